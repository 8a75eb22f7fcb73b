"""Fields of the parts of a scene, each declared once with its kind.

    length: Annotated[Number | None, Quantity("m", "as drawn unless given", POSITIVE)] = None

From the kind follow what a file may write, what an editor is told (JSON Schema), and the value that
is handed on. A field whose mistake has been reported holds ``BROKEN`` while a file is read.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING, Any, ClassVar, NamedTuple

from solver.scene.expression import ExpressionError, Vector
from solver.scene.grammar import Reading, read
from solver.scene.quantities import Offer
from solver.scene.report import Path
from solver.scene.rules import GEOMETRY, SETTING, Place, Rule
from solver.scene.units import in_si
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
    """

    unit: str = ""
    text: str = ""
    rule: Rule | None = None
    place: Place = GEOMETRY
    example: Any = None
    required: bool | None = None

    FORM: ClassVar[dict[str, Any]] = {}
    """What the file may have, as JSON Schema."""

    @property
    def beside(self) -> Mapping[str, Kind]:
        """Fields of the file that belong to the value of this one."""
        return {}

    def schema(self) -> dict[str, Any]:
        """JSON Schema of the field."""
        description = ", ".join(filter(None, (self.unit, self.text)))
        told = {"description": description} if description else {}
        return {**self.FORM, **told, **({"examples": [self.example]} if self.example else {})}

    def parse(self, draft: Draft, path: Path, value: Any) -> Any:
        """Check what a file writes, by itself; ``BROKEN`` after a mistake."""
        raise NotImplementedError

    def read(self, reader: Reader, path: Path, value: Any, given: Any) -> Any:  # noqa: ARG002
        """Check what was parsed against the scene, and return the value of the part's field.

        `given` has all fields of the part as they were parsed.
        """
        return value

    def wrong(self, draft: Draft, path: Path, rule: str, value: object) -> Any:
        """Report a value of a type that does not fit."""
        draft.error(path, f"{rule}, got {shown(value)}", draft.example(path, self.example))
        return BROKEN


class Quantity(Kind):
    """A number, or an expression as text; it arrives as a ``Reading``."""

    FORM: ClassVar = {
        "type": ["number", "string"],
        "description": "a number, or an expression as text",
    }

    def parse(self, draft: Draft, path: Path, value: Any) -> Any:
        """Read a number or the text of an expression."""
        if type(value) is float and math.isfinite(value):  # most are
            return Reading(value, value)
        if isinstance(value, str):
            try:
                return read(value)
            except ExpressionError as error:
                message = f"{error.message}, column {error.column} of '{value}'"
                mark = (value, error.column or 1)
                draft.error(path, message, error.help or in_si(value), mark)
                return BROKEN
        if isinstance(value, bool) or not isinstance(value, (int, float)):
            draft.error(path, f"must be a number or an expression, got {shown(value)}")
            return BROKEN
        try:
            number = float(value)
        except OverflowError:
            number = math.inf
        if math.isfinite(number):
            return Reading(value, number)
        draft.error(path, f"must be a finite number, got {shown(value)}")
        return BROKEN

    def read(self, reader: Reader, path: Path, value: Any, given: Any) -> Any:  # noqa: ARG002
        """Check symbols, rule and unit."""
        return reader.number(path, value, self.place, self.rule, self.unit)


class Angle(Quantity):
    """An angle in rad; one of more than a turn is perhaps in degrees."""

    def read(self, reader: Reader, path: Path, value: Any, given: Any) -> Any:  # noqa: ARG002
        """Check symbols, and warn of degrees."""
        return 0.0 if value is BROKEN else reader.angle(path, value, self.place)


@dataclass(frozen=True)
class Setting(Quantity):
    """A number without symbols, with a default."""

    place: Place = SETTING
    default: float = 0.0

    def read(self, reader: Reader, path: Path, value: Any, given: Any) -> Any:  # noqa: ARG002
        """Check the rule."""
        return reader.constant(path, value, self.default, self.rule, self.unit)


@dataclass(frozen=True)
class ListOf(Kind):
    """A list of values of one kind, of any number or of two."""

    item: Kind = dataclasses.field(default_factory=Quantity)
    two: bool = False

    def schema(self) -> dict[str, Any]:
        """JSON Schema of a list."""
        size = {"minItems": 2, "maxItems": 2} if self.two else {}
        return {"type": "array", "items": self.item.schema(), **size, **super().schema()}

    def parse(self, draft: Draft, path: Path, value: Any) -> Any:
        """Check all items."""
        if not isinstance(value, list):
            return self.wrong(draft, path, "must be a list", value)
        parsed = [self.item.parse(draft, (*path, i), item) for i, item in enumerate(value)]
        if self.two and len(value) != 2:
            return self.wrong(draft, path, "must have two entries", value)
        return BROKEN if BROKEN in parsed else parsed


class Components(Kind):
    """A vector: as many numbers as the scene has dimensions."""

    FORM: ClassVar = {
        "type": "array",
        "items": {"type": ["number", "string"]},
        "minItems": 2,
        "maxItems": 3,
    }

    def parse(self, draft: Draft, path: Path, value: Any) -> Any:
        """Check all numbers."""
        if not isinstance(value, list):
            return self.wrong(draft, path, "must be a list", value)
        parsed = [NUMBER.parse(draft, (*path, i), item) for i, item in enumerate(value)]
        return BROKEN if any(x is BROKEN for x in parsed) else parsed

    def read(self, reader: Reader, path: Path, value: Any, given: Any) -> Any:  # noqa: ARG002
        """Check symbols and number of components."""
        return reader.vector(path, value, self.place)


class Direction(Components):
    """A vector of any length but zero."""

    def read(self, reader: Reader, path: Path, value: Any, given: Any) -> Any:  # noqa: ARG002
        """Check components and length."""
        return reader.axis(path, value)


class Directions(ListOf):
    """Two directions."""

    def read(self, reader: Reader, path: Path, value: Any, given: Any) -> Any:  # noqa: ARG002
        """Check both."""
        if value is BROKEN:
            return reader.zero(), reader.zero()
        return tuple(reader.axis((*path, i), axis) for i, axis in enumerate(value))


@dataclass(frozen=True)
class Table(Kind):
    """A table: of values of one kind, or one that the reader of the part checks itself."""

    item: Kind | None = None
    parts: tuple[type[Part], ...] = ()

    def schema(self) -> dict[str, Any]:
        """JSON Schema of a table."""
        if self.item is not None:
            return {
                "type": "object",
                "additionalProperties": self.item.schema(),
                **super().schema(),
            }
        forms = [schema_of(part) for part in self.parts]
        return {**(forms[0] if len(forms) == 1 else {"anyOf": forms}), **super().schema()}

    def parse(self, draft: Draft, path: Path, value: Any) -> Any:
        """Check all items."""
        if not isinstance(value, dict):
            return self.wrong(draft, path, "must be a table", value)
        if self.item is None:
            return value
        parsed = {name: self.item.parse(draft, (*path, name), x) for name, x in value.items()}
        return BROKEN if BROKEN in parsed.values() else parsed


@dataclass(frozen=True)
class ByShape(Kind):
    """One of several kinds, by the shape of what is written; it stays as it was parsed."""

    number: Kind | None = None
    vector: Kind | None = None
    vectors: Kind | None = None
    table: Kind | None = None

    def schema(self) -> dict[str, Any]:
        """JSON Schema of all of them."""
        kinds = (self.number, self.table, self.vector, self.vectors)
        return {"oneOf": [kind.schema() for kind in kinds if kind], **super().schema()}

    def parse(self, draft: Draft, path: Path, value: Any) -> Any:
        """Parse what the shape of the value tells."""
        kind = self.number or self.vector
        if isinstance(value, dict):
            kind = self.table or kind
        elif isinstance(value, list):
            nested = any(isinstance(item, list) for item in value)
            kind = (self.vectors if nested else None) or self.vector or kind
        assert kind is not None
        return kind.parse(draft, path, value)


@dataclass(frozen=True)
class Choice(Kind):
    """One of a few words or whole numbers."""

    words: tuple[str | int, ...] = ()

    def schema(self) -> dict[str, Any]:
        """JSON Schema of the words."""
        first, *more = self.words
        form = {"enum": [first, *more]} if more else {"const": first}
        return {"type": _TYPES[type(first)][0], **form, **super().schema()}

    def parse(self, draft: Draft, path: Path, value: Any) -> Any:
        """Report a value outside the list."""
        if type(value) in (str, int) and value in self.words:
            return value
        name = str(path[-1])
        message, help = f"unknown {name} {shown(value)}", None
        if name == "order":
            message = f"order {shown(value)} is not available"
            help = "use 2, 4, 6 or 8, or 0 for the one that a tolerance chooses"
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

    def schema(self) -> dict[str, Any]:
        """JSON Schema of the type."""
        pattern = {"pattern": self.pattern} if self.pattern else {}
        return {"type": _TYPES[self.type][0], **pattern, **super().schema()}

    def parse(self, draft: Draft, path: Path, value: Any) -> Any:
        """Check the type."""
        fits = type(value) is self.type
        return value if fits else self.wrong(draft, path, _TYPES[self.type][1], value)

    def read(self, reader: Reader, path: Path, value: Any, given: Any) -> Any:  # noqa: ARG002
        """Check the rule of a whole number."""
        if self.rule is not None and value is not BROKEN and not self.rule.holds(value):
            reader.draft.error(path, f"must be {self.rule.words}, got {value}")
        return value


_TYPES = {
    str: ("string", "must be a text"),
    bool: ("boolean", "must be true or false"),
    int: ("integer", "must be a whole number"),
}


class BodyName(Plain):
    """Name of a body; None is the ground."""

    def schema(self) -> dict[str, Any]:
        """JSON Schema of a name that may be missing."""
        return {**super().schema(), "default": "ground"}

    def read(self, reader: Reader, path: Path, value: Any, given: Any) -> Any:  # noqa: ARG002
        """Report what is no body with axes."""
        fine = value is not BROKEN and reader.body(path, value, ground=True)
        return value if fine and value != "ground" else None


@dataclass(frozen=True)
class JointName(Plain):
    """Name of a joint that has an angle or a displacement."""

    has: str = "angle"

    def read(self, reader: Reader, path: Path, value: Any, given: Any) -> Any:  # noqa: ARG002
        """Report what is no such joint."""
        reader.joint(path, value, self.has)
        return "" if value is BROKEN else value


@dataclass(frozen=True)
class JointNames(ListOf):
    """Names of two joints, the first with an angle."""

    second: str = "angle"

    def read(self, reader: Reader, path: Path, value: Any, given: Any) -> Any:  # noqa: ARG002
        """Report what are no such joints."""
        if value is BROKEN:
            return "", ""
        fine = [
            reader.joint((*path, i), name, has)
            for i, (name, has) in enumerate(zip(value, ("angle", self.second), strict=True))
        ]
        if all(fine) and value[0] == value[1] and self.second == "angle":
            reader.draft.error(path, f"both joints are '{value[0]}'")
        return tuple(value)


class BodyNames(ListOf):
    """Names of the two bodies of a joint; None is the ground."""

    def read(self, reader: Reader, path: Path, value: Any, given: Any) -> Any:  # noqa: ARG002
        """Report what are no two bodies."""
        return reader.pair(path, value)


class PointNames(ListOf):
    """Names of two points."""


class Ends(PointNames):
    """Two ends of a part: names, and beside them the places of those on a body or the ground."""

    @property
    def beside(self) -> Mapping[str, Kind]:
        """Fields of the file that belong to the ends."""
        return {"at": _AT}

    def read(self, reader: Reader, path: Path, value: Any, given: Any) -> Any:
        """Find both places."""
        return reader.ends(path[:-1], value, given.at)


class End(Plain):
    """One end of a part: its name, and beside it the place on a body."""

    @property
    def beside(self) -> Mapping[str, Kind]:
        """Fields of the file that belong to the end."""
        return {"at": _ON}

    def read(self, reader: Reader, path: Path, value: Any, given: Any) -> Any:
        """Find the place."""
        return reader.point(path[:-1], value, given.at)


NUMBER, COMPONENTS, NAME = Quantity(), Components(), Plain()
_AT = ByShape(
    text="m, place of 'ground', or of each end, as drawn",
    vector=COMPONENTS,
    vectors=ListOf(item=COMPONENTS),
)
_ON = Components("m", "place on the body that `point` names, as drawn")
TWO_ENDS = Ends(item=NAME, two=True, example=["A", "B"])
TWO_BODIES = BodyNames(item=NAME, two=True, example=["ground", "rod"])
TWO_AXES = Directions(item=COMPONENTS, two=True, example=[[1, 0, 0], [0, 1, 0]])
ONE_END = End(example="A")


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
    is_usual: ClassVar[bool] = False
    """Whether a part without a type has this one."""
    only_in_space: ClassVar[str] = ""
    """Of what the plane does not have: what it has instead."""
    offers: ClassVar[tuple[Offer, ...]] = ()
    """Quantities that expressions and the FMU have of it."""
    also: ClassVar[Mapping[str, Kind]] = {}
    """Fields of the file from which others are calculated."""

    @classmethod
    def read(cls, reader: Reader, path: Path, given: Any) -> Any:
        """Return the part whose fields, as they were parsed, are `given`."""
        return cls(**reader.fields(cls, path, given))

    @classmethod
    def offered(cls, *, joins_points: bool) -> tuple[Offer, ...]:  # noqa: ARG003
        """Quantities of a part that joins two points rather than two bodies, or not."""
        return cls.offers

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
    for name, field in fields_of(part).items():
        properties[name] = field.kind.schema()
        if isinstance(field.default, (str, bool, int, float, dict)) and field.kind.required is None:
            properties[name]["default"] = field.default
    required = [name for name, field in fields_of(part).items() if field.required]
    return {
        "type": "object",
        "description": (part.__doc__ or "").partition("\n\n")[0].replace("\n    ", " "),
        "properties": properties,
        **({"required": required} if required else {}),
        "additionalProperties": False,
    }
