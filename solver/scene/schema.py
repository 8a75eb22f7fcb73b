"""Schema of the scene file: which tables, which fields, which types (pydantic, version 2).

It judges one part at a time and knows no names of other parts; references, symbols and values are
judged in ``build``. The JSON Schema for editors is generated from here. pydantic takes a third of a
second to import, so only ``load`` imports this module.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Literal, Optional, Union

from pydantic import Field, create_model

from solver.options import OPTIONS, Option
from solver.scene.fields import Expression, Vector
from solver.scene.grammar import Reading
from solver.scene.schema_bodies import BODIES, Point
from solver.scene.schema_forces import DRIVERS, FORCES
from solver.scene.schema_joints import JOINTS, Constraint
from solver.scene.schema_part import Part


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

    start: Expression = Field(Reading(0.0, 0.0), json_schema_extra={"default": 0})
    unit: str = ""
    description: str = ""
    min: Expression | None = None
    max: Expression | None = None
    interpolation: Literal["hold", "ramp"] = "hold"
    limit: Literal["refuse", "clip"] = "refuse"


class Output(Part):
    """An expression over the mechanism."""

    value: Expression = Field(examples=["A.x"])
    unit: str = ""
    description: str = ""


def _field(option: Option) -> tuple[Any, Any]:
    """Return type and default of a setting; numbers may be expressions."""
    description = ", ".join(filter(None, (option.unit, option.meaning)))
    if option.words:
        return Literal[option.words], Field(option.default, description=description)
    if option.is_switch:
        return bool, Field(option.default, description=description)
    if option.allowed:
        return Literal[tuple(map(int, option.allowed))], Field(
            int(option.default), description=description
        )
    if option.whole:
        return int, Field(int(option.default), description=description)
    return Optional[Expression], Field(None, description=description)  # noqa: UP045


if TYPE_CHECKING:

    class Solver(Part):
        """The method and its settings."""

else:
    Solver = create_model(
        "Solver",
        __base__=Part,
        __doc__="The method and its settings.",
        **{name: _field(option) for name, option in OPTIONS.items()},
    )


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


AnyBody = Union[tuple(BODIES.values())]  # noqa: UP007
AnyJoint = Union[tuple(JOINTS.values())]  # noqa: UP007
AnyForce = Union[tuple(FORCES.values())]  # noqa: UP007
AnyDriver = Union[tuple(DRIVERS.values())]  # noqa: UP007


class File(Heading):
    """A mechanism: format version 1."""

    parameters: dict[str, Expression | Parameter] = Field({})
    inputs: dict[str, Input] = Field({})
    points: dict[str, Point] = Field({})
    bodies: dict[str, AnyBody] = Field({})  # pyright: ignore[reportInvalidTypeForm]
    joints: dict[str, AnyJoint] = Field({})  # pyright: ignore[reportInvalidTypeForm]
    constraints: dict[str, Constraint] = Field({})
    forces: dict[str, AnyForce] = Field({})  # pyright: ignore[reportInvalidTypeForm]
    drivers: dict[str, AnyDriver] = Field({})  # pyright: ignore[reportInvalidTypeForm]
    outputs: dict[str, Output] = Field({})
    solver: Solver | None = None
    experiment: Experiment | None = None


TYPES: dict[str, dict[str, type[Part]]] = {
    "bodies": BODIES,
    "joints": JOINTS,
    "forces": FORCES,
    "drivers": DRIVERS,
}
"""Tables whose parts have a type, and the types of this version."""

PARTS: dict[str, type[Part]] = {
    "parameters": Parameter,
    "inputs": Input,
    "points": Point,
    "constraints": Constraint,
    "outputs": Output,
}
"""Tables of parts of one kind."""


ONLY_IN_SPACE: dict[str, str] = {
    "spherical": "in the plane 'revolute' lets two bodies share a point",
    "universal": "in the plane bodies turn about one axis only: 'revolute'",
    "cylindrical": "in the plane write 'prismatic', or 'point_on_line' for a pin in a slot",
    "planar": "in the plane it has no effect: leave it out",
    "point_on_plane": "in the plane write 'point_on_line'",
    "angle": "in the plane write 'prismatic', which keeps the angle of two bodies",
    "screw": "in the plane write 'rack'",
}
"""Types of joints that the plane does not have, and what it has instead."""


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
