"""Exact positions of driven mechanisms, and motions with a closed form; nothing of the solver."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
from scipy.linalg import expm
from scipy.optimize import root

from tests.support.mechanisms.reduced_models import Array, rotation


def meet(p: Array, r: float, q: Array, s: float, side: int) -> Array:
    """Pin of two links of lengths r from p and s from q; side 1: to the left of p -> q."""
    d = math.dist(p, q)
    along = (d**2 + r**2 - s**2) / (2 * d)
    e = (q - p) / d
    return p + along * e + side * math.sqrt(r**2 - along**2) * np.array([-e[1], e[0]])


def cardan_angle(driving: Array, bend: float) -> Array:
    """Angle of the driven shaft, tan(driven) = cos(bend) tan(driving), continuous."""
    return driving + np.arctan2(
        (math.cos(bend) - 1) * np.sin(driving) * np.cos(driving),
        np.cos(driving) ** 2 + math.cos(bend) * np.sin(driving) ** 2,
    )


def slider_crank(angle: Array, crank: float, rod: float) -> tuple[Array, Array]:
    """Angle of the rod and place of the slider at crank angles."""
    swing = -np.arcsin(crank / rod * np.sin(angle))
    return swing, crank * np.cos(angle) + rod * np.cos(swing)


def stephenson(angle: float) -> dict[str, Array]:
    """Pins of `scenes/stephenson.toml` at an angle of the crank from x."""
    A0, B0, C0, D0 = (np.array(p) for p in ([0, 0.1], [0.35, 0.25], [0.25, 0.4], [0.6, 0.45]))
    O4, O6 = np.array([0.4, 0.0]), np.array([0.65, 0.1])
    A = 0.1 * np.array([math.cos(angle), math.sin(angle)])
    B = meet(A, math.dist(A0, B0), O4, math.dist(O4, B0), 1)
    C = meet(A, math.dist(A0, C0), B, math.dist(B0, C0), 1)
    D = meet(C, math.dist(C0, D0), O6, math.dist(O6, D0), 1)
    return {"A": A, "B": B, "C": C, "D": D}


def jansen(angle: float) -> dict[str, Array]:
    """Pins of Jansen's leg at an angle of the crank; lengths in m from the book, in cm."""
    pivot, X = np.array([-0.38, -0.078]), 0.15 * np.array([math.cos(angle), math.sin(angle)])
    A = meet(pivot, 0.415, X, 0.50, 1)
    D = meet(pivot, 0.393, X, 0.619, -1)
    C = meet(pivot, 0.401, A, 0.558, 1)
    F = meet(C, 0.394, D, 0.367, -1)
    return {"X": X, "A": A, "C": C, "D": D, "F": F, "foot": meet(F, 0.657, D, 0.49, -1)}


def peaucellier(angle: float) -> dict[str, Array]:
    """Pins of Peaucellier's linkage (arm 1, links 2.5 and 1) at an angle of its crank."""
    B = np.array([1 + math.cos(angle), math.sin(angle)])
    P = B * (2.5**2 - 1.0) / (B @ B)
    pivot = np.zeros(2)
    return {"B": B, "P": P, "C": meet(pivot, 2.5, B, 1.0, 1), "D": meet(pivot, 2.5, B, 1.0, -1)}


def stewart(legs: Array, base: Array, top: Array, guess: Array) -> Array:
    """Pose x, y, z and rotation vector at which base[i] and top[i] are legs[i] apart.

    `base` (6, 3) global, `top` (6, 3) in axes of the platform.
    """

    def gaps(pose: Array) -> Array:
        corners = pose[:3] + top @ rotation(pose[3:]).T
        return np.linalg.norm(corners - base, axis=1) - legs

    found = root(gaps, guess, tol=1e-14)
    assert np.abs(gaps(found.x)).max() < 1e-13
    return found.x


def differential(t: Array) -> Array:
    """Angles of cage, left and right axle (n, 3) of `scenes/differential.toml` from rest.

    In c (cage) and p = ratio times the planet's angle, left = c + p, right = c - p, so that
    M (c, p)'' + D (c, p)' = (torque, 0) with constant matrices.
    """
    ratio, torque, left, right = 0.6, 40.0, 0.5, 2.0
    M = np.diag([0.04 + 3e-4 + 2 * 0.02, 2 * 0.02 + 5e-4 / ratio**2])
    D = np.array([[left + right, left - right], [left - right, left + right]])
    y = _linear(np.linalg.solve(M, -D), np.linalg.solve(M, [torque, 0.0]))
    c, p = np.array([y(s) for s in t]).T
    return np.column_stack([c, c + p, c - p])


def _linear(A: Array, b: Array) -> Callable[[float], Array]:
    """Solution x(t) of x'' = A x' + b from rest, by the exponential of the augmented matrix."""
    n = len(b)
    system = np.zeros((2 * n + 1, 2 * n + 1))
    system[:n, n : 2 * n] = np.eye(n)
    system[n : 2 * n, n : 2 * n] = A
    system[n : 2 * n, -1] = b
    return lambda t: expm(system * t)[:n, -1]
