"""Newton's and Poisson's laws of impact with Coulomb's friction, and stiff springs.

Newton (Moreau 1988): 0 <= p_N _|_ gamma_N+ + e gamma_N- >= 0, |p_T| <= mu p_N against the slip at
the end. Poisson (Glocker and Pfeiffer 1995): a compression like that with e = 0, then an expansion
with p_N,E >= e p_N,C and a cone of its own. Springs are what an elastic impact is made of.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import product

import numpy as np

from benchmarks.contact_laws.experiments import Impact
from benchmarks.contact_laws.method import Method, RefusedError
from benchmarks.problems.parts import Array

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
    if len(b) == 2 and tangents == 1:
        return _one_in_the_plane(W, b, mu, float(floor[0]))
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


def _one_in_the_plane(W: Array, b: Array, mu: float, least: float) -> Array:
    """Those of one contact, of all its modes the first that fits: strong friction has several."""
    size = np.abs(b).max() + np.abs(W).max() * least
    for closed, slides in product((True, False), (0.0, 1.0, -1.0)):
        A, right = np.eye(2), np.array([least, 0.0])
        if closed:
            A[0], right[0] = W[0], -b[0]
        if slides:
            A[1] = slides * mu, 1.0
        else:
            A[1], right[1] = W[1], -b[1]
        if abs(np.linalg.det(A)) < 1e-12 * np.abs(A).max():
            continue
        p = np.asarray(np.linalg.solve(A, right), np.float64)
        rates = b + W @ p
        fits = p[0] >= least * (1.0 - ROUND_OFF) and rates[0] >= -1e-12 * size
        held = abs(p[1]) <= mu * p[0] * (1.0 + 1e-12)
        if fits and (slides * rates[1] >= 0.0 if slides else held):
            return p
    message = "it has no solution"
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

    Raises
    ------
    RefusedError
        If a contact lasts fifty times as long.
    """
    size, v = 1 + impact.tangents, impact.before.copy()
    count = len(impact.G) // size
    rows = impact.G.reshape(count, size, -1)
    change = np.linalg.solve(impact.M, impact.G.T).T.reshape(rows.shape)
    held = [-np.linalg.inv(a[1:] @ b[1:].T) for a, b in zip(rows, change, strict=True)]
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
            most, p = mu * h * push[i], held[i] @ slip
            if np.linalg.norm(p) > most:
                p = -most * slip / np.linalg.norm(slip)
            v += p @ change[i, 1:]
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
