"""Redundant rows: a planar mechanism built in space moves as in the plane and is held as there.

Hinges with parallel axes hold a loop three times too often. Motion and what is determined of the
reactions must not notice; what is not determined must stay bounded for ever.
"""

from __future__ import annotations

import numpy as np
import pytest

import solver
from tests.support.mechanisms.mechanism_runs import scene
from tests.support.mechanisms.problems import Array
from tests.support.mechanisms.work_sums import vector

PINS = {"A": [0.0, 0.0], "B": [0.1, 0.3], "C": [0.7, 0.55], "D": [0.6, 0.0], "E": [1.2, 0.0]}
FOUR_BAR = (("crank", "AB", 1.0), ("coupler", "BC", 2.0), ("rocker", "CD", 1.5))
SLIDER_CRANK = (("crank", "AB", 1.0), ("rod", "BE", 2.0))
LOADS = """
[forces]
motor = { type = "joint_torque", joint = "A", value = "0.3*sin(2*t)" }
damper = { type = "torsion_damper", joint = "B", damping = 0.02 }
"""


def bars(dimension: int, links: tuple[tuple[str, str, float], ...]) -> str:
    """Uniform bars between pins, as rigid bodies; the crank turns at 3 rad/s."""
    text, rest = "", [0.0] * (dimension - 2)
    for name, (start, end), mass in links:
        a, b = np.array(PINS[start]), np.array(PINS[end])
        inertia, angle = mass * (b - a) @ (b - a) / 12, float(np.arctan2(*(b - a)[::-1]))
        text += f"[bodies.{name}]\nmass = {mass}\nposition = {[*(0.5 * (a + b)).tolist(), *rest]}\n"
        if dimension == 2:
            text += f"inertia = {inertia}\norientation = {angle}\n"
        else:
            text += f"inertia = [{0.1 * inertia}, {inertia}, {inertia}]\n"
            text += f"orientation = {{ rotation_vector = [0, 0, {angle}] }}\n"
        if name == "crank":
            text += f"angular_velocity = {3.0 if dimension == 2 else [0, 0, 3.0]}\n"
    return text


def drawn(dimension: int, name: str, *, across: float = 0.0, loads: str = LOADS) -> solver.Scene:
    """Four-bar or slider-crank; in space its hinges are along z, where `across` [m/s2] pulls."""
    rest, axis = ([], "") if dimension == 2 else ([0.0], ", axis = [0, 0, 1]")
    if name == "four_bar":
        text = bars(dimension, FOUR_BAR)
        ends = {
            "A": "ground crank",
            "B": "crank coupler",
            "C": "coupler rocker",
            "D": "rocker ground",
        }
    else:
        text = (
            bars(dimension, SLIDER_CRANK)
            + f"[bodies.slider]\nmass = 0.5\nposition = {PINS['E'] + rest}\n"
        )
        text += f"inertia = {0.01 if dimension == 2 else [0.01, 0.01, 0.01]}\n"
        ends = {"A": "ground crank", "B": "crank rod", "E": "rod slider"}
    joints = "[joints]\n"
    if name == "slider_crank":
        slide = f'bodies = ["slider", "ground"], axis = {[1.0, 0.0, *rest]}'
        joints += f'D = {{ type = "prismatic", {slide}, position = {PINS["E"] + rest} }}\n'
    for pin, pair in ends.items():
        one, two = pair.split()
        joints += f'{pin} = {{ type = "revolute", bodies = ["{one}", "{two}"], '
        joints += f"position = {PINS[pin] + rest}{axis} }}\n"
    gravity = [0.0, -9.81] if dimension == 2 else [0.0, -9.81, across]
    head = f'name = "{name}"\ndimension = {dimension}\ngravity = {gravity}\n'
    return solver.loads(f"{head}{text}{joints}{loads}[solver]\nassemble = true\nstep_size = 0.01\n")


def moved(mechanism: solver.Scene) -> solver.Trajectory:
    """5 s in pairs of 0.01 s."""
    return solver.simulate(mechanism, stop_time=5.0, step_size=0.05)


MECHANISMS = {
    # (names of its motion, joints): all in the plane
    "four_bar": (["crank.x", "coupler.x", "coupler.y", "A.angle", "C.angle"], "ABCD"),
    "slider_crank": (["crank.x", "rod.y", "slider.x", "A.angle", "E.angle"], "ABED"),
}


@pytest.mark.parametrize("across", [0.0, -5.0])
@pytest.mark.parametrize("name", MECHANISMS)
def test_a_planar_mechanism_moves_in_space_as_in_the_plane(name, across):
    # 1000 half steps at 10 rad/s, each solved to round-off; angles of up to 30 rad.
    flat, spatial = moved(drawn(2, name)), moved(drawn(3, name, across=across))
    for quantity in MECHANISMS[name][0]:
        assert spatial[quantity] == pytest.approx(flat[quantity], abs=1e-12)
    assert spatial["energy.dissipated"] == pytest.approx(flat["energy.dissipated"], abs=1e-12)
    assert spatial["energy.work"] == pytest.approx(flat["energy.work"], abs=1e-12)


@pytest.mark.parametrize("across", [0.0, -5.0])
@pytest.mark.parametrize("name", MECHANISMS)
def test_the_reactions_in_its_plane_are_those_of_the_plane(name, across):
    flat, spatial = moved(drawn(2, name)), moved(drawn(3, name, across=across))
    for joint in MECHANISMS[name][1]:
        force = vector(flat, f"{joint}.force.", "xy")
        size = np.abs(force).max()
        assert vector(spatial, f"{joint}.force.", "xy") == pytest.approx(force, abs=1e-10 * size)
    if name == "slider_crank":
        assert spatial["D.torque.z"] == pytest.approx(flat["D.torque.z"], abs=1e-9)


@pytest.mark.parametrize("name", MECHANISMS)
def test_what_acts_across_the_plane_is_carried_by_both_supports_together(name):
    # Which of them takes how much is not determined; their sum is the weight.
    weight = 5.0 * (4.5 if name == "four_bar" else 3.5)
    run = moved(drawn(3, name, across=-5.0))
    assert run["A.force.z"] - run["D.force.z"] == pytest.approx(weight, rel=1e-10)


def test_without_a_load_across_the_plane_nothing_acts_there():
    run = moved(drawn(3, "four_bar"))
    for joint in "ABCD":
        for quantity in ("force.z", "torque.x", "torque.y"):
            assert np.abs(run[f"{joint}.{quantity}"]).max() < 1e-9


ROD = """
name = "twin"
dimension = 2
gravity = [0, -9.81]
[points]
O = { position = [0, 0], fixed = true }
A = { position = [1, 0], mass = 2.0 }
[joints]
one = { type = "distance", points = ["O", "A"] }
"""
TWIN = ROD + 'two = { type = "distance", points = ["O", "A"] }\n'


def test_two_equal_rods_share_what_one_carries():
    single, double = (moved(solver.loads(text)) for text in (ROD, TWIN))
    assert double["A.x"] == pytest.approx(single["A.x"], abs=1e-12)
    assert double["one.force"] == pytest.approx(0.5 * single["one.force"], abs=1e-9)
    assert double["two.force"] == pytest.approx(0.5 * single["one.force"], abs=1e-9)


def test_a_stress_between_two_rods_is_forgotten_without_moving_anything():
    # One pulls as the other pushes: nothing determines it, and a step leaves it out. The means at
    # an output are those of the steps before and after it.
    calm, tense = (solver.Integrator(solver.assemble(solver.loads(TWIN))) for _ in range(2))
    for integrator in (calm, tense):
        integrator["solver.step_size"] = 0.01
        integrator.initialise()
        integrator.advance(0.0, 1.0)
    for name in ("mu_first", "mu_second", "mean", "mean_before"):
        tense.state.vectors[name][0] += 50.0
        tense.state.vectors[name][1] -= 50.0
    assert abs(float(tense["one.force"]) - float(tense["two.force"])) > 50.0
    for integrator in (calm, tense):
        integrator.advance(1.0, 0.1)
    assert tense["one.force"] == pytest.approx(float(tense["two.force"]), abs=1e-6)
    assert tense["A.x"] == pytest.approx(float(calm["A.x"]), abs=1e-9)


def multipliers(mechanism: solver.Scene, seconds: float) -> tuple[Array, float]:
    """Largest mean multiplier every 0.1 s of a long run, and the energy error at its end."""
    integrator = solver.Integrator(solver.assemble(mechanism))
    integrator.initialise()
    largest = []
    for _ in range(round(seconds / 0.1)):
        integrator.advance(integrator.time, 0.1)
        largest.append(np.abs(np.asarray(integrator.state.vectors["mean"])).max())
    return np.array(largest), float(integrator["energy.error"])


@pytest.mark.parametrize("name", ["four_bar", "bricard"])
def test_multipliers_stay_bounded_for_a_hundred_thousand_steps(name):
    # Undamped, the motion comes back; what the rows leave undetermined is forgotten in some steps.
    mechanism = (
        drawn(3, "four_bar", across=-5.0, loads="")
        if name == "four_bar"
        else solver.load(scene("bricard"))
    )
    largest, error = multipliers(mechanism, 500.0)
    assert len(largest) == 5000
    early, late = largest[:500].max(), largest[-500:].max()
    assert late < 1.5 * early
    assert largest.max() < 1.5 * early
    assert error < 1e-11
