"""Joints between two bodies: pairs, places and axes; or of two points that become one."""

from __future__ import annotations

import math
from typing import Any

from solver.scene import schema_joints as schema
from solver.scene.fields import BROKEN
from solver.scene.geometry import Geometry
from solver.scene.numbers import GEOMETRY, NOT_ZERO
from solver.scene.references import References
from solver.scene.report import Path
from solver.scene.vocabulary_joints import BodyJoint
from solver.scene.vocabulary_parts import Vector

ALIGNED = 1e-6
"""Sine of an angle below which directions count as parallel, and its cosine as perpendicular."""

MEETING = ("spherical", "revolute", "universal", "fixed")
"""Types of joints at whose position a place of one body and one of the other are the same."""

_HOW = "write bodies = [...] and position = [...]"


class BodyJoints:
    """Reader of the joints that have two bodies."""

    def __init__(self, geometry: Geometry, references: References) -> None:
        self.geometry = geometry
        self.references = references
        self.draft = geometry.draft

    def read(self, path: Path, part: Any) -> BodyJoint:
        """Read a joint between two bodies, or of two points that coincide."""
        if getattr(part, "points", None) is not None:
            return self._shared_point(path, part)
        if part.bodies is None:
            self.draft.error(path, "'bodies' is missing", _HOW)
        if getattr(part, "at", None) is not None:
            message = "'at' belongs to 'points'; bodies meet at 'position'"
            self.draft.error((*path, "at"), message)
        bodies = BROKEN if part.bodies is None else part.bodies
        pair = self.references.pair((*path, "bodies"), bodies)
        axis, second = self._axes(path, part)
        pitch = getattr(part, "pitch", None)
        number = self.geometry.numbers.optional
        position = self._position(path, part, pair)
        return BodyJoint(
            type=part.type,
            bodies=pair,
            position=position,
            on=self._points(path, part, pair, position),
            axis=axis,
            second_axis=second,
            pitch=number((*path, "pitch"), pitch, GEOMETRY, NOT_ZERO, "m per turn"),
        )

    def _shared_point(self, path: Path, part: Any) -> BodyJoint:
        if part.bodies is not None:
            message = "either 'points' or 'bodies' is possible, not both"
            self.draft.error((*path, "bodies"), message, "leave out one of them")
        for field in ("position", "axis"):
            if getattr(part, field, None) is not None:
                message = f"points that become one need no '{field}'"
                self.draft.error((*path, field), message, "leave it out")
        if part.type == "revolute" and self.geometry.dimension == 3:
            message = "a revolute joint in space joins bodies, not points"
            help = f'{_HOW}, or type = "spherical"'
            self.draft.error((*path, "points"), message, help)
        return BodyJoint(type=part.type, bodies=None, points=self.references.ends(path, part))

    def _position(self, path: Path, part: Any, pair: tuple[str | None, str | None]) -> Vector:
        """Read the place of a joint; where it does not matter, the second body's origin will do."""
        if part.position is not None:
            return self.geometry.vector((*path, "position"), part.position)
        if part.type in ("fixed", "prismatic"):
            drawn = self.references.places.drawn
            places = [drawn[name] for name in pair[::-1] if name in drawn]
            return places[0] if places else self.geometry.zero()
        help = f"write position = {'[0, 0]' if self.geometry.dimension == 2 else '[0, 0, 0]'}"
        if part.bodies is not None:
            self.draft.error(path, "'position' is missing: where the bodies meet", help)
        return self.geometry.zero()

    def _points(
        self, path: Path, part: Any, pair: tuple[str | None, str | None], position: Vector
    ) -> tuple[str | None, str | None]:
        """Named points of the two bodies that are one at the position, where that matters."""
        if part.type not in MEETING or part.position is None:
            return None, None
        where = (*path, "position")
        first, second = (self.references.places.point_at(where, body, position) for body in pair)
        held = {*self.references.fixed, None} if None in pair else {first}
        if (first or second) and {first, second} <= held:
            message = f"the bar ends in the fixed point '{first or second}', which holds it already"
            if None not in pair:
                message = f"both bars end in '{first}', about which they turn already"
            bar = pair[1] or pair[0]
            help = f"leave the joint out: '{bar}' turns about its ends"
            if part.type == "fixed":
                help = f'hold its angle instead, by a constraint with value = "{bar}.angle - ..."'
            self.draft.error(path, message, help)
        return first, second

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
        axes = self.two_axes((*path, "axes"), part.axes)
        cosine = self.cosine(axes)
        if cosine is not None and abs(cosine) > ALIGNED:
            angle = math.degrees(math.acos(cosine))
            message = f"the two axes must be perpendicular, got {angle:.6g} degrees between them"
            self.draft.error((*path, "axes"), message)
        return axes

    def two_axes(self, path: Path, given: Any) -> tuple[Vector, Vector]:
        """Read two directions."""
        if given is BROKEN:
            return self.geometry.zero(), self.geometry.zero()
        first, second = (self.geometry.axis((*path, i), axis) for i, axis in enumerate(given))
        return first, second

    def cosine(self, axes: tuple[Vector, Vector]) -> float | None:
        """Cosine of the angle between two directions; None where one has no direction."""
        first, second = (self.geometry.values(axis) for axis in axes)
        if not first or not second or len(first) != len(second):
            return None
        lengths = math.hypot(*first) * math.hypot(*second)
        if not 0.0 < lengths < math.inf:
            return None
        cosine = math.fsum(x * y for x, y in zip(first, second, strict=True)) / lengths
        return max(-1.0, min(1.0, cosine))
