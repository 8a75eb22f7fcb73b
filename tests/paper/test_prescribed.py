"""Scenes by the paper's method in which the time prescribes places, formulas, springs and loads.

Right values are closed forms, or equations in one coordinate by DOP853.
"""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import solver
from solver.paper import FORMULATIONS
from solver.paper_scenes import refusal
from solver.runtime import OptionError
from tests.support.mechanisms.problems import GRAVITY, observed_order

SCENES = Path(__file__).parents[2] / "scenes"
STEPS = [0.02, 0.01, 0.005]


def by_paper(
    text: str, h: float, formulation: str = "conserving-al", stop: float = 1.0
) -> solver.Trajectory:
    """Run in steps of h, each of which is told."""
    steps = {"step_size": h, "internal_step": h}
    return solver.simulate(solver.loads(text), stop_time=stop, formulation=formulation, **steps)


SHAKEN = """
name = "shaken"
dimension = 2
gravity = [0, -9.81]
[points]
S = { position = [0, 0] }
A = { position = [0.6, -0.8], velocity = [0.6, 0], mass = 1.0 }
[joints]
rod = { type = "distance", points = ["S", "A"] }
[drivers]
hand = { type = "position", point = "S", value = ["0.2*sin(3*t)", 0] }
"""


@pytest.mark.parametrize("formulation", FORMULATIONS)
def test_a_pendulum_on_a_support_that_shakes_moves_as_its_equation_to_second_order(
    formulation: str,
):
    # With the support at x_S, x = x_S + sin p: p'' = -g sin p - x_S'' cos p; p' is 0 at first.
    def rates(t: float, y: np.ndarray) -> list[float]:
        return [y[1], -GRAVITY * math.sin(y[0]) + 1.8 * math.sin(3.0 * t) * math.cos(y[0])]

    start = [math.asin(0.6), 0.0]
    exact = solve_ivp(rates, (0.0, 1.0), start, method="DOP853", rtol=1e-12, atol=1e-12).y[0, -1]
    runs = [by_paper(SHAKEN, h, formulation) for h in STEPS]
    errors = [abs(run["A.x"][-1] - 0.2 * math.sin(3.0) - math.sin(exact)) for run in runs]
    assert observed_order(STEPS, errors) == pytest.approx(2.0, abs=0.1)
    assert errors[-1] < 2e-5
    if formulation != "penalty-velocity":  # which holds acceleration, rate and place together
        missed = np.abs(runs[0]["S.x"] - 0.2 * np.sin(3.0 * runs[0].t)).max()
        assert missed < (1e-14 if "-al" in formulation else 1e-10)


PULLED = """
name = "pulled"
dimension = 2
gravity = [0, -9.81]
[points]
S = { position = [0, 0] }
A = { position = [-0.6, -0.8] }
[bodies]
rod = { type = "bar", points = ["S", "A"], mass = 2.0 }
[drivers]
hand = { type = "position", point = "S", value = ["0.375*9.81*t**2", 0] }
"""


@pytest.mark.parametrize("formulation", ["conserving-al", "conserving-al-beta", "midpoint-al"])
def test_a_bar_pulled_with_constant_acceleration_hangs_along_its_apparent_weight(formulation: str):
    # It leans back by atan(a/g) = atan(3/4) and stays: the hand pulls with m a and carries m g.
    # Mass between the driven end and the other, m/6, is part of both. Steps are exact for motions
    # of second degree; round-off of places 1e-16 over h^2 makes 1e-12 of the forces.
    run = by_paper(PULLED, 0.02, formulation)
    assert run["hand.force.x"] == pytest.approx(2.0 * 0.75 * GRAVITY, abs=1e-9)
    assert run["hand.force.y"] == pytest.approx(2.0 * GRAVITY, abs=1e-9)
    assert run["A.y"] == pytest.approx(-0.8, abs=1e-13)
    assert run["A.x"] - run["S.x"] == pytest.approx(-0.6, abs=1e-13)
    speed = 0.75 * GRAVITY * run.t
    assert run["energy.work"] == pytest.approx(0.5 * 2.0 * speed**2, abs=1e-10)


CRANK = """
name = "crank"
dimension = 2
gravity = [0, -9.81]
[points]
A = { position = [0.3, 0], velocity = [0, 1.2], mass = 0.5 }
B = { position = [1.3, 0], mass = 2.0 }
[joints]
rod = { type = "distance", points = ["A", "B"] }
guide = { type = "point_on_line", point = "B", position = [0, 0], axis = [1, 0] }
[drivers]
motor = { type = "position", point = "A", value = ["0.3*cos(4*t)", "0.3*sin(4*t)"] }
"""


def slider(t: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Place and velocity of the end of the rod."""
    x = 0.3 * np.cos(4.0 * t) + np.sqrt(1.0 - 0.09 * np.sin(4.0 * t) ** 2)
    slope = 0.36 * np.sin(4.0 * t) * np.cos(4.0 * t) / np.sqrt(1.0 - 0.09 * np.sin(4.0 * t) ** 2)
    return x, -1.2 * np.sin(4.0 * t) - slope


@pytest.mark.parametrize("formulation", ["conserving-al", "conserving-al-beta"])
def test_the_work_of_a_driven_crank_is_the_energy_of_what_it_moves(formulation: str):
    # Both places are given: 1/2 2 kg v_B^2 + 0.5 kg g y_A is what the motor has done.
    errors = []
    for h in STEPS:
        run = by_paper(CRANK, h, formulation)
        x, v = slider(run.t)
        assert run["B.x"] == pytest.approx(x, abs=1e-13)
        work = v**2 + 0.5 * GRAVITY * 0.3 * np.sin(4.0 * run.t)
        errors.append(np.abs(run["energy.work"] - work).max())
        change = run["energy.total"] - run["energy.total"][0]
        assert run["energy.work"] == pytest.approx(change, abs=1e-12)
    assert observed_order(STEPS, errors) == pytest.approx(2.0, abs=0.1)


@pytest.mark.parametrize("formulation", FORMULATIONS)
def test_iterations_of_a_driven_crank_tell_the_energies_of_eqs_17_18_and_28(formulation: str):
    # Eq 17 is the work of rod, guide and motor: what remains of the kinetic energy, here from the
    # outputs, less the work of weights. Eqs 18 and 28 know Phi - u alone, and vanish where it does.
    run = by_paper(CRANK, 0.02, formulation, 0.2)
    kinetic = 0.25 * (run["A.vx"] ** 2 + run["A.vy"] ** 2) + run["B.vx"] ** 2 + run["B.vy"] ** 2
    weight = -GRAVITY * (0.5 * run["A.y"] + 2.0 * run["B.y"])
    for k, at in enumerate(run.moments[1:]):
        for tried in at.iterations:
            if formulation.startswith("conserving") or tried is at.iterations[-1]:
                assert tried.kinetic == pytest.approx(tried.applied + tried.eq17, abs=1e-9)
        last = at.iterations[-1]
        assert last.kinetic == pytest.approx(kinetic[k + 1] - kinetic[k], abs=1e-12)
        assert last.applied == pytest.approx(weight[k + 1] - weight[k], abs=1e-12)
        if formulation.startswith("conserving-al"):
            assert abs(last.eq18) < 1e-12
            assert abs(last.eq28) < 1e-12
    moved = sum(at.iterations[-1].eq17 for at in run.moments[1:])
    assert moved == pytest.approx(kinetic[-1] - kinetic[0] - weight[-1] + weight[0], abs=1e-11)
    assert abs(moved) > 0.1


WIRE = """
name = "wire"
dimension = 2
[points]
A = { position = [1, 0], velocity = [0, 2], mass = 1.5 }
[constraints]
wire = { value = "A.y*cos(2*t) - A.x*sin(2*t)" }
"""


@pytest.mark.parametrize("formulation", FORMULATIONS)
def test_a_bead_on_a_wire_that_turns_flies_outwards_to_second_order(formulation: str):
    # r'' = w^2 r: r = cosh w t, and the wire has done m w^2 (cosh 2wt - 1)/2.
    errors = []
    for h in STEPS:
        run = by_paper(WIRE, h, formulation)
        errors.append(abs(np.hypot(run["A.x"][-1], run["A.y"][-1]) - math.cosh(2.0)))
    assert observed_order(STEPS, errors) == pytest.approx(2.0, abs=0.1)
    work = 0.5 * 1.5 * 4.0 * (math.cosh(4.0) - 1.0)
    assert run["energy.work"][-1] == pytest.approx(work, rel=1e-3)
    if formulation.startswith("conserving"):
        assert np.abs(run["energy.balance"]).max() < 1e-12


BREATHING = """
name = "breathing"
dimension = 2
[points]
O = { position = [0, 0], fixed = true }
A = { position = [1, 0], mass = 1.0 }
[forces.spring]
type = "spring"
points = ["O", "A"]
stiffness = 9.0
free_length = "1 + 0.1*sin(2*t)"
"""


@pytest.mark.parametrize("formulation", ["conserving-al", "midpoint-al"])
def test_a_spring_whose_free_length_breathes_works_as_its_oscillator_tells(formulation: str):
    # s'' = -9 (s - 0.1 sin 2t), s = 0.18 (sin 2t - 2/3 sin 3t).
    errors = []
    for h in STEPS:
        run = by_paper(BREATHING, h, formulation)
        t = run.t
        s = 0.18 * (np.sin(2.0 * t) - 2.0 / 3.0 * np.sin(3.0 * t))
        v = 0.36 * (np.cos(2.0 * t) - np.cos(3.0 * t))
        energy = 0.5 * v**2 + 4.5 * (s - 0.1 * np.sin(2.0 * t)) ** 2
        errors.append(np.abs(run["A.x"] - 1.0 - s).max())
        assert run["energy.work"] == pytest.approx(energy, abs=h**2)
        assert np.abs(run["energy.balance"]).max() < 1e-14
    assert observed_order(STEPS, errors) == pytest.approx(2.0, abs=0.1)


def test_a_spring_that_slackens_swings_as_its_closed_form():
    # Of s'' = -(1 + t/10)^-4 s, s = 0.1 a sin(10 - 10/a) with a = 1 + t/10 is a motion. Of phase,
    # steps of 50 ms miss the integral of omega^3 h^2/12, 4e-4 rad.
    text = BREATHING.replace("9.0", '"(1 + t/10)**-4"').replace('"1 + 0.1*sin(2*t)"', "1.0")
    text = text.replace("[1, 0], mass", "[1, 0], velocity = [0.1, 0], mass")
    run = by_paper(text, 0.05, stop=20.0)
    a = 1.0 + run.t / 10.0
    assert run["A.x"] - 1.0 == pytest.approx(0.1 * a * np.sin(10.0 - 10.0 / a), abs=3e-4)
    assert np.abs(run["energy.balance"]).max() < 1e-14


PUSHED = """
name = "pushed"
dimension = 2
[points]
A = { position = [0, 0], velocity = [1, 0], mass = 2.0 }
[forces]
push = { type = "force", point = "A", value = ["VALUE", 0] }
"""


def test_a_load_that_reads_the_velocity_acts_in_the_middle_of_the_step():
    # m (v_1 - v_n) = -h c (v_n + v_1)/2, from step to step.
    run = by_paper(PUSHED.replace("VALUE", "-3*A.vx"), 0.05)
    ratio = (1.0 - 3.0 * 0.05 / 4.0) / (1.0 + 3.0 * 0.05 / 4.0)
    assert run["A.vx"] == pytest.approx(ratio ** np.arange(21), abs=1e-12)
    assert run["energy.work"] == pytest.approx(run["A.vx"] ** 2 - 1.0, abs=1e-12)


@pytest.mark.parametrize(
    ("value", "impulse"),
    [("1 if t < 0.5 else -4", -1.5), ("max(0, t - 0.5)", 0.125), ("floor(4*t)", 1.5)],
)
def test_a_load_that_switches_gives_its_impulse(value: str, impulse: float):
    # Steps end where it jumps, and the middle of a step is exact for what is linear in it.
    run = by_paper(PUSHED.replace("VALUE", value), 0.01)
    assert 2.0 * (run["A.vx"][-1] - 1.0) == pytest.approx(impulse, abs=1e-12)


def test_numbers_that_the_time_prescribes_may_be_large_beside_the_mechanism():
    # A millimetre at 9 MN/m, which varies by 1e-3, in steps of a fortieth of a period, for five:
    # their phase is off by 0.065 rad, that of the varying stiffness by 0.007.
    text = BREATHING.replace("9.0", '"9e6*(1 + 1e-3*sin(1e4*t))"')
    text = text.replace('"1 + 0.1*sin(2*t)"', "0.0009")
    text = text.replace("[1, 0], mass = 1.0", "[0.001, 0], mass = 1e-4")
    period = 2.0 * math.pi / 3e5
    run = by_paper(text, period / 40.0, stop=5.0 * period)
    assert np.abs(run["energy.balance"]).max() < 1e-11 * run["energy.total"][0]
    assert run["A.x"] == pytest.approx(0.0009 + 0.0001 * np.cos(3e5 * run.t), abs=1e-5)


DAMPED = """
name = "damped"
dimension = 2
gravity = [0, -9.81]
[points]
A = { position = [0, 1], mass = 1.0 }
[contacts.floor]
type = "plane"
point = "A"
axis = [0, 1]
law = "hunt-crossley"
stiffness = 1e3
damping = 0.2
"""


def test_a_contact_that_yields_is_taken_if_it_has_no_damping():
    # Dropped by 1 m on a floor with the force 1000 d: m g (1 + d) = 1000 d^2/2 at the deepest.
    hertz = DAMPED.replace("hunt-crossley", "hertz").replace("damping = 0.2", "exponent = 1")
    run = by_paper(hertz, 0.002)
    deepest = (GRAVITY + math.sqrt(GRAVITY**2 + 2000.0 * GRAVITY)) / 1000.0
    assert run["A.y"].min() == pytest.approx(-deepest, rel=1e-3)
    assert np.abs(run["energy.balance"]).max() < 1e-11
    with pytest.raises(OptionError, match=r"contact 'floor': .* no damped contacts.*leave out"):
        by_paper(DAMPED, 0.002)


@pytest.mark.parametrize(
    "law",
    [
        'type = "damper", points = ["ground", "A"], at = [0, 1], force = "rate*abs(rate)"',
        'type = "actuator", points = ["ground", "A"], at = [0, 1], value = "2 - rate"',
    ],
)
def test_a_law_of_a_rate_is_refused_as_it_is_no_energy(law):
    text = PUSHED.replace("VALUE", "1") + f"pad = {{ {law} }}\n"
    with pytest.raises(OptionError, match=r"force 'pad': .* no laws of dampers.*leave out"):
        by_paper(text, 0.02)


def test_as_many_scenes_are_taken_and_refused_as_the_page_says():
    taken, refused = [], []
    for path in sorted(SCENES.glob("*.toml")):
        model = solver.assemble(solver.load(path))
        message = refusal(model, [])
        (refused if message else taken).append(path.stem)
        *parts, remedy = message.split("; ")
        assert not message or remedy == "the core does: leave out 'formulation'"
        assert all(": the paper's method takes no " in part for part in parts)
    assert {"car_axis", "double_wishbone", "andrews"} < {*taken}
    page = (SCENES.parent / "docs" / "solver_settings.md").read_text(encoding="utf-8")
    assert f"{len(taken)} of the {len(taken) + len(refused)} scenes" in page
