"""Files of `--parameters`: values by name, in TOML, JSON, CSV or as a parameter set of SSP (.ssv).

    mass = 2.0                          name,value,unit
    "points.A.velocity" = [0, 1]        mass,2.0,kg
    [solver]                            solver.step_size,10,ms
    step_size = 0.005

Each value knows the line it stands in, and all mistakes of all files are reported at once.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from os import PathLike
from pathlib import Path

from build_fmu.study.csv_file import csv_rows
from build_fmu.study.ssv import read_parameter_set
from build_fmu.study.values import Entry, Mistake, keep, not_finite, read_value, refuse

HEADS = (["name", "value"], ["name", "value", "unit"])


def read_parameters(paths: Iterable[str | PathLike[str]]) -> dict[str, Entry]:
    """Values by name; those of a later file replace those of an earlier one.

    Raises
    ------
    UsageError
        With every mistake of the files.
    """
    found = entries_of_files(paths)
    refuse(entry.wrong for entry in found.values() if entry.wrong)
    return found


def entries_of_files(paths: Iterable[str | PathLike[str]]) -> dict[str, Entry]:
    """As `read_parameters`, with each mistake as an entry of its own, to be told with others."""
    mistakes: list[Mistake] = []
    found: dict[str, Entry] = {}
    for path in map(Path, paths):
        read = _READERS.get(path.suffix.lower())
        if read is None:
            message = f"unknown kind of file {path.suffix!r}"
            mistakes.append(Mistake(str(path), message, f"known: {', '.join(_READERS)}"))
            continue
        try:
            entries = read(path, mistakes)
            found |= entries
            mistakes += _infinite(entries)
        except UnicodeDecodeError as error:
            message = f"not a UTF-8 text: byte 0x{error.object[error.start]:02x}"
            mistakes.append(Mistake(str(path), message, "save the file as UTF-8"))
        except OSError as error:
            mistakes.append(Mistake(str(path), f"cannot be read: {error.strerror}"))
    return found | {f"mistake {i}": Entry(None, m.where, wrong=m) for i, m in enumerate(mistakes)}


def _infinite(entries: Mapping[str, Entry]) -> Iterator[Mistake]:
    for name, entry in entries.items():
        if (wrong := not_finite(entry.value)) is not None:
            yield Mistake(entry.where, f"{name}: must be a finite number, got {wrong}")


def _text(path: Path) -> str:
    return path.read_bytes().decode("utf-8-sig").replace("\r\n", "\n")


# ------------------------------------------------------------------------------- TOML and JSON


def _tables(path: Path, mistakes: list[Mistake]) -> dict[str, Entry]:
    from solver.scene import SceneError
    from solver.scene.tables import tables_of

    text, notation = _text(path), path.suffix.lower().removeprefix(".")
    try:
        data, problems = tables_of(text, str(path), notation)
    except SceneError as error:
        data, problems = {}, error.problems
    for problem in problems:
        where = ":".join(str(x) for x in (path, problem.line, problem.column) if x)
        subject = f"{problem.location}: " if problem.location else ""
        mistakes.append(Mistake(where, subject + problem.message, problem.help or ""))
    return _flattened(path, data, text, notation, mistakes) if data else {}


def _flattened(
    path: Path, data: Mapping, text: str, notation: str, mistakes: list[Mistake]
) -> dict[str, Entry]:
    """Values of nested tables by dotted names."""
    from solver.scene.positions import lines_of
    from solver.scene.report import location_of

    lines = lines_of(text, notation)

    def leaves(table: Mapping, place: tuple[str, ...]) -> Iterator[tuple[tuple[str, ...], object]]:
        for key, value in table.items():
            if isinstance(value, Mapping):
                yield from leaves(value, (*place, key))
            else:
                yield (*place, key), value

    found: dict[str, Entry] = {}
    for place, value in leaves(data, ()):
        # A key that is a dotted name itself stands for it.
        name = place[0] if len(place) == 1 else location_of(place)
        keep(found, name, Entry(value, f"{path}:{lines.get(place, 1)}"), mistakes)
    return found


# ----------------------------------------------------------------------------------------- CSV


def _csv(path: Path, mistakes: list[Mistake]) -> dict[str, Entry]:
    before, rows = len(mistakes), csv_rows(path, mistakes)
    header, head = next(rows, (f"{path}:1", []))
    if len(mistakes) == before and head not in HEADS:
        help = f"it must be {' or '.join(','.join(names) for names in HEADS)}"
        message = f"the header is {','.join(head)!r}"
        if len(head) == 1 and head[0].split(",") in HEADS:
            message, help = f"{message} in quotes, as one cell", "write it without quotes"
        elif len(head) == 1 and re.search("[;\t]", head[0]):
            help += ", separated by commas"
        mistakes.append(Mistake(header, message, help))
    found: dict[str, Entry] = {}
    for where, row in rows:
        if len(head) not in map(len, HEADS):
            continue  # nobody knows what is what
        name, text, unit = [*row, ""][:3]
        if not name or not text:
            mistakes.append(Mistake(where, f"{name or 'a value'}: an empty cell"))
        else:
            entry = Entry(value_of_cell(text, where, mistakes, name), where, unit)
            keep(found, name, entry, mistakes)
    return found


def value_of_cell(text: str, where: str, mistakes: list[Mistake], name: str = "") -> object:
    """Value of a cell; a list that cannot be read is a mistake."""
    try:
        return read_value(text)
    except ValueError as error:
        mistakes.append(Mistake(where, f"{name or text}: {error}"))
        return text


_READERS = {".toml": _tables, ".json": _tables, ".csv": _csv, ".ssv": read_parameter_set}
