"""Forces do the work that their laws say, step by step, and every joule is booked.

The discrete forms are those of Gonzalez 1996 and García Orden & Goicolea 2000: a spring's force is
a difference quotient of its potential, a damper's has the sign of its elongation, a torque's couple
turns by the angle that the link turns.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

import solver
from tests.problems import (
    GRAVITY,
    Array,
    four_bar,
    mechanism,
    move,
    observe,
    observed_order,
    start,
    step,
    tethered,
    turning_bar,
    view,
)

DIMENSIONS = pytest.mark.parametrize("dimension", [2, 3], ids=["plane", "space"])


def lengths(q: Array) -> Array:
    """Distance of the first point from the origin at each time."""
    return np.linalg.norm(q[:, 0], axis=1)


def kinetic(v: Array, mass: float = 2.0) -> Array:
    """Kinetic energy of the first point at each time."""
    return 0.5 * mass * np.einsum("ik,ik->i", v[:, 0], v[:, 0])


# ----------------------------------------------------------------------- gravity, springs, dampers


@DIMENSIONS
@pytest.mark.parametrize("h", [0.01, 1.0])
def test_a_thrown_point_flies_its_parabola_at_any_step(dimension, h):
    # The step is exact for a constant force: only round-off remains.
    points = {"A": {"position": [0.0] * dimension, "velocity": [3.0] * dimension, "mass": 0.7}}
    motion = move(start(mechanism("thrown", dimension, points=points), h=h), h, 50)
    expected = 3.0 * motion.t[:, np.newaxis] * np.ones(dimension)
    expected[:, -1] -= 0.5 * GRAVITY * motion.t**2
    assert motion.q[:, 0] == pytest.approx(expected, rel=1e-13, abs=1e-12)


@DIMENSIONS
@pytest.mark.parametrize("free_length", [0.0, 0.7, 3.0])
@pytest.mark.parametrize("h", [0.01, 0.3])
def test_a_spring_takes_and_gives_back_exactly_its_energy(dimension, free_length, h):
    law = {"type": "spring", "stiffness": 50.0, "free_length": free_length}
    motion = move(start(tethered(law, dimension), h=h), h, 200)
    stored = 0.5 * 50.0 * (lengths(motion.q) - free_length) ** 2
    exchanged = np.diff(kinetic(motion.v)) + np.diff(stored)
    # Rounding of energies up to 1e2 J, a few times in each difference.
    assert np.abs(exchanged).max() < 1e-13 * stored.max() * 10


@pytest.mark.parametrize("h", [0.01, 0.1, 0.5])
def test_a_spring_without_free_length_swings_at_the_frequency_of_the_midpoint_rule(h):
    # x_n = cos(n theta) with tan(theta/2) = omega h/2, exactly.
    points = {"A": {"position": [1.0, 0.0], "mass": 2.0}}
    tie = {
        "type": "spring",
        "points": ["ground", "A"],
        "at": [0, 0],
        "stiffness": 50,
        "free_length": 0,
    }
    content = mechanism("oscillator", 2, gravity=False, points=points, forces={"tie": tie})
    motion = move(start(content, h=h), h, 100)
    theta = 2 * math.atan(math.sqrt(50.0 / 2.0) * h / 2)
    assert motion.q[:, 0, 0] == pytest.approx(np.cos(np.arange(101) * theta), abs=1e-12)


@DIMENSIONS
@pytest.mark.parametrize("h", [0.01, 0.3])
def test_a_damper_takes_out_c_times_the_square_of_its_elongation_over_h(dimension, h):
    integrator = start(tethered({"type": "damper", "damping": 1.5}, dimension), h=h)
    q, v, taken = [view(integrator, "q").copy()], [view(integrator, "v").copy()], [0.0]
    for _ in range(100):
        step(integrator, h)
        q.append(view(integrator, "q").copy())
        v.append(view(integrator, "v").copy())
        taken.append(integrator["energy.dissipated"])
    elongation = np.diff(lengths(np.array(q)))
    expected = 1.5 * elongation**2 / h
    assert np.diff(taken) == pytest.approx(expected, rel=1e-9, abs=1e-14)
    assert (np.diff(taken) >= 0.0).all()
    assert kinetic(np.array(v)) + taken == pytest.approx([kinetic(np.array(v))[0]] * 101, rel=1e-13)


def test_a_damped_oscillator_is_of_second_order():
    # m x'' + c x' + k x = 0 along the line of its spring and damper, 1 m from the ground's point.
    def error(h: float) -> float:
        points = {"A": {"position": [1.3, 0.0], "mass": 2.0}}
        tie = {"points": ["ground", "A"], "at": [0.0, 0.0]}
        forces = {
            "spring": {"type": "spring", "stiffness": 50.0, "free_length": 1.0} | tie,
            "damper": {"type": "damper", "damping": 2.0} | tie,
        }
        content = mechanism("damped", 2, gravity=False, points=points, forces=forces)
        motion = move(start(content, h=h), h, round(2 / h))
        decay, rate = 0.5, math.sqrt(25 - 0.25)
        envelope = 0.3 * np.exp(-decay * motion.t)
        exact = 1 + envelope * (np.cos(rate * motion.t) + decay / rate * np.sin(rate * motion.t))
        return float(np.abs(motion.q[:, 0, 0] - exact).max())

    steps = [0.02, 0.01, 0.005]
    assert observed_order(steps, [error(h) for h in steps]) == pytest.approx(2.0, abs=0.05)


def test_a_spring_whose_ends_meet_is_refused_with_its_reason():
    points = {"A": {"position": [0.5, 0.0], "velocity": [-1.0, 0.0], "mass": 1.0}}
    tie = {
        "type": "spring",
        "points": ["ground", "A"],
        "at": [0.5, 0],
        "stiffness": 1,
        "free_length": 1,
    }
    content = mechanism("meeting", 2, gravity=False, points=points, forces={"tie": tie})
    with pytest.raises((solver.SceneError, solver.AssemblyError), match="coincide"):
        start(content)


# ----------------------------------------------------------------------------- forces from outside


def test_the_work_of_a_constant_force_is_force_times_way():
    force = {"type": "force", "point": "B0", "value": [2.0, -3.0]}
    integrator = start(four_bar(1) | {"forces": {"push": force}}, h=0.05)
    motion = move(integrator, 0.05, 200)
    way = motion.q[-1, 0] - motion.q[0, 0]
    assert integrator["energy.work"] == pytest.approx(2.0 * way[0] - 3.0 * way[1], abs=1e-12)


def test_the_work_of_a_force_that_changes_in_time_is_taken_in_the_middle_of_the_step():
    h, force = 0.1, {"type": "force", "point": "A", "value": ["4*sin(3*t)", 0.0]}
    points = {"A": {"position": [0.0, 0.0], "velocity": [1.0, 0.5], "mass": 2.0}}
    content = mechanism("driven", 2, points=points, forces={"push": force})
    integrator = start(content, h=h)
    motion = move(integrator, h, 100)
    middle = motion.t[:-1] + h / 2
    expected = np.sum(4 * np.sin(3 * middle) * np.diff(motion.q[:, 0, 0]))
    assert integrator["energy.work"] == pytest.approx(expected, abs=1e-12)
    fallen = integrator["energy.kinetic"]  # 1e4 J after 10 s, of which the last digit is 2e-12
    assert abs(integrator["energy.balance"]) < 1e-15 * fallen


@pytest.mark.parametrize("pivoted", [True, False], ids=["pivoted", "free"])
@pytest.mark.parametrize("h", [0.01, 0.2])
def test_the_work_of_a_torque_in_the_plane_is_torque_times_angle(pivoted, h):
    # Over several turns, at up to 2 rad in a step.
    integrator = start(turning_bar(2, -2.5, pivoted=pivoted), h=h)
    work, angle, energy = observe(
        integrator, h, round(6 / h), ["energy.work", "bar.angle", "energy.kinetic"]
    ).T
    assert angle[-1] < -6 * math.pi
    assert work == pytest.approx(-2.5 * angle, rel=1e-12, abs=1e-12)
    assert energy == pytest.approx(work, rel=1e-12, abs=1e-12)


@DIMENSIONS
def test_a_bar_that_is_turned_gains_speed_as_the_torque_says(dimension):
    # I w' = M about the pivot, I = m L^2/3 = 1.6 kg m^2: w = M t/I, of second order in h.
    torque = 0.8 if dimension == 2 else [0.0, 0.0, 0.8]
    errors, steps = [], [0.2, 0.1, 0.05]
    for h in steps:
        motion = move(start(turning_bar(dimension, torque), h=h, paired=True), h, round(4 / h))
        angle = np.unwrap(np.arctan2(motion.q[:, 0, 1], motion.q[:, 0, 0]))
        errors.append(np.abs(angle - 0.5 * 0.8 / 1.6 * motion.t**2).max())
    assert observed_order(steps, errors) == pytest.approx(2.0, abs=0.1)


@pytest.mark.parametrize("h", [0.01, 0.2])
def test_the_work_of_a_moment_in_space_is_moment_times_angle_about_it(h):
    # The bar starts across the moment's axis, so that it turns about that axis and nothing else.
    axis = np.array([0.0, 0.6, 0.8])
    integrator = start(turning_bar(3, (1.5 * axis).tolist()), h=h)
    across = np.cross(axis, [1.0, 0.0, 0.0])
    angle, work = [0.0], [0.0]
    for _ in range(round(6 / h)):
        step(integrator, h)
        link = view(integrator, "q")[0] / 2.0
        angle.append(math.atan2(link @ across, link[0]))
        work.append(integrator["energy.work"])
        assert abs(link @ axis) < 1e-12
    assert np.unwrap(angle)[-1] > 4 * math.pi
    assert np.array(work) == pytest.approx(1.5 * np.unwrap(angle), rel=1e-11, abs=1e-12)


def test_a_moment_along_a_slender_bar_does_nothing():
    integrator = start(turning_bar(3, [5.0, 0.0, 0.0], pivoted=False), h=0.1)
    motion = move(integrator, 0.1, 20)
    assert np.abs(motion.q - motion.q[0]).max() == 0.0
    assert integrator["energy.work"] == 0.0


def test_the_work_of_a_moment_on_a_tumbling_bar_is_that_of_its_angular_velocity():
    # integral of m . w dt with w = u x u'/L^2 along the computed motion, trapezoidal, is met to
    # O(h^2).
    content = turning_bar(3, [0.4, -0.7, 1.1], pivoted=False)
    content["points"]["O"]["velocity"], content["points"]["A"]["velocity"] = (
        [0, -1, 0.5],
        [0, 1, -0.5],
    )
    errors, steps = [], [0.04, 0.02, 0.01]
    for h in steps:
        integrator = start(content, h=h, paired=True)
        motion = move(integrator, h, round(3 / h))
        link, rate = motion.q[:, 1] - motion.q[:, 0], motion.v[:, 1] - motion.v[:, 0]
        power = np.cross(link, rate) @ [0.4, -0.7, 1.1] / 4.0
        expected = np.sum((power[1:] + power[:-1]) / 2) * h
        errors.append(abs(integrator["energy.work"] - expected))
        assert abs(integrator["energy.balance"]) < 1e-11
    assert observed_order(steps, errors) == pytest.approx(2.0, abs=0.1)
