"""Events wherever they fall: at the start, at and around communication points, many at once."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tests.support.contact.contact_events import begin, cover, even, events_of, number, times_of
from tests.support.contact.contact_scenes import (
    ball,
    belt,
    cam,
    circle,
    point_on_a_ball,
    rod_that_falls,
    slider,
    slider_crank_with_clearance,
)
from tests.support.mechanisms.problems import GRAVITY, Content, mechanism

HALF_SECOND = 0.5 * GRAVITY * 0.5**2
"""Height from which a fall takes 0.5 s."""


def fall_and_rebound(t: float, hit: float, restitution: float) -> float:
    """Height at a time after the first hit and before the second one."""
    return restitution * GRAVITY * hit * (t - hit) - 0.5 * GRAVITY * (t - hit) ** 2


# -------------------------------------------------------------------------- communication points


@pytest.mark.parametrize("step", [0.5, 0.25, 0.1, 0.05])
def test_an_impact_at_a_communication_point_counts_once(step):
    integrator = begin(ball(HALF_SECOND), 0.05)
    passed = cover(integrator, even(1.0, step))
    assert integrator["floor.impacts"] == 1.0
    assert integrator["p.y"] == pytest.approx(fall_and_rebound(1.0, 0.5, 0.8), abs=1e-14)
    loss = 0.5 * (1.0 - 0.8**2) * (GRAVITY * 0.5) ** 2
    assert integrator["energy.impact"] == pytest.approx(loss, abs=1e-14)
    assert passed.gap > -1e-15


AROUND = [0.0] + [sign * x for sign in (-1.0, 1.0) for x in (1e-16, 1e-15, 1e-13, 1e-11, 1e-9)]


@pytest.mark.parametrize(
    ("make", "h", "contact"),
    [
        (ball, 0.02, "floor"),
        (lambda: circle(0.5), 0.02, "wall"),
        (slider_crank_with_clearance, 4e-4, "pin"),
        (rod_that_falls, 0.02, "A"),
        (lambda: rod_that_falls(0.5, 1.0), 0.02, "A"),
    ],
    ids=["ball", "circle", "slider-crank", "rod", "rod that bounces"],
)
def test_a_communication_step_may_end_during_an_impact(make, h, contact):
    # Ends from 1 ns before to 1 ns after it. What follows agrees with the run that has none there,
    # but for the steps of order 4 behind it, which are cut elsewhere.
    content = make()
    hit = times_of(events_of(content, 50.0 * h if h < 0.01 else 0.5, h, order=4), "hit")[0]
    before, after = math.floor(hit / h) * h, (math.floor(hit / h) + 2) * h
    names = ["energy.kinetic", "energy.potential", "energy.impact"]
    reference = begin(content, h, 4)
    cover(reference, [*even(before, h), after])
    expected = [number(reference, name) for name in names]
    for x in AROUND:
        integrator = begin(content, h, 4)
        passed = cover(integrator, [*even(before, h), hit + x])
        if abs(x) > 2e-15:
            assert integrator[f"{contact}.impacts"] == (x > 0.0)
        passed_later = cover(integrator, [after])
        assert integrator[f"{contact}.impacts"] == 1.0
        assert [number(integrator, name) for name in names] == pytest.approx(expected, rel=1e-8)
        assert max(passed.error, passed_later.error) < 1e-13
        assert min(passed.gap, passed_later.gap) > -1e-14


def test_a_communication_step_may_end_during_a_release_that_a_driver_brings_about():
    # The follower lifts off once, without a hit; the ledger stays closed at every end.
    release = times_of(events_of(cam(), 0.04, 1e-3, order=2), "open")[0]
    for x in AROUND:
        integrator = begin(cam(), 1e-3)
        passed = cover(integrator, [*even(0.03, 1e-3), release + x, 0.031])
        assert passed.error < 1e-11
        assert integrator["lifter.impacts"] == 0.0
        assert integrator["lifter.mode"] == 0.0


@pytest.mark.parametrize(("h", "order"), [(0.01, 2), (0.02, 4), (0.04, 6)])
def test_a_contact_that_is_let_go_just_before_a_communication_point_is_open_there(h, order):
    # Once, at every end from 1 ns to 0.3 us behind the release.
    content = point_on_a_ball()
    release = times_of(events_of(content, 0.8, h, order=order), "open")[0]
    integrator = begin(content, h, order)
    cover(integrator, even(math.floor(release / h) * h, h))
    saved = integrator.save()
    for behind in np.geomspace(1e-9, 3e-7, 40):
        integrator.restore(saved)
        cover(integrator, [release + behind])
        assert integrator["solver.events"] == 1.0
        assert integrator["top.mode"] == 0.0


@pytest.mark.parametrize(("h", "order"), [(0.02, 2), (0.02, 6), (0.05, 6)])
def test_the_ledger_closes_wherever_a_communication_step_ends_about_a_slip(h, order):
    # The belt works on the block in pieces of every length, down to 1e-14 s.
    integrator = begin(belt(), h, order)
    cover(integrator, even(0.2, h))
    saved = integrator.save()
    for apart in np.geomspace(1e-14, 1e-2, 40):
        for end in (0.25 - apart, 0.25 + apart):
            integrator.restore(saved)
            assert cover(integrator, [end, 0.3]).error < 1e-12


@pytest.mark.parametrize(
    ("make", "until", "h", "contact", "hits"),
    [
        (ball, 2.0, 0.05, "floor", 3),
        (ball, 5.0, 0.05, "floor", 49),
        (lambda: circle(0.5), 2.0, 0.05, "wall", 17),
        (slider_crank_with_clearance, 0.02, 4e-4, "pin", 9),
    ],
    ids=["ball", "ball at rest", "circle", "slider-crank"],
)
def test_one_long_communication_step_is_many_short_ones(make, until, h, contact, hits):
    # Internal steps are the same ones, so what differs is round-off; hits amplify it.
    content = make()
    names = ["energy.kinetic", "energy.potential", "energy.impact"]
    rows = []
    for steps in (1, 2, round(until / h)):
        integrator = begin(content, h)
        passed = cover(integrator, even(until, until / steps))
        assert integrator[f"{contact}.impacts"] == hits
        assert passed.error < 1e-13
        rows.append([number(integrator, name) for name in names])
    assert rows[1] == pytest.approx(rows[0], abs=1e-10)
    assert rows[2] == pytest.approx(rows[0], abs=1e-10)


# ------------------------------------------------------------------------------------- the start


def test_a_point_drawn_on_the_floor_that_approaches_it_hits_at_the_start():
    integrator = begin(ball(0.0, 0.8, -1.0), 0.05)
    assert integrator["p.vy"] == pytest.approx(0.8, abs=1e-15)
    assert integrator["floor.impacts"] == 1.0
    assert integrator["floor.mode"] == 0.0
    assert integrator["energy.impact"] == pytest.approx(0.5 * 0.36, abs=1e-15)
    assert number(integrator, "energy.error") < 1e-15
    cover(integrator, even(0.1, 0.05))
    assert integrator["p.y"] == pytest.approx(0.08 - 0.5 * GRAVITY * 0.01, abs=1e-15)
    assert integrator["floor.impacts"] == 1.0


def test_a_point_drawn_on_the_floor_that_leaves_it_flies():
    integrator = begin(ball(0.0, 0.8, 1.0), 0.05)
    assert integrator["floor.mode"] == 0.0
    cover(integrator, even(0.1, 0.05))
    assert integrator["p.y"] == pytest.approx(0.1 - 0.5 * GRAVITY * 0.01, abs=1e-15)
    assert integrator["floor.impacts"] == 0.0


def test_a_point_drawn_sliding_rubs_from_the_start():
    integrator = begin(slider(), 0.05)
    assert integrator["floor.mode"] == 2.0
    assert integrator["floor.force"] == pytest.approx(GRAVITY, rel=1e-14)
    assert integrator["floor.friction"] == pytest.approx(-0.3 * GRAVITY, rel=1e-14)
    assert integrator["floor.slip"] == 1.5
    cover(integrator, even(0.1, 0.05))
    assert integrator["p.x"] == pytest.approx(0.15 - 0.5 * 0.3 * GRAVITY * 0.01, abs=1e-15)


def test_a_point_drawn_at_rest_that_is_pushed_beyond_its_cone_slides_at_once():
    content = slider(0.0) | {
        "forces": {"push": {"type": "force", "point": "p", "value": [-5.0, 0.0]}}
    }
    integrator = begin(content, 0.05)
    assert integrator["floor.mode"] == 2.0
    cover(integrator, even(0.1, 0.05))
    assert integrator["p.vx"] == pytest.approx(-0.1 * (5.0 - 0.3 * GRAVITY), abs=1e-15)


# --------------------------------------------------------------------------------- two at once


def two_balls(second: float) -> Content:
    """Two balls that know nothing of each other, from 1 m and from another height."""
    floor = {"type": "plane", "axis": [0, 1]}
    return mechanism(
        "balls",
        2,
        points={
            "p": {"mass": 1.0, "position": [0.0, 1.0]},
            "q": {"mass": 3.0, "position": [1.0, second]},
        },
        contacts={
            "P": floor | {"point": "p", "restitution": 0.8},
            "Q": floor | {"point": "q", "restitution": 0.5},
        },
    )


@pytest.mark.parametrize("apart", [0.0, 1e-16, -1e-15, 1e-14, 1e-12, -1e-10, 1e-8])
def test_two_that_hit_at_once_rebound_as_each_alone(apart):
    # What is nearer than 1e-10 of the size of the mechanism takes part in an impact.
    near = 1e-13 if abs(apart) < 1e-15 or abs(apart) > 1e-9 else 5e-10
    integrator = begin(two_balls(1.0 + apart), 0.05)
    passed = cover(integrator, even(0.8, 0.1))
    hit = 0.451523640985731
    assert (integrator["P.impacts"], integrator["Q.impacts"]) == (1.0, 1.0)
    assert integrator["p.y"] == pytest.approx(fall_and_rebound(0.8, hit, 0.8), abs=near)
    later = math.sqrt(2.0 * (1.0 + apart) / GRAVITY)
    assert integrator["q.y"] == pytest.approx(fall_and_rebound(0.8, later, 0.5), abs=near)
    loss = GRAVITY * (0.36 + 3.0 * 0.75 * (1.0 + apart))
    assert integrator["energy.impact"] == pytest.approx(loss, abs=10.0 * near)
    assert passed.error < 1e-14


@pytest.mark.parametrize("law", ["simultaneous", "sequential"])
@pytest.mark.parametrize("restitution", [1.0, 0.5])
def test_a_ball_in_a_corner_goes_back_the_way_it_came(restitution, law):
    # Two walls at a right angle at once: each reverses its part of the velocity, in either order.
    wall = {"type": "plane", "point": "p", "restitution": restitution}
    content = mechanism(
        "corner",
        2,
        gravity=False,
        points={"p": {"mass": 1.0, "position": [1.0, 0.5], "velocity": [-1.0, -0.5]}},
        contacts={"left": wall | {"axis": [1, 0]}, "right": wall | {"axis": [0, 1]}},
    )
    integrator = begin(content, 0.1, impact_law=law)
    cover(integrator, even(2.0, 0.25))
    assert integrator["p.x"] == pytest.approx(restitution, abs=1e-14)
    assert integrator["p.y"] == pytest.approx(0.5 * restitution, abs=1e-14)
    loss = 0.5 * 1.25 * (1.0 - restitution**2)
    assert integrator["energy.impact"] == pytest.approx(loss, abs=1e-15)


def test_a_flat_rod_that_falls_on_both_ends_rebounds_flat():
    # Newton's law at both ends at once: each leaves with e times the speed that it came with.
    floor = {"type": "plane", "axis": [0, 1], "restitution": 0.6, "friction": 0.3}
    content = mechanism(
        "flat",
        2,
        points={
            "a": {"mass": 0.0, "position": [0.0, 0.5]},
            "b": {"mass": 0.0, "position": [1.0, 0.5]},
        },
        bodies={"rod": {"type": "bar", "points": ["a", "b"], "mass": 2.0}},
        contacts={"A": floor | {"point": "a"}, "B": floor | {"point": "b"}},
    )
    integrator = begin(content, 0.05, order=4)
    passed = cover(integrator, even(0.5, 0.05))
    hit = math.sqrt(1.0 / GRAVITY)
    height = fall_and_rebound(0.5, hit, 0.6)
    assert [integrator["a.y"], integrator["b.y"]] == pytest.approx([height, height], abs=1e-13)
    assert (integrator["A.impacts"], integrator["B.impacts"]) == (1.0, 1.0)
    assert integrator["energy.impact"] == pytest.approx(0.64 * GRAVITY, rel=1e-13)
    assert passed.error < 1e-14


def test_a_release_and_an_impact_of_others_may_come_together():
    # One ball hits just when another one, pressed down until then, is let go.
    content = two_balls(0.0)
    content["forces"] = {
        "lift": {
            "type": "force",
            "point": "q",
            "value": [0.0, f"{3.0 * GRAVITY}*t/{0.451523640985731!r}"],
        }
    }
    events = events_of(content, 0.6, 0.05)
    assert sorted(e.kind for e in events) == ["hit", "open"]
    times = np.array([e.time for e in events])
    assert times == pytest.approx([0.451523640985731] * 2, abs=2e-11)
