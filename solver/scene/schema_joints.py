"""Fields of joints and constraints in a scene file; places and axes as drawn, in global axes."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from solver.scene.fields import (
    Expression,
    Two,
    TwoBodies,
    TwoJoints,
    TwoVectors,
    Vector,
    VectorOrVectors,
)
from solver.scene.schema_part import Part

_PLACE = "m, place of the joint as drawn"
_AXIS = "direction as drawn, of any length"
_AT = "m, place of 'ground', or of each end, as drawn"


class Distance(Part):
    """A massless rod between two points."""

    type: Literal["distance"]
    points: Two
    at: VectorOrVectors | None = Field(None, description=_AT)
    length: Expression | None = Field(None, description="m; as drawn unless given")


class Spherical(Part):
    """Two bodies share a point; or two points are one."""

    type: Literal["spherical"]
    bodies: TwoBodies | None = None
    position: Vector | None = Field(None, examples=[[0, 0, 0]], description=_PLACE)
    points: Two | None = None
    at: VectorOrVectors | None = Field(None, description=_AT)


class Revolute(Part):
    """A hinge; in the plane two bodies share a point, or two points are one."""

    type: Literal["revolute"]
    bodies: TwoBodies | None = None
    position: Vector | None = Field(None, examples=[[0, 0, 0]], description=_PLACE)
    axis: Vector | None = Field(None, examples=[[0, 0, 1]], description=f"{_AXIS}; only in 3-D")
    points: Two | None = None
    at: VectorOrVectors | None = Field(None, description=_AT)


class Universal(Part):
    """A Cardan joint: a cross of two perpendicular axes, one in each body."""

    type: Literal["universal"]
    bodies: TwoBodies
    position: Vector = Field(examples=[[0, 0, 0]], description=_PLACE)
    axes: TwoVectors = Field(description="axis in the first and in the second body, as drawn")


class Cylindrical(Part):
    """The second body turns about an axis of the first and slides along it."""

    type: Literal["cylindrical"]
    bodies: TwoBodies
    position: Vector = Field(examples=[[0, 0, 0]], description=_PLACE)
    axis: Vector = Field(examples=[[0, 0, 1]], description=_AXIS)


class Prismatic(Part):
    """The second body slides along an axis of the first without turning."""

    type: Literal["prismatic"]
    bodies: TwoBodies
    position: Vector | None = Field(None, description=f"{_PLACE}; origin of the second body")
    axis: Vector = Field(examples=[[0, 0, 1]], description=_AXIS)


class Planar(Part):
    """The second body slides on a plane of the first."""

    type: Literal["planar"]
    bodies: TwoBodies
    position: Vector = Field(examples=[[0, 0, 0]], description=_PLACE)
    axis: Vector = Field(examples=[[0, 0, 1]], description="normal of the plane, as drawn")


class Fixed(Part):
    """Two bodies move as one."""

    type: Literal["fixed"]
    bodies: TwoBodies
    position: Vector | None = Field(None, description=f"{_PLACE}; origin of the second body")


class Screw(Part):
    """A cylindrical joint whose turning and sliding go together."""

    type: Literal["screw"]
    bodies: TwoBodies
    position: Vector = Field(examples=[[0, 0, 0]], description=_PLACE)
    axis: Vector = Field(examples=[[0, 0, 1]], description=_AXIS)
    pitch: Expression = Field(examples=[0.005], description="m per turn")


class PointOnLine(Part):
    """A point stays on a line of a body."""

    type: Literal["point_on_line"]
    point: str = Field(examples=["A"])
    at: Vector | None = Field(None, description="m, place on the body that `point` names, as drawn")
    body: str = "ground"
    position: Vector | None = Field(None, description="m, a place of the line as drawn")
    axis: Vector = Field(examples=[[0, 0, 1]], description=_AXIS)


class PointOnPlane(Part):
    """A point stays on a plane of a body."""

    type: Literal["point_on_plane"]
    point: str = Field(examples=["A"])
    at: Vector | None = Field(None, description="m, place on the body that `point` names, as drawn")
    body: str = "ground"
    position: Vector | None = Field(None, description="m, a place of the plane as drawn")
    axis: Vector = Field(examples=[[0, 0, 1]], description="normal of the plane, as drawn")


class PointOnSurface(Part):
    """A point stays on a surface of a body; in the plane on a curve."""

    type: Literal["point_on_surface"]
    point: str = Field(examples=["A"])
    at: Vector | None = Field(None, description="m, place on the body that `point` names, as drawn")
    body: str = "ground"
    surface: Expression = Field(
        examples=["x**2 + y**2 - 1"], description="zero on the surface, in body axes"
    )


class Angle(Part):
    """The angle between an axis of one body and one of another is constant."""

    type: Literal["angle"]
    bodies: TwoBodies
    axes: TwoVectors
    value: Expression | None = Field(None, description="rad; as drawn unless given")


class Gear(Part):
    """angle of the second joint = ratio * angle of the first."""

    type: Literal["gear"]
    joints: TwoJoints
    ratio: Expression = Field(examples=[-2.0])


class Rack(Part):
    """displacement of the second joint = radius * angle of the first."""

    type: Literal["rack"]
    joints: TwoJoints
    radius: Expression = Field(examples=[0.1], description="m, of the pinion")


class Rolling(Part):
    """A thin disc rolls without slip on a plane; in the plane on a line."""

    type: Literal["rolling"]
    body: str = Field(examples=["wheel"])
    radius: Expression = Field(examples=[0.1], description="m")
    axis: Vector | None = Field(None, examples=[[0, 1, 0]], description="of the disc; only in 3-D")
    position: Vector | None = Field(None, description="m, a place of the plane; the origin")
    normal: Vector | None = Field(None, description="towards the disc; +z, in 2-D +y")


class Constraint(Part):
    """An expression that stays zero: of positions, or linear in velocities."""

    value: Expression | None = None
    velocity: Expression | None = None


JOINTS: dict[str, type[Part]] = {
    "distance": Distance,
    "spherical": Spherical,
    "revolute": Revolute,
    "universal": Universal,
    "cylindrical": Cylindrical,
    "prismatic": Prismatic,
    "planar": Planar,
    "fixed": Fixed,
    "point_on_line": PointOnLine,
    "point_on_plane": PointOnPlane,
    "point_on_surface": PointOnSurface,
    "angle": Angle,
    "gear": Gear,
    "rack": Rack,
    "screw": Screw,
    "rolling": Rolling,
}
