"""Splines of profiles from their tables; slopes over a step are means of the derivative.

    (f(x_n1) - f(x_n))/(x_n1 - x_n) = mean of f' over the step,

piece by piece by Gauss-Legendre quadrature of three points, which is exact up to degree 5.
A table has the period, 0 for none, and rows (x_k, c_0, ..., c_4) for sum_j c_j (x - x_k)^j.
"""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Number = Any

ORDERS = {"spline": 0, "spline_slope": 1, "spline_curvature": 2}
"""Operations, and which derivative each of them is."""

_AT, _WEIGHT = np.polynomial.legendre.leggauss(3)


def value(order: int, x: Number, table: Array, where: float | None = None) -> Number:
    """Derivative of this order at `x`, by the piece that `where` lies in: `x`, unless given."""
    rows = np.asarray(table[1:]).reshape(-1, 6)
    where = float(np.real(x if where is None else where))
    turns = np.floor((where - rows[0, 0]) / table[0]) if table[0] > 0.0 else 0.0
    shift = turns * table[0]
    k = max(int(np.searchsorted(rows[1:, 0], where - shift, side="right")), 0)
    coefficients = np.polynomial.polynomial.polyder(rows[k, 1:], order) if order else rows[k, 1:]
    return np.polynomial.polynomial.polyval(x - shift - rows[k, 0], coefficients)


def slope(order: int, n: Number, n1: Number, table: Array) -> Number:
    """Slope between two ends; where they coincide, the derivative."""
    if np.real(n) == np.real(n1):
        return value(order + 1, n, table)
    knots, (low, high) = np.asarray(table[7::6]), sorted((float(np.real(n)), float(np.real(n1))))
    if table[0] > 0.0:
        turns = np.arange(np.floor((low - knots[0]) / table[0]), (high - knots[0]) // table[0] + 1)
        knots = (knots[:-1] + turns[:, None] * table[0]).ravel()
    cuts = [low, *(x for x in knots if low < x < high), high]
    cuts = cuts if np.real(n) <= np.real(n1) else cuts[::-1]
    ends = [n, *cuts[1:-1], n1]
    total = 0.0
    for left, right in pairwise(ends):
        middle, half = 0.5 * (left + right), 0.5 * (right - left)
        means = [value(order + 1, middle + half * at, table, middle) for at in _AT]
        total = total + half * sum(w * y for w, y in zip(_WEIGHT, means, strict=True))
    return total / (n1 - n)
