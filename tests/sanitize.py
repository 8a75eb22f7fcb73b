"""Compiles the kernel and native FMUs with gcc's address and undefined behaviour sanitizers.

python -m tests.sanitize [--every N]

Scenes run in a copy of `solver` with such a kernel, in a temporary folder; the first fault ends it.
"""

from __future__ import annotations

import argparse
import os
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from build_kernel.compiler import (
    DIMENSIONS,
    LIBRARIES,
    SLAVE_SOURCES,
    SOURCES,
    Kind,
    compile_library,
    library_name,
)

ROOT = Path(__file__).parent.parent
OPTIONS = (
    *("-g1", "-fno-omit-frame-pointer", "-fno-sanitize-recover=all"),
    "-fsanitize=address,undefined,float-cast-overflow,bounds-strict",
)
SETTINGS = {
    "ASAN_OPTIONS": "detect_leaks=0:halt_on_error=1",  # leaks are Python's own, at its end
    "UBSAN_OPTIONS": "print_stacktrace=1:halt_on_error=1",
    "PYTHONMALLOC": "malloc",  # Python's arenas hide what lies beyond a block
}


def can_sanitize() -> bool:
    """Whether there is a gcc with the run-time libraries of the sanitizers."""
    return bool(shutil.which("gcc")) and all(Path(path).is_absolute() for path in _preloaded())


def has_thread_sanitizer() -> bool:
    """Whether there is a gcc with that."""
    return bool(shutil.which("gcc")) and Path(_library_of_gcc("libtsan.so")).is_absolute()


def _library_of_gcc(name: str) -> str:
    """Path of a library; its bare name where gcc has none."""
    command = ["gcc", f"-print-file-name={name}"]
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout.strip()


def _preloaded() -> list[str]:
    """Libraries that must be loaded before Python; bare names where gcc has none."""
    return [_library_of_gcc(name) for name in ("libasan.so", "libubsan.so")]


def sanitized_library(folder: Path, dimension: int) -> Path:
    """Library in a folder of ``copy_with_sanitizers``, for Python and for hosts of FMUs."""
    return folder / LIBRARIES / library_name("Linux", dimension)


def copy_with_sanitizers(folder: Path, optimisation: str) -> None:
    """Copy `solver` below a folder, and compile the kernel there: quick to compile, or to run."""
    kept = shutil.ignore_patterns("__pycache__", "*.so")
    shutil.copytree(ROOT / "solver", folder / "solver", ignore=kept)
    # What Python calls is to be seen as well.
    options = (optimisation, *OPTIONS, "-UHOLONOM_STATIC")

    def compiled(dimension: int) -> None:
        target = sanitized_library(folder, dimension)
        target.parent.mkdir(exist_ok=True)
        kind = Kind(dimension, slave=ROOT / SLAVE_SOURCES)
        compile_library(["gcc"], folder / SOURCES, kind, target, *options)

    with ThreadPoolExecutor(len(DIMENSIONS)) as pool:
        list(pool.map(compiled, DIMENSIONS))


def run_in(folder: Path, every: int) -> subprocess.CompletedProcess[str]:
    """Run each `every`-th case of ``sanitized_runs`` with the copy in a folder."""
    environment = dict(os.environ) | SETTINGS
    environment["PYTHONPATH"] = os.pathsep.join([str(folder), str(ROOT)])
    environment["LD_PRELOAD"] = " ".join(_preloaded())
    command = [sys.executable, "-m", "tests.support.kernel.sanitized_runs", str(every)]
    return subprocess.run(command, cwd=folder, env=environment, text=True, capture_output=True)


def main() -> int:
    """Compile and run; 1 where a sanitizer has found something."""
    parser = argparse.ArgumentParser(prog="python -m tests.sanitize", description=__doc__)
    parser.add_argument("--every", type=int, default=1, help="run only each N-th case")
    every = parser.parse_args().every
    if not can_sanitize():
        sys.exit("the sanitizers need gcc with libasan and libubsan")
    with tempfile.TemporaryDirectory(prefix="sanitize-") as name:
        copy_with_sanitizers(Path(name), "-O1")
        run = run_in(Path(name), every)
    print(run.stdout + run.stderr[-4000:])
    return 1 if run.returncode else 0


if __name__ == "__main__":
    sys.exit(main())
