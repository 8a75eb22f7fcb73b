"""The mechanical tables of a scene, in the order in which they refer to each other."""

from __future__ import annotations

from typing import Any

from solver.scene.bodies import Bodies
from solver.scene.diagnostics import Draft
from solver.scene.drivers import Drivers
from solver.scene.fields import BROKEN
from solver.scene.forces import Forces
from solver.scene.joint_names import JointNames
from solver.scene.joints import Joints
from solver.scene.quantities import Inventory
from solver.scene.vocabulary_forces import PositionDriver
from solver.scene.vocabulary_parts import Bar


def read_elements(bodies_reader: Bodies, inventory: Inventory) -> dict[str, Any]:
    """Read all mechanical tables; they are returned under the names of their tables."""
    geometry, references = bodies_reader.geometry, bodies_reader.references
    points, bodies = bodies_reader.read()
    names = JointNames(geometry, inventory.joints)
    joints = Joints(geometry, references, names).read()
    drivers_reader = Drivers(geometry, references, names)
    constraints = drivers_reader.constraints()
    forces = Forces(geometry, references, names).read(points, bodies)
    drivers = drivers_reader.read()
    _something_moves(geometry.draft, points)
    read = {
        **{"points": points, "bodies": bodies, "joints": joints, "constraints": constraints},
        **{"forces": forces, "drivers": drivers},
    }
    _free_points_have_mass(geometry.draft, bodies_reader.parts["points"], read)
    return read


def _something_moves(draft: Draft, points: dict[str, Any]) -> None:
    tables = [draft.data.get(name, {}) for name in ("points", "bodies")]
    if not all(isinstance(table, dict) for table in tables) or tables[1]:
        return
    if not tables[0]:
        message = "no points and no bodies: nothing can move"
        draft.error((), message, "write a table [points] or [bodies]")
    elif points and all(point.fixed for point in points.values()):
        draft.error(("points",), "all points are fixed: nothing can move")


def _free_points_have_mass(draft: Draft, drawn: dict[str, Any], read: dict[str, Any]) -> None:
    """Report points that have no mass: none of their own or of a bar, and no driver."""
    if any(len(read[table]) < len(draft.table(table)) for table in ("bodies", "drivers")):
        return  # what was left out may carry any point
    bars = [body for body in read["bodies"].values() if isinstance(body, Bar)]
    carried = {end for bar in bars for end in bar.points}
    if not carried <= read["points"].keys():
        return  # a name that is none is reported already, and may mean any point
    carried |= {x.point.point for x in read["drivers"].values() if isinstance(x, PositionDriver)}
    for name, part in drawn.items():
        nothing = part.mass is None or (part.mass is not BROKEN and part.mass.number == 0.0)
        if nothing and part.fixed is False and name not in carried:
            message = f"free point '{name}' has no mass"
            help = "give it a mass, a bar or fixed = true, or make it a point of a body"
            draft.error(("points", name), message, help)
