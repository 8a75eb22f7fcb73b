"""Friction of joints against closed forms and an integration of the reduced equations."""

from __future__ import annotations

import math

import numpy as np
import pytest

import solver

PENDULUM = """
name = "pendulum"
dimension = 2
gravity = [0, -9.81]
[bodies]
arm = {{ position = [{x}, {y}], mass = 1, inertia = 1e-9 }}
[joints]
pin = {{ type = "revolute", bodies = ["ground", "arm"], position = [0, 0], friction = {friction} }}
[solver]
order = 4
step_size = 0.005
[experiment]
stop_time = 10
step_size = 0.005
"""


def pendulum(angle: float, friction: str) -> solver.Trajectory:
    text = PENDULUM.format(x=math.sin(angle), y=-math.cos(angle), friction=friction)
    return solver.simulate(solver.loads(text))


def test_a_journal_takes_the_swing_of_a_pendulum_that_the_reduced_equation_has():
    """Of T = 0.03 m (L w^2 + g cos a): DOP853 with events of its own, 14 digits.

    There the force along the rod alone makes the torque. Here the force that the torque itself
    needs across the rod, T/L, counts as well: T = k N/sqrt(1 - k^2) if N is that along the rod.
    The inertia of 1e-9 kg.m2 is what a body in the plane needs.
    """
    k = 0.03 / math.sqrt(1.0 + 0.03**2)
    found = pendulum(1.2, f"{{ coefficient = {k / 0.2!r}, radius = 0.2 }}")
    assert found["pin.angle"][-1] + 1.2 == pytest.approx(0.07226720019556, abs=2e-8)
    assert found["pin.slip"][-1] == pytest.approx(1.144543504028, abs=2e-8)
    assert found["energy.friction"][-1] == pytest.approx(5.574675059958, abs=2e-8)
    assert np.sum(found["solver.events"]) == 9  # turns
    assert np.abs(found["energy.balance"]).max() < 1e-13


def test_a_preload_holds_a_pendulum_up_to_its_torque():
    held = pendulum(0.1, f"{{ preload = {1.001 * 9.81 * math.sin(0.1)}, radius = 0.1 }}")
    assert np.abs(held["pin.angle"]).max() < 1e-12
    assert set(held["pin.friction_mode"]) == {1.0}
    assert held["pin.friction"][-1] == pytest.approx(9.81 * math.sin(0.1))
    loose = pendulum(0.1, f"{{ preload = {0.999 * 9.81 * math.sin(0.1)}, radius = 0.1 }}")
    assert np.abs(loose["pin.angle"]).max() > 1e-4


@pytest.mark.parametrize("settings", ["tolerance = 1e-6", "order = 4\nstep_size = 0.005"])
@pytest.mark.parametrize("inertia", ["1e-10", "1e-9", "1e-6"])
def test_a_tiny_inertia_leaves_the_friction_that_holds_as_it_is(inertia, settings):
    """Of moments about the pin, T = m g l sin a; pin and friction share none of it."""
    text = PENDULUM.format(
        x=math.sin(0.1), y=-math.cos(0.1), friction="{ preload = 1.0, radius = 0.1 }"
    )
    text = text.replace("order = 4\nstep_size = 0.005", settings).replace("1e-9", inertia)
    held = solver.simulate(solver.loads(text), stop_time=0.1)
    assert held["pin.friction"][-1] == pytest.approx(9.81 * math.sin(0.1), rel=1e-6)
    assert held["pin.force.y"][-1] == pytest.approx(9.81, rel=1e-6)


def test_a_sled_stops_where_friction_has_taken_its_energy():
    text = """
name = "sled"
dimension = 2
gravity = [0, -9.81]
[bodies]
sled = { position = [0, 0], mass = 2, inertia = 1, velocity = [1.5, 0] }
[joints]
rail = { type = "prismatic", bodies = ["ground", "sled"], axis = [1, 0], friction = { coefficient = 0.3, preload = 0.2 } }
"""  # noqa: E501
    found = solver.simulate(solver.loads(text))
    force = 0.3 * 2 * 9.81 + 0.2
    assert found["rail.displacement"][-1] == pytest.approx(1.5**2 / force, abs=1e-12)
    assert found["energy.friction"][-1] == pytest.approx(1.5**2, abs=1e-12)
    assert found["rail.friction"][1] == pytest.approx(-force)
    assert found["rail.friction_mode"][-1] == 1.0
