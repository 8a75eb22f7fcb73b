"""N-four-bar mechanism, problem A02 of the IFToMM multibody benchmark, against its exact motion.

All cranks stay parallel, so the exact motion has one degree of freedom, I phi'' = W g sin(phi) with
I = (N + 1)/3 + N and W = (N + 1)/2 + N. At phi = 90 degrees all bars lie in one line and the rows
become dependent, twice in a turn of 1.94 s.
"""

from __future__ import annotations

import numpy as np
import pytest

from tests.support.mechanisms.exact_motions import four_bar_angle
from tests.support.mechanisms.problems import (
    GRAVITY,
    Array,
    assemble,
    four_bar,
    observe,
    start,
    view,
)

TIMES = np.array([0.0, 1.0, 2.0, 5.0, 10.0])
B0_MINUS_A0 = np.array(
    [
        (-0.195020302, -0.980799206),
        (0.057815796, 0.998327268),
        (-0.811310461, -0.584615545),
        (0.328458112, 0.944518538),
    ]
)
"""Crank B0 - A0 at 1, 2, 5, 10 s for N = 2, from the equation of one degree of freedom."""


def cranks(n: int, h: float, **settings: object) -> tuple[Array, Array]:
    """Crank vectors B_i - A_i at `TIMES[1:]`, (4, n + 1, 2), and the energy balance (4,)."""
    integrator = start(four_bar(n), h=h, **settings)
    pivots = np.array([[i, 0.0] for i in range(n + 1)])
    found, balance = [], []
    for t in TIMES[1:]:
        integrator.advance(integrator.time, t - integrator.time)
        found.append(view(integrator, "q") - pivots)
        balance.append(integrator["energy.balance"])
    return np.array(found), np.array(balance)


def test_the_equation_of_one_degree_of_freedom_gives_the_reference_positions():
    angle = four_bar_angle(TIMES, 2)[1:]
    assert np.stack([np.sin(angle), np.cos(angle)], axis=-1) == pytest.approx(B0_MINUS_A0, abs=1e-9)


def test_the_energy_at_the_start_is_that_of_the_benchmark():
    integrator = start(four_bar(2), h=0.0025)
    # Cranks turn about their ends, couplers only move along: 3/6 + 2/2 J; half and full height.
    assert integrator["energy.kinetic"] == pytest.approx(1.5, rel=1e-14)
    assert integrator["energy.potential"] == pytest.approx(3.5 * GRAVITY, rel=1e-14)


def test_the_benchmark_is_met_through_all_its_singular_configurations():
    # B0.x within 1e-4 at 10 s with steps of 2.5 ms; cranks parallel to 1e-9, where leaving the
    # branch would show at once as a difference of the size of the mechanism.
    found, balance = cranks(2, 0.0025)
    assert found[-1, 0, 0] == pytest.approx(0.328458, abs=1e-4)
    assert np.ptp(found, axis=1).max() < 1e-9
    assert np.abs(balance).max() < 1e-10 * 35.835


@pytest.mark.parametrize("penalty", [1e6, 1e8, 1e10])
def test_every_penalty_passes_them(penalty):
    found, _ = cranks(2, 0.005, penalty=penalty)
    reference, _ = cranks(2, 0.005)
    assert np.ptp(found, axis=1).max() < 1e-9
    assert found == pytest.approx(reference, abs=1e-8)


@pytest.mark.parametrize("n", [1, 3, 8, 20])
def test_more_loops_stay_on_their_branch_too(n):
    found, balance = cranks(n, 0.005)
    angle = four_bar_angle(TIMES, n)[1:]
    exact = np.stack([np.sin(angle), np.cos(angle)], axis=-1)
    # Error h^2 rate^2/12 of the phase, here at most 0.005^2 * 9^2/12 of 60 rad and with
    # sensitivity.
    assert np.ptp(found, axis=1).max() < 1e-9
    assert found[:, 0] == pytest.approx(exact, abs=5e-3)
    assert np.abs(balance).max() < 1e-10 * n * GRAVITY


def test_a_singular_configuration_is_passed_when_a_step_ends_in_it():
    # Cranks drawn flat, all bars in one line: two rows depend on the others from the first instant.
    content = four_bar(2)
    for i in range(3):
        content["points"][f"B{i}"] = {"position": [i + 1.0, 0.0], "velocity": [0.0, 2.0]}
    energy = observe(
        start(content, h=0.0025), 0.0025, 800, ["energy.balance", "constraint.position"]
    )
    assert np.abs(energy).max() < 1e-10


def test_a_redundant_crank_changes_nothing():
    # A third crank in a loop that two already guide: one row too many, at every instant.
    content = four_bar(2)
    plain = start(content, h=0.005)
    content["joints"] = {
        "again": {"type": "distance", "points": ["A1", "B1"]},
        "across": {"type": "distance", "points": ["A0", "B0"]},
    }
    redundant = start(content, h=0.005)
    assert redundant.model.sizes["n_rows"] == plain.model.sizes["n_rows"] + 2
    for integrator in (plain, redundant):
        integrator.advance(0.0, 1.0)
    assert view(redundant, "q") == pytest.approx(view(plain, "q"), abs=1e-10)
    assert abs(redundant["energy.balance"]) < 1e-10


def test_fill_in_of_the_loops_is_bounded():
    # Beyond the first few, each further loop costs the same: no band that widens.
    sizes = [assemble(four_bar(n)).sizes["n_lu_values"] for n in (8, 16, 32, 64, 128)]
    per_loop = np.diff(sizes) / np.array([8, 16, 32, 64])
    assert per_loop == pytest.approx([per_loop[0]] * 4, rel=1e-12)


@pytest.mark.parametrize("step", [5e-4, 2e-4, 1e-4])
def test_a_singular_configuration_is_passed_at_steps_that_land_in_it(step):
    # At 90 degrees, 0.714 s after the start, rows become dependent. Steps of 1e-4 s end up to 1e-4
    # rad from it: there the Uzawa factor 1/(1 + chi g_1 g_m/sigma) has its pole. 1e-12: round-off.
    integrator = start(four_bar(2), h=step)
    integrator.advance(0.0, 0.8)
    assert integrator["energy.error"] < 1e-12
    assert integrator["constraint.position"] < 1e-15
    assert integrator["solver.substeps"] == 2 * round(0.8 / step)  # none was halved
