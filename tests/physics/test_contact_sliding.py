"""Friction of contacts: where sliding stops, turns, sticks and gives way, and what it takes.

References are closed forms with 40 digits (mpmath); for the rod and for the block thrown across an
incline, solutions in minimal coordinates by DOP853 with polished events.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from tests.support.contact.contact_events import begin, cover, even, events_of, number, times_of
from tests.support.contact.contact_scenes import (
    belt,
    bowling_ball,
    bowling_disc,
    incline,
    rod_that_falls,
    slider,
    two_on_a_spring,
)
from tests.support.contact.exact_contacts import rod_that_bounces
from tests.support.mechanisms.problems import GRAVITY, Content, mechanism, start

SLIDER_STOP, SLIDER_PLACE, SLIDER_LOSS = 0.509683995922528, 0.382262996941896, 1.125
BELT_FIRST_SLIP, BELT_SLIP_TIME, BELT_PERIOD = 0.25, 0.471238898038469, 0.671238898038469
BELT_LOSS, BELT_RIGHT = 0.402743338823081, 0.0582842712474619  # of a cycle; x at the farthest
DISC_ROLLS, DISC_PLACE = 0.509683995922528, 1.27420998980632
BALL_ROLLS, BALL_SPEED, BALL_SPIN = 1.16499199068006, 4.28571428571429, 39.6825396825397
BALL_PLACE, BALL_LOSS = 5.99138738064033, 5.14285714285714
ROD_HIT, ROD_TURN, ROD_END = 0.3248707931989, 0.4217270464735, 0.4374693840614
ROD_LOSS = 1.837397483959 + 0.1515135408489  # along and across the floor, until the far end hits
THROWN_STOP, THROWN_DOWN, THROWN_ACROSS = 0.34573831175214, 0.053474696351885, 0.11799314374224


@pytest.mark.parametrize("h", [0.1, 0.01, 0.007])
def test_a_slider_stops_and_stays(h):
    # Under a constant force steps are exact: round-off at every h.
    events = events_of(slider(), 1.0, h)
    assert times_of(events, "stick") == pytest.approx([SLIDER_STOP], abs=1e-13)
    integrator = begin(slider(), h)
    passed = cover(integrator, even(1.0, 0.1))
    assert integrator["p.x"] == pytest.approx(SLIDER_PLACE, abs=1e-15)
    assert integrator["p.vx"] == pytest.approx(0.0, abs=1e-16)
    assert integrator["floor.mode"] == 1.0
    assert integrator["floor.friction"] == pytest.approx(0.0, abs=1e-15)
    assert integrator["energy.friction"] == pytest.approx(SLIDER_LOSS, abs=1e-15)
    assert passed.error < 1e-15


def test_a_block_on_a_belt_sticks_and_slips_in_the_period_of_the_closed_form():
    # Order 6 at h = 0.02 s: 3.6e-11 s late in each cycle.
    events = events_of(belt(), 6.6, 0.02, order=6)
    slips, sticks = times_of(events, "slip"), times_of(events, "stick")
    expected = [BELT_FIRST_SLIP + i * BELT_PERIOD for i in range(10)]
    assert slips == pytest.approx(expected, abs=5e-10)
    assert sticks == pytest.approx([t + BELT_SLIP_TIME for t in expected[:9]], abs=5e-10)
    assert slips[9] == pytest.approx(6.29115008234622, abs=5e-10)


def test_a_cycle_of_stick_and_slip_takes_the_work_of_the_belt():
    # From one slip to the next the spring is as it was: the belt's work is what friction takes.
    integrator = begin(belt(), 0.01, 6)
    cover(integrator, [BELT_FIRST_SLIP, *even(BELT_FIRST_SLIP + BELT_PERIOD, 0.05, 0.25)])
    assert integrator["energy.friction"] == pytest.approx(BELT_LOSS, abs=1e-12)
    work = number(integrator, "energy.work")
    until_slip = 0.5 * 100.0 * 0.05**2  # of the spring, by the belt at the same speed
    assert work == pytest.approx(BELT_LOSS + until_slip, abs=1e-12)


def test_the_farthest_place_on_the_belt_is_that_of_the_closed_form():
    # The belt has carried the block to 0.05 m; it overshoots the middle of its swing at 0.03 m.
    integrator = begin(belt(), 0.01, 6)
    swing = math.hypot(0.02, 0.02)  # stretch over that of sliding, and speed over frequency
    cover(integrator, even(BELT_FIRST_SLIP + math.atan2(0.02, 0.02) / 10.0, 0.01))
    assert integrator["p.x"] == pytest.approx(0.03 + swing, abs=1e-12)
    assert 0.03 + swing == pytest.approx(BELT_RIGHT, abs=1e-15)
    assert integrator["p.vx"] == pytest.approx(0.0, abs=2e-12)


def test_a_disc_that_slides_begins_to_roll():
    events = events_of(bowling_disc(), 0.6, 0.01, order=6)
    assert times_of(events, "stick") == pytest.approx([DISC_ROLLS], abs=5e-13)
    integrator = begin(bowling_disc(), 0.01, 6)
    passed = cover(integrator, even(1.0, 0.1))
    assert integrator["d.vx"] == pytest.approx(2.0, abs=1e-12)
    assert abs(number(integrator, "d.angular_velocity")) == pytest.approx(8.0, abs=5e-12)
    place = DISC_PLACE + 2.0 * (1.0 - DISC_ROLLS)
    assert integrator["d.x"] == pytest.approx(place, abs=5e-12)
    assert integrator["energy.friction"] == pytest.approx(1.5, abs=1e-12)
    assert passed.error < 1e-13


@pytest.mark.parametrize("direction", [0.0, 0.3, math.pi / 2, 2.0])
def test_a_bowling_ball_begins_to_roll_in_any_direction(direction):
    # Slip in space counts as none below 1e-7 of the speeds of the mechanism, so it rolls 1e-7 s
    # early and no more: what then is left is booked. 1e-9 of place and speed is the order's.
    content = bowling_ball(direction)
    events = events_of(content, 1.3, 0.005, order=6)
    assert times_of(events, "stick") == pytest.approx([BALL_ROLLS], abs=2e-7)
    integrator = begin(content, 0.005, 6)
    passed = cover(integrator, even(1.5, 0.1))
    speed = math.hypot(number(integrator, "b.vx"), number(integrator, "b.vy"))
    assert speed == pytest.approx(BALL_SPEED, abs=5e-9)
    spin = math.hypot(number(integrator, "b.wx"), number(integrator, "b.wy"))
    assert spin == pytest.approx(BALL_SPIN, abs=5e-8)
    way = math.atan2(number(integrator, "b.vy"), number(integrator, "b.vx"))
    assert way == pytest.approx(direction, abs=1e-12)
    place = BALL_PLACE + BALL_SPEED * (1.5 - BALL_ROLLS)
    found = math.hypot(number(integrator, "b.x"), number(integrator, "b.y"))
    assert found == pytest.approx(place, abs=1e-8)
    assert integrator["energy.friction"] == pytest.approx(BALL_LOSS, abs=5e-9)
    assert passed.error < 1e-13
    assert passed.gap > -1e-14


def test_a_block_thrown_across_an_incline_curves_down_and_stops():
    # In space friction turns with the slip, which turns ever faster until the block stops. The stop
    # is called one at 1e-7 of its speed, with no effect on the place.
    content = incline(0.3, 0.5, [0.0, 1.0])
    events = events_of(content, 0.5, 0.01, order=6)
    assert times_of(events, "stick") == pytest.approx([THROWN_STOP], abs=1e-7)
    integrator = begin(content, 0.01, 6)
    passed = cover(integrator, even(1.0, 0.1))
    assert integrator["p.x"] == pytest.approx(-THROWN_DOWN, abs=2e-12)
    assert integrator["p.y"] == pytest.approx(THROWN_ACROSS, abs=2e-12)
    loss = 0.5 + 9.81 * math.sin(0.3) * THROWN_DOWN
    assert integrator["energy.friction"] == pytest.approx(loss, abs=5e-12)
    assert passed.error < 1e-13


@pytest.mark.parametrize("order", [2, 4])
def test_an_accelerating_belt_leaves_behind_what_friction_cannot_carry_along(order):
    # The belt goes with 2 t^2 m/s: it accelerates by more than c g from t = c g/4 on. The rate of
    # its speed is a difference over 5e-4 s.
    content = slider(0.0, 0.5)
    content["contacts"]["floor"]["surface_velocity"] = ["2*t**2", 0.0]
    events = events_of(content, 1.5, 0.05, order=order)
    assert [event.kind for event in events] == ["slip"]
    assert events[0].time == pytest.approx(0.125 * GRAVITY, abs=1e-10)


def test_a_rod_that_falls_hits_slides_turns_and_lands():
    # Its lower end slides, turns and slides the other way before the far end hits.
    events = events_of(rod_that_falls(), 0.438, 0.01, order=6)
    assert times_of(events, "hit", "A") == pytest.approx([ROD_HIT], abs=2e-13)
    assert times_of(events, "turn", "A") == pytest.approx([ROD_TURN], abs=2e-12)
    assert times_of(events, "hit", "B") == pytest.approx([ROD_END], abs=1e-12)
    integrator = begin(rod_that_falls(), 0.01, 6)
    passed = cover(integrator, [*even(0.43, 0.01), ROD_END - 1e-12])
    loss = number(integrator, "energy.impact") + number(integrator, "energy.friction")
    assert loss == pytest.approx(ROD_LOSS, abs=5e-12)
    centre = 0.5 * (number(integrator, "a.x") + number(integrator, "b.x"))
    assert centre == pytest.approx(0.0276348620904, abs=2e-12)
    assert passed.error < 1e-14


def test_a_rod_that_bounces_lands_on_its_far_end():
    # Its slip reverses in the impact: what friction takes depends on the path.
    content = rod_that_falls(0.5, 1.0)
    end, loss = rod_that_bounces()
    events = events_of(content, 0.43, 0.01, order=6)
    assert times_of(events, "hit", "A") == pytest.approx([ROD_HIT], abs=2e-13)
    assert times_of(events, "hit", "B") == pytest.approx([end], abs=1e-12)
    integrator = begin(content, 0.01, 6)
    cover(integrator, even(0.42, 0.01))
    assert integrator["energy.impact"] == pytest.approx(loss, abs=1e-12)
    assert integrator["energy.friction"] == 0.0


def test_a_flat_rod_comes_to_rest_with_all_its_energy_lost():
    # m g 0.8 m; the rod's ends hold the same thing twice then.
    integrator = begin(rod_that_falls(), 0.01, 4)
    passed = cover(integrator, even(0.8, 0.01))
    assert integrator["energy.dissipated"] == pytest.approx(0.8 * 9.81, abs=1e-10)
    assert passed.error < 1e-13
    assert passed.gap > -1e-14
    assert passed.loss >= 0.0


@pytest.mark.parametrize("stiffness", [1000.0, 5000.0, 8000.0, 50000.0])
@pytest.mark.parametrize("friction", [0.8, 1.2, 1.5])
def test_a_slip_in_space_may_stop_sooner_than_its_rate_says(stiffness, friction):
    # The spring swings in a piece, so that slip stops before the time that its rate at the start
    # of the piece leaves to it: the piece is cut, until it is solved.
    integrator = begin(two_on_a_spring(stiffness, friction, 0.02), 0.01)
    events = 0.0
    for _ in range(60):
        # A length of 1 m is rounded by 1e-16; the stiffest spring pulls with 1e3 N.
        assert cover(integrator, [integrator.time + 0.01]).error < 2e-13
        assert integrator["solver.stepped"] == 0.0
        events += number(integrator, "solver.events")
    assert events >= 6.0  # landings and stops


@pytest.mark.parametrize(("turn", "h", "order", "error"), [
    (2.0, 0.01, 2, 5e-5), (5.0, 0.01, 2, 5e-5), (20.0, 0.01, 2, 1e-4), (5.0, 0.003, 4, 1e-6),
    (20.0, 0.003, 4, 1e-6),
])  # fmt: skip
def test_a_ball_begins_to_slide_under_a_push_that_grows_and_turns_round(turn, h, order, error):
    """It rolls while 2/7 of the push are less than the cone; then s' = F/m - 7/2 mu g s/|s|."""
    mu, radius, growth = 0.3, 0.1, 20.0
    push = [f"{growth}*t*cos({turn}*t)", f"{growth}*t*sin({turn}*t)", 0.0]
    content = mechanism(
        "ball",
        3,
        bodies={"ball": {"mass": 1.0, "inertia": [0.004] * 3, "position": [0.0, 0.0, radius]}},
        contacts={
            "floor": {
                "type": "plane", "point": "ball", "radius": radius, "axis": [0, 0, 1],
                "friction": mu,
            }
        },
        forces={"push": {"type": "force", "point": "ball", "value": push}},
    )  # fmt: skip

    def force(t: float) -> np.ndarray:
        return growth * t * np.array([np.cos(turn * t), np.sin(turn * t)])

    def slope(t: float, y: np.ndarray) -> np.ndarray:  # slip, velocity, place
        rubs = mu * GRAVITY * y[:2] / np.linalg.norm(y[:2])
        return np.concatenate([force(t) - 3.5 * rubs, force(t) - rubs, y[2:4]])

    begins, end = 3.5 * mu * GRAVITY / growth, 1.0
    rolls = solve_ivp(
        lambda t, y: np.concatenate([5.0 / 7.0 * force(t), y[:2]]), (0.0, begins), np.zeros(4),
        rtol=1e-11, atol=1e-13,
    ).y[:, -1]  # fmt: skip
    first = np.concatenate([1e-9 * force(begins), rolls])
    exact = solve_ivp(slope, (begins, end), first, "Radau", rtol=1e-9, atol=1e-12).y[4:, -1]
    ran = start(content, h=h, order=order)
    ran.advance(0.0, end)
    assert [ran["ball.x"], ran["ball.y"]] == pytest.approx(exact, abs=error)
    assert float(ran["energy.error"]) < 1e-11


def ball_in_a_socket(friction: float) -> Content:
    """A body of 1 kg on a ball that turns in a socket with 1 mm of play."""
    return mechanism(
        "socket",
        3,
        points={"o": {"position": [0.0, 0.0, 0.0], "fixed": True}},
        bodies={
            "b": {
                "mass": 1.0, "inertia": [1e-3, 5e-3, 5e-3], "position": [0.3, 0.0, 0.0],
                "angular_velocity": [3.0, 1.0, 2.0], "points": {"e": [-0.3, 0.0, 0.0]},
            }
        },
        contacts={
            "c": {
                "type": "clearance", "points": ["b.e", "o"], "radius": 1e-3, "pin_radius": 0.01,
                "restitution": 0.0, "friction": friction,
            }
        },
    )  # fmt: skip


def increments_and_half_steps(friction: float) -> np.ndarray:
    """Newton's increments and half steps of 0.26 s."""
    ran = start(ball_in_a_socket(friction), h=0.001)
    counts = np.zeros(2)
    for step in range(26):
        ran.advance(0.01 * step, 0.01)
        counts += float(ran["solver.newton_iterations"]), float(ran["solver.substeps"])
    return counts


@pytest.mark.parametrize("friction", [0.005, 0.1, 0.5])
def test_slow_sliding_in_space_takes_few_more_increments_than_none(friction):
    # With 0.5 it creeps for long times at a hundredth of what friction changes in a step. Where a
    # slip turned its friction by a fixed part, increments shrank by a third: 2.4 times as many.
    smooth, rough = (increments_and_half_steps(x) for x in (0.0, friction))
    assert rough[0] < 1.7 * smooth[0]
    assert rough[1] < 1.1 * smooth[1]
