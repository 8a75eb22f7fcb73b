"""Kernel and reference agree on mechanisms written by hand, which use every part of a model."""

from __future__ import annotations

from functools import partial

import numpy as np
import pytest

from solver.runtime.layout import HEAD, measured_sections, state_sections
from tests import hand_scenes
from tests.hand_runs import Run

COUNTERS = [
    HEAD.index(name) for name in ("newton_iterations", "uzawa_iterations", "ledger_error", "across")
]
OF_THE_KERNEL = ("islands", "imbalance", "imbalance_before", "sampled")
"""How islands iterated and rested; what Newton left and loads missed, which the kernel follows."""

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
    "ramped slider in space": (partial(hand_scenes.ramped_slider, 3), {"order": 4.0}),
    "heavy top, order 8": (hand_scenes.heavy_top, {"order": 8.0}),
    "driven angle, order 6": (hand_scenes.driven_angle, {"order": 6.0}),
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
def twins(request):
    build, settings = CASES[request.param]
    return [Run(build(), engine, **settings) for engine in ("c", "numpy")]


def block(run):
    """The whole state, as a view."""
    return np.asarray(memoryview(run.engine.state).cast("B").cast("d"))


def assert_alike(twins, tolerance):
    sections = (state_sections(twins[0].model.sizes)[name] for name in OF_THE_KERNEL)
    left_out = [*COUNTERS, *(k for begin, count in sections for k in range(begin, begin + count))]
    ours, theirs = (np.delete(block(run), left_out) for run in twins)
    assert ours == pytest.approx(theirs, rel=tolerance, abs=tolerance)


def test_both_begin_alike(twins):
    # start accelerations of driven nodes: rounding 1e-16 of positions over (1e-2 h)^2
    assert_alike(twins, 1e-8)
    kernel, oracle = twins
    for ours, theirs in zip(kernel.engine.residuals(), oracle.engine.residuals(), strict=True):
        assert ours == pytest.approx(theirs, abs=1e-12)


def test_both_take_the_same_steps_and_measure_the_same(twins):
    kernel, oracle = twins
    for run in twins:
        run.set_inputs(*[0.35] * run.model.sizes["n_inputs"])
    for _ in range(3):
        block(oracle)[:] = block(kernel)
        for run in twins:
            run.advance(1)
        # rounding of Phi and forces, 1e-16, over h^2 in accelerations and multipliers
        assert_alike(twins, 1e-9)
    block(oracle)[:] = block(kernel)
    for name in measured_sections(kernel.model.sizes):
        assert kernel[name] == pytest.approx(oracle[name], rel=1e-12, abs=1e-12), name


def test_both_have_the_same_residual_and_tangent(twins):
    kernel, oracle = twins
    block(oracle)[:] = block(kernel)
    random, sizes = np.random.default_rng(0), kernel.model.sizes
    n, r = sizes["dim"] * sizes["n_free"], sizes["n_rows"]
    unknowns = 1e-3 * random.normal(size=n), random.normal(size=r), random.normal(size=n + r)
    (_, ours, our_product), (_, theirs, product) = (
        run.engine.probe(0.02, *unknowns) for run in twins
    )
    assert ours == pytest.approx(theirs, rel=1e-13, abs=1e-14 * np.max(np.abs(theirs)))
    # the tangents of functions are difference quotients; those of beta leave out its change
    close = 1e-4 if oracle.head["formulation"] == 5.0 else 1e-8
    assert our_product == pytest.approx(product, abs=close * np.max(np.abs(product)))
