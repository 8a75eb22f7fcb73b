"""Hulls of corners, with all that lies within a radius of them, and how far places are from them.

A place x has the signed distance D to the hull of the corners,

segment      |x - p - s u|,  s = max(0, min(1, (x - p) . u/u^2))
polygon      m + min |x_k| - |m|,  m = max d_k, the largest distance to the line of an edge
box          sqrt(sum max(q_k, 0)^2) + min(m, 0),  m = max q_k,  q_k = |x_k| - a_k/2
polyhedron   max d_k, the largest distance to the plane of a face

and without a radius, where D has kinks, m, which is 0 on the same surface.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import NamedTuple

from solver.mechanics.combination import Combination
from solver.mechanics.contacts import SKEW
from solver.mechanics.frames import Ground, RigidFrame
from solver.mechanics.rows import Rows
from solver.mechanics.slips import is_there
from solver.mechanics.vectors import Vector, dot, norm, scale, subtract, turned
from solver.scene import Number
from solver.scene.expression import operate, sqrt

MARGIN = 1e-4
"""Share of its length before an end of a face from which its distance grows faster: a corner that
is there is seen by the other shape, whose own is 1e-9 farther off at most."""
Distance = Callable[[Vector, bool], Number]
"""Of a place in body axes to a hull; of places beyond its faces or ends larger, if asked for."""
Plane = tuple[Vector, Number]
"""Unit normal, outwards, and distance from the origin of the body."""
Edge = tuple[int, int, int, int]
"""Corners at its ends, and planes of the faces that meet there, by their numbers."""


class Shape(NamedTuple):
    """Hull of corners of a body, in its axes, with all within a radius."""

    frame: Ground | RigidFrame
    title: str
    corners: tuple[Vector, ...]
    radius: Number
    distance: Distance
    planes: tuple[Plane, ...] = ()
    edges: tuple[Edge, ...] = ()
    """Of a polyhedron in space."""
    up: Vector = ()
    """Normal whose tangents the others turn from: no face points against it."""

    def place(self, corner: Vector) -> Combination:
        """Return where a corner is."""
        frame = self.frame
        return frame.place(corner) if isinstance(frame, Ground) else frame.at(corner)

    def edge(self, edge: Edge) -> Shape:
        """Return the segment between the corners of an edge."""
        one, two = (self.corners[k] for k in edge[:2])
        return self._replace(corners=(one, two), distance=segment(one, two))

    @property
    def ball(self) -> Ground | RigidFrame | None:
        """What turns about the corners; None where the radius is no arm."""
        return self.frame if is_there(self.radius) else None


def larger(x: Number, y: Number) -> Number:
    """Return max(x, y)."""
    return operate("max", x, y)


def smaller(x: Number, y: Number) -> Number:
    """Return min(x, y)."""
    return operate("min", x, y)


def largest(numbers: Iterable[Number]) -> Number:
    """Return the largest of some numbers."""
    first, *others = numbers
    for other in others:
        first = larger(first, other)
    return first


def within(x: Number, low: float, high: float) -> Number:
    """Return the number between two that is next to x."""
    return larger(smaller(x, high), low)


def beyond_ends(share: Number) -> Number:
    """Return the square of how far a share of a length lies out of it, or nearly."""
    out = share - within(share, MARGIN, 1.0 - MARGIN)
    return out * out


# ---------------------------------------------------------------------------------- boxes in space


def box_planes(half: Vector) -> tuple[Plane, ...]:
    """Return the planes of a box in space: against and along each axis."""
    return tuple(
        (tuple(sign * float(k == axis) for k in range(3)), half[axis])
        for axis in range(3)
        for sign in (-1.0, 1.0)
    )


def _edges_of_a_box() -> tuple[Edge, ...]:
    edges = []
    for k in (4, 2, 1):  # corner i is at the far end of x, y, z where its bits 4, 2, 1 are set
        for i in range(8):
            if not i & k:
                one, two = (
                    2 * axis + bool(i & bit) for axis, bit in enumerate((4, 2, 1)) if bit != k
                )
                edges.append((i, i + k, one, two))
    return tuple(edges)


BOX_EDGES = _edges_of_a_box()
UP_OF_A_BOX = SKEW

# ---------------------------------------------------------------------------------------- distances


def place(corner: Vector) -> Distance:
    """Return the distance to a place."""
    return lambda x, _: norm(subtract(x, corner))


def segment(first: Vector, second: Vector) -> Distance:
    """Return the distance to a segment."""
    u = subtract(second, first)
    length2 = dot(u, u)

    def distance(x: Vector, grows: bool) -> Number:
        link = subtract(x, first)
        share = dot(link, u) / length2
        across = subtract(link, scale(within(share, 0.0, 1.0), u))
        more = length2 * beyond_ends(share) if grows else 0.0
        return sqrt(dot(across, across) + more)

    return distance


def polygon(rows: Rows, corners: tuple[Vector, ...], rounded: bool, end: str) -> Distance:
    """Return the distance to a convex polygon, whose corners go round it either way."""
    default = rows.mechanism.default
    edges = list(zip(corners, (*corners[1:], corners[0]), strict=True))
    area = sum(default(a[0] * b[1] - a[1] * b[0]) for a, b in edges)
    faces = []
    for k, (one, two) in enumerate(edges):
        along = subtract(two, one)
        length = norm(along)
        rows.rule(length, ">", f"two corners of the polygon{end} coincide: length {{value:.6g}} m")
        outward = scale((-1.0 if area > 0.0 else 1.0) / length, turned(along))
        faces.append((one, outward))
        for other in set(range(len(corners))) - {k, (k + 1) % len(corners)}:
            depth = -1.0 * dot(subtract(corners[other], one), outward)
            text = f"the polygon{end} is not convex, or its corners are not in turn: corner "
            text += f"{other + 1} is {{value:.6g}} m within edge {k + 1}, which must be > 0"
            rows.rule(depth, ">", text)
    sides = [segment(*edge) for edge in edges]

    def distance(x: Vector, grows: bool) -> Number:
        depth = largest(dot(subtract(x, one), outward) for one, outward in faces)
        if not rounded:
            return depth
        nearest, *others = (side(x, grows) for side in sides)
        for other in others:
            nearest = smaller(nearest, other)
        return depth + nearest - operate("abs", depth)

    return distance


def box(half: Vector, rounded: bool) -> Distance:
    """Return the distance to a box in space, of half lengths along the axes."""

    def distance(x: Vector, grows: bool) -> Number:
        heights = [operate("abs", y) - a for y, a in zip(x, half, strict=True)]
        highest = larger(larger(heights[0], heights[1]), heights[2])
        if not rounded:
            return highest
        beyond = [larger(height, 0.0) for height in heights]
        if grows:
            least = smaller(smaller(heights[0], heights[1]), heights[2])
            beyond.append(larger(least + MARGIN * norm(half), 0.0))
        return sqrt(larger(dot(beyond, beyond), 1e-300)) + smaller(highest, 0.0)

    return distance


def polyhedron(planes: Iterable[Plane]) -> Distance:
    """Return the largest distance to a plane of a convex polyhedron."""
    return lambda x, _: largest(dot(normal, x) - offset for normal, offset in planes)
