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
from tests.support.mechanisms.problems import (
    GRAVITY,
    mechanism,
    move,
    observed_order,
    start,
    step,
    turning_bar,
    view,
)

DIMENSIONS = pytest.mark.parametrize("dimension", [2, 3], ids=["plane", "space"])


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


@pytest.mark.parametrize("h", [0.01, 0.1, 0.5])
def test_a_spring_without_free_length_swings_at_the_frequency_of_the_midpoint_rule(h):
    # Half steps of h/2: x_n = cos(2 n theta) with tan(theta/2) = omega h/4, exactly.
    points = {"A": {"position": [1.0, 0.0], "mass": 2.0}}
    tie = {
        "type": "spring",
        "points": ["ground", "A"],
        "at": [0, 0],
        "stiffness": 50,
        "free_length": 0,
    }
    content = mechanism("oscillator", 2, gravity=False, points=points, forces={"tie": tie})
    motion = move(start(content, h=2 * h), 2 * h, 50)
    theta = 2 * math.atan(math.sqrt(50.0 / 2.0) * h / 2)  # of each half of a pair
    assert motion.q[:, 0, 0] == pytest.approx(np.cos(np.arange(0, 101, 2) * theta), abs=1e-12)


# ----------------------------------------------------------------------------- forces from outside


def test_the_work_of_a_force_that_changes_in_time_is_taken_in_the_middle_of_each_half_step():
    h, force = 0.1, {"type": "force", "point": "A", "value": ["4*sin(3*t)", 0.0]}
    points = {"A": {"position": [0.0, 0.0], "velocity": [1.0, 0.5], "mass": 2.0}}
    content = mechanism("driven", 2, points=points, forces={"push": force})
    integrator = start(content, h=h)
    motion = move(integrator, h, 100)
    # By hand: 2 kg pushed by the force in the middle of each half step of 50 ms.
    push = 4.0 * np.sin(3.0 * (np.arange(200) + 0.5) * h / 2)
    v = 1.0 + np.concatenate([[0.0], np.cumsum(push / 2.0 * h / 2)])
    way = 0.5 * (v[:-1] + v[1:]) * h / 2
    assert motion.q[-1, 0, 0] == pytest.approx(np.sum(way), abs=1e-12)
    assert integrator["energy.work"] == pytest.approx(np.sum(push * way), abs=1e-12)
    fallen = integrator["energy.kinetic"]  # 1e4 J after 10 s, of which the last digit is 2e-12
    assert abs(integrator["energy.balance"]) < 1e-15 * fallen


@DIMENSIONS
def test_a_bar_that_is_turned_gains_speed_as_the_torque_says(dimension):
    # I w' = M about the pivot, I = m L^2/3 = 1.6 kg m^2: w = M t/I, of second order in h.
    torque = 0.8 if dimension == 2 else [0.0, 0.0, 0.8]
    errors, steps = [], [0.2, 0.1, 0.05]
    for h in steps:
        motion = move(start(turning_bar(dimension, torque), h=h), h, round(4 / h))
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


@pytest.mark.parametrize(
    "law",
    [
        'type = "spring", stiffness = 0',
        'type = "damper", damping = 0',
        'type = "gravitation", constant = 0',
    ],
)
def test_a_force_without_strength_moves_nothing(law):
    run = solver.simulate(
        solver.loads(
            f"""
name = "weak"
[points]
A = {{ position = [0, 0, 0], mass = 1, velocity = [0, 1, 0] }}
B = {{ position = [1, 0, 0], mass = 2 }}
[forces]
law = {{ points = ["A", "B"], {law} }}
"""
        ),
        stop_time=1.0,
    )
    # Ten steps of round-off at most.
    assert run["A.y"] == pytest.approx(run.t, abs=1e-13)
    assert run["B.x"] == pytest.approx(1.0, abs=1e-14)
    assert run["law.force"] == pytest.approx(0.0, abs=1e-14)
