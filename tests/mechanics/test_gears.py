"""Gears and racks against closed forms; freedom, momenta and order are in `test_joints.py`."""

from __future__ import annotations

import numpy as np
import pytest

import solver
from tests.mechanism_runs import run


def wheels(dimension: int, ratio: float) -> str:
    """Two wheels on the ground, 0.3 and 0.2 kg.m2, geared; 0.6 N.m turn the first."""
    axis = ", axis = [0, 0, 1]" if dimension == 3 else ""
    at = ("0, 0", "1, 0") if dimension == 2 else ("0, 0, 0", "1, 0, 0")
    inertia = ("0.3", "0.2") if dimension == 2 else ("[0.2, 0.2, 0.3]", "[0.1, 0.1, 0.2]")
    return f"""
name = "wheels"
dimension = {dimension}
[bodies]
one = {{ position = [{at[0]}], mass = 1.0, inertia = {inertia[0]} }}
two = {{ position = [{at[1]}], mass = 1.0, inertia = {inertia[1]} }}
[joints]
a = {{ type = "revolute", bodies = ["ground", "one"], position = [{at[0]}]{axis} }}
b = {{ type = "revolute", bodies = ["ground", "two"], position = [{at[1]}]{axis} }}
mesh = {{ type = "gear", joints = ["a", "b"], ratio = {ratio} }}
[forces]
motor = {{ type = "joint_torque", joint = "a", value = 0.6 }}
"""


@pytest.mark.parametrize("ratio", [-2.0, 0.5])
@pytest.mark.parametrize("dimension", [2, 3])
def test_geared_wheels_speed_up_as_one_wheel(dimension: int, ratio: float) -> None:
    """M = (J_1 + k^2 J_2) alpha; the gear turns the second wheel with J_2 k alpha.

    In steps of 0.01 s a wheel of at most 3 rad/s turns by 0.03 rad, and a body's discrete rate is
    2 sin(x/2)/x of the exact one: 4e-5, of which Richardson leaves some 1e-8.
    """
    names = ["a.angle", "a.angular_velocity", "b.angle", "mesh.torque"]
    scene = solver.loads(wheels(dimension, ratio))
    coarse, fine = (run(scene, names, h, 1.0)[-1] for h in (0.01, 0.005))
    alpha = 0.6 / (0.3 + 0.2 * ratio**2)
    exact = np.array([alpha / 2, alpha, ratio * alpha / 2, 0.2 * ratio * alpha])
    assert (4 * fine - coarse) / 3 == pytest.approx(exact, rel=1e-7)


@pytest.mark.parametrize("ratio", [-2.0, 0.5])
@pytest.mark.parametrize("h", [0.5, 0.01])
def test_a_motor_gives_geared_wheels_its_torque_times_its_angle(ratio: float, h: float) -> None:
    """M theta, and none of it is lost in the gear, at 0.5 s as well, up to 1 rad a step."""
    names = ["a.angle", "b.angle", "energy.kinetic", "energy.work"]
    found = run(solver.loads(wheels(2, ratio)), names, h, 2.0, every=0.5)
    angle, second, kinetic, work = found.T
    assert angle[-1] > 1.0
    assert second == pytest.approx(ratio * angle, abs=1e-14)
    assert kinetic == pytest.approx(0.6 * angle, abs=1e-14)
    assert work == pytest.approx(0.6 * angle, abs=1e-14)


@pytest.mark.parametrize("dimension", [2, 3])
def test_a_pinion_pulls_its_rack_with_what_speeds_it_up(dimension: int) -> None:
    """M - R F = (J + m R^2) alpha with F = 2 N against it; the rack pulls with m R alpha + F."""
    axes, at = ("[0, 0, 1]", "0, 0, 0") if dimension == 3 else ("", "0, 0")
    inertia = "[1, 1, 0.3]" if dimension == 3 else "0.3"
    scene = solver.loads(f"""
name = "pinion"
dimension = {dimension}
[bodies]
pinion = {{ position = [{at}], mass = 1.0, inertia = {inertia} }}
bar = {{ position = [{at}], mass = 4.0, inertia = {inertia} }}
[joints.hinge]
type = "revolute"
bodies = ["ground", "pinion"]
position = [{at}]
{f"axis = {axes}" if axes else ""}
[joints.guide]
type = "prismatic"
bodies = ["ground", "bar"]
axis = [{"0.6, 0.8" + ", 0" * (dimension - 2)}]
[joints.mesh]
type = "rack"
joints = ["hinge", "guide"]
radius = 0.25
[forces.motor]
type = "joint_torque"
joint = "hinge"
value = 0.9
[forces.load]
type = "force"
point = "bar"
value = [{"-1.2, -1.6" + ", 0" * (dimension - 2)}]
""")
    names = ["hinge.angle", "guide.displacement", "guide.velocity", "mesh.force"]
    coarse, fine = (run(scene, names, h, 1.0)[-1] for h in (0.01, 0.005))
    alpha = (0.9 - 0.25 * 2.0) / (0.3 + 4.0 * 0.25**2)
    travel = 0.25 * alpha
    exact = [alpha / 2, travel / 2, travel, 4.0 * travel + 2.0]
    assert (4 * fine - coarse) / 3 == pytest.approx(np.array(exact), rel=1e-8)
