"""Files that a scene names: they are read once, and travel with it."""

from __future__ import annotations

import importlib.util
from pathlib import Path

import pytest

import solver
from solver.scene import SceneError
from tests.support.mechanisms.scene_files import SCENES

CUBE = """
v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1
f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8
"""
"""Of six squares that face outwards."""


def scene(folder: Path, contact: str) -> Path:
    path = folder / "scene.toml"
    start = 'name = "x"\n[points]\nA = { position = [0.5, 0.5, 3], mass = 1 }\n[contacts]\n'
    path.write_text(f"{start}c = {{ point = 'A', {contact} }}\n")
    return path


def again(found: solver.Scene) -> solver.Scene:
    """Read a scene as an FMU carries it: from its text and overrides."""
    texts = found.source.overrides.values()
    overrides = dict(text.split("=", 1) for text in texts)
    return solver.loads(found.source.text, overrides=overrides)


def test_a_scene_with_meshes_is_read_again_without_their_files():
    found = solver.load(SCENES / "die_in_a_bowl.toml")
    assert solver.assemble(again(found)).file == solver.assemble(found).file


def test_a_grid_of_heights_in_a_file_is_that_of_the_lists(tmp_path):
    """Also when it is read again without the file; a byte order mark and semicolons do no harm."""
    (tmp_path / "h.csv").write_text("﻿x\\y;0;1;3\n0;0;0.1;0\n2;0.3;0;-1\n", encoding="utf-8")
    from_file = solver.load(scene(tmp_path, 'type = "height_field", file = "h.csv"'))
    lists = "x = [0, 2], y = [0, 1, 3], z = [[0, 0.1, 0], [0.3, 0, -1]]"
    from_lists = solver.load(scene(tmp_path, f'type = "height_field", {lists}'))
    model = solver.assemble(from_lists).file
    assert solver.assemble(from_file).file == model
    (tmp_path / "h.csv").unlink()
    assert solver.assemble(again(from_file)).file == model


@pytest.mark.parametrize("decorated", [False, True])
def test_triangles_may_face_either_side_and_have_colours_and_textures(tmp_path, decorated):
    text = CUBE
    if decorated:
        text = text.replace("4 3 2 1", "4/1/1 3/2/1 2/3/1 1/1/1").replace(" 5 6", " 5//1 6//1")
        text = "mtllib none.mtl\no a\nusemtl red\nvt 0 0\nvt 1 0\nvt 1 1\nvn 0 0 1\n" + text
    turned = "\n".join(
        " ".join(["f", *reversed(line.split()[1:])]) if line.startswith("f ") else line
        for line in text.splitlines()
    )
    gaps = []
    for content in (text, turned):
        (tmp_path / "cube.obj").write_text(content)
        path = scene(tmp_path, 'type = "mesh", file = "cube.obj"')
        run = solver.Integrator(solver.assemble(solver.load(path)))
        run.initialise()
        gaps.append(run["c.gap"])
    assert gaps[0] == gaps[1] == pytest.approx(2.0, abs=0.05)


def test_a_mesh_in_millimetres_is_scaled(tmp_path):
    (tmp_path / "cube.obj").write_text(CUBE)
    contact = 'type = "mesh", file = "cube.obj", scale = 0.001, position = [0.4995, 0.4995, 2.9]'
    run = solver.Integrator(solver.assemble(solver.load(scene(tmp_path, contact))))
    run.initialise()
    assert run["c.gap"] == pytest.approx(0.099, abs=5e-5)


def test_without_the_libraries_a_sentence_says_what_to_install(tmp_path, monkeypatch):
    (tmp_path / "cube.obj").write_text(CUBE)
    path = scene(tmp_path, 'type = "mesh", file = "cube.obj"')
    spec = importlib.util.find_spec
    monkeypatch.setattr(
        "solver.scene.meshes.find_spec", lambda name: None if name == "igl" else spec(name)
    )
    with pytest.raises(SceneError, match="packages that are not installed: igl") as caught:
        solver.load(path)
    assert 'pip install "holonom[mesh]"' in str(caught.value)
