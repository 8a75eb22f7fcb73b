"""Multipliers: what the Uzawa iteration does to them, and what they are when it has converged.

García Orden & Ortega, eqs 15, 16 and 26, 27; Hestenes 1969 and Powell 1969 for the rate.
"""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest

from solver.runtime import Integrator
from tests.exact_motions import pendulum_multiplier
from tests.kernel_calls import kernel_of
from tests.problems import (
    Array,
    Content,
    chain,
    double_pendulum,
    four_bar,
    free_system,
    last_multipliers,
    move,
    observed_order,
    pendulum,
    start,
    step,
    view,
)

ANGLE, RATE = 1.0, 2.0
STEPS = [0.02, 0.01, 0.005, 0.0025]


# ----------------------------------------------------------------------------- the Uzawa iteration


def residuals_by_update(penalty: float, tolerances: Array) -> dict[int, float]:
    """Phi after a step from a forgotten multiplier, by how many updates the tolerance asked for."""
    found = {}
    for tolerance in tolerances:
        integrator = start(
            pendulum(ANGLE, RATE),
            h=0.01,
            penalty=penalty,
            newton_tolerance=tolerance,
            max_uzawa=1000,
        )
        for name in ("mu_first", "mu_second"):
            view(integrator, name)[:] = 0.0
        step(integrator, 0.01)
        phi = kernel_of(integrator).residuals()[0][0]
        found[int(integrator["solver.uzawa_iterations"])] = phi  # type: ignore[arg-type]
    return found


@pytest.mark.parametrize("alpha", [1e3, 1e4, 1e5, 1e6])
def test_an_uzawa_update_reduces_the_residual_by_one_over_one_plus_chi(alpha):
    # Near the solution e_(k+1) = (1 + alpha W/2)^-1 e_k with W = h^2/2 G M^-1 G' up to O(h^2): 3 %
    # is what higher terms may change. chi = alpha h^2 sigma/4 with sigma = 4 L^2/m = 4. Residuals
    # below 1e-13 are round-off and left out.
    chi = alpha * 0.01**2 * 4 / 4
    found = residuals_by_update(chi, 10.0 ** -np.arange(3, 13))
    updates = sorted(k for k in found if abs(found[k]) > 1e-13)
    rates = [
        (found[last] / found[first]) ** (1 / (last - first)) for first, last in pairwise(updates)
    ]
    assert len(rates) >= 1
    assert rates == pytest.approx([1 / (1 + chi)] * len(rates), rel=0.03)


def disturbed_pendulum(update: str, algorithm: str = "nested") -> Integrator:
    """Pendulum that starts off its circle, with Phi = |q|^2 - 1 = 2.0001e-4."""
    content = pendulum(ANGLE, RATE)
    integrator = start(content, h=0.01, multiplier_update=update, algorithm=algorithm)
    view(integrator, "q")[:] *= 1 + 1e-4
    return integrator


ENERGY_OFF = pytest.mark.filterwarnings("ignore:the energy is off by")
"""Constraints that are put right, or turned round, change the energy: the run says so."""


@ENERGY_OFF
@pytest.mark.parametrize("algorithm", ["nested", "simultaneous"])
def test_the_update_with_the_end_value_removes_an_initial_defect_in_one_step(algorithm):
    motion = move(disturbed_pendulum("end", algorithm), 0.01, 8)
    assert motion.phi[0, 0] == pytest.approx(2.0001e-4, rel=1e-9)
    assert np.abs(motion.phi[1:]).max() < 1e-14


@ENERGY_OFF
def test_the_update_of_eq_16_turns_an_initial_defect_round_for_ever_and_pumps_energy():
    # lambda + alpha (Phi_n + Phi_1)/2 rests where Phi_1 = -Phi_n: a fixed point that is no
    # solution.
    motion = move(disturbed_pendulum("paper"), 0.01, 8)
    signs = (-1.0) ** np.arange(9)
    assert motion.phi[:, 0] == pytest.approx(2.0001e-4 * signs, rel=1e-9)
    assert abs(motion.balance[-1]) > 10 * abs(motion.balance[1])


def test_both_updates_agree_where_the_start_keeps_the_constraints():
    # For Phi_n = 0 eq 16 is the update with the end value, but for a factor two in the penalty.
    end, paper = (
        move(start(double_pendulum(), h=0.01, multiplier_update=update), 0.01, 100)
        for update in ("end", "paper")
    )
    assert end.q == pytest.approx(paper.q, abs=1e-11)


@pytest.mark.parametrize("penalty", [10.0, 1e3, 1e6])
def test_the_converged_step_does_not_depend_on_the_penalty(penalty):
    # The penalty moves the way, not the end: what is left is the tolerance, 1e-12 a step.
    reference = move(start(double_pendulum(1.0), h=0.01), 0.01, 50)
    motion = move(start(double_pendulum(1.0), h=0.01, penalty=penalty, max_uzawa=200), 0.01, 50)
    assert motion.q == pytest.approx(reference.q, abs=1e-9)


# ---------------------------------------------------------------------------- the total multiplier


def test_multipliers_are_of_first_order_and_their_means_of_second():
    # mu is constant over a step: compared in its middle. A part that changes sign every step makes
    # it first order; the mean of two neighbours, at the time between them, has lost that part.
    raw, averaged = [], []
    for h in STEPS:
        motion = move(start(pendulum(ANGLE, RATE), h=h), h, round(2 / h))
        mu, middle = motion.mu[:, 0], motion.t[:-1] + h / 2
        raw.append(np.abs(mu - pendulum_multiplier(middle, ANGLE, RATE)).max())
        between = pendulum_multiplier(motion.t[1:-1], ANGLE, RATE)
        averaged.append(np.abs((mu[1:] + mu[:-1]) / 2 - between).max())
    assert observed_order(STEPS, raw) == pytest.approx(1.0, abs=0.15)
    assert observed_order(STEPS, averaged) == pytest.approx(2.0, abs=0.15)


@pytest.mark.parametrize("paired", [False, True], ids=["plain", "pairs"])
def test_the_rod_force_that_is_reported_is_of_second_order(paired):
    # Tension 2 L mu, positive in tension, at the times of the outputs; the largest error of ten,
    # since at a single one the leading term may happen to vanish.
    errors = []
    for h in STEPS:
        integrator = start(pendulum(ANGLE, RATE), h=h, paired=paired)
        found = []
        for t in np.arange(10) / 5:
            integrator.advance(float(t), 0.2)
            found.append(integrator["rod1.force"])
        times = np.arange(1, 11) / 5
        errors.append(np.abs(found - 2 * pendulum_multiplier(times, ANGLE, RATE)).max())
    assert observed_order(STEPS, errors) == pytest.approx(2.0, abs=0.15)


@pytest.mark.parametrize("angle", [0.3, 1.0, 2.0])
def test_the_first_rod_force_is_that_of_statics_and_motion(angle):
    # Tension m (v^2/L + g cos(theta)): the start solves (G M^-1 G') lambda = G M^-1 Q + v'Hv.
    integrator = start(pendulum(angle, RATE, mass=2.0, length=0.5), h=0.01)
    expected = 2.0 * (RATE**2 * 0.5 + 9.81 * math.cos(angle))
    assert integrator["rod1.force"] == pytest.approx(expected, rel=1e-12)


# -------------------------------------------------------------- recursion of the normal velocities


def second_derivatives(integrator: Integrator, v: Array) -> Array:
    """v'H_i v of each row, 2 |v_b - v_a|^2 for the two nodes of a link; supports are at rest."""
    tables, n_free = integrator.model.tables, integrator.model.sizes["n_free"]
    values = []
    for form in tables["row_form"]:
        first, last = tables["form_ptr"][form], tables["form_ptr"][form + 1]
        ends = [v[node] for node in tables["form_node"][first:last] if node < n_free]
        relative = ends[0] - ends[1] if len(ends) == 2 else ends[0]
        values.append(2 * relative @ relative)
    return np.array(values)


@pytest.mark.parametrize(
    "content",
    [double_pendulum(), chain(5, dimension=3), four_bar(2), free_system(2), free_system(3)],
    ids=lambda content: f"{content['name']}-{content['dimension']}",
)
def test_normal_velocities_are_reflected_and_turned_by_the_curvature(content: Content):
    # delta_1 = -delta_0 + h/4 (v_1'Hv_1 - v_0'Hv_0), exact for quadratic rows that hold at both
    # ends: what is left is 4 |Phi|/h of the solve.
    h = 0.01
    integrator = start(content, h=h)
    motion = move(integrator, h, 500)
    curvature = np.array([second_derivatives(integrator, v) for v in motion.v])
    defect = motion.phi_dot[1:] + motion.phi_dot[:-1] - h / 4 * np.diff(curvature, axis=0)
    assert np.abs(motion.phi_dot).max() > 1e-5  # there is something to reflect
    assert np.abs(defect).max() < 1e-11


def test_a_pendulum_at_rest_hangs_on_its_weight():
    integrator = start(pendulum(0.0, mass=3.0), h=0.1)
    move(integrator, 0.1, 50)
    assert 2 * last_multipliers(integrator)[0] == pytest.approx(3.0 * 9.81, rel=1e-13)
    assert view(integrator, "q")[0] == pytest.approx([0.0, -1.0], abs=1e-14)
