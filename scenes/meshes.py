"""Writes the meshes of scenes: `python -m scenes.meshes`, or with a folder for them behind it.

The bowl is a round block with a spherical hollow, the die an icosahedron, the caltrop a
tetrahedron. Lengths are in m.
"""

from __future__ import annotations

import math
import sys
from itertools import pairwise
from pathlib import Path

Corner = tuple[float, float, float]
Mesh = tuple[list[Corner], list[tuple[int, int, int]]]

AROUND, RINGS = 40, 8


def bowl() -> Mesh:
    """Corners and triangles of a block of 0.36 m radius; its hollow has its lowest place at 0."""
    radius, width = 0.435, 0.3
    hollow = [math.asin(width / radius) * ring / RINGS for ring in range(1, RINGS + 1)]
    outline = [(radius * math.sin(a), radius * (1.0 - math.cos(a))) for a in hollow]
    outline += [(0.36, outline[-1][1]), (0.36, -0.05)]
    turns = [2.0 * math.pi * k / AROUND for k in range(AROUND)]
    corners = [(0.0, 0.0, 0.0), (0.0, 0.0, -0.05)]
    corners += [(r * math.cos(a), r * math.sin(a), z) for r, z in outline for a in turns]
    rings = [[2 + AROUND * i + k for k in range(AROUND)] for i in range(len(outline))]
    triangles = []
    for k in range(AROUND):
        after = (k + 1) % AROUND
        triangles += [(0, rings[0][k], rings[0][after]), (1, rings[-1][after], rings[-1][k])]
        for inner, outer in pairwise(rings):
            triangles += [
                (inner[k], outer[k], outer[after]),
                (inner[k], outer[after], inner[after]),
            ]
    return corners, triangles


def die() -> Mesh:
    """Corners and triangles of an icosahedron whose corners are 0.05 m from its centre."""
    golden = 0.5 * (1.0 + math.sqrt(5.0))
    size = 0.05 / math.hypot(1.0, golden)
    plane = [(0.0, a * size, b * golden * size) for a in (-1.0, 1.0) for b in (-1.0, 1.0)]
    corners = [(c[k], c[(k + 1) % 3], c[(k + 2) % 3]) for k in range(3) for c in plane]
    edge, n = 2.0 * size * (1.0 + 1e-9), range(len(corners))
    found = []
    for i, j, k in ((i, j, k) for i in n for j in n for k in n if i < j < k):
        a, b, c = corners[i], corners[j], corners[k]
        if max(math.dist(a, b), math.dist(b, c), math.dist(c, a)) <= edge:
            found.append((i, j, k) if _turns_left(a, b, c) else (i, k, j))
    return corners, found


def caltrop() -> Mesh:
    """Corners and triangles of a tetrahedron with edges of 0.1 m."""
    a = 0.1 / math.sqrt(8.0)
    corners = [(a, a, a), (a, -a, -a), (-a, a, -a), (-a, -a, a)]
    return corners, [(0, 1, 2), (0, 3, 1), (0, 2, 3), (1, 3, 2)]


def _turns_left(a: Corner, b: Corner, c: Corner) -> bool:
    """Whether three corners turn left as seen from outside of a body about the origin."""
    x, y, z = a
    return x * (b[1] * c[2] - b[2] * c[1]) + y * (b[2] * c[0] - b[0] * c[2]) + z * (
        b[0] * c[1] - b[1] * c[0]
    ) > 0.0  # fmt: skip


def as_obj(mesh: Mesh) -> str:
    """Text of an OBJ file."""
    corners, triangles = mesh
    lines = [f"v {x:.6f} {y:.6f} {z:.6f}" for x, y, z in corners]
    lines += [f"f {i + 1} {j + 1} {k + 1}" for i, j, k in triangles]
    return "\n".join(lines) + "\n"


def as_stl(mesh: Mesh) -> str:
    """Text of an STL file; normals follow from the corners and are left 0."""
    corners, triangles = mesh
    lines = ["solid mesh"]
    for triangle in triangles:
        places = [f"vertex {x:.9f} {y:.9f} {z:.9f}" for x, y, z in (corners[i] for i in triangle)]
        lines += ["facet normal 0 0 0", "outer loop", *places, "endloop", "endfacet"]
    return "\n".join([*lines, "endsolid mesh"]) + "\n"


FILES = {
    "bowl.obj": lambda: as_obj(bowl()),
    "die.stl": lambda: as_stl(die()),
    "caltrop.stl": lambda: as_stl(caltrop()),
}


def main() -> None:
    """Write the files."""
    folder = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parent)
    for name, text in FILES.items():
        (folder / name).write_bytes(text().encode())


if __name__ == "__main__":
    main()
