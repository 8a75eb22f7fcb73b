"""What may stand at a place of a scene: which symbols an expression mentions, which values fit."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Literal

from solver.scene.quantities import Level


@dataclass(frozen=True, slots=True)
class Place:
    """What an expression may mention at one kind of place."""

    parameters: bool = True
    tunable: bool = True
    time: bool = False
    levels: tuple[Level, ...] = ()
    """Of the mechanism's own quantities."""
    own: tuple[str, ...] = ()
    """Symbols with a meaning at this place alone."""
    of: str = ""
    """The parameter that is being defined; it is not suggested for its own value."""


COORDINATES, LENGTH, ANGLE, RATE = ("x", "y", "z"), "length", "angle", "rate"
ELONGATION, MOTOR_SPEED = "elongation", "motor_speed"
"""Symbols of single places: of a point on a surface, of springs and dampers."""
SETTING = Place(parameters=False, tunable=False)
PARAMETER = PROPERTY = Place()
GEOMETRY = Place(tunable=False)
FORCE = DRIVER = Place(time=True)
LOAD = VELOCITY_ROW = Place(time=True, levels=("position", "rate"))
POTENTIAL = Place(levels=("position",))
CONSTRAINT = Place(time=True, levels=("position",))
OUTPUT = Place(time=True, levels=("position", "rate", "acceleration", "result"))
ANYWHERE = replace(OUTPUT, own=(*COORDINATES, LENGTH, ELONGATION, ANGLE, RATE, MOTOR_SPEED))
"""All that some place allows; a named expression is held against each place that uses it."""


@dataclass(frozen=True, slots=True)
class Rule:
    """A condition on a value, with its words."""

    holds: Callable[[float], bool]
    words: str
    help: str | None = None
    relation: Literal[">", ">="] | None = None
    """To zero, if that is the condition: an FMU checks it again when a parameter changes."""


POSITIVE = Rule(lambda x: x > 0.0, "> 0", relation=">")
NOT_ZERO = Rule(lambda x: x != 0.0, "other than 0")
NOT_NEGATIVE = Rule(lambda x: x >= 0.0, ">= 0", relation=">=")
SHARE = Rule(lambda x: 0.0 <= x <= 1.0, "from 0 to 1", relation=">=")
"""Of restitution; the upper limit is a rule of its own: see ``solver.mechanics.contacts``."""
