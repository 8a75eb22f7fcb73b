"""Sensors show what instruments would, and powers what forces give to the mechanism."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import solver
from tests.support.mechanisms.reduced_models import matrix_of, rotation

TURNTABLE = """
name = "turntable"
gravity = [0, 0, -9.81]
[bodies.table]
mass = 1.0
inertia = [0.1, 0.1, 0.1]
position = [0, 0, 0]
angular_velocity = [0, 0, 3]
[bodies.load]
mass = 1.0
inertia = [0.1, 0.2, 0.3]
position = [1, 0.5, 2]
orientation = { axis = [1, 1, 0], angle = 0.4 }
angular_velocity = [0.3, 1, 2]
[joints]
hinge = { type = "revolute", bodies = ["ground", "table"], position = [0, 0, 0], axis = [0, 0, 1] }
[sensors]
"""


def run(text: str, **options: Any) -> solver.Trajectory:
    return solver.simulate(solver.loads(text), stop_time=1.0, step_size=0.1, **options)


def vectors(found: solver.Trajectory, *words: str) -> np.ndarray:
    """Vectors (times, components) of some columns."""
    return np.column_stack([found[word] for word in words])


@pytest.mark.parametrize("options", [{}, {"order": 2.0, "tolerance": 0.0}], ids=["default", "2"])
def test_an_imu_on_a_turntable_shows_the_centripetal_force_and_the_weight(options):
    """Numbers of a hand calculation: 3^2 0.2 = 1.8 m/s2 towards the axis, 9.81 up, 3 rad/s."""
    text = """
        imu = { type = "imu", body = "table", at = [0.2, 0, 0.1] }
        free = { type = "imu", body = "load" }
        [sensors.side]
        type = "imu"
        body = "table"
        at = [0.2, 0, 0.1]
        orientation = { axis = [0, 0, 1], angle = "pi/2" }
        """
    found = run(TURNTABLE + text, **options)
    words = "fx", "fy", "fz", "wx", "wy", "wz"
    own, turned = (vectors(found, *(f"{x}.{word}" for word in words)) for x in ("imu", "side"))
    assert own == pytest.approx(np.tile([-1.8, 0, 9.81, 0, 0, 3], (11, 1)), abs=1e-9)
    assert turned == pytest.approx(np.tile([0, 1.8, 9.81, 0, 0, 3], (11, 1)), abs=1e-9)
    assert np.abs(vectors(found, "free.fx", "free.fy", "free.fz")).max() < 1e-12


def test_an_imu_in_the_plane_shows_gravity_in_its_own_axes():
    text = """
        name = "leaning"
        dimension = 2
        gravity = [0, -9.81]
        [bodies]
        mast = { position = [1, 0], mass = 1, inertia = 1, orientation = 0.3 }
        [joints]
        held = { type = "fixed", bodies = ["ground", "mast"], position = [1, 0] }
        [sensors]
        imu = { type = "imu", body = "mast", orientation = 0.2 }
        """
    found = run(text)
    assert found["imu.fx"] == pytest.approx(9.81 * np.sin(0.5), abs=1e-9)
    assert found["imu.fy"] == pytest.approx(9.81 * np.cos(0.5), abs=1e-9)
    assert np.abs(found["imu.w"]).max() < 1e-9


def test_angular_velocity_in_body_axes_is_that_of_eulers_equations():
    text = TURNTABLE + 'imu = { type = "imu", body = "load" }'
    found = run(text, tolerance=1e-10)
    own = vectors(found, "imu.wx", "imu.wy", "imu.wz")
    inertia = np.array([0.1, 0.2, 0.3])
    start = rotation(0.4 * np.array([1, 1, 0]) / np.sqrt(2.0)).T @ [0.3, 1.0, 2.0]
    assert own[0] == pytest.approx(start, abs=1e-12)
    energies, squares = own**2 @ inertia, (own * inertia) ** 2 @ np.ones(3)
    assert energies == pytest.approx(start**2 @ inertia, rel=1e-7)
    assert squares == pytest.approx(np.sum((start * inertia) ** 2), rel=1e-7)
    attitudes = np.array([matrix_of(q) for q in vectors(found, *(f"load.q{x}" for x in "wxyz"))])
    turned = np.einsum("tji,tj->ti", attitudes, vectors(found, "load.wx", "load.wy", "load.wz"))
    assert own == pytest.approx(turned, abs=1e-10)


def test_a_place_seen_from_a_turntable_moves_as_its_components_do():
    """The rate of R'r is R'(v - omega x r): the table turns by 3 t, the load flies freely."""
    text = """
        seen = { type = "relative", bodies = ["table", "load"], axes = "table" }
        end = { type = "relative", points = ["ground", "load"], at = [0, 0, 1], axes = "table" }
        """
    found = run(TURNTABLE + text, tolerance=1e-10)
    t = found.t
    back = np.array([rotation([0, 0, -3.0 * x]) for x in t])
    place = np.column_stack([1.0 + 0 * t, 0.5 + 0 * t, 2.0 - 0.5 * 9.81 * t**2])
    rate = np.column_stack([0 * t, 0 * t, -9.81 * t]) - np.cross([0, 0, 3.0], place)
    x = vectors(found, "seen.x", "seen.y", "seen.z")
    assert x == pytest.approx(np.einsum("tij,tj->ti", back, place), abs=1e-8)
    v = vectors(found, "seen.vx", "seen.vy", "seen.vz")
    assert v == pytest.approx(np.einsum("tij,tj->ti", back, rate), abs=1e-7)
    assert found["seen.distance"] == pytest.approx(np.linalg.norm(place, axis=1), abs=1e-8)
    assert found["end.z"] == pytest.approx(found["seen.z"] - 1.0, abs=1e-12)
    assert found["end.vx"] == pytest.approx(found["seen.vx"], abs=1e-12)


def test_the_rotation_vector_turns_the_first_body_into_the_second():
    """R_2 = exp([psi]x) R_1, with psi in global axes, and |psi| <= pi, the angle."""
    text = """
        both = { type = "relative", bodies = ["table", "load"] }
        own = { type = "relative", bodies = ["table", "load"], axes = "table" }
        """
    found = run(TURNTABLE + text)
    psi = vectors(found, "both.psi_x", "both.psi_y", "both.psi_z")
    first, second = (
        np.array([matrix_of(q) for q in vectors(found, *(f"{body}.q{x}" for x in "wxyz"))])
        for body in ("table", "load")
    )
    for vector, before, after in zip(psi, first, second, strict=True):
        assert rotation(vector) @ before == pytest.approx(after, abs=1e-12)
    assert found["both.angle"] == pytest.approx(np.linalg.norm(psi, axis=1), abs=1e-12)
    assert found["both.angle"].max() <= np.pi
    own = vectors(found, "own.psi_x", "own.psi_y", "own.psi_z")
    assert np.einsum("tij,tj->ti", first, own) == pytest.approx(psi, abs=1e-12)
    rate = vectors(found, "both.wx", "both.wy", "both.wz")
    apart = [found[f"load.w{x}"] - found[f"table.w{x}"] for x in "xyz"]
    assert rate == pytest.approx(np.array(apart).T, abs=1e-12)


def test_bodies_that_are_turned_alike_have_no_angle():
    text = TURNTABLE.replace("orientation = { axis = [1, 1, 0], angle = 0.4 }\n", "")
    found = run(text + 'both = { type = "relative", bodies = ["table", "load"] }')
    assert [found[f"both.{word}"][0] for word in ("angle", "psi_x", "psi_y", "psi_z")] == [0.0] * 4


def test_two_bars_of_the_plane_have_an_angle_that_is_not_wrapped():
    text = """
        name = "bars"
        dimension = 2
        [points]
        O = { position = [0, 0], fixed = true }
        A = { position = [1, 0], velocity = [0, 7] }
        P = { position = [0, 2], fixed = true }
        B = { position = [1, 2], velocity = [0, -2] }
        [bodies]
        first = { type = "bar", points = ["O", "A"], mass = 1 }
        second = { type = "bar", points = ["P", "B"], mass = 1 }
        [sensors]
        fold = { type = "relative", bodies = ["first", "second"], axes = "first" }
        """
    found = run(text)
    assert found["fold.angle"] == pytest.approx(-9.0 * found.t, abs=1e-3)
    assert found["fold.angular_velocity"] == pytest.approx(-9.0, abs=1e-6)
    assert found["fold.x"] == pytest.approx(2.0 * np.sin(7.0 * found.t), abs=1e-3)
    assert found["fold.vx"] == pytest.approx(14.0 * np.cos(7.0 * found.t), abs=1e-2)


PLANE = """
name = "plane"
dimension = 2
gravity = [0.3, -9.81]
[parameters]
c = 0.7
[points]
A = { position = [0, 0], fixed = true }
B = { position = [1, 0.2], mass = 0.7, velocity = [-0.2, 1] }
C = { position = [1.8, -0.3], mass = 1.1 }
[bodies]
ab = { type = "bar", points = ["A", "B"], mass = 1.0 }
[bodies.rod]
mass = 2.0
inertia = 0.3
position = [3, 0]
center_of_mass = [0.3, 0.1]
orientation = -0.7
angular_velocity = 1.3
points = { tip = [1.0, 0.2], centre = [0.3, 0.1] }
[joints.hinge]
type = "revolute"
bodies = ["ground", "rod"]
position = [3, 0]
friction = { coefficient = 0.2, radius = 0.05, preload = 0.1 }
[forces]
spring = { type = "spring", points = ["B", "C"], stiffness = 30, free_length = 0.8 }
stiff = { type = "spring", points = ["C", "rod.tip"], energy = "3*(length - 1)**2 + length**4" }
damper = { type = "damper", points = ["B", "rod.tip"], damping = 0.4 }
law = { type = "damper", points = ["C", "rod.tip"], force = "0.3*rate + 0.2*rate*abs(rate)" }
brake = { type = "torsion_damper", joint = "hinge", torque = "0.1*rate**3" }
pull = { type = "gravitation", points = ["B", "C"], constant = 2.0 }
twist = { type = "torsion_spring", joint = "hinge", stiffness = 3, free_angle = 0.3 }
drag = { type = "torsion_damper", joint = "hinge", damping = 0.2 }
servo = { type = "joint_torque", joint = "hinge", value = "c*cos(t) - 0.3*hinge.angular_velocity" }
hand = { type = "force", point = "rod.tip", value = ["sin(t)", "B.vx"], axes = "body" }
wind = { type = "force", point = "C", value = [1, "-C.vy*abs(C.vy)"] }
load = { type = "torque", body = "rod", value = "0.4*t" }
other = { type = "torque", body = "ab", value = 0.5 }
well = { type = "potential", value = "2*B.x**2 + C.y*B.y + 0.3*distance(B, C)**2" }
"""
SPACE = """
name = "space"
gravity = [0.3, -9.81, 0.2]
[points]
A = { position = [0, 0, 0], fixed = true }
B = { position = [1, 0.2, 0.3], mass = 0.7, velocity = [0.1, 1, -1] }
[bodies]
ab = { type = "bar", points = ["A", "B"], mass = 1.0 }
[bodies.rod]
mass = 2.0
inertia = [0.3, 0.2, 0.4]
position = [3, 0, 0]
orientation = { axis = [1, 2, 3], angle = 0.7 }
angular_velocity = [1, 2, 3]
points = { tip = [1.0, 0.2, 0.3] }
[forces]
spring = { type = "spring", points = ["B", "rod.tip"], stiffness = 30, free_length = 0.8 }
hand = { type = "force", point = "rod.tip", value = ["sin(t)", "B.vx", 1], axes = "body" }
wind = { type = "force", point = "rod", at = [3, 1, 1], value = [1, 2, 3] }
load = { type = "torque", body = "rod", value = [1, "0.4*t", 2], axes = "body" }
other = { type = "torque", body = "rod", value = [1, "0.4*t", 2] }
last = { type = "torque", body = "ab", value = [0.5, 1, 0.2] }
"""


def power_of_inertia(masses: dict[str, float], gravity: list[float]) -> str:
    """Sum of m (a - g) . v of some points, as an expression."""
    terms = (
        f"{mass}*({point}.a{axis} - {g})*{point}.v{axis}"
        for point, mass in masses.items()
        for axis, g in zip("xyz", gravity, strict=False)
    )
    return " + ".join(terms)


def test_powers_of_all_forces_in_the_plane_are_what_masses_gain():
    """They add up to m (a - g) . v of all masses and J alpha omega: rows that rest give nothing.

    A bar from O, of 1 kg, moves as a third of it does at its end, and weighs half there.
    """
    scene = solver.loads(PLANE)
    powers = [f"{name}.power" for name in (*scene.forces, "hinge")]
    inertia = power_of_inertia({"rod.centre": 2.0, "B": 0.7, "C": 1.1}, [0.3, -9.81])
    inertia += " + 0.3*rod.angular_acceleration*rod.angular_velocity"
    inertia += " + (B.ax/3 - 0.15)*B.vx + (B.ay/3 + 4.905)*B.vy"
    text = f'[outputs]\ngained = {{ value = "{inertia} - ({" + ".join(powers)})" }}'
    found = solver.simulate(
        solver.loads(PLANE + text), outputs=["gained", "hinge.power", "damper.power", *powers],
        stop_time=0.5, step_size=0.1, tolerance=1e-8,
    )  # fmt: skip
    assert np.abs(found["gained"]).max() < 1e-9  # of some 60 W
    assert found["hinge.power"].max() <= 0.0
    assert found["damper.power"].max() <= 0.0
    assert min(np.abs(found[name]).max() for name in powers) > 0.01


def test_powers_of_all_forces_in_space_are_what_masses_gain():
    inertia = power_of_inertia({"rod": 2.0, "B": 0.7}, [0.3, -9.81, 0.2])
    inertia += " + (B.ax/3 - 0.15)*B.vx + (B.ay/3 + 4.905)*B.vy + (B.az/3 - 0.1)*B.vz"
    powers = [f"{name}.power" for name in solver.loads(SPACE).forces]
    words = [f"rod.{word}{axis}" for word in ("q", "w", "wd") for axis in "wxyz"[word != "q" :]]
    text = f'[outputs]\ngained = {{ value = "{inertia} - ({" + ".join(powers)})" }}'
    found = solver.simulate(
        solver.loads(SPACE + text), outputs=["gained", *words, *powers],
        stop_time=0.5, step_size=0.1, tolerance=1e-8,
    )  # fmt: skip
    attitude = np.array([matrix_of(q) for q in vectors(found, *words[:4])])
    rate, turning = (
        np.einsum("tji,tj->ti", attitude, vectors(found, *words[k : k + 3])) for k in (4, 7)
    )
    spun = np.sum(rate * turning * [0.3, 0.2, 0.4], axis=1)
    assert found["gained"] + spun == pytest.approx(0.0, abs=1e-8)  # of some 200 W
    assert min(np.abs(found[name]).max() for name in powers) > 0.01
