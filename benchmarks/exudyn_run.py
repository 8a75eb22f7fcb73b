"""`python -m benchmarks.exudyn_run`: time Exudyn's steps of the problems that its input names.

Input: JSON of `repetitions`, `budget` [s] and `jobs`, each with `key`, `model` (a function of
`benchmarks.problems`), its `arguments`, `step` [s] and `count`. The last line of what it prints is
JSON: for each key seconds per step, noise and Newton iterations per step, or a failure. Needs
Exudyn and NumPy alone of all packages.
"""

from __future__ import annotations

import json
import sys
from typing import Any

from benchmarks import problems
from benchmarks.effort import repeated
from benchmarks.exudyn_problem import Build
from benchmarks.timing import Entry, interleave


def run(request: dict[str, Any]) -> dict[str, dict[str, Any]]:
    """Time all jobs in turn."""
    effort = repeated(request["repetitions"], request["budget"])
    builds, found = {}, {}
    for job in request["jobs"]:
        build = Build(getattr(problems, job["model"])(*job["arguments"]))
        try:
            _steps(build, job)
        except ArithmeticError as error:
            found[job["key"]] = {"failure": str(error)}
        else:
            builds[job["key"]] = (build, job)
    entries = {key: Entry(lambda pair=pair: _steps(*pair)) for key, pair in builds.items()}
    for key, times in interleave(entries, effort).items():
        build, job = builds[key]
        newton, step = build.newton / job["count"], times.minimum / job["count"]
        found[key] = {"step": step, "noise": times.noise, "newton": newton, "failure": ""}
    return found


def _steps(build: Build, job: dict[str, Any]) -> None:
    """All steps from the start."""
    build.solve(job["count"], job["count"] * job["step"])


if __name__ == "__main__":
    results = run(json.load(sys.stdin))
    print()
    print(json.dumps(results))
