"""Settings of the solver and of the default run: choices, ranges and how the steps relate."""

from __future__ import annotations

from typing import Any

from solver.scene import schema
from solver.scene.fields import BROKEN
from solver.scene.numbers import NOT_NEGATIVE, POSITIVE, Numbers, Rule, up_to
from solver.scene.vocabulary import Experiment, SolverSettings

_COUNTS = ("max_newton", "max_uzawa")

TOLERANCE = Rule(
    lambda x: x == 0.0 or 1e-14 <= x <= 0.1,
    "0 or from 1e-14 to 0.1",
    "write for instance tolerance = 1e-6, the error of the run relative to size and speed; no run "
    "comes closer than round-off, some 1e-14",
)

RANGES = {
    "step_size": up_to(1e6),
    "tolerance": TOLERANCE,
    "absolute_tolerance": up_to(1e6, NOT_NEGATIVE),
    "longest_step": up_to(1e6),
    "newton_tolerance": up_to(1e-3),
    "penalty": up_to(1e14),
    "xi": up_to(1e6, NOT_NEGATIVE),
    "omega": up_to(1e9),
    **dict.fromkeys(_COUNTS, Rule(lambda x: 1 <= x <= 1000, "from 1 to 1000")),
}
"""Settings that are numbers; the ranges are those of ``solver.runtime.options``."""

ROWS, MOST_INTERNAL_STEPS = 100, 10
"""Communication steps of a default run, and the most internal steps in one of them."""

_UNITS = {"absolute_tolerance": "m", "longest_step": "s", "omega": "rad/s"}
_DEFAULT = SolverSettings()
_CHOICES = (
    *("formulation", "algorithm", "multiplier_update", "order", "paired"),
    *("assemble", "start"), *_COUNTS,
)  # fmt: skip


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

    def setting(name: str) -> float:
        given, default = getattr(solver, name), getattr(_DEFAULT, name)
        return numbers.constant(
            ("solver", name), given, default, RANGES[name], _UNITS.get(name, "")
        )

    return SolverSettings(
        **{name: getattr(solver, name) for name in _CHOICES},
        step_size=step_size,
        tolerance=setting("tolerance"),
        absolute_tolerance=setting("absolute_tolerance"),
        longest_step=setting("longest_step"),
        newton_tolerance=setting("newton_tolerance"),
        penalty=setting("penalty"),
        xi=setting("xi"),
        omega=setting("omega"),
    )


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
