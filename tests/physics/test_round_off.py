"""Round-off that is larger than what is asked for is said, and no wrong values are handed on."""

from __future__ import annotations

import math
import pytest

import solver

SLIDE = """
name = "far"
dimension = 2
gravity = [0, -9.81]
[bodies]
B = {{ position = [{arm}, 0], mass = 1.0, inertia = 1.0 }}
[joints]
slide = {{ type = "prismatic", bodies = ["ground", "B"], position = [0, 0], axis = [1, 1] }}
[solver]
step_size = {step}
assemble = true
"""

CHAIN = """
name = "masses"
dimension = 2
gravity = [0, -9.81]
[points]
O = {{ position = [0, 0], fixed = true }}
A = {{ position = [1, 0], mass = {light} }}
B = {{ position = [2, 0], mass = {heavy} }}
C = {{ position = [3, 0], mass = {light} }}
[joints]
a = {{ type = "distance", points = ["O", "A"] }}
b = {{ type = "distance", points = ["A", "B"] }}
c = {{ type = "distance", points = ["B", "C"] }}
[solver]
tolerance = {tolerance}
"""


def said_of(text: str, step: float) -> tuple[list[str], solver.Integrator]:
    """What twenty steps of a scene say."""
    said: list[str] = []
    run = solver.Integrator(solver.assemble(solver.loads(text)), log=said.append)
    for _ in range(20):
        run.advance(run.time, step)
    return said, run


@pytest.mark.filterwarnings("ignore::solver.SceneWarning")
@pytest.mark.parametrize(("arm", "step"), [(1e5, 1e-8)])
def test_energy_that_round_off_of_far_places_feeds_is_said_once(arm, step):
    """Places 1e5 m away are known to 1e-11 m, and weight moves them by 5e-16 m in 10 ns."""
    said, run = said_of(SLIDE.format(arm=arm, step=step), 50.0 * step)
    (sentence,) = said
    assert sentence.startswith("the energy is off by ")
    assert "closer to the origin" in sentence
    assert run.state.head["ledger_error"] == run["energy.error"]


@pytest.mark.filterwarnings("ignore::solver.SceneWarning")
@pytest.mark.parametrize(("arm", "step"), [(5e6, 1e-3), (5e6, 3e-7), (1.0, 1e-3), (1.0, 1e-9)])
def test_nothing_is_said_where_round_off_stays_below_what_steps_are_solved_to(arm, step):
    said, run = said_of(SLIDE.format(arm=arm, step=step), 50.0 * step)
    assert said == []
    assert run["energy.error"] < 1e-9


@pytest.mark.parametrize("light", [1.0, 1e-4, 1e-8, 1e-12])
@pytest.mark.parametrize("tolerance", [1e-2, 1e-4])
def test_velocities_across_the_rows_stay_below_the_tolerance(light, tolerance):
    """Errors in the mass norm do not see parts that are 1e12 times lighter than others."""
    run = solver.Integrator(
        solver.assemble(solver.loads(CHAIN.format(light=light, heavy=1.0, tolerance=tolerance)))
    )
    fastest = (2.0 * 9.81 / 3.0) ** 0.5
    for _ in range(20):
        run.advance(run.time, 0.1)
        speeds = [math.hypot(*(float(run[f"{name}.v{axis}"]) for axis in "xy")) for name in "ABC"]
        # Ten times the tolerance of the fastest motion so far over the size, 3 m: more is put back.
        # The first steps, from rest, are measured against the fall by the size.
        fastest = max(max(speeds) / 3.0, fastest)
        assert run["constraint.velocity"] < 10.1 * tolerance * fastest
        assert run["energy.error"] < 1e-9


def test_rows_are_measured_exactly_far_from_where_they_were_drawn():
    # A slider of 1 m falls 2.5e7 m along a slanted guide: places of doubles would be off by 4e-9 m.
    text = """
name = "far"
dimension = 2
gravity = [0, -1e6]
[bodies.slider]
position = [0.3, 0.7]
mass = 1
inertia = 0.1
[joints]
guide = { type = "prismatic", bodies = ["ground", "slider"], axis = [-0.5068, 0.7758] }
[solver]
step_size = 0.01
"""
    run = solver.simulate(solver.loads(text), stop_time=10, step_size=0.1)
    assert max(map(abs, run["slider.x"])) > 1e7
    assert max(run["constraint.position"]) < 1e-11
