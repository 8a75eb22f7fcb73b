"""Profiles: splines with the bits of the core, from lists and files, that expressions call."""

from __future__ import annotations

import json
import math
import shutil
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.interpolate import CubicSpline

import solver
from solver.mechanics.derivative import derivative
from solver.scene import SceneError
from solver.scene.expression import Curve, apply, evaluate, symbol
from solver.scene.grammar import read
from solver.scene.profiles import table_of
from tests.oracle import splines

SPLINES = ("spline", "spline_slope", "spline_curvature")


@st.composite
def tables(draw, kinds=("plain", "periodic", "integral")):
    """Abscissae, ordinates, kind and table of a random profile."""
    kind = draw(st.sampled_from(kinds))
    steps = draw(st.lists(st.floats(0.01, 2.0), min_size=2, max_size=12))
    x = np.cumsum([draw(st.floats(-3.0, 3.0)), *steps]).tolist()
    y = [draw(st.floats(-5.0, 5.0)) for _ in x]
    if kind == "periodic":
        y[-1] = y[0]
    periodic, integrate = kind == "periodic", kind == "integral"
    return x, y, kind, Curve("f", table_of(x, y, periodic=periodic, integrate=integrate))


def size_of(table, order, *more):
    """Largest derivative of this order, at points of the pieces and `more`; at least 1."""
    numbers = np.array(table.numbers)
    spread = [a + s * (b - a) for a, b in pairwise(numbers[7::6]) for s in (0.0, 0.3, 0.7, 1.0)]
    return max(1.0, *(abs(splines.value(order, x, numbers)) for x in (*spread, *more)))


@given(tables())
def test_a_profile_is_the_natural_or_periodic_spline_through_its_points(content):
    x, y, kind, table = content
    reference = CubicSpline(x, y, bc_type="periodic" if kind == "periodic" else "natural")
    reference = reference.antiderivative() if kind == "integral" else reference
    for order, name in enumerate(SPLINES):
        # rounding of curvatures is that of slopes over the shortest piece
        near = 1e-13 * size_of(table, order) / min(np.diff(x)) ** order
        for at in np.linspace(x[0], x[-1], 41)[:-1]:
            assert apply(name, float(at), table) == pytest.approx(
                float(reference(at, order)), abs=near
            )


@given(tables(("plain", "periodic")))
def test_a_profile_goes_through_its_points(content):
    x, y, _, table = content
    for at, value in zip(x, y, strict=True):
        assert apply("spline", at, table) == pytest.approx(value, abs=1e-14 * size_of(table, 0))


@given(tables())
def test_value_slope_and_curvature_are_continuous_at_all_points_also_the_ends(content):
    x, _, kind, table = content
    for order, name in enumerate(SPLINES):
        for at in x:
            left, right = (apply(name, at + d, table) for d in (-1e-9, 1e-9))
            steepest = size_of(table, min(order + 1, 2)) / min(np.diff(x))
            assert left == pytest.approx(right, abs=1e-7 * max(steepest, 1.0))
    beyond = apply("spline_curvature", x[-1] + 1.0, table)
    assert kind != "plain" or beyond == 0.0  # straight


@given(tables(("periodic",)), st.integers(-5, 5), st.floats(0.0, 1.0))
def test_a_periodic_profile_repeats(content, turns, share):
    x, _, _, table = content
    period = x[-1] - x[0]
    at = x[0] + share * period
    for order, name in enumerate(SPLINES):
        near = 1e-11 * size_of(table, min(order + 1, 2)) / min(np.diff(x)) ** 2
        again = apply(name, at + turns * period, table)
        assert again == pytest.approx(apply(name, at, table), abs=near)


def test_a_number_that_is_known_folds_to_the_bits_of_the_core():
    table = Curve("f", table_of([0.0, 1.0, 3.0], [0.0, 2.0, 1.0]))
    folded = read("2*f(0.5)", {"f": table}).number
    late = read("2*f(a)", {"f": table}).number
    assert isinstance(folded, float)
    assert evaluate(late, {"a": 0.5}) == folded
    assert str(late) == "(2.0 * f(a))"
    assert str(derivative(late, "a")) == "(2.0 * f'(a))"
    assert read("f(x)", {"f": table}).number != read("f(x)", {"f": table._replace(name="g")}).number
    assert read("f(x)", {"f": table}).number.args[0] == symbol("x")


SCENE = """
name = "profiles"
dimension = 2
[profiles]
lobe = {PROFILE}
[parameters]
width = 0.25
lift = "lobe(width)"
[points]
A = { position = [0, "lobe(0.5)"], mass = "1 + lobe(width)" }
[outputs]
height = { value = "lobe(A.y) + lobe(1.5)" }
"""
LISTED = "{ x = [0, 0.5, 1], y = [0, 1, 0], periodic = true }"


def model_of(folder, profile):
    path = folder / "scene.toml"
    path.write_text(SCENE.replace("{PROFILE}", profile))
    return solver.assemble(solver.load(path))


@pytest.mark.parametrize(
    "text",
    [
        "0,0\n0.5,1\n1,0\n",
        "angle;lift\r\n0;0\r\n0.5;1\r\n1;0\r\n",
        "\ufeffx\ty\n\n 0\t0\n 5e-1\t1.0 \n1\t0\n\n,\n",
    ],
)
def test_a_file_gives_the_model_of_its_numbers(tmp_path, text):
    (tmp_path / "tables").mkdir()
    (tmp_path / "tables" / "lobe.csv").write_text(text, encoding="utf-8", newline="")
    read = model_of(tmp_path, '{ file = "tables/lobe.csv", periodic = true }')
    assert read.fingerprint == model_of(tmp_path, LISTED).fingerprint


def test_a_file_is_found_from_the_folder_of_the_scene_and_may_be_replaced(tmp_path, monkeypatch):
    folder, other = tmp_path / "a", tmp_path / "b"
    folder.mkdir()
    other.mkdir()
    (folder / "lobe.csv").write_text("0,0\n0.5,1\n1,0\n")
    before = model_of(folder, '{ file = "lobe.csv", periodic = true }').fingerprint
    monkeypatch.chdir(other)
    path = shutil.copy(folder / "scene.toml", other)
    with pytest.raises(
        SceneError, match=r"profiles.lobe.file: file '.*lobe.csv' cannot be read: no such file"
    ):
        solver.load(path)
    found = solver.load(path, {"profiles.lobe.file": str(folder / "lobe.csv")})
    assert solver.assemble(found).fingerprint == before
    assert found.profiles["lobe"].y == (0.0, 1.0, 0.0)
    (folder / "lobe.csv").write_text("0,0\n0.5,2\n1,0\n")
    assert solver.assemble(solver.load(folder / "scene.toml")).fingerprint != before


def test_a_scene_in_json_has_profiles_as_well():
    profile = {"x": [0, 0.5, 1], "y": [0, 1, 0]}
    point = {"A": {"position": [0, "lobe(0.25)"], "mass": 1.0}}
    content = {"name": "a", "dimension": 2, "profiles": {"lobe": profile}, "points": point}
    scene = solver.loads(json.dumps(content), format="json")
    assert scene.points["A"].position[1] == pytest.approx(0.6875, rel=1e-15)


def test_a_folder_is_no_profile(tmp_path):
    with pytest.raises(SceneError, match=r"profiles.lobe.file: file '.*' cannot be read: "):
        model_of(tmp_path, '{ file = "." }')


def test_a_profile_with_a_mistake_is_reported_once(tmp_path):
    with pytest.raises(SceneError) as caught:
        model_of(tmp_path, "{ x = [1, 0], y = [0, 1] }")
    assert [problem.location for problem in caught.value.problems] == ["profiles.lobe.x[1]"]


def test_the_integral_of_a_profile_begins_at_its_first_point():
    table = Curve("f", table_of([1.0, 2.0, 4.0], [3.0, 3.0, 3.0], integrate=True))
    for x in (-1.0, 1.0, 1.5, 4.0, 6.0):
        assert apply("spline", x, table) == pytest.approx(3.0 * (x - 1.0), rel=1e-15)
    assert apply("spline", math.nextafter(1.0, 0.0), table) == pytest.approx(0.0, abs=1e-15)
