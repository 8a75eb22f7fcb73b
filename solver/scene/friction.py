"""Friction of joints: |T| <= coefficient radius N + preload, N the force that the joint carries."""

from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Any

from solver.scene import fields as kind
from solver.scene.expression import Number
from solver.scene.fields import BROKEN, Part
from solver.scene.mistakes import Path
from solver.scene.quantities import Offer, turning
from solver.scene.rules import NOT_NEGATIVE, POSITIVE, PROPERTY

if TYPE_CHECKING:
    from solver.scene.references import Reader

ALONG = (
    Offer("friction", "N", "friction of {name} on the motion of its second body"),
    Offer("slip", "m/s", "slip rate of {name}"),
    Offer("friction_mode", "1", "of {name}: 1 while friction holds it, 2 while it slides"),
    Offer("power", "W", "power of the friction of {name}, never positive", on_demand=True),
)
"""Of a joint that slides; of a cylindrical one the sizes."""
ABOUT = turning(ALONG)
"""Of a joint that turns; of a spherical one the sizes."""
SMOOTH_SPEED = "slip s over which friction is smoothed, s/sqrt(s^2 + smooth_speed^2): no stick"


def check_sticking(reader: "Reader", part: Part, given: Any, path: Path, slides: str) -> None:
    """Check a coefficient of sticking, at `path`, against that of the part while it `slides`.

    It is none smaller, and there is none with smooth friction, which never sticks.
    """
    field = str(path[-1])
    if getattr(given, field) is not None and given.smooth_speed is not None:
        message = "has no effect with smooth_speed: smooth friction never sticks"
        reader.draft.error(path, message, "leave out one of the two")
    if BROKEN in (getattr(given, field), getattr(given, slides)):
        return
    sliding, static = (
        None if (number := getattr(part, name)) is None else reader.value(number)
        for name in (slides, field)
    )
    if sliding is not None and static is not None and 0.0 <= static < sliding:
        message = f"must be >= {slides} = {sliding:.15g}, got {static:.15g}"
        reader.draft.error(path, message)


@dataclass(frozen=True, slots=True, kw_only=True)
class JointFriction(Part):
    """Coulomb's friction in a joint; without a normal force it is the preload."""

    coefficient: Annotated[Number, kind.Quantity("", "while it slides", NOT_NEGATIVE, PROPERTY)] = (
        0.0
    )
    static: Annotated[
        Number | None,
        kind.Quantity("", "while it sticks; `coefficient` unless given", NOT_NEGATIVE, PROPERTY),
    ] = None
    radius: Annotated[
        Number | None, kind.Quantity("m", "of the journal, pin or ball", POSITIVE, example=0.01)
    ] = None
    """None of a prismatic joint."""
    preload: Annotated[
        Number,
        kind.Quantity(
            "N.m or N", "N.m where the joint turns, N where it slides", NOT_NEGATIVE, PROPERTY
        ),
    ] = 0.0
    smooth_speed: Annotated[
        Number | None, kind.Quantity("rad/s or m/s", SMOOTH_SPEED, POSITIVE, PROPERTY, example=0.01)
    ] = None

    def check(self, reader: "Reader", path: Path, given: Any) -> None:
        """Check that there is some friction, and none larger while it slides than at rest."""
        draft = reader.draft
        if given.coefficient is None and given.preload is None:
            help = "write coefficient = ..., preload = ... or both"
            draft.error(path, "neither 'coefficient' nor 'preload' is given", help)
        check_sticking(reader, self, given, (*path, "static"), "coefficient")


def _with_radius(needed: bool, units: tuple[str, str]) -> kind.Reading:
    """Return the reading of a joint's friction; `units` are of its preload and slip."""

    def read(reader: "Reader", path: Path, value: Any, _: Any) -> JointFriction | None:
        if value is BROKEN:
            return None
        part = reader.draft.part(path, JointFriction, value)
        if not needed and part.radius is not None:
            message = "friction of a prismatic joint acts along it, at no radius"
            reader.draft.error((*path, "radius"), message, "leave it out")
        elif needed and part.radius is None:
            message = "'radius' is missing: the arm of the friction"
            reader.draft.error(path, message, "write radius = 0.01")
        for field, unit in (("preload", units[0]), ("smooth_speed", units[1])):
            reader.in_unit((*path, field), getattr(part, field), unit)
        return JointFriction.read(reader, path, part)

    return read


_TEXT = "{ coefficient, radius, preload, static, smooth_speed } of Coulomb's friction"
_TURNS, _SLIDES = ("N.m", "rad/s"), ("N", "m/s")
"""Units of preload and slip."""
FRICTION = kind.Table(text=_TEXT, parts=(JointFriction,), reading=_with_radius(True, _TURNS))
FRICTION_ON_A_JOURNAL = kind.Table(
    text=_TEXT, parts=(JointFriction,), reading=_with_radius(True, _SLIDES)
)
FRICTION_ALONG = kind.Table(
    text=_TEXT.replace(" radius,", ""),
    parts=(JointFriction,),
    reading=_with_radius(False, _SLIDES),
)
