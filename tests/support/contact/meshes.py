"""Meshes for tests, as texts that stand for their files."""

from __future__ import annotations

from typing import Any

import trimesh

from solver.scene.files import DataFile


def data_file(mesh: Any, name: str = "mesh.stl") -> DataFile:
    """File of a ``trimesh.Trimesh``."""
    return DataFile(name, "stl", mesh.export(file_type="stl"))


def ellipsoid(fineness: int, semi_axes: tuple[float, ...] = (1.0, 0.8, 0.6)) -> DataFile:
    """Ellipsoid of 20 * 4^fineness triangles, whose corners lie on it."""
    mesh = trimesh.creation.icosphere(subdivisions=fineness)
    mesh.apply_scale(semi_axes)
    return data_file(mesh)


def box(*size: float) -> DataFile:
    """Box about the origin."""
    return data_file(trimesh.creation.box(size))
