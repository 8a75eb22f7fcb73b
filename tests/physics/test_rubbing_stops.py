"""Stops along an axis that rub as what they hold turns: of joints, and of journals, by hand."""

from __future__ import annotations

import math

import pytest

from tests.physics.test_bodies_with_shapes import run
from tests.support.mechanisms.problems import GRAVITY, Content, mechanism

MASS, INERTIA, RADIUS, FRICTION, SPIN = 3.0, 0.02, 0.05, 0.2, 6.0
SLOWING = FRICTION * MASS * GRAVITY * RADIUS / INERTIA
"""Angular deceleration by a collar that carries the weight [rad/s^2]."""


def shaft(kind: str, height: float = 0.0, **more: float) -> Content:
    """A vertical shaft on a stop below its joint, or on the collar of its bearing."""
    body = {
        "mass": MASS, "inertia": [0.05, 0.05, INERTIA], "position": [0, 0, height],
        "angular_velocity": [0, 0, SPIN],
    }  # fmt: skip
    content = mechanism("shaft", 3, bodies={"shaft": body})
    if kind == "stop":
        content["joints"] = {
            "guide": {
                "type": "cylindrical", "bodies": ["ground", "shaft"], "position": [0, 0, 0],
                "axis": [0, 0, 1],
            }
        }  # fmt: skip
        stop = {"type": "stop", "joint": "guide", "of": "displacement", "min": -height}
        content["contacts"] = {"c": stop | {"friction": FRICTION, "radius": RADIUS} | more}
    else:
        content["contacts"] = {
            "c": {
                "type": "journal", "bodies": ["ground", "shaft"], "position": [0, 0, 0],
                "axis": [0, 0, 1], "length": 0.2, "radius": 1e-3, "axial_play": height or 1e-3,
                "friction": FRICTION, "collar_radius": RADIUS,
            } | more
        }  # fmt: skip
        if not height:
            body["position"] = [0, 0, 0]
    return content


@pytest.mark.parametrize("h", [0.003, 0.02])
def test_a_shaft_on_a_rubbing_stop_slows_down_evenly_and_stands_still(h):
    """At J w/(mu m g r), after half of that time times w; all its energy is lost by friction."""
    time = SPIN / SLOWING
    for share in (0.5, 1.5):
        ran = run(shaft("stop"), share * time, h=h)
        left = max(0.0, 1.0 - share)
        assert ran["guide.angular_velocity"] == pytest.approx(left * SPIN, abs=1e-9)
        turned = 0.5 * SPIN * time * (1.0 - left * left)
        # a turn phi in a step has the velocity 2 tan(phi/2)/h
        assert ran["guide.angle"] == pytest.approx(turned, rel=(SPIN * h) ** 2 / 12.0)
        lost = 0.5 * INERTIA * SPIN**2 * (1.0 - left * left)
        # rates of rows that hold, of order 2, keep a share (w h)^4 of the energy
        assert ran["energy.friction"] == pytest.approx(lost, rel=(SPIN * h) ** 4 / 100.0)
        assert ran["c.force"] == pytest.approx(MASS * GRAVITY, rel=1e-9)


def test_a_shaft_that_lands_on_a_rubbing_stop_loses_spin_by_the_impulse():
    """J dw = -mu r m v, with v the speed of the fall."""
    height = 0.02
    ran = run(shaft("stop", height), math.sqrt(2.0 * height / GRAVITY) + 1e-7, h=0.01)
    speed = math.sqrt(2.0 * GRAVITY * height)
    spin = SPIN - FRICTION * RADIUS * MASS * speed / INERTIA
    assert ran["c.impacts"] == 1.0
    assert ran["guide.angular_velocity"] == pytest.approx(spin, abs=1e-5)


def test_the_collar_of_a_journal_slows_it_down_once_it_has_landed():
    """It falls by the play, lands, and turns on with what the impulse leaves, more slowly."""
    play = 1e-3
    fall, speed = math.sqrt(2.0 * play / GRAVITY), math.sqrt(2.0 * play * GRAVITY)
    spin = SPIN - FRICTION * RADIUS * MASS * speed / INERTIA
    ran = run(shaft("journal"), fall + 0.2, h=0.005)
    assert ran["shaft.z"] == pytest.approx(-play, abs=1e-12)
    assert ran["shaft.wz"] == pytest.approx(spin - 0.2 * SLOWING, rel=2e-4)
    assert ran["c.force"] == pytest.approx(MASS * GRAVITY, rel=1e-9)


def test_a_stop_holds_a_shaft_against_a_torque_below_its_cone():
    """And lets it turn by the torque above it: J w' = T - mu m g r."""
    limit = FRICTION * MASS * GRAVITY * RADIUS
    for share in (0.95, 1.05):
        content = shaft("stop")
        content["bodies"]["shaft"]["angular_velocity"] = [0, 0, 0]
        torque = {"type": "torque", "body": "shaft", "value": [0, 0, share * limit]}
        content["forces"] = {"motor": torque}
        ran = run(content, 1.0, h=0.01)
        expected = max(0.0, share - 1.0) * limit / INERTIA
        assert ran["guide.angular_velocity"] == pytest.approx(expected, abs=1e-9)
