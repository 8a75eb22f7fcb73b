"""Gradients of functions over a step from q_n to q_n1 (eqs 5, 8, 11 and 25), shape (r, n)."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from .problem import Array, Functions, Mask

ROUND_OFF = 1e-15  # what eq 8 may miss at the midpoint, relative to the terms of the function
CLOSE = 1e-5  # change of a square below which a mean of slopes is nearer than their quotient


def midpoint(f: Functions, q_n: Array, q_n1: Array) -> Array:
    """Gradients at the midpoint (eqs 5 and 7)."""
    return f.gradient(0.5 * (q_n + q_n1))


def intermediate(f: Functions, q_n: Array, q_n1: Array, where: Mask | bool = True) -> Array:
    """Gradients at q_n + beta d, so that Phi_q d = Phi_n1 - Phi_n (eq 8), with d = q_n1 - q_n.

    Each function has its own beta, that next to 1/2; no one beta serves several. It is 1/2 itself
    where a function is quadratic, or not `where`.
    """
    G, d, change = midpoint(f, q_n, q_n1).copy(), q_n1 - q_n, f.value(q_n1) - f.value(q_n)
    terms = np.abs(G) @ (np.abs(q_n) + np.abs(q_n1))
    for row in map(int, np.flatnonzero(where & (np.abs(G @ d - change) > ROUND_OFF * terms))):

        def missed(beta: float, row: int = row) -> float:
            return float(f.gradient(q_n + beta * d)[row] @ d - change[row])

        G[row] = f.gradient(q_n + root_next_to_half(missed) * d)[row]
    return G


def root_next_to_half(f: Callable[[float], float]) -> float:
    """Root in [0, 1] by regula falsi (Illinois); 1/2 where rounding hides the change of sign."""
    for inner in np.arange(16) / 32.0:
        for side in (1.0, -1.0):
            a, b = 0.5 + side * inner, 0.5 + side * (inner + 1.0 / 32.0)
            f_a, f_b = f(a), f(b)
            if f_a * f_b > 0.0:
                continue
            while abs(b - a) > 1e-15 and f_b != 0.0 and f_a != f_b:
                c = b - f_b * (b - a) / (f_b - f_a)
                f_c, done = f(c), abs(c - b) <= 1e-15
                a, f_a = (a, 0.5 * f_a) if f_b * f_c > 0.0 else (b, f_b)
                b, f_b = c, 0.0 if done else f_c
            return b
    return 0.5


def quotients(f: Functions, s: Functions, q_n: Array, q_n1: Array) -> tuple[Array, Array, Mask]:
    """Slopes (Phi_n1 - Phi_n)/(s_n1 - s_n), these changes of s, and where slopes are means."""
    s_n, s_n1 = s.value(q_n), s.value(q_n1)
    close = np.abs(s_n1 - s_n) <= CLOSE * np.maximum(np.abs(s_n), np.abs(s_n1))
    pairs = [(f.gradient(q), s.gradient(q)) for q in (q_n, q_n1)]
    slope = np.mean([np.sum(G * s_q, axis=1) / np.sum(s_q**2, axis=1) for G, s_q in pairs], axis=0)
    change = np.where(close, 1.0, s_n1 - s_n)
    return np.where(close, slope, (f.value(q_n1) - f.value(q_n)) / change), change, close


def scalar(f: Functions, q_n: Array, q_n1: Array) -> Array:
    """Gradients (Phi_n1 - Phi_n)/(s_n1 - s_n) s_q, s_q in the middle (eqs 11, 25); else of eq 8."""
    if f.square is None:
        return intermediate(f, q_n, q_n1)
    slope = quotients(f, f.square, q_n, q_n1)[0]
    lacks = np.isnan(slope)
    G = slope[:, None] * midpoint(f.square, q_n, q_n1)
    return np.where(lacks[:, None], intermediate(f, q_n, q_n1, lacks), G) if any(lacks) else G


GRADIENTS = {  # of each formulation
    "conserving-al": scalar, "conserving-al-beta": intermediate, "conserving-penalty": scalar,
    "midpoint-al": midpoint, "midpoint-penalty": midpoint, "penalty-velocity": midpoint,
}  # fmt: skip


def hessian(f: Functions, q: Array) -> Array:
    """Second derivatives (r, n, n), by differences of the gradients where there are no others."""
    if f.hessian is not None:
        return f.hessian(q)
    steps = 1e-5 * (np.ptp(q) or 1.0) * np.eye(len(q))
    columns = [(f.gradient(q + e) - f.gradient(q - e)) / (2.0 * e.max()) for e in steps]
    return np.moveaxis(np.reshape(columns, (len(q), -1, len(q))), 0, 2)


def bend(gradient: Callable, f: Functions, q_n: Array, q_n1: Array, weights: Array) -> Array:
    """Derivative (n, n) of the weighted gradients in q_n1; of eq 8 that at beta = 1/2."""
    middle = 0.5 * (q_n + q_n1)
    if gradient is not scalar or f.square is None:
        return 0.5 * np.tensordot(weights, hessian(f, middle), 1)
    slope, change, close = quotients(f, f.square, q_n, q_n1)
    i = np.flatnonzero(~close & ~np.isnan(slope))
    K = 0.5 * np.tensordot(weights * ~np.isin(np.arange(len(slope)), i), hessian(f, middle), 1)
    K += 0.5 * np.tensordot((weights * slope)[i], hessian(f.square, middle)[i], 1)
    turns = f.gradient(q_n1)[i] - slope[i, None] * f.square.gradient(q_n1)[i]
    return K + f.square.gradient(middle)[i].T @ ((weights / change)[i, None] * turns)
