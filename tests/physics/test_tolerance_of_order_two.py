"""Order 2 alone keeps a tolerance as far as round-off lets it, or says that it cannot."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.special import ellipj, ellipk

import solver

GRAVITY, BEGIN = 9.81, 2.0
PENDULUM = f"""
name = "pendulum"
dimension = 2
gravity = [0, -{GRAVITY}]
[points]
O = {{ position = [0, 0], fixed = true }}
A = {{ position = [{math.sin(BEGIN)}, {-math.cos(BEGIN)}], mass = 1 }}
[joints]
rod = {{ type = "distance", points = ["O", "A"], length = 1 }}
"""


def swing(t):
    """Angle and angular velocity of a pendulum of 1 m let go at 2 rad: Jacobi's functions."""
    omega, k = math.sqrt(GRAVITY), math.sin(0.5 * BEGIN)
    sn, cn, _, _ = ellipj(ellipk(k * k) + omega * t, k * k)
    angle = 2.0 * np.arcsin(k * sn)
    return angle, 2.0 * omega * k * cn


@pytest.mark.parametrize("tolerance", [1e-6, 1e-8, 1e-9])
def test_pairs_follow_a_pendulum_as_closely_as_a_tight_tolerance_asks(tolerance):
    run = solver.simulate(
        solver.loads(PENDULUM), stop_time=1.0, step_size=0.1, tolerance=tolerance, order=2
    )
    angle, rate = swing(run.t)
    fastest = np.abs(rate).max()
    assert run["A.x"] == pytest.approx(np.sin(angle), rel=0.0, abs=3.0 * tolerance)
    assert run["A.vx"] / fastest == pytest.approx(
        rate * np.cos(angle) / fastest, rel=0.0, abs=3.0 * tolerance
    )
    assert run["solver.error_estimate"][-1] < tolerance
    assert run["solver.substeps"].sum() < 2e5
