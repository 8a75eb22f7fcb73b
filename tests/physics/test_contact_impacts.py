"""Times, losses and places of impacts against closed forms and event-accurate solutions.

Closed forms were evaluated with 40 digits (mpmath). The circle, the rod and the slider-crank were
solved in minimal coordinates by DOP853 with polished events, to 3e-11 between two step controls.
"""

from __future__ import annotations

import math

import pytest

import solver
from tests.support.contact.contact_events import begin, cover, even, events_of, number, times_of
from tests.support.contact.contact_scenes import (
    ball,
    cam,
    circle,
    cradle,
    pendulum_at_a_stop,
    rocking_block,
    rod_that_falls,
    slider_crank_with_clearance,
    sphere_of_clearance,
)
from tests.support.mechanisms.problems import GRAVITY

BALL_HITS = [0.451523640985731, 1.1739614665629, 1.75191172702464]
CIRCLE = {
    1.0: [-0.6574062000662, -0.2738892367167],
    0.5: [-0.6850412555779, -0.7285042746314],
    0.0: [-0.507268358772, -0.8617881480902],
}
"""Place at 8, 20, 20 s for each restitution; contacts close below 0.01 m/s."""
CIRCLE_HITS = {
    1.0: "0.4941982660591 0.8282069296622 1.681786791329 2.602345089557 3.294516720469"
    " 3.594271652386 3.890731346973 4.595967468117 5.516904984944 6.388115388731 6.748494102387"
    " 7.521782727713",
    0.5: "0.4941982660591 0.7269779934221 0.8485909048961 0.9162339029737 0.9528686716561"
    " 0.9720840233537 0.9819452673284 0.9869432288484 0.9894595567455 0.9907221226267",
    0.0: "0.4941982660591",
}
CIRCLE_LOSS = {1.0: 0.0, 0.5: 6.891693941328, 0.0: 6.504864815522}
STOP_HITS = [0.636375398716223, 1.95380341134223, 3.35390204401844]
STOP_HITS += [4.85825288596779, 6.47219706421657]
STOP_LOSS = 0.40331049483155  # of m g L after five hits; here m g L = 0.5 g
ROCKING_HITS = [0.338045483931156, 0.781462847122351, 1.11940175098697, 1.38943963839401]
ROCKING_RATES = [1.42949581372277, 1.21507144166436, 1.0328107254147, 0.877889116602499]
ROCKING_RATIO = 0.85
CRANK_HITS = (
    "0.00119481935377 0.002945449291185 0.003815936076778 0.004480015883807 0.007628156450661"
    " 0.009282173653204 0.01191150427891 0.01484520218614 0.01738819183353 0.02128714046717"
    " 0.0253919570834 0.02934130889991 0.03146269659552 0.03295516489684 0.03453147122096"
)
CRANK_LOSS = 0.02340109938383  # after fifteen hits


def numbers(text: str) -> list[float]:
    """Numbers in a text."""
    return [float(word) for word in text.split()]


@pytest.mark.parametrize("order", [2, 4, 6])
@pytest.mark.parametrize("h", [0.05, 0.01, 0.003])
def test_a_bouncing_ball_hits_and_flies_as_its_parabolas_say(h, order):
    # Steps of every order are exact on a parabola, so only round-off is left.
    events = events_of(ball(), 2.0, h, order=order)
    assert times_of(events, "hit") == pytest.approx(BALL_HITS, abs=1e-14)
    integrator = begin(ball(), h, order)
    cover(integrator, even(2.0, 0.5))
    assert integrator["floor.impacts"] == 3.0
    assert integrator["p.y"] == pytest.approx(0.260741728327057, abs=2e-14)
    assert integrator["p.vy"] == pytest.approx(-0.165869135836471, abs=2e-14)
    assert integrator["energy.impact"] == pytest.approx(7.23836736, abs=2e-14)


@pytest.mark.parametrize("step", [0.05, 5.0])
def test_a_ball_comes_to_rest_by_hits_that_get_ever_closer(step):
    # It hits ever slower, v e^n, until it hits below the rest speed: no 49th rebound. All energy
    # is lost then, and flights of twice v e^n/g have filled the time.
    speed, rest = math.sqrt(2.0 * GRAVITY), 1e-4
    hits = 1 + math.ceil(math.log(rest / speed) / math.log(0.8))
    integrator = begin(ball(), 0.05)
    passed = cover(integrator, even(5.0, step))
    assert integrator["floor.impacts"] == hits == 49
    assert integrator["floor.mode"] == 1.0
    assert integrator["floor.force"] == pytest.approx(GRAVITY, rel=1e-12)
    assert integrator["energy.impact"] == pytest.approx(9.81, abs=1e-13)
    assert passed.error < 1e-14
    end = speed / GRAVITY * (1.0 + 2.0 * math.fsum(0.8**n for n in range(1, hits)))
    events = events_of(ball(), 5.0, 0.05)
    # The last flights are as slow as 1e-4 m/s, and a gap of 1e-15 m is none: 1e-11 s.
    assert times_of(events, "close") == pytest.approx([end], abs=2e-11)
    assert end < 4.06371276887158  # where infinitely many hits would end


@pytest.mark.parametrize("wall", ["clearance", "rope"])
@pytest.mark.parametrize("restitution", CIRCLE)
def test_a_mass_in_a_circle_hits_where_the_reference_does(restitution, wall):
    # Flights are parabolas: hits to round-off, grown by 12 hits. Sliding after the last hit is of
    # order 6: 2e-8 at h = 0.05 s. A rope is the same circle.
    content, until = circle(restitution, wall), 8.0 if restitution == 1.0 else 20.0
    settings = {"order": 6, "rest_speed": 1e-2}
    hits = times_of(events_of(content, min(until, 8.0), 0.05, **settings), "hit")
    assert hits == pytest.approx(numbers(CIRCLE_HITS[restitution]), abs=1e-11)
    integrator = begin(content, 0.05, **settings)
    passed = cover(integrator, even(until, 0.1))
    place = [integrator["p.x"], integrator["p.y"]]
    tolerance = 5e-11 if restitution == 1.0 else 2e-8
    assert place == pytest.approx(CIRCLE[restitution], abs=tolerance)
    assert integrator["wall.impacts"] == len(hits)
    assert integrator["energy.impact"] == pytest.approx(CIRCLE_LOSS[restitution], abs=1e-12)
    assert passed.gap > -1e-15
    assert passed.error < 1e-14


def test_a_lower_rest_speed_adds_the_hits_between():
    # Seventeen hits instead of ten, with the loss to 12 digits.
    integrator = begin(circle(0.5), 0.05, rest_speed=1e-4)
    cover(integrator, even(2.0, 0.1))
    assert integrator["wall.impacts"] == 17.0
    assert integrator["energy.impact"] == pytest.approx(6.891693933373, abs=1e-12)


@pytest.mark.parametrize("restitution", CIRCLE)
def test_a_ball_socket_in_space_is_the_circle_in_any_plane(restitution):
    until = 8.0 if restitution == 1.0 else 20.0
    integrator = begin(sphere_of_clearance(restitution), 0.05, 6, rest_speed=1e-2)
    cover(integrator, even(until, 0.1))
    along = math.cos(0.7) * number(integrator, "p.x") + math.sin(0.7) * number(integrator, "p.y")
    across = math.cos(0.7) * number(integrator, "p.y") - math.sin(0.7) * number(integrator, "p.x")
    tolerance = 5e-11 if restitution == 1.0 else 2e-8
    assert [along, integrator["p.z"]] == pytest.approx(CIRCLE[restitution], abs=tolerance)
    assert across == pytest.approx(0.0, abs=1e-11)
    assert integrator["energy.impact"] == pytest.approx(CIRCLE_LOSS[restitution], abs=1e-12)


@pytest.mark.parametrize("dimension", [2, 3])
def test_a_pendulum_hits_its_stop_at_the_times_of_elliptic_integrals(dimension):
    # Order 6 at h = 0.02 s: 4e-12 s after five hits; five times that is allowed. What each hit
    # takes is a part of the energy at the stop, and does not depend on the step.
    content = pendulum_at_a_stop(dimension)
    events = events_of(content, 6.6, 0.02, order=6)
    assert times_of(events, "hit") == pytest.approx(STOP_HITS, abs=2e-11)
    integrator = begin(content, 0.02, 6)
    passed = cover(integrator, even(6.6, 0.1))
    assert integrator["limit.impacts"] == 5.0
    loss = number(integrator, "energy.impact") / (0.5 * GRAVITY)
    assert loss == pytest.approx(STOP_LOSS, abs=1e-13)
    assert passed.error < 1e-13


def test_a_rocking_block_changes_edges_at_the_times_of_its_quadratures():
    # No restitution and no slip: the block turns on about the other edge with 0.85 of its rate.
    # The old edge lifts off in the same impact.
    events = events_of(rocking_block(), 1.45, 0.01, order=6)
    assert times_of(events, "hit") == pytest.approx(ROCKING_HITS, abs=2e-11)
    assert [e.contact for e in events if e.kind == "hit"] == ["A", "B", "A", "B"]
    assert [e.contact for e in events if e.kind == "open"] == ["B", "A", "B", "A"]
    integrator = begin(rocking_block(), 0.01, 6)
    cover(integrator, even(1.45, 0.05))
    about_edge = 4.0 / 3.0 * (0.1**2 + 0.3**2)
    lost = 0.5 * about_edge * (1.0 - ROCKING_RATIO**2) * math.fsum(w * w for w in ROCKING_RATES)
    assert integrator["energy.impact"] == pytest.approx(lost, rel=1e-10)
    assert integrator["energy.friction"] == 0.0  # what sticks does not rub


def test_a_slider_crank_with_a_worn_pin_hits_as_the_reference_does():
    # Fifteen hits with e = 0.9, at order 6 to 1e-12 s, which is what the reference has.
    content, settings = slider_crank_with_clearance(), {"order": 6, "rest_speed": 1e-6}
    hits = times_of(events_of(content, 0.0346, 2e-4, **settings), "hit")
    assert hits[:5] == pytest.approx(numbers(CRANK_HITS)[:5], abs=1e-13)
    assert hits == pytest.approx(numbers(CRANK_HITS), abs=5e-12)
    integrator = begin(content, 2e-4, **settings)
    passed = cover(integrator, even(0.0346, 2e-4))
    assert integrator["energy.impact"] == pytest.approx(CRANK_LOSS, abs=2e-12)
    assert passed.error < 1e-14
    assert passed.gap > -1e-17


CRADLE = [
    ("simultaneous", 1.0, [-0.6, 0.4, 0.4, 0.4, 0.4]),
    ("simultaneous", 0.9, [-0.52, 0.38, 0.38, 0.38, 0.38]),
    ("sequential", 1.0, [0.0, 0.0, 0.0, 0.0, 1.0]),
]


def pair_after_pair(velocities: list[float], restitution: float) -> list[float]:
    """Velocities of equal balls that touch, once no pair approaches; the fastest hits first."""
    v = list(velocities)
    while True:
        approach, i = max((v[i] - v[i + 1], i) for i in range(len(v) - 1))
        if approach <= 1e-9:
            return v
        e = restitution if approach > 1e-6 else 0.0
        mean, half = 0.5 * (v[i] + v[i + 1]), 0.5 * e * approach
        v[i], v[i + 1] = mean - half, mean + half


@pytest.mark.parametrize(("law", "restitution", "velocities"), CRADLE)
def test_a_cradle_of_five_balls_parts_as_its_law_of_impact_says(law, restitution, velocities):
    # Newton and Moreau: the four that touch go on together; pair after pair: the last one goes.
    integrator = begin(cradle(restitution), 0.1, impact_law=law, rest_speed=1e-6)
    passed = cover(integrator, even(1.5, 0.1))
    found = [number(integrator, f"b{i}.vx") for i in range(5)]
    assert found == pytest.approx(velocities, abs=1e-15)
    lost = 0.5 - 0.5 * math.fsum(v * v for v in velocities)
    assert integrator["energy.impact"] == pytest.approx(lost, abs=2e-15)
    assert passed.error < 1e-14


def test_pairs_of_a_cradle_hit_until_none_approaches():
    # With e = 0.9 the first ball follows the second one at once, and hits it again.
    integrator = begin(cradle(0.9), 0.1, impact_law="sequential", rest_speed=1e-6)
    cover(integrator, even(1.5, 0.1))
    found = [number(integrator, f"b{i}.vx") for i in range(5)]
    assert found == pytest.approx(pair_after_pair([1.0, 0.0, 0.0, 0.0, 0.0], 0.9), abs=1e-12)


@pytest.mark.parametrize("law", ["simultaneous", "sequential"])
def test_in_a_cradle_with_gaps_each_pair_hits_alone_under_either_law(law):
    # Four hits within 5 ms; the first ball takes 0.4 s to come up with the second one again.
    integrator = begin(cradle(0.9, gaps=1e-3), 0.1, impact_law=law)
    cover(integrator, even(1.1, 0.1))
    found = [number(integrator, f"b{i}.vx") for i in range(5)]
    assert found == pytest.approx([0.05, 0.0475, 0.045125, 0.04286875, 0.81450625], abs=1e-15)
    assert [integrator[f"c{i}.impacts"] for i in range(4)] == [1.0] * 4


def test_a_cam_throws_its_follower_and_catches_it_where_the_closed_form_says():
    # Turned at constant rate, the follower lifts off where its inertia exceeds spring and weight.
    # Order 6 at h = 0.5 ms: the flight is exact to 1e-11 s, and grows no error.
    content = cam()
    events = events_of(content, 0.08, 5e-4, order=6)
    assert [e.kind for e in events] == ["open", "hit", "close"]
    assert times_of(events, "open") == pytest.approx([0.0301611762602959], abs=1e-9)
    assert times_of(events, "hit") == pytest.approx([0.0665961038986019], abs=1e-9)
    integrator = begin(content, 5e-4, 6)
    passed = cover(integrator, even(0.08, 5e-4))
    assert integrator["energy.impact"] == pytest.approx(0.0557996132142155, abs=1e-8)
    assert passed.error < 1e-11


def test_a_rope_along_a_bar_takes_no_part_in_the_impacts_of_the_bar():
    # Its rate is that of a row that holds, so that no impulse along it changes anything.
    loose = rod_that_falls(1.0)
    loose["contacts"]["A"].pop("friction")
    loose["contacts"]["B"] |= {"friction": 0.0, "restitution": 1.0}
    length = math.dist(*(loose["points"][end]["position"] for end in "ab"))
    rope = {"rope": {"type": "stop", "points": ["a", "b"], "max": length}}
    tied = loose | {"contacts": loose["contacts"] | rope}
    runs = [begin(content, 0.01) for content in (loose, tied)]
    for _ in range(12):
        for run in runs:
            run.advance(run.time, 0.05)
            assert run["solver.stepped"] == 0.0
            assert run["energy.impact"] == pytest.approx(0.0, abs=1e-13)
        for name in ("a.x", "a.y", "b.x", "b.y"):
            assert runs[0][name] == pytest.approx(runs[1][name], abs=1e-11)
    assert number(runs[1], "A.impacts") + number(runs[1], "B.impacts") > 2.0


@pytest.mark.parametrize("order", [2, 4])
def test_what_slides_along_a_wall_does_not_bounce_where_an_input_changes(order):
    # A step leaves the gap a rate of its order, 1e-4 m/s here, which is no approach.
    content = circle(0.9)
    content["points"]["p"] |= {"position": [0.0, -1.0], "velocity": [2.0, 0.0]}
    content["forces"] = {"load": {"type": "force", "point": "p", "value": ["push", 0.0]}}
    content["inputs"] = {"push": {}}
    integrator = begin(content, 0.05, order)
    for k in range(20):
        integrator["push"] = 1e-3 * (k % 2)
        integrator.advance(integrator.time, 0.1)
        assert integrator["wall.mode"] == 1.0
        assert integrator["wall.impacts"] == 0.0
    assert number(integrator, "energy.error") < 1e-13


@pytest.mark.parametrize("parting", [0.0, 1e-13, 1e-11, 1e-9, 1e-6, 1e-3, 0.1])
def test_an_end_of_a_rod_that_parts_ever_slower_does_not_make_the_impact_of_the_other_jump(parting):
    """A rod of 1 kg and 1 m hits with one end at 1 m/s while the other parts from its stop.

    W is 4 for each end and -2 between them, so that the other end comes back to rest at half its
    speed; from there on W is 3. The compression gives back e^2 of its work.
    """
    e, speed = 0.8, 1.0 - 2.0 * parting
    work = (1.0 - speed**2) / 8.0 + speed**2 / 6.0
    rebound = e * math.sqrt(6.0 * work)
    stops = "\n".join(
        f'{name} = {{ type = "plane", point = "rod.{name}", axis = [0, 1], restitution = {e} }}'
        for name in ("left", "right")
    )
    found = solver.simulate(solver.loads(f"""
name = "rod"
dimension = 2
gravity = [0, 0]
[bodies.rod]
position = [0, 0]
mass = 1
inertia = {1 / 12!r}
velocity = [0, {(parting - 1.0) / 2!r}]
angular_velocity = {1.0 + parting!r}
points = {{ left = [-0.5, 0], right = [0.5, 0] }}
[contacts]
{stops}
"""), stop_time=0.01, step_size=0.01)  # fmt: skip
    assert found["rod.vy"][-1] == pytest.approx(rebound / 2.0, rel=1e-9)
    assert found["rod.angular_velocity"][-1] == pytest.approx(-rebound, rel=1e-9)
    assert found["energy.impact"][-1] == pytest.approx((1.0 - e**2) * work, rel=1e-9)
