"""Friction at dead centres, where the slip ends and begins anew and no force stops it."""

from __future__ import annotations

import numpy as np
import pytest

import solver
from solver.runtime import Integrator
from tests.support.contact.contact_events import number
from tests.support.mechanisms.scene_files import SCENES

FORCE, STROKE, ENERGY = 0.02 * 2.0 * 9.81, 0.3, 1.0
"""Of friction [N], of the crank [m], at the start [J]; the parts below have them."""
YOKE = """
name = "yoke"
dimension = 2
gravity = [0, -9.81]
[bodies.crank]
position = [0, 0]
angular_velocity = 2.0
mass = 1.0
inertia = 0.5
points = { pin = [0.3, 0] }
[bodies.slider]
position = [0.3, 0]
mass = 2.0
inertia = 0.1
points = { left = [-0.2, -0.1], right = [0.2, -0.1] }
[joints]
bearing = { type = "revolute", bodies = ["ground", "crank"], position = [0, 0] }
slot = { type = "point_on_line", point = "crank.pin", body = "slider", axis = [0, 1] }
"""
HELD = {
    "on two feet": """
[contacts]
left = { type = "plane", point = "slider.left", axis = [0, 1], position = [0, -0.1], friction = 0.02 }
right = { type = "plane", point = "slider.right", axis = [0, 1], position = [0, -0.1], friction = 0.02 }
""",  # noqa: E501
    "in a guide": """
guide = { type = "prismatic", bodies = ["ground", "slider"], axis = [1, 0], friction = { coefficient = 0, preload = 0.3924 } }
""",  # noqa: E501
}


@pytest.mark.parametrize("order", [2, 4])
@pytest.mark.parametrize("step", [0.05, 0.01])
@pytest.mark.parametrize("held", HELD)
def test_friction_takes_its_force_times_the_way_through_dead_centres(held, step, order):
    """A Scotch yoke turns twice through its dead centres: the weight, and so friction, is constant.

    Steps of 0.05 s turn by 0.1 rad. Rates that rows have left then make the slip seem to end where
    it is 1e-6 of the speed: to stop it there, where the crank hardly moves the slider, took 4 % of
    the energy.
    """
    run = Integrator(solver.assemble(solver.loads(YOKE + HELD[held])))
    run["solver.step_size"], run["solver.order"] = step, float(order)
    run.initialise()
    events = 0.0
    for k in range(80):
        run.advance(0.05 * k, 0.05)
        events += number(run, "solver.events")
    turns, rest = divmod(number(run, "crank.angle"), np.pi)
    loss = FORCE * STROKE * (2.0 * turns + 1.0 - np.cos(rest))
    assert turns == 2.0
    assert events <= 4.0  # two dead centres, and again where the slip had not quite ended
    assert number(run, "energy.friction") == pytest.approx(loss, abs=1e-10 * ENERGY)
    assert number(run, "energy.kinetic") == pytest.approx(ENERGY - loss, abs=1e-10 * ENERGY)


@pytest.mark.parametrize("step", [0.02, 0.005])
@pytest.mark.parametrize("held", HELD)
def test_a_yoke_turns_through_its_dead_centres_in_stepped_mode(held, step):
    """On two feet it stopped at the first one. The half step there has an error of second order."""
    run = Integrator(solver.assemble(solver.loads(YOKE + HELD[held])))
    run["solver.step_size"], run["solver.contact_mode"] = step, "stepped"
    run.initialise()
    for k in range(80):
        run.advance(0.05 * k, 0.05)
    turns, rest = divmod(number(run, "crank.angle"), np.pi)
    loss = FORCE * STROKE * (2.0 * turns + 1.0 - np.cos(rest))
    assert turns == 2.0
    assert number(run, "energy.friction") == pytest.approx(loss, abs=2e-6 * ENERGY)


@pytest.mark.parametrize("step", [1e-3, 5e-4])
def test_a_guide_with_play_takes_little_at_a_dead_centre(step):
    """Friction takes its force times the way in 1 ms about the dead centre, as an upper bound.

    Less than 4 N press the slider, which is no faster than at the ends of this time. 85 % of the
    energy went there, or the step failed.
    """
    scene = solver.load(SCENES / "slider_crank_with_play_in_the_guide.toml")
    run = Integrator(solver.assemble(scene))
    run["solver.step_size"], run["solver.order"] = step, 2.0
    run.initialise()
    for k in range(80):
        friction, speed = number(run, "energy.friction"), abs(number(run, "slider.vx"))
        run.advance(1e-3 * k, 1e-3)
        fastest = max(speed, abs(number(run, "slider.vx")))
        assert number(run, "solver.stepped") == 0.0
        if k == 34:
            assert number(run, "energy.friction") - friction < 0.01 * 4.0 * 1e-3 * fastest
    assert abs(number(run, "energy.error")) < 1e-12
