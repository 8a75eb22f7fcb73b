"""Drivers: prescribed positions, distances, angles and displacements (theory 6.1).

A driven point is a node whose coordinates are signals; everything else is a row sigma - f(t) = 0
whose multiplier is the force that the driver exerts, F = -mu along +sigma.
"""

from __future__ import annotations

from solver.mechanics.equations import SIGNAL, Formula, Leaf, Scale
from solver.mechanics.formulas import leaf_symbol
from solver.mechanics.parts import JointParts, RowOf
from solver.mechanics.rows import METRES, RADIANS, Rows
from solver.mechanics.vectors import Vector
from solver.scene import (
    AngleDriver,
    DisplacementDriver,
    DistanceDriver,
    JointDriver,
    Number,
    PositionDriver,
    Scene,
)


def driven_points(scene: Scene) -> dict[str, tuple[str, Vector]]:
    """Return the driver of each driven point, and the path that it prescribes."""
    return {
        driver.point.point: (name, driver.value)
        for name, driver in scene.drivers.items()
        if isinstance(driver, PositionDriver)
        and driver.point.point in scene.points
        and not scene.points[driver.point.point].fixed
    }


def drive_position(rows: Rows, driver: PositionDriver, found: JointParts) -> None:
    """Let a point of a body follow a path; a point of its own has it as coordinates."""
    parts = rows.parts
    if driver.point.point not in parts.paths:
        place = parts.place(driver.point)
        for k, value in enumerate(driver.value):
            axis = parts.axis(k)
            row = _row(rows, rows.mechanism.component(place, axis), value, METRES)
            found.pushes.append((row, 1.0, axis))


def drive_joint(rows: Rows, driver: JointDriver, found: JointParts) -> None:
    """Prescribe the angle or displacement of a joint."""
    joint, turns = rows.parts.joints[driver.joint], driver.type == "angle"
    found.driven = joint.angle if turns else joint.displacement
    if found.driven is None:
        rows.problem(f"joint '{driver.joint}' has no {driver.type}", ".joint")
    else:
        found.row = _row(rows, found.driven, driver.value, RADIANS if turns else METRES)


def drive_distance(rows: Rows, driver: DistanceDriver, found: JointParts) -> None:
    """Prescribe the distance of two places."""
    found.driven = rows.mechanism.length(rows.parts.link(driver.points))
    found.row = _row(rows, found.driven, driver.value, METRES)


def _row(rows: Rows, quantity: int, value: Number, scale: Scale) -> RowOf:
    mechanism = rows.mechanism
    leaves = mechanism.leaf(quantity), Leaf(SIGNAL, mechanism.signal(value))
    return rows.function(Formula(leaf_symbol(0) - leaf_symbol(1), leaves), scale, "driver")


DRIVERS = {
    PositionDriver: drive_position, DistanceDriver: drive_distance,
    AngleDriver: drive_joint, DisplacementDriver: drive_joint,
}  # fmt: skip
