"""Bodies with shapes that hit, rest, slide and roll, against reduced equations."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.spatial.transform import Rotation

from solver.runtime import Integrator
from tests.support.mechanisms.problems import GRAVITY, Content, mechanism, observed_order, start
from tests.support.mechanisms.reduced_models import Array

STICK = [[-0.5, 0.0, 0.0], [0.5, 0.0, 0.0]]
INERTIA = [0.01, 0.1, 0.1]


def run(content: Content, time: float, **settings: Any) -> Integrator:
    """Run in steps of the settings; the ledger closes and nothing penetrates."""
    integrator = start(content, **settings)
    integrator.advance(0.0, time)
    assert float(integrator["energy.error"]) < 1e-11
    for name in content["contacts"]:
        assert float(integrator[f"{name}.gap"]) > -1e-12
    return integrator


def vector(integrator: Integrator, name: str) -> Array:
    """Components of a vector among the outputs."""
    return np.array([float(integrator[f"{name}{axis}"]) for axis in "xyz"])


# ---------------------------------------------------------------------------------------- impacts


def sticks(restitution: float) -> Content:
    """A stick that moves down and turns, above one that rests across it; they are free."""
    upper = {
        "mass": 1.0, "inertia": INERTIA, "position": [0.1, 0.2, 0.3], "velocity": [0, 0, -1.0],
        "angular_velocity": [0.0, 0.5, 0.2],
    }  # fmt: skip
    turned = {"axis": [0, 0, 1], "angle": 1.1}
    lower = {"mass": 2.0, "inertia": INERTIA, "position": [0, 0, 0], "orientation": turned}
    contact = {
        "type": "capsule", "bodies": ["a", "b"], "segments": [STICK, STICK], "radii": [0.1, 0.05],
        "restitution": restitution,
    }  # fmt: skip
    bodies = {"a": upper, "b": lower}
    return mechanism("sticks", 3, gravity=False, bodies=bodies, contacts={"c": contact})


@pytest.mark.parametrize("h", [0.001, 0.02])
def test_sticks_that_cross_lose_what_their_restitution_says(h):
    """A loss of (1 - e^2) times that of e = 0, at every step; momentum stays."""
    elastic = run(sticks(1.0), 0.2, h=h)
    assert elastic["c.impacts"] == 1.0
    assert elastic["energy.impact"] == pytest.approx(0.0, abs=1e-15)
    lossy = run(sticks(0.5), 0.2, h=h)
    plastic = run(sticks(0.0), 0.2, h=h)
    before = 0.5 * (1.0 + 0.1 * 0.5**2 + 0.1 * 0.2**2)
    for ran in (elastic, lossy, plastic):
        assert vector(ran, "momentum.") == pytest.approx([0.0, 0.0, -1.0], abs=1e-13)
        left = float(ran["energy.total"])
        assert left + float(ran["energy.impact"]) == pytest.approx(before, rel=1e-13)
    assert lossy["energy.impact"] == pytest.approx(0.75 * float(plastic["energy.impact"]), rel=1e-9)


def dominoes(height: float, width: float, pitch: float, tilt: float) -> Content:
    """One tilted past its balance, about its edge, and one that stands; the floor is rough."""
    c, s = math.cos(tilt), math.sin(tilt)
    first = [-width / 2 * c + height / 2 * s, width / 2 * s + height / 2 * c]
    size = [width, height]
    inertia = (width**2 + height**2) / 12.0
    body = {"mass": 1.0, "inertia": inertia}
    floor = {"type": "corners", "size": size, "axis": [0, 1], "friction": 5.0}
    return mechanism(
        "dominoes",
        2,
        bodies={
            "a": body | {"position": first, "orientation": -tilt},
            "b": body | {"position": [pitch - width / 2, height / 2]},
        },
        contacts={
            "hit": {"type": "box", "bodies": ["a", "b"], "sizes": [size, size]},
            "under_a": floor | {"body": "a"},
            "under_b": floor | {"body": "b"},
        },
    )


@pytest.mark.parametrize("h", [0.002, 0.02])
def test_a_domino_hits_the_next_one_when_it_should_and_shares_its_speed(h):
    """Both turn about edges that are held, with equal arms of the hit: half of the energy goes."""
    height, width, pitch, tilt = 0.5, 0.08, 0.25, 0.3
    about_edge = (width**2 + height**2) / 3.0

    def slope(_: float, state: Array) -> list[float]:
        arm = -width / 2 * math.cos(state[0]) + height / 2 * math.sin(state[0])
        return [state[1], GRAVITY * arm / about_edge]

    def touches(_: float, state: Array) -> float:
        return height * math.sin(state[0]) - (pitch - width)

    touches.terminal = True  # pyright: ignore[reportFunctionMemberAccess]
    falls = solve_ivp(slope, (0.0, 2.0), [tilt, 0.0], events=touches, rtol=1e-12, atol=1e-13)
    time, speed = float(falls.t_events[0][0]), float(falls.y_events[0][0][1])
    content = dominoes(height, width, pitch, tilt)
    before = run(content, time - 1e-6, h=h, order=4)
    assert before["hit.impacts"] == 0.0
    after = run(content, time + 1e-6, h=h, order=4)
    assert after["hit.impacts"] == 1.0
    energy = 0.5 * about_edge * speed**2
    assert after["energy.impact"] == pytest.approx(0.5 * energy, rel=1e-6)
    assert after["b.angular_velocity"] == pytest.approx(-0.5 * speed, rel=1e-4)


# ---------------------------------------------------------------------------------------- resting


def tower(dimension: int, radius: float, friction: float = 0.4) -> Content:
    """Three boxes, each within the face of the one below; the lowest on a box of the ground."""
    contacts, bodies = {}, {}
    below, across = "ground", [1.0] * (dimension - 1)
    for k, name in enumerate("abc", 1):
        lower = across
        across = [0.8 * x for x in lower]
        contacts[f"on_{below}"] = {
            "type": "box", "bodies": [name, below], "sizes": [[*across, 0.5], [*lower, 0.5]],
            "radii": [radius, radius], "friction": friction,
        }  # fmt: skip
        bodies[name] = {
            "mass": 1.0, "inertia": 0.1 if dimension == 2 else [0.1, 0.1, 0.1],
            "position": [0.02 * k, *[0.03 * k] * (dimension - 2), 0.52 * k],
        }  # fmt: skip
        below = name
    return mechanism("tower", dimension, bodies=bodies, contacts=contacts)


@pytest.mark.parametrize("radius", [0.0, 0.03])
@pytest.mark.parametrize("dimension", [2, 3])
def test_boxes_fall_on_each_other_and_rest_with_the_weight_above_them(dimension, radius):
    ran = run(tower(dimension, radius), 0.3, h=0.01)
    forces = [float(ran[f"on_{below}.force"]) for below in ("ground", "a", "b")]
    assert forces == pytest.approx([3.0 * GRAVITY, 2.0 * GRAVITY, GRAVITY], rel=1e-9)
    height = float(ran["c.y" if dimension == 2 else "c.z"])
    assert height == pytest.approx(1.5, abs=1e-12)
    assert ran["energy.impact"] == pytest.approx(0.02 * GRAVITY * (1 + 2 + 3), rel=1e-12)


def test_a_box_slides_down_a_slope_of_the_ground_as_a_block_does():
    slope, friction = 0.4, 0.2
    content = tower(3, 0.01, friction)
    content["gravity"] = [GRAVITY * math.sin(slope), 0.0, -GRAVITY * math.cos(slope)]
    content["bodies"] = {"a": content["bodies"]["a"] | {"position": [-0.09, 0.0, 0.5]}}
    content["contacts"] = {"on_ground": content["contacts"]["on_ground"]}
    ran = run(content, 0.4, h=0.02)
    way = 0.5 * GRAVITY * (math.sin(slope) - friction * math.cos(slope)) * 0.4**2
    assert ran["a.x"] == pytest.approx(-0.09 + way, abs=1e-12)
    lost = friction * GRAVITY * math.cos(slope) * way
    assert ran["energy.friction"] == pytest.approx(lost, rel=1e-12)


# ---------------------------------------------------------------------------------------- rolling


@pytest.mark.parametrize(
    "ends", [STICK, [[-0.7, 0.0, 0.0], [0.3, 0.0, 0.0]]], ids=["even", "uneven"]
)
def test_a_log_rolls_off_another_one_as_a_pendulum_does(ends):
    """Without slip phi'' = g sin(phi)/(D (1 + J/(m r^2))), along a line of contact."""
    r, reach, phi = 0.1, 0.3, 0.1
    content = mechanism(
        "logs",
        3,
        bodies={
            "a": {
                "mass": 1.0,
                "inertia": [0.005, 0.1, 0.1],
                "position": [0.0, reach * math.sin(phi), reach * math.cos(phi)],
            }
        },
        contacts={
            "c": {
                "type": "capsule", "bodies": ["a", "ground"], "segments": [STICK, ends],
                "radii": [r, reach - r], "friction": 0.8,
            }
        },
    )  # fmt: skip
    rate = GRAVITY / (reach * (1.0 + 0.005 / r**2))
    exact = solve_ivp(
        lambda _, y: [y[1], rate * math.sin(y[0])], (0.0, 0.5), [phi, 0.0], rtol=1e-12, atol=1e-13
    ).y[0, -1]

    def error(h: float) -> float:
        ran = run(content, 0.5, h=h, order=4)
        assert ran["c.mode"] == 1.0
        return math.hypot(
            float(ran["a.y"]) - reach * math.sin(exact), float(ran["a.z"]) - reach * math.cos(exact)
        )

    assert error(0.005) < 1e-8
    assert observed_order([0.05, 0.025], [error(0.05), error(0.025)]) == pytest.approx(4.0, abs=0.5)


@pytest.mark.parametrize("length", [0.0, 0.4])
def test_a_drum_rolls_down_a_slope_with_two_thirds_of_what_sliding_takes(length):
    slope, radius = 0.3, 0.1
    content = mechanism(
        "drum",
        3,
        bodies={
            "drum": {
                "mass": 2.0, "inertia": [0.02, 0.02, 0.01], "position": [0, 0, radius],
                "orientation": {"axis": [1, 0, 0], "angle": math.pi / 2},
            }
        },
        contacts={
            "c": {
                "type": "cylinder", "body": "drum", "radius": radius, "length": length,
                "axis": [0, 0, 1], "friction": 0.5,
            }
        },
    )  # fmt: skip
    content["gravity"] = [GRAVITY * math.sin(slope), 0.0, -GRAVITY * math.cos(slope)]
    ran = run(content, 1.0, h=0.01, order=4)
    assert ran["drum.x"] == pytest.approx(0.5 * GRAVITY * math.sin(slope) / 1.5, rel=1e-9)
    assert ran["c.force"] == pytest.approx(2.0 * GRAVITY * math.cos(slope), rel=1e-9)
    assert ran["energy.dissipated"] == pytest.approx(0.0, abs=1e-12)


def disc(tilt: float, spin: Array, radius: float = 0.1) -> Content:
    """Thin disc, tilted about y from lying flat, with an angular velocity; it rolls."""
    down = radius * np.array([math.cos(tilt), 0.0, -math.sin(tilt)])
    body = {
        "mass": 0.5, "inertia": [0.00125, 0.00125, 0.0025], "position": [0, 0, -down[2]],
        "orientation": {"axis": [0, 1, 0], "angle": tilt},
        "angular_velocity": spin.tolist(), "velocity": (-np.cross(spin, down)).tolist(),
    }  # fmt: skip
    contact = {
        "type": "cylinder", "body": "disc", "radius": radius, "axis": [0, 0, 1], "friction": 50.0,
    }  # fmt: skip
    return mechanism("disc", 3, bodies={"disc": body}, contacts={"c": contact})


def test_a_disc_rolls_round_on_the_spot_with_its_steady_rate():
    """Omega^2 = 4 g/(R sin(tilt)) of a thin disc whose centre stays."""
    tilt, radius = 0.5, 0.1
    turn = math.sqrt(4.0 * GRAVITY / (radius * math.sin(tilt)))
    spin = turn * math.sin(tilt) * np.array([-math.cos(tilt), 0.0, math.sin(tilt)])
    ran = run(disc(tilt, spin), 1.0, h=0.002, order=4)
    assert vector(ran, "disc.") == pytest.approx([0, 0, radius * math.sin(tilt)], abs=1e-8)
    found = -vector(ran, "disc.w")[:2] / (turn * math.sin(tilt) * math.cos(tilt))
    assert found == pytest.approx([math.cos(turn), math.sin(turn)], abs=1e-6)


def rolled(tilt: float, spin: Array, time: float, radius: float = 0.1) -> Array:
    """Centre of a thin disc that rolls, by Newton's and Euler's equations about its contact."""
    mass, inertia = 0.5, np.array([0.00125, 0.00125, 0.0025])

    def slope(_: float, state: Array) -> Array:
        turn, w = Rotation.from_quat(state[:4]), state[4:7]
        matrix = turn.as_matrix()
        axis = matrix[:, 2]
        up = np.array([0.0, 0.0, 1.0]) - axis[2] * axis
        down = -radius * up / np.linalg.norm(up)
        axis_rate = np.cross(w, axis)
        up_rate = -axis_rate[2] * axis - axis[2] * axis_rate
        out = up / np.linalg.norm(up)
        down_rate = -radius * (up_rate - (up_rate @ out) * out) / np.linalg.norm(up)
        about = matrix @ np.diag(inertia) @ matrix.T
        # v = -w x down; m v' = F - m g z;  J w' + w x J w = down x F
        arm = np.array([[0, -down[2], down[1]], [down[2], 0, -down[0]], [-down[1], down[0], 0]])
        weight = mass * np.array([0.0, 0.0, GRAVITY])
        known = np.cross(down, weight - mass * np.cross(w, down_rate)) - np.cross(w, about @ w)
        w_rate = np.linalg.solve(about - mass * arm @ arm, known)
        x, y, z, s = state[:4]
        turn_rate = 0.5 * np.array([*(s * w + np.cross(w, [x, y, z])), -w @ [x, y, z]])
        return np.concatenate([turn_rate, w_rate, -np.cross(w, down)])

    first = Rotation.from_euler("y", tilt).as_quat()
    state = np.concatenate([first, spin, [0.0, 0.0, radius * math.sin(tilt)]])
    return solve_ivp(slope, (0.0, time), state, "DOP853", rtol=1e-11, atol=1e-13).y[7:, -1]


def test_a_disc_that_rolls_any_way_follows_newton_and_euler():
    tilt, spin = 1.2, np.array([0.5, 2.0, 6.0])
    exact = rolled(tilt, spin, 0.5)

    def error(h: float) -> float:
        return float(
            np.abs(vector(run(disc(tilt, spin), 0.5, h=h, order=4), "disc.") - exact).max()
        )

    assert error(0.0025) < 1e-6
    assert observed_order([0.01, 0.005], [error(0.01), error(0.005)]) == pytest.approx(4.0, abs=0.5)
