"""Accelerations are those that the state asks for, at every order: closed forms of the state.

Angles, velocities and inputs of a run stand in Newton's and Euler's equations by hand, so that the
error of the motion does not count, and what is left is round-off of the solution for accelerations.
"""

from __future__ import annotations

import numpy as np
import pytest

import solver
from tests.support.mechanisms.reduced_models import matrix_of

STEPS = {
    "order 2": "order = 2\nstep_size = 0.01",
    "order 4": "order = 4\nstep_size = 0.01",
    "order 8": "order = 8\nstep_size = 0.01",
    "tolerance": "tolerance = 1e-8",
}
ROUND_OFF = 1e-9
"""Of accelerations of some 10 m/s2: multipliers of 10 digits are asked for."""
each_method = pytest.mark.parametrize("steps", STEPS.values(), ids=STEPS)


def columns(text: str, steps: str, outputs: list[str], stop_time: float = 1.0) -> list[np.ndarray]:
    scene = solver.loads(f'name = "test"\n{text}\n[solver]\n{steps}')
    found = solver.simulate(scene, outputs=outputs, stop_time=stop_time, step_size=0.1)
    return [found[name] for name in outputs]


PENDULUM = """
dimension = 2
gravity = [0, -9.81]
[bodies.rod]
mass = 2.0
inertia = 0.3
position = [0, 0]
center_of_mass = [0.5, 0]
orientation = -0.7
points = { tip = [1.0, 0.2] }
[joints]
hinge = { type = "revolute", bodies = ["ground", "rod"], position = [0, 0] }
"""


@each_method
def test_a_pendulum_at_an_angle_has_the_acceleration_of_its_weight(steps):
    names = ["angle", "angular_velocity", "angular_acceleration", "tip.x", "tip.y", "tip.ax"]
    names = [f"rod.{name}" for name in (*names, "tip.ay", "ax", "ay")]
    angle, rate, turning, x, y, ax, ay, *pivot, of_joint = columns(
        PENDULUM, steps, [*names, "hinge.angular_acceleration"]
    )
    expected = -2.0 * 9.81 * 0.5 * np.cos(angle) / (0.3 + 2.0 * 0.5**2)
    assert turning == pytest.approx(expected, abs=ROUND_OFF)
    assert of_joint == pytest.approx(expected, abs=ROUND_OFF)
    assert ax == pytest.approx(-expected * y - rate**2 * x, abs=ROUND_OFF)
    assert ay == pytest.approx(expected * x - rate**2 * y, abs=ROUND_OFF)
    assert np.abs(pivot).max() < ROUND_OFF


@each_method
def test_what_falls_accelerates_by_gravity_and_a_fixed_point_not_at_all(steps):
    text = """
        gravity = [0.5, 0, -9.81]
        [points]
        A = { position = [0, 0, 0], mass = 2, velocity = [1, 2, 3] }
        O = { position = [0, 0, 0], fixed = true }
        """
    found = columns(text, steps, ["A.ax", "A.ay", "A.az"])
    for acceleration, expected in zip(found, (0.5, 0.0, -9.81), strict=True):
        assert acceleration == pytest.approx(expected, abs=1e-12)
    resting = solver.loads(f'name = "o"\n{text}\n[outputs]\nrest = {{ value = "O.ax + O.az" }}')
    assert not solver.simulate(resting, outputs=["rest"])["rest"].any()


@each_method
def test_a_driven_arm_has_the_acceleration_of_its_driver(steps):
    text = """
        [bodies.arm]
        mass = 1.0
        inertia = [0.1, 0.1, 0.1]
        position = [0, 0, 0]
        points = { tip = [0.5, 0, 0.2] }
        [joints.pin]
        type = "revolute"
        bodies = ["ground", "arm"]
        position = [0, 0, 0]
        axis = [0, 0, 1]
        [drivers]
        motor = { type = "angle", joint = "pin", value = "0.4*t + 0.9*t**2" }
        """
    names = ["arm.tip.ax", "arm.tip.ay", "arm.tip.az", "arm.wdx", "arm.wdy", "arm.wdz"]
    ax, ay, az, wdx, wdy, wdz, of_joint = columns(text, steps, [*names, "pin.angular_acceleration"])
    t = 0.1 * np.arange(11)
    angle, rate = 0.4 * t + 0.9 * t**2, 0.4 + 1.8 * t
    bound = 1e-3 if "order = 2" in steps else 1e-7  # velocities between drawn places are of order 2
    assert ax == pytest.approx(-0.9 * np.sin(angle) - 0.5 * rate**2 * np.cos(angle), abs=bound)
    assert ay == pytest.approx(0.9 * np.cos(angle) - 0.5 * rate**2 * np.sin(angle), abs=bound)
    assert np.abs([az, wdx, wdy]).max() < ROUND_OFF
    assert wdz == pytest.approx(1.8, abs=1e-8)
    assert of_joint == pytest.approx(1.8, abs=1e-8)


@each_method
def test_a_disc_that_rolls_down_a_slope_keeps_two_thirds_of_its_weight(steps):
    g = 9.81 * np.array([np.sin(0.3), -np.cos(0.3)])
    text = f"""
        dimension = 2
        gravity = [{g[0]}, {g[1]}]
        [bodies]
        disc = {{ position = [0, 0.2], shape = {{ type = "disc", radius = 0.2, density = 100 }} }}
        [joints]
        wheel = {{ type = "rolling", body = "disc", radius = 0.2 }}
        """
    ax, ay, turning = columns(text, steps, ["disc.ax", "disc.ay", "disc.angular_acceleration"])
    assert ax == pytest.approx(2.0 / 3.0 * g[0], abs=ROUND_OFF)
    assert np.abs(ay).max() < ROUND_OFF
    assert turning == pytest.approx(-2.0 / 3.0 * g[0] / 0.2, abs=ROUND_OFF)


@each_method
def test_a_spinning_top_obeys_eulers_equations(steps):
    inertia, mass, arm = np.diag([0.01, 0.013, 0.004]), 0.5, np.array([0.01, 0.0, 0.1])
    text = """
        gravity = [0, 0, -9.81]
        [bodies.top]
        mass = 0.5
        inertia = [0.01, 0.013, 0.004]
        position = [0, 0, 0]
        center_of_mass = [0.01, 0, 0.1]
        orientation = { axis = [1, 0, 0], angle = 0.6 }
        angular_velocity = { body = [0.3, 0.2, 20] }
        points = { tip = [0, 0, 0] }
        [joints]
        ball = { type = "spherical", points = ["top.tip", "ground"], at = [0, 0, 0] }
        """
    words = ["qw", "qx", "qy", "qz", "wx", "wy", "wz", "wdx", "wdy", "wdz"]
    found = np.array(columns(text, steps, [f"top.{word}" for word in words]))
    about = inertia + mass * (arm @ arm * np.eye(3) - np.outer(arm, arm))
    for quaternion, rate, turning in zip(*np.split(found.T, [4, 7], axis=1), strict=True):
        attitude = matrix_of(quaternion)
        own = attitude.T @ rate
        moment = np.cross(arm, attitude.T @ [0.0, 0.0, -9.81 * mass])
        expected = attitude @ np.linalg.solve(about, moment - np.cross(own, about @ own))
        assert turning == pytest.approx(expected, abs=1e-7)  # of some 100 rad/s2


SLED = """
dimension = 2
gravity = [0, -10]
[inputs]
push = { start = 0.0 }
[points]
A = { position = [0, 0], mass = 2 }
[contacts]
floor = { type = "plane", point = "A", axis = [0, 1], friction = 0.3 }
[forces]
hand = { type = "force", point = "A", value = ["push", 0] }
[outputs]
a = { value = "A.ax" }
"""


@pytest.mark.parametrize(
    ("steps", "mode"),
    [*((steps, "located") for steps in STEPS.values()), (STEPS["order 2"], "stepped")],
)
def test_a_block_slides_at_once_where_its_push_beats_friction(steps, mode):
    text = f'name = "sled"\n{SLED}\n[solver]\n{steps}\ncontact_mode = "{mode}"'
    sled = solver.Integrator(solver.assemble(solver.loads(text)))
    sled.initialise()
    assert sled["a"] == 0.0
    sled.advance(0.0, 0.1)
    sled["push"] = 5.0  # friction holds 6 N
    sled.advance(0.1, 0.1)
    assert sled["a"] == pytest.approx(0.0, abs=1e-12)
    sled["push"] = 8.0
    if mode == "located":  # in stepped mode the next half step decides
        assert sled["a"] == pytest.approx(1.0, abs=1e-9)
    sled.advance(0.2, 0.1)
    assert sled["a"] == pytest.approx(1.0, abs=1e-9)
    assert sled["A.vx"] == pytest.approx(0.1, abs=1e-6)


def test_accelerations_are_the_slopes_of_velocities():
    """A second check, over a linkage with two loops: central differences, with error h^2 v'''/6."""
    scene = solver.load("scenes/watt.toml")
    names = [f"{point}.{axis}" for point in scene.points for axis in "xy"]
    names = [x for x in names if any(v.name == x for v in solver.assemble(scene).variables)]
    rates, slopes = ([x.replace(".", f".{k}") for x in names] for k in "va")
    found = solver.simulate(scene, outputs=[*rates, *slopes], stop_time=0.05, step_size=1e-3)
    for rate, slope in zip(rates, slopes, strict=True):
        difference = (found[rate][2:] - found[rate][:-2]) / 2e-3
        assert found[slope][1:-1] == pytest.approx(difference, abs=1e-4)


def test_accelerations_that_are_asked_for_change_no_bit_of_the_motion():
    scene = solver.loads(f'name = "test"\n{PENDULUM}')
    plain, asked = solver.assemble(scene), solver.assemble(scene, ["rod.tip.ax"])
    assert {v.name for v in asked.variables} - {v.name for v in plain.variables} == {"rod.tip.ax"}
    assert (plain.sizes["accelerates"], asked.sizes["accelerates"]) == (0, 1)
    names = [v.name for v in plain.variables if v.causality == "output"]
    first, second = (solver.simulate(model, outputs=names) for model in (plain, asked))
    assert all(first[name].tobytes() == second[name].tobytes() for name in names)


@pytest.mark.parametrize("count", [1, 9], ids=["alone", "with all others"])
def test_an_acceleration_read_alone_is_that_of_all_measurements(count):
    text = f'name = "test"\n{PENDULUM}\n[solver]\norder = 2\nstep_size = 0.01'
    model = solver.assemble(solver.loads(text), ["rod.tip.ax"])
    integrator = solver.Integrator(model)
    integrator.initialise()
    integrator.advance(0.0, 0.1)
    force = integrator["hinge.force.y"]
    acceleration, *_ = integrator.get([model.index("rod.tip.ax")] * count)
    assert acceleration == pytest.approx(integrator["rod.tip.ax"], rel=1e-15)
    assert integrator["hinge.force.y"] == force  # means stay means
