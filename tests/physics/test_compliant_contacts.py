"""Contacts that are forces: Hertz, Hunt and Crossley, Lankarani and Nikravesh."""

from __future__ import annotations

import math
from typing import Any

import pytest

from tests.support.contact.contact_events import begin, number
from tests.support.mechanisms.problems import Content, mechanism, observed_order

HUNT_CROSSLEY = {"law": "hunt-crossley", "stiffness": 1e6, "damping": 0.3}


def falling(law: dict[str, Any], height: float = 0.0, speed: float = 1.0) -> Content:
    """Point of 1 kg that comes down on the ground at a speed."""
    return mechanism(
        "bounce",
        2,
        points={"p": {"mass": 1.0, "position": [0.0, height], "velocity": [0.0, -speed]}},
        contacts={"floor": {"type": "plane", "point": "p", "axis": [0, 1]} | law},
    )


def rebound(content: Content, h: float, order: int = 2) -> float:
    """Upward speed at the height 0 after the first bounce, by the flight that follows."""
    integrator, steps = begin(content, h, order), 0
    while not (number(integrator, "floor.gap") > 0.0 and number(integrator, "p.vy") > 0.0):
        integrator.advance(integrator.time, h)
        assert number(integrator, "floor.force") >= 0.0
        assert number(integrator, "energy.error") < 1e-13
        steps += 1
        assert steps < 100_000
    return math.hypot(number(integrator, "p.vy"), math.sqrt(2.0 * 9.81 * number(integrator, "p.y")))


def test_sixty_hertzian_bounces_keep_the_energy():
    integrator = begin(falling({"law": "hertz", "stiffness": 1e6}, 0.2, 0.0), 1e-3)
    before, bounces, worst = 0.0, 0, 0.0
    while bounces < 60:
        integrator.advance(integrator.time, 1e-3)
        speed = number(integrator, "p.vy")
        bounces += before < 0.0 <= speed
        before, worst = speed, max(worst, number(integrator, "energy.error"))
    assert worst <= 1e-12
    assert integrator["energy.dissipated"] == 0.0


def test_the_rebound_of_hunt_and_crossley_is_of_second_order():
    # 0.8156594410286 by the reduced equation; as much energy is dissipated as the speeds tell.
    steps = [8e-5, 4e-5, 2e-5, 1e-5]
    errors = [abs(rebound(falling(HUNT_CROSSLEY), h) - 0.8156594410286) for h in steps]
    assert errors[2] < 1e-6
    assert observed_order(steps, errors) == pytest.approx(2.0, abs=0.1)


def test_what_hunt_and_crossley_take_is_what_the_motion_lost():
    integrator = begin(falling(HUNT_CROSSLEY), 1e-3)  # a step of a sixth of the impact
    for _ in range(30):
        integrator.advance(integrator.time, 1e-3)
    lost = 0.5 - number(integrator, "energy.total")
    assert integrator["energy.dissipated"] == pytest.approx(lost, rel=1e-13)
    assert lost > 0.1


@pytest.mark.parametrize("speed", [1.0, -1.0, 30.0])
@pytest.mark.parametrize("exponent", [1.0, 1.5, 2.0, 2.2])
def test_a_piece_of_a_nanosecond_dissipates_its_power_times_its_length(exponent, speed):
    """K depth^n a v^2, by the law. A rigid contact elsewhere lets steps be cut into pieces."""
    law = HUNT_CROSSLEY | {"exponent": exponent, "damping": 0.01}
    content = falling(law, -0.01, speed)
    content["points"]["q"] = {"mass": 1.0, "position": [5.0, 5.0]}
    content["contacts"]["far"] = {"type": "plane", "point": "q", "axis": [0, 1]}
    integrator = begin(content, 0.01)
    integrator.advance(0.0, 1e-9)
    power = 1e6 * 0.01**exponent * 0.01 * speed**2
    assert integrator["energy.dissipated"] == pytest.approx(1e-9 * power, rel=1e-12, abs=0.0)


@pytest.mark.parametrize("damping", [3.0, 100.0])
def test_a_strongly_damped_contact_never_pulls_and_only_takes_energy(damping):
    # The damping would pull while it opens faster than 1/damping.
    content = falling(HUNT_CROSSLEY | {"damping": damping})
    content["points"]["p"] |= {"velocity": [0.0, -2.0]}
    integrator, before = begin(content, 1e-4), 0.0
    for _ in range(2000):
        integrator.advance(integrator.time, 1e-4)
        taken = number(integrator, "energy.dissipated")
        assert number(integrator, "floor.force") >= 0.0
        assert taken >= before
        before = taken
    assert number(integrator, "energy.error") < 1e-12


def test_lankarani_and_nikravesh_rebound_with_their_restitution():
    # To the first order in 1 - e, at the speed for which the restitution is given.
    law = {"law": "lankarani-nikravesh", "stiffness": 1e8, "restitution": 0.95, "impact_speed": 1.0}
    assert rebound(falling(law), 1e-6, 4) == pytest.approx(0.95, abs=5e-3)
    loss = {"law": "hunt-crossley", "stiffness": 1e8, "damping": 0.75 * (1.0 - 0.95**2)}
    assert rebound(falling(law), 1e-5) == pytest.approx(rebound(falling(loss), 1e-5), rel=1e-12)


GEOMETRIES = {
    "balls": {"type": "sphere", "points": ["o", "p"], "radii": [0.2, 0.1]},
    "pin": {"type": "clearance", "points": ["p", "o"], "radius": 0.5},
    "rope": {"type": "stop", "points": ["o", "p"], "max": 0.5},
}


@pytest.mark.parametrize("dimension", [2, 3])
@pytest.mark.parametrize("name", GEOMETRIES)
def test_all_contacts_may_be_compliant(name, dimension):
    # A point about a fixed one, without gravity: energy and angular momentum about it tell.
    zero = [0.0] * (dimension - 2)
    law = {"law": "hunt-crossley", "stiffness": 2e4, "damping": 0.1}
    content = mechanism(
        "pair", dimension, gravity=False,
        points={
            "o": {"position": [0.0, 0.0, *zero], "fixed": True},
            "p": {"mass": 1.0, "position": [0.4, 0.05, *zero], "velocity": [-1.5, 0.3, *zero]},
        },
        contacts={"touch": GEOMETRIES[name] | law},
    )  # fmt: skip
    integrator, pressed = begin(content, 1e-3), 0.0
    word = "angular_momentum.z"
    momentum = number(integrator, word)
    for _ in range(1000):
        integrator.advance(integrator.time, 1e-3)
        assert number(integrator, "energy.error") < 1e-12
        assert number(integrator, word) == pytest.approx(momentum, abs=1e-13)
        force, gap = number(integrator, "touch.force"), number(integrator, "touch.gap")
        assert (force > 0.0) <= (gap < 0.0)
        pressed = max(pressed, force)
    assert pressed > 10.0
    assert number(integrator, "energy.dissipated") > 0.0


def test_a_pin_at_the_centre_of_its_hole_may_be_compliant():
    content = mechanism(
        "pin", 2,
        points={"o": {"position": [0, 0], "fixed": True}, "p": {"mass": 1.0, "position": [0, 0]}},
        contacts={
            "pin": {"type": "clearance", "points": ["p", "o"], "radius": 0.01, "law": "hertz",
                    "stiffness": 1e7}
        },
    )  # fmt: skip
    integrator = begin(content, 1e-4)
    for _ in range(5000):
        integrator.advance(integrator.time, 1e-4)
    assert number(integrator, "energy.error") < 1e-12


def test_compliant_and_rigid_contacts_live_together():
    # A ball on a soft pad over a rigid floor: the pad is pressed flat, and the ball rebounds of
    # the floor.
    content = falling(HUNT_CROSSLEY | {"stiffness": 100.0}, 0.05, 3.0)
    stop = {"type": "plane", "point": "p", "axis": [0, 1], "position": [0, -0.02]}
    content["contacts"]["bottom"] = stop | {"restitution": 0.5}
    integrator = begin(content, 1e-3)
    for _ in range(3000):
        integrator.advance(integrator.time, 1e-3)
        assert number(integrator, "energy.error") < 1e-12
        assert number(integrator, "bottom.gap") >= -1e-12
    assert number(integrator, "bottom.impacts") >= 2.0
    assert number(integrator, "energy.impact") > 1.0
    assert number(integrator, "energy.damping") > 1e-3


@pytest.mark.parametrize("pressed", [0.0, 1e-17, 1e-14, 1e-12, 1e-8])
def test_a_step_that_begins_in_the_least_penetration_closes_its_ledger(pressed):
    content = mechanism(
        "ball",
        3,
        points={"ball": {"mass": 1.0, "position": [0, 0, -pressed], "velocity": [0, 0, -4.43]}},
        contacts={
            "floor": {
                "type": "plane", "point": "ball", "axis": [0, 0, 1], "law": "hertz",
                "stiffness": 1e6,
            }
        },
    )  # fmt: skip
    run = begin(content, 3e-4)
    run.advance(run.time, 3e-4)
    assert number(run, "energy.error") <= 1e-15
