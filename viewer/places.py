"""Where the parts of a scene are at the start: frames that move, and places fixed to them.

A frame is the ground, a point, a rigid body or, in the plane, a bar; each but the ground has
variables of the model that say where it is. A place has a frame and coordinates in its axes.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, TypeAlias, TypeVar

import numpy as np
from numpy.typing import NDArray

from solver.scene import Bar, Number, PointReference, PositionDriver, Rigid, Scene, evaluate

Array: TypeAlias = NDArray[np.float64]
Place: TypeAlias = dict[str, Any]
T = TypeVar("T")
DIGITS = 14
"""Of numbers of a drawing, so that those with few digits are short."""
MOST = 2000
"""Parts of a kind that are drawn; of more, each second, third, ..."""
SEEN = 4
"""Of numbers of a curve or surface."""


def some(parts: Iterable[T], most: int = MOST) -> list[T]:
    """All parts, or `most` of them, evenly chosen, so that they are quickly drawn."""
    listed = list(parts)
    return listed[:: 1 + len(listed) // (most + 1)]


def rounded(numbers: Any) -> Any:
    """Return numbers of a curve or surface with as many digits as one can see."""
    if not isinstance(numbers, np.ndarray) or not numbers.any():
        return numbers
    return np.round(numbers, max(0, SEEN - math.ceil(math.log10(np.abs(numbers).max()))))


def tidy(numbers: Any) -> Any:
    """Return numbers as JSON has them: whole ones without a point, others with few digits.

    In a vector what is small against the others is round-off.
    """
    if numbers is None:
        return None
    if isinstance(numbers, list) and any(x is None or isinstance(x, list) for x in numbers):
        return [tidy(x) for x in numbers]  # rows, in which some numbers may be missing
    array = np.asarray(numbers, None if isinstance(numbers, np.ndarray) else float)
    if array.ndim == 0:
        return _tidy_number(float(array))
    if array.ndim > 1:
        return [tidy(x) for x in array]
    listed = array.tolist()
    least = 1e-15 * max(map(abs, listed), default=0.0)
    return [_tidy_number(float(x)) if not abs(x) < least else 0 for x in listed]


def _tidy_number(number: float) -> float:
    if number.is_integer() and abs(number) < 10.0**DIGITS:
        return int(number)
    value = float(f"{number:.{DIGITS}g}")
    return int(value) if value.is_integer() and abs(value) < 1e15 else value


def quaternion(rotation: Array) -> Array:
    """Return [w, x, y, z] of a rotation matrix, w >= 0 (Bar-Itzhack: the largest eigenvector)."""
    R = rotation
    K = np.zeros((4, 4))
    K[0, 0] = np.trace(R)
    K[1:, 1:] = R + R.T - np.trace(R) * np.eye(3)
    K[0, 1:] = K[1:, 0] = R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]
    largest = np.linalg.eigh(K)[1][:, -1]
    return largest if largest[0] >= 0.0 else -largest


def turned_to(axis: Array) -> Array:
    """Return the rotation that turns z to a direction, by the shortest way."""
    z = axis / np.linalg.norm(axis)
    x = np.cross((0.0, 1.0, 0.0), z)
    if np.linalg.norm(x) < 1e-6:
        x = np.array((1.0, 0.0, 0.0))
    x = x / np.linalg.norm(x)
    return np.column_stack((x, np.cross(z, x), z))


class Places:
    """Numbers, frames and places of a scene with these values of its parameters."""

    def __init__(self, scene: Scene, values: Mapping[str, float]) -> None:
        self.scene, self.values = scene, scene.values(values)
        self.frames: list[dict[str, Any]] = []
        self.poses: list[tuple[Array, Array]] = []
        """Origin and rotation of each frame at the start."""
        self._index: dict[str | None, int] = {}
        self._paths = {
            driver.point.point: driver.value
            for driver in scene.drivers.values()
            if isinstance(driver, PositionDriver) and driver.point.at is None
        }
        self._add(None, "ground", np.zeros(3), np.eye(3), [], [])

    # --------------------------------------------------------------------------- numbers

    def number(self, number: Number) -> float:
        """Return the value of a number of the scene."""
        return float(number) if isinstance(number, float) else float(evaluate(number, self.values))

    def vector(self, numbers: Sequence[Number]) -> Array:
        """Return three coordinates of a vector of the scene."""
        return np.array([*map(self.number, numbers), 0.0][:3])

    def direction(self, numbers: Sequence[Number]) -> Array:
        """Return the unit vector along a vector of the scene."""
        vector = self.vector(numbers)
        return vector / (np.linalg.norm(vector) or 1.0)

    # --------------------------------------------------------------------------- frames

    def frame(self, name: str | None) -> int:
        """Return the index of the frame of a part; that of a fixed point is the ground."""
        if name not in self._index:
            part = self.scene.points.get(name or "") or self.scene.bodies[name or ""]
            if isinstance(part, Rigid):
                self._add_rigid(name or "", part)
            elif isinstance(part, Bar):
                self._add_bar(name or "", part)
            elif part.fixed:
                return 0
            else:
                words = "xyz"[: self.scene.dimension]
                at = self.vector(self._paths.get(name, part.position))
                start = at[: self.scene.dimension]
                self._add(name, "point", at, np.eye(3), [f"{name}.{x}" for x in words], start)
        return self._index[name]

    def _add(
        self, name: str | None, kind: str, origin: Array, rotation: Array, variables: list[str],
        start: Sequence[float] | Array,
    ) -> None:  # fmt: skip
        self._index[name] = len(self.frames)
        self.poses.append((origin, rotation))
        known = {"name": name or "ground", "kind": kind, "variables": variables}
        self.frames.append({**known, "start": tidy(start)})

    def _add_rigid(self, name: str, body: Rigid) -> None:
        origin = self.vector(body.position)
        rotation = np.eye(3)
        rows = body.rotation
        rotation[: len(rows), : len(rows)] = [[self.number(x) for x in row] for row in rows]
        words, turn = ("x", "y", "angle"), [0.0]
        if self.scene.dimension == 3:
            words, turn = ("x", "y", "z", "qw", "qx", "qy", "qz"), quaternion(rotation)
        elif not isinstance(body.orientation, tuple):
            turn = [self.number(body.orientation)]
        start = [*origin[: self.scene.dimension], *turn]
        self._add(name, "body", origin, rotation, [f"{name}.{word}" for word in words], start)

    def _add_bar(self, name: str, bar: Bar) -> None:
        """Add the frame of a bar in the plane, about an end that moves."""
        first, second = (self.at_start(self.named(end)) for end in bar.points)
        end = bar.points[1] if self.frame(bar.points[0]) == 0 else bar.points[0]
        along = second - first
        angle = math.atan2(along[1], along[0])
        c, s = math.cos(angle), math.sin(angle)
        rotation = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
        origin = self.at_start(self.named(end))
        variables = [f"{end}.x", f"{end}.y", f"{name}.angle"]
        self._add(name, "body", origin, rotation, variables, [*origin[:2], angle])

    # --------------------------------------------------------------------------- places

    def fixed_to(self, frame: int, at: Array) -> Place:
        """Return the place with these coordinates in a frame."""
        return {"frame": frame, "at": tidy(at)}

    def named(self, name: str) -> Place:
        """Return a point, the origin of a rigid body, or a point of one."""
        body, _, point = name.partition(".")
        frame = self.frame(body)
        if body in self.scene.points and frame == 0:
            return self.fixed_to(0, self.vector(self.scene.points[body].position))
        found: Any = self.scene.bodies.get(body)
        return self.fixed_to(frame, self.vector(found.points[point]) if point else np.zeros(3))

    def drawn(self, body: str | None, position: Array) -> Place:
        """Return the place on a body, or on the ground, that is drawn at a global position."""
        frame = self.frame(body)
        origin, rotation = self.poses[frame]
        return self.fixed_to(frame, rotation.T @ (position - origin))

    def of(self, reference: PointReference) -> Place:
        """Return the place that an end of a part names."""
        if reference.at is not None:
            return self.drawn(reference.point, self.vector(reference.at))
        return self.named(reference.point or "")

    def own(self, body: str | None, direction: Array) -> Array:
        """Return the components of a global direction in the axes of a body."""
        return self.poses[self.frame(body)][1].T @ direction

    def at_start(self, place: Place) -> Array:
        """Return global coordinates at the start."""
        origin, rotation = self.poses[place["frame"]]
        return origin + rotation @ np.array(place["at"], float)
