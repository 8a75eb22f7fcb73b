"""Fields of the parts of a scene, each declared once with its kind.

    length: Annotated[Number | None, Quantity("m", "as drawn unless given", POSITIVE)] = None

From the kind follow what a file may write, what an editor is told (JSON Schema), and the value that
is handed on. A field whose mistake has been reported holds ``BROKEN`` while a file is read.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass, field
from functools import cache
from typing import TYPE_CHECKING, Any, ClassVar, NamedTuple, TypeAlias

from solver.scene import grammar
from solver.scene.expression import ExpressionError, Vector
from solver.scene.mistakes import Path
from solver.scene.quantities import Offer
from solver.scene.rules import GEOMETRY, SETTING, Place, Rule
from solver.scene.substitution import ReportedError
from solver.scene.units import Literal, literal, misfit, remedy, unit_help
from solver.scene.usual_texts import USUAL_TEXTS
from solver.scene.words import did_you_mean

if TYPE_CHECKING:
    from solver.scene.draft import Draft
    from solver.scene.references import Reader

BROKEN: Any = object()
"""Value of a field whose mistake has been reported; everything accepts it."""


def shown(value: object) -> str:
    """Write a value the way it stands in the file."""
    if value is None or isinstance(value, bool):
        return "null" if value is None else str(value).lower()
    if isinstance(value, list):
        return f"[{', '.join(shown(item) for item in value)}]"
    if isinstance(value, dict):
        return "a table"
    if isinstance(value, int) and abs(value) >= 10**20:  # Python refuses to write long ones
        power = round(math.log10(abs(value)))
        return f"an integer of {power + (abs(value) >= 10**power)} digits"
    return repr(value) if isinstance(value, (str, int, float)) else str(value)


@dataclass(frozen=True, slots=True, kw_only=True)
class PointReference:
    """An end of a joint or force: a point, a point of a body, or a place on body or ground."""

    point: str | None
    """"A" a point, "rod" a body's origin, "rod.tip" a point of a body; None is the ground."""
    at: Vector | None = None
    """Place on the ground. With the name of a body: place on it, as drawn, in global axes."""


Reading: TypeAlias = Callable[["Reader", Path, Any, Any], Any]
"""From the parsed value of a field to that of the part: reader, path, value, and all fields of the
part as they were parsed."""


@dataclass(frozen=True)
class Kind:
    """Kind of a field: of a quantity, of a name, of a choice.

    Attributes
    ----------
    unit, text : str
        What an editor shows.
    rule, place : Rule, Place
        What a number must be, and what an expression may mention.
    example : object
        How the field is written, for the report of one that is missing.
    required : bool or None
        Whether a file must give it; None: where the part's field has no default.
    beside : mapping of str to Kind
        Fields of the file that belong to the value of this one.
    reading : callable, optional
        How the value is checked against the scene, where that is special.
    """

    unit: str = ""
    text: str = ""
    rule: Rule | None = None
    place: Place = GEOMETRY
    example: Any = None
    required: bool | None = None
    beside: Mapping[str, Kind] = field(default_factory=dict)
    reading: Reading | None = None

    def form(self) -> dict[str, Any]:
        """JSON Schema of what the file may have; empty where that is a mistake."""
        return {}

    def parse(self, draft: Draft, path: Path, value: Any, unit: str = "") -> Any:
        """Check what a file writes, by itself; ``BROKEN`` after a mistake.

        `unit` is that of the list or table in which it stands.
        """
        raise NotImplementedError

    def usual(self, reader: Reader, path: Path, value: Any) -> Any:  # noqa: ARG002
        """Check what was parsed against the scene, where no `reading` says how."""
        return value

    def read(self, reader: Reader, path: Path, value: Any, given: Any) -> Any:
        """Return the value of the part's field."""
        if self.reading is not None:
            return self.reading(reader, path, value, given)
        return self.usual(reader, path, value)

    def schema(self) -> dict[str, Any]:
        """JSON Schema of the field."""
        description = ", ".join(filter(None, (self.unit, self.text)))
        told = {"description": description} if description else {}
        return {**self.form(), **told, **({"examples": [self.example]} if self.example else {})}

    def wrong(self, draft: Draft, path: Path, rule: str, value: object) -> Any:
        """Report a value of a type that does not fit."""
        draft.error(path, f"{rule}, got {shown(value)}", draft.example(path, self.example))
        return BROKEN


class Quantity(Kind):
    """A number, with a unit or without, or an expression; parsed, it is a ``ParsedNumber``."""

    of_any_unit: ClassVar[bool] = False

    def form(self) -> dict[str, Any]:
        """JSON Schema of a number."""
        text = "a number, one with a unit as text, or an expression as text"
        return {"type": ["number", "string"], "description": text}

    def parse(self, draft: Draft, path: Path, value: Any, unit: str = "") -> Any:
        """Read a number, a number with its unit, or the text of an expression."""
        if type(value) is float and math.isfinite(value):  # most are
            return grammar.ParsedNumber(value, value)
        if isinstance(value, str):
            if found := literal(value):
                return self._in_si(draft, path, value, found, self.unit or unit)
            try:
                return grammar.read(value, draft.curves, draft.expressions)
            except ReportedError:
                return BROKEN
            except ExpressionError as error:
                message = f"{error.message}, column {error.column} of '{value}'"
                mark = (value, error.column or 1)
                draft.error(path, message, error.help or unit_help(value), mark)
                return BROKEN
        if isinstance(value, bool) or not isinstance(value, (int, float)):
            draft.error(path, f"must be a number or an expression, got {shown(value)}")
            return BROKEN
        try:
            number = float(value)
        except OverflowError:
            number = math.inf
        if math.isfinite(number):
            return grammar.ParsedNumber(value, number)
        draft.error(path, f"must be a finite number, got {shown(value)}")
        return BROKEN

    def _in_si(self, draft: Draft, path: Path, text: str, found: Literal, wanted: str) -> Any:
        """Return the number of SI that a literal is; report one of another quantity."""
        words = "" if self.of_any_unit else misfit(found.unit, wanted)
        if words:
            draft.error(path, f"is {text}, {words}", remedy(wanted))
        elif math.isinf(found.value):
            draft.error(path, f"is {text}, larger than any floating-point number")
        else:
            return grammar.ParsedNumber(text, found.value, unit=found.unit)
        return BROKEN

    def usual(self, reader: Reader, path: Path, value: Any) -> Any:
        """Check symbols, rule and unit."""
        return reader.number(path, value, self.place, self.rule, self.unit)


class OfAnyUnit(Quantity):
    """A number in the unit of its part, with which the part compares that of a literal."""

    of_any_unit = True


@dataclass(frozen=True)
class ListOf(Kind):
    """A list of values of one kind: of any number, or of two."""

    item: Kind = field(default_factory=Quantity)
    size: tuple[int, int] | None = None

    def form(self) -> dict[str, Any]:
        """JSON Schema of a list."""
        size = dict(zip(("minItems", "maxItems"), self.size or (), strict=False))
        return {"type": "array", "items": self.item.schema(), **size}

    def parse(self, draft: Draft, path: Path, value: Any, unit: str = "") -> Any:
        """Check all items."""
        if not isinstance(value, list):
            return self.wrong(draft, path, "must be a list", value)
        if self.size == TWO and len(value) != 2:
            return self.wrong(draft, path, "must have two entries", value)
        unit = self.unit or unit
        parsed = [self.item.parse(draft, (*path, i), item, unit) for i, item in enumerate(value)]
        return BROKEN if any(item is BROKEN for item in parsed) else parsed


TWO = (2, 2)


@dataclass(frozen=True)
class Components(ListOf):
    """A vector: as many numbers as the scene has dimensions."""

    size: tuple[int, int] | None = (2, 3)

    def usual(self, reader: Reader, path: Path, value: Any) -> Any:
        """Check symbols and number of components."""
        return reader.vector(path, value, self.place)


class Direction(Components):
    """A vector of any length but zero."""

    def usual(self, reader: Reader, path: Path, value: Any) -> Any:
        """Check components and length."""
        return reader.axis(path, value)


@dataclass(frozen=True)
class Table(Kind):
    """A table: of values of one kind, or one that the reader of the part checks itself."""

    item: Kind | None = None
    parts: tuple[type[Part], ...] = ()

    def form(self) -> dict[str, Any]:
        """JSON Schema of a table."""
        if self.item is not None:
            return {"type": "object", "additionalProperties": self.item.schema()}
        first, *more = [schema_of(part) for part in self.parts]
        return {"anyOf": [first, *more]} if more else first

    def parse(self, draft: Draft, path: Path, value: Any, unit: str = "") -> Any:
        """Check all items."""
        if not isinstance(value, dict):
            return self.wrong(draft, path, "must be a table", value)
        if self.item is None:
            return value
        unit, item = self.unit or unit, self.item
        parsed = {name: item.parse(draft, (*path, name), x, unit) for name, x in value.items()}
        return BROKEN if any(item is BROKEN for item in parsed.values()) else parsed


@dataclass(frozen=True)
class ByShape(Kind):
    """One of several kinds, by the shape of what is written."""

    number: Kind | None = None
    vector: Kind | None = None
    vectors: Kind | None = None
    table: Kind | None = None

    def form(self) -> dict[str, Any]:
        """JSON Schema of all of them."""
        kinds = (self.number, self.table, self.vector, self.vectors)
        return {"oneOf": [kind.schema() for kind in kinds if kind and kind.form()]}

    def parse(self, draft: Draft, path: Path, value: Any, unit: str = "") -> Any:
        """Parse what the shape of the value tells."""
        kind = self.number or self.vector
        if isinstance(value, dict):
            kind = self.table or kind
        elif isinstance(value, list):
            nested = any(isinstance(item, list) for item in value)
            kind = (self.vectors if nested else None) or self.vector or kind
        assert kind is not None
        return kind.parse(draft, path, value, self.unit or unit)


@dataclass(frozen=True)
class Choice(Kind):
    """One of a few words or whole numbers."""

    words: tuple[str | int, ...] = ()
    help: str = ""

    def form(self) -> dict[str, Any]:
        """JSON Schema of the words."""
        first, *more = self.words
        words = {"enum": [first, *more]} if more else {"const": first}
        return {"type": _TYPES[type(first)][0], **words}

    def parse(self, draft: Draft, path: Path, value: Any, unit: str = "") -> Any:  # noqa: ARG002
        """Report a value outside the list."""
        if type(value) in (str, int) and value in self.words:
            return value
        name = str(path[-1])
        message, help = f"unknown {name} {shown(value)}", None
        if self.help:
            message, help = f"{name} {shown(value)} is not available", self.help
        elif not isinstance(self.words[0], str):
            message = f"must be {' or '.join(map(str, self.words))}, got {shown(value)}"
        else:
            text = value if isinstance(value, str) else shown(value)
            help = did_you_mean(text, map(str, self.words))
        draft.error(path, message, help)
        return BROKEN


@dataclass(frozen=True)
class Plain(Kind):
    """A value of a type that Python has: a text, true or false, a whole number."""

    type: type = str
    pattern: str = ""

    def form(self) -> dict[str, Any]:
        """JSON Schema of the type."""
        pattern = {"pattern": self.pattern} if self.pattern else {}
        return {"type": _TYPES[self.type][0], **pattern}

    def parse(self, draft: Draft, path: Path, value: Any, unit: str = "") -> Any:  # noqa: ARG002
        """Check the type."""
        fits = type(value) is self.type
        return value if fits else self.wrong(draft, path, _TYPES[self.type][1], value)

    def usual(self, reader: Reader, path: Path, value: Any) -> Any:
        """Check the rule of a whole number."""
        if self.rule is not None and value is not BROKEN and not self.rule.holds(value):
            reader.draft.error(path, f"must be {self.rule.words}, got {shown(value)}")
        return value


_TYPES = {
    str: ("string", "must be a text"),
    bool: ("boolean", "must be true or false"),
    int: ("integer", "must be a whole number"),
}


def setting(
    unit: str = "", text: str = "", rule: Rule | None = None, default: float = 0.0,
    kind: type[Quantity] = Quantity, **more: Any,
) -> Quantity:  # fmt: skip
    """Return the kind of a number without symbols, with a default."""

    def constant(reader: Reader, path: Path, value: Any, _: Any) -> float:
        return reader.constant(path, value, default, rule, unit)

    return kind(unit, text, rule, SETTING, reading=constant, **more)


def joint_with(word: str, example: str, text: str = "") -> Plain:
    """Return the kind of the name of a joint that has an angle or a displacement."""

    def read(reader: Reader, path: Path, name: Any, _: Any) -> str:
        reader.joint(path, name, word)
        return "" if name is BROKEN else name

    return Plain(text=text, example=example, reading=read)


def _body(reader: Reader, path: Path, name: Any, _: Any) -> str | None:
    fine = name is not BROKEN and reader.body(path, name, ground=True)
    return name if fine and name != "ground" else None


def _directions(reader: Reader, path: Path, axes: Any, _: Any) -> Any:
    if axes is BROKEN:
        return reader.zero(), reader.zero()
    return tuple(reader.axis((*path, i), axis) for i, axis in enumerate(axes))


NUMBER, COMPONENTS, NAME = Quantity(), Components(), Plain()
TWO_ENDS = ListOf(
    item=NAME, size=TWO, example=["A", "B"],
    beside={
        "at": ByShape(
            "m", "place of 'ground', or of each end, as drawn",
            vector=COMPONENTS, vectors=ListOf(item=COMPONENTS),
        )
    },
    reading=lambda reader, path, names, given: reader.ends(path[:-1], names, given.at),
)  # fmt: skip
"""Two ends of a part: names, and beside them the places of those on a body or the ground."""
ONE_END = Plain(
    example="A",
    beside={"at": Components("m", "place on the body that `point` names, as drawn")},
    reading=lambda reader, path, name, given: reader.point(path[:-1], name, given.at),
)
TWO_BODIES = ListOf(
    item=NAME, size=TWO, example=["ground", "rod"],
    reading=lambda reader, path, names, _: reader.pair(path, names),
)  # fmt: skip
TWO_AXES = ListOf(
    item=COMPONENTS, size=TWO, example=[[1, 0, 0], [0, 1, 0]], reading=_directions
)  # fmt: skip
BODY_OR_GROUND = Plain(text="the ground unless given", reading=_body)


class Field(NamedTuple):
    """A field of a part in a file."""

    kind: Kind
    required: bool
    default: Any
    """Of the part's own field, where it has one."""
    is_own: bool
    """Whether the part has a field of this name."""


class Part:
    """A part of a scene: a dataclass, whose fields are annotated with their kinds."""

    __slots__ = ()

    type: ClassVar[str] = ""
    """Type in a table of parts of several types."""
    short: ClassVar[str] = ""
    """Field whose value a file may write alone, in place of the table of fields."""
    is_usual: ClassVar[bool] = False
    """Whether a part without a type has this one."""
    only_in: ClassVar[tuple[int, str]] = (0, "")
    """The one dimension that has such parts, 0 for both, and what to write in the other."""
    offers: ClassVar[tuple[Offer, ...]] = ()
    """Quantities that expressions and the FMU have of it."""
    also: ClassVar[Mapping[str, Kind]] = {}
    """Fields of the file from which others are calculated."""

    @classmethod
    def read(cls, reader: Reader, path: Path, given: Any) -> Any:
        """Return the part whose fields, as they were parsed, are `given`."""
        part = cls(**reader.fields(cls, path, given))
        part.check(reader, path, given)
        return part

    def check(self, reader: Reader, path: Path, given: Any) -> None:
        """Report fields that do not fit each other or the scene; `given` is what was parsed."""

    @classmethod
    def offered(cls, given: Collection[str]) -> tuple[Offer, ...]:  # noqa: ARG003
        """Quantities of a part for which a file gives the fields of these names."""
        return cls.offers

    def given(self) -> list[str]:
        """Names of its fields that have a value."""
        return [name for name in fields_of(type(self)) if getattr(self, name, None) is not None]

    @classmethod
    def is_in(cls, dimension: int | None) -> bool:
        """Whether a scene of this dimension may have such a part; None, a broken one, may."""
        return dimension is None or cls.only_in[0] in (0, dimension)

    @classmethod
    def has(cls, word: str) -> bool:
        """Whether it offers a quantity of this name."""
        return any(offer.word == word for offer in cls.offers)


@cache
def fields_of(part: type[Part]) -> Mapping[str, Field]:
    """Fields of a part in a file."""
    found: dict[str, Field] = {}
    if part.type:
        kind = Choice(words=(part.type,))
        found["type"] = Field(kind, not part.is_usual, part.type if part.is_usual else None, False)
    for own in dataclasses.fields(part):  # pyright: ignore[reportArgumentType]
        kind: Kind | None = next(iter(getattr(own.type, "__metadata__", ())), None)
        if kind is not None:
            has_none = own.default is own.default_factory is dataclasses.MISSING
            default = {} if own.default_factory is dict else own.default
            required = has_none if kind.required is None else kind.required
            found[own.name] = Field(kind, required, default, True)
            found |= {name: Field(x, False, None, False) for name, x in kind.beside.items()}
    return found | {name: Field(kind, False, None, False) for name, kind in part.also.items()}


def schema_of(part: type[Part]) -> dict[str, Any]:
    """JSON Schema of a part."""
    properties = {}
    for name, found in fields_of(part).items():
        properties[name] = found.kind.schema()
        if name in USUAL_TEXTS and "$ref" not in properties[name]:
            properties[name].setdefault("description", USUAL_TEXTS[name])
        told = isinstance(found.default, (str, bool, int, float, dict))
        if told and found.kind.required is None:
            properties[name]["default"] = found.default
    required = [name for name, found in fields_of(part).items() if found.required]
    return {
        "type": "object",
        "description": (part.__doc__ or "").partition("\n\n")[0].replace("\n    ", " "),
        "properties": properties,
        **({"required": required} if required else {}),
        "additionalProperties": False,
    }
