"""The closed pose is written into the text of a scene, in place; read again it needs no closing."""

from __future__ import annotations

import json
import math

import pytest

import solver
from solver.scene import SceneError
from tests.commands import run
from tests.excavator import DRAWN, SCENE, branches
from tests.straight_arm import arm


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


def test_a_pose_that_counts_from_the_drawing_otherwise_is_refused():
    text = arm("plane", [1.2, 0.8]).partition("[drivers]")[0] + (
        '[constraints]\nheld = { value = "shoulder.angle - 0.2" }\n'
    )
    with pytest.raises(SceneError, match=r"read again, 'upper' moves by 0\.0998 m"):
        solver.close(solver.loads(text))


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
