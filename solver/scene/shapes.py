"""Volume and radii of gyration of the shapes that a rigid body may have, about their centres."""

from __future__ import annotations

import math
from typing import Any

from solver.scene.expression import Number
from solver.scene.fields import BROKEN, shown
from solver.scene.geometry import Geometry
from solver.scene.numbers import GEOMETRY, NOT_NEGATIVE, POSITIVE
from solver.scene.report import Path
from solver.scene.vocabulary_parts import Vector


class Sizes:
    """Sizes of one shape, each checked as it is asked for."""

    def __init__(self, geometry: Geometry, path: Path, part: Any) -> None:
        self.geometry = geometry
        self.path = path
        self.part = part

    def length(self, name: str) -> Number:
        """Read a length in m."""
        numbers, given = self.geometry.numbers, getattr(self.part, name)
        return numbers.number((*self.path, name), given, GEOMETRY, POSITIVE, "m")

    def edges(self) -> Vector:
        """Read the edges of a box in m."""
        path, wanted = (*self.path, "size"), self.geometry.dimension or 3
        if self.part.size is BROKEN:
            return (1.0,) * wanted
        edges = self.geometry.vector(path, self.part.size)
        values = self.geometry.values(edges)
        if values is not None and min(values, default=1.0) <= 0.0:
            self.geometry.draft.error(path, f"sizes must be > 0 m, got {shown(values)}")
        return edges if len(edges) == wanted else (1.0,) * wanted

    def radii(self) -> tuple[Number, Number]:
        """Read the outer and the inner radius in m."""
        outer, path = self.length("radius"), (*self.path, "inner_radius")
        given, numbers = self.part.inner_radius, self.geometry.numbers
        if given is None:
            return outer, 0.0
        inner = numbers.number(path, given, GEOMETRY, NOT_NEGATIVE, "m")
        large, small = numbers.value(outer), numbers.value(inner)
        if large is not None and small is not None and 0.0 < large <= small:
            message = f"must be less than the radius {large:.15g} m, got {small:.15g}"
            self.geometry.draft.error(path, message)
            return outer, 0.0
        return outer, inner


def _box(sizes: Sizes) -> tuple[Number, Vector]:
    edges = sizes.edges()
    if len(edges) == 2:
        a, b = edges
        return a * b, ((a * a + b * b) / 12.0,)
    a, b, c = edges
    return a * b * c, (
        (b * b + c * c) / 12.0,
        (a * a + c * c) / 12.0,
        (a * a + b * b) / 12.0,
    )


def _cylinder(sizes: Sizes) -> tuple[Number, Vector]:
    outer, inner = sizes.radii()
    length = sizes.length("length")
    square = outer * outer + inner * inner
    along, across = square / 2.0, (3.0 * square + length * length) / 12.0
    axis = "z" if sizes.part.axis is BROKEN else sizes.part.axis
    radii = tuple(along if name == axis else across for name in "xyz")
    return math.pi * (outer * outer - inner * inner) * length, radii


def _sphere(sizes: Sizes) -> tuple[Number, Vector]:
    outer, inner = sizes.radii()
    cubes = outer**3.0 - inner**3.0
    radius = 0.4 * (outer * outer)
    if not isinstance(inner, float) or inner != 0.0:
        radius = 0.4 * (outer**5.0 - inner**5.0) / cubes
    return 4.0 / 3.0 * math.pi * cubes, (radius,) * 3


def _disc(sizes: Sizes) -> tuple[Number, Vector]:
    outer, inner = sizes.radii()
    area = math.pi * (outer * outer - inner * inner)
    return area, ((outer * outer + inner * inner) / 2.0,)


def _rod(sizes: Sizes) -> tuple[Number, Vector]:
    length = sizes.length("length")
    return length, (length * length / 12.0,)


GYRATION = {"box": _box, "cylinder": _cylinder, "sphere": _sphere, "disc": _disc, "rod": _rod}
"""Volume (2-D: area, length) and squared radii of gyration of each shape, in m."""
