"""The drawing of a scene: plain data, whose frames are variables of the model."""

from __future__ import annotations

import json
import warnings
import zipfile
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings

import solver
from solver.mechanics import assemble_parts
from solver.scene import SceneWarning, loads
from tests.support.fmus.fmu_instance import SCENES, scene_fmu
from tests.support.mechanisms.random_mechanisms import driven_systems
from tests.support.mechanisms.scene_files import ALL
from viewer.drawing import drawing
from viewer.faces import faces_of
from viewer.picture import picture
from viewer.touching import SOLIDS

WHOLE = Path(__file__).parents[1] / "whole_scenes"
CLOSED = ("box", "cylinder", "prism", "mesh")


def loaded(path, overrides=None):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", SceneWarning)
        return solver.load(path, overrides)


def started(scene):
    """Values of all variables at the start."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        _, model = assemble_parts(scene)
        begin = scene.experiment.start_time
        return solver.simulate(model, stop_time=begin + 1e-6, step_size=1e-6)


def places(found, run=None, row=0):
    """Function from a place of a drawing to its global coordinates in a run."""

    def at(place):
        frame = found["frames"][place["frame"]]
        own = np.array(place["at"], float)
        if not frame["variables"]:
            return own
        x = [float(run[v][row]) for v in frame["variables"]] if run else frame["start"]
        n = found["dimension"]
        origin = np.array([*x[:n], 0.0][:3])
        if len(x) == n:
            return origin + own
        if n == 2:
            c, s = np.cos(x[2]), np.sin(x[2])
            return origin + np.array(((c, -s, 0), (s, c, 0), (0, 0, 1))) @ own
        w, axis = x[3], np.array(x[4:])
        return origin + own + 2.0 * np.cross(axis, np.cross(axis, own) + w * own)

    return at


@pytest.mark.parametrize("path", ALL, ids=lambda path: path.stem)
def test_a_drawing_of_each_scene_is_json_that_begins_where_the_model_does(path):
    scene = loaded(path)
    found = drawing(scene)
    assert json.loads(json.dumps(found, allow_nan=False)) == found
    assert len(json.dumps(found)) < 60_000  # 190 contacts of a pile of discs
    assert found["frames"][0]["name"] == "ground"
    run = started(scene)
    for frame in found["frames"]:
        for name, start in zip(frame["variables"], frame["start"], strict=True):
            assert abs(run[name][0] - start) <= 1e-12
    for part in (*found["links"], *found["joints"], *found["contacts"]):
        assert all(name in run for name in part.get("force", ()))
    ends = [end for link in found["links"] for end in link["ends"]]
    for place in (*found["solids"], *ends, *(x["place"] for x in found["joints"])):
        assert 0 <= place["frame"] < len(found["frames"])
        assert len(place["at"]) == 3


@settings(max_examples=20, deadline=None)
@given(driven_systems())
def test_rods_and_springs_of_random_mechanisms_end_where_they_are_long(content):
    scene = loads(json.dumps(content), format="json")
    found, at = drawing(scene), None
    run = started(scene)
    for link in found["links"]:
        at = places(found, run)
        a, b = map(at, link["ends"])
        if (name := f"{link['name']}.length") in run:
            assert np.linalg.norm(b - a) == pytest.approx(run[name][0], abs=1e-12, rel=1e-12)
    for frame in found["frames"]:
        for name, start in zip(frame["variables"], frame["start"], strict=True):
            assert abs(run[name][0] - start) <= 1e-12


@pytest.mark.parametrize("name", ["stephenson", "double_wishbone", "watt", "chain"])
def test_rods_keep_their_lengths_along_a_run(name):
    scene = loaded(SCENES / f"{name}.toml")
    found = drawing(scene)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        _, model = assemble_parts(scene)
        run = solver.simulate(model, stop_time=0.2, step_size=0.02)
    lengths = []
    for row in (0, 5, 10):
        at = places(found, run, row)
        rods = [link for link in found["links"] if link["kind"] in ("rod", "bar")]
        assert rods
        lengths.append([np.linalg.norm(at(b) - at(a)) for a, b in (rod["ends"] for rod in rods)])
    np.testing.assert_allclose(lengths[1], lengths[0], rtol=1e-9)
    np.testing.assert_allclose(lengths[2], lengths[0], rtol=1e-9)


def test_joints_are_at_one_place_on_both_bodies_along_a_run():
    scene = loaded(SCENES / "jansen.toml")
    found = drawing(scene)
    run = started(scene)
    at = places(found, run)
    drawn = {
        name: [*joint.position, 0.0]
        for name, joint in scene.joints.items()
        if getattr(joint, "position", None) and getattr(joint, "bodies", None)
    }
    for joint in found["joints"]:
        if joint["name"] in drawn:
            wanted = [scene.values().get(str(x), x) for x in drawn[joint["name"]]]
            if all(isinstance(x, float) for x in wanted):
                np.testing.assert_allclose(at(joint["place"]), wanted, atol=1e-12)


MOVED = """
name = "moved"
[parameters]
a = 1.0
b = "2*a"
[bodies]
arm = { position = ["a", 0, 0], shape = { type = "box", size = ["b", 0.1, 0.1], density = 1 } }
[joints]
hinge = { type = "revolute", bodies = ["ground", "arm"], position = [0, 0, 0], axis = [0, 1, 0] }
"""


def test_a_parameter_that_moves_a_place_moves_the_drawing():
    scene = loads(MOVED)
    usual, moved = drawing(scene), drawing(scene, {"a": 3.0})
    assert usual["frames"][1]["start"][:3] == [1, 0, 0]
    assert moved["frames"][1]["start"][:3] == [3, 0, 0]
    assert moved["solids"][0]["size"] == [6, 0.1, 0.1]
    assert moved["joints"][0]["place"]["at"] == [-3, 0, 0]
    assert moved["joints"][0]["axis"] == [0, 1, 0]


@pytest.mark.parametrize("name", ["plane", "space", "rough"])
def test_each_contact_gives_a_solid(name):
    scene = loaded(WHOLE / f"{name}.toml")
    found = drawing(scene)
    owners = {solid["owner"] for solid in found["solids"]}
    same = {str({k: x for k, x in s.items() if k != "owner"}) for s in found["solids"]}
    assert len(same) == len(found["solids"])  # what two contacts share is there once
    kinds = {type(contact) for contact in scene.contacts.values()}
    assert kinds <= SOLIDS.keys()
    seen = {type(scene.contacts[owner]) for owner in owners if owner in scene.contacts}
    links = {link["name"] for link in found["links"]}
    seen |= {type(x) for owner, x in scene.contacts.items() if owner in links}
    shared = {"box", "corners", "cylinder"}  # these may equal another contact's
    assert {kind.type for kind in kinds - seen} <= shared
    assert {x["name"] for x in found["contacts"]} <= scene.contacts.keys()


def test_each_type_of_contact_is_known():
    types = {*solver.scene.scene.TYPES["contacts"].values()}
    assert types <= SOLIDS.keys()


@pytest.mark.parametrize("name", ["plane", "space", "rough"])
def test_faces_of_closed_solids_enclose_a_positive_volume(name):
    for solid in drawing(loaded(WHOLE / f"{name}.toml"))["solids"]:
        if solid["shape"] not in CLOSED or solid["kind"] == "surface":
            continue
        volume = sum(
            face[0] @ np.cross(face[k], face[k + 1])
            for face in faces_of(solid)
            for k in range(1, len(face) - 1)
        )
        assert volume > 0.0, solid["owner"]


LOOKS = """
[looks]
rim = { type = "wheel", on = "arm", at = [1, 0, 0], axis = [0, 1, 0], radius = 0.3, width = 0.1 }
mark = { type = "sphere", on = "ground", radius = 0.1, opacity = 0.5, colour = "#ff0000" }
[view]
direction = [1, 0, 0]
follow = "arm"
traces = ["arm"]
plots = [["arm.x", "energy.error"]]
"""


def test_looks_and_view_change_nothing_of_the_model():
    plain, dressed = loads(MOVED), loads(MOVED + LOOKS)
    assert solver.assemble(plain).file == solver.assemble(dressed).file
    found = drawing(dressed)
    looks = [solid for solid in found["solids"] if solid["kind"] == "look"]
    assert {x["owner"] for x in looks} == {"rim", "mark"}
    assert found["solids"][: len(found["solids"]) - len(looks)] == drawing(plain)["solids"]
    mark = looks[-1]
    assert (mark["frame"], mark["opacity"], mark["colour"]) == (0, 0.5, "#ff0000")
    view = found["view"]
    assert view["direction"] == [1, 0, 0]
    assert view["follow"] == {"frame": 1, "at": [0, 0, 0]}
    assert view["traces"] == [{"name": "arm", "place": {"frame": 1, "at": [0, 0, 0]}}]
    assert view["plots"] == [["arm.x", "energy.error"]]


def test_the_drawing_travels_in_the_archive_whose_page_shows_it():
    with zipfile.ZipFile(scene_fmu("four_bar")) as archive:
        text = archive.read("modelDescription.xml").decode()
        assert '<Tool name="holonom.drawing">' in text
        assert '<Drawing file="resources/drawing.json" />' in text
        found = json.loads(archive.read("resources/drawing.json"))
        assert archive.read("model.png") == picture(found)
        assert b'src="../model.png"' in archive.read("documentation/index.html")
    assert found == drawing(loaded(SCENES / "four_bar.toml"))
    assert found["format"] == 1


def test_a_surface_reaches_as_far_as_what_flies_over_it():
    trajectory = solver.simulate(SCENES / "ball_on_hills.toml")
    drawn = drawing(trajectory.model.scene)
    (hills,) = [solid for solid in drawn["solids"] if solid["shape"] == "heights"]
    for axis in "xy":
        places = trajectory[f"ball.{axis}"]
        assert hills[axis][0] < places.min()
        assert places.max() < hills[axis][-1]


def solids_of(name):
    return drawing(loaded(SCENES / f"{name}.toml"))["solids"]


def test_an_outline_that_closes_around_a_body_is_filled():
    (wheel,) = [x for x in solids_of("ratchet") if x["owner"] == "teeth"]
    assert wheel["shape"] == "prism"
    corners = np.array(wheel["corners"])
    x, y = corners.T
    assert 0.5 * np.sum(x * np.roll(y, -1) - y * np.roll(x, -1)) > 0.9 * np.pi * 0.1**2


def test_a_ball_stands_on_the_surface_that_it_touches():
    """The heights of the scene are those of its centre."""
    (green,) = [x for x in solids_of("putting_green") if x["shape"] == "heights"]
    x, y, z = (np.array(green[axis], float) for axis in "xyz")
    assert z.shape == (len(x), len(y))
    assert (x[0], y[0], x[-1], y[-1]) == (-0.5, -1.0, 4.0, 1.0)
    assert 0.022 - z[0, 0] == pytest.approx(0.02135, rel=0.02)  # more where it is steep
    assert -0.014 - z[-1, -1] == pytest.approx(0.02135, rel=0.02)


def test_what_a_look_hides_is_not_drawn_but_what_shows_through_it_is():
    assert [x["kind"] for x in solids_of("rocking_block")] == ["surface", "look"]
    assert "struts" in [x["shape"] for x in solids_of("double_wishbone")]


def test_a_point_with_much_play_is_small_in_its_hole():
    pin, hole = solids_of("mass_in_a_circle")
    assert hole["inner_radius"] - pin["radius"] == pytest.approx(1.0)
    assert pin["radius"] <= 0.05
