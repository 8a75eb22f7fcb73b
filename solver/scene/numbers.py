"""Numbers of a scene: which symbols may stand where, whether values keep their rules; vectors.

Parameters have default values, so every number that depends on parameters alone is evaluated with
them here; a rule such as "mass >= 0" that fails already with the defaults is a mistake in the file.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Any, TypeVar

from solver.scene.expression import (
    FUNCTIONS,
    MECHANISM_FUNCTIONS,
    ExpressionError,
    Number,
    Vector,
    evaluate,
)
from solver.scene.fields import BROKEN
from solver.scene.grammar import Mention, ParsedNumber
from solver.scene.mistakes import Path
from solver.scene.quantities import Level, Offer, quantities
from solver.scene.rules import GEOMETRY, SETTING, Place, Rule
from solver.scene.units import misfit, remedy, symbol_help
from solver.scene.words import a, did_you_mean, nearest

if TYPE_CHECKING:
    from solver.scene.draft import Draft

T = TypeVar("T")

LARGEST_NUMBER = 1e100
"""Largest size of a number of a mechanism: products of three of them are finite."""


@dataclass
class Known:
    """Everything an expression can mention."""

    parts: Mapping[str, str]
    """Name of each part and what it is: "point", "body", "bar", "parameter", "input", ..."""
    tunable: dict[str, str] = field(default_factory=dict)
    """Tunable parameters, and the one each of them is calculated from, or itself."""
    ends: dict[str, None] = field(default_factory=dict)
    """Points, bodies with an origin, and points of bodies: what ``distance`` takes."""
    dimension: int = 3
    offered: Mapping[str, tuple[Offer, ...]] = field(default_factory=dict)
    """What each part offers, once the parts are counted."""
    touches: bool = False
    """Whether there are contacts, or friction of joints."""
    values: dict[str, float] = field(default_factory=dict)
    """Default values of the parameters that have one."""
    uses: dict[str, list[Path]] = field(default_factory=dict)
    """Where each name stands in an expression."""
    reported: set[str] = field(default_factory=set)
    """Named expressions that mention what no place knows."""

    @cached_property
    def quantities(self) -> Mapping[str, Level]:
        """The mechanism's own quantities; many, of which few scenes mention any."""
        return quantities(self.offered, self.dimension, self.touches)

    def of(self, *kinds: str) -> list[str]:
        """Names of all parts of these kinds."""
        return [name for name, kind in self.parts.items() if kind in kinds]


class NumberChecks:
    """Judge of every number and vector of a scene."""

    def __init__(self, draft: Draft, known: Known) -> None:
        self.draft = draft
        self.known = known

    @property
    def dimension(self) -> int | None:
        """Of the scene; None: broken, so that vectors may have two or three numbers."""
        return self.draft.dimension

    def number(
        self,
        path: Path,
        parsed: Any,
        place: Place = GEOMETRY,
        rule: Rule | None = None,
        unit: str = "",
    ) -> Number:
        """Check one number and return it; 0.0 stands for a broken one."""
        if parsed is BROKEN:
            return 0.0
        if parsed.is_constant:
            value = parsed.number
        elif self.mentions_are_allowed(path, parsed, place):
            value = self.default(path, parsed)
        else:
            return 0.0
        if value is not None and abs(value) > LARGEST_NUMBER and place is not SETTING:
            self.draft.error(path, f"must be at most {LARGEST_NUMBER:g} in size, got {value:.6g}")
        elif value is not None and rule is not None and not rule.holds(value):
            unit = f" {unit}" if unit else ""
            is_plain = isinstance(parsed.number, float) and not parsed.unit
            how = "" if is_plain else f" (= {parsed.text})"
            self.draft.error(path, f"must be {rule.words}{unit}, got {value:.15g}{how}", rule.help)
        return parsed.number

    def angle(self, path: Path, parsed: Any, place: Place = GEOMETRY) -> Number:
        """Check an angle in rad; one of more than a turn is perhaps in degrees."""
        number = self.number(path, parsed, place)
        self.advise_radians(path, parsed, self.value(number) or 0.0)
        return number

    def advise_radians(self, path: Path, parsed: Any, value: float) -> None:
        """Warn of an angle in rad of more than a turn."""
        is_plain = "pi" not in parsed.text and not parsed.unit
        if abs(turns := value / (2.0 * math.pi)) > 1.0 and is_plain:
            help = f'if these are degrees, write "{value:.12g} deg"'
            self.draft.warn(path, f"is {value:.6g} rad, {turns:.3g} turns", help)

    def in_unit(self, path: Path, parsed: Any, unit: str) -> None:
        """Report a literal whose unit is not this one, where the kind of its field allows more."""
        if parsed not in (None, BROKEN) and parsed.unit and (words := misfit(parsed.unit, unit)):
            self.draft.error(path, f"is {parsed.text}, {words}", remedy(unit))

    def constant(
        self,
        path: Path,
        parsed: Any,
        default: float = 0.0,
        rule: Rule | None = None,
        unit: str = "",
    ) -> float:
        """Check a number without symbols; `default` stands for a missing or broken one."""
        if parsed is None or parsed is BROKEN:
            return default
        if parsed.mentions and all(self._is_word(mention) for mention in parsed.mentions):
            limits = f", {rule.words} {unit}" if rule else f" in {unit}" if unit else ""
            message = f"must be a number{limits.rstrip()}, got '{parsed.text}'"
            help = f"write {path[-1]} = {default:g}" if default else None
            self.draft.error(path, message, (rule and rule.help) or help, (parsed.text, 1))
            return default
        number = self.number(path, parsed, SETTING, rule, unit)
        return number if isinstance(number, float) else default

    def _is_word(self, mention: Mention) -> bool:
        """Whether a symbol is nothing that a scene knows."""
        known = mention.name in self.known.parts or mention.name in self.known.quantities
        return mention.role == "symbol" and not known and mention.name not in ("t", *FUNCTIONS)

    def default(self, path: Path, parsed: ParsedNumber) -> float | None:
        """Value with the default parameters; None when it depends on more than those."""
        number, values = parsed.number, self.known.values
        if isinstance(number, float):
            return number
        if any(mention.name not in values for mention in parsed.mentions):
            return None
        try:
            return evaluate(number, values)
        except ExpressionError as error:
            message = f"no value with the default parameters: {error.message}"
            self.draft.error(path, message, None, (parsed.text, 1))
            return None

    def mentions_are_allowed(self, path: Path, parsed: ParsedNumber, place: Place) -> bool:
        """Report every name in an expression that is unknown or out of place."""
        fine = True
        for name in sorted(parsed.named & {*place.own}):
            fine = False
            self.draft.error(path, *_own_and(name, "expression"))
        for mention in parsed.mentions:
            if not self.known.reported.isdisjoint(mention.within):
                fine = False
                continue
            self.known.uses.setdefault(mention.name, []).append(path)
            judge = self._symbol if mention.role == "symbol" else self._call
            verdict = judge(mention, place)
            if verdict is not None:
                fine, (message, help) = False, verdict
                if mention.within:
                    message += f" (in the expression '{_OF.join(mention.within[::-1])}')"
                self.draft.error(path, message, help, (parsed.text, mention.column))
        return fine

    def value(self, number: Number) -> float | None:
        """Value with the default parameters; None where it has none, which others report."""
        try:
            return evaluate(number, self.known.values)
        except (ExpressionError, KeyError):
            return None

    def _call(self, mention: Mention, place: Place) -> tuple[str, str | None] | None:
        """Judge a function of the mechanism: where it stands, and which parts it names."""
        if mention.role == "function":
            return None if place.levels else (f"{mention.name}() {_ELSEWHERE}", None)
        return unknown_end(self.known, mention.name)

    def _symbol(self, mention: Mention, place: Place) -> tuple[str, str | None] | None:
        name, kind = mention.name, self.known.parts.get(mention.name)
        if name in place.own:
            if kind is None:
                return None
            return _own_and(name, kind)
        if kind == "parameter":
            return self._parameter(name, place)
        if kind == "state" and (own := self.known.offered.get(name)):
            known = ", ".join(f"{name}.{offer.word}" for offer in own)
            return f"'{name}' has no value of its own", f"known: {known}"
        if self.known.quantities.get(name) == "state":
            kind = "state"
        if name == "t" or kind in ("input", "state"):
            what = "the time 't'" if name == "t" else f"the {kind} '{name}'"
            if place.time:
                return None
            if place.levels or place.own:
                return f"{what} is not possible here", None
            return f"{what} is possible only in forces, constraints, drivers and outputs", None
        if name in self.known.quantities:
            return self._quantity(name, place)
        return self._unknown(name, kind, place)

    def _quantity(self, name: str, place: Place) -> tuple[str, str | None] | None:
        """Judge a quantity of the mechanism, which not every place may mention."""
        level = self.known.quantities[name]
        if level in place.levels:
            return None
        if not place.levels:
            return f"the mechanism's own '{name}' {_ELSEWHERE}", None
        if level == "rate":
            return f"'{name}' is a velocity, and only positions are possible here", None
        words = "positions and velocities" if "rate" in place.levels else "positions"
        help = f"here the {words} of points and joints are possible"
        if level == "acceleration":
            message = f"'{name}' is an acceleration, which follows from all forces and constraints"
            return f"{message}: it is possible only in outputs", help
        return f"'{name}' is possible only in outputs", help

    def _parameter(self, name: str, place: Place) -> tuple[str, str | None] | None:
        if not place.parameters:
            return f"must be a plain number, parameter '{name}' is not possible here", None
        if name in self.known.tunable and not place.tunable:
            help = f"make '{self.known.tunable[name]}' a fixed parameter"
            words = "is possible only in forces, constraints, drivers and outputs"
            return f"the tunable parameter '{name}' {words}", help
        return None

    def _unknown(self, name: str, kind: str | None, place: Place) -> tuple[str, str | None]:
        if kind == "output":
            return f"'{name}' is an output, which no expression may use", None
        owner, levels = name.split(".")[0], place.levels
        possible = [word for word, level in self.known.quantities.items() if level in levels]
        if kind != "parameter" and any(word.startswith(f"{owner}.") for word in possible):
            return self._unknown_of(name, owner, possible)
        if name in FUNCTIONS or name in MECHANISM_FUNCTIONS:
            return f"'{name}' is a function", f"write {name}(...)"
        if kind is not None:
            help = f"write {name}(...)" if kind == "profile" else None
            return f"'{name}' is {a(kind)}, not a number", help
        kinds = ("parameter", "expression") if place.parameters else ()
        words = [*place.own, *(other for other in self.known.of(*kinds) if other != place.of)]
        if place.time:
            words += ["t", *self.known.of("input", "state")]
        words += sorted(possible)
        is_near = nearest(name, words) is not None
        unit = symbol_help(name) if len(name) > 1 and not is_near else None
        return f"unknown symbol '{name}'", unit or did_you_mean(name, words)

    def _unknown_of(self, name: str, owner: str, possible: list[str]) -> tuple[str, str | None]:
        """Judge a name that begins like that of a part: list what the part has."""
        within = [word for word in possible if word.startswith(f"{name}.")]
        message = f"'{name}' has no value of its own" if within else f"unknown quantity '{name}'"
        above = name.rpartition(".")[0]
        whole = name if within else above if above in self.known.ends else owner
        points = [f"{end}." for end in self.known.ends if end.startswith(f"{whole}.")]
        own = [
            word
            for word in possible
            if word.startswith(f"{whole}.") and not word.startswith(tuple(points))
        ]
        return message, f"known: {', '.join(sorted(own))}"

    # ----------------------------------------------------------------------------- vectors

    def zero(self) -> Vector:
        """Return the zero vector of the scene's dimension."""
        return (0.0,) * (self.dimension or 3)

    def vector(self, path: Path, readings: Any, place: Place = GEOMETRY) -> Vector:
        """Read a vector of the scene's dimension."""
        wanted = self.dimension or 3
        if readings is BROKEN:
            return (0.0,) * wanted
        if len(readings) != wanted and not (self.dimension is None and len(readings) == 2):
            message = f"must have {wanted} numbers in dimension {wanted}, got {len(readings)}"
            planar = path == ("gravity",) and wanted == 3
            self.draft.error(path, message, "in the plane write dimension = 2" if planar else None)
        return self.entries(path, readings, place)

    def entries(self, path: Path, readings: Any, place: Place = GEOMETRY) -> Vector:
        """Read the numbers of a list."""
        if all([parsed.is_constant for parsed in readings]):
            numbers = tuple([parsed.number for parsed in readings])
            if all([-LARGEST_NUMBER <= number <= LARGEST_NUMBER for number in numbers]):
                return numbers
        return tuple(self.number((*path, i), parsed, place) for i, parsed in enumerate(readings))

    def matrix(
        self, path: Path, readings: Any
    ) -> tuple[tuple[Vector, ...], list[list[float]]] | None:
        """Read 3 rows of 3 numbers, and their values if all are known; None for another shape."""
        if [len(row) for row in readings] != [3, 3, 3]:
            self.draft.error(path, "must have 3 rows of 3 numbers")
            return None
        rows = tuple(self.vector((*path, i), row) for i, row in enumerate(readings))
        values = [known for row in rows if (known := self.values(row)) is not None]
        return rows, values if len(values) == 3 else []

    def axis(self, path: Path, readings: Any) -> Vector:
        """Read a direction of any length but zero."""
        axis = self.vector(path, readings)
        if readings is BROKEN or len(axis) != len(self.zero()):
            return axis
        fine = self.has_length(path, axis, "a direction")
        return axis if fine else (1.0, *self.zero()[1:])

    def has_length(self, path: Path, vector: Vector, what: str) -> bool:
        """Report a vector whose length is zero, or too small or large for its square."""
        values = self.values(vector)
        size = 1.0 if values is None else max(map(abs, values))
        if not 1.0 / LARGEST_NUMBER <= size <= LARGEST_NUMBER:
            length = f"{size:.3g}" if size else "zero"
            help = "any other length will do"
            if size:
                help = f"any length from {1.0 / LARGEST_NUMBER:g} to {LARGEST_NUMBER:g} will do"
            self.draft.error(path, f"{what} of length {length}", help)
        return values is not None and 1.0 / LARGEST_NUMBER <= size <= LARGEST_NUMBER

    def values(self, vector: Vector) -> list[float] | None:
        """Values with the default parameters; None where one of them has none."""
        values = [self.value(number) for number in vector]
        known = [value for value in values if value is not None]
        return known if len(known) == len(values) else None

    def calculated(self, path: Path, calculate: Callable[[], T], otherwise: T) -> T:
        """Return what is calculated from numbers of the file, unless it has no finite value."""
        try:
            result = calculate()
        except ExpressionError as error:
            self.draft.error(path, f"no value: {error.message}")
            return otherwise
        except OverflowError:
            result = math.inf
        if _finite(result):
            return result  # pyright: ignore[reportReturnType]
        self.draft.error(path, "no value: larger than any floating-point number")
        return otherwise


_OF = "' of '"
_ELSEWHERE = "is possible only in outputs, in constraints and in the values of forces and torques"


def _own_and(name: str, kind: str) -> tuple[str, str]:
    """Judge a symbol of a place that is the name of something else too."""
    message = f"'{name}' has a meaning of its own here, and is the name of {a(kind)}"
    return message, f"rename the {kind}"


def unknown_end(known: Known, name: str, *, ground: bool = False) -> tuple[str, str | None] | None:
    """Judge the name of a point, of a body with an origin, or of a point of a body.

    `ground` says that the ground would do as well.
    """
    if name in known.ends:
        return None
    owner, _, point = name.partition(".")
    kind = known.parts.get(owner)
    if point and kind == "body":
        own = [end.partition(".")[2] for end in known.ends if end.startswith(f"{owner}.")]
        help = did_you_mean(point, own, f"points of '{owner}'")
        return f"body '{owner}' has no point '{point}'", help or "write it into its table 'points'"
    if point and kind is not None:
        return f"'{owner}' is {a(kind)}, and only a rigid body has points of its own", None
    if kind == "bar":
        return f"'{name}' is a bar, not a point", "name one of its two points"
    if kind is not None:
        return f"'{name}' is {a(kind)}, not a point", None
    ends = [*known.ends, *(["ground"] if ground else [])]
    return f"unknown point '{name}'", did_you_mean(name, ends, "known points")


def _finite(result: object) -> bool:
    """Whether all numbers of a result that are known are finite."""
    if isinstance(result, tuple):
        return all(_finite(item) for item in result)
    return not isinstance(result, float) or math.isfinite(result)


def dot(a: Sequence[Number], b: Sequence[Number]) -> Number:
    """Inner product of two vectors."""
    total: Number = 0.0
    for x, y in zip(a, b, strict=True):
        total = total + x * y
    return total


def times(matrix: Sequence[Vector], vector: Sequence[Number]) -> Vector:
    """Product of a matrix, given by its rows, and a vector."""
    return tuple(dot(row, vector) for row in matrix)
