"""The kernel against the NumPy reference, and against its own residual."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from solver.mechanics.survey import survey
from solver.runtime import StepError
from solver.runtime.layout import measured_sections
from tests.kernel_cases import LADDER, METHODS, SOURCES, is_plain, settings
from tests.twins import (
    EVERYTHING,
    FORMULATIONS,
    KERNELS,
    PENDULUM,
    advance,
    block,
    internal_step,
    model_of,
    numbers,
    start,
    vector,
)

UNDRIVEN = [name for name, source in SOURCES.items() if not model_of(source).sizes["n_signals"]]

CASES = [
    (name, method)
    for name, source in SOURCES.items()
    for method in (LADDER if is_plain(source) else METHODS)
    # Of an angle that is driven, the roots 1/2 - 1/sqrt(12) and 1/2 + 1/sqrt(12) are equally near.
    if not (method.startswith("conserving-al-beta") and name not in UNDRIVEN)
]


BLURRED = {"double_wishbone", "conserving-al-beta nested"}
"""Where rounding is multiplied: a tyre of 200 kN/m beside an arm without thickness; the root beta
of a function that is almost quadratic, for which almost every beta will do."""


@cache
def has_dependent_rows(name):
    """Whether some rows follow from others, as in every planar mechanism built in space."""
    return survey(model_of(SOURCES[name])).redundant_rows != 0


def errors_of_one_step(name, kernel, oracle):
    """Differences of d, v and mu after one internal step of both, over their natural scales.

    d = h (v_n + v_n1)/2 can be no better than h times the velocities. mu follows from a row that
    is a difference of terms l |d|, by division by h^2 sigma/2: so much of it is at the mercy of
    rounding, however exact the solution.
    """
    block(oracle)[:] = block(kernel)
    oracle.phase = kernel.phase
    h = kernel.state.head["step_size"]
    q_n, v_n = (vector(kernel, name) for name in "qv")
    q_n_low = vector(kernel, "q_low")
    for twin in (kernel, oracle):
        internal_step(twin)
    d, v, mu = zip(
        *(
            (
                (vector(twin, "q") - q_n) + (vector(twin, "q_low") - q_n_low),
                vector(twin, "v", "v_low"),
                np.concatenate([vector(twin, "mu_first"), vector(twin, "mu_second")]),
            )
            for twin in (kernel, oracle)
        ),
        strict=True,
    )
    speed = max(np.max(np.abs(v_n)), np.max(np.abs(v[0])))
    size = max(np.max(np.abs(d[0])), h * speed)
    at, count = kernel.model.offsets, kernel.model.sizes["n_rows"]
    length2, sigma = (
        numbers(kernel)[at[name] : at[name] + count] for name in ("row_scale", "row_sigma")
    )
    force = np.max(np.abs(mu[0]), initial=1e-300) + np.max(
        2.0 * np.sqrt(length2) * size / (0.5 * (0.5 * h) ** 2 * sigma), initial=0.0
    )
    pairs = list(zip((d, v, mu), (size, speed, force), strict=True))
    if has_dependent_rows(name):  # their multipliers are not determined; their forces are
        del pairs[2]
    return [np.max(np.abs(x - y), initial=0.0) / scale for (x, y), scale in pairs]


@pytest.mark.parametrize(("name", "method"), CASES)
def test_the_kernel_equals_the_reference_step_by_step(name, method):
    """At points along the run; each step of both starts from the same state, against chaos."""
    model = model_of(SOURCES[name])
    kernel, oracle = (start(model, twin, **settings(method)) for twin in KERNELS)
    leaps = 12 if is_plain(SOURCES[name]) else 4
    leap = model.experiment.stop_time / leaps
    compared = 0
    try:
        for _ in range(leaps):
            for error in errors_of_one_step(name, kernel, oracle):
                assert error <= (1e-8 if method in BLURRED or name in BLURRED else 1e-11)
            compared += 1
            kernel.advance(kernel.time, leap)
    except StepError:
        # The midpoint rule blows up, which is the point of the paper.
        assert method.startswith("midpoint")
    assert compared >= 2


@pytest.mark.parametrize("name", SOURCES)
def test_both_begin_alike_and_measure_alike(name):
    kernel, oracle = (start(SOURCES[name], twin) for twin in KERNELS)
    derived = {"a_first", "a_second", "driven_first", "driven_second", "quaternion"}
    derived |= {name for name in kernel.state.vectors if name.startswith(("mu", "mean", "driven"))}
    for part in set(kernel.state.vectors) - derived:
        ours, theirs = vector(kernel, part), vector(oracle, part)
        # velocities that drivers prescribe are differences of signals, 1e-16 over 1e-4 s
        assert ours == pytest.approx(theirs, rel=1e-13, abs=1e-11 if part == "v" else 1e-13), part
    for part in derived:  # accelerations rest on differences of rates in time, to about 1e-9
        ours, theirs = vector(kernel, part), vector(oracle, part)
        if not (has_dependent_rows(name) and part.startswith(("mu", "mean"))):
            size = np.max(np.abs(theirs), initial=1.0)
            assert ours == pytest.approx(theirs, abs=1e-7 * size), part
    advance(kernel, 7)
    advance(oracle, 7)
    block(oracle)[:] = block(kernel)
    for twin in (kernel, oracle):
        twin.engine.measure()
    base = kernel.model.offsets["measured"]
    for section, (start_at, count) in measured_sections(kernel.model.sizes).items():
        part = slice(base + start_at, base + start_at + count)
        ours, theirs = numbers(kernel)[part], numbers(oracle)[part]
        near = 1e-10 if section == "residual" else 1e-12 if section == "energy" else 1e-14
        assert ours == pytest.approx(theirs, rel=1e-13, abs=near * max(1.0, *np.abs(theirs), 0.0))
    (phi, rates), (its_phi, its_rates) = kernel.engine.residuals(), oracle.engine.residuals()
    assert phi == pytest.approx(its_phi, abs=1e-14)
    assert rates == pytest.approx(
        its_rates, abs=1e-10 if kernel.model.sizes["n_signals"] else 1e-14
    )


def test_both_book_the_same_ledger():
    kernel, oracle = (start(EVERYTHING[3], twin, step_size=0.02) for twin in KERNELS)
    for twin in (kernel, oracle):
        advance(twin, 5)
        twin["push"] = 2.0
        advance(twin, 5)
    for account in ("energy.work", "energy.dissipated", "energy.total"):
        assert kernel[account] == pytest.approx(oracle[account], rel=1e-12)
        assert kernel["energy.error"] < 1e-13


# --------------------------------------------------------------------------- residual and tangent


@pytest.fixture(params=[2, 3], ids=["plane", "space"], scope="module")
def probed(request):
    """Kernel and reference in the same state of a mechanism of all laws, a little under way."""
    model = model_of(EVERYTHING[request.param])
    kernel, oracle = (start(model, twin, penalty=10.0, step_size=0.05) for twin in KERNELS)
    advance(kernel, 2)
    numbers(oracle)[:] = numbers(kernel)
    return kernel, oracle


def unknowns(kernel, size, seed):
    """Random w [m] of a size, mu, and a direction (w, mu)."""
    random = np.random.default_rng(seed)
    n, r = len(kernel.state.vectors["q"]), kernel.model.sizes["n_rows"]
    return size * random.normal(size=n), 5.0 * random.normal(size=r), random.normal(size=n + r)


def choose(formulation, kernel, oracle):
    """Set the formulation; both are in the kernel's state."""
    kernel.state.head["formulation"] = FORMULATIONS.index(formulation)
    block(oracle)[:] = block(kernel)


@pytest.mark.parametrize("size", [1e-9, 1e-2, 1.0])
@pytest.mark.parametrize("formulation", FORMULATIONS)
def test_residual_and_tangent_of_the_kernel_are_those_of_the_reference(probed, formulation, size):
    """At increments from none (series of the torque's law) to links turned by more than 90°."""
    kernel, oracle = probed
    choose(formulation, kernel, oracle)
    for seed in range(5):
        w, mu, x = unknowns(kernel, size, seed)
        status, *ours = kernel.engine.probe(0.1, w, mu, x)
        _, *theirs = oracle.engine.probe(0.1, w, mu, x)
        assert status == 0
        for a, b in zip(ours, theirs, strict=True):
            # terms up to 1e2 (1e5 in the rows of penalty-velocity) cancel
            assert a == pytest.approx(b, rel=1e-12, abs=1e-13 * np.max(np.abs(b)))


@pytest.mark.parametrize("size", [1e-9, 1e-2, 1.0])
@pytest.mark.parametrize("formulation", FORMULATIONS)
def test_the_tangent_is_the_derivative_of_the_residual(probed, formulation, size):
    kernel, oracle = probed
    choose(formulation, kernel, oracle)
    for seed in range(5):
        w, mu, x = unknowns(kernel, size, seed)
        n, step = len(w), 1e-5
        _, _, tangent = kernel.engine.probe(0.1, w, mu, x)
        ahead, behind = (
            np.array(kernel.engine.probe(0.1, w + s * x[:n], mu + s * x[n:], x)[1])
            for s in (step, -step)
        )
        # truncation step^2 times third derivatives of order 10, rounding 1e-16/step
        scale = np.max(np.abs(tangent))
        assert (ahead - behind) / (2.0 * step) == pytest.approx(tangent, abs=1e-8 * scale)


def rows_along_the_motion(run, step):
    """(Phi(q + step v) - Phi(q - step v))/(2 step), signals held."""
    q, v = (run.state.vectors[part] for part in "qv")
    q_n = vector(run, "q")
    rows = []
    for sign in (step, -step):
        q[:] = memoryview(q_n + sign * np.asarray(v))
        rows.append(np.array(run.engine.residuals()[0]))
    q[:] = memoryview(q_n)
    return (rows[0] - rows[1]) / (2.0 * step)


@pytest.mark.parametrize("name", UNDRIVEN)
def test_the_rates_of_the_rows_are_the_derivative_of_the_rows(name):
    """G v of the kernel against differences of Phi, which are exact for quadratic rows."""
    kernel = start(SOURCES[name])
    advance(kernel, 3)
    _, rates = kernel.engine.residuals()
    sizes, scale = kernel.model.sizes, max(1.0, np.max(np.abs(vector(kernel, "v"))))
    coarse, fine = (rows_along_the_motion(kernel, step / scale) for step in (1e-3, 5e-4))
    quadratic = sizes["n_form_rows"] + sizes["dim"] * sizes["n_coincidences"]
    # rounding 1e-16 l^2 over the step
    assert fine[:quadratic] == pytest.approx(rates[:quadratic], abs=2e-12 * scale)
    last = quadratic + sizes["n_function_rows"]
    functions = (4.0 * fine - coarse)[quadratic:last] / 3.0
    assert functions == pytest.approx(rates[quadratic:last], rel=1e-9, abs=1e-9 * scale)


def test_the_first_pair_needs_no_more_iterations_than_the_next():
    """Both halves start from the acceleration at rest, not from one of another step length.

    A try with lean factors, which may then be given up, takes two increments more in each.
    """
    for source in (PENDULUM, *SOURCES.values()):
        run = start(source)
        counts = []
        for _ in range(3):
            internal_step(run)
            counts.append(run.state.head["newton_iterations"])
            assert run.state.head["substeps"] == 2
        assert counts[0] <= 2.0 * max(counts[1:]) + 4.0
