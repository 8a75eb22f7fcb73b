"""Fields of forces and drivers in a scene file."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from solver.scene.fields import (
    Expression,
    NumberOrVector,
    Two,
    TwoNumbers,
    Vector,
    VectorOrVectors,
)
from solver.scene.schema_part import Part

_AT = "m, place of 'ground', or of each end, as drawn"
_ON = "m, place on the body that `point` names, as drawn"


class Spring(Part):
    """A spring between two points: linear, or with an energy that depends on its length."""

    type: Literal["spring"]
    points: Two
    at: VectorOrVectors | None = Field(None, description=_AT)
    stiffness: Expression | None = Field(None, examples=[100.0], description="N/m")
    free_length: Expression | None = Field(None, description="m; as drawn unless given")
    energy: Expression | None = Field(None, description="J, an expression in `length`")


class Damper(Part):
    """A linear damper between two points."""

    type: Literal["damper"]
    points: Two
    at: VectorOrVectors | None = Field(None, description=_AT)
    damping: Expression = Field(examples=[1.0], description="N.s/m")


class TorsionSpring(Part):
    """A torsion spring at a joint that has an angle."""

    type: Literal["torsion_spring"]
    joint: str = Field(examples=["bearing"])
    stiffness: Expression = Field(examples=[10.0], description="N.m/rad")
    free_angle: Expression | None = Field(None, description="rad; 0, as drawn, unless given")


class TorsionDamper(Part):
    """A torsion damper at a joint that has an angle."""

    type: Literal["torsion_damper"]
    joint: str = Field(examples=["bearing"])
    damping: Expression = Field(examples=[1.0], description="N.m.s/rad")


class JointTorque(Part):
    """A torque about a joint's angle, on the second body; the opposite one on the first."""

    type: Literal["joint_torque"]
    joint: str = Field(examples=["bearing"])
    value: Expression = Field(examples=[1.0], description="N.m")


class Force(Part):
    """A force on a point, in global or body axes."""

    type: Literal["force"]
    point: str = Field(examples=["A"])
    at: Vector | None = Field(None, description=_ON)
    value: Vector = Field(examples=[[0, 0, 1]], description="N")
    axes: Literal["global", "body"] = "global"


class Torque(Part):
    """A torque on a body."""

    type: Literal["torque"]
    body: str = Field(examples=["crank"])
    value: NumberOrVector = Field(
        examples=[1.0], description="N.m: a number in 2-D, a vector in 3-D"
    )
    axes: Literal["global", "body"] = "global"


class Potential(Part):
    """A potential energy, an expression over positions of the mechanism."""

    type: Literal["potential"]
    value: Expression = Field(examples=["2.0*A.x**2"], description="J")


class Gravitation(Part):
    """Attraction of two masses."""

    type: Literal["gravitation"]
    points: Two
    at: VectorOrVectors | None = Field(None, description=_AT)
    masses: TwoNumbers | None = Field(None, description="kg; those of the points unless given")
    constant: Expression | None = Field(None, description="m3/(kg.s2); 6.6743e-11 unless given")


class PositionDriver(Part):
    """A point follows a path."""

    type: Literal["position"]
    point: str = Field(examples=["A"])
    at: Vector | None = Field(None, description=_ON)
    value: Vector = Field(examples=[[0, 0, "sin(t)"]], description="m")


class DistanceDriver(Part):
    """The distance of two points follows an expression."""

    type: Literal["distance"]
    points: Two
    at: VectorOrVectors | None = Field(None, description=_AT)
    value: Expression = Field(examples=["1 + 0.1*sin(t)"], description="m")


class AngleDriver(Part):
    """The angle of a joint follows an expression."""

    type: Literal["angle"]
    joint: str = Field(examples=["bearing"])
    value: Expression = Field(examples=["2*pi*t"], description="rad, 0 as drawn")


class DisplacementDriver(Part):
    """The displacement of a joint follows an expression."""

    type: Literal["displacement"]
    joint: str = Field(examples=["guide"])
    value: Expression = Field(examples=["0.1*sin(t)"], description="m, 0 as drawn")


FORCES: dict[str, type[Part]] = {
    "spring": Spring,
    "damper": Damper,
    "torsion_spring": TorsionSpring,
    "torsion_damper": TorsionDamper,
    "force": Force,
    "torque": Torque,
    "joint_torque": JointTorque,
    "potential": Potential,
    "gravitation": Gravitation,
}

DRIVERS: dict[str, type[Part]] = {
    "position": PositionDriver,
    "distance": DistanceDriver,
    "angle": AngleDriver,
    "displacement": DisplacementDriver,
}
