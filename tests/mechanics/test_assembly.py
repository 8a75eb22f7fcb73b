"""From a scene to a mechanism: masses, first multipliers, and contradictions that are named."""

from __future__ import annotations

import copy
from typing import Any

import pytest

import solver
from tests.support.mechanisms.problems import (
    Content,
    assemble,
    double_pendulum,
    mechanism,
    pendulum,
    start,
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
