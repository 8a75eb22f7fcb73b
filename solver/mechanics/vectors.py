"""Vector algebra on numbers of a scene: floats stay floats, expressions stay expressions."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from solver.scene import Number
from solver.scene.expression import Vector, sqrt
from solver.scene.numbers import dot as dot
from solver.scene.numbers import times as times

Matrix = tuple[Vector, ...]
"""Rows."""


def add(a: Sequence[Number], b: Sequence[Number]) -> Vector:
    """Return a + b."""
    return tuple([x + y for x, y in zip(a, b, strict=True)])


def subtract(a: Sequence[Number], b: Sequence[Number]) -> Vector:
    """Return a - b."""
    return tuple([x - y for x, y in zip(a, b, strict=True)])


def scale(factor: Number, a: Sequence[Number]) -> Vector:
    """Return factor a."""
    return tuple([factor * x for x in a])


def cross(a: Sequence[Number], b: Sequence[Number]) -> Vector:
    """Return a x b in space."""
    return (
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    )


def turned(a: Sequence[Number]) -> Vector:
    """Return J a, a turned by a right angle in the plane, counter-clockwise."""
    return (-a[1], a[0])


def norm(a: Sequence[Number]) -> Number:
    """Return |a|."""
    return sqrt(dot(a, a))


def unit(a: Sequence[Number]) -> Vector:
    """Return a/|a|; exact for a vector along an axis of coordinates."""
    if sum(x != 0.0 for x in a) == 1 and all(x in (0.0, 1.0, -1.0) for x in a):
        return tuple(a)
    length = norm(a)
    return tuple(x / length for x in a)


def columns(matrix: Matrix) -> tuple[Vector, ...]:
    """Return the columns of a matrix."""
    return tuple(zip(*matrix, strict=True))


def identity(dim: int) -> Matrix:
    """Return the unit matrix."""
    return tuple(tuple(float(i == k) for k in range(dim)) for i in range(dim))


def perpendicular(a: Vector, default: Callable[[Number], float]) -> tuple[Vector, Vector]:
    """Return two unit vectors that form a right-handed set with the unit vector a: (b, a x b).

    Which of the axes of coordinates helps to find them is decided with the default values.
    """
    sizes = [abs(default(x)) for x in a]
    helper = identity(3)[sizes.index(min(sizes))]
    b = unit(cross(a, helper))
    return b, cross(a, b)


def snapped(a: Sequence[Number], size: float) -> Vector:
    """Return a without the components that only rounding left, against a length `size`."""
    return tuple(0.0 if isinstance(x, float) and abs(x) <= 1e-15 * size else x for x in a)
