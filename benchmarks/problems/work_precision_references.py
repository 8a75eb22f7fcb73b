"""Where the problems are at their end: closed forms, or the reduced equations at their limit."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from benchmarks.peers.peer_reduced import unwritten
from benchmarks.peers.peer_scipy import compiled_path, equations
from benchmarks.problems.exact import double_pendulum_motion, four_bar_motion
from benchmarks.problems.parts import Problem
from benchmarks.sections import work_precision_ours

SHARPEST = 1e-13
"""Tolerance of the solutions that stand for exact ones, relative and absolute."""
FINEST = 32
"""Steps of our own solution where nothing else is known, over those of the coarsest run."""


@dataclass(frozen=True, slots=True)
class Reference:
    """Positions and velocities of the watched places at the end, and the change of energy [J]."""

    q: list[list[float]]
    v: list[list[float]]
    change: float
    source: str


def reference(problem: Problem) -> Reference:
    """What is known of the end of a problem, independently of our solver."""
    if unwritten(problem):
        return _ours(problem)
    family = problem.key.rpartition("_")[0]
    if family == "double_pendulum":
        state = double_pendulum_motion(problem.data["angle"], problem.stop)
        source = "reduced equations, extrapolated to order 20 in extended precision"
    elif family == "four_bar":
        state = four_bar_motion(problem.stop, loops=round(problem.data["loops"]))
        source = "Jacobi's elliptic functions"
    else:
        state = compiled_path(problem, SHARPEST)[1][-1]
        source = f"reduced equations, DOP853 with tolerance {SHARPEST:g}"
    look, start = equations(problem.key).look, equations(problem.key).start
    energy = look(0.0, start)[2]
    q, v, last = look(problem.stop, np.array(state, dtype=float))
    return Reference(q.tolist(), v.tolist(), last - energy, source)


def _ours(problem: Problem) -> Reference:
    """The end of our run of order 8 with steps far below those that are measured."""
    method = work_precision_ours.methods(problem)[work_precision_ours.ORDERS.index(8)]
    count = FINEST * work_precision_ours.DRAWN[problem.key].first
    end = method.observe(problem, count)
    source = f"ours, order 8 with {count} steps"
    return Reference([list(q) for q in end.q], [list(v) for v in end.v], end.change, source)
