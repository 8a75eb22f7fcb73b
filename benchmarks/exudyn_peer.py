"""Exudyn beside our own steps: its times from a process of its own, where there is one.

Its interpreter is that of the variable `EXUDYN_PYTHON`, or else this one; either must have the
package `exudyn` (the extra `peers`).
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from typing import Any

from benchmarks.effort import Effort
from benchmarks.peer_interpreter import VARIABLE, run_there

ABSENT = (
    "Exudyn is not installed here: no times of it (it is the extra `peers`; "
    f"`{VARIABLE}` may name another interpreter that has it)"
)
METHOD = (
    "*Exudyn*, in a process of its own in the same run: generalized alpha (index 3, spectral "
    "radius 0.9, its own tolerances, compiled module without range checks, the faster one of its "
    "dense and sparse solvers) with as many steps of the length of our inner ones, from the start."
)


@dataclass(frozen=True, slots=True)
class Job:
    """`count` steps of a length [s] of a model of `benchmarks.exudyn_models` or `exudyn_planar`."""

    key: str
    model: str
    n: int | None
    step: float
    count: int


def measured(jobs: Sequence[Job], effort: Effort) -> tuple[dict[str, dict[str, Any]], list[str]]:
    """Seconds per step, Newton iterations and noise by key of the job; and remarks."""
    version = _version()
    if version is None:
        return {}, [ABSENT]
    request = {
        "repetitions": effort.repetitions,
        "budget": effort.budget,
        "jobs": [asdict(job) for job in jobs],
    }
    run = run_there(["-m", "benchmarks.exudyn_run"], json.dumps(request))
    if run.returncode:
        reason = run.stderr.strip().rpartition("\n")[2] or f"ended with code {run.returncode}"
        return {}, [f"Exudyn {version}: {reason}"]
    found = json.loads(run.stdout.strip().rpartition("\n")[2])
    failures = [f"Exudyn, {key}: {row['failure']}" for key, row in found.items() if row["failure"]]
    return found, [f"Exudyn {version}", *failures]


def _version() -> str | None:
    code = "from importlib.metadata import version; print(version('exudyn'))"
    run = run_there(["-c", code], "")
    return None if run.returncode else run.stdout.strip()
