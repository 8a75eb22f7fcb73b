"""Times of Exudyn's steps of the problems that a request names (`benchmarks.peers.peer_run`)."""

from __future__ import annotations

from typing import Any

from benchmarks.measuring.effort import repeated
from benchmarks.measuring.timing import Entry, interleave
from benchmarks.peers.exudyn_problem import Build
from benchmarks.problems import catalogue as problems


def run(request: dict[str, Any]) -> dict[str, dict[str, Any]]:
    """Time all jobs in turn: seconds, noise and Newton iterations per step, or a failure, by key.

    The request has `repetitions`, `budget` [s] and `jobs`, each with `key`, `model` (a function of
    `benchmarks.problems.catalogue`), its `arguments`, `step` [s] and `count`.
    """
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
