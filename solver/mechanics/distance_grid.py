"""Signed distances to a mesh as a spline over a grid.

    d(x) = sum_ijk c_ijk B(u - i) B(v - j) B(w - k),       u, v, w = (x - origin)/spacing

with cubic B-splines B, so that curvature is continuous and a contact opens where it should. The
coefficients interpolate exact distances (libigl) at the nodes, positive outside of the mesh; beyond
the grid the second differences vanish. Edges of the mesh are rounded off within a cell.
"""

from __future__ import annotations

from array import array
from functools import lru_cache
from math import floor, log2, prod
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from solver.scene.expression import Grid
from solver.scene.files import DataFile
from solver.scene.meshes import triangles_of

Array = NDArray[np.float64]
CELLS = 32
"""Of the longest side, unless the scene says how long they are."""
LEAST_CELLS = 4
MOST_CELLS = 4000
"""Of the longest side: the core reads 4096 coefficients along an axis."""
LONGEST = 1e100
"""Side of a mesh [m]; squares of much longer ones overflow."""
MOST_NUMBERS = 1_000_000
"""Coefficients of a grid: 8 MB of a model."""
ROUNDED = 2.0**-20
"""Of a cell: coefficients are multiples of about this, which an archive stores in half the room."""
PADDING = 12
"""Nodes after which an end of an interpolating spline has no influence: 0.27^12 = 1e-7."""
TRIALS = 4000
"""Random places at which the spline is compared with the mesh."""


class MeshError(ValueError):
    """A number that a mesh does not allow, of this field of the contact."""

    def __init__(self, message: str, field: str) -> None:
        super().__init__(message)
        self.field = field


class DistanceGrid(NamedTuple):
    """Distances to a mesh, and how exact they are."""

    grid: Grid
    low: tuple[float, ...]
    """Corner of the box in which the spline stands [m]."""
    high: tuple[float, ...]
    spacing: float
    """Length of a cell [m]."""
    reach: float
    """How far the box goes beyond the mesh, at least [m]."""
    depth: float
    """Distance of the deepest node inside of the mesh [m]."""
    largest_error: float
    """At random places within a cell of the surface where points or centres of balls touch [m]."""
    mean_error: float
    """Root of the mean square [m]."""

    @property
    def cells(self) -> list[int]:
        """Number of cells along each axis."""
        return [int(n) - 3 for n in self.grid.numbers[4:7]]


@lru_cache(maxsize=8)
def distance_grid(
    mesh: DataFile, scale: float, spacing: float | None, radius: float
) -> DistanceGrid:
    """Return the distances to a mesh.

    Parameters
    ----------
    mesh : DataFile
    scale : float
        Unit of its file [m].
    spacing : float or None
        Length of the cells [m].
    radius : float
        Distance at which centres of balls touch the mesh, negative inside of it [m].

    Raises
    ------
    MeshError
        If the cells are too large or too small for the mesh, or the mesh or its balls too large.
    """
    corners, faces = scaled(mesh, scale)
    low, high = corners.min(axis=0), corners.max(axis=0)
    longest = float((high - low).max())
    h = longest / CELLS if spacing is None else spacing
    ball = max(radius, 0.0)
    _demand_size(high - low, h, ball, "file" if spacing is None else "resolution")
    reach, cells = ball + 2.0 * h, _cells(high - low, h, ball)
    origin = 0.5 * (low + high - h * cells)
    axes = [x + h * np.arange(-1, n + 2) for x, n in zip(origin, cells, strict=True)]
    nodes = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1)
    samples = _distances(nodes.reshape(-1, 3), corners, faces).reshape(nodes.shape[:3])
    depth = -float(samples.min())
    if radius < 0.0 and -radius >= depth:
        message = f"must be < {depth:.6g} m, the largest ball inside of the mesh that its grid "
        message += f"shows, got {-radius:.6g} m"
        raise MeshError(message, "ball_radius")
    coefficients = _interpolating(samples, h)
    errors = _errors(mesh, scale, radius, origin, h, coefficients)
    numbers = array("d", [*origin, h, *samples.shape])
    numbers.frombytes(coefficients.tobytes())
    return DistanceGrid(
        Grid("distance", numbers),
        tuple(map(float, origin)), tuple(map(float, origin + h * cells)), h, reach, depth,
        float(np.abs(errors).max()), float(np.sqrt(np.mean(errors**2))),
    )  # fmt: skip


def _cells(sides: Array, h: float, ball: float) -> Array:
    """Number of cells along each axis about a mesh and balls of this radius outside of it."""
    return np.ceil((sides + 2.0 * (ball + 2.0 * h)) / h)


def _demand_size(sides: Array, h: float, ball: float, field: str) -> None:
    """Demand that cells of length h are neither too large nor too many for a mesh."""

    def count(size: float) -> float:
        return prod((_cells(sides, size, ball) + 3.0).tolist())

    longest = float(sides.max())
    if not longest < LONGEST:
        message = f"makes a mesh of {longest:.2g} m, must be < {LONGEST:.0e} m"
        raise MeshError(message, "scale")
    if not longest / MOST_CELLS <= h <= longest / LEAST_CELLS:
        word, part = ("least", MOST_CELLS) if h < longest / MOST_CELLS else ("most", LEAST_CELLS)
        message = f"must be at {word} 1/{part} of the longest side of the mesh, "
        message += f"{longest / part:.6g} m, got {h:.6g} m"
        raise MeshError(message, field)
    enough = h
    while count(enough) > MOST_NUMBERS:
        enough *= 1.2
        if enough > longest / LEAST_CELLS:
            message = f"must be smaller: the longest side of the mesh has {longest:.6g} m, "
            message += f"got {ball:.6g} m"
            raise MeshError(message, "ball_radius")
    if enough > h:
        message = f"makes a grid of {count(h):.2g} numbers, more than {MOST_NUMBERS:.0e}: "
        message += f"cells of {1.1 * enough:.2g} m will do"
        raise MeshError(message, field)


def scaled(mesh: DataFile, scale: float) -> tuple[Array, NDArray[np.int64]]:
    """Return the corners of a mesh in m, and the three of each triangle."""
    found = triangles_of(mesh)
    return scale * np.asarray(found.vertices, float), np.asarray(found.faces, np.int64)


def spread(places: Array, most: int) -> tuple[Array, float]:
    """Return some of many places, each the farthest from those before, and the largest way left."""
    chosen = [int(np.argmax(np.linalg.norm(places - places.mean(axis=0), axis=1)))]
    way = np.linalg.norm(places - places[chosen[0]], axis=1)
    while len(chosen) < min(most, len(places)):
        chosen.append(int(np.argmax(way)))
        way = np.minimum(way, np.linalg.norm(places - places[chosen[-1]], axis=1))
    return places[chosen], float(way.max())


def _distances(places: Array, corners: Array, faces: NDArray[np.int64]) -> Array:
    import igl

    kind = igl.SIGNED_DISTANCE_TYPE_PSEUDONORMAL  # pyright: ignore[reportAttributeAccessIssue]
    return np.asarray(igl.signed_distance(places, corners, faces, sign_type=kind)[0], float)


def _interpolating(samples: Array, spacing: float) -> Array:
    """Coefficients of the spline through samples, rounded."""
    from scipy.ndimage import spline_filter

    padded = np.pad(samples, PADDING, mode="reflect", reflect_type="odd")
    inner = (slice(PADDING, -PADDING),) * 3
    unit = 2.0 ** floor(log2(spacing)) * ROUNDED
    return unit * np.round(np.asarray(spline_filter(padded, order=3), float)[inner] / unit)


def _errors(
    mesh: DataFile, scale: float, radius: float, origin: Array, spacing: float, coefficients: Array
) -> Array:  # fmt: skip
    """Differences from exact distances at random places near where something touches."""
    from scipy.ndimage import map_coordinates

    found: Any = triangles_of(mesh)
    random = np.random.default_rng(1)
    share = np.cumsum(found.area_faces)
    chosen = np.searchsorted(share, share[-1] * random.random(TRIALS))
    weights = random.dirichlet((1.0, 1.0, 1.0), TRIALS)
    on = scale * np.einsum("ij,ijk->ik", weights, found.triangles[chosen])
    off = radius + spacing * random.uniform(-1.0, 1.0, TRIALS)
    places = on + off[:, None] * found.face_normals[chosen]
    exact = _distances(places, *scaled(mesh, scale))
    near = np.abs(exact - radius) <= spacing
    cells = (places[near] - origin).T / spacing + 1.0
    return map_coordinates(coefficients, cells, order=3, prefilter=False) - exact[near]
