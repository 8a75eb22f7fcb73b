"""A picture of a scene as drawn: points, bars, bodies, rods, springs, dampers, joints, ground.

    z or the direction against gravity points up; a mechanism in space is seen from the side and a
    little from above, in parallel projection.

A body is drawn by the places where something holds on to it, joined to its centre: a scene keeps
what its shape weighs, not the shape.
"""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Callable, Iterable, Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from build_fmu import symbols
from build_fmu.canvas import Canvas, Colour, Pixel
from build_fmu.symbols import DARK
from solver.mechanics.build_mechanism import collect
from solver.scene import (
    Bar,
    BodyJoint,
    Damper,
    Distance,
    DistanceDriver,
    PointOn,
    PointOnLine,
    PointReference,
    PositionDriver,
    Rigid,
    Rolling,
    Spring,
)

if TYPE_CHECKING:
    from solver.mechanics.combination import Combination
    from solver.mechanics.parts import Parts
    from solver.scene import Scene

Array = NDArray[np.float64]

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


def picture(scene: Scene) -> bytes:
    """PNG file of a scene, with its numbers as the file gives them."""
    return _Drawing(scene).png()


class _Drawing:
    """Places of the parts of a scene, then strokes on a canvas."""

    def __init__(self, scene: Scene) -> None:
        self.scene, self.parts = scene, collect(scene)
        self.canvas = Canvas(WIDTH, HEIGHT)
        self._seen: list[Array] = []
        """Places that the picture must hold."""
        self._strokes: list[tuple[int, float, Callable[[], None]]] = []
        self._towards, self._right, self._up = _view(scene, self.parts)
        self._held: dict[str, list[Array]] = defaultdict(list)

    # ----------------------------------------------------------------------------- places

    def _drawn(self, numbers: Sequence) -> Array:
        """Three coordinates of a vector of the scene."""
        values = [self.parts.mechanism.default(x) for x in numbers]
        return np.array([*values, 0.0][:3])

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

    def _two(self, ends: Iterable[PointReference]) -> tuple[Array, Array]:
        first, second = self._ends(ends)
        return first, second

    def _pixel(self, place: Array) -> Pixel:
        x, y = float(place @ self._right), float(place @ self._up)
        return (
            0.5 * WIDTH + (x - self._middle[0]) * self._scale,
            0.5 * HEIGHT - (y - self._middle[1]) * self._scale,
        )

    def _fit(self) -> None:
        """Choose scale and middle so that all places are seen."""
        x = [float(place @ self._right) for place in self._seen] or [0.0]
        y = [float(place @ self._up) for place in self._seen] or [0.0]
        wide, high = max(x) - min(x), max(y) - min(y)
        self._middle = 0.5 * (max(x) + min(x)), 0.5 * (max(y) + min(y))
        scales = [(WIDTH - 2 * MARGIN) / wide] if wide > 0.0 else []
        scales += [(HEIGHT - 2 * MARGIN) / high] if high > 0.0 else []
        self._scale = min(scales, default=1.0)

    # ----------------------------------------------------------------------------- strokes

    def _stroke(self, layer: int, places: Sequence[Array], draw: Callable[..., None]) -> None:
        """Draw later: layer by layer, what is far away first."""
        self._seen.extend(places)
        depth = float(np.mean([place @ self._towards for place in places]))
        self._strokes.append((layer, depth, lambda: draw(*map(self._pixel, places))))

    def _line(self, layer: int, a: Array, b: Array, width: float, colour: Colour) -> None:
        canvas = self.canvas
        self._stroke(layer, (a, b), lambda p, q: canvas.line(p, q, width, colour))

    def png(self) -> bytes:
        """Collect all strokes, and draw them."""
        for part in (self._joints, self._forces, self._drivers, self._points, self._bodies):
            part()
        self._fit()
        for _, _, draw in sorted(self._strokes, key=lambda stroke: stroke[:2]):
            draw()
        return self.canvas.png()

    def _joints(self) -> None:
        for joint in _some(self.scene.joints.values()):
            if isinstance(joint, Distance):
                self._line(2, *self._two(joint.points), 2.5, STEEL)
            elif isinstance(joint, BodyJoint):
                self._joint(joint)
            elif isinstance(joint, PointOn):
                (place,) = self._ends((joint.point,))
                axis = joint.axis if isinstance(joint, PointOnLine) else None
                self._pin(place, ground=joint.body is None, axis=axis)
            elif isinstance(joint, Rolling):
                self._disc(joint)

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
        """Draw a joint: on the ground with hatching below it, and on a rail if it has an axis."""
        canvas, direction = self.canvas, None if axis is None else self._direction(axis)

        def draw(p: Pixel) -> None:
            if ground:
                symbols.hatch(canvas, p)
            if direction is not None:
                symbols.rail(canvas, p, direction)
            if turns or direction is None:
                symbols.pin(canvas, p)
            else:
                symbols.block(canvas, p, direction)

        self._stroke(4, (place,), draw)

    def _direction(self, axis: Sequence) -> Pixel | None:
        """Direction of an axis in the picture, of length 1; None if it points at the eye."""
        along = self._drawn(axis)
        x, y = float(along @ self._right), -float(along @ self._up)
        length = math.hypot(x, y)
        return (x / length, y / length) if length > 1e-6 * np.linalg.norm(along) else None

    def _disc(self, joint: Rolling) -> None:
        """Draw the rim of a rolling disc."""
        centre = self._at(self.parts.named(joint.body))
        radius = self.parts.mechanism.default(joint.radius)
        axis = np.array([0.0, 0.0, 1.0]) if joint.axis is None else self._drawn(joint.axis)
        first = np.cross(axis, np.eye(3)[int(np.argmin(np.abs(axis)))])
        first = np.array(first * radius / np.linalg.norm(first), dtype=float)
        second = np.array(np.cross(axis, first) / np.linalg.norm(axis), dtype=float)
        turns = np.linspace(0.0, 2.0 * math.pi, 49)
        rim = [centre + math.cos(x) * first + math.sin(x) * second for x in turns]
        self._held[joint.body] += [rim[0], rim[12], rim[24], rim[36]]
        canvas = self.canvas
        self._stroke(2, rim, lambda *pixels: canvas.path(pixels, 2.5, STEEL))

    def _forces(self) -> None:
        canvas = self.canvas
        for force in _some(self.scene.forces.values()):
            if isinstance(force, Spring):
                ends = self._ends(force.points)
                self._stroke(3, ends, lambda p, q: canvas.path(symbols.coil(p, q), 1.6, SPRING))
            elif isinstance(force, Damper):
                a, b = self._two(force.points)
                self._line(3, a, b, 1.4, DAMPER)
                self._line(3, a + 0.38 * (b - a), a + 0.62 * (b - a), 6.0, DAMPER)

    def _drivers(self) -> None:
        canvas = self.canvas
        for driver in _some(self.scene.drivers.values()):
            if isinstance(driver, PositionDriver):
                places = self._ends((driver.point,))
                self._stroke(5, places, lambda p: canvas.ring(p, 7.5, 1.8, DRIVER))
            elif isinstance(driver, DistanceDriver):
                self._line(3, *self._two(driver.points), 2.5, DRIVER)

    def _points(self) -> None:
        canvas, default = self.canvas, self.parts.mechanism.default
        heaviest = max((default(p.mass) for p in self.scene.points.values()), default=0.0)
        for name, point in _some(self.scene.points.items()):
            place = self._at(self.parts.named(name))
            if point.fixed:
                self._pin(place, ground=True)
                continue
            share = default(point.mass) / heaviest if heaviest > 0.0 else 0.0
            radius = 3.0 + 4.0 * max(0.0, share) ** (1.0 / 3.0)
            self._stroke(4, (place,), lambda p, r=radius: canvas.disc(p, r, DARK))

    def _bodies(self) -> None:
        for k, (name, body) in enumerate(_some(self.scene.bodies.items())):
            colour = BODIES[k % len(BODIES)]
            if isinstance(body, Bar):
                a, b = (self._at(self.parts.named(end)) for end in body.points)
                self._line(1, a, b, 6.0, colour)
            elif isinstance(body, Rigid):
                self._rigid(name, body, colour)

    def _rigid(self, name: str, body: Rigid, colour: Colour) -> None:
        """Draw the places that hold a body, joined to its origin, which it is drawn around."""
        origin = self._at(self.parts.named(name))
        places = [*self._held[name]]
        places += [self._at(self.parts.named(f"{name}.{point}")) for point in body.points]
        for place in places:
            self._line(1, origin, place, 6.0, colour)
        canvas = self.canvas
        self._stroke(1, (origin,), lambda p: canvas.disc(p, 6.0, colour))
        if not places:
            reach = self._gyration(body)
            sides = [origin, origin - reach * self._right, origin + reach * self._right]
            self._stroke(
                1, sides, lambda p, q, r: canvas.ring(p, 0.5 * math.dist(q, r), 2.5, colour)
            )

    def _gyration(self, body: Rigid) -> float:
        """Radius of gyration [m]: the size of a body that nothing holds."""
        default = self.parts.mechanism.default
        inertia, mass = body.inertia, default(body.mass)
        if isinstance(inertia, tuple):
            moment = 0.5 * sum(default(inertia[k][k]) for k in range(3))
        else:
            moment = default(inertia)
        return math.sqrt(max(0.0, moment / mass)) if mass > 0.0 else 0.0


def _some(parts: Iterable) -> list:
    """All parts, or so many of them, evenly chosen, that the picture is quickly drawn."""
    listed = list(parts)
    return listed[:: 1 + len(listed) // MOST]


def _view(scene: Scene, parts: Parts) -> tuple[Array, Array, Array]:
    """Directions towards the eye, to the right and up."""
    if scene.dimension == 2:
        return np.eye(3)[2], np.eye(3)[0], np.eye(3)[1]
    gravity = np.array([parts.mechanism.default(x) for x in scene.gravity])
    axis = int(np.argmax(np.abs(gravity))) if gravity.any() else 2
    up = np.eye(3)[axis] * (-1.0 if gravity[axis] > 0.0 else 1.0)
    first = np.eye(3)[(axis + 1) % 3]
    second = np.cross(up, first)
    level = math.cos(AZIMUTH) * first + math.sin(AZIMUTH) * second
    towards = math.cos(ELEVATION) * level + math.sin(ELEVATION) * up
    right = np.cross(up, level)
    return towards, right, np.cross(towards, right)
