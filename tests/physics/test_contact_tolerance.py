"""The error of a run with contacts falls with its tolerance, as that of other runs does.

A pair of half steps is judged by the one before it; the first ones after an event are judged by
two of half their length.
"""

from __future__ import annotations

import math

import pytest

import solver
from solver.runtime import Integrator
from tests.support.contact.contact_events import begin, cover, even, number
from tests.support.contact.contact_scenes import ball_on_a_strut, belt, circle, incline
from tests.support.contact.exact_contacts import BELT, hits_on_a_strut, on_a_strut, slips_on_a_belt
from tests.support.mechanisms.problems import Content
from tests.support.mechanisms.scene_files import SCENES

Place = tuple[float, float]


def place_on_a_strut(t: float) -> Place:
    """Place of `ball_on_a_strut` between its third and its fourth hit."""
    times, state = hits_on_a_strut(3)
    return 0.0, float(on_a_strut(state, t - times[-1])[0])


def place_on_a_belt(t: float) -> Place:
    """Place of the block of `belt` while it sticks after its third slip."""
    _, ended, x = slips_on_a_belt(3, 0.5)
    return x + BELT * (t - ended), 0.0


PROBLEMS: dict[str, tuple[Content, float, Place]] = {
    "impacts until it slides": (circle(0.5), 20.0, (-0.6850412555779, -0.7285042746314)),
    "a stop of slip in space": (
        incline(0.3, 0.5, [0.0, 1.0]), 0.6, (-0.053474696351885, 0.11799314374224),
    ),
    "impacts with a damper": (ball_on_a_strut(), 2.5, place_on_a_strut(2.5)),
    "stick and slip with a damper": (belt(0.5), 2.1, place_on_a_belt(2.1)),
}  # fmt: skip


def error_of(name: str, **settings: float) -> float:
    content, until, place = PROBLEMS[name]
    integrator = begin(
        content, rest_speed=1e-2 if name.startswith("impacts until") else 1e-6, **settings
    )
    assert cover(integrator, even(until, until / 20.0)).error < 1e-13
    return math.dist([number(integrator, "p.x"), number(integrator, "p.y")], place)


@pytest.mark.parametrize("tolerance", [1e-5, 1e-6, 1e-7, 1e-9, 1e-11])
@pytest.mark.parametrize("name", PROBLEMS)
def test_the_error_is_at_most_ten_times_the_tolerance_through(name, tolerance):
    assert error_of(name, tolerance=tolerance, order=0) < 10.0 * tolerance


@pytest.mark.parametrize("name", PROBLEMS)
def test_pairs_are_judged_after_events_through(name):
    assert error_of(name, tolerance=1e-4, order=2) < 2e-4


def test_angles_of_many_turns_do_not_shorten_steps_to_nothing():
    """Round-off of an angle of 55 rad over a step is no error that shorter steps would lessen."""
    run = Integrator(solver.assemble(solver.load(SCENES / "gear_pair_with_backlash.toml")))
    run["solver.tolerance"], run["solver.order"], run["solver.step_size"] = 1e-9, 0.0, 0.0
    for _ in range(5):
        run.advance(run.time, 0.4)
        assert run["solver.newton_iterations"] < 5e4
