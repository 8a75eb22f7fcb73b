"""Motions known independently of the solver, in minimal coordinates.

Double pendulum, angles a, b of the rods from the vertical, unit masses and lengths:

    2 a'' + cos(a - b) b'' = -sin(a - b) b'^2 - 2 g sin a
    cos(a - b) a'' + b''   =  sin(a - b) a'^2 -   g sin b

integrated with Gragg's modified midpoint rule extrapolated to order 20 (Gragg 1965; Hairer, Norsett
& Wanner I, II.9), in the widest floating-point numbers of the platform. Four-bar with N loops,
angle phi of the cranks from the upright: I phi'' = W g sin phi, I = (N+1)/3 + N, W = (N+1)/2 + N,
solved by Jacobi's amplitude:

    phi = pi + 2 am(A t/2 - K, m),   A^2 = phi'(0)^2 + 4 W g/I,   m = 4 W g/(I A^2)
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.special import ellipj, ellipkm1

from benchmarks.problems.mechanisms import GRAVITY

Array = NDArray[np.float64]
Extended = NDArray[np.longdouble]

STAGES = 10


def double_pendulum_rates(
    _t: float,
    y: Sequence[float],
    sin: Callable[[Any], Any] = math.sin,
    cos: Callable[[Any], Any] = math.cos,
) -> list[float]:
    """Derivatives of (a, b, a', b'), written for speed in plain Python."""
    a, b, da, db = y
    s, c = sin(a - b), cos(a - b)
    f = -s * db * db - 2.0 * GRAVITY * sin(a)
    g = s * da * da - GRAVITY * sin(b)
    determinant = 2.0 - c * c
    return [da, db, (f - c * g) / determinant, (2.0 * g - c * f) / determinant]


def double_pendulum_motion(angle: float, stop: float, step: float = 0.0125) -> Extended:
    """Return (a, b, a', b') at `stop`, released from rest with both rods at `angle`."""

    def rates(y: Extended) -> Extended:
        return np.array(double_pendulum_rates(0.0, tuple(y), np.sin, np.cos), dtype=np.longdouble)

    y = np.array([angle, angle, 0.0, 0.0], dtype=np.longdouble)
    count = max(1, round(stop / step))
    h = np.longdouble(stop) / count
    for _ in range(count):
        y = _extrapolated_step(rates, y, h)
    return y


def _extrapolated_step(rates: Callable[[Any], Any], y: Extended, h: np.longdouble) -> Extended:
    """One step of length h: midpoint rules of 2, 4, ... substeps, extrapolated in their square."""
    row: list[Extended] = []
    start = rates(y)
    for stage in range(1, STAGES + 1):
        n = 2 * stage
        previous, present = y, y + h / n * start
        for _ in range(n - 1):
            previous, present = present, previous + 2 * (h / n) * rates(present)
        row.append(present)
        # Aitken and Neville; the row ends in the column of the highest order so far.
        for k in range(stage - 2, -1, -1):
            ratio = np.longdouble(n / (2 * (k + 1))) ** 2
            row[k] = row[k + 1] + (row[k + 1] - row[k]) / (ratio - 1)
    return row[0]


def four_bar_motion(t: float, loops: int = 2, rate: float = 1.0) -> tuple[float, float]:
    """Return phi and phi' at `t`, started upright with `rate` [rad/s]."""
    inertia, weight = (loops + 1) / 3 + loops, (loops + 1) / 2 + loops
    swing = 4 * weight * GRAVITY / inertia
    fastest = math.sqrt(rate**2 + swing)
    rest = (rate / fastest) ** 2
    _, _, dn, amplitude = ellipj(0.5 * fastest * t - ellipkm1(rest), 1.0 - rest)
    return math.pi + 2.0 * float(amplitude), fastest * float(dn)
