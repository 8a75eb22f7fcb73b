"""Joints of a scene: which bodies and points they join, where, and along which axes."""

from __future__ import annotations

import math
from typing import Any

from solver.scene import schema_joints as schema
from solver.scene.fields import BROKEN
from solver.scene.geometry import Geometry
from solver.scene.numbers import GEOMETRY, NOT_ZERO, POSITIVE, Place, a
from solver.scene.quantities import WITH_ANGLE, WITH_DISPLACEMENT, Inventory
from solver.scene.references import References
from solver.scene.report import Path, did_you_mean
from solver.scene.types_of_parts import SHARED_POINT
from solver.scene.vocabulary import (
    BodyJoint,
    ConstantAngle,
    Distance,
    Gear,
    Joint,
    PointOn,
    Rack,
    Rolling,
    Vector,
)

ALIGNED = 1e-6
"""Sine of an angle below which directions count as parallel, and its cosine as perpendicular."""

_HOW = "write bodies = [...] and position = [...]"


class Joints:
    """Reader of the table [joints], and judge of references to joints."""

    def __init__(self, geometry: Geometry, references: References, inventory: Inventory) -> None:
        self.geometry = geometry
        self.references = references
        self.draft = geometry.draft
        self.types = inventory.joints
        """Type of each joint in the file, "" where it is unknown."""

    def read(self) -> dict[str, Joint]:
        """Read all joints."""
        return {name: self._joint(name, part) for name, part in self.draft.parts("joints").items()}

    def _joint(self, name: str, part: Any) -> Joint:
        path = ("joints", name)
        for kind, reader in _READERS.items():
            if isinstance(part, kind):
                return reader(self, path, part)
        return self._body_joint(path, part)

    def with_angle(self, path: Path, name: Any) -> bool:
        """Report a name that is no joint with an angle."""
        return self._has(path, name, WITH_ANGLE, "angle")

    def with_displacement(self, path: Path, name: Any) -> bool:
        """Report a name that is no joint with a displacement."""
        return self._has(path, name, WITH_DISPLACEMENT, "displacement")

    def _has(self, path: Path, name: Any, kinds: tuple[str, ...], what: str) -> bool:
        if name is BROKEN:
            return False
        kind, part = self.types.get(name), self.geometry.known.parts.get(name)
        if kind == "" or (kind in kinds and part == "joint"):
            return kind != ""
        if kind is None or part != "joint":
            known = [joint for joint, kind in self.types.items() if kind in kinds]
            help = did_you_mean(name, known, f"joints with {a(what)}")
            message = f"'{name}' is {a(part)}, not a joint" if part else f"unknown joint '{name}'"
            self.draft.error(path, message, help)
            return False
        planar = self.geometry.dimension == 2
        help = f"joints with {a(what)}: {', '.join(k for k in kinds if not planar or k in _PLANAR)}"
        message = f"'{name}' is of type '{kind}', which has no {what}"
        if kind == SHARED_POINT:
            message = f"'{name}' joins points, and has no {what}"
            help = "give it bodies and position instead of points"
        self.draft.error(path, message, help)
        return False

    def _distance(self, path: Path, part: schema.Distance) -> Distance:
        number = self.geometry.numbers.optional
        return Distance(
            points=self.references.ends(path, part),
            length=number((*path, "length"), part.length, GEOMETRY, POSITIVE, "m"),
        )

    def _body_joint(self, path: Path, part: Any) -> Joint:
        """Read a joint between two bodies, or of two points that coincide."""
        if getattr(part, "points", None) is not None:
            return self._shared_point(path, part)
        if part.bodies is None:
            self.draft.error(path, "'bodies' is missing", _HOW)
        if getattr(part, "at", None) is not None:
            message = "'at' belongs to 'points'; bodies meet at 'position'"
            self.draft.error((*path, "at"), message)
        pair = self.references.pair((*path, "bodies"), part.bodies or BROKEN)
        axis, second = self._axes(path, part)
        pitch = getattr(part, "pitch", None)
        number = self.geometry.numbers.optional
        return BodyJoint(
            type=part.type,
            bodies=pair,
            position=self._position(path, part, pair),
            axis=axis,
            second_axis=second,
            pitch=number((*path, "pitch"), pitch, GEOMETRY, NOT_ZERO, "m per turn"),
        )

    def _shared_point(self, path: Path, part: Any) -> BodyJoint:
        for field in ("bodies", "position", "axis"):
            if getattr(part, field, None) is not None:
                what = "and bodies" if field == "bodies" else f"without '{field}'"
                message = (
                    f"two points are joined {what}"
                    if field != "bodies"
                    else ("either 'points' or 'bodies', not both")
                )
                self.draft.error((*path, field), message, f"leave out '{field}'")
        if part.type == "revolute" and self.geometry.dimension == 3:
            help = f'{_HOW}, or type = "spherical"'
            self.draft.error((*path, "points"), "a hinge in space joins bodies, not points", help)
        return BodyJoint(type=part.type, bodies=None, points=self.references.ends(path, part))

    def _position(self, path: Path, part: Any, pair: tuple[str | None, str | None]) -> Vector:
        """Read the place of a joint; where it does not matter, the second body's origin will do."""
        if part.position is not None:
            return self.geometry.vector((*path, "position"), part.position)
        if part.type in ("fixed", "prismatic"):
            names = [name for name in (*pair[::-1],) if name is not None]
            places = [self._origin(name) for name in names]
            return next((place for place in places if place is not None), self.geometry.zero())
        help = f"write position = {'[0, 0]' if self.geometry.dimension == 2 else '[0, 0, 0]'}"
        if part.bodies is not None:
            self.draft.error(path, "'position' is missing: where the bodies meet", help)
        return self.geometry.zero()

    def _origin(self, body: str) -> Vector | None:
        """Where a body is drawn: its origin, or the first point of a bar."""
        data = self.draft.data["bodies"].get(body, {})
        points = data.get("points") if isinstance(data, dict) else None
        if self.geometry.known.parts.get(body) == "bar" and isinstance(points, list) and points:
            body = str(points[0])
        return self.references.places.get(body)

    def _axes(self, path: Path, part: Any) -> tuple[Vector | None, Vector | None]:
        if isinstance(part, schema.Universal):
            return self._cross(path, part)
        axis = getattr(part, "axis", None)
        if isinstance(part, schema.Revolute):
            if self.geometry.dimension == 2 and axis is not None:
                message = "a revolute joint in the plane has no axis: it turns about z"
                self.draft.error((*path, "axis"), message, "leave it out")
                return None, None
            if self.geometry.dimension == 3 and axis is None:
                self.draft.error(path, "'axis' is missing", "write axis = [0, 0, 1]")
        return (None if axis is None else self.geometry.axis((*path, "axis"), axis)), None

    def _cross(self, path: Path, part: schema.Universal) -> tuple[Vector | None, Vector | None]:
        """Read the two axes of a universal joint, which are at right angles."""
        axes = self._two_axes((*path, "axes"), part.axes)
        cosine = self._cosine(axes)
        if cosine is not None and abs(cosine) > ALIGNED:
            angle = math.degrees(math.acos(cosine))
            message = f"the two axes must be perpendicular, got {angle:.6g} degrees between them"
            self.draft.error((*path, "axes"), message)
        return axes

    def _two_axes(self, path: Path, given: Any) -> tuple[Vector, Vector]:
        if given is BROKEN:
            return self.geometry.zero(), self.geometry.zero()
        first, second = (self.geometry.axis((*path, i), axis) for i, axis in enumerate(given))
        return first, second

    def _cosine(self, axes: tuple[Vector, Vector]) -> float | None:
        """Cosine of the angle between two directions; None where one has no direction."""
        first, second = (self.geometry.values(axis) for axis in axes)
        if not first or not second or len(first) != len(second):
            return None
        lengths = math.hypot(*first) * math.hypot(*second)
        cosine = (
            math.fsum(x * y for x, y in zip(first, second, strict=True)) / lengths
            if (0.0 < lengths < math.inf)
            else None
        )
        return None if cosine is None else max(-1.0, min(1.0, cosine))

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

    def _surface(self, path: Path, part: schema.PointOnSurface) -> Any:
        where = (*path, "surface")
        own = ("x", "y") if self.geometry.dimension == 2 else ("x", "y", "z")
        surface = self.geometry.numbers.number(where, part.surface, Place(tunable=False, own=own))
        mentioned = {m.name for m in part.surface.mentions} if part.surface is not BROKEN else own
        if not mentioned & set(own) if isinstance(mentioned, set) else False:
            message = f"mentions none of the coordinates {', '.join(own)}"
            self.draft.error(where, message, "an expression that is 0 on the surface")
        return surface

    def _angle(self, path: Path, part: schema.Angle) -> ConstantAngle:
        pair = self.references.pair((*path, "bodies"), part.bodies)
        axes = self._two_axes((*path, "axes"), part.axes)
        value = self.geometry.numbers.optional((*path, "value"), part.value, GEOMETRY)
        cosine = self._cosine(axes)
        given = None if value is None else self.geometry.numbers.value(value)
        help = "for parallel axes write 'prismatic', 'cylindrical' or 'planar'"
        if given is not None and not (ALIGNED < given < math.pi - ALIGNED):
            message = f"must be > 0 and < pi rad, where the joint is singular, got {given:.15g}"
            self.draft.error((*path, "value"), message, help)
        elif value is None and cosine is not None and 1.0 - abs(cosine) < 0.5 * ALIGNED**2:
            message = "the axes are parallel as drawn, where the joint is singular"
            self.draft.error((*path, "axes"), message, help)
        return ConstantAngle(bodies=pair, axes=axes, value=value)

    def _gear(self, path: Path, part: schema.Gear) -> Gear:
        number = self.geometry.numbers.number
        return Gear(
            joints=self._two_joints(path, part, self.with_angle),
            ratio=number((*path, "ratio"), part.ratio, GEOMETRY, NOT_ZERO),
        )

    def _rack(self, path: Path, part: schema.Rack) -> Rack:
        number = self.geometry.numbers.number
        return Rack(
            joints=self._two_joints(path, part, self.with_displacement),
            radius=number((*path, "radius"), part.radius, GEOMETRY, NOT_ZERO, "m"),
        )

    def _two_joints(self, path: Path, part: Any, second_fits: Any) -> tuple[str, str]:
        if part.joints is BROKEN:
            return "", ""
        first, second = part.joints
        fine = self.with_angle((*path, "joints", 0), first)
        fine = second_fits((*path, "joints", 1), second) and fine
        if fine and first == second and part.type == "gear":
            self.draft.error((*path, "joints"), f"both joints are '{first}'")
        return first, second

    def _rolling(self, path: Path, part: schema.Rolling) -> Rolling:
        geometry, planar = self.geometry, self.geometry.dimension == 2
        if part.body is not BROKEN and self.references.body((*path, "body"), part.body):
            if geometry.known.parts.get(part.body) == "bar":
                self.draft.error((*path, "body"), f"'{part.body}' is a bar, and does not roll")
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


_PLANAR = ("revolute", "prismatic")
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
