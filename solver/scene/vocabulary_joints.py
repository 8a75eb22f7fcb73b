"""The words of a scene for what joins its parts: joints and constraints.

Places and axes are those of the drawn configuration, in global axes. Lengths in m, angles in rad.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, TypeAlias

from solver.scene.expression import Number
from solver.scene.vocabulary_parts import PointReference, Vector


@dataclass(frozen=True, slots=True, kw_only=True)
class Distance:
    """A massless rod: two points keep their distance."""

    points: tuple[PointReference, PointReference]
    length: Number | None = None
    """None: as drawn."""


@dataclass(frozen=True, slots=True, kw_only=True)
class BodyJoint:
    """A lower pair between two bodies, or two points that coincide.

    In the plane: revolute, prismatic, fixed. In space: spherical, revolute, universal, cylindrical,
    prismatic, planar, fixed, screw.
    """

    type: str
    bodies: tuple[str | None, str | None] | None
    """Names of rigid bodies (in the plane also of bars); None in a pair is the ground."""
    points: tuple[PointReference, PointReference] | None = None
    """Instead of `bodies` and `position`, for spherical, and for revolute in the plane."""
    position: Vector | None = None
    """Of the joint, as drawn, in global axes."""
    on: tuple[str | None, str | None] = (None, None)
    """Named points of the two bodies that `position` means, since it lies there: "rod.tip"."""
    axis: Vector | None = None
    """Of the joint, as drawn, in global axes, of any length; in a universal joint fixed in the
    first body; the normal of a planar joint."""
    second_axis: Vector | None = None
    """Of a universal joint, fixed in the second body; perpendicular to `axis`."""
    pitch: Number | None = None
    """Of a screw: advance of the second body in m per turn."""


@dataclass(frozen=True, slots=True, kw_only=True)
class PointOn:
    """A point stays on a line, a plane or a surface F(x, y, z) = 0 that a body carries."""

    type: Literal["point_on_line", "point_on_plane", "point_on_surface"]
    point: PointReference
    body: str | None
    """None: the ground."""
    position: Vector | None = None
    """A place of the line or plane as drawn; None: where the point is drawn."""
    axis: Vector | None = None
    """Direction of the line, normal of the plane, as drawn."""
    surface: Number | None = None
    """F, an expression in the symbols x, y, z: coordinates in m in the axes of the body, from its
    origin. In the plane a curve F(x, y) = 0."""


@dataclass(frozen=True, slots=True, kw_only=True)
class ConstantAngle:
    """The angle between an axis of one body and an axis of another one is constant."""

    bodies: tuple[str | None, str | None]
    axes: tuple[Vector, Vector]
    """As drawn, in global axes, of any length."""
    value: Number | None = None
    """Angle in rad; None: as drawn."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Gear:
    """angle of the second joint = ratio * angle of the first, both zero as drawn."""

    joints: tuple[str, str]
    ratio: Number


@dataclass(frozen=True, slots=True, kw_only=True)
class Rack:
    """displacement of the second joint = radius * angle of the first, both zero as drawn."""

    joints: tuple[str, str]
    radius: Number


@dataclass(frozen=True, slots=True, kw_only=True)
class Rolling:
    """A thin disc of a rigid body rolls without slip on a fixed plane (2-D: a fixed line)."""

    body: str
    """Its origin is the centre of the disc."""
    radius: Number
    axis: Vector | None = None
    """Of the disc, as drawn, in space; None in the plane."""
    position: Vector | None = None
    """A place of the plane or line; None: the origin of the global axes."""
    normal: Vector | None = None
    """Of the plane or line, towards the disc; None: +z in space, +y in the plane."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Constraint:
    """An expression over the mechanism that stays zero: of positions, or linear in velocities."""

    value: Number | None = None
    velocity: Number | None = None
    """Exactly one of the two is given."""


Joint: TypeAlias = Distance | BodyJoint | PointOn | ConstantAngle | Gear | Rack | Rolling
