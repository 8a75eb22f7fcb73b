"""Solids of contacts: what touches, and the surfaces that it touches."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from solver.scene import (
    BodyJoint,
    BoxContact,
    CamContact,
    CapsuleContact,
    ClearanceContact,
    ConvexContact,
    CornersContact,
    CylinderContact,
    EllipsoidContact,
    HeightFieldContact,
    JournalContact,
    MeshContact,
    Number,
    PlaneContact,
    PointOnPlane,
    PointOnSurface,
    PointReference,
    PolygonContact,
    ProfileContact,
    Rolling,
    SphereContact,
    Stop,
    SuperquadricContact,
    SurfaceContact,
    Vector,
    evaluate,
)
from solver.scene.meshes import triangles_of
from viewer import contours
from viewer.places import Array, Place, rounded, turned_to
from viewer.solids import Solids, Z

WALL = 0.3
"""Of a hole with play, over the radius of its pin."""
CLEAR = 0.35
"""Opacity of what holds something inside."""
FLOOR = 0.5
"""Opacity of a plane or a surface in space, through which the grid below it is seen."""


class Touching:
    """Solids of the contacts of a scene, added to those of its bodies."""

    def __init__(self, solids: Solids) -> None:
        self.solids, self.places, self.scene = solids, solids.places, solids.scene
        self.flat = self.scene.dimension == 2
        self._drawn: set[tuple[str | None, Number]] = set()
        """Surfaces of formulas that several contacts may share."""

    def add(self, name: str, part: Any) -> None:
        """Add what is seen of a contact, or of a joint with a surface."""
        found = SOLIDS.get(type(part))
        if found is not None:
            found(self, name, part)

    # ----------------------------------------------------------------------------- pieces

    def _place(self, body: str | None, position: Vector | None) -> Place:
        """Return a place as drawn, or the origin of a body."""
        if position is not None:
            return self.places.drawn(body, self.places.vector(position))
        frame = self.places.frame(body)
        return self.places.fixed_to(frame, np.zeros(3))

    def _ball(
        self, name: str, end: PointReference | None, radius: Number, opacity: float = 1.0
    ) -> None:
        if end is not None and (size := self.places.number(radius)) > 0.0:
            self._round(name, end.point, self.places.of(end), size, opacity)

    def _round(
        self, name: str, body: str | None, place: Place, radius: float, opacity: float = 1.0
    ) -> None:
        """Add a ball, in the plane a disc."""
        body = (body or "").partition(".")[0] or None
        if self.flat:
            more: dict[str, Any] = {"radius": radius, "length": self.solids.thickness(radius)}
            self.solids.add(name, "contact", body, place, "cylinder", opacity=opacity, **more)
        else:
            self.solids.add(name, "contact", body, place, "sphere", opacity=opacity, radius=radius)

    def _plane(self, name: str, body: str | None, position: Vector | None, axis: Vector) -> None:
        zero = (0.0,) * self.scene.dimension
        place = self.places.drawn(body, self.places.vector(position or zero))
        normal = self.places.own(body, self.places.direction(axis))
        opacity = 1.0 if self.flat else FLOOR
        self.solids.add(name, "surface", body, place, "plane", opacity=opacity, normal=normal)

    def _corners(
        self, name: str, body: str | None, corners: Sequence[Vector], radius: Number
    ) -> None:
        """Add the hull of some corners of a body, each with a radius."""
        places, size = [*map(self.places.vector, corners)], self.places.number(radius)
        origin = self._place(body, None)
        if len(places) == 1:
            at = self.places.fixed_to(origin["frame"], places[0])
            self._round(name, body, at, size or 0.01 * self.solids.size)
        elif len(places) == 2:
            radius = size or 0.005 * self.solids.size
            ends = {"from": places[0], "to": places[1], "radius": radius}
            self.solids.add(name, "contact", body, origin, "capsule", **ends)
        elif self.flat:
            hull = contours.around(places, size)
            thick = self.solids.thickness(0.0)
            self.solids.add(
                name, "contact", body, origin, "prism", corners=rounded(hull), thickness=thick
            )
        else:
            self._mesh(name, body, origin, np.array(places), None)

    def _mesh(
        self, name: str, body: str | None, place: Place, vertices: Array,
        triangles: contours.Triangles | None,
        kind: str = "contact", opacity: float = 1.0,
    ) -> None:  # fmt: skip
        """Add a mesh, or the hull of its corners."""
        if triangles is None:
            vertices = vertices[:: 1 + len(vertices) // 32]
            triangles = contours.hull(vertices)
        vertices, triangles = contours.coarser(vertices, triangles)
        more: dict[str, Any] = {"vertices": rounded(vertices), "triangles": triangles}
        self.solids.add(name, kind, body, place, "mesh", opacity=opacity, **more)

    def _file(self, mesh: Any, scale: float) -> tuple[Array, contours.Triangles]:
        found = triangles_of(mesh)
        return scale * np.array(found.vertices, float), np.array(found.faces, int)

    def _curve(self, name: str, body: str | None, place: Place, points: Array, turn: Any) -> None:
        places = np.column_stack((points, np.zeros((len(points), 3 - points.shape[1]))))
        self.solids.add(name, "surface", body, place, "curve", turn, points=rounded(places))

    # ----------------------------------------------------------------------------- contacts

    def _on_plane(self, name: str, part: PlaneContact) -> None:
        self._plane(name, part.body, part.position, part.axis)
        self._ball(name, part.point, part.radius)

    def _corners_on_plane(self, name: str, part: CornersContact) -> None:
        self._plane(name, part.on, part.position, part.axis)
        if part.size is None:
            self._corners(name, part.body, part.corners, part.radius)
        else:
            self._box(name, part.body, part.size)

    def _box(self, name: str, body: str | None, size: Vector) -> None:
        edges = self.places.vector(size)
        edges[2] = edges[2] or self.solids.thickness(0.0)
        self.solids.add(name, "contact", body, self._place(body, None), "box", size=edges)

    def _cylinder(self, name: str, part: CylinderContact) -> None:
        self._plane(name, part.on, part.position, part.axis)
        radius, length = map(self.places.number, (part.radius, part.length))
        turn = turned_to(self.places.vector(part.along))
        more: dict[str, Any] = {"radius": radius, "length": length or 0.02 * radius}
        place = self._place(part.body, None)
        self.solids.add(name, "contact", part.body, place, "cylinder", turn, **more)

    def _ellipsoid(self, name: str, part: EllipsoidContact) -> None:
        if part.axis is not None:
            self._plane(name, part.on, part.position, part.axis)
        place, half = self._place(part.body, None), self.places.vector(part.semi_axes)
        if self.flat:
            turns = np.linspace(0.0, 2.0 * math.pi, 97)[:-1]
            corners = half[:2] * np.column_stack((np.cos(turns), np.sin(turns)))
            more: dict[str, Any] = {
                "corners": rounded(corners), "thickness": self.solids.thickness(0.0)
            }  # fmt: skip
            self.solids.add(name, "contact", part.body, place, "prism", **more)
        else:
            more = {"half_axes": half, "exponent": 2.0}
            self.solids.add(name, "contact", part.body, place, "superquadric", **more)
        self._ball(name, part.point, part.radius)

    def _rolling(self, name: str, part: Rolling) -> None:
        up = part.normal or ((0.0, 1.0) if self.flat else (0.0, 0.0, 1.0))
        self._plane(name, None, part.position, up)
        radius = self.places.number(part.radius)
        axis = Z
        if part.axis is not None:
            axis = self.places.own(part.body, self.places.direction(part.axis))
        more: dict[str, Any] = {"radius": radius, "length": self.solids.thickness(0.1 * radius)}
        place, turn = self._place(part.body, None), turned_to(axis)
        self.solids.add(name, "contact", part.body, place, "cylinder", turn, **more)

    def _balls(self, name: str, part: SphereContact) -> None:
        for end, radius in zip(part.points, part.radii, strict=True):
            self._ball(name, end, radius)

    def _clearance(self, name: str, part: ClearanceContact) -> None:
        pin, hole = part.points
        play, radius = map(self.places.number, (part.radius, part.pin_radius))
        radius = radius or self._pin(play)
        self._ball(name, pin, radius)
        body = (hole.point or "").partition(".")[0] or None
        if not self.flat:
            self._ball(name, hole, (1.0 + WALL) * radius + play, CLEAR)
            return
        self._ring(name, body, self.places.of(hole), radius, play, self.solids.thickness(0.0), Z)

    def _pin(self, play: float) -> float:
        """Radius of a pin that has none: as large as its play, or small in a hole to see."""
        size = self.solids.size
        return max(play, 0.01 * size) if play < 0.05 * size else max(0.02 * size, 0.05 * play)

    def _ring(
        self, name: str, body: str | None, place: Place, pin: float, play: float, length: float,
        axis: Array,
    ) -> None:  # fmt: skip
        inner = pin + play
        more: dict[str, Any] = {
            "radius": inner + WALL * max(pin, 0.1 * inner), "inner_radius": inner,
            "length": length,
        }  # fmt: skip
        turn = turned_to(axis)
        self.solids.add(name, "contact", body, place, "cylinder", turn, CLEAR, **more)

    def _journal(self, name: str, part: JournalContact) -> None:
        bearing, journal = part.bodies
        play, radius, length = map(
            self.places.number, (part.radius, part.pin_radius, part.length)
        )  # fmt: skip
        radius, axis = radius or max(play, 0.1 * length), self.places.direction(part.axis)
        place, own = self._place(journal, part.position), self.places.own(journal, axis)
        more: dict[str, Any] = {"radius": radius, "length": 1.2 * length}
        self.solids.add(name, "contact", journal, place, "cylinder", turned_to(own), **more)
        place, own = self._place(bearing, part.position), self.places.own(bearing, axis)
        self._ring(name, bearing, place, radius, play, length, own)

    def _stop(self, name: str, part: Stop) -> None:
        """Add the way that a stop leaves a joint: an arc, or a line, of the first body."""
        joint = self.scene.joints.get(part.joint or "")
        if not isinstance(joint, BodyJoint) or joint.bodies is None or joint.position is None:
            return
        first, second = joint.bodies
        axis = Z if joint.axis is None else self.places.direction(joint.axis)
        position, size = self.places.vector(joint.position), 0.12 * self.solids.size
        low, high = (None if x is None else self.places.number(x) for x in (part.min, part.max))
        room = math.pi if part.turns else 2.0 * size
        low, high = (-room if low is None else low), (room if high is None else high)
        if part.turns:
            arm = self.places.at_start(self._centre(second)) - position
            arm = arm - (arm @ axis) * axis
            if np.linalg.norm(arm) < 1e-9 * self.solids.size:
                arm = turned_to(axis)[:, 0]
            u, ways = size * arm / np.linalg.norm(arm), np.linspace(low, high, 33)
            points = np.outer(np.cos(ways), u) + np.outer(np.sin(ways), np.cross(axis, u))
        else:
            points = np.outer((low, high), axis)
        rotation = self.places.poses[self.places.frame(first)][1]
        place = self.places.drawn(first, position)
        self._curve(name, first, place, points @ rotation, None)

    def _centre(self, body: str | None) -> Place:
        found: Any = self.scene.bodies.get(body or "")
        centre = getattr(found, "center_of_mass", (0.0,) * 3)
        return self.places.fixed_to(self.places.frame(body), self.places.vector(centre))

    def _profile(self, name: str, part: ProfileContact) -> None:
        up = self.places.direction(part.axis or (0.0, 1.0))
        axes = np.column_stack(((up[1], -up[0], 0.0), up, Z))
        place = self.places.drawn(part.body, self.places.vector(part.position or (0.0, 0.0)))
        turn = self.places.poses[place["frame"]][1].T @ axes
        at = self.places.at_start(self.places.of(part.point)) - self.places.at_start(place)
        points = contours.profile_curve(self.scene.profiles[part.profile], float(axes[:, 0] @ at))
        self._curve(name, part.body, place, points, turn)
        self._ball(name, part.point, part.radius)

    def _cam(self, name: str, part: CamContact) -> None:
        joint: Any = self.scene.joints[part.joint]
        place = self.places.drawn(joint.bodies[1], self.places.vector(joint.position))
        turn, thick = self.places.poses[place["frame"]][1].T, self.solids.thickness(0.0)
        corners = contours.cam_curve(self.scene.profiles[part.profile])
        more: dict[str, Any] = {"corners": rounded(corners), "thickness": thick}
        self.solids.add(name, "contact", joint.bodies[1], place, "prism", turn, **more)
        self._ball(name, part.follower, part.radius)
        if part.face is not None:
            body = (part.follower.point or "").partition(".")[0]
            x, y, _ = self.places.own(body, self.places.direction(part.face))
            half = 0.15 * self.solids.size * np.array((-y, x))
            points = np.array((-half, half))
            self._curve(name, body, self.places.of(part.follower), points, None)

    def _surface(self, name: str, part: SurfaceContact | PointOnSurface) -> None:
        self._ball(name, part.point, getattr(part, "ball_radius", 0.0))
        if (part.body, part.surface) in self._drawn:
            return
        self._drawn.add((part.body, part.surface))
        place, n = self._place(part.body, None), self.scene.dimension
        at = self.places.at_start(self.places.of(part.point)) - self.places.at_start(place)
        start = (self.places.poses[place["frame"]][1].T @ at)[:n]

        def value(x: Array) -> float:
            own = dict(zip("xyz", x.tolist(), strict=False))
            return float(evaluate(part.surface, {**self.places.values, **own}))

        try:
            radius, size = self.places.number(getattr(part, "ball_radius", 0.0)), self.solids.size
            if self.flat:
                points = contours.traced(value, start, size, radius)
                inside = points[:-1]
                if (
                    np.isfinite(points).all()
                    and contours.closes(points)
                    and value(inside.mean(axis=0)) < 0.0
                ):
                    more: dict[str, Any] = {"thickness": self.solids.thickness(0.0)}
                    self.solids.add(
                        name, "contact", part.body, place, "prism", corners=rounded(inside), **more
                    )  # fmt: skip
                elif np.isfinite(points).all():
                    self._curve(name, part.body, place, points, None)
            elif found := contours.heights_over(value, start, size, self._travel(part), radius):
                axes, grid = found
                self.solids.add(name, "surface", part.body, place, "heights", axes, FLOOR, **grid)
        except (ArithmeticError, ValueError):  # the formula has no value somewhere around
            return

    def _travel(self, part: SurfaceContact | PointOnSurface) -> Array:
        """How far a point comes in the experiment with the velocity that it begins with [m]."""
        owner = (part.point.point or "").partition(".")[0]
        moving: Any = self.scene.points.get(owner) or self.scene.bodies.get(owner)
        velocity = getattr(moving, "velocity", None)
        if part.body is not None or not velocity:
            return np.zeros(3)
        time = self.scene.experiment.stop_time - self.scene.experiment.start_time
        return time * self.places.vector(velocity)

    def _point_on_plane(self, name: str, part: PointOnPlane) -> None:
        at = part.position
        if at is None:
            at = tuple(self.places.at_start(self.places.of(part.point)).tolist())
        self._plane(name, part.body, at, part.axis)

    def _superquadric(self, name: str, part: SuperquadricContact) -> None:
        place, opacity = self._place(part.body, part.position), CLEAR
        half, power = self.places.vector(part.semi_axes), part.power
        radius = self.places.number(part.ball_radius)
        half = np.maximum(half + (radius if part.side == "inside" else -radius), 0.01 * half)
        if self.flat:
            turns = np.linspace(0.0, 2.0 * math.pi, 97)
            both = np.column_stack((np.cos(turns), np.sin(turns)))
            points = half[:2] * np.sign(both) * np.abs(both) ** (2.0 / power)
            self._curve(name, part.body, place, points, None)
        else:
            opacity = opacity if part.side == "inside" else 1.0
            more: dict[str, Any] = {"half_axes": half, "exponent": power}
            kind = "surface" if part.side == "inside" else "contact"
            self.solids.add(
                name, kind, part.body, place, "superquadric", opacity=opacity, **more
            )  # fmt: skip
        self._ball(name, part.point, part.ball_radius)

    def _height_field(self, name: str, part: HeightFieldContact) -> None:
        place, grid = (
            self._place(part.body, part.position),
            contours.heights_of(part, self.places.number(part.ball_radius)),
        )
        self.solids.add(name, "surface", part.body, place, "heights", opacity=FLOOR, **grid)
        self._ball(name, part.point, part.ball_radius)

    def _of_mesh(self, name: str, part: MeshContact) -> None:
        place, opacity = self._place(part.body, part.position), 1.0
        if part.side == "inside":
            opacity = CLEAR
        of_file = self._file(part.file, part.scale)
        self._mesh(name, part.body, place, *of_file, kind="surface", opacity=opacity)
        for end in (part.point, *part.points):
            self._ball(name, end, part.ball_radius)
        if part.corner_file is not None:
            origin = self._place(part.part, None)
            self._mesh(name, part.part, origin, *self._file(part.corner_file, part.scale))
        elif part.part:
            self._corners(name, part.part, part.corners, part.ball_radius)

    def _of_pieces(self, name: str, part: ConvexContact) -> None:
        """Add the mesh of each body, or the box of the second one."""
        for body, mesh in zip(part.bodies, (part.file, part.other_file), strict=True):
            if mesh is not None:
                self._mesh(name, body, self._place(body, None), *self._file(mesh, part.scale))
            elif part.size is not None:
                self._box(name, body, part.size)

    def _of_both(self, name: str, part: CapsuleContact | PolygonContact | BoxContact) -> None:
        """Add the shapes of two bodies."""
        for k, body in enumerate(part.bodies):
            if isinstance(part, BoxContact) and k < len(part.sizes):
                self._box(name, body, part.sizes[k])
            elif isinstance(part, BoxContact):
                self._corners(name, body, part.segment, part.radii[k])
            else:
                places = part.segments if isinstance(part, CapsuleContact) else part.corners
                self._corners(name, body, places[k], part.radii[k])


SOLIDS: dict[type, Callable[[Touching, str, Any], None]] = {
    PlaneContact: Touching._on_plane, CornersContact: Touching._corners_on_plane,
    CylinderContact: Touching._cylinder, EllipsoidContact: Touching._ellipsoid,
    Rolling: Touching._rolling,
    SphereContact: Touching._balls, ClearanceContact: Touching._clearance,
    JournalContact: Touching._journal, Stop: Touching._stop, ProfileContact: Touching._profile,
    CamContact: Touching._cam, SurfaceContact: Touching._surface,
    PointOnSurface: Touching._surface, PointOnPlane: Touching._point_on_plane,
    SuperquadricContact: Touching._superquadric, HeightFieldContact: Touching._height_field,
    MeshContact: Touching._of_mesh, ConvexContact: Touching._of_pieces,
    CapsuleContact: Touching._of_both, PolygonContact: Touching._of_both,
    BoxContact: Touching._of_both,
}  # fmt: skip
"""What is seen of a contact, or of a joint with a surface."""
