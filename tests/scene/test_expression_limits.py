"""Expressions have a largest size and depth; below these they work wherever a formula may stand."""

from __future__ import annotations

import json
from pathlib import Path
from random import Random

import pytest

import solver
from solver.scene import ExpressionError, SceneError, evaluate, parse
from solver.scene.grammar import MOST_NESTED, MOST_OPERATIONS

SCENE = {
    "name": "long",
    "dimension": 2,
    "gravity": [0, -9.81],
    "parameters": {"p": 0.3, "q": {"value": 0.7, "variability": "tunable"}},
    "inputs": {"u": {"start": 0.2}},
    "points": {
        "O": {"position": [0, 0], "fixed": True},
        "A": {"position": [1, 0], "mass": 1.0},
        "B": {"position": [1.2, 0.3], "mass": 1.0, "velocity": [0.1, 0]},
        "C": {"position": [1.5, -0.3]},
    },
    "joints": {"rod": {"type": "distance", "points": ["O", "A"]}},
    "drivers": {"d": {"type": "position", "point": "C", "value": [1.5, -0.3]}},
    "outputs": {"used": {"value": "p*q*u"}},
    "solver": {"assemble": True},
}
SPRING = {"type": "spring", "points": ["O", "B"]}
MOTION = ("A.x", "B.y", "distance(A, B)")
PLACES = {
    "parameter": ("parameters.x", lambda x: {"value": x}, ("p", "q")),
    "position": ("points.D", lambda x: {"position": [x, 0], "mass": 1.0}, ("p", "0.4")),
    "mass": ("points.D", lambda x: {"position": [3, 0], "mass": f"2000 + {x}"}, ("p", "0.4")),
    "force": (
        "forces.f", lambda x: {"type": "force", "point": "B", "value": [x, 0]},
        (*MOTION, "t", "u", "B.vx"),
    ),
    "stiffness": (
        "forces.f", lambda x: {**SPRING, "stiffness": f"2000 + {x}", "free_length": 1}, ("t", "q"),
    ),
    "energy": ("forces.f", lambda x: {**SPRING, "energy": f"length + {x}"}, ("length", "p", "q")),
    "potential": (
        "forces.f", lambda x: {"type": "potential", "value": f"A.x + {x}"}, (*MOTION, "q"),
    ),
    "constraint": ("constraints.c", lambda x: {"value": f"3000*B.y + {x}"}, (*MOTION, "t", "q")),
    "velocity": (
        "constraints.c", lambda x: {"velocity": f"3000*B.vx + A.vy*({x})"}, (*MOTION, "t"),
    ),
    "driver": (
        "drivers.d", lambda x: {"type": "position", "point": "C", "value": [1.5, x]}, ("t", "q"),
    ),
    "output": (
        "outputs.o", lambda x: {"value": x}, (*MOTION, "t", "u", "p", "B.vx", "energy.kinetic"),
    ),
}  # fmt: skip
"""Where a formula may stand, what is written around it, and what it may mention."""
AROUND = 3
"""Operations that the table above writes around a formula, and levels."""


def run(place, text):
    """One step of a scene with a formula at a place."""
    location, part, _ = PLACES[place]
    table, name = location.split(".")
    data = json.loads(json.dumps(SCENE))
    data.setdefault(table, {})[name] = part(text)
    if table == "parameters":
        data["outputs"]["o"] = {"value": "x*t"}
    model = solver.assemble(solver.loads(json.dumps(data), format="json"))
    integrator = solver.Integrator(model, log=lambda _: None)  # a formula may move what it holds
    integrator.advance(0.0, 0.01)
    return integrator


def random_tree(chance, operations, depth, leaves):
    """Text of an expression with so many operations, at most so many within each other."""
    if operations == 0:
        return chance.choice(leaves)
    if depth == 1:
        more = [chance.choice([" + ", " - "]) + chance.choice(leaves) for _ in range(operations)]
        return f"({chance.choice(leaves)}{''.join(more)})"
    if operations == 1 or chance.random() < 0.3:
        name = chance.choice(["sin", "cos", "tanh", "abs", "-"])
        return f"{name}({random_tree(chance, operations - 1, depth - 1, leaves)})"
    first = chance.choice([0, chance.randrange(operations), operations - 1])
    sizes = (first, operations - 1 - first)
    one, two = (random_tree(chance, size, depth - 1, leaves) for size in sizes)
    form = chance.choice(["max({}, {})", "min({}, {})", "({} + {})", "({} - {})"])
    return form.format(one, two)


@pytest.mark.filterwarnings("ignore:.*conditions and kinks:solver.SceneWarning")
@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("place", PLACES)
def test_a_random_expression_of_the_largest_size_works(place, seed):
    chance = Random(f"{place}/{seed}")
    text = random_tree(chance, MOST_OPERATIONS - AROUND, MOST_NESTED - AROUND, PLACES[place][2])
    run(place, text)


@pytest.mark.parametrize("place", PLACES)
def test_sums_and_functions_of_many_terms_work(place):
    names = PLACES[place][2]
    terms = [names[k % len(names)] for k in range(MOST_OPERATIONS - AROUND)]
    for text in (" + ".join(terms), " - ".join(terms), f"max({', '.join(terms)})"):
        run(place, text)


NESTS = [
    ("sin(", ")"), ("-(", ")"), ("tanh((", "))"), ("0.5**", ""), ("0.1 - (", ")"), ("- ", ""),
    ("max(0.1, ", ")"), ("(0.1 if p > 9 else ", ")"), ("0.5*(0.2 + ", ")"), ("(1 < ", ")"),
]  # fmt: skip


@pytest.mark.parametrize("nest", NESTS, ids=lambda nest: nest[0])
@pytest.mark.parametrize("place", ["parameter", "force", "output"])
def test_the_deepest_expression_works_and_a_deeper_one_is_refused(place, nest):
    levels = MOST_NESTED // 2 if nest[0].startswith("0.5*(") else MOST_NESTED - nest[0].count(">")
    run(place, nest[0] * levels + "p" + nest[1] * levels)
    with pytest.raises(
        SceneError, match=f"more than {MOST_OPERATIONS} operations, or {MOST_NESTED} within"
    ):
        run(place, nest[0] * (levels + 1) + "p" + nest[1] * (levels + 1))


@pytest.mark.parametrize("text", [
    " + ".join(["p"] * (MOST_OPERATIONS + 2)), f"max({', '.join(['p'] * (MOST_OPERATIONS + 2))})",
    "-" * 50_000 + "1", "+".join(["p"] * 30_000), "p" + ".p" * 30_000,
    " if p else ".join(["p"] * 999),
    "(" * 5_000 + "1" + ")" * 5_000, "1" * 5_000, "\ud800", "'\ud800'",
])  # fmt: skip
def test_what_is_larger_is_refused(text):
    with pytest.raises(ExpressionError):
        parse(text)


def test_a_long_sum_is_that_of_its_terms():
    random = Random(1)
    numbers = [random.uniform(0.5, 2.0) for _ in range(200)]
    signs = [random.choice("+-") for _ in numbers]
    powers = [random.choice("*/") for _ in numbers]
    added = "p" + "".join(f" {s} p*{x!r}" for s, x in zip(signs, numbers, strict=True))
    multiplied = "p" + "".join(f" {s} (p + {x!r})" for s, x in zip(powers, numbers, strict=True))
    for text in (added, multiplied):
        expected = eval(text, {"p": 0.3})
        value = evaluate(parse(text), {"p": 0.3})
        assert value == pytest.approx(expected, rel=1e-12)


def test_parameters_may_be_calculated_from_each_other_in_a_long_chain():
    for first, last in ((1.0, "x1999"), ({"value": 1.0, "variability": "tunable"}, "x1999*t")):
        chain = {f"x{k}": f"x{k - 1} + 1" for k in range(1999, 0, -1)}
        data = SCENE | {"parameters": SCENE["parameters"] | chain | {"x0": first}}
        data |= {"outputs": SCENE["outputs"] | {"o": {"value": last}}}
        data |= {"forces": {"f": {"type": "force", "point": "B", "value": [last, 0]}}}
        model = solver.assemble(solver.loads(json.dumps(data), format="json"))
        moved = solver.Integrator(model, log=lambda _: None)
        assert moved["x1999"] == 2000.0


def test_the_guide_states_the_limits():
    guide = (Path(__file__).parents[2] / "docs" / "scene.md").read_text(encoding="utf-8")
    assert (
        f"at most {MOST_OPERATIONS} operations, and at most {MOST_NESTED} of them within" in guide
    )
