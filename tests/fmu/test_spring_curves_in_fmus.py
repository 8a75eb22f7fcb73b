"""Springs by a curve and springs of joints in FMUs of every kind, with parameters that change."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import holonom
from build_fmu import build
from build_fmu.run import run_fmu
from tests.fmu.test_kinds import KINDS

SCENE = """
name = "sprung"
dimension = 2
gravity = [0, -9.81]
[parameters]
hard = { value = 300, variability = "tunable" }
free = 0.9
[profiles]
pad = { x = [-0.4, -0.1, 0, 0.1, 0.4], y = [-120, -10, 0, 10, 120], interpolation = "monotone" }
[bodies]
arm = { mass = 1, inertia = 0.1, position = [0.5, 0], points = { tip = [0.5, 0] } }
[joints]
hinge = { type = "revolute", bodies = ["ground", "arm"], position = [0, 0], stiffness = "hard/30", damping = 0.01 }
[forces]
mount = { type = "spring", points = ["ground", "arm.tip"], at = [1, 1], force = "pad(elongation) + min(hard*elongation, 20)", free_length = "free" }
gas = { type = "spring", points = ["ground", "arm.tip"], at = [1, -1], force = "elongation*hard/(2 + elongation)" }
click = { type = "torsion_spring", joint = "hinge", torque = "0.1*sin(8*angle)" }
[solver]
step_size = 0.005
[experiment]
stop_time = 0.5
"""  # noqa: E501
NAMES = ("hinge.angle", "hinge.spring", "hinge.damper", "mount.force", "gas.force", "click.torque")


@pytest.fixture(scope="module")
def scene(tmp_path_factory) -> Path:
    path = tmp_path_factory.mktemp("sprung") / "sprung.toml"
    path.write_text(SCENE)
    return path


@pytest.mark.parametrize("kind", KINDS)
def test_an_fmu_has_the_forces_of_its_curves(kind, scene, tmp_path):
    fmu = build(scene, tmp_path / "sprung.fmu", **KINDS[kind])
    own = holonom.simulate(str(scene), stop_time=0.5)
    values = run_fmu(fmu, stop_time=0.5).values
    for name in NAMES:
        assert np.array(values[name]) == pytest.approx(own[name], abs=1e-12), name
    angle = np.array(values["hinge.angle"])
    tip = np.array([np.cos(angle), np.sin(angle)])
    stretch = np.hypot(1 - tip[0], -1 - tip[1]) - 1
    assert values["gas.force"] == pytest.approx(300 * stretch / (2 + stretch), abs=1e-10)
    assert values["click.torque"] == pytest.approx(0.1 * np.sin(8 * angle), abs=1e-12)
    assert values["hinge.spring"] == pytest.approx(10 * angle, abs=1e-12)
    assert max(values["energy.error"]) < 1e-12


@pytest.mark.parametrize("kind", KINDS)
def test_parameters_of_a_curve_may_be_set_in_an_fmu(kind, scene, tmp_path):
    fmu = build(scene, tmp_path / "sprung.fmu", **KINDS[kind])
    given = {"hard": 150.0, "free": 0.95}
    own = holonom.simulate(str(scene), stop_time=0.5, parameters=given)
    values = run_fmu(fmu, stop_time=0.5, settings=given).values
    assert own["hinge.angle"][-1] != holonom.simulate(str(scene), stop_time=0.5)["hinge.angle"][-1]
    for name in NAMES:
        assert np.array(values[name]) == pytest.approx(own[name], abs=1e-12), name
