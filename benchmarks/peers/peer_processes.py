"""Other codes, each in a process of its own: which are there, and what they measured.

Their interpreter is that of the variable `EXUDYN_PYTHON`, or else this one; the extra `benchmarks`
has them. What is not installed, or fails, gives a row that says so.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, replace

from benchmarks.peers import peer_interpreter
from benchmarks.peers.peer_interpreter import InterpreterError, Packages, answer, packages_there
from benchmarks.peers.peer_methods import Limits, Row
from benchmarks.problems.parts import Problem

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


def found() -> Packages:
    """Which codes the interpreter has."""
    return packages_there([package for _, package in MODULES.values()])


def remarks(packages: Packages) -> list[str]:
    """A sentence about each code."""
    return peer_interpreter.remarks(packages, dict(MODULES.values()))


def measured(
    problem: Problem, limits: Limits, expected: Sequence[Sequence[float]], packages: Packages
) -> list[Row]:
    """Rows of all codes on a problem."""
    rows: list[Row] = []
    for module, (name, package) in MODULES.items():
        absence = packages.absence(package)
        if absence:
            rows.append(_empty(name, f"not measured: {absence}"))
            continue
        request = {
            "module": module,
            "problem": problem.key,
            "expected": expected,
            "limits": asdict(replace(limits, run=LEEWAY * limits.run)),
        }
        program = ["-m", "benchmarks.peers.peer_run", "benchmarks.peers.peer_methods"]
        try:
            rows += answer(program, request, patience=PATIENCE, environment=ONE)
        except InterpreterError as error:
            rows.append(_empty(name, f"failed: {error}"))
    return rows


def _empty(solver: str, remark: str) -> Row:
    return {"solver": solver, "setting": "", "remark": remark}
