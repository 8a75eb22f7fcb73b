"""What is in the folder of a study: NAME_1.fmu, NAME_1.ssv, NAME_2.fmu, ..., and what was before.

A folder must hold what its manifest says and no more, or a program that takes all FMUs of it takes
some of another scene. What this package did not write is neither replaced nor removed.
"""

from __future__ import annotations

import glob
import zipfile
from collections.abc import Collection, Mapping
from dataclasses import dataclass
from pathlib import Path

from build_fmu.errors import UsageError

_OURS = b'generationTool="holonom '


@dataclass(frozen=True)
class Room:
    """A folder with room for the FMUs of a study."""

    folder: Path
    stem: str
    names: Collection[str]
    """Names of the FMUs that the study may write; no file of one of them is another's."""
    earlier: Mapping[str, tuple[int, int]]
    """FMUs of an earlier study by name, which are to be replaced or removed; each with its mark."""

    def is_touched(self) -> bool:
        """Whether an FMU was written since."""
        there = {path.name: _mark(path) for path in _numbered(self.folder, self.stem, ".fmu")}
        return any(there.get(n, m) != m for n, m in self.earlier.items()) or any(
            name in there and name not in self.earlier for name in self.names
        )

    def clear(self, kept: Collection[str]) -> None:
        """Remove the FMUs of both studies but for those named, and their parameter sets."""
        own = {Path(name).stem for name in self.names}
        going = (own | {Path(name).stem for name in self.earlier}) - {Path(n).stem for n in kept}
        for kind in (".fmu", ".ssv"):
            for path in _numbered(self.folder, self.stem, kind):
                if path.stem in going and (path.stem in own or _is_ours(path)):
                    path.unlink(missing_ok=True)
        # Of a process that was ended:
        for path in self.folder.glob(f".{glob.escape(self.stem)}_*.fmu-*"):
            if path.name[1:].rpartition(".fmu-")[0] in going:
                path.unlink(missing_ok=True)


def require_room(folder: Path, stem: str, names: Collection[str], fresh: bool) -> Room:
    """Room for FMUs of these names, which replace those of an earlier study.

    Raises
    ------
    UsageError
        If some of these would stay and are not to be removed, or if a name is that of another's
        file or folder.
    """
    if folder.suffix == ".fmu" or (folder.exists() and not folder.is_dir()):
        text = f"{folder}: there will be many FMUs; name a folder for them, not a file"
        raise UsageError(text)
    there = [path for path in _numbered(folder, stem, ".fmu") if _is_ours(path)]
    for path in (*_numbered(folder, stem, ".fmu"), *_numbered(folder, stem, ".ssv")):
        if path.with_suffix(".fmu").name in names and not _is_ours(path):
            raise UsageError(_not_ours(path, "folder"))
    left = sorted(path.name for path in there if path.name not in names)
    if left and not fresh:
        count = f"{len(left)} FMU{'s' * (len(left) > 1)} of an earlier study would stay there"
        first = left[0] if len(left) == 1 else f"{left[0]} to {left[-1]}"
        remedy = "name another folder, or remove them with --fresh"
        text = f"{folder}: {count}, {first}; {remedy}"
        raise UsageError(text)
    return Room(folder, stem, names, {path.name: _mark(path) for path in there})


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


def _mark(path: Path) -> tuple[int, int]:
    """What tells a file from one that has replaced it."""
    status = path.stat()
    return status.st_ino, status.st_mtime_ns


def _is_ours(path: Path) -> bool:
    try:
        if path.suffix == ".ssv":
            return _OURS in path.read_bytes()
        with zipfile.ZipFile(path) as archive:
            return _OURS in archive.read("modelDescription.xml")
    except (OSError, KeyError, zipfile.BadZipFile):
        return False
