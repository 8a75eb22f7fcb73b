"""Orders 2, 4 and 6 hold through impacts, releases, stick and slip, since steps end at events.

With dampers a step is the weighted end of covers by pairs (test_high_orders.py), in which contacts
do not change either.

Errors are those against closed forms and event-accurate references. The slope of all of them over
the steps, in logarithms, is the order to 0.3: grids of steps meet events at other places for each
step, which scatters errors.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

import numpy as np
import pytest
from scipy.integrate import quad

from tests.support.contact.contact_events import begin, cover, even, events_of, number, times_of
from tests.support.contact.contact_scenes import (
    ball_on_a_strut,
    belt,
    circle,
    incline,
    pendulum_at_a_stop,
    point_on_a_ball,
    rocking_block,
    rod_that_falls,
    slider_crank_with_clearance,
)
from tests.support.contact.exact_contacts import hits_on_a_strut, rod_that_bounces, slips_on_a_belt
from tests.support.mechanisms.problems import GRAVITY, Content

CIRCLE_AT_20_S = [-0.6850412555779, -0.7285042746314]
STOP_HITS = [0.636375398716223, 1.95380341134223, 3.35390204401844]
ROCKING_HITS = [0.338045483931156, 0.781462847122351, 1.11940175098697, 1.38943963839401]
CRANK_HITS = [0.00119481935377, 0.002945449291185, 0.003815936076778, 0.004480015883807]
CRANK_HITS += [0.007628156450661, 0.009282173653204, 0.01191150427891, 0.01484520218614]
FALLEN = 0.3248707931989 - 0.242
"""Part of its fall after which the rod begins, so that it hits at 0.242 s, a multiple of steps."""
ROD_TURN, ROD_END, ROD_BOUNCE_END = (
    t - FALLEN for t in (0.4217270464735, 0.4374693840614, rod_that_bounces()[0])
)
BELT_SLIPS = [0.25 + i * 0.671238898038469 for i in range(5)]
BELT_DAMPING = 0.5
THROWN = [-0.053474696351885, 0.11799314374224]


def release_time(angle: float = 0.1, rate: float = 0.3) -> float:
    """Time at which a point leaves a ball of 1 m: where g cos(theta) is the square of its speed."""
    end = math.acos((2.0 * math.cos(angle) + rate**2 / GRAVITY) / 3.0)

    def slowness(theta: float) -> float:
        return 1.0 / math.sqrt(rate**2 + 2.0 * GRAVITY * (math.cos(angle) - math.cos(theta)))

    return quad(slowness, angle, end, epsabs=1e-14, epsrel=1e-14)[0]


def late(
    content: Content, until: float, kind: str, contact: str | None, reference: Sequence[float]
) -> Callable[[float, int], float]:
    """Return a function of step and order: the error of the times of some events."""

    def error(h: float, order: int) -> float:
        events = events_of(content, until, h, order=order, rest_speed=1e-6)
        times = times_of(events, kind, contact)
        assert len(times) == len(reference)
        return float(np.linalg.norm(np.subtract(times, reference)))

    return error


def away(
    content: Content, until: float, place: Sequence[float], **settings: float
) -> Callable[[float, int], float]:
    """Return a function of step and order: the distance of `p` from where it must end."""

    def error(h: float, order: int) -> float:
        integrator = begin(content, h, order, **settings)
        cover(integrator, even(until, 0.2))
        return math.dist([number(integrator, "p.x"), number(integrator, "p.y")], place)

    return error


COARSE, FINE = [0.0484, 0.0242, 0.0121], [0.0242, 0.0121, 0.00605]
Steps = dict[int, list[float]]
PROBLEMS: dict[str, tuple[Callable[[float, int], float], Steps]] = {
    "impacts until it slides": (
        away(circle(0.5), 20.0, CIRCLE_AT_20_S, rest_speed=1e-2),
        {2: [0.04, 0.02, 0.01], 4: [0.1, 0.05, 0.025], 6: [0.1, 0.05, 0.025]},
    ),
    "impacts at a stop": (
        late(pendulum_at_a_stop(), 3.4, "hit", None, STOP_HITS),
        {2: [0.04, 0.02, 0.01], 4: [0.08, 0.04, 0.02], 6: [0.16, 0.08, 0.04]},
    ),
    "impacts of a slider-crank": (
        late(slider_crank_with_clearance(), 0.0149, "hit", None, CRANK_HITS),
        {2: [2e-4, 1e-4, 5e-5], 4: [4e-4, 2e-4, 1e-4], 6: [3e-4, 2e-4, 1.5e-4]},
    ),
    "impacts that close and release": (
        late(rocking_block(), 1.45, "hit", None, ROCKING_HITS),
        {2: [0.02, 0.01, 0.005], 4: [0.02, 0.01, 0.005], 6: [0.04, 0.02, 0.01]},
    ),
    "an impact with friction": (
        late(rod_that_falls(0.5, 1.0, FALLEN), 0.35, "hit", "B", [ROD_BOUNCE_END]),
        {2: FINE, 4: FINE, 6: COARSE[:2]},
    ),
    "slip that turns": (
        late(rod_that_falls(fallen=FALLEN), 0.345, "turn", "A", [ROD_TURN]),
        {2: FINE, 4: FINE, 6: COARSE},
    ),
    "impacts after slip": (
        late(rod_that_falls(fallen=FALLEN), 0.356, "hit", "B", [ROD_END]),
        {2: FINE, 4: FINE, 6: COARSE},
    ),
    "stick and slip": (
        late(belt(), 3.2, "slip", None, BELT_SLIPS),
        {2: [0.02, 0.01, 0.005], 4: [0.08, 0.04, 0.02], 6: [0.08, 0.04, 0.02]},
    ),
    "impacts with a damper": (
        late(ball_on_a_strut(), 2.45, "hit", None, hits_on_a_strut(3)[0]),
        {2: [0.04, 0.02, 0.01], 4: [0.08, 0.04, 0.02], 6: [0.08, 0.04, 0.02]},
    ),
    "stick and slip with a damper": (
        late(belt(BELT_DAMPING), 2.0, "slip", None, slips_on_a_belt(3, BELT_DAMPING)[0]),
        {2: [0.02, 0.01, 0.005], 4: [0.04, 0.02, 0.01], 6: [0.06, 0.03, 0.015]},
    ),
    "slip in space until it stops": (
        away(incline(0.3, 0.5, [0.0, 1.0]), 0.6, THROWN),
        {2: [0.02, 0.01, 0.005], 4: [0.02, 0.01, 0.005], 6: [0.025, 0.0125, 0.01, 0.008]},
    ),
    "a release": (
        late(point_on_a_ball(), 0.8, "open", None, [release_time()]),
        {2: [0.02, 0.01, 0.005], 4: [0.04, 0.02, 0.01], 6: [0.16, 0.08, 0.04]},
    ),
}


@pytest.mark.parametrize("order", [2, 4, 6])
@pytest.mark.parametrize("name", PROBLEMS)
def test_the_order_holds_through(name, order):
    error, steps = PROBLEMS[name]
    errors = [error(h, order) for h in steps[order]]
    slope = np.polyfit(np.log(steps[order]), np.log(errors), 1)[0]
    assert slope == pytest.approx(order, abs=0.3), errors
