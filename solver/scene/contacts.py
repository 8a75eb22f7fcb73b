"""Contacts of a scene between points, balls, planes, pins and holes, and the stops of joints."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Any, Literal, TypeAlias

from solver.scene import fields as kind
from solver.scene.contact_laws import RubbingContact
from solver.scene.couplings import check_point_and_body
from solver.scene.expression import Number, Vector
from solver.scene.fields import BROKEN, Part, PointReference
from solver.scene.joints import Pair as BodyPair
from solver.scene.mistakes import Path
from solver.scene.places import SAME
from solver.scene.rules import DRIVER, NOT_NEGATIVE, POSITIVE, PROPERTY

if TYPE_CHECKING:
    from solver.scene.references import Reader

Ends: TypeAlias = tuple[PointReference, PointReference]

THINNEST = 1e-9
"""Shortest length of a shape, over its longest one: squares of both still add up."""
TOWARDS_THE_BODY = kind.Direction(
    text="normal of the plane, towards the body", example=[0, 0, 1], required=True
)
PLACE_OF_PLANE = kind.Components("m", "a place of the plane as drawn; the origin")
SURFACE_VELOCITY = kind.Components(
    "m/s", "of the surface along the plane, in axes as drawn, as of a belt", place=DRIVER
)


@dataclass(frozen=True, slots=True, kw_only=True)
class PlaneContact(RubbingContact):
    """A point or ball on one side of a plane, in 2-D of a line, that a body carries."""

    type = "plane"

    point: Annotated[PointReference, kind.ONE_END]
    axis: Annotated[
        Vector,
        kind.Direction(
            text="normal of the plane, towards the point", example=[0, 0, 1], required=True
        ),
    ]
    position: Annotated[Vector | None, PLACE_OF_PLANE] = None
    body: Annotated[str | None, kind.BODY_OR_GROUND] = None
    radius: Annotated[Number, kind.Quantity("m", "of a ball about the point", NOT_NEGATIVE)] = 0.0
    surface_velocity: Annotated[Vector | None, SURFACE_VELOCITY] = None

    def check(self, reader: "Reader", path: Path, given: Any) -> None:
        """Check that the point is none of the body, and that a moving surface rubs."""
        RubbingContact.check(self, reader, path, given)
        check_point_and_body(reader, path, self.point, self.body, given.body)
        check_surface_velocity(reader, path, given)


def check_surface_velocity(reader: "Reader", path: Path, given: Any) -> None:
    """Report a moving surface that does not rub."""
    if given.surface_velocity is not None and given.friction is None:
        message = "has no effect without friction"
        help = "write friction = ..., or leave it out"
        reader.draft.error((*path, "surface_velocity"), message, help)


def read_corners(reader: "Reader", path: Path, corners: Any, _: Any) -> tuple[Vector, ...]:
    """Check that each corner is a place, and that there are some."""
    if corners is BROKEN:
        return ()
    if not corners:
        reader.draft.error(path, "must have at least one corner, got none")
    return tuple(reader.vector((*path, i), corner) for i, corner in enumerate(corners))


def read_carrier(reader: "Reader", path: Path, name: Any, _: Any) -> str:
    """Check that what has corners or rims is a rigid body."""
    if name is BROKEN:
        return ""
    if reader.known.parts.get(name) == "bar":
        message, help = f"the bar '{name}' has points for corners", 'write type = "plane" for each'
        reader.draft.error(path, message, help)
    else:
        reader.body(path, name)
    return name


@dataclass(frozen=True, slots=True, kw_only=True)
class CornersContact(RubbingContact):
    """Corners of a body on one side of a plane: of a polygon, a box, a capsule with a radius."""

    type = "corners"
    may_be_compliant = False

    body: Annotated[str, kind.Plain(example="block", reading=read_carrier)]
    corners: Annotated[
        tuple[Vector, ...],
        kind.ListOf(
            "m", "in axes of the body, from its origin", item=kind.COMPONENTS,
            example=[[0, 0, 0], [1, 0, 0]], reading=read_corners,
        ),
    ] = ()  # fmt: skip
    size: Annotated[
        Vector | None,
        kind.Components(
            "m", "instead of corners: lengths of a box about the origin of the body", rule=POSITIVE
        ),
    ] = None
    axis: Annotated[Vector, TOWARDS_THE_BODY]
    position: Annotated[Vector | None, PLACE_OF_PLANE] = None
    on: Annotated[str | None, kind.BODY_OR_GROUND] = None
    """The body that carries the plane."""
    radius: Annotated[
        Number, kind.Quantity("m", "of the corners, as of a capsule", NOT_NEGATIVE)
    ] = 0.0
    surface_velocity: Annotated[Vector | None, SURFACE_VELOCITY] = None

    def check(self, reader: "Reader", path: Path, given: Any) -> None:
        """Check that the plane is another body's, and that a moving surface rubs."""
        RubbingContact.check(self, reader, path, given)
        if (given.corners is None) == (given.size is None):
            message = "neither 'corners' nor 'size' is given"
            if given.size is not None:
                message = "either 'corners' or 'size' is possible, not both"
            reader.draft.error(path, message, "write size = [...] for a box, or its corners")
        if self.size is not None and given.size is not BROKEN:
            check_size(reader, (*path, "size"), self.size)
        if self.on is not None and self.on == self.body:
            reader.draft.error((*path, "on"), f"the corners are those of '{self.on}' itself")
        check_surface_velocity(reader, path, given)


def check_size(reader: "Reader", path: Path, size: Vector) -> None:
    """Report lengths that are not positive, or nothing beside the others."""
    values = [reader.value(length) for length in size]
    longest = max((x for x in values if x is not None), default=0.0)
    least = max(SAME, THINNEST * longest)
    for i, value in enumerate(values):
        if value is not None and not value > 0.0:
            reader.draft.error((*path, i), f"must be > 0 m, got {value:.15g}")
        elif value is not None and not value >= least:
            message = f"must be >= {least:.6g} m, {THINNEST:g} of the longest one, got {value:.6g}"
            if least == SAME:
                message = f"must be >= {least:g} m, got {value:.6g}"
            reader.draft.error((*path, i), message, "make the shape thicker")


def is_same_place(one: Sequence[float], two: Sequence[float]) -> bool:
    """Whether places are the same but for round-off, of their coordinates or of 1 m."""
    return math.dist(one, two) <= SAME * max(1.0, *map(abs, one), *map(abs, two))


def read_radii(reader: "Reader", path: Path, radii: Any, _: Any) -> tuple[Number, ...]:
    """Check the radii of both balls, of which one may be a point."""
    if radii is BROKEN:
        return 1.0, 1.0
    found = tuple(
        reader.number((*path, i), radius, rule=NOT_NEGATIVE, unit="m")
        for i, radius in enumerate(radii)
    )
    if reader.values(found) == [0.0, 0.0]:
        reader.draft.error(path, "both are 0: two points never touch", "give one ball a radius")
    return found


@dataclass(frozen=True, slots=True, kw_only=True)
class SphereContact(RubbingContact):
    """Two balls, in 2-D discs, about two points."""

    type = "sphere"

    points: Annotated[Ends, kind.TWO_ENDS]
    radii: Annotated[
        tuple[Number, Number],
        kind.ListOf("m", "of each", example=[0.1, 0.1], size=kind.TWO, reading=read_radii),
    ]


@dataclass(frozen=True, slots=True, kw_only=True)
class ClearanceContact(RubbingContact):
    """A pin in a hole with play, in 3-D a ball in a socket: its centre stays in the clearance."""

    type = "clearance"

    points: Annotated[Ends, kind.TWO_ENDS]
    """Centre of the pin, and of the hole."""
    radius: Annotated[
        Number,
        kind.Quantity("m", "the clearance: of the hole less of the pin", POSITIVE, example=1e-4),
    ]
    pin_radius: Annotated[
        Number, kind.Quantity("m", "of the pin, the arm of the friction", NOT_NEGATIVE)
    ] = 0.0


@dataclass(frozen=True, slots=True, kw_only=True)
class JournalContact(RubbingContact):
    """A journal in a bearing with play: its two ends stay in the clearance, and it may tilt."""

    type = "journal"
    may_be_compliant = False
    only_in = (3, "in the plane write 'clearance'")

    bodies: Annotated[BodyPair, kind.TWO_BODIES]
    """That of the bearing, and that of the journal."""
    position: Annotated[Vector, kind.Components("m", "middle of both as drawn")]
    axis: Annotated[Vector, kind.Direction(text="of both as drawn", example=[0, 0, 1])]
    length: Annotated[Number, kind.Quantity("m", "of the bearing", POSITIVE, example=0.1)]
    radius: Annotated[
        Number,
        kind.Quantity("m", "the clearance: of the hole less of the journal", POSITIVE,
                      example=1e-4),
    ]  # fmt: skip
    pin_radius: Annotated[
        Number, kind.Quantity("m", "of the journal, the arm of the friction", NOT_NEGATIVE)
    ] = 0.0
    axial_play: Annotated[
        Number | None,
        kind.Quantity("m", "way to the stop along the axis, either way", POSITIVE, example=1e-4),
    ] = None
    """None: it slides along its axis without end."""
    collar_radius: Annotated[
        Number,
        kind.Quantity("m", "of the faces of these stops, the arm of their friction", NOT_NEGATIVE),
    ] = 0.0

    def check(self, reader: "Reader", path: Path, given: Any) -> None:
        """Check that a collar has stops, and rubs."""
        RubbingContact.check(self, reader, path, given)
        for name, what in (("axial_play", "a stop"), ("friction", "friction")):
            if given.collar_radius is not None and getattr(given, name) is None:
                help = f"write {name} = ..., or leave it out"
                reader.draft.error((*path, "collar_radius"), f"has no effect without {what}", help)


def _joint(reader: "Reader", path: Path, name: Any, _: Any) -> str:
    reader.joint(path, name, "angle", "displacement")
    return "" if name is BROKEN else name


@dataclass(frozen=True, slots=True, kw_only=True)
class Stop(RubbingContact):
    """An end of the angle or displacement of a joint, or of the distance of two points (a rope).

    It rubs where a joint turns about the axis along which it is stopped.
    """

    type = "stop"

    joint: Annotated[str | None, kind.Plain(example="bearing", reading=_joint)] = None
    of: Annotated[
        Literal["angle", "displacement"] | None,
        kind.Choice(text="of the joint, if it has both", words=("angle", "displacement")),
    ] = None
    """None where `points` is given; else what of the joint is limited."""
    points: Annotated[Ends | None, kind.TWO_ENDS] = None
    min: Annotated[
        Number | None,
        kind.Quantity("rad or m", "least angle, displacement or distance", place=PROPERTY),
    ] = None
    max: Annotated[
        Number | None,
        kind.Quantity("rad or m", "largest angle, displacement or distance", place=PROPERTY),
    ] = None

    radius: Annotated[
        Number, kind.Quantity("m", "of the stop's face, the arm of its friction", NOT_NEGATIVE)
    ] = 0.0

    @property
    def turns(self) -> bool:
        """Whether it limits an angle."""
        return self.of == "angle"

    @classmethod
    def read(cls, reader: "Reader", path: Path, given: Any) -> Any:
        """Find out what of the joint is limited, where the joint has only one of the two."""
        values = reader.fields(cls, path, given)
        if given.joint not in (None, BROKEN):
            offered = [word for word in ("angle", "displacement") if reader.has(given.joint, word)]
            if given.of is None and len(offered) == 1:
                values["of"] = offered[0]
            elif given.of is None and len(offered) == 2:
                message = f"'of' is missing: '{given.joint}' has an angle and a displacement"
                help = 'write of = "angle" or of = "displacement"'
                reader.draft.error(path, message, help)
            elif given.of not in (None, BROKEN) and offered and given.of not in offered:
                reader.joint((*path, "joint"), given.joint, given.of)
        stop = cls(**values)
        stop.check(reader, path, given)
        return stop

    def check(self, reader: "Reader", path: Path, given: Any) -> None:
        """Check that it limits one thing, at an end at least, which the drawing does not pass."""
        RubbingContact.check(self, reader, path, given)
        self._check_friction(reader, path, given)
        draft = reader.draft
        if (given.joint is None) == (given.points is None):
            message = "neither 'joint' nor 'points' is given"
            if given.joint is not None:
                message = "either 'joint' or 'points' is possible, not both"
            help = 'write joint = "...", or points = [...] for the distance of two points'
            draft.error(path, message, help)
        if given.points is not None and given.of is not None:
            message = "a stop of two points limits their distance"
            draft.error((*path, "of"), message, "leave it out")
        if given.min is None and given.max is None:
            draft.error(path, "neither 'min' nor 'max' is given", "give one or both")
        low, high = (x if x is None else reader.value(x) for x in (self.min, self.max))
        for name, value in (("min", low), ("max", high)):
            reader.in_unit((*path, name), getattr(given, name), "rad" if self.turns else "m")
            if self.turns and value is not None:
                reader.advise_radians((*path, name), getattr(given, name), value)
        if low is not None and high is not None and not low < high:
            message = f"must be < max = {high:.15g}, got {low:.15g}"
            draft.error((*path, "min"), message)
        elif given.points is None and given.joint is not None:
            unit, what = ("rad" if self.turns else "m"), self.of or "angle"
            for name, value, sign in (("min", low, -1.0), ("max", high, 1.0)):
                if value is not None and sign * value < -SAME:
                    rule = "<= 0" if name == "min" else ">= 0"
                    message = f"must be {rule} {unit}, got {value:.15g}: the {what} is 0 as drawn"
                    help = "draw the joint within its stops, or measure them from the drawing"
                    draft.error((*path, name), message, help)

    def _check_friction(self, reader: "Reader", path: Path, given: Any) -> None:
        """Report friction where nothing turns at the stop, and what has none of it."""
        error = reader.draft.error
        if given.friction is None:
            if given.radius is not None:
                message = "has no effect without friction"
                error((*path, "radius"), message, "write friction = ..., or leave it out")
            return
        if self.turns or given.joint is None or not reader.has(self.joint or "", "angle"):
            message = "a stop rubs only along the axis of a joint that turns about it"
            help = 'leave it out; a cylindrical joint has such stops, of = "displacement"'
            error((*path, "friction"), message, help)
        elif given.radius is None:
            message = "'radius' is missing: the mean radius of the faces that rub"
            error(path, message, "write radius = ...")


CONTACTS: dict[str, type[Part]] = {
    contact.type: contact
    for contact in (
        PlaneContact,
        CornersContact,
        SphereContact,
        ClearanceContact,
        JournalContact,
        Stop,
    )
}
"""Types of contacts."""
