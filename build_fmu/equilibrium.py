"""Static equilibrium of a model: where its parts come to rest, and what holds them there."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from build_fmu.errors import UnfinishedError

if TYPE_CHECKING:
    from solver.runtime import Model, Variable

Grid = dict[str, dict[str, float]]
"""Values by part and quantity, as in {"A": {"x": 1.0}}, in the units of `UNITS`."""

UNITS = {
    **dict.fromkeys(("x", "y", "z", "displacement", "length"), "m"),
    **dict.fromkeys(("force", "force.x", "force.y", "force.z"), "N"),
    **dict.fromkeys(("torque", "torque.x", "torque.y", "torque.z"), "N.m"),
    "angle": "rad",
    "energy": "J",
}

AXES = ("x", "y", "z")
TABLES = ("positions", "orientations", "joints", "forces", "reactions")

MOVING = 1e-9
"""Velocities (m/s, rad/s) and rates of rows (1/s) above this mean that a driver moves."""


@dataclass(frozen=True)
class Equilibrium:
    """Values at rest, at the start time and with the default parameters and inputs."""

    positions: Grid
    """Of points and bodies, and the angles of bodies in the plane."""
    orientations: Grid
    """Of bodies in space: quaternions."""
    joints: Grid
    """Angles and displacements of joints, zero as drawn."""
    forces: Grid
    """Of springs and all else in the scene's table of forces: length, force, torque, energy."""
    reactions: Grid
    """Of joints, constraints and drivers."""
    outputs: dict[str, float]
    """Of the scene, in their own units."""
    potential_energy: float
    """J."""
    held: bool
    """Whether drivers move at the start time, and are held where they are then."""


def find_equilibrium(model: Model) -> Equilibrium:
    """Static equilibrium next to the drawn configuration.

    Raises
    ------
    UnfinishedError
        If none is found.
    """
    from solver.runtime import AssemblyError, Integrator
    from solver.runtime.errors import in_one_line

    integrator = Integrator(model)
    integrator["solver.start"] = "equilibrium"
    integrator["solver.assemble"] = True  # else a driver that moves contradicts being at rest
    try:
        integrator.initialise()
    except AssemblyError as error:
        reason = in_one_line(error)
        if not model.sizes["sensing"]:
            reason = (
                "no static equilibrium was found next to the drawn configuration; perhaps there is "
                "none, as where a torque turns a free shaft or nothing holds a body against "
                f"gravity ({reason})"
            )
        text = f"{model.name}: {reason}"
        raise UnfinishedError(text) from None
    outputs = [(i, v) for i, v in enumerate(model.variables) if v.causality == "output"]
    values = integrator.get([i for i, _ in outputs])
    grids: dict[str, Grid] = {table: {} for table in TABLES}
    whole: dict[str, float] = {}
    fastest = 0.0
    kinds = _kinds(model)
    for (_, variable), value in zip(outputs, values, strict=True):
        table, part, quantity = _place(variable, kinds)
        if table:
            grids[table].setdefault(part, {})[quantity] = float(value)
        else:
            whole[variable.name] = float(value)
        if variable.unit in ("m/s", "rad/s") or variable.name == "constraint.velocity":
            fastest = max(fastest, abs(float(value)))
    return Equilibrium(
        **grids,
        outputs={name: value for name, value in whole.items() if "." not in name},
        potential_energy=whole["energy.potential"],
        held=fastest > MOVING,
    )


def _kinds(model: Model) -> dict[str, str]:
    """Table of the scene in which what brings rows, or drives, stands: joints, drivers, ..."""
    places = (row.location.partition(".") for row in model.rows)
    return {name: kind for kind, _, name in places} | dict.fromkeys(driver_names(model), "drivers")


def driver_names(model: Model) -> list[str]:
    """Names of the drivers: of what has a power, all but forces, and joints that rub."""
    units = {v.name: v.unit for v in model.variables if v.causality == "output"}
    powers = (name for name, unit in units.items() if unit == "W" and name.endswith(".power"))
    found = (name.removesuffix(".power") for name in powers)
    return [name for name in found if name not in model.forces and f"{name}.slip" not in units]


def _place(variable: Variable, kinds: Mapping[str, str]) -> tuple[str, str, str]:
    """Table of a variable, its part and what it is of it; no table for rates and totals.

    The unit says what ``rod.force.x`` is: the reaction of a joint, or a point called force.
    """
    part, _, last = variable.name.rpartition(".")
    if part in ("", "energy", "constraint", "momentum", "angular_momentum", "solver"):
        return "", part, last
    if last in AXES and variable.unit in ("N", "N.m"):
        part, _, quantity = part.rpartition(".")
        last = f"{quantity}.{last}"
    if variable.unit in ("N", "N.m", "J") or last == "multiplier":
        return "reactions" if part in kinds else "forces", part, last
    if last in ("qw", "qx", "qy", "qz"):
        return "orientations", part, last
    if last in AXES:
        return "positions", part, last
    if last == "length":
        return "forces", part, last
    if variable.unit in ("m", "rad"):
        return "joints" if kinds.get(part) == "joints" else "positions", part, last
    return "", part, last
