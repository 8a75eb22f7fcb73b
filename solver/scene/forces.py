"""Forces, torques and potentials of a scene: what they act on, and what they may depend on.

Forces of springs and dampers are positive in tension, torques of their torsional kin against the
angle.
"""

from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Any, Literal, TypeAlias

from solver.scene import fields as kind
from solver.scene.actuators import Actuator
from solver.scene.expression import ExpressionError, Number, Vector, evaluate
from solver.scene.fields import BROKEN, Part, PointReference
from solver.scene.mistakes import Path
from solver.scene.quantities import POWER, Offer
from solver.scene.rules import (
    ANGLE,
    ELONGATION,
    FORCE,
    LENGTH,
    LOAD,
    NOT_NEGATIVE,
    POSITIVE,
    POTENTIAL,
    PROPERTY,
    RATE,
    Place,
)
from solver.scene.words import a

if TYPE_CHECKING:
    from solver.scene.references import Reader

Ends: TypeAlias = tuple[PointReference, PointReference]

_ON_A_LINE = (
    Offer("length", "m", "length of {name}"),
    Offer("force", "N", "force in {name}, positive in tension: it pulls its ends together"),
    POWER,
)
_AGAINST = Offer(
    "torque",
    "N.m",
    "torque of {name}, positive against the angle of {part.joint}: it turns it back",
)
_AXES = kind.Choice(text="axes of the components", words=("global", "body"))
_JOINT = kind.joint_with("angle", "bearing")
_ELONGATION, _ANGLE = Place(own=(ELONGATION, LENGTH)), Place(own=(ANGLE,))
_NEAR = 1e-6
"""Elongation in m, or angle in rad, at which the sign of a law is looked at."""


def not_negative(unit: str, example: float | None = None, text: str = "") -> kind.Quantity:
    """Return the kind of a stiffness, a damping or a length, which time and inputs may change."""
    return kind.Quantity(unit, text, NOT_NEGATIVE, FORCE, example)


@dataclass(frozen=True, slots=True, kw_only=True)
class Spring(Part):
    """A spring between two points: linear, or with a force or an energy of its length."""

    type = "spring"
    offers = _ON_A_LINE

    points: Annotated[Ends, kind.TWO_ENDS]
    stiffness: Annotated[Number | None, not_negative("N/m", 100.0)] = None
    """None where `force` or `energy` is given."""
    force: Annotated[
        Number | None, kind.Quantity("N", "an expression in `elongation`", place=_ELONGATION)
    ] = None
    """Positive in tension, an expression in ``elongation`` (m), length less free length."""
    free_length: Annotated[Number | None, not_negative("m", text="as drawn unless given")] = None
    energy: Annotated[
        Number | None, kind.Quantity("J", "an expression in `length`", place=Place(own=(LENGTH,)))
    ] = None
    """Stored energy, an expression in the symbol ``length`` (m)."""

    def check(self, reader: "Reader", path: Path, given: Any) -> None:
        """Check that it has a stiffness, a force or an energy, and no two of them."""
        draft, energy = reader.draft, (*path, "energy")
        laws = [
            word for word in ("stiffness", "force", "energy") if getattr(given, word) is not None
        ]
        if not laws:
            help = "write stiffness = 100.0, a force of 'elongation', or an energy in 'length'"
            draft.error(path, "'stiffness' is missing", help)
        elif len(laws) > 1:
            first, last = map(a, (laws[0], laws[-1]))
            message = f"a spring has {first} or {last}, not both"
            draft.error((*path, laws[-1]), message, "leave out one of them")
        elif given.energy is not None and given.free_length is not None:
            message = "the energy already defines the free length of the spring"
            draft.error((*path, "free_length"), message, "leave it out")
        what = "the length of the spring in m"
        _check_mention(reader, energy, given.energy, (LENGTH,), what, "50*(length - 1)**2")
        what = "length - free_length in m"
        words = ELONGATION, LENGTH
        _check_law(reader, (*path, "force"), given.force, words, what, "is longer")


def _check_mention(
    reader: "Reader", path: Path, given: Any, words: tuple[str, ...], what: str, example: str
) -> bool:
    """Check that a law, if it is given and not broken, mentions what it depends on."""
    names = set() if given in (None, BROKEN) else {mention.name for mention in given.mentions}
    if given in (None, BROKEN) or names - {*words, *reader.known.of("parameter")}:
        return False  # what it mentions instead is reported already
    if not names.isdisjoint(words):
        return True
    reader.draft.error(path, f"mentions no '{words[0]}', {what}", f'such as "{example}"')
    return False


def _check_law(
    reader: "Reader", path: Path, given: Any, words: tuple[str, ...], what: str, where: str
) -> None:
    """Check a force or torque that depends on one of `words`; warn of one with the wrong sign."""
    word, found = words[0], []
    if not _check_mention(reader, path, given, words, what, f"100*{word} + 400*{word}**3"):
        return
    for place in (-_NEAR, 0.0, _NEAR):
        try:
            found.append(evaluate(given.number, {**reader.known.values, word: place}))
        except (ExpressionError, KeyError):  # of a length as well, or not everywhere
            return
    if found[0] > 0.0 == found[1] > found[2]:
        message = f"is negative where it {where}, and so pushes on from {word} = 0"
        reader.draft.warn(path, message, "turn its sign, unless it is meant to be unstable there")


def _law_of_rate(unit: str, word: str) -> kind.Quantity:
    place = Place(time=True, levels=("position", "rate"), own=(RATE, word))
    return kind.Quantity(unit, f"an expression in `rate`, and perhaps `{word}`", place=place)


def _check_damper(reader: "Reader", path: Path, given: Any, field: str, example: str) -> None:
    """Check that a damper has a damping or a law in its rate, and not both."""
    draft, law = reader.draft, getattr(given, field)
    if given.damping is None and law is None:
        help = f"write damping = 1.0, or a {field} in 'rate', such as \"{example}\""
        draft.error(path, "'damping' is missing", help)
    elif given.damping is not None and law is not None:
        message = f"a damper has a damping or a {field}, not both"
        draft.error((*path, field), message, "leave out one of them")
    elif law not in (None, BROKEN) and RATE not in {x.name for x in law.mentions} | law.named:
        help = f'such as "{example}"'
        draft.error((*path, field), "mentions no 'rate', the rate of the damper", help)


@dataclass(frozen=True, slots=True, kw_only=True)
class Damper(Part):
    """A damper between two points: linear, or with a force that depends on its rate."""

    type = "damper"
    offers = _ON_A_LINE

    points: Annotated[Ends, kind.TWO_ENDS]
    damping: Annotated[Number | None, not_negative("N.s/m", 1.0)] = None
    """None where `force` is given."""
    force: Annotated[Number | None, _law_of_rate("N", LENGTH)] = None
    """In the symbols ``rate`` (m/s, positive as it lengthens) and ``length`` (m)."""

    def check(self, reader: "Reader", path: Path, given: Any) -> None:
        """Check that it is linear or has a law, and not both."""
        _check_damper(reader, path, given, "force", "50*rate + 20*rate*abs(rate)")


def read_free_angle(reader: "Reader", path: Path, value: Any, _: Any) -> Number:
    """Read the angle at which a torsion spring is free, which may be in degrees by mistake."""
    return 0.0 if value is BROKEN else reader.angle(path, value, FORCE)


@dataclass(frozen=True, slots=True, kw_only=True)
class TorsionSpring(Part):
    """A torsion spring at a joint that has an angle: linear, or with a torque of the angle."""

    type = "torsion_spring"
    offers = (_AGAINST, POWER)

    joint: Annotated[str, _JOINT]
    stiffness: Annotated[Number | None, not_negative("N.m/rad", 10.0)] = None
    """None where `torque` is given."""
    torque: Annotated[
        Number | None, kind.Quantity("N.m", "an expression in `angle`", place=_ANGLE)
    ] = None
    """Against the angle, an expression in ``angle`` (rad), that of the joint less free angle."""
    free_angle: Annotated[
        Number, kind.Quantity("rad", "as drawn unless given", place=FORCE, reading=read_free_angle)
    ] = 0.0

    def check(self, reader: "Reader", path: Path, given: Any) -> None:
        """Check that it has a stiffness or a torque, and not both."""
        if given.stiffness is None and given.torque is None:
            help = "write stiffness = 10.0, or a torque of 'angle'"
            reader.draft.error(path, "'stiffness' is missing", help)
        elif given.stiffness is not None and given.torque is not None:
            message = "a torsion spring has a stiffness or a torque, not both"
            reader.draft.error((*path, "torque"), message, "leave out one of them")
        what = "the angle of the joint less free_angle in rad"
        _check_law(reader, (*path, "torque"), given.torque, (ANGLE,), what, "is turned on")


@dataclass(frozen=True, slots=True, kw_only=True)
class TorsionDamper(Part):
    """A torsion damper at a joint that has an angle: linear, or with a law of its rate."""

    type = "torsion_damper"
    offers = (_AGAINST, POWER)

    joint: Annotated[str, _JOINT]
    damping: Annotated[Number | None, not_negative("N.m.s/rad", 1.0)] = None
    """None where `torque` is given."""
    torque: Annotated[Number | None, _law_of_rate("N.m", ANGLE)] = None
    """In the symbols ``rate`` (rad/s) and ``angle`` (rad)."""

    def check(self, reader: "Reader", path: Path, given: Any) -> None:
        """Check that it is linear or has a law, and not both."""
        _check_damper(reader, path, given, "torque", "0.5*rate + 0.1*rate**3")


@dataclass(frozen=True, slots=True, kw_only=True)
class JointTorque(Part):
    """A torque about a joint's angle, on the second body; the opposite one on the first."""

    type = "joint_torque"
    offers = (
        Offer("torque", "N.m", "torque of {name}, positive along the angle of {part.joint}"),
        POWER,
    )

    joint: Annotated[str, _JOINT]
    value: Annotated[Number, kind.Quantity("N.m", place=LOAD, example=1.0)]


@dataclass(frozen=True, slots=True, kw_only=True)
class Force(Part):
    """A force on a point, in global or body axes."""

    type = "force"
    offers = (POWER,)

    point: Annotated[PointReference, kind.ONE_END]
    value: Annotated[Vector, kind.Components("N", place=LOAD, example=[0, 0, 1])]
    axes: Annotated[Literal["global", "body"], _AXES] = "global"

    def check(self, reader: "Reader", path: Path, given: Any) -> None:  # noqa: ARG002
        """Check that the point can move, and has the axes that are asked for."""
        point = self.point.point
        if point in reader.fixed:
            reader.draft.error((*path, "point"), f"a force on the fixed point '{point}'")
        if self.axes == "body" and point and reader.owner(point) is None:
            message = f"'{point}' is a point, which has no axes of a body"
            reader.draft.error((*path, "axes"), message, "name a point of a rigid body")


def _moment(reader: "Reader", path: Path, value: Any, _: Any) -> Number | Vector:
    """Check that a torque is a number in the plane, a vector in space."""
    if value is BROKEN:
        return 0.0
    if isinstance(value, list):
        if reader.dimension == 2:
            reader.draft.error(path, "must be a number in dimension 2, got a vector")
            return 0.0
        return reader.vector(path, value, LOAD)
    if reader.dimension == 3:
        help = 'write value = [0, 0, "..."]'
        reader.draft.error(path, "must be a vector of 3 numbers in dimension 3", help)
    return reader.number(path, value, LOAD)


@dataclass(frozen=True, slots=True, kw_only=True)
class Torque(Part):
    """A torque on a body."""

    type = "torque"
    offers = (POWER,)

    body: Annotated[str, kind.Plain(example="crank")]
    value: Annotated[
        Number | Vector,
        kind.ByShape(
            "N.m", "a number in 2-D, a vector in 3-D", example=1.0, number=kind.NUMBER,
            vector=kind.COMPONENTS, reading=_moment,
        ),
    ]  # fmt: skip
    axes: Annotated[Literal["global", "body"], _AXES] = "global"

    def check(self, reader: "Reader", path: Path, given: Any) -> None:
        """Check that there is such a body, with the axes that are asked for."""
        body = given.body
        if body is not BROKEN and reader.body((*path, "body"), body, bar=True):
            bar = reader.known.parts.get(body) == "bar" and reader.dimension == 3
            if bar and given.axes == "body":
                message = f"the bar '{body}' has no axes in space"
                reader.draft.error((*path, "axes"), message, "leave it out: global axes")


@dataclass(frozen=True, slots=True, kw_only=True)
class Potential(Part):
    """A potential energy, an expression over positions of the mechanism."""

    type = "potential"
    offers = (Offer("energy", "J", "energy of {name}"), POWER)

    value: Annotated[Number, kind.Quantity("J", place=POTENTIAL, example="2.0*A.x**2")]

    def check(self, reader: "Reader", path: Path, given: Any) -> None:
        """Check that it depends on the mechanism, if it is not wrong for another reason."""
        if given.value is not BROKEN and not any(
            mention.role == "function" or mention.name not in reader.known.parts
            for mention in given.value.mentions
            if mention.name != "t"
        ):
            message = "mentions no position of the mechanism, and so makes no force"
            reader.draft.error((*path, "value"), message, 'such as "2.0*A.x**2"')


def _masses(reader: "Reader", path: Path, masses: Any, _: Any) -> tuple[Number, ...]:
    """Check both masses that attract each other."""
    if masses is BROKEN:
        return 1.0, 1.0
    return tuple(
        reader.number((*path, i), mass, PROPERTY, POSITIVE, "kg") for i, mass in enumerate(masses)
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class Gravitation(Part):
    """Attraction of two masses, V = -constant m1 m2/distance."""

    type = "gravitation"
    offers = _ON_A_LINE

    points: Annotated[Ends, kind.TWO_ENDS]
    masses: Annotated[
        tuple[Number, Number],
        kind.ListOf(
            "kg", "those of the points unless given", POSITIVE, PROPERTY, [1.0, 1.0], False,
            size=kind.TWO, reading=_masses,
        ),
    ]  # fmt: skip
    constant: Annotated[
        Number, kind.Quantity("m3/(kg.s2)", "CODATA 2018 unless given", place=PROPERTY)
    ] = 6.6743e-11

    @classmethod
    def read(cls, reader: "Reader", path: Path, given: Any) -> Any:
        """Find the masses of points and bodies, which stand for those that are not given."""
        values = reader.fields(cls, path, given)
        if given.masses is None:
            names = ("", "") if given.points is BROKEN else given.points
            values["masses"] = tuple(_mass(reader, path, name) for name in names)
        return cls(**values)


def _mass(reader: "Reader", path: Path, name: str) -> Number:
    """Mass of a named point or body."""
    found = reader.parts["points"].get(name) or reader.parts["bodies"].get(name)
    mass = found.mass if found and reader.known.parts[name] != "bar" else None
    named = mass is not None or name == "ground" or name in reader.known.ends
    if named and (mass is None or reader.value(mass) == 0.0):
        message = f"'masses' is missing: '{name}' has no mass of its own"
        reader.draft.error(path, message, "write masses = [..., ...]")
    return 1.0 if mass is None else mass


FORCES: dict[str, type[Part]] = {
    force.type: force
    for force in (
        *(Spring, Damper, TorsionSpring, TorsionDamper, Force, Torque, JointTorque, Potential),
        *(Gravitation, Actuator),
    )
}
"""Types of forces."""
