"""A half step of the kernel satisfies the equations of the paper."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tests.support.kernel.twins import PENDULUM, internal_step, start, vector

M, L, G = 2.0, 1.0, np.array([0.0, -9.81])


def halves(integrator, h):
    """Both half steps of a pair of length 2 h: q_n, v_n, q_n1, v_n1 and the multiplier of each.

    A state has both ends of the pair. That the sum of d = h (v_n + v_n1)/2 over both halves leads
    from one to the other tells the velocity in the middle, whose round-off is 1e-16/h.
    """
    (q_0, v_0), _, (q_2, v_2) = at(integrator), internal_step(integrator), at(integrator)
    v_1 = (q_2 - q_0) / h - 0.5 * (v_0 + v_2)
    q_1 = q_0 + 0.5 * h * (v_0 + v_1)
    mu = [vector(integrator, f"mu_{half}")[0] for half in ("first", "second")]
    return (q_0, v_0, q_1, v_1, mu[0]), (q_1, v_1, q_2, v_2, mu[1])


def at(integrator):
    """Coordinates and velocities."""
    return [vector(integrator, name, f"{name}_low") for name in "qv"]


def momentum_defect(h, q_n, v_n, q_n1, v_n1, mu):
    """Eq 15 of the paper for one point: M (v_n1 - v_n) + h [2 q_mid mu - M g]."""
    return M * (v_n1 - v_n) + h * (2.0 * 0.5 * (q_n + q_n1) * mu - M * G)


def phi(q):
    return q @ q - L**2


def test_a_step_of_the_pendulum_satisfies_the_equations_of_the_paper():
    h = 0.05
    run = start(PENDULUM, step_size=2.0 * h)
    for _ in range(3):
        for q_n, v_n, q_n1, v_n1, mu in halves(run, h):
            # round-off of terms of size M v over h, and of l^2
            assert momentum_defect(h, q_n, v_n, q_n1, v_n1, mu) == pytest.approx([0, 0], abs=1e-13)
            assert phi(q_n1) == pytest.approx(0.0, abs=1e-15)


def test_a_point_on_a_rod_without_gravity_turns_by_twice_the_arctangent():
    """Closed solution: tan(beta/2) = h v/(2 L); mu = m v^2/(2 L^2) as in the motion itself."""
    h, v, text = 0.3, 2.0, PENDULUM.replace("gravity = [0, -9.81]", "gravity = [0, 0]")
    run = start(text.replace("[0.8, 0.6]", "[1.6, 1.2]"), step_size=2.0 * h)
    beta = 2.0 * math.atan(0.5 * h * v / L)
    turn = np.array([[math.cos(beta), -math.sin(beta)], [math.sin(beta), math.cos(beta)]])
    for _ in range(2):
        for q_n, v_n, q_n1, v_n1, mu in halves(run, h):
            assert q_n1 == pytest.approx(turn @ q_n, abs=1e-14)
            assert v_n1 == pytest.approx(turn @ v_n, abs=1e-14)
            assert mu == pytest.approx(M * v**2 / (2.0 * L**2), rel=1e-14)
