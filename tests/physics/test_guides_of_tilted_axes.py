"""A slider-crank in space, whose guide lies in the plane of its hinges but for digits of a file.

The mass centre of the crank is at its bearing, that of the rod at the crank pin. The reference is
the Lagrangian of one freedom, the angle q of the crank, with DOP853 at 1e-12.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import solver
from solver.scene import SceneError

CRANK, ROD, MASS, SLIDER, INERTIA, BEGIN, SPEED, STOP = 0.3, 0.7, 1.0, 2.0, 0.02, 0.8, 3.0, 0.5
PIN = [CRANK * math.cos(BEGIN), CRANK * math.sin(BEGIN)]
TILT = -math.asin(PIN[1] / ROD)
END = PIN[0] + ROD * math.cos(TILT)
SCENE = f"""
name = "press"
gravity = [0, -9.81, 0]
[bodies.crank]
position = [0, 0, 0]
mass = {MASS}
inertia = [{INERTIA}, {INERTIA}, {INERTIA}]
angular_velocity = [0, 0, {SPEED}]
points = {{ pin = [{PIN[0]!r}, {PIN[1]!r}, 0] }}
[bodies.rod]
position = [{PIN[0]!r}, {PIN[1]!r}, 0]
velocity = [{-SPEED * PIN[1]!r}, {SPEED * PIN[0]!r}, 0]
angular_velocity = [0, 0, {-SPEED * PIN[0] / (ROD * math.cos(TILT))!r}]
mass = {MASS}
inertia = [{INERTIA}, {INERTIA}, {INERTIA}]
[bodies.slider]
position = [{END!r}, 0, 0]
velocity = [{-SPEED * PIN[1] + SPEED * PIN[0] * math.tan(TILT)!r}, 0, 0]
mass = {SLIDER}
inertia = [0.01, 0.01, 0.01]
[joints]
A = {{ type = "revolute", bodies = ["ground", "crank"], position = [0, 0, 0], axis = [0, 0, 1] }}
B = {{ type = "revolute", bodies = ["crank", "rod"], position = [{PIN[0]!r}, {PIN[1]!r}, 0], axis = [0, 0, 1] }}
C = {{ type = "revolute", bodies = ["rod", "slider"], position = [{END!r}, 0, 0], axis = [0, 0, 1] }}
G = {{ type = "KIND", bodies = ["ground", "slider"], position = [{END!r}, 0, 0], axis = AXIS }}
[solver]
tolerance = 1e-6
"""  # noqa: E501


def scene_of(kind: str, tilt: float) -> str:
    return SCENE.replace("KIND", kind).replace("AXIS", str([1.0, 0.0, tilt]))


def right_angle() -> float:
    """Angle of the crank at the end, by d/dt (T') = Q."""

    def rate(_t: float, y: np.ndarray) -> list[float]:
        q, w = y
        p = -math.asin(CRANK * math.sin(q) / ROD)  # of the rod
        turn = -CRANK * math.cos(q) / (ROD * math.cos(p))  # dp/dq
        bend = math.tan(p) * turn**2 - math.tan(q) * turn  # d2p/dq2
        way = -CRANK * math.sin(q) - ROD * math.sin(p) * turn  # of the slider, likewise
        curve = -CRANK * math.cos(q) - ROD * (math.cos(p) * turn**2 + math.sin(p) * bend)
        mass = INERTIA + MASS * CRANK**2 + INERTIA * turn**2 + SLIDER * way**2
        force = -MASS * 9.81 * CRANK * math.cos(q)
        return [w, (force - (INERTIA * turn * bend + SLIDER * way * curve) * w**2) / mass]

    return solve_ivp(rate, (0, STOP), [BEGIN, SPEED], "DOP853", rtol=1e-12, atol=1e-13).y[0, -1]


@pytest.mark.parametrize("kind", ["prismatic", "cylindrical"])
@pytest.mark.parametrize("tilt", [0.0, 1e-10, -1e-8, 1e-6])
def test_a_guide_that_leaves_the_plane_by_digits_slides_in_it(kind, tilt):
    text = scene_of(kind, tilt)
    if tilt:
        with pytest.warns(solver.SceneWarning, match="perpendicular to that of joint 'A' but for"):
            scene = solver.loads(text)
    else:
        scene = solver.loads(text)
    run = solver.simulate(scene, stop_time=STOP, step_size=0.05)
    angle = BEGIN + run["A.angle"][-1]
    assert angle == pytest.approx(right_angle(), abs=3e-6)
    assert run["constraint.position"].max() < 1e-12


@pytest.mark.filterwarnings("ignore:.* and taken as:solver.SceneWarning")
def test_where_axes_are_made_parallel_gaps_of_the_drawing_are_refused():
    text = scene_of("prismatic", 1e-7).replace("axis = [0, 0, 1]", "axis = [1e-7, 0, 1]", 1)
    apart = "[points]\nP = { position = [0, 1, 0], mass = 1 }\n"
    apart += "Q = { position = [0, 1.02, 0], mass = 1 }\n"
    knot = 'knot = { type = "spherical", points = ["P", "Q"] }\n'
    text = text.replace("[joints]\n", apart + "[joints]\n" + knot)
    with pytest.raises(SceneError, match=r"'P' and 'Q' are drawn 0.02 m apart"):
        solver.simulate(solver.loads(text), stop_time=0.01)
