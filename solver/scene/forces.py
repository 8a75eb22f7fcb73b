"""Forces, torques and potentials of a scene: what they act on, and what they may depend on."""

from __future__ import annotations

from typing import Any

from solver.scene import schema_forces as schema
from solver.scene.expression import Number
from solver.scene.fields import BROKEN
from solver.scene.geometry import Geometry
from solver.scene.joint_names import JointNames
from solver.scene.numbers import FORCE, LOAD, NOT_NEGATIVE, POSITIVE, POTENTIAL, PROPERTY, Place
from solver.scene.references import References
from solver.scene.report import Path
from solver.scene.vocabulary_forces import (
    Damper,
    Force,
    ForceElement,
    Gravitation,
    JointTorque,
    Potential,
    Spring,
    Torque,
    TorsionDamper,
    TorsionSpring,
)
from solver.scene.vocabulary_parts import Body, Point, Rigid, Vector

STORED = Place(own=("length",))
"""Where the energy of a spring stands."""


class Forces:
    """Reader of the table [forces]."""

    def __init__(self, geometry: Geometry, references: References, joints: JointNames) -> None:
        self.geometry = geometry
        self.references = references
        self.joints = joints
        self.draft = geometry.draft
        self.numbers = geometry.numbers
        self.masses: dict[str, Number] = {}
        """Of points, and of bodies by the name of their origin."""

    def read(self, points: dict[str, Point], bodies: dict[str, Body]) -> dict[str, ForceElement]:
        """Read all forces."""
        self.masses = {name: point.mass for name, point in points.items()}
        self.masses |= {name: b.mass for name, b in bodies.items() if isinstance(b, Rigid)}
        parts = self.draft.parts("forces")
        return {
            name: _READERS[type(part)](self, ("forces", name), part) for name, part in parts.items()
        }

    def _spring(self, path: Path, part: schema.Spring) -> Spring:
        optional, energy = self.numbers.optional, (*path, "energy")
        if part.stiffness is None and part.energy is None:
            help = "write stiffness = 100.0, or an energy in 'length'"
            self.draft.error(path, "'stiffness' is missing", help)
        elif part.stiffness is not None and part.energy is not None:
            message = "a spring has a stiffness or an energy, not both"
            self.draft.error(energy, message, "leave out one of them")
        elif part.energy is not None and part.free_length is not None:
            message = "the energy already defines the free length of the spring"
            self.draft.error((*path, "free_length"), message, "leave it out")
        if part.energy not in (None, BROKEN) and "length" not in _mentioned(part.energy):
            message = "mentions no 'length', the length of the spring in m"
            self.draft.error(energy, message, 'such as "50*(length - 1)**2"')
        free = (*path, "free_length")
        return Spring(
            points=self.references.ends(path, part),
            stiffness=optional((*path, "stiffness"), part.stiffness, FORCE, NOT_NEGATIVE, "N/m"),
            free_length=optional(free, part.free_length, FORCE, NOT_NEGATIVE, "m"),
            energy=optional(energy, part.energy, STORED),
        )

    def _damper(self, path: Path, part: schema.Damper) -> Damper:
        where = (*path, "damping")
        damping = self.numbers.number(where, part.damping, FORCE, NOT_NEGATIVE, "N.s/m")
        return Damper(points=self.references.ends(path, part), damping=damping)

    def _torsion_spring(self, path: Path, part: schema.TorsionSpring) -> TorsionSpring:
        where, number = (*path, "stiffness"), self.numbers.number
        joint = self._joint(path, part)
        stiffness = number(where, part.stiffness, FORCE, NOT_NEGATIVE, "N.m/rad")
        free = part.free_angle
        if free is not None:
            free = self.numbers.angle((*path, "free_angle"), free, FORCE)
        return TorsionSpring(
            joint=joint,
            stiffness=stiffness,
            free_angle=0.0 if free is None else free,
        )

    def _torsion_damper(self, path: Path, part: schema.TorsionDamper) -> TorsionDamper:
        where = (*path, "damping")
        damping = self.numbers.number(where, part.damping, FORCE, NOT_NEGATIVE, "N.m.s/rad")
        return TorsionDamper(joint=self._joint(path, part), damping=damping)

    def _joint_torque(self, path: Path, part: schema.JointTorque) -> JointTorque:
        value = self.numbers.number((*path, "value"), part.value, LOAD)
        return JointTorque(joint=self._joint(path, part), value=value)

    def _joint(self, path: Path, part: Any) -> str:
        self.joints.with_angle((*path, "joint"), part.joint)
        return part.joint if isinstance(part.joint, str) else ""

    def _force(self, path: Path, part: schema.Force) -> Force:
        point = self.references.point(path, part)
        if point.point in self.references.fixed:
            self.draft.error((*path, "point"), f"a force on the fixed point '{point.point}'")
        axes = "global" if part.axes is BROKEN else part.axes
        if axes == "body" and point.point and self.references.owner(point.point) is None:
            message = f"'{point.point}' is a point, which has no axes of a body"
            self.draft.error((*path, "axes"), message, "name a point of a rigid body")
        value = self.geometry.vector((*path, "value"), part.value, LOAD)
        return Force(point=point, value=value, axes=axes)

    def _torque(self, path: Path, part: schema.Torque) -> Torque:
        axes = "global" if part.axes is BROKEN else part.axes
        if part.body is not BROKEN and self.references.body((*path, "body"), part.body, bar=True):
            kind = self.geometry.known.parts.get(part.body)
            if axes == "body" and kind == "bar" and self.geometry.dimension == 3:
                message = f"the bar '{part.body}' has no axes in space"
                self.draft.error((*path, "axes"), message, "leave it out: global axes")
        body = part.body if isinstance(part.body, str) else ""
        return Torque(body=body, value=self._moment((*path, "value"), part.value), axes=axes)

    def _moment(self, where: Path, value: Any) -> Number | Vector:
        if value is BROKEN:
            return 0.0
        if isinstance(value, list):
            if self.geometry.dimension == 2:
                self.draft.error(where, "must be a number in dimension 2, got a vector")
                return 0.0
            return self.geometry.vector(where, value, LOAD)
        if self.geometry.dimension == 3:
            help = 'write value = [0, 0, "..."]'
            self.draft.error(where, "must be a vector of 3 numbers in dimension 3", help)
        return self.numbers.number(where, value, LOAD)

    def _potential(self, path: Path, part: schema.Potential) -> Potential:
        where = (*path, "value")
        value = self.numbers.number(where, part.value, POTENTIAL)
        if part.value is not BROKEN and not _mentions_the_mechanism(self.geometry, part.value):
            message = "mentions no position of the mechanism, and so makes no force"
            self.draft.error(where, message, 'such as "2.0*A.x**2"')
        return Potential(value=value)

    def _gravitation(self, path: Path, part: schema.Gravitation) -> Gravitation:
        number, optional = self.numbers.number, self.numbers.optional
        ends = self.references.ends(path, part)
        if part.masses is None:
            first, second = (self._mass(path, part, i) for i in range(2))
        elif part.masses is BROKEN:
            first = second = 1.0
        else:
            first, second = (
                number((*path, "masses", i), mass, PROPERTY, POSITIVE, "kg")
                for i, mass in enumerate(part.masses)
            )
        constant = optional((*path, "constant"), part.constant, PROPERTY)
        given = {} if constant is None else {"constant": constant}
        return Gravitation(points=ends, masses=(first, second), **given)

    def _mass(self, path: Path, part: Any, end: int) -> Number:
        """Mass of a named point or body."""
        if part.points is BROKEN or part.points[end] not in self.masses:
            name = "" if part.points is BROKEN else part.points[end]
            if name == "ground" or name in self.geometry.known.ends:
                message = f"'masses' is missing: '{name}' has no mass of its own"
                self.draft.error(path, message, "write masses = [..., ...]")
            return 1.0
        mass = self.masses[part.points[end]]
        if self.numbers.value(mass) == 0.0:
            message = f"'masses' is missing: '{part.points[end]}' has no mass of its own"
            self.draft.error(path, message, "write masses = [..., ...]")
        return mass


def _mentioned(reading: Any) -> set[str]:
    return {mention.name for mention in reading.mentions}


def _mentions_the_mechanism(geometry: Geometry, reading: Any) -> bool:
    """Whether an expression depends on the mechanism, or is wrong for another reason."""
    return any(
        mention.role == "function" or mention.name not in geometry.known.parts
        for mention in reading.mentions
        if mention.name != "t"
    )


_READERS: dict[type, Any] = {
    schema.Spring: Forces._spring,
    schema.Damper: Forces._damper,
    schema.TorsionSpring: Forces._torsion_spring,
    schema.TorsionDamper: Forces._torsion_damper,
    schema.JointTorque: Forces._joint_torque,
    schema.Force: Forces._force,
    schema.Torque: Forces._torque,
    schema.Potential: Forces._potential,
    schema.Gravitation: Forces._gravitation,
}
