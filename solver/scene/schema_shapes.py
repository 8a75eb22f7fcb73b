"""Fields of a body's attitude, spin and shape in a scene file."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from solver.scene.fields import Expression, Vector
from solver.scene.schema_part import Part


class Orientation(Part):
    """Attitude of a body in space; one of the four ways."""

    axis: Vector | None = None
    angle: Expression | None = Field(None, description="rad")
    quaternion: list[Expression] | None = Field(None, description="[w, x, y, z]")
    rotation_vector: Vector | None = Field(None, description="rad")
    matrix: list[Vector] | None = Field(None, description="columns are the body's axes")


class InBodyAxes(Part):
    """A vector in the axes of the body."""

    body: Vector = Field(examples=[[0, 0, 1]])


class Box(Part):
    """A cuboid; in the plane a rectangle."""

    type: Literal["box"]
    size: Vector = Field(examples=[[0.2, 0.1, 0.1]], description="m, along x, y, z")
    density: Expression | None = Field(None, description="kg/m3; in 2-D kg/m2")


class Cylinder(Part):
    """A cylinder, or a tube."""

    type: Literal["cylinder"]
    radius: Expression = Field(examples=[0.1], description="m")
    length: Expression = Field(examples=[1.0], description="m")
    inner_radius: Expression | None = Field(None, description="m")
    axis: Literal["x", "y", "z"] = "z"
    density: Expression | None = Field(None, description="kg/m3")


class Sphere(Part):
    """A ball, or a hollow one."""

    type: Literal["sphere"]
    radius: Expression = Field(examples=[0.1], description="m")
    inner_radius: Expression | None = Field(None, description="m")
    density: Expression | None = Field(None, description="kg/m3")


class Disc(Part):
    """A disc in the plane, or a ring."""

    type: Literal["disc"]
    radius: Expression = Field(examples=[0.1], description="m")
    inner_radius: Expression | None = Field(None, description="m")
    density: Expression | None = Field(None, description="kg/m2")


class Rod(Part):
    """A slender rod in the plane, along x."""

    type: Literal["rod"]
    length: Expression = Field(examples=[1.0], description="m")
    density: Expression | None = Field(None, description="kg/m")


SHAPES: dict[int, dict[str, type[Part]]] = {
    2: {"box": Box, "disc": Disc, "rod": Rod},
    3: {"box": Box, "cylinder": Cylinder, "sphere": Sphere},
}
"""Shapes that a rigid body may have, by dimension."""
