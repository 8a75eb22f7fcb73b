"""Newton's and Poisson's laws of impact with Coulomb's friction, as textbooks have them.

Newton (Moreau 1988): 0 <= p_N _|_ gamma_N+ + e gamma_N- >= 0, |p_T| <= mu p_N against the slip at
the end. Poisson (Glocker and Pfeiffer 1995): a compression like that with e = 0, then an expansion
with p_N,E >= e p_N,C and a cone of its own.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from benchmarks.contact_laws.experiments import Impact
from benchmarks.contact_laws.method import Method, RefusedError
from benchmarks.problems_parts import Array

SWEEPS = 20_000
ROUND_OFF = 1e-15


def impulses(W: Array, b: Array, tangents: int, mu: float, least: Array | None = None) -> Array:
    """Impulses p (rows,) of contacts with 1 + `tangents` rows each, by projected Gauss-Seidel.

    p_N >= least and gamma_N = (b + W p)_N >= 0, one of them as an equation; p_T is in its cone
    against the slip.

    Raises
    ------
    RefusedError
        If the sweeps do not converge.
    """
    p, size = np.zeros(len(b)), 1 + tangents
    floor = np.zeros(len(b) // size) if least is None else least
    for _ in range(SWEEPS):
        before = p.copy()
        for i, n in enumerate(range(0, len(b), size)):
            p[n] = max(floor[i], p[n] - (b[n] + W[n] @ p) / W[n, n])
            if tangents:
                t = slice(n + 1, n + size)
                stiffest = np.linalg.norm(W[t, t], 2)
                x = p[t] - (b[t] + W[t] @ p) / stiffest
                cone = mu * p[n]
                p[t] = x * min(1.0, cone / max(float(np.linalg.norm(x)), 1e-300))
        if np.max(np.abs(p - before)) <= ROUND_OFF * np.max(np.abs(p)):
            return p
    message = "its complementarity problem was not solved"
    raise RefusedError(message)


Law = Callable[[Array, Array, int, float, float], Array]


def newton(W: Array, b: Array, tangents: int, mu: float, e: float) -> Array:
    """Impulses (rows,) of Newton's law for rates b before the impact."""
    shifted, normals = b.copy(), slice(None, None, 1 + tangents)
    shifted[normals] += e * np.minimum(b[normals], 0.0)
    return impulses(W, shifted, tangents, mu)


def poisson(W: Array, b: Array, tangents: int, mu: float, e: float) -> Array:
    """Impulses (rows,) of Poisson's law for rates b before the impact."""
    compression = impulses(W, b, tangents, mu)
    least = e * compression[:: 1 + tangents]
    return compression + impulses(W, b + W @ compression, tangents, mu, least)


def _after(law: Law, impact: Impact, mu: float, e: float) -> Array:
    size = 1 + impact.tangents
    rows = np.concatenate([np.arange(i * size, (i + 1) * size) for i in impact.order])
    G = impact.G[rows]
    p = law(impact.delassus[np.ix_(rows, rows)], G @ impact.before, impact.tangents, mu, e)
    return impact.before + np.linalg.solve(impact.M, G.T @ p)


METHODS = (
    Method(
        name="Newton's law",
        settings="friction against the slip at the end",
        impact=lambda *case: _after(newton, *case),
        rest=None,
    ),
    Method(
        name="Poisson's law",
        settings="compression, then expansion",
        impact=lambda *case: _after(poisson, *case),
        rest=None,
    ),
)
