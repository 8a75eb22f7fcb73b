"""Impulses of rubbing joints: |P_T| <= mu r |P_N| with the impulses that the joint carries."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import fsolve

from tests.support.contact.contact_events import begin, cover, even, number
from tests.support.mechanisms.problems import Content

MASS, LENGTH, BALL, SPEED, E = 2.0, 1.0, 0.5, 3.0, 0.6
MU, RADIUS = 0.4, 0.05
INERTIA = MASS * LENGTH**2 / 3.0
"""A rod that hangs at rest, hit at an arm by a ball; of the rod about its bearing [kg m2]."""


def hit_rod(arm: float, dimension: int = 2, friction: float = MU) -> Content:
    """Ball that hits a hanging rod at a distance from its bearing; no gravity."""

    def at(x: float, y: float) -> list[float]:
        return [x, y] if dimension == 2 else [x, 0.0, y]

    about = MASS * LENGTH**2 / 12.0
    bearing = {"type": "revolute", "bodies": ["ground", "rod"], "position": at(0, 0)}
    if dimension == 3:
        bearing["axis"] = [0, -1, 0]
    return {
        "name": "hit",
        "dimension": dimension,
        "gravity": [0.0] * dimension,
        "points": {"b": {"mass": BALL, "position": at(-0.1, -arm), "velocity": at(SPEED, 0.0)}},
        "bodies": {
            "rod": {
                "mass": MASS,
                "inertia": about if dimension == 2 else [about, about, 0.001],
                "position": at(0.0, -0.5 * LENGTH),
            }
        },
        "joints": {
            "bearing": bearing | {"friction": {"coefficient": friction, "radius": RADIUS}}
        },
        "contacts": {
            "c": {
                "type": "plane", "point": "b", "body": "rod", "axis": at(-1.0, 0.0),
                "restitution": E,
            }
        },
    }  # fmt: skip


def speeds_after(arm: float, friction: float) -> tuple[float, float, float]:
    """Speed of the ball, rate of the rod, impulse p: the bearing takes P = p - m l w/2.

    I w = p d - mu r |P| where it slips (and 0 where it need not), e v = d w - u, m_b (v - u) = p.
    """
    for sign in (1.0, -1.0):
        # unknowns u, w, p; the sign is that of the bearing's impulse
        rub = friction * RADIUS * sign
        A = [
            [BALL, 0.0, 1.0],
            [-1.0, arm, 0.0],
            [0.0, INERTIA - 0.5 * rub * MASS * LENGTH, rub - arm],
        ]
        u, w, p = np.linalg.solve(A, [BALL * SPEED, E * SPEED, 0.0])
        if sign * (p - 0.5 * MASS * LENGTH * w) >= 0.0 and w > 0.0:
            return u, w, p
    raise AssertionError


@pytest.mark.parametrize("law", ["simultaneous", "sequential"])
@pytest.mark.parametrize("dimension", [2, 3])
@pytest.mark.parametrize("arm", [0.3, 0.6, 0.9])
def test_a_bearing_rubs_in_the_impact_of_a_ball_on_its_rod(arm, dimension, law):
    """Beyond the centre of percussion, at 2/3 m, the bearing is pushed the other way."""
    integrator = begin(hit_rod(arm, dimension), 0.05, impact_law=law)
    integrator.advance(0.0, 0.1 / SPEED + 1e-9)
    u, w, p = speeds_after(arm, MU)
    assert integrator["b.vx"] == pytest.approx(u, abs=1e-11)
    assert abs(number(integrator, "bearing.angular_velocity")) == pytest.approx(w, abs=1e-8)
    assert integrator["c.impulse"] == pytest.approx(p, abs=1e-11)
    loss = 0.5 * BALL * (SPEED**2 - u**2) - 0.5 * INERTIA * w**2
    assert integrator["energy.impact"] == pytest.approx(loss, abs=1e-11)
    free, turning, _ = speeds_after(arm, 0.0)
    assert loss > 0.5 * BALL * (SPEED**2 - free**2) - 0.5 * INERTIA * turning**2
    assert abs(number(integrator, "energy.error")) < 1e-13


def test_strong_friction_holds_the_rod_as_a_wall_would():
    """The ball comes back with e v, and the bearing's impulse is that of the ball."""
    content = hit_rod(0.3, friction=0.35 / RADIUS)
    integrator = begin(content, 0.05)
    integrator.advance(0.0, 0.1 / SPEED + 1e-9)
    assert integrator["b.vx"] == pytest.approx(-E * SPEED, abs=1e-12)
    assert integrator["bearing.angular_velocity"] == pytest.approx(0.0, abs=1e-12)
    assert integrator["energy.impact"] == pytest.approx(0.5 * BALL * SPEED**2 * (1 - E**2))


def test_the_preload_has_no_impulse():
    """In the nanosecond after the hit it acts as a torque of 5 N.m does."""
    found = []
    for preload in (0.0, 5.0):
        friction = {"coefficient": MU, "radius": RADIUS, "preload": preload}
        content = hit_rod(0.9)
        content["joints"]["bearing"]["friction"] = friction
        integrator = begin(content, 0.05)
        integrator.advance(0.0, 0.1 / SPEED + 1e-9)
        found.append([number(integrator, x) for x in ("c.impulse", "energy.impact")])
    assert found[1] == pytest.approx(found[0], abs=1e-11)


def test_a_ball_joint_rubs_against_its_angular_velocity():
    """J w = d x n p - mu r |P| w/|w| with P = m w x c - n p, and the ball as before."""
    c, d = np.array([0.1, 0.2, -0.5]), np.array([0.1, 0.35, -0.9])
    n = np.array([1.0, 0.0, 0.0])
    principal = np.array([0.2, 0.15, 0.05])
    J = np.diag(principal) + MASS * (c @ c * np.eye(3) - np.outer(c, c))

    def residual(z: np.ndarray) -> np.ndarray:
        w, u, p = z[:3], z[3], z[4]
        P = MASS * np.cross(w, c) - p * n
        rub = MU * RADIUS * np.linalg.norm(P) * w / np.linalg.norm(w)
        turned = J @ w - p * np.cross(d, n) + rub
        return np.array([*turned, BALL * (u - SPEED) + p, np.cross(w, d) @ n - u - E * SPEED])

    z = fsolve(residual, [*np.cross(d, n), 0.0, BALL * SPEED], xtol=1e-12)
    scene = {
        "name": "ball_joint",
        "gravity": [0, 0, 0],
        "points": {
            "b": {"mass": BALL, "position": (d - 0.1 * n).tolist(), "velocity": [SPEED, 0, 0]}
        },
        "bodies": {
            "rod": {"mass": MASS, "inertia": principal.tolist(), "position": c.tolist()}
        },
        "joints": {
            "bearing": {
                "type": "spherical", "bodies": ["ground", "rod"], "position": [0, 0, 0],
                "friction": {"coefficient": MU, "radius": RADIUS},
            }
        },
        "contacts": {
            "c": {
                "type": "plane", "point": "b", "body": "rod", "axis": [-1, 0, 0],
                "position": d.tolist(), "restitution": E,
            }
        },
    }  # fmt: skip
    integrator = begin(scene, 0.05)
    integrator.advance(0.0, 0.1 / SPEED + 1e-9)
    assert integrator["c.impulse"] == pytest.approx(z[4], abs=1e-9)  # of fsolve
    assert integrator["b.vx"] == pytest.approx(z[3], abs=1e-9)
    w = [number(integrator, f"rod.w{k}") for k in "xyz"]
    assert w == pytest.approx(z[:3], abs=1e-7)  # it turns 1e-9 s on, with its friction


def test_a_joint_that_rubs_never_gives_energy_in_impacts():
    """A double pendulum against a wall, with all joints rubbing, whatever the coefficients."""
    random = np.random.default_rng(3)
    for _ in range(20):
        mu, e = random.uniform(0.0, 3.0, 2), random.uniform(0.0, 1.0)
        y, x = random.uniform(-2.0, 2.0, 2), 0.6
        bodies = {
            name: {
                "mass": 1.0, "inertia": 0.1, "position": place, "velocity": velocity,
                "angular_velocity": rate,
            }
            for name, place, velocity, rate in (
                ("p", [0.3, 0.0], [0.0, 0.3 * y[0]], y[0]),
                ("q", [x, -0.3], [0.3 * y[1], 0.6 * y[0]], y[1]),
            )
        }  # fmt: skip
        pins = {"a": (["ground", "p"], [0, 0]), "b": (["p", "q"], [x, 0.0])}
        joints = {
            name: {
                "type": "revolute", "bodies": pair, "position": place,
                "friction": {"coefficient": m, "radius": 0.1},
            }
            for m, (name, (pair, place)) in zip(mu, pins.items(), strict=True)
        }  # fmt: skip
        walls = {
            "w": {"axis": [-1, 0], "position": [x + 0.01, 0]},
            "v": {"axis": [1, 0], "position": [x - 0.01, 0]},
            "f": {"axis": [0, 1], "position": [0, -0.62], "friction": 0.3},
        }
        q = bodies["q"] | {"points": {"tip": [0.0, -0.3]}}
        scene = {
            "name": "double", "dimension": 2, "gravity": [0, -9.81],
            "bodies": bodies | {"q": q},
            "joints": joints,
            "contacts": {
                k: {"type": "plane", "point": "q.tip", "restitution": e} | v
                for k, v in walls.items()
            },
        }  # fmt: skip
        passed = cover(begin(scene, 0.01), even(0.4, 0.02))
        assert passed.loss > -1e-13
        assert passed.error < 1e-11
        assert passed.gap > -1e-12


@pytest.mark.parametrize("e", [0.0, 0.6, 1.0])
def test_a_bearing_that_rubs_helps_to_stop_and_hinders_the_rebound(e):
    """Of a pendulum at a stop: e^2 of the work of compression comes back, by Routh's path.

    The bearing takes f = mu r m c of each change of the angular velocity, so that the compression
    takes v^2 (I - f)/2 and the expansion w^2 (I + f)/2. On the way centrifugal and tangential
    forces press it: d(omega)/dt = f omega^2/sqrt(I^2 - f^2).
    """
    inertia, f, speed, way = 0.5, 5.0 * 0.02 * 0.5, 2.0, 0.3
    content: Content = {
        "name": "stopped",
        "dimension": 2,
        "gravity": [0.0, 0.0],
        "bodies": {
            "bob": {"mass": 1.0, "inertia": 0.25, "position": [0.0, -0.5],
                    "velocity": [-0.5 * speed, 0.0], "angular_velocity": -speed}
        },
        "joints": {
            "bearing": {"type": "revolute", "bodies": ["ground", "bob"], "position": [0.0, 0.0],
                        "friction": {"coefficient": 5.0, "radius": 0.02}}
        },
        "contacts": {"stop": {"type": "stop", "joint": "bearing", "min": -way, "restitution": e}},
        "experiment": {"stop_time": 0.2, "step_size": 0.01},
    }  # fmt: skip
    integrator = begin(content, 1e-3, 4)
    cover(integrator, even(0.2, 0.01))
    energy = 0.5 * inertia * (speed * np.exp(-f * way / np.sqrt(inertia**2 - f**2))) ** 2
    kept = e**2 * (inertia - f) / (inertia + f)
    assert number(integrator, "stop.impacts") == 1.0
    assert number(integrator, "energy.impact") == pytest.approx(energy * (1.0 - kept), rel=1e-9)
