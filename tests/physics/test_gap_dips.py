"""Gaps that close and open again within one step: an impact, or none, as closed forms tell."""

from __future__ import annotations

import pytest

import solver
from tests.support.kernel.twins import start

PENDULUM = """
name = "grazing"
dimension = 2
gravity = [0, -9.81]
[points]
P = {{ position = [0.8, -0.6], mass = 1.0 }}
Q = {{ position = [2.8, -0.6], mass = 1.0 }}
[joints]
rod = {{ type = "distance", points = ["ground", "P"], at = [0, 0], length = 1.0 }}
other = {{ type = "distance", points = ["ground", "Q"], at = [2, 0], length = 1.0 }}
[contacts.floor]
type = "plane"
point = "P"
axis = [0, 1]
position = [0, {floor}]
restitution = 0.5
[contacts.second]
type = "plane"
point = "Q"
axis = [0, 1]
position = [0, {second}]
restitution = 0.5
"""
FAR = -5.0
STEP = 1.0  # P passes its lowest place at 0.53 s, and is about as high as at the start at its end
SETTINGS = [
    {"tolerance": tolerance, "method": method}
    for tolerance in (1e-3, 1e-4, 1e-6, 1e-8)
    for method in ("conserving", "fastest")
]


def run(settings, floor, second=FAR):
    pendulum = start(
        solver.assemble(solver.loads(PENDULUM.format(floor=floor, second=second))),
        **settings,
    )
    pendulum.advance(0.0, STEP)
    return pendulum


def turning_height(pendulum, point="P"):
    """Return how high the point comes, from its state."""
    speed2 = pendulum[f"{point}.vx"] ** 2 + pendulum[f"{point}.vy"] ** 2
    return pendulum[f"{point}.y"] + speed2 / (2 * 9.81)


def height_after_impact(depth):
    """Return it where the tip hits a floor this far above its lowest place: its speed halves."""
    return -1 + depth + 0.25 * (0.4 - depth)


def height_error(settings):
    """Return what the height errs by: the impact's place, and velocities across the rod."""
    return max(1e-10, 1e-5 * settings["tolerance"])


@pytest.mark.parametrize("settings", SETTINGS, ids=str)
@pytest.mark.parametrize("depth", [1e-2, 1e-3, 3e-4, 1e-4, 1e-5, 1e-6])
def test_a_tip_that_passes_through_the_floor_within_a_step_hits_it(depth, settings):
    pendulum = run(settings, -1 + depth)
    assert pendulum["solver.events"] == 1
    assert turning_height(pendulum) == pytest.approx(
        height_after_impact(depth), abs=height_error(settings)
    )


@pytest.mark.parametrize("settings", SETTINGS, ids=str)
@pytest.mark.parametrize("clearance", [1e-2, 1e-4, 1e-6])
def test_a_tip_that_just_misses_the_floor_swings_on(clearance, settings):
    pendulum = run(settings, -1 - clearance)
    assert pendulum["solver.events"] == 0
    assert turning_height(pendulum) == pytest.approx(-0.6, abs=1e-12)


@pytest.mark.parametrize("settings", SETTINGS, ids=str)
def test_a_tip_that_just_misses_hides_no_other_impact_of_the_step(settings):
    """P misses its floor at the moment at which Q, released as high, hits its own."""
    pendulum = run(settings, -1 - 1e-5, second=-1 + 1e-5)
    assert pendulum["solver.events"] == 1
    assert turning_height(pendulum) == pytest.approx(-0.6, abs=1e-12)
    assert turning_height(pendulum, "Q") == pytest.approx(
        height_after_impact(1e-5), abs=height_error(settings)
    )


PASSING = """
name = "passing"
dimension = 2
gravity = [0, 0]
[points]
A = {{ position = [-5, {offset}], velocity = [10, 0], mass = 1.0 }}
B = {{ position = [0, 0], mass = 2.0 }}
[contacts]
pair = {{ type = "sphere", points = ["A", "B"], radii = [0.1, 0.1], restitution = 1 }}
"""


@pytest.mark.parametrize("settings", SETTINGS, ids=str)
@pytest.mark.parametrize("offset", [0.0, 0.02, 0.1, 0.19])
def test_a_disc_that_flies_through_another_one_in_one_step_hits_it(offset, settings):
    """An elastic impact takes 4/3 of the speed of approach from A, along the line of centres."""
    run = start(solver.assemble(solver.loads(PASSING.format(offset=offset))), **settings)
    run.advance(0.0, STEP)
    across = offset / 0.2
    along = -((1 - across**2) ** 0.5)
    change = 2 * 2.0 / 3.0 * 10 * along  # 2 m_B/(m_A + m_B) times the speed of approach
    assert run["A.vx"] == pytest.approx(10 + change * -along, abs=1e-9)
    assert run["A.vy"] == pytest.approx(-change * across, abs=1e-9)
