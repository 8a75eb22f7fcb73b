"""The kernel's steps and starts against the oracle's."""

from __future__ import annotations

import json
from functools import cache

import numpy as np
import pytest
from hypothesis import HealthCheck, given
from hypothesis import settings as trials

import solver
from solver.mechanics.mobility import survey
from tests.oracle import Mechanism
from tests.oracle import internal_step as step_of_the_oracle
from tests.oracle.start import consistent_velocities, first_multipliers, scales
from tests.support.kernel.kernel_calls import kernel_of
from tests.support.kernel.kernel_cases import PROFILES, SOURCES, ZOO, is_plain
from tests.support.kernel.twins import (
    EVERYTHING,
    PENDULUM,
    advance,
    internal_step,
    model_of,
    start,
    vector,
)
from tests.support.mechanisms.joint_scenes import PAIRS, pair
from tests.support.mechanisms.random_mechanisms import driven_systems

ALL = SOURCES | ZOO | PROFILES
UNDRIVEN = [name for name, source in SOURCES.items() if not model_of(source).sizes["n_signals"]]
LARGE = {name for name, source in ALL.items() if model_of(source).sizes["n_rows"] > 40}
"""Here the oracle takes long."""

BLURRED = {"double_wishbone", "screw_jack"}
"""Where rounding is multiplied: a tyre of 200 kN/m beside an arm without thickness; dependent rows
of a screw.
"""


@cache
def has_dependent_rows(name):
    """Whether some rows follow from others, as in every planar mechanism built in space."""
    return survey(model_of(ALL[name])).redundant_rows != 0


JOINED = {f"{kind} in {dim}-D": pair(dim, kind, 0.01) for dim, kind in PAIRS}
QUADRATIC = {
    name: source
    for name, source in (ALL | JOINED).items()
    if not model_of(source).sizes["n_function_rows"]
    and not (name in ALL and has_dependent_rows(name))
}
"""All rows are of rods, bars and joints, and multipliers are unique."""


def oracle_of(run):
    """Oracle at the present state of a run."""
    return Mechanism.of(run.model, run.state)


def errors_of_one_step(run, *, multipliers):
    """Differences of d, v and mu after an internal step of kernel and oracle, over their scales.

    d = h (v_n + v_n1)/2 can be no better than h times the velocities; at rest nothing is smaller
    than what gravity or a load does in the step. mu follows from a row that is a difference of
    terms l |d|, by division by h^2 sigma/2: so much of it is at the mercy of rounding, however
    exact the solution.
    """
    h, before = run.state.head["step_size"], oracle_of(run)
    internal_step(run)
    assert run.state.head["substeps"] == 2.0
    oracle = step_of_the_oracle(before, h)
    q_n, q_low, v_n = (before.vectors[name] for name in ("q", "q_low", "v"))
    a = np.max(np.abs([oracle.vectors["a_first"], oracle.vectors["a_second"]]))
    values = []
    for at in (run.state.vectors, oracle.vectors):
        x = {name: np.asarray(at[name]) for name in ("q", "q_low", "v", "v_low")}
        mu = np.concatenate([np.asarray(at["mu_first"]), np.asarray(at["mu_second"])])
        values.append(((x["q"] - q_n) + (x["q_low"] - q_low), x["v"] + x["v_low"], mu))
    (d, v, mu), (its_d, its_v, its_mu) = values
    extent = before.section["extent"][0]
    speed = max(np.max(np.abs(v_n)), np.max(np.abs(v)), h * a, 1e-5 * extent / h)
    size = max(np.max(np.abs(d)), h * speed)
    errors = [np.max(np.abs(d - its_d)) / size, np.max(np.abs(v - its_v)) / speed]
    if multipliers and len(mu):
        count = before.n_rows
        for x in (mu, its_mu):
            x.reshape(2, -1)[:, before.rigidity] = 0.0  # turns of bodies have none
        scale, sigma = (before.section[name][:count] for name in ("row_scale", "row_sigma"))
        force = np.max(np.abs(mu)) + np.max(2.0 * np.sqrt(scale) * size / (h**2 / 8.0 * sigma))
        errors.append(np.max(np.abs(mu - its_mu)) / force)
    for account in ("work", "dissipated"):
        ours, theirs = run.state.head[account], oracle.head[account]
        assert ours == pytest.approx(theirs, rel=1e-9, abs=1e-11 * before.head["energy_reference"])
    assert np.array_equal(run.state.vectors["turns"], oracle.vectors["turns"])
    return errors


@pytest.mark.parametrize("name", ALL)
def test_a_step_of_the_kernel_is_that_of_the_equations(name):
    """At points along the run; each step of both starts from the same state, against chaos.

    A step is solved to 1e-5 newton_tolerance of the energy, so to round-off of increments.
    """
    run = start(ALL[name])
    leaps = 6 if is_plain(ALL[name]) else 2 if name in LARGE else 3
    near = 1e-8 if name in BLURRED else 1e-11
    for leap in range(leaps):
        if leap:
            run.advance(run.time, run.model.experiment.stop_time / leaps)
        advance(run, 2)
        assert max(errors_of_one_step(run, multipliers=not has_dependent_rows(name))) <= near


@trials(max_examples=20, deadline=None, suppress_health_check=list(HealthCheck))
@given(driven_systems())
def test_a_random_mechanism_moves_by_the_equations(content):
    model = solver.assemble(solver.loads(json.dumps(content), format="json"))
    run = start(model, step_size=0.01)
    for _ in range(3):
        # Loops may be nearly stretched: their multipliers are then at the mercy of rounding.
        assert max(errors_of_one_step(run, multipliers=False)) <= 1e-9


@pytest.mark.parametrize("name", ALL)
def test_the_kernel_begins_as_the_equations_say(name):
    run = start(ALL[name])
    oracle = oracle_of(run)
    sizes = run.model.sizes
    # Turns fulfil the rows that keep bodies rigid: these have no multipliers, and need no sigma.
    rows = np.arange(sizes["n_rows"]) - (sizes["n_form_rows"] - sizes["n_rigidity_rows"])
    has_force = (rows < 0) | (rows >= sizes["n_rigidity_rows"])
    used = np.concatenate([np.ones(2 + len(rows), dtype=bool), has_force])
    assert vector(run, "derived")[used] == pytest.approx(scales(oracle)[used], rel=1e-13)
    if run.model.sizes["n_signals"] or run.state.head["assemble"]:
        # velocities that drivers prescribe are differences of signals, 1e-16 over 1e-4 s
        assert vector(run, "v") == pytest.approx(consistent_velocities(oracle), abs=1e-11)
    lam, a, driven = first_multipliers(oracle)
    # The core's accelerations rest on differences of the rates of rows, and where signals take part
    # on those of rates that are differences themselves: 1e-11 over 1e-3 step sizes.
    near = 1e-6 if run.model.sizes["n_signals"] else 1e-7
    for names, theirs in ((("a_first", "a_second"), a), (("driven_first", "driven_mean"), driven)):
        size = np.max(np.abs(theirs), initial=1.0)
        for part in names:
            assert vector(run, part) == pytest.approx(theirs, abs=near * size), part
    if not has_dependent_rows(name):
        size = np.max(np.abs(lam), initial=1.0)
        for part in ("mu_first", "mu_second", "mean", "mean_before"):
            found = vector(run, part)
            assert found[has_force] == pytest.approx(lam[has_force], abs=near * size), part
            assert not found[~has_force].any()


@pytest.mark.parametrize("name", QUADRATIC)
def test_steps_of_ten_nanoseconds_have_the_multipliers_of_the_start(name):
    """An error of 1e-17 m in a row would be one of 0.1 m/s2: rows are known to twice the digits."""
    run = start(QUADRATIC[name], step_size=1e-8, assemble=True)
    mu = vector(run, "mu_first")
    advance(run, 20)
    size = max(1.0, np.max(np.abs(mu), initial=0.0))
    for half in ("mu_first", "mu_second"):
        assert vector(run, half) == pytest.approx(mu, abs=1e-3 * size)


def test_a_jump_of_an_input_is_booked_by_the_equations():
    run = start(EVERYTHING[3], step_size=0.02)
    advance(run, 5)
    run["push"] = 2.0
    for _ in range(5):
        errors_of_one_step(run, multipliers=False)
    assert run["energy.error"] < 1e-13


def rows_along_the_motion(run, step):
    """(Phi(q + step v) - Phi(q - step v))/(2 step), signals held."""
    q, v = (run.state.vectors[part] for part in "qv")
    q_n = vector(run, "q")
    rows = []
    for sign in (step, -step):
        q[:] = memoryview(q_n + sign * np.asarray(v))
        rows.append(np.array(kernel_of(run).residuals()[0]))
    q[:] = memoryview(q_n)
    return (rows[0] - rows[1]) / (2.0 * step)


@pytest.mark.parametrize("name", UNDRIVEN)
def test_the_rates_of_the_rows_are_the_derivative_of_the_rows(name):
    """G v of the kernel against differences of Phi, which are exact for quadratic rows."""
    kernel = start(SOURCES[name])
    advance(kernel, 3)
    _, rates = kernel_of(kernel).residuals()
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
