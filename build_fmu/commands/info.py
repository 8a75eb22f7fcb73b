"""`build-fmu info SCENE|FMU`: bodies, rows, degrees of freedom, redundant rows, variables."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from dataclasses import asdict
from typing import TYPE_CHECKING

from build_fmu.errors import UsageError
from build_fmu.report import print_json, print_table
from build_fmu.target import fmu_model, is_fmu, scene_model

if TYPE_CHECKING:
    from solver.mechanics.survey import Survey
    from solver.runtime import Model, Variable


def run(arguments: argparse.Namespace) -> int:
    """Describe; exit code 0."""
    from solver.mechanics.survey import survey

    if not is_fmu(arguments.target):
        model = scene_model(arguments.target, dict(arguments.settings))
    elif arguments.settings:
        text = "--set changes the numbers of a scene; those of an FMU are set when it is simulated"
        raise UsageError(text)
    else:
        model = fmu_model(arguments.target)
    counts = survey(model)
    if arguments.json:
        print_json(_document(model, counts))
    else:
        print_table(
            f"{model.name}: {model.description}".rstrip(": "), ("", ""), _rows(model, counts)
        )
        columns = ("variable", "unit", "kind", "start", "meaning")
        print_table("variables", columns, [_row(variable) for variable in model.variables])
    return 0


def _rows(model: Model, counts: Survey) -> list[tuple[str, str]]:
    redundant, freedom = counts.redundant_rows, counts.degrees_of_freedom
    note = "  (accepted; reactions of dependent rows are not unique)" if redundant else ""
    return [
        ("bodies", _names(_parts(model, "body"))),
        ("joints", _names(_parts(model, "joint"))),
        ("points", f"{counts.moving_points} moving, {counts.supports} fixed"),
        ("springs and dampers", str(counts.springs_and_dampers)),
        ("loads and torques", str(counts.loads_and_torques)),
        ("coordinates", f"{counts.coordinates} ({model.sizes['dim']} per moving point)"),
        ("constraint rows", str(counts.rows)),
        (
            "redundant rows",
            "not counted: too many rows" if redundant is None else f"{redundant}{note}",
        ),
        ("degrees of freedom", "not counted" if freedom is None else str(freedom)),
    ]


def _parts(model: Model, kind: str) -> list[str]:
    """Names of the bodies or joints that bring constraint rows."""
    labels = (label.partition(" ") for label in dict.fromkeys(model.row_names))
    return [name.strip("'") for word, _, name in labels if word == kind]


def _names(names: Sequence[str], most: int = 8) -> str:
    shown = ", ".join(names[:most]) + (", ..." if len(names) > most else "")
    return f"{len(names)}  {shown}".rstrip()


def _row(variable: Variable) -> tuple[str, ...]:
    start = "" if variable.start is None else str(variable.start)
    kind = variable.causality
    if kind == "parameter":
        kind = f"{variable.variability} {kind}"
    return variable.name, variable.unit, kind, start, variable.description


def _document(model: Model, counts: Survey) -> dict[str, object]:
    return {
        "name": model.name,
        "description": model.description,
        "dimension": model.sizes["dim"],
        "bodies": _parts(model, "body"),
        "joints": _parts(model, "joint"),
        **asdict(counts),
        "experiment": model.experiment._asdict(),
        "variables": [
            {
                "name": v.name,
                "type": v.type,
                "unit": v.unit,
                "causality": v.causality,
                "variability": v.variability,
                "start": v.start,
                "min": v.minimum,
                "max": v.maximum,
                "description": v.description,
            }
            for v in model.variables
        ],
    }
