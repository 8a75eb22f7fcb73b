"""Scenes by the paper's method: they move as by the core, and other right values are met."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import solver
from solver import paper
from solver.paper import FORMULATIONS
from solver.runtime import OptionError
from tests.exact_motions import pendulum_angle
from tests.problems import double_pendulum, pendulum, scene

SCENES = Path(__file__).parents[2] / "scenes"


@pytest.mark.parametrize(
    ("name", "method"),
    [
        ("double_pendulum", {}),
        ("double_pendulum", {"algorithm": "simultaneous"}),
        ("double_pendulum", {"formulation": "conserving-al-beta"}),
        ("four_bar", {}),
        ("heavy_top", {}),
    ],
    ids=str,
)
def test_a_scene_moves_as_by_the_core(name: str, method: dict[str, str]):
    # 100 steps, and 20 of a top with 12 coordinates, two of the paper's for each pair of the core.
    # What differs is round-off: 1e-16 of Phi is 2e-16/h of the velocities. Forces are means there.
    model = solver.assemble(solver.load(SCENES / f"{name}.toml"))
    h = model.settings["step_size"]
    stop = (20 if name == "heavy_top" else 100) * h
    ours = paper.simulate(model, stop_time=stop, step_size=0.5 * h, **method)
    core = solver.simulate(model, stop_time=stop, step_size=h, internal_step=h, order=2)
    ends = (".x", ".y", ".z", ".vx", ".vy", ".vz", "energy.total", ".qw", ".qx")
    names = [x for x in core if x.endswith(ends) and ".force" not in x]
    assert len(names) > 8
    for output in names:
        size = max(np.abs(core[output]).max(), 1.0)
        assert np.abs(ours.values[output][::2] - core[output]).max() < 1e-10 * size, output


def test_a_pendulum_of_a_scene_swings_as_elliptic_functions_tell():
    # Second order: a quarter of the error with half the step.
    errors = []
    for h in (0.02, 0.01):
        run = paper.simulate(scene(pendulum(1.0)), stop_time=1.0, step_size=h)
        errors.append(np.abs(run.values["A.x"] - np.sin(pendulum_angle(run.t, 1.0))).max())
    assert errors[0] / errors[1] == pytest.approx(4.0, rel=0.1)
    assert errors[1] < 1e-3


TIED = """
name = "tied"
dimension = 2
gravity = [0, -9.81]
[points]
O = { position = [0, 0], fixed = true }
A = { position = [1.1, 0.0], velocity = [0.1, 1.0], mass = 2.0 }
B = { position = [1.9, 0.3], mass = 1.0 }
[constraints]
curve = { value = "exp(A.x)*cos(A.y) + 0.2*distance(O, B)**3 - exp(1.1) - 0.2*3.70**1.5" }
[forces]
spring = { type = "spring", points = ["A", "B"], stiffness = 40.0, free_length = 0.6 }
[solver]
assemble = true
step_size = 0.02
"""


@pytest.mark.parametrize("formulation", ["conserving-al", "conserving-al-beta"])
def test_a_formula_of_places_and_a_spring_keep_their_energy(formulation: str):
    # T + m g y + k (l - l_0)^2/2 from the outputs alone, some 10 J, in 50 large steps.
    run = paper.simulate(solver.loads(TIED), stop_time=1.0, formulation=formulation)
    x = run.values
    kinetic = x["A.vx"] ** 2 + x["A.vy"] ** 2 + 0.5 * (x["B.vx"] ** 2 + x["B.vy"] ** 2)
    length = np.hypot(x["A.x"] - x["B.x"], x["A.y"] - x["B.y"])
    energy = kinetic + 9.81 * (2.0 * x["A.y"] + x["B.y"]) + 20.0 * (length - 0.6) ** 2
    curve = np.exp(x["A.x"]) * np.cos(x["A.y"]) + 0.2 * np.hypot(x["B.x"], x["B.y"]) ** 3
    assert np.ptp(kinetic) > 1.0
    assert np.ptp(energy) < 1e-11
    assert np.ptp(curve) < 1e-12
    assert np.abs(x["energy.balance"]).max() < 1e-11


@pytest.mark.parametrize("formulation", FORMULATIONS)
def test_every_formulation_takes_a_formula(formulation: str):
    # The core's motion of order 8 on the first 0.1 s, up to what steps of 5 ms and penalties leave.
    run = paper.simulate(
        solver.loads(TIED), stop_time=0.1, step_size=0.005, formulation=formulation, penalty=1e5
    )
    exact = solver.simulate(solver.loads(TIED), stop_time=0.1, step_size=0.1, tolerance=1e-10)
    for name in ("A.x", "A.y", "B.x", "B.y"):
        assert run.values[name][-1] == pytest.approx(exact[name][-1], abs=2e-4)


GEARS = """
name = "gears"
dimension = 2
[bodies]
wheel = { position = [0, 0], mass = 1.0, inertia = 0.5, angular_velocity = 3.0 }
pinion = { position = [1, 0], mass = 1.0, inertia = 0.1, angular_velocity = -9.0 }
[joints]
first = { type = "revolute", bodies = ["ground", "wheel"], position = [0, 0] }
second = { type = "revolute", bodies = ["ground", "pinion"], position = [1, 0] }
mesh = { type = "gear", joints = ["first", "second"], ratio = -3.0 }
[forces]
brake = { type = "torsion_damper", joint = "second", damping = 0.02 }
[solver]
step_size = 0.02
"""


def test_gears_turn_on_beyond_half_a_turn_and_a_damper_slows_them():
    # J = 0.5 + 9 * 0.1 about the first axis is slowed by c = 9 * 0.02: it turns by
    # w_0 J/c (1 - exp(-c t/J)). Steps turn the pinion by 0.18 rad, whose square over 12 is 3e-3.
    run = paper.simulate(solver.loads(GEARS), stop_time=0.5)
    turned = 3.0 * 1.4 / 0.18 * (1.0 - np.exp(-0.5 * 0.18 / 1.4))
    assert 3.0 * turned > np.pi
    assert run.values["first.angle"][-1] == pytest.approx(turned, rel=3e-3)
    assert run.values["second.angle"][-1] == pytest.approx(-3.0 * turned, rel=3e-3)
    lost = 0.5 * 1.4 * 9.0 * (1.0 - np.exp(-2.0 * 0.5 * 0.18 / 1.4))
    assert run.values["energy.dissipated"][-1] == pytest.approx(lost, rel=1e-2)
    assert np.abs(run.values["energy.balance"]).max() < 1e-12


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("bouncing_ball", "contacts and friction"),
        ("slider_crank", "drivers"),
        ("rolling_disc", "rolling"),
        ("bifilar", "laws of time"),
    ],
)
def test_what_the_method_does_not_take_is_refused_in_words(name: str, words: str):
    with pytest.raises(OptionError, match=rf"takes no .*{words}.*default formulation"):
        paper.simulate(SCENES / f"{name}.toml", stop_time=0.1)


def test_a_wrong_setting_is_refused_with_its_rule():
    content = scene(double_pendulum())
    with pytest.raises(OptionError, match=r"'leapfrog' one of conserving-al"):
        paper.simulate(content, formulation="leapfrog")
    with pytest.raises(OptionError, match=r"penalty -1.0 must be > 0"):
        paper.simulate(content, penalty=-1.0)
