"""Overrides: any number of a scene can be replaced, and mistakes name the override."""

import math
from pathlib import Path

import numpy as np
import pytest

from solver.scene import SceneError, loads, parse
from solver.scene.fields import shown
from tests.support.mechanisms.short_scene import SHORT


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
        ("solver.start", "equilibrium", lambda s: s.solver.start, "equilibrium"),
        ("solver.assemble", "true", lambda s: s.solver.assemble, True),
        ("experiment.stop_time", 3, lambda s: s.experiment.stop_time, 3.0),
        ("joints.rod.length", 1.0, lambda s: s.joints["rod"].length, 1.0),
        ("name", "other", lambda s: s.name, "other"),
    ],
)
def test_any_number_can_be_replaced(name, value, read, expected):
    assert read(loads(SHORT, overrides={name: value})) == expected


@pytest.mark.parametrize(
    ("name", "value", "read", "expected"),
    [
        ("bodies.b1.points.tip[0]", 2, lambda s: s.bodies["b1"].points["tip"], (2.0, 0.0)),
        ("bodies.b4.shape.density", 5, lambda s: s.bodies["b4"].mass, 10.0),
        ("bodies.b1.orientation", "pi", lambda s: s.bodies["b1"].orientation, math.pi),
        ("joints.j3.axis", "[0, 1]", lambda s: s.joints["j3"].axis, (0.0, 1.0)),
        ("joints.j7.radius", -1, lambda s: s.joints["j7"].radius, -1.0),
        ("solver.assemble", True, lambda s: s.solver.assemble, True),
    ],
)
def test_numbers_of_bodies_and_joints_can_be_replaced(name, value, read, expected):
    text = (Path(__file__).parents[1] / "whole_scenes" / "plane.toml").read_text(encoding="utf-8")
    assert read(loads(text, overrides={name: value})) == expected


@pytest.mark.parametrize(
    ("name", "value", "report"),
    [
        (
            "points.A.mas",
            "2",
            "error: points.A.mas: unknown field\n     = help: did you mean 'mass'?",
        ),
        (
            "points.A.mass",
            "2mm",
            "error: points.A.mass: is 2mm, and must be in kg\n"
            '     = help: write for instance "250 g"',
        ),
        (
            "points.A.mass",
            "-2",
            "error: points.A.mass: must be >= 0 kg, got -2",
        ),
        (
            "points.A.mass",
            math.nan,
            "error: points.A.mass: must be a finite number, got nan",
        ),
        (
            "points.B.mass",
            "2",
            "error: points.B.mass: no such thing in the scene\n"
            "     = help: did you mean 'points.A.mass'?",
        ),
        (
            "lenght",
            2.0,
            "error: lenght: unknown name\n     = help: did you mean 'length'?",
        ),
        (
            "length",
            "2*",
            "error: parameters.length: not an expression, column 3 of '2*'",
        ),
        (
            "points.A.position[2]",
            1,
            "error: points.A.position[2]: "
            "no such thing in the scene\n"
            "     = help: did you mean 'points.A.position'?",
        ),
    ],
)
def test_mistakes_in_overrides_name_the_override(name, value, report):
    with pytest.raises(SceneError) as caught:
        loads(SHORT, overrides={name: value})
    assert str(caught.value) == f"overrides[{name!r}]={shown(value)}: {report}"


def test_an_override_can_correct_a_mistake_of_the_file():
    wrong = SHORT.replace("mass = 2", "mass = -2")
    with pytest.raises(SceneError):
        loads(wrong)
    assert loads(wrong, overrides={"points.A.mass": 2}) == loads(SHORT)


@pytest.mark.parametrize(
    ("name", "meant"),
    [
        ("stop_time", "'experiment.stop_time'"),
        ("penalty", "'solver.penalty'"),
        ("step_size", "'solver.step_size' or 'experiment.step_size'"),
    ],
)
def test_a_field_of_solver_or_experiment_without_its_table_is_suggested_with_it(name, meant):
    with pytest.raises(SceneError) as caught:
        loads(SHORT, overrides={name: 3})
    assert f"did you mean {meant}?" in str(caught.value)


@pytest.mark.parametrize("power", [20, 21, 29, 300, 309, 5000])
def test_the_digits_of_a_long_integer_are_counted_exactly(power):
    assert shown(10**power) == f"an integer of {power + 1} digits"
    assert shown(1 - 10 ** (power + 1)) == f"an integer of {power + 1} digits"
