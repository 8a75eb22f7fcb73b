"""Exudyn beside our own steps: its times from a process of its own, where there is one.

Its interpreter is that of the variable `EXUDYN_PYTHON`, or else this one; either must have the
package `exudyn` (the extra `peers`).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from typing import Any

from benchmarks.measuring.effort import Effort
from benchmarks.pages.report import Value
from benchmarks.peers.peer_interpreter import InterpreterError, answer, packages_there, remarks

PACKAGE = "exudyn"
METHOD = (
    "*Exudyn*, in a process of its own in the same run: generalized alpha (index 3, spectral "
    "radius 0.9, its own tolerances, compiled module without range checks, the faster one of its "
    "dense and sparse solvers) with as many steps of the length of our inner ones, from the start."
)


@dataclass(frozen=True, slots=True)
class Job:
    """`count` steps of a length [s] of a function of the catalogue with its arguments."""

    key: str
    model: str
    arguments: tuple[float, ...]
    step: float
    count: int


def measured(jobs: Sequence[Job], effort: Effort) -> tuple[dict[str, dict[str, Any]], list[str]]:
    """Seconds per step, Newton iterations and noise by key of the job; and remarks."""
    packages = packages_there([PACKAGE])
    told = remarks(packages, {"Exudyn": PACKAGE})
    if packages.absence(PACKAGE):
        return {}, told
    request = {
        "repetitions": effort.repetitions,
        "budget": effort.budget,
        "jobs": [asdict(job) for job in jobs],
    }
    try:
        found = answer(["-m", "benchmarks.peers.peer_run", "benchmarks.peers.exudyn_run"], request)
    except InterpreterError as error:
        return {}, [*told, f"Exudyn: {error}"]
    failures = [f"Exudyn, {key}: {row['failure']}" for key, row in found.items() if row["failure"]]
    return found, [*told, *failures]


def beside(row: dict[str, Value], theirs: Mapping[str, Any]) -> dict[str, Value]:
    """Put Exudyn's time and iterations of a step into a row with our own time `solve` [µs]."""
    if "solve" not in row:
        return row
    exudyn = 1e6 * theirs["step"] if theirs.get("step") else None
    ratio = exudyn / float(row["solve"]) if exudyn else None
    return row | {"exudyn": exudyn, "ratio": ratio, "their_newton": theirs.get("newton")}
