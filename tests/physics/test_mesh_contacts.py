"""Balls and parts that slide, roll and bounce on meshes, beside what is known of such motion."""

from __future__ import annotations

import math

import numpy as np
import pytest
import trimesh

from solver.runtime import Integrator
from tests.support.contact.contact_events import begin, contacts_of, cover, number
from tests.support.contact.meshes import box, data_file, ellipsoid
from tests.support.mechanisms.problems import GRAVITY, Content, mechanism, observed_order

SEMI_AXES = (1.0, 0.8, 0.6)


def place(run: Integrator, name: str) -> np.ndarray:
    return np.array([number(run, f"{name}.{axis}") for axis in "xyz"])


def bowl(**contact: object) -> Content:
    """A point that falls into an ellipsoid and slides there without friction."""
    return mechanism(
        "bowl", 3,
        points={"P": {"position": [0.5, 0.1, -0.2], "velocity": [0, 0.6, 0], "mass": 1.0}},
        contacts={"c": {"point": "P"} | contact},
    )  # fmt: skip


def slid(
    fineness: int, resolution: float, h: float, order: int = 4, time: float = 1.0
) -> Integrator:
    mesh = {"type": "mesh", "file": ellipsoid(fineness).text, "side": "inside"}
    run = begin(bowl(**mesh, resolution=resolution), h, order)
    run.advance(0.0, time)
    assert number(run, "energy.error") <= 1e-12
    assert number(run, "c.mode") == 1.0
    return run


def test_a_point_in_a_meshed_bowl_moves_as_in_the_bowl_the_finer_the_closer():
    """Triangles are off by the square of their edges, and the spline follows them."""
    exact = begin(bowl(type="superquadric", semi_axes=SEMI_AXES), 0.0025, 4)
    exact.advance(0.0, 1.0)
    errors = []
    for fineness, resolution in ((3, 0.125), (4, 0.0625)):
        errors.append(np.abs(place(slid(fineness, resolution, 0.0025), "P") - place(exact, "P")))
    coarse, fine = (error.max() for error in errors)
    assert fine < 2e-3
    assert coarse / fine > 3.0


@pytest.mark.parametrize("order", [2, 4])
def test_order_while_a_point_slides_is_that_asked_for(order):
    """Third derivatives of the spline jump from cell to cell, here by little."""
    exact = place(slid(3, 0.25, 1 / 800, 6), "P")
    steps = [0.08, 0.04, 0.02]
    errors = [np.abs(place(slid(3, 0.25, h, order), "P") - exact).max() for h in steps]
    assert observed_order(steps, errors) == pytest.approx(order, abs=0.3)


def test_a_ball_rolls_down_a_meshed_ramp_with_five_sevenths_of_the_slope():
    """Flat faces are exact: x = 5/14 g sin(a) t^2 without slip, and friction takes nothing."""
    slope = 0.2
    up = np.array([math.sin(slope), 0.0, math.cos(slope)])
    ball = {"mass": 2.0, "inertia": [0.008] * 3, "position": (0.15 * up).tolist()}  # R = 0.1
    ramp = {
        "type": "mesh", "file": box(4.0, 1.0, 1.0).text, "resolution": 0.1,
        "body": "ramp", "point": "ball", "ball_radius": 0.1, "friction": 0.5,
    }  # fmt: skip
    c, s = math.cos(slope), math.sin(slope)
    content = mechanism(
        "ramp", 3,
        bodies={
            "ball": ball,
            "ramp": {
                "mass": 1.0, "inertia": [1, 1, 1], "position": (-0.45 * up).tolist(),
                "orientation": {"axis": [0, 1, 0], "angle": slope},
            },
        },
        joints={"hold": {"type": "fixed", "bodies": ["ground", "ramp"]}},
        contacts={"c": ramp},
    )  # fmt: skip
    run = begin(content, 0.005, 4)
    run.advance(0.0, 0.5)
    way = place(run, "ball") - 0.15 * up
    assert way @ [c, 0.0, -s] == pytest.approx(5 / 14 * GRAVITY * s * 0.25, rel=1e-4)
    assert number(run, "energy.friction") == pytest.approx(0.0, abs=1e-6)


def test_a_block_slides_on_a_mesh_as_far_as_friction_lets_it():
    """v^2/(2 mu g), on four corners; all of its energy is lost by friction."""
    corners = [[x, y, -0.05] for x in (-0.05, 0.05) for y in (-0.05, 0.05)]
    content = mechanism(
        "block", 3,
        bodies={
            "block": {
                "mass": 1.0, "inertia": [0.01] * 3, "position": [-0.5, 0, 0.05],
                "velocity": [1.0, 0, 0],
            }
        },
        contacts={
            "c": {
                "type": "mesh", "file": box(3.0, 1.0, 1.0).text, "position": [0, 0, -0.5],
                "resolution": 0.1, "part": "block", "corners": corners, "friction": 0.2,
            }
        },
    )  # fmt: skip
    run = begin(content, 0.01, 2)
    run.advance(0.0, 1.0)
    assert number(run, "c.force") == pytest.approx(GRAVITY, rel=1e-6)
    assert place(run, "block")[0] + 0.5 == pytest.approx(1.0 / (0.4 * GRAVITY), rel=1e-3)
    assert number(run, "energy.friction") == pytest.approx(0.5, rel=1e-3)
    assert number(run, "energy.error") <= 1e-11


def test_bodies_that_meet_keep_their_momenta():
    """A ball hits a free body that is a mesh, with friction; both are turned as they are drawn."""
    content = mechanism(
        "hit", 3, gravity=False,
        bodies={
            "stone": {
                "mass": 2.0, "inertia": [0.5, 0.6, 0.7], "position": [0.1, -0.2, 0.3],
                "orientation": {"axis": [1, 2, 3], "angle": 0.7},
                "angular_velocity": [0.5, -1, 0.3],
            },
            "ball": {
                "mass": 1.0, "inertia": [0.01] * 3, "position": [0.3, 0.1, 2.2],
                "velocity": [0.1, -0.2, -2.0], "angular_velocity": [1, 2, -3],
            },
        },
        contacts={
            "c": {
                "type": "mesh", "file": ellipsoid(2).text, "body": "stone", "point": "ball",
                "ball_radius": 0.2, "friction": 0.3, "restitution": 0.8, "resolution": 0.1,
            }
        },
    )  # fmt: skip
    names = [f"momentum.{axis}" for axis in "xyz"] + [f"angular_momentum.{axis}" for axis in "xyz"]
    run = begin(content, 0.01, 4)
    before = [number(run, name) for name in names]
    run.advance(0.0, 2.0)
    assert number(run, "c.impacts") >= 1.0
    assert number(run, "energy.impact") > 0.0
    assert [number(run, name) for name in names] == pytest.approx(before, abs=1e-11)
    assert number(run, "energy.error") <= 1e-11


def test_a_part_passes_far_from_a_mesh_and_comes_back_into_its_grid():
    """A throw over 20 m that leaves the grid through its side and lands on the box again."""
    content = mechanism(
        "throw", 3,
        points={"P": {"position": [0, 0, 0.5], "velocity": [0.02, 0, 9.81], "mass": 1.0}},
        contacts={
            "c": {"type": "mesh", "file": box(1, 1, 1).text, "resolution": 0.1, "point": "P"}
        },
    )  # fmt: skip
    run = begin(content, 0.02, 2)
    run.advance(0.0, 2.0 - 1e-5)
    assert number(run, "c.impacts") == 0.0
    run.advance(run.time, 2e-5)
    assert number(run, "c.impacts") == 1.0


def test_a_tumbling_part_loses_energy_alone_and_never_penetrates():
    """Random throws of a die into a dish with friction: the ledger closes, whatever happens."""
    die = data_file(trimesh.creation.icosahedron())
    contact = {
        "type": "mesh", "file": ellipsoid(2, (5.0, 4.0, 3.0)).text, "side": "inside",
        "resolution": 0.5, "part": "die", "corner_file": die.text, "friction": 0.4,
        "restitution": 0.6,
    }  # fmt: skip
    random = np.random.default_rng(7)
    for _ in range(3):
        body = {
            "mass": 1.0, "inertia": [0.40, 0.42, 0.44], "position": [0, 0, 0],
            "velocity": random.uniform(-1, 1, 3).tolist(),
            "angular_velocity": random.uniform(-6, 6, 3).tolist(),
        }  # fmt: skip
        run = begin(mechanism("die", 3, bodies={"die": body}, contacts={"c": contact}), 0.01, 2)
        passed = cover(run, np.arange(1, 31) * 0.05)
        assert contacts_of(run) == ["c"]
        assert passed.error <= 1e-11
        assert passed.gap >= -1e-10
        assert passed.loss >= -1e-12
        assert number(run, "c.impacts") > 0.0
