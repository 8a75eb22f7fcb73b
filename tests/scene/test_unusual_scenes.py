"""Texts and numbers that no scene should have end in a report that can be printed."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import pytest

import solver
from solver.scene import SceneError
from solver.scene.draft import MOST
from tests.support.mechanisms.nested_data import paths_of

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

SCENES = Path(__file__).parents[2] / "scenes"
PLANAR = {
    "name": "odd",
    "dimension": 2,
    "parameters": {"p": {"value": 1.0, "unit": "m"}},
    "points": {"O": {"position": [0, 0], "fixed": True}, "A": {"position": ["p", 0], "mass": 1}},
    "bodies": {"b": {"type": "bar", "points": ["O", "A"], "mass": 1.0}},
}
SPATIAL = {
    "name": "odd",
    "bodies": {"b": {
        "position": [0, 0, 0], "mass": 1, "inertia": [1, 1, 1],
        "orientation": {"axis": [0, 0, 1], "angle": 0.2},
    }, "c": {
        "position": [0, 0, 0], "mass": 1, "inertia": [[2, 0.1, 0], [0.1, 2, 0], [0, 0, 2]],
        "orientation": {"quaternion": [1, 0.1, 0, 0]}, "angular_velocity": [0, 0, 1],
    }},
    "joints": {"j": {"type": "revolute", "bodies": ["ground", "b"], "position": [0, 0, 0],
                     "axis": [0, 0, 1]}},
}  # fmt: skip


def report(text, **options):
    """Report of a scene that is read and assembled; None for one without mistakes."""
    try:
        solver.assemble(solver.loads(text, **options))
    except SceneError as error:
        return str(error).encode("utf-8").decode()
    return None


def replaced(data, path, value):
    """Copy of nested tables with one value changed."""
    copied = json.loads(json.dumps(data))
    owner = copied
    for step in path[:-1]:
        owner = owner[step]
    owner[path[-1]] = value
    return copied


@pytest.mark.filterwarnings("ignore::solver.SceneWarning")
@pytest.mark.parametrize("extreme", [1e-320, 1e-200, 1e-160, 1e99, 1e150, 1e200, 1.7e308, -1e200])
@pytest.mark.parametrize("data", [PLANAR, SPATIAL], ids=["planar", "spatial"])
def test_a_number_of_any_size_is_taken_or_reported(data, extreme):
    for path, value in paths_of(data):
        if isinstance(value, (int, float)) and not isinstance(value, bool):
            report(json.dumps(replaced(data, path, extreme)), format="json")


LONG = {"decimal": "1" * 5000, "hexadecimal": "0x" + "f" * 5000, "negative": "-" + "7" * 4400}


@pytest.mark.parametrize("number", LONG)
@pytest.mark.parametrize("place", ["name", "dimension", "points.A.mass", "solver.order", "x"])
def test_an_integer_of_thousands_of_digits_is_reported(place, number):
    toml = f"{place} = {LONG[number]}\n"
    assert report(json.dumps(PLANAR), format="json", overrides={place: LONG[number]})
    assert "digits" in str(report(toml))
    if number != "hexadecimal":
        assert "digits" in str(report(f'{{"{place}": {LONG[number]}}}', format="json"))


@pytest.mark.parametrize(
    "path",
    [
        ("name",),
        ("points",),
        ("points", "A"),
        ("points", "A", "mass"),
        ("bodies", "b", "points", 0),
        ("parameters", "p", "unit"),
    ],
)
def test_half_a_character_is_reported(path):
    half = "\ud800"
    assert report(json.dumps(replaced(PLANAR, path, half)), format="json")
    assert report(json.dumps(replaced(PLANAR, path, {half: 1})), format="json")
    assert report(json.dumps(PLANAR), format="json", overrides={"points.A." + half: 1})
    assert report(json.dumps(PLANAR), format="json", overrides={"points.A.mass": half})


@pytest.mark.parametrize("power", ["2", "9", "-9", "99", "9" * 400, "-" + "9" * 400])
@pytest.mark.parametrize("unit", ["m", "mm", "GPa", "N.GPa", "mm9.mm"])
def test_a_power_of_a_unit_is_known_or_reported(unit, power):
    report(json.dumps(replaced(PLANAR, ("parameters", "p", "unit"), unit + power)), format="json")
    report(json.dumps(replaced(PLANAR, ("points", "A", "mass"), f"2 {unit}{power}")), format="json")


def test_of_thousands_of_mistakes_some_are_listed():
    wrong = {f"p{k}": f"q{k}" for k in range(3000)}
    text = report(json.dumps(PLANAR | {"parameters": wrong}, indent=0), format="json")
    assert text is not None
    assert text.count("unknown symbol") == MOST + 1
    assert f"more than {MOST} mistakes" in text


@pytest.mark.filterwarnings("ignore::solver.SceneWarning")
@pytest.mark.parametrize("name", ["four_bar", "spatial_slider_crank", "watt"])
def test_positions_of_scenes_may_be_anywhere(name):
    data = tomllib.loads((SCENES / f"{name}.toml").read_text("utf-8"))
    for path, value in paths_of(data):
        if "position" in path and isinstance(value, (int, float)):
            for extreme in (1e-300, 1e90, 1e200):
                report(json.dumps(replaced(data, path, extreme)), format="json")
