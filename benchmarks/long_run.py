"""Energy and constraints over a million steps, and the momenta of a system without supports."""

from __future__ import annotations

import time

import numpy as np

from benchmarks.effort import Effort
from benchmarks.mechanisms import free_body, hanging_chain, start
from benchmarks.observe import Observer
from benchmarks.report import Goal, Section, Table, Value
from solver.runtime import Integrator

STEPS = 1_000_000
STEP = 1e-3
SAMPLE = 100
"""Internal steps between two looks at energy and constraints."""

FREE_STEPS = 100_000
FREE_STEP = 0.02
FREE_SAMPLE = 20

ENERGY_GOAL = 1e-12
"""Joule, for the first 2e5 steps; over a million steps it is shown beside what was found."""

COLUMNS = {
    "stepping": "steps",
    "count": "number",
    "energy": "largest |ΔE|, J",
    "early": "the same in the first fifth, J",
    "residual": "largest |Φ|/L²",
    "seconds": "CPU s",
    "solve": "µs per inner step",
}
FREE_COLUMNS = {
    "stepping": "steps",
    "count": "number",
    "energy": "energy",
    "linear": "linear momentum",
    "angular": "angular momentum",
    "residual": "largest |Φ|/L²",
}


def measure(effort: Effort) -> Section:
    rows = [_double_pendulum(paired, effort) for paired in (True, False)]
    free = [_free_body(paired, effort) for paired in (True, False)]
    return Section(
        name="long-run",
        title="Long runs",
        method=(
            f"Energy, momenta and constraints are calculated from positions and velocities, every "
            f"{SAMPLE} steps ({FREE_SAMPLE} for the free body), not taken from the solver's own "
            "ledger. Settings as by default."
        ),
        tables=[
            Table(title="Double pendulum from the horizontal, 1 ms", columns=COLUMNS, rows=rows,
                  formats=_FORMATS),
            Table(title=f"Free body in space (points, bar, rods, springs), {FREE_STEP} s; largest "
                  "relative change", columns=FREE_COLUMNS, rows=free, formats=_FORMATS),
        ],
        goals=[
            Goal(
                what="largest energy error, double pendulum, "
                f"{row['early_count']:.0f} {row['stepping']}",
                unit="J",
                goal=ENERGY_GOAL,
                value=float(row["early"]),  # type: ignore[arg-type]
            )
            for row in rows
        ],
    )  # fmt: skip


_FORMATS = {
    "count": ".0f", "energy": ".1e", "early": ".1e", "residual": ".1e", "linear": ".1e",
    "angular": ".1e", "seconds": ".2f", "solve": ".2f",
}  # fmt: skip


def _double_pendulum(paired: bool, effort: Effort) -> dict[str, Value]:
    content = hanging_chain(2)
    integrator = start(content, step_size=STEP, paired=paired)
    observer = Observer(content, integrator)
    samples = effort.count(STEPS // SAMPLE)
    initial, seconds, residual = observer.energy(), 0.0, 0.0
    errors = []
    for _ in range(samples):
        seconds += _timed_advance(integrator, SAMPLE * STEP)
        errors.append(abs(observer.energy() - initial))
        residual = max(residual, observer.residual())
    early = max(1, samples // 5)
    solves = samples * SAMPLE * (2 if paired else 1)
    return {
        "stepping": "pairs" if paired else "plain steps",
        "count": float(samples * SAMPLE),
        "early_count": float(early * SAMPLE),
        "energy": max(errors),
        "early": max(errors[:early]),
        "residual": residual,
        "seconds": seconds,
        "solve": 1e6 * seconds / solves,
    }


def _timed_advance(integrator: Integrator, step: float) -> float:
    begin = time.process_time()
    integrator.advance(integrator.time, step)
    return time.process_time() - begin


def _free_body(paired: bool, effort: Effort) -> dict[str, Value]:
    content = free_body()
    integrator = start(content, step_size=FREE_STEP, paired=paired)
    observer = Observer(content, integrator)
    samples = effort.count(FREE_STEPS // FREE_SAMPLE)
    energy, (linear, angular) = observer.energy(), observer.momenta()
    changes, residual = [], 0.0
    for _ in range(samples):
        integrator.advance(integrator.time, FREE_SAMPLE * FREE_STEP)
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
    return {
        "stepping": "pairs" if paired else "plain steps",
        "count": float(samples * FREE_SAMPLE),
        "energy": float(worst[0]),
        "linear": float(worst[1]),
        "angular": float(worst[2]),
        "residual": residual,
    }
