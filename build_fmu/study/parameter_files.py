"""Files of `--parameters`: values by name, in TOML, JSON, CSV or as a parameter set of SSP (.ssv).

    mass = 2.0                          name,value,unit
    "points.A.velocity" = [0, 1]        mass,2.0,kg
    [solver]                            solver.step_size,10,ms
    step_size = 0.005

Each value knows the line it stands in, and all mistakes of all files are reported at once.
"""

from __future__ import annotations

import csv
import json
import re
import sys
from collections.abc import Iterable, Iterator, Mapping
from os import PathLike
from pathlib import Path

from build_fmu.study.ssv import read_parameter_set
from build_fmu.study.values import Entry, Mistake, read_value, refuse

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

HEADS = (["name", "value"], ["name", "value", "unit"])


def read_parameters(paths: Iterable[str | PathLike[str]]) -> dict[str, Entry]:
    """Values by name; those of a later file replace those of an earlier one.

    Raises
    ------
    UsageError
        With every mistake of the files.
    """
    mistakes: list[Mistake] = []
    found: dict[str, Entry] = {}
    for path in map(Path, paths):
        read = _READERS.get(path.suffix.lower())
        if read is None:
            message = f"unknown kind of file {path.suffix!r}"
            mistakes.append(Mistake(str(path), message, f"known: {', '.join(_READERS)}"))
            continue
        try:
            found |= read(path, mistakes)
        except UnicodeDecodeError as error:
            message = f"not a UTF-8 text: byte 0x{error.object[error.start]:02x}"
            mistakes.append(Mistake(str(path), message, "save the file as UTF-8"))
        except OSError as error:
            mistakes.append(Mistake(str(path), f"cannot be read: {error.strerror}"))
    refuse(mistakes)
    return found


def _text(path: Path) -> str:
    return path.read_bytes().decode("utf-8-sig").replace("\r\n", "\n")


# ------------------------------------------------------------------------------- TOML and JSON


def _toml(path: Path, mistakes: list[Mistake]) -> dict[str, Entry]:
    text = _text(path)
    try:
        data = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        place = re.search(r" \(at line (\d+), column (\d+)\)", str(error))
        where = f"{path}:{place[1]}:{place[2]}" if place else str(path)
        mistakes.append(Mistake(where, f"TOML: {str(error).partition(' (at ')[0]}"))
        return {}
    return _flattened(path, data, text, "toml")


def _json(path: Path, mistakes: list[Mistake]) -> dict[str, Entry]:
    text = _text(path)
    try:
        data = json.loads(text)
    except json.JSONDecodeError as error:
        where = f"{path}:{error.lineno}:{error.colno}"
        mistakes.append(Mistake(where, f"JSON: {error.msg}"))
        return {}
    if not isinstance(data, dict):
        mistakes.append(Mistake(f"{path}:1", "must be an object of values by name"))
        return {}
    return _flattened(path, data, text, "json")


def _flattened(path: Path, data: Mapping, text: str, notation: str) -> dict[str, Entry]:
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

    return {
        # A key that is a dotted name itself stands for it.
        place[0] if len(place) == 1 else location_of(place): Entry(
            value, f"{path}:{lines.get(place, 1)}"
        )
        for place, value in leaves(data, ())
    }


# ----------------------------------------------------------------------------------------- CSV


def _csv(path: Path, mistakes: list[Mistake]) -> dict[str, Entry]:
    reader = csv.reader(_text(path).splitlines(), skipinitialspace=True)
    head = [cell.strip() for cell in next(reader, [])]
    if head not in HEADS:
        help = f"it must be {' or '.join(','.join(names) for names in HEADS)}"
        if len(head) == 1 and re.search("[;\t]", head[0]):
            help += ", separated by commas"
        mistakes.append(Mistake(f"{path}:1", f"the header is {','.join(head)!r}", help))
        return {}
    found: dict[str, Entry] = {}
    for row in reader:
        if not any(cell.strip() for cell in row):
            continue
        where = f"{path}:{reader.line_num}"
        if len(row) != len(head):
            message = f"has {len(row)} cells, and the header has {len(head)}"
            mistakes.append(Mistake(where, message, "put a text with a comma into quotes"))
            continue
        name, text, *unit = (cell.strip() for cell in row)
        if not name or not text:
            mistakes.append(Mistake(where, f"{name or 'a value'}: an empty cell"))
        elif name in found:
            mistakes.append(Mistake(where, f"{name}: given twice"))
        else:
            found[name] = Entry(value_of_cell(text, where, mistakes), where, *unit)
    return found


def value_of_cell(text: str, where: str, mistakes: list[Mistake]) -> object:
    """Value of a cell; a list that cannot be read is a mistake."""
    try:
        return read_value(text)
    except ValueError as error:
        mistakes.append(Mistake(where, f"{text}: {error}"))
        return text


_READERS = {".toml": _toml, ".json": _json, ".csv": _csv, ".ssv": read_parameter_set}
