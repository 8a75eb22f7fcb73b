"""Mass and inertia of a rigid body: as given, or from a shape and its density.

An inertia J about the centre of mass belongs to a body when no principal moment is larger than
the sum of the other two; equality is a slender or flat body, zero a point.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Annotated, Any, Literal, TypeAlias

from solver.scene.expression import Number, Vector
from solver.scene.fields import BROKEN, Choice, Components, Part, Quantity, fields_of, shown
from solver.scene.mistakes import Path
from solver.scene.principal_moments import (
    composed,
    excess,
    explained,
    half_units,
    nearest,
    principal,
)
from solver.scene.rules import NOT_NEGATIVE, POSITIVE

if TYPE_CHECKING:
    from solver.scene.draft import Draft
    from solver.scene.references import Reader

Inertia: TypeAlias = Number | tuple[Vector, Vector, Vector]

NOTHING: tuple[Vector, Vector, Vector] = ((0.0,) * 3, (0.0,) * 3, (0.0,) * 3)

# --------------------------------------------------------------------------------------- shapes

_RADIUS = Quantity("m", rule=POSITIVE, example=0.1)
_INNER = Quantity("m", rule=NOT_NEGATIVE)
_LENGTH = Quantity("m", rule=POSITIVE, example=1.0)


class _Density(Quantity):
    """A density: of an area in the plane, where the shape is one in space."""

    def parse(self, draft: "Draft", path: Path, value: Any, unit: str = "") -> Any:
        """Read a number, whose unit depends on the dimension."""
        in_plane = draft.dimension == 2 and self.unit == "kg/m3"
        own = replace(self, unit="kg/m2") if in_plane else self
        return Quantity.parse(own, draft, path, value, unit)


def _density(unit: str, text: str = "") -> Quantity:
    return _Density(unit, text, POSITIVE)


class Shape(Part):
    """A homogeneous body about its centre."""

    __slots__ = ()
    density: Number | None

    def gyration(self) -> tuple[Number, Vector]:
        """Volume (2-D: area, length) and squared radii of gyration, in m."""
        raise NotImplementedError


def _edges(reader: "Reader", path: Path, value: Any, _: Any) -> Vector:
    """Check that the edges of a box are positive."""
    edges, ones = reader.vector(path, value), (1.0,) * len(reader.zero())
    values = None if value is BROKEN else reader.values(edges)
    if values is not None and min(values, default=1.0) <= 0.0:
        reader.draft.error(path, f"sizes must be > 0 m, got {shown(values)}")
    return edges if value is not BROKEN and len(edges) == len(ones) else ones


_SIZE = Components("m", "along x, y, z", example=[0.2, 0.1, 0.1], reading=_edges)


@dataclass(frozen=True, slots=True, kw_only=True)
class Box(Shape):
    """A cuboid; in the plane a rectangle."""

    type = "box"

    size: Annotated[Vector, _SIZE]
    density: Annotated[Number | None, _density("kg/m3", "in 2-D kg/m2")] = None

    def gyration(self) -> tuple[Number, Vector]:
        """Squares of the edges across each axis, over twelve."""
        if len(self.size) == 2:
            a, b = self.size
            return a * b, ((a * a + b * b) / 12.0,)
        a, b, c = self.size
        across = ((b * b + c * c) / 12.0, (a * a + c * c) / 12.0, (a * a + b * b) / 12.0)
        return a * b * c, across


@dataclass(frozen=True, slots=True, kw_only=True)
class Round(Shape):
    """A shape with an outer and an inner radius."""

    radius: Annotated[Number, _RADIUS]
    inner_radius: Annotated[Number, _INNER] = 0.0

    @classmethod
    def read(cls, reader: "Reader", path: Path, given: Any) -> Any:
        """Check that the inner radius is the smaller one."""
        values = reader.fields(cls, path, given)
        large, small = (reader.value(values.get(name, 0.0)) for name in ("radius", "inner_radius"))
        if large is not None and small is not None and 0.0 < large <= small:
            message = f"must be less than the radius {large:.15g} m, got {small:.15g}"
            reader.draft.error((*path, "inner_radius"), message)
            values["inner_radius"] = 0.0
        return cls(**values)

    def squares(self) -> tuple[Number, Number]:
        """Sum and difference of the squared radii, in m2."""
        outer, inner = self.radius * self.radius, self.inner_radius * self.inner_radius
        return outer + inner, outer - inner


@dataclass(frozen=True, slots=True, kw_only=True)
class Cylinder(Round):
    """A cylinder, or a tube."""

    type = "cylinder"
    only_in = (3, "")

    length: Annotated[Number, _LENGTH]
    axis: Annotated[Literal["x", "y", "z"], Choice(text="along it", words=("x", "y", "z"))] = "z"
    density: Annotated[Number | None, _density("kg/m3")] = None

    def gyration(self) -> tuple[Number, Vector]:
        """Squares along the axis and across it."""
        squares, ring = self.squares()
        along, across = squares / 2.0, (3.0 * squares + self.length * self.length) / 12.0
        radii = tuple(along if name == self.axis else across for name in "xyz")
        return math.pi * ring * self.length, radii


@dataclass(frozen=True, slots=True, kw_only=True)
class Sphere(Round):
    """A ball, or a hollow one."""

    type = "sphere"
    only_in = (3, "")

    density: Annotated[Number | None, _density("kg/m3")] = None

    def gyration(self) -> tuple[Number, Vector]:
        """Fifth powers over cubes."""
        outer, inner = self.radius, self.inner_radius
        cubes = outer**3.0 - inner**3.0
        radius = 0.4 * (outer * outer)
        if not isinstance(inner, float) or inner != 0.0:
            radius = 0.4 * (outer**5.0 - inner**5.0) / cubes
        return 4.0 / 3.0 * math.pi * cubes, (radius,) * 3


@dataclass(frozen=True, slots=True, kw_only=True)
class Disc(Round):
    """A disc in the plane, or a ring."""

    type = "disc"
    only_in = (2, "")

    density: Annotated[Number | None, _density("kg/m2")] = None

    def gyration(self) -> tuple[Number, Vector]:
        """Half the squares of the radii."""
        squares, ring = self.squares()
        return math.pi * ring, (squares / 2.0,)


@dataclass(frozen=True, slots=True, kw_only=True)
class Rod(Shape):
    """A slender rod in the plane, along x."""

    type = "rod"
    only_in = (2, "")

    length: Annotated[Number, _LENGTH]
    density: Annotated[Number | None, _density("kg/m")] = None

    def gyration(self) -> tuple[Number, Vector]:
        """Square of the length over twelve."""
        return self.length, (self.length * self.length / 12.0,)


SHAPES: dict[str, type[Shape]] = {shape.type: shape for shape in (Box, Cylinder, Sphere, Disc, Rod)}
"""Shapes that a rigid body may have."""

# --------------------------------------------------------------------------------------- inertia


def read_inertia(
    reader: "Reader", path: Path, given: Any, mass: Number | None
) -> tuple[Number, Inertia, Shape | None]:
    """Return mass in kg, inertia in kg.m2 and shape of a rigid body, whose own mass is read."""
    inertia = _inertia(reader, (*path, "inertia"), given.inertia)
    known = 0.0 if mass is None else mass
    if isinstance(given.shape, dict):
        return _from_shape(reader, path, given, mass)
    missing = [f"'{name}'" for name in ("mass", "inertia") if getattr(given, name) is None]
    if missing and given.shape is None:
        message = f"{' and '.join(missing)} {'are' if len(missing) == 2 else 'is'} missing"
        help = "write mass and inertia, or a shape with a density"
        reader.draft.error(path, message, help)
    return known, inertia, None


def _from_shape(
    reader: "Reader", path: Path, given: Any, mass: Number | None
) -> tuple[Number, Inertia, Shape | None]:
    draft, where = reader.draft, (*path, "shape")
    otherwise: Inertia = 0.0 if reader.dimension == 2 else NOTHING
    if given.inertia is not None:
        help = "leave out 'inertia' or 'shape'"
        draft.error((*path, "inertia"), "the shape gives the inertia already", help)
    title = f"shapes in dimension {reader.dimension or 3}"
    kind = draft.class_of(where, given.shape, SHAPES, title)
    if kind is None:
        return (0.0 if mass is None else mass), otherwise, None
    fields = draft.part(where, kind, given.shape)
    shape = kind.read(reader, where, fields)
    if mass is not None and fields.density is not None:
        help = "leave out 'mass' or 'density'"
        draft.error((*path, "mass"), "the density of the shape gives the mass already", help)
    if mass is None and fields.density is None:
        unit = fields_of(kind)["density"].kind.unit
        help = f"write a density in {unit} into the shape, or the mass of the body"
        draft.error(where, "neither 'density' nor the body's 'mass' is given", help)

    def scaled() -> tuple[Number, Inertia]:
        volume, radii = shape.gyration()
        own = (0.0 if shape.density is None else shape.density) * volume if mass is None else mass
        if len(radii) == 1:
            return own, own * radii[0]
        return own, _diagonal(*(own * radius for radius in radii))

    return *reader.calculated(where, scaled, (0.0, otherwise)), shape


def _diagonal(x: Number, y: Number, z: Number) -> tuple[Vector, Vector, Vector]:
    return (x, 0.0, 0.0), (0.0, y, 0.0), (0.0, 0.0, z)


def _inertia(reader: "Reader", path: Path, given: Any) -> Inertia:
    """Read an inertia: a number in 2-D; principal moments or a matrix in 3-D."""
    draft, planar = reader.draft, reader.dimension == 2
    if given is None or given is BROKEN or reader.dimension is None:
        return 0.0 if planar else NOTHING
    if planar:
        if isinstance(given, list):
            draft.error(path, "must be a number in dimension 2, got a list")
            return 0.0
        return reader.number(path, given, rule=NOT_NEGATIVE, unit="kg.m2")
    if not isinstance(given, list):
        message = "must be [Jx, Jy, Jz] or 3 rows of 3 numbers in dimension 3, got a number"
        draft.error(path, message)
        return NOTHING
    if any(isinstance(row, list) for row in given):
        return _matrix(reader, path, given)
    moments = reader.vector(path, given)
    if len(moments) != 3:
        return NOTHING
    return _of_a_body(reader, path, _diagonal(*moments), [[x] for x in given])


def _matrix(reader: "Reader", path: Path, given: Any) -> Inertia:
    found = reader.matrix(path, given)
    if found is None:
        return NOTHING
    rows, matrix = found
    if matrix:
        size = max(abs(x) for row in matrix for x in row)
        for i, j in ((0, 1), (0, 2), (1, 2)):
            if abs(matrix[i][j] - matrix[j][i]) > 1e-9 * size:
                names = "xyz"[i] + "xyz"[j]
                message = f"must be symmetric: J{names} = {matrix[i][j]:.15g}, but J{names[::-1]} ="
                reader.draft.error(path, f"{message} {matrix[j][i]:.15g} kg.m2")
                return NOTHING
    (a, d, e), (_, b, f), (_, _, c) = rows
    return _of_a_body(reader, path, ((a, d, e), (d, b, f), (e, f, c)), given)


def _of_a_body(
    reader: "Reader", path: Path, inertia: tuple[Vector, Vector, Vector],
    given: Sequence[Sequence[Any]],
) -> Inertia:  # fmt: skip
    """Return an inertia that a body can have; report one that none has by more than its digits.

    `given` are the rows of the file, or the three principal moments, one a row.
    """
    values = [reader.values(row) for row in inertia]
    matrix = [row for row in values if row is not None]
    if len(matrix) < 3:
        return inertia
    moments, axes = principal(matrix)
    over = excess(moments)
    if over == 0.0:
        return inertia
    diagonal = len(given[0]) == 1
    names = ["J1", "J2", "J3"]
    if diagonal:
        names = ["J" + "xyz"[axis.index(1.0)] for axis in axes]
    problem = _broken(moments, names) + ("" if diagonal else " (principal moments)")
    if not over <= explained(moments, axes, _half_units(reader, path, given)):
        help = "give it about the centre of mass, in kg.m2" if ">" in problem else None
        reader.draft.error(path, f"inertia that no body can have: {problem}", help)
        return inertia
    mended = composed(nearest(moments), axes)
    shown = [mended[i][i] for i in range(3)] if diagonal else mended
    message = f"{problem}, by less than its digits or the solver resolve; taken as {_listed(shown)}"
    reader.draft.warn(path, message, "give it with more digits, or give a shape")
    if any(not isinstance(x, float) for row in inertia for x in row):
        return inertia  # of parameters, the mechanism gives a flat body what it lacks
    return tuple(mended[0]), tuple(mended[1]), tuple(mended[2])


def _half_units(reader: "Reader", path: Path, given: Sequence[Sequence[Any]]) -> list[list[float]]:
    """Half a unit of the last digit of each entry of an inertia, of a formula 0."""

    def text(place: Path, parsed: Any) -> str:
        formula = isinstance(parsed.given, str)
        return "" if formula else reader.draft.source.written(place, parsed.given)

    if len(given[0]) == 1:
        ends = half_units([[text((*path, i), x)] for i, (x,) in enumerate(given)])
        return [[ends[i][0] if i == k else 0.0 for k in range(3)] for i in range(3)]
    return half_units(
        [[text((*path, i, k), x) for k, x in enumerate(row)] for i, row in enumerate(given)]
    )


def _broken(moments: Sequence[float], names: Sequence[str]) -> str:
    """What is wrong with moments that no body can have."""
    small, middle, large = moments
    if small < 0.0:
        return f"{names[0]} = {small:.12g} < 0 kg.m2"
    return f"{names[2]} = {large:.12g} > {names[0]} + {names[1]} = {small + middle:.12g} kg.m2"


def _listed(numbers: Any) -> str:
    """Numbers with 12 digits, in brackets."""
    if isinstance(numbers, float):
        return f"{numbers:.12g}"
    return f"[{', '.join(map(_listed, numbers))}]"
