"""Overrides: numbers of a scene replaced from outside, ``points.A.mass=2``.

A name alone means the parameter or input of that name. The new value goes through the same checks
as the file, and mistakes in it are reported with the override instead of a line of the scene.
"""

from __future__ import annotations

import sys
from collections.abc import Mapping
from typing import Any

from solver.scene.fields import fields_of, shown
from solver.scene.grammar import is_readable
from solver.scene.mistakes import Given, Path, Problem, location_of, path_of
from solver.scene.scene import HEADING, NOUNS, TABLES
from solver.scene.units import literal, si_unit
from solver.scene.words import did_you_mean, nearest

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib


_BY_NAME = {"parameters": "value", "inputs": "start", "expressions": "value"}
"""Tables whose parts an override means by their names alone, and the field that it replaces."""
SECTIONS = {name: table.types[0] for name, table in TABLES.items() if name not in NOUNS}
"""Tables whose fields are the same in all scenes."""


def apply_overrides(
    data: dict[str, Any], overrides: Mapping[str, object], problems: list[Problem]
) -> tuple[dict[Path, str], dict[Path, str]]:
    """Replace values in the data of a scene, in place.

    Returns
    -------
    tuple of dict
        By the path of what was replaced: text of each override, ``name=value``, in the order of
        the texts; and where it was given, ``--set name=value`` or ``overrides['name']=value``.
    """
    replaced: dict[Path, str] = {}
    places: dict[Path, str] = {}
    for name, override in overrides.items():
        given = override.value if isinstance(override, Given) else override
        value = value_of(given)
        text = f"{name}={given if isinstance(given, str) else shown(value)}"
        where = (
            override.where if isinstance(override, Given) else f"overrides[{name!r}]={shown(given)}"
        )
        path = _target(data, path_of(name))
        if not is_readable(text):
            problems.append(Problem("", "not a readable text", override=where))
        elif path is None or not _replace(data, path, _with_units(data, path, value)):
            tables = [table for table, part in SECTIONS.items() if name in fields_of(part)]
            meant = " or ".join(f"'{table}.{name}'" for table in sorted(tables, reverse=True))
            given_names, possible = _known(data, whole=False), _known(data, whole=True)
            known = given_names if nearest(name, given_names) else possible
            help = f"did you mean {meant}?" if meant else did_you_mean(name, known)
            message = "unknown name" if len(path_of(name)) == 1 else "no such thing in the scene"
            named = override.named if isinstance(override, Given) else ""
            problems.append(Problem(name, message, help, override=named or where))
        else:
            replaced[path], places[path] = text, where
    return dict(sorted(replaced.items(), key=lambda item: item[1])), places


def value_of(given: object) -> object:
    """Read a text as a value of the file where it is one; ``2*length`` stays an expression."""
    given = getattr(given, "tolist", lambda: given)()  # numbers and arrays of NumPy
    if isinstance(given, (tuple, list)):
        return [value_of(item) for item in given]
    if not isinstance(given, str):
        return given
    try:
        read = tomllib.loads(f"value = {given}")
    except (ValueError, RecursionError):  # no TOML, or an integer of too many digits
        return given
    return read["value"] if len(read) == 1 else given


def _target(data: dict[str, Any], path: Path) -> Path | None:
    """Place of the value that a name or location means."""
    if not path:
        return None
    if len(path) == 1:
        for table, field in _BY_NAME.items():
            parts = data.get(table)
            if isinstance(parts, dict) and path[0] in parts:
                whole = not isinstance(parts[path[0]], dict)
                return (table, path[0]) if whole else (table, path[0], field)
        return path if path[0] in HEADING else None
    if len(path) == 2 and path[0] in _BY_NAME:
        return _target({path[0]: data.get(str(path[0]))}, path[1:])
    if path[0] in SECTIONS:
        data.setdefault(str(path[0]), {})
    return path


def _with_units(data: dict[str, Any], path: Path, value: object) -> object:
    """Let a parameter or input keep the unit that its literal gave it, under another number."""
    is_literal = isinstance(value, str) and literal(value) is not None
    if path[0] not in ("parameters", "inputs") or not (is_literal or type(value) in (int, float)):
        return value
    table = data.get(path[0])
    part = table.get(path[1]) if isinstance(table, dict) else None
    is_short = not isinstance(part, dict)
    before = part if is_short else part.get(path[-1])
    found = literal(before) if isinstance(before, str) else None
    if found is None or (len(path) == 3 and path[2] != _BY_NAME[path[0]]):
        return value
    units = {"unit": si_unit(found.unit)}
    if found.unit != units["unit"] and not is_literal:
        units["display_unit"] = found.unit
    if is_short:
        return {"value": value, **units}
    part |= units | part
    return value


def _replace(data: Any, path: Path, value: object) -> bool:
    """Set a value within tables and arrays that exist; a field of a table may be new."""
    *steps, last = path
    try:
        for step in steps:
            data = data[step]
        if not isinstance(data, dict):
            data[last]  # an array does not grow
        elif not isinstance(last, str):
            return False
        data[last] = value
    except (KeyError, IndexError, TypeError):
        return False
    return True


def _known(data: dict[str, Any], *, whole: bool) -> list[str]:
    """Every name an override may have in this scene; without `whole` of what the file gives."""
    names = []
    for table in _BY_NAME:
        parts = data.get(table)
        names += list(parts) if isinstance(parts, dict) else []
    if whole:
        names += HEADING
        names += [
            location_of((x, field)) for x, part in SECTIONS.items() for field in fields_of(part)
        ]
    for table, parts in data.items():
        listed = (*_BY_NAME, *(SECTIONS if whole else ()))
        if not isinstance(parts, dict) or table in listed:
            continue
        for name, part in parts.items():
            if isinstance(part, dict):
                fields = [*part, *(_fields(table, part) if whole else [])]
                names += [location_of((table, name, field)) for field in dict.fromkeys(fields)]
            else:
                names.append(location_of((table, name)))
    return names


def _fields(table: str, part: dict[str, Any]) -> list[str]:
    """Fields that a part of its type has, also those that the file leaves out."""
    types = TABLES[table].types if table in TABLES else ()
    return [
        field
        for kind in types
        if kind.type == part.get("type", "") or (kind.is_usual and "type" not in part)
        for field in fields_of(kind)
    ]
