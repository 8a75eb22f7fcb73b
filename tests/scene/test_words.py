"""Words that a scene does not have: each leads to the one that it has."""

import json

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from solver import SceneError, loads
from solver.options import OPTIONS
from solver.scene import JointFriction
from solver.scene.fields import fields_of
from solver.scene.scene import NOUNS, TYPES, Scene
from solver.scene.units import base_unit
from solver.scene.words import NAMES, listed

TABLES = [*NOUNS]
PARTS = [(table, word) for table, types in TYPES.items() for word in types]
SCENE = {
    "name": "x",
    "points": {
        "O": {"position": [0, 0, 0], "fixed": True},
        "A": {"position": [1, 0, 0], "mass": 1.0},
        "B": {"position": [2, 0, 0], "mass": 1.0},
    },
    "bodies": {
        "crank": {"position": [0, 0, 0], "mass": 1.0, "inertia": [1, 1, 1]},
        "slider": {"position": [0, 0, 0], "mass": 1.0, "inertia": [1, 1, 1]},
    },
    "joints": {
        "bearing": {"type": "revolute", "bodies": ["ground", "crank"], "position": [0, 0, 0],
                    "axis": [0, 0, 1]},
        "guide": {"type": "prismatic", "bodies": ["ground", "slider"], "axis": [1, 0, 0]},
    },
}  # fmt: skip


PLANE = {
    "name": "x",
    "dimension": 2,
    "points": {
        "O": {"position": [0, 0], "fixed": True},
        "A": {"position": [1, 0], "mass": 1.0},
    },
    "bodies": {
        name: {"position": [0, 0], "mass": 1.0, "inertia": 1.0} for name in ("crank", "slider")
    },
    "joints": {
        "bearing": {"type": "revolute", "bodies": ["ground", "crank"], "position": [0, 0]},
        "guide": {"type": "prismatic", "bodies": ["ground", "slider"], "axis": [1, 0]},
    },
}
"""Likewise in the plane, for types that exist only there."""


def scene_with(table, word):
    """Scene in which there may be a part of this type."""
    return SCENE if TYPES[table][word].is_in(3) else PLANE


def problems(scene):
    """Mistakes that are reported of a scene; none where it is right."""
    text = scene if isinstance(scene, str) else json.dumps(scene)
    try:
        loads(text, format="toml" if isinstance(scene, str) else "json")
    except SceneError as error:
        return error.problems
    return ()


def problem_of(table, fields, scene=SCENE):
    """The one mistake that is reported of a scene with one more part."""
    parts = scene.get(table, {}) | {"new": fields}
    (found,) = problems(scene | {table: parts})
    return found


def example(table, word):
    """Fields of a part of this type, all that are required, with values that are right."""
    known = {
        "points": ["O", "A"], "point": "A", "bodies": ["ground", "slider"], "body": "slider",
        "joint": "bearing", "joints": ["bearing", "guide"], "axis": [0, 0, 1], "value": "1.0",
        "position": [0, 0, 0], "axes": [[1, 0, 0], [0, 1, 0]], "surface": "x", "follower": "A",
        "on": "slider", "size": [1, 1, 1], "inner_radius": 0.5,
    }  # fmt: skip
    if word == "torque" or (table, word) in (("forces", "force"), ("drivers", "position")):
        known["value"] = [1, 0, 0]
    required = (name for name, field in fields_of(TYPES[table][word]).items()
                if field.required and name != "type")  # fmt: skip
    return {"type": word} | {name: known.get(name, 1.0) for name in required}


# -------------------------------------------------------------------------- names of tables


@pytest.mark.parametrize("table", TABLES)
def test_the_singular_of_a_table_suggests_it(table):
    singular = f"{table[:-3]}y" if table.endswith("ies") else table.removesuffix("s")
    for word in (singular, singular.upper(), singular.title()):
        (found,) = problems(SCENE | {word: {}})
        assert (found.message, found.help) == ("unknown table or field", f"did you mean '{table}'?")


@pytest.mark.parametrize("place", NAMES)
def test_every_word_of_the_list_means_what_exists(place):
    fields = {field for types in TYPES.values() for x in types.values() for field in fields_of(x)}
    known = {"file": {*fields_of(Scene)}, "fields": {*fields, "density", "start", "min", "max"}}
    known["fields"] |= {"description", "fixed", "radius", *fields_of(JointFriction)}
    for word, names in NAMES[place].items():
        assert names
        assert {*names} <= known.get(place, {*TYPES.get(place, ())})
        assert word == word.lower()
        if place in ("file", *TYPES):
            assert word not in known.get(place, {*TYPES.get(place, ())})


@pytest.mark.parametrize(("word", "names"), NAMES["file"].items())
def test_other_words_for_tables(word, names):
    (found,) = problems(SCENE | {word: {}})
    assert found.help == f"did you mean '{names[0]}'?"


@pytest.mark.parametrize(
    ("table", "word", "names"), [(t, *item) for t in TYPES for item in NAMES[t].items()]
)
def test_other_words_for_types(table, word, names):
    scene = scene_with(table, names[0])
    assert problem_of(table, {"type": word}, scene).help == f"did you mean '{names[0]}'?"


@pytest.mark.parametrize(("word", "names"), NAMES["fields"].items())
def test_other_words_for_fields(word, names):
    """In the first part that has one of the fields that the word may mean."""
    for table, kind in PARTS:
        own = fields_of(TYPES[table][kind])
        wanted = next((name for name in names if name in own), "")
        if wanted and word not in own:
            fields = example(table, kind)
            fields.pop(wanted, None)
            if table == "bodies" and kind == "bar":
                fields["points"] = ["A", "B"]
            reports = problems(SCENE | {table: SCENE.get(table, {}) | {"new": fields | {word: 1}}})
            helps = [report.help for report in reports if report.message == "unknown field"]
            types = [report.help for report in reports if "no field of the type" in report.message]
            assert helps == [f"did you mean '{wanted}'?"] or types
            return
    assert {*names} <= {"density", "start", "min", "max", "description", "fixed"}


@pytest.mark.parametrize("word", ["motor", "friction", "limit", "velocity"])
def test_what_is_no_word_of_a_scene_says_what_to_write(word):
    """As a table, as a type and as a field of a joint."""
    cross = {"bodies": ["ground", "crank"], "position": [0, 0, 0], "axes": [[1, 0, 0], [0, 1, 0]]}
    places = [
        problems(SCENE | {word: {}}),
        problems(SCENE | {"joints": {"bearing": {"type": "universal", **cross, word: 1.0}}}),
        *([problem_of(table, {"type": word})] for table in ("forces", "drivers")),
    ]
    for (found,) in places:
        assert found.help.count("type = ") or "field of points and rigid bodies" in found.help
        for kind in ("angle", "displacement", "joint_torque", "torsion_damper", "potential"):
            assert kind in str(TYPES)  # what the sentences name exists


@pytest.mark.parametrize(
    ("table", "word"), [("joints", "spring"), ("forces", "revolute"), ("drivers", "joint_torque")]
)
def test_a_type_of_another_table_names_the_table(table, word):
    home = next(home for home, types in TYPES.items() if word in types)
    help = problem_of(table, {"type": word}).help
    assert help == f"'{word}' is a type of [{home}]: write it there"


# --------------------------------------------------------------------- types with these fields


@pytest.mark.parametrize(("table", "right"), PARTS)
def test_fields_of_one_type_under_another_name_suggest_it(table, right):
    """Where one type alone has all fields that are given, and not near names of them."""
    fields = example(table, right)
    fitting = {
        word
        for word, model in TYPES[table].items()
        if fields.keys() <= fields_of(model).keys()
        and all(name in fields for name, x in fields_of(model).items() if x.required)
    }
    scene = scene_with(table, right)
    for wrong, model in TYPES[table].items():
        possible = model.is_in(scene.get("dimension", 3))
        if fitting == {right} and possible and not fields.keys() <= fields_of(model).keys():
            parts = scene.get(table, {}) | {"new": fields | {"type": wrong}}
            found = {p.message: p.help for p in problems(scene | {table: parts})}
            assert found[f"is no field of the type '{wrong}'"] == f'write type = "{right}"'
            assert "unknown field" not in found


@pytest.mark.parametrize(("table", "word"), PARTS)
def test_a_misspelt_field_is_one_mistake_and_not_also_a_missing_one(table, word):
    fields = example(table, word)
    if table == "bodies":
        fields |= {"points": ["A", "B"]} if word == "bar" else {"mass": 1.0, "inertia": [1, 1, 1]}
    for name in fields.keys() - {"type"}:
        wrong = {(f"{x}_" if x == name else x): value for x, value in fields.items()}
        scene = scene_with(table, word)
        found = problems(scene | {table: scene.get(table, {}) | {"new": wrong}})
        helps = {report.location: report.help for report in found}
        assert helps[f"{table}.new.{name}_"] == f"did you mean '{name}'?"
        assert not any(f"'{name}'" in report.message for report in found)


def test_a_torque_at_a_joint_is_one_of_those_of_joints():
    found = problem_of("forces", {"type": "torque", "joint": "bearing", "value": 1.0})
    assert (found.location, found.help) == (
        "forces.new.joint",
        "types of forces with these fields: joint_torque, actuator",
    )


@pytest.mark.parametrize(("table", "word"), PARTS)
def test_what_is_missing_is_shown_with_names_of_this_scene(table, word):
    named = {"point", "points", "body", "bodies", "joint", "joints", "follower"}
    fields = example(table, word)
    for name in named & fields.keys():
        scene = scene_with(table, word)
        scene = scene | {table: scene.get(table, {}) | {"new": fields | {name: 1.5}}}
        helps = [found.help for found in problems(scene) if found.location.endswith(f".{name}")]
        (text,) = helps
        names = json.loads(text.partition("= ")[2])
        parts = {**SCENE["points"], **SCENE["bodies"], **SCENE["joints"], "ground": {}}
        assert {names} if isinstance(names, str) else {*names} <= parts.keys()


def test_nothing_is_named_where_there_is_nothing():
    scene = {"name": "x", "points": SCENE["points"]}
    scene["forces"] = {"drive": {"type": "torque", "value": [1, 0, 0]}}
    (found,) = problems(scene)
    assert found.help == 'write body = "..."'


# ------------------------------------------------------------------------------ what is known


def test_what_is_possible_is_listed_whole():
    """Fields of a table with many, points with the ground, and symbols with the mechanism's own."""
    rod = {"type": "distance", "points": ["A", "qqq"]}
    output = {"value": "qqq"}
    scene = SCENE | {"solver": {"qqq": 1}, "joints": {"rod": rod}, "outputs": {"o": output}}
    helps = {found.location: found.help for found in problems(scene)}
    assert helps["solver.qqq"] == f"known fields: {', '.join(OPTIONS)}"
    assert helps["joints.rod.points[1]"].endswith(", ground")
    of_output = helps["outputs.o.value"].removeprefix("known: ").split(", ")
    assert {"t", "A.x", "crank.qw", "energy.error"} <= {*of_output}


def test_an_unknown_override_lists_all_that_can_be_replaced():
    with pytest.raises(SceneError) as caught:
        loads(json.dumps(SCENE), format="json", overrides={"qqq": 1})
    names = caught.value.problems[0].help.removeprefix("known: ").split(", ")
    assert {"gravity", "solver.tolerance", "experiment.stop_time", "points.A.velocity"} <= {*names}
    for name in ("gravity", "solver.tolerance", "points.A.mass"):
        value = [0, 0, -1] if name == "gravity" else 0.01
        loads(json.dumps(SCENE), format="json", overrides={name: value})


def test_of_very_many_names_the_number_of_the_rest_is_told():
    assert listed([f"n{i}" for i in range(300)]).endswith(", n298, n299")
    assert listed([f"n{i}" for i in range(1234)]).endswith(", n298, n299 and 934 more")


# --------------------------------------------------------------------------------------- units

SI = ["N", "m", "s", "kg", "rad", "J", "Pa", "W", "Hz"]


@given(st.lists(st.sampled_from(SI), min_size=2, max_size=3, unique=True))
def test_symbols_without_signs_between_them_suggest_a_product(symbols):
    unit = "".join(symbols)
    assume(base_unit(unit) is None)
    scene = SCENE | {"parameters": {"p": {"value": 1.0, "unit": unit}}}
    (found,) = problems(scene)
    assert found.message == f"there is no unit '{unit}'"
    meant = found.help.removeprefix("did you mean '").removesuffix("'?")
    assert meant.replace(".", "") == unit
    assert base_unit(meant).factor == 1.0


@pytest.mark.parametrize(
    ("unit", "meant"),
    [("Nm", "N.m"), ("Nms/rad", "N.m.s/rad"), ("N·m", "N.m"), ("kgm2", "kg.m2"), ("Kg", "kg"),
     ("newton", "N"), ("m/sec", "m/s"), ("N m", None)],
)  # fmt: skip
def test_other_spellings_of_units(unit, meant):
    scene = SCENE | {"parameters": {"p": {"value": 1.0, "unit": unit}}}
    helps = [found.help for found in problems(scene)]
    assert helps == ([f"did you mean '{meant}'?"] if meant else [])


@pytest.mark.parametrize(
    ("unit", "help"),
    [
        ("mN", "give the value in N: 1 mN is 0.001 N"),
        ("mNm", "give the value in N.m: 1 mN.m is 0.001 N.m"),
        ("mN*m", "give the value in N.m: 1 mN.m is 0.001 N.m"),
        ("kN/m", "give the value in N/m: 1 kN/m is 1000 N/m"),
        ("mrad", "give the value in rad: 1 mrad is 0.001 rad"),
        ("hPa", "give the value in Pa: 1 hPa is 100 Pa"),
        ("um", "give the value in m: 1 um is 1e-06 m"),
        ("degC", "give a temperature in K, value + 273.15; a difference of 1 degC is 1 K"),
        ("deg C", "give a temperature in K, value + 273.15; a difference of 1 degC is 1 K"),
        ("J/°C", "give a temperature in K, value + 273.15; a difference of 1 °C is 1 K"),
        ("degF", "give a temperature in K, (value + 459.67)*5/9; a difference of 1 degF is 5/9 K"),
    ],
)
def test_a_unit_with_a_prefix_or_an_offset_is_refused_with_the_value_in_si(unit, help):
    (found,) = problems(SCENE | {"parameters": {"p": {"value": 1.0, "unit": unit}}})
    assert found.help.partition("; display_unit")[0] == help.partition("; display_unit")[0]
    counts = "counts from another zero than SI, so that no factor converts it"
    assert (counts in found.message) == ("K" in help)


def test_a_name_of_the_scene_is_nearer_than_a_unit():
    """A pm is a picometre."""
    point = SCENE["points"]["A"] | {"mass": "pm"}
    helps = [
        found.help
        for parameters in ({"pms": 1.0}, {"k": 1.0})
        for found in problems(SCENE | {"points": {"A": point}, "parameters": parameters})
    ]
    assert helps[0] == "did you mean 'pms'?"
    assert helps[1].endswith("for pm in a formula write 1e-12")


@given(
    value=st.floats(-1e6, 1e6),
    unit=st.sampled_from(["degrees", "°", "meters", "newtons", "rad/sec", "KN"]),
    space=st.sampled_from(["", " ", "  "]),
)
def test_an_unknown_unit_behind_a_number_says_the_one_that_is_meant(value, unit, space):
    point = SCENE["points"]["A"] | {"mass": f"{value!r}{space}{unit}"}
    (found,) = problems(SCENE | {"points": {"A": point}})
    meant = {"degrees": "deg", "°": "deg", "meters": "m", "newtons": "N", "KN": "kN"}
    assert found.help == f'write "{value!r} {meant.get(unit, "rad/s")}"'


@pytest.mark.parametrize("line", ["value = 90 deg", "a = { value = 90 deg }", "v = [0, 90 deg]"])
def test_one_without_quotes_says_how_it_is_written(line):
    """Of TOML it is a mistake of the notation."""
    (found,) = problems(f'name = "x"\n[parameters.p]\n{line}\n')
    assert found.line == 3
    assert found.help == 'write "90 deg"'


def test_an_expression_is_no_number_with_a_unit():
    for text in ("2*", "1 if", "3 foo", "1e5 +"):
        (found,) = problems(SCENE | {"points": {"A": {"position": [0, 0, 0], "mass": text}}})
        assert found.help is None or "unit" not in found.help


def test_a_unit_as_a_symbol_says_so_too():
    point = SCENE["points"]["A"] | {"position": ["30*deg", "0.5*mm", 0]}
    helps = [found.help for found in problems(SCENE | {"points": {"A": point}})]
    assert [help.rpartition("write ")[2] for help in helps] == ["0.0174532925199", "0.001"]


# ------------------------------------------------------------------------- angles and gravity


@settings(max_examples=20)
@given(st.lists(st.floats(-360, 360), min_size=1, max_size=4))
def test_a_list_as_an_orientation_says_how_it_is_written(angles):
    body = SCENE["bodies"]["crank"] | {"orientation": angles}
    (found,) = problems(SCENE | {"bodies": {"crank": body}, "joints": {}})
    assert found.message.startswith("must be a number in dimension 2 and a table in dimension 3")
    assert 'angle = "90 deg"' in found.help


def test_the_angle_of_a_joint_in_degrees_says_radians():
    joint = {"type": "angle", "bodies": ["crank", "slider"], "value": 90,
             "axes": [[1, 0, 0], [0, 1, 0]]}  # fmt: skip
    assert problem_of("joints", joint).help == 'if these are degrees, write "90 deg"'


@pytest.mark.parametrize("points", [{}, SCENE["points"], {"A": {"position": [0, 0], "mass": 1}}])
def test_gravity_of_two_numbers_suggests_the_plane(points):
    found = problems({"name": "x", "gravity": [0, -9.81], "points": points})
    assert any("dimension = 2" in str(each.help) for each in found)
