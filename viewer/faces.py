"""Faces of the solids of a drawing, in axes of their frames."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from viewer.places import Array

ROUND = 36
"""Sides of a cylinder."""


def rotation(q: Any) -> Array:
    """Return the rotation matrix of a quaternion [w, x, y, z]."""
    w, x, y, z = q
    return np.array([
        (1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)),
        (2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)),
        (2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)),
    ])  # fmt: skip


def faces_of(solid: dict[str, Any]) -> list[Array]:
    """Return the polygons of a solid, counterclockwise from outside."""
    found = _FACES.get(solid["shape"])
    return [] if found is None else found(solid)


def _prism(corners: Array, thickness: float) -> list[Array]:
    """Between two copies of a polygon that turns counterclockwise and sees all of itself."""
    up, down = (np.column_stack((corners, np.full(len(corners), z))) for z in
                (0.5 * thickness, -0.5 * thickness))  # fmt: skip
    after = [*range(1, len(corners)), 0]
    sides = [
        np.array((down[k], down[n], up[n], up[k])) for k, n in enumerate(after)
    ]  # fmt: skip
    return [up, down[::-1], *sides]


def _box(solid: dict[str, Any]) -> list[Array]:
    x, y, z = solid["size"]
    return _prism(0.5 * np.array(((-x, -y), (x, -y), (x, y), (-x, y))), z)


def _circle(radius: float) -> Array:
    turns = np.arange(ROUND) * 2.0 * math.pi / ROUND
    return radius * np.column_stack((np.cos(turns), np.sin(turns)))


def _cylinder(solid: dict[str, Any]) -> list[Array]:
    outer = _prism(_circle(solid["radius"]), solid["length"])
    if "inner_radius" not in solid:
        return outer
    inner = _prism(_circle(solid["inner_radius"]), solid["length"])
    found = [*outer[2:], *(side[::-1] for side in inner[2:])]
    for rim, hole in zip(outer[:2], inner[:2], strict=True):
        for k in range(ROUND):
            found.append(np.array((rim[k - 1], rim[k], hole[k], hole[k - 1])))
    return found


def _mesh(solid: dict[str, Any]) -> list[Array]:
    vertices = np.array(solid["vertices"], float)
    return [vertices[list(triangle)] for triangle in solid["triangles"]]


def _grid(x: Array, y: Array, z: Array) -> list[Array]:
    places = np.stack((x, y, z), axis=-1)
    cells = [
        np.array((places[i, k], places[i + 1, k], places[i + 1, k + 1], places[i, k + 1]))
        for i in range(len(places) - 1)
        for k in range(places.shape[1] - 1)
    ]
    return [cell for cell in cells if np.isfinite(cell).all()]


def _heights(solid: dict[str, Any]) -> list[Array]:
    x, y = np.meshgrid(solid["x"], solid["y"], indexing="ij")
    return _grid(x, y, np.array(solid["z"], float))


def _superquadric(solid: dict[str, Any]) -> list[Array]:
    turns, tilts = np.meshgrid(
        np.linspace(-math.pi, math.pi, ROUND + 1), np.linspace(-0.5 * math.pi, 0.5 * math.pi, 13),
        indexing="ij",
    )  # fmt: skip
    unit = (np.cos(turns) * np.cos(tilts), np.sin(turns) * np.cos(tilts), np.sin(tilts))
    power = 2.0 / solid["exponent"]
    return _grid(*(
        half * np.sign(x) * np.abs(x) ** power
        for half, x in zip(solid["half_axes"], unit, strict=True)
    ))  # fmt: skip


_FACES = {
    "box": _box,
    "cylinder": _cylinder,
    "prism": lambda solid: _prism(np.array(solid["corners"], float), solid["thickness"]),
    "mesh": _mesh,
    "heights": _heights,
    "superquadric": _superquadric,
}
