"""Drivers that jump: velocities do not follow them, which is said at build and found by a check."""

from __future__ import annotations

import zipfile

import pytest

import solver
from build_fmu import build
from build_fmu.motion import RESIDUAL
from build_fmu.self_check import self_check
from tests.commands import run

ARM = """
name = "arm"
dimension = 2
gravity = [0, -9.81]
[bodies]
arm = {{ position = [0, 0], mass = 60.0, inertia = 5.0, center_of_mass = [0.5, 0] }}
[joints]
slew = {{ type = "revolute", bodies = ["ground", "arm"], position = [0, 0] }}
[drivers]
motor = {{ type = "angle", joint = "slew", value = "{angle}" }}
[experiment]
stop_time = 2.0
step_size = 0.05
"""
SMOOTH = ("0.3*(1 - cos(3*t))", "0.5*t", "0.2*t**3", "0")
JUMPS = {"value": "0.5 if t > 1 else 0", "rate": "2*max(t - 1.03, 0)"}


def lag(model: solver.Model) -> list[str]:
    """What the trial run of a build says of velocities that lag."""
    return [text for text in self_check(model).remarks if RESIDUAL in text]


@pytest.mark.parametrize("angle", JUMPS.values(), ids=JUMPS)
def test_a_driver_whose_value_or_rate_jumps_is_told_and_fails_a_check(angle, tmp_path, capsys):
    scene = tmp_path / "arm.toml"
    scene.write_text(f"{ARM.format(angle=angle)}[solver]\nstep_size = 0.01\n")
    (said,) = lag(solver.assemble(solver.load(scene)))
    assert "look for a driver or a constraint whose value or rate jumps" in said
    fmu = build(scene, tmp_path / "arm.fmu")
    with zipfile.ZipFile(fmu) as archive:
        assert b"velocities do not follow" in archive.read("documentation/index.html")
    code, out, err = run(capsys, "check", str(fmu))
    assert code == 1
    assert RESIDUAL in out
    assert "value or rate jumps" in err


@pytest.mark.parametrize("angle", SMOOTH)
def test_of_a_smooth_driver_nothing_is_said(angle):
    assert lag(solver.assemble(solver.loads(ARM.format(angle=angle)))) == []


PLANETARY = """
name = "planetary"
dimension = 2
[bodies]
carrier = { position = [0, 0], mass = 2, inertia = 0.02 }
sun = { position = [0, 0], mass = 1, inertia = 0.001 }
planet = { position = [0.045, 0], mass = 0.5, inertia = 0.0002 }
[joints]
jc = { type = "revolute", bodies = ["ground", "carrier"], position = [0, 0] }
js = { type = "revolute", bodies = ["carrier", "sun"], position = [0, 0] }
jp = { type = "revolute", bodies = ["carrier", "planet"], position = [0.045, 0] }
sun_planet = { type = "gear", joints = ["js", "jp"], ratio = -0.8 }
planet_ring = { type = "gear", joints = ["jc", "jp"], ratio = -2.8 }
[forces]
motor = { type = "torque", body = "sun", value = "1.0" }
[experiment]
stop_time = 2
step_size = 0.02
"""


@pytest.mark.parametrize("driven", [False, True])
def test_velocities_that_lag_in_long_steps_are_no_jump_of_a_driver(driven):
    """The sun comes to 966 rad/s, and turns by 9.7 rad in a step."""
    driver = """
[drivers]
door = { type = "angle", joint = "hinge", value = "sin(t)" }
[joints.hinge]
type = "revolute"
bodies = ["ground", "panel"]
position = [1, 0]
[bodies.panel]
position = [1, 0]
mass = 1
inertia = 1
"""
    (said,) = lag(solver.assemble(solver.loads(f"{PLANETARY}{driver * driven}[solver]\nstep_size = 0.01\n")))
    assert "jumps" not in said
    assert said.endswith("set a solver.tolerance, or a shorter solver.step_size")
