"""`python -m benchmarks.exudyn_run`: time Exudyn's steps of the models that its input names.

Input: JSON of `repetitions`, `budget` [s] and `jobs`, each with `key`, `model`, `n` (size, or
null), `step` [s] and `count`. The last line of what it prints is JSON: for each key seconds per
step, noise and Newton iterations per step, or a failure. Needs Exudyn and NumPy alone of all
packages.
"""

from __future__ import annotations

import json
import sys
from typing import Any

import exudyn as exu

from benchmarks import exudyn_models, exudyn_planar
from benchmarks.effort import Effort
from benchmarks.exudyn_system import Drawing, solve
from benchmarks.timing import Entry, interleave

NEWTON = 1e-8
"""Exudyn's own choice of the relative tolerance."""


def run(request: dict[str, Any]) -> dict[str, dict[str, Any]]:
    """Time all jobs in turn."""
    effort = Effort(
        name="child",
        scale=1.0,
        repetitions=request["repetitions"],
        budget=request["budget"],
        largest=1,
        steps=0,
    )
    drawings, found = {}, {}
    for job in request["jobs"]:
        drawing = _drawn(job)
        try:
            _steps(drawing, job)
        except (ArithmeticError, exu.SolverError) as error:
            found[job["key"]] = {"failure": str(error).partition("\n")[0]}
        else:
            drawings[job["key"]] = (drawing, job)
    entries = {key: Entry(lambda pair=pair: _steps(*pair)) for key, pair in drawings.items()}
    for key, times in interleave(entries, effort).items():
        drawing, job = drawings[key]
        newton = drawing.system.sys["dynamicSolver"].it.newtonStepsCount / job["count"]
        step = times.minimum / job["count"]
        found[key] = {"step": step, "noise": times.noise, "newton": newton, "failure": ""}
    return found


def _drawn(job: dict[str, Any]) -> Drawing:
    name, n = job["model"], job["n"]
    build = getattr(exudyn_planar, name, None) or getattr(exudyn_models, name)
    drawing = build() if n is None else build(n)
    drawing.system.Assemble()
    return drawing


def _steps(drawing: Drawing, job: dict[str, Any]) -> None:
    """All steps from the start."""
    stop = job["count"] * job["step"]
    solve(drawing, job["step"], stop, stop, NEWTON)


if __name__ == "__main__":
    results = run(json.load(sys.stdin))
    print()
    print(json.dumps(results))
