"""Contacts that would be passed within one step: gaps that dip below zero and open again."""

from __future__ import annotations

import math

import pytest

from tests.support.contact.contact_events import begin, cover, even, events_of, number, times_of
from tests.support.contact.contact_scenes import ORIGIN, circle, pendulum_at_a_stop, slider
from tests.support.mechanisms.problems import GRAVITY, Content, mechanism


def ceiling(depth: float, restitution: float = 0.5) -> Content:
    """Point thrown up at 2 m/s towards a ceiling that is a depth below the top of its flight."""
    top = 0.5 * 2.0**2 / GRAVITY
    return mechanism(
        "ceiling",
        2,
        points={"p": {"mass": 1.0, "position": [0.0, 0.0], "velocity": [0.0, 2.0]}},
        contacts={
            "ceiling": {
                "type": "plane",
                "point": "p",
                "axis": [0, -1],
                "position": [0.0, top - depth],
                "restitution": restitution,
            }
        },
    )


@pytest.mark.parametrize("order", [2, 4, 6])
@pytest.mark.parametrize("h", [0.5, 0.4, 0.05])
@pytest.mark.parametrize("depth", [0.1, 1e-2, 1e-4, 1e-6, 1e-9, 1e-12])
def test_a_ball_that_would_fall_back_within_the_step_hits_the_ceiling(depth, h, order):
    # The cubic through gaps and rates is the parabola itself, so any depth beyond round-off of the
    # gap, 1e-15 m, is found. The time of a hit at a speed w has this over w.
    speed = math.sqrt(2.0 * GRAVITY * depth)
    hit = (2.0 - speed) / GRAVITY
    settings = {"order": order, "rest_speed": 1e-9}
    events = events_of(ceiling(depth), 0.5, h, **settings)
    assert [e.kind for e in events] == ["hit"]
    assert events[0].time == pytest.approx(hit, abs=1e-14 + 2e-15 / speed)
    integrator = begin(ceiling(depth), h, **settings)
    passed = cover(integrator, [0.5])
    height = 0.5 * 2.0**2 / GRAVITY - depth
    t = 0.5 - hit
    height += -0.5 * speed * t - 0.5 * GRAVITY * t * t
    assert integrator["p.y"] == pytest.approx(height, abs=1e-14 + 2e-15 / speed)
    assert integrator["energy.impact"] == pytest.approx(0.375 * speed**2, abs=1e-14)
    assert passed.error < 1e-14


@pytest.mark.parametrize("h", [0.5, 0.4, 0.05])
@pytest.mark.parametrize("distance", [1e-2, 1e-6, 1e-9, 1e-12])
def test_a_ball_that_does_not_reach_the_ceiling_flies_on(distance, h):
    integrator = begin(ceiling(-distance), h, rest_speed=1e-9)
    cover(integrator, [0.5])
    assert integrator["ceiling.impacts"] == 0.0
    assert integrator["solver.events"] == 0.0
    assert integrator["p.y"] == pytest.approx(1.0 - 0.5 * GRAVITY * 0.25, abs=1e-15)


def test_a_ball_that_just_touches_the_ceiling_keeps_its_energy():
    # Whether this is a hit is for round-off to say: 1e-15 m below the top the ball has 1.4e-7 m/s,
    # which a hit without rebound takes, and is 4e-8 m lower at the end.
    for h in (0.5, 0.4, 0.05):
        integrator = begin(ceiling(0.0), h)
        passed = cover(integrator, [0.5])
        assert integrator["p.y"] == pytest.approx(1.0 - 0.5 * GRAVITY * 0.25, abs=1e-7)
        assert integrator["energy.impact"] == pytest.approx(0.0, abs=1e-14)
        assert passed.error < 1e-14


def passing(offset: float) -> Content:
    """Point that flies at 1 m/s past a fixed ball of 1 m, its line at an offset from the centre."""
    return mechanism(
        "passing",
        2,
        gravity=False,
        points={
            "o": ORIGIN,
            "p": {"mass": 1.0, "position": [-0.5, offset], "velocity": [1.0, 0.0]},
        },
        contacts={"ball": {"type": "sphere", "points": ["o", "p"], "radii": [1.0, 0.0]}},
    )


@pytest.mark.parametrize("order", [2, 4])
@pytest.mark.parametrize("h", [0.2, 0.1, 0.033])
@pytest.mark.parametrize("depth", [1e-2, 1e-3, 2e-5])
def test_a_point_that_flies_past_a_ball_touches_it(depth, h, order):
    # It is within the ball for 2 sqrt(2 depth) s, 13 ms at the least. The cubic is off by less than
    # 3 h^4/384 = 1.3e-5 m, the fourth derivative of the distance being 3 m/s4.
    offset = 1.0 - depth
    hit = 0.5 - math.sqrt(1.0 - offset**2)
    events = events_of(passing(offset), 0.9, h, order=order)
    speed = math.sqrt(1.0 - offset**2)  # towards the centre
    assert times_of(events, "hit")[0] == pytest.approx(hit, abs=1e-14 + 2e-15 / speed)
    integrator = begin(passing(offset), h, order)
    cover(integrator, even(0.9, h))
    assert integrator["energy.impact"] == pytest.approx(0.5 * speed**2, abs=1e-14)


@pytest.mark.parametrize("h", [0.2, 0.1, 0.033])
def test_a_point_that_flies_past_a_ball_at_a_distance_does_not_touch_it(h):
    integrator = begin(passing(1.0 + 2e-5), h)
    cover(integrator, even(0.9, h))
    assert integrator["ball.impacts"] == 0.0
    assert integrator["p.y"] == 1.0 + 2e-5


def swinging(stop: float) -> Content:
    """Pendulum let go at 0.3 rad, with a stop at an angle from there."""
    content = pendulum_at_a_stop()
    content["bodies"]["bob"]["position"] = [0.5 * math.sin(0.3), -0.5 * math.cos(0.3)]
    content["contacts"]["limit"] |= {"min": stop, "restitution": 1.0}
    return content


@pytest.mark.parametrize("beyond", [1e-2, 1e-4, 1e-6])
def test_a_pendulum_that_swings_a_little_too_far_touches_its_stop(beyond):
    # Steps keep the energy, and with it how far it swings: 0.6 rad, to the same height. It is
    # beyond the stop for 1.7 ms at the least. The cubic is off by 2e-7 rad, h^4/384 of 28 rad/s4.
    integrator = begin(swinging(-0.6 + beyond), 0.04, rest_speed=1e-9)
    passed = cover(integrator, even(1.6, 0.04))
    assert integrator["limit.impacts"] == 1.0
    assert passed.gap > -1e-14


@pytest.mark.parametrize("short", [1e-2, 1e-5, 1e-8, 1e-11])
def test_a_pendulum_that_does_not_reach_its_stop_does_not_touch_it(short):
    integrator = begin(swinging(-0.6 - short), 0.04, rest_speed=1e-9)
    cover(integrator, even(1.6, 0.04))
    assert integrator["limit.impacts"] == 0.0


def test_hits_that_get_ever_closer_within_one_step_are_found():
    # Hits of a circle are as near as 1.4 ms, all of them within one step of 0.1 s.
    events = events_of(circle(0.5), 2.0, 0.1, order=4, rest_speed=1e-2)
    assert len(times_of(events, "hit")) == 10


def pushed(speed: float) -> Content:
    """Block that slides while a force of a frequency slows it down and speeds it up again."""
    return slider(speed, 0.01) | {
        "forces": {"push": {"type": "force", "point": "p", "value": ["4*sin(4*(t - 0.5))", 0.0]}}
    }


@pytest.mark.parametrize("h", [0.2, 0.1, 0.05, 0.01])
def test_slip_that_stops_and_starts_again_within_a_step_turns_twice(h):
    # The speed is below 0 for 28 ms about 0.5 s, in the middle of a step of 0.2 s. Friction of
    # 0.0981 N is too weak to hold the block there. 0.6085 m/s is the limit of small steps.
    events = events_of(pushed(1.46), 0.8, h)
    assert [e.kind for e in events] == ["turn", "turn"]
    integrator = begin(pushed(1.46), h)
    passed = cover(integrator, even(0.8, h))
    assert number(integrator, "p.vx") == pytest.approx(0.6085, abs=1.5 * h**2 * 0.6)
    assert passed.loss > 0.0
