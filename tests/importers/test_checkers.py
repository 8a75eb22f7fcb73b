"""Programs that read an FMU and judge or run it find nothing to complain of in any scene."""

from __future__ import annotations

import pytest

from tests.importers.tools import REQUIRED, command, need
from tests.support.fmus.fmu_instance import scene_fmu
from tests.support.fmus.native_fmus import native_scene_fmu
from tests.support.mechanisms.scene_files import ALL

if not REQUIRED:
    pytest.skip("takes minutes: make importers runs it", allow_module_level=True)
NAMES = [path.stem for path in ALL]
KINDS = pytest.mark.parametrize("fmi", [0, 2, 3], ids=["python", "native 2", "native 3"])


def fmu(scene: str, fmi: int) -> str:
    """Path of a scene's FMU: with Python (0), or native."""
    return str(native_scene_fmu(scene, fmi) if fmi else scene_fmu(scene))


@KINDS
@pytest.mark.parametrize("scene", NAMES)
def test_fmpy_validates_a_scene(scene, fmi):
    run = command(need("fmpy"), "fmpy", "validate", fmu(scene, fmi))
    assert run.returncode == 0, run.stdout
    assert "No problems found" in run.stdout


@KINDS
@pytest.mark.parametrize("scene", NAMES)
def test_fmpy_simulates_a_scene(scene, fmi, tmp_path):
    result = tmp_path / "result.csv"
    arguments = ["--stop-time", "0.1", "--output-file", str(result)]
    run = command(need("fmpy"), "fmpy", *arguments, "simulate", fmu(scene, fmi))
    # Its work done, Python may abort in an exit handler of pythonfmu's library (docs/fmu.md, 5).
    assert run.returncode in (0, -6), run.stderr
    rows = result.read_text(encoding="utf-8").splitlines()
    assert float(rows[-1].partition(",")[0]) == pytest.approx(0.1)


@pytest.mark.parametrize("fmi", [0, 2], ids=["python", "native 2"])
@pytest.mark.parametrize("scene", NAMES)
def test_fmutool_finds_no_error_in_a_scene(scene, fmi):
    tool = need("fmu-manipulation-toolbox")
    run = command(tool, "fmutool", "-input", fmu(scene, fmi), "-check")
    output = run.stdout + run.stderr
    assert run.returncode == 0, output
    assert "compliant with FMI-2.0" in output
    assert "No semantic error" in output
    assert "ERROR" not in output
