"""Corners, faces and edges of the convex pieces of a mesh, and meshes that are refused."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh

from solver.mechanics.convex_parts import convex_pieces, free_direction
from solver.scene import SceneError
from solver.scene.files import DataFile
from tests.support.contact.meshes import data_file
from tests.support.mechanisms.problems import GRAVITY, assemble, mechanism, start

SCENES = Path(__file__).parents[2] / "scenes"
DIE = DataFile("die.stl", "stl", (SCENES / "die.stl").read_bytes())
BOWL = DataFile("bowl.obj", "obj", (SCENES / "bowl.obj").read_bytes())


@pytest.mark.parametrize(
    ("mesh", "counts"),
    [
        (DIE, (12, 20, 30)),
        (data_file(trimesh.creation.box((1, 2, 3))), (8, 6, 12)),
        (data_file(trimesh.creation.box((1, 2, 3)).subdivide().subdivide()), (8, 6, 12)),
        (data_file(trimesh.creation.cylinder(1.0, 2.0, sections=7)), (14, 9, 21)),
    ],
    ids=["icosahedron", "box", "box of many triangles", "prism"],
)
def test_triangles_of_a_plane_are_one_face(mesh, counts):
    (piece,) = convex_pieces(mesh, 0.5)
    assert (len(piece.corners), len(piece.planes), len(piece.edges)) == counts
    corners, normals = np.array(piece.corners), np.array([n for n, _ in piece.planes])
    heights = corners @ normals.T - np.array([d for _, d in piece.planes])
    assert heights.max() <= 0.0  # none beyond a face
    for i, k, *faces in piece.edges:
        assert np.abs(heights[[i, k]][:, faces]).max() < 1e-6
    assert (normals @ np.array(free_direction(piece.planes))).min() > -0.95


def test_pieces_that_do_not_touch_are_parts_of_their_own():
    shifted = trimesh.transformations.translation_matrix([3.0, 0.0, 0.0])
    both = [trimesh.creation.box((1, 1, 1)), trimesh.creation.box((1, 1, 1), transform=shifted)]
    pieces = convex_pieces(data_file(trimesh.util.concatenate(both)), 1.0)
    assert [sum(x for x, *_ in piece.corners) / 8.0 for piece in pieces] == [0.0, 3.0]


def contact(file: DataFile, **fields: Any) -> dict[str, Any]:
    """A body with a mesh on a box of the ground."""
    bodies = {"stone": {"mass": 1.0, "inertia": [1.0] * 3, "position": [0, 0, 9.0]}}
    given = {
        "type": "convex", "bodies": ["stone", "ground"], "file": file.text, "size": [1, 1, 1],
    }  # fmt: skip
    return mechanism("stone", 3, bodies=bodies, contacts={"c": given | fields})


def test_a_hollow_mesh_is_refused_with_its_remedy():
    with pytest.raises(SceneError, match=r"'bowl.obj' is not convex: it fills 74.34 % of its hull"):
        assemble(contact(BOWL))
    with pytest.raises(SceneError, match="split it into convex pieces"):
        assemble(contact(BOWL))


def test_a_mesh_of_too_many_edges_is_refused():
    content = contact(data_file(trimesh.creation.icosphere(subdivisions=1)), other_file=DIE.text)
    del content["contacts"]["c"]["size"]
    with pytest.raises(SceneError, match="make 3654 gaps, more than 2000: the bodies have 120 and"):
        assemble(content)


def test_what_is_drawn_into_each_other_is_refused():
    content = contact(DIE, scale=100.0)
    content["bodies"]["stone"]["position"] = [0, 0, 4.0]
    with pytest.raises(SceneError, match="drawn in penetration: the bodies overlap by"):
        assemble(content)


def test_sharp_boxes_of_equal_width_in_line_are_noted_and_round_ones_rest_on_each_other():
    upper = {"mass": 1.0, "inertia": [0.01] * 3, "position": [0, 0, 0.21]}
    box = {"type": "box", "bodies": ["upper", "ground"], "sizes": [[0.2] * 3] * 2}
    content = mechanism("stack", 3, bodies={"upper": upper}, contacts={"c": box})
    with pytest.warns(RuntimeWarning, match="8 corners of 'upper' are drawn in line with faces of"):
        start(content).advance(0.0, 0.01)
    content["contacts"]["c"]["radii"] = [0.01, 0.01]
    ran = start(content)
    ran.advance(0.0, 0.2)
    assert ran["upper.z"] == pytest.approx(0.2, abs=1e-12)
    assert ran["c.force"] == pytest.approx(GRAVITY, rel=1e-9)
