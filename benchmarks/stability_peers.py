"""Exudyn and MuJoCo beside our own stability: each mechanism in a process of its own.

Their interpreter is that of the variable `EXUDYN_PYTHON`, or else this one; a peer that is not
there is left out, and a remark says so.
"""

from __future__ import annotations

import json
import subprocess
from collections.abc import Sequence

from benchmarks.peer_interpreter import run_there
from benchmarks.stability_rules import Outcome, Seen
from benchmarks.stability_runs import Ready

LIMIT = 300.0
"""Seconds for all methods of a peer on one mechanism."""
MODELS = ("chain", "four-bar", "bricard", "stiff spring")
LONGEST = {"Exudyn": 1000, "MuJoCo": 100}
"""Points of the longest chain; MuJoCo takes a second for a step of 1000."""


def present() -> dict[str, str]:
    """Versions of the peers that are installed."""
    found = {}
    for name in ("Exudyn", "MuJoCo"):
        code = f"from importlib.metadata import version; print(version('{name.lower()}'))"
        run = run_there(["-c", code], "", patience=LIMIT)
        if not run.returncode:
            found[name] = run.stdout.strip()
    return found


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
        run = run_there(["-m", "benchmarks.stability_peer"], json.dumps(request), patience=LIMIT)
    except subprocess.TimeoutExpired:
        return {}, f"{peer}, {case.name}: not done after {LIMIT:g} s"
    if run.returncode:
        reason = run.stderr.strip().rpartition("\n")[2] or f"ended with code {run.returncode}"
        return {}, f"{peer}, {case.name}: {reason}"
    found = json.loads(run.stdout.strip().rpartition("\n")[2])
    return {
        method: [(h, Outcome(**outcome)) for h, outcome in seen] for method, seen in found.items()
    }, ""
