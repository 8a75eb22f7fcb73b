"""Contacts in FMUs: the library's bits, parameters that take effect, states taken over impacts."""

from __future__ import annotations

import functools
import math
from pathlib import Path

import pytest

from tests.support.contact.contact_scenes import (
    ball,
    chain_over_a_floor,
    rod_that_falls,
    slider,
    slider_crank_with_clearance,
    toml_of,
)
from tests.support.fmus.fmu_instance import instance, text_fmu
from tests.support.mechanisms.problems import GRAVITY, Content

HITS = [0.451523640985731, 1.1739614665629, 1.75191172702464]


def text_of(
    content: Content, until: float, step: float, h: float, order: int = 2, mode: str = "located"
) -> str:
    """Text of a scene file with an experiment and settings."""
    tables = {
        "solver": {"step_size": h, "order": order, "contact_mode": mode},
        "experiment": {"stop_time": until, "step_size": step},
    }
    return toml_of(content | tables)


def bouncing_ball() -> str:
    parameters = {"bounce": {"value": 0.8, "min": 0.0, "max": 1.0, "variability": "tunable"}}
    content = ball(restitution="bounce") | {"parameters": parameters}
    return text_of(content, 2.0, 0.1, 0.05)


def slider_crank() -> str:
    return text_of(slider_crank_with_clearance(), 0.02, 0.001, 2e-4, order=4)


def falling_rod() -> str:
    return text_of(rod_that_falls(), 0.6, 0.02, 0.01, order=4)


def falling_chain() -> str:
    return text_of(chain_over_a_floor(4), 0.5, 0.02, 0.005, mode="stepped")


SCENES = {
    "ball": bouncing_ball,
    "slider-crank": slider_crank,
    "rod": falling_rod,
    "chain, stepped": falling_chain,
}


@functools.cache
def fmu_of(name: str) -> Path:
    return text_fmu(SCENES[name]())


@pytest.mark.parametrize("bounce", [0.0, 0.3, 1.0])
def test_a_restitution_that_is_set_at_the_start_takes_effect(bounce):
    # 0.08 s after the hit, within the flight at 0.3 times its speed.
    with instance(fmu_of("ball")) as fmu:
        fmu.initialise(bounce=bounce)
        fmu.run(0.0, 0.1, 5)
        assert fmu.step(0.5, 0.03)
        speed, t = math.sqrt(2.0 * GRAVITY), 0.53 - HITS[0]
        height = bounce * speed * t - 0.5 * GRAVITY * t * t if bounce > 0.0 else 0.0
        assert fmu.get("p.y") == pytest.approx(height, abs=1e-14)
        lost = GRAVITY * (1.0 - bounce * bounce)
        assert fmu.get("energy.impact") == pytest.approx(lost, abs=1e-13)
        assert fmu.get("floor.mode") == (bounce == 0.0)


def test_a_restitution_that_is_tuned_between_two_hits_holds_from_the_next_one():
    with instance(fmu_of("ball")) as fmu:
        fmu.initialise()
        fmu.run(0.0, 0.1, 8)
        assert fmu.get("energy.impact") == pytest.approx(0.36 * GRAVITY, abs=1e-14)
        fmu.set(bounce=1.0)
        fmu.run(0.8, 0.1, 12)
        assert fmu.get("floor.impacts") == 3.0
        assert fmu.get("energy.impact") == pytest.approx(0.36 * GRAVITY, abs=1e-13)
        assert fmu.get("energy.work") == 0.0
        assert fmu.get("energy.error") == pytest.approx(0.0, abs=1e-13)


@pytest.mark.parametrize("name", SCENES)
def test_a_step_over_an_impact_may_be_taken_back_and_retried(name):
    # Over an impact at least; of the rod from a slip over its turn to where it lies flat.
    step, before, more = {
        "ball": (0.1, 4, 8),
        "slider-crank": (0.001, 1, 10),
        "rod": (0.02, 20, 5),
        "chain, stepped": (0.02, 1, 20),
    }[name]
    with instance(fmu_of(name)) as fmu, instance(fmu_of(name)) as other:
        fmu.initialise()
        other.initialise()
        fmu.run(0.0, step, before)
        start = before * step
        state = fmu.fmu.getFMUState()
        data = fmu.fmu.serializeFMUState(state)
        impacts = [each for each in fmu.references if each.endswith(".impacts")]
        hits = [fmu.get(each) for each in impacts]
        first = fmu.run(start, step, more)
        assert [fmu.get(each) for each in impacts] != hits
        fmu.fmu.setFMUState(state)
        fmu.run(start, 0.37 * step, 3)
        fmu.fmu.setFMUState(state)
        assert fmu.run(start, step, more) == first
        other.fmu.setFMUState(other.fmu.deserializeFMUState(data))
        assert other.run(start, step, more) == first
        fmu.fmu.freeFMUState(state)


def test_friction_that_is_set_and_tuned_takes_effect():
    # At 1.5 m/s with 0.3 for 0.2 s, then with 0.6 until the block stops.
    content = slider() | {"parameters": {"mu": {"value": 0.1, "variability": "tunable"}}}
    content["contacts"]["floor"]["friction"] = "mu"
    with instance(text_fmu(text_of(content, 1.0, 0.1, 0.05))) as fmu:
        fmu.initialise(mu=0.3)
        fmu.run(0.0, 0.1, 2)
        speed = 1.5 - 0.3 * GRAVITY * 0.2
        assert fmu.get("p.vx") == pytest.approx(speed, abs=1e-13)
        fmu.set(mu=0.6)
        fmu.run(0.2, 0.1, 3)
        way = 0.5 * (1.5 + speed) * 0.2 + speed**2 / (2.0 * 0.6 * GRAVITY)
        assert fmu.get("p.x") == pytest.approx(way, abs=1e-13)
        assert fmu.get("floor.mode") == 1.0
        assert fmu.get("energy.friction") == pytest.approx(0.5 * 1.5**2, abs=1e-13)
