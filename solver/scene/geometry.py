"""Vectors of a scene: as many numbers as the dimension, directions of some length, products."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, TypeVar

from solver.scene.expression import ExpressionError, Number, Vector
from solver.scene.fields import BROKEN
from solver.scene.numbers import LARGEST_NUMBER, Known, Numbers
from solver.scene.report import Path
from solver.scene.rules import GEOMETRY, Place

if TYPE_CHECKING:
    from solver.scene.draft import Draft

T = TypeVar("T")


class Vectors(Numbers):
    """Judge of every number and vector of a scene."""

    def __init__(self, draft: Draft, known: Known, dimension: Any) -> None:
        super().__init__(draft, known)
        self.dimension: int | None = None if dimension is BROKEN else dimension
        """None: broken, so that vectors may have two or three numbers."""

    def zero(self) -> Vector:
        """Return the zero vector of the scene's dimension."""
        return (0.0,) * (self.dimension or 3)

    def vector(self, path: Path, readings: Any, place: Place = GEOMETRY) -> Vector:
        """Read a vector of the scene's dimension."""
        wanted = self.dimension or 3
        if readings is BROKEN:
            return (0.0,) * wanted
        if len(readings) != wanted and not (self.dimension is None and len(readings) == 2):
            message = f"must have {wanted} numbers in dimension {wanted}, got {len(readings)}"
            planar = path == ("gravity",) and wanted == 3
            self.draft.error(path, message, "in the plane write dimension = 2" if planar else None)
        return self.entries(path, readings, place)

    def entries(self, path: Path, readings: Any, place: Place = GEOMETRY) -> Vector:
        """Read the numbers of a list."""
        if all([reading.is_constant for reading in readings]):
            numbers = tuple([reading.number for reading in readings])
            if all([-LARGEST_NUMBER <= number <= LARGEST_NUMBER for number in numbers]):
                return numbers
        return tuple(self.number((*path, i), reading, place) for i, reading in enumerate(readings))

    def axis(self, path: Path, readings: Any) -> Vector:
        """Read a direction of any length but zero."""
        axis = self.vector(path, readings)
        if readings is BROKEN or len(axis) != len(self.zero()):
            return axis
        fine = self.has_length(path, axis, "a direction")
        return axis if fine else (1.0, *self.zero()[1:])

    def has_length(self, path: Path, vector: Vector, what: str) -> bool:
        """Report a vector whose length is zero, or too small or large for its square."""
        values = self.values(vector)
        size = 1.0 if values is None else max(map(abs, values))
        if not 1.0 / LARGEST_NUMBER <= size <= LARGEST_NUMBER:
            length = f"{size:.3g}" if size else "zero"
            help = "any other length will do"
            if size:
                help = f"any length from {1.0 / LARGEST_NUMBER:g} to {LARGEST_NUMBER:g} will do"
            self.draft.error(path, f"{what} of length {length}", help)
        return values is not None and 1.0 / LARGEST_NUMBER <= size <= LARGEST_NUMBER

    def values(self, vector: Vector) -> list[float] | None:
        """Values with the default parameters; None where one of them has none."""
        values = [self.value(number) for number in vector]
        known = [value for value in values if value is not None]
        return known if len(known) == len(values) else None

    def calculated(self, path: Path, calculate: Callable[[], T], otherwise: T) -> T:
        """Return what is calculated from numbers of the file, unless it has no finite value."""
        try:
            result = calculate()
        except ExpressionError as error:
            self.draft.error(path, f"no value: {error.message}")
            return otherwise
        except OverflowError:
            result = math.inf
        if _finite(result):
            return result  # pyright: ignore[reportReturnType]
        self.draft.error(path, "no value: larger than any floating-point number")
        return otherwise


def _finite(result: object) -> bool:
    """Whether all numbers of a result that are known are finite."""
    if isinstance(result, tuple):
        return all(_finite(item) for item in result)
    return not isinstance(result, float) or math.isfinite(result)


def dot(a: Vector, b: Vector) -> Number:
    """Inner product of two vectors."""
    total: Number = 0.0
    for x, y in zip(a, b, strict=True):
        total = total + x * y
    return total


def applied(matrix: tuple[Vector, ...], vector: Vector) -> Vector:
    """Product of a matrix, given by its rows, and a vector."""
    return tuple(dot(row, vector) for row in matrix)
