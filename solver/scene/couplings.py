"""Couplings of a scene: rods, points on lines and surfaces, angles, gears, racks and rolling discs.

Places and axes are those of the drawn configuration, in global axes. Forces and torques are those
on the second body, the point or the disc.
"""

import math
from collections.abc import Collection
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Any, TypeAlias

from solver.scene import fields as kind
from solver.scene.expression import Number, Vector, curves_of
from solver.scene.fields import BROKEN, Part, PointReference
from solver.scene.mistakes import Path
from solver.scene.profiles import check_smooth
from solver.scene.quantities import CONTACT, VECTOR, Offer, turning
from solver.scene.rules import COORDINATES, NOT_ZERO, POSITIVE, PROPERTY, SHARE, Place

if TYPE_CHECKING:
    from solver.scene.references import Reader

ALIGNED = 1e-6
"""Sine of an angle below which directions count as parallel, and its cosine as perpendicular."""

Ends: TypeAlias = tuple[PointReference, PointReference]
Pair: TypeAlias = tuple[str | None, str | None]
"""Names of two rigid bodies (in the plane also of bars); None is the ground."""

AXIS = kind.Direction(text="direction as drawn, of any length", example=[0, 0, 1], required=True)
NORMAL = kind.Direction(text="normal of the plane, as drawn", example=[0, 0, 1], required=True)


def force_on(what: str) -> Offer:
    """Return the force on what a joint holds."""
    return Offer("force.{}", "N", f"force of {{name}} on {what}, {{axis}} component", axes=VECTOR)


def _on_the_second(word: str, unit: str) -> tuple[Offer]:
    return (Offer(word, unit, f"{word} of {{name}} on the motion of its second part"),)


def only_in_space(message: str) -> kind.Reading:
    """Return the reading of an axis that is a mistake in the plane."""

    def read(reader: "Reader", path: Path, value: Any, _: Any) -> Vector | None:
        if reader.dimension != 2:
            return reader.axis(path, value)
        reader.draft.error(path, message, "leave it out")
        return None

    return read


def cosine_of(reader: "Reader", axes: tuple[Vector, Vector]) -> float | None:
    """Cosine of the angle between two directions; None where one has no direction."""
    first, second = (reader.values(axis) for axis in axes)
    if not first or not second or len(first) != len(second):
        return None
    lengths = math.hypot(*first) * math.hypot(*second)
    if not 0.0 < lengths < math.inf:
        return None
    cosine = math.fsum(x * y for x, y in zip(first, second, strict=True)) / lengths
    return max(-1.0, min(1.0, cosine))


@dataclass(frozen=True, slots=True, kw_only=True)
class Distance(Part):
    """A massless rod: two points keep their distance."""

    type = "distance"
    offers = (
        Offer(
            "force",
            "N",
            "force in joint '{name}', positive in tension: it pulls its points together",
        ),
    )

    points: Annotated[Ends, kind.TWO_ENDS]
    length: Annotated[Number | None, kind.Quantity("m", "as drawn unless given", POSITIVE)] = None


# ------------------------------------------------------------------------------- of one point


def check_point_and_body(
    reader: "Reader", path: Path, reference: PointReference, body: str | None, given: Any,
    field: str = "point",
) -> None:  # fmt: skip
    """Check that a point is none of a body, `given` in the file, and that one of them can move."""
    point, where = reference.point, (*path, field)
    if point in reader.fixed and given in (None, "ground"):
        reader.draft.error(where, f"the point '{point}' is fixed, and so is the ground")
    if body is not None and point and reader.owner(point) == body:
        reader.draft.error(where, f"'{point}' is a point of the body '{body}' itself")


@dataclass(frozen=True, slots=True, kw_only=True)
class PointOn(Part):
    """A point stays on a line, a plane or a surface that a body carries."""

    offers = (force_on("the point"),)

    point: Annotated[PointReference, kind.ONE_END]
    body: Annotated[str | None, kind.BODY_OR_GROUND] = None

    def check(self, reader: "Reader", path: Path, given: Any) -> None:
        """Check that the point is none of the body, and that one of the two can move."""
        check_point_and_body(reader, path, self.point, self.body, given.body)


def read_surface(reader: "Reader", path: Path, value: Any, _: Any) -> Number:
    """Check that an expression depends on the coordinates of a point."""
    own = COORDINATES[: reader.dimension or 3]
    number = reader.number(path, value, Place(tunable=False, own=own))
    if value is not BROKEN and not any(mention.name in own for mention in value.mentions):
        message = f"mentions none of the coordinates {', '.join(own)} of the point"
        reader.draft.error(path, message, "write an expression that is 0 on the surface")
    check_smooth(reader.draft, path, reader.profiles, sorted(curves_of(number)))
    return number


@dataclass(frozen=True, slots=True, kw_only=True)
class PointOnLine(PointOn):
    """A point stays on a line of a body."""

    type = "point_on_line"

    position: Annotated[Vector | None, kind.Components("m", "a place of the line as drawn")] = None
    """None: where the point is drawn."""
    axis: Annotated[Vector, AXIS]


@dataclass(frozen=True, slots=True, kw_only=True)
class PointOnPlane(PointOn):
    """A point stays on a plane of a body."""

    type = "point_on_plane"
    only_in = (3, "in the plane write 'point_on_line'")

    position: Annotated[Vector | None, kind.Components("m", "a place of the plane as drawn")] = None
    axis: Annotated[Vector, NORMAL]


@dataclass(frozen=True, slots=True, kw_only=True)
class PointOnSurface(PointOn):
    """A point stays on a surface F(x, y, z) = 0 of a body; in the plane on a curve F(x, y) = 0.

    The coordinates are those in the axes of the body, from its origin.
    """

    type = "point_on_surface"

    surface: Annotated[
        Number,
        kind.Quantity(
            text="zero on the surface, in body axes",
            example="x**2 + y**2 - 1",
            reading=read_surface,
        ),
    ]


# ----------------------------------------------------------------------- of bodies and joints


@dataclass(frozen=True, slots=True, kw_only=True)
class ConstantAngle(Part):
    """The angle between an axis of one body and one of another is constant."""

    type = "angle"
    offers = _on_the_second("torque", "N.m")
    only_in = (3, "in the plane write 'prismatic', which keeps the angle of two bodies")

    bodies: Annotated[Pair, kind.TWO_BODIES]
    axes: Annotated[tuple[Vector, Vector], kind.TWO_AXES]
    value: Annotated[Number | None, kind.Quantity("rad", "as drawn unless given")] = None

    def check(self, reader: "Reader", path: Path, given: Any) -> None:  # noqa: ARG002
        """Check that the axes are not parallel, where the joint is singular."""
        value, cosine = self.value, cosine_of(reader, self.axes)
        angle = None if value is None else reader.value(value)
        help = "for parallel axes write 'prismatic', 'cylindrical' or 'planar'"
        if angle is not None and not (ALIGNED < angle < math.pi - ALIGNED):
            if angle > math.pi:
                help = f'if these are degrees, write "{angle:.12g} deg"'
            message = f"must be > 0 and < pi rad, where the joint is singular, got {angle:.15g}"
            reader.draft.error((*path, "value"), message, help)
        elif value is None and cosine is not None and 1.0 - abs(cosine) < 0.5 * ALIGNED**2:
            message = "the axes are parallel as drawn, where the joint is singular"
            reader.draft.error((*path, "axes"), message, help)


def _two_joints(second: str) -> kind.ListOf:
    """Return the kind of names of two joints, the first with an angle."""

    def read(reader: "Reader", path: Path, names: Any, _: Any) -> tuple[str, ...]:
        if names is BROKEN:
            return "", ""
        has = zip(names, ("angle", second), strict=True)
        fine = [reader.joint((*path, i), name, word) for i, (name, word) in enumerate(has)]
        if all(fine) and names[0] == names[1] and second == "angle":
            reader.draft.error(path, f"both joints are '{names[0]}'")
        return tuple(names)

    return kind.ListOf(item=kind.NAME, size=kind.TWO, example=["first", "second"], reading=read)


@dataclass(frozen=True, slots=True, kw_only=True)
class Gear(Part):
    """angle of the second joint = ratio * angle of the first, give or take half the backlash."""

    type = "gear"
    offers = _on_the_second("torque", "N.m")

    joints: Annotated[tuple[str, str], _two_joints("angle")]
    ratio: Annotated[Number, kind.Quantity(text="of the angles", rule=NOT_ZERO, example=-2.0)]
    backlash: Annotated[
        Number | None, kind.Quantity("rad", "turn of the second joint within the play", POSITIVE)
    ] = None
    """None: the teeth have no play, and the gear is a constraint."""
    restitution: Annotated[
        Number,
        kind.Quantity("", "rate after an impact of the teeth over that before", SHARE, PROPERTY),
    ] = 0.0

    @classmethod
    def offered(cls, given: Collection[str]) -> tuple[Offer, ...]:
        """One with backlash is a contact, too."""
        return (*cls.offers, *(turning(CONTACT) if "backlash" in given else ()))

    def check(self, reader: "Reader", path: Path, given: Any) -> None:
        """Check that teeth that rebound have play."""
        if given.restitution is not None and given.backlash is None:
            message = "has no effect without backlash: teeth without play never part"
            reader.draft.error((*path, "restitution"), message, "write backlash = 0.01")


@dataclass(frozen=True, slots=True, kw_only=True)
class Rack(Part):
    """displacement of the second joint = radius * angle of the first."""

    type = "rack"
    offers = _on_the_second("force", "N")

    joints: Annotated[tuple[str, str], _two_joints("displacement")]
    radius: Annotated[Number, kind.Quantity("m", "of the pinion", NOT_ZERO, example=0.1)]


@dataclass(frozen=True, slots=True, kw_only=True)
class Rolling(Part):
    """A thin disc rolls without slip on a plane; in the plane on a line."""

    type = "rolling"
    offers = (force_on("the disc"),)

    body: Annotated[str, kind.Plain(example="wheel")]
    """Its origin is the centre of the disc."""
    radius: Annotated[Number, kind.Quantity("m", rule=POSITIVE, example=0.1)]
    axis: Annotated[
        Vector | None,
        kind.Direction(
            text="of the disc; only in 3-D", example=[0, 1, 0],
            reading=only_in_space("a disc in the plane has no axis: it turns about z"),
        ),
    ] = None  # fmt: skip
    position: Annotated[Vector | None, kind.Components("m", "a place of the plane; the origin")] = (
        None
    )
    normal: Annotated[Vector | None, kind.Direction(text="towards the disc; +z, in 2-D +y")] = None

    def check(self, reader: "Reader", path: Path, given: Any) -> None:
        """Check that the body can roll, about an axis in space."""
        draft, body = reader.draft, given.body
        if body is not BROKEN and reader.known.parts.get(body) == "bar":
            draft.error((*path, "body"), f"'{body}' is a bar, and does not roll")
        elif body is not BROKEN:
            reader.body((*path, "body"), body)
        if reader.dimension != 2 and given.axis is None:
            draft.error(path, "'axis' is missing: that of the disc", "write axis = [0, 1, 0]")
