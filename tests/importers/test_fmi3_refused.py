"""libcosim knows FMI 1.0 and 2.0: it refuses every FMU of FMI 3.0, and libcosimpy does not look.

It gives the null pointer of the refusal to the next call, which ends Python: so the faults of the
page docs/importers.md are those of the tool, and no FMU of FMI 3.0 could mend them.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.importers.tools import need, run_of
from tests.support.fmus.fmu_instance import packed
from tests.support.fmus.native_fmus import native_scene_fmu

MADE = """
import sys
from libcosimpy.CosimSlave import CosimLocalSlave
from libcosimpy._internal import get_last_error_message
slave = CosimLocalSlave(fmu_path=sys.argv[1], instance_name="a")
print(bool(slave.ptr()), get_last_error_message())
"""
ADDED = """
import sys
from libcosimpy.CosimExecution import CosimExecution
from libcosimpy.CosimSlave import CosimLocalSlave
execution = CosimExecution.from_step_size(10**7)
execution.add_local_slave(CosimLocalSlave(fmu_path=sys.argv[1], instance_name="a"))
print("added")
"""
EMPTY = b'<?xml version="1.0"?><fmiModelDescription fmiVersion="3.0"/>'


@pytest.fixture(params=["ours", "an empty one", "no file"])
def fmu(request, tmp_path) -> Path:
    """FMU of FMI 3.0, or none."""
    if request.param == "ours":
        return native_scene_fmu("double_pendulum", 3)
    path = tmp_path / "a.fmu"
    if request.param == "an empty one":
        path.write_bytes(packed({"modelDescription.xml": EMPTY}))
    return path


def test_there_is_no_slave_and_the_reason_is_told(fmu):
    tool = need("libcosimpy")
    run = run_of(tool, [tool.python, "-c", MADE, str(fmu)])
    assert run.returncode == 0, run.stderr
    assert "False " in run.stdout
    assert ("Unsupported FMI version" if fmu.exists() else "No such file") in run.stdout


def test_to_add_it_all_the_same_ends_python_whatever_the_fmu(fmu):
    tool = need("libcosimpy")
    run = run_of(tool, [tool.python, "-c", ADDED, str(fmu)])
    assert run.returncode < 0
    assert "added" not in run.stdout


def test_an_fmu_of_fmi_2_is_added():
    tool = need("libcosimpy")
    run = run_of(tool, [tool.python, "-c", ADDED, str(native_scene_fmu("double_pendulum"))])
    assert run.returncode == 0
    assert "added" in run.stdout
