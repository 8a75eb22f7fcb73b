"""Quantities of a mechanism, declared by the parts that offer them.

``A.x`` of a point, ``bearing.angle`` of a joint, ``buffer.force`` of a spring, ``energy.total`` of
the whole: the variables of the FMU, which expressions may mention. Positions and rates are known
before forces and multipliers are, so forces and constraints may mention those; everything else may
stand in outputs alone.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, Literal, TypeAlias

Level: TypeAlias = Literal["state", "position", "rate", "acceleration", "result"]
"""Of what is held between ticks, of the drawn and moved configuration, of its velocities, of what
all forces bring about, or of the solution as a whole."""

Axes: TypeAlias = tuple[Sequence[str], Sequence[str]]
"""Axes of the components that a quantity has, in the plane and in space."""

SCALAR: Axes = ("",), ("",)
VECTOR: Axes = "xy", "xyz"
ROTATION: Axes = "z", "xyz"
"""Of a torque, which in the plane is about z."""
SCALAR_IN_THE_PLANE: Axes = ("",), ()
ROTATION_IN_SPACE: Axes = (), "xyz"
QUATERNION: Axes = (), "wxyz"


@dataclass(frozen=True, slots=True)
class Offer:
    """A quantity that a part offers.

    Attributes
    ----------
    word : str
        What stands behind the name of the part; the axis of a component stands for ``{}``.
    unit : str
    text : str
        Description; ``{name}`` and ``{part}`` are those of the part, ``{axis}`` the component's.
    """

    word: str
    unit: str
    text: str
    level: Level = "result"
    axes: Axes = SCALAR
    on_demand: bool = False
    """Whether it is measured, and a variable, only where it is named: in formulas of outputs, among
    the outputs of [fmu], in a plot, or by whoever assembles the scene."""

    def words(self, dimension: int) -> Iterator[tuple[str, str]]:
        """Axis and word of each component in a scene of this dimension."""
        for axis in self.axes[dimension - 2]:
            yield axis, self.word.format(axis)

    def named(self, name: str, dimension: int, part: Any = None) -> Iterator[tuple[str, str]]:
        """Name and description of each component, of a part of this name."""
        for axis, word in self.words(dimension):
            yield f"{name}.{word}", self.text.format(name=name, part=part, axis=axis)


def quantities(
    offered: Mapping[str, Iterable[Offer]], dimension: int, touches: bool = False
) -> dict[str, Level]:
    """Names of all quantities, each with its level, from what is offered under each name.

    `touches` says that the scene has contacts, or friction of joints.
    """
    of_contacts = WHOLE_OF_CONTACTS.items() if touches else ()
    return {
        f"{name}.{word}": offer.level
        for name, offers in (*offered.items(), *WHOLE.items(), *of_contacts)
        for offer in offers
        for _, word in offer.words(dimension)
    }


MOTION = (
    Offer("{}", "m", "position of {name}, {axis} component", "position", VECTOR),
    Offer("v{}", "m/s", "velocity of {name}, {axis} component", "rate", VECTOR),
    Offer(
        "a{}", "m/s2", "acceleration of {name}, {axis} component", "acceleration", VECTOR,
        on_demand=True,
    ),
)  # fmt: skip
"""Of a place."""


def angular_acceleration(axes: Axes = SCALAR) -> Offer:
    """Return what a body or joint with one angle offers."""
    text = "angular acceleration of {name}"
    return Offer("angular_acceleration", "rad/s2", text, "acceleration", axes, on_demand=True)


POWER = Offer(
    "power", "W", "power of {name}: positive while it gives energy to the mechanism",
    on_demand=True,
)  # fmt: skip
"""Of a force."""


def _results(unit: str, texts: Mapping[str, str]) -> tuple[Offer, ...]:
    return tuple(Offer(word, unit, text) for word, text in texts.items())


WHOLE: dict[str, tuple[Offer, ...]] = {
    "energy": (
        *_results("J", {
            "kinetic": "kinetic energy",
            "potential": "energy of gravity, springs and potentials",
            "total": "kinetic and potential energy",
            "work": "work done by forces, torques, drivers and inputs since the start",
            "dissipated": "energy taken out by dampers, friction and impacts since the start",
            "balance": "total - initial - work + dissipated: zero up to round-off",
        }),
        Offer("error", "1", "size of the balance over the reference energy"),
    ),
    "constraint": (
        Offer("position", "1", "largest constraint residual over the size of its row"),
        Offer(
            "velocity", "1/s", "largest rate of a constraint residual over the size of its row; a "
            "discretization error, which at order 2 falls with the square of the step",
        ),
    ),
    "momentum": (Offer("{}", "kg.m/s", "linear momentum, {axis} component", axes=VECTOR),),
    "angular_momentum": (
        Offer(
            "{}", "kg.m2/s", "angular momentum about the origin, {axis} component", axes=ROTATION
        ),
    ),
    "solver": _results("1", {
        "newton_iterations": "Newton iterations, and accelerations of explicit steps, of the last "
        "communication step",
        "uzawa_iterations": "Uzawa updates of the last communication step",
        "substeps": "half steps, and stages of explicit steps, of the last communication step",
        "order_in_use": "order of the last internal step, 0 before it",
        "method_in_use": "of the last internal step: 1 conserving, 2 explicit, 0 before it",
        "error_estimate": "estimated error of the run so far, relative to size and speed as a "
        "tolerance is, of equal steps over the size or in rad; 0 where nothing estimates it",
        "as_pairs": "steps of the last communication step taken as pairs of half steps, of order "
        "2, since a damper or friction would have given energy at their order, or equal steps are "
        "too long for it",
        "sampling": "for forces that read the motion: part of their work that they missed, as they "
        "are evaluated once in a half step; above 1 the step is too long",
        "coarseness": "of equal steps so far: largest turn of a body in one, or without contacts "
        "their estimated error, over what leaves the path right within 2 %; above 1 they are too "
        "long",
        "status": "0 after a solved step, else the code of what failed",
    }),
}  # fmt: skip
"""Quantities of the mechanism as a whole, by the name before the dot."""

WHOLE_OF_CONTACTS: dict[str, tuple[Offer, ...]] = {
    "energy": _results("J", {
        "damping": "energy taken out by dampers since the start",
        "friction": "energy taken out by friction since the start, without that of impacts",
        "impact": "energy taken out by impacts since the start, with their friction",
    }),
    "solver": _results("1", {
        "events": "impacts, other changes of contacts and switches of laws in the last "
        "communication step",
        "stepped": "1 if the last communication step was not cut at its impacts, else 0",
        "jams": "impacts in the last communication step that jammed by strong friction",
        "newton_impacts": "impacts in the last communication step by Newton's restitution, where "
        "the energetic law found no impulses",
        "mixed_impacts": "impacts of stepped contacts in the last communication step not by the "
        "law alone: friction would give back more than it took, or too much touches",
        "deferred_frictions": "pieces of half steps of stepped contacts in the last communication "
        "step whose friction acted at their end alone, since no choice agreed with the forces",
    }),
}  # fmt: skip
"""Likewise where there are contacts, or friction of joints."""

CONTACT = (
    Offer("gap", "m", "gap of {name}, zero while it touches"),
    Offer("force", "N", "normal force of {name}, never negative"),
    Offer("mode", "1", "0 while {name} is open, 1 while it is closed, 2 while it slides"),
    Offer("impacts", "1", "number of impacts of {name} since the start"),
    Offer("impulse", "N.s", "sum of the normal impulses of {name} since the start"),
)
"""Of a contact."""

COMPLIANT = (
    Offer("gap", "m", "gap of {name}, negative while it is pressed in"),
    Offer("force", "N", "normal force of {name}, never negative"),
)
"""Of a compliant contact."""

FRICTION = (
    Offer("friction", "N", "friction force of {name}; in space its size"),
    Offer("slip", "m/s", "slip rate of {name}; in space its size"),
)
"""Of one that rubs."""

_TURNING = {"m": "rad", "m/s": "rad/s", "N": "N.m", "N.s": "N.m.s"}


def turning(offers: Iterable[Offer]) -> tuple[Offer, ...]:
    """Return quantities of a length and force as those of an angle and torque."""
    return tuple(replace(offer, unit=_TURNING.get(offer.unit, offer.unit)) for offer in offers)


def place_in_whole(name: str, word: str) -> int:
    """Index of a word among the quantities of that name, none of which has components."""
    return [offer.word for offer in WHOLE[name]].index(word)
