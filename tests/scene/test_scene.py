"""Scenes: what a file says arrives; lines are known, numbers replaceable, mistakes reported."""

import dataclasses
import json
import pickle
import sys
from pathlib import Path

import pytest

from solver.options import tolerance_of
from solver.scene import (
    Distance,
    Expr,
    PointReference,
    Scene,
    SceneError,
    evaluate,
    load,
    loads,
    parse,
)
from tests.support.mechanisms.scene_files import ALL
from tests.support.mechanisms.short_scene import SHORT

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

ROOT = Path(__file__).parents[2]


def problems_of(text, **options):
    with pytest.raises(SceneError) as caught:
        loads(text, **options)
    return caught.value.problems


@pytest.mark.parametrize("path", ALL, ids=lambda path: path.stem)
def test_every_scene_of_the_repository_is_free_of_mistakes(path):
    scene = load(path)
    assert scene.name == path.stem
    assert scene.description


def test_the_double_pendulum_arrives_as_written():
    scene = load(ROOT / "scenes" / "double_pendulum.toml")
    length = parse("length")
    assert scene.dimension == 2
    assert scene.gravity == (0.0, -9.81)
    assert scene.parameters["length"].min == 0.01
    assert scene.parameters["length"].max is None
    assert scene.points["O"].fixed
    assert scene.points["B"].position == (2 * length, 0.0)
    assert scene.points["B"].mass == parse("mass")
    assert scene.points["A"].velocity is None
    assert scene.joints["lower"] == Distance(
        points=(PointReference(point="A"), PointReference(point="B")), length=None
    )
    assert scene.solver.start == "drawn"
    assert scene.solver.step_size == 0.01
    assert (scene.experiment.stop_time, scene.experiment.step_size) == (10.0, 0.05)


def test_a_parameter_calculated_from_a_tunable_one_is_tunable():
    parameters = load(ROOT / "scenes" / "spring_pendulum.toml").parameters
    assert parameters["stiffness"].variability == "tunable"
    assert parameters["frequency"].variability == "tunable"
    assert parameters["mass"].variability == "fixed"
    assert isinstance(parameters["frequency"].value, Expr)


def test_defaults_are_filled_in():
    scene = loads(SHORT)
    assert scene.gravity == (0.0, 0.0)
    assert scene.description == ""
    assert scene.points["A"].mass == 2.0
    assert scene.solver.step_size == 0.0  # the tolerance of 1e-4 chooses
    assert tolerance_of(vars(scene.solver)) == 1e-4
    assert scene.experiment.step_size == pytest.approx(0.01)  # of a run of 1 s
    assert scene.experiment.stop_time == 1.0
    assert scene.inputs["push"].start == 0.0


@pytest.mark.parametrize("setting", ["step_size = 0.02", "order = 4"])
def test_a_step_or_an_order_chooses_equal_steps(setting):
    assert tolerance_of(vars(loads(f"{SHORT}[solver]\n{setting}").solver)) == 0.0


def test_a_tolerance_chooses_steps_whatever_order_is_asked_for():
    scene = loads(f"{SHORT}[solver]\nstep_size = 0.02\norder = 4\ntolerance = 1e-6")
    assert tolerance_of(vars(scene.solver)) == 1e-6


def test_settings_may_be_constant_expressions():
    assert loads(SHORT + '[solver]\nstep_size = "1/120"').solver.step_size == 1 / 120


def test_a_scene_holds_plain_immutable_data():
    scene = loads(SHORT)
    with pytest.raises(dataclasses.FrozenInstanceError):
        scene.points["A"].mass = 1.0
    assert pickle.loads(pickle.dumps(scene)) == scene


def test_the_place_of_ground_may_be_given_for_both_ends_or_alone():
    def scene(at):
        rod = f'stay = {{ type = "distance", points = ["ground", "A"], at = {at} }}\n'
        return loads(SHORT.replace("[inputs]", rod + "[inputs]")).joints["stay"]

    assert scene("[0, 1]") == scene("[[0, 1], [1, 0]]")
    assert scene("[0, 1]").points[0].at == (0.0, 1.0)


def test_json_says_the_same_as_toml():
    path = ROOT / "scenes" / "bifilar.toml"
    data = tomllib.loads(path.read_text(encoding="utf-8"))
    assert loads(json.dumps(data), format="json") == load(path)


def test_json_files_are_read(tmp_path):
    path = tmp_path / "short.json"
    path.write_text(json.dumps(tomllib.loads(SHORT)), encoding="utf-8")
    assert load(path) == loads(SHORT)


@pytest.mark.parametrize(
    ("text", "message", "line"),
    [
        ('{\n"name" "a"}', "JSON: ", 2),
        ("[1]", "must be a table of fields, got [1]", None),
        ('{"name": "a",\n "points": {"A": {"position": [0, 0, NaN],\n "mass": 1}}}', "finite", 2),
        ('{"name": "a",\n "name": "b"}', "given twice", 2),
        ('{"name": "a", "points": {"A":\n{"position": [0, 0, 0],\n"mas": 1}}}', "unknown field", 3),
        ('{"name": "a", "points": null}', "must be a table, got null", 1),
        ('{"name": "a",\n"gravity": null}', "must have a value, got null", 2),
        ("[" * 100_000, "nested too deeply", None),
        ('{"name": ' + "[" * 500 + "]" * 500 + "}", "nested too deeply", None),
    ],
)
def test_mistakes_in_json_are_reported_with_their_line(text, message, line):
    problems = problems_of(text, format="json", name="bad.json")
    assert any(message in problem.message and problem.line == line for problem in problems)


def test_a_byte_order_mark_and_windows_line_ends_are_accepted(tmp_path):
    path = tmp_path / "short.toml"
    path.write_bytes(b"\xef\xbb\xbf" + SHORT.replace("\n", "\r\n").encode())
    assert load(path) == loads(SHORT)


@pytest.mark.parametrize(
    ("name", "content", "message"),
    [
        ("missing.toml", None, "missing.toml: error: file not found"),
        ("scene.yaml", b"", "scene.yaml: error: unknown kind of file '.yaml'"),
        (
            "latin.toml",
            b'name = "a"\ndescription = "\xe9"\n',
            "latin.toml:2: error: not a UTF-8 text",
        ),
        ("folder.toml", "folder", "folder.toml: error: cannot be read"),
    ],
)
def test_unreadable_files_are_reported(tmp_path, monkeypatch, name, content, message):
    monkeypatch.chdir(tmp_path)
    if content == "folder":
        Path(name).mkdir()
    elif content is not None:
        Path(name).write_bytes(content)
    with pytest.raises(SceneError) as caught:
        load(name)
    assert str(caught.value).startswith(message)


def test_later_findings_name_file_and_line():
    scene = loads(SHORT, name="folder/short.toml")
    with pytest.raises(SceneError) as caught:
        scene.fail([scene.error("joints.rod", "zero length", "move A"), scene.error("x", "odd")])
    assert str(caught.value).splitlines() == [
        "folder/short.toml:10: error: joints.rod: zero length",
        '    10 | rod = { type = "distance", points = ["O", "A"] }',
        "       = help: move A",
        "folder/short.toml: error: x: odd",
    ]
    assert pickle.loads(pickle.dumps(caught.value)).problems == caught.value.problems


def test_a_scene_made_by_hand_can_report_too():
    scene = Scene(name="made")
    with pytest.raises(SceneError, match=r"^scene: error: points\.A: no mass$"):
        scene.fail([scene.error("points.A", "no mass")])


def test_rules_are_judged_with_the_default_parameters():
    text = SHORT.replace("mass = 2", 'mass = "1 - length"').replace("length = 1.0", "length = 1.5")
    (problem,) = problems_of(text)
    assert problem.message == "must be >= 0 kg, got -0.5 (= 1 - length)"
    assert evaluate(loads(text, overrides={"length": 0.5}).points["A"].mass, {"length": 0.5}) == 0.5


def test_two_hundred_mistakes_are_two_hundred_reports():
    points = "".join(f"P{i} = {{ position = [{i}, 0], mas = 1 }}\n" for i in range(200))
    text = SHORT.replace("[joints]", points + "[joints]")
    assert len(problems_of(text)) == 200
