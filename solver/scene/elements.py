"""The mechanical tables of a scene, in the order in which they refer to each other."""

from __future__ import annotations

from typing import Any

from solver.scene.bodies import Bodies
from solver.scene.draft import Draft
from solver.scene.drivers import Drivers
from solver.scene.fields import BROKEN
from solver.scene.forces import Forces
from solver.scene.joint_names import JointNames
from solver.scene.joints import Joints
from solver.scene.numbers import Known
from solver.scene.quantities import Inventory
from solver.scene.schema import TYPES


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
    _free_points_have_mass(geometry.draft, bodies_reader.parts["points"], geometry.known)
    return {
        "points": points,
        "bodies": bodies,
        "joints": joints,
        "constraints": constraints,
        "forces": forces,
        "drivers": drivers,
    }


def _something_moves(draft: Draft, points: dict[str, Any]) -> None:
    tables = [draft.data.get(name, {}) for name in ("points", "bodies")]
    if not all(isinstance(table, dict) for table in tables) or tables[1]:
        return
    if not tables[0]:
        message = "no points and no bodies: nothing can move"
        draft.error((), message, "write a table [points] or [bodies]")
    elif points and all(point.fixed for point in points.values()):
        draft.error(("points",), "all points are fixed: nothing can move")


_CARRIERS = ("bar", "spherical", "revolute", "position")
"""Types of bodies, joints and drivers that give a point mass, or need none of it."""


def _free_points_have_mass(draft: Draft, drawn: dict[str, Any], known: Known) -> None:
    """Report points that certainly have no mass: none of their own, of a bar or of a body."""
    carried: set[str] = set()
    for table in ("bodies", "joints", "drivers"):
        parts = draft.data.get(table, {})
        for part in parts.values() if isinstance(parts, dict) else ():
            kind = part.get("type", "rigid") if isinstance(part, dict) else None
            if kind in _CARRIERS or not (isinstance(kind, str) and kind in TYPES[table]):
                ends = part.get("points", part.get("point")) if isinstance(part, dict) else None
                names = ends if isinstance(ends, list) else [ends]
                carried |= {str(name) for name in names}
    if not carried <= {*known.ends, "ground"}:
        return  # a name that is none is reported already, and may mean any point
    for name, part in drawn.items():
        nothing = part.mass is None or (part.mass is not BROKEN and part.mass.number == 0.0)
        if nothing and part.fixed is False and name not in carried:
            message = f"free point '{name}' has no mass"
            help = "give it a mass, a bar, a joint with a body or fixed = true"
            draft.error(("points", name), message, help)
