"""Prescribed motions and general constraints of a scene."""

from __future__ import annotations

from typing import Any

from solver.scene import schema_forces as schema
from solver.scene.expression import Expr, Number
from solver.scene.fields import BROKEN
from solver.scene.geometry import Geometry
from solver.scene.joint_names import JointNames
from solver.scene.numbers import CONSTRAINT, DRIVER, POSITIVE, VELOCITY_ROW
from solver.scene.quantities import Level
from solver.scene.references import References
from solver.scene.report import Path
from solver.scene.vocabulary_forces import DistanceDriver, Driver, JointDriver, PositionDriver
from solver.scene.vocabulary_joints import Constraint


class Drivers:
    """Reader of the tables [drivers] and [constraints]."""

    def __init__(self, geometry: Geometry, references: References, joints: JointNames) -> None:
        self.geometry = geometry
        self.references = references
        self.joints = joints
        self.draft = geometry.draft
        self.driven: dict[tuple[str, str], str] = {}
        """Driver of each point, and of the angle or displacement of each joint."""

    def read(self) -> dict[str, Driver]:
        """Read all drivers."""
        parts = self.draft.parts("drivers")
        return {
            name: _READERS[type(part)](self, ("drivers", name), part)
            for name, part in parts.items()
        }

    def _position(self, path: Path, part: schema.PositionDriver) -> PositionDriver:
        point, where = self.references.point(path, part), (*path, "point")
        if point.point in self.references.fixed:
            message = f"the point '{point.point}' is fixed, and cannot be driven"
            self.draft.error(where, message, "leave out its fixed = true")
        if point.point is not None and point.at is None:
            self._once(where, "position", point.point)
        return PositionDriver(
            point=point, value=self.geometry.vector((*path, "value"), part.value, DRIVER)
        )

    def _distance(self, path: Path, part: schema.DistanceDriver) -> DistanceDriver:
        number, where = self.geometry.numbers.number, (*path, "value")
        return DistanceDriver(
            points=self.references.ends(path, part),
            value=number(where, part.value, DRIVER, POSITIVE, "m"),
        )

    def _joint(self, path: Path, part: Any) -> JointDriver:
        where = (*path, "joint")
        fits = self.joints.with_angle if part.type == "angle" else self.joints.with_displacement
        if fits(where, part.joint):
            self._once(where, part.type, part.joint)
        return JointDriver(
            type=part.type,
            joint=part.joint if isinstance(part.joint, str) else "",
            value=self.geometry.numbers.number((*path, "value"), part.value, DRIVER),
        )

    def _once(self, where: Path, what: str, name: str) -> None:
        """Report what two drivers move at once."""
        first = self.driven.setdefault((what, name), str(where[1]))
        if first != where[1]:
            message = f"the {what} of '{name}' is driven by '{first}' already"
            self.draft.error(where, message, "leave out one of the two")

    def constraints(self) -> dict[str, Constraint]:
        """Read all constraints."""
        parts = self.draft.parts("constraints")
        return {name: self._constraint(name, part) for name, part in parts.items()}

    def _constraint(self, name: str, part: Any) -> Constraint:
        path = ("constraints", name)
        if (part.value is None) == (part.velocity is None):
            message = "neither 'value' nor 'velocity' is given"
            if part.value is not None:
                message = "either 'value' or 'velocity' is possible, not both"
            help = "write value = ... for positions, or velocity = ... for velocities"
            self.draft.error(path, message, help)
        value = self._row((*path, "value"), part.value, CONSTRAINT, "position")
        velocity = self._row((*path, "velocity"), part.velocity, VELOCITY_ROW, "rate")
        return Constraint(value=value, velocity=velocity)

    def _row(self, path: Path, reading: Any, place: Any, level: Level) -> Number | None:
        """Read one row, which depends on positions, or linearly on velocities."""
        before = len(self.draft.problems)
        number = self.geometry.numbers.optional(path, reading, place)
        if reading is None or reading is BROKEN or len(self.draft.problems) > before:
            return number
        levels = {self.geometry.known.quantities.get(m.name) for m in reading.mentions}
        calls = any(mention.role == "function" for mention in reading.mentions)
        if level not in levels and not (level == "position" and calls):
            what = "position" if level == "position" else "velocity"
            self.draft.error(path, f"mentions no {what} of the mechanism: it constrains nothing")
        elif level == "rate" and _degree(number, self.geometry.known.quantities) > 1:
            message = "must be linear in the velocities"
            self.draft.error(path, message, 'such as "A.vx*sin(b) - A.vy*cos(b)"')
        return number


_READERS: dict[type, Any] = {
    schema.PositionDriver: Drivers._position,
    schema.DistanceDriver: Drivers._distance,
    schema.AngleDriver: Drivers._joint,
    schema.DisplacementDriver: Drivers._joint,
}


def _degree(number: Any, levels: Any) -> int:
    """Degree of an expression in the velocities; 2 stands for everything but linear."""
    if not isinstance(number, Expr) or number.op == "call":
        return 0
    if number.op == "symbol":
        return int(levels.get(number.args[0]) == "rate")
    degrees = [_degree(arg, levels) for arg in number.args]
    if number.op in ("add", "sub", "neg"):
        return max(degrees)
    if number.op == "mul":
        return min(2, sum(degrees))
    if number.op == "div":
        return degrees[0] if degrees[1] == 0 else 2
    if number.op == "select":
        return max(degrees[1:]) if degrees[0] == 0 else 2
    return 2 if any(degrees) else 0
