"""Stops whose ends are tunable parameters, moved during a run."""

from __future__ import annotations

import math

import pytest

from solver.runtime import Integrator, OptionError
from solver.scene import SceneError
from tests.support.contact.contact_events import begin, number
from tests.support.mechanisms.problems import GRAVITY, Content, mechanism


def slider(low: float = -1.0, high: float = 1.0, **more: object) -> Content:
    """Mass of 1 kg that falls along a guide from 0, between two ends of a stop."""
    ends = {"low": low, "high": high}
    return mechanism(
        "slider",
        2,
        parameters={
            k: {"value": x, "unit": "m", "variability": "tunable"} for k, x in ends.items()
        },
        bodies={"b": {"position": [0.0, 0.0], "mass": 1.0, "inertia": 1.0}},
        joints={"guide": {"type": "prismatic", "bodies": ["ground", "b"], "axis": [0, 1]}},
        contacts={"stop": {"type": "stop", "joint": "guide", "min": "low", "max": "high"} | more},
    )


def advance(integrator: Integrator, until: float) -> None:
    """Advance in one communication step."""
    integrator.advance(integrator.time, until - integrator.time)


MODES = ["located", "stepped"]


@pytest.mark.parametrize("mode", MODES)
def test_a_stop_is_hit_where_it_was_moved_to(mode):
    # From -1 m to -0.5 m in flight: a fall of 0.3193 s.
    integrator = begin(slider(), 0.01, contact_mode=mode)
    advance(integrator, 0.2)
    integrator["low"] = -0.5
    assert integrator["stop.gap"] == pytest.approx(0.5 - 0.5 * GRAVITY * 0.04, abs=1e-14)
    advance(integrator, 0.31)
    assert integrator["stop.impacts"] == 0.0
    advance(integrator, 0.4)
    assert integrator["stop.impacts"] == 1.0
    assert integrator["b.y"] == pytest.approx(-0.5, abs=1e-12)
    assert integrator["energy.impact"] == pytest.approx(0.5 * GRAVITY, rel=1e-12)
    assert number(integrator, "energy.error") < 1e-13


@pytest.mark.parametrize("mode", MODES)
def test_a_stop_that_is_taken_away_lets_go_and_does_no_work(mode):
    integrator = begin(slider(low=0.0), 0.01, contact_mode=mode)
    advance(integrator, 0.5)
    assert integrator["stop.force"] == pytest.approx(GRAVITY, rel=1e-12)
    integrator["low"] = -1.0
    advance(integrator, 0.7)
    assert integrator["stop.mode"] == 0.0
    assert integrator["b.y"] == pytest.approx(-0.5 * GRAVITY * 0.04, abs=1e-13)
    assert integrator["energy.work"] == 0.0
    assert integrator["energy.dissipated"] == 0.0


@pytest.mark.parametrize("mode", MODES)
def test_a_stop_is_not_moved_into_what_it_stops(mode):
    # Refused with a sentence, and the run goes on as if nothing had been tried, bit for bit.
    integrator = begin(slider(low=0.0), 0.01, contact_mode=mode)
    advance(integrator, 0.5)
    before = integrator.save()
    with pytest.raises(OptionError, match=r"contact 'stop': its gap would be -0\.1 m; a stop may"):
        integrator["low"] = 0.1
    assert integrator.save() == before
    assert integrator["low"] == 0.0
    advance(integrator, 0.6)
    assert integrator["b.y"] == 0.0


def test_ends_of_a_stop_do_not_cross():
    integrator = begin(slider(), 0.01)
    advance(integrator, 0.1)
    with pytest.raises(OptionError, match="max - min must be > 0, got -1"):
        integrator["low"] = 2.0


@pytest.mark.parametrize("length", [0.0, 1e-300])
def test_a_rope_without_length_is_refused(length):
    rope = mechanism(
        "rope", 2,
        points={"p": {"position": [0, 0], "mass": 1}, "q": {"position": [0, 0], "mass": 1}},
        contacts={"rope": {"type": "stop", "points": ["p", "q"], "max": length}},
    )  # fmt: skip
    with pytest.raises(SceneError, match=r"rope: max, a distance, must be > 1e-12 m, got"):
        begin(rope, 0.01)


def test_a_rope_is_shortened_as_far_as_it_is_slack():
    rope = mechanism(
        "rope",
        2,
        gravity=False,
        parameters={"reach": {"value": 2.0, "unit": "m", "variability": "tunable"}},
        points={
            "o": {"position": [0.0, 0.0], "fixed": True},
            "p": {"position": [1.0, 0.0], "mass": 1.0, "velocity": [1.0, 0.0]},
        },
        contacts={
            "rope": {"type": "stop", "points": ["o", "p"], "max": "reach", "restitution": 1.0}
        },
    )
    integrator = begin(rope, 0.05)
    advance(integrator, 0.2)
    integrator["reach"] = 1.5
    advance(integrator, 1.0)
    assert integrator["p.x"] == pytest.approx(1.0, abs=1e-14)  # back from 1.5 m
    assert integrator["energy.impact"] == pytest.approx(0.0, abs=1e-15)
    with pytest.raises(OptionError, match=r"contact 'rope': its gap would be -0\.5 m"):
        integrator["reach"] = 0.5


def test_a_state_holds_the_place_of_its_stop():
    integrator = begin(slider(), 0.01)
    advance(integrator, 0.2)
    integrator["low"] = -0.5
    saved = integrator.save()
    advance(integrator, 0.5)
    first = integrator.save()
    integrator.restore(saved)
    integrator["low"] = -0.9
    advance(integrator, 0.5)
    integrator.restore(saved)
    advance(integrator, 0.5)
    assert integrator.save() == first


def test_a_compliant_stop_may_be_moved_into_what_it_stops_and_works_on_it():
    # Pressed in by 0.1 m it stores K delta^2.5/2.5, which is work, and shoots the mass away.
    content = slider(low=0.0, law="hertz", stiffness=1000.0)
    content["gravity"] = [0.0, 0.0]
    integrator = begin(content, 1e-3)
    advance(integrator, 0.01)
    integrator["low"] = 0.1
    advance(integrator, 0.3)
    work = 1000.0 / 2.5 * 0.1**2.5
    assert integrator["energy.work"] == pytest.approx(work, rel=1e-12)
    assert integrator["stop.gap"] == pytest.approx(number(integrator, "b.y") - 0.1, abs=1e-14)
    assert integrator["stop.force"] == 0.0
    assert integrator["b.vy"] == pytest.approx(math.sqrt(2.0 * work), rel=1e-9)
