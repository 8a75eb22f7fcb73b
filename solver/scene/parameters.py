"""Parameters and inputs of a scene: default values, circles, ranges, what may change when."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from graphlib import CycleError, TopologicalSorter
from itertools import pairwise
from typing import TYPE_CHECKING, Annotated, Any, Literal

from solver.scene import fields as kind
from solver.scene.expression import Number
from solver.scene.fields import BROKEN, Part
from solver.scene.mistakes import Path
from solver.scene.rules import PARAMETER
from solver.scene.units import base_unit, misfit, not_of_si, offset_of, respelled, si_unit, spelled

if TYPE_CHECKING:
    from solver.scene.draft import Draft
    from solver.scene.references import Reader


def _unit(reader: "Reader", path: Path, unit: Any, given: Any) -> Any:
    """Report a unit that is not of SI, as nothing would convert the number; write it as FMI."""
    message, help = not_of_si(unit) if isinstance(unit, str) else ("", "")
    if message:
        if hasattr(given, "display_unit") and base_unit(unit) and not offset_of(unit):
            help += f'; display_unit = "{spelled(unit)}" shows it so'
        reader.draft.error(path, message, help)
    return spelled(unit) if isinstance(unit, str) and not message else unit


def _display_unit(reader: "Reader", path: Path, unit: Any, _: Any) -> Any:
    """Report a display unit that is none, or that counts from another zero."""
    if not isinstance(unit, str):
        return unit
    if offset := offset_of(unit):
        reader.draft.error(path, *offset)
        return BROKEN
    if base_unit(unit) is None:
        meant = respelled(unit)
        help = f"did you mean '{meant}'?" if meant else "write for instance mm, deg, rpm or kN"
        reader.draft.error(path, f"there is no unit {unit!r}", help)
        return BROKEN
    return spelled(unit)


def settle_units(reader: "Reader", path: Path, given: Any, values: dict[str, Any]) -> None:
    """Hold units of literals against that of their part; where it has none, they give it.

    The display unit, unless it is given, is that of the value's literal.
    """
    names = [name for name in ("value", "start", "min", "max") if hasattr(given, name)]
    parsed = {name: getattr(given, name) for name in names}
    units = {name: x.unit for name, x in parsed.items() if x not in (None, BROKEN) and x.unit}
    shown = values.get("display_unit")
    first = next(iter(units.values()), shown)
    if not values.get("unit") and isinstance(first, str):
        values["unit"] = si_unit(first)
    unit = values.get("unit", "")
    if unit is BROKEN or (unit and base_unit(unit) is None):
        return
    for name in units:
        place = path if not isinstance(_data(reader, path), dict) else (*path, name)
        reader.in_unit(place, parsed[name], unit)
    if isinstance(shown, str):
        if words := misfit(shown, unit):
            help = f"the unit of {path[1]} is {unit or 'none'}"
            reader.draft.error((*path, "display_unit"), f"is {shown}, {words}", help)
    elif hasattr(given, "display_unit") and (own := units.get(names[0], unit)) != unit:
        values["display_unit"] = own


def _data(reader: "Reader", path: Path) -> Any:
    return reader.draft.data[str(path[0])][path[1]]


def _limit(reader: "Reader", path: Path, value: Any, _: Any) -> float | None:
    """Check min or max; what is calculated from a parameter with a mistake is not wrong as well."""
    before = len(reader.draft.problems)
    limit = None if value is BROKEN else reader.constant(path, value, 0.0)
    if len(reader.draft.problems) > before:
        reader.known.values.pop(str(path[1]), None)
    return limit


def _default(reader: "Reader", path: Path, value: Any, given: Any) -> Number:
    """Note the default value of a parameter, and whether it is or depends on a tunable one."""
    name, known = str(path[1]), reader.known
    uses = _uses(given)
    origins = [known.tunable[used] for used in uses if used in known.tunable]
    if given.variability == "tunable" or origins:
        known.tunable[name] = origins[0] if origins else name
    if uses and given.variability not in (None, BROKEN):
        message = "a calculated parameter has the variability of what it is calculated from"
        reader.draft.error((*path[:2], "variability"), message, "leave it out")
    if value is BROKEN:
        return 0.0
    path = _value_path(reader.draft, name)
    if reader.mentions_are_allowed(path, value, replace(PARAMETER, of=name)):
        default = reader.default(path, value)
        if default is not None:
            known.values[name] = default
    return value.number


UNIT, TEXT = kind.Plain(reading=_unit), kind.Plain()
DISPLAY_UNIT = kind.Plain(example="mm", reading=_display_unit)
_VALUE = "default; an expression of other parameters makes it a calculated parameter"
_LEAST = kind.OfAnyUnit(text="least value that it may have", reading=_limit)
_LARGEST = kind.OfAnyUnit(text="largest value that it may have", reading=_limit)


@dataclass(frozen=True, slots=True, kw_only=True)
class Parameter(Part):
    """A number with a name, settable in the FMU."""

    short = "value"

    value: Annotated[Number, kind.OfAnyUnit(text=_VALUE, example=1.0, reading=_default)]
    unit: Annotated[str, UNIT] = ""
    description: Annotated[str, TEXT] = ""
    min: Annotated[float | None, _LEAST] = None
    max: Annotated[float | None, _LARGEST] = None
    variability: Annotated[Literal["fixed", "tunable"], kind.Choice(words=("fixed", "tunable"))] = (
        "fixed"
    )
    """A tunable one may change during a run. Calculated from a tunable one means tunable."""
    display_unit: Annotated[str, DISPLAY_UNIT] = ""

    @classmethod
    def read(cls, reader: "Reader", path: Path, given: Any) -> Any:
        """Check that the default value is within the limits."""
        name, values = str(path[1]), reader.fields(cls, path, given)
        settle_units(reader, path, given, values)
        values["variability"] = "tunable" if name in reader.known.tunable else "fixed"
        parameter = cls(**values)
        if not _within_limits(reader, (*path, "value"), parameter, reader.known.values.get(name)):
            reader.known.values.pop(name, None)
        return parameter


@dataclass(frozen=True, slots=True, kw_only=True)
class Input(Part):
    """A number that arrives from outside at every communication step."""

    start: Annotated[float, kind.setting(text="value until it is set", kind=kind.OfAnyUnit)] = 0.0
    unit: Annotated[str, UNIT] = ""
    description: Annotated[str, TEXT] = ""
    min: Annotated[float | None, _LEAST] = None
    max: Annotated[float | None, _LARGEST] = None
    interpolation: Annotated[
        Literal["hold", "ramp", "smooth"], kind.Choice(words=("hold", "ramp", "smooth"))
    ] = "hold"
    """How drivers and forces see it within a communication step: constant, a straight line from
    the value before to the new one, or a cubic to it whose rate does not jump."""
    limit: Annotated[Literal["refuse", "clip"], kind.Choice(words=("refuse", "clip"))] = "refuse"
    """What happens to a value beyond `min` or `max`: an error, or the limit instead."""
    display_unit: Annotated[str, DISPLAY_UNIT] = ""

    @classmethod
    def read(cls, reader: "Reader", path: Path, given: Any) -> Any:
        """Settle its unit."""
        values = reader.fields(cls, path, given)
        settle_units(reader, path, given, values)
        part = cls(**values)
        part.check(reader, path, given)
        return part

    @property
    def told(self) -> str:
        """Its description in an FMU, which says what to set before a step if it moves there."""
        moves = _MOVES.get(self.interpolation, "")
        return (
            f"{self.description} ({moves})"
            if self.description and moves
            else self.description or moves
        )

    def check(self, reader: "Reader", path: Path, given: Any) -> None:
        """Check that the start is within the limits, and that there are some to clip to."""
        _within_limits(reader, (*path, "start"), self, self.start)
        if given.limit == "clip" and given.min is None and given.max is None:
            message = "there is nothing to clip to without min or max"
            reader.draft.error((*path, "limit"), message, "give one, or leave it out")


_MOVES = {
    "ramp": "a ramp: before each step set its value at the end of the step",
    "smooth": "smooth: before each step set its value at the end of the step",
}
"""What is said of inputs that are not held, by interpolation."""


def _within_limits(
    reader: "Reader", path: Path, part: "Parameter | Input", value: float | None
) -> bool:
    """Hold the value at a path against min and max."""
    low, high = part.min, part.max
    behind = f" {part.unit}" if isinstance(part.unit, str) and part.unit else ""
    if low is not None and high is not None and low > high:
        reader.draft.error((*path[:2], "min"), f"min {low:g} is larger than max {high:g}")
    elif value is not None and low is not None and not value >= low:
        reader.draft.error(path, f"must be >= {low:g}{behind} (min), got {value:.15g}")
    elif value is not None and high is not None and not value <= high:
        reader.draft.error(path, f"must be <= {high:g}{behind} (max), got {value:.15g}")
    else:
        return True
    return False


def read_parameters(reader: "Reader") -> None:
    """Read the table [parameters]; their default values and variabilities become known."""
    found = reader.draft.parts("parameters")
    reader.read("parameters", {name: found[name] for name in _order(reader.draft, found)})
    read = reader.parts["parameters"]
    reader.parts["parameters"] = {name: read[name] for name in found}


def _uses(given: Any) -> list[str]:
    """Names in a parameter's value, in the order of the text."""
    if given.value is BROKEN:
        return []
    return list(dict.fromkeys(mention.name for mention in given.value.mentions))


def _between(given: Any, name: str) -> tuple[str, ...]:
    """Named expressions by which a parameter's value mentions another parameter."""
    return next(x.within for x in given.value.mentions if x.name == name)


def _value_path(draft: "Draft", name: str) -> Path:
    """Place of a parameter's value, in the short form or in a table."""
    short = not isinstance(draft.data["parameters"][name], dict)
    return ("parameters", name) if short else ("parameters", name, "value")


def _order(draft: "Draft", parts: Mapping[str, tuple[type[Part], Any]]) -> list[str]:
    """Parameters in the order of their calculation; circles are reported, and come last."""
    uses = {name: [u for u in _uses(given) if u in parts] for name, (_, given) in parts.items()}
    circular: list[str] = []
    while True:
        try:
            return [*TopologicalSorter(uses).static_order(), *circular]
        except CycleError as error:
            circle = error.args[1][:0:-1]  # each uses the next
        first = min(circle, key=list(parts).index)
        start = circle.index(first)
        names = [*circle[start:], *circle[:start], first]
        steps = (_between(parts[x][1], y) for x, y in pairwise(names))
        by_way = [name for x, step in zip(names, steps, strict=False) for name in (x, *step)]
        message = f"calculated from itself: {' -> '.join([*by_way, first])}"
        draft.error(_value_path(draft, first), message)
        circular += circle
        uses = {
            name: [used for used in names if used not in circle]
            for name, names in uses.items()
            if name not in circle
        }
