"""Saved states with contacts: what follows is the same, bit for bit, wherever they were taken."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import pytest

from solver.runtime import Integrator
from tests.support.contact.contact_events import begin, cover, even, number
from tests.support.contact.contact_scenes import (
    ball,
    belt,
    bowling_ball,
    circle,
    cradle,
    incline,
    rocking_block,
    rod_that_falls,
    slider_crank_with_clearance,
)
from tests.support.mechanisms.problems import Content

MOMENTS: dict[str, tuple[Callable[[], Content], float, float, float]] = {
    "between impacts": (ball, 0.05, 0.7, 0.9),
    "between impacts of a mechanism": (slider_crank_with_clearance, 4e-4, 0.0034, 0.004),
    "between impacts of many": (lambda: cradle(0.9, gaps=0.01), 0.05, 0.91, 0.5),
    "before the impact that closes": (lambda: circle(0.5), 0.05, 0.97, 0.5),
    "while it slides in a circle": (lambda: circle(0.5), 0.05, 1.3, 0.5),
    "in the middle of stick": (belt, 0.02, 0.1, 0.9),
    "in the middle of slip": (belt, 0.02, 0.5, 0.9),
    "in stick after slip": (belt, 0.02, 0.81, 0.9),
    "before slip turns": (rod_that_falls, 0.01, 0.4, 0.1),
    "after slip has turned": (rod_that_falls, 0.01, 0.43, 0.1),
    "on one edge": (rocking_block, 0.01, 0.5, 0.5),
    "in slip in space": (lambda: incline(0.3, 0.5, [0.0, 1.0]), 0.01, 0.2, 0.3),
    "before it rolls": (lambda: bowling_ball(0.3), 0.01, 1.1, 0.2),
    "while it rolls": (lambda: bowling_ball(0.3), 0.01, 1.3, 0.2),
    "at the start": (ball, 0.05, 0.0, 0.9),
}
"""Problem, internal step, time at which the state is taken, and how long the run goes on."""


def outputs(integrator: Integrator) -> list[float]:
    """Values of all outputs."""
    names = [v.name for v in integrator.model.variables if v.causality == "output"]
    return [number(integrator, name) for name in names]


def course(integrator: Integrator, end: float, step: float) -> list[list[float]]:
    """Outputs after each of some communication steps, longer than internal ones."""
    rows = []
    for t in even(end, step, integrator.time):
        integrator.advance(integrator.time, t - integrator.time)
        rows.append(outputs(integrator))
    return rows


@pytest.mark.parametrize("order", [2, 4])
@pytest.mark.parametrize("moment", MOMENTS)
def test_a_run_repeats_bit_for_bit_from_a_saved_state(moment, order):
    # Over events of all kinds, in the instance that saved the state and in another one.
    make, h, at, more = MOMENTS[moment]
    integrator = begin(make(), h, order)
    if at > 0.0:
        cover(integrator, even(at, h))
    saved = integrator.save()
    first, events = course(integrator, at + more, 3.3 * h), number(integrator, "solver.events")
    last = integrator.save()
    integrator.restore(saved)
    assert integrator.save() == saved
    assert course(integrator, at + more, 3.3 * h) == first
    assert integrator.save() == last
    other = begin(make(), h, order)
    other.restore(saved)
    assert course(other, at + more, 3.3 * h) == first
    assert other.save() == last
    assert number(other, "solver.events") == events


@pytest.mark.parametrize("moment", MOMENTS)
def test_a_step_that_is_taken_back_leaves_no_trace(moment):
    # Tried over events with steps of several lengths, taken back each time, as a master does.
    make, h, at, more = MOMENTS[moment]
    integrator, retried = begin(make(), h), begin(make(), h)
    for each in (integrator, retried):
        if at > 0.0:
            cover(each, even(at, h))
    saved = retried.save()
    for step in (more, 0.5 * more, 0.37 * more, 1e-3 * h):
        retried.advance(retried.time, step)
        retried.restore(saved)
    assert course(retried, at + more, h) == course(integrator, at + more, h)


@pytest.mark.parametrize("moment", MOMENTS)
def test_nothing_of_a_contact_is_kept_in_scratch(moment):
    # Scratch full of NaN between communication steps changes no bit.
    make, h, at, more = MOMENTS[moment]
    integrator, spoiled = begin(make(), h), begin(make(), h)
    for t in even(at + more, 2.0 * h):
        integrator.advance(integrator.time, t - integrator.time)
        np.asarray(spoiled.work)[:] = math.nan
        spoiled.advance(spoiled.time, t - spoiled.time)
        assert outputs(spoiled) == outputs(integrator)
