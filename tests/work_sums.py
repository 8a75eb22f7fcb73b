"""Vectors of a run and integrals over its steps, for what forces and drivers do."""

from __future__ import annotations

import numpy as np

import solver
from tests.problems import Array

ROUND_OFF = 1e-12
"""Of the energies exchanged, over a few hundred steps that are each solved to round-off."""


def vector(run: solver.Trajectory, name: str, axes: str = "xyz") -> Array:
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
