"""Start of a run: scaling of the penalties, and the first multipliers and accelerations."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from .forces import step_force
from .mechanism import Mechanism
from .state import Motion

Array = NDArray[np.float64]

RANK = 1e-10
"""Singular values of the scaled G M^-1 G' below this belong to dependent rows."""


def derive_scales(mechanism: Mechanism, motion: Motion) -> None:
    """Write sigma_i = (G m^-1 G')_ii and the extent of the mechanism into their sections."""
    G = mechanism.G(motion.q, motion.q_low)
    mechanism.sigma[:] = np.sum(G**2 / mechanism.m_node, axis=1)
    nodes = np.concatenate([motion.q, mechanism.section["support"]]).reshape(-1, mechanism.dim)
    extent = float(np.linalg.norm(nodes.max(axis=0) - nodes.min(axis=0)))
    mass = float(np.sum(mechanism.section["node_mass"]))
    mechanism.section["extent"][:] = extent, np.sqrt(mass) * extent


def forces_at_rest(mechanism: Mechanism, motion: Motion) -> Array:
    """Forces Q(q, v) at the present state: those of a step of no length, and the dampers'."""
    lines = [*mechanism.lines, *mechanism.moment_links]
    links = {form: form.links(motion.q, motion.q_low)[0] for form in lines}
    Q, _ = step_force(mechanism, links, np.zeros(mechanism.n), 1.0)
    for form, damping in zip(mechanism.lines, mechanism.damping, strict=True):
        if damping != 0.0:
            u = links[form]
            Q -= form.U.T @ (damping * (u @ (form.U @ motion.v)) / (u @ u) * u)
    return Q


def first_multipliers(mechanism: Mechanism, motion: Motion) -> tuple[Array, Array]:
    """Multipliers and accelerations from M a + G' lam = Q, G a = -v' H v.

    Of dependent rows, the multipliers of least size, scaled with their compliance, are taken.
    """
    M, G = mechanism.M, mechanism.G(motion.q, motion.q_low)
    Q = forces_at_rest(mechanism, motion)
    scale = 1.0 / np.sqrt(mechanism.sigma)
    S = scale[:, None] * (G @ np.linalg.solve(M, G.T)) * scale
    b = scale * (G @ np.linalg.solve(M, Q) + mechanism.quadratic(motion.v))
    lam = scale * np.linalg.lstsq(S, b, rcond=RANK)[0]
    return lam, np.linalg.solve(M, Q - G.T @ lam).astype(np.float64)
