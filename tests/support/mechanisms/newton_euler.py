"""Newton's and Euler's equations of jointed bodies, index 1, by DOP853 at 1e-12.

An oracle in space. Unknowns are places, quaternions and velocities of the bodies, where the solver
has directors; rows are differentiated twice, J nu' = gamma, and multipliers found by least squares,
so that redundant rows do no harm. A body's origin is its centre of mass; body -1 is the ground.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from tests.support.mechanisms.reduced_models import (
    Array,
    integrate,
    matrix_of,
    quaternion_of,
    quaternion_rates,
)

GROUND = -1


def skew(v: Array) -> Array:
    """Matrix of v x."""
    return np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])


@dataclass(frozen=True)
class Meet:
    """Two bodies share a point: places in body axes, from the centres of mass."""

    a: int
    at_a: Array
    b: int
    at_b: Array

    def rows(self, R: Array, w: Array) -> tuple[list[tuple[int, Array, Array]], Array]:
        """Parts (body, J_v, J_w) of the rows x_a - x_b = 0, and gamma."""
        s, r = R[self.a] @ self.at_a, R[self.b] @ self.at_b
        one = np.eye(3)
        parts = [(self.a, one, -skew(s)), (self.b, -one, skew(r))]
        at_a, at_b = w[self.a], w[self.b]
        return parts, np.cross(at_b, np.cross(at_b, r)) - np.cross(at_a, np.cross(at_a, s))


@dataclass(frozen=True)
class Perpendicular:
    """A direction of one body stays at its angle to a direction of another, as u . v = const."""

    a: int
    u: Array
    b: int
    v: Array

    def rows(self, R: Array, w: Array) -> tuple[list[tuple[int, Array, Array]], Array]:
        """Parts of the row u . v, d/dt = (u x v) . (w_a - w_b), and gamma."""
        u, v = R[self.a] @ self.u, R[self.b] @ self.v
        at_a, at_b = w[self.a], w[self.b]
        lever, none = np.cross(u, v)[None], np.zeros((1, 3))
        du, dv = np.cross(at_a, u), np.cross(at_b, v)
        bent = v @ np.cross(at_a, du) + u @ np.cross(at_b, dv) + 2 * du @ dv
        return [(self.a, none, lever), (self.b, none, -lever)], np.array([-bent])


Row = Meet | Perpendicular


@dataclass(frozen=True)
class Mechanism:
    """Bodies and rows: masses (n,) [kg], inertias (n, 3) [kg.m2] principal, gravity (3,) [m/s2]."""

    masses: Array
    inertias: Array
    places: Array
    """(n, 3), as drawn, axes along the global ones."""
    rows: Sequence[Row]
    gravity: Array

    def accelerations(self, R: Array, w: Array) -> Array:
        """Accelerations (n, 6): of the centre, and of the angular velocity in global axes."""
        n = len(self.masses)
        inverse, load = np.zeros((n + 1, 6, 6)), np.zeros((n + 1, 6))
        for i in range(n):
            J = R[i] @ np.diag(self.inertias[i]) @ R[i].T
            inverse[i, :3, :3] = np.eye(3) / self.masses[i]
            inverse[i, 3:, 3:] = np.linalg.inv(J)
            load[i, :3] = self.masses[i] * self.gravity
            load[i, 3:] = np.cross(J @ w[i], w[i])
        blocks, gammas = [], []
        for row in self.rows:
            parts, gamma = row.rows(R, w)
            block = np.zeros((len(gamma), n + 1, 6))
            for body, of_v, of_w in parts:
                block[:, body] += np.hstack([of_v, of_w])
            blocks.append(block)
            gammas.append(gamma)
        J = np.concatenate(blocks)
        lighter = np.einsum("rbi,bij->rbj", J, inverse)
        W = np.einsum("rbi,sbi->rs", lighter, J)
        right = np.einsum("rbi,bi->r", lighter, load) - np.concatenate(gammas)
        force = np.linalg.lstsq(W, right, rcond=1e-10)[0]
        return np.einsum("bij,bj->bi", inverse, load - np.einsum("rbi,r->bi", J, force))[:n]

    def motion(self, times: Array) -> tuple[Array, Array]:
        """Places (len(times), n, 3) and attitudes (len(times), n, 3, 3) from rest."""
        n = len(self.masses)

        def rates(y: Array) -> Array:
            q, v, w = y[3 * n : 7 * n].reshape(n, 4), y[7 * n : 10 * n], y[10 * n :].reshape(n, 3)
            R = np.array([*(matrix_of(one) for one in q), np.eye(3)])
            turning = [quaternion_rates(q[i], R[i].T @ w[i]) for i in range(n)]
            slope = self.accelerations(R, np.vstack([w, np.zeros(3)]))
            return np.concatenate([v, *turning, slope[:, :3].ravel(), slope[:, 3:].ravel()])

        upright = np.tile(quaternion_of(np.eye(3)), n)
        y = integrate(rates, np.concatenate([self.places.ravel(), upright, np.zeros(6 * n)]), times)
        q = y[:, 3 * n : 7 * n].reshape(-1, n, 4)
        R = np.array([[matrix_of(one) for one in moment] for moment in q])
        return y[:, : 3 * n].reshape(-1, n, 3), R


def hinge(a: int, place_a: Array, b: int, place_b: Array, at: Array, axis: Array) -> list[Row]:
    """Rows of a revolute joint drawn at `at`; `place_...` are the drawn centres of mass."""
    across = np.eye(3)[[i for i in range(3) if axis[i] == 0]]
    square = [Perpendicular(a, axis, b, direction) for direction in across]
    return [Meet(a, at - place_a, b, at - place_b), *square]


def bricard() -> Mechanism:
    """Bricard's mechanism of `scenes/bricard.toml`: rods 1 x 0.1 x 0.1 m of 1 kg."""
    corners = np.array([[0, 0, 0], [1, 0, 0], [1, -1, 0], [1, -1, 1], [0, -1, 1], [0, 0, 1.0]])
    places = (corners[:-1] + corners[1:]) / 2
    along = np.abs(np.diff(corners, axis=0)).argmax(axis=1)
    inertias = np.full((5, 3), 1.01 / 12)
    inertias[np.arange(5), along] = 0.02 / 12
    axes = np.eye(3)[[1, 2, 0, 1, 2, 0]]
    drawn = np.vstack([places, np.zeros(3)])  # the ground at place -1
    pairs = [(GROUND, 0), (0, 1), (1, 2), (2, 3), (3, 4), (4, GROUND)]
    rows = [
        row
        for (a, b), at, axis in zip(pairs, corners, axes, strict=True)
        for row in hinge(a, drawn[a], b, drawn[b], at, axis)
    ]
    return Mechanism(np.ones(5), inertias, places, rows, np.array([0.0, -9.81, 0.0]))
