"""Inputs that go to their new value by a cubic whose rate does not jump, and what drivers feel."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import simpson

import solver
from solver.runtime import Integrator
from tests.support.mechanisms.problems import observed_order

INERTIA, WEIGHT = 0.2 + 2.0 * 0.3**2, 2.0 * 10.0 * 0.3
"""About the hinge [kg m2], and the moment of the arm's weight in the horizontal [N m]."""
ARM = """
name = "arm"
dimension = 2
gravity = [0, -10]
[inputs]
u = { unit = "rad", interpolation = "smooth" }
[bodies.A]
position = [0, 0]
center_of_mass = [0.3, 0]
mass = 2.0
inertia = 0.2
[joints]
j = { type = "revolute", bodies = ["ground", "A"], position = [0, 0] }
[drivers]
motor = { type = "angle", joint = "j", value = "u" }
[solver]
step_size = 0.001
tolerance = TOLERANCE
"""
MODELS = {
    tolerance: solver.assemble(solver.loads(ARM.replace("TOLERANCE", str(tolerance))))
    for tolerance in (0.0, 1e-8)
}
STEPS = (0.04, 0.02, 0.01)
READ = ("motor.torque", "A.angular_velocity")
TOLERANCES = pytest.mark.parametrize("tolerance", MODELS)


def driven(
    integrator: Integrator, angle: Callable[[float], float], steps: Sequence[float]
) -> np.ndarray:
    """Time and what is `READ` after communication steps that end where the angle is."""
    rows = []
    for step in steps:
        integrator["u"] = angle(integrator.time + step)
        integrator.advance(integrator.time, step)
        rows.append([integrator.time, *(integrator[name] for name in READ)])
    return np.array(rows)


def begun(tolerance: float) -> Integrator:
    integrator = Integrator(MODELS[tolerance])
    integrator.initialise()
    return integrator


def torque(angle: np.ndarray, acceleration: np.ndarray | float) -> np.ndarray:
    """What holds the arm on a motion [N m]."""
    return INERTIA * acceleration + WEIGHT * np.cos(angle)


@given(
    acceleration=st.floats(-2.0, 2.0),
    steps=st.lists(st.floats(0.02, 0.05), min_size=2, max_size=6),
)
def test_a_smooth_input_follows_a_constant_acceleration_from_rest(acceleration, steps):
    """Three values tell a parabola. Signals are known to 1e-16 over the square of a step."""
    t, felt, rate = driven(begun(1e-8), lambda t: 0.5 * acceleration * t * t, steps).T
    assert rate == pytest.approx(acceleration * t, abs=1e-7)
    assert felt == pytest.approx(torque(0.5 * acceleration * t * t, acceleration), abs=1e-5)


@TOLERANCES
def test_the_integral_of_a_drivers_power_comes_to_its_work_with_shorter_communication_steps(
    tolerance,
):
    """A ramp's lacks the kinetic energy, 0.087 J, at any length."""
    errors = []
    for step in STEPS:
        integrator = begun(tolerance)
        count = round(1.2 / step)
        _, felt, rate = driven(integrator, lambda t: math.sin(t) ** 2, [step] * count).T
        power = np.concatenate([[0.0], felt * rate])
        errors.append(abs(integrator["energy.work"] - simpson(power, dx=step)))
    assert observed_order(STEPS, errors) > 1.8


@TOLERANCES
def test_a_restored_run_goes_on_with_the_same_cubics(tolerance):
    integrator = begun(tolerance)
    driven(integrator, math.sin, [0.02, 0.03])
    state = integrator.save()
    first, again = (
        (integrator.restore(state), driven(integrator, math.sin, [0.01, 0.04, 0.02]))[1]
        for _ in range(2)
    )
    assert np.array_equal(first, again)


def test_a_short_step_does_not_enlarge_what_its_value_lacks():
    """A value that is 1e-5 off, after a step of 0.1 ms, is a rate that is 0.1 rad/s off there.

    The step after it, a hundred times longer, ends as fast as it goes on the whole.
    """
    integrator = begun(1e-8)
    driven(integrator, lambda t: 0.5 * t * t, [0.01] * 4 + [1e-4])
    driven(integrator, lambda t: 0.5 * t * t - 1e-5, [1e-4])
    rate = driven(integrator, lambda t: 0.5 * t * t, [0.01])[-1, 2]
    assert rate == pytest.approx(integrator.time, abs=0.01)


MASS = """
name = "mass"
dimension = 2
[inputs]
push = { unit = "N", interpolation = "smooth" }
[points]
P = { position = [0, 0], mass = 1 }
[forces]
force = { type = "force", point = "P", value = ["push", 0] }
[solver]
step_size = 1e-3
"""
"""Its velocity is the integral of its force."""


@pytest.mark.parametrize("growth", [1.2, 1.5, 2.0, 2.5, 3.0, 10.0])
@pytest.mark.parametrize("short", [1e-4, 1e-3, 0.02, 0.05, 0.099])
def test_a_smooth_input_that_jumps_in_a_short_step_stays_near_its_values(short, growth):
    """From 0 to 4 N: the mean force of no later step is farther than 1 N from 4 N, at any lengths.

    So far is the mean of a cubic that begins with the bound of its slope, 3 times 4 N over its
    step; 4/short, which the slope is at the end of the short step, may be as much as 40 kN/s.
    """
    after = [min(0.1, short * growth**k) for k in range(1, 8)]
    integrator = Integrator(solver.assemble(solver.loads(MASS)))
    integrator.initialise()
    for step, force in [(0.1, 0.0), (0.1 - short, 0.0), (short, 4.0), *((h, 4.0) for h in after)]:
        integrator["push"] = force
        before = integrator["P.vx"]
        integrator.advance(integrator.time, step)
        mean = (integrator["P.vx"] - before) / step
        assert 0.0 <= mean < 4.0 if step == short else abs(mean - force) <= 1.0


def test_a_smooth_input_is_constant_in_a_long_step_after_a_jump_in_a_short_one():
    """As an importer leaves it that takes a jump within its step: 40 kN/s for the values of 4 N."""
    integrator = Integrator(solver.assemble(solver.loads(MASS)))
    integrator.initialise()
    for step, force in [(0.1, 0.0), (1e-4, 4.0), (0.1, 4.0), (0.1, 4.0)]:
        integrator["push"] = force
        before = integrator["P.vx"]
        integrator.advance(integrator.time, step)
    assert (integrator["P.vx"] - before) / step == pytest.approx(4.0, abs=1e-9)


def test_a_driver_follows_a_smooth_input_whose_slope_is_bounded_after_a_jump():
    """Its rate jumps then as that of a ramp does, by an impulse."""
    integrator = begun(1e-8)
    for step, angle in [(0.1, 0.0), (1e-3, 0.1), (0.05, 0.1), (0.05, 0.1)]:
        integrator["u"] = angle
        integrator.advance(integrator.time, step)
        assert integrator["constraint.velocity"] < 1e-10
    assert integrator["A.angular_velocity"] == pytest.approx(0.0, abs=1e-9)
    assert integrator["motor.torque"] == pytest.approx(torque(np.array(0.1), 0.0), rel=1e-6)
