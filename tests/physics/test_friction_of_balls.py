"""Balls that rub on balls in space, against closed forms and SciPy."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from tests.support.contact.contact_events import begin, cover, even, number
from tests.support.mechanisms.problems import Content

G = 9.81
SLOPE, WIDE, SMALL = 0.2, 1.0, 0.25
"""Angle from the top at which a ball is let go [rad], radii of the fixed ball and of it [m]."""


def ball_on_a_ball(direction: float) -> Content:
    """Solid ball of 1 kg, at rest beside the top of a fixed one, in a direction; mu = 2."""
    reach = WIDE + SMALL
    c, s = math.cos(direction), math.sin(direction)
    place = [reach * math.sin(SLOPE) * c, reach * math.sin(SLOPE) * s, reach * math.cos(SLOPE)]
    return {
        "name": "balls",
        "gravity": [0, 0, -G],
        "points": {"o": {"position": [0, 0, 0], "fixed": True}},
        "bodies": {"b": {"mass": 1.0, "inertia": [0.4 * SMALL**2] * 3, "position": place}},
        "contacts": {
            "c": {"type": "sphere", "points": ["o", "b"], "radii": [WIDE, SMALL], "friction": 2.0}
        },
    }


@pytest.mark.parametrize("direction", [0.0, 1.0, 4.0])
def test_a_ball_that_rolls_down_a_ball_has_the_speed_of_its_height(direction):
    """7/10 v^2 = g (R + r) (cos a - cos b); it sticks, so that friction takes nothing."""
    integrator = begin(ball_on_a_ball(direction), 0.01, order=6)
    passed = cover(integrator, even(0.9, 0.1))
    x = np.array([number(integrator, f"b.{k}") for k in "xyz"])
    v = np.array([number(integrator, f"b.v{k}") for k in "xyz"])
    slope = math.acos(x[2] / np.linalg.norm(x))
    assert slope > 0.5
    assert integrator["c.mode"] == 1.0
    fall = G * (WIDE + SMALL) * (math.cos(SLOPE) - math.cos(slope))
    assert v @ v == pytest.approx(fall / 0.7, rel=1e-9)
    turned = math.remainder(math.atan2(x[1], x[0]) - direction, 2.0 * math.pi)
    assert turned == pytest.approx(0.0, abs=1e-9)
    assert abs(number(integrator, "energy.friction")) < 1e-12
    assert passed.error < 1e-12


def test_a_ball_that_slides_in_a_socket_moves_as_its_equations_say():
    """Newton: m a = m g - N n - mu N s/|s|, I w' = -r mu N n x s/|s|, with s = v + r w x n.

    A tolerance of 1e-11 and order 6 at 2 ms leave 1e-8 of a motion of 0.5 m.
    """
    c, r, mu, inertia = 0.2, 0.05, 0.3, 0.001
    start_x, start_v, start_w = [0.0, 0.12, -0.16], [1.0, 0.4, 0.3], [3.0, -20.0, 5.0]

    def rates(_: float, y: np.ndarray) -> np.ndarray:
        x, v, w = y[:3], y[3:6], y[6:]
        n = x / c
        slip = v + r * np.cross(w, n)
        normal = v @ v / c - G * n[2]
        rub = -mu * normal * slip / np.linalg.norm(slip)
        return np.concatenate(
            [v, [0.0, 0.0, -G] - normal * n + rub, r * np.cross(n, rub) / inertia]
        )

    until = 0.06
    state = np.concatenate([start_x, start_v, start_w])
    expected = solve_ivp(rates, (0.0, until), state, "DOP853", rtol=1e-12, atol=1e-12).y[:, -1]
    scene = {
        "name": "socket",
        "gravity": [0, 0, -G],
        "points": {"o": {"position": [0, 0, 0], "fixed": True}},
        "bodies": {
            "b": {
                "mass": 1.0, "inertia": [inertia] * 3, "position": start_x, "velocity": start_v,
                "angular_velocity": start_w,
            }
        },
        "contacts": {
            "c": {
                "type": "clearance", "points": ["b", "o"], "radius": c, "pin_radius": r,
                "friction": mu,
            }
        },
    }  # fmt: skip
    integrator = begin(scene, 0.002, order=6)
    passed = cover(integrator, even(until, 0.02))
    assert integrator["c.mode"] == 2.0
    found = [number(integrator, f"b.{k}") for k in ("x", "y", "z", "vx", "vy", "vz")]
    assert found == pytest.approx(expected[:6], abs=1e-8)
    x, v, w = expected.reshape(3, 3)
    spin = [number(integrator, f"angular_momentum.{k}") for k in "xyz"]
    assert spin == pytest.approx(np.cross(x, v) + inertia * w, abs=1e-9)
    assert passed.error < 1e-12
    assert passed.loss > 0.0
