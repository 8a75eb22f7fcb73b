"""From numbers to a mechanism: parameters take effect, and contradictions are named.

A parameter that arrives before the first step must do exactly what the same scene does with the
number written in: the tape that evaluates it in the kernel and the reader that folds it in Python
perform the same operations.
"""

from __future__ import annotations

import copy
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
from tests.problems import (
    Array,
    Content,
    assemble,
    double_pendulum,
    four_bar,
    mechanism,
    move,
    observe,
    pendulum,
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


def test_overrides_of_a_scene_do_what_written_numbers_do():
    content = adjustable() | {"solver": {"paired": False, "step_size": 0.02}}
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
    written = start(double_pendulum(), h=0.02, paired=True, formulation="conserving-penalty")
    given_later = Integrator(assemble(double_pendulum(), step_size=0.02))
    given_later["solver.formulation"] = "conserving-penalty"
    assert bits(given_later) == bits(written)
    assert bits(start(double_pendulum(), h=0.02, paired=True)) != bits(written)


def test_a_start_time_shifts_nothing_but_the_time():
    content = four_bar(1)
    one, other = start(content, h=0.01), start(content, h=0.01)
    other.initialise(start_time=100.0)
    one.advance(0.0, 0.5)
    other.advance(100.0, 0.5)
    assert other.time == 100.5
    assert view(other, "q") == pytest.approx(view(one, "q"), abs=1e-12)


# ------------------------------------------------------------------------------- mass and measures


def test_masses_of_bars_and_points_add_up():
    # Vertical force at rest is the weight of everything that hangs: two bars of 3 kg, 0.5 kg.
    content = mechanism(
        "hanging", 2,
        points={
            "O": {"position": [0, 0], "fixed": True},
            "A": {"position": [0, -1]},
            "B": {"position": [0, -2], "mass": 0.5},
        },
        joints={"hook": {"type": "distance", "points": ["ground", "A"], "at": [0, 1]}},
        bodies={"lower": {"type": "bar", "points": ["A", "B"], "mass": 3.0}},
    )  # fmt: skip
    integrator = start(content, h=0.01)
    assert integrator["hook.force"] == pytest.approx(3.5 * 9.81, rel=1e-13)


def flat_four_bar() -> Content:
    """All bars in one line, cranks turning: the rows depend on each other."""
    content = four_bar(2) | {"name": "flat_four_bar"}
    for i in range(3):
        content["points"][f"B{i}"] = {"position": [i + 1.0, 0.0], "velocity": [0.0, 2.0]}
    return content


def first_multipliers(content: Content) -> tuple[Array, Array, Array]:
    """G and the solution (mu, a) of M a + G' mu = Q, G a = -v'Hv, by dense least squares."""
    names = [name for name, point in content["points"].items() if not point.get("fixed")]
    node = {name: place for place, name in enumerate(names)}
    points, dim = content["points"], content["dimension"]
    links = [(body["points"], body["mass"]) for body in content.get("bodies", {}).values()]
    links += [(joint["points"], 0.0) for joint in content.get("joints", {}).values()]
    M, Q = np.zeros((len(names), len(names))), np.zeros((len(names), dim))
    G, curvature = np.zeros((len(links), len(names), dim)), np.zeros(len(links))
    for name, place in node.items():
        M[place, place] += points[name].get("mass", 0.0)
    zero = [0.0] * dim
    for row, (ends, mass) in enumerate(links):
        x = [np.array(points[end]["position"]) for end in ends]
        v = [np.array(points[end].get("velocity", zero)) for end in ends]
        curvature[row] = 2 * (v[1] - v[0]) @ (v[1] - v[0])
        for k, end in enumerate(ends):
            if end not in node:
                continue
            G[row, node[end]] += 2 * (x[k] - x[1 - k])
            for other in ends:
                if other in node:
                    M[node[end], node[other]] += mass / (3 if other == end else 6)
            Q[node[end]] += mass / 2 * np.array(content["gravity"])
    for name, place in node.items():
        Q[place] += points[name].get("mass", 0.0) * np.array(content["gravity"])
    A, flat = np.kron(M, np.eye(dim)), G.reshape(len(links), -1)
    inverse = np.linalg.inv(A)
    right = flat @ inverse @ Q.ravel() + curvature
    mu = np.linalg.lstsq(flat @ inverse @ flat.T, right, rcond=None)[0]
    return flat, mu, inverse @ (Q.ravel() - flat.T @ mu)


@pytest.mark.parametrize(
    ("content", "accuracy"),
    [
        (pendulum(1.0, 2.0), 1e-12),
        (double_pendulum(0.5), 1e-12),
        (four_bar(1), 1e-12),
        (four_bar(3), 1e-12),
        (flat_four_bar(), 1e-7),
    ],
    ids=lambda value: value["name"] if isinstance(value, dict) else "",
)
def test_the_first_multipliers_and_accelerations_are_those_of_the_dense_equations(
    content, accuracy
):
    # Multipliers of dependent rows are not determined, their forces G' mu are: with half of the
    # digits, since the start is regularised by 1e-8 and nothing else keeps its matrix from rank
    # loss.
    integrator = start(content, h=0.01)
    G, mu, acceleration = first_multipliers(content)
    found = view(integrator, "a_first").ravel()
    assert found == pytest.approx(acceleration, rel=accuracy, abs=10 * accuracy)
    assert G.T @ view(integrator, "mu_first") == pytest.approx(
        G.T @ mu, rel=accuracy, abs=10 * accuracy
    )


# ------------------------------------------------------------------------------ mistakes are named


def broken(change: Any) -> Content:
    content = copy.deepcopy(double_pendulum())
    change(content)
    return content


MISTAKES = {
    "mass of a free point": (
        lambda c: c["points"]["A"].update(mass=0.0),
        ["points.A", "free point 'A' has no mass", "give it a mass"],
    ),
    "drawn length": (
        lambda c: c["joints"]["rod1"].update(length=1.5),
        ["joints.rod1", "length is 1.5 m", "1 m apart"],
    ),
    "velocity along a rod": (
        lambda c: c["points"]["A"].update(velocity=[1.0, 0.0]),
        ["joints.rod1", "velocities", "1 m/s", "0 m/s"],
    ),
    "points that coincide": (
        lambda c: c["points"]["B"].update(position=c["points"]["A"]["position"]),
        ["joints.rod2", "coincide"],
    ),
    "negative stiffness": (
        lambda c: c.update(
            forces={"s": {"type": "spring", "points": ["O", "B"], "stiffness": -5.0}}
        ),
        ["forces.s.stiffness", "must be >= 0 N/m", "got -5"],
    ),
}


@pytest.mark.parametrize("change", MISTAKES.values(), ids=MISTAKES)
def test_a_mistake_in_a_scene_names_part_value_unit_and_rule(change):
    with pytest.raises(solver.SceneError) as caught:
        assemble(broken(change[0]))
    report = str(caught.value)
    assert all(word in report for word in change[1]), report


@pytest.mark.parametrize("rate", [3.7, 1e2, 1e3, 1e4])
@pytest.mark.parametrize("angle", [0.1, 1.0, 2.3])
def test_a_velocity_across_a_rod_is_accepted_whatever_its_rounding_along_it(angle, rate):
    start(pendulum(angle, rate), h=0.1 / rate)


def test_all_mistakes_of_a_mechanism_are_reported_together():
    content = double_pendulum()
    content["joints"]["rod1"]["length"] = 1.5
    content["joints"]["rod2"]["length"] = 0.5
    with pytest.raises(solver.SceneError) as caught:
        assemble(content)
    assert len(caught.value.problems) == 2


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
