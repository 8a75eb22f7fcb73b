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

from build_fmu.study.csv_tables import csv_table
from build_fmu.study.ssv import read_parameter_set
from build_fmu.study.values import Entry, Mistake, keep, not_finite, read_value

HEADS = (["name", "value"], ["name", "value", "unit"])


def entries_of_files(paths: Iterable[str | PathLike[str]]) -> dict[str, Entry]:
    """Values by name; those of a later file replace those of an earlier one.

    Each mistake is an entry of its own, to be told with others.
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
            entries = read(path, mistakes)
        except OSError as error:
            mistakes.append(Mistake(str(path), f"cannot be read: {error.strerror}"))
            continue
        found |= entries
        for name, entry in entries.items():
            if (wrong := not_finite(entry.value)) is not None:
                message = f"{name}: must be a finite number, got {wrong}"
                mistakes.append(Mistake(entry.where, message))
    return found | {f"mistake {i}": Entry(None, m.where, wrong=m) for i, m in enumerate(mistakes)}


def _tables(path: Path, mistakes: list[Mistake]) -> dict[str, Entry]:
    """Values of the nested tables of TOML or JSON by dotted names."""
    from solver.scene import SceneError
    from solver.scene.mistakes import location_of
    from solver.scene.positions import lines_of
    from solver.scene.tables import tables_of, text_of

    text, notation, data = "", "", {}
    try:
        text, notation = text_of(str(path))
        text = text.replace("\r\n", "\n")
        data, problems = tables_of(text, str(path), notation)
    except SceneError as error:
        problems = error.problems
    for problem in problems:
        where = ":".join(str(x) for x in (path, problem.line, problem.column) if x)
        subject = f"{problem.location}: " if problem.location else ""
        mistakes.append(Mistake(where, subject + problem.message, problem.help or ""))
    lines = lines_of(text, notation) if data else {}
    found: dict[str, Entry] = {}
    for place, value in _leaves(data):
        # A key that is a dotted name itself stands for it.
        name = place[0] if len(place) == 1 else location_of(place)
        keep(found, name, Entry(value, f"{path}:{lines.get(place, 1)}"), mistakes)
    return found


def _leaves(
    table: Mapping, place: tuple[str, ...] = ()
) -> Iterator[tuple[tuple[str, ...], object]]:
    for key, value in table.items():
        if isinstance(value, Mapping):
            yield from _leaves(value, (*place, key))
        else:
            yield (*place, key), value


def _csv(path: Path, mistakes: list[Mistake]) -> dict[str, Entry]:
    before, help = len(mistakes), f"it must be {' or '.join(','.join(names) for names in HEADS)}"
    header, head, rows = csv_table(path, help, mistakes)
    if len(mistakes) == before and head not in HEADS:
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
            continue
        try:
            keep(found, name, Entry(read_value(text), where, unit), mistakes)
        except ValueError as error:
            mistakes.append(Mistake(where, f"{name}: {error}"))
    return found


_READERS = {".toml": _tables, ".json": _tables, ".csv": _csv, ".ssv": read_parameter_set}
