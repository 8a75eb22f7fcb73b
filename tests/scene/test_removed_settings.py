"""Settings of before are refused with a sentence that says where they went."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

import solver
from build_fmu.errors import UsageError
from build_fmu.run import run_fmu
from build_fmu.study.ssv import VALUES
from solver.options import OPTIONS, REMOVED
from solver.scene import SceneError
from solver.trajectory import PAPER
from tests.support.fmus.commands import run
from tests.support.fmus.fmu_instance import scene_fmu

SCENE = Path(__file__).resolve().parents[2] / "scenes" / "double_pendulum.toml"
LEFT = "the setting '{}' left in version 2.0: "


@pytest.mark.parametrize("name", REMOVED)
def test_a_setting_of_before_says_where_it_went(name):
    told = re.escape(LEFT.format(name) + REMOVED[name])
    text = SCENE.read_text().replace("[solver]", f'[solver]\n{name} = "exact"')
    with pytest.raises(SceneError, match=told):
        solver.loads(text)
    with pytest.raises(SceneError, match=told):
        solver.load(SCENE, {f"solver.{name}": "exact"})
    of_paper = rf"{name}: must be" if name in PAPER else told
    with pytest.raises(solver.OptionError, match=of_paper):
        solver.simulate(SCENE, **{name: "exact"})
    with pytest.raises(solver.OptionError, match=told):
        solver.simulate(SCENE, parameters={f"solver.{name}": "exact"})
    with pytest.raises(UsageError, match=told):
        run_fmu(scene_fmu("double_pendulum"), settings={f"solver.{name}": "exact"})


@pytest.mark.parametrize("kind", ["scene", "fmu"])
def test_a_parameter_file_with_a_setting_of_before_is_told_where_it_went(capsys, tmp_path, kind):
    parameters = tmp_path / "set.ssv"
    parameters.write_text(
        f'<ssv:ParameterSet xmlns:ssv="{VALUES}" version="1.0" name="set"><ssv:Parameters>'
        '<ssv:Parameter name="solver.formulation"><ssv:String value="midpoint-al"/></ssv:Parameter>'
        "</ssv:Parameters></ssv:ParameterSet>"
    )
    model = SCENE if kind == "scene" else scene_fmu("double_pendulum")
    code, _, told = run(capsys, "simulate", model, "--parameters", parameters)
    assert code == 2
    assert LEFT.format("formulation") + REMOVED["formulation"] in told


def test_a_low_penalty_of_an_fmu_is_told_where_it_went(capsys):
    given = "solver.penalty=100"
    code, _, told = run(capsys, "simulate", scene_fmu("double_pendulum"), "--set", given)
    assert code == 2
    assert "solver.penalty: must be >= 1e+06, got 100" in told
    assert "holonom.simulate(scene, formulation=..., penalty=...)" in told


def test_no_setting_is_both_there_and_gone():
    assert not OPTIONS.keys() & REMOVED.keys()
