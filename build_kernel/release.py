"""`make release`: an archive of the sources, and a wheel for each platform, in `dist/`.

    python -m build_kernel.release [FOLDER]

They are made of the last commit alone. Wheels are made of the unpacked archive, so that it is known
to be complete. All files have the time of that commit: the same commit gives the same bytes.
"""

from __future__ import annotations

import gzip
import io
import os
import subprocess
import sys
import tarfile
import tempfile
import time
from pathlib import Path

from build_fmu.platforms import PLATFORMS
from build_kernel.compiler import CompilerError, compile_for_all

ROOT = Path(__file__).resolve().parent.parent


def release(target: Path) -> list[Path]:
    """Write the archive and the wheels of the last commit into a folder; their paths."""
    if _git("status", "--porcelain", "--untracked-files=no"):
        sys.exit("holonom: a release is made of the last commit, and files differ; commit them")
    moment = int(_git("log", "-1", "--format=%ct"))
    os.environ["SOURCE_DATE_EPOCH"] = str(moment)
    target.mkdir(parents=True, exist_ok=True)
    for old in target.glob("holonom-*"):
        old.unlink()
    with tempfile.TemporaryDirectory() as name:
        scratch = Path(name)
        _unpack(io.BytesIO(_git("archive", "--prefix=clone/", "HEAD")), scratch)
        _build(scratch / "clone", target, "--sdist")
        (source,) = target.glob("holonom-*.tar.gz")
        _set_times(source, moment)
        _unpack(io.BytesIO(source.read_bytes()), scratch)
        tree = scratch / source.name.removesuffix(".tar.gz")
        compile_for_all(tree)
        for platform in PLATFORMS:
            _build(tree, target, "--wheel", f"-Cplatform={platform}")
    return sorted(target.glob("holonom-*"))


def _git(*arguments: str) -> bytes:
    return subprocess.check_output(["git", *arguments], cwd=ROOT)


def _build(tree: Path, target: Path, *options: str) -> None:
    # No isolation: setuptools is here, and five environments would be the same.
    command = [sys.executable, "-m", "build", "--no-isolation", "--outdir", str(target), *options]
    print("building", *options, flush=True)
    run = subprocess.run([*command, str(tree)], capture_output=True, text=True, check=False)
    if run.returncode != 0:
        sys.exit(run.stdout + run.stderr)


def _unpack(packed: io.BytesIO, target: Path) -> None:
    with tarfile.open(fileobj=packed) as archive:
        archive.extractall(target)


def _set_times(source: Path, moment: int) -> None:
    """Write an archive anew, without times and owners of this machine; setuptools has no option."""
    plain = io.BytesIO()
    with tarfile.open(source) as old, tarfile.open(fileobj=plain, mode="w") as new:
        for entry in sorted(old.getmembers(), key=lambda entry: entry.name):
            entry.mtime, entry.uid, entry.gid, entry.uname, entry.gname = moment, 0, 0, "", ""
            entry.pax_headers = {}
            new.addfile(entry, old.extractfile(entry) if entry.isfile() else None)
    source.write_bytes(gzip.compress(plain.getvalue(), mtime=moment))


if __name__ == "__main__":
    start = time.perf_counter()
    try:
        found = release(Path(*sys.argv[1:] or ["dist"]).resolve())
    except CompilerError as error:
        sys.exit(f"holonom: {error}")
    for path in found:
        print(f"{path.name}: {path.stat().st_size / 1e6:.2f} MB")
    print(f"{time.perf_counter() - start:.0f} s")
