"""Other integrators on equations reduced by hand: SciPy's DOP853, stepped in Python or compiled.

Dormand and Prince's pair of order 8 (Hairer, Norsett & Wanner I, II.5): `solve_ivp` steps it in
Python with NumPy, `ode` in compiled code; either calls the same right-hand side in plain Python.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import ode, solve_ivp

from benchmarks.problems import Problem

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Peer:
    """`run(problem, tolerance, stop)` is timed; `path` gives the states after all steps."""

    name: str
    run: Callable[[Problem, float, float], object]
    path: Callable[[Problem, float, float], Array]
    """States (variables, steps + 1)."""


def _solve(problem: Problem, tolerance: float, stop: float) -> Array:
    solution = solve_ivp(
        problem.rates, (0.0, stop), problem.start, method="DOP853", rtol=tolerance, atol=tolerance
    )
    if not solution.success:
        raise ArithmeticError(solution.message)
    return solution.y


def _compiled(problem: Problem, tolerance: float) -> ode:
    limit = 1_000_000
    return ode(problem.rates).set_integrator("dop853", rtol=tolerance, atol=tolerance, nsteps=limit)


def _solve_compiled(problem: Problem, tolerance: float, stop: float) -> Array:
    integrator = _compiled(problem, tolerance).set_initial_value(problem.start, 0.0)
    y = integrator.integrate(stop)
    if not integrator.successful():
        message = f"dop853 ended with code {integrator.get_return_code()}"
        raise ArithmeticError(message)
    return y


def _path_compiled(problem: Problem, tolerance: float, stop: float) -> Array:
    states: list[Array] = []
    integrator = _compiled(problem, tolerance)
    integrator.set_solout(lambda _, y: states.append(y.copy()))
    integrator.set_initial_value(problem.start, 0.0)
    integrator.integrate(stop)
    return np.transpose(states)


PEERS = (
    Peer("SciPy solve_ivp DOP853", _solve, _solve),
    Peer("SciPy ode dop853 (compiled)", _solve_compiled, _path_compiled),
)
