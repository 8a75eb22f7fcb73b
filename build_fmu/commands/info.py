"""`build-fmu info SCENE|FMU`: bodies, rows, degrees of freedom, redundant rows, variables."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from dataclasses import asdict
from typing import TYPE_CHECKING

from build_fmu.errors import UsageError
from build_fmu.report import print_json, print_table
from build_fmu.structure import Structure, structure
from build_fmu.target import fmu_model, is_fmu, scene_model

if TYPE_CHECKING:
    from solver.runtime import Model, Variable


def run(arguments: argparse.Namespace) -> int:
    """Describe; exit code 0."""
    if not is_fmu(arguments.target):
        model = scene_model(arguments.target, dict(arguments.settings))
    elif arguments.settings:
        text = "--set changes the numbers of a scene; those of an FMU are set when it is simulated"
        raise UsageError(text)
    else:
        model = fmu_model(arguments.target)
    counts = structure(model)
    if arguments.json:
        print_json(_document(model, counts))
    else:
        print_table(f"{model.name}: {model.description}".rstrip(": "), ("", ""), _counts(counts))
        columns = ("variable", "unit", "kind", "start", "meaning")
        print_table("variables", columns, [_row(variable) for variable in model.variables])
    return 0


def _counts(counts: Structure) -> list[tuple[str, str]]:
    redundant = str(counts.redundant_rows)
    if counts.redundant_rows:
        redundant += "  (accepted; reactions of dependent rows are not unique)"
    return [
        ("dimension", str(counts.dimension)),
        ("bodies", _names(counts.bodies)),
        ("joints", _names(counts.joints)),
        ("points", f"{counts.points} free, {counts.fixed_points} fixed"),
        ("coordinates", str(counts.coordinates)),
        ("constraint rows", str(counts.rows)),
        ("redundant rows", redundant),
        ("degrees of freedom", str(counts.degrees_of_freedom)),
    ]


def _names(names: Sequence[str], most: int = 8) -> str:
    shown = ", ".join(names[:most]) + (", ..." if len(names) > most else "")
    return f"{len(names)}  {shown}".rstrip()


def _row(variable: Variable) -> tuple[str, ...]:
    start = "" if variable.start is None else str(variable.start)
    kind = variable.causality
    if kind == "parameter":
        kind = f"{variable.variability} {kind}"
    return variable.name, variable.unit, kind, start, variable.description


def _document(model: Model, counts: Structure) -> dict[str, object]:
    return {
        "name": model.name,
        "description": model.description,
        **asdict(counts),
        "redundant_rows": counts.redundant_rows,
        "degrees_of_freedom": counts.degrees_of_freedom,
        "experiment": asdict(model.experiment),
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
