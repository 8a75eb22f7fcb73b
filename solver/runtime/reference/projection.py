"""Initial configurations that are sought: assembled from a drawn one, or in equilibrium.

Both are steps from rest, with gradients and forces at their end:

    (2/h) M d + h [ G(q_n1)' mu - Q(q_n1) ] = 0,    Phi(q_n1) = 0.

Without forces d is the stationary displacement d' M d that closes the mechanism. With forces, and h
growing from step to step, the end is where they balance.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..errors import Status
from .course import Course, Present
from .equations import rows_at
from .forces import step_force
from .mechanism import Mechanism
from .rows import END, Rows
from .start import constrained, row_rates, rows_of
from .state import Motion, add
from .unsolved import UnsolvedError

Array = NDArray[np.float64]

MAX_UPDATES = 60
"""Iterations of one step, which also update the multipliers."""

MAX_STEPS = 100
"""Steps towards equilibrium."""

AT_REST = 1e-10
"""Largest displacement of a step, over the extent, that tells equilibrium."""

LONG, LONGEST = 1e3, 1e6
"""Steps, over the step size: motion is slower than longer ones; none is longer than the last."""

FLOOR = 1e-13


class Seeking:
    """A step from rest towards a configuration; `solve` returns d of all moving nodes."""

    def __init__(self, mechanism: Mechanism, motion: Motion, h: float, *, forces: bool) -> None:
        self.mechanism, self.motion, self.h, self.forces = mechanism, motion, h, forces
        self.present = Present(mechanism, motion)
        self.phi_n = rows_at(mechanism, motion, self.present)
        # With forces G A^-1 G' grows with h^2 only until springs hold the mechanism.
        holding = min(h, motion.head["step_size"]) if forces else h
        self.compliance = holding**2 * mechanism.sigma / (2.0 * motion.head["penalty"])

    def _rows(self, d: Array) -> Rows:
        course = Course(self.present, d, self.present.signal, self.h)
        return Rows(self.mechanism, course, END)

    def defect(self, d: Array) -> float:
        """Largest |Phi| over the scale of the rows."""
        phi = self.phi_n + self._rows(d).change
        return float(np.max(np.abs(phi) / self.mechanism.row_scale, initial=0.0))

    def increments(self, d: Array, mu: Array) -> tuple[Array, Array]:
        """Newton increments of d and mu, with lam = mu."""
        mechanism, h, free = self.mechanism, self.h, self.mechanism.n_free
        rows = self._rows(d)
        Q, Q_d = np.zeros(mechanism.n), np.zeros_like(mechanism.M)
        if self.forces:
            Q, Q_d = step_force(mechanism, rows.view)
        phi = self.phi_n + rows.change
        R = 2.0 / h * mechanism.M @ d + h * (rows.G_bar.T @ mu - Q)
        A = 2.0 / h * mechanism.M + h * (rows.stiffness(mu) - Q_d)
        G, G_n1 = rows.G_bar[:, :free], rows.G_n1[:, :free]
        tangent = np.block([[A[:free, :free], h * G.T], [G_n1, -np.diag(self.compliance)]])
        try:
            x = np.linalg.solve(tangent, -np.concatenate([R[:free], phi]))
        except np.linalg.LinAlgError:
            raise UnsolvedError(Status.SINGULAR_TANGENT) from None
        return x[:free].astype(np.float64), x[free:].astype(np.float64)

    def solve(self, mu: Array) -> tuple[Array, Array, bool]:
        """Return d and mu, begun with `mu`, and whether rows hold and increments are round-off."""
        mechanism, tolerance = self.mechanism, self.motion.head["newton_tolerance"]
        d, last, done = np.zeros(mechanism.n), np.inf, False
        floor = FLOOR * float(mechanism.section["extent"][1])
        for _ in range(MAX_UPDATES):
            dd, dmu = self.increments(d, mu)
            size = mechanism.norm(dd)
            if not size < 1e150:
                raise UnsolvedError(Status.NOT_FINITE)
            longest = 0.3 * float(mechanism.section["extent"][1])
            part = longest / size if size > longest else 1.0
            d[: len(dd)] += part * dd
            mu = mu + part * dmu
            stalled = size > 0.5 * last and size <= 100.0 * floor
            done = self.defect(d) <= tolerance and (size <= floor or stalled)
            if done:
                break
            last = size
        return d, mu, done


def assemble_positions(mechanism: Mechanism, motion: Motion) -> None:
    """Move the drawn nodes, by their masses as little as is needed, to where the rows hold.

    Where they cannot hold their residuals tell so.
    """
    d, _, _ = Seeking(mechanism, motion, 1.0, forces=False).solve(np.zeros(mechanism.n_rows))
    add(motion.q, motion.q_low, d)


def assemble_velocities(
    mechanism: Mechanism, motion: Motion, signal_rates: Array, *, keep_given: bool = True
) -> None:
    """Change velocities as little as is needed to those the rows allow: M_w (v - v_0) + G' mu = 0.

    M_w is the mass matrix, heavier where the scene gives a velocity: those stay as they are given,
    unless the rows contradict them. What the weights give way is put back in the next round; in
    the last one the rows have their way.
    """
    free = slice(mechanism.n_free)
    v, nothing = motion.v[free], np.zeros(mechanism.n_free)
    weight = mechanism.section["velocity_weight"]
    given = np.repeat(weight, mechanism.dim)[free] > 1.0
    G = rows_of(mechanism, motion)[0][:, free]
    for weights in [*([weight] * 3 if keep_given else []), np.ones_like(weight)]:
        if weights is weight:
            v[given] = mechanism.section["initial_velocity"][free][given]
        a, b = mechanism.mass_node.T
        weighted = mechanism.section["mass"] * np.sqrt(weights[a] * weights[b])
        M = mechanism.mass_matrix(weighted)[free, free]
        rate = row_rates(mechanism, motion, signal_rates)
        heavy = np.repeat(weights, mechanism.dim)[free]
        v += constrained(mechanism, M, G, nothing, -rate, heavy)[0]


def find_equilibrium(mechanism: Mechanism, motion: Motion) -> None:
    """Move to where weight, loads, springs, potentials and rows balance; velocities become 0."""
    shortest, small = motion.head["step_size"], 0
    h, mu = shortest, np.zeros(mechanism.n_rows)
    motion.v[: mechanism.n_free] = 0.0
    for _ in range(MAX_STEPS):
        d, mu_n1 = _tried(Seeking(mechanism, motion, h, forces=True), mu)
        if d is None:
            h *= 0.25
            continue
        add(motion.q, motion.q_low, d)
        mu = mu_n1
        still = mechanism.norm(d) <= AT_REST * mechanism.section["extent"][1]
        small = small + 1 if still and h > LONG * shortest else 0
        if small == 2:
            return
        h *= 4.0 if h < LONGEST * shortest else 1.0
    raise UnsolvedError(Status.NEWTON_DIVERGED)


def _tried(step: Seeking, mu: Array) -> tuple[Array | None, Array]:
    """Return d and mu of a step; None where it has no solution, or is not found."""
    try:
        d, mu_n1, done = step.solve(mu)
    except UnsolvedError:
        return None, mu
    return (d, mu_n1) if done else (None, mu)
