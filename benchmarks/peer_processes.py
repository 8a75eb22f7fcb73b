"""Other codes, each in a process of its own: which are there, and what they measured.

Their interpreter is that of the variable `EXUDYN_PYTHON`, or else this one; the extra `benchmarks`
has them. What is not installed gives a row that says so.
"""

from __future__ import annotations

import json
import subprocess
from collections.abc import Mapping, Sequence
from dataclasses import asdict, replace

from benchmarks.peer_interpreter import VARIABLE, run_there
from benchmarks.peer_methods import Limits, Row
from benchmarks.problems_parts import Problem

MODULES = {
    "peer_exudyn": ("Exudyn", "exudyn"),
    "peer_mujoco": ("MuJoCo", "mujoco"),
    "peer_sundials": ("SUNDIALS CVODE", "scikit-sundae"),
    "peer_ida": ("SUNDIALS IDAS by CasADi", "casadi"),
    "peer_drake": ("Drake", "drake"),
    "peer_simbody": ("Simbody by OpenSim", "opensim"),
}
"""Module of each code, its name and that of its package."""
LEEWAY = 2.0
"""Of the longest run: other codes come less far in the same time."""
PATIENCE = 120.0
"""Seconds after which a code is stopped at a problem."""
ONE = {name: "1" for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")}

Versions = Mapping[str, str | None]
"""Version of each module's package, None where it is not installed."""

ASK = """
import json, sys
from importlib.metadata import PackageNotFoundError, version
def ask(name):
    try:
        return version(name)
    except PackageNotFoundError:
        return None
print(json.dumps([ask(name) for name in sys.argv[1:]]))
"""


def found() -> Versions:
    """Which codes the interpreter has."""
    packages = [package for _, package in MODULES.values()]
    run = run_there(["-c", ASK, *packages], "", patience=PATIENCE, environment=ONE)
    versions = json.loads(run.stdout) if run.returncode == 0 else [None] * len(packages)
    return dict(zip(MODULES, versions, strict=True))


def remarks(versions: Versions) -> list[str]:
    """A sentence about each code."""
    sentences = []
    for module, (name, package) in MODULES.items():
        version = versions[module]
        text = f"version {version}" if version else f"not measured: `{package}` is not installed"
        sentences.append(f"{name}: {text}")
    if not all(versions.values()):
        sentences.append(f"`{VARIABLE}` may name an interpreter that has the extra `benchmarks`.")
    return sentences


def measured(
    problem: Problem, limits: Limits, expected: Sequence[Sequence[float]], versions: Versions
) -> list[Row]:
    """Rows of all codes on a problem."""
    rows: list[Row] = []
    for module, (name, _) in MODULES.items():
        if versions[module] is None:
            remark = "not measured: not installed"
            rows.append({"solver": name, "setting": "", "remark": remark})
            continue
        request = {
            "module": module,
            "problem": problem.key,
            "expected": expected,
            "limits": asdict(replace(limits, run=LEEWAY * limits.run)),
        }
        try:
            run = run_there(
                ["-m", "benchmarks.peer_run"],
                json.dumps(request),
                patience=PATIENCE,
                environment=ONE,
            )
        except subprocess.TimeoutExpired:
            remark = f"no end within {PATIENCE:g} s"
            rows.append({"solver": name, "setting": "", "remark": remark})
            continue
        if run.returncode:
            reason = run.stderr.strip().rpartition("\n")[2] or f"code {run.returncode}"
            rows.append({"solver": name, "setting": "", "remark": f"failed: {reason[:120]}"})
            continue
        rows += json.loads(run.stdout.strip().rpartition("\n")[2])
    return rows
