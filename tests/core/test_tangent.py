"""Residual and tangent of the kernel against the oracle's, and against each other."""

from __future__ import annotations

import numpy as np
import pytest

from solver.runtime.layout import ISLAND
from tests.oracle import Mechanism, Residual
from tests.support.kernel.kernel_calls import kernel_of
from tests.support.kernel.kernel_cases import SOURCES, ZOO
from tests.support.kernel.twins import EVERYTHING, advance, model_of, numbers, start, vector

ALL = SOURCES | ZOO


@pytest.fixture(params=[2, 3], ids=["plane", "space"], scope="module")
def probed(request):
    """Kernel in a state of a mechanism of all laws, a little under way."""
    run = start(model_of(EVERYTHING[request.param]), step_size=0.05)
    advance(run, 2)
    run.state.head["penalty"] = 10.0  # so that the rows' compliance is seen
    return run


def unknowns(run, size, seed):
    """Random w [m] of a size, mu, and a direction (w, mu)."""
    random = np.random.default_rng(seed)
    sizes = run.model.sizes
    n, r = sizes["dim"] * sizes["n_free"], sizes["n_rows"]
    return size * random.normal(size=n), 5.0 * random.normal(size=r), random.normal(size=n + r)


def probe_of_the_oracle(run, h, w, mu, x):
    """Residual and tangent times x, rows as in the kernel.

    They are Phi_n1 - (2/alpha) mu there, which is eq 15 with lam = -alpha Phi_n/2.
    """
    oracle = Mechanism.of(run.model, run.state)
    oracle.numbers[:] = numbers(run)
    equations = Residual(oracle, h)
    lam = -0.5 * equations.alpha * equations.phi_n
    n, step = len(w), 1e-30j
    residual = equations.residual(w, mu, lam)
    ahead = equations.residual(w + step * x[:n], mu + step * x[n:], lam)
    rows = np.where(np.arange(len(x)) < n, 1.0, 2.0)
    return rows * residual, rows * ahead.imag / 1e-30


def lower_penalties(run):
    """Lower penalties to those that were asked for, which are the oracle's."""
    levels = np.asarray(run.state.vectors["islands"])[ISLAND.index("penalty_level") :: len(ISLAND)]
    levels[:] = 0.0


def is_near(ours, theirs):
    """Whether they are equal but for the rounding of terms, up to 1e5 in rows, that cancel."""
    return ours == pytest.approx(theirs, rel=1e-12, abs=1e-13 * np.max(np.abs(theirs)))


@pytest.mark.parametrize("size", [1e-9, 1e-2, 1.0])
def test_residual_and_tangent_of_the_kernel_are_those_of_the_equations(probed, size):
    """At increments from none (series of the torque's law) to links turned by more than 90°."""
    for seed in range(5):
        arguments = unknowns(probed, size, seed)
        status, *ours = kernel_of(probed).probe(0.1, *arguments)
        assert status == 0
        for a, b in zip(ours, probe_of_the_oracle(probed, 0.1, *arguments), strict=True):
            assert is_near(a, b)


@pytest.mark.parametrize("name", ALL)
def test_residual_and_tangent_of_every_scene_are_those_of_the_equations(name):
    """At increments next to those of the motion: formulas of a scene may have no value far off."""
    run = start(ALL[name])
    advance(run, 2)
    lower_penalties(run)
    h = run.state.head["step_size"]
    for seed in range(3):
        _, mu, x = unknowns(run, 1.0, seed)
        free = len(x) - len(mu)
        w = 0.5 * h**2 * vector(run, "a_first")[:free] * (1.0 + 0.1 * seed)
        status, *ours = kernel_of(run).probe(h, w, mu, x)
        assert status == 0
        for a, b in zip(ours, probe_of_the_oracle(run, h, w, mu, x), strict=True):
            # Rows of all scales are beside balances of all scales; each is a sum that cancels.
            assert a == pytest.approx(b, rel=1e-10, abs=1e-11 * np.max(np.abs(b)))


@pytest.mark.parametrize("size", [1e-9, 1e-2, 1.0])
def test_the_tangent_is_the_derivative_of_the_residual(probed, size):
    kernel = probed
    for seed in range(5):
        w, mu, x = unknowns(kernel, size, seed)
        n, step = len(w), 1e-5
        _, _, tangent = kernel_of(kernel).probe(0.1, w, mu, x)
        ahead, behind = (
            np.array(kernel_of(kernel).probe(0.1, w + s * x[:n], mu + s * x[n:], x)[1])
            for s in (step, -step)
        )
        # truncation step^2 times third derivatives of order 10, rounding 1e-16/step
        scale = np.max(np.abs(tangent))
        assert (ahead - behind) / (2.0 * step) == pytest.approx(tangent, abs=1e-8 * scale)
