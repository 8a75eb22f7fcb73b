"""Forces besides the constraints, each in the discrete form whose work over a step is exact.

For a step d = q_n1 - q_n every function returns Q (n,) and, where it depends on d, its tangent
dQ/dd (n, n). A tension N along a link is taken along e = (u_n + u_n1)/(l_n + l_n1), because then

    N e . du = N (l_n1^2 - l_n^2)/(l_n + l_n1) = N dl

(paper, eq 11 for a potential V(l); Gonzalez 1996).
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from ..errors import Status
from .mechanism import Form, Mechanism

Array = NDArray[np.float64]


class UnsolvedError(Exception):
    """A step or the assembly cannot be solved, for the reason `status`."""

    def __init__(self, status: Status) -> None:
        super().__init__(status.name)
        self.status = status


def length(u: Array) -> float:
    """Euclidean length of a link."""
    return float(np.sqrt(u @ u))


def constant_force(mechanism: Mechanism) -> Array:
    """Weight and loads, Q = sum m g + F."""
    Q = mechanism.m_node * np.tile(mechanism.gravity, mechanism.n_free)
    dim = mechanism.dim
    for node, load in zip(mechanism.load_nodes, mechanism.load, strict=True):
        Q[dim * node : dim * (node + 1)] += load
    return Q


def elongation(u_n: Array, du: Array) -> float:
    """Elongation l_n1 - l_n = (u_n + u_n1) . du/(l_n + l_n1), without cancellation."""
    return float((2.0 * u_n + du) @ du) / (length(u_n) + length(u_n + du))


def tension(
    u_n: Array, du: Array, h: float, stiffness: float, free_length: float, damping: float
) -> tuple[Array, Array]:
    """Force N e [N] in a link from spring and damper, and its derivative in du = u_n1 - u_n.

    N = k [(l_n + l_n1)/2 - l_free] + c (l_n1 - l_n)/h: the mean slope of V = k (l - l_free)^2/2, so
    that the work is exactly -dV - c (l_n1 - l_n)^2/h.
    """
    if not (stiffness >= 0.0 and free_length >= 0.0 and damping >= 0.0):
        raise UnsolvedError(Status.BAD_LAW)
    identity, u_n1, u_sum = np.eye(len(u_n)), u_n + du, 2.0 * u_n + du
    if free_length == 0.0 and damping == 0.0:  # V = k u.u/2: no direction is needed
        return 0.5 * stiffness * u_sum, 0.5 * stiffness * identity
    l_n, l_n1 = length(u_n), length(u_n1)
    if not (l_n > 0.0 and l_n1 > 0.0):
        raise UnsolvedError(Status.ZERO_LENGTH)
    l_sum, e_n1 = l_n + l_n1, u_n1 / l_n1
    N = stiffness * (0.5 * l_sum - free_length) + damping * elongation(u_n, du) / h
    dN = (0.5 * stiffness + damping / h) * e_n1
    e, de = u_sum / l_sum, identity / l_sum - np.outer(u_sum, e_n1) / l_sum**2
    return N * e, np.outer(e, dN) + N * de


def in_space(x: Array) -> Array:
    """Vector of the plane as a vector of space."""
    return np.append(x, np.zeros(3 - len(x)))


def couple(moment: Array, u_n: Array, du: Array) -> tuple[Array, Array]:
    """Force f [N] of a moment m on a link, and its derivative in du = u_n1 - u_n.

    f = g m x u_mid with g = beta/|u_n x u_n1|, beta the angle from u_n to u_n1. In the plane the
    work f . du = g m . (u_n x u_n1) is exactly m beta.
    """
    dim = len(u_n)
    m = in_space(moment) if dim == 3 else np.array([0.0, 0.0, moment[0]])
    u_n, u_n1 = in_space(u_n), in_space(u_n + du)
    size2 = length(u_n) * length(u_n1)
    if not size2 > 0.0:
        raise UnsolvedError(Status.ZERO_LENGTH)
    cross: Array = np.cross(u_n, u_n1).astype(np.float64)
    beta = float(np.arctan2(length(cross), u_n @ u_n1))
    g = 1.0 / (size2 * np.sinc(beta / np.pi))
    # dg/du_n1 from g = (beta/sin beta)/(|u_n| |u_n1|); the quotient below tends to 1/3.
    quotient = (
        (np.sin(beta) - beta * np.cos(beta)) / np.sin(beta) ** 3 if beta > 1e-3 else 1.0 / 3.0
    )
    dg = -g * u_n1 + quotient * np.cross(cross, u_n1) / size2**2
    dg /= u_n1 @ u_n1
    arm: Array = np.cross(m, 0.5 * (u_n + u_n1)).astype(np.float64)
    skew = np.cross(m, np.eye(3)).T
    tangent = np.outer(arm, dg) + 0.5 * g * skew
    return (g * arm)[:dim], tangent[:dim, :dim]


def step_force(
    mechanism: Mechanism, links: Mapping[Form, Array], d: Array, h: float
) -> tuple[Array, Array]:
    """Q (n,) of all forces over a step by d from links u_n, given by form, and dQ/dd (n, n)."""
    Q, Q_d = constant_force(mechanism), np.zeros((mechanism.n, mechanism.n))
    laws = zip(mechanism.stiffness, mechanism.free_length, mechanism.damping, strict=True)
    for form, law in zip(mechanism.lines, laws, strict=True):
        u_n = links[form]
        f, f_u = tension(u_n, form.U @ d, h, *law)
        Q -= form.U.T @ f
        Q_d -= form.U.T @ f_u @ form.U
    for form, moment in zip(mechanism.moment_links, mechanism.moment, strict=True):
        u_n = links[form]
        f, f_u = couple(moment, u_n, form.U @ d)
        Q += form.U.T @ f
        Q_d += form.U.T @ f_u @ form.U
    return Q, Q_d
