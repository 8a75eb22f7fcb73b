"""The importers, where they are, and what to know of each; docs/importers.md is written from it."""

from __future__ import annotations

import functools
import importlib.util
import json
import os
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
DRIVERS = Path(__file__).with_name("drivers")
LONGEST = 300.0
"""Seconds that a program of a tool may run: many times what the slowest takes."""
REQUIRED = os.environ.get("IMPORTERS", "").split()
"""Tools that have to be there; `make importers` names them."""


@dataclass(frozen=True)
class Tool:
    """An importer."""

    name: str
    """of its package"""
    module: str
    ran: str
    remark: str
    fmus: str = "Python, native 2"
    """kinds of our FMUs that it runs: with Python, or native ones of FMI 2 and 3"""
    interpreter: str = "IMPORTERS_PYTHON"
    """environment variable that names the Python which has it, this one if it is not set"""
    program: str = ""
    """environment variable that names a program built from sources, by docs/importers.md"""
    revision: str = ""
    """of these sources"""

    @property
    def python(self) -> str:
        """Python that runs this tool."""
        return os.environ.get(self.interpreter, sys.executable)


ALL_KINDS = "Python, native 2, native 3"
TOOLS = (
    Tool(
        "fmpy",
        "fmpy",
        "`fmpy validate` and `fmpy simulate` of every scene; all tests of FMUs use its `FMU2Slave`",
        "`simulate_fmu` ends a run at a discarded step without a message; see `solver.status`",
        ALL_KINDS,
    ),
    Tool(
        "libcosimpy",
        "libcosimpy",
        "coupled, fixed step; two FMUs alone, beside fmpy",
        "the parallel scheme; it rounds t to nanoseconds; knows no FMI 3.0 and ends Python at one, "
        "see below",
    ),
    Tool(
        "ecospy",
        "ecospy",
        "coupled, fixed step",
        "the parallel scheme; needs libtbb12 of the system; it sums t, so `step_until(1.0)` stops "
        "at 0.99 with steps of 0.01: count steps",
    ),
    Tool(
        "pathsim-fmi",
        "pathsim_fmi",
        "coupled, scheduled events",
        "the sequential scheme, in the order of the list of blocks; at t its blocks show t + H",
    ),
    Tool(
        "fmu-manipulation-toolbox",
        "fmu_manipulation_toolbox",
        "`fmutool -check` of every scene; `fmucontainer` of the three coupled FMUs, run in fmpy",
        "the parallel scheme, or the sequential one with `sequential`, both bit for bit; its log "
        "always says `[ERROR] Solver configure....`",
    ),
    Tool(
        "cofmupy",
        "cofmupy",
        "coupled, `jacobi` and `gauss_seidel`",
        "the parallel scheme, and a sequential one; it sets inputs to 0 unless its configuration "
        "has `initialization`, and ignores their start values; its 86 packages need an older fmpy, "
        "and so an environment of its own",
        interpreter="COFMUPY_PYTHON",
    ),
    Tool(
        "FMUComplianceChecker",
        "",
        "`fmuCheck` of every scene: description, 20 steps, outputs beside fmpy's",
        "no warning and no error; it knows no FMI 3, and is not developed further",
        program="FMUCHECK",
        revision="c704b98",
    ),
    Tool(
        "fmi4c",
        "",
        "`fmi4ctest` of every scene: 20 steps, outputs of FMI 3 beside fmpy's",
        "it writes no outputs of FMI 2; in FMI 3 it always gives 10 s as the stop time, "
        "and later steps are errors",
        ALL_KINDS,
        program="FMI4C",
        revision="cab0bb1",
    ),
    Tool(
        "OMSimulator",
        "",
        "every scene alone: 20 steps, outputs beside fmpy's",
        "it takes value references in `dependencies` of FMI 3 for places in the list of variables, "
        "which ours therefore are",
        ALL_KINDS,
        program="OMSIMULATOR",
        revision="v3.0.0-114-gacb56d9d",
    ),
)
BY_NAME = {tool.name: tool for tool in TOOLS}


def need(name: str) -> Tool:
    """Return an importer; without it skip the test, or fail if it has to be there."""
    tool = BY_NAME[name]
    reason = missing(tool)
    if reason and name in REQUIRED:
        pytest.fail(f"{name}: {reason}")
    if reason:
        pytest.skip(f"{name}: {reason}")
    return tool


@functools.cache
def missing(tool: Tool) -> str:
    """Why a tool cannot be used, empty if it can."""
    if tool.program:
        named = os.environ.get(tool.program, "")
        found = os.access(named, os.X_OK)
        return "" if found else f"${tool.program} names no program (recipe: docs/importers.md)"
    if tool.python == sys.executable and importlib.util.find_spec(tool.module) is None:
        target = "make cofmupy" if tool.name == "cofmupy" else "make importers"
        return f"not installed ({target})"
    run = run_of(tool, [tool.python, "-c", f"import {tool.module}"])
    if "libtbb" in run.stderr:
        return "needs libtbb.so.12 of the system (Debian: apt-get install libtbb12)"
    return run.stderr.strip().rpartition("\n")[2] if run.returncode else ""


def version(tool: Tool) -> str:
    """Version that is installed, or that of the recipe."""
    if tool.program:
        return tool.revision
    code = f"import importlib.metadata as m; print(m.version({tool.name!r}))"
    run = run_of(tool, [tool.python, "-c", code])
    run.check_returncode()
    return run.stdout.strip()


def run_of(
    tool: Tool, program: list[str], given: str = "", **environment: str
) -> subprocess.CompletedProcess[str]:
    """Run a program of a tool; one that hangs fails the test, and is ended."""
    try:
        return subprocess.run(
            program,
            input=given,
            capture_output=True,
            text=True,
            check=False,
            timeout=LONGEST,
            env={**os.environ, **environment},
        )
    except subprocess.TimeoutExpired:
        pytest.fail(f"{tool.name}: ended, as it still ran after {LONGEST:g} s: {program}")


def command(tool: Tool, name: str, *arguments: str) -> subprocess.CompletedProcess[str]:
    """Run a program that a tool has brought, from the folder of its Python."""
    return run_of(tool, [str(Path(tool.python).with_name(name)), *arguments])


def drive(tool: Tool, job: dict) -> list[list[float]]:
    """Run the tool's driver in a process of its own; what was watched, after each step.

    A job has `fmus` (file of each unit), `links` (unit, output, unit, input), `references` (of
    each unit's variables), `start` (values of its inputs), `h`, `steps`, `watch` (unit, output)
    and `scheme`.
    """
    driver = DRIVERS / f"{tool.module}_driver.py"
    run = run_of(tool, [tool.python, str(driver)], json.dumps(job))
    assert run.returncode == 0, run.stderr[-3000:]
    return json.loads(run.stdout.rpartition("ROWS")[2])
