"""The words of a scene for its numbers, points and bodies.

Lengths in m, masses in kg, angles in rad. A vector has as many numbers as the scene has dimensions.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal, TypeAlias

from solver.scene.expression import Number

Vector: TypeAlias = tuple[Number, ...]
"""As many numbers as the scene has dimensions."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Parameter:
    """A number with a name, settable in the FMU."""

    value: Number
    """Default; an expression in other parameters makes it a calculated parameter."""
    unit: str = ""
    description: str = ""
    minimum: float | None = None
    maximum: float | None = None
    variability: Literal["fixed", "tunable"] = "fixed"
    """A tunable one may change during a run. Calculated from a tunable one means tunable."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Input:
    """A number that arrives from outside at every communication step."""

    start: float = 0.0
    unit: str = ""
    description: str = ""
    minimum: float | None = None
    maximum: float | None = None
    interpolation: Literal["hold", "ramp"] = "hold"
    """How drivers and forces see it within a communication step: constant, or a straight line from
    the value before to the new one."""
    limit: Literal["refuse", "clip"] = "refuse"
    """What happens to a value beyond `minimum` or `maximum`: an error, or the limit instead."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Point:
    """A point of the mechanism, free or fixed to the ground."""

    position: Vector
    velocity: Vector
    mass: Number = 0.0
    fixed: bool = False
    velocity_given: bool = False
    """Whether the file gives `velocity`; `assemble` is free to choose those it does not give."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Bar:
    """A uniform slender rigid bar between two points."""

    points: tuple[str, str]
    mass: Number


@dataclass(frozen=True, slots=True, kw_only=True)
class Rigid:
    """A rigid body: an origin, axes, and what it weighs; a shape has become mass and inertia."""

    mass: Number
    inertia: Number | tuple[Vector, Vector, Vector]
    """About the centre of mass: a number in 2-D, a symmetric 3 x 3 matrix in body axes in 3-D."""
    center_of_mass: Vector
    """In body axes, from the origin."""
    position: Vector
    """Of the origin."""
    orientation: Number | tuple[Vector, Vector, Vector]
    """An angle in 2-D; in 3-D the rotation matrix, whose columns are the body's axes."""
    velocity: Vector | None = None
    """Of the origin; None: not given, at rest."""
    angular_velocity: Number | Vector | None = None
    """A number in 2-D, a vector in global axes in 3-D; None: not given, at rest."""
    points: dict[str, Vector] = field(default_factory=dict)
    """Named points fixed in the body, in body axes."""


@dataclass(frozen=True, slots=True, kw_only=True)
class PointReference:
    """An end of a joint or force: a point, a point of a body, or a place on body or ground."""

    point: str | None
    """"A" a point, "rod" a body's origin, "rod.tip" a point of a body; None is the ground."""
    at: Vector | None = None
    """Place on the ground. With the name of a body: place on it, as drawn, in global axes."""


Body: TypeAlias = Bar | Rigid
