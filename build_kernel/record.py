"""What the libraries in the source tree were compiled from, so that nothing is compiled twice.

Each installation asks for the kernel, and to compile it takes most of an installation's time. The
record has a digest of all that goes into the libraries, and one of each library: one that another
platform's compiler or an interrupted run has put there is not taken for ours.
"""

from __future__ import annotations

import hashlib
import json
import os
import shutil
from collections.abc import Iterable, Sequence
from pathlib import Path

RECORD = Path("build/compiled.json")
"""Below the folder of pyproject.toml."""
SUFFIXES = (".c", ".h", ".def")


def digest_of_inputs(root: Path, command: Sequence[str], folders: Iterable[Path]) -> str:
    """Digest of the compiler, its options, the files that call it, and the sources below folders.

    `command` begins with the compiler; `folders` are below `root`.
    """
    program = shutil.which(command[0])
    found = os.stat(program) if program else None  # another version has another size or time
    version = (found.st_size, found.st_mtime_ns) if found else ()
    digest = hashlib.sha256(repr(([*command], version)).encode())
    files = [path for folder in folders for path in (root / folder).rglob("*")]
    files = [path for path in files if path.suffix in SUFFIXES]
    for path in (*sorted(Path(__file__).parent.glob("*.py")), *sorted(files)):
        digest.update(f"\n{path.name} {path.stat().st_size}\n".encode())
        digest.update(path.read_bytes())
    return digest.hexdigest()


def is_compiled(root: Path, inputs: str, libraries: Iterable[Path]) -> bool:
    """Whether these libraries below `root` are there, as they were compiled from these inputs."""
    try:
        record = json.loads((root / RECORD).read_text("utf-8"))
        return record == _record(root, inputs, libraries)
    except (OSError, ValueError):  # no record or library, or a record that is cut off
        return False


def keep_record(root: Path, inputs: str, libraries: Iterable[Path]) -> None:
    """Write down that these libraries were compiled from these inputs."""
    path = root / RECORD
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(json.dumps(_record(root, inputs, libraries), indent=1), "utf-8")


def _record(root: Path, inputs: str, libraries: Iterable[Path]) -> dict:
    found = {
        path.relative_to(root).as_posix(): hashlib.sha256(path.read_bytes()).hexdigest()
        for path in libraries
    }
    return {"inputs": inputs, "libraries": found}
