"""Compositions of pairs: orders 2, 4, 6 and 8 in coordinates and velocities, energy at round-off.

Suzuki's five stages, nine of Kahan & Li 1997 and fifteen of Suzuki & Umeno: every stage is a
conserving pair of half steps, so that the order costs nothing of what a step keeps.
"""

from __future__ import annotations

import functools
import math

import numpy as np
import pytest

import solver
from solver.runtime import Integrator
from tests.exact_motions import double_pendulum_motion
from tests.mechanism_runs import run, scene, vector
from tests.physics.test_linkages import ANDREWS, ANDREWS_AT_30_MS, angles_of_the_test_set
from tests.problems import Array, double_pendulum, observed_order
from tests.problems import scene as scene_of
from tests.twins import PENDULUM

STAGES = {2: 1, 4: 5, 6: 9, 8: 15}
QUIET = ["energy.error", "constraint.position"]

MANIPULATOR = """
name = "manipulator"
gravity = [0, 0, -3]
[bodies.crank]
position = [0.25, 0, 0]
mass = 1.0
inertia = [0.02, 0.05, 0.06]
[bodies.arm]
position = [0.5, 0.3, 0]
mass = 0.8
inertia = [0.1, 0.08, 0.12]
[bodies.tool]
position = [0.5, 0.6, -0.2]
mass = 0.5
inertia = [0.05, 0.06, 0.08]
[joints.bearing]
type = "revolute"
bodies = ["ground", "crank"]
position = [0, 0, 0]
axis = [0, 0, 1]
[joints.elbow]
type = "revolute"
bodies = ["crank", "arm"]
position = [0.5, 0, 0]
axis = [1, 0, 0.3]
[joints.wrist]
type = "universal"
bodies = ["arm", "tool"]
position = [0.5, 0.6, 0]
axes = [[1, 0, 0], [0, 1, 0]]
[drivers]
motor = { type = "angle", joint = "bearing", value = "0.8*sin(2*t) + 0.3*t" }
[forces]
spring = { type = "torsion_spring", joint = "elbow", stiffness = 1.0, free_angle = 0.3 }
[solver]
assemble = true
"""
"""A driven crank, an arm on a skew hinge with a spring, and a tool on a universal joint."""
PLACES = [*vector("arm"), *vector("tool")]
RATES = [*vector("arm", "v"), *vector("tool", "v")]


def end(mechanism: solver.Scene, names: list[str], stop: float, n: int, order: int) -> Array:
    """Values after n steps, each a composition of pairs."""
    return run(mechanism, names, stop / n, stop, order=order)[-1]


@functools.cache
def manipulator(n: int, order: int) -> Array:
    """Places, velocities, energy error and constraints of the manipulator at 1 s."""
    return end(solver.loads(MANIPULATOR), [*PLACES, *RATES, *QUIET], 1.0, n, order)


@pytest.mark.parametrize(
    ("order", "steps"),
    [(2, (100, 200, 400)), (4, (20, 40, 80)), (6, (20, 40, 80)), (8, (16, 24, 32))],
)
def test_a_double_pendulum_is_met_to_the_order_asked_for(order, steps):
    names = [f"{point}.{part}" for part in ("x", "y", "vx", "vy") for point in "AB"]
    q, v = double_pendulum_motion(np.array([0.0, 2.0]), math.pi / 6)
    exact = np.concatenate([q[-1].T.ravel(), v[-1].T.ravel()])
    drawn = scene_of(double_pendulum(math.pi / 6))
    ends = np.array([end(drawn, [*names, *QUIET], 2.0, n, order) for n in steps])
    errors = np.abs(ends[:, :8] - exact)
    lengths = [1.0 / n for n in steps]
    assert observed_order(lengths, errors[:, :4].max(axis=1)) == pytest.approx(order, abs=0.2)
    assert observed_order(lengths, errors[:, 4:].max(axis=1)) == pytest.approx(order, abs=0.2)
    assert ends[:, 8:].max() < 1e-14


@pytest.mark.parametrize(
    ("order", "steps"),
    [(2, (25, 50, 100)), (4, (10, 20, 40)), (6, (10, 16, 24)), (8, (4, 6, 9))],
)
def test_a_driven_mechanism_in_space_is_met_to_the_order_asked_for(order, steps):
    exact = manipulator(80, 8)
    ends = np.array([manipulator(n, order) for n in steps])
    errors = np.abs(ends - exact)
    lengths = [1.0 / n for n in steps]
    assert observed_order(lengths, errors[:, :6].max(axis=1)) == pytest.approx(order, abs=0.2)
    assert observed_order(lengths, errors[:, 6:12].max(axis=1)) == pytest.approx(order, abs=0.2)
    assert ends[:, 12:].max() < 1e-13


def test_order_eight_goes_where_order_two_goes():
    # Richardson from 500 and 1000 pairs: what is left is of fourth order, 1e-4 of the second's.
    coarse, fine = manipulator(500, 2), manipulator(1000, 2)
    assert manipulator(80, 8)[:12] == pytest.approx(((4 * fine - coarse) / 3)[:12], abs=1e-8)


@pytest.mark.parametrize("order", STAGES)
def test_as_many_pairs_are_solved_as_the_composition_has_stages(order):
    found = run(solver.loads(MANIPULATOR), ["solver.substeps"], 0.05, 0.2, order=order)
    assert found[-1, 0] == 2 * STAGES[order] * 4


@pytest.mark.parametrize("order", STAGES)
@pytest.mark.parametrize("name", ["bricard", "spatial_slider_crank", "heavy_top", "rolling_disc"])
def test_every_order_keeps_energy_and_constraints(name, order):
    h = 2 * solver.load(scene(name)).solver.step_size
    error, gap = run(name, QUIET, h, 40 * h, every=4 * h, order=order).T
    assert error.max() < 1e-12
    assert gap.max() < 1e-12


@pytest.mark.parametrize("tolerance", [0.0, 1e-3])
def test_dampers_limit_the_order_of_some_methods_to_two_and_that_is_said_once(tolerance):
    # Stages that go back in time would give back what a damper takes; weighted covers need a method
    # that conserves.
    text = f"""{PENDULUM}[forces.brake]
type = "damper"
points = ["A", "ground"]
at = [3, 0]
damping = 0.2
"""
    said: list[str] = []
    damped = solver.assemble(solver.loads(text))
    limited, second = (Integrator(damped, log=said.append) for _ in range(2))
    for run_ in (limited, second):
        run_["solver.formulation"], run_["solver.tolerance"] = "midpoint-al", tolerance
    limited["solver.order"], second["solver.order"] = 6.0, 2.0
    for run_ in (limited, second):
        for _ in range(3):
            run_.advance(run_.time, 0.1)
    assert limited["solver.order_in_use"] == 2.0
    assert limited["solver.order"] == 6.0
    assert limited["A.x"] == second["A.x"]
    (sentence,) = said
    assert sentence.startswith("solver.order is 6, but steps are of order 2")


def test_without_damping_the_order_is_the_one_asked_for():
    free = solver.Integrator(solver.assemble(solver.loads(MANIPULATOR)))
    free["solver.order"] = 6.0
    free.advance(0.0, 0.1)
    assert free["solver.order_in_use"] == 6.0


def test_the_squeezer_meets_the_published_angles_with_600_pairs_in_one_run():
    found = run("andrews", [*ANDREWS, *QUIET], 0.03 / 120, 0.03, order=4)[-1]
    assert angles_of_the_test_set(found[:7]) == pytest.approx(ANDREWS_AT_30_MS, abs=1e-6)
    assert found[7:].max() < 1e-12


@pytest.mark.parametrize("order", [4, 6])
def test_loads_of_time_keep_the_order(order):
    load = '[forces.load]\ntype = "joint_torque"\njoint = "elbow"\nvalue = "sin(3*t)"\n'
    drawn = solver.loads(MANIPULATOR + load)
    exact = end(drawn, [*PLACES, *RATES], 1.0, 80, 8)
    steps = (8, 12, 16)
    errors = [np.abs(end(drawn, [*PLACES, *RATES], 1.0, n, order) - exact).max() for n in steps]
    assert observed_order([1 / n for n in steps], errors) == pytest.approx(order, abs=0.2)
