"""Drivers: prescribed positions, distances, angles and displacements (theory 6.1).

A driven point is a node whose coordinates are signals; everything else is a row sigma - f(t) = 0
whose multiplier is the force that the driver exerts, F = -mu along +sigma.
"""

from __future__ import annotations

from solver.mechanics.combination import Combination
from solver.mechanics.equations import SIGNAL, VALUE, Leaf
from solver.mechanics.formulas import leaf_symbol
from solver.mechanics.parts import JointParts, Parts
from solver.mechanics.rows import METRES, RADIANS, Rows
from solver.mechanics.vectors import Vector
from solver.scene import Driver, JointDriver, Number, PositionDriver, Scene


def driven_points(scene: Scene) -> dict[str, tuple[str, Vector]]:
    """Return the driver of each driven point, and the path that it prescribes."""
    return {
        driver.point.point: (name, driver.value)
        for name, driver in scene.drivers.items()
        if isinstance(driver, PositionDriver)
        and driver.point.point in scene.points
        and not scene.points[driver.point.point].fixed
    }


def add_driver(parts: Parts, name: str, driver: Driver) -> None:
    """Add the rows of a driver."""
    rows = Rows(parts.mechanism, f"drivers.{name}", f"driver '{name}'")
    parts.joints[name] = JointParts()
    if isinstance(driver, PositionDriver):
        if driver.point.point not in parts.paths:
            _follow(parts, rows, name, driver)
        return
    if isinstance(driver, JointDriver):
        joint = parts.joints[driver.joint]
        quantity = joint.angle if driver.type == "angle" else joint.displacement
        if quantity is None:
            text = f"joint '{driver.joint}' has no {driver.type}"
            parts.problems.append((f"drivers.{name}.joint", text))
            return
        scale = RADIANS if driver.type == "angle" else METRES
    else:
        quantity = parts.mechanism.length(parts.link(driver.points))
        scale = METRES
    row = _row(parts, rows, quantity, driver.value, scale)
    parts.joints[name].row = ("function", row)
    parts.driven[name] = quantity


def _row(parts: Parts, rows: Rows, quantity: int, value: Number, scale) -> int:
    mechanism = parts.mechanism
    leaves = (Leaf(VALUE, mechanism.use(quantity)), Leaf(SIGNAL, mechanism.signal(value)))
    return rows.function(leaf_symbol(0) - leaf_symbol(1), leaves, scale, "driver")


def _follow(parts: Parts, rows: Rows, name: str, driver: PositionDriver) -> None:
    """Let a point of a body follow a path."""
    mechanism = parts.mechanism
    place: Combination = parts.place(driver.point)
    for k, value in enumerate(driver.value):
        axis = parts.axis(k)
        row = _row(parts, rows, mechanism.component(place, axis), value, METRES)
        parts.joints[name].pushes.append((("function", row), 1.0, axis))
