"""What is checked when the parameters have arrived: drawn lengths and the velocities of rods."""

from __future__ import annotations

import math

import pytest

import solver
from solver.scene import SceneError
from tests.support.kernel.twins import PENDULUM, model_of


def pendulum(angle: float, speed: float, along: float = 0.0) -> str:
    """Pendulum at an angle, moving across its rod with a speed and along it with another."""
    x, y = math.cos(angle), math.sin(angle)
    text = PENDULUM.replace("[0.6, -0.8]", str([x, y]))
    return text.replace("[0.8, 0.6]", str([along * x - speed * y, along * y + speed * x]))


@pytest.mark.parametrize("speed", [1e-3, 1.0, 1e3])
@pytest.mark.parametrize("angle", [0.1, 0.7, 2.0, 4.0])
def test_rounding_of_a_velocity_across_a_rod_does_not_contradict_it(angle, speed):
    """Its component along the rod is 1e-16 of the speed, and not zero."""
    assert model_of(pendulum(angle, speed)).sizes["n_rows"] == 1


@pytest.mark.parametrize("speed", [0.0, 1.0])
def test_a_velocity_along_a_rod_contradicts_it(speed):
    with pytest.raises(SceneError, match="the velocities of its points contradict it"):
        model_of(pendulum(0.7, speed, along=1e-6))


# --------------------------------------------------------------------- joints that do not close

PAIR = """
name = "pair"
dimension = 2
[bodies]
one = { position = [0, 0], mass = 1.0, inertia = 0.1, points = { end = [1, 0] } }
two = { position = [2, 0.3], mass = 1.0, inertia = 0.1, points = { end = [-1, 0] } }
[joints]
fixed = { type = "revolute", bodies = ["ground", "one"], position = [0, 0] }
meet = { type = "revolute", points = ["one.end", "two.end"] }
"""


def assemble(text: str) -> solver.Integrator:
    integrator = solver.Integrator(solver.assemble(solver.loads(text)))
    integrator.initialise()
    return integrator


def report(text: str) -> str:
    with pytest.raises(SceneError) as caught:
        assemble(text)
    return str(caught.value)


def test_places_that_are_drawn_apart_are_named_with_their_bodies_and_the_gap():
    text = report(PAIR)
    assert "joints.meet: its places on 'one.end' and 'two.end' are drawn 0.3 m apart" in text
    assert "assemble = true" in text
    assert text.count("error:") == 1


def test_assemble_closes_them_and_keeps_what_is_drawn_well():
    closed = assemble(PAIR + "[solver]\nassemble = true\n")
    assert closed["constraint.position"] < 1e-12
    assert closed["two.end.x"] == pytest.approx(float(closed["one.end.x"]), abs=1e-12)
    assert closed["one.x"] == pytest.approx(0.0, abs=1e-12)


def test_joints_that_fight_each_other_are_named_with_what_is_missing():
    far = PAIR.replace("[2, 0.3]", "[7, 0]")
    far += 'pin = { type = "revolute", bodies = ["ground", "two"], position = [7, 0] }\n'
    text = report(far + "[solver]\nassemble = true\n")
    assert "cannot be closed" in text
    assert all(f"joint '{name}' (" in text for name in ("fixed", "meet", "pin"))


def test_velocities_that_contradict_a_joint_are_named():
    text = PAIR.replace("[2, 0.3]", "[2, 0]").replace("two = {", "two = { velocity = [0, 0.5],")
    found = report(text)
    assert "joints.meet: the velocities of its parts contradict it, by 0.5 m/s" in found
    consistent = assemble(text + "[solver]\nassemble = true\n")
    assert consistent["constraint.velocity"] < 1e-12
    assert consistent["two.vy"] == pytest.approx(0.5, abs=1e-7)


def test_a_driver_that_starts_elsewhere_is_named():
    text = PAIR.replace("[2, 0.3]", "[2, 0]") + (
        '[drivers]\nmotor = { type = "angle", joint = "fixed", value = "0.2 + t" }\n'
    )
    found = report(text)
    assert "drivers.motor: the drawing is 0.2 off its value at the start" in found
    turned = assemble(text + "[solver]\nassemble = true\n")
    assert turned["fixed.angle"] == pytest.approx(0.2, abs=1e-12)
    assert turned["fixed.angular_velocity"] == pytest.approx(1.0, abs=1e-6)


def test_what_cannot_move_is_refused():
    text = """
name = "stuck"
[points]
A = { position = [0, 0, 0] }
P = { position = [1, 1, 1], mass = 1.0 }
[joints]
rod = { type = "distance", points = ["A", "ground"], at = [1, 0, 0] }
[drivers]
hand = { type = "position", point = "A", value = [0, 0, 0] }
"""
    assert "joints.rod: joins only parts that cannot move" in report(text)
