"""Actuators: what drives a mechanism along a line or a joint, up to what its motor can."""

from collections.abc import Collection
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Any

from solver.scene import fields as kind
from solver.scene.expression import Number
from solver.scene.fields import Part, PointReference
from solver.scene.mistakes import Path
from solver.scene.quantities import POWER, Offer
from solver.scene.rules import MOTOR_SPEED, NOT_ZERO, POSITIVE, RATE, Place, Rule

if TYPE_CHECKING:
    from solver.scene.references import Reader

_COORDINATES = "points", "joint", "guide"
_LAW = Place(time=True, levels=("position", "rate"), own=(RATE, MOTOR_SPEED))
_PART_OF_ONE = Rule(lambda x: 0.0 < x <= 1.0, "above 0, and at most 1", relation=">")
_ALONG = Offer("force", "N", "force of {name}, positive where it pushes its ends apart")
_ON_A_LINE = Offer("length", "m", "length of {name}"), _ALONG
_OF_A_GUIDE = (
    Offer("force", "N", "force of {name}, positive along the displacement of {part.guide}"),
)
_OF_A_JOINT = (
    Offer("torque", "N.m", "torque of {name}, positive along the angle of {part.joint}"),
)
_OF_A_MOTOR = (Offer("motor_speed", "rad/s", "speed of the motor of {name}"),)
_ALWAYS = (
    POWER,
    Offer("limited", "1", "limit of {name}: 0 none, 1 largest force or torque, 2 largest power"),
)


def _most(unit: str, what: str, place: Place = _LAW) -> kind.Quantity:
    return kind.Quantity(unit, f"largest {what}, unlimited unless given", POSITIVE, place)


@dataclass(frozen=True, slots=True, kw_only=True)
class Actuator(Part):
    """A force along a line or a displacement, or a torque about an angle, up to a motor's limits.

    A motor with a ratio turns that many times as fast as its joint; `value` and `max_torque` are
    those of the motor, the torque on the joint is `ratio` times as large.
    """

    type = "actuator"
    offers = (*_ON_A_LINE, *_OF_A_JOINT, *_OF_A_MOTOR, *_ALWAYS)

    points: Annotated[tuple[PointReference, PointReference] | None, kind.TWO_ENDS] = None
    joint: Annotated[str | None, kind.joint_with("angle", "hinge")] = None
    guide: Annotated[
        str | None, kind.joint_with("displacement", "slide", "joint along which it pushes")
    ] = None
    value: Annotated[
        Number, kind.Quantity("N or N.m", "may mention `rate` and `motor_speed`", None, _LAW, 100.0)
    ]
    max_force: Annotated[Number | None, _most("N", "force, of either sign")] = None
    max_torque: Annotated[Number | None, _most("N.m", "torque of the motor, of either sign")] = None
    max_power: Annotated[Number | None, _most("W", "power, given or taken")] = None
    ratio: Annotated[
        Number, kind.Quantity("", "speed of the motor over that of the joint", NOT_ZERO)
    ] = 1.0
    efficiency: Annotated[
        Number, kind.Quantity("", "of the gear: power behind it over power before", _PART_OF_ONE)
    ] = 1.0

    @classmethod
    def offered(cls, given: Collection[str]) -> tuple[Offer, ...]:
        """Force or torque, by what it acts along."""
        if "joint" in given:
            return (*_OF_A_JOINT, *_OF_A_MOTOR, *_ALWAYS)
        return (*(_OF_A_GUIDE if "guide" in given else _ON_A_LINE), *_ALWAYS)

    def check(self, reader: "Reader", path: Path, given: Any) -> None:
        """Check that it acts along one thing, and has limits and a gear that belong to it."""
        draft = reader.draft
        along = [name for name in _COORDINATES if getattr(given, name) is not None]
        if len(along) != 1:
            found = f"'{along[0]}' and '{along[1]}'" if along else "nothing"
            message = f"an actuator acts along one of {', '.join(_COORDINATES)}, got {found}"
            help = 'write points = ["A", "B"], joint = "hinge" or guide = "slide"'
            draft.error((*path, along[1]) if along else path, message, help)
            return
        reader.in_unit((*path, "value"), given.value, "N.m" if along == ["joint"] else "N")
        wrong = ["max_force"] if along == ["joint"] else ["max_torque", "ratio", "efficiency"]
        for name in wrong:
            if getattr(given, name) is not None:
                is_turning = name == "max_force"
                message = f"an actuator {'about' if is_turning else 'along'} '{along[0]}' has no "
                message += "force" if is_turning else "motor that turns"
                help = "write max_torque" if is_turning else "give it 'joint', or leave it out"
                draft.error((*path, name), message, help)
