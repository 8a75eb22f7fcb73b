"""Mass and inertia of a rigid body: as given, or from a shape and its density.

An inertia J about the centre of mass belongs to a body when no principal moment is larger than
the sum of the other two; equality is a slender or flat body, zero a point.
"""

from __future__ import annotations

import math
from typing import Any, TypeAlias

from solver.scene.expression import Number
from solver.scene.fields import BROKEN
from solver.scene.geometry import Geometry
from solver.scene.numbers import GEOMETRY, NOT_NEGATIVE, POSITIVE
from solver.scene.report import Path
from solver.scene.schema_shapes import SHAPES
from solver.scene.shapes import GYRATION, Sizes
from solver.scene.vocabulary_parts import Vector

Inertia: TypeAlias = Number | tuple[Vector, Vector, Vector]

NOTHING: tuple[Vector, Vector, Vector] = ((0.0,) * 3, (0.0,) * 3, (0.0,) * 3)
ROUND_OFF = 1e-12
"""By which a moment may exceed the sum of the others, relative to that sum."""

_DENSITY = {"box": "kg/m3", "cylinder": "kg/m3", "sphere": "kg/m3", "disc": "kg/m2", "rod": "kg/m"}


def read_weight(geometry: Geometry, path: Path, part: Any) -> tuple[Number, Inertia]:
    """Read the mass in kg and the inertia in kg.m2 of a rigid body."""
    mass = geometry.numbers.optional((*path, "mass"), part.mass, GEOMETRY, POSITIVE, "kg")
    inertia = _inertia(geometry, (*path, "inertia"), part.inertia)
    if part.shape is not None:
        if part.shape is BROKEN:
            return _known(mass), inertia
        return _from_shape(geometry, path, part, mass)
    missing = [f"'{name}'" for name in ("mass", "inertia") if getattr(part, name) is None]
    if missing:
        message = f"{' and '.join(missing)} {'are' if len(missing) == 2 else 'is'} missing"
        help = "write mass and inertia, or a shape with a density"
        geometry.draft.error(path, message, help)
    return _known(mass), inertia


def _from_shape(
    geometry: Geometry, path: Path, part: Any, mass: Number | None
) -> tuple[Number, Inertia]:
    draft, where = geometry.draft, (*path, "shape")
    otherwise: Inertia = 0.0 if geometry.dimension == 2 else NOTHING
    if part.inertia is not None:
        help = "leave out 'inertia' or 'shape'"
        draft.error((*path, "inertia"), "the shape gives the inertia already", help)
    shape = _shape(geometry, where, part.shape)
    if shape is None:
        return _known(mass), otherwise
    density_at = (*where, "density")
    unit = _DENSITY[shape.type]
    density = geometry.numbers.optional(density_at, shape.density, GEOMETRY, POSITIVE, unit)
    if part.mass is not None and shape.density is not None:
        help = "leave out 'mass' or 'density'"
        draft.error((*path, "mass"), "the density of the shape gives the mass already", help)
    if part.mass is None and shape.density is None:
        help = f"write a density in {unit} into the shape, or a mass"
        draft.error(where, "neither 'density' nor the body's 'mass' is given", help)
    sizes = Sizes(geometry, where, shape)

    def weight() -> tuple[Number, Inertia]:
        volume, radii = GYRATION[shape.type](sizes)
        given = _known(density) * volume if mass is None else mass
        return given, _scaled(given, radii)

    return geometry.calculated(where, weight, (0.0, otherwise))


def _known(number: Number | None) -> Number:
    """Put a number in the place of one whose absence has been reported."""
    return 0.0 if number is None else number


def _scaled(mass: Number, radii: Vector) -> Inertia:
    """Inertia from the squared radii of gyration: a number, or a diagonal matrix."""
    if len(radii) == 1:
        return mass * radii[0]
    x, y, z = (mass * radius for radius in radii)
    return (x, 0.0, 0.0), (0.0, y, 0.0), (0.0, 0.0, z)


def _shape(geometry: Geometry, path: Path, data: dict[str, Any]) -> Any:
    """Check the fields of a shape; None where its type is of no use."""
    known = SHAPES.get(geometry.dimension or 0, SHAPES[3] | SHAPES[2])
    title = f"shapes in dimension {geometry.dimension or 3}"

    def elsewhere(kind: str) -> tuple[str, str] | None:
        possible = [dimension for dimension, shapes in SHAPES.items() if kind in shapes]
        message = f"'{kind}' is possible only in dimension {(*possible, 0)[0]}"
        return (message, f"{title}: {', '.join(known)}") if possible else None

    model = geometry.draft.model(path, data, known, title, elsewhere)
    return None if model is None else geometry.draft.part(path, model, data)


def _inertia(geometry: Geometry, path: Path, given: Any) -> Inertia:
    """Read an inertia: a number in 2-D; principal moments or a matrix in 3-D."""
    draft, planar = geometry.draft, geometry.dimension == 2
    if given is None or given is BROKEN or geometry.dimension is None:
        return 0.0 if planar else NOTHING
    if planar:
        if isinstance(given, list):
            draft.error(path, "must be a number in dimension 2, got a list")
            return 0.0
        return geometry.numbers.number(path, given, GEOMETRY, NOT_NEGATIVE, "kg.m2")
    if not isinstance(given, list):
        message = "must be [Jx, Jy, Jz] or 3 rows of 3 numbers in dimension 3, got a number"
        draft.error(path, message)
        return NOTHING
    if any(isinstance(row, list) for row in given):
        return _matrix(geometry, path, given)
    moments = geometry.vector(path, given)
    values = geometry.values(moments)
    if len(moments) != 3:
        return NOTHING
    if values is not None:
        names = ["Jx", "Jy", "Jz"]
        order = sorted(range(3), key=lambda i: values[i])
        _possible(geometry, path, [values[i] for i in order], [names[i] for i in order])
    x, y, z = moments
    return (x, 0.0, 0.0), (0.0, y, 0.0), (0.0, 0.0, z)


def _matrix(geometry: Geometry, path: Path, given: Any) -> Inertia:
    if [len(row) for row in given] != [3, 3, 3]:
        geometry.draft.error(path, "must have 3 rows of 3 numbers")
        return NOTHING
    rows = [geometry.vector((*path, i), row) for i, row in enumerate(given)]
    values = [geometry.values(row) for row in rows]
    if not any(row is None for row in values):
        matrix = [list(row or ()) for row in values]
        size = max(abs(x) for row in matrix for x in row)
        for i, j in ((0, 1), (0, 2), (1, 2)):
            if abs(matrix[i][j] - matrix[j][i]) > 1e-9 * size:
                names = "xyz"[i] + "xyz"[j]
                message = f"must be symmetric: J{names} = {matrix[i][j]:.15g}, but J{names[::-1]} ="
                geometry.draft.error(path, f"{message} {matrix[j][i]:.15g} kg.m2")
                return NOTHING
        names = ["J1", "J2", "J3"]
        _possible(geometry, path, principal_moments(matrix), names)
    (a, d, e), (_, b, f), (_, _, c) = rows
    return (a, d, e), (d, b, f), (e, f, c)


def _possible(geometry: Geometry, path: Path, moments: list[float], names: list[str]) -> None:
    """Report moments, the largest last, that no body can have."""
    small, middle, large = moments
    principal = "" if "Jx" in names else " (principal moments)"
    if small < -ROUND_OFF * large or large < 0.0:
        message = f"inertia that no body can have: {names[0]} = {small:.12g} < 0 kg.m2{principal}"
        geometry.draft.error(path, message)
    elif large > (small + middle) * (1.0 + ROUND_OFF):
        message = (
            f"inertia that no body can have: {names[2]} = {large:.12g} > "
            f"{names[0]} + {names[1]} = {small + middle:.12g} kg.m2{principal}"
        )
        geometry.draft.error(path, message, "give it about the centre of mass, in kg.m2")


def principal_moments(matrix: list[list[float]]) -> list[float]:
    """Eigenvalues of a symmetric 3 x 3 matrix, ascending, by Jacobi's rotations."""
    a = [row[:] for row in matrix]
    for _ in range(30):  # quadratic convergence: 6 sweeps of 3 rotations are usual
        i, j = max(((0, 1), (0, 2), (1, 2)), key=lambda pair: abs(a[pair[0]][pair[1]]))
        if a[i][j] == 0.0:
            break
        angle = 0.5 * math.atan2(2.0 * a[i][j], a[j][j] - a[i][i])
        c, s = math.cos(angle), math.sin(angle)
        for row in a:
            row[i], row[j] = c * row[i] - s * row[j], s * row[i] + c * row[j]
        a[i], a[j] = (
            [c * x - s * y for x, y in zip(a[i], a[j], strict=True)],
            [s * x + c * y for x, y in zip(a[i], a[j], strict=True)],
        )
    return sorted(a[k][k] for k in range(3))
