"""A scene while it is being read: its data, its source, and the mistakes found so far.

Every part is checked against its schema; a field with a mistake is reported once and then counts
as ``BROKEN``, so that the rest of the part can still be checked in the same run.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any, Literal, get_args

from pydantic import ValidationError
from pydantic_core import ErrorDetails

from solver.scene.fields import BROKEN, shown
from solver.scene.report import Path, Problem, SceneError, Source
from solver.scene.schema import ONLY_IN_SPACE, PARTS, TYPES
from solver.scene.schema_part import Part
from solver.scene.words import did_you_mean, nearest

if TYPE_CHECKING:
    from solver.scene.places import Seat

_EXPECTED = {
    "string_type": "must be a text",
    "bool_type": "must be true or false",
    "int_type": "must be a whole number",
    "list_type": "must be a list",
    "model_type": "must be a table",
    "dict_type": "must be a table",
    "too_short": "must have two entries",
    "too_long": "must have two entries",
}
_NAMES_OF = {
    **{"point": "points", "body": "bodies", "joint": "joints"},
    **{name: name for name in ("points", "bodies", "joints")},
}
"""Fields that name parts of a table."""

MOST = 200
"""Mistakes that are reported."""

_BAR = 'write type = "bar"; the points of a rigid body are a table'


class Draft:
    """Data of a scene file and the mistakes in it."""

    def __init__(self, data: dict[str, Any], source: Source, problems: list[Problem]) -> None:
        self.data = data
        self.source = source
        self.problems = problems
        self.warnings: list[Problem] = []
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

    def parts(self, table: str) -> dict[str, Any]:
        """Check all parts of a table against their schema; parts without a usable type drop out."""
        checked, types = {}, TYPES.get(table, {})
        if table == "joints" and self.data.get("dimension") == 2:
            types = {word: model for word, model in types.items() if word not in ONLY_IN_SPACE}
        for name, data in self.table(table).items():
            path = (table, name)
            if table == "parameters" and not isinstance(data, dict):
                checked[name] = self.part(path, PARTS[table], {"value": data}, short=True)
            elif not isinstance(data, dict):
                help = "write it as a table: { ... }"
                self.error(path, f"must be a table of fields, got {shown(data)}", help)
            elif (model := PARTS.get(table) or self._model(path, data, types)) is not None:
                if fitting := _fitting(model, data, types):
                    self._wrong_type(path, model, data, fitting)
                    model, data = types[fitting[0]], data | {"type": fitting[0]}
                checked[name] = self.part(path, model, data)
        return checked

    def _model(
        self, path: Path, data: dict[str, Any], known: dict[str, type[Part]]
    ) -> type[Part] | None:
        table = str(path[0])
        if table == "bodies" and data.get("type") is None:
            if not isinstance(data.get("points"), list):
                return known["rigid"]
            self.error(path, "'type' is missing; a body with two points is a bar", _BAR)
            return None

        def elsewhere(word: str) -> tuple[str, str] | None:
            if table == "joints" and word in ONLY_IN_SPACE:
                return f"'{word}' is possible only in dimension 3", ONLY_IN_SPACE[word]
            home = next((home for home, types in TYPES.items() if word in types), None)
            if home is None or nearest(word, known, table):
                return None
            return f"unknown type {shown(word)}", f"'{word}' is a type of [{home}]: write it there"

        return self.model(path, data, known, f"known types of {table}", elsewhere, table)

    def model(
        self, path: Path, data: dict[str, Any], known: Mapping[str, type[Part]], title: str,
        elsewhere: Callable[[str], tuple[str, str] | None], place: str = "",
    ) -> type[Part] | None:  # fmt: skip
        """Return the model of the type that a part has; report one that is not known.

        `elsewhere` has message and help for a type that is known at another place of a scene.
        """
        wanted = data.get("type")
        if isinstance(wanted, str) and wanted in known:
            return known[wanted]
        if wanted is None:
            help = f"write type = ...; {title}: {', '.join(known)}"
            self.error(path, "'type' is missing", help)
        else:
            help = did_you_mean(str(wanted), known, title, place)
            words = elsewhere(str(wanted)) or (f"unknown type {shown(wanted)}", help)
            self.error((*path, "type"), *words)
        return None

    def _wrong_type(
        self, path: Path, model: type[Part], data: dict[str, Any], fitting: list[str]
    ) -> None:
        """Report a field that the type does not have and others have."""
        extra = next(name for name in data if name not in model.model_fields)
        help = f"types of {path[0]} with these fields: {', '.join(fitting)}"
        if len(fitting) == 1:
            help = f'write type = "{fitting[0]}"'
        message = f"is no field of the type '{data.get('type', 'rigid')}'"
        self.error((*path, extra), message, help)

    def part(self, path: Path, model: type[Part], data: dict[str, Any], short: bool = False) -> Any:
        """Check the fields of one part; a field with a mistake becomes ``BROKEN``.

        `short` says that the file gives the value alone instead of a table of fields.
        """
        try:
            return model.model_validate(data)
        except ValidationError as error:
            usable = {name: x for name, x in data.items() if name in model.model_fields}
            others = model.model_fields.keys() - usable.keys()
            meant = {nearest(name, others, "fields") for name in data.keys() - usable.keys()}
            usable |= dict.fromkeys(meant & others, BROKEN)
            for detail in error.errors(include_url=False):
                location = tuple(detail["loc"])
                if detail["type"] != "missing" or location[0] not in meant:
                    self._report(path, model, data, detail, location[1:] if short else location)
                if detail["type"] != "extra_forbidden":
                    usable[str(location[0])] = BROKEN
            return model.model_validate(usable)

    def _report(
        self, path: Path, model: type[Part], data: Any, detail: ErrorDetails, location: Path
    ) -> None:
        kind, value = detail["type"], detail["input"]
        about = detail.get("ctx", {})
        if kind == "missing":
            name = str(location[-1])
            self.error(path, f"'{name}' is missing", self._example(model, name, path))
            return
        if kind == "extra_forbidden":
            help = did_you_mean(str(location[-1]), model.model_fields, "known fields", "fields")
            self.error((*path, *location), "unknown field", help)
            return
        place = (*path, *_existing(location, data))
        if kind == "literal_error":
            words = _choices(model, str(location[0]))
            self.error(place, *_unknown_choice(str(location[0]), value, words))
        elif "message" in about:
            self.error(place, about["message"], about.get("help"), about.get("mark", ("", 1)))
        else:
            rule = _EXPECTED.get(kind, detail["msg"])
            name = str(detail["loc"][0])
            help = self._example(model, name, path) if len(location) == 1 else None
            self.error(place, f"{rule}, got {shown(value)}", help)

    def _example(self, model: type[Part], name: str, path: Path) -> str | None:
        """Say how a field is written; a vector has as many numbers as the scene has dimensions."""
        examples = model.model_fields[name].examples
        if not examples:
            return None
        example = examples[0]
        if name in _NAMES_OF and isinstance(example[0], str):
            parts = self.data.get(_NAMES_OF[name])
            found = [part for part in parts if part not in path] if isinstance(parts, dict) else []
            two = [*["ground"] * (name == "bodies"), *found, "...", "..."][:2]
            example = (found or two)[-1] if isinstance(example, str) else two
        text = shown(example).replace("'", '"')
        if self.data.get("dimension") == 2:
            text = text.replace("[0, ", "[", 1)
        return f"write {name} = {text}"


def _fitting(model: type[Part], data: dict[str, Any], types: Mapping[str, type[Part]]) -> list[str]:
    """Types of a table that have all fields of a part, where its own type has not."""
    own = model.model_fields
    if data.keys() <= own.keys():
        return []
    misspelt = [nearest(name, own.keys() - data.keys(), "fields") for name in data.keys() - own]
    found = [
        word
        for word, other in types.items()
        if data.keys() <= other.model_fields.keys()
        and all(name in data for name, x in other.model_fields.items() if x.is_required())
    ]
    return found if len(found) == 1 or not all(misspelt) else []


def _existing(location: Path, data: Any) -> Path:
    """Leave out the steps of a location that are names of alternatives rather than places."""
    steps: list[str | int] = []
    for step in location:
        if isinstance(data, dict) and step in data:
            data = data[str(step)]
        elif isinstance(data, list) and isinstance(step, int):
            data = data[step]
        else:
            continue
        steps.append(step)
    return tuple(steps)


def _choices(model: type[Part], name: str) -> list[Any]:
    annotation = model.model_fields[name].annotation
    options = [annotation, *get_args(annotation)]
    literal = next(kind for kind in options if getattr(kind, "__origin__", None) is Literal)
    return list(get_args(literal))


def _unknown_choice(name: str, value: object, choices: list[Any]) -> tuple[str, str | None]:
    """Words for a value outside a fixed list."""
    if name == "order":
        return (
            f"order {shown(value)} is not available",
            "use 2, 4, 6 or 8, or 0 for the one that a tolerance chooses",
        )
    if not isinstance(choices[0], str):
        return f"must be {' or '.join(map(str, choices))}, got {shown(value)}", None
    text = value if isinstance(value, str) else shown(value)
    return f"unknown {name} {shown(value)}", did_you_mean(text, choices)
