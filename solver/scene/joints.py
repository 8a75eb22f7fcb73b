"""Joints of a scene: what they join, where and along which axes, and what they offer.

Places and axes are those of the drawn configuration, in global axes. Angles and displacements of
joints are zero as drawn; forces and torques are those on the second body, the point or the disc.
"""

import math
from collections.abc import Collection
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, TypeAlias

from solver.scene import fields as kind
from solver.scene.expression import Number, Vector
from solver.scene.fields import BROKEN, Part, PointReference
from solver.scene.friction import ABOUT, ALONG, FRICTION, FRICTION_ALONG, JointFriction
from solver.scene.quantities import (
    CONTACT,
    ROTATION,
    ROTATION_IN_SPACE,
    VECTOR,
    Offer,
    turning,
)
from solver.scene.report import Path
from solver.scene.rules import NOT_ZERO, POSITIVE, PROPERTY, SHARE, Place

if TYPE_CHECKING:
    from solver.scene.references import Reader

ALIGNED = 1e-6
"""Sine of an angle below which directions count as parallel, and its cosine as perpendicular."""

ANGLE = (
    Offer("angle", "rad", "angle of {name}, zero as drawn, unwrapped", "position"),
    Offer("angular_velocity", "rad/s", "angular velocity of {name}", "rate"),
)
DISPLACEMENT = (
    Offer("displacement", "m", "displacement of {name}, zero as drawn", "position"),
    Offer("velocity", "m/s", "velocity along {name}", "rate"),
)
_TORQUE_TEXT = "torque of {name} on its second body, about the joint's place, {axis} component"
TORQUE = Offer("torque.{}", "N.m", _TORQUE_TEXT, axes=ROTATION)
TORQUE_IN_SPACE = Offer("torque.{}", "N.m", _TORQUE_TEXT, axes=ROTATION_IN_SPACE)


def _force_on(what: str) -> Offer:
    return Offer("force.{}", "N", f"force of {{name}} on {what}, {{axis}} component", axes=VECTOR)


def _on_the_second(word: str, unit: str) -> tuple[Offer]:
    return (Offer(word, unit, f"{word} of {{name}} on the motion of its second part"),)


FORCE = _force_on("its second body")


def _only_in_space(message: str) -> kind.Reading:
    """Return the reading of an axis that is a mistake in the plane."""

    def read(reader: "Reader", path: Path, value: Any, _: Any) -> Vector | None:
        if reader.dimension != 2:
            return reader.axis(path, value)
        reader.draft.error(path, message, "leave it out")
        return None

    return read


Ends: TypeAlias = tuple[PointReference, PointReference]
Pair: TypeAlias = tuple[str | None, str | None]
"""Names of two rigid bodies (in the plane also of bars); None is the ground."""

_PLACE = kind.Components("m", "place of the joint as drawn", example=[0, 0, 0])
_PLACE_OR_ORIGIN = kind.Components("m", "place of the joint as drawn; origin of the second body")
_AXIS = kind.Direction(text="direction as drawn, of any length", example=[0, 0, 1], required=True)
_NORMAL = kind.Direction(text="normal of the plane, as drawn", example=[0, 0, 1], required=True)


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


# ------------------------------------------------------------------------- joints of two bodies


@dataclass(frozen=True, slots=True, kw_only=True)
class BodyJoint(Part):
    """A lower pair between two bodies, or two points that coincide."""

    meets: ClassVar[bool] = False
    """Whether a place of one body and one of the other are the same, at the position."""
    takes_points: ClassVar[bool] = False
    """Whether it may join two points instead of two bodies."""
    rubs: ClassVar[tuple[Offer, ...]] = ()
    """What it offers if it has friction."""

    bodies: Annotated[Pair | None, kind.TWO_BODIES]
    position: Annotated[Vector | None, _PLACE]
    axis: Vector | None = None
    """Fixed in the first body."""
    points: Ends | None = None
    """Instead of `bodies` and `position`."""
    on: Pair = (None, None)
    """Named points of the two bodies that `position` means, since it lies there: "rod.tip"."""
    friction: JointFriction | None = None

    @classmethod
    def offered(cls, given: Collection[str]) -> tuple[Offer, ...]:
        """Points that are one have a force between them and nothing else."""
        joins_points = "points" in given and "bodies" not in given
        if joins_points and cls.takes_points:
            return (FORCE,)
        return (*cls.offers, *(cls.rubs if "friction" in given else ()))

    @classmethod
    def read(cls, reader: "Reader", path: Path, given: Any) -> Any:
        """Check that it joins two bodies at a place, and find their points that are there."""
        how = "write bodies = [...] and position = [...]"
        if getattr(given, "points", None) is not None:
            return cls(**_shared_point(reader, path, given, cls.type, how))
        if given.bodies is None:
            reader.draft.error(path, "'bodies' is missing", how)
        if getattr(given, "at", None) is not None:
            message = "'at' belongs to 'points'; bodies meet at 'position'"
            reader.draft.error((*path, "at"), message)
        values = reader.fields(cls, path, given)
        if given.position is None and given.bodies is not None:
            values["position"] = _origin(reader, values["bodies"])
            if cls.meets and cls is not Fixed:
                help = f"write position = {'[0, 0]' if reader.dimension == 2 else '[0, 0, 0]'}"
                message = "'position' is missing: where the bodies meet"
                reader.draft.error(path, message, help)
        if cls.meets and given.position is not None and given.bodies is not None:
            values["on"] = _named_points(reader, path, cls, values)
        joint = cls(**values)
        joint.check(reader, path, given)
        return joint


def _shared_point(
    reader: "Reader", path: Path, given: Any, type: str, how: str
) -> dict[str, Any]:  # fmt: skip
    """Read two points that become one."""
    if given.bodies is not None:
        message = "either 'points' or 'bodies' is possible, not both"
        reader.draft.error((*path, "bodies"), message, "leave out one of them")
    for field in ("position", "axis"):
        if getattr(given, field, None) is not None:
            message = f"points that become one need no '{field}'"
            reader.draft.error((*path, field), message, "leave it out")
    if type == "revolute" and reader.dimension == 3:
        message = "a revolute joint in space joins bodies, not points"
        reader.draft.error((*path, "points"), message, f'{how}, or type = "spherical"')
    if getattr(given, "friction", None) is not None:
        message = "a joint of points measures no slip"
        help = "give it 'bodies' and 'position' instead of 'points'"
        reader.draft.error((*path, "friction"), message, help)
    return {"points": reader.ends(path, given.points, given.at)}


def _origin(reader: "Reader", pair: Pair) -> Vector:
    """Place of a joint whose position does not matter: the origin of the second body, if any."""
    places = [reader.drawn[name] for name in pair[::-1] if name in reader.drawn]
    return places[0] if places else reader.zero()


def _named_points(
    reader: "Reader", path: Path, joint: type[BodyJoint], values: dict[str, Any]
) -> Pair:
    """Named points of the two bodies that are one at the position of a joint."""
    pair, where = values["bodies"], (*path, "position")
    first, second = (
        reader.point_at(where, body, values["position"]) for body in pair
    )  # fmt: skip
    held = {*reader.fixed, None} if None in pair else {first}
    if (first or second) and {first, second} <= held:
        message = f"the bar ends in the fixed point '{first or second}', which holds it already"
        if None not in pair:
            message = f"both bars end in '{first}', about which they turn already"
        bar = pair[1] or pair[0]
        help = f"leave the joint out: '{bar}' turns about its ends"
        if joint is Fixed:
            help = f'hold its angle instead, by a constraint with value = "{bar}.angle - ..."'
        reader.draft.error(path, message, help)
    return first, second


def _cosine(reader: "Reader", axes: tuple[Vector, Vector]) -> float | None:
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
class Spherical(BodyJoint):
    """Two bodies share a point; or two points are one."""

    type = "spherical"
    offers = (FORCE,)
    rubs = ABOUT
    only_in = (3, "in the plane 'revolute' lets two bodies share a point")
    meets = takes_points = True

    bodies: Annotated[Pair | None, kind.TWO_BODIES] = None
    position: Annotated[Vector | None, _PLACE] = None
    points: Annotated[Ends | None, kind.TWO_ENDS] = None
    friction: Annotated[JointFriction | None, FRICTION] = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Revolute(BodyJoint):
    """A hinge; in the plane two bodies share a point, or two points are one."""

    type = "revolute"
    offers = (*ANGLE, FORCE, TORQUE_IN_SPACE)
    rubs = ABOUT
    meets = takes_points = True

    bodies: Annotated[Pair | None, kind.TWO_BODIES] = None
    position: Annotated[Vector | None, _PLACE] = None
    axis: Annotated[
        Vector | None,
        kind.Direction(
            text="direction as drawn, of any length; only in 3-D", example=[0, 0, 1],
            reading=_only_in_space("a revolute joint in the plane has no axis: it turns about z"),
        ),
    ] = None  # fmt: skip
    points: Annotated[Ends | None, kind.TWO_ENDS] = None
    friction: Annotated[JointFriction | None, FRICTION] = None

    def check(self, reader: "Reader", path: Path, given: Any) -> None:
        """Check that there is an axis in space."""
        if reader.dimension == 3 and given.axis is None:
            reader.draft.error(path, "'axis' is missing", "write axis = [0, 0, 1]")


@dataclass(frozen=True, slots=True, kw_only=True)
class Universal(BodyJoint):
    """A Cardan joint: a cross of two perpendicular axes, one in each body."""

    type = "universal"
    offers = (FORCE, TORQUE)
    only_in = (3, "in the plane bodies turn about one axis only: 'revolute'")
    meets = True

    axes: Annotated[
        tuple[Vector, Vector],
        replace(kind.TWO_AXES, text="axis in the first and in the second body, as drawn"),
    ]

    def __post_init__(self) -> None:
        """The axis of the joint is the one in the first body."""
        object.__setattr__(self, "axis", self.axes[0])

    def check(self, reader: "Reader", path: Path, given: Any) -> None:  # noqa: ARG002
        """Check that the axes are at right angles."""
        cosine = _cosine(reader, self.axes)
        if cosine is not None and abs(cosine) > ALIGNED:
            angle = math.degrees(math.acos(cosine))
            message = f"the two axes must be perpendicular, got {angle:.6g} degrees between them"
            reader.draft.error((*path, "axes"), message)


@dataclass(frozen=True, slots=True, kw_only=True)
class Cylindrical(BodyJoint):
    """The second body turns about an axis of the first and slides along it."""

    type = "cylindrical"
    offers = (*ANGLE, *DISPLACEMENT, FORCE, TORQUE)
    rubs = ALONG
    only_in = (3, "in the plane write 'prismatic', or 'point_on_line' for a pin in a slot")

    axis: Annotated[Vector | None, _AXIS] = None
    friction: Annotated[JointFriction | None, FRICTION] = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Prismatic(BodyJoint):
    """The second body slides along an axis of the first without turning."""

    type = "prismatic"
    offers = (*DISPLACEMENT, FORCE, TORQUE)
    rubs = ALONG

    position: Annotated[Vector | None, _PLACE_OR_ORIGIN] = None
    axis: Annotated[Vector | None, _AXIS] = None
    friction: Annotated[JointFriction | None, FRICTION_ALONG] = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Planar(BodyJoint):
    """The second body slides on a plane of the first."""

    type = "planar"
    offers = (FORCE, TORQUE)
    only_in = (3, "in the plane it has no effect: leave it out")

    axis: Annotated[Vector | None, _NORMAL] = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Fixed(BodyJoint):
    """Two bodies move as one."""

    type = "fixed"
    offers = (FORCE, TORQUE)
    meets = True

    position: Annotated[Vector | None, _PLACE_OR_ORIGIN] = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Screw(BodyJoint):
    """A cylindrical joint whose turning and sliding go together."""

    type = "screw"
    offers = (*ANGLE, *DISPLACEMENT, FORCE, TORQUE)
    only_in = (3, "in the plane write 'rack'")

    axis: Annotated[Vector | None, _AXIS] = None
    pitch: Annotated[Number, kind.Quantity("m per turn", rule=NOT_ZERO, example=0.005)]
    """Advance of the second body."""


# --------------------------------------------------------------------------- joints of one point


def check_point_and_body(
    reader: "Reader", path: Path, reference: PointReference, body: str | None, given: Any
) -> None:
    """Check that a point is none of a body, `given` in the file, and that one of them can move."""
    point, where = reference.point, (*path, "point")
    if point in reader.fixed and given in (None, "ground"):
        reader.draft.error(where, f"the point '{point}' is fixed, and so is the ground")
    if body is not None and point and reader.owner(point) == body:
        reader.draft.error(where, f"'{point}' is a point of the body '{body}' itself")


@dataclass(frozen=True, slots=True, kw_only=True)
class PointOn(Part):
    """A point stays on a line, a plane or a surface that a body carries."""

    offers = (_force_on("the point"),)

    point: Annotated[PointReference, kind.ONE_END]
    body: Annotated[str | None, kind.BODY_OR_GROUND] = None

    def check(self, reader: "Reader", path: Path, given: Any) -> None:
        """Check that the point is none of the body, and that one of the two can move."""
        check_point_and_body(reader, path, self.point, self.body, given.body)


def read_surface(reader: "Reader", path: Path, value: Any, _: Any) -> Number:
    """Check that an expression depends on the coordinates of a point."""
    own = ("x", "y", "z")[: reader.dimension or 3]
    number = reader.number(path, value, Place(tunable=False, own=own))
    if value is not BROKEN and not any(mention.name in own for mention in value.mentions):
        message = f"mentions none of the coordinates {', '.join(own)} of the point"
        reader.draft.error(path, message, "write an expression that is 0 on the surface")
    return number


@dataclass(frozen=True, slots=True, kw_only=True)
class PointOnLine(PointOn):
    """A point stays on a line of a body."""

    type = "point_on_line"

    position: Annotated[Vector | None, kind.Components("m", "a place of the line as drawn")] = None
    """None: where the point is drawn."""
    axis: Annotated[Vector, _AXIS]


@dataclass(frozen=True, slots=True, kw_only=True)
class PointOnPlane(PointOn):
    """A point stays on a plane of a body."""

    type = "point_on_plane"
    only_in = (3, "in the plane write 'point_on_line'")

    position: Annotated[Vector | None, kind.Components("m", "a place of the plane as drawn")] = None
    axis: Annotated[Vector, _NORMAL]


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


# ------------------------------------------------------------------------------ other relations


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
        value, cosine = self.value, _cosine(reader, self.axes)
        angle = None if value is None else reader.value(value)
        help = "for parallel axes write 'prismatic', 'cylindrical' or 'planar'"
        if angle is not None and not (ALIGNED < angle < math.pi - ALIGNED):
            if angle > math.pi:
                help = f'if these are degrees, write "{angle:.12g}*pi/180"'
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
    ratio: Annotated[Number, kind.Quantity(rule=NOT_ZERO, example=-2.0)]
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
    offers = (_force_on("the disc"),)

    body: Annotated[str, kind.Plain(example="wheel")]
    """Its origin is the centre of the disc."""
    radius: Annotated[Number, kind.Quantity("m", rule=POSITIVE, example=0.1)]
    axis: Annotated[
        Vector | None,
        kind.Direction(
            text="of the disc; only in 3-D", example=[0, 1, 0],
            reading=_only_in_space("a disc in the plane has no axis: it turns about z"),
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


JOINTS: dict[str, type[Part]] = {
    joint.type: joint
    for joint in (
        *(Distance, Spherical, Revolute, Universal, Cylindrical, Prismatic, Planar, Fixed),
        *(PointOnLine, PointOnPlane, PointOnSurface, ConstantAngle, Gear, Rack, Screw, Rolling),
    )
}
"""Types of joints."""
