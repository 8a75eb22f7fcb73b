"""The ladder of formulations of García Orden & Ortega, from penalties to the conserving method.

What the paper says of each; their equations are in `tests/core/test_step_equations.py`.
"""

from __future__ import annotations

import numpy as np
import pytest

from tests.exact_motions import pendulum_angle
from tests.problems import (
    GRAVITY,
    Motion,
    chain,
    double_pendulum,
    four_bar,
    free_system,
    move,
    observe,
    observe_until_it_fails,
    observed_order,
    pendulum,
    start,
    tree,
    view,
)


@pytest.mark.parametrize("h", [0.01, 0.05])
@pytest.mark.parametrize("penalty", [1.0, 1e2, 1e4])
def test_the_conserving_penalty_keeps_energy_where_the_midpoint_penalty_does_not(penalty, h):
    # Energy with that of the penalties, 10 s of a double pendulum from the horizontal, relative to
    # the 29 J that gravity can give. The midpoint rule gains or loses at least a thousandth of
    # them.
    content, reference = double_pendulum(), 3 * GRAVITY

    def error(formulation: str) -> float:
        integrator = start(content, h=h, formulation=formulation, penalty=penalty)
        values = observe_until_it_fails(integrator, h, round(10 / h), ["energy.balance"])
        if formulation == "conserving-penalty":
            assert len(values) == round(10 / h) + 1
        return float(np.abs(values).max() / reference)

    assert error("conserving-penalty") < 1e-10
    assert error("midpoint-penalty") > 1e-3


@pytest.mark.parametrize(
    "content", [chain(3), free_system(3), four_bar(1), tree(5)], ids=lambda c: c["name"]
)
@pytest.mark.parametrize("paired", [False, True], ids=["plain", "pairs"])
def test_the_conserving_penalty_keeps_the_energy_of_any_mechanism(content, paired):
    integrator = start(
        content, h=0.02, formulation="conserving-penalty", penalty=1e3, paired=paired
    )
    error = observe(integrator, 0.02, 300, ["energy.error"])
    assert error.max() < 1e-12


def test_the_conserving_penalty_stretches_rods_in_inverse_proportion():
    penalties = [1e2, 1e3, 1e4]
    stretch = []
    for penalty in penalties:
        integrator = start(pendulum(1.0), h=0.01, formulation="conserving-penalty", penalty=penalty)
        stretch.append(observe(integrator, 0.01, 200, ["constraint.position"]).max())
    assert observed_order(penalties, stretch) == pytest.approx(-1.0, abs=0.1)


def test_the_penalty_does_not_follow_the_length_of_a_shortened_step():
    # A stored energy alpha Phi^2/2 must not change when a communication step cuts an internal one.
    integrator = start(double_pendulum(), h=0.01, formulation="conserving-penalty", penalty=1e2)
    errors = []
    for i in range(200):
        integrator.advance(integrator.time, 0.01 if i % 3 else 0.004)
        errors.append(integrator["energy.error"])
    assert max(errors) < 1e-12


def test_penalty_velocity_lets_a_defect_die_out_as_a_damped_oscillator():
    # For a large penalty Phi'' + 2 xi omega Phi' + omega^2 Phi = 0; critically damped from rest:
    # Phi = Phi_0 (1 + omega t) exp(-omega t). Second order in h.
    errors, steps = [], [0.01, 0.005, 0.0025]
    for h in steps:
        motion = stretched_pendulum(h, penalty=1e8)
        phi = motion.phi[:, 0]
        expected = phi[0] * (1 + 10 * motion.t) * np.exp(-10 * motion.t)
        errors.append(np.abs(phi - expected).max())
    assert observed_order(steps, errors) == pytest.approx(2.0, abs=0.1)
    assert errors[-1] < 1e-3 * 0.02


def stretched_pendulum(h: float, *, penalty: float) -> Motion:
    """A second of penalty-velocity with xi = 1, omega = 10 rad/s from a rod 1 percent too long."""
    integrator = start(
        pendulum(1.0), h=h, formulation="penalty-velocity", penalty=penalty, xi=1.0, omega=10.0
    )
    view(integrator, "q")[:] *= 1.01
    return move(integrator, h, round(1 / h))


def test_penalty_velocity_meets_the_constraints_as_its_penalty_grows():
    # Distance from the exact swing, at a step that hardly matters: 1/alpha.
    penalties, errors = [1e2, 1e3, 1e4], []
    for penalty in penalties:
        integrator = start(pendulum(1.0), h=0.002, formulation="penalty-velocity", penalty=penalty)
        motion = move(integrator, 0.002, 500)
        exact = np.sin(pendulum_angle(motion.t, 1.0))
        errors.append(np.abs(motion.q[:, 0, 0] - exact).max())
    assert observed_order(penalties, errors) == pytest.approx(-1.0, abs=0.15)


def test_penalty_velocity_takes_out_the_energy_of_a_defect():
    # Row energy alpha (Phi'^2 + omega^2 Phi^2)/2 falls as -2 xi omega alpha Phi'^2; 1 % is what the
    # swing under gravity feeds in by errors of the step.
    motion = stretched_pendulum(0.0025, penalty=1e8)
    energy = motion.phi_dot[:, 0] ** 2 + 100.0 * motion.phi[:, 0] ** 2
    assert np.diff(energy).max() < 0.01 * energy[0]
    assert energy[-1] < 1e-4 * energy[0]


# -------------------------------------------------------------------------------------- algorithms


@pytest.mark.parametrize("paired", [False, True], ids=["plain", "pairs"])
@pytest.mark.parametrize(
    "content", [double_pendulum(1.0), free_system(3), four_bar(2)], ids=lambda c: c["name"]
)
def test_simultaneous_updates_reach_the_same_steps_as_nested_ones(content, paired):
    # Both solve each step to 1e-12 and better; 100 steps of a regular motion leave 1e-11.
    nested, simultaneous = (
        move(start(content, h=0.02, algorithm=algorithm, paired=paired), 0.02, 100)
        for algorithm in ("nested", "simultaneous")
    )
    assert simultaneous.q == pytest.approx(nested.q, abs=1e-11)
    assert simultaneous.v == pytest.approx(nested.v, abs=1e-9)
    assert np.abs(simultaneous.phi).max() < 1e-14


@pytest.mark.parametrize("formulation", ["conserving-al", "midpoint-al", "conserving-penalty"])
def test_formulations_agree_as_steps_get_short(formulation):
    # Half a second, before the midpoint rule shows its weakness: all are of second order. The
    # penalty grows as h^-2 with fixed chi, so that its own error is of second order too.
    errors, steps = [], [0.01, 0.005, 0.0025]
    for h in steps:
        integrator = start(pendulum(1.0), h=h, formulation=formulation, penalty=1e2)
        motion = move(integrator, h, round(0.5 / h))
        errors.append(np.abs(motion.q[:, 0, 0] - np.sin(pendulum_angle(motion.t, 1.0))).max())
    assert observed_order(steps, errors) == pytest.approx(2.0, abs=0.15)
