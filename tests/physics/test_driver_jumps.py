"""Drivers that jump: velocities do not follow them, which is said at build and found by a check."""

from __future__ import annotations

import math

import pytest

import solver
from build_fmu import build
from build_fmu.motion import RESIDUAL
from build_fmu.self_check import self_check
from tests.support.fmus.commands import run
from tests.support.kernel.twins import start

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


def lag(model: solver.Model) -> list[str]:
    """What the trial run of a build says of velocities that lag."""
    return [text for text in self_check(model).remarks if RESIDUAL in text]


def test_a_driver_whose_value_jumps_is_told_at_build_and_fails_a_check(tmp_path, capsys):
    scene = tmp_path / "arm.toml"
    scene.write_text(ARM.format(angle="0.5 if t > 1 else 0"))
    said = "driver 'motor': t > 1: what it drives would jump to another place"
    assert said in (self_check(solver.assemble(solver.load(scene))).reason or "")
    fmu = build(scene, tmp_path / "arm.fmu")
    code, _, err = run(capsys, "check", str(fmu))
    assert code != 0
    assert said in err


@pytest.mark.parametrize("settings", [{"step_size": 0.01, "order": 4}, {"tolerance": 1e-6}])
def test_velocities_jump_with_the_rate_of_a_driver(settings):
    """J = 5 + 60/4 about the joint: 40 J at 2 rad/s, and the weight at sin(angle)/2."""
    model = solver.assemble(solver.loads(ARM.format(angle="2*max(t - 1.03, 0)")))
    arm = start(model, **settings)
    for k in range(40):
        arm.advance(0.05 * k, 0.05)
    assert arm["slew.angle"] == pytest.approx(1.94, abs=1e-12)
    assert arm["slew.angular_velocity"] == pytest.approx(2.0, abs=1e-8)
    lifted = 60 * 9.81 * 0.5 * math.sin(1.94)
    assert arm["energy.work"] == pytest.approx(40.0 + lifted, rel=1e-7)
    assert abs(float(arm["energy.error"])) < 1e-12


@pytest.mark.parametrize("settings", [{"step_size": 0.01}, {"tolerance": 1e-6}])
def test_velocities_jump_at_the_points_of_a_linear_profile(settings):
    """J/2 = 10 kg.m^2 at -0.5 rad/s, then at 1 rad/s; pairs of 0.01 s have velocities to h^2."""
    profile = (
        '[profiles]\nway = { x = [0, 0.43, 3], y = [0.215, 0, 2.57], interpolation = "linear" }\n'
    )
    start_at = "[solver]\nassemble = true\n"
    model = solver.assemble(solver.loads(ARM.format(angle="way(t)") + profile + start_at))
    arm = start(model, **settings)
    for k in range(20):
        arm.advance(0.05 * k, 0.05)
    assert arm["slew.angle"] == pytest.approx(0.57, abs=1e-12)
    assert arm["slew.angular_velocity"] == pytest.approx(1.0, abs=1e-6)
    lifted = 60 * 9.81 * 0.5 * (math.sin(0.57) - math.sin(0.215))
    assert arm["energy.work"] == pytest.approx(10.0 * (1.0 - 0.25) + lifted, rel=1e-6)
    assert abs(float(arm["constraint.velocity"])) < 1e-5


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
[solver]
step_size = 0.01
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
    (said,) = lag(solver.assemble(solver.loads(PLANETARY + driver * driven)))
    assert "jumps" not in said
    assert said.endswith("set a solver.tolerance, or a shorter solver.step_size")
