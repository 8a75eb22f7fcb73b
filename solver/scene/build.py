"""From the tables of a scene file to a ``Scene``: references, symbols, values, every mistake.

A field with a mistake is reported once and counts as broken from then on; a part that was left out
because its type is unknown still lends its name. So nothing is reported twice.
"""

from __future__ import annotations

from typing import Any

from solver.scene.draft import Draft
from solver.scene.elements import Elements
from solver.scene.fields import BROKEN
from solver.scene.names import check_name, check_names, kinds_of_names, quantities
from solver.scene.numbers import GEOMETRY, OUTPUT, Known, Numbers
from solver.scene.report import did_you_mean
from solver.scene.schema import TYPES, File, Heading
from solver.scene.settings import read_settings
from solver.scene.values import read_inputs, read_parameters
from solver.scene.vocabulary import Output, Scene


def build(draft: Draft) -> Scene:
    """Check a draft and turn it into a scene; the draft collects the mistakes."""
    heading = _heading(draft)
    check_names(draft)
    known = Known(kinds_of_names(draft))
    numbers = Numbers(draft, known)
    elements = Elements(numbers, heading.dimension)
    known.quantities |= _quantities(draft, elements.dimension or 3)
    parameters = read_parameters(numbers)
    inputs = read_inputs(numbers)
    points, bodies, joints, forces = elements.read()
    gravity = elements.zero()
    if heading.gravity is not None:
        gravity = elements.vector(("gravity",), heading.gravity, GEOMETRY)
    outputs = _outputs(numbers)
    solver, experiment = read_settings(numbers)
    return Scene(
        name=heading.name,
        description=heading.description,
        dimension=2 if elements.dimension == 2 else 3,
        gravity=gravity,
        parameters=parameters,
        inputs=inputs,
        points=points,
        bodies=bodies,
        joints=joints,
        forces=forces,
        outputs=outputs,
        solver=solver,
        experiment=experiment,
        source=draft.source,
    )


def _heading(draft: Draft) -> Any:
    """Read what the file says about the scene as a whole, and report unknown tables."""
    for name in draft.data:
        if name not in File.model_fields:
            help = did_you_mean(name, File.model_fields, "known tables and fields")
            draft.error((name,), "unknown table or field", help)
    fields = {name: value for name, value in draft.data.items() if name in Heading.model_fields}
    heading = draft.part((), Heading, fields)
    if heading.name is not BROKEN:
        check_name(draft, ("name",), heading.name)
    return heading


def _names(draft: Draft, table: str) -> list[str]:
    entries = draft.data.get(table)
    return list(entries) if isinstance(entries, dict) else []


def _quantities(draft: Draft, dimension: int) -> set[str]:
    """Names of the mechanism's quantities; a force of unknown type may have any of them."""
    forces = draft.data.get("forces")
    kinds = {}
    for name, data in forces.items() if isinstance(forces, dict) else ():
        kind = data.get("type") if isinstance(data, dict) else None
        kinds[name] = kind if isinstance(kind, str) and kind in TYPES["forces"] else "spring"
    points, bodies, joints = (_names(draft, table) for table in ("points", "bodies", "joints"))
    return set(quantities(dimension, points, bodies, joints, kinds))


def _outputs(numbers: Numbers) -> dict[str, Output]:
    return {
        name: Output(
            value=numbers.number(("outputs", name, "value"), part.value, OUTPUT),
            unit=part.unit,
            description=part.description,
        )
        for name, part in numbers.draft.parts("outputs").items()
    }
