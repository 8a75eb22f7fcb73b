"""Scenes: what a file says arrives; lines are known, numbers replaceable, mistakes reported."""

import dataclasses
import json
import math
import pickle
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from solver.scene import (
    Bar,
    Damper,
    Distance,
    Expr,
    Force,
    PointReference,
    Scene,
    SceneError,
    Spring,
    Torque,
    evaluate,
    json_schema,
    load,
    loads,
    parse,
)
from solver.scene.positions import lines_of_json, lines_of_toml
from solver.scene.report import location_of, path_of

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

ROOT = Path(__file__).parents[1]
SCENES = sorted((ROOT / "scenes").glob("*.toml"))

SHORT = """
name = "short"
dimension = 2
[parameters]
length = 1.0
[points]
O = { position = [0, 0], fixed = true }
A = { position = ["length", 0], mass = 2 }
[joints]
rod = { type = "distance", points = ["O", "A"] }
[inputs]
push = { unit = "N" }
"""


def problems_of(text, **options):
    with pytest.raises(SceneError) as caught:
        loads(text, **options)
    return caught.value.problems


@pytest.mark.parametrize("path", SCENES, ids=lambda path: path.stem)
def test_every_scene_of_the_repository_is_free_of_mistakes(path):
    scene = load(path)
    assert scene.name == path.stem
    assert scene.description


def test_the_double_pendulum_arrives_as_written():
    scene = load(ROOT / "scenes" / "double_pendulum.toml")
    length = parse("length")
    assert scene.dimension == 2
    assert scene.gravity == (0.0, -9.81)
    assert scene.parameters["length"].minimum == 0.01
    assert scene.parameters["length"].maximum is None
    assert scene.points["O"].fixed
    assert scene.points["B"].position == (2 * length, 0.0)
    assert scene.points["B"].mass == parse("mass")
    assert scene.points["A"].velocity == (0.0, 0.0)
    assert scene.joints["lower"] == Distance(
        points=(PointReference(point="A"), PointReference(point="B")), length=None
    )
    assert scene.solver.formulation == "conserving-al"
    assert scene.solver.step_size == 0.01
    assert (scene.experiment.stop_time, scene.experiment.step_size) == (10.0, 0.05)


def test_the_four_bar_arrives_as_written():
    scene = load(ROOT / "scenes" / "four_bar.toml")
    assert list(scene.bodies) == ["crank0", "crank1", "crank2", "coupler0", "coupler1"]
    assert scene.bodies["coupler0"] == Bar(points=("B0", "B1"), mass=1.0)
    assert scene.forces["motor"] == Torque(body="crank0", value=parse("drive"))
    assert scene.inputs["drive"].unit == "N.m"
    assert scene.points["B0"].mass == 0.0
    assert scene.points["B0"].velocity == (1.0, 0.0)


def test_springs_dampers_and_forces_arrive_as_written():
    forces = load(ROOT / "scenes" / "spring_pendulum.toml").forces
    ends = (PointReference(point=None, at=(0.0, 0.0, 0.0)), PointReference(point="A"))
    assert forces["spring"] == Spring(points=ends, stiffness=parse("stiffness"), free_length=0.9)
    assert forces["damper"] == Damper(points=ends, damping=parse("damping"))
    assert forces["pusher"] == Force(point="A", value=(parse("push"), 0.0, 0.0))


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
    assert scene.solver.step_size == 0.01
    assert scene.experiment.step_size == pytest.approx(0.1)
    assert scene.experiment.stop_time == 1.0
    assert scene.inputs["push"].start == 0.0


def test_the_internal_step_follows_a_shorter_communication_step():
    assert loads(SHORT + "[experiment]\nstep_size = 0.002").solver.step_size == 0.002


def test_settings_may_be_constant_expressions():
    assert loads(SHORT + '[solver]\nstep_size = "1/120"').solver.step_size == 1 / 120


def test_a_scene_holds_plain_immutable_data():
    scene = loads(SHORT)
    assert "pydantic" not in {type(part).__module__.split(".")[0] for part in parts(scene)}
    with pytest.raises(dataclasses.FrozenInstanceError):
        scene.points["A"].mass = 1.0
    assert pickle.loads(pickle.dumps(scene)) == scene


def parts(thing):
    """Everything within a scene."""
    yield thing
    if dataclasses.is_dataclass(thing):
        for field in dataclasses.fields(thing):
            yield from parts(getattr(thing, field.name))
    elif isinstance(thing, (tuple, list)):
        for item in thing:
            yield from parts(item)
    elif isinstance(thing, dict):
        for item in thing.values():
            yield from parts(item)


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
        ('{\n"name": "a",\n}', "JSON: ", 3),
        ("[1]", "must be a table of fields, got [1]", None),
        ('{"name": "a",\n "points": {"A": {"position": [0, 0, NaN],\n "mass": 1}}}', "finite", 2),
        ('{"name": "a",\n "name": "b"}', "given twice", 2),
        ('{"name": "a", "points": {"A":\n{"position": [0, 0, 0],\n"mas": 1}}}', "unknown field", 3),
        ('{"name": "a", "points": null}', "must be a table, got null", 1),
        ('{"name": "a",\n"gravity": null}', "must have a value, got null", 2),
        ("[" * 100_000, "nested too deeply", None),
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


# ------------------------------------------------------------------------------------- overrides


@pytest.mark.parametrize(
    ("name", "value", "read", "expected"),
    [
        ("length", 2.0, lambda s: s.parameters["length"].value, 2.0),
        ("length", "3", lambda s: s.parameters["length"].value, 3.0),
        ("parameters.length", 2, lambda s: s.parameters["length"].value, 2.0),
        ("points.A.mass", "2*length", lambda s: s.points["A"].mass, parse("2*length")),
        ("points.A.velocity", (0, 1), lambda s: s.points["A"].velocity, (0.0, 1.0)),
        ("points.A.position[1]", 5, lambda s: s.points["A"].position[1], 5.0),
        ("points.A.mass", np.float64(3.0), lambda s: s.points["A"].mass, 3.0),
        ("gravity", "[0, -1.62]", lambda s: s.gravity, (0.0, -1.62)),
        ("push", 4, lambda s: s.inputs["push"].start, 4.0),
        ("solver.step_size", "0.001", lambda s: s.solver.step_size, 0.001),
        ("solver.formulation", "midpoint-al", lambda s: s.solver.formulation, "midpoint-al"),
        ("solver.paired", "false", lambda s: s.solver.paired, False),
        ("experiment.stop_time", 3, lambda s: s.experiment.stop_time, 3.0),
        ("joints.rod.length", 1.0, lambda s: s.joints["rod"].length, 1.0),
        ("name", "other", lambda s: s.name, "other"),
    ],
)
def test_any_number_can_be_replaced(name, value, read, expected):
    assert read(loads(SHORT, overrides={name: value})) == expected


@pytest.mark.parametrize(
    ("name", "value", "report"),
    [
        (
            "points.A.mas",
            "2",
            "--set points.A.mas=2: error: points.A.mas: unknown field\n"
            "     = help: did you mean 'mass'?",
        ),
        (
            "points.A.mass",
            "-2",
            "--set points.A.mass=-2: error: points.A.mass: must be >= 0 kg, got -2",
        ),
        (
            "points.A.mass",
            math.nan,
            "--set points.A.mass=nan: error: points.A.mass: must be a finite number, got nan",
        ),
        (
            "points.B.mass",
            "2",
            "--set points.B.mass=2: error: points.B.mass: no such thing in the scene\n"
            "     = help: did you mean 'points.A.mass'?",
        ),
        (
            "lenght",
            2.0,
            "--set lenght=2.0: error: lenght: unknown name\n     = help: did you mean 'length'?",
        ),
        (
            "length",
            "2*",
            "--set length=2*: error: parameters.length: not an expression, column 3 of '2*'",
        ),
        (
            "points.A.position[2]",
            1,
            "--set points.A.position[2]=1: error: points.A.position[2]: "
            "no such thing in the scene\n"
            "     = help: did you mean 'points.A.position'?",
        ),
    ],
)
def test_mistakes_in_overrides_name_the_override(name, value, report):
    with pytest.raises(SceneError) as caught:
        loads(SHORT, overrides={name: value})
    assert str(caught.value) == report


def test_an_override_can_correct_a_mistake_of_the_file():
    wrong = SHORT.replace("mass = 2", "mass = -2")
    assert problems_of(wrong)
    assert loads(wrong, overrides={"points.A.mass": 2}) == loads(SHORT)


# ------------------------------------------------------------------------------ lines of the file


def paths_of(data, path=()):
    """Every path of nested data."""
    items = data.items() if isinstance(data, dict) else enumerate(data)
    for key, value in items:
        yield (*path, key), value
        if isinstance(value, (dict, list)):
            yield from paths_of(value, (*path, key))


TRICKY = """# = [ { "
name = "a # b = {" # c
a.b.c = 1
a . "b.c" = 'its'
[points]
A = { position = [0, # x ]
  [1,
  2],
 ], "q r" = 'x"' , n = { m = 1.0 } }

[ bodies . crank ]
text = \"\"\"a
"b" ] ""\"\"\"
after = '''
''' # three
next = 1979-05-27T07:32:00Z
neg = [-1_000, 0x1F, 1e-3,
  true]
[[arr]]
x = 1
[[arr]]
x = "\\"]"
[arr.sub]
y = 3
[[arr.deep]]
z = []
[[arr.deep]]
z = {}
"""


def test_every_path_of_a_toml_text_has_its_line():
    lines = lines_of_toml(TRICKY)
    data = tomllib.loads(TRICKY)
    assert set(lines) == {path for path, _ in paths_of(data)}
    text = TRICKY.split("\n")
    for path, line in lines.items():
        if isinstance(path[-1], str):
            assert path[-1] in text[line - 1]
    assert lines["points", "A", "position", 1, 1] == 8
    assert lines["bodies", "crank", "after"] == 14
    assert lines["arr", 1, "deep", 1, "z"] == 28


@pytest.mark.parametrize("path", SCENES, ids=lambda path: path.stem)
def test_every_path_of_a_scene_has_its_line(path):
    text = path.read_text(encoding="utf-8")
    assert set(lines_of_toml(text)) == {place for place, _ in paths_of(tomllib.loads(text))}


keys = st.text(st.characters(min_codepoint=32, max_codepoint=0x24F, exclude_categories=["C"]))
trees = st.recursive(
    st.none() | st.booleans() | st.floats(allow_nan=False) | keys,
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(keys, inner, max_size=3),
    max_leaves=12,
)


@given(st.dictionaries(keys, trees, max_size=4), st.sampled_from([None, 0, 2]))
def test_every_path_of_a_json_text_has_its_line(data, indent):
    text = json.dumps(data, indent=indent)
    lines, repeated = lines_of_json(text)
    assert set(lines) == {path for path, _ in paths_of(data)}
    assert not repeated
    shown = text.split("\n")
    for path, line in lines.items():
        if isinstance(path[-1], str):
            assert json.dumps(path[-1]) in shown[line - 1]


def test_locations_read_back_as_paths():
    for path in [("points", "A", "position", 0), ("points", "my point", "mass"), ("name",), ()]:
        assert path_of(location_of(path)) == path


# ------------------------------------------------------------------------------------- the schema


def test_the_published_schema_is_current():
    """To renew it: json.dumps(solver.scene.json_schema(), indent=2) into docs/scene.schema.json."""
    published = (ROOT / "docs" / "scene.schema.json").read_text(encoding="utf-8")
    assert json.loads(published) == json_schema()


def test_the_schema_lists_every_table_and_field():
    schema = json_schema()
    assert set(schema["properties"]) == {
        field.name for field in dataclasses.fields(Scene) if field.name != "source"
    }
    assert "stiffness" in schema["$defs"]["Spring"]["properties"]
    assert "null" not in json.dumps(schema)


def test_importing_the_reader_does_not_import_pydantic():
    code = "import sys, solver.scene; sys.exit('pydantic' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], cwd=ROOT, check=False).returncode == 0


def test_rules_are_judged_with_the_default_parameters():
    text = SHORT.replace("mass = 2", 'mass = "1 - length"').replace("length = 1.0", "length = 1.5")
    (problem,) = problems_of(text)
    assert problem.message == "must be >= 0 kg, got -0.5 (= 1 - length)"
    assert evaluate(loads(text, overrides={"length": 0.5}).points["A"].mass, {"length": 0.5}) == 0.5


def test_two_hundred_mistakes_are_two_hundred_reports():
    points = "".join(f"P{i} = {{ position = [{i}, 0], mas = 1 }}\n" for i in range(200))
    text = SHORT.replace("[joints]", points + "[joints]")
    assert len(problems_of(text)) == 200
