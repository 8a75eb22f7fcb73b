"""Schema of the scene file: which tables, which fields, which types (pydantic, version 2).

It judges one part at a time and knows no names of other parts; references, symbols and values are
judged in ``build``. The JSON Schema for editors is generated from here. pydantic takes a third of a
second to import, so only ``load`` imports this module.
"""

from __future__ import annotations

from typing import Any, Literal

from pydantic import BaseModel, ConfigDict, Field, ValidatorFunctionWrapHandler, field_validator

from solver.scene.fields import (
    BROKEN,
    Expression,
    NumberOrVector,
    Two,
    Vector,
    VectorOrVectors,
    mistake,
)
from solver.scene.grammar import Reading


class Part(BaseModel):
    """A table with fixed fields."""

    model_config = ConfigDict(extra="forbid", strict=True, arbitrary_types_allowed=True)

    @field_validator("*", mode="wrap")
    @classmethod
    def _accept_broken(cls, value: object, handler: ValidatorFunctionWrapHandler) -> object:
        if value is None:  # JSON's null; an optional field is left out instead
            raise mistake({"message": "must have a value, got null", "help": "leave it out"})
        return value if value is BROKEN else handler(value)


class Parameter(Part):
    """A number with a name, settable in the FMU."""

    value: Expression = Field(examples=[1.0])
    unit: str = ""
    description: str = ""
    min: Expression | None = None
    max: Expression | None = None
    variability: Literal["fixed", "tunable"] | None = None


class Input(Part):
    """A number that arrives from outside at every communication step."""

    start: Expression = Reading("0", 0.0)
    unit: str = ""
    description: str = ""
    min: Expression | None = None
    max: Expression | None = None


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


class Distance(Part):
    """A massless rod between two points."""

    type: Literal["distance"]
    points: Two
    at: VectorOrVectors | None = Field(None, description="place of 'ground'")
    length: Expression | None = Field(None, description="m; as drawn unless given")


class Spring(Part):
    """A linear spring between two points."""

    type: Literal["spring"]
    points: Two
    at: VectorOrVectors | None = Field(None, description="place of 'ground'")
    stiffness: Expression = Field(examples=[100.0], description="N/m")
    free_length: Expression | None = Field(None, description="m; as drawn unless given")


class Damper(Part):
    """A linear damper between two points."""

    type: Literal["damper"]
    points: Two
    at: VectorOrVectors | None = Field(None, description="place of 'ground'")
    damping: Expression = Field(examples=[1.0], description="N.s/m")


class Force(Part):
    """A force on a point, in global axes."""

    type: Literal["force"]
    point: str = Field(examples=["A"])
    value: Vector = Field(examples=[[0, 0, 1]], description="N")


class Torque(Part):
    """A torque on a bar."""

    type: Literal["torque"]
    body: str = Field(examples=["crank"])
    value: NumberOrVector = Field(
        examples=[1.0], description="N.m: a number in 2-D, a vector in 3-D"
    )


class Output(Part):
    """An expression over the mechanism."""

    value: Expression = Field(examples=["A.x"])
    unit: str = ""
    description: str = ""


class Solver(Part):
    """The method and its settings."""

    formulation: Literal[
        "conserving-al", "midpoint-al", "conserving-penalty", "midpoint-penalty", "penalty-velocity"
    ] = "conserving-al"
    algorithm: Literal["nested", "simultaneous"] = "nested"
    multiplier_update: Literal["end", "paper"] = "end"
    order: Literal[2] = 2
    paired: bool = True
    step_size: Expression | None = Field(None, description="s, at most the communication step")
    tolerance: Expression | None = None
    penalty: Expression | None = None
    xi: Expression | None = None
    omega: Expression | None = Field(None, description="rad/s")
    max_newton: int = 20
    max_uzawa: int = 20


class Experiment(Part):
    """Default run of the FMU."""

    start_time: Expression | None = Field(None, description="s")
    stop_time: Expression | None = Field(None, description="s")
    step_size: Expression | None = Field(None, description="s, the communication step")
    tolerance: Expression | None = None


class Heading(Part):
    """What a scene says about itself as a whole."""

    name: str = Field(
        examples=["double_pendulum"], json_schema_extra={"pattern": "^[A-Za-z][A-Za-z0-9_]*$"}
    )
    description: str = ""
    dimension: Literal[2, 3] = 3
    gravity: Vector | None = Field(None, examples=[[0, 0, -9.81]], description="m/s2")


class File(Heading):
    """A mechanism: format version 1."""

    parameters: dict[str, Expression | Parameter] = {}
    inputs: dict[str, Input] = {}
    points: dict[str, Point] = {}
    bodies: dict[str, Bar] = {}
    joints: dict[str, Distance] = {}
    forces: dict[str, Spring | Damper | Force | Torque] = {}
    outputs: dict[str, Output] = {}
    solver: Solver | None = None
    experiment: Experiment | None = None


TYPES: dict[str, dict[str, type[Part]]] = {
    "bodies": {"bar": Bar},
    "joints": {"distance": Distance},
    "forces": {"spring": Spring, "damper": Damper, "force": Force, "torque": Torque},
}
"""Tables whose parts have a type, and the types of this version."""

PARTS: dict[str, type[Part]] = {
    "parameters": Parameter,
    "inputs": Input,
    "points": Point,
    "outputs": Output,
}
"""Tables of parts of one kind."""


def json_schema() -> dict[str, Any]:
    """JSON Schema of a scene file, for completion and checks in an editor."""
    head = {"$schema": "https://json-schema.org/draft/2020-12/schema", "title": "holonom scene"}
    return head | _without_null(File.model_json_schema())


def _without_null(schema: Any) -> Any:
    """A field that may be missing is optional, not null: TOML has no null."""
    if isinstance(schema, list):
        return [_without_null(item) for item in schema]
    if not isinstance(schema, dict):
        return schema
    kept = {
        key: _without_null(value)
        for key, value in schema.items()
        if not (key == "default" and value is None) and key != "title"
    }
    options = [option for option in kept.get("anyOf", []) if option != {"type": "null"}]
    if len(options) == 1:
        del kept["anyOf"]
        return options[0] | kept
    return kept | ({"anyOf": options} if options else {})
