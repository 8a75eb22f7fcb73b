"""Energy, constraints and momenta over a million steps and ten: what round-off adds up to."""

from __future__ import annotations

import time
from dataclasses import dataclass
from typing import Any

import numpy as np

from benchmarks.measuring.effort import Effort
from benchmarks.measuring.observe import Observer
from benchmarks.pages.report import Goal, Section, Table, Value
from benchmarks.problems.mechanisms import GRAVITY, free_system, hanging_chain, start
from solver.runtime import Integrator

LOOKS = 10_000
"""Times that energy and constraints are looked at in a run."""
EARLY = 200_000
"""Steps for which the prototype's drift is known: 4e-14 J."""
STROKE = 3.0 * GRAVITY
"""Reference energy of the double pendulum [J]: what it exchanges from the horizontal to the lowest
position."""
ENERGY_GOAL = 1e-12


@dataclass(frozen=True, slots=True)
class Run:
    """Steps of a length [s] with settings of the solver; `solves` implicit solves in each."""

    stepping: str
    settings: dict[str, Any]
    h: float
    count: int
    solves: int


PENDULUM = (
    Run("pairs", {}, 1e-3, 1_000_000, 2),
    Run("pairs", {}, 1e-3, 10_000_000, 2),
    Run("pairs", {}, 5e-2, 1_000_000, 2),
    Run("order 8", {"order": 8}, 2e-2, 1_000_000, 30),
)
FREE = (
    Run("pairs", {}, 0.02, 1_000_000, 2),
    Run("order 8", {"order": 8}, 0.1, 100_000, 30),
)

COMMON = {
    "stepping": "steps",
    "h": ("h, s", "g"),
    "count": ("number", ".0e"),
    "solves": ("implicit solves", ".0e"),
}
COLUMNS = COMMON | {
    "energy": ("largest |ΔE|, J", ".1e"),
    "early": ("the same in the first 2e5 steps, J", ".1e"),
    "relative": ("largest |ΔE|/E", ".1e"),
    "residual": ("largest |Φ|/L²", ".1e"),
    "seconds": ("CPU s", ".2f"),
    "solve": ("µs per implicit solve", ".2f"),
}
FREE_COLUMNS = COMMON | {
    "energy": ("energy", ".1e"),
    "linear": ("linear momentum", ".1e"),
    "angular": ("angular momentum", ".1e"),
    "residual": ("largest |Φ|/L²", ".1e"),
}


def measure(effort: Effort) -> Section:
    rows = [_double_pendulum(run, effort) for run in PENDULUM]
    free = [_free_body(run, effort) for run in FREE]
    return Section(
        name="long-run",
        title="Long runs",
        method=(
            "Energy, momenta and constraints are calculated from positions and velocities, "
            f"{LOOKS:.0e} times in a run, not taken from the solver's own ledger. Settings as by "
            "default; pairs of half steps are two implicit solves, a step of order 8 thirty."
        ),
        tables=[
            Table(title=f"Double pendulum from the horizontal; reference energy {STROKE:.1f} J",
                  columns=COLUMNS, rows=rows),
            Table(title="Free body in space (points, bar, rods, springs); largest relative change",
                  columns=FREE_COLUMNS, rows=free),
        ],
        goals=[goal for row in rows for goal in _goals(row)],
        remarks=[
            "The free body flies away from the origin by 0.06 m/s, to some km: what its positions "
            "lose there of their digits shows in the lengths of its rods as they are calculated "
            "here.",
            "The shorter the step, the less a solve leaves of round-off: at 1 ms the energy walks "
            "at random, at 50 ms it grows by some 1e-15 J a step.",
        ],
    )  # fmt: skip


def _goals(row: dict[str, Value]) -> list[Goal]:
    steps = f"{row['count']:.0e} x {row['h']:g} s, {row['stepping']}"
    relative = Goal(
        what=f"largest energy error over reference energy, double pendulum, {steps}",
        unit="1",
        goal=ENERGY_GOAL,
        value=float(row["relative"]),  # type: ignore[arg-type]
    )
    if row["h"] != 1e-3 or row["count"] > 1e6:
        return [relative]
    early = Goal(
        what=f"largest energy error, double pendulum, first {EARLY:.0e} of them",
        unit="J",
        goal=ENERGY_GOAL,
        value=float(row["early"]),  # type: ignore[arg-type]
    )
    return [relative, early]


def _length(run: Run, effort: Effort) -> tuple[int, int]:
    """Looks at a run, and steps from one to the next."""
    stride = max(1, run.count // LOOKS)
    return effort.count(run.count // stride), stride


def _row(run: Run, steps: int) -> dict[str, Value]:
    return {
        "stepping": run.stepping,
        "h": run.h,
        "count": float(steps),
        "solves": float(steps * run.solves),
    }


def _double_pendulum(run: Run, effort: Effort) -> dict[str, Value]:
    content = hanging_chain(2)
    integrator = start(content, step_size=run.h, **run.settings)
    observer = Observer(content, integrator)
    looks, stride = _length(run, effort)
    initial, seconds, residual, errors = observer.energy(), 0.0, 0.0, []
    for _ in range(looks):
        seconds += _timed_advance(integrator, stride * run.h)
        errors.append(abs(observer.energy() - initial))
        residual = max(residual, observer.residual())
    early = errors[: EARLY // stride]
    return _row(run, looks * stride) | {
        "energy": max(errors),
        "early": max(early),
        "relative": max(errors) / STROKE,
        "residual": residual,
        "seconds": seconds,
        "solve": 1e6 * seconds / (looks * stride * run.solves),
    }


def _timed_advance(integrator: Integrator, step: float) -> float:
    begin = time.process_time()
    integrator.advance(integrator.time, step)
    return time.process_time() - begin


def _free_body(run: Run, effort: Effort) -> dict[str, Value]:
    content = free_system(3)
    integrator = start(content, step_size=run.h, **run.settings)
    observer = Observer(content, integrator)
    looks, stride = _length(run, effort)
    energy, (linear, angular) = observer.energy(), observer.momenta()
    changes, residual = [], 0.0
    for _ in range(looks):
        integrator.advance(integrator.time, stride * run.h)
        p, m = observer.momenta()
        changes.append(
            (
                abs(observer.energy() / energy - 1.0),
                float(np.linalg.norm(p - linear) / np.linalg.norm(linear)),
                float(np.linalg.norm(m - angular) / np.linalg.norm(angular)),
            )
        )
        residual = max(residual, observer.residual())
    worst = np.max(changes, axis=0)
    return _row(run, looks * stride) | {
        "energy": float(worst[0]),
        "linear": float(worst[1]),
        "angular": float(worst[2]),
        "residual": residual,
    }
