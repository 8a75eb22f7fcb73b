"""Names of all that a user reads or sets, in one table, and what symbols of expressions mean."""

from __future__ import annotations

from collections.abc import Iterator

from solver.mechanics.parts import Parts
from solver.mechanics.tape import Segment
from solver.runtime.model import Variable
from solver.runtime.options import DEFAULTS, MEANINGS, RANGES
from solver.scene import Expr, Number, Scene
from solver.scene.expression import sqrt, symbol

AXES = "xyz"

ENERGIES = {
    "kinetic": "kinetic energy",
    "potential": "energy of gravity, springs and penalties",
    "total": "kinetic and potential energy",
    "work": "work done by forces, torques and inputs since the start",
    "dissipated": "energy taken out by dampers since the start",
    "balance": "total - initial - work + dissipated: zero up to round-off",
    "error": "size of the balance over the reference energy",
}

COUNTERS = {
    "newton_iterations": "Newton iterations of the last communication step",
    "uzawa_iterations": "Uzawa updates of the last communication step",
    "substeps": "implicit steps solved in the last communication step",
    "status": "0 after a step that was solved, else the reason why it was not",
}


def _vector(name: str, unit: str, text: str, dim: int) -> Iterator[tuple[str, str, str]]:
    for axis in AXES[:dim]:
        yield f"{name}{axis}", unit, f"{text}, {axis} component"


def measured(parts: Parts) -> Iterator[tuple[str, str, str]]:
    """Name, unit and description of each measurement, in the kernel's order."""
    dim = parts.dim
    for name in parts.free_names:
        yield from _vector(f"{name}.", "m", f"position of {name}", dim)
    for name in parts.free_names:
        yield from _vector(f"{name}.v", "m/s", f"velocity of {name}", dim)
    for name in parts.angle_names:
        yield f"{name}.angle", "rad", f"angle of {name} from the x axis, unwrapped"
    for name in parts.angle_names:
        yield f"{name}.angular_velocity", "rad/s", f"angular velocity of {name}"
    for name in parts.line_names:
        yield f"{name}.length", "m", f"length of {name}"
    for name in parts.line_names:
        yield f"{name}.force", "N", f"force in {name}, positive in tension"
    for label, name in zip(parts.row_labels, parts.row_force_name, strict=True):
        yield name or "", "N", f"force in {label}, positive in tension"
    for name, text in ENERGIES.items():
        yield f"energy.{name}", "1" if name == "error" else "J", text
    yield "constraint.position", "1", "largest |Phi|/l^2 of the constraints"
    yield "constraint.velocity", "1/s", "largest |dPhi/dt|/l^2 of the constraints"
    yield from _vector("momentum.", "kg.m/s", "linear momentum", dim)
    for axis in AXES if dim == 3 else "z":
        yield f"angular_momentum.{axis}", "kg.m2/s", f"angular momentum about the origin, {axis}"
    for name, text in COUNTERS.items():
        yield f"solver.{name}", "1", text


def meanings(scene: Scene, parts: Parts) -> dict[str, tuple[str, int, Segment] | Number]:
    """What each symbol of an expression stands for: a place with its segment, or an expression."""
    table: dict[str, tuple[str, int, Segment] | Number] = {"t": ("time", 0, Segment.LAWS)}
    for place, (name, _, _) in enumerate(measured(parts)):
        if name:
            table[name] = ("measured", place, Segment.OUTPUTS)
    for name, point in scene.points.items():
        if point.fixed:
            for axis, number in zip(AXES, point.position, strict=False):
                table[f"{name}.{axis}"] = number
                table[f"{name}.v{axis}"] = 0.0
    place = 0
    for name, parameter in scene.parameters.items():
        if isinstance(parameter.value, Expr):
            table[name] = parameter.value
            continue
        tunable = parameter.variability == "tunable"
        table[name] = ("parameter", place, Segment.LAWS if tunable else Segment.PARAMETERS)
        place += 1
    for place, name in enumerate(scene.inputs):
        table[name] = ("input", place, Segment.LAWS)
    return table


def distance_between(dim: int, call: Expr) -> Number:
    """Return the expression of ``distance(A, B)`` in the coordinates of its points."""
    function, first, second = (str(arg) for arg in call.args)
    assert function == "distance"
    total: Number = 0.0
    for axis in AXES[:dim]:
        gap = symbol(f"{second}.{axis}") - symbol(f"{first}.{axis}")
        total = total + gap * gap
    return sqrt(total)


def variable_table(
    scene: Scene, parts: Parts, output_places: dict[str, int], calculated: dict[str, int]
) -> tuple[Variable, ...]:
    """Return all variables: parameters, inputs, settings, outputs of the scene, measurements."""
    return (
        *_parameters(scene, calculated),
        *(
            Variable(
                name=name, type="Real", causality="input", variability="continuous",
                unit=given.unit, description=given.description, start=given.start,
                minimum=given.minimum, maximum=given.maximum, kind="input", place=place,
            )
            for place, (name, given) in enumerate(scene.inputs.items())
        ),
        *_settings(scene),
        *(
            Variable(
                name=name, type="Real", causality="output", variability="continuous",
                unit=output.unit, description=output.description, kind="number",
                place=output_places[name],
            )
            for name, output in scene.outputs.items()
        ),
        *(
            Variable(
                name=name, type="Real", causality="output", variability="continuous", unit=unit,
                description=text, place=place,
            )
            for place, (name, unit, text) in enumerate(measured(parts))
            if name
        ),
    )  # fmt: skip


def _parameters(scene: Scene, calculated: dict[str, int]) -> Iterator[Variable]:
    place = 0
    for name, given in scene.parameters.items():
        free = not isinstance(given.value, Expr)
        yield Variable(
            name=name, type="Real", causality="parameter" if free else "calculatedParameter",
            variability=given.variability, unit=given.unit, description=given.description,
            start=None if isinstance(given.value, Expr) else float(given.value),
            minimum=given.minimum, maximum=given.maximum,
            kind="parameter" if free else "number", place=place if free else calculated[name],
        )  # fmt: skip
        place += free


def _settings(scene: Scene) -> Iterator[Variable]:
    for name, default in DEFAULTS.items():
        start = getattr(scene.solver, name, default)
        kind = {str: "String", bool: "Boolean"}.get(type(start), "Real")
        unit = RANGES[name][2] if name in RANGES else ""
        yield Variable(
            name=f"solver.{name}", type=kind, causality="parameter", variability="fixed",
            unit=unit, description=MEANINGS[name], start=float(start) if kind == "Real" else start,
            kind="option",
        )  # fmt: skip
