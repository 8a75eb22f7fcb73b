"""Every joint and coupling: its freedom, what free bodies keep, second order, and its reactions."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

import solver
from solver.mechanics.mobility import survey
from tests.support.mechanisms.joint_scenes import COUPLINGS, PAIRS, PLANAR, SPATIAL, pair, train

EVERY = pytest.mark.parametrize(("dimension", "kind"), [*PAIRS, *COUPLINGS])


def _run(scene: str, stop: float, step: float) -> solver.Trajectory:
    return solver.simulate(solver.loads(scene), stop_time=stop, step_size=step)


def assert_nothing_is_lost(run: solver.Trajectory, dimension: int) -> None:
    """Energy and momenta to 1e-11 of their own size, constraints to 1e-12, all along a run."""
    energy = run["energy.total"]
    assert np.ptp(energy) < 1e-11 * energy[0]
    assert np.max(run["constraint.position"]) < 1e-12
    axes, turning = ("xy", "z") if dimension == 2 else ("xyz", "xyz")
    for name, parts in (("momentum", axes), ("angular_momentum", turning)):
        vector = np.stack([run[f"{name}.{axis}"] for axis in parts])
        drift = np.max(np.abs(vector - vector[:, :1]))
        assert drift < 1e-11 * np.linalg.norm(vector[:, 0])


def drawn(dimension: int, kind: str, h: float) -> str:
    """Scene of a joint or coupling."""
    return (train if (dimension, kind) in COUPLINGS else pair)(dimension, kind, h)


@EVERY
def test_a_joint_takes_the_freedom_of_the_textbook(dimension: int, kind: str) -> None:
    is_train = (dimension, kind) in COUPLINGS
    joints = SPATIAL if dimension == 3 else PLANAR
    rows = COUPLINGS[dimension, kind][-1] if is_train else joints[kind][-1]
    found = survey(solver.assemble(solver.loads(drawn(dimension, kind, 0.01))))
    assert found.degrees_of_freedom == (6 if dimension == 3 else 3) * (2 + is_train) - rows
    assert found.redundant_rows == 0


@EVERY
def test_free_bodies_keep_energy_and_momenta_for_ten_thousand_large_steps(
    dimension: int, kind: str
) -> None:
    """0.1 s at 1 to 2 rad/s; relative to the energy, and to the momenta's own size."""
    run = _run(drawn(dimension, kind, 0.1), 1000.0, 10.0)
    assert_nothing_is_lost(run, dimension)
    if (dimension, kind) in COUPLINGS:
        angle = run["first.angle"]
        assert np.ptp(angle) > 100 * 2 * np.pi
        second = run["second.angle" if kind[0] == "g" else "second.displacement"]
        # 1e-12: a few last digits of angles of 1000 rad.
        assert second == pytest.approx((-1.5 if kind[0] == "g" else 0.12) * angle, abs=1e-12)


@EVERY
def test_a_joint_keeps_second_order(dimension: int, kind: str) -> None:
    names = ["B.x", "B.y", "B.vx", "B.vy"]
    if (dimension, kind) in COUPLINGS:
        names += ["first.angle", "first.angular_velocity"]
    ends = []
    for h in (0.04, 0.02, 0.01):
        run = _run(drawn(dimension, kind, h), 1.0, 1.0)
        ends.append(np.array([run[name][-1] for name in names]))
    coarse, fine = (float(np.linalg.norm(a - b)) for a, b in pairwise(ends))
    if coarse < 1e-9:
        assert kind == "fixed"  # one free body: its centre moves on a straight line
        return
    assert np.log2(coarse / fine) == pytest.approx(2.0, abs=0.15)
