"""Exudyn and MuJoCo beside our own stability: each mechanism in a process of its own.

Their interpreter is that of the variable `EXUDYN_PYTHON`, or else this one; a peer that is not
there, or fails, is left out, and a remark says so.
"""

from __future__ import annotations

from collections.abc import Sequence

from benchmarks.peers.peer_interpreter import InterpreterError, answer, packages_there, remarks
from benchmarks.sections.stability_rules import Outcome, Seen
from benchmarks.sections.stability_runs import Ready

PROGRAM = ["-m", "benchmarks.peers.peer_run", "benchmarks.peers.stability_peer"]

LIMIT = 300.0
"""Seconds for all methods of a peer on one mechanism."""
MODELS = ("chain", "four-bar", "bricard", "stiff spring")
PACKAGES = {"Exudyn": "exudyn", "MuJoCo": "mujoco"}
LONGEST = {"Exudyn": 1000, "MuJoCo": 100}
"""Points of the longest chain; MuJoCo takes a second for a step of 1000."""


def present() -> tuple[list[str], list[str]]:
    """Which peers the interpreter has, and a sentence about each."""
    packages = packages_there(list(PACKAGES.values()))
    there = [peer for peer, package in PACKAGES.items() if package in packages.versions]
    return there, remarks(packages, PACKAGES)


def scanned(peer: str, ready: Ready, grid: Sequence[float]) -> tuple[dict[str, Seen], str]:
    """What a peer survived by method, and why there is nothing; neither where it has no model."""
    case = ready.case
    if case.name not in MODELS or (case.name == "chain" and case.size[0] > LONGEST[peer]):
        return {}, ""
    request = {
        "peer": peer,
        "mechanism": case.name,
        "size": list(case.size),
        "grid": list(grid),
        "case": {"stop": ready.stop, "reference": ready.reference, "length": case.length},
    }
    try:
        found = answer(PROGRAM, request, patience=LIMIT)
    except InterpreterError as error:
        return {}, f"{peer}, {case.name}: {error}"
    return {
        method: [(h, Outcome(**outcome)) for h, outcome in seen] for method, seen in found.items()
    }, ""
