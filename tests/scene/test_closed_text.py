"""The closed pose is written into the text of a scene, in place; read again it needs no closing."""

from __future__ import annotations

import json
import math
from dataclasses import replace

import pytest

import solver
from solver.closed_text import files_from
from solver.scene import SceneError, Source
from solver.scene.rewriting import tomllib
from tests.support.fmus.commands import run
from tests.support.fmus.fmu_instance import SCENES
from tests.support.mechanisms.excavator import DRAWN, SCENE, branches
from tests.support.mechanisms.straight_arm import arm


def start(text: str, **reading) -> solver.Integrator:
    integrator = solver.Integrator(solver.assemble(solver.loads(text, **reading)))
    integrator.initialise()  # without a log a remark would be a warning, and fail
    return integrator


def unassembled(text: str) -> str:
    return text.replace("assemble = true", "assemble = false")


def test_a_closed_text_is_closed_without_assembling_it_and_keeps_all_else():
    text = SCENE.replace("mass = 800", "mass = 800  # with oil")
    closing = solver.close(solver.loads(text))
    again = start(unassembled(closing.text))
    assert float(again["constraint.position"]) < 1e-15
    assert float(again["boom.angle"]) == pytest.approx(branches(0.5, 0.7, 0.5)[DRAWN][0], abs=1e-12)
    kept = [line for line in text.splitlines() if not line.startswith(("position", "orientation"))]
    assert [line for line in closing.text.splitlines() if line in kept] == kept
    assert 'bodies.boom.orientation: numbers replace "30*pi/180"' in closing.remarks
    assert "position = [0, 0]\norientation = 0.161" in closing.text  # the boom only turned
    assert solver.close(solver.loads(closing.text)).text == closing.text


def test_what_moved_and_how_is_told():
    closing = solver.close(solver.loads(arm("plane", [1.2, 0.8])))
    bend = math.acos(math.hypot(1.2, 0.8) / 2.0)
    angles = [math.atan2(0.8, 1.2) + sign * bend for sign in (-1.0, 1.0)]
    way = math.hypot(0.5 * math.cos(angles[0]) - 0.5, 0.5 * math.sin(angles[0]))
    assert closing.moved["upper"] == pytest.approx((way, angles[0]))
    assert closing.moved["lower"][1] == pytest.approx(angles[1])
    assert (closing.method, closing.freedoms, closing.redundant) == (
        "on a path from the drawing",
        0,
        (),
    )
    assert closing.others


HINGES = """
name = "hinges"  # the elbow's place and axis are of the drawing
[parameters]
turn = 0.3
[bodies.upper]
position = [0.5, 0, 0]
orientation = { axis = [0, 1, 0], angle = 0 }
mass = 1
inertia = [0.1, 0.1, 0.1]
points = { tip = [0.5, 0, 0] }
[bodies.lower]
position = [1.5, 0, 0]
mass = 1
inertia = [0.1, 0.1, 0.1]
points = { tip = [0.5, 0, 0] }
[joints]
shoulder = { type = "spherical", bodies = ["ground", "upper"], position = [0, 0, 0] }
elbow = { type = "revolute", bodies = ["upper", "lower"], position = [1, 0, 0], axis = [0, 0, 2] }
[forces]
rope = { type = "spring", points = ["ground", "lower"], at = [1.2, 0.1, 0], stiffness = 10, free_length = 0 }
[drivers]
hand = { type = "position", point = "lower.tip", value = [1.2, 0.5, "0.6 + 0.1*t"] }
[solver]
assemble = true
"""  # noqa: E501


def test_places_and_axes_of_the_drawing_go_with_their_bodies():
    closing = solver.close(solver.loads(HINGES))
    first, again = start_silent(HINGES), start(unassembled(closing.text))
    for name in ("upper", "lower", "lower.tip"):
        for axis in "xyz":
            value = float(first[f"{name}.{axis}"])
            assert float(again[f"{name}.{axis}"]) == pytest.approx(value, abs=1e-12)
    assert float(again["constraint.velocity"]) < 1e-9
    assert float(again["lower.tip.vz"]) == pytest.approx(0.1, abs=1e-9)
    for run_ in (first, again):
        for step in range(20):
            run_.advance(0.01 * step, 0.01)
    for axis in "xyz":
        assert float(again[f"upper.{axis}"]) == pytest.approx(
            float(first[f"upper.{axis}"]), abs=1e-7
        )


def start_silent(text: str) -> solver.Integrator:
    integrator = solver.Integrator(solver.assemble(solver.loads(text)), log=lambda _: None)
    integrator.initialise()
    return integrator


def test_a_scene_in_json_is_closed_alike():
    data = {
        "name": "arm", "dimension": 2,
        "points": {
            "O": {"position": [0, 0], "fixed": True}, "A": {"position": [0.9, 0.1], "mass": 1},
        },
        "joints": {"rod": {"type": "distance", "points": ["O", "A"], "length": 1}},
        "solver": {"assemble": True},
    }  # fmt: skip
    text = json.dumps(data)
    closed = json.loads(solver.close(solver.loads(text, format="json")).text)
    size = math.hypot(0.9, 0.1)
    assert closed["points"]["A"]["position"] == pytest.approx([0.9 / size, 0.1 / size])
    data["points"]["A"]["position"] = closed["points"]["A"]["position"]
    assert closed == data


def test_drivers_and_stops_of_joints_count_from_the_new_drawing():
    text = arm("plane", [1.2, 0.8])
    closing = solver.close(solver.loads(text))
    assert any("joints.elbow: its angle counts from the new drawing" in x for x in closing.remarks)
    text = text.partition("[drivers]")[0] + (
        '[drivers]\nmotor = { type = "angle", joint = "shoulder", value = "0.2 + 3*t" }\n'
        '[contacts]\nend = { type = "stop", joint = "elbow", max = 1, restitution = 0 }\n'
    )
    closing = solver.close(solver.loads(text))
    assert 'value = "(0.2 + 3*t) - 0.2' in closing.text
    elbow = closing.moved["lower"][1] - closing.moved["upper"][1]
    limit = float(closing.text.partition("max = ")[2].partition(",")[0])
    assert limit == pytest.approx(1.0 - elbow, abs=1e-12)
    again = start(closing.text)
    again.advance(0.0, 0.1)
    assert float(again["upper.angle"]) == pytest.approx(0.5, abs=1e-9)


@pytest.mark.parametrize(
    ("written", "counted"),
    [
        ("'0.2 + 0*t'", '"(0.2 + 0*t) - 0.2'),
        ('"""0.2 + 0*t"""', '"(0.2 + 0*t) - 0.2'),
        ("2e-1", ""),
        ("0x1", ""),
    ],
)
def test_a_driver_in_any_notation_of_toml_counts_from_the_new_drawing(written, counted):
    text = arm("plane", [1.2, 0.8]).partition("[drivers]")[0] + (
        f'[drivers]\nmotor = {{ type = "angle", joint = "shoulder", value = {written} }}\n'
        "[solver]\nassemble = true\n"
    )
    closed = solver.close(solver.loads(text)).text
    assert f"value = {counted}" in closed
    angle = 1.0 if written == "0x1" else 0.2
    assert float(start(closed)["upper.angle"]) == pytest.approx(angle, abs=1e-9)


def test_new_fields_stand_beside_the_position_whatever_the_name_of_the_part():
    head, _, rest = arm("plane", [1.2, 0.8]).replace("upper", "position1").partition("[bodies]\n")
    _, _, rest = rest.partition("[joints]")
    dotted = "".join(
        f"{name}.{field}\n"
        for name, fields in (("position1", "position = [0.5, 0]"), ("lower", "position = [1.5, 0]"))
        for field in (fields, "mass = 1", "inertia = 0.1",
                      "points = { root = [-0.5, 0], tip = [0.5, 0] }")
    )  # fmt: skip
    closed = solver.close(solver.loads(f"{head}[bodies]\n{dotted}[joints]{rest}")).text
    assert "\nposition1.orientation = " in closed


LOADED = """
[constraints]
held = { value = "shoulder.angle - 0.2" }
[profiles]
law = { x = [-4, 0, 4], y = [-2, 0, 3] }
[forces]
coil = { type = "torsion_spring", joint = "shoulder", stiffness = 3 }
leaf = { type = "torsion_spring", joint = "elbow", stiffness = 2, free_angle = "0.1 + 0.1*t" }
motor = { type = "joint_torque", joint = "elbow", value = "law(-elbow.angle) - 0.1*elbow . angle*shoulder.angle" }
well = { type = "potential", value = "3*(1 - cos(elbow.angle)) + upper.y" }
push = { type = "force", point = "lower", value = ["2*sin(shoulder.angle)", 1, ] }
rope = { type = "spring", points = ["ground", "lower.tip"], at = [1, 1], stiffness = 4 }
[outputs]
bend = { value = "elbow.angle", description = "elbow.angle" }
[solver]
assemble = true
tolerance = 1e-9
"""  # noqa: E501


def test_all_that_reads_a_joint_means_what_it_did():
    """The closed scene moves as the drawn one, which the solver closes, does."""
    text = arm("plane", [1.2, 0.8]).partition("[drivers]")[0] + LOADED
    closing = solver.close(solver.loads(text))
    before, after = start_silent(text), start(closing.text)
    turns = {name: closing.moved[name][1] for name in ("upper", "lower")}
    assert turns["upper"] == pytest.approx(0.2, abs=1e-12)
    for step in range(20):
        for name in ("upper.angle", "lower.x", "lower.y", "lower.angle", "bend"):
            assert float(after[name]) == pytest.approx(float(before[name]), abs=1e-7)
        for integrator in (before, after):
            integrator.advance(0.05 * step, 0.05)
    assert abs(float(after["lower.angle"]) - turns["lower"]) > 0.1  # it has moved
    remarks = "\n".join(closing.remarks)
    for said in (
        "forces.coil.free_angle: -0.2 is added, since shoulder.angle is 0.2 rad less in the new",
        'constraints.held.value: "(shoulder.angle + 0.2) - 0.2" replaces "shoulder.angle - 0.2"',
        "joints.shoulder: its angle counts from the new drawing, in which it is 0.2 rad less",
        "forces.rope.free_length: 1.4142135623",
    ):
        assert said in remarks
    assert 'forces.push.value: "2*sin((shoulder.angle + 0.2))" replaces "2*sin(shou' in remarks
    for name in ("leaf", "motor", "well"):
        assert f"forces.{name}." in remarks
    assert "outputs.bend.value: " in remarks
    assert 'description = "elbow.angle"' in closing.text
    again = solver.close(solver.loads(closing.text))
    assert (again.text, again.remarks) == (closing.text, ())


GEARED = """
name = "geared"
dimension = 2
[bodies]
cam = { position = [0, 0], orientation = 0, mass = 1, inertia = 1, points = { pin = [0.5, 0] } }
wheel = { position = [2, 0], mass = 1, inertia = 1, points = { rim = [0.3, 0] } }
slide = { position = [0, 1.5], mass = 1, inertia = 1 }
[joints]
shaft = { type = "revolute", bodies = ["ground", "cam"], position = [0, 0] }
axle = { type = "revolute", bodies = ["ground", "wheel"], position = [2, 0] }
way = { type = "prismatic", bodies = ["ground", "slide"], axis = [0, 1] }
teeth = { type = "gear", joints = ["shaft", "axle"], ratio = -1, backlash = 0.2 }
[profiles]
lobe = { x = [0, "pi", "2*pi"], y = [1, 1.4, 1], periodic = true }
[contacts]
lift = { type = "cam", joint = "shaft", follower = "slide", profile = "lobe" }
[constraints]
turn = { value = "cam.pin.y - 0.5*sin(0.05)" }
[solver]
assemble = true
"""


def test_what_cannot_be_written_otherwise_is_told_with_its_amount():
    remarks = "\n".join(solver.close(solver.loads(GEARED)).remarks)
    assert "contacts.lift: the angle of its profile counts from +x of the new drawing" in remarks
    assert "'cam' has turned by 0.05 rad; add 0.05 to x in profiles.lobe" in remarks
    assert "joints.teeth: its play lies about the new drawing" in remarks
    assert "turned by 0.05 rad within the old play" in remarks


def test_numbers_have_no_digits_of_round_off():
    text = """
name = "bars"
dimension = 2
[points]
O = { position = [0, 0], fixed = true }
A = { position = [0.31, 0.41], mass = 1 }
B = { position = [0.8, 0.39], mass = 1 }
[constraints]
x = { value = "A.x - 0.3" }
y = { value = "A.y - 0.4" }
z = { value = "B.y - A.y + 0.4" }
w = { value = "B.x - A.x - 0.6" }
[solver]
assemble = true
"""
    closed = solver.close(solver.loads(text)).text
    assert "A = { position = [0.3, 0.4], mass" in closed
    assert "B = { position = [0.9, 0.0], mass" in closed
    assert float(start(unassembled(closed))["constraint.position"]) < 1e-15


@pytest.mark.parametrize("end", ["\r\n", "\n"])
def test_lines_end_as_those_of_the_source(tmp_path, end):
    drawn, closed = tmp_path / "arm.toml", tmp_path / "closed.toml"
    drawn.write_bytes(arm("plane", [1.2, 0.8]).replace("\n", end).encode())
    closing = solver.close(drawn, closed)
    assert closed.read_bytes() == closing.text.encode()
    assert closing.text.count("\n") == closing.text.count(end)
    assert solver.close(closed).text == closing.text


def test_files_of_a_scene_are_found_from_another_folder(tmp_path):
    (tmp_path / "from").mkdir()
    (tmp_path / "from" / "data").mkdir()
    (tmp_path / "from" / "data" / "push.csv").write_text("0,0\n1,2\n2,1\n")
    text = arm("plane", [1.2, 0.8]) + (
        '[profiles]\npush = { file = "data/push.csv" }\n'
        '[forces]\nf = { type = "force", point = "lower", value = ["push(t)", 0] }\n'
    )
    drawn = tmp_path / "from" / "arm.toml"
    drawn.write_text(text)
    inside, outside = tmp_path / "from" / "closed.toml", tmp_path / "to" / "closed.toml"
    assert 'file = "data/push.csv"' in solver.close(drawn, inside).text
    closing = solver.close(drawn, outside)
    assert 'file = "../from/data/push.csv"' in outside.read_text()
    assert "profiles.push.file: '../from/data/push.csv' from its folder" in closing.remarks
    assert solver.load(outside).profiles["push"] == replace(
        solver.load(drawn).profiles["push"], file=solver.load(outside).profiles["push"].file
    )
    assert solver.close(outside).text == outside.read_text()


def test_all_files_that_a_scene_names_are_found(tmp_path):
    scene = solver.load(SCENES / "die_in_a_bowl.toml")
    found = files_from(scene, str(tmp_path))
    assert {path[2] for path in found} == {"file", "corner_file"}
    assert all((tmp_path / str(name)).is_file() for name in found.values())


def test_a_closed_scene_stays_as_it_is():
    """Also where velocities are round-off: its cross does not rise."""
    text = (SCENES / "cardan_shaft.toml").read_text()
    assert solver.close(solver.loads(text)).text == text


def test_a_closed_text_has_the_values_that_the_scene_was_loaded_with():
    values = {"boom_stroke": 0.9, "bodies.stick.mass": 777, "gravity[1]": -1.62,
              "bodies.bucket.points.tooth[0]": 1.5, "solver.tolerance": 1e-7}  # fmt: skip
    closing = solver.close(solver.loads(SCENE, overrides=values))
    again = solver.loads(closing.text)
    assert again.inputs["boom_stroke"].start == 0.9
    assert (again.bodies["stick"].mass, again.gravity) == (777, (0.0, -1.62))
    assert again.solver.tolerance == 1e-7
    closed = start(unassembled(closing.text))
    assert float(closed["boom.angle"]) == pytest.approx(
        branches(0.9, 0.7, 0.5)[DRAWN][0], abs=1e-12
    )
    assert "tooth = [1.5, 0]" in closing.text


def test_a_new_field_of_a_new_table_is_written():
    text = arm("plane", [1.2, 0.8]).replace("[solver]\nassemble = true\n", "")
    closing = solver.close(solver.loads(text, overrides={"solver.assemble": True}))
    assert closing.text.endswith("[solver]\nassemble = true\n")
    assert solver.loads(closing.text).solver.assemble
    text = json.dumps(tomllib.loads(text))
    scene = solver.loads(text, format="json", overrides={"solver.assemble": True})
    with pytest.raises(SceneError, match="of a table that the text lacks"):
        solver.close(scene)


@pytest.mark.parametrize(
    ("value", "place"),
    [({"lower.points.root": [-0.4, 0.0]}, 1.4), ({"upper.points.tip": [0.7, 0.0]}, 1.7)],
)
def test_a_joint_on_a_named_point_goes_with_it(value, place):
    """The elbow is on both; its place in the file is [1, 0]."""
    text = arm("plane", [1.2, 0.8]).partition("[drivers]")[0] + "[solver]\nassemble = true\n"
    overrides = {f"bodies.{name}": x for name, x in value.items()}
    scene = solver.loads(text, overrides={**overrides, "bodies.lower.angular_velocity": 1.0})
    again = start(unassembled(solver.close(scene).text))
    assert float(again["lower.x"]) == pytest.approx(place, abs=1e-12)
    again.advance(0.0, 1.0)
    assert abs(float(again["lower.angle"])) > 0.1
    for axis in "xy":  # the hinge is in both points
        tip, root = (float(again[f"{name}.{axis}"]) for name in ("upper.tip", "lower.root"))
        assert tip == pytest.approx(root, abs=1e-9)


def test_a_scene_without_a_text_is_refused_in_words():
    scene = replace(solver.loads(arm("plane", [1.2, 0.8])), source=Source())
    with pytest.raises(solver.OptionError, match="the scene 'arm' has no text"):
        solver.close(scene)


def test_an_orientation_of_several_lines_is_refused():
    table = "[bodies.upper.orientation]\naxis = [0, 1, 0]\nangle = 0\n[bodies.lower]"
    line = "orientation = { axis = [0, 1, 0], angle = 0 }\n"
    text = HINGES.replace(line, "").replace("[bodies.lower]", table)
    with pytest.raises(SceneError, match=r"bodies.upper.orientation: is written as a table"):
        solver.close(solver.loads(text))


def test_the_command_writes_the_scene_and_says_what_moved(tmp_path, capsys):
    drawn, closed = tmp_path / "arm.toml", tmp_path / "closed.toml"
    drawn.write_text(arm("plane", [1.2, 0.8]))
    code, out, _ = run(capsys, "assemble", drawn, "-o", closed)
    assert code == 0
    assert "on a path from the drawing" in out
    assert "0.51336" in out
    assert "1.3534" in out
    assert float(start(unassembled(closed.read_text()))["constraint.position"]) < 1e-15
    code, out, _ = run(capsys, "assemble", drawn, "--json")
    assert (code, json.loads(out)["freedoms"]) == (0, 0)
    code, _, error = run(capsys, "assemble", drawn, "-o", tmp_path / "closed.json")
    assert (code, (tmp_path / "closed.json").exists()) == (2, False)
    assert "closed.json: the name must end in .toml" in error
    code, out, _ = run(capsys, "assemble", drawn, "-o", closed, "--set", "bodies.upper.mass=7")
    assert (code, "mass = 7" in closed.read_text()) == (0, True)
    code, _, error = run(capsys, "assemble", drawn, "--set", "mass=7")
    assert (code, "--set mass=7: error: mass: unknown name" in error) == (2, True)
    for name in ("closed.fmu", "closed"):
        code, _, error = run(capsys, "assemble", drawn, "-o", tmp_path / name)
        assert (code, "the name must end in .toml" in error) == (2, True)
    drawn.write_text(arm("plane", [2.5, 0.0]))
    code, _, error = run(capsys, "assemble", drawn, "-o", closed)
    assert code == 2
    assert "driver 'hand' (0.167 m)" in error


ARM_OVER_A_FLOOR = """
name = "arm"
dimension = 2
[points]
O = { position = [0, 1], fixed = true }
[bodies]
a = { position = [0.5, 1], orientation = 0.4, mass = 1, inertia = 0.1, points = { l = [-0.5, 0] } }
[joints]
h = { type = "revolute", points = ["O", "a.l"] }
[forces]
s = { type = "spring", points = ["ground", "a"], at = [[0.4, 0.5], [0.4, 1.1]], stiffness = 1 }
[contacts]
[contacts.floor]
type = "corners"
body = "a"
corners = [[-0.5, 0], [0.5, 0]]
axis = [0, 1]
position = [0, 0.5]
[solver]
assemble = true
"""


def test_both_ends_of_a_spring_and_the_floor_stay_where_they_are_fixed():
    """The floor and the lower end of the spring are the ground's, its upper end is the arm's."""
    closed = solver.close(solver.loads(ARM_OVER_A_FLOOR)).text
    before, after = (start_silent(text) for text in (ARM_OVER_A_FLOOR, unassembled(closed)))
    for name in ("s.length", "floor.gap"):
        assert float(after[name]) == pytest.approx(float(before[name]), abs=1e-12)
    assert "at = [[0.4, 0.5], [" in closed
    assert "position = [0, 0.5]" in closed


def test_instruments_go_with_the_bodies_that_carry_them():
    text = """
        name = "mast"
        dimension = 2
        [points]
        O = { position = [0, 0], fixed = true }
        [bodies.arm]
        position = [0.1, 0.05]
        orientation = 0.1
        mass = 1
        inertia = 1
        points = { end = [0, 0], tip = [1, 0] }
        [joints]
        pin = { type = "revolute", points = ["O", "arm.end"] }
        rod = { type = "distance", points = ["ground", "arm.tip"], at = [1, 3], length = 3 }
        [sensors]
        imu = { type = "imu", body = "arm", at = [0.6, 0.2], orientation = 0.2 }
        way = { type = "relative", points = ["O", "arm"], at = [0.6, 0.2] }
        [solver]
        assemble = true
        """
    closed = solver.close(solver.loads(text)).text
    (x, y), old = (tomllib.loads(closed)["sensors"]["imu"]["at"], (0.6 - 0.1, 0.2 - 0.05))
    c, s = math.cos(0.1), math.sin(0.1)  # the arm comes to lie along x, from the origin
    assert (x, y) == pytest.approx((c * old[0] + s * old[1], c * old[1] - s * old[0]), abs=1e-12)
    assert float(start(unassembled(closed))["way.distance"]) == pytest.approx(math.hypot(x, y))
