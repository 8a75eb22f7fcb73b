"""Explicit steps under a tolerance: their coefficients, orders, reactions and laws that jump."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from functools import cache
from itertools import combinations_with_replacement
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.integrate import quad, solve_ivp

import solver
from solver.runtime import Integrator
from tests.support.kernel.twins import vector
from tests.support.mechanisms.mechanism_runs import scene, steps_explicitly
from tests.support.mechanisms.problems import GRAVITY

TEXT = (
    Path(__file__).parents[2] / "solver" / "kernel" / "methods" / "runge_kutta_methods.h"
).read_text("utf-8")
"""Where the kernel has the coefficients."""

Array = NDArray[np.float64]
Tree = tuple["Tree", ...]
"""A rooted tree: its subtrees."""

METHODS = {5: ("FIFTH_ORDER", (4,)), 8: ("EIGHTH_ORDER", (5, 3))}
"""By order: its name, and the orders of what the differences are taken from."""


def _number(text: str) -> float:
    above, _, below = text.partition("/")
    return float(above) / float(below or 1.0)


@cache
def coefficients(order: int) -> tuple[Array, Array, Array, list[Array]]:
    """Parts, times and weights of the stages, and weights of the differences."""
    name = METHODS[order][0]
    body = re.findall(rf"{name} = \{{(.*?)\}};", TEXT, re.DOTALL)[0]
    rows = [
        [_number(x) for x in row.replace(" ", "").split(",") if x]
        for row in re.findall(r"\{([^{}]*)\}", body.replace("\n", ""))
    ]
    stages = len(METHODS[order][1]) * 6
    parts = np.zeros((stages, stages))
    for i, row in enumerate(rows[:stages]):
        parts[i, : len(row)] = row
    node, weight, *differences = (np.array(row) for row in rows[stages:])
    return parts, node, weight, differences


@cache
def trees(size: int) -> list[Tree]:
    """All rooted trees with so many nodes."""

    def forests(nodes: int, largest: int) -> list[Tree]:
        if nodes == 0:
            return [()]
        found: list[Tree] = []
        for first in range(min(nodes, largest), 0, -1):
            for count in range(nodes // first, 0, -1):
                for some in combinations_with_replacement(trees(first), count):
                    found += [(*some, *rest) for rest in forests(nodes - count * first, first - 1)]
        return found

    return forests(size - 1, size - 1)


def nodes(tree: Tree) -> int:
    return 1 + sum(map(nodes, tree))


def density(tree: Tree) -> float:
    return nodes(tree) * math.prod(map(density, tree))


def stage_values(tree: Tree, parts: Array) -> Array:
    """Of each stage: product over the subtrees of the sums that their stages come to."""
    product = np.ones(len(parts))
    for branch in tree:
        product = product * (parts @ stage_values(branch, parts))
    return product


def defect(weight: Array, parts: Array, order: int, exact: Callable[[Tree], float]) -> float:
    """Largest error in the conditions of an order (Butcher 1963)."""
    return max(abs(weight @ stage_values(tree, parts) - exact(tree)) for tree in trees(order))


def test_there_are_as_many_rooted_trees_as_known():
    assert [len(trees(size)) for size in range(1, 10)] == [1, 1, 2, 4, 9, 20, 48, 115, 286]


@pytest.mark.parametrize("order", METHODS)
def test_the_coefficients_fulfil_all_conditions_of_their_order_and_not_of_the_next(order):
    parts, node, weight, _ = coefficients(order)
    assert np.abs(parts.sum(axis=1) - node).max() < 1e-14
    for size in range(1, order + 1):
        assert defect(weight, parts, size, lambda tree: 1.0 / density(tree)) < 1e-14
    assert defect(weight, parts, order + 1, lambda tree: 1.0 / density(tree)) > 1e-8


@pytest.mark.parametrize("order", METHODS)
def test_differences_vanish_to_the_order_of_what_they_are_taken_from(order):
    parts, _, _, differences = coefficients(order)
    for weight, lower in zip(differences, METHODS[order][1], strict=True):
        for size in range(1, lower + 1):
            assert defect(weight, parts, size, lambda _: 0.0) < 1e-14
        assert defect(weight, parts, lower + 1, lambda _: 0.0) > 1e-6


def moved(name: str, count: int, stop: float) -> Array:
    """Places after so many explicit steps of order 8."""
    run = Integrator(solver.assemble(solver.load(scene(name))))
    settings = {"tolerance": 0.1, "order": 8, "longest_step": stop / count, "method": "fastest"}
    for option, value in settings.items():
        run[f"solver.{option}"] = value
    run.initialise()
    run.state.head["wanted"] = run.state.head["horizon"] = stop / count
    run.advance(0.0, stop)
    assert run["solver.substeps"] == 12 * count
    return vector(run, "q")


@pytest.mark.parametrize(
    ("name", "stop", "count"),
    [
        ("double_pendulum", 1.0, 8),
        ("heavy_top", 0.1, 4),
        ("rolling_disc", 0.5, 8),
        ("chaplygin_sleigh", 1.0, 4),
        ("triangle", 0.25, 8),
        ("spring_pendulum", 1.0, 8),
        ("bifilar", 1.0, 8),
        ("bricard", 0.5, 2),  # whose rows depend on each other, though not off them
    ],
)
def test_explicit_steps_have_order_eight(name, stop, count):
    """Points, bodies, springs, dampers, rows of velocities, loops, loads of the time."""
    exact = moved(name, 64, stop)
    coarse, fine = (np.abs(moved(name, n, stop) - exact).max() for n in (count, 2 * count))
    assert 100.0 < coarse / fine < 400.0


def test_a_load_that_jumps_where_a_step_ends_costs_no_accuracy_and_no_steps():
    """A mass of 1 kg is pushed by 1 N for 1 s: x = 1/2 + (t - 1) after it."""
    text = """
        name = "jump"
        dimension = 2
        [points]
        A = { position = [0, 0], mass = 1.0 }
        [forces]
        push = { type = "force", point = "A", value = ["1 if t < 1 else 0", 0] }
        [solver]
        tolerance = 1e-8
        method = 'fastest'
    """
    run = Integrator(solver.assemble(solver.loads(text)))
    for end in (0.5, 1.0, 1.5, 2.0):
        run.advance(run.time, 0.5)
        assert run["A.x"] == pytest.approx(0.5 * end**2 if end <= 1.0 else end - 0.5, rel=1e-12)
        assert run["energy.work"] == pytest.approx(min(end, 1.0) ** 2 / 2.0, rel=1e-12)


TURNING = """
name = "turning"
dimension = 2
[bodies]
left = { position = [0, 0], mass = 1.0, inertia = 0.5, angular_velocity = 7.0 }
right = { position = [0, 0], mass = 1.0, inertia = 0.5, angular_velocity = -5.0 }
[joints]
pivot = { type = "revolute", bodies = ["ground", "left"], position = [0, 0] }
hinge = { type = "revolute", bodies = ["left", "right"], position = [0, 0] }
[solver]
tolerance = 0.1
method = 'fastest'
"""


@pytest.mark.parametrize("order", [0, 8])
@pytest.mark.parametrize(
    "drawn",
    [
        "inertia = 0.5, angular_velocity = -5.0",
        "inertia = 0.5, angular_velocity = -5.0, orientation = 1.5707963267948966",
    ],
)
def test_angles_keep_their_turns_in_long_steps(order, drawn):
    """Two bodies turn steadily, against each other, by less than pi in each step."""
    text = TURNING.replace("inertia = 0.5, angular_velocity = -5.0", drawn)
    run = Integrator(solver.assemble(solver.loads(text)))
    run["solver.order"] = order
    for _ in range(20):
        run.advance(run.time, 0.7)
        assert run["pivot.angle"] == pytest.approx(7.0 * run.time, rel=1e-12)
        assert run["hinge.angle"] == pytest.approx(-12.0 * run.time, rel=1e-12)
        assert steps_explicitly(run)


def test_a_load_that_pauses_at_both_ends_of_a_step_changes_the_momentum():
    """A mass flies along x and is pushed across, by sin(2 pi t): v = (1 - cos 2 pi t)/2 pi."""
    text = """
        name = "pushed_across"
        dimension = 2
        [points]
        A = { position = [0, 0], mass = 1.0, velocity = [3.0, 0.0] }
        B = { position = [1, 0], mass = 1.0, velocity = [3.0, 0.5] }
        [joints]
        rod = { type = "distance", points = ["A", "B"] }
        [forces]
        push = { type = "force", point = "A", value = [0, "sin(2*pi*t)"] }
        [solver]
        tolerance = 1e-6
        method = 'fastest'
        assemble = true
    """
    run = Integrator(solver.assemble(solver.loads(text)))
    before = float(run["momentum.y"])
    for _ in range(8):
        run.advance(run.time, 0.25)
        gained = (1.0 - math.cos(2.0 * math.pi * run.time)) / (2.0 * math.pi)
        assert run["momentum.y"] - before == pytest.approx(gained, abs=1e-6)


def test_half_steps_pass_a_singular_place_that_leaves_accelerations_undetermined():
    """A parallelogram through its straight position (IFToMM A02), at a tolerance near round-off."""
    run = Integrator(solver.assemble(solver.load(scene("four_bar"))))
    run["solver.tolerance"], run["solver.longest_step"] = 1e-11, 1e6
    run["solver.method"] = "fastest"
    for _ in range(10):
        run.advance(run.time, 0.5)
        assert run["energy.error"] < 1e-13
        assert run["solver.substeps"] < 2000.0


@pytest.mark.parametrize("order", [0.0, 4.0])
@pytest.mark.parametrize("tolerance", [1e-4, 1e-8])
@pytest.mark.parametrize("apart", [1e-3, -1e-5, 1e-7, -1e-9, 0.0])
def test_communication_points_near_a_singular_place_cost_no_accuracy(order, tolerance, apart):
    """Rods in parallel, 3 a'' = -3.5 g cos a, a' = -1 rad/s at 90 deg, are flat after 0.71 s."""
    rate = quad(
        lambda a: 1.0 / math.sqrt(1.0 + 7.0 / 3.0 * GRAVITY * (1.0 - math.sin(a))), 0.0, math.pi / 2
    )
    run = Integrator(solver.assemble(solver.load(scene("four_bar"))))
    run["solver.tolerance"], run["solver.order"], run["solver.longest_step"] = tolerance, order, 1e6
    for step in (rate[0] + apart, 0.5):
        run.advance(run.time, step)
        found = solve_ivp(
            lambda _, y: [y[1], -3.5 / 3.0 * GRAVITY * math.cos(y[0])],
            (0.0, run.time),
            [math.pi / 2, -1.0],
            method="DOP853",
            rtol=1e-13,
            atol=1e-13,
        )
        angle, speed = found.y[:, -1]
        assert run["B0.x"] == pytest.approx(math.cos(angle), abs=3.0 * tolerance)
        assert run["B1.y"] == pytest.approx(math.sin(angle), abs=3.0 * tolerance)
        assert run["B1.vy"] == pytest.approx(speed * math.cos(angle), abs=3.0 * tolerance * 4.9)


def test_a_long_chain_of_springs_is_as_fast_as_its_shortest_wave():
    """Masses between springs swing with 2 sqrt(k/m) at most, every other one with sqrt(2 k/m)."""
    n = 100
    wave = [math.sin(math.pi * 50 * i / n) for i in range(n + 1)]
    text = """
        name = "springs"
        dimension = 2
        [solver]
        tolerance = 1e-3
        method = 'fastest'
        longest_step = 10.0
        [points]
    """
    for i, speed in enumerate(wave):
        ends = ", fixed = true" if i in (0, n) else f", mass = 1.0, velocity = [{speed}, 0]"
        text += f"P{i} = {{ position = [{10 * i}, 0]{ends} }}\n"
    text += "[forces]\n"
    for i in range(n):
        law = "stiffness = 1.0, free_length = 10.0"
        text += f'S{i} = {{ type = "spring", points = ["P{i}", "P{i + 1}"], {law} }}\n'
    run = Integrator(solver.assemble(solver.loads(text)))
    run.advance(0.0, 10.0)
    rate = 2.0 * math.sin(math.pi * 50 / (2 * n))
    for i in (1, 3, 51):
        assert float(run[f"P{i}.vx"]) == pytest.approx(wave[i] * math.cos(rate * 10.0), abs=5e-3)
    assert run["solver.substeps"] <= 12 * 8 + 20  # at the end all stand, which a cover passes


def test_what_drivers_move_alone_runs_under_a_tolerance():
    """Nothing is free, and there is no mass that errors could be measured by."""
    spring = Path(__file__).resolve().parents[2] / "examples" / "coupling_spring.toml"
    scene = solver.load(spring, {"solver.tolerance": 1e-6, "solver.method": "fastest"})
    moved = solver.simulate(scene, stop_time=0.1, inputs={"ax": lambda t: 0.6 + t})
    length = math.hypot(2.0 - moved["a.x"][-1], -1.2 + 1.8)
    assert moved["a.x"][-1] == pytest.approx(0.7, abs=1e-12)
    assert moved["spring.force"][-1] == pytest.approx(40.0 * (length - 1.0), rel=1e-12)
