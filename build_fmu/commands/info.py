"""`holonom info SCENE|FMU`: what it consists of, how it can move, and where it comes to rest."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from dataclasses import asdict
from typing import TYPE_CHECKING

from build_fmu.equilibrium import (
    TABLES,
    UNITS,
    Equilibrium,
    Grid,
    driver_names,
    find_equilibrium,
)
from build_fmu.errors import UsageError
from build_fmu.report import as_text, number, print_json, print_table
from build_fmu.study.settings import given_on_the_command_line
from build_fmu.target import fmu_model, is_fmu, scene_and_model

if TYPE_CHECKING:
    from solver.mechanics.mobility import Survey
    from solver.runtime import Model, Variable

FORCES = {
    "springs": ("spring", "torsion_spring"),
    "dampers": ("damper", "torsion_damper"),
    "torques": ("joint_torque", "torque"),
    "forces": ("force",),
    "potentials": ("potential", "gravitation"),
}
"""Rows of the table, and the types of forces in each."""
VARIABLE_FIELDS = {
    **{x: x for x in ("name", "type", "unit", "causality", "variability", "start")},
    **{"minimum": "min", "maximum": "max", "description": "description"},
}
"""What --json has of a variable, and what it is called there."""
ROUNDING = 1e-10
"""Part of the largest value of its unit below which a value is shown as 0."""


def run(arguments: argparse.Namespace) -> int:
    """Describe; exit code 0."""
    from solver.mechanics.mobility import survey

    if not is_fmu(arguments.target):
        entries = given_on_the_command_line(arguments.parameters, arguments.settings)
        _, model = scene_and_model(arguments.target, entries)
    elif arguments.settings or arguments.parameters:
        text = (
            "--set and --parameters change the numbers of a scene; those of an FMU are set when it "
            "is simulated"
        )
        raise UsageError(text)
    else:
        model = fmu_model(arguments.target)
    if arguments.equilibrium:
        found = find_equilibrium(model)
        if arguments.json:
            print_json({"name": model.name, **asdict(found), "warnings": arguments.warnings})
        else:
            _print_equilibrium(model, found, survey(model).redundant_parts or ())
        return 0
    counts = survey(model)
    if arguments.json:
        print_json(_document(model, counts) | {"warnings": arguments.warnings})
    else:
        _print_counts(model, counts)
    return 0


# -------------------------------------------------------------------------------------- counts


def _print_counts(model: Model, counts: Survey) -> None:
    print_table(_title(model), ("", ""), _rows(model, counts))
    columns = ("variable", "unit", "kind", "start", "meaning")
    variables = sorted(model.variables, key=lambda v: v.name.startswith("solver."))
    print_table("variables", columns, map(_row, variables))


def _title(model: Model) -> str:
    return f"{model.name}: {model.description}".rstrip(": ")


def _rows(model: Model, counts: Survey) -> list[tuple[str, str]]:
    rolling = _velocity_parts(model)
    return [
        ("bodies", _names(_parts(model, "bodies"))),
        ("joints", _names(_parts(model, "joints"))),
        ("constraint formulas", _names(_parts(model, "constraints"))),
        ("drivers", _names(driver_names(model))),
        ("points", _points(counts)),
        *((kind, _names(_of_types(counts, types))) for kind, types in FORCES.items()),
        ("coordinates", f"{counts.coordinates} ({model.sizes['dim']} per point or axis)"),
        ("constraint rows", f"{counts.rows}  of bodies, joints, drivers and formulas"),
        ("redundant rows", _redundancy(counts)),
        ("non-holonomic rows", f"{model.sizes['n_velocity_rows']}  {', '.join(rolling)}".rstrip()),
        ("mobility", _mobility(counts)),
        ("degrees of freedom", _freedom(counts)),
        ("separate parts", str(counts.islands)),
    ]


def _of_types(counts: Survey, types: Sequence[str]) -> list[str]:
    return [name for word in types for name in counts.forces.get(word, ())]


def _points(counts: Survey) -> str:
    # A model does not say which of its fixed places were points, and which ends of springs.
    note = " (fixed points, and places where parts meet the ground)" if counts.supports else ""
    return f"{counts.moving_points} moving (origins of bodies count), {counts.supports} fixed{note}"


def _redundancy(counts: Survey) -> str:
    if counts.redundant_rows is None:
        return "not counted: too many rows"
    if not counts.redundant_rows:
        return "0"
    parts = ", ".join(counts.redundant_parts or ())
    note = "accepted; reactions in them are not unique"
    return f"{counts.redundant_rows}  among those of {parts} ({note})"


def _mobility(counts: Survey) -> str:
    by_rank = "not ranked" if counts.mobility is None else f"{counts.mobility} by rank"
    return f"{by_rank}, {counts.mobility_by_count} by counting (Kutzbach), without drivers"


def _freedom(counts: Survey) -> str:
    positions, velocities = counts.degrees_of_freedom, counts.velocity_freedom
    if positions is None:
        return "not counted"
    if positions == velocities:
        return str(positions)
    return f"{positions} of positions, {velocities} of velocities"


def _parts(model: Model, table: str) -> list[str]:
    """Names of the bodies, joints or constraints that bring constraint rows."""
    places = (row.location.partition(".") for row in model.rows)
    return list(dict.fromkeys(name for kind, _, name in places if kind == table))


def _velocity_parts(model: Model) -> list[str]:
    """What brings rows of velocities that are not rates of rows of positions."""
    first = len(model.rows) - model.sizes["n_velocity_rows"]
    return list(dict.fromkeys(row.name for row in model.rows[first:]))


def _names(names: Sequence[str], most: int = 8) -> str:
    shown = ", ".join(names[:most]) + (", ..." if len(names) > most else "")
    return f"{len(names)}  {shown}".rstrip()


def _row(variable: Variable) -> tuple[str, ...]:
    kind = variable.causality
    if kind == "parameter":
        kind = f"{variable.variability} {kind}"
    return variable.name, variable.unit, kind, as_text(variable.start), variable.description


def _document(model: Model, counts: Survey) -> dict[str, object]:
    return {
        "name": model.name,
        "description": model.description,
        "dimension": model.sizes["dim"],
        "bodies": _parts(model, "bodies"),
        "joints": _parts(model, "joints"),
        "constraints": _parts(model, "constraints"),
        **asdict(counts),
        "drivers": driver_names(model),
        "prescribed_motions": counts.drivers,
        "velocity_rows": model.sizes["n_velocity_rows"],
        "velocity_parts": _velocity_parts(model),
        "experiment": model.experiment._asdict(),
        "variables": [
            {short: getattr(v, field) for field, short in VARIABLE_FIELDS.items()}
            for v in model.variables
        ],
    }


# --------------------------------------------------------------------------------- equilibrium


def _print_equilibrium(model: Model, found: Equilibrium, redundant: Sequence[str]) -> None:
    held = "; drivers are held where they are at the start" if found.held else ""
    energy = [("potential energy", f"{number(found.potential_energy)} J")]
    print_table(f"{model.name} in static equilibrium{held}", ("", ""), energy)
    for table in TABLES:
        if grid := getattr(found, table):
            unsure = table == "reactions" and redundant
            note = f", not unique in {', '.join(redundant)}" if unsure else ""
            _print_grid(f"{table}{note}", grid)
    if found.outputs:
        units = {variable.name: variable.unit for variable in model.variables}
        rows = [(name, number(x), units[name]) for name, x in found.outputs.items()]
        print_table("outputs", ("", "", ""), rows)


def _print_grid(title: str, grid: Grid) -> None:
    """One row for each part; what rounding leaves of a zero is shown as 0."""
    columns = list(dict.fromkeys(column for values in grid.values() for column in values))
    largest: dict[str, float] = {}
    for values in grid.values():
        for column, value in values.items():
            unit = UNITS.get(column, "")
            largest[unit] = max(largest.get(unit, 0.0), abs(value))

    def shown(column: str, value: float | None) -> str:
        if value is None:
            return ""
        return number(value if abs(value) > ROUNDING * largest[UNITS.get(column, "")] else 0.0)

    rows = [(part, *(shown(c, values.get(c)) for c in columns)) for part, values in grid.items()]
    heads = [f"{column} [{UNITS[column]}]" if column in UNITS else column for column in columns]
    print_table(title, ("", *heads), rows)
