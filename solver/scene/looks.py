"""Looks of a scene and how it is viewed: for drawings alone, the mechanism knows nothing of them.

A look is a shape that moves with a body or a point, or stays on the ground; its place and axis are
those in the axes of the body.
"""

import re
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Any

from solver.scene import fields as kind
from solver.scene.contacts import check_size
from solver.scene.expression import Number, Vector
from solver.scene.fields import BROKEN, Part, PointReference
from solver.scene.mistakes import Path
from solver.scene.numbers import unknown_end
from solver.scene.rules import NOT_NEGATIVE, POSITIVE, SHARE
from solver.scene.words import a, did_you_mean, listed

if TYPE_CHECKING:
    from solver.scene.references import Reader

COLOUR = "#[0-9A-Fa-f]{6}"


def _carrier(reader: "Reader", path: Path, name: Any, _: Any) -> PointReference:
    """Check that a look is on a point, a rigid body or the ground."""
    if name not in (BROKEN, "ground") and (problem := unknown_end(reader.known, name)):
        reader.draft.error(path, *problem)
    return PointReference(point=None if name in (BROKEN, "ground") else name)


def _colour(reader: "Reader", path: Path, value: Any, _: Any) -> str:
    if value is not BROKEN and not re.fullmatch(COLOUR, value):
        message = f"must be # and six digits, two each of red, green and blue, got '{value}'"
        reader.draft.error(path, message, 'write colour = "#3070b0"')
    return "" if value is BROKEN else value


_RADIUS = kind.Quantity("m", rule=POSITIVE, example=0.1)
_LENGTH = kind.Quantity("m", rule=POSITIVE, example=0.5)


@dataclass(frozen=True, slots=True, kw_only=True)
class Look(Part):
    """A shape for drawings: it has no mass and touches nothing."""

    on: Annotated[
        PointReference,
        kind.Plain(text="body, point or ground that it moves with", example="wheel",
                   reading=_carrier),
    ]  # fmt: skip
    at: Annotated[
        Vector, kind.Components("m", "its centre, in axes of the body, from its origin")
    ] = (0.0, 0.0, 0.0)
    opacity: Annotated[float, kind.setting("", "0 cannot be seen", SHARE, 1.0)] = 1.0
    colour: Annotated[
        str, kind.Plain(text="that of the body unless given", pattern=COLOUR, reading=_colour)
    ] = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class RoundLook(Look):
    """A shape about an axis."""

    radius: Annotated[Number, _RADIUS]
    axis: Annotated[
        Vector | None, kind.Direction(text="in axes of the body; z, in 2-D across the plane")
    ] = None


@dataclass(frozen=True, slots=True, kw_only=True)
class BoxLook(Look):
    """A cuboid along the axes of the body; in the plane a rectangle."""

    type = "box"

    size: Annotated[Vector, kind.Components("m", "along x, y, z", example=[0.2, 0.1, 0.1])]

    def check(self, reader: "Reader", path: Path, given: Any) -> None:
        """Check the lengths."""
        if given.size is not BROKEN:
            check_size(reader, (*path, "size"), self.size)


@dataclass(frozen=True, slots=True, kw_only=True)
class CylinderLook(RoundLook):
    """A cylinder."""

    type = "cylinder"

    length: Annotated[Number, _LENGTH]


@dataclass(frozen=True, slots=True, kw_only=True)
class SphereLook(Look):
    """A ball."""

    type = "sphere"

    radius: Annotated[Number, _RADIUS]


@dataclass(frozen=True, slots=True, kw_only=True)
class WheelLook(RoundLook):
    """A wheel with tyre, disc and a spoke, which shows how it turns."""

    type = "wheel"

    width: Annotated[Number, kind.Quantity("m", rule=POSITIVE, example=0.2)]


@dataclass(frozen=True, slots=True, kw_only=True)
class TubeLook(RoundLook):
    """A hollow cylinder."""

    type = "tube"

    length: Annotated[Number, _LENGTH]
    inner_radius: Annotated[Number, kind.Quantity("m", rule=NOT_NEGATIVE, example=0.08)]

    def check(self, reader: "Reader", path: Path, given: Any) -> None:  # noqa: ARG002
        """Check that the inner radius is the smaller one."""
        large, small = map(reader.value, (self.radius, self.inner_radius))
        if large is not None and small is not None and 0.0 < large <= small:
            message = f"must be less than the radius {large:.15g} m, got {small:.15g}"
            reader.draft.error((*path, "inner_radius"), message)


LOOKS: dict[str, type[Look]] = {
    look.type: look for look in (BoxLook, CylinderLook, SphereLook, WheelLook, TubeLook)
}
"""Types of looks."""


# ------------------------------------------------------------------------------------------ view


def _direction(reader: "Reader", path: Path, value: Any, _: Any) -> Vector | None:
    if reader.dimension != 2:
        return reader.axis(path, value)
    message = "a mechanism in the plane is seen from +z"
    reader.draft.error(path, message, "leave it out")
    return None


def _place(reader: "Reader", path: Path, name: Any, _: Any) -> str | None:
    problem = None if name is BROKEN else unknown_end(reader.known, name)
    if problem:
        reader.draft.error(path, *problem)
    return None if name is BROKEN else name


def _places(reader: "Reader", path: Path, names: Any, given: Any) -> tuple[str, ...]:
    for i, name in enumerate(() if names is BROKEN else names):
        _place(reader, (*path, i), name, given)
    return () if names is BROKEN else tuple(names)


def _plots(reader: "Reader", path: Path, plots: Any, _: Any) -> tuple[tuple[str, ...], ...]:
    """Check that each plot has variables, and that these are some of the FMU."""
    known = reader.known
    plain = known.of("parameter", "input", "output")
    for i, names in enumerate(() if plots is BROKEN else plots):
        for k, name in enumerate(names):
            if name in known.quantities or name in plain:
                continue
            help = did_you_mean(name, [*known.quantities, *plain])
            message = f"unknown variable '{name}'"
            if name in known.parts:
                message = f"'{name}' is {a(known.parts[name])}, not a variable"
                own = [word for word in known.quantities if word.startswith(f"{name}.")]
                help = f"known: {listed(own)}" if own else help
            reader.draft.error((*path, i, k), message, help)
        if not names:
            reader.draft.error((*path, i), "must have at least one variable, got none")
    return () if plots is BROKEN else tuple(map(tuple, plots))


@dataclass(frozen=True, slots=True, kw_only=True)
class View(Part):
    """How the mechanism is shown: from where, what is followed, which paths and plots."""

    direction: Annotated[
        Vector | None,
        kind.Direction(text="from the mechanism to the eye; only in 3-D", example=[1, -1.5, 0.7],
                       reading=_direction),
    ] = None  # fmt: skip
    follow: Annotated[
        str | None, kind.Plain(text="body or point that stays in the middle", reading=_place)
    ] = None
    traces: Annotated[
        tuple[str, ...],
        kind.ListOf(text="points whose paths are drawn", item=kind.NAME, example=["rod.tip"],
                    reading=_places),
    ] = ()  # fmt: skip
    plots: Annotated[
        tuple[tuple[str, ...], ...],
        kind.ListOf(text="variables of each plot", item=kind.ListOf(item=kind.NAME),
                    example=[["A.x", "A.y"]], reading=_plots),
    ] = ()  # fmt: skip


def read_view(reader: "Reader") -> View:
    """Read the table [view]."""
    given = reader.draft.part(("view",), View, reader.draft.table("view"))
    return View(**reader.fields(View, ("view",), given))
