"""Numbers of a scene: which symbols may stand where, and whether values keep their rules.

Parameters have default values, so every number that depends on parameters alone is evaluated with
them here; a rule such as "mass >= 0" that fails already with the defaults is a mistake in the file.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

from solver.scene.draft import Draft
from solver.scene.expression import ExpressionError, Number, evaluate
from solver.scene.fields import BROKEN
from solver.scene.grammar import Mention, Reading
from solver.scene.operations import FUNCTIONS, MECHANISM_FUNCTIONS
from solver.scene.report import Path, did_you_mean


@dataclass(frozen=True, slots=True)
class Place:
    """What an expression may mention at one kind of place."""

    parameters: bool = True
    tunable: bool = True
    time: bool = False
    mechanism: bool = False


SETTING = Place(parameters=False, tunable=False)
PARAMETER = Place()
GEOMETRY = Place(tunable=False)
FORCE = Place(time=True)
OUTPUT = Place(time=True, mechanism=True)


@dataclass(frozen=True, slots=True)
class Rule:
    """A condition on a value, with its words."""

    holds: Callable[[float], bool]
    words: str


POSITIVE = Rule(lambda x: x > 0.0, "> 0")
NOT_NEGATIVE = Rule(lambda x: x >= 0.0, ">= 0")


def up_to(highest: float, above: Rule = POSITIVE) -> Rule:
    """Rule of a range: as low as another rule has it, and no higher than this."""
    words = f"{above.words} and <= {highest:g}"
    return Rule(lambda x: above.holds(x) and x <= highest, words)


@dataclass(slots=True)
class Known:
    """Everything an expression can mention."""

    parts: Mapping[str, str]
    """Name of each part and what it is: "point", "bar", "parameter", "input", "output", ..."""
    tunable: dict[str, str] = field(default_factory=dict)
    """Tunable parameters, and the one each of them is calculated from, or itself."""
    quantities: set[str] = field(default_factory=set)
    values: dict[str, float] = field(default_factory=dict)
    """Default values of the parameters that have one."""

    def of(self, *kinds: str) -> list[str]:
        """Names of all parts of these kinds."""
        return [name for name, kind in self.parts.items() if kind in kinds]


class Numbers:
    """Judge of every number of a scene."""

    def __init__(self, draft: Draft, known: Known) -> None:
        self.draft = draft
        self.known = known

    def number(
        self, path: Path, reading: Any, place: Place, rule: Rule | None = None, unit: str = ""
    ) -> Number:
        """Check one number and return it; 0.0 stands for a broken one."""
        if reading is BROKEN or not self.mentions_are_allowed(path, reading, place):
            return 0.0
        value = self.default(path, reading)
        if value is not None and rule is not None and not rule.holds(value):
            unit = f" {unit}" if unit else ""
            how = "" if isinstance(reading.number, float) else f" (= {reading.text})"
            self.draft.error(path, f"must be {rule.words}{unit}, got {value:.15g}{how}")
        return reading.number

    def optional(
        self, path: Path, reading: Any, place: Place, rule: Rule | None = None, unit: str = ""
    ) -> Number | None:
        """Check a number that may be missing."""
        return None if reading is None else self.number(path, reading, place, rule, unit)

    def constant(
        self, path: Path, reading: Any, default: float, rule: Rule | None = None, unit: str = ""
    ) -> float:
        """Check a number without symbols; `default` stands for a missing or broken one."""
        if reading is None or reading is BROKEN:
            return default
        number = self.number(path, reading, SETTING, rule, unit)
        return number if isinstance(number, float) else default

    def default(self, path: Path, reading: Reading) -> float | None:
        """Value with the default parameters; None when it depends on more than those."""
        number, values = reading.number, self.known.values
        if isinstance(number, float):
            return number
        if any(mention.name not in values for mention in reading.mentions):
            return None
        try:
            return evaluate(number, values)
        except ExpressionError as error:
            message = f"no value with the default parameters: {error.message}"
            self.draft.error(path, message, None, (reading.text, 1))
            return None

    def mentions_are_allowed(self, path: Path, reading: Reading, place: Place) -> bool:
        """Report every name in an expression that is unknown or out of place."""
        fine = True
        for mention in reading.mentions:
            judge = self._symbol if mention.role == "symbol" else self._call
            verdict = judge(mention, place)
            if verdict is not None:
                fine = False
                self.draft.error(path, *verdict, (reading.text, mention.column))
        return fine

    def _call(self, mention: Mention, place: Place) -> tuple[str, str | None] | None:
        """Judge a function of the mechanism: where it stands, and which parts it names."""
        if mention.role == "function":
            words = f"{mention.name}() is possible only in outputs"
            return None if place.mechanism else (words, None)
        if self.known.parts.get(mention.name) == "point":
            return None
        help = did_you_mean(mention.name, self.known.of("point"), "known points")
        return f"unknown point '{mention.name}'", help

    def _symbol(self, mention: Mention, place: Place) -> tuple[str, str | None] | None:
        name, kind = mention.name, self.known.parts.get(mention.name)
        if kind == "parameter":
            return self._parameter(name, place)
        if name == "t" or kind == "input":
            what = "the time 't'" if name == "t" else f"the input '{name}'"
            return None if place.time else (f"{what} is possible only in forces and outputs", None)
        if name in self.known.quantities:
            if place.mechanism:
                return None
            return f"the mechanism's own '{name}' is possible only in outputs", None
        return self._unknown(name, kind, place)

    def _parameter(self, name: str, place: Place) -> tuple[str, str | None] | None:
        if not place.parameters:
            return f"must be a plain number, parameter '{name}' is not possible here", None
        if name in self.known.tunable and not place.tunable:
            help = f"make '{self.known.tunable[name]}' a fixed parameter"
            return f"the tunable parameter '{name}' is possible only in forces and outputs", help
        return None

    def _unknown(self, name: str, kind: str | None, place: Place) -> tuple[str, str | None]:
        if kind == "output":
            return f"'{name}' is an output, which no expression may use", None
        owner = name.split(".")[0]
        own = [word for word in sorted(self.known.quantities) if word.startswith(f"{owner}.")]
        if place.mechanism and own:
            message = f"'{name}' has no value of its own" if name == owner else None
            return message or f"unknown quantity '{name}'", f"known: {', '.join(own)}"
        if name in FUNCTIONS or name in MECHANISM_FUNCTIONS:
            return f"'{name}' is a function", f"write {name}(...)"
        if kind is not None:
            return f"'{name}' is a {kind}, not a number", None
        words = self.known.of("parameter") if place.parameters else []
        if place.time:
            words += ["t", *self.known.of("input")]
        if place.mechanism:
            words += [word for word in sorted(self.known.quantities) if name.count(".")]
        return f"unknown symbol '{name}'", did_you_mean(name, words)
