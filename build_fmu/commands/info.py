"""`holonom info SCENE|FMU`: what it consists of, how it can move, and where it comes to rest."""

from __future__ import annotations

import argparse
from collections.abc import Mapping, Sequence
from dataclasses import asdict
from itertools import pairwise
from typing import TYPE_CHECKING, Any

from build_fmu.equilibrium import TABLES, UNITS, Equilibrium, Grid, driver_names, find_equilibrium
from build_fmu.errors import UsageError
from build_fmu.motion import LOSSES
from build_fmu.package import NATIVE, package_of
from build_fmu.platforms import library_scope, library_word
from build_fmu.printing import as_text, number, print_json, print_table
from build_fmu.study.settings import given_on_the_command_line
from build_fmu.target import fmu_model, is_fmu, parts_and_model
from solver.runtime import Integrator
from solver.runtime.layout import LEAST_WITH_JOINT

if TYPE_CHECKING:
    from solver.mechanics.mobility import Survey
    from solver.runtime import Model, Variable

FORCES = {
    "springs": ("spring", "torsion_spring"),
    "dampers": ("damper", "torsion_damper"),
    "actuators": ("actuator",),
    "torques": ("joint_torque", "torque"),
    "forces": ("force",),
    "potentials": ("potential", "gravitation"),
}
"""Rows of the table, and the types of forces in each."""
VARIABLE_FIELDS = {
    **{x: x for x in ("name", "type", "unit", "causality", "variability", "start")},
    **{"display_unit": "display_unit", "minimum": "min", "maximum": "max"},
    "description": "description",
}
"""What --json has of a variable, and what it is called there."""
CAUSES = (*LOSSES.values(),)
"""What takes energy out."""
ALWAYS, OPEN = "always", "while all contacts of a part are open"
"""When multipliers may follow before Newton's iteration ends."""
ROUNDING = 1e-10
"""Part of the largest value of its unit below which a value is shown as 0."""


def run(arguments: argparse.Namespace) -> int:
    """Describe; exit code 0."""
    from solver.mechanics.mobility import survey

    if not is_fmu(arguments.target):
        entries = given_on_the_command_line(arguments.parameters, arguments.settings)
        _, model = parts_and_model(arguments.target, entries)
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
    package = package_of(arguments.target) if is_fmu(arguments.target) else {}
    if package.get("kind") == NATIVE and package["platforms"]:
        package["library"] = library_word(model.sizes["dim"], library_scope(model.sizes))
    document = _document(model, counts) | _ledger(model) | ({"package": package} if package else {})
    if arguments.json:
        print_json(document | {"warnings": arguments.warnings})
        return 0
    title = f"{model.name}: {model.description}".rstrip(": ")
    print_table(title, ("", ""), _rows(document, counts))
    columns = ("variable", "unit", "kind", "start", "meaning")
    variables = sorted(model.variables, key=lambda v: v.name.startswith("solver."))
    print_table("variables", columns, map(_row, variables))
    return 0


# -------------------------------------------------------------------------------------- counts


def _document(model: Model, counts: Survey) -> dict[str, Any]:
    from solver.mechanics.mobility import is_lasting

    places = [row.location.partition(".") for row in model.rows]
    first = len(model.rows) - model.sizes["n_velocity_rows"]
    lasting = is_lasting(model)
    of_velocities = [
        row for row, lasts in zip(model.rows[first:], lasting[first:], strict=True) if lasts
    ]
    return {
        "name": model.name,
        "description": model.description,
        "dimension": model.sizes["dim"],
        **{
            table: list(dict.fromkeys(name for kind, _, name in places if kind == table))
            for table in ("bodies", "joints", "constraints", "contacts")
        },
        "meshes": model.meshes,
        "switches": list(dict.fromkeys(model.switches)),
        "rubbing": _rubbing(model),
        **asdict(counts),
        "drivers": driver_names(model),
        "prescribed_motions": counts.drivers,
        "velocity_rows": len(of_velocities),
        "velocity_parts": list(dict.fromkeys(row.name for row in of_velocities)),
        "steps": Integrator(model).steps(),
        "step": _step(model, bool(counts.redundant_rows)),
        "experiment": model.experiment._asdict(),
        "variables": [
            {short: getattr(v, field) for field, short in VARIABLE_FIELDS.items()}
            for v in model.variables
        ],
    }


def _rubbing(model: Model) -> list[str]:
    """Sentences on forces of which the sign of a rate, or a gear, became friction."""
    tables = (model.rows, model.tables["row_power"], model.tables["row_owner"])
    last = zip(*(table[::-1] for table in tables), strict=False)  # rows that may be off are last
    rows = [found for found in last if found[0].location.startswith("forces.")][::-1]
    if not rows:
        return []
    integrator = Integrator(model, log=lambda _: None)
    integrator.initialise()
    preload = model.offsets["preload"] - model.sizes["n_contacts"]
    sentences = []
    for row, power, owner in rows:
        _, is_sign, rate = row.detail.partition(" along ")
        most = f"{integrator.numbers[preload + owner]:.6g} {'N' if power else 'N.m'}"
        sentence = f"its gear is friction, which holds up to {most} at the start"
        if is_sign:
            sentence = f"the sign of {rate} is friction, which holds up to {most} where {rate} is 0"
        sentences.append(f"{row.name}: {sentence}")
    return sentences


def _step(model: Model, redundant: bool) -> dict[str, Any]:
    """What a step has for unknowns, and how many numbers the factors of its equations have.

    With early updates multipliers may follow before Newton's iteration ends (docs/skips.md).
    """
    located = model.settings.get("contact_mode") == "located" and model.sizes["unilateral"]
    sizes, dim = model.sizes, model.sizes["dim"]
    replaced = (3 if dim == 3 else 1) * sizes["n_bodies"]  # directors, by turns
    pivots = pairwise(model.tables["lu_group"][::3])
    return {
        "early_updates": OPEN if located and not redundant else ALWAYS,
        "coordinates": dim * (sizes["n_free"] - replaced),
        "turns": replaced,
        "multipliers": sizes["n_rows"] - sizes["n_rigidity_rows"],
        "factors": sizes["n_lu_values"],
        "lean_factors": sizes["n_lean_values"],
        "articulated_bodies": sum(b - a >= LEAST_WITH_JOINT for a, b in pivots),
    }


def _ledger(model: Model) -> dict[str, Any]:
    """Energy that each cause takes in a run of the default experiment, if there are contacts."""
    if not any(variable.name == "energy.impact" for variable in model.variables):
        return {}
    from build_fmu.self_check import self_check

    seen = self_check(model)
    return {"taken": {**seen.taken, "duration": seen.duration, "reason": seen.reason}}


def _rows(document: Mapping[str, Any], counts: Survey) -> list[tuple[str, str]]:
    """Rows of the table: what there is, and how much of it."""
    # A model does not say which of its fixed places were points, and which ends of springs.
    note = " (fixed points, and places where parts meet the ground)" if counts.supports else ""
    moving = f"{counts.moving_points} moving (origins of bodies count)"
    rolling = f"{document['velocity_rows']}  {', '.join(document['velocity_parts'])}"
    by_rank = "not ranked" if counts.mobility is None else f"{counts.mobility} by rank"
    by_count = f"{counts.mobility_by_count} by counting (Kutzbach), without drivers"
    forces = {
        kind: [name for word in types for name in counts.forces.get(word, ())]
        for kind, types in FORCES.items()
    }
    package = document.get("package")
    return [
        *([("package", _package(package))] if package else []),
        ("bodies", _names(document["bodies"])),
        ("joints", _names(document["joints"])),
        ("constraint formulas", _names(document["constraints"])),
        *([("contacts", _names(document["contacts"]))] if document["contacts"] else []),
        *((f"mesh of {name}", _mesh(mesh)) for name, mesh in document["meshes"].items()),
        *([("energy taken out", _taken(document["taken"]))] if "taken" in document else []),
        ("drivers", _names(document["drivers"])),
        ("points", f"{moving}, {counts.supports} fixed{note}"),
        *((kind, _names(names)) for kind, names in forces.items()),
        *(("switch", name) for name in document["switches"]),
        *(("friction", sentence) for sentence in document["rubbing"]),
        ("coordinates", f"{counts.coordinates} ({document['dimension']} per point or axis)"),
        ("constraint rows", f"{counts.rows}  of bodies, joints, drivers and formulas"),
        ("redundant rows", _redundancy(counts)),
        ("non-holonomic rows", rolling.rstrip()),
        ("mobility", f"{by_rank}, {by_count}"),
        ("degrees of freedom", _freedom(counts)),
        ("separate parts", str(counts.islands)),
        ("steps", document["steps"]),
        ("unknowns of a step", _unknowns(document["step"])),
    ]


def _unknowns(step: Mapping[str, Any]) -> str:
    """Unknowns of a step, how they are found, and the factors for it."""
    kinds = {
        "coordinates": "coordinates",
        "turns": "of turns of bodies",
        "multipliers": "multipliers",
    }
    parts = [f"{step[key]} {words}" for key, words in kinds.items() if step[key]]
    lean = f", {step['lean_factors']} without stiffness" if step["lean_factors"] else ""
    text = f"{' + '.join(parts)}; {step['factors']} numbers in the factors{lean}"
    if bodies := step["articulated_bodies"]:
        text += f"; {bodies} eliminated with {'its joint' if bodies == 1 else 'their joints'}"
    text += "; multipliers follow before Newton's iteration ends"
    if step["early_updates"] == ALWAYS:
        return text
    return f"{text} while all contacts of their part are open, else they are held"


def _package(package: Mapping[str, Any]) -> str:
    content = [*package["platforms"], *(["sources in C"] if package["sources"] else ())]
    kind = package["kind"] + (f" ({package['library']})" if "library" in package else "")
    return f"FMI {package['fmi']}, {kind}, {', '.join(content)}"


def _taken(taken: Mapping[str, Any]) -> str:
    causes = [f"{value:.6g} J by {cause}" for cause, value in taken.items() if cause in CAUSES]
    ended = f", which ended early: {taken['reason']}" if taken["reason"] else ""
    return f"{', '.join(causes)}; in a run of {taken['duration']:g} s{ended}"


def _names(names: Sequence[str], most: int = 8) -> str:
    shown = ", ".join(names[:most]) + (", ..." if len(names) > most else "")
    return f"{len(names)}  {shown}".rstrip()


def _mesh(mesh: Mapping[str, Any]) -> str:
    """Grid of a mesh, how exact its distances are, and what touches it."""
    cells = " x ".join(map(str, mesh["cells"]))
    text = f"{mesh['file']}, {mesh['triangles']} triangles; {cells} cells of "
    text += f"{mesh['resolution']:.4g} m; distances to {mesh['largest_error']:.1e} m, "
    text += f"{mesh['mean_error']:.1e} m in the mean; {mesh['points']} points touch it"
    left = mesh["corners_left"]
    return text + (f", up to {left:.1e} m from a corner" if left else "")


def _redundancy(counts: Survey) -> str:
    if counts.redundant_rows is None:
        return "not counted: too many rows"
    if not counts.redundant_rows:
        return "0"
    parts = ", ".join(counts.redundant_parts or ())
    note = "accepted; reactions in them are not unique"
    return f"{counts.redundant_rows}  among those of {parts} ({note})"


def _freedom(counts: Survey) -> str:
    positions, velocities = counts.degrees_of_freedom, counts.velocity_freedom
    if positions is None:
        return "not counted"
    if positions == velocities:
        return str(positions)
    return f"{positions} of positions, {velocities} of velocities"


def _row(variable: Variable) -> tuple[str, ...]:
    kind = variable.causality
    if kind == "parameter":
        kind = f"{variable.variability} {kind}"
    return variable.name, variable.unit, kind, as_text(variable.start), variable.description


# --------------------------------------------------------------------------------- equilibrium


def _print_equilibrium(model: Model, found: Equilibrium, redundant: Sequence[str]) -> None:
    held = "; drivers are held where they are at the start" if found.held else ""
    energy = [("potential energy", f"{number(found.potential_energy)} J")]
    print_table(f"{model.name} in static equilibrium{held}", ("", ""), energy)
    places = [x for grid in found.positions.values() for x in grid.values()]
    size = max(map(abs, places), default=1.0)
    for table in TABLES:
        if grid := getattr(found, table):
            unsure = table == "reactions" and redundant
            note = f", not unique in {', '.join(redundant)}" if unsure else ""
            _print_grid(f"{table}{note}", grid, size)
    if found.outputs:
        units = {variable.name: variable.unit for variable in model.variables}
        rows = [(name, number(x), units[name]) for name, x in found.outputs.items()]
        print_table("outputs", ("", "", ""), rows)


def _print_grid(title: str, grid: Grid, size: float) -> None:
    """One row for each part; what rounding leaves of a zero is shown as 0.

    Torques are compared with the largest force, too, across the size of the mechanism [m].
    """
    columns = list(dict.fromkeys(column for values in grid.values() for column in values))
    units = {column: UNITS.get(column, "") for column in columns}
    least: dict[str, float] = {}
    for values in grid.values():
        for column, value in values.items():
            unit = units[column]
            least[unit] = max(least.get(unit, 0.0), ROUNDING * abs(value))
    if "N.m" in least:
        least["N.m"] = max(least["N.m"], size * least.get("N", 0.0))

    def shown(column: str, value: float) -> str:
        return number(value if abs(value) > least[units[column]] else 0.0)

    rows = [
        (part, *(shown(c, values[c]) if c in values else "" for c in columns))
        for part, values in grid.items()
    ]
    heads = [f"{column} [{unit}]" if unit else column for column, unit in units.items()]
    print_table(title, ("", *heads), rows)
