"""Joints of a scene: which bodies and points they join, where, and along which axes."""

from __future__ import annotations

import math
from typing import Any

from solver.scene import schema_joints as schema
from solver.scene.body_joints import ALIGNED, BodyJoints
from solver.scene.expression import Number
from solver.scene.fields import BROKEN
from solver.scene.geometry import Geometry
from solver.scene.joint_names import JointNames
from solver.scene.numbers import GEOMETRY, NOT_ZERO, POSITIVE, Place
from solver.scene.references import References
from solver.scene.report import Path
from solver.scene.vocabulary_joints import (
    ConstantAngle,
    Distance,
    Gear,
    Joint,
    PointOn,
    Rack,
    Rolling,
)


class Joints:
    """Reader of the table [joints]."""

    def __init__(self, geometry: Geometry, references: References, names: JointNames) -> None:
        self.geometry = geometry
        self.references = references
        self.draft = geometry.draft
        self.names = names
        self.of_bodies = BodyJoints(geometry, references)

    def read(self) -> dict[str, Joint]:
        """Read all joints."""
        return {name: self._joint(name, part) for name, part in self.draft.parts("joints").items()}

    def _joint(self, name: str, part: Any) -> Joint:
        reader, path = _READERS.get(type(part)), ("joints", name)
        return self.of_bodies.read(path, part) if reader is None else reader(self, path, part)

    def _distance(self, path: Path, part: schema.Distance) -> Distance:
        number = self.geometry.numbers.optional
        return Distance(
            points=self.references.ends(path, part),
            length=number((*path, "length"), part.length, GEOMETRY, POSITIVE, "m"),
        )

    def _point_on(self, path: Path, part: Any) -> PointOn:
        """Read a point that stays on a line, plane or surface of a body."""
        point = self.references.point(path, part)
        where = (*path, "point")
        if point.point in self.references.fixed and part.body == "ground":
            self.draft.error(where, f"the point '{point.point}' is fixed, and so is the ground")
        body = None
        if part.body is not BROKEN and self.references.body((*path, "body"), part.body, True):
            body = None if part.body == "ground" else part.body
        if body is not None and point.point and self.references.owner(point.point) == body:
            self.draft.error(where, f"'{point.point}' is a point of the body '{body}' itself")
        if isinstance(part, schema.PointOnSurface):
            return PointOn(
                type=part.type, point=point, body=body, surface=self._surface(path, part)
            )
        return PointOn(
            type=part.type,
            point=point,
            body=body,
            position=self.geometry.optional((*path, "position"), part.position),
            axis=self.geometry.axis((*path, "axis"), part.axis),
        )

    def _surface(self, path: Path, part: schema.PointOnSurface) -> Number:
        where = (*path, "surface")
        own = ("x", "y") if self.geometry.dimension == 2 else ("x", "y", "z")
        surface = self.geometry.numbers.number(where, part.surface, Place(tunable=False, own=own))
        if part.surface is not BROKEN and not any(m.name in own for m in part.surface.mentions):
            message = f"mentions none of the coordinates {', '.join(own)} of the point"
            self.draft.error(where, message, "write an expression that is 0 on the surface")
        return surface

    def _angle(self, path: Path, part: schema.Angle) -> ConstantAngle:
        pair = self.references.pair((*path, "bodies"), part.bodies)
        axes = self.of_bodies.two_axes((*path, "axes"), part.axes)
        value = self.geometry.numbers.optional((*path, "value"), part.value, GEOMETRY)
        cosine = self.of_bodies.cosine(axes)
        given = None if value is None else self.geometry.numbers.value(value)
        help = "for parallel axes write 'prismatic', 'cylindrical' or 'planar'"
        if given is not None and not (ALIGNED < given < math.pi - ALIGNED):
            if given > math.pi:
                help = f'if these are degrees, write "{given:.12g}*pi/180"'
            message = f"must be > 0 and < pi rad, where the joint is singular, got {given:.15g}"
            self.draft.error((*path, "value"), message, help)
        elif value is None and cosine is not None and 1.0 - abs(cosine) < 0.5 * ALIGNED**2:
            message = "the axes are parallel as drawn, where the joint is singular"
            self.draft.error((*path, "axes"), message, help)
        return ConstantAngle(bodies=pair, axes=axes, value=value)

    def _gear(self, path: Path, part: schema.Gear) -> Gear:
        number = self.geometry.numbers.number
        return Gear(
            joints=self._two_joints(path, part, self.names.with_angle),
            ratio=number((*path, "ratio"), part.ratio, GEOMETRY, NOT_ZERO),
        )

    def _rack(self, path: Path, part: schema.Rack) -> Rack:
        number = self.geometry.numbers.number
        return Rack(
            joints=self._two_joints(path, part, self.names.with_displacement),
            radius=number((*path, "radius"), part.radius, GEOMETRY, NOT_ZERO, "m"),
        )

    def _two_joints(self, path: Path, part: Any, second_fits: Any) -> tuple[str, str]:
        if part.joints is BROKEN:
            return "", ""
        first, second = part.joints
        fine = self.names.with_angle((*path, "joints", 0), first)
        fine = second_fits((*path, "joints", 1), second) and fine
        if fine and first == second and part.type == "gear":
            self.draft.error((*path, "joints"), f"both joints are '{first}'")
        return first, second

    def _rolling(self, path: Path, part: schema.Rolling) -> Rolling:
        geometry, planar = self.geometry, self.geometry.dimension == 2
        if part.body is not BROKEN:
            if geometry.known.parts.get(part.body) == "bar":
                self.draft.error((*path, "body"), f"'{part.body}' is a bar, and does not roll")
            else:
                self.references.body((*path, "body"), part.body)
        axis = None
        if planar and part.axis is not None:
            message = "a disc in the plane has no axis: it turns about z"
            self.draft.error((*path, "axis"), message, "leave it out")
        elif not planar and part.axis is None:
            self.draft.error(path, "'axis' is missing: that of the disc", "write axis = [0, 1, 0]")
        elif part.axis is not None:
            axis = geometry.axis((*path, "axis"), part.axis)
        normal = part.normal
        return Rolling(
            body=part.body if isinstance(part.body, str) else "",
            radius=geometry.numbers.number((*path, "radius"), part.radius, GEOMETRY, POSITIVE, "m"),
            axis=axis,
            position=geometry.optional((*path, "position"), part.position),
            normal=None if normal is None else geometry.axis((*path, "normal"), normal),
        )


_READERS: dict[type, Any] = {
    schema.Distance: Joints._distance,
    schema.PointOnLine: Joints._point_on,
    schema.PointOnPlane: Joints._point_on,
    schema.PointOnSurface: Joints._point_on,
    schema.Angle: Joints._angle,
    schema.Gear: Joints._gear,
    schema.Rack: Joints._rack,
    schema.Rolling: Joints._rolling,
}
