"""From a scene to a mechanism: masses, first multipliers, and contradictions that are named."""

from __future__ import annotations

import copy
from typing import Any

import numpy as np
import pytest

import solver
from tests.problems import (
    Array,
    Content,
    assemble,
    double_pendulum,
    four_bar,
    mechanism,
    pendulum,
    start,
    view,
)

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
