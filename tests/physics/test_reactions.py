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


@pytest.mark.parametrize("order", [["ground", "beam"], ["beam", "ground"]])
def test_a_clamp_carries_weight_and_bending_moment(order):
    # On the beam, whose centre is 3 m from the clamp: 20 N up, and 60 N.m about -y ... by r x F.
    text = f"""{DOWN}
[bodies]
beam = {{ position = [3, 0, 0], {BOX} }}
[joints]
clamp = {{ type = "fixed", bodies = {order}, position = [0, 0, 0] }}
"""
    held = start(text.replace("'", '"'))
    sign = 1.0 if order[1] == "beam" else -1.0
    assert vector(held, "clamp.force") == pytest.approx([0, 0, sign * 20], abs=AT_REST)
    assert vector(held, "clamp.torque") == pytest.approx([0, -sign * 60, 0], abs=AT_REST)


def test_a_clamp_in_the_plane_carries_weight_and_bending_moment():
    text = """
dimension = 2
gravity = [0, -10]
[bodies]
beam = { position = [3, 1], mass = 2.0, inertia = 0.3, orientation = 0.4 }
[joints]
clamp = { type = "fixed", bodies = ["ground", "beam"], position = [0, 0] }
"""
    held = start(text)
    assert vector(held, "clamp.force", "xy") == pytest.approx([0, 20], abs=AT_REST)
    assert held["clamp.torque.z"] == pytest.approx(60, abs=1e-5)


@pytest.mark.parametrize(("kind", "axis"), [("prismatic", [1, 0, 0]), ("revolute", [0, 0, 1])])
def test_a_guide_and_a_hinge_carry_the_moment_across_their_axis(kind, axis):
    text = f"""{DOWN}
[bodies]
beam = {{ position = [3, 0, 0], {BOX} }}
[joints]
guide = {{ type = "{kind}", bodies = ["ground", "beam"], position = [0, 0, 0], axis = {axis} }}
"""
    held = start(text)
    assert vector(held, "guide.force") == pytest.approx([0, 0, 20], abs=AT_REST)
    assert vector(held, "guide.torque") == pytest.approx([0, -60, 0], abs=AT_REST)


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


def test_a_gear_hands_the_torque_on_in_its_ratio():
    # theta_2 = k theta_1: torques in balance if M_1 + k M_2 = 0; the gear holds the second joint.
    text = f"""
[bodies]
one = {{ position = [0, 0, 0], {BOX} }}
two = {{ position = [1, 0, 0], {BOX} }}
[joints]
a = {{ type = "revolute", bodies = ["ground", "one"], position = [0, 0, 0], axis = [0, 0, 1] }}
b = {{ type = "revolute", bodies = ["ground", "two"], position = [1, 0, 0], axis = [0, 0, 1] }}
mesh = {{ type = "gear", joints = ["a", "b"], ratio = -2.0 }}
[forces]
first = {{ type = "joint_torque", joint = "a", value = 6.0 }}
second = {{ type = "joint_torque", joint = "b", value = 3.0 }}
"""
    held = start(text, 5)
    assert held["mesh.torque"] == pytest.approx(-3.0, abs=AT_REST)
    assert held["b.angle"] == pytest.approx(0.0, abs=1e-9)


def test_a_constant_angle_is_held_by_its_torque():
    # Two hinged bodies, the angle of 1 rad between them held against 2 N.m that would close it.
    c, s = math.cos(1.0), math.sin(1.0)
    text = f"""
[bodies]
leaf = {{ position = [0, 0, 0], {BOX} }}
[joints]
hinge = {{ type = "revolute", bodies = ["ground", "leaf"], position = [0, 0, 0], axis = [0, 0, 1] }}
stay = {{ type = "angle", bodies = ["ground", "leaf"], axes = [[1, 0, 0], [{c!r}, {s!r}, 0]] }}
[forces]
push = {{ type = "joint_torque", joint = "hinge", value = -2.0 }}
"""
    held = start(text, 3)
    assert held["stay.torque"] == pytest.approx(2.0, abs=AT_REST)


def test_a_surface_pushes_along_its_normal():
    # A point on a slope z = x/2: N = m g cos, across the slope.
    text = f"""{DOWN}
[points]
P = {{ position = [2, 0, 1], mass = 3.0 }}
[joints]
slope = {{ type = "point_on_surface", point = "P", surface = "z - x/2" }}
"""
    held = start(text)
    across = np.array([-0.5, 0, 1]) / math.sqrt(1.25)
    expected = 30 * across[2] * across
    assert vector(held, "slope.force") == pytest.approx(expected.tolist(), abs=AT_REST)


def test_a_wheel_on_a_slope_is_held_by_the_line_and_turned_by_its_friction():
    # A disc J = m R^2/2 rolls down a slope of 30 degrees with 2/3 g sin; friction m g sin/3 uphill.
    c, s = math.cos(math.pi / 6), 0.5
    text = f"""
dimension = 2
gravity = [0, -9.0]
[bodies]
disc = {{ position = [{-0.3 * s!r}, {0.3 * c!r}], mass = 2.0, inertia = 0.09 }}
[joints]
roll = {{ type = "rolling", body = "disc", radius = 0.3, normal = [{-s!r}, {c!r}] }}
"""
    wheel = start(text, 10)
    weight = 18.0
    normal, uphill = np.array([-s, c]), np.array([c, s])
    expected = weight * c * normal + weight * s / 3 * uphill
    assert vector(wheel, "roll.force", "xy") == pytest.approx(expected.tolist(), rel=1e-6)
    downhill = -3.0 * 0.01  # 2/3 g sin over 10 ms
    assert vector(wheel, "disc", ["vx", "vy"]) == pytest.approx((downhill * uphill).tolist())
    assert wheel["disc.angular_velocity"] == pytest.approx(0.1, rel=1e-9)


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


def test_a_driven_point_is_held_by_its_driver():
    text = """
dimension = 2
gravity = [0, -10]
[points]
hand = { position = [0, 0] }
load = { position = [0, -1], mass = 2.0 }
[joints]
string = { type = "distance", points = ["hand", "load"] }
[drivers]
lift = { type = "position", point = "hand", value = [0, "0.5*t**2"] }
"""
    lifted = start(text, 20)
    assert vector(lifted, "lift.force", "xy") == pytest.approx([0, 22], abs=AT_REST)
    assert lifted["lift.power"] == pytest.approx(22 * 0.02, rel=1e-6)
