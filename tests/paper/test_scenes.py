"""Scenes by the paper's method: they move as by the core, and other right values are met."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import solver
from solver.paper import FORMULATIONS
from solver.runtime import OptionError, StepError
from tests.support.mechanisms.problems import double_pendulum, scene

SCENES = Path(__file__).parents[2] / "scenes"


@pytest.mark.parametrize(
    ("name", "method"),
    [
        ("double_pendulum", {"formulation": "conserving-al"}),
        ("double_pendulum", {"algorithm": "simultaneous"}),
        ("double_pendulum", {"formulation": "conserving-al-beta"}),
        ("four_bar", {"multiplier_update": "end"}),
        ("heavy_top", {"formulation": "conserving-al"}),
        ("slider_crank", {"formulation": "conserving-al"}),
        ("bricard", {"formulation": "conserving-al"}),
        ("triangle", {"formulation": "conserving-al"}),
        ("car_axis", {"formulation": "conserving-al"}),
        ("car_axis", {"algorithm": "simultaneous"}),
    ],
    ids=str,
)
def test_a_scene_moves_as_by_the_core(name: str, method: dict[str, str]):
    # Twenty pairs of half steps of the core, each two steps here. What differs is round-off: 1e-16
    # of Phi is 2e-16/h of the velocities. Forces are not compared, as rows of Bricard's linkage
    # depend on each other; nor dampers, which act along other gradients in the core.
    model = solver.assemble(solver.load(SCENES / f"{name}.toml"))
    h = model.settings["step_size"]
    run, given = {"stop_time": 20 * h, "step_size": h}, {"internal_step": 0.5 * h}
    ours = solver.simulate(model, **run, **given, **method)
    core = solver.simulate(model, **run, internal_step=h, order=2)
    ends = (".x", ".y", ".z", ".vx", ".vy", ".vz", "energy.total", "energy.work", ".qw", ".qx")
    names = [x for x in core if x.endswith(ends) and "force." not in x and "torque." not in x]
    assert len(names) > 8
    for output in names:
        size = max(np.abs(core[output]).max(), 1.0)
        assert np.abs(ours[output] - core[output]).max() < 3e-10 * size, output


def by_paper(
    mechanism: solver.Scene, stop: float, h: float, formulation: str = "conserving-al", **more: Any
) -> solver.Trajectory:
    """Run in steps of h, each of which is told."""
    steps = {"step_size": h, "internal_step": h}
    return solver.simulate(mechanism, stop_time=stop, formulation=formulation, **steps, **more)


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
    x = by_paper(solver.loads(TIED), 1.0, 0.02, formulation)
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
    run = by_paper(solver.loads(TIED), 0.1, 0.005, formulation, penalty=1e5)
    exact = solver.simulate(solver.loads(TIED), stop_time=0.1, step_size=0.1, tolerance=1e-10)
    for name in ("A.x", "A.y", "B.x", "B.y"):
        assert run[name][-1] == pytest.approx(exact[name][-1], abs=2e-4)


def test_the_intermediate_configuration_keeps_energy_and_loses_angular_momentum():
    # A product of two distances is invariant, but its gradient off the middle is not (theory 2.4).
    text = """
name = "triple"
dimension = 2
[points]
A = { position = [0.9, 0.1], velocity = [0.3, 1.1], mass = 1.0 }
B = { position = [-0.7, 0.2], velocity = [0.1, -0.6], mass = 3.0 }
C = { position = [0.2, 1.1], velocity = [-1.0, 0.3], mass = 2.0 }
[constraints]
tie = { value = "distance(A, C)*distance(B, C) - 1.5" }
[solver]
assemble = true
"""
    run = by_paper(solver.loads(text), 5.0, 0.05, "conserving-al-beta")
    assert np.ptp(run["energy.total"]) < 1e-11
    assert np.ptp(run["angular_momentum.z"]) > 1e-4


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
    run = by_paper(solver.loads(GEARS), 0.5, 0.02)
    turned = 3.0 * 1.4 / 0.18 * (1.0 - np.exp(-0.5 * 0.18 / 1.4))
    assert 3.0 * turned > np.pi
    assert run["first.angle"][-1] == pytest.approx(turned, rel=3e-3)
    assert run["second.angle"][-1] == pytest.approx(-3.0 * turned, rel=3e-3)
    lost = 0.5 * 1.4 * 9.0 * (1.0 - np.exp(-2.0 * 0.5 * 0.18 / 1.4))
    assert run["energy.dissipated"][-1] == pytest.approx(lost, rel=1e-2)
    assert np.abs(run["energy.balance"]).max() < 1e-12


def test_drivers_and_loads_of_the_time_do_the_work_that_the_mechanism_takes():
    # J = 1 kg m2 about its pin, turned by a driver to t^2 and pushed at 1 m by 3 t N along x. Its
    # kinetic energy is all that motor and push give; the motor's torque is 2 + 3 t sin t^2 N m.
    # Steps of 20 ms leave 1e-3, and means of forces half a step, times their rates of 10 N m/s.
    text = """
name = "driven"
dimension = 2
[bodies]
rod = { position = [0, 0], mass = 1.0, inertia = 1.0, points = { tip = [1, 0] } }
[joints]
pin = { type = "revolute", bodies = ["ground", "rod"], position = [0, 0] }
[forces]
push = { type = "force", point = "rod.tip", value = ["3*t", 0] }
[drivers]
motor = { type = "angle", joint = "pin", value = "t**2" }
"""
    run = by_paper(solver.loads(text), 1.0, 0.02)
    t = run.t
    assert run["pin.angle"] == pytest.approx(t**2, abs=1e-12)
    assert run["energy.kinetic"][-1] == pytest.approx(2.0, abs=1e-3)
    assert run["energy.work"][-1] == pytest.approx(2.0, abs=1e-3)
    assert run["motor.torque"][2:] == pytest.approx(2.0 + 3.0 * t[2:] * np.sin(t[2:] ** 2), abs=0.1)
    assert np.abs(run["energy.balance"]).max() < 1e-12


TURNED = {
    2: """
[bodies.disc]
position = [0, 0]
mass = 2.0
inertia = 0.5
points = { rim = [1, 0] }
[forces]
torque = { type = "torque", body = "disc", value = 0.7 }
thrust = { type = "force", point = "disc.rim", value = [0, 0.3], axes = "body" }
""",
    3: """
[bodies.disc]
position = [0, 0, 0]
mass = 2.0
inertia = [0.3, 0.3, 0.5]
points = { rim = [1, 0, 0] }
[forces]
torque = { type = "torque", body = "disc", value = [0, 0, 0.7] }
thrust = { type = "force", point = "disc.rim", value = [0, 0.3, 0], axes = "body" }
""",
}


@pytest.mark.parametrize("dimension", TURNED)
def test_torques_and_thrusts_turn_a_free_body(dimension: int):
    # J w' = 0.7 + 0.3 1 N m, so that w = 2 t rad/s, and all work is kinetic energy. A torque at the
    # middle of a step of 10 ms turns by tan x in the place of x = w h/2: 1e-4.
    run = by_paper(
        solver.loads(f"name = 'd'\ndimension = {dimension}\n{TURNED[dimension]}"), 1.0, 0.01
    )
    spin = "disc.angular_velocity" if dimension == 2 else "disc.wz"
    assert run[spin] == pytest.approx(2.0 * run.t, abs=1e-3)
    assert run["energy.kinetic"][-1] == pytest.approx(run["energy.work"][-1], rel=1e-12)


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("bouncing_ball", "contact 'floor': .* no contacts"),
        ("rolling_disc", "joint 'contact': .* no rolling"),
        ("pile_of_discs", "contact 'floor_3' and [0-9]+ more: .* no contacts"),
    ],
)
def test_what_the_method_does_not_take_is_refused_with_part_and_remedy(name: str, words: str):
    with pytest.raises(OptionError, match=rf"{words}.*the core does: leave out 'formulation'"):
        solver.simulate(SCENES / f"{name}.toml", stop_time=0.1, formulation="midpoint-al")


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({"formulation": "leapfrog"}, "formulation: must be one of conserving-al,"),
        ({"formulation": "midpoint-penalty", "penalty": -1.0}, "penalty: must be .* > 0, got -1"),
        ({"formulation": "penalty-velocity", "xi": "a"}, "xi: must be a finite number >= 0"),
        (
            {"algorithm": "nested", "tolerance": 1e-6},
            "tolerance: .* no such setting; leave it out, or, for the core, leave algorithm out",
        ),
        ({"formulation": "midpoint-al", "penatly": 1.0}, "penatly'; did you mean 'solver.penalty'"),
        ({"xi": 1.0, "algoritm": "nested"}, "algoritm'; did you mean 'solver.algorithm'"),
        ({"xi": 1.0, "paired": True}, "'paired' left in version 2.0: half steps always come in"),
        ({"xi": 1.0, "inputs": {"pull": lambda t: t}}, "pull: .* no inputs that change"),
    ],
    ids=["formulation", "penalty", "xi", "tolerance", "penatly", "algoritm", "paired", "inputs"],
)
def test_a_wrong_argument_is_refused_with_its_rule(given: dict[str, Any], words: str):
    with pytest.raises(OptionError, match=words):
        solver.simulate(scene(double_pendulum()), **given)


@pytest.mark.parametrize("algorithm", ["nested", "simultaneous"])
def test_a_penalty_under_which_updates_contract_too_slowly_is_to_be_larger(algorithm: str):
    # Each update leaves 1/(1 + 1e-3) of what the rows miss, whatever the step.
    given = {"formulation": "conserving-al", "algorithm": algorithm, "stop_time": 0.01}
    with pytest.raises(StepError, match=r"did not converge .*; a larger penalty usually helps"):
        solver.simulate(scene(double_pendulum()), step_size=0.01, penalty=1e-3, **given)


def test_a_trajectory_has_every_step_with_what_its_iterations_did():
    run = solver.simulate(
        scene(double_pendulum()), stop_time=0.1, step_size=0.05, internal_step=0.01, penalty=1e2,
        formulation="conserving-al",
    )  # fmt: skip
    assert len(run.moments) == 11
    assert [at.t for at in run.moments[::5]] == pytest.approx(run.t)
    missed = [k.phi for k in run.moments[-1].iterations]
    assert missed[0] > 1e-8 > 1e-14 > missed[-1]


def test_a_run_that_fails_leaves_what_it_came_to():
    # The four-bar's midpoint rule breaks where all bars are in one line, at 0.7 s.
    with pytest.raises(StepError, match="smaller step_size") as caught:
        solver.simulate(SCENES / "four_bar.toml", formulation="midpoint-al", internal_step=2e-3)
    run = caught.value.trajectory
    assert isinstance(run, solver.Trajectory)
    assert run.t[-1] == pytest.approx(0.7)
    change = np.abs(run["energy.total"] / run["energy.total"][0] - 1.0)
    assert 0.01 < change.max() < 0.5
