"""SUNDIALS' CVODE on the reduced equations; runs where the package `scikit-sundae` is.

A. C. Hindmarsh et al., "SUNDIALS: suite of nonlinear and differential/algebraic equation solvers",
ACM TOMS 31 (2005) 363-396. The right-hand sides are the compiled ones that SciPy's methods have.
"""

from __future__ import annotations

import functools

import numpy as np
from sksundae.cvode import CVODE

from benchmarks.measuring.timing import Entry
from benchmarks.peers.peer_methods import SAMPLES, GaveUpError, Method, Observed
from benchmarks.peers.peer_reduced import Reduced, reduced, unwritten
from benchmarks.problems.catalogue import PROBLEMS
from benchmarks.problems.parts import Array, Problem

TOLERANCES = tuple(10.0**-k for k in range(3, 14))
LARGEST = 200
"""Variables above which a dense Jacobian by differences takes too long."""


@functools.lru_cache(maxsize=1)
def _equations(key: str) -> Reduced:
    return reduced(PROBLEMS[key]())


def _solver(equation: Reduced, kind: str, tolerance: float) -> CVODE:
    def slopes(t: float, y: Array, slope: Array) -> None:
        slope[:] = equation.rates(t, y)

    return CVODE(slopes, method=kind, rtol=tolerance, atol=tolerance, max_num_steps=10_000_000)


def _solve(solver: CVODE, equation: Reduced, times: Array) -> Array:
    solution = solver.solve(times, equation.start)
    if not solution.success:
        raise GaveUpError(str(solution.message))
    return solution.y


def _observe(problem: Problem, kind: str, tolerance: float) -> Observed:
    equation = _equations(problem.key)
    times = np.linspace(0.0, problem.stop, SAMPLES + 1)
    states = _solve(_solver(equation, kind, tolerance), equation, times)
    energies = [equation.look(t, y)[2] for t, y in zip(times, states, strict=True)]
    q, v, _ = equation.look(problem.stop, states[-1])
    return Observed.of(q, v, energies)


def _method(kind: str) -> Method:
    def entry(problem: Problem, tolerance: float) -> Entry:
        equation = _equations(problem.key)
        ends = np.array([0.0, problem.stop])
        return Entry(lambda: _solve(_solver(equation, kind, tolerance), equation, ends))

    return Method(
        name=f"CVODE {kind}",
        label="tolerance {:.0e}",
        settings=lambda _: TOLERANCES,
        observe=lambda problem, tolerance: _observe(problem, kind, tolerance),
        entry=entry,
        excuse=_excuse,
    )


def _excuse(problem: Problem) -> str:
    if excuse := unwritten(problem):
        return excuse
    if len(_equations(problem.key).start) > LARGEST:
        return "not measured: its Jacobian by differences is dense"
    return ""


METHODS = (_method("Adams"), _method("BDF"))
