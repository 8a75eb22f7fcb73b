"""Extreme numbers: masses, lengths, stiffnesses and speeds many powers of ten apart.

Energy error is relative to the largest energy exchanged so far (`energy.error`).
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from tests.problems import (
    GRAVITY,
    Content,
    chain,
    double_pendulum,
    free_system,
    mechanism,
    observe,
    pendulum,
    start,
)

NAMES = ["energy.error", "constraint.position"]
PAIRED = pytest.mark.parametrize("paired", [False, True], ids=["plain", "pairs"])


@PAIRED
@pytest.mark.parametrize("ratio", [1e-6, 1e-3, 1e3, 1e6])
def test_masses_may_differ_by_six_powers_of_ten(ratio, paired):
    content = double_pendulum(1.0)
    content["points"]["B"]["mass"] = ratio
    assert observe(start(content, h=0.01, paired=paired), 0.01, 500, NAMES).max() < 1e-12


@pytest.mark.parametrize("mass", [1e-12, 1e-6, 1e6, 1e12])
def test_the_unit_of_mass_does_not_matter(mass):
    # All masses times a power of two would give the same bits; a power of ten, the same round-off.
    content = double_pendulum(1.0)
    for name in "AB":
        content["points"][name]["mass"] = mass
    assert observe(start(content, h=0.01), 0.01, 500, NAMES).max() < 1e-12


@pytest.mark.parametrize("length", [1e-6, 1e-3, 1e3, 1e6])
def test_the_unit_of_length_does_not_matter(length):
    # Steps of the same angle: the time of a pendulum grows as the root of its length.
    h = 0.01 * math.sqrt(length)
    content = chain(2, length=length)
    content["experiment"] = {"stop_time": 1e4 * h, "step_size": 10 * h}
    assert observe(start(content, h=h), h, 500, NAMES).max() < 1e-12


@pytest.mark.parametrize("length", [1e-3, 1e3, 1e6])
def test_neighbouring_rods_may_differ_in_length(length):
    # The shorter rod sets the step; one of 1 mm swings a hundred times faster than one of 10 m.
    content = double_pendulum(1.0)
    x, y = content["points"]["A"]["position"]
    content["points"]["B"]["position"] = [x + length, y]
    h = 0.01 * min(1.0, math.sqrt(length))
    assert observe(start(content, h=h), h, 500, NAMES).max() < 1e-12


@pytest.mark.parametrize("away", [1e3, 1e6])
def test_a_mechanism_far_from_the_origin_loses_no_digits(away):
    # Increments and differences of positions are formed before anything else; drawn lengths keep
    # the digits that positions of 1e6 m leave them, 1e-10.
    content = double_pendulum(1.0)
    for point in content["points"].values():
        point["position"][0] += away
    assert observe(start(content, h=0.01), 0.01, 500, NAMES).max() < 1e-12


def spring_pendulum(stiffness: float) -> Content:
    points = {"A": {"position": [1.0, 0.0], "mass": 1.0}}
    tie = {"type": "spring", "points": ["ground", "A"], "at": [0, 0], "stiffness": stiffness}
    return mechanism("stiff", 2, points=points, forces={"tie": tie})


@pytest.mark.filterwarnings("ignore:the energy is off by")
@pytest.mark.parametrize("h", [1e-3, 1e-2])
@pytest.mark.parametrize("stiffness", [1.0, 1e3, 1e6, 1e9, 1e12])
def test_a_spring_may_be_as_stiff_as_a_rod(stiffness, h):
    # Its length is known to 2e-16, so its force to 2e-16 k and the energy of a step, through 0.05
    # m, to 1e-17 k; 500 steps of either sign make 2e-16 k, with a factor of ten to spare.
    error = observe(start(spring_pendulum(stiffness), h=h), h, 500, ["energy.balance"])
    assert np.abs(error).max() < 1e-12 * GRAVITY + 2e-15 * stiffness


def test_springs_of_very_different_stiffness_act_in_one_mechanism():
    content = free_system(2)
    content["forces"]["left"]["stiffness"] = 1e6
    content["forces"]["long"]["stiffness"] = 1e-6
    assert observe(start(content, h=0.001), 0.001, 500, NAMES).max() < 1e-12


@pytest.mark.parametrize("rate", [1e1, 1e2])
def test_a_fast_pendulum_keeps_its_energy_at_a_radian_a_step(rate):
    assert observe(start(pendulum(1.0, rate), h=1.0 / rate), 1.0 / rate, 500, NAMES).max() < 1e-12


@pytest.mark.parametrize("h", [0.5, 1.0, 3.0])
def test_a_free_system_survives_steps_of_radians(h):
    # Beyond 1 rad a step is halved inside; it stays exact in energy.
    content = free_system(3) | {"forces": {}}
    assert observe(start(content, h=h), h, 300, NAMES).max() < 1e-12
