"""A ball on a table slides past its edge and falls freely: a parabola from where the edge begins.

Where v^2/r exceeds g the ball lifts off at once, and its path is that of a point: x = x_0 + v t and
a fall from the moment at which the flat part ends; friction slows it before by mu g.
"""

from __future__ import annotations

import json
import math
from typing import Any

import pytest

import solver

G = 9.81
END = 0.25  # of the flat part
STEP = 0.02  # of communication


def table(dim: int, radius: float, begin: float, speed: float, friction: float) -> dict[str, Any]:
    rest = [0.0] * (dim - 2)
    size = [0.5, *([0.5] * (dim - 2)), 0.1]
    contact: dict[str, Any] = {
        "type": "box",
        "bodies": ["ground", "ball"],
        "sizes": [size],
        "segment": [[0.0] * dim],
        "radii": [0.0, radius],
        "restitution": 0.3,
    }
    if friction:
        contact["friction"] = friction
    ball = {
        "position": [begin, *rest, 0.05 + radius],
        "mass": 1.0,
        "inertia": 1e9 if dim == 2 else [1e9] * 3,  # friction does not roll it
        "velocity": [speed, *rest, 0.0],
    }
    return {
        "name": "table",
        "dimension": dim,
        "gravity": [0.0, *rest, -G],
        "bodies": {"ball": ball},
        "contacts": {"edge": contact},
        "experiment": {"step_size": STEP, "stop_time": 0.3},
    }


def parabola(begin: float, speed: float, friction: float, time: float) -> tuple[float, ...]:
    """Way, fall and both velocities at a time after the edge."""
    way = END - begin
    at_edge = math.sqrt(speed * speed - 2.0 * friction * G * way)
    t = time - 2.0 * way / (speed + at_edge)
    return END + at_edge * t, -0.5 * G * t * t, at_edge, -G * t


def flight(content: dict[str, Any], radius: float) -> tuple[float, ...]:
    ball = solver.Integrator(solver.assemble(solver.loads(json.dumps(content), format="json")))
    for i in range(15):
        ball.advance(STEP * i, STEP)
    assert ball["energy.error"] < 1e-12
    up = "y" if content["dimension"] == 2 else "z"
    x, y, vx, vy = (float(ball[f"ball.{name}"]) for name in ("x", up, "vx", "v" + up))
    return x, y - 0.05 - radius, vx, vy


@pytest.mark.parametrize("radius", [1e-7, 1e-5, 1e-4, 2e-3])
@pytest.mark.parametrize("h", [0.02, 0.013, 0.01, 0.007, 0.005, 0.001])
def test_a_ball_that_slides_off_a_table_falls_freely_from_its_edge(radius, h):
    # 4e-3: a step may end on the edge, a hundredth of a radian past its begin, and find no force.
    content = table(2, radius, -0.105, 2.0, 0.0)
    content["solver"] = {"step_size": h, "order": 2}
    assert flight(content, radius) == pytest.approx(parabola(-0.105, 2.0, 0.0, 0.3), abs=4e-3)


@pytest.mark.parametrize("order", [2, 4, 6, 8])
@pytest.mark.parametrize("friction", [0.0, 0.05])
@pytest.mark.parametrize("dim", [2, 3])
def test_it_does_so_with_friction_at_every_order_in_plane_and_space(dim, friction, order):
    content = table(dim, 1e-4, -0.045, 4.727, friction)
    content["solver"] = {"step_size": 0.0067, "order": order}
    assert flight(content, 1e-4) == pytest.approx(parabola(-0.045, 4.727, friction, 0.3), abs=1e-3)


@pytest.mark.parametrize(
    ("radius", "begin", "speed", "friction", "h"),
    [
        (1e-3, -0.12874, 6.19709, 0.0, 0.00374),
        (1e-5, -0.04538, 4.72721, 0.05, 0.00667),
        (1e-5, 0.16578, 2.88469, 0.05, 0.00175),
        (1e-4, -0.07339, 5.46468, 0.2, 0.0013),
    ],
)
def test_in_stepped_mode_it_leaves_the_edge_within_a_step(radius, begin, speed, friction, h):
    # The gap opens in the half step that passes the edge: g h for what falls, mu g h for the way.
    content = table(2, radius, begin, speed, friction)
    content["solver"] = {"step_size": h, "contact_mode": "stepped"}
    wanted = parabola(begin, speed, friction, 0.3)
    assert flight(content, radius) == pytest.approx(wanted, abs=G * h)


@pytest.mark.parametrize("tolerance", [1e-4, 1e-6])
def test_under_a_tolerance_it_does_so_within_ten_times_that(tolerance):
    content = table(2, 1e-4, -0.105, 2.0, 0.0)
    content["solver"] = {"tolerance": tolerance}
    wanted = parabola(-0.105, 2.0, 0.0, 0.3)
    assert flight(content, 1e-4) == pytest.approx(wanted, abs=10.0 * tolerance)


@pytest.mark.parametrize("rim", [20.0, 200.0])
@pytest.mark.parametrize("h", [0.02, 0.013, 0.007, 0.004])
@pytest.mark.parametrize("dim", [2, 3])
def test_a_slow_ball_does_so_beside_a_flywheel_whose_rim_is_fast(dim, h, rim):
    # 3e-3: as above, a hundredth of a radian of 0.3 m/s.
    begin, speed, hub, turn = 0.215, 0.3, [3.0] * dim, rim / 2.0
    content = table(dim, 1e-4, begin, speed, 0.0)
    content["bodies"]["wheel"] = {
        "position": hub,
        "mass": 2.0,
        "inertia": 4.0 if dim == 2 else [2.1, 4.0, 2.1],
        "angular_velocity": turn if dim == 2 else [0.0, turn, 0.0],
    }
    axis = {} if dim == 2 else {"axis": [0.0, 1.0, 0.0]}
    bearing = {"type": "revolute", "bodies": ["ground", "wheel"], "position": hub} | axis
    content["joints"] = {"bearing": bearing}
    content["solver"] = {"step_size": h, "order": 2}
    assert flight(content, 1e-4) == pytest.approx(parabola(begin, speed, 0.0, 0.3), abs=3e-3)
