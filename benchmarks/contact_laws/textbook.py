"""Newton's and Poisson's laws of impact with Coulomb's friction, and stiff springs.

Newton (Moreau 1988): 0 <= p_N _|_ gamma_N+ + e gamma_N- >= 0, |p_T| <= mu p_N against the slip at
the end. Poisson (Glocker and Pfeiffer 1995): a compression like that with e = 0, then an expansion
with p_N,E >= e p_N,C and a cone of its own. Springs are what an elastic impact is made of.
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


def springs(impact: Impact, mu: float, steps: int = 4000) -> Array:
    """Velocities after an elastic impact: a linear spring and Coulomb's friction at each contact.

    Bodies do not move meanwhile but for the depths of the springs; all have one stiffness. `steps`
    are those of the shortest contact, of first order.
    """
    size, v = 1 + impact.tangents, impact.before.copy()
    count = len(impact.G) // size
    rows = impact.G.reshape(count, size, -1)
    change = np.linalg.solve(impact.M, impact.G.T).T.reshape(rows.shape)
    masses = 1.0 / np.einsum("ijk,ijk->ij", rows, change)
    normals = impact.G[impact.normals]
    fastest = float(np.linalg.eigvalsh(impact.delassus[impact.normals, impact.normals])[-1])
    h, gaps = np.pi / steps, np.zeros(count)
    for _ in range(count * 50 * steps):
        gaps += h * (normals @ v)
        push = np.maximum(0.0, -gaps) / fastest
        if not push.any():
            return v
        for i in np.flatnonzero(push):
            v += h * push[i] * change[i, 0]
            slip = rows[i, 1:] @ v
            size_of_slip = float(np.linalg.norm(slip))
            if size_of_slip:
                stops = masses[i, 1:].min() * size_of_slip
                v -= min(mu * h * push[i], stops) * (slip / size_of_slip) @ change[i, 1:]
    message = "springs did not part"
    raise RefusedError(message)


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
