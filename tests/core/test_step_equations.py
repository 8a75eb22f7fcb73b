"""A half step of the kernel satisfies the equations of the paper, formulation by formulation."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tests.twins import PENDULUM, internal_step, start, vector

M, L, G = 2.0, 1.0, np.array([0.0, -9.81])
SIGMA = 4.0 * L**2 / M
"""G M^-1 G' of the row Phi = q.q - L^2 of the pendulum."""


def pendulum(**settings):
    return start(PENDULUM, paired=False, **settings)


def ends(integrator):
    """State before and after one step: q, v each, and the multiplier."""
    before = [vector(integrator, name, f"{name}_low") for name in "qv"]
    half = int(integrator.state.head["parity"])
    internal_step(integrator)
    after = [vector(integrator, name, f"{name}_low") for name in "qv"]
    return *before, *after, vector(integrator, ("mu_first", "mu_second")[half])[0]


def momentum_defect(h, q_n, v_n, q_n1, v_n1, mu):
    """Eqs 5, 7, 9 and 15 of the paper for one point: M (v_n1 - v_n) + h [2 q_mid mu - M g]."""
    return M * (v_n1 - v_n) + h * (2.0 * 0.5 * (q_n + q_n1) * mu - M * G)


def phi(q):
    return q @ q - L**2


@pytest.mark.parametrize("algorithm", ["nested", "simultaneous"])
@pytest.mark.parametrize("formulation", ["conserving-al", "midpoint-al"])
def test_a_step_of_the_pendulum_satisfies_the_equations_of_the_paper(formulation, algorithm):
    h = 0.05
    run = pendulum(formulation=formulation, algorithm=algorithm, step_size=h)
    for _ in range(3):
        q_n, v_n, q_n1, v_n1, mu = ends(run)
        # round-off of terms of size M v and l^2
        assert momentum_defect(h, q_n, v_n, q_n1, v_n1, mu) == pytest.approx([0.0, 0.0], abs=1e-14)
        assert 0.5 * (v_n + v_n1) == pytest.approx((q_n1 - q_n) / h, abs=1e-14)
        where = q_n1 if formulation == "conserving-al" else 0.5 * (q_n + q_n1)
        assert phi(where) == pytest.approx(0.0, abs=1e-15)


@pytest.mark.parametrize("chi", [0.1, 10.0, 1e4])
def test_the_penalty_of_a_conserving_step_is_a_potential(chi):
    """Eq 9 in closed form: mu = alpha (Phi_n + Phi_n1)/2, and T + V + alpha Phi^2/2 is constant."""
    h = 0.05
    run = pendulum(formulation="conserving-penalty", penalty=chi, step_size=h)
    alpha = 4.0 * chi / (h**2 * SIGMA)
    energies = []
    for _ in range(20):
        q_n, v_n, q_n1, v_n1, mu = ends(run)
        assert momentum_defect(h, q_n, v_n, q_n1, v_n1, mu) == pytest.approx([0.0, 0.0], abs=1e-13)
        # alpha multiplies the rounding of Phi, 1e-16 l^2
        assert mu == pytest.approx(0.5 * alpha * (phi(q_n) + phi(q_n1)), abs=1e-14 + 1e-15 * alpha)
        energies.append(0.5 * M * v_n1 @ v_n1 - M * G @ q_n1 + 0.5 * alpha * phi(q_n1) ** 2)
    assert np.ptp(energies) < 1e-12
    assert run["energy.total"] == pytest.approx(energies[-1], abs=1e-13)


def test_the_penalty_of_the_midpoint_step_is_taken_at_the_midpoint():
    h, chi = 0.05, 10.0
    run = pendulum(formulation="midpoint-penalty", penalty=chi, step_size=h)
    for _ in range(3):
        q_n, v_n, q_n1, v_n1, mu = ends(run)
        assert momentum_defect(h, q_n, v_n, q_n1, v_n1, mu) == pytest.approx([0.0, 0.0], abs=1e-13)
        alpha = 4.0 * chi / (h**2 * SIGMA)
        assert mu == pytest.approx(alpha * phi(0.5 * (q_n + q_n1)), abs=1e-15 * alpha)


def test_penalty_velocity_is_equation_3_at_the_midpoint():
    h, chi, xi, omega = 0.05, 30.0, 0.8, 7.0
    run = pendulum(formulation="penalty-velocity", penalty=chi, xi=xi, omega=omega, step_size=h)
    for _ in range(3):
        q_n, v_n, q_n1, v_n1, mu = ends(run)
        q, v, a = 0.5 * (q_n + q_n1), 0.5 * (v_n + v_n1), (v_n1 - v_n) / h
        row = 2 * q @ a + 2 * v @ v + 2 * xi * omega * (2 * q @ v) + omega**2 * phi(q)
        assert momentum_defect(h, q_n, v_n, q_n1, v_n1, mu) == pytest.approx([0.0, 0.0], abs=1e-13)
        assert mu == pytest.approx(chi / SIGMA * row, rel=1e-12)


def test_a_point_on_a_rod_without_gravity_turns_by_twice_the_arctangent():
    """Closed solution: tan(beta/2) = h v/(2 L); mu = m v^2/(2 L^2) as in the motion itself."""
    h, v, text = 0.3, 2.0, PENDULUM.replace("gravity = [0, -9.81]", "gravity = [0, 0]")
    run = start(text.replace("[0.8, 0.6]", "[1.6, 1.2]"), paired=False, step_size=h)
    beta = 2.0 * math.atan(0.5 * h * v / L)
    turn = np.array([[math.cos(beta), -math.sin(beta)], [math.sin(beta), math.cos(beta)]])
    for _ in range(4):
        q_n, v_n, q_n1, v_n1, mu = ends(run)
        assert q_n1 == pytest.approx(turn @ q_n, abs=1e-14)
        assert v_n1 == pytest.approx(turn @ v_n, abs=1e-14)
        assert mu == pytest.approx(M * v**2 / (2.0 * L**2), rel=1e-14)
