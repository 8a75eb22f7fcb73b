"""Friction of contacts: what rolls goes on rolling, and what touches keeps its momenta together."""

from __future__ import annotations

import json

import numpy as np
import pytest

import solver
from tests.support.contact.contact_events import begin
from tests.support.mechanisms.problems import Content, mechanism

ROLLING = {
    2: """
dimension = 2
gravity = [0, -9.81]
[bodies]
ball = { position = [0, 0.1], mass = 1, inertia = 0.004, velocity = [4, 0], angular_velocity = -40 }
[contacts]
floor = { type = "plane", point = "ball", axis = [0, 1], radius = 0.1, friction = 0.2 }
""",
    3: """
gravity = [0, 0, -9.81]
[bodies]
ball = { position = [0, 0, 0.1], mass = 1, inertia = [0.004, 0.004, 0.004], velocity = [4, 0, 0], angular_velocity = [0, 40, 0] }
[contacts]
floor = { type = "plane", point = "ball", axis = [0, 0, 1], radius = 0.1, friction = 0.2 }
""",  # noqa: E501
}
DISCS = """
name = "discs"
dimension = 2
[bodies]
a = { position = [0, 0], mass = 1, inertia = 0.01, velocity = [1, 0], angular_velocity = 20 }
b = { position = [0.5, 0.05], mass = 2, inertia = 0.05, angular_velocity = -3 }
[contacts]
pair = { type = "sphere", points = ["a", "b"], radii = [0.1, 0.2], friction = 0.3, restitution = 0.4 }
"""  # noqa: E501
PINS = """
name = "pin"
dimension = 2
[bodies]
a = { position = [0, 0], mass = 1, inertia = 0.01, velocity = [1, 0], angular_velocity = 20 }
b = { position = [0, 0], mass = 2, inertia = 0.05, angular_velocity = -3 }
[contacts]
bearing = { type = "clearance", points = ["a", "b"], radius = 0.01, pin_radius = 0.05, friction = 0.3 }
"""  # noqa: E501
BALLS = """
name = "balls"
[bodies]
a = { position = [0, 0, 0], mass = 1, inertia = [0.01, 0.01, 0.01], velocity = [1, 0, 0], angular_velocity = [3, -9, 20] }
b = { position = [0.5, 0.05, 0.1], mass = 2, inertia = [0.05, 0.06, 0.07], angular_velocity = [1, 2, -3] }
[contacts]
pair = { type = "sphere", points = ["a", "b"], radii = [0.1, 0.2], friction = 0.3, restitution = 0.4 }
"""  # noqa: E501
SOCKET = """
name = "socket"
[bodies]
a = { position = [0, 0, 0], mass = 1, inertia = [0.01, 0.01, 0.01], velocity = [1, 0.2, 0], angular_velocity = [3, -9, 20] }
b = { position = [0, 0, 0], mass = 2, inertia = [0.05, 0.06, 0.07], angular_velocity = [1, 2, -3] }
[contacts]
bearing = { type = "clearance", points = ["a", "b"], radius = 0.01, pin_radius = 0.05, friction = 0.3 }
"""  # noqa: E501


@pytest.mark.parametrize("step", [0.002, 0.01, 0.03])
@pytest.mark.parametrize("dimension", [2, 3])
def test_a_ball_that_rolls_goes_on_rolling_without_slip_at_any_step(dimension, step):
    """A turn of 1.2 rad in the longest step; only rounding is left of the slip rate."""
    text = f'name = "ball"\n{ROLLING[dimension]}[solver]\nstep_size = {step}\n'
    found = solver.simulate(solver.loads(text + f"[experiment]\nstep_size = {step}\n"))
    assert np.abs(found["floor.slip"]).max() < 1e-9
    assert found["ball.vx"] == pytest.approx(4.0, abs=1e-9)
    assert np.abs(found["floor.friction"]).max() < 1e-7
    assert found["energy.friction"][-1] == pytest.approx(0.0, abs=1e-12)


@pytest.mark.parametrize(
    "text", [DISCS, PINS, BALLS, SOCKET], ids=["discs", "pin", "balls", "socket"]
)
def test_what_touches_and_rubs_keeps_momentum_and_angular_momentum(text):
    found = solver.simulate(solver.loads(text))
    touched = found["energy.impact"][-1] + found["energy.friction"][-1]
    assert touched > 0.01
    for word in [name for name in found.names if "momentum." in name]:
        assert np.ptp(found[word]) < 1e-12
    assert np.abs(found["energy.balance"]).max() < 1e-12


def sliding_box(friction: float) -> Content:
    """A box slides on four corners."""
    size = [0.4, 0.3, 0.2]
    shape = {"type": "box", "size": size, "density": 1000.0}
    floor = {"type": "corners", "body": "b", "size": size, "axis": [0, 0, 1], "friction": friction}
    box = {"position": [0, 0, 0.1], "velocity": [1, 0.3, 0], "shape": shape}
    return mechanism("box", 3, bodies={"b": box}, contacts={"floor": floor})


def test_friction_that_lets_nothing_slide_stops_what_slides_whatever_its_coefficient():
    """The box tips over its front corner at once: coefficients of 10 to 1e10 are as good."""
    ends = []
    for friction in (10.0, 1e3, 1e6, 1e10):
        integrator = begin(sliding_box(friction))
        integrator.advance(0.0, 0.03)
        ends.append([integrator[f"b.{name}"] for name in ("x", "y", "z", "vx", "vy", "vz")])
    assert np.ptp(ends, axis=0) == pytest.approx(np.zeros(6), abs=1e-9)


def test_friction_beyond_all_digits_is_said():
    """With a coefficient of 1e12 no force of sliding has a digit left."""
    said: list[str] = []
    model = solver.assemble(solver.loads(json.dumps(sliding_box(1e12)), format="json"))
    integrator = solver.Integrator(model, log=said.append)
    integrator.initialise()
    assert integrator["solver.newton_impacts"] == 1.0
    assert any("1 impact at the start has Newton's restitution" in line for line in said)
    assert integrator["energy.kinetic"] < 0.5 * 24.0 * (1.0**2 + 0.3**2)
    stepped = begin(sliding_box(1e12), contact_mode="stepped")
    with pytest.raises(
        solver.StepError, match="contact 'floor': a friction of 1e\\+12 is so strong"
    ):
        stepped.advance(0.0, 0.01)
