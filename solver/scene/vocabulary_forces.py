"""The words of a scene for what moves it: forces, torques, potentials, and prescribed motions.

Forces in N, torques in N.m, energies in J, the time ``t`` in s. A ``Number`` here may depend on the
time and on inputs, that of a force or torque also on the mechanism's own quantities.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, TypeAlias

from solver.scene.expression import Number
from solver.scene.vocabulary_parts import PointReference, Vector


@dataclass(frozen=True, slots=True, kw_only=True)
class Spring:
    """A spring between two points: linear, or with an energy that depends on its length."""

    points: tuple[PointReference, PointReference]
    stiffness: Number | None = None
    """None where `energy` is given."""
    free_length: Number | None = None
    """None: as drawn."""
    energy: Number | None = None
    """Stored energy in J, an expression in the symbol ``length`` (m)."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Damper:
    """A linear damper between two points."""

    points: tuple[PointReference, PointReference]
    damping: Number


@dataclass(frozen=True, slots=True, kw_only=True)
class TorsionSpring:
    """A torsion spring at a joint that has an angle: stiffness * (angle - free_angle)."""

    joint: str
    stiffness: Number
    free_angle: Number = 0.0
    """0 is the drawn configuration."""


@dataclass(frozen=True, slots=True, kw_only=True)
class TorsionDamper:
    """A torsion damper at a joint that has an angle."""

    joint: str
    damping: Number


@dataclass(frozen=True, slots=True, kw_only=True)
class JointTorque:
    """A torque about a joint's angle: positive on the second body, negative on the first."""

    joint: str
    value: Number


@dataclass(frozen=True, slots=True, kw_only=True)
class Force:
    """A force on a point or on a point of a body, in global or in the body's axes."""

    point: PointReference
    value: Vector
    axes: Literal["global", "body"] = "global"


@dataclass(frozen=True, slots=True, kw_only=True)
class Torque:
    """A torque on a body: one number in 2-D, a vector in global or body axes in 3-D."""

    body: str
    value: Number | Vector
    axes: Literal["global", "body"] = "global"


@dataclass(frozen=True, slots=True, kw_only=True)
class Potential:
    """A potential energy in J: an expression over positions of the mechanism."""

    value: Number


@dataclass(frozen=True, slots=True, kw_only=True)
class Gravitation:
    """Attraction of two masses, V = -constant m1 m2/distance."""

    points: tuple[PointReference, PointReference]
    masses: tuple[Number, Number]
    constant: Number = 6.6743e-11
    """In m^3/(kg s^2); CODATA 2018."""


@dataclass(frozen=True, slots=True, kw_only=True)
class PositionDriver:
    """A point follows a path: one expression in time, inputs and parameters for each axis."""

    point: PointReference
    value: Vector


@dataclass(frozen=True, slots=True, kw_only=True)
class DistanceDriver:
    """The distance of two points follows an expression in time, inputs and parameters."""

    points: tuple[PointReference, PointReference]
    value: Number


@dataclass(frozen=True, slots=True, kw_only=True)
class JointDriver:
    """Angle or displacement of a joint, both zero as drawn, follows an expression."""

    type: Literal["angle", "displacement"]
    joint: str
    value: Number


ForceElement: TypeAlias = (
    Spring | Damper | TorsionSpring | TorsionDamper | JointTorque | Force | Torque | Potential
    | Gravitation
)  # fmt: skip
Driver: TypeAlias = PositionDriver | DistanceDriver | JointDriver
