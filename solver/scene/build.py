"""From the tables of a scene file to a ``Scene``: references, symbols, values, every mistake.

A field with a mistake is reported once and counts as broken from then on; a part that was left out
because its type is unknown still lends its name. So nothing is reported twice.
"""

from __future__ import annotations

from typing import Any

from solver.scene.advice import advise
from solver.scene.bodies import Bodies
from solver.scene.diagnostics import Draft
from solver.scene.fields import BROKEN
from solver.scene.geometry import Geometry
from solver.scene.names import (
    check_body_points,
    check_name,
    check_names,
    inventory_of_draft,
    kinds_of_names,
)
from solver.scene.numbers import OUTPUT, Known, Numbers
from solver.scene.part_readers import read_elements
from solver.scene.references import References
from solver.scene.report import in_order
from solver.scene.schema import File, Heading
from solver.scene.settings import read_settings
from solver.scene.values import check_unit, read_inputs, read_parameters
from solver.scene.vocabulary import Output, Scene
from solver.scene.words import did_you_mean


def build(draft: Draft) -> Scene:
    """Check a draft and turn it into a scene; the draft collects the mistakes."""
    heading = _heading(draft)
    check_names(draft)
    known = Known(kinds_of_names(draft))
    numbers = Numbers(draft, known)
    geometry = Geometry(numbers, heading.dimension)
    bodies = Bodies(geometry, References(geometry), heading.gravity)
    inventory = known.inventory = inventory_of_draft(draft, geometry.dimension or 3)
    check_body_points(draft, known)
    ends = (*inventory.points, *known.of("body"), *inventory.body_points)
    known.ends = dict.fromkeys(ends)
    parameters = read_parameters(numbers)
    inputs = read_inputs(numbers)
    elements = read_elements(bodies, inventory)
    gravity = geometry.optional(("gravity",), heading.gravity)
    outputs = _outputs(numbers)
    solver, experiment = read_settings(numbers)
    if not draft.problems:
        advise(numbers, inputs, elements["joints"])
    return Scene(
        name=heading.name,
        description=heading.description,
        dimension=2 if geometry.dimension == 2 else 3,
        gravity=geometry.zero() if gravity is None else gravity,
        parameters=parameters,
        inputs=inputs,
        **elements,
        outputs=outputs,
        solver=solver,
        experiment=experiment,
        source=draft.source,
        warnings=in_order(draft.warnings),
    )


def _heading(draft: Draft) -> Any:
    """Read what the file says about the scene as a whole, and report unknown tables."""
    for name in draft.data:
        if name not in File.model_fields:
            help = did_you_mean(name, File.model_fields, "known tables and fields", "file")
            draft.error((name,), "unknown table or field", help)
    fields = {name: value for name, value in draft.data.items() if name in Heading.model_fields}
    heading = draft.part((), Heading, fields)
    if heading.name is not BROKEN:
        check_name(draft, ("name",), heading.name)
    return heading


def _outputs(numbers: Numbers) -> dict[str, Output]:
    parts = numbers.draft.parts("outputs")
    for name, part in parts.items():
        check_unit(numbers.draft, ("outputs", name), part)
    return {
        name: Output(
            value=numbers.number(("outputs", name, "value"), part.value, OUTPUT),
            unit=part.unit,
            description=part.description,
        )
        for name, part in parts.items()
    }
