"""Profiles: splines with the bits of the core, from lists and files, that expressions call."""

from __future__ import annotations

import json
import math
import shutil
import warnings
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.interpolate import CubicSpline, PchipInterpolator

import holonom
import solver
from solver.mechanics.derivative import derivative
from solver.scene import SceneError
from solver.scene.expression import Curve, apply, evaluate, symbol
from solver.scene.grammar import read
from solver.scene.profiles import table_of
from tests.oracle import splines

SPLINES = ("spline", "spline_slope", "spline_curvature")


WORDS = ("cubic", "monotone", "linear")


@st.composite
def tables(draw, kinds=("plain", "periodic", "integral"), words=("cubic",)):
    """Abscissae, ordinates, kind and table of a random profile."""
    kind, word = draw(st.sampled_from(kinds)), draw(st.sampled_from(words))
    steps = draw(st.lists(st.floats(0.01, 2.0), min_size=2, max_size=12))
    x = np.cumsum([draw(st.floats(-3.0, 3.0)), *steps]).tolist()
    y = [draw(st.floats(-5.0, 5.0)) for _ in x]
    if kind == "periodic":
        y[-1] = y[0]
    periodic, integrate = kind == "periodic", kind == "integral"
    numbers = table_of(x, y, interpolation=word, periodic=periodic, integrate=integrate)
    return x, y, kind, Curve("f", numbers)


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


@given(tables(("plain", "periodic"), ("monotone", "linear")))
def test_a_monotone_or_linear_profile_goes_through_its_points(content):
    """Up to the rounding of x, of which a period is taken off, times the slope."""
    x, y, _, table = content
    near = 1e-14 * size_of(table, 0) + 4e-16 * max(map(abs, x)) * size_of(table, 1)
    for at, value in zip(x, y, strict=True):
        assert apply("spline", at, table) == pytest.approx(value, abs=near)


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


@given(tables(words=("monotone",)))
def test_a_monotone_profile_is_that_of_fritsch_and_butland(content):
    """As SciPy has it; of a periodic one the middle of three periods."""
    x, y, kind, table = content
    period = x[-1] - x[0]
    long = [at + k * period for k in (-1, 0, 1) for at in x[:-1]], [*y[:-1]] * 3
    reference = PchipInterpolator(*(long if kind == "periodic" else (x, y)))
    reference = reference.antiderivative() if kind == "integral" else reference
    for order, name in enumerate(SPLINES):
        near = 1e-13 * size_of(table, order) / min(np.diff(x)) ** order
        for share in np.linspace(0.01, 0.99, 40):  # where no curvature jumps
            at = x[0] + share * (x[-1] - x[0])
            if min(abs(at - np.array(x))) < 1e-9 or (kind == "periodic" and at > x[-2]):
                continue
            assert apply(name, at, table) == pytest.approx(float(reference(at, order)), abs=near)


@given(tables(("plain",), ("linear",)), st.floats(-4.0, 30.0))
def test_a_linear_profile_is_straight_between_its_points_and_beyond(content, at):
    x, y, _, table = content
    k = min(max(int(np.searchsorted(x, at, "right")) - 1, 0), len(x) - 2)
    slope = (y[k + 1] - y[k]) / (x[k + 1] - x[k])
    near = 1e-14 * size_of(table, 0, at)
    assert apply("spline", at, table) == pytest.approx(y[k] + slope * (at - x[k]), abs=near)
    assert apply("spline_slope", at, table) == slope


@given(tables(("integral",), ("linear",)))
def test_the_integral_of_a_linear_profile_is_that_of_trapezia(content):
    x, y, _, table = content
    areas = np.cumsum([0.0, *(np.diff(x) * 0.5 * (np.array(y[1:]) + y[:-1]))])
    for at, area in zip(x, areas, strict=True):
        assert apply("spline", at, table) == pytest.approx(area, abs=1e-13 * size_of(table, 0))


@given(tables(("plain", "periodic"), ("monotone", "linear")))
def test_a_monotone_or_linear_profile_stays_between_neighbouring_points(content):
    x, y, _, table = content
    for (left, right), (a, b) in zip(pairwise(x), pairwise(y), strict=True):
        low, high = sorted((a, b))
        near = 1e-14 * size_of(table, 0)
        for share in np.linspace(0.0, 1.0, 9)[:-1]:
            assert (
                low - near <= apply("spline", left + share * (right - left), table) <= high + near
            )


@given(tables(words=("monotone",)))
def test_the_slope_of_a_monotone_profile_is_continuous_at_all_points(content):
    x, _, _, table = content
    for at in x:
        left, right = (apply("spline_slope", at + d, table) for d in (-1e-9, 1e-9))
        steepest = max(size_of(table, 1) / min(np.diff(x)), size_of(table, 2))
        assert left == pytest.approx(right, abs=1e-7 * steepest)


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


@pytest.mark.parametrize("integrate", [False, True])
@pytest.mark.parametrize("word", WORDS)
def test_a_profile_may_hold_the_values_of_its_ends(word, integrate):
    x, y = [1.0, 2.0, 4.0], [3.0, -1.0, 5.0]
    inside = Curve("f", table_of(x, y, interpolation=word, integrate=integrate))
    numbers = table_of(x, y, interpolation=word, integrate=integrate, extrapolate="hold")
    held = Curve("f", numbers)
    for at in (1.0, 1.3, 2.0, 3.9, 4.0):
        assert apply("spline", at, held) == apply("spline", at, inside)
    for at, end, value in ((-1.0, 1.0, 3.0), (0.5, 1.0, 3.0), (4.5, 4.0, 5.0), (9.0, 4.0, 5.0)):
        beyond = apply("spline", end, held) + value * (at - end) if integrate else value
        assert apply("spline", at, held) == pytest.approx(beyond, rel=1e-15)


def test_a_force_by_a_held_profile_has_steps_end_at_its_ends():
    # m = 1 under f(t) = t up to 1 s, then 1: v(2) = 1/2 + 1, x(2) = 1/6 + 1/2 + 1/2.
    text = """
name = "held"
dimension = 2
gravity = [0, 0]
[profiles]
ramp = { x = [0, 1], y = [0, 1], interpolation = "linear", extrapolate = "hold" }
[points]
A = { position = [0, 0], mass = 1 }
[forces]
push = { type = "force", point = "A", value = ["ramp(t)", 0] }
[solver]
step_size = 0.3
order = 4
"""
    run = holonom.simulate(solver.loads(text), stop_time=2.0)
    assert run["A.vx"][-1] == pytest.approx(1.5, abs=1e-14)
    assert run["A.x"][-1] == pytest.approx(7 / 6, abs=1e-14)


@pytest.mark.parametrize(
    ("more", "message"),
    [
        ('extrapolate = "hold", periodic = true', "a periodic profile has no ends to go on from"),
        ('extrapolate = "constant"', "unknown extrapolate 'constant'"),
    ],
)
def test_ends_of_a_profile_that_are_wrong_are_told(tmp_path, more, message):
    with pytest.raises(SceneError, match=message):
        model_of(tmp_path, f"{{ x = [0, 0.5, 1], y = [0, 1, 0], {more} }}")


def test_a_held_profile_has_no_normal_at_its_ends():
    text = """
name = "road"
dimension = 2
[profiles]
road = { x = [0, 1, 2], y = [0, 0.1, 0.3], extrapolate = "hold" }
[points]
A = { position = [0, 1], mass = 1 }
[contacts]
street = { type = "profile", point = "A", profile = "road" }
"""
    with pytest.raises(SceneError, match="has corners") as caught:
        solver.loads(text)
    assert 'write extrapolate = "straight" in profiles.road' in str(caught.value)


# --------------------------------------------------------------------------- words and warnings

KERB = """
name = "kerb"
dimension = 2
[profiles]
road = { x = [0, 1, 2, 2.1, 3, 4], y = [0, 0, 0, 0.1, 0.1, 0.1]INTERPOLATION }
[points]
A = { position = [0, 0], mass = 1 }
[drivers]
d = { type = "position", point = "A", value = ["t", "road(t)"] }
[experiment]
stop_time = 4
"""


@pytest.mark.parametrize("word", ["", "cubic"])
def test_a_spline_that_swings_out_of_its_points_is_told_with_place_and_value(word):
    """The natural spline falls to -0.16315 at 1.6163 and rises to 0.24575; its points have 0.1."""
    x, y = [0, 1, 2, 2.1, 3, 4], [0, 0, 0, 0.1, 0.1, 0.1]
    curve = CubicSpline(x, y, bc_type="natural")
    place = min(curve.derivative().roots(extrapolate=False), key=curve)
    told = f"the spline swings beyond its points, whose y are 0 to 0.1: it is {curve(place):.6g}"
    with pytest.warns(solver.SceneWarning):
        scene = solver.loads(
            KERB.replace("INTERPOLATION", f', interpolation = "{word}"' * bool(word))
        )
    (problem,) = scene.warnings
    assert problem.location == "profiles.road"
    assert problem.message == f"{told} at x = {place:.6g}"
    assert "monotone" in problem.help


@pytest.mark.parametrize("lift", [0.4, 0.9, 1.1, 3.0])
@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_a_swing_is_told_from_a_tenth_of_the_range_on(lift, sign):
    """From 0 to 1 and 1 + lift: by how much it leaves these, against SciPy's spline on a grid."""
    x, y = [0.0, 1.0, 2.0, 3.0], [sign * v for v in (0.0, 1.0 + lift, 1.0, 1.0)]
    curve = CubicSpline(x, y, bc_type="natural")(np.linspace(0.0, 3.0, 30001))
    beyond = max(curve.max() - max(y), min(y) - curve.min()) / (max(y) - min(y))
    text = KERB.replace("INTERPOLATION", "").replace("[0, 1, 2, 2.1, 3, 4]", str(x))
    text = text.replace("[0, 0, 0, 0.1, 0.1, 0.1]", str(y)).replace("stop_time = 4", "")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        scene = solver.loads(text)
    assert len(scene.warnings) == (beyond > 0.1)


@pytest.mark.parametrize("word", ["monotone", "linear"])
def test_a_driver_along_a_profile_that_does_not_swing_gives_no_warning(word):
    text = KERB.replace("INTERPOLATION", f', interpolation = "{word}"')
    assert solver.loads(text).warnings == ()


def test_a_constraint_along_a_profile_with_corners_gives_a_warning():
    text = KERB.replace("INTERPOLATION", ', interpolation = "linear"')
    text += '[constraints]\nway = { value = "B.y - road(B.x)" }\n'
    text = text.replace("[points]", "[points]\nB = { position = [0, 0], mass = 1 }")
    with pytest.warns(solver.SceneWarning):
        scene = solver.loads(text)
    (problem,) = scene.warnings
    assert problem.location == "constraints.way.value"
    assert problem.message.startswith("moves along the straight lines of 'road', whose rate jumps")


def test_an_unknown_interpolation_lists_the_known_ones():
    with pytest.raises(SceneError) as caught:
        solver.loads(KERB.replace("INTERPOLATION", ', interpolation = "akima"'))
    (problem,) = caught.value.problems
    assert problem.location == "profiles.road.interpolation"
    assert problem.help == "known: cubic, monotone, linear"


def test_the_text_of_a_profile_from_a_file_keeps_its_interpolation(tmp_path):
    """An FMU carries the scene with the points of its files."""
    (tmp_path / "lobe.csv").write_text("0,0\n0.5,1\n1,0\n")
    words = ', periodic = true, interpolation = "monotone" }'
    (tmp_path / "scene.toml").write_text(SCENE.replace("{PROFILE}", '{ file = "lobe.csv"' + words))
    scene = solver.load(tmp_path / "scene.toml")
    (override,) = scene.source.overrides.values()
    name, _, text = override.partition("=")
    assert name == "profiles.lobe"
    again = solver.loads(SCENE.replace("{PROFILE}", text))
    assert again.profiles["lobe"].interpolation == "monotone"
    assert again.profiles["lobe"].curve == scene.profiles["lobe"].curve


CORNERED = """
name = "corners"
dimension = 2
[profiles]
road = { x = [-1, 0, 1], y = [0, 0, 1], interpolation = "linear" }
lobe = { x = [0, 1, 2, "2*pi"], y = [1, 1.1, 1, 1], periodic = true, interpolation = "linear" }
[points]
A = { position = [0, 2], mass = 1 }
[bodies]
shaft = { position = [5, 0], mass = 1, inertia = 1 }
[joints]
j = { type = "revolute", bodies = ["ground", "shaft"], position = [5, 0] }
"""


@pytest.mark.parametrize(
    ("part", "place", "name"),
    [
        ('[contacts]\nc = { type = "profile", point = "A", profile = "road" }', "profile", "road"),
        (
            '[contacts]\nc = { type = "cam", joint = "j", follower = "A", profile = "lobe" }',
            "profile", "lobe",
        ),
        (
            '[contacts]\nc = { type = "surface", point = "A", surface = "y - road(x)" }',
            "surface", "road",
        ),
        ('s = { type = "point_on_surface", point = "A", surface = "y - 2 - road(x)" }', "surface",
         "road"),
    ],
)  # fmt: skip
def test_no_contact_or_surface_has_corners(part, place, name):
    with pytest.raises(SceneError) as caught:
        solver.loads(CORNERED + part)
    (problem,) = caught.value.problems
    assert problem.location.endswith(f".{place}")
    assert problem.message.startswith(f"the profile '{name}' has corners")
    smooth = (CORNERED + part).replace("linear", "monotone")
    assert solver.loads(smooth).profiles[name].interpolation == "monotone"
