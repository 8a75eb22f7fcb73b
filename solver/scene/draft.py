"""A scene while it is being read: its data, its source, and the mistakes found so far.

Every part is checked against its class; a field with a mistake is reported once and then counts
as ``BROKEN``, so that the rest of the part can still be checked in the same run.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import replace
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any, TypeVar

from solver.options import removed
from solver.scene.expression import Curve
from solver.scene.fields import BROKEN, Part, fields_of, shown
from solver.scene.mistakes import Path, Problem, SceneError, Source, location_of
from solver.scene.named_expressions import Expressions
from solver.scene.scene import TABLES, TYPES
from solver.scene.words import did_you_mean, nearest

if TYPE_CHECKING:
    from solver.scene.places import Seat

_NAMES_OF = {
    **{"point": "points", "body": "bodies", "joint": "joints"},
    **{"follower": "bodies", "profile": "profiles"},
    **{name: name for name in ("points", "bodies", "joints")},
}
"""Fields that name parts of a table."""

P = TypeVar("P", bound=Part)

MOST = 200
"""Mistakes that are reported."""

_BAR = 'write type = "bar"; the points of a rigid body are a table'


class Draft:
    """Data of a scene file and the mistakes in it."""

    def __init__(self, data: dict[str, Any], source: Source, problems: list[Problem]) -> None:
        self.data = data
        dimension = data.get("dimension", 3)
        self.dimension = dimension if type(dimension) is int and dimension in (2, 3) else None
        """Of the scene; None: broken, so that vectors may have two or three numbers."""
        self.source = source
        self.problems = problems
        self.warnings: list[Problem] = []
        self.curves: dict[str, Curve] = {}
        """Profiles that expressions can call."""
        self.expressions = Expressions(self)
        self.seats: dict[tuple[Path, str], Seat] | None = None
        """Where each place lies on each of its bodies, if that is asked for."""
        self.seats_of_file: Mapping[tuple[Path, str], Seat] | None = None
        """The same without overrides, if these move something."""

    def error(
        self, path: Path, message: str, help: str | None = None, mark: tuple[str, int] = ("", 1)
    ) -> None:
        """Note a mistake at a place of the file.

        Raises ``SceneError`` after ``MOST`` mistakes: a reader would not look at more.
        """
        self.problems.append(self.source.problem(path, message, help, mark))
        if len(self.problems) > MOST:
            message = f"more than {MOST} mistakes; not all are listed"
            raise SceneError([*self.problems, Problem("", message)], self.source)

    def warn(self, path: Path, message: str, help: str) -> None:
        """Note what is legal at a place of the file and seldom meant."""
        problem = self.source.problem(path, message, help)
        self.warnings.append(replace(problem, severity="warning"))

    def table(self, name: str) -> dict[str, Any]:
        """Return a table of the file, empty where it is missing or no table."""
        table = self.data.get(name, {})
        if isinstance(table, dict):
            return table
        self.error((name,), f"must be a table, got {shown(table)}", f"write [{name}]")
        return {}

    def names(self, table: str) -> tuple[str, ...]:
        """Names of the parts of a table."""
        entries = self.data.get(table)
        return tuple(entries) if isinstance(entries, dict) else ()

    def parts(self, table: str) -> dict[str, tuple[type[Part], Any]]:
        """Check the fields of all parts of a table; parts without a usable type drop out."""
        checked, types = {}, self._possible(TYPES.get(table, {}))
        for name, data in self.table(table).items():
            path = (table, name)
            short = TABLES[table].types[0].short
            if short and not isinstance(data, dict):
                part = TABLES[table].types[0]
                checked[name] = part, self.part(path, part, {short: data}, short=True)
            elif not isinstance(data, dict):
                help = "write it as a table: { ... }"
                self.error(path, f"must be a table of fields, got {shown(data)}", help)
            elif (part := self._usable_class(path, data)) is not None:
                if fitting := _fitting(part, data, types):
                    self._wrong_type(path, part, data, fitting)
                    part, data = types[fitting[0]], data | {"type": fitting[0]}
                checked[name] = part, self.part(path, part, data)
        return checked

    def part_class(self, table: str, name: str) -> type[Part] | None:
        """Class of a part of the file; None where it is unknown."""
        types, data = TYPES.get(table), self.data[table][name]
        if types is None:
            return TABLES[table].types[0]
        kind = data.get("type") if isinstance(data, dict) else None
        if kind is None:
            return next((part for part in types.values() if part.is_usual), None)
        return types.get(kind) if isinstance(kind, str) else None

    def _usable_class(self, path: tuple[str, str], data: dict[str, Any]) -> type[Part] | None:
        """Class of a part; None where its type is of no use, which is reported."""
        part, types = self.part_class(*path), TYPES.get(path[0], {})
        if types and (part is None or not part.is_in(self.dimension)):
            return self.class_of(path, data, types, f"known types of {path[0]}", path[0])
        if types and data.get("type") is None and isinstance(data.get("points"), list):
            self.error(path, "'type' is missing; a body with two points is a bar", _BAR)
            return None
        return part

    def _possible(self, types: Mapping[str, type[P]]) -> dict[str, type[P]]:
        """Types that a scene of this dimension may have."""
        return {word: part for word, part in types.items() if part.is_in(self.dimension)}

    def class_of(
        self, path: Path, data: dict[str, Any], types: Mapping[str, type[P]], title: str,
        table: str = "",
    ) -> type[P] | None:  # fmt: skip
        """Return the class of the type that a part has; report one that is not possible."""
        wanted, known = data.get("type"), self._possible(types)
        if isinstance(wanted, str) and wanted in known:
            return known[wanted]
        listed = f"{title}: {', '.join(known)}"
        if wanted is None:
            self.error(path, "'type' is missing", f"write type = ...; {listed}")
        elif isinstance(wanted, str) and wanted in types:
            dimension, instead = types[wanted].only_in
            message = f"'{wanted}' is possible only in dimension {dimension}"
            self.error((*path, "type"), message, instead or listed)
        else:
            word = str(wanted)
            help = did_you_mean(word, known, title, table)
            home = next((home for home, others in TYPES.items() if word in others), None)
            if table and home and not nearest(word, known, table):
                help = f"'{word}' is a type of [{home}]: write it there"
            self.error((*path, "type"), f"unknown type {shown(wanted)}", help)
        return None

    def _wrong_type(
        self, path: Path, part: type[Part], data: dict[str, Any], fitting: list[str]
    ) -> None:
        """Report a field that the type does not have and others have."""
        extra = next(name for name in data if name not in fields_of(part))
        help = f"types of {path[0]} with these fields: {', '.join(fitting)}"
        if len(fitting) == 1:
            help = f'write type = "{fitting[0]}"'
        message = f"is no field of the type '{part.type}'"
        self.error((*path, extra), message, help)

    def part(self, path: Path, part: type[Part], data: dict[str, Any], short: bool = False) -> Any:
        """Check the fields of one part by themselves; None stands for one that is not given.

        `short` says that the file gives the value alone instead of a table of fields.
        """
        fields = fields_of(part)
        given: dict[str, Any] = dict.fromkeys(fields)
        unknown = [name for name in data if name not in fields]
        meant = {nearest(name, fields.keys() - data.keys(), "fields") for name in unknown}
        for name, field in fields.items():
            value, place = data.get(name), path if short else (*path, name)
            if value is not None:
                given[name] = field.kind.parse(self, place, value)
            elif name in data:  # JSON's null
                given[name] = BROKEN
                how = self.example((*path, name), field.kind.example)
                how = how if field.required else "leave it out"
                self.error(place, "must have a value, got null", how)
            elif name in meant:
                given[name] = BROKEN
            elif field.required:
                given[name] = BROKEN
                how = self.example((*path, name), field.kind.example)
                self.error(path, f"'{name}' is missing", how)
        for name in unknown:
            help = did_you_mean(name, fields, "known fields", "fields")
            gone = removed(location_of((*path, name)))
            self.error((*path, name), gone or "unknown field", "leave it out" if gone else help)
        return SimpleNamespace(**given)

    def example(self, path: Path, example: Any) -> str | None:
        """Say how a field is written; a vector has as many numbers as the scene has dimensions."""
        if example is None:
            return None
        name = str(path[-1])
        if name in _NAMES_OF and isinstance(example[0], str):
            parts = self.data.get(_NAMES_OF[name])
            found = [part for part in parts if part not in path] if isinstance(parts, dict) else []
            two = [*["ground"] * (name == "bodies"), *found, "...", "..."][:2]
            example = (found or two)[-1] if isinstance(example, str) else two
        text = shown(example).replace("'", '"')
        if self.dimension == 2:
            text = re.sub(r"\[0, ([^][,]+), ([^][,]+)\]", r"[\1, \2]", text)
            text = re.sub(r"\[([^][,]+), ([^][,]+), [^][,]+\]", r"[\1, \2]", text)
        return f"write {name} = {text}"


def _fitting(part: type[Part], data: dict[str, Any], types: Mapping[str, type[Part]]) -> list[str]:
    """Types of a table that have all fields of a part, where its own type has not."""
    own = fields_of(part)
    if data.keys() <= own.keys():
        return []
    misspelt = [nearest(name, own.keys() - data.keys(), "fields") for name in data.keys() - own]
    found = [
        word
        for word, other in types.items()
        if data.keys() <= fields_of(other).keys()
        and all(name in data for name, field in fields_of(other).items() if field.required)
    ]
    return found if len(found) == 1 or not all(misspelt) else []
