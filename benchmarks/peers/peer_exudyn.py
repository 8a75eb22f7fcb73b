"""Exudyn on the problems of the work-precision curves; runs where the package `exudyn` is."""

from __future__ import annotations

import functools

import numpy as np

from benchmarks.measuring.timing import Entry
from benchmarks.peers.exudyn_problem import ALPHA, TRAPEZOIDAL, Build
from benchmarks.peers.peer_methods import SAMPLES, GaveUpError, Method, Observed
from benchmarks.problems.catalogue import PROBLEMS
from benchmarks.problems.parts import Problem, energies

FIRST = {"andrews": 100, "heavy_top": 100, "governor": 200, "car_axis": 100}
"""Steps of the coarsest run; chains of points begin with some that lead to steps of 1 ms."""
NEWTON, FINE = (1e-8, 1e-11), 10_000
"""Relative tolerances: Exudyn's own, and one for runs of so many steps, where it would show."""


def _solve(build: Build, count: int, method: tuple, newton: float) -> None:
    try:
        build.solve(count, method=method, newton=newton)
    except ArithmeticError as error:
        raise GaveUpError(str(error)) from error


@functools.cache
def _sharpest(key: str, count: int, method: tuple) -> float:
    """Smaller Newton tolerance of fine steps, unless a step fails with it."""
    if count >= FINE:
        try:
            _solve(Build(PROBLEMS[key]()), count, method, NEWTON[1])
        except GaveUpError:
            return NEWTON[0]
        return NEWTON[1]
    return NEWTON[0]


def _observe(problem: Problem, count: int, method: tuple) -> Observed:
    build = Build(problem, period=problem.stop / min(SAMPLES, count))
    _solve(build, count, method, _sharpest(problem.key, count, method))
    found = build.recorded()
    energy = energies(problem, lambda name, what: found[name, what])
    if problem.key == "car_axis":
        energy = energy + _car_springs(problem, found)
    last = range(len(problem.watch))
    q = np.array([found[problem.watch[i][0], f"watch{i}"][-1] for i in last])
    v = np.array([found[problem.watch[i][0], f"speed{i}"][-1] for i in last])
    if not np.all(np.isfinite(q)):
        message = "diverged"
        raise GaveUpError(message)
    return Observed.of(q, v, energy.tolist())


def _car_springs(problem: Problem, found: dict[tuple[str, str], np.ndarray]) -> np.ndarray:
    k = problem.data
    t = np.linspace(0.0, problem.stop, len(found["A", "x"]))
    s = k["wave"] * np.sin(k["omega"] * t)
    wheel = np.stack([np.sqrt(k["length"] ** 2 - s**2), s, 0.0 * s], axis=1)
    stretch = [
        np.linalg.norm(found["A", "x"], axis=1),
        np.linalg.norm(found["B", "x"] - wheel, axis=1),
    ]
    return sum(0.5 * k["stiffness"] * (l - k["free_length"]) ** 2 for l in stretch)  # noqa: E741


def counts(problem: Problem) -> list[float]:
    """Numbers of steps from coarse to fine."""
    if problem.key.startswith(("chain_", "net_")):
        return [8.0, 40.0, 200.0, 1000.0, 4000.0, 16000.0]
    return [float(FIRST.get(problem.key, 200) * 4**k) for k in range(8)]


def _method(name: str, method: tuple) -> Method:
    def entry(problem: Problem, count: float) -> Entry:
        # A run leaves the system where it ended, but always begins at the initial values.
        build = Build(problem)
        newton = _sharpest(problem.key, int(count), method)
        return Entry(lambda: _solve(build, int(count), method, newton))

    return Method(
        name=f"Exudyn {name}",
        label="{:g} steps",
        settings=counts,
        observe=lambda problem, count: _observe(problem, int(count), method),
        entry=entry,
    )


METHODS = (
    _method("generalized alpha", ALPHA),
    _method("trapezoidal, index 2", TRAPEZOIDAL),
)
