"""Curves and surfaces as points and triangles: hulls, F = 0, splines, coarser meshes."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from itertools import combinations
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from solver.mechanics.curves import separated
from solver.scene import HeightFieldContact, Profile
from solver.scene.expression import Curve, apply
from solver.scene.profiles import table_of
from viewer.places import Array, rounded

Triangles: TypeAlias = NDArray[np.int64]

STEPS = 40
"""Of a curve along the size of a mechanism."""
CELLS = 16
"""Of a surface along each side."""
MOST_CELLS = 64
"""Of one on which something travels."""
MOST_TRIANGLES = 300
"""Of a mesh in a drawing: 5 kB of text."""
_ROUNDED = 16
"""Corners of a circle about the corner of a rounded polygon."""


def around(corners: Sequence[Array], radius: float) -> Array:
    """Return the convex polygon around circles in the plane (Andrew's monotone chain)."""
    turns = np.arange(_ROUNDED) * 2.0 * math.pi / _ROUNDED
    circle = np.column_stack((np.cos(turns), np.sin(turns))) * radius
    centres = np.array(corners)[:, :2]
    places = np.unique((centres[:, None] + circle).reshape(-1, 2) if radius else centres, axis=0)

    def chain(ordered: Array) -> list[Array]:
        found: list[Array] = []
        for place in ordered:
            while len(found) > 1 and _area(found[-2], found[-1], place) <= 0.0:
                found.pop()
            found.append(place)
        return found[:-1]

    return np.array([*chain(places), *chain(places[::-1])])


def _area(a: Array, b: Array, c: Array) -> float:
    """Twice the area of a triangle, positive counterclockwise."""
    return float((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]))


def hull(corners: Array) -> Triangles:
    """Return the triangles of the convex hull of a few places: all that have none outside.

    Where more than three lie in a plane, triangles overlap.
    """
    middle, size = corners.mean(axis=0), float(np.ptp(corners, axis=0).max())
    found = []
    for i, j, k in combinations(range(len(corners)), 3):
        a, normal = corners[i], np.cross(corners[j] - corners[i], corners[k] - corners[i])
        length = np.linalg.norm(normal)
        if length <= 1e-9 * size * size:
            continue
        heights = (corners - a) @ (normal / length)
        if heights.max() <= 1e-9 * size or heights.min() >= -1e-9 * size:
            found.append((i, j, k) if normal @ (a - middle) >= 0.0 else (i, k, j))
    return np.array(found, int).reshape(-1, 3)


def coarser(
    vertices: Array, triangles: Triangles, most: int = MOST_TRIANGLES
) -> tuple[Array, Triangles]:
    """Return a mesh of fewer triangles: corners within a cell of a grid become one."""
    cells, low = 48.0, vertices.min(axis=0)
    side = float(np.ptp(vertices, axis=0).max()) or 1.0
    kept, faces = vertices, triangles
    while len(faces) > most:
        keys = np.floor((vertices - low) * (cells / side))
        _, place, count = np.unique(keys, axis=0, return_inverse=True, return_counts=True)
        place = place.reshape(-1)
        kept = np.zeros((len(count), 3))
        np.add.at(kept, place, vertices)
        kept = kept / count[:, None]
        faces = place[triangles]
        whole = (faces[:, 0] != faces[:, 1]) & (faces[:, 1] != faces[:, 2])
        faces = faces[whole & (faces[:, 2] != faces[:, 0])]
        cells *= 0.8
    return kept, faces


def profile_curve(profile: Profile, middle: float) -> Array:
    """Return places of a profile; of a periodic one three periods about a way."""
    period = profile.x[-1] - profile.x[0]
    low, high = profile.x[0], profile.x[-1]
    if profile.periodic:
        low += (math.floor((middle - low) / period) - 1.0) * period
        high = low + 3.0 * period
    knots = [x for x in profile.x if low < x < high]
    ways = np.unique([*np.linspace(low, high, 4 * STEPS + 1), *knots])
    return np.column_stack((ways, [apply("spline", x, profile.curve) for x in ways]))


def cam_curve(profile: Profile) -> Array:
    """Return places of a cam r(angle), counterclockwise."""
    turns = np.linspace(0.0, 2.0 * math.pi, 3 * STEPS, endpoint=False)
    radii = np.array([apply("spline", x, profile.curve) for x in turns])
    return np.column_stack((radii * np.cos(turns), radii * np.sin(turns)))


def closes(points: Array) -> bool:
    """Whether a curve ends where it begins."""
    return len(points) > 3 and bool((points[0] == points[-1]).all())


def traced(value: Callable[[Array], float], start: Array, size: float, depth: float) -> Array:
    """Return places of a curve F(x, y) = 0, from the one next to `start` until it closes.

    It turns counterclockwise about F < 0. A ball whose centre moves on it touches what lies deeper.
    """
    step = size / STEPS

    def slope(at: Array) -> Array:
        e = 1e-5 * step
        return np.array([(value(at + d) - value(at - d)) / (2.0 * e) for d in e * np.eye(2)])

    def onto(at: Array, g: Array) -> Array:
        for k in range(8):
            if k in (3, 5):  # there is an edge
                g = slope(at)
            change = value(at) * g / (float(g @ g) or 1.0)
            at = at - change
            if float(change @ change) < (1e-3 * step) ** 2:
                break
        return at

    def below(points: Array) -> Array:
        if depth == 0.0:
            return points
        slopes = np.array([*map(slope, points)])
        return points - depth * slopes / np.linalg.norm(slopes, axis=1)[:, None]

    first = start
    for _ in range(8):
        first = onto(first, slope(first))
    branches = []
    for sign in (1.0, -1.0):
        at, found = first, []
        for _ in range(8 * STEPS):
            g = slope(at)
            along = np.array((-g[1], g[0])) / (np.linalg.norm(g) or 1.0)
            at = onto(at + sign * step * along, g)
            found.append(at)
            if len(found) > 4 and np.linalg.norm(at - first) < 1.5 * step:  # longer at edges
                return below(np.array([first, *found, first]))
            if not np.linalg.norm(at - start) < 1.5 * size:
                break
        branches.append(found)
    return below(np.array([*branches[1][::-1], first, *branches[0]]))


def heights_over(
    value: Callable[[Array], float], start: Array, size: float, travel: Array, depth: float
) -> tuple[Array, dict[str, Any]] | None:
    """Return axes and a grid of heights on a surface F(x, y, z) = 0 about a place that travels.

    The heights are along the axis to which the normal is nearest; each is sought by Newton's
    iteration from its neighbour, and is None where there is none. A ball whose centre moves on the
    surface touches what lies deeper, where F < 0.
    """
    e = 1e-6 * size
    slopes = [(value(start + d) - value(start - d)) for d in e * np.eye(3)]
    up = int(np.argmax(np.abs(slopes)))
    axes = np.eye(3)[:, [(up + 1) % 3, (up + 2) % 3, up]]
    ways, middle = [], []
    for far in axes.T[:2] @ travel:
        cells = min(CELLS + round(CELLS * abs(far) / (3.0 * size)), MOST_CELLS)
        ways.append(
            np.linspace(min(far, 0.0) - 0.75 * size, max(far, 0.0) + 0.75 * size, cells + 1)
        )
        middle.append(int(np.argmin(np.abs(ways[-1]))))
    grid: dict[tuple[int, int], float] = {}
    own = axes.T @ start

    def height(i: int, k: int, guess: float) -> float | None:
        z = guess
        for _ in range(20):
            at = axes @ np.array((own[0] + ways[0][i], own[1] + ways[1][k], z))
            rise = (value(at + e * axes[:, 2]) - value(at - e * axes[:, 2])) / (2.0 * e)
            change = -value(at) / rise if rise else math.inf
            if not abs(change) < size:
                return None
            z += change
            if abs(change) < 1e-9 * size:
                return z
        return None

    places = [(i, k) for i in range(len(ways[0])) for k in range(len(ways[1]))]
    for i, k in sorted(places, key=lambda c: (c[0] - middle[0]) ** 2 + (c[1] - middle[1]) ** 2):
        near = (i - int(np.sign(i - middle[0])), k - int(np.sign(k - middle[1])))
        guess = grid.get(near, None if grid else own[2])
        found = None if guess is None else height(i, k, guess)
        if found is not None:
            grid[i, k] = found
    if not grid:
        return None
    rows = [[grid.get((i, k), math.nan) for k in range(len(ways[1]))] for i in range(len(ways[0]))]
    x, y, down = own[0] + ways[0], own[1] + ways[1], math.copysign(depth, slopes[up])
    return axes, _heights(x, y, np.array(rows), down)


def _heights(x: Array, y: Array, z: Array, down: float) -> dict[str, Any]:
    """Return a grid of heights, None for NaN, lower by a length along the normal."""
    if down:
        slopes = np.nan_to_num(np.gradient(z, x, y))
        z = z - down * np.sqrt(1.0 + slopes[0] ** 2 + slopes[1] ** 2)
    digits = rounded(np.where(np.isfinite(z), z, 0.0))
    rows = [
        [height if known else None for height, known in zip(*row, strict=True)]
        for row in zip(digits.tolist(), np.isfinite(z).tolist(), strict=True)
    ]
    return {"x": rounded(x), "y": rounded(y), "z": rows}


def heights_of(contact: HeightFieldContact, depth: float) -> dict[str, Any]:
    """Return a grid of the splines through a field of heights, that much lower along the normal."""
    x, y = (np.linspace(places[0], places[-1], CELLS + 1) for places in (contact.x, contact.y))
    z = np.zeros((len(x), len(y)))
    for u, v in separated(contact.z):
        first, second = (
            Curve("height", table_of(contact.x, u)),
            Curve("height", table_of(contact.y, v)),
        )
        along = [apply("spline", at, first) for at in x]
        z += np.outer(along, [apply("spline", at, second) for at in y])
    return _heights(x, y, z, depth)
