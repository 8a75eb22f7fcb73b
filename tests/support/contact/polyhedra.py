"""Convex polyhedra of tests: as meshes, and how far two of them are from each other."""

from __future__ import annotations

from itertools import product
from typing import NamedTuple

import numpy as np
import trimesh

from solver.scene.files import DataFile
from tests.mechanics.test_contact_rows import Pose
from tests.support.contact.meshes import data_file
from tests.support.mechanisms.reduced_models import Array


class Polyhedron(NamedTuple):
    """Corners, normals of faces and directions of edges, in body axes."""

    corners: Array
    normals: Array
    edges: Array


def cuboid(*size: float) -> Polyhedron:
    """Box about the origin."""
    corners = np.array(list(product(*([-0.5 * x, 0.5 * x] for x in size))))
    return Polyhedron(corners, np.eye(3), np.eye(3))


def hull_of(corners: Array) -> tuple[Polyhedron, DataFile]:
    """Hull of some corners in general position, and its file."""
    mesh = trimesh.convex.convex_hull(corners.astype(np.float32))  # as STL has them
    edges = mesh.vertices[mesh.edges_unique]
    found = Polyhedron(
        np.array(mesh.vertices), np.array(mesh.face_normals), edges[:, 1] - edges[:, 0]
    )
    return found, data_file(mesh)


def axes_of(first: Polyhedron, one: Pose, second: Polyhedron, two: Pose) -> Array:
    """Normals of faces and those across two edges, either way: one of them separates the two."""
    across = np.cross((first.edges @ one.R.T)[:, None], (second.edges @ two.R.T)[None])
    axes = np.concatenate(
        (first.normals @ one.R.T, second.normals @ two.R.T, across.reshape(-1, 3))
    )
    sizes = np.linalg.norm(axes, axis=1)
    axes = (axes[sizes > 1e-9].T / sizes[sizes > 1e-9]).T
    return np.concatenate((axes, -axes))


def separation(first: Polyhedron, one: Pose, second: Polyhedron, two: Pose) -> float:
    """Largest distance along these axes, < 0 where both overlap."""
    axes = axes_of(first, one, second, two)
    a = (one.x + first.corners @ one.R.T) @ axes.T
    b = (two.x + second.corners @ two.R.T) @ axes.T
    return float((a.min(0) - b.max(0)).max())
