"""Multipliers: what the Uzawa iteration does to them, and what they are when it has converged.

García Orden & Ortega, eqs 15, 16 and 26, 27; Hestenes 1969 and Powell 1969 for the rate.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from solver.runtime import Integrator
from tests.support.mechanisms.exact_motions import pendulum_multiplier
from tests.support.mechanisms.problems import (
    Array,
    Content,
    chain,
    double_pendulum,
    four_bar,
    free_system,
    move,
    observed_order,
    pendulum,
    start,
    view,
)

ANGLE, RATE = 1.0, 2.0
STEPS = [0.02, 0.01, 0.005, 0.0025]


# ----------------------------------------------------------------------------- the Uzawa iteration


@pytest.mark.filterwarnings("ignore:the energy is off by")
def test_an_update_removes_an_initial_defect_in_one_step():
    # A pendulum starts off its circle, with Phi = |q|^2 - 1 = 2.0001e-4. To put it right changes
    # its energy: the run says so.
    integrator = start(pendulum(ANGLE, RATE), h=0.01)
    view(integrator, "q")[:] *= 1 + 1e-4
    motion = move(integrator, 0.01, 8)
    assert motion.phi[0, 0] == pytest.approx(2.0001e-4, rel=1e-9)
    assert np.abs(motion.phi[1:]).max() < 1e-14


def test_a_defect_is_told_in_the_size_of_its_row_and_in_the_energy_that_it_means():
    """Of a rod L long Phi/L^2 is (1 + e)^2 - 1, its rate 2 (1 + e) u/L at a speed u along it."""
    integrator = start(pendulum(ANGLE, RATE, mass=2.0, length=0.5), h=0.01)
    q, v = view(integrator, "q"), view(integrator, "v")
    v += 1e-3 * q / 0.5
    q *= 1 + 1e-4
    assert integrator["constraint.position"] == pytest.approx(2.0001e-4, rel=1e-9)
    assert integrator["constraint.velocity"] == pytest.approx(2 * 1.0001 * 1e-3 / 0.5, rel=1e-9)
    gained = 0.5 * 2.0 * 1e-3**2 - 2.0 * 9.81 * 0.5 * 1e-4 * math.cos(ANGLE)
    assert integrator["energy.balance"] == pytest.approx(gained, rel=1e-9)
    of_start = 0.5 * 2.0 * (0.5 * RATE) ** 2
    assert integrator["energy.error"] == pytest.approx(abs(gained) / of_start, rel=1e-9)


@pytest.mark.parametrize("penalty", [1e6, 1e10])
def test_the_converged_step_does_not_depend_on_the_penalty(penalty):
    # The penalty moves the way, not the end: what is left is the tolerance, 1e-12 a step.
    reference = move(start(double_pendulum(1.0), h=0.01), 0.01, 50)
    motion = move(start(double_pendulum(1.0), h=0.01, penalty=penalty, max_uzawa=200), 0.01, 50)
    assert motion.q == pytest.approx(reference.q, abs=1e-9)


# ---------------------------------------------------------------------------- the total multiplier


def test_multipliers_are_of_first_order_and_their_means_of_second():
    # mu is constant over a half step: compared in its middle. A part that changes sign every time
    # makes it first order; the mean of two neighbours, at the time between, has lost that part.
    raw, averaged = [], []
    for h in STEPS:
        motion = move(start(pendulum(ANGLE, RATE), h=2 * h), 2 * h, round(1 / h))
        mu, middle = motion.mu[:, 0], h * (np.arange(len(motion.mu)) + 0.5)
        raw.append(np.abs(mu - pendulum_multiplier(middle, ANGLE, RATE)).max())
        between = pendulum_multiplier(middle[:-1] + h / 2, ANGLE, RATE)
        averaged.append(np.abs((mu[1:] + mu[:-1]) / 2 - between).max())
    assert observed_order(STEPS, raw) == pytest.approx(1.0, abs=0.15)
    assert observed_order(STEPS, averaged) == pytest.approx(2.0, abs=0.15)


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
    # delta_1 = -delta_0 + h/4 (v_1'Hv_1 - v_0'Hv_0) in a half step of length h, exact for quadratic
    # rows that hold at both ends: what is left is 4 |Phi|/h of the solve. In a pair twice that; the
    # velocity in its middle follows from q_2 - q_0 = h (v_0 + 2 v_1 + v_2)/2.
    h = 0.01
    integrator = start(content, h=2 * h)
    motion = move(integrator, 2 * h, 250)
    middle = np.diff(motion.q, axis=0) / h - 0.5 * (motion.v[:-1] + motion.v[1:])
    ends, between = (
        np.array([second_derivatives(integrator, v) for v in x]) for x in (motion.v, middle)
    )
    turned = h / 4 * (ends[1:] - 2.0 * between + ends[:-1])
    defect = motion.phi_dot[1:] - motion.phi_dot[:-1] - turned
    assert np.abs(motion.phi_dot).max() > 1e-5  # there is something to reflect
    assert np.abs(defect).max() < 1e-11
