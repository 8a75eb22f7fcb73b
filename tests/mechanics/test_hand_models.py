"""Kernel and oracle agree on mechanisms written by hand, which use every part of a model."""

from __future__ import annotations

from functools import partial

import numpy as np
import pytest

from tests import hand_scenes
from tests.hand_runs import Run
from tests.kernel_calls import kernel_of
from tests.oracle import Mechanism, Residual, internal_step
from tests.oracle.measurements import measurements
from tests.oracle.start import first_multipliers, row_rates, rows_of
from tests.oracle.step import rows_now

CASES = {
    "planar body": (hand_scenes.planar_body, {}),
    "planar body, midpoint": (hand_scenes.planar_body, {"formulation": "midpoint-al"}),
    "planar body, penalty": (
        hand_scenes.planar_body,
        {"formulation": "conserving-penalty", "penalty": 1e3},
    ),
    "planar body, penalty-velocity": (
        hand_scenes.planar_body,
        {"formulation": "penalty-velocity", "penalty": 1e3},
    ),
    "heavy top": (hand_scenes.heavy_top, {"step_size": 0.005}),
    "functions": (hand_scenes.functions, {}),
    "functions, beta": (hand_scenes.functions, {"formulation": "conserving-al-beta"}),
    "functions, assembled": (
        lambda: _disturbed(hand_scenes.functions()),
        {"assemble": True},
    ),
    "slider-crank": (hand_scenes.slider_crank, {"step_size": 0.005}),
    "driven angle": (hand_scenes.driven_angle, {}),
    "driven angle, beta": (hand_scenes.driven_angle, {"formulation": "conserving-al-beta"}),
    "sensed": (hand_scenes.sensed, {}),
    "ramped slider": (hand_scenes.ramped_slider, {}),
    "ramped slider in space": (partial(hand_scenes.ramped_slider, 3), {}),
    "two bodies": (hand_scenes.two_bodies, {"step_size": 0.005}),
    "two bodies, assembled": (partial(hand_scenes.two_bodies, 0.01), {"assemble": True}),
    "catenary, assembled": (partial(hand_scenes.catenary, 0.02), {"assemble": True}),
    "catenary, hanging": (
        partial(hand_scenes.catenary, 0.02),
        {"assemble": True, "start": "equilibrium"},
    ),
}


def _disturbed(hand):
    hand.disturb(0.01)
    return hand


@pytest.fixture(params=CASES)
def run(request):
    build, settings = CASES[request.param]
    return Run(build(), **settings)


def oracle_of(run):
    return Mechanism.of(run.model, run.state)


def test_a_run_begins_as_the_equations_say(run):
    oracle = oracle_of(run)
    lam, a, driven = first_multipliers(oracle)
    # start accelerations of driven nodes: rounding 1e-16 of positions over (1e-2 h)^2
    assert run.vector("a_first") == pytest.approx(a, rel=1e-8, abs=1e-8)
    assert run.vector("driven_first") == pytest.approx(driven, rel=1e-7, abs=1e-7)
    G = rows_of(oracle)[0]
    if np.linalg.matrix_rank(G[:, : oracle.n_free]) == len(G):
        assert run.vector("mu_first") == pytest.approx(lam, rel=1e-7, abs=1e-7)
    phi, rates = kernel_of(run).residuals()
    assert phi == pytest.approx(rows_now(oracle), abs=1e-12)
    assert rates == pytest.approx(row_rates(oracle, oracle.signal_rates(0.0)), abs=1e-12)


def test_an_assembled_mechanism_is_closed_and_was_moved_along_its_rows_alone(run):
    if not run.head["assemble"] or run.head["equilibrium"]:
        return
    oracle = oracle_of(run)
    assert np.max(np.abs(rows_now(oracle)), initial=0.0) < 1e-12
    n, G = oracle.n_free, rows_of(oracle)[0]
    moved = (oracle.x - oracle.section["initial_position"])[:n]
    assert np.max(np.abs(moved)) > 1e-6
    # M d + G' mu = 0: a displacement that is stationary in d' M d.
    pull = oracle.M[:n, :n] @ moved
    mu = np.linalg.lstsq(G[:, :n].T, -pull, rcond=None)[0]
    assert G[:, :n].T @ mu == pytest.approx(-pull, abs=1e-11 * np.max(np.abs(pull)) + 1e-13)


def test_in_equilibrium_nothing_accelerates(run):
    if run.head["equilibrium"]:
        assert not run.vector("v").any()
        # displacements of the last step are 1e-10 of the size, with 1e3 and more step sizes
        assert np.max(np.abs(first_multipliers(oracle_of(run))[1])) < 1e-8


def test_a_run_takes_the_steps_of_the_equations_and_measures_what_is_defined(run):
    if not any(run.model.tables["input_ramp"]):
        run.set_inputs(*[0.35] * run.model.sizes["n_inputs"])
    for _ in range(3):
        before = oracle_of(run)
        run.advance(1)
        after = internal_step(before, run.head["step_size"])
        # rounding of Phi and forces, 1e-16, over h^2 in accelerations and multipliers
        for name in ("q", "v", "a_first", "a_second", "driven_second", "signal", "turns"):
            theirs = after.vectors[name]
            assert run.vector(name) == pytest.approx(theirs, rel=1e-9, abs=1e-9), name
        G = rows_of(before)[0][:, : before.n_free]
        for name in ("mu_first", "mu_second"):
            force = G.T @ after.vectors[name]
            assert G.T @ run.vector(name) == pytest.approx(force, rel=1e-7, abs=1e-7), name
        for account in ("work", "dissipated"):
            assert run.head[account] == pytest.approx(after.head[account], rel=1e-9, abs=1e-11)
    for name, values in measurements(oracle_of(run)).items():
        # rates of signals are quotients of differences over 1e-2 step_size
        near = 1e-11 if name == "residual" else 1e-12
        assert run[name] == pytest.approx(values, rel=1e-12, abs=near), name


def test_residual_and_tangent_are_those_of_the_equations(run):
    random, sizes = np.random.default_rng(0), run.model.sizes
    n, r = sizes["dim"] * sizes["n_free"], sizes["n_rows"]
    w, mu, x = 1e-3 * random.normal(size=n), random.normal(size=r), random.normal(size=n + r)
    _, ours, our_product = kernel_of(run).probe(0.02, w, mu, x)
    equations = Residual(oracle_of(run), 0.02)
    # The kernel's rows are Phi_n1 - (2/alpha) mu: eq 15 with lam = -alpha Phi_n/2.
    twice = 2.0 if equations.conserving else 1.0
    lam = -0.5 * equations.alpha * equations.phi_n if equations.conserving else 0.0 * mu
    rows = np.where(np.arange(n + r) < n, 1.0, twice)
    theirs = rows * equations.residual(w, mu, lam)
    product = rows * (equations.tangent(w, mu, lam) @ x)
    assert ours == pytest.approx(theirs, rel=1e-13, abs=1e-14 * np.max(np.abs(theirs)))
    # the kernel's tangents of functions are difference quotients; those of beta hold beta fixed
    close = 1e-4 if run.head["formulation"] == 5.0 else 1e-8
    assert our_product == pytest.approx(product, abs=close * np.max(np.abs(product)))
