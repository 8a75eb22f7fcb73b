"""A picture of a scene as drawn: points, bars, bodies, rods, springs, dampers, joints, ground.

    z or the direction against gravity points up; a mechanism in space is seen from the side and a
    little from above, in parallel projection.

A body is drawn by the places where something holds on to it, joined to its centre, and by the
corners and balls that touch something: a scene keeps what its shape weighs, not the shape.
"""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Callable, Iterable, Sequence
from itertools import product
from typing import TYPE_CHECKING, Any

import numpy as np

from build_fmu.canvas import DARK, Array, Canvas, Colour, Pixel
from solver.mechanics.frames import RigidFrame
from solver.scene import (
    Bar,
    BodyJoint,
    BoxContact,
    CapsuleContact,
    CornersContact,
    Damper,
    Distance,
    DistanceDriver,
    Number,
    PlaneContact,
    PointOn,
    PointOnLine,
    PointReference,
    PolygonContact,
    PositionDriver,
    Rigid,
    Rolling,
    SphereContact,
    Spring,
)

if TYPE_CHECKING:
    from solver.mechanics.combination import Combination
    from solver.mechanics.parts import Parts

WIDTH, HEIGHT, MARGIN = 480, 360, 40
MOST = 2000
"""Parts of a kind that are drawn; of more, each second, third, ..."""
AZIMUTH, ELEVATION = math.radians(-55.0), math.radians(22.0)
STEEL: Colour = (0.35, 0.40, 0.47)
SPRING, DAMPER, DRIVER = (0.10, 0.50, 0.35), (0.62, 0.42, 0.10), (0.80, 0.16, 0.16)
BODIES: tuple[Colour, ...] = (
    (0.16, 0.42, 0.70), (0.85, 0.45, 0.12), (0.35, 0.58, 0.24), (0.58, 0.33, 0.62),
    (0.20, 0.60, 0.63), (0.75, 0.30, 0.36),
)  # fmt: skip


def picture(parts: Parts) -> bytes:
    """PNG file of the parts of a scene, with its numbers as the file gives them."""
    return _Drawing(parts).png()


class _Drawing:
    """Places of the parts of a scene, then strokes on a canvas."""

    def __init__(self, parts: Parts) -> None:
        self.scene, self.parts = parts.scene, parts
        self._default = self.parts.mechanism.default
        self._seen: list[Array] = []
        """Places that the picture must hold."""
        self._strokes: list[tuple[int, float, Callable[[Canvas], None]]] = []
        """Layer, distance towards the eye, and what draws it."""
        self._towards, *view = _view(parts)
        self._view = np.array(view)
        """Directions to the right and up."""
        self._held: dict[str, list[Array]] = defaultdict(list)
        """Places that hold a body."""
        self._shown: set[str] = set()
        """Bodies of which an outline is drawn."""

    # ----------------------------------------------------------------------------- places

    def _drawn(self, numbers: Sequence) -> Array:
        """Three coordinates of a vector of the scene."""
        return np.array([*map(self._default, numbers), 0.0][:3])

    def _at(self, place: Combination) -> Array:
        return self._drawn(self.parts.mechanism.drawn(place))

    def _ends(self, ends: Iterable[PointReference]) -> list[Array]:
        places = []
        for end in ends:
            places.append(self._at(self.parts.place(end)))
            body = (end.point or "").partition(".")[0]
            if body in self.scene.bodies:
                self._held[body].append(places[-1])
            if end.point is None:
                self._pin(places[-1], ground=True)
        return places

    # ----------------------------------------------------------------------------- strokes

    def _stroke(
        self, layer: int, places: Sequence[Array], shape: Callable[..., None], **style: Any
    ) -> None:
        """Draw a shape of the canvas later: layer by layer, what is far away first."""
        self._seen.extend(places)
        depth = float(np.mean([place @ self._towards for place in places]))

        def draw(canvas: Canvas) -> None:
            shape(canvas, *map(self._pixel, places), **style)

        self._strokes.append((layer, depth, draw))

    def _line(self, layer: int, *places: Array, width: float, colour: Colour) -> None:
        self._stroke(layer, places, Canvas.path, width=width, colour=colour)

    def _pixel(self, place: Array) -> Pixel:
        x, y = (self._scale * (self._view @ place - self._middle)).tolist()
        return 0.5 * WIDTH + x, 0.5 * HEIGHT - y

    def png(self) -> bytes:
        """Collect all strokes, choose the scale by which they are seen, and draw them."""
        for part in (
            self._joints,
            self._forces,
            self._drivers,
            self._points,
            self._contacts,
            self._bodies,
        ):
            part()
        seen = np.array(self._seen or [np.zeros(3)]) @ self._view.T
        least, most = seen.min(axis=0), seen.max(axis=0)
        self._middle = 0.5 * (least + most)
        rooms = zip((WIDTH - 2 * MARGIN, HEIGHT - 2 * MARGIN), most - least, strict=True)
        self._scale = min((room / span for room, span in rooms if span > 0.0), default=1.0)
        canvas = Canvas(WIDTH, HEIGHT)
        for _, _, draw in sorted(self._strokes, key=lambda stroke: stroke[:2]):
            draw(canvas)
        return canvas.png()

    def _joints(self) -> None:
        for joint in _some(self.scene.joints.values()):
            if isinstance(joint, Distance):
                self._line(2, *self._ends(joint.points), width=2.5, colour=STEEL)
            elif isinstance(joint, BodyJoint):
                self._joint(joint)
            elif isinstance(joint, PointOn):
                (place,) = self._ends((joint.point,))
                axis = joint.axis if isinstance(joint, PointOnLine) else None
                self._pin(place, ground=joint.body is None, axis=axis)
            elif isinstance(joint, Rolling):
                axis = np.array([0.0, 0.0, 1.0]) if joint.axis is None else self._drawn(joint.axis)
                first = np.cross(axis, np.eye(3)[int(np.argmin(np.abs(axis)))])
                directions = np.array([first, np.cross(axis, first) / np.linalg.norm(axis)], float)
                centre = self._at(self.parts.named(joint.body))
                rim = self._rim(centre, self._default(joint.radius), directions, STEEL, 2)
                self._held[joint.body] += [rim[0], rim[12], rim[24], rim[36]]

    def _joint(self, joint: BodyJoint) -> None:
        if joint.points is not None:
            place, _ = self._ends(joint.points)
            ground = any(end.point is None for end in joint.points)
        elif joint.position is not None and joint.bodies is not None:
            place = self._drawn(joint.position)
            ground = None in joint.bodies
            for body in filter(None, joint.bodies):
                self._held[body].append(place)
        else:
            return
        axis = joint.axis if joint.has("displacement") else None
        self._pin(place, ground=ground, axis=axis, turns=joint.type != "prismatic")

    def _pin(
        self, place: Array, *, ground: bool, axis: Sequence | None = None, turns: bool = True
    ) -> None:
        """Draw a joint, with the direction in the picture of an axis that does not point at it."""
        direction = None
        if axis is not None:
            along = self._drawn(axis)
            x, y = (self._view @ along).tolist()
            length = math.hypot(x, y)
            if length > 1e-6 * np.linalg.norm(along):
                direction = (x / length, -y / length)
        style = {"ground": ground, "direction": direction, "turns": turns}
        self._stroke(4, (place,), Canvas.joint, **style)

    def _rim(
        self, centre: Array, radius: float, directions: Array, colour: Colour, layer: int
    ) -> list[Array]:
        """Draw a circle around a place, in the plane of two directions."""
        first, second = (radius * x / np.linalg.norm(directions[0]) for x in directions)
        turns = np.linspace(0.0, 2.0 * math.pi, 49)
        rim = [centre + math.cos(x) * first + math.sin(x) * second for x in turns]
        self._line(layer, *rim, width=2.5, colour=colour)
        return rim

    def _forces(self) -> None:
        for force in _some(self.scene.forces.values()):
            if isinstance(force, Spring):
                self._stroke(3, self._ends(force.points), Canvas.coil, width=1.6, colour=SPRING)
            elif isinstance(force, Damper):
                a, b = self._ends(force.points)
                self._line(3, a, b, width=1.4, colour=DAMPER)
                cylinder = a + 0.38 * (b - a), a + 0.62 * (b - a)
                self._line(3, *cylinder, width=6.0, colour=DAMPER)

    def _drivers(self) -> None:
        for driver in _some(self.scene.drivers.values()):
            if isinstance(driver, PositionDriver):
                style = {"radius": 7.5, "width": 1.8, "colour": DRIVER}
                self._stroke(5, self._ends((driver.point,)), Canvas.ring, **style)
            elif isinstance(driver, DistanceDriver):
                self._line(3, *self._ends(driver.points), width=2.5, colour=DRIVER)

    def _points(self) -> None:
        points = self.scene.points
        heaviest = max((self._default(p.mass) for p in points.values()), default=0.0)
        for name, point in _some(points.items()):
            place = self._at(self.parts.named(name))
            if point.fixed:
                self._pin(place, ground=True)
                continue
            share = self._default(point.mass) / heaviest if heaviest > 0.0 else 0.0
            radius = 3.0 + 4.0 * max(0.0, share) ** (1.0 / 3.0)
            self._stroke(4, (place,), Canvas.disc, radius=radius, colour=DARK)

    def _contacts(self) -> None:
        for contact in _some(self.scene.contacts.values()):
            if isinstance(contact, CornersContact):
                self._outline(contact.body, contact.size, contact.corners)
            elif isinstance(contact, BoxContact):
                for body, size in zip(contact.bodies, contact.sizes, strict=True):
                    self._outline(body, size)
            elif isinstance(contact, PolygonContact | CapsuleContact):
                polygons = isinstance(contact, PolygonContact)
                of_both = contact.corners if polygons else contact.segments
                for body, corners in zip(contact.bodies, of_both, strict=True):
                    self._outline(body, None, corners)
            elif isinstance(contact, PlaneContact):
                self._ball(contact.point, contact.radius)
            elif isinstance(contact, SphereContact):
                for point, radius in zip(contact.points, contact.radii, strict=True):
                    self._ball(point, radius)

    def _outline(self, body: str | None, size: Sequence | None, corners: Sequence = ()) -> None:
        """Draw a box about the origin of a body, or a closed line through places in its axes."""
        edges = [(k - 1, k) for k in range(len(corners))]
        if size is not None:
            half = [0.5 * x for x in size]
            corners = list(product(*((-1.0 * x, x) for x in half)))
            bits = [1 << k for k in range(len(half))]
            edges = [(k, k | bit) for k in range(len(corners)) for bit in bits if not k & bit]
        frame = self.parts.frame(body)
        at = frame.at if isinstance(frame, RigidFrame) else frame.place
        places = [self._at(at(corner)) for corner in corners]
        for i, j in edges:
            self._line(1, places[i], places[j], width=2.0, colour=self._colour(body))
        self._shown.add(body or "")

    def _ball(self, point: PointReference, radius: Number) -> None:
        """Draw the outline of a ball about a point."""
        if (size := self._default(radius)) > 0.0:
            name = (point.point or "").partition(".")[0]
            self._rim(self._at(self.parts.place(point)), size, self._view, self._colour(name), 1)
            self._shown.add(name)

    def _colour(self, body: str | None) -> Colour:
        names = list(self.scene.bodies)
        return BODIES[names.index(body) % len(BODIES)] if body in names else STEEL

    def _bodies(self) -> None:
        for name, body in _some(self.scene.bodies.items()):
            colour = self._colour(name)
            if isinstance(body, Bar):
                ends = (self._at(self.parts.named(end)) for end in body.points)
                self._line(1, *ends, width=6.0, colour=colour)
            elif isinstance(body, Rigid):
                self._rigid(name, body, colour)

    def _rigid(self, name: str, body: Rigid, colour: Colour) -> None:
        """Draw the places that hold a body, joined to its origin, which it is drawn around."""
        origin = self._at(self.parts.named(name))
        places = [*self._held[name]]
        places += [self._at(self.parts.named(f"{name}.{point}")) for point in body.points]
        for place in places:
            self._line(1, origin, place, width=6.0, colour=colour)
        self._stroke(1, (origin,), Canvas.disc, radius=6.0, colour=colour)
        if not places and name not in self._shown:
            self._rim(origin, self._gyration(body), self._view, colour, 1)

    def _gyration(self, body: Rigid) -> float:
        """Radius of gyration [m]: the size of a body that nothing holds."""
        inertia, mass = body.inertia, self._default(body.mass)
        if isinstance(inertia, tuple):
            moment = 0.5 * sum(self._default(inertia[k][k]) for k in range(3))
        else:
            moment = self._default(inertia)
        return math.sqrt(max(0.0, moment / mass)) if mass > 0.0 else 0.0


def _some(parts: Iterable) -> list:
    """All parts, or so many of them, evenly chosen, that the picture is quickly drawn."""
    listed = list(parts)
    return listed[:: 1 + len(listed) // MOST]


def _view(parts: Parts) -> tuple[Array, Array, Array]:
    """Directions towards the eye, to the right and up."""
    if parts.scene.dimension == 2:
        return np.eye(3)[2], np.eye(3)[0], np.eye(3)[1]
    gravity = np.array([parts.mechanism.default(x) for x in parts.scene.gravity])
    axis = int(np.argmax(np.abs(gravity))) if gravity.any() else 2
    up = np.eye(3)[axis] * (-1.0 if gravity[axis] > 0.0 else 1.0)
    first = np.eye(3)[(axis + 1) % 3]
    second = np.cross(up, first)
    level = math.cos(AZIMUTH) * first + math.sin(AZIMUTH) * second
    towards = math.cos(ELEVATION) * level + math.sin(ELEVATION) * up
    right = np.cross(up, level)
    return towards, right, np.cross(towards, right)
