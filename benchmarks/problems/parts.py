"""Parts of the problems of the work-precision curves: bodies, joints, springs, places to watch.

Bodies stand where they start, described about their centres of mass; a planar mechanism moves in
the plane z = 0. NumPy alone is needed: the peers read these files in interpreters of their own.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Vector = tuple[float, ...]
Place = tuple[str, Vector]
"""A body and a place [m] in its axes, from its centre of mass; or the ground and a place there."""

GROUND = ""
O = (0.0, 0.0, 0.0)  # noqa: E741 - the origin
X, Y, Z = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)
GRAVITY = 9.81
"""[m/s2]"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Body:
    """Mass [kg], start of the centre of mass [m, m/s], attitude, angular velocity [rad/s]."""

    mass: float
    position: Vector
    inertia: Vector = O
    """Principal moments about the centre of mass, in the body's axes [kg m2]; none: a point."""
    turn: Vector = O
    """Rotation vector of the body's axes [rad]."""
    velocity: Vector = O
    omega: Vector = O
    """In the body's axes."""

    @property
    def is_point(self) -> bool:
        """Whether it has a mass alone."""
        return not any(self.inertia)

    @property
    def attitude(self) -> Array:
        """Rotation matrix of the start, whose columns are the body's axes."""
        return rotation(self.turn)


@dataclass(frozen=True, slots=True, kw_only=True)
class Joint:
    """Holds two bodies together; `kind` is revolute, spherical, prismatic or distance."""

    kind: str
    pair: tuple[str, str]
    position: Vector = O
    """Where it is at the start [m]; a distance joint goes from centre to centre, or this place."""
    ends: tuple[Vector, Vector] = (O, O)
    """Where a distance joint ends in the axes of its bodies, from their centres of mass [m]."""
    axis: Vector = Z
    redundant: bool = False
    """Leaves to others, whose rows say the same, the rotation about x and that about z; in space a
    spherical joint leaves the place along z."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Spring:
    """Spring [N/m, m] and damper [N s/m] between two places."""

    ends: tuple[Place, Place]
    stiffness: float = 0.0
    length: float = 0.0
    damping: float = 0.0


@dataclass(frozen=True, slots=True, kw_only=True)
class Problem:
    """A mechanism, its end and what is looked at there."""

    key: str
    title: str
    stop: float
    """End [s]."""
    bodies: Mapping[str, Body]
    joints: tuple[Joint, ...]
    watch: tuple[Place, ...]
    """Places whose position and velocity is compared."""
    gravity: Vector = (0.0, -GRAVITY, 0.0)
    springs: tuple[Spring, ...] = ()
    torque: tuple[str, float] | None = None
    """A body and a constant torque about z on it [N m]."""
    planar: bool = True
    conserves: bool = True
    """Whether its energy stays what it was."""
    data: Mapping[str, float] = field(default_factory=dict)
    """Numbers that equations in fewest coordinates use by name."""


def rotation(vector: Vector) -> Array:
    """Rotation matrix of a rotation vector [rad] (Rodrigues)."""
    angle = math.sqrt(sum(x * x for x in vector))
    x, y, z = (part / (angle or 1.0) for part in vector)
    K = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + math.sin(angle) * K + (1 - math.cos(angle)) * K @ K


def added(a: Vector, b: Vector) -> Vector:
    """Sum of two vectors."""
    return tuple(p + q for p, q in zip(a, b, strict=True))


def energies(problem: Problem, read: Callable[[str, str], Array]) -> Array:
    """Energy of samples [J], from what `read(body, what)` returns, (samples, 3) each.

    `what` is x, v, w (centre of mass, its velocity, angular velocity in body axes), or spring10 for
    the first end of the second spring.
    """
    total = np.zeros(1)
    gravity = np.array(problem.gravity)
    for name, body in problem.bodies.items():
        total = total + 0.5 * body.mass * np.sum(read(name, "v") ** 2, axis=1)
        total = total - body.mass * (read(name, "x") @ gravity)
        if not body.is_point:
            total = total + 0.5 * read(name, "w") ** 2 @ np.array(body.inertia)
    for i, spring in enumerate(problem.springs):
        ends = [
            np.array([place]) if name == GROUND else read(name, f"spring{i}{j}")
            for j, (name, place) in enumerate(spring.ends)
        ]
        stretch = np.linalg.norm(ends[1] - ends[0], axis=1) - spring.length
        total = total + 0.5 * spring.stiffness * stretch**2
    return total
