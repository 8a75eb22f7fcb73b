"""Where a point or body lies in the closed pose, and what is fixed to it."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from solver.mechanics.vectors import Matrix, columns, identity, times
from solver.scene import Point, Rigid, Scene, evaluate
from solver.scene.orientation import rotation_of


@dataclass(frozen=True, slots=True)
class Pose:
    """Place of a point or body as drawn and closed [m], and its axes."""

    drawn: Sequence[float]
    place: Sequence[float]
    drawn_turn: Matrix
    turn: Matrix
    angle: float
    """By which it turned [rad]."""
    orientation: Sequence[float]
    """Closed, as a scene has it: an angle in the plane, a quaternion in space, none of a point."""

    @classmethod
    def of(cls, scene: Scene, name: str, closed: Mapping[str, float]) -> Pose:
        """Pose of a part of the scene with these values."""
        values = scene.values()
        part: Point | Rigid = (scene.points | scene.bodies)[name]  # type: ignore[assignment]
        drawn = [number(x, values) for x in part.position]
        place = [closed[f"{name}.{axis}"] for axis in axes_of(scene)]
        unit = identity(scene.dimension)
        if isinstance(part, Point):
            return cls(drawn, place, unit, unit, 0.0, ())
        before = tuple(tuple(number(x, values) for x in row) for row in part.rotation)
        if scene.dimension == 2:
            angle = closed[f"{name}.angle"]
            c, s = math.cos(angle), math.sin(angle)
            whole = angle - math.atan2(before[1][0], before[0][0])
            by = math.remainder(whole, 2.0 * math.pi)
            # Without turns that a driver asks for: the closed scene counts from its own drawing.
            turns = round((whole - by) / (2.0 * math.pi))
            turn, written = ((c, -s), (s, c)), [angle - 2.0 * math.pi * turns]
        else:
            q = [closed[f"{name}.q{x}"] for x in "wxyz"]
            turn, written = rotation_of(*q), q
            by = _angle(columns(tuple(times(turn, axis) for axis in before)))  # of turn before'
        return cls(drawn, place, before, turn, by, written)

    @property
    def moved(self) -> tuple[float, float]:
        """Way [m] and angle [rad]."""
        return math.dist(self.drawn, self.place), self.angle

    def carried(self, place: Sequence[float]) -> list[float]:
        """Where a place of the drawing that is fixed to the body lies in the closed pose."""
        arm = [x - y for x, y in zip(place, self.drawn, strict=True)]
        return [x + y for x, y in zip(self.place, self.turned(arm), strict=True)]

    def turned(self, direction: Sequence[float]) -> list[float]:
        """Direction of the closed pose that was drawn so."""
        turned = times(self.turn, times(columns(self.drawn_turn), direction))
        return [number(x, {}) for x in turned]


def moving(scene: Scene) -> Iterator[str]:
    """Names of the points and rigid bodies that can move."""
    yield from (name for name, point in scene.points.items() if not point.fixed)
    yield from (name for name, body in scene.bodies.items() if isinstance(body, Rigid))


def axes_of(scene: Scene) -> str:
    """Names of the global axes."""
    return "xyz"[: scene.dimension]


def number(x: Any, values: Mapping[str, float]) -> float:
    """Value of a number of a scene, from those of its parameters and inputs."""
    return float(evaluate(x, values))


def _angle(turn: Any) -> float:
    across = (turn[2][1] - turn[1][2], turn[0][2] - turn[2][0], turn[1][0] - turn[0][1])
    return math.atan2(math.hypot(*across), sum(turn[i][i] for i in range(3)) - 1.0)
