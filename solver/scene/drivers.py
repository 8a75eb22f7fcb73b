"""Prescribed motions and general constraints of a scene.

The force of a driver is the one that it exerts, positive along what it drives.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Any

from solver.scene import fields as kind
from solver.scene.expression import Expr, Number, Vector
from solver.scene.fields import BROKEN, Part, PointReference
from solver.scene.mistakes import Path
from solver.scene.quantities import VECTOR, Level, Offer
from solver.scene.rules import CONSTRAINT, DRIVER, POSITIVE, VELOCITY_ROW, Place

if TYPE_CHECKING:
    from solver.scene.references import Reader

_POWER = Offer("power", "W", "power of {name}")


def _along(word: str, unit: str, what: str) -> tuple[Offer, ...]:
    return Offer(word, unit, f"{word} of {{name}}, positive along its {what}"), _POWER


@dataclass(frozen=True, slots=True, kw_only=True)
class PositionDriver(Part):
    """A point follows a path."""

    type = "position"
    offers = (
        Offer(
            "force.{}", "N", "force of {name} on the point that it moves, {axis} component",
            axes=VECTOR,
        ),
        _POWER,
    )  # fmt: skip

    point: Annotated[PointReference, kind.ONE_END]
    value: Annotated[Vector, kind.Components("m", place=DRIVER, example=[0, 0, "sin(t)"])]
    """One expression in time, inputs and parameters for each axis."""

    def check(self, reader: "Reader", path: Path, given: Any) -> None:  # noqa: ARG002
        """Check that the point can move, and that no other driver moves it."""
        point, where = self.point, (*path, "point")
        if point.point in reader.fixed:
            message = f"the point '{point.point}' is fixed, and cannot be driven"
            reader.draft.error(where, message, "leave out its fixed = true")
        if point.point is not None and point.at is None:
            _once(reader, where, self.type, point.point)


@dataclass(frozen=True, slots=True, kw_only=True)
class DistanceDriver(Part):
    """The distance of two points follows an expression."""

    type = "distance"
    offers = _along("force", "N", "distance")

    points: Annotated[tuple[PointReference, PointReference], kind.TWO_ENDS]
    value: Annotated[Number, kind.Quantity("m", "", POSITIVE, DRIVER, "1 + 0.1*sin(t)")]


class JointDriver(Part):
    """A motion of a joint, zero as drawn, follows an expression."""

    __slots__ = ()
    joint: str
    value: Number

    def check(self, reader: "Reader", path: Path, given: Any) -> None:  # noqa: ARG002
        """Check that no other driver moves the joint in the same way."""
        if reader.has(self.joint, self.type):
            _once(reader, (*path, "joint"), self.type, self.joint)


@dataclass(frozen=True, slots=True, kw_only=True)
class AngleDriver(JointDriver):
    """The angle of a joint follows an expression."""

    type = "angle"
    offers = _along("torque", "N.m", "angle")

    joint: Annotated[str, kind.joint_with("angle", "bearing")]
    value: Annotated[Number, kind.Quantity("rad", "0 as drawn", place=DRIVER, example="2*pi*t")]


@dataclass(frozen=True, slots=True, kw_only=True)
class DisplacementDriver(JointDriver):
    """The displacement of a joint follows an expression."""

    type = "displacement"
    offers = _along("force", "N", "displacement")

    joint: Annotated[str, kind.joint_with("displacement", "guide")]
    value: Annotated[Number, kind.Quantity("m", "0 as drawn", place=DRIVER, example="0.1*sin(t)")]


def _once(reader: "Reader", where: Path, what: str, name: str) -> None:
    """Report what two drivers move at once."""
    first = reader.driven.setdefault((what, name), str(where[1]))
    if first != where[1]:
        message = f"the {what} of '{name}' is driven by '{first}' already"
        reader.draft.error(where, message, "leave out one of the two")


def _row(place: Place, level: Level) -> kind.Reading:
    """Return the reading of a row, which depends on positions, or linearly on velocities."""

    def read(reader: "Reader", path: Path, value: Any, _: Any) -> Number:
        before = len(reader.draft.problems)
        number = reader.number(path, value, place)
        if value is BROKEN or len(reader.draft.problems) > before:
            return number
        levels = {reader.known.quantities.get(mention.name) for mention in value.mentions}
        calls = any(mention.role == "function" for mention in value.mentions)
        if level not in levels and not (level == "position" and calls):
            what = "position" if level == "position" else "velocity"
            reader.draft.error(path, f"mentions no {what} of the mechanism: it constrains nothing")
        elif level == "rate" and (degrees := _degrees(number, reader.known.quantities)) != {1}:
            message = "must be linear in the velocities"
            message += "" if 2 in degrees else ", without a part that contains none"
            reader.draft.error(path, message, 'such as "A.vx*sin(b) - A.vy*cos(b)"')
        return number

    return read


_POSITIONS = kind.Quantity(
    text="of positions, stays zero; either this or velocity is given",
    reading=_row(CONSTRAINT, "position"),
)
_VELOCITIES = kind.Quantity(
    text="linear in velocities, stays zero", reading=_row(VELOCITY_ROW, "rate")
)


@dataclass(frozen=True, slots=True, kw_only=True)
class Constraint(Part):
    """An expression that stays zero: of positions, or linear in velocities."""

    offers = (
        Offer(
            "multiplier", "", "multiplier of {name}: its force is -multiplier times its gradient"
        ),
    )

    value: Annotated[Number | None, _POSITIONS] = None
    velocity: Annotated[Number | None, _VELOCITIES] = None

    def check(self, reader: "Reader", path: Path, given: Any) -> None:
        """Check that one of the two is given."""
        if (given.value is None) == (given.velocity is None):
            message = "neither 'value' nor 'velocity' is given"
            if given.value is not None:
                message = "either 'value' or 'velocity' is possible, not both"
            help = "write value = ... for positions, or velocity = ... for velocities"
            reader.draft.error(path, message, help)


def _degrees(number: Any, levels: Mapping[str, Level]) -> set[int]:
    """Degrees in the velocities of the terms of an expression; 2 stands for all but 0 and 1."""
    if not isinstance(number, Expr):
        return {0} if number else set()
    if number.op in ("symbol", "call"):
        return {int(levels.get(str(number)) == "rate")}
    first, *others = (_degrees(arg, levels) for arg in number.args)
    rest = set().union(*others)
    if number.op in ("add", "sub", "neg"):
        return first | rest
    if number.op == "mul":
        return {min(2, a + b) for a in first for b in rest}
    if number.op in ("div", "select"):  # what divides or decides comes last or first
        free, terms = (rest, first) if number.op == "div" else (first, rest)
        return terms if free <= {0} else {2}
    return {0} if first | rest <= {0} else {2}


DRIVERS: dict[str, type[Part]] = {
    driver.type: driver
    for driver in (PositionDriver, DistanceDriver, AngleDriver, DisplacementDriver)
}
"""Types of drivers."""
