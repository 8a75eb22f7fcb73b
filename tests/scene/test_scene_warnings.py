"""What is legal in a scene and seldom meant is told: once, with its line, by every command."""

import json
import warnings
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import build_fmu
from solver import SceneError, SceneWarning, load, loads, simulate
from tests.support.fmus.commands import run
from tests.support.mechanisms.scene_files import ALL

ROOT = Path(__file__).parents[2]
GOOD = [*ALL, *ROOT.glob("examples/*.toml")]

SWING = """
name = "swing"
dimension = 2
gravity = [0, -9.81]
[parameters]
mass = 1.0
spare = 2.0
[points]
O = { position = [0, 0], fixed = true }
A = { position = [1, 0], mass = "mass" }
[joints]
rod = { type = "distance", points = ["O", "A"] }
[experiment]
stop_time = 0.02
step_size = 0.01
"""
SPARE = """swing.toml:7: warning: parameters.spare: nothing depends on it
    7 | spare = 2.0
      = help: use it in an expression, or leave it out
"""


def told(text, **overrides):
    """Location and message of each warning of a scene."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", SceneWarning)
        scene = loads(text, overrides=overrides)
    assert all(problem.severity == "warning" and problem.help for problem in scene.warnings)
    return [(problem.location, problem.message) for problem in scene.warnings]


@pytest.mark.parametrize("path", GOOD, ids=lambda path: path.stem)
def test_no_scene_of_ours_is_told_anything(path):
    assert load(path).warnings == ()


def test_a_tolerance_of_the_experiment_alone_has_no_effect_and_that_is_told():
    alone = SWING.replace("spare = 2.0\n", "") + "tolerance = 1e-6\n"
    message = "has no effect on steps of fixed length, which this scene has"
    assert told(alone, **{"solver.step_size": 0.01}) == [("experiment.tolerance", message)]
    assert told(alone) == []  # an importer that gets it asks for less error than 1e-4
    assert told(alone, **{"solver.tolerance": 1e-5}) == []
    message = "has no effect: the steps of this scene are for 1e-08, which is tighter"
    assert told(alone, **{"solver.tolerance": 1e-8}) == [("experiment.tolerance", message)]


# -------------------------------------------------------------------------------- who is told


def test_python_warns_at_the_line_that_loads(tmp_path):
    path = tmp_path / "swing.toml"
    path.write_text(SWING)
    for read in (load, lambda path: loads(path.read_text(), name=str(path)), simulate):
        with pytest.warns(SceneWarning) as caught:
            read(path)
        assert [str(each.message) for each in caught] == [f"{path.parent}/{SPARE}".rstrip()]
    assert caught[0].category is SceneWarning


@pytest.mark.parametrize(
    "command", [("build",), ("simulate",), ("check",), ("info",), ("info", "--equilibrium")]
)
def test_every_command_tells_it_once_on_stderr_and_in_its_document(
    capsys, tmp_path, monkeypatch, command
):
    monkeypatch.chdir(tmp_path)
    Path("swing.toml").write_text(SWING)
    for json_too in ((), ("--json",)):
        code, out, err = run(capsys, command[0], "swing.toml", *command[1:], *json_too)
        assert code == 0
        assert err.count(SPARE) == err.count("warning:") == 1
    assert json.loads(out)["warnings"] == [SPARE.rstrip()]
    Path("swing.toml").write_text(SWING.replace("spare = 2.0\n", ""))
    code, out, err = run(capsys, command[0], "swing.toml", *command[1:], "--json")
    assert (json.loads(out)["warnings"], err.count("warning:")) == ([], 0)


@pytest.mark.parametrize("engine", ["serial", "processes:2"])
def test_so_do_studies_which_read_the_scene_many_times(capsys, tmp_path, monkeypatch, engine):
    monkeypatch.chdir(tmp_path)
    Path("swing.toml").write_text(SWING)
    many = ("--grid", "mass=1,2,3", "--engine", engine, "--json")
    for command in ("variants", "sweep"):
        code, out, err = run(capsys, command, "swing.toml", *many)
        assert code == 0
        assert err.count(SPARE) == err.count("warning:") == 1
        assert json.loads(out)["warnings"] == [SPARE.rstrip()]


def test_the_functions_of_build_fmu_warn_as_python_does(tmp_path):
    path = tmp_path / "swing.toml"
    path.write_text(SWING)
    for call in (
        lambda: build_fmu.build(path, tmp_path),
        lambda: build_fmu.variants(path, tmp_path / "many", grid={"mass": [1, 2]}, engine="serial"),
        lambda: build_fmu.sweep(path, grid={"mass": [1, 2]}, engine="serial"),
    ):
        with pytest.warns(SceneWarning, match="parameters.spare") as caught:
            call()
        assert len(caught) == 1


def test_a_scene_with_mistakes_has_these_alone():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        with pytest.raises(SceneError) as caught:
            loads(SWING.replace('"mass"', "-1.0"))
    (problem,) = caught.value.problems
    assert (problem.location, problem.severity) == ("points.A.mass", "error")


# ------------------------------------------------------------------------------- what is told

UNUSED = "nothing depends on it"


def test_a_parameter_or_input_is_used_wherever_an_expression_names_it():
    text = SWING.replace("spare = 2.0", "spare = 2.0\n[inputs]\npush = {}")
    assert told(text) == [("parameters.spare", UNUSED), ("inputs.push", UNUSED)]
    for uses in (
        '[outputs]\nx = { value = "spare*push" }',
        '[forces]\nf = { type = "force", point = "A", value = ["push", "spare"] }',
        '[constraints]\nc = { velocity = "A.vx*spare + 0*push" }',
    ):
        assert told(text + uses) == []
    again = text.replace("[inputs]", 'twice = "2*spare"\n[inputs]')  # a result, which is shown
    assert told(again) == [("inputs.push", UNUSED)]


def test_a_setting_of_contacts_has_no_effect_without_any():
    text = SWING.replace("spare = 2.0\n", "") + "[solver]\nrest_speed = 1e-3\n"
    assert told(text) == [("solver.rest_speed", "has no effect: nothing touches or rubs")]
    stop = '[contacts]\nrope = { type = "stop", points = ["O", "A"], max = 2 }\n'
    assert told(text + stop) == []


@pytest.mark.parametrize(
    "given", ['method = "fastest"', "longest_step = 0.1", "absolute_tolerance = 1e-3"]
)
def test_a_setting_of_chosen_steps_has_no_effect_on_equal_ones(given):
    text = SWING.replace("spare = 2.0\n", "") + f"[solver]\n{given}\n"
    message = "has no effect on steps of fixed length, which this scene has"
    for equal in ({"solver.step_size": 0.01}, {"solver.order": 4}):
        assert told(text, **equal) == [(f"solver.{given.split()[0]}", message)]
        assert told(text, **equal | {"solver.tolerance": 1e-6, "solver.order": 8}) == []
    assert told(text) == []


def test_explicit_steps_of_an_order_that_has_none_are_told():
    text = SWING.replace("spare = 2.0\n", "") + '[solver]\nmethod = "fastest"\ntolerance = 1e-6\n'
    message = "has no effect: no step of order 4 is explicit"
    for order, expected in ((0, []), (4, [("solver.method", message)]), (8, [])):
        assert told(text, **{"solver.order": order}) == expected


def test_an_override_can_take_away_the_last_use_of_a_parameter():
    assert told(SWING, **{"points.A.mass": 3.0}) == [
        ("parameters.mass", UNUSED), ("parameters.spare", UNUSED)
    ]  # fmt: skip


DRIVEN = """
name = "driven"
dimension = 2
[inputs]
u = { start = 1.0%s }
[points]
O = { position = [0, 0], fixed = true }
A = { position = [1, 0], mass = 1.0 }
[bodies]
b = { position = [0, 1], mass = 1.0, inertia = 0.1 }
[joints]
hinge = { type = "revolute", bodies = ["ground", "b"], position = [0, 1] }
slide = { type = "prismatic", bodies = ["ground", "b"], axis = [1, 0] }
%s
"""


@pytest.mark.parametrize(
    ("part", "jumps"),
    [
        ('[drivers]\nd = { type = "position", point = "A", value = ["u", 0] }', "d.value[0]"),
        ('[drivers]\nd = { type = "distance", points = ["O", "A"], value = "u" }', "d.value"),
        ('[drivers]\nd = { type = "angle", joint = "hinge", value = "2*u*t" }', "d.value"),
        ('[drivers]\nd = { type = "displacement", joint = "slide", value = "u" }', "d.value"),
        ('[constraints]\nd = { value = "A.x - u" }', "d.value"),
        ('[constraints]\nd = { velocity = "A.vx - u*A.vy" }', ""),
        ('[forces]\nd = { type = "force", point = "A", value = ["u", 0] }', ""),
    ],
)
def test_a_held_input_that_says_where_something_is_jumps(part, jumps):
    table = part[1 : part.index("]")]
    message = f"is held in each communication step, so that {table}.{jumps} jumps"
    for given_as in ("", ', interpolation = "hold"'):
        assert told(DRIVEN % (given_as, part)) == [("inputs.u", message)] * bool(jumps)
    assert told(DRIVEN % (', interpolation = "ramp"', part)) == []


@pytest.mark.parametrize("follows", ["u + w", "u + 2*w*t"])
def test_a_tunable_parameter_in_a_driver_would_make_it_jump(follows):
    driver = f'[drivers]\nd = {{ type = "angle", joint = "hinge", value = "{follows}" }}'
    text = DRIVEN % (', interpolation = "ramp"', driver)
    for variability, is_told in (("tunable", True), ("fixed", False)):
        parameter = f'[parameters]\nw = {{ value = 0.0, variability = "{variability}" }}\n'
        message = "may change during a run, and drivers.d.value would jump then"
        assert told(text + "\n" + parameter) == [("parameters.w", message)] * is_told


FIELDS = {"fixed": "", "spherical": "position = [0, 0, 0.3], "}


def welded(pairs, also=()):
    """Scene of bodies, by numbers from 1, and fixed joints of these pairs; 0 is the ground."""
    names = ["ground", *(f"b{i}" for i in range(1, 7))]
    text = 'name = "welds"\n[bodies]\n' + "".join(
        f"{name} = {{ position = [{i}, 0, 0], mass = 1, inertia = [1, 1, 1] }}\n"
        for i, name in enumerate(names[1:])
    )
    text += "[joints]\n"
    for i, (a, b, word) in enumerate([*((a, b, "fixed") for a, b in pairs), *also]):
        fields = FIELDS.get(word, "position = [0, 0, 0.3], axis = [0, 0, 1], ")
        text += f'j{i} = {{ {fields}type = "{word}", bodies = ["{names[a]}", "{names[b]}"] }}\n'
    return text


@given(st.data())
def test_a_weld_that_closes_a_loop_of_welds_is_told(data):
    """Welds that join everything without a loop are a tree; one more joint in it is redundant."""
    order = data.draw(st.permutations(range(7)))
    tree = [(order[data.draw(st.integers(0, i - 1))], order[i]) for i in range(1, 7)]
    assert told(welded(tree)) == []
    a, b = data.draw(st.lists(st.integers(0, 6), min_size=2, max_size=2, unique=True))
    place = data.draw(st.integers(0, 6))
    assert len(told(welded([*tree[:place], (a, b), *tree[place:]]))) == 1
    kind = data.draw(st.sampled_from(["revolute", "prismatic", "cylindrical", "spherical"]))
    (found,) = told(welded(tree, also=[(a, b, kind)]))
    assert found == (
        "joints.j6",
        "fixed joints hold these bodies together already, so that it is redundant",
    )
    assert told(welded(tree[:-1], also=[(*tree[-1], kind)])) == []


FREE = 'name = "x"\n[points]\n%s\n[bodies.b]\nmass = 1\ninertia = [1, 1, 1]\nposition = %s\n'


@pytest.mark.parametrize(
    ("points", "position", "suspicious"),
    [
        ("", "[500, 0, 0]", True),
        ("A = { position = [120, 35, 0], mass = 1 }", "[250, 0, 20]", True),  # drawn in mm
        ("A = { position = [0.2, 0, 0], mass = 1 }", "[300, 0, 0]", True),  # one of them is
        ("A = { position = [0.2, 0, 0], mass = 1 }", "[30, 2, 0]", False),  # a crane
        ("A = { position = [60, 0.5, 0], mass = 1 }", "[1, 0, 120]", False),  # a wind turbine
        ("", '["500", 0, 0]', False),
        ("", "[1e-3, 0, 0]", False),
    ],
)
def test_lengths_that_look_like_millimetres_are_told(points, position, suspicious):
    found = told(FREE % (points, position))
    assert bool(found) == suspicious
    if found:
        ((location, message),) = found
        assert location == "bodies.b.position[0]"
        assert message.endswith("m: all lengths of a scene are in metres")


def test_a_parameter_in_metres_says_that_metres_are_meant():
    text = FREE % ("", '["span", 0, 0]') + '[parameters]\nspan = { value = 500, unit = "m" }'
    assert told(text) == []


def test_planets_are_far_apart():
    text = FREE % ("A = { position = [1e9, 0, 0], mass = 1e24 }", "[0, 0, 0]")
    assert len(told(text)) == 1
    assert told(text + '[forces]\ng = { type = "gravitation", points = ["A", "b"] }') == []


PLANE = 'name = "x"\ndimension = 2\n%s[bodies.b]\nmass = 1\ninertia = 1\nposition = [0, 0]\n%s'
SPACE = 'name = "x"\n[bodies.b]\nmass = 1\ninertia = [1, 1, 1]\nposition = [0, 0, 0]\n%s'
HINGE = (
    'orientation = 0\n[joints]\nj = { type = "revolute", bodies = ["ground", "b"], '
    'position = [0, 0] }\n[forces]\nf = { type = "torsion_spring", joint = "j", stiffness = 1, '
)
ANGLES = {
    "bodies.b.orientation": lambda x: PLANE % ("", f"orientation = {x}"),
    "bodies.b.orientation.angle": lambda x: (
        SPACE % f"orientation = {{ axis = [0, 0, 1], angle = {x} }}"
    ),
    "bodies.b.orientation.rotation_vector[1]": lambda x: (
        SPACE % f"orientation = {{ rotation_vector = [0, {x}, 0] }}"
    ),
    "forces.f.free_angle": lambda x: PLANE % ("", f"{HINGE}free_angle = {x} }}"),
}


@pytest.mark.parametrize("where", ANGLES)
@settings(max_examples=30)
@given(angle=st.floats(-1e4, 1e4))
def test_an_angle_of_more_than_a_turn_is_perhaps_in_degrees(where, angle):
    found = told(ANGLES[where](angle))
    assert [location for location, _ in found] == [where] * (abs(angle) > 6.283185307179586)
    assert told(ANGLES[where](f'"{angle!r}*pi/180"')) == []


def test_so_is_the_default_of_a_parameter():
    text = PLANE % ('[parameters]\ntilt = { value = 90, unit = "rad" }\n', 'orientation = "tilt"')
    assert told(text) == [("bodies.b.orientation", "is 90 rad, 14.3 turns")]


def test_so_are_stops_of_an_angle_and_not_those_of_a_distance():
    joint = '[joints]\nhinge = { type = "revolute", bodies = ["ground", "b"], position = [0, 0] }\n'
    rope = 'rope = { type = "stop", points = ["ground", "b"], at = [0, 1], max = 90 }\n'
    stop = 'stop = { type = "stop", joint = "hinge", min = "-10*pi/180", max = 80 }\n'
    text = PLANE % ("", "velocity = [0, 0]\n") + f"{joint}[contacts]\n{rope}{stop}"
    assert told(text) == [("contacts.stop.max", "is 80 rad, 12.7 turns")]


LAWS = [
    ("-50*elongation", True),
    ("-bent(elongation)", True),
    ("50*elongation", False),
    ("bent(elongation) - 3", False),
    ("max(elongation - 0.1, 0)", False),
    ("100 - 50*elongation", False),
]


@pytest.mark.parametrize(("law", "is_wrong"), LAWS)
def test_a_spring_that_pushes_on_from_its_free_length_may_have_the_wrong_sign(law, is_wrong):
    profile = "[profiles]\nbent = { x = [-1, 0, 1], y = [-5, 0, 9] }\n" * ("bent" in law)
    torque = f'torque = "{law.replace("elongation", "angle")}"'
    hinge = HINGE.replace("stiffness = 1, ", torque + " }\n")
    spring = f'g = {{ type = "spring", points = ["ground", "b"], at = [1, 0], force = "{law}" }}'
    found = told(PLANE % (profile, hinge + spring))
    assert [location for location, _ in found] == ["forces.f.torque", "forces.g.force"] * is_wrong
    assert all("and so pushes on from" in text for _, text in found)
