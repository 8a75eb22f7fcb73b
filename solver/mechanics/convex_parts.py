"""Convex parts of a mesh: its connected pieces, as corners, faces and edges.

Triangles of one plane are one face, and a corner is where three faces meet or more. What is not
convex is refused: it fills less than its hull.
"""

from __future__ import annotations

from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from solver.mechanics.hulls import Edge, Plane
from solver.scene.expression import Vector
from solver.scene.files import DataFile
from solver.scene.meshes import triangles_of

FLAT = 1e-4
"""Angle below which two triangles are of one face [rad]: coordinates of STL files have 24 bits."""
HOLLOW = 1e-5
"""Share of its hull that a convex piece may lack."""


class Piece(NamedTuple):
    """A convex polyhedron, in axes of the body that carries it [m]."""

    corners: tuple[Vector, ...]
    planes: tuple[Plane, ...]
    edges: tuple[Edge, ...]


class NotConvexError(ValueError):
    """A piece of a mesh that is not convex."""


@lru_cache(maxsize=32)
def convex_pieces(mesh: DataFile, scale: float) -> tuple[Piece, ...]:
    """Return the connected pieces of a mesh.

    Parameters
    ----------
    mesh : DataFile
    scale : float
        Unit of its file [m].

    Raises
    ------
    NotConvexError
        If a piece is not convex.
    """
    from scipy.sparse import coo_matrix
    from scipy.sparse.csgraph import connected_components

    found: Any = triangles_of(mesh)
    faces, n = np.asarray(found.faces), len(found.faces)
    one, two = np.asarray(found.face_adjacency).T
    near = coo_matrix((np.ones(len(one)), (one, two)), shape=(n, n))
    count, piece_of = connected_components(near, directed=False)
    places = scale * np.asarray(found.vertices, float)
    pieces = []
    for k in range(count):
        name = f"its piece {k + 1} of {count}" if count > 1 else "it"
        pieces.append(_piece(places, faces[piece_of == k], f"the mesh '{mesh.name}'", name))
    return tuple(pieces)


def _piece(places: NDArray[Any], faces: NDArray[Any], mesh: str, name: str) -> Piece:
    from scipy.spatial import ConvexHull

    used = np.unique(faces)
    x = places[used]
    hull: Any = ConvexHull(x)
    a, b, c = (places[faces[:, k]] - x[0] for k in range(3))
    share = float(abs(np.einsum("ij,ij->i", a, np.cross(b, c)).sum()) / 6.0 / hull.volume)
    if not share > 1.0 - HOLLOW:
        message = f"{mesh} is not convex: {name} fills {100.0 * share:.4g} % of its hull"
        raise NotConvexError(message)
    normals = hull.equations[:, :3]
    face_of = np.full(len(normals), -1)
    for i in range(len(normals)):
        if face_of[i] < 0:
            face_of[(np.linalg.norm(normals - normals[i], axis=1) < FLAT) & (face_of < 0)] = i
    members = [set(hull.simplices[face_of == k].ravel().tolist()) for k in np.unique(face_of)]
    planes = []
    for k in np.unique(face_of):  # no corner is beyond a face
        normal = normals[k]
        planes.append((tuple(map(float, normal)), float((x @ normal).max())))
    corners = [i for i in range(len(x)) if sum(i in face for face in members) > 2]
    edges = []
    for i in range(len(members)):
        for k in range(i):
            both = [j for j in corners if j in members[i] and j in members[k]]
            if len(both) > 1:
                at = x[both]
                way = np.linalg.norm(at[:, None] - at[None], axis=2)
                ends = (both[m] for m in np.unravel_index(int(way.argmax()), way.shape))
                edges.append((*(corners.index(m) for m in ends), k, i))
    if len(corners) - len(edges) + len(members) != 2:  # Euler's formula
        message = f"{mesh} has edges at which {name} bends by about {FLAT} rad: make them flat"
        raise NotConvexError(message)
    at = tuple(tuple(map(float, x[i])) for i in corners)
    return Piece(at, tuple(planes), tuple(edges))


def free_direction(planes: tuple[Plane, ...]) -> Vector:
    """Return a direction against which no face points, as far from all as may be."""
    normals = np.array([normal for normal, _ in planes])
    k = np.arange(200) + 0.5
    z, turn = 1.0 - k / 100.0, np.pi * (1.0 + np.sqrt(5.0)) * k  # a spiral over the sphere
    r = np.sqrt(1.0 - z * z)
    directions = np.stack((r * np.cos(turn), r * np.sin(turn), z), axis=1)
    best = directions[int((directions @ normals.T).min(axis=1).argmax())]
    return tuple(map(float, best))
