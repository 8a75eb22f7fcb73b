"""Parameters and inputs of a scene: default values, circles, ranges, what may change when."""

from __future__ import annotations

from dataclasses import replace
from graphlib import CycleError, TopologicalSorter
from typing import Any

from solver.scene.diagnostics import Draft
from solver.scene.fields import BROKEN
from solver.scene.numbers import PARAMETER, Numbers
from solver.scene.report import Path
from solver.scene.units import not_of_si
from solver.scene.vocabulary_parts import Input, Parameter


def read_parameters(numbers: Numbers) -> dict[str, Parameter]:
    """Read the table [parameters]; their default values and variabilities become known."""
    draft, known = numbers.draft, numbers.known
    parts = draft.parts("parameters")
    ranges = {}
    for name in _order(draft, parts):
        part = parts[name]
        _calculate(numbers, name, part)
        before = len(draft.problems)
        ranges[name] = _range(numbers, ("parameters", name), part, known.values.get(name))
        if len(draft.problems) > before:
            known.values.pop(name, None)  # what is calculated from it is not wrong once more
    read = {}
    for name, part in parts.items():
        check_unit(draft, ("parameters", name), part)
        low, high = ranges[name]
        read[name] = Parameter(
            value=0.0 if part.value is BROKEN else part.value.number,
            unit=part.unit,
            description=part.description,
            minimum=low,
            maximum=high,
            variability="tunable" if name in known.tunable else "fixed",
        )
    return read


def read_inputs(numbers: Numbers) -> dict[str, Input]:
    """Read the table [inputs]."""
    read = {}
    for name, part in numbers.draft.parts("inputs").items():
        check_unit(numbers.draft, ("inputs", name), part)
        start = numbers.constant(("inputs", name, "start"), part.start, 0.0)
        low, high = _range(numbers, ("inputs", name), part, start)
        if part.limit == "clip" and part.min is None and part.max is None:
            message = "there is nothing to clip to without min or max"
            numbers.draft.error(("inputs", name, "limit"), message, "give one, or leave it out")
        read[name] = Input(
            start=start,
            unit=part.unit,
            description=part.description,
            minimum=low,
            maximum=high,
            interpolation=part.interpolation,
            limit=part.limit,
        )
    return read


def check_unit(draft: Draft, path: Path, part: Any) -> None:
    """Report a unit that is not of SI: nothing would convert the number."""
    message, help = not_of_si(part.unit) if isinstance(part.unit, str) else ("", "")
    if message:
        draft.error((*path, "unit"), message, help)


def _calculate(numbers: Numbers, name: str, part: Any) -> None:
    """Note the default value of a parameter, and whether it is or depends on a tunable one."""
    path, known = _value_path(numbers.draft, name), numbers.known
    uses = _uses(part)
    origins = [known.tunable[used] for used in uses if used in known.tunable]
    if part.variability == "tunable" or origins:
        known.tunable[name] = origins[0] if origins else name
    if uses and part.variability is not None and part.variability is not BROKEN:
        message = "a calculated parameter has the variability of what it is calculated from"
        numbers.draft.error(("parameters", name, "variability"), message, "leave it out")
    place = replace(PARAMETER, of=name)
    if part.value is BROKEN or not numbers.mentions_are_allowed(path, part.value, place):
        return
    value = numbers.default(path, part.value)
    if value is not None:
        known.values[name] = value


def _uses(part: Any) -> list[str]:
    """Names in a parameter's value, in the order of the text."""
    if part.value is BROKEN:
        return []
    return list(dict.fromkeys(mention.name for mention in part.value.mentions))


def _value_path(draft: Draft, name: str) -> Path:
    """Place of a parameter's value, in the short form or in a table."""
    short = not isinstance(draft.data["parameters"][name], dict)
    return ("parameters", name) if short else ("parameters", name, "value")


def _order(draft: Draft, parts: dict[str, Any]) -> list[str]:
    """Parameters in the order of their calculation; circles are reported, and come last."""
    uses = {name: [u for u in _uses(part) if u in parts] for name, part in parts.items()}
    circular: list[str] = []
    while True:
        try:
            return [*TopologicalSorter(uses).static_order(), *circular]
        except CycleError as error:
            circle = error.args[1][:0:-1]  # each uses the next
        first = min(circle, key=list(parts).index)
        start = circle.index(first)
        names = [*circle[start:], *circle[:start], first]
        message = f"calculated from itself: {' -> '.join(names)}"
        draft.error(_value_path(draft, first), message)
        circular += circle
        uses = {
            name: [used for used in names if used not in circle]
            for name, names in uses.items()
            if name not in circle
        }


def _range(
    numbers: Numbers, path: Path, part: Any, value: float | None
) -> tuple[float | None, float | None]:
    """Read min and max of a parameter or input and hold its value against them."""
    given: list[float | None] = []
    for word, bound in (("min", part.min), ("max", part.max)):
        absent = bound is None or bound is BROKEN
        given.append(None if absent else numbers.constant((*path, word), bound, 0.0))
    low, high = given
    unit = f" {part.unit}" if isinstance(part.unit, str) and part.unit else ""
    field = (*path, "value" if path[0] == "parameters" else "start")
    if low is not None and high is not None and low > high:
        numbers.draft.error((*path, "min"), f"min {low:g} is larger than max {high:g}")
    elif value is not None and low is not None and not value >= low:
        numbers.draft.error(field, f"must be >= {low:g}{unit} (min), got {value:.15g}")
    elif value is not None and high is not None and not value <= high:
        numbers.draft.error(field, f"must be <= {high:g}{unit} (max), got {value:.15g}")
    return low, high
