"""Reactions, torques and powers against statics and against the work that they do."""

from __future__ import annotations

import math

import numpy as np
import pytest

import solver

BOX = "mass = 2.0, inertia = [0.1, 0.2, 0.3]"
AT_REST = 1e-5
"""The first multipliers are regularised by 1e-8 of each row [N, N.m]."""
DOWN = "gravity = [0, 0, -10]"


def start(text: str, steps: int = 0, h: float = 1e-3) -> solver.Integrator:
    integrator = solver.Integrator(solver.assemble(solver.loads(f'name = "statics"\n{text}')))
    integrator["solver.step_size"] = h
    integrator.initialise()
    for _ in range(steps):
        integrator.advance(integrator.time, h)
    return integrator


def vector(integrator: solver.Integrator, name: str, axes: str = "xyz") -> list[float]:
    return [float(integrator[f"{name}.{axis}"]) for axis in axes]


# ------------------------------------------------------------------------- bodies that are held


def test_a_screw_turns_weight_into_torque():
    # F p/(2 pi) = M: the spring of torsion that holds the nut, on the ground's behalf.
    text = f"""{DOWN}
[bodies]
nut = {{ position = [0, 0, 1], {BOX} }}
[joints.thread]
type = "screw"
bodies = ["ground", "nut"]
position = [0, 0, 0]
axis = [0, 0, 1]
pitch = 0.1
[forces]
lock = {{ type = "joint_torque", joint = "thread", value = {20 * 0.1 / (2 * math.pi)!r} }}
"""
    held = start(text)
    assert vector(held, "thread.force") == pytest.approx([0, 0, 20], abs=AT_REST)
    lock = float(held["lock.torque"])
    assert lock == pytest.approx(20 * 0.1 / (2 * math.pi), rel=1e-12)
    assert vector(held, "thread.torque") == pytest.approx([0, 0, -lock], abs=AT_REST)


def test_the_same_disc_in_space_rolls_the_same():
    c, s = math.cos(math.pi / 6), 0.5
    text = f"""
gravity = [0, 0, -9.0]
[bodies.disc]
position = [{-0.3 * s!r}, 0, {0.3 * c!r}]
mass = 2.0
inertia = [0.045, 0.09, 0.045]
[joints.roll]
type = "rolling"
body = "disc"
radius = 0.3
axis = [0, 1, 0]
normal = [{-s!r}, 0, {c!r}]
"""
    wheel = start(text, 10)
    normal, uphill = np.array([-s, 0, c]), np.array([c, 0, s])
    expected = 18.0 * c * normal + 3.0 * uphill
    # The disc is drawn upright on a slope: it leans about the line of steepest descent by nothing.
    assert vector(wheel, "roll.force") == pytest.approx(expected.tolist(), rel=1e-5, abs=AT_REST)


# --------------------------------------------------------------------- drivers and their power

DRIVERS = {
    "angle": (
        'hinge = { type = "revolute", bodies = ["ground", "arm"], position = [0, 0, 0], '
        "axis = [0, 1, 0] }",
        'motor = { type = "angle", joint = "hinge", value = "t**2" }',
    ),
    "displacement": (
        'guide = { type = "prismatic", bodies = ["ground", "arm"], position = [0, 0, 0], '
        "axis = [1, 0, 1] }",
        'motor = { type = "displacement", joint = "guide", value = "t**2" }',
    ),
    "distance": (
        'pin = { type = "spherical", bodies = ["ground", "arm"], position = [0, 0, 0] }',
        'motor = { type = "distance", points = ["ground", "arm"], at = [[1, 0, 1], [1, 0, 0]], '
        'value = "1 - t**2" }',
    ),
    "position of a body": (
        "",
        'motor = { type = "position", point = "arm.tip", value = ["1", "t**2", "t**2"] }',
    ),
}


@pytest.mark.parametrize(("joint", "driver"), DRIVERS.values(), ids=DRIVERS)
def test_the_power_of_a_driver_adds_up_to_the_work_that_it_does(joint, driver):
    # Trapezes of 1 ms over 0.3 s: (1e-3)^2/12 of the second derivative, some 1e-5 J of 1 J.
    text = f"""{DOWN}
[bodies]
arm = {{ position = [0.5, 0, 0], points = {{ tip = [0.5, 0, 0] }}, {BOX} }}
[joints]
{joint}
[drivers]
{driver}
"""
    mechanism = start(text)
    power, work = [], []
    for k in range(301):
        power.append(float(mechanism["motor.power"]))
        work.append(float(mechanism["energy.work"]))
        mechanism.advance(k * 1e-3, 1e-3)
    done = 1e-3 * (sum(power) - 0.5 * (power[0] + power[-1]))
    assert abs(work[-1]) > 0.1
    assert done == pytest.approx(work[-1], rel=1e-3)
    assert abs(float(mechanism["energy.balance"])) < 1e-12
