"""FMUs that an earlier study left in the folder of a new one: NAME_1.fmu, NAME_2.fmu, ...

A folder must hold what its manifest says and no more, or a program that takes all FMUs of it takes
some of another scene. What this package did not write is neither replaced nor removed.
"""

from __future__ import annotations

import zipfile
from collections.abc import Collection
from pathlib import Path

from build_fmu.errors import UsageError

_OURS = b'generationTool="holonom '


def require_room(folder: Path, stem: str, names: Collection[str], fresh: bool) -> list[Path]:
    """FMUs of an earlier study, which `names` replace or which are to be removed.

    Raises
    ------
    UsageError
        If some would stay and are not to be removed, or if a name is that of another's file.
    """
    numbered = [p for p in folder.glob(f"{stem}_*.fmu") if p.stem[len(stem) + 1 :].isdecimal()]
    there = [path for path in numbered if _is_ours(path)]
    for path in numbered:
        if path.name in names and path not in there:
            text = f"{path}: was not written by build-fmu; move it, or name another folder"
            raise UsageError(text)
    left = sorted(path.name for path in there if path.name not in names)
    if left and not fresh:
        count = f"{len(left)} FMU{'s' * (len(left) > 1)} of an earlier study would stay there"
        first = left[0] if len(left) == 1 else f"{left[0]} to {left[-1]}"
        remedy = "name another folder, or remove what is of no use with --fresh"
        text = f"{folder}: {count}, {first}; {remedy}"
        raise UsageError(text)
    return there


def remove_remains(there: Collection[Path], names: Collection[str]) -> None:
    """Remove those of the earlier FMUs that no new one has replaced, and their parameter sets."""
    for path in there:
        if path.name in names:
            continue
        path.unlink(missing_ok=True)
        beside = path.with_suffix(".ssv")
        if beside.is_file() and _OURS in beside.read_bytes():
            beside.unlink()


def _is_ours(path: Path) -> bool:
    try:
        with zipfile.ZipFile(path) as archive:
            return _OURS in archive.read("modelDescription.xml")
    except (OSError, KeyError, zipfile.BadZipFile):
        return False
