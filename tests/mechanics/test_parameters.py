"""Parameters take effect: what arrives before the first step acts like a number in the scene.

The tape that evaluates a parameter in the kernel and the reader that folds a number in Python
perform the same operations, so the motions agree bit for bit.
"""

from __future__ import annotations

import json
import math
import re
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import solver
from solver.runtime import AssemblyError, Integrator, OptionError
from solver.runtime.model_writing import rules_of_laws
from tests.support.mechanisms.problems import (
    Content,
    assemble,
    double_pendulum,
    four_bar,
    mechanism,
    move,
    observe,
    start,
    view,
)

VALUES = {"mass": 1.7, "arm": 0.8, "stiffness": 33.0, "free": 0.4, "damping": 0.3, "speed": 1.3}


def adjustable(values: dict[str, float] | None = None) -> Content:
    """A bar with a spring and a damper in which parameters say everything, or `values` do."""
    text = {name: name for name in VALUES} if values is None else values

    def number(expression: str) -> Any:
        """The expression, or with the numbers written in: `arm` becomes 0.8 wherever it stands."""
        if values is None:
            return expression
        return re.sub("|".join(VALUES), lambda found: repr(values[found[0]]), expression)

    points: Content = {
        "O": {"position": [number("0.1*arm"), 0.0], "fixed": True},
        "A": {"position": [number("1.1*arm"), 0.0], "velocity": [0.0, number("speed")]},
        "B": {
            "position": [number("1.1*arm"), number("-sqrt(arm*arm/4)")],
            "velocity": [0.0, number("speed")],
            "mass": number("mass/2 + 0.1"),
        },
    }
    ends = {"points": ["ground", "B"], "at": [0.0, number("-2*arm")]}
    spring = {"type": "spring", "stiffness": text["stiffness"], "free_length": text["free"]} | ends
    parameters = {"parameters": {name: {"value": 1.0} for name in VALUES}} if values is None else {}
    return mechanism(
        "adjustable", 2, points=points,
        bodies={"bar": {"type": "bar", "points": ["O", "A"], "mass": text["mass"]}},
        joints={"rod": {"type": "distance", "points": ["A", "B"], "length": number("arm/2")}},
        forces={"tie": spring, "brake": {"type": "damper", "damping": text["damping"]} | ends},
        **parameters,
    )  # fmt: skip


def bits(integrator: Integrator, n_steps: int = 40) -> bytes:
    """Coordinates, velocities and multipliers after some steps, bit for bit."""
    move(integrator, 0.02, n_steps)
    names = ("q", "q_low", "v", "v_low", "mu_first", "mu_second")
    return b"".join(view(integrator, name).tobytes() for name in names)


# -------------------------------------------------------------------------- parameters take effect


@given(st.fixed_dictionaries({name: st.floats(0.2, 5.0) for name in VALUES}))
def test_set_parameters_do_what_written_numbers_do(values):
    written, parameters = start(adjustable(values), h=0.02), start(adjustable(), h=0.02)
    for name, value in values.items():
        parameters[name] = value
    assert bits(parameters) == bits(written)


JOINTED = """
name = "jointed"
gravity = [0, 0, -9.81]
[parameters]
arm = {arm}
tilt = {tilt}
mass = {mass}
thin = {thin}
[bodies.crank]
position = ["arm/2", 0, 0]
mass = "mass"
inertia = ["thin", "mass*arm**2/12", "mass*arm**2/12 + thin"]
orientation = {{ rotation_vector = [0, "-tilt", 0] }}
points = {{ tip = ["arm*0.6", 0, "thin"] }}
[bodies.rod]
position = ["arm", 0, "-arm/2"]
center_of_mass = [0, 0, "arm/10"]
mass = "2*mass"
inertia = [0.1, 0.2, "0.1 + thin"]
[joints.a]
type = "revolute"
bodies = ["ground", "crank"]
position = [0, 0, 0]
axis = ["tilt", 1, 0]
[joints.b]
type = "universal"
bodies = ["crank", "rod"]
position = ["arm", 0, 0]
axes = [[0, 1, 0], [1, 0, 0]]
[joints.c]
type = "distance"
points = ["rod", "ground"]
at = [0, 0, "-arm"]
[forces]
d = {{ type = "torsion_spring", joint = "a", stiffness = "mass", free_angle = "tilt" }}
[solver]
step_size = 0.01
"""


@given(
    arm=st.floats(0.5, 2.0), tilt=st.floats(-0.4, 0.4), mass=st.floats(0.5, 2.0),
    thin=st.floats(0.01, 0.05),
)  # fmt: skip
def test_set_parameters_of_bodies_and_joints_do_what_written_numbers_do(arm, tilt, mass, thin):
    # Which perpendicular vectors a joint takes was decided with the default values and is kept, so
    # that rows may differ, and rounding with them.
    values = {"arm": arm, "tilt": tilt, "mass": mass, "thin": thin}
    usual = {"arm": 1.0, "tilt": 0.1, "mass": 1.0, "thin": 0.02}
    written = Integrator(solver.assemble(solver.loads(JOINTED.format(**values))))
    changed = Integrator(solver.assemble(solver.loads(JOINTED.format(**usual))))
    for name, value in values.items():
        changed[name] = value
    for integrator in (written, changed):
        for _ in range(20):
            integrator.advance(integrator.time, 0.01)
    for name in ("crank.tip.z", "rod.x", "rod.vy", "a.angle", "energy.potential"):
        assert changed[name] == pytest.approx(written[name], rel=1e-9, abs=1e-9)


def test_overrides_of_a_scene_do_what_written_numbers_do():
    content = adjustable() | {"solver": {"step_size": 0.02}}
    content["experiment"] = {"stop_time": 1.0, "step_size": 0.02}
    scene = solver.loads(json.dumps(content), name="a.json", format="json", overrides=VALUES)
    assert bits(Integrator(solver.assemble(scene))) == bits(start(adjustable(VALUES), h=0.02))


@pytest.mark.parametrize("name", VALUES)
def test_every_parameter_changes_the_motion(name):
    first, second = start(adjustable(), h=0.02), start(adjustable(), h=0.02)
    second[name] = 1.25
    assert bits(first) != bits(second)


def test_a_parameter_set_after_assembly_assembles_again():
    integrator = start(adjustable(), h=0.02)
    assert integrator["A.x"] == pytest.approx(1.1)
    integrator["arm"] = 2.0
    assert integrator["A.x"] == pytest.approx(2.2)
    assert integrator["B.y"] == pytest.approx(-1.0)


def test_reset_forgets_parameters_and_motion():
    integrator = start(adjustable(), h=0.02)
    fresh = bits(integrator)
    integrator.reset()
    integrator["mass"] = 3.0
    assert bits(integrator) != fresh
    integrator.reset()
    assert integrator["mass"] == 1.0
    assert bits(integrator) == fresh


def test_a_fixed_parameter_is_refused_once_the_mechanism_moves():
    integrator = start(adjustable(), h=0.02)
    integrator.advance(0.0, 0.02)
    with pytest.raises(OptionError, match=r"^mass: is a fixed parameter"):
        integrator["mass"] = 2.0
    assert integrator["mass"] == 1.0


def test_settings_of_the_solver_take_effect():
    written = start(double_pendulum(), h=0.02, penalty=1e10)
    given_later = Integrator(assemble(double_pendulum(), step_size=0.02))
    given_later["solver.penalty"] = 1e10
    assert bits(given_later) == bits(written)
    assert bits(start(double_pendulum(), h=0.02)) != bits(written)


def test_a_start_time_shifts_nothing_but_the_time():
    content = four_bar(1)
    one, other = start(content, h=0.01), start(content, h=0.01)
    other.initialise(start_time=100.0)
    one.advance(0.0, 0.5)
    other.advance(100.0, 0.5)
    assert other.time == 100.5
    assert view(other, "q") == pytest.approx(view(one, "q"), abs=1e-12)


@pytest.mark.parametrize(
    ("name", "value", "words"),
    [
        ("mass", -1.0, ["body 'bar'", "mass must be > 0 kg", "-1.0"]),
        ("stiffness", -2.0, ["force 'tie'", "stiffness must be >= 0 N/m", "-2.0"]),
        ("damping", -3.0, ["force 'brake'", "damping must be >= 0 N.s/m", "-3.0"]),
        ("arm", -1.0, ["joint 'rod'", "length must be > 0 m"]),
    ],
)
def test_a_parameter_that_breaks_a_rule_is_named_when_the_mechanism_is_assembled(
    name, value, words
):
    integrator = Integrator(assemble(adjustable(), step_size=0.02))
    integrator[name] = value
    with pytest.raises(AssemblyError) as caught:
        integrator.initialise()
    assert all(word in str(caught.value) for word in words), str(caught.value)
    integrator[name] = 1.0
    integrator.initialise()
    assert np.isfinite(observe(integrator, 0.02, 5, ["energy.total"])).all()


@pytest.mark.parametrize("value", [math.nan, math.inf, "1"])
def test_a_parameter_that_is_no_number_is_refused(value):
    integrator = Integrator(assemble(adjustable(), step_size=0.02))
    with pytest.raises(OptionError, match=r"^mass: must be a finite number"):
        integrator["mass"] = value
    assert integrator["mass"] == 1.0


# ----------------------------------------------------------------------------- rules, while moving


def turned(stiffness: str) -> Content:
    """A point on a spring whose stiffness can be turned while it moves."""
    points = {
        "O": {"position": [0.0, 0.0], "fixed": True},
        "A": {"position": [1.0, 0.0], "mass": 1.0},
    }
    ends = {"points": ["O", "A"], "free_length": 0.4}
    return mechanism(
        "turned", 2, points=points,
        inputs={"u": {"start": 10.0}, "push": {}},
        parameters={"k": {"value": 7.0, "variability": "tunable"}},
        forces={
            "tie": {"type": "spring", "stiffness": stiffness} | ends,
            "wind": {"type": "force", "point": "A", "value": ["push", 0.0]},
        },
    )  # fmt: skip


@pytest.mark.parametrize(
    ("stiffness", "name", "value"),
    [("u", "u", -5.0), ("2*u - 1", "u", -2.0), ("k", "k", -5.0), ("k*t + u", "k", -500.0)],
)
def test_a_rule_is_kept_in_motion_and_a_value_that_breaks_it_changes_nothing(
    stiffness, name, value
):
    model = assemble(turned(stiffness), step_size=0.01)
    one, other = Integrator(model), Integrator(model)
    for integrator in (one, other):
        integrator.advance(0.0, 0.1)
    places = [model.index("push"), model.index(name)]
    with pytest.raises(OptionError, match=r"^force 'tie': stiffness must be >= 0 N/m, got -"):
        one.set(places, [3.0, value])
    assert one["push"] == 0.0
    for integrator in (one, other):
        integrator.advance(0.1, 0.1)
    assert one.save() == other.save()


def test_plain_inputs_are_not_checked_against_rules_in_motion():
    # Setting them is part of every communication step, and copies nothing.
    assert not rules_of_laws(assemble(turned("5.0")))
    (rule,) = rules_of_laws(assemble(turned("k")))
    assert (rule.location, rule.name) == ("forces.tie", "force 'tie'")
    assert rule.message.startswith("stiffness must be")


def test_a_rule_about_an_expression_of_inputs_is_checked_at_assembly():
    integrator = Integrator(assemble(turned("2*u - 1"), step_size=0.01))
    integrator["u"] = -2.0
    with pytest.raises(AssemblyError, match=r"stiffness must be >= 0 N/m, got -5\.0"):
        integrator.initialise()
