"""Fields of points and bodies in a scene file, and of what a body's shape and attitude may be."""

# pyright: reportInvalidTypeForm=false
from __future__ import annotations

from typing import Annotated, Any, Literal, NoReturn, TypeAlias

from pydantic import Field, PlainValidator, WithJsonSchema

from solver.scene.fields import (
    Expression,
    NumberToMatrix,
    Two,
    Vector,
    by_shape,
    mistake,
    shown,
)
from solver.scene.schema_part import Part
from solver.scene.schema_shapes import SHAPES, InBodyAxes, Orientation


def _table(*models: type[Part]) -> Any:
    """Type of a nested table, which the reader of the part checks against one of these models."""
    options = [model.model_json_schema() for model in models]
    schema = {"anyOf": options} if len(options) > 1 else options[0]
    return Annotated[dict[str, Any], WithJsonSchema(schema)]


Shape: TypeAlias = _table(*(SHAPES[3] | SHAPES[2]).values())


def _no_list(value: object) -> NoReturn:
    message = f"must be a number in dimension 2 and a table in dimension 3, got {shown(value)}"
    help = 'angles are in rad: write for instance { axis = [0, 1, 0], angle = "pi/2" }'
    raise mistake({"message": message, "help": help})


_NoList = Annotated[Expression, PlainValidator(_no_list)]
AngleOrAttitude: TypeAlias = by_shape(Expression, _table(Orientation), _NoList, _NoList)
Spin: TypeAlias = by_shape(Expression, _table(InBodyAxes), Vector, Vector)


class Point(Part):
    """A point, free or fixed to the ground."""

    position: Vector = Field(examples=[[0, 0, 0]], description="m, as drawn")
    velocity: Vector | None = Field(None, examples=[[0, 0, 0]], description="m/s at the start")
    mass: Expression | None = Field(None, description="kg")
    fixed: bool = False


class Bar(Part):
    """A uniform slender rigid bar between two points."""

    type: Literal["bar"]
    points: Two
    mass: Expression = Field(examples=[1.0], description="kg")


class Rigid(Part):
    """A rigid body: an origin, axes, mass and inertia, or a shape."""

    type: Literal["rigid"] = "rigid"
    mass: Expression | None = Field(None, description="kg")
    inertia: NumberToMatrix | None = Field(
        None,
        description="kg.m2 about the centre of mass: a number in 2-D, [Jx, Jy, Jz] or 3 x 3 in 3-D",
    )
    center_of_mass: Vector | None = Field(None, description="m, in body axes, from the origin")
    position: Vector = Field(examples=[[0, 0, 0]], description="m, of the origin, as drawn")
    orientation: AngleOrAttitude | None = Field(
        None,
        description="rad in 2-D; in 3-D { axis, angle }, { quaternion }, { rotation_vector } or "
        "{ matrix }",
    )
    velocity: Vector | None = Field(None, description="m/s, of the origin, at the start")
    angular_velocity: Spin | None = Field(
        None, description="rad/s: a number in 2-D; in 3-D a vector, or { body = [...] }"
    )
    shape: Shape | None = Field(
        None, description="box, cylinder or sphere; in 2-D box, disc or rod; with a density or mass"
    )
    points: dict[str, Vector] = Field({}, description="m, named points in body axes")


BODIES: dict[str, type[Part]] = {"rigid": Rigid, "bar": Bar}
