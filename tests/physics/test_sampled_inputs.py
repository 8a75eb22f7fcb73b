"""Held inputs that a controller samples: the cost and the errors of steps that follow them."""

from __future__ import annotations

import math

import pytest

import solver
from tests.support.kernel.twins import start

ARM = """
name = "arm"
dimension = 2
gravity = [0, -9.81]
[inputs]
torque = { unit = "N.m" }
[bodies.arm]
position = [0.5, 0]
mass = 2.0
inertia = 0.2
[bodies.hand]
position = [1.3, 0]
mass = 0.5
inertia = 0.03
[joints]
shoulder = { type = "revolute", bodies = ["ground", "arm"], position = [0, 0] }
wrist = { type = "revolute", bodies = ["arm", "hand"], position = [1, 0] }
[forces]
motor = { type = "joint_torque", joint = "shoulder", value = "torque" }
"""
STEP = 1e-3


def smooth(k):
    return 14.7 + 3 * math.sin(6 * k * STEP)


def alternating(k):
    return 14.7 + 3 * (-1) ** k


def run(course, **settings):
    """Return the end after 0.4 s and Newton's increments of the last 0.2 s."""
    arm, increments = start(solver.assemble(solver.loads(ARM)), **settings), 0.0
    for k in range(400):
        arm["torque"] = course(k)
        arm.advance(arm.time, STEP)
        increments += arm["solver.newton_iterations"] if k >= 200 else 0.0
    return arm, increments


EQUAL = {"step_size": STEP, "order": 2}
HALF_STEPS = 400  # in the last 0.2 s, of equal steps


def test_half_steps_over_samples_of_a_smooth_course_take_one_increment_each():
    """A jump that begins them anew takes two."""
    assert run(smooth, **EQUAL)[1] <= 1.1 * HALF_STEPS
    assert run(alternating, **EQUAL)[1] >= 1.9 * HALF_STEPS


@pytest.mark.parametrize("course", [smooth, alternating])
@pytest.mark.parametrize("tolerance", [1e-4, 1e-6])
def test_held_inputs_that_jump_with_each_step_keep_the_tolerance(course, tolerance):
    exact, _ = run(course, tolerance=1e-11)
    arm, _ = run(course, tolerance=tolerance)
    for name in ("arm.x", "arm.y", "hand.x", "hand.y"):
        assert arm[name] == pytest.approx(exact[name], abs=3 * tolerance)
