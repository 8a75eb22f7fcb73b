"""Loads from the outside do the work of their law, to the last digit.

A load is evaluated once, in the middle of a step; its work is then a sum over steps that outputs
suffice to form. Tolerances are round-off of that work.
"""

from __future__ import annotations

import numpy as np
import pytest

import solver
from tests.support.mechanisms.problems import Array, observed_order
from tests.support.mechanisms.work_sums import (
    ROUND_OFF,
    HalfSteps,
    middles,
    sums,
    trapezoids,
    vector,
)

DIMENSIONS = pytest.mark.parametrize("dimension", [2, 3], ids=["plane", "space"])
STEPS = pytest.mark.parametrize("h", [0.02, 0.2])
AXES = {2: "xy", 3: "xyz"}

FREE = {
    2: """
name = "free"
dimension = 2
[points]
P = { position = [0.1, 0.7], velocity = [0.4, -0.3], mass = 0.8 }
[bodies.A]
position = [0.2, -0.1]
mass = 2.0
inertia = 0.13
center_of_mass = [0.03, 0.05]
orientation = 0.3
velocity = [0.1, -0.2]
angular_velocity = 1.7
points = { tip = [0.3, -0.1], ux = [1, 0], uy = [0, 1] }
""",
    3: """
name = "free"
[points]
P = { position = [0.1, 0.7, -0.2], velocity = [0.4, -0.3, 0.5], mass = 0.8 }
[bodies.A]
position = [0.2, -0.1, 0.3]
mass = 2.0
inertia = [0.11, 0.13, 0.17]
center_of_mass = [0.03, 0.05, -0.02]
orientation = { rotation_vector = [0.2, -0.3, 0.4] }
velocity = [0.1, -0.2, 0.3]
angular_velocity = [1.0, -0.5, 0.7]
points = { tip = [0.3, -0.1, 0.2], ux = [1, 0, 0], uy = [0, 1, 0], uz = [0, 0, 1] }
""",
}
FORCE, MOMENT = np.array([1.3, -0.7, 0.9]), np.array([0.4, -0.7, 1.1])


def loaded(dimension: int, load: str, h: float, stop: float = 2.0) -> HalfSteps:
    """A point and a body in free flight under one load."""
    scene = solver.loads(f"{FREE[dimension]}[forces]\nload = {{ {load} }}\n")
    return HalfSteps(scene, stop_time=stop, h=h)


def directors(run: HalfSteps, dimension: int) -> Array:
    """Axes of the body, shape (n, axis, component)."""
    axes = [vector(run, f"A.u{axis}.", AXES[dimension]) for axis in AXES[dimension]]
    return np.stack(axes, axis=1) - vector(run, "A.", AXES[dimension])[:, np.newaxis]


@DIMENSIONS
@STEPS
@pytest.mark.parametrize("place", ["P", "A", "A.tip"])
def test_a_constant_force_does_force_times_way_and_gives_its_impulse(place, h, dimension):
    force = FORCE[:dimension]
    run = loaded(dimension, f'type = "force", point = "{place}", value = {force.tolist()}', h)
    way, t = vector(run, f"{place}.", AXES[dimension]), h * np.arange(len(run.t))
    assert run["energy.work"] == pytest.approx((way - way[0]) @ force, abs=1e-11)
    momentum = vector(run, "momentum.", AXES[dimension])
    assert momentum == pytest.approx(momentum[0] + np.outer(t, force), abs=ROUND_OFF)


@DIMENSIONS
@STEPS
@pytest.mark.parametrize("place", ["A", "A.tip"])
def test_a_force_that_turns_with_its_body_works_along_the_mean_of_its_axes(place, h, dimension):
    force = FORCE[:dimension]
    law = f'type = "force", point = "{place}", value = {force.tolist()}, axes = "body"'
    run = loaded(dimension, law, h)
    acting = np.einsum("k,nki->ni", force, middles(directors(run, dimension)))
    steps = np.diff(vector(run, f"{place}.", AXES[dimension]), axis=0)
    work = sums(np.einsum("ni,ni->n", acting, steps))
    assert run["energy.work"] == pytest.approx(work, abs=1e-11)
    assert np.abs(run["energy.balance"]).max() < ROUND_OFF * np.abs(run["energy.work"]).max()


@STEPS
@pytest.mark.parametrize("axes", ["global", "body"])
def test_a_torque_on_a_body_in_the_plane_does_torque_times_angle(axes, h):
    law = f'[forces]\nload = {{ type = "torque", body = "A", value = -1.1, axes = "{axes}" }}\n'
    run = solver.simulate(solver.loads(FREE[2] + law), stop_time=6.0, step_size=h, internal_step=h)
    turned = run["A.angle"] - 0.3
    assert turned[-1] < -30.0
    assert run["energy.work"] == pytest.approx(-1.1 * turned, rel=1e-12, abs=1e-12)


@STEPS
@pytest.mark.parametrize("axes", ["global", "body"])
def test_a_torque_in_space_is_a_couple_on_the_three_axes(axes, h):
    # Half of m x d^i on each director d_i, with d^i dual to their means: the whole couple is m.
    law = f'type = "torque", body = "A", value = {MOMENT.tolist()}, axes = "{axes}"'
    run = loaded(3, law, h, stop=1.2)  # up to 2.5 rad in a step: none is halved
    d = directors(run, 3)
    mean = middles(d)
    dual = np.linalg.inv(mean).transpose(0, 2, 1)
    moment = np.einsum("k,nki->ni", MOMENT, mean) if axes == "body" else MOMENT
    couple = 0.5 * np.cross(np.broadcast_to(moment, mean[:, 0].shape)[:, np.newaxis], dual)
    work = sums(np.einsum("nki,nki->n", np.diff(d, axis=0), couple))
    size = np.abs(work).max()
    assert run["energy.work"] == pytest.approx(work, abs=ROUND_OFF * size)
    if axes == "global":
        t, kept = h * np.arange(len(run.t)), vector(run, "angular_momentum.")
        assert kept == pytest.approx(kept[0] + np.outer(t, MOMENT), abs=ROUND_OFF * size)


@pytest.mark.parametrize("axes", ["global", "body"])
def test_the_work_of_a_torque_in_space_is_the_integral_of_its_power(axes):
    law = f'type = "torque", body = "A", value = {MOMENT.tolist()}, axes = "{axes}"'
    errors, steps = [], [0.02, 0.01, 0.005]
    for h in steps:
        run = loaded(3, law, h)
        moment = MOMENT if axes == "global" else np.einsum("k,nki->ni", MOMENT, directors(run, 3))
        power = np.sum(vector(run, "A.w") * moment, axis=1)
        errors.append(np.abs(run["energy.work"] - trapezoids(power, h)).max())
    assert observed_order(steps, errors) == pytest.approx(2.0, abs=0.2)


def test_a_torque_about_a_fixed_axis_in_space_does_twice_the_tangent_of_half_the_angle():
    # The same couple turns a plane figure by a: its directors move 2 sin(a/2) against 1/cos(a/2).
    text = """
name = "flywheel"
[bodies]
wheel = { position = [0, 0, 0], mass = 2.0, inertia = [0.11, 0.13, 0.17] }
[joints]
axle = { type = "revolute", bodies = ["ground", "wheel"], position = [0, 0, 0], axis = [0, 3, 4] }
[forces]
motor = { type = "torque", body = "wheel", value = [0, 0.66, 0.88] }
"""
    run = HalfSteps(solver.loads(text), stop_time=2.0, h=0.1)
    work = sums(2 * 1.1 * np.tan(0.5 * np.diff(run["axle.angle"])))
    assert run["energy.work"] == pytest.approx(work, rel=1e-12)


BAR = """
name = "bar"
dimension = 2
[points]
A = { position = [0.1, 0.7], velocity = [0.4, -0.3], mass = 0.8 }
B = { position = [1.1, 0.9] }
[bodies]
bar = { type = "bar", points = ["A", "B"], mass = 1.5 }
[solver]
assemble = true
"""


@STEPS
def test_a_torque_on_a_free_bar_does_torque_times_angle(h):
    load = '[forces]\nload = { type = "torque", body = "bar", value = 2.5 }\n'
    run = solver.simulate(solver.loads(BAR + load), stop_time=4.0, step_size=h, internal_step=h)
    turned = run["bar.angle"] - run["bar.angle"][0]
    assert turned[-1] > 30.0
    assert run["energy.work"] == pytest.approx(2.5 * turned, rel=1e-12, abs=1e-12)


# --------------------------------------------------------------- formulas with sensors, and inputs

CONTROLLED = {
    # load in the plane: (its text, its power)
    "force on a point": (
        'type = "force", point = "P", value = ["-3*(P.x - A.x) - 0.5*P.vx", "-2*P.y"]',
        "(-3*(P.x - A.x) - 0.5*P.vx)*P.vx - 2*P.y*P.vy",
    ),
    "force on a body": (
        'type = "force", point = "A.tip", value = ["A.angle*sin(4*t)", "-3*A.vy"]',
        "A.angle*sin(4*t)*A.tip.vx - 3*A.vy*A.tip.vy",
    ),
    "torque": (
        'type = "torque", body = "A", value = "-4*sin(A.angle) - 0.3*A.angular_velocity"',
        "(-4*sin(A.angle) - 0.3*A.angular_velocity)*A.angular_velocity",
    ),
}


@pytest.mark.parametrize("name", CONTROLLED)
def test_the_work_of_a_controller_is_the_integral_of_its_power(name):
    law, power = CONTROLLED[name]
    text = f'{FREE[2]}[forces]\nload = {{ {law} }}\n[outputs]\npower = {{ value = "{power}" }}\n'
    errors, steps = [], [0.02, 0.01, 0.005]
    for h in steps:
        run = solver.simulate(solver.loads(text), stop_time=2.0, step_size=h, internal_step=h)
        errors.append(np.abs(run["energy.work"] - trapezoids(run["power"], h)).max())
        assert np.abs(run["energy.balance"]).max() < ROUND_OFF
        assert np.ptp(run["energy.work"]) > 0.05
    assert observed_order(steps, errors) == pytest.approx(2.0, abs=0.2)


PUSHED = """
name = "pushed"
[inputs]
u = {{ interpolation = "{interpolation}" }}
[points]
P = {{ position = [0.1, 0.7, 0], velocity = [0.4, 0, 0], mass = 0.8 }}
[forces]
push = {{ type = "force", point = "P", value = ["u", 0, "3*u"] }}
"""


@pytest.mark.parametrize("interpolation", ["hold", "ramp"])
@pytest.mark.parametrize("substeps", [1, 2, 7])
def test_a_force_from_an_input_does_the_work_of_its_course(interpolation, substeps):
    # Held: u times the way. In a line over a half step: its mean over that; for a body at
    # constant acceleration the sum over substeps is formed from the exact motion.
    every, mass = 0.1, 0.8
    integrator = solver.Integrator(
        solver.assemble(solver.loads(PUSHED.format(interpolation=interpolation)))
    )
    integrator["solver.step_size"] = every / substeps
    integrator.initialise()
    before, work, speed = 0.0, 0.0, np.array([0.4, 0.0])
    for k in range(30):
        u = 2.0 * np.sin(0.9 * k + 0.5)
        integrator["u"] = u
        integrator.advance(integrator.time, every)
        halves = 2 * substeps
        for i in range(halves):
            part = 1.0 if interpolation == "hold" else (i + 0.5) / halves
            force = (before + part * (u - before)) * np.array([1.0, 3.0])
            after = speed + force * every / halves / mass
            work += force @ (speed + after) / 2 * every / halves
            speed = after
        before = u
        assert integrator["energy.work"] == pytest.approx(work, abs=1e-11)
        assert [integrator["P.vx"], integrator["P.vz"]] == pytest.approx(speed, abs=1e-11)
    assert abs(work) > 0.1
