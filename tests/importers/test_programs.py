"""Importers built from their sources run every scene as fmpy does; variables name them."""

from __future__ import annotations

import csv
import functools
import os
import re
import sys
import tempfile
from pathlib import Path

import fmpy
import pytest

from tests.importers.tools import TOOLS, Tool, missing, need, run_of
from tests.support.fmus.fmu_instance import Instance, scene_fmu
from tests.support.fmus.native_fmus import native_scene_fmu
from tests.support.mechanisms.scene_files import ALL

PROGRAMS = [tool for tool in TOOLS if tool.program]
if not any(os.environ.get(tool.program) for tool in PROGRAMS):
    pytest.skip("; ".join(map(missing, PROGRAMS)), allow_module_level=True)
STEPS = 20
REACTION = re.compile(r"\.(force|torque|moment)\b")
SCENES = [path.stem for path in ALL]
RUNS = [(tool.name, kind) for tool in PROGRAMS for kind in tool.fmus.split(", ")]


def arguments(tool: Tool, path: Path, result: Path, h: float) -> list[str]:
    """Command line of a run over a number of steps."""
    stop = STEPS * h
    if tool.name == "FMUComplianceChecker":
        options = ["-l", "3", "-n", "0", "-h", repr(h), "-s", repr(stop), "-o", str(result)]
    elif tool.name == "fmi4c":
        # Its last step begins, not ends, at the stop time.
        options = ["-l", "3", "-h", repr(h), "-s", repr(stop - 0.5 * h), "-o", str(result)]
    else:
        folder = f"--tempDir={result.parent}"
        options = [f"--resultFile={result}", f"--stopTime={stop!r}", f"--stepSize={h!r}", folder]
    return [os.environ[tool.program], *options, str(path)]


def last_row(result: Path) -> dict[str, float]:
    """What a program wrote at the end, by name."""
    with result.open(encoding="utf-8", newline="") as lines:
        return {name.strip(): float(x) for name, x in list(csv.DictReader(lines))[-1].items()}


@functools.cache
def expected(scene: str, h: float) -> dict[str, float]:
    """Outputs after the same steps in fmpy; counts of the solver may differ by round-off of t."""
    with tempfile.TemporaryDirectory() as folder:
        instance = Instance(native_scene_fmu(scene), folder)
        instance.initialise()
        row = instance.run(0.0, h, STEPS)[-1]
        instance.fmu.terminate()
        instance.fmu.freeInstance()
    outputs = [v.name for v in instance.description.modelVariables if v.causality == "output"]
    return {name: x for name, x in zip(outputs, row, strict=True) if "solver." not in name}


@pytest.mark.parametrize("scene", SCENES)
@pytest.mark.parametrize(("name", "kind"), RUNS)
def test_a_program_runs_a_scene_as_fmpy_does(name, kind, scene, tmp_path):
    tool = need(name)
    python = kind == "Python"
    path = scene_fmu(scene) if python else native_scene_fmu(scene, int(kind[-1]))
    description = fmpy.read_model_description(str(path))
    h = description.defaultExperiment.stepSize
    result = tmp_path / "result.csv"
    library = "libpython{}.{}.so.1.0".format(*sys.version_info) if python else ""
    # OMSimulator writes its settings at home; two at once would read half a file.
    program = arguments(tool, path, result, float(h))
    run = run_of(tool, program, LD_PRELOAD=library, HOME=str(tmp_path))
    told = run.stdout + run.stderr
    assert run.returncode == 0, told
    assert "error:" not in told
    assert "warning:" not in told
    if name == "FMUComplianceChecker":
        assert "0 Warning(s)" in told
        assert "0 Error(s)" in told
    if name == "fmi4c":
        assert "successfully terminated" in told
        if kind != "native 3":
            return
    found = last_row(result)
    # fmi4ctest writes 1024 outputs at most, with six decimals.
    wanted = {name: x for name, x in expected(scene, float(h)).items() if name in found}
    if scene == "cardan_shaft":  # these programs sum t, and round-off of it moves its reactions
        wanted = {name: x for name, x in wanted.items() if not REACTION.search(name)}
    assert len(wanted) >= 10
    assert {name: found[name] for name in wanted} == pytest.approx(wanted, rel=1e-5, abs=2e-6)
