"""A scene as a whole; the file that a user writes has the same fields.

Lengths in m, masses in kg, times in s, forces in N, angles in rad. A vector has as many numbers as
the scene has dimensions. A ``Number`` that is not a float depends on parameters or, where its kind
allows it, on inputs, the time ``t`` and the mechanism's own quantities.
"""

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from graphlib import TopologicalSorter
from typing import TYPE_CHECKING, Annotated, Any, Literal, NoReturn

from solver.scene import fields as kind
from solver.scene.bodies import BODIES, Body, Point
from solver.scene.contacts import CONTACTS
from solver.scene.drivers import DRIVERS, Constraint
from solver.scene.ellipsoids import ELLIPSOIDS
from solver.scene.expression import Number, Vector, evaluate, symbols
from solver.scene.fields import Part, fields_of, schema_of
from solver.scene.forces import FORCES
from solver.scene.joints import JOINTS
from solver.scene.looks import LOOKS, View
from solver.scene.meshes import MESHES
from solver.scene.mistakes import Path, Problem, SceneError, Source
from solver.scene.named_expressions import Expression
from solver.scene.parameters import DISPLAY_UNIT, TEXT, UNIT, Input, Parameter, settle_units
from solver.scene.profiles import Profile
from solver.scene.rules import OUTPUT
from solver.scene.sensors import SENSORS
from solver.scene.settings import Experiment, Ports, SolverSettings
from solver.scene.shapes import SHAPES
from solver.scene.states import STATES, sampled_states
from solver.scene.surfaces import SURFACES

if TYPE_CHECKING:
    from solver.scene.references import Reader

NAME = re.compile(r"[A-Za-z][A-Za-z0-9_]*")
"""What a name looks like."""
LONGEST = 200
"""Letters of the name of a scene: files and folders have it, and names of these have 255 bytes."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Output(Part):
    """An expression over the mechanism, computed at every communication point."""

    value: Annotated[Number, kind.OfAnyUnit(text="of the mechanism", place=OUTPUT, example="A.x")]
    unit: Annotated[str, UNIT] = ""
    description: Annotated[str, TEXT] = ""
    display_unit: Annotated[str, DISPLAY_UNIT] = ""

    @classmethod
    def read(cls, reader: "Reader", path: Path, given: Any) -> Any:
        """Settle its unit."""
        values = reader.fields(cls, path, given)
        settle_units(reader, path, given, values)
        return cls(**values)


@dataclass(frozen=True)
class Parts(kind.Kind):
    """A table whose keys name parts, of one type or several; or of the fields of one part."""

    noun: str = ""
    """What a key names; empty for one part."""
    types: tuple[type[Part], ...] = ()

    def schema(self) -> dict[str, Any]:
        """JSON Schema, which refers to that of each part."""
        forms: list[dict[str, Any]] = [{"$ref": f"#/$defs/{x.__name__}"} for x in self.types]
        if not self.noun:
            return forms[0] | {"description": (self.types[0].__doc__ or "").partition("\n")[0]}
        if self.types[0].short:
            forms.insert(0, kind.NUMBER.schema())
        one = forms[0] if len(forms) == 1 else {"anyOf": forms}
        text = f"a name for each {self.noun}, and what it is"
        return {"type": "object", "description": text, "additionalProperties": one}


def _table(noun: str, types: Mapping[str, type[Part]] | type[Part]) -> Parts:
    return Parts(noun=noun, types=tuple(types.values()) if isinstance(types, Mapping) else (types,))


@dataclass(frozen=True, slots=True, kw_only=True)
class Scene(Part):
    """A mechanism: format version 1."""

    name: Annotated[
        str, kind.Plain(example="double_pendulum", pattern=f"^(?=.{{1,{LONGEST}}}$){NAME.pattern}$")
    ]
    description: Annotated[str, kind.Plain()] = ""
    dimension: Annotated[Literal[2, 3], kind.Choice(words=(2, 3))] = 3
    gravity: Annotated[Vector, kind.Components("m/s2", "0 by default", example=[0, 0, -9.81])] = (
        0.0,
    ) * 3
    parameters: Annotated[dict[str, Parameter], _table("parameter", Parameter)] = field(
        default_factory=dict
    )
    inputs: Annotated[dict[str, Input], _table("input", Input)] = field(default_factory=dict)
    states: Annotated[dict[str, Part], _table("state", STATES)] = field(default_factory=dict)
    profiles: Annotated[dict[str, Profile], _table("profile", Profile)] = field(
        default_factory=dict
    )
    expressions: Annotated[dict[str, Expression], _table("expression", Expression)] = field(
        default_factory=dict
    )
    points: Annotated[dict[str, Point], _table("point", Point)] = field(default_factory=dict)
    bodies: Annotated[dict[str, Body], _table("body", BODIES)] = field(default_factory=dict)
    joints: Annotated[dict[str, Part], _table("joint", JOINTS)] = field(default_factory=dict)
    constraints: Annotated[dict[str, Constraint], _table("constraint", Constraint)] = field(
        default_factory=dict
    )
    contacts: Annotated[
        dict[str, Part], _table("contact", CONTACTS | SURFACES | SHAPES | ELLIPSOIDS | MESHES)
    ] = field(default_factory=dict)
    forces: Annotated[dict[str, Part], _table("force", FORCES)] = field(default_factory=dict)
    drivers: Annotated[dict[str, Part], _table("driver", DRIVERS)] = field(default_factory=dict)
    sensors: Annotated[dict[str, Part], _table("sensor", SENSORS)] = field(default_factory=dict)
    outputs: Annotated[dict[str, Output], _table("output", Output)] = field(default_factory=dict)
    solver: Annotated[SolverSettings, _table("", SolverSettings)] = field(
        default_factory=SolverSettings
    )
    experiment: Annotated[Experiment, _table("", Experiment)] = field(default_factory=Experiment)
    fmu: Annotated[Ports, _table("", Ports)] = field(default_factory=Ports)
    looks: Annotated[dict[str, Part], _table("look", LOOKS)] = field(default_factory=dict)
    view: Annotated[View, _table("", View)] = field(default_factory=View)
    fits_velocities: bool = field(default=False, repr=False)
    """Whether velocities are made to fit joints, whose axes are not quite as written."""
    source: Source = field(default_factory=Source, repr=False, compare=False)
    """The text it was read from, so that later findings can name file and line."""
    warnings: tuple[Problem, ...] = field(default=(), repr=False, compare=False)
    """What is legal in that text and seldom meant."""

    def values(self, given: Mapping[str, float] | None = None) -> dict[str, float]:
        """Values of parameters and inputs, and the time, at the start; `given` replaces some."""
        values = {name: found.start for name, found in self.inputs.items()}
        values["t"] = self.experiment.start_time
        numbers = {name: parameter.value for name, parameter in self.parameters.items()}
        uses = {name: sorted(symbols(x) & numbers.keys()) for name, x in numbers.items()}
        for name in TopologicalSorter(uses).static_order():
            values[name] = float((given or {}).get(name, evaluate(numbers[name], values)))
        for name, _, _, found in sampled_states(self.states):
            values[name] = float(evaluate(found.start, values))
        return values

    def results(self) -> list[str]:
        """Names of the outputs and of the values of sensors: what reports plot."""
        offered = (
            (name, offer)
            for name, sensor in self.sensors.items()
            for offer in sensor.offered(sensor.given())
        )
        values = (x for name, offer in offered for x, _ in offer.named(name, self.dimension))
        return [*self.outputs, *values]

    def sentences(self) -> tuple[str, ...]:
        """Each warning as it is reported, with its line and help."""
        return tuple(map(self.source.report, self.warnings))

    def error(self, location: str, message: str, help: str | None = None) -> Problem:
        """Describe a mistake found later, such as a rod of zero length, with its line."""
        return self.source.problem(location, message, help)

    def fail(self, problems: Iterable[Problem]) -> NoReturn:
        """Raise ``SceneError`` with all these mistakes, each with its source line."""
        raise SceneError(problems, self.source)


TABLES: dict[str, Parts] = {
    name: found.kind for name, found in fields_of(Scene).items() if isinstance(found.kind, Parts)
}
"""Tables of a scene."""

NOUNS: dict[str, str] = {name: table.noun for name, table in TABLES.items() if table.noun}
"""Tables whose keys are names, and what they name; one name stands for one thing in all tables."""

TYPES: dict[str, dict[str, type[Part]]] = {
    name: {part.type: part for part in table.types}
    for name, table in TABLES.items()
    if table.types[0].type
}
"""Tables whose parts have a type, and the types of this version."""


HEADING = [name for name in fields_of(Scene) if name not in TABLES]
"""What a scene says about itself as a whole."""


def json_schema() -> dict[str, Any]:
    """JSON Schema of a scene file, for completion and checks in an editor."""
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "holonom scene",
        **schema_of(Scene),
        "$defs": {part.__name__: schema_of(part) for x in TABLES.values() for part in x.types},
    }
