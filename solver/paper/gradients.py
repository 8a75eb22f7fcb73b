"""Gradients of functions over a step from q_n to q_n1 (eqs 5, 8, 11 and 25), shape (r, n)."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from .problem import Array, Functions

ROUND_OFF = 1e-15
"""Error of eq 8 at the midpoint, relative to the terms of the function, that rounding explains."""
PLACES = np.arange(1, 17) / 32.0
"""Distances from 1/2 where a change of sign is looked for."""
CLOSE = 1e-5
"""Relative change of a square below which the mean of both derivatives is nearer than a quotient."""


def midpoint(f: Functions, q_n: Array, q_n1: Array) -> Array:
    """Gradients at the midpoint (eqs 5 and 7)."""
    return f.gradient(0.5 * (q_n + q_n1))


def intermediate(f: Functions, q_n: Array, q_n1: Array) -> Array:
    """Gradients at q_n + beta d with Phi_q d = Phi_n1 - Phi_n: each function has its own beta.

    One beta for all, as eq 8 may be read, does not exist in general; for one function the mean
    value theorem gives it. Of several the one next to 1/2 is taken; quadratic functions have 1/2.
    """
    G, d, change = midpoint(f, q_n, q_n1), q_n1 - q_n, f.value(q_n1) - f.value(q_n)
    size = np.abs(G) @ (np.abs(q_n) + np.abs(q_n1))
    for row in np.flatnonzero(np.abs(G @ d - change) > ROUND_OFF * size):

        def missed(beta: float, row: int = row) -> float:
            return float(f.gradient(q_n + beta * d)[row] @ d - change[row])

        G[row] = f.gradient(q_n + next_to_half(missed) * d)[row]
    return G


def next_to_half(f: Callable[[float], float]) -> float:
    """Root of f in [0, 1] next to 1/2; 1/2 where rounding hides its change of sign."""
    inner = {1.0: (0.5, f(0.5))}
    inner[-1.0] = inner[1.0]
    for place in PLACES:
        for side, (a, f_a) in inner.items():
            b = 0.5 + side * place
            f_b = f(b)
            if f_a * f_b <= 0.0:
                return bracketed_root(f, a, f_a, b, f_b)
            inner[side] = b, f_b
    return 0.5


def bracketed_root(f: Callable[[float], float], a: float, f_a: float, b: float, f_b: float) -> float:
    """Root between a and b, by regula falsi (Illinois)."""
    for _ in range(100):
        c = b - f_b * (b - a) / (f_b - f_a) if f_b != f_a else b
        if f_b == 0.0 or abs(c - b) <= 1e-16:
            return c
        f_c = f(c)
        a, f_a = (b, f_b) if f_b * f_c < 0.0 else (a, 0.5 * f_a)
        b, f_b = c, f_c
    return b


def scalar(f: Functions, q_n: Array, q_n1: Array) -> Array:
    """Gradients of functions of a scalar (eqs 11 and 25), of others those of eq 8.

    With the scalar's square s: (Phi_n1 - Phi_n)/(s_n1 - s_n) grad s at the midpoint.
    """
    if f.square is None or f.square_gradient is None:
        return intermediate(f, q_n, q_n1)
    s_n, s_n1 = f.square(q_n), f.square(q_n1)
    close = np.abs(s_n1 - s_n) <= CLOSE * np.maximum(np.abs(s_n), np.abs(s_n1))
    ends = [(f.gradient(q), f.square_gradient(q)) for q in (q_n, q_n1)]
    with np.errstate(all="ignore"):
        derivative = 0.5 * sum(np.sum(G * g, axis=1) / np.sum(g * g, axis=1) for G, g in ends)
        quotient = (f.value(q_n1) - f.value(q_n)) / (s_n1 - s_n)
    slope = np.where(close, derivative, quotient)
    return slope[:, None] * f.square_gradient(0.5 * (q_n + q_n1))


GRADIENTS = {
    "conserving-al": scalar,
    "conserving-al-beta": intermediate,
    "conserving-penalty": scalar,
    "midpoint-al": midpoint,
    "midpoint-penalty": midpoint,
    "penalty-velocity": midpoint,
}
"""Gradient of each formulation."""
