"""Orientation and spin of a rigid body: from the ways of writing them to one matrix, one vector.

    R = c I + s [n]x + (1 - c) n n',   n = axis/|axis|,  c = cos(angle),  s = sin(angle)

(Rodrigues). The columns of R are the body's axes in global axes; in the plane an angle is enough.
"""

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Any, TypeAlias

from solver.scene import fields as kind
from solver.scene.expression import Number, Vector, cos, operate, select, sin, sqrt
from solver.scene.fields import BROKEN, Part
from solver.scene.mistakes import Path
from solver.scene.numbers import dot, times

if TYPE_CHECKING:
    from solver.scene.references import Reader

Matrix: TypeAlias = tuple[Vector, Vector, Vector]

IDENTITY: Matrix = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
ORTHONORMAL = 1e-9
"""Largest deviation of R'R from the identity: nine digits are what a person copies."""

_WAYS = "{ axis, angle }, { quaternion }, { rotation_vector } or { matrix }"
_EXAMPLE = "write orientation = { axis = [0, 0, 1], angle = ... }"


@dataclass(frozen=True, slots=True)
class Orientation(Part):
    """Orientation of a body in space; one of the four ways."""

    axis: Annotated[Any, kind.Components(text="about which it is turned by the angle")] = None
    angle: Annotated[Any, kind.Quantity("rad", "about the axis")] = None
    quaternion: Annotated[Any, kind.ListOf(text="[w, x, y, z]", item=kind.NUMBER)] = None
    rotation_vector: Annotated[Any, kind.Components("rad")] = None
    matrix: Annotated[
        Any, kind.ListOf(text="columns are the body's axes", item=kind.COMPONENTS)
    ] = None


@dataclass(frozen=True, slots=True)
class InBodyAxes(Part):
    """A vector in the axes of the body."""

    body: Annotated[Any, kind.Components("rad/s", example=[0, 0, 1])]


def read_orientation(reader: "Reader", path: Path, given: Any) -> Number | Matrix:
    """Read an orientation: an angle in rad in 2-D, a rotation matrix in 3-D."""
    planar, table = reader.dimension == 2, isinstance(given, dict)
    if given is None or given is BROKEN or reader.dimension is None:
        return 0.0 if planar else IDENTITY
    if planar and table:
        reader.draft.error(path, "must be a number in dimension 2, the angle in rad, got a table")
        return 0.0
    if planar:
        return reader.angle(path, given)
    if not table:
        reader.draft.error(path, "must be a table in dimension 3, got a number", _EXAMPLE)
        return IDENTITY
    part = reader.draft.part(path, Orientation, given)
    return reader.calculated(path, lambda: _matrix(reader, path, part), IDENTITY)


def read_spin(
    reader: "Reader", path: Path, given: Any, orientation: Number | Matrix
) -> Number | Vector | None:
    """Read an angular velocity in rad/s: a number in 2-D, a vector in global axes in 3-D."""
    draft = reader.draft
    if given is None or given is BROKEN or reader.dimension is None:
        return None
    if reader.dimension == 2:
        if isinstance(given, (dict, list)):
            what = "a table" if isinstance(given, dict) else "a vector"
            draft.error(path, f"must be a number in dimension 2, got {what}")
            return None
        return reader.number(path, given)
    if isinstance(given, list):
        return reader.vector(path, given)
    if not isinstance(given, dict):
        help = "write angular_velocity = [0, 0, ...]"
        draft.error(path, "must be a vector of 3 numbers in dimension 3, got a number", help)
        return None
    part = draft.part(path, InBodyAxes, given)
    own = reader.vector((*path, "body"), part.body)
    if len(own) != 3 or not isinstance(orientation, tuple):
        return None
    return reader.calculated(path, lambda: times(orientation, own), reader.zero())


def _matrix(reader: "Reader", path: Path, part: Any) -> Matrix:
    draft = reader.draft
    names = ("axis", "quaternion", "rotation_vector", "matrix")
    ways = [name for name in names if getattr(part, name) is not None]
    if not ways and part.angle is not None:
        draft.error(path, "'axis' is missing", _EXAMPLE)
    elif len(ways) != 1 or (part.angle is not None and ways != ["axis"]):
        given = [*ways, *(["angle"] if part.angle is not None and "axis" not in ways else [])]
        draft.error(path, f"must be given in one way, got {' and '.join(given) or 'none'}", _WAYS)
    elif ways == ["axis"] and part.angle is None:
        draft.error(path, "'angle' is missing", _EXAMPLE)
    elif getattr(part, ways[0]) is not BROKEN:
        return _READERS[ways[0]](reader, path, part)
    return IDENTITY


def _about_an_axis(reader: "Reader", path: Path, part: Any) -> Matrix:
    axis = reader.axis((*path, "axis"), part.axis)
    angle = reader.angle((*path, "angle"), part.angle)
    if len(axis) != 3 or reader.values(axis) is None:
        return IDENTITY
    length = sqrt(dot(axis, axis))
    x, y, z = (component / length for component in axis)
    return _rodrigues((x, y, z), sin(angle), cos(angle), 1.0 - cos(angle))


def _rotation_vector(reader: "Reader", path: Path, part: Any) -> Matrix:
    """Turn by |v| about v; for v = 0 by nothing."""
    vector = reader.vector((*path, "rotation_vector"), part.rotation_vector)
    for i, component in enumerate(part.rotation_vector):
        reader.angle((*path, "rotation_vector", i), component)
    if len(vector) != 3:
        return IDENTITY
    square = dot(vector, vector)
    turned = operate("gt", square, 0.0)
    angle = sqrt(select(turned, square, 1.0))
    along = select(turned, sin(angle) / angle, 1.0)
    half = select(turned, sin(angle / 2.0) / angle, 0.5)
    cosine = select(turned, cos(angle), 1.0)
    return _rodrigues(vector, along, cosine, 2.0 * half * half)  # 1 - cos a = 2 sin^2(a/2)


def _rodrigues(vector: Vector, along: Number, cosine: Number, across: Number) -> Matrix:
    """Return cosine I + along [v]x + across v v'."""
    x, y, z = vector
    cross = ((0.0, -z, y), (z, 0.0, -x), (-y, x, 0.0))
    rows = [
        tuple(
            (cosine if i == j else 0.0) + along * cross[i][j] + across * vector[i] * vector[j]
            for j in range(3)
        )
        for i in range(3)
    ]
    return rows[0], rows[1], rows[2]


def _quaternion(reader: "Reader", path: Path, part: Any) -> Matrix:
    path = (*path, "quaternion")
    given = reader.entries(path, part.quaternion)
    if len(given) != 4:
        reader.draft.error(path, f"must have 4 numbers, w first, got {len(given)}")
        return IDENTITY
    if not reader.has_length(path, given, "a quaternion"):
        return IDENTITY
    length = sqrt(dot(given, given))
    w, x, y, z = (number / length for number in given)
    return rotation_of(w, x, y, z)


def rotation_of(w: Number, x: Number, y: Number, z: Number) -> Matrix:
    """Return the rotation matrix of a unit quaternion, w first."""
    return (
        (1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)),
        (2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)),
        (2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)),
    )


def _given_matrix(reader: "Reader", path: Path, part: Any) -> Matrix:
    path = (*path, "matrix")
    found = reader.matrix(path, part.matrix)
    if found is None:
        return IDENTITY
    (x, y, z), values = found
    if values:
        _orthonormal(reader, path, list(zip(*values, strict=True)))
    return x, y, z


def _orthonormal(reader: "Reader", path: Path, columns: list[Vector]) -> None:
    """Report axes that are not of unit length, not perpendicular or left-handed."""
    errors = []
    for i in range(3):
        for j in range(i, 3):
            product = reader.value(dot(columns[i], columns[j]))
            errors.append(abs((product or 0.0) - (i == j)))
    if not all(error <= ORTHONORMAL for error in errors):
        message = (
            "must be orthonormal: the products of its columns deviate by "
            f"{max(errors):.3g} from those of unit vectors at right angles"
        )
        help = f"give at least {-round(math.log10(ORTHONORMAL))} digits, or an axis and an angle"
        reader.draft.error(path, message, help)
        return
    (a, b, c), (d, e, f), (g, h, i) = columns
    determinant = a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
    if isinstance(determinant, float) and determinant < 0.0:
        message = "a left-handed set of axes: a mirror, not a rotation"
        reader.draft.error(path, message, "turn the sign of one column")


_READERS = {
    "axis": _about_an_axis,
    "quaternion": _quaternion,
    "rotation_vector": _rotation_vector,
    "matrix": _given_matrix,
}
