"""Vectors of a run and integrals over its steps, for what forces and drivers do."""

from __future__ import annotations

from typing import TypeAlias

import numpy as np

import solver
from tests.support.kernel.kernel_calls import kernel_of
from tests.support.mechanisms.problems import Array

ROUND_OFF = 1e-12
"""Of the energies exchanged, over a few hundred steps that are each solved to round-off."""


class HalfSteps(dict[str, Array]):
    """Outputs of a run at the ends of all half steps of length h, which pairs consist of."""

    def __init__(self, scene: solver.Scene, *, stop_time: float, h: float) -> None:
        run = solver.Integrator(solver.assemble(scene))
        run["solver.step_size"] = 2.0 * h
        run.initialise()
        run.begin()
        names = [v.name for v in run.model.variables if v.causality == "output"]
        places = [run.model.index(name) for name in names]
        rows, self.t = [run.get(places)], h * np.arange(round(stop_time / h) + 1)
        for k in range(len(self.t) - 1):
            saved = run.save()
            if kernel_of(run).half_step(h, k % 2):  # polynomials miss what turns fast
                run.restore(saved)
                run.state.head["known"] = 0.0
                assert kernel_of(run).half_step(h, k % 2) == 0
            run.restore(run.save())  # so that outputs are evaluated anew
            rows.append(run.get(places))
        super().__init__(zip(names, np.array(rows, dtype=float).T, strict=True))


Run: TypeAlias = solver.Trajectory | HalfSteps


def vector(run: Run, name: str, axes: str = "xyz") -> Array:
    """Components of a vector, shape (n, len(axes)): vector(run, "A.v") is A.vx, A.vy, A.vz."""
    return np.stack([run[f"{name}{axis}"] for axis in axes], axis=-1)


def middles(values: Array) -> Array:
    """Means of neighbours in time."""
    return 0.5 * (values[1:] + values[:-1])


def sums(values: Array) -> Array:
    """0 and the running sums."""
    return np.concatenate([[0.0], np.cumsum(values)])


def trapezoids(rate: Array, h: float) -> Array:
    """Running integral of a rate by trapezoids."""
    return sums(h * middles(rate))
