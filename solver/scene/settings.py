"""Settings of the solver and of the default run: choices, ranges and how the steps relate."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from solver.options import OPTIONS, Option
from solver.scene import schema
from solver.scene.fields import BROKEN
from solver.scene.numbers import NOT_NEGATIVE, POSITIVE, Numbers, Rule, up_to
from solver.scene.vocabulary import Experiment, SolverSettings

TOLERANCE = Rule(
    OPTIONS["tolerance"].holds,
    "0 or from 1e-14 to 0.1",
    "write for instance tolerance = 1e-6, the error of the run relative to size and speed; no run "
    "comes closer than round-off, some 1e-14",
)


def _rule(option: Option) -> Rule:
    if option.whole:
        return Rule(option.holds, f"from {option.low:g} to {option.high:g}")
    above = NOT_NEGATIVE if option.low == 0.0 else POSITIVE
    return replace(up_to(option.high, above), holds=option.holds)


RANGES = {name: _rule(option) for name, option in OPTIONS.items() if option.is_number}
RANGES["tolerance"] = TOLERANCE
"""Settings that are numbers."""

ROWS, MOST_INTERNAL_STEPS = 100, 10
"""Communication steps of a default run, and the most internal steps in one of them."""

_DEFAULT = SolverSettings()
_COUNTS = tuple(name for name, option in OPTIONS.items() if option.whole)


def read_settings(numbers: Numbers) -> tuple[SolverSettings, Experiment]:
    """Read the tables [solver] and [experiment]."""
    draft = numbers.draft
    solver = draft.part(("solver",), schema.Solver, draft.table("solver"))
    experiment = draft.part(("experiment",), schema.Experiment, draft.table("experiment"))
    outer = _seconds(numbers, "experiment", experiment, "step_size", 0.0, POSITIVE)
    usual = min(_DEFAULT.step_size, outer) if outer > 0.0 else _DEFAULT.step_size
    inner = _seconds(numbers, "solver", solver, "step_size", usual, RANGES["step_size"])
    if outer > 0.0 and inner > outer:
        message = f"must be at most the communication step {outer:g} s, got {inner:g} s"
        draft.error(("solver", "step_size"), message)
    return _solver(numbers, solver, inner), _experiment(numbers, experiment, inner, outer)


def _seconds(
    numbers: Numbers, table: str, part: Any, name: str, default: float, rule: Rule | None = None
) -> float:
    return numbers.constant((table, name), getattr(part, name), default, rule, "s")


def _solver(numbers: Numbers, solver: Any, step_size: float) -> SolverSettings:
    for name in _COUNTS:
        count = getattr(solver, name)
        if count is not BROKEN and not RANGES[name].holds(count):
            message = f"must be {RANGES[name].words}, got {count}"
            numbers.draft.error(("solver", name), message)

    given = {name: getattr(solver, name) for name in OPTIONS}
    for name in RANGES.keys() - {*_COUNTS, "step_size"}:
        value, unit = getattr(_DEFAULT, name), OPTIONS[name].unit
        given[name] = numbers.constant(("solver", name), given[name], value, RANGES[name], unit)
    return SolverSettings(**given | {"step_size": step_size})


def _experiment(numbers: Numbers, experiment: Any, inner: float, outer: float) -> Experiment:
    start = _seconds(numbers, "experiment", experiment, "start_time", 0.0)
    stop = _seconds(numbers, "experiment", experiment, "stop_time", start + 1.0)
    if not stop > start:
        message = f"must be > start_time = {start:g} s, got {stop:g}"
        numbers.draft.error(("experiment", "stop_time"), message)
    tolerance = experiment.tolerance
    given = numbers.constant(("experiment", "tolerance"), tolerance, 0.0, TOLERANCE)
    # Whole internal steps, so that the communication step does not change the motion.
    counts, whole = range(1, MOST_INTERNAL_STEPS + 1), (stop - start) * (1.0 + 1e-9)
    usual = max((k for k in counts if ROWS * k * inner <= whole), default=1)
    return Experiment(
        start_time=start, stop_time=stop, step_size=outer or usual * inner, tolerance=given or None
    )
