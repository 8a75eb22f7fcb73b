"""Inertia of a rigid body as the masses of its directors: the Euler tensor.

    E = tr(J)/2 I - J,      J_perp of an axis a = tr(E) - a' E a,      (theory 9.1)

E is zero along what has no extent: a rod, a plate, a point. A direction without inertia would have
no equation of motion, so such a body gets the smallest one that computes safely.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial, reduce

import numpy as np

from solver.mechanics.vectors import Matrix, Vector, dot, times
from solver.scene import Number
from solver.scene.expression import operate

FLOOR = 1e-7
"""Least inertia of a director, relative to the largest; of a point-like body, to m l^2. A hundredth
of it fails where joints are redundant: their pivots, of 1e-8, drown in rounding. A rod in flight
turns about its own axis by round-off of its torques over this inertia: Newton's iteration sees it
with a tenth of it."""
ROUNDING = 5e-8
"""By how much parameters may let E miss zero, relative to its trace: `FORGIVEN` of the moments."""


def euler_tensor(inertia: Matrix) -> Matrix:
    """Return E [kg m^2] of an inertia matrix J about the same place."""
    half = (inertia[0][0] + inertia[1][1] + inertia[2][2]) / 2.0
    return tuple(
        tuple(half - x if i == k else -1.0 * x for k, x in enumerate(row))
        for i, row in enumerate(inertia)
    )


def minors(E: Matrix) -> tuple[Number, Number, Number]:
    """Return what is positive for every body: E + ROUNDING tr(E) I has positive minors.

    For principal moments this is the triangle inequality, J_i + J_j >= J_k.
    """
    trace = E[0][0] + E[1][1] + E[2][2]
    a, b, c = (E[i][i] + ROUNDING * trace for i in range(3))
    d, e, f = E[0][1], E[0][2], E[1][2]
    plane = a * b - d * d
    return a, plane, c * plane - a * f * f - b * e * e + 2.0 * d * e * f


def floored(E: Matrix, default: Callable[[Number], float], least: float = FLOOR) -> Matrix:
    """Return E with enough inertia along each of its axes.

    Along an axis v_k with less, `least` times the largest is given, and the axes that have enough
    give as much: the transverse inertias of a rod, the sums of two of E's eigenvalues, stay exact
    and only its spin inertia is biased. Axes and cases are those of the default values, but for a
    diagonal E that parameters make thin.
    """
    values, axes = _principal([[default(x) for x in row] for row in E])
    largest = max(range(3), key=lambda k: values[k])
    thin = [k for k in range(3) if values[k] < least * values[largest]]
    if not thin:
        return _kept_thick(E, least)
    floor = least * dot(axes[largest], times(E, axes[largest]))
    lacking = {k: operate("max", floor - dot(axes[k], times(E, axes[k])), 0.0) for k in thin}
    mean: Number = 0.0
    for lack in lacking.values():
        mean = mean + lack / float(len(thin))
    for k in range(3):
        E = _added(E, lacking.get(k, -1.0 * mean), axes[k])
    return E


def _kept_thick(E: Matrix, least: float) -> Matrix:
    """Return E with a floor below diagonal elements that parameters could make smaller."""
    diagonal = [E[i][i] for i in range(3)]
    parts = [E[i][k] for i in range(3) for k in range(3) if i != k]
    if all(isinstance(x, float) for x in diagonal) or any(x != 0.0 for x in parts):
        return E
    floor = least * reduce(partial(operate, "max"), diagonal)
    thick = [operate("max", x, floor) for x in diagonal]
    return tuple(tuple(thick[i] if i == k else 0.0 for k in range(3)) for i in range(3))


def _principal(E: list[list[float]]) -> tuple[Sequence[float], list[Vector]]:
    """Eigenvalues and axes of E; those of a diagonal matrix are exact."""
    if all(E[i][k] == 0.0 for i in range(3) for k in range(3) if i != k):
        return [E[k][k] for k in range(3)], [tuple(np.eye(3)[k].tolist()) for k in range(3)]
    values, vectors = np.linalg.eigh(np.array(E))
    return values.tolist(), [tuple(vectors[:, k].tolist()) for k in range(3)]


def _added(E: Matrix, amount: Number, axis: Vector) -> Matrix:
    """Return E + amount axis axis'."""
    return tuple(
        tuple(x + amount * (axis[i] * axis[k]) for k, x in enumerate(row))
        for i, row in enumerate(E)
    )
