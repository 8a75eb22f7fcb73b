"""A tolerance instead of a step: what a run's error is, and what stays exact whatever is chosen."""

from __future__ import annotations

import math

import numpy as np
import pytest

import solver
from benchmarks.tolerances import course_of
from solver.runtime import Integrator
from tests.exact_motions import double_pendulum_motion
from tests.mechanism_runs import scene
from tests.problems import Array, assemble, double_pendulum
from tests.twins import block, vector

SWING = double_pendulum(math.pi / 6)
POINTS = [f"{point}.{part}" for part in "xy" for point in "AB"]
RELATIVE = math.sqrt(2.0 * (2.0 * math.sin(math.pi / 6)) ** 2)


def swinging(tolerance: float, **settings: float) -> Integrator:
    """Double pendulum from 30 degrees over 10 s."""
    return Integrator(assemble(SWING, tolerance=tolerance, **settings))


def error_at_the_end(integrator: Integrator, step: float = 10.0) -> float:
    """Largest error of a coordinate at 10 s, in m; the mechanism is 2 m long."""
    for _ in range(round(10.0 / step)):
        integrator.advance(integrator.time, step)
    q, _ = double_pendulum_motion(np.array([0.0, 10.0]), math.pi / 6)
    return float(np.abs([integrator[name] for name in POINTS] - q[-1].T.ravel()).max())


def test_the_error_of_a_run_follows_the_request_within_a_decade():
    asked = [1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10]
    errors = [error_at_the_end(swinging(tolerance)) / 2.0 for tolerance in asked]
    for tolerance, error in zip(asked, errors, strict=True):
        assert 0.01 * tolerance < error < 10.0 * tolerance
    assert errors == sorted(errors, reverse=True)


def test_all_orders_are_open_to_a_tolerance_that_the_scene_did_not_ask_for():
    # It is assembled for order 2: higher ones begin with a poorer guess, and still take less.
    run = Integrator(assemble(SWING, order=2))
    run["solver.tolerance"], run["solver.order"], run["solver.longest_step"] = 1e-7, 0.0, 1e6
    assert error_at_the_end(run) / 2.0 < 1e-6
    assert run["solver.order_in_use"] > 4.0
    assert run["solver.substeps"] < 5000.0


@pytest.mark.parametrize("order", [2, 4, 6, 8])
def test_an_order_that_is_given_is_kept(order):
    tolerance = 1e-4 if order == 2 else 1e-6
    run = swinging(tolerance, order=order)
    assert error_at_the_end(run) / 2.0 < 10.0 * tolerance
    assert run["solver.order_in_use"] == order


def test_shorter_communication_steps_choose_lower_orders_and_meet_them_exactly():
    orders = []
    for step in (5.0, 0.05, 0.001):
        run = swinging(1e-4)
        for _ in range(10):
            run.advance(run.time, step)
        assert run.time == pytest.approx(10 * step, abs=1e-15)
        orders.append(float(run["solver.order_in_use"]))
    assert orders == sorted(orders, reverse=True)
    assert orders[0] > 2.0 == orders[-1]
    assert run["solver.substeps"] == 2.0


@pytest.mark.parametrize("name", ["bricard", "heavy_top", "four_bar", "rolling_disc", "andrews"])
@pytest.mark.parametrize("tolerance", [1e-3, 1e-8])
def test_energy_and_constraints_stay_at_round_off_for_any_sequence_of_steps(name, tolerance):
    run = Integrator(solver.assemble(solver.load(scene(name))))
    run["solver.tolerance"], run["solver.order"] = tolerance, 4.0
    stop = min(1.0, run.model.experiment.stop_time)
    for _ in range(5):
        run.advance(run.time, stop / 5)
    assert float(run["energy.error"]) < 1e-12
    assert float(run["constraint.position"]) < 1e-12


def test_a_saved_state_chooses_the_same_to_the_last_bit():
    first, second = (swinging(1e-5) for _ in range(2))
    for _ in range(3):
        first.advance(first.time, 0.1)
    second.restore(first.save())
    for run in (first, second):
        for _ in range(3):
            run.advance(run.time, 0.1)
    assert np.array_equal(block(first), block(second))


def test_an_absolute_tolerance_is_a_floor_under_the_relative_one():
    coarse, fine = swinging(1e-8, absolute_tolerance=1e-3), swinging(1e-8)
    assert 1e-6 < error_at_the_end(coarse) < 1e-2
    assert error_at_the_end(fine) < 1e-7
    assert coarse["solver.substeps"] < fine["solver.substeps"]


def test_longest_step_is_then_the_longest_internal_step():
    run = swinging(0.1, longest_step=0.01, order=2)
    run.advance(0.0, 1.0)
    assert run["solver.substeps"] >= 200.0


PUSHED = """
name = "pushed"
dimension = 2
[points]
A = { position = [0, 0], mass = 1.0 }
[inputs]
push = { unit = "N" }
[forces]
pull = { type = "force", point = "A", value = ["push", 0] }
spring = { type = "spring", points = ["ground", "A"], at = [[-1, 0], [0, 0]], stiffness = 40.0 }
damper = { type = "damper", points = ["ground", "A"], at = [[-1, 0], [0, 0]], damping = 0.5 }
"""


def pushed(**settings: float) -> float:
    """Place after 5 s of a damped mass, pushed anew at each communication point."""
    run = Integrator(solver.assemble(solver.loads(PUSHED)))
    for name, value in settings.items():
        run[f"solver.{name}"] = value
    for k in range(20):
        run["push"] = 5.0 * math.sin(1.7 * k)
        run.advance(run.time, 0.25)
    return float(run["A.x"])


def test_inputs_that_jump_at_each_communication_point_do_not_switch_the_control_off():
    # A pair is judged by the one before it, which a jump forgets: two are taken then.
    exact = pushed(step_size=1e-4)
    for tolerance in (1e-2, 1e-3, 1e-4):
        assert abs(pushed(tolerance=tolerance) - exact) < 10.0 * tolerance


def test_the_order_and_length_of_steps_are_left_to_the_tolerance_in_a_scene_too():
    settings = solver.loads(
        'name = "one"\n[points.A]\nposition = [0, 0, 0]\nmass = 1.0\n[solver]\ntolerance = 1e-5\n'
    ).solver
    assert (settings.order, settings.tolerance) == (0, 1e-5)
    assert settings.longest_step == solver.scene.SolverSettings().longest_step


def test_a_mechanism_that_nothing_has_moved_yet_begins_as_well():
    # Its reference energy is 0, so that an error of its velocities has nothing to be relative to.
    run = Integrator(solver.assemble(solver.load(scene("snakeboard"))))
    run["solver.tolerance"] = 1e-5
    for _ in range(5):
        run.advance(run.time, 0.1)
    assert float(run["constraint.velocity"]) < 1.0
    assert abs(float(run["energy.balance"])) < 1e-12


def test_steps_do_not_shrink_to_nothing_where_round_off_is_all_that_is_left():
    # Jansen's legs pass near singular places, where velocities have few digits.
    run = Integrator(solver.assemble(solver.load(scene("jansen"))))
    run["solver.tolerance"] = 1e-9
    run["solver.order"] = 4.0
    for _ in range(3):
        run.advance(run.time, 0.1)
    assert run.state.head["wanted"] > 1e-5


TWELVE = (
    *("andrews", "bricard", "car_axis", "double_pendulum", "dzhanibekov", "four_bar"),
    *("heavy_top", "pendulum", "rolling_disc", "snakeboard", "triangle", "watt"),
)


@pytest.mark.parametrize("name", TWELVE)
def test_scenes_stay_within_a_decade_of_the_request_which_errors_follow(name):
    # Places and rates in the mass norm over size and speed, at ten points; the order is chosen.
    asked = (1e-3, 1e-5, 1e-7, 1e-9)
    exact = course_of(name, 1e-11, 5.0)
    errors = [course_of(name, tolerance, 5.0).error(exact) for tolerance in asked]
    for tolerance, error in zip(asked, errors, strict=True):
        assert 0.1 * tolerance < error < 10.0 * tolerance
    assert errors == sorted(errors, reverse=True)


def test_an_error_far_from_the_mean_over_mechanisms_is_learned_from_steps_of_half_the_length():
    # Order 6 errs ten times more in a rolling disc than in the mean, and less in a spinning top.
    learned: dict[str, float] = {}
    for name in ("rolling_disc", "heavy_top"):
        run = Integrator(solver.assemble(solver.load(scene(name))))
        run["solver.tolerance"], run["solver.order"] = 1e-6, 6.0
        run.state.head["horizon"] = 1.0
        run.advance(run.time, 0.5)
        learned[name] = math.exp(run.state.head["learned_6"])
    assert learned["rolling_disc"] > 2.0
    assert learned["heavy_top"] < 0.8


@pytest.mark.parametrize("order", [4, 6, 8])
def test_measuring_the_error_of_a_step_leaves_the_motion_as_it_is(order):
    # Nothing but the choice of steps may follow from it: one step is too few to be measured, and
    # the second is measured, but as long as both have their greatest length they are the same.
    ends = []
    for judged in (0.0, 10.0):
        run = swinging(1e-1, order=order, step_size=0.05)
        run.initialise()
        run.state.head["wanted"], run.state.head[f"judged_{order}"] = 0.05, judged
        run.advance(0.0, 0.1)
        ends.append(vector(run, "q"))
        assert (run.state.head[f"learned_{order}"] != 0.0) == (judged == 0.0)
    assert np.array_equal(*ends)


def test_a_mechanism_of_nanometres_moves_like_one_of_metres():
    # Periods go with the root of the length: all steps are then shorter than 1e-5 of `step_size`,
    # which under a tolerance says nothing about them. Forces are the same, places in proportion.
    places: list[Array] = []
    forces: list[float] = []
    for size in (1.0, 1e-14):
        points = [(0.5 * size * k, -math.sqrt(0.75) * size * k) for k in range(3)]
        text = f"""
            name = "scaled"
            dimension = 2
            gravity = [0, -9.81]
            [points]
            O = {{ position = [0, 0], fixed = true }}
            A = {{ position = {list(points[1])}, mass = 1.0 }}
            B = {{ position = {list(points[2])}, mass = 1.0 }}
            [joints]
            upper = {{ type = "distance", points = ["O", "A"] }}
            lower = {{ type = "distance", points = ["A", "B"] }}
            [solver]
            tolerance = 1e-6
        """
        run = Integrator(solver.assemble(solver.loads(text)))
        run.initialise()
        run.state.head["horizon"] = math.sqrt(size)
        run.advance(0.0, math.sqrt(size))
        places.append(vector(run, "q") / size)
        forces.append(float(run["upper.force"]))
    assert np.abs(places[1] - places[0]).max() < 1e-5
    assert forces[1] == pytest.approx(forces[0], rel=1e-3)
