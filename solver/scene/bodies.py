"""Points, bars and rigid bodies of a scene: what they are made of and where they are drawn."""

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Annotated, Any, TypeAlias

from solver.scene import fields as kind
from solver.scene.expression import Number, Vector, cos, sin
from solver.scene.fields import BROKEN, Part, shown
from solver.scene.inertia import SHAPES, Shape, read_inertia
from solver.scene.mistakes import Path
from solver.scene.orientation import InBodyAxes, Orientation, read_orientation, read_spin
from solver.scene.quantities import (
    MOTION,
    QUATERNION,
    ROTATION_IN_SPACE,
    SCALAR_IN_THE_PLANE,
    Offer,
    angular_acceleration,
)
from solver.scene.rules import NOT_NEGATIVE, POSITIVE

if TYPE_CHECKING:
    from solver.scene.draft import Draft
    from solver.scene.references import Reader

_TURN = (
    Offer(
        "angle", "rad", "angle of {name} from the x axis, unwrapped", "position",
        SCALAR_IN_THE_PLANE,
    ),
    Offer(
        "angular_velocity", "rad/s", "angular velocity of {name}", "rate", SCALAR_IN_THE_PLANE
    ),
    angular_acceleration(SCALAR_IN_THE_PLANE),
)  # fmt: skip


@dataclass(frozen=True, slots=True, kw_only=True)
class Point(Part):
    """A point, free or fixed to the ground."""

    offers = MOTION

    position: Annotated[Vector, kind.Components("m", "as drawn", example=[0, 0, 0])]
    velocity: Annotated[
        Vector | None, kind.Components("m/s", "at the start", example=[0, 0, 0])
    ] = None
    """None: not given, at rest; `assemble` is free to choose it."""
    mass: Annotated[Number, kind.Quantity("kg", rule=NOT_NEGATIVE)] = 0.0
    fixed: Annotated[bool, kind.Plain(type=bool)] = False

    def check(self, reader: "Reader", path: Path, given: Any) -> None:
        """Check that a fixed point has no velocity, and note where it is drawn."""
        name = str(path[1])
        if self.fixed is True:
            reader.fixed.add(name)
            if any(component != 0.0 for component in self.velocity or ()):
                message = "a fixed point cannot have a velocity"
                reader.draft.error((*path, "velocity"), message, "leave out velocity or fixed")
        if given.position is not BROKEN:
            reader.drawn[name] = self.position


def _bar_ends(reader: "Reader", path: Path, names: Any, _: Any) -> tuple[str, str]:
    """Check that a bar has two points of the table [points], of which one can move."""
    if names is BROKEN:
        return "", ""
    first, second = names
    for i, point in enumerate(names):
        _check_end(reader, (*path, i), point)
    if first == second:
        reader.draft.error(path, f"both ends are '{first}'")
    elif {first, second} <= reader.fixed:
        message = f"both ends are fixed ('{first}' and '{second}'): the bar cannot move"
        reader.draft.error(path, message)
    reader.add_bar(str(path[1]), (first, second))
    return first, second


_BAR_ENDS = kind.ListOf(item=kind.NAME, size=kind.TWO, example=["A", "B"], reading=_bar_ends)


def _check_end(reader: "Reader", path: Path, point: str) -> None:
    if point == "ground":
        message = "a bar ends in points, not in 'ground'"
        reader.draft.error(path, message, "make a point with fixed = true")
    elif reader.exists(path, point) and reader.owner(point) is not None:
        message = f"a bar ends in points of the table [points], not in '{point}' of a body"
        help = "end it in a point of [points], and join the two with points = [...]"
        reader.draft.error(path, message, help)


@dataclass(frozen=True, slots=True, kw_only=True)
class Bar(Part):
    """A uniform slender rigid bar between two points."""

    type = "bar"
    offers = _TURN

    points: Annotated[tuple[str, str], _BAR_ENDS]
    mass: Annotated[Number, kind.Quantity("kg", rule=POSITIVE, example=1.0)]


class NoList(kind.Kind):
    """Stands where a list is a mistake."""

    def parse(self, draft: "Draft", path: Path, value: Any, unit: str = "") -> Any:  # noqa: ARG002
        """Report the list."""
        message = f"must be a number in dimension 2 and a table in dimension 3, got {shown(value)}"
        help = 'write for instance { axis = [0, 1, 0], angle = "90 deg" }'
        draft.error(path, message, help)
        return BROKEN


def _named_places(reader: "Reader", path: Path, places: Any, _: Any) -> dict[str, Vector]:
    given = {} if places is BROKEN else places
    return {name: reader.vector((*path, name), place) for name, place in given.items()}


_NAMED_PLACES = kind.Table(
    "m", "named points in body axes", item=kind.COMPONENTS, reading=_named_places
)


@dataclass(frozen=True, slots=True, kw_only=True)
class Rigid(Part):
    """A rigid body: an origin, axes, mass and inertia, or a shape."""

    type = "rigid"
    is_usual = True
    offers = (
        *(*MOTION, *_TURN),
        Offer("q{}", "1", "quaternion of {name}, {axis}, of continuous sign", axes=QUATERNION),
        Offer(
            "w{}", "rad/s", "angular velocity of {name}, {axis} component", axes=ROTATION_IN_SPACE
        ),
        Offer(
            "wd{}", "rad/s2", "angular acceleration of {name}, {axis} component", "acceleration",
            ROTATION_IN_SPACE, on_demand=True,
        ),
    )  # fmt: skip
    also = {  # noqa: RUF012
        "shape": kind.Table(
            text="box, cylinder or sphere; in 2-D box, disc or rod; with a density or mass",
            parts=tuple(SHAPES.values()),
        )
    }

    mass: Annotated[Number, kind.Quantity("kg", "its shape's by default", POSITIVE, required=False)]
    inertia: Annotated[
        Number | tuple[Vector, Vector, Vector],
        kind.ByShape(
            "kg.m2", "about the centre of mass: a number in 2-D, [Jx, Jy, Jz] or 3 x 3 in 3-D, "
            "with Jxy = -integral of x*y dm",
            required=False, number=kind.NUMBER, vector=kind.COMPONENTS,
            vectors=kind.ListOf(item=kind.COMPONENTS),
        ),
    ]  # fmt: skip
    """A number in 2-D; in 3-D the tensor in body axes, 3 x 3, with Jxy = -integral of x*y dm."""
    center_of_mass: Annotated[
        Vector, kind.Components("m", "in body axes, from the origin", required=False)
    ]  # fmt: skip
    position: Annotated[Vector, kind.Components("m", "of the origin, as drawn", example=[0, 0, 0])]
    orientation: Annotated[
        Number | tuple[Vector, Vector, Vector],
        kind.ByShape(
            "rad", "in 2-D; in 3-D { axis, angle }, { quaternion }, { rotation_vector } or "
            "{ matrix }",
            required=False, number=kind.NUMBER, vector=NoList(),
            table=kind.Table(parts=(Orientation,)),
        ),
    ]  # fmt: skip
    """An angle in 2-D; in 3-D the rotation matrix, whose columns are the body's axes."""
    velocity: Annotated[Vector | None, kind.Components("m/s", "of the origin; 0 by default")] = None
    """None: not given, at rest."""
    angular_velocity: Annotated[
        Number | Vector | None,
        kind.ByShape(
            "rad/s", "a number in 2-D; in 3-D a vector, or { body = [...] }; 0 by default",
            number=kind.NUMBER, vector=kind.COMPONENTS, table=kind.Table(parts=(InBodyAxes,)),
        ),
    ] = None  # fmt: skip
    """A number in 2-D, a vector in global axes in 3-D; None: not given, at rest."""
    points: Annotated[dict[str, Vector], _NAMED_PLACES] = field(default_factory=dict)
    shape: Shape | None = None
    """That of which mass and inertia were calculated, about the centre of mass."""

    @property
    def rotation(self) -> tuple[Vector, ...]:
        """Rotation matrix as drawn, whose columns are the body's axes."""
        if isinstance(self.orientation, tuple):
            return self.orientation
        c, s = cos(self.orientation), sin(self.orientation)
        return (c, -s), (s, c)

    @classmethod
    def read(cls, reader: "Reader", path: Path, given: Any) -> Any:
        """Turn shape, orientation and spin into what they mean, and note where it is drawn."""
        values: dict[str, Any] = {
            "center_of_mass": reader.zero(),
            **reader.fields(cls, path, given),
        }
        turned = read_orientation(reader, (*path, "orientation"), given.orientation)
        values["orientation"] = turned
        mass, inertia, shape = read_inertia(reader, path, given, values.get("mass"))
        values |= {"mass": mass, "inertia": inertia, "shape": shape}
        values["angular_velocity"] = read_spin(
            reader, (*path, "angular_velocity"), given.angular_velocity, turned
        )
        body = cls(**values)
        if given.position is not BROKEN:
            reader.add_rigid(str(path[1]), body)
        return body


BODIES: dict[str, type[Part]] = {"rigid": Rigid, "bar": Bar}
"""Types of bodies."""

Body: TypeAlias = Bar | Rigid
