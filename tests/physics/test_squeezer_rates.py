"""Andrews' squeezer at level of velocities, accelerations and forces: the published digits.

All numbers are those of the Test Set for Initial Value Problem Solvers, part II.3.
"""

from __future__ import annotations

import numpy as np
import pytest

import solver
from tests.support.mechanisms.mechanism_runs import run, scene
from tests.support.mechanisms.problems import observed_order
from tests.support.mechanisms.reduced_models import Array

BETA, THETA = 14222.4439199541, -10666.8329399656
"""Accelerations of the crank and of the rod against it at the start [rad/s2]; others are zero."""
CLOSING = [98.5668703962411, -6.12268834425567]
"""Multipliers of the first closing condition, K2.tip - K3.tip, at the start [N]."""
RATES = np.array(
    [
        1139.920302151208, -1424.379294994111, 11.03291221937134, 19.29337464421385,
        0.5735699284790808, -19.29337464421385, 0.3231791658026955,
    ]
)  # fmt: skip
"""Of beta, theta, gamma, phi, delta, omega, epsilon at 0.03 s [rad/s]."""


def started() -> solver.Integrator:
    integrator = solver.Integrator(solver.assemble(solver.load(scene("andrews"))))
    integrator.initialise()
    return integrator


def test_the_squeezer_starts_with_the_published_accelerations() -> None:
    # At rest d'' = alpha J d of each body's director; 14 digits are published.
    vectors = started().state.vectors
    place, slope = (np.array(vectors[name]).reshape(7, 2, 2) for name in ("q", "a_first"))
    (x, y), (ax, ay) = place[:, 1].T, slope[:, 1].T
    k1, k2, *others = x * ay - y * ax
    assert k1 == pytest.approx(BETA, rel=1e-12)
    assert k2 - k1 == pytest.approx(THETA, rel=1e-12)
    # K4 to K7 do not move yet; K3 neither, to the rounding of 14222 times lengths of a centimetre.
    assert np.array(others) == pytest.approx(0.0, abs=1e-9 * BETA)


def test_the_pin_that_closes_the_first_loop_pulls_as_published() -> None:
    squeezer = started()
    found = [squeezer["E23.force.x"], squeezer["E23.force.y"]]
    assert found == pytest.approx(CLOSING, rel=1e-12)


def rates(n: int) -> Array:
    names = [f"K{i}.angular_velocity" for i in range(1, 8)]
    k1, k2, k3, k4, k5, k6, k7 = run("andrews", names, 0.03 / n, 0.03, order=4)[-1]
    return np.array([k1, k2 - k1, k3, k4 - k5, k5, k6 - k7, k7])


def test_the_squeezer_turns_as_fast_as_published() -> None:
    # Errors of fourth order, 1e-4 at the coarser step; the rates of the source are good to 1e-9.
    steps = (240, 480)
    errors = [np.abs(rates(n) - RATES).max() for n in steps]
    assert errors[-1] < 1e-5
    assert observed_order([1 / n for n in steps], errors) == pytest.approx(4.0, abs=0.2)
