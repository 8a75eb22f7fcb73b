"""SciPy's integrators on reduced equations with a compiled right-hand side.

Dormand and Prince's pair of order 8 (Hairer, Norsett & Wanner I, II.5): `ode` steps it in compiled
code, `solve_ivp` in Python with NumPy; Radau IIA of order 5 (II, IV.8) in Python, too.
"""

from __future__ import annotations

import functools
import warnings
from collections.abc import Callable, Sequence

import numpy as np
from scipy.integrate import ode, solve_ivp

from benchmarks.measuring.timing import Entry
from benchmarks.peers.peer_methods import GaveUpError, Method, Observed
from benchmarks.peers.peer_reduced import Reduced, reduced, unwritten
from benchmarks.problems.parts import Array, Problem

TOLERANCES = tuple(10.0**-k for k in range(3, 14))

Path = tuple[Array, Array]
"""Times and states (times, variables) after all steps."""


@functools.lru_cache(maxsize=1)
def equations(problem: str) -> Reduced:
    """Those of a problem, by its key."""
    from benchmarks.problems.catalogue import PROBLEMS

    return reduced(PROBLEMS[problem]())


def observed(problem: Problem, path: Path) -> Observed:
    """What a path comes to."""
    times, states = path
    look = equations(problem.key).look
    energies = [look(float(t), y)[2] for t, y in zip(times, states, strict=True)]
    q, v, _ = look(float(times[-1]), states[-1])
    return Observed.of(q, v, energies)


def compiled_path(problem: Problem, tolerance: float) -> Path:
    """DOP853 in compiled code, from `ode`."""
    equation = equations(problem.key)
    times, states = [], []

    def note(t: float, y: Array) -> None:
        times.append(t)
        states.append(y.copy())

    integrator = _dop853(equation, tolerance)
    integrator.set_solout(note)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # it warns of stiffness, and then ends with a code
        _advance(integrator, equation, problem.stop)
    return np.array(times), np.array(states)


def _dop853(equation: Reduced, tolerance: float) -> ode:
    limit = 10_000_000
    return ode(equation.rates).set_integrator(
        "dop853", rtol=tolerance, atol=tolerance, nsteps=limit
    )


def _advance(integrator: ode, equation: Reduced, stop: float) -> None:
    integrator.set_initial_value(equation.start, 0.0)
    integrator.integrate(stop)
    if not integrator.successful():
        message = f"ended with code {integrator.get_return_code()}"
        raise GaveUpError(message)


def _compiled_entry(problem: Problem, tolerance: float) -> Entry:
    equation = equations(problem.key)
    return Entry(lambda: _advance(_dop853(equation, tolerance), equation, problem.stop))


def _python_path(kind: str, problem: Problem, tolerance: float) -> Path:
    equation = equations(problem.key)
    copied: Callable[[float, Array], Array] = lambda t, y: equation.rates(t, y).copy()  # noqa: E731
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # a tolerance below what Radau takes is raised to it
        solution = solve_ivp(
            copied, (0.0, problem.stop), equation.start, method=kind, rtol=tolerance,
            atol=tolerance,
        )  # fmt: skip
    if not solution.success:
        raise GaveUpError(solution.message)
    return solution.t, solution.y.T


def _python_method(kind: str, tolerances: Sequence[float]) -> Method:
    def entry(problem: Problem, tolerance: float) -> Entry:
        return Entry(lambda: _python_path(kind, problem, tolerance))

    return Method(
        name=f"SciPy solve_ivp {kind}",
        label="tolerance {:.0e}",
        settings=lambda _: tolerances,
        observe=lambda problem, tolerance: observed(
            problem, _python_path(kind, problem, tolerance)
        ),
        entry=entry,
        excuse=_excuse(kind),
    )


def _excuse(kind: str) -> Callable[[Problem], str]:
    def excuse(problem: Problem) -> str:
        if kind == "DOP853" and problem.key == "governor":
            return "not measured: an explicit method, stepped in Python, on a stiff problem"
        if kind == "Radau" and problem.key in ("chain_100", "chain_1000"):
            return "not measured: its Jacobian by differences is dense"
        return unwritten(problem)

    return excuse


PEERS = (
    Method(
        name="SciPy ode dop853",
        label="tolerance {:.0e}",
        settings=lambda _: TOLERANCES,
        observe=lambda problem, tolerance: observed(problem, compiled_path(problem, tolerance)),
        entry=_compiled_entry,
        excuse=unwritten,
    ),
    _python_method("DOP853", TOLERANCES),
    _python_method("Radau", TOLERANCES[:9]),
)
