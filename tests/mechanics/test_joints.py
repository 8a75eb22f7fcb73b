"""Every joint: its freedom, what two free bodies keep, second order, and its reactions."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

import solver
from solver.mechanics.mobility import survey
from tests.free_flight import assert_nothing_is_lost
from tests.joint_scenes import PAIRS, PLANAR, SPATIAL, pair

REACTING = [
    (dimension, kind)
    for dimension, kind in PAIRS
    if kind not in ("distance", "angle", "point_on_surface", "screw")
]
"""Joints with a reaction force at one place; of a screw, the thread's part is a driver's."""


def _run(scene: str, stop: float, step: float) -> solver.Trajectory:
    return solver.simulate(solver.loads(scene), stop_time=stop, step_size=step)


@pytest.mark.parametrize(("dimension", "kind"), PAIRS)
def test_a_joint_takes_the_freedom_of_the_textbook(dimension: int, kind: str) -> None:
    rows = (SPATIAL if dimension == 3 else PLANAR)[kind][1]
    found = survey(solver.assemble(solver.loads(pair(dimension, kind, 0.01))))
    assert found.degrees_of_freedom == (12 if dimension == 3 else 6) - rows
    assert found.redundant_rows == 0


@pytest.mark.parametrize(("dimension", "kind"), PAIRS)
def test_free_bodies_keep_energy_and_momenta_for_ten_thousand_large_steps(
    dimension: int, kind: str
) -> None:
    """0.1 s at 1.3 to 1.7 rad/s; relative to the energy, and to the momenta's own size."""
    run = _run(pair(dimension, kind, 0.1), 1000.0, 10.0)
    assert_nothing_is_lost(run, dimension)


@pytest.mark.parametrize(("dimension", "kind"), PAIRS)
def test_a_joint_keeps_second_order(dimension: int, kind: str) -> None:
    names = ["B.x", "B.y", "B.vx", "B.vy"]
    ends = []
    for h in (0.04, 0.02, 0.01):
        run = _run(pair(dimension, kind, h), 1.0, 1.0)
        ends.append(np.array([run[name][-1] for name in names]))
    coarse, fine = (float(np.linalg.norm(a - b)) for a, b in pairwise(ends))
    if coarse < 1e-9:
        assert kind == "fixed"  # one free body: its centre moves on a straight line
        return
    assert np.log2(coarse / fine) == pytest.approx(2.0, abs=0.15)


@pytest.mark.parametrize(("dimension", "kind"), REACTING)
def test_the_reaction_is_what_accelerates_the_second_body(dimension: int, kind: str) -> None:
    """No other force acts on B: F = m dv/dt of its centre of mass, by central differences."""
    axes, step = "xyz"[:dimension], 1e-3
    text = pair(dimension, kind, step).replace("center_of_mass = [0.02, 0.05, -0.03]\n", "")
    run = _run(text.replace("center_of_mass = [0.02, 0.05]\n", ""), 0.2, step)
    for axis in axes:
        speed, force = run[f"B.v{axis}"], run[f"joint.force.{axis}"]
        acceleration = (speed[2:] - speed[:-2]) / (2 * step)
        scale = np.max(np.abs(force)) + 1e-3
        assert np.max(np.abs(force[1:-1] - acceleration)) < 1e-4 * max(scale, 1.0)
