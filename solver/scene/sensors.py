"""Sensors of a scene: what an instrument on a body shows, and one place or body seen from another.

They measure and change nothing. Their values are variables, and may stand in formulas of outputs.
"""

from collections.abc import Collection
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Any, TypeAlias

from solver.scene import fields as kind
from solver.scene.expression import Number, Vector
from solver.scene.fields import BROKEN, Part, PointReference
from solver.scene.mistakes import Path
from solver.scene.orientation import Orientation, read_orientation
from solver.scene.quantities import ROTATION_IN_SPACE, SCALAR_IN_THE_PLANE, VECTOR, Offer

if TYPE_CHECKING:
    from solver.scene.references import Reader

Pair: TypeAlias = tuple[str | None, str | None]
Ends: TypeAlias = tuple[PointReference, PointReference]

GLOBAL = "global"
"""Axes that do not move; no body has this name, as it is reserved."""


def _place_with_axes(reader: "Reader", path: Path, name: Any, given: Any) -> PointReference:
    """Read the place of an instrument, which has the axes of its body."""
    if name not in (BROKEN, "ground") and reader.known.parts.get(name) != "body":
        reader.body(path, name, bar=True)  # says what it is, unless it is a bar
        if reader.known.parts.get(name) == "bar":
            help = "give it a rigid body instead, which has an origin and axes"
            reader.draft.error(path, f"the bar '{name}' carries no instrument", help)
        name = BROKEN
    return reader.point(path[:-1], name, given.at, field="body")


def _orientation(reader: "Reader", path: Path, value: Any, _: Any) -> Any:
    return read_orientation(reader, path, value)


@dataclass(frozen=True, slots=True, kw_only=True)
class Imu(Part):
    """An inertial measurement unit: specific force and angular velocity in its own axes."""

    type = "imu"
    offers = (
        Offer(
            "f{}", "m/s2", "specific force at {name} along its {axis} axis: acceleration less "
            "gravity", axes=VECTOR,
        ),
        Offer("w", "rad/s", "angular velocity of {name}", axes=SCALAR_IN_THE_PLANE),
        Offer(
            "w{}", "rad/s", "angular velocity of {name} about its {axis} axis",
            axes=ROTATION_IN_SPACE,
        ),
    )  # fmt: skip

    body: Annotated[
        PointReference,
        kind.Plain(
            text="name of the rigid body that carries it", example="rod",
            beside={"at": kind.Components("m", "place on the body as drawn; its origin")},
            reading=_place_with_axes,
        ),
    ]  # fmt: skip
    orientation: Annotated[
        Number | tuple[Vector, Vector, Vector] | None,
        kind.ByShape(
            "rad", "in 2-D, of its axes in those of the body; in 3-D { axis, angle }, "
            "{ quaternion }, { rotation_vector } or { matrix }",
            number=kind.NUMBER, table=kind.Table(parts=(Orientation,)), reading=_orientation,
        ),
    ] = None  # fmt: skip
    """Angle or rotation matrix; None: not turned."""


def _axes(reader: "Reader", path: Path, name: Any, _: Any) -> str:
    if name in (BROKEN, GLOBAL):
        return GLOBAL
    if name == "ground":
        reader.draft.error(path, "the ground has the global axes", f'write axes = "{GLOBAL}"')
        return GLOBAL
    return name if reader.body(path, name) else GLOBAL


_PLACE = (
    Offer("{}", "m", "place in {name}: second less first, along axis {axis}", axes=VECTOR),
    Offer("v{}", "m/s", "rate of the component {axis} of {name}", axes=VECTOR),
    Offer("distance", "m", "distance in {name}"),
)
_TURN = (
    Offer("angle", "rad", "angle in {name}: second less first, in space from 0 to pi"),
    Offer(
        "angular_velocity", "rad/s", "angular velocity in {name}: second less first",
        axes=SCALAR_IN_THE_PLANE,
    ),
    Offer(
        "psi_{}", "rad", "rotation vector in {name}, from first to second, component {axis}",
        axes=ROTATION_IN_SPACE,
    ),
    Offer(
        "w{}", "rad/s", "angular velocity in {name}: second less first, component {axis}",
        axes=ROTATION_IN_SPACE,
    ),
)  # fmt: skip


@dataclass(frozen=True, slots=True, kw_only=True)
class Relative(Part):
    """The second of two places, or bodies, as seen from the first."""

    type = "relative"
    offers = (*_PLACE, *_TURN)

    bodies: Annotated[Pair | None, kind.TWO_BODIES] = None
    points: Annotated[Ends | None, kind.TWO_ENDS] = None
    """Instead of `bodies`."""
    axes: Annotated[
        str,
        kind.Plain(
            text="of the components: global, or the name of a body", example="arm", reading=_axes
        ),
    ] = GLOBAL

    @classmethod
    def offered(cls, given: Collection[str]) -> tuple[Offer, ...]:
        """Points have places alone."""
        return _PLACE if "points" in given and "bodies" not in given else cls.offers

    def check(self, reader: "Reader", path: Path, given: Any) -> None:
        """Check that there are two bodies or two points."""
        if (given.bodies is None) == (given.points is None):
            message = "neither 'bodies' nor 'points' is given"
            if given.bodies is not None:
                message = "either 'bodies' or 'points' is possible, not both"
            help = 'write bodies = ["arm", "load"], or points = ["arm.tip", "load"]'
            reader.draft.error(path, message, help)
        elif given.points is None and given.at is not None:
            message = "the place of an end of 'points', of which there are none"
            help = "leave it out: bodies are seen at their origins"
            reader.draft.error((*path, "at"), message, help)


SENSORS: dict[str, type[Part]] = {sensor.type: sensor for sensor in (Imu, Relative)}
"""Types of sensors."""
