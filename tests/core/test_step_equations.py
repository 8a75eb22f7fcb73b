"""A half step against closed forms: of the kernel, and the oracle's laws and Uzawa updates."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tests.hand_models import Hand
from tests.hand_runs import Run
from tests.kernel_calls import kernel_of
from tests.oracle import HalfStep, Mechanism, forces
from tests.oracle.path import Path
from tests.oracle.step import added
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


def test_the_first_multiplier_is_that_of_the_equations_of_motion():
    run = pendulum()
    q, v = (np.array(run.state.vectors[name]) for name in "qv")
    tension_in_rod = M * (v @ v / L + G @ q / L)
    assert vector(run, "mu_first")[0] == pytest.approx(tension_in_rod / (2.0 * L), rel=1e-14)
    acceleration = G - tension_in_rod / M * q
    assert vector(run, "a_first") == pytest.approx(acceleration, rel=1e-14)


@pytest.mark.filterwarnings("ignore:the energy is off")  # the rod is stretched by hand
@pytest.mark.parametrize("update", ["end", "paper"])
def test_the_update_of_the_paper_reflects_a_defect_and_that_at_the_end_removes_it(update):
    """Eq 16 has the fixed point Phi_n + Phi_n1 = 0."""
    run = pendulum(multiplier_update=update, step_size=0.01)
    q = run.state.vectors["q"]
    stretch = math.sqrt(1.0 + 2e-4)
    q[0], q[1] = 0.6 * stretch, -0.8 * stretch
    rows = []
    for _ in range(4):
        rows.append(kernel_of(run).residuals()[0][0])
        internal_step(run)
    assert rows[0] == pytest.approx(2e-4, rel=1e-9)
    expected = [-rows[0], rows[0], -rows[0]] if update == "paper" else [0.0, 0.0, 0.0]
    assert rows[1:] == pytest.approx(expected, abs=1e-14)


@pytest.mark.parametrize("chi", [0.5, 5.0, 50.0])
def test_the_uzawa_iteration_contracts_by_the_penalty(chi):
    """Each update shrinks the defect by 1/(1 + chi), up to terms of size h^2 lam/m."""
    run, defects = pendulum(step_size=0.002, penalty=chi), []

    class Watched(HalfStep):
        def newton(self, lam):
            super().newton(lam)
            path = self.equations.path(self.w)
            change, G_bar, _ = self.equations.rows(path)
            defects.append(self.equations.held(path, change, G_bar)[0])

    Watched(Mechanism.of(run.model, run.state), 0.002)
    ratios = np.array(defects[1:3]) / np.array(defects[:2])
    assert ratios == pytest.approx(1.0 / (1.0 + chi), rel=1e-3)
    assert abs(defects[-1]) < 1e-12


def link_law(u_n, h, stiffness, rest, damping):
    """Force in du of a spring and damper from the origin to a point at u_n."""
    hand = Hand(len(u_n))
    point, origin = hand.free(list(u_n)), hand.fixed([0.0] * len(u_n))
    length = hand.quantity(1, hand.form({point: 1.0, origin: -1.0}))
    hand.element(length, stiffness, rest, damping)
    run = Run(hand)
    oracle = Mechanism.of(run.model, run.state)

    def force(du):
        return sum(forces.laws(oracle, Path(oracle, du, h=h).over_step()))

    return force


@pytest.mark.parametrize("dim", [2, 3])
def test_springs_and_dampers_do_exactly_the_work_of_their_laws(dim):
    random = np.random.default_rng(1)
    for _ in range(20):
        u_n, u_n1 = random.normal(size=(2, dim))
        h, k, rest, c = random.uniform(0.1, 2.0, size=4)
        f = -link_law(u_n, h, k, rest, c)(u_n1 - u_n)
        l_n, l_n1 = np.linalg.norm(u_n), np.linalg.norm(u_n1)
        stored = 0.5 * k * ((l_n1 - rest) ** 2 - (l_n - rest) ** 2)
        assert f @ (u_n1 - u_n) == pytest.approx(stored + c * (l_n1 - l_n) ** 2 / h, abs=1e-13)
        across = np.outer(f, u_n + u_n1)
        assert across == pytest.approx(across.T, abs=1e-13)


def test_a_torque_in_the_plane_does_the_work_moment_times_angle():
    random = np.random.default_rng(2)
    for beta in (0.0, 1e-9, 1e-4, 0.1, 1.5, 3.0, -2.0):
        angle, l_n, l_n1, moment = random.uniform(0.5, 2.0, size=4)
        u_n = l_n * np.array([math.cos(angle), math.sin(angle)])
        u_n1 = l_n1 * np.array([math.cos(angle + beta), math.sin(angle + beta)])
        f = forces.couple(np.array([moment]), u_n, u_n1)
        # rounding of u_n1 - u_n turns the link by 1e-16
        assert f @ (u_n1 - u_n) == pytest.approx(moment * beta, rel=1e-13, abs=1e-15)


def test_sums_keep_what_rounding_leaves_over():
    high, low = np.array([1e16]), np.array([0.0])
    for _ in range(1000):
        high, low = added(high, low, np.array([0.1]))
    assert high[0] - 1e16 + low[0] == pytest.approx(100.0, rel=1e-13)
