"""Joints between two bodies, and all types of joints: where they are drawn, what they offer.

Places and axes are those of the drawn configuration, in global axes. Angles and displacements of
joints are zero as drawn; forces and torques are those on the second body.
"""

import math
from collections.abc import Collection
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal

from solver.scene import fields as kind
from solver.scene.couplings import (
    ALIGNED,
    AXIS,
    NORMAL,
    ConstantAngle,
    Distance,
    Ends,
    Gear,
    Pair,
    PointOnLine,
    PointOnPlane,
    PointOnSurface,
    Rack,
    Rolling,
    cosine_of,
    force_on,
    only_in_space,
)
from solver.scene.expression import Number, Vector
from solver.scene.fields import Part
from solver.scene.friction import (
    ABOUT,
    ALONG,
    FRICTION,
    FRICTION_ALONG,
    FRICTION_ON_A_JOURNAL,
    JointFriction,
)
from solver.scene.joint_springs import (
    DAMPING_ABOUT,
    DAMPING_ALONG,
    DAMPING_OF,
    FIELD_OF,
    FREE_ANGLE,
    FREE_DISPLACEMENT,
    OF,
    SPRING_ABOUT,
    SPRING_ALONG,
    STIFFNESS_ABOUT,
    STIFFNESS_ALONG,
    STIFFNESS_OF,
    check_springs,
    given_fields,
)
from solver.scene.mistakes import Path
from solver.scene.quantities import ROTATION, ROTATION_IN_SPACE, Offer, angular_acceleration
from solver.scene.rules import NOT_ZERO

if TYPE_CHECKING:
    from solver.scene.references import Reader

ANGLE = (
    Offer("angle", "rad", "angle of {name}, zero as drawn, unwrapped", "position"),
    Offer("angular_velocity", "rad/s", "angular velocity of {name}", "rate"),
    angular_acceleration(),
)
DISPLACEMENT = (
    Offer("displacement", "m", "displacement of {name}, zero as drawn", "position"),
    Offer("velocity", "m/s", "velocity along {name}", "rate"),
    Offer("acceleration", "m/s2", "acceleration along {name}", "acceleration", on_demand=True),
)
_TORQUE_TEXT = "torque of {name} on its second body, about the joint's place, {axis} component"
TORQUE = Offer("torque.{}", "N.m", _TORQUE_TEXT, axes=ROTATION)
TORQUE_IN_SPACE = Offer("torque.{}", "N.m", _TORQUE_TEXT, axes=ROTATION_IN_SPACE)


FORCE = force_on("its second body")


_PLACE = kind.Components("m", "place of the joint as drawn", example=[0, 0, 0])
_PLACE_OR_ORIGIN = kind.Components("m", "place of the joint as drawn; origin of the second body")


@dataclass(frozen=True, slots=True, kw_only=True)
class BodyJoint(Part):
    """A lower pair between two bodies, or two points that coincide."""

    meets: ClassVar[bool] = False
    """Whether a place of one body and one of the other are the same, at the position."""
    takes_points: ClassVar[bool] = False
    """Whether it may join two points instead of two bodies."""
    rubs: ClassVar[tuple[Offer, ...]] = ()
    """What it offers if it has friction."""
    springs: ClassVar[tuple[Offer, ...]] = ()
    """What it offers if it has a spring and a damper."""

    bodies: Annotated[Pair | None, kind.TWO_BODIES]
    position: Annotated[Vector | None, _PLACE]
    axis: Vector | None = None
    """Fixed in the first body."""
    points: Ends | None = None
    """Instead of `bodies` and `position`."""
    on: Pair = (None, None)
    """Named points of the two bodies that `position` means, since it lies there: "rod.tip"."""
    friction: JointFriction | None = None
    stiffness: Number | None = None
    damping: Number | None = None
    free_angle: Number | None = None
    free_displacement: Number | None = None
    of: str | None = None
    """"angle" or "displacement" of a joint with both."""

    @property
    def springs_along(self) -> bool:
        """Whether its spring and damper act along it, and not about its axis."""
        return self.of == "displacement" or not self.has("angle")

    @classmethod
    def offered(cls, given: Collection[str]) -> tuple[Offer, ...]:
        """Points that are one have a force between them and nothing else."""
        joins_points = "points" in given and "bodies" not in given
        if joins_points and cls.takes_points:
            return (FORCE,)
        springs = (offer for offer in cls.springs if FIELD_OF[offer.word] in given)
        return (*cls.offers, *(cls.rubs if "friction" in given else ()), *springs)

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
        check_springs(reader, path, given, both=cls.has("angle") and cls.has("displacement"))
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
    for field in given_fields(given):
        help = "give it 'bodies' and 'position' instead of 'points'"
        reader.draft.error((*path, field), "a joint of points has no angle", help)
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


@dataclass(frozen=True, slots=True, kw_only=True)
class SharedPoint(BodyJoint):
    """Two bodies share a point; or two points are one."""

    rubs = ABOUT
    meets = takes_points = True

    bodies: Annotated[Pair | None, kind.TWO_BODIES] = None
    position: Annotated[Vector | None, _PLACE] = None
    points: Annotated[Ends | None, kind.TWO_ENDS] = None
    friction: Annotated[JointFriction | None, FRICTION] = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Spherical(SharedPoint):
    """Two bodies share a point; or two points are one."""

    type = "spherical"
    offers = (FORCE,)
    only_in = (3, "in the plane 'revolute' lets two bodies share a point")


@dataclass(frozen=True, slots=True, kw_only=True)
class Revolute(SharedPoint):
    """A hinge; in the plane two bodies share a point, or two points are one."""

    type = "revolute"
    offers = (*ANGLE, FORCE, TORQUE_IN_SPACE)
    springs = SPRING_ABOUT

    axis: Annotated[
        Vector | None,
        kind.Direction(
            text="direction as drawn, of any length; only in 3-D", example=[0, 0, 1],
            reading=only_in_space("a revolute joint in the plane has no axis: it turns about z"),
        ),
    ] = None  # fmt: skip
    stiffness: Annotated[Number | None, STIFFNESS_ABOUT] = None
    damping: Annotated[Number | None, DAMPING_ABOUT] = None
    free_angle: Annotated[Number | None, FREE_ANGLE] = None

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
        cosine = cosine_of(reader, self.axes)
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
    springs = SPRING_ABOUT
    only_in = (3, "in the plane write 'prismatic', or 'point_on_line' for a pin in a slot")

    axis: Annotated[Vector | None, AXIS] = None
    friction: Annotated[JointFriction | None, FRICTION_ON_A_JOURNAL] = None
    stiffness: Annotated[Number | None, STIFFNESS_OF] = None
    damping: Annotated[Number | None, DAMPING_OF] = None
    of: Annotated[Literal["angle", "displacement"] | None, OF] = None
    free_angle: Annotated[Number | None, FREE_ANGLE] = None
    free_displacement: Annotated[Number | None, FREE_DISPLACEMENT] = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Prismatic(BodyJoint):
    """The second body slides along an axis of the first without turning."""

    type = "prismatic"
    offers = (*DISPLACEMENT, FORCE, TORQUE)
    rubs = ALONG
    springs = SPRING_ALONG

    position: Annotated[Vector | None, _PLACE_OR_ORIGIN] = None
    axis: Annotated[Vector | None, AXIS] = None
    friction: Annotated[JointFriction | None, FRICTION_ALONG] = None
    stiffness: Annotated[Number | None, STIFFNESS_ALONG] = None
    damping: Annotated[Number | None, DAMPING_ALONG] = None
    free_displacement: Annotated[Number | None, FREE_DISPLACEMENT] = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Planar(BodyJoint):
    """The second body slides on a plane of the first."""

    type = "planar"
    offers = (FORCE, TORQUE)
    only_in = (3, "in the plane it has no effect: leave it out")

    axis: Annotated[Vector | None, NORMAL] = None


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
    springs = SPRING_ABOUT
    only_in = (3, "in the plane write 'rack'")

    axis: Annotated[Vector | None, AXIS] = None
    pitch: Annotated[Number, kind.Quantity("m", "per turn", rule=NOT_ZERO, example=0.005)]
    """Advance of the second body."""
    stiffness: Annotated[Number | None, STIFFNESS_OF] = None
    damping: Annotated[Number | None, DAMPING_OF] = None
    of: Annotated[Literal["angle", "displacement"] | None, OF] = None
    free_angle: Annotated[Number | None, FREE_ANGLE] = None
    free_displacement: Annotated[Number | None, FREE_DISPLACEMENT] = None


JOINTS: dict[str, type[Part]] = {
    joint.type: joint
    for joint in (
        *(Distance, Spherical, Revolute, Universal, Cylindrical, Prismatic, Planar, Fixed),
        *(PointOnLine, PointOnPlane, PointOnSurface, ConstantAngle, Gear, Rack, Screw, Rolling),
    )
}
"""Types of joints."""
