"""Experiments on laws of contact: impacts of one instant, and a box that friction holds or not.

An impact is gamma+ = gamma- + W p with gamma = G v and W = G M^-1 G'. Every code gives the
velocities v+ after it; the impulses are then those of M (v+ - v-) = G' p, whatever the code tells.
NumPy alone is needed: the same file is read in the interpreters of other codes.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import product

import numpy as np

from benchmarks.problems.parts import Array

GRAVITY = 9.81


@dataclass(frozen=True, slots=True, kw_only=True)
class Impact:
    """Bodies that touch at an instant, with velocities v (n,) and c contacts."""

    key: str
    title: str
    M: Array
    """Mass matrix (n, n) [kg, kg.m, kg.m^2]."""
    G: Array
    """Rows (c (1 + tangents), n): of each contact its normal, then its tangents."""
    before: Array
    """Velocities (n,) [m/s, rad/s]."""
    tangents: int
    order: tuple[int, ...]
    """Numbers of the contacts in the order in which a code is told of them."""
    frictions: tuple[float, ...] = (0.0,)
    restitutions: tuple[float, ...] = (0.0, 0.5, 1.0)
    turned: tuple[int, ...] | None = None
    """Another order, whose results are to be the same."""

    @property
    def delassus(self) -> Array:
        """W = G M^-1 G', what unit impulses change of the rates of all rows [1/kg]."""
        return self.G @ np.linalg.solve(self.M, self.G.T)

    @property
    def normals(self) -> slice:
        """Rows of the normals."""
        return slice(None, None, 1 + self.tangents)

    @property
    def speed(self) -> float:
        """Of the fastest approach [m/s]."""
        return float(np.max(-(self.G @ self.before)[self.normals]))

    def energy(self, v: Array) -> float:
        """Kinetic energy [J]."""
        return 0.5 * float(v @ self.M @ v)

    def impulse(self, after: Array) -> Array:
        """Impulses (c, 1 + tangents) [N.s]: of dependent rows the least that change v as it did."""
        change = self.M @ (np.asarray(after) - self.before)
        p = np.linalg.lstsq(self.G.T, change, rcond=1e-10)[0]
        return p.reshape(-1, 1 + self.tangents)


# ----------------------------------------------------------------------------------- the bodies

ROD_ANGLE = 0.5
"""Of the rod of 1 m and 1 kg with the ground [rad]; its lower end is the left one."""
ROD_SPEED = math.sqrt(2.0 * GRAVITY * 0.5 * (1.0 - math.sin(ROD_ANGLE)))
"""After its fall, upright place of its centre 0.5 m [m/s]."""
BOX = (0.4, 0.3, 0.2)
"""Sides of the box of 1 kg [m]."""
BOX_TURN = (0.5, 0.3, 0.2)
"""Its turning vector where it lands on a corner [rad]."""
BOX_SPEED = (1.0, 0.3, -2.0)
KANE_ANGLES = (math.radians(20.0), math.radians(30.0))
"""Of both rods, of 1 m and 1 kg, from the vertical [rad]."""
KANE_RATES = (-0.1, -0.2)


def box_inertia() -> Array:
    """Moments of inertia about the axes of the box [kg.m^2]."""
    a = np.square(BOX)
    return (a.sum() - a) / 12.0


def turned_by(vector: Sequence[float]) -> Array:
    """Rotation matrix of a turning vector [rad] (Rodrigues)."""
    w = np.asarray(vector, float)
    angle = float(np.linalg.norm(w))
    if not angle:
        return np.eye(3)
    x, y, z = w / angle
    K = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    return np.eye(3) + math.sin(angle) * K + (1.0 - math.cos(angle)) * K @ K


def box_corners(Q: Array) -> Array:
    """Places (8, 3) of the corners from the centre, the lowest first [m]."""
    corners = np.array([Q @ (0.5 * np.array(s) * BOX) for s in product((-1, 1), repeat=3)])
    return corners[np.argsort(corners[:, 2], kind="stable")]


def _rod() -> Impact:
    x, y = -0.5 * math.cos(ROD_ANGLE), -0.5 * math.sin(ROD_ANGLE)
    return Impact(
        key="rod",
        title="rod, slip reverses",
        M=np.diag([1.0, 1.0, 1.0 / 12.0]),
        G=np.array([[0.0, 1.0, x], [1.0, 0.0, -y]]),
        before=np.array([1.0, -ROD_SPEED, 0.0]),
        tangents=1,
        order=(0,),
        frictions=(0.0, 1e-9, 0.1, 0.5),
    )


def _box(key: str, title: str, vector: Sequence[float], count: int) -> Impact:
    Q = turned_by(vector)
    M = np.zeros((6, 6))
    M[:3, :3], M[3:, 3:] = np.eye(3), Q @ np.diag(box_inertia()) @ Q.T
    axes = np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
    rows = [[*axis, *np.cross(c, axis)] for c in box_corners(Q)[:count] for axis in axes]
    return Impact(
        key=key,
        title=title,
        M=M,
        G=np.array(rows),
        before=np.array([*BOX_SPEED, 0.0, 0.0, 0.0]),
        tangents=2,
        order=tuple(range(count)),
        frictions=(0.0, 0.01, 0.3) if count == 1 else (0.0, 0.3),
        turned=(2, 0, 3, 1) if count == 4 else None,
    )


def _kane() -> Impact:
    a, b = KANE_ANGLES
    mixed = 0.5 * math.cos(a - b)
    return Impact(
        key="kane",
        title="Kane's double pendulum",
        M=np.array([[4.0 / 3.0, mixed], [mixed, 1.0 / 3.0]]),
        G=np.array([[math.sin(a), math.sin(b)], [math.cos(a), math.cos(b)]]),
        before=np.array(KANE_RATES),
        tangents=1,
        order=(0,),
        frictions=(0.0, 0.1, 0.5),
    )


def _cradle(n: int) -> Impact:
    return Impact(
        key=f"cradle{n}",
        title=f"cradle of {n}",
        M=np.eye(n),
        G=np.diff(np.eye(n), axis=0),
        before=np.eye(n)[0],
        tangents=0,
        order=tuple(range(n - 1)),
        restitutions=(0.5, 1.0),
        turned=tuple(reversed(range(n - 1))),
    )


IMPACTS = {
    impact.key: impact
    for impact in (
        _rod(),
        _kane(),
        _box("corner", "turned box, one corner", BOX_TURN, 1),
        _box("flat", "box flat on four corners", (0.0, 0.0, 0.0), 4),
        _cradle(3),
        _cradle(7),
    )
}

Case = tuple[Impact, float, float]
"""An impact with its friction and restitution."""


def cases() -> list[Case]:
    """All impacts of all experiments, those told in another order last."""
    found = [
        (impact, mu, e)
        for impact in IMPACTS.values()
        for mu in impact.frictions
        for e in impact.restitutions
    ]
    return found + [
        (replace(impact, order=impact.turned), mu, e) for impact, mu, e in found if impact.turned
    ]


# ----------------------------------------------------------------------------------------- rest

PARK_SIZE = (0.4, 0.4, 0.2)
"""Of the parked box of 32 kg, which stands on four corners [m]."""
PARK_MASS = 32.0
PARK_FRICTION = 0.6
PARK_TIME = 1.0
DEMANDS = {"parked": 5.5 / GRAVITY, "below": 0.599, "above": 0.601}
"""Gravity along the ground over that across it: less, and more, than friction holds."""


def parked_rows() -> tuple[Array, list[Array]]:
    """Mass matrix (6, 6) of the parked box, and the rows (3, 6) of each of its corners."""
    a = np.square(PARK_SIZE)
    M = np.diag([PARK_MASS] * 3 + list(PARK_MASS * (a.sum() - a) / 12.0))
    axes = np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
    corners = [0.5 * np.array(PARK_SIZE) * (x, y, -1.0) for x, y in product((-1, 1), repeat=2)]
    return M, [np.array([[*axis, *np.cross(c, axis)] for axis in axes]) for c in corners]


def slid(demand: float) -> float:
    """How far the box slides in the time [m]."""
    return max(0.0, 0.5 * GRAVITY * (demand - PARK_FRICTION) * PARK_TIME**2)


@dataclass(frozen=True, slots=True)
class Rest:
    """What became of the parked box."""

    slip: float
    """Way along the ground [m]."""
    lift: float
    """Way across it [m]."""
    changes: int | None = None
    """Events, or steps in which another number of corners pushed; None where a code tells none."""
