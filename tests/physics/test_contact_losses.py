"""Every joule of an impact and of sliding is booked, and no step decides how many there are."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import pytest

from tests.support.contact.contact_events import begin, cover, even, number
from tests.support.contact.contact_scenes import (
    ball,
    belt,
    bowling_ball,
    bowling_disc,
    circle,
    cradle,
    incline,
    pendulum_at_a_stop,
    point_on_a_ball,
    rocking_block,
    rod_that_falls,
    slider,
    slider_crank_with_clearance,
    sphere_of_clearance,
)
from tests.support.mechanisms.problems import GRAVITY, Content

ALL: dict[str, tuple[Callable[[], Content], float, float]] = {
    "ball": (ball, 5.0, 0.05),
    "circle": (lambda: circle(0.5), 10.0, 0.05),
    "rope": (lambda: circle(0.7, "rope"), 5.0, 0.05),
    "sphere": (lambda: sphere_of_clearance(0.9), 5.0, 0.05),
    "pendulum": (pendulum_at_a_stop, 6.0, 0.05),
    "pendulum in space": (lambda: pendulum_at_a_stop(3), 6.0, 0.05),
    "slider-crank": (slider_crank_with_clearance, 0.04, 2e-4),
    "cradle": (lambda: cradle(0.8, gaps=0.01), 3.0, 0.1),
    "rod": (rod_that_falls, 0.8, 0.01),
    "rod that bounces": (lambda: rod_that_falls(0.5, 1.0), 1.5, 0.01),
    "rocking block": (rocking_block, 2.5, 0.02),
    "slider": (slider, 1.0, 0.05),
    "incline": (lambda: incline(0.5, 0.2, [2.0]), 2.0, 0.05),
    "thrown": (lambda: incline(0.3, 0.5, [0.0, 1.0]), 0.6, 0.02),
    "belt": (belt, 3.0, 0.02),
    "disc": (bowling_disc, 1.0, 0.02),
    "bowling ball": (bowling_ball, 1.5, 0.01),
    "off a ball": (point_on_a_ball, 1.0, 0.02),
}
"""Problem, time to run, and an internal step."""


@pytest.mark.parametrize("order", [2, 4, 6])
@pytest.mark.parametrize("name", ALL)
def test_the_ledger_closes_through_impacts_release_stick_and_slip(name, order):
    # At every communication point, two in each step: nothing penetrates, and neither impacts nor
    # friction give energy back.
    make, until, h = ALL[name]
    integrator = begin(make(), h, order)
    energy = number(integrator, "energy.kinetic")
    passed = cover(integrator, even(until, 0.5 * h))
    assert passed.error < 1e-11
    assert passed.gap > -1e-12
    assert passed.loss > -1e-13 * max(1.0, energy)


@pytest.mark.parametrize("h", [0.02, 0.01, 0.005, 0.0025])
def test_the_ledger_of_a_falling_rod_closes_at_every_step_of_order_4(h):
    # A prototype that took a step of 5 ms for solved by its increments was open by 5.4e-7 here.
    integrator = begin(rod_that_falls(), h, 4)
    assert cover(integrator, even(0.44, h)).error < 1e-13


@pytest.mark.parametrize("order", [2, 4, 6])
@pytest.mark.parametrize("h", [0.001, 0.005, 0.01, 0.02, 0.033, 0.05])
def test_what_a_mass_in_a_circle_loses_does_not_depend_on_step_and_order(h, order):
    integrator = begin(circle(0.5), h, order, rest_speed=1e-2)
    cover(integrator, even(2.0, 0.5))
    assert integrator["energy.impact"] == pytest.approx(6.891693941328, abs=1e-12)


@pytest.mark.parametrize(("h", "order"), [(0.01, 2), (0.05, 4), (0.02, 6)])
def test_a_rocking_block_comes_to_rest_after_landings_that_do_not_depend_on_the_step(h, order):
    # Its landings follow each other faster and faster, until rest_speed, 0.1 mm/s, ends them at
    # 2.77 s. All of its height is lost then.
    integrator = begin(rocking_block(), h, order)
    for _ in range(60):
        integrator.advance(integrator.time, 0.05)
        assert integrator["solver.stepped"] == 0.0
    height = 0.1 * math.sin(0.2) + 0.3 * (math.cos(0.2) - 1.0)
    assert integrator["energy.impact"] == pytest.approx(GRAVITY * height, rel=1e-12)
    assert integrator["energy.kinetic"] < 1e-20
    for contact in ("A", "B"):
        assert integrator[f"{contact}.mode"] == 1.0
        assert integrator[f"{contact}.impacts"] == 25.0


@pytest.mark.parametrize("h", [0.001, 0.01, 0.05])
@pytest.mark.parametrize(
    ("make", "until"),
    [(ball, 91.0), (circle, 75.0), (sphere_of_clearance, 75.0)],
    ids=["ball", "circle", "sphere"],
)
def test_a_hundred_elastic_impacts_lose_nothing(make, until, h):
    # Round-off of a hundred impacts, against an energy of up to 10 J.
    integrator = begin(make(restitution=1.0), h)
    energy = number(integrator, "energy.total")
    cover(integrator, even(until, 0.5))
    name = "floor" if make is ball else "wall"
    assert number(integrator, f"{name}.impacts") >= 100.0
    assert abs(number(integrator, "energy.total") - energy) < 1e-12 * 9.81
    assert abs(number(integrator, "energy.impact")) < 1e-12 * 9.81


@pytest.mark.parametrize("order", [2, 4, 6])
def test_elastic_impacts_of_a_mechanism_with_joints_lose_nothing(order):
    integrator = begin(slider_crank_with_clearance(1.0), 4e-4, order)
    energy = number(integrator, "energy.total")
    cover(integrator, even(0.3, 2e-3))
    assert number(integrator, "pin.impacts") >= 100.0
    assert abs(number(integrator, "energy.impact")) < 1e-12 * energy
    assert number(integrator, "energy.total") == pytest.approx(energy, rel=1e-12)


def test_the_accounts_add_up():
    # energy.dissipated is the sum of what dampers, friction and impacts take.
    content: dict[str, Any] = rod_that_falls(0.5, 1.0)
    content["forces"] = {"damper": {"type": "damper", "points": ["o", "a"], "damping": 0.4}}
    content["points"] |= {"o": {"position": [2.0, 1.0], "fixed": True}}
    integrator = begin(content, 0.01, 2)
    passed = cover(integrator, even(1.2, 0.01))
    parts = [number(integrator, f"energy.{name}") for name in ("damping", "friction", "impact")]
    assert min(parts) > 0.01
    assert integrator["energy.dissipated"] == pytest.approx(math.fsum(parts), rel=1e-15)
    assert passed.error < 1e-13
