"""Frames: where the places and directions of a body are, as combinations of its nodes.

A place of a rigid body is x = r + sum xi_i d_i with xi = R' (x - r) as drawn; in the plane the
second director is J d. A bar between two points has the frame d = (X_2 - X_1)/L in the plane.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from solver.mechanics.combination import Combination, node
from solver.mechanics.mechanism import Mechanism
from solver.mechanics.vectors import (
    Matrix,
    Vector,
    columns,
    dot,
    identity,
    scale,
    snapped,
    subtract,
    times,
    turned,
)
from solver.runtime.layout import NODE_DIRECTION, NODE_POINT
from solver.scene import Number


@dataclass(frozen=True, slots=True)
class Ground:
    """The body that stays."""

    mechanism: Mechanism

    @property
    def axes(self) -> tuple[Vector, ...]:
        """Return the global axes."""
        return identity(self.mechanism.dim)

    def place(self, position: Vector) -> Combination:
        """Return a fixed place."""
        return self.mechanism.fixed(NODE_POINT, position)

    def direction(self, vector: Vector) -> Combination:
        """Return a fixed direction."""
        return self.mechanism.fixed(NODE_DIRECTION, vector)

    def coordinates(self, place: Combination) -> tuple[tuple[Combination, Combination], ...]:
        """Return the global coordinates."""
        return tuple((place, self.direction(axis)) for axis in self.axes)


@dataclass(frozen=True, slots=True)
class RigidFrame:
    """Frame of a rigid body: node r, directors, and how it is drawn."""

    mechanism: Mechanism
    centre: int
    directors: tuple[int, ...]
    rotation: Matrix
    position: Vector
    """Of the centre of mass, as drawn."""
    offset: Vector
    """Centre of mass in body axes, from the origin."""
    points: dict[str, Vector] = field(default_factory=dict)

    @property
    def axes(self) -> tuple[Vector, ...]:
        """Return the body's axes as drawn."""
        return columns(self.rotation)

    def along(self, vector: Vector) -> Combination:
        """Return the direction with these components in body axes."""
        if self.mechanism.dim == 2:
            return Combination.of([(self.directors[0], vector[0], vector[1])])
        return Combination.of((d, x, 0.0) for d, x in zip(self.directors, vector, strict=True))

    def at(self, vector: Vector) -> Combination:
        """Return the place with these coordinates in body axes, from the origin."""
        return node(self.centre) + self.along(subtract(vector, self.offset))

    def _components(self, vector: Vector, size: float) -> Vector:
        return snapped(times(columns(self.rotation), vector), size)

    def place(self, position: Vector) -> Combination:
        """Return the place that is drawn at a global position."""
        both = (*position, *self.position)
        size = max((abs(x) for x in both if isinstance(x, float)), default=0.0)
        return node(self.centre) + self.along(
            self._components(subtract(position, self.position), size)
        )

    def direction(self, vector: Vector) -> Combination:
        """Return the direction that is drawn along a global vector."""
        return self.along(self._components(vector, 1.0))

    def coordinates(self, place: Combination) -> tuple[tuple[Combination, Combination], ...]:
        """Return the forms d_i . (x - x_origin)."""
        link = place - self.at((0.0,) * self.mechanism.dim)
        return tuple((link, self.along(axis)) for axis in identity(self.mechanism.dim))


@dataclass(frozen=True, slots=True)
class BarFrame:
    """Frame of a bar in the plane: origin at its first point, first axis towards the second."""

    mechanism: Mechanism
    ends: tuple[int, int]
    length: Number
    drawn: tuple[Vector, Vector]

    @property
    def axes(self) -> tuple[Vector, ...]:
        """Return its axes as drawn."""
        along = scale(1.0 / self.length, subtract(self.drawn[1], self.drawn[0]))
        return along, turned(along)

    def direction(self, vector: Vector) -> Combination:
        """Return the direction that is drawn along a global vector."""
        x, y = (dot(axis, vector) / self.length for axis in self.axes)
        first, second = self.ends
        return Combination.of([(first, -1.0 * x, -1.0 * y), (second, x, y)])

    def place(self, position: Vector) -> Combination:
        """Return the place that is drawn at a global position."""
        for end, drawn in zip(self.ends, self.drawn, strict=True):
            if position == drawn:
                return node(end)
        return node(self.ends[0]) + self.direction(subtract(position, self.drawn[0]))

    def coordinates(self, place: Combination) -> tuple[tuple[Combination, Combination], ...]:
        """Return the forms that are the coordinates along and across it."""
        link = place - node(self.ends[0])
        return tuple((link, self.direction(axis)) for axis in self.axes)


Frame = Ground | RigidFrame | BarFrame
"""A body, or the ground, to which places and directions are fixed."""
