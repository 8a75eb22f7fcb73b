"""A named expression means its text: a scene with names is the scene with the texts written out."""

import json
import re
from random import Random

import pytest

import holonom
import solver
from build_fmu import build
from solver.scene import ExpressionError, Force, SceneError, SceneWarning, loads
from solver.scene.fields import fields_of
from solver.scene.grammar import read
from solver.scene.rules import ANYWHERE
from solver.scene.scene import TABLES

NAMED = """
name = "pads"
dimension = 2
gravity = ["drift", -9.81]
[expressions]
pull = { value = "k*stretch**3", unit = "N", description = "pull of the pad" }
stretch = "A.x - B.x"
drift = 0.5
arm = "2*length/3"
rate = "sqrt(k/mass)"
push = "late(t) - 0.1*B.vx"
apart = "distance(A, B)"
[parameters]
k = { value = 5, variability = "tunable" }
mass = 2.0
length = 1.1
frequency = "rate/(2*pi)"
[profiles]
late = { x = [0, 1, 2], y = [0, 1, 3], interpolation = "linear" }
[points]
O = { position = [0, 0], fixed = true }
A = { position = ["arm", 0.2], mass = "mass" }
B = { position = ["-arm", 0.1], mass = "mass/arm", velocity = [0, 1] }
[joints]
rod = { type = "distance", points = ["O", "A"] }
[forces]
f = { type = "force", point = "A", value = ["-pull", 0] }
h = { type = "force", point = "B", value = ["pull + push", "-pull"] }
s = { type = "spring", points = ["O", "B"], stiffness = "2*rate" }
e = { type = "potential", value = "3*apart**2" }
[outputs]
total = { value = "1 - stretch + A.y + pull + 2*apart", unit = "m" }
[experiment]
stop_time = 0.3
step_size = 0.01
"""
TEXTS = {
    "pull": "(k*(A.x - B.x)**3)",
    "stretch": "(A.x - B.x)",
    "arm": "(2*length/3)",
    "rate": "(sqrt(k/mass))",
    "push": "(late(t) - 0.1*B.vx)",
    "apart": "(distance(A, B))",
}


def written_out() -> str:
    """Return the scene with texts in the place of the names."""
    head, _, rest = NAMED.partition("[expressions]")
    rest = rest[rest.index("[parameters]") :]
    return head.replace('"drift"', '"(0.5)"') + re.sub(
        rf"\b({'|'.join(TEXTS)})\b", lambda found: TEXTS[found[0]], rest
    )


def test_a_scene_with_names_is_that_with_the_texts():
    named, plain = loads(NAMED), loads(written_out())
    for table in {*TABLES} - {"expressions"}:
        assert getattr(named, table) == getattr(plain, table), table
    assert named.gravity == plain.gravity
    assert named.expressions["pull"].unit == "N"
    assert named.expressions["pull"].description == "pull of the pad"


def test_models_are_equal_to_the_byte():
    models = (solver.assemble(loads(text)) for text in (NAMED, written_out()))
    one, two = (model.file for model in models)
    assert one == two


@pytest.mark.parametrize("values", [{}, {"k": 7.0}, {"length": 0.9, "mass": 1.5}], ids=str)
def test_a_run_has_the_bits_of_the_texts(values):
    overrides = dict(values)
    runs = [
        holonom.simulate(loads(text, overrides=overrides)).table.tobytes()
        for text in (NAMED, written_out())
    ]
    assert runs[0] == runs[1]


@pytest.mark.parametrize("native", [False, True], ids=["python", "native"])
def test_an_fmu_has_the_bits_of_the_texts(native, tmp_path):
    results = []
    for name, text in (("named", NAMED), ("plain", written_out())):
        path = build(loads(text), tmp_path / f"{name}.fmu", native=native)
        results.append(holonom.run_fmu(path, settings={"k": 7.0, "length": 0.9}).values.tobytes())
    assert results[0] == results[1]


def test_brackets_are_around_the_text_of_a_name():
    texts = {"e": "a + b", "n": "-2", "long": " + ".join(f"x{i}" for i in range(20))}
    for text, meant in [
        ("e*c", "(a + b)*c"),
        ("c - e", "c - (a + b)"),
        ("n**2", "(-2)**2"),
        ("e if e < n else -e", "(a + b) if (a + b) < (-2) else -(a + b)"),
        ("long + y", f"({texts['long']}) + y"),
        ("y - long - z", f"y - ({texts['long']}) - z"),
        ("min(e, n, c)", "min(a + b, -2, c)"),
    ]:
        assert read(text, {}, texts).number == read(meant).number


def test_names_of_parts_and_functions_are_no_expressions():
    found = read("distance(e, B) + e.x", {}, {"e": "2"})
    assert [mention.name for mention in found.mentions] == ["distance", "e", "B", "e.x"]
    assert not found.named


def test_json_has_named_expressions_too():
    data = {
        "name": "p",
        "expressions": {"twice": "2*half", "half": {"value": 0.5, "description": "of it"}},
        "points": {"A": {"position": ["twice", 0, 0], "mass": 1}},
    }
    scene = loads(json.dumps(data), format="json")
    assert scene.points["A"].position == (1.0, 0.0, 0.0)


def test_overrides_replace_an_expression_by_its_name():
    for name in ("arm", "expressions.arm"):
        scene = loads(NAMED, overrides={name: 0.25})
        assert scene.points["A"].position[0] == 0.25
    scene = loads(NAMED, overrides={"pull": "-2*stretch"})
    assert scene.expressions["pull"].unit == "N"
    force = scene.forces["f"]
    assert isinstance(force, Force)
    assert force.value[0] == read("-(-2*(A.x - B.x))").number


def test_a_long_sum_with_names_is_no_deep_tree():
    text = " + ".join(f"a*{i}" for i in range(1, 400))
    assert read(text, {}, {"a": "b"}).number == read(text.replace("a", "b")).number


def test_a_name_counts_with_the_operations_of_its_text():
    texts = {"e0": "a*a + 1"} | {f"e{i}": f"e{i - 1}*e{i - 1}" for i in range(1, 40)}
    read("e8", {}, texts)  # 2^8 times 2 operations, and 255 products
    for name in ("e10", "e39"):
        with pytest.raises(solver.scene.ExpressionError, match="with the expressions that it men"):
            read(name, {}, texts)


def test_an_expression_that_nothing_mentions_is_a_warning():
    with pytest.warns(SceneWarning, match=r"expressions.spare: nothing mentions it"):
        loads(NAMED.replace("[expressions]", '[expressions]\nspare = "2*t"'))


def test_a_parameter_that_only_an_expression_mentions_is_in_use():
    assert loads(NAMED).warnings == ()


def test_a_held_input_that_drives_by_way_of_a_name_is_a_warning():
    text = """
name = "lift"
dimension = 2
[inputs]
lever = { unit = "m" }
[expressions]
way = "2*lever"
[points]
A = { position = [0, 0], mass = 1 }
[drivers]
hand = { type = "position", point = "A", value = ["way", 0] }
"""
    with pytest.warns(SceneWarning, match=r"so that drivers\.hand\.value\[0\] jumps"):
        loads(text)


def test_a_closed_text_changes_what_an_expression_reads_of_a_joint():
    text = """
name = "arm"
dimension = 2
[expressions]
bend = { value = "2*elbow.angle", unit = "rad" }
[bodies]
arm = { mass = 1, inertia = 1, position = [0, 0] }
[joints]
elbow = { type = "revolute", bodies = ["ground", "arm"], position = [0, 0] }
[drivers]
motor = { type = "angle", joint = "elbow", value = 0.5 }
[outputs]
turned = { value = "bend + 1", unit = "rad" }
[solver]
assemble = true
"""
    closing = solver.close(loads(text))
    assert 'value = "2*(elbow.angle + 0.5)"' in closing.text
    assert 'value = "bend + 1"' in closing.text


def test_a_circle_by_way_of_a_parameter_is_named_in_order():
    text = NAMED.replace("drift = 0.5", 'drift = "2*spin"').replace(
        "mass = 2.0", 'mass = 2.0\nspin = "drift + 1"'
    )
    with pytest.raises(SceneError, match="calculated from itself: spin -> drift -> spin"):
        loads(text)


def test_a_name_may_stand_for_symbols_of_one_place_alone():
    """Of springs, dampers and surfaces; elsewhere both the place and the expression are told."""
    text = """
name = "own"
dimension = 2
[parameters]
k = 3.0
[expressions]
stretch = "length - 1"
stored = "k*stretch**2"
drag = "2*rate + rate*abs(rate)"
bowl = "y - x**2"
[points]
O = { position = [0, 0], fixed = true }
A = { position = [1, 1], mass = 1 }
[bodies]
ground_plate = { position = [0, 0], mass = 1, inertia = 1 }
[joints]
hold = { type = "fixed", bodies = ["ground", "ground_plate"], position = [0, 0] }
slope = { type = "point_on_surface", point = "A", surface = "bowl" }
[forces]
spring = { type = "spring", points = ["O", "A"], energy = "stored" }
damper = { type = "damper", points = ["O", "A"], force = "drag" }
"""
    named = loads(text)
    plain = text.replace('"stored"', '"(k*(length - 1)**2)"').replace(
        '"drag"', '"(2*rate + rate*abs(rate))"'
    )
    plain = plain.replace('"bowl"', '"(y - x**2)"')
    head, _, rest = plain.partition("[expressions]")
    plain = loads(head + rest[rest.index("[points]") :])
    assert named.forces == plain.forces
    assert named.joints == plain.joints
    with pytest.raises(SceneError) as caught:
        loads(text.replace('energy = "stored"', 'stiffness = "drag"'))
    (found,) = (x for x in caught.value.problems if x.location == "forces.spring.stiffness")
    assert found.message == "unknown symbol 'rate' (in the expression 'drag')"


def test_an_expression_that_is_called_as_a_symbol_of_a_damper_is_one_mistake():
    text = """
name = "own"
dimension = 2
[expressions]
rate = "3*2"
[points]
A = { position = [1, 1], mass = 1 }
[forces]
slow = { type = "damper", points = ["ground", "A"], at = [0, 0], force = "2*rate" }
"""
    with pytest.raises(SceneError) as caught:
        loads(text)
    (found,) = caught.value.problems
    message = "'rate' has a meaning of its own here, and is the name of an expression"
    assert (found.location, found.message) == ("forces.slow.force", message)


def test_a_named_expression_may_mention_the_symbols_of_every_place():
    parts = [part for table in TABLES.values() for part in table.types]
    kinds = [field.kind for part in parts for field in fields_of(part).values()]
    own = {word for kind in kinds for word in kind.place.own}
    assert {"length", "rate", "angle"} <= own <= {*ANYWHERE.own}


def _formula(draw: Random, names: list[str], depth: int = 0) -> str:
    """Return a random formula over names, symbols and numbers."""
    kind = draw.random()
    if depth > 3 or kind < 0.3:
        return draw.choice([*names, "a", "b", "2", "0.5", "A.x"])
    x, y, z = (_formula(draw, names, depth + 1) for _ in range(3))
    if kind < 0.75:
        return x + draw.choice(["+", "-", "*", "/", "**", "<", " and "]) + y
    return draw.choice([f"({x})", f"min({x}, {y}, {z})", f"{x} if {y} else {z}", f"-{x}"])


@pytest.mark.parametrize("seed", range(200))
def test_random_formulas_with_names_are_those_written_out(seed):
    draw, texts = Random(seed), dict[str, str]()
    for k in range(3):
        texts[f"n{k}"] = _formula(draw, list(texts))

    def out(text: str) -> str:
        return re.sub(r"\bn\d\b", lambda name: f"({out(texts[name[0]])})", text)

    def found(text: str, expressions: dict[str, str]) -> object:
        try:
            return read(text, {}, expressions).number
        except ExpressionError as error:
            return error.message.removeprefix("with the expressions that it mentions, ")

    text = _formula(draw, list(texts))
    assert found(text, texts) == found(out(text), {})
