"""What is in the folder of a study: NAME_1.fmu, NAME_1.ssv, NAME_2.fmu, ..., and what was before.

A folder must hold what its manifest says and no more, or a program that takes all FMUs of it takes
some of another scene. What this package did not write is neither replaced nor removed.
"""

from __future__ import annotations

import glob
import zipfile
from collections.abc import Collection
from pathlib import Path

from build_fmu.errors import UsageError
from solver.files import read_whole, why_unreadable

_OURS = b'generationTool="holonom '


def require_room(folder: Path, stem: str, names: Collection[str], fresh: bool) -> None:
    """Refuse a folder without room for FMUs of these names, which replace those of a study before.

    Raises
    ------
    UsageError
        If some of these would stay and are not to be removed, or if a name is that of another's
        file or folder.
    """
    if folder.suffix == ".fmu" or (folder.exists() and not folder.is_dir()):
        text = f"{folder}: there will be many FMUs; name a folder for them, not a file"
        raise UsageError(text)
    for path in (*_numbered(folder, stem, ".fmu"), *_numbered(folder, stem, ".ssv")):
        if path.with_suffix(".fmu").name in names and not _is_ours(path):
            raise UsageError(_not_ours(path, "folder"))
    there = (path for path in _numbered(folder, stem, ".fmu") if path.name not in names)
    left = sorted(path.name for path in there if _is_ours(path))
    if left and not fresh:
        count = f"{len(left)} FMU{'s' * (len(left) > 1)} of an earlier study would stay there"
        first = left[0] if len(left) == 1 else f"{left[0]} to {left[-1]}"
        remedy = "name another folder, or remove them with --fresh"
        text = f"{folder}: {count}, {first}; {remedy}"
        raise UsageError(text)


def take_over(scratch: Path, folder: Path, stem: str, kept: Collection[str]) -> None:
    """Move the FMUs of a study from where they were made, in place of those of the study before."""
    for path in filter(_is_ours, _numbered(folder, stem, ".fmu")):
        for each in filter(_is_ours, (path.with_suffix(".ssv"), path)):
            each.unlink()
    for path in (*_numbered(scratch, stem, ".fmu"), *_numbered(scratch, stem, ".ssv")):
        if path.with_suffix(".fmu").name in kept:
            path.replace(folder / path.name)


def require_own_set(fmu: Path) -> None:
    """Refuse an FMU beside which the parameter set of another program would be replaced."""
    beside = fmu.with_suffix(".ssv")
    if beside.exists() and not _is_ours(beside):
        raise UsageError(_not_ours(beside, "FMU"))


def _not_ours(path: Path, other: str) -> str:
    return f"{path}: was not written by holonom; move it, or name another {other}"


def _numbered(folder: Path, stem: str, kind: str) -> list[Path]:
    found = folder.glob(f"{glob.escape(stem)}_*{kind}")
    return [path for path in found if path.stem[len(stem) + 1 :].isdecimal()]


def _is_ours(path: Path) -> bool:
    try:
        if path.suffix == ".ssv":
            return _OURS in read_whole(path)
        if why_unreadable(path):
            return False
        with zipfile.ZipFile(path) as archive:
            return _OURS in archive.read("modelDescription.xml")
    except (OSError, KeyError, zipfile.BadZipFile):
        return False
