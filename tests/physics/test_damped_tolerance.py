"""A tolerance where dampers take energy out: orders above 2 are open, and judged by weights.

The difference of the weighted end from that of one order less tells the error of a step; where the
weighted end is not taken, its difference from the end that is.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Iterator

import numpy as np
import pytest

import solver
from solver.runtime import Integrator
from tests.benchmarks.test_tolerance import PUSHED, pushed
from tests.kernel_calls import kernel_of
from tests.mechanism_runs import scene
from tests.physics.test_extrapolation import DRIVEN, FLYING, OSCILLATOR, RESTLESS
from tests.problems import Array
from tests.twins import block, vector

TEXTS = {"driven": DRIVEN, "flying": FLYING, "restless": RESTLESS, "oscillator": OSCILLATOR}
STOPS = {"flyball_governor": 1.0, "spring_pendulum": 5.0, "double_wishbone": 1.0}
"""Seconds; 2 for the others."""

RESTING = """
name = "resting"
dimension = 2
gravity = [0, -9.81]
[points]
O = { position = [0, 0], fixed = true }
A = { position = [0.8, -0.6], mass = 1.0 }
[joints]
rod = { type = "distance", points = ["O", "A"] }
[forces]
brake = { type = "damper", points = ["A", "ground"], at = [2, 0], damping = 5 }
"""
"""A pendulum that comes to rest within a few seconds."""


def prepared(name: str, stop: float = 0.0, **settings: float) -> Integrator:
    """Scene that is about to run for `stop` s, and as long as in `STOPS` if that is 0."""
    drawn = solver.loads(TEXTS[name]) if name in TEXTS else solver.load(scene(name))
    run = Integrator(solver.assemble(drawn))
    for setting, value in ({"longest_step": 1e6, "order": 0.0} | settings).items():
        run[f"solver.{setting}"] = value
    run.initialise()
    run.state.head["horizon"] = stop or STOPS.get(name, 2.0)
    return run


def parts_of(run: Integrator, points: int = 10) -> Iterator[float]:
    """Move over the horizon; yield the half steps solved in each communication step."""
    for _ in range(points):
        run.advance(run.time, run.state.head["horizon"] / points)
        yield run.state.head["substeps"]


@dataclasses.dataclass(frozen=True)
class Course:
    """Places over size and rates (points, n) in the mass norm, and the speed to compare with."""

    q: Array
    v: Array
    speed: float
    halves: float
    order: float

    def error(self, exact: Course) -> float:
        of_q, of_v = (self.q - exact.q), (self.v - exact.v) / exact.speed
        return max(float(np.linalg.norm(part, axis=1).max()) for part in (of_q, of_v))


def course_of(name: str, **settings: float) -> Course:
    run, found, halves = prepared(name, **settings), list[Array](), 0.0
    sizes, at = run.model.sizes, run.model.offsets["node_mass"]
    free = sizes["dim"] * sizes["n_free"]
    mass = np.array(kernel_of(run).numbers[at : at + sizes["n_free"]])
    root = np.sqrt(np.repeat(mass, sizes["dim"]))
    for solved in parts_of(run):
        halves += solved
        found.append(np.array([root * vector(run, part)[:free] for part in "qv"]))
    places, rates = np.swapaxes(np.array(found), 0, 1)
    speed = math.sqrt(2.0 * run.state.head["energy_reference"])
    size = float(run.state.vectors["derived"][1])
    return Course(places / size, rates, speed, halves, run.state.head["order_in_use"])


@pytest.mark.parametrize(
    "name", ["flyball_governor", "spring_pendulum", "double_wishbone", "flying", "restless"]
)
def test_errors_with_dampers_stay_within_a_decade_of_the_request_which_they_follow(name):
    # Steps of order 8 are exact to 2e-11 in the governor and 1e-13 in the others (half the length).
    exact = course_of(name, order=8.0, step_size=STOPS.get(name, 2.0) / 1000, tolerance=0.0)
    asked = (1e-3, 1e-5, 1e-7, 1e-9)
    courses = [course_of(name, tolerance=tolerance) for tolerance in asked]
    errors = [course.error(exact) for course in courses]
    for tolerance, error in zip(asked, errors, strict=True):
        assert 0.1 * tolerance < error < 10.0 * tolerance
    assert errors == sorted(errors, reverse=True)
    assert courses[-1].order > 4.0


@pytest.mark.parametrize(
    ("name", "times"), [("spring_pendulum", 8.0), ("flyball_governor", 4.0), ("driven", 6.0)]
)
def test_a_narrow_tolerance_takes_fewer_half_steps_than_with_order_two(name, times):
    chosen, second = (sum(parts_of(prepared(name, tolerance=1e-6, order=p))) for p in (0.0, 2.0))
    assert times * chosen < second


@pytest.mark.parametrize("order", [2, 4, 6, 8])
@pytest.mark.parametrize("name", ["flying", "driven"])
def test_an_order_that_is_given_is_kept_with_dampers(name, order):
    run = prepared(name, tolerance=1e-4, order=order)
    for _ in parts_of(run):
        assert run["solver.order_in_use"] == order


@pytest.mark.parametrize("tolerance", [1e-2, 1e-5, 1e-8])
@pytest.mark.parametrize("name", ["flyball_governor", "double_wishbone", "flying", "restless"])
def test_ledger_and_constraints_hold_under_a_tolerance_and_no_step_gives_energy(name, tolerance):
    run, lost = prepared(name, tolerance=tolerance), [0.0]
    for _ in parts_of(run):
        lost.append(float(run["energy.dissipated"]))
        assert float(run["energy.error"]) < 1e-12
        assert float(run["constraint.position"]) < 1e-13
    assert run.time == pytest.approx(STOPS.get(name, 2.0), abs=1e-14)
    assert min(np.diff(lost)) >= 0.0
    assert lost[-1] > 0.0


@pytest.mark.parametrize("tolerance", [1e-2, 1e-5])
def test_a_saved_state_with_dampers_chooses_the_same_to_the_last_bit(tolerance):
    first, second = (prepared("driven", tolerance=tolerance) for _ in range(2))
    for _ in range(3):
        first.advance(first.time, 0.1)
    second.restore(first.save())
    for run in (first, second):
        for _ in range(3):
            run.advance(run.time, 0.1)
    assert np.array_equal(block(first), block(second))


def test_an_end_whose_weighted_one_is_not_taken_is_judged_by_its_own_order():
    # Under so wide a tolerance a step of half a second is taken for good, though weights change it
    # by more than is sure: it is of order 2, and said to be so.
    run = prepared("oscillator", stop=10.0, tolerance=0.1, order=4.0)
    orders: list[float] = []
    for _ in parts_of(run):
        orders.append(float(run["solver.order_in_use"]))
        assert abs(float(run["energy.balance"])) < 1e-13
    assert 2.0 in orders
    # Under a narrow one it is repeated by shorter ones, whose weighted ends are taken.
    narrow = prepared("oscillator", stop=10.0, tolerance=1e-5, order=4.0)
    narrow.advance(0.0, 1.0)
    assert narrow["solver.order_in_use"] == 4.0
    # x'' + x' + 9 x = 0 from (0.5, 0.5)
    w, b = math.sqrt(8.75), 0.75 / math.sqrt(8.75)
    x = math.exp(-0.5) * (0.5 * math.cos(w) + b * math.sin(w))
    assert narrow["A.x"] == pytest.approx(1.5 + x, abs=1e-4)


@pytest.mark.parametrize("order", [0, 4, 8])
def test_steps_do_not_shrink_where_dampers_bring_a_mechanism_to_rest(order):
    # Without velocities no energy can be brought onto the ledger by them.
    run = Integrator(solver.assemble(solver.loads(RESTING)))
    run["solver.tolerance"], run["solver.order"], run["solver.longest_step"] = 1e-6, order, 1e6
    run.initialise()
    for _ in range(10):
        run.advance(run.time, 5.0)
    assert run["solver.substeps"] <= 20.0
    assert run["A.x"] == pytest.approx(0.0, abs=1e-6)
    assert abs(float(run["energy.balance"])) < 1e-13


def test_pushes_from_rest_are_followed_to_the_tolerance():
    # Before the first push nothing tells a length, and a pair has none before it to be judged by.
    exact = pushed(order=8.0, step_size=5e-3)
    for tolerance in (1e-4, 1e-6):
        end = pushed(tolerance=tolerance, order=0.0, longest_step=1e6)
        assert abs(end - exact) < 3.0 * tolerance


def test_loads_that_read_a_damped_mechanism_leave_the_choice_at_order_two():
    follows = PUSHED.replace('["push", 0]', '["push - 0.3*A.vx", 0]')
    run = Integrator(solver.assemble(solver.loads(follows)))
    run["solver.tolerance"], run["solver.order"], run["push"] = 1e-4, 0.0, 1.0
    with pytest.warns(RuntimeWarning, match="a load reads the mechanism"):
        run.advance(0.0, 0.5)
    assert run["solver.order_in_use"] == 2.0
