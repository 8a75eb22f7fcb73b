"""Microseconds of a step of the chains of points: ours of 1 ms, and the finest of other codes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from benchmarks.measuring.effort import Effort
from benchmarks.measuring.stepping import Repeated
from benchmarks.measuring.timing import interleave
from benchmarks.pages.report import Goal, Table, Value
from benchmarks.problems.mechanisms import start, waving_chain

STEP = 2e-3  # two half steps
COUNT = 300
"""Steps that are timed."""
GOALS = {10: 4.0, 100: 30.0, 1000: 200.0}
"""Points, and goal of a step of ours [microseconds]."""
COLUMNS = {
    "points": ("points", "d"),
    "solver": "solver",
    "length": "step, ms",
    "step": "µs per step",
    "noise": ("noise", ".2f"),
}

Row = Mapping[str, Any]


def steps(curves: Mapping[int, Sequence[Row]], effort: Effort) -> list[dict[str, Value]]:
    """Rows by number of points: our half step, and the finest steps of peers."""
    count = effort.count(COUNT)
    rows: list[dict[str, Value]] = []
    for n, curve in curves.items():
        ours = Repeated(start(waving_chain(n, 3), step_size=STEP), STEP, max(1, count // 2))
        times = interleave({"steps": ours.entry}, effort)["steps"]
        step = 1e6 * times.minimum / ours.solves
        rows.append(_row(n, "holonom, half step", 0.5e3 * STEP, step, times.noise))
        finest = {
            str(row["solver"]): row
            for row in curve
            if str(row["setting"]).endswith("steps") and row.get("ms")
        }
        rows += [
            _row(n, solver, 1e3 / float(row["value"]), 1e3 * row["ms"] / row["value"], row["noise"])
            for solver, row in finest.items()
            if not solver.startswith("holonom")
        ]
    return rows


def _row(points: int, solver: str, length: float, step: float, noise: Value) -> dict[str, Value]:
    return {"points": points, "solver": solver, "length": length, "step": step, "noise": noise}


def table(rows: Sequence[dict[str, Value]]) -> Table:
    """Chains beside each other."""
    return Table(title="Chains of points", columns=COLUMNS, rows=rows)


def goals(rows: Sequence[dict[str, Value]]) -> list[Goal]:
    """Our half step, whose energy is as exact as that of a pair."""
    return [
        Goal.of_row(
            f"step of 1 ms, chain of {row['points']} points in space, energy exact",
            GOALS[int(row["points"])],  # type: ignore[arg-type]
            row,
            "step",
        )
        for row in rows
        if str(row["solver"]).startswith("holonom, half step")
    ]
