"""Smooth friction, mu N s/sqrt(s^2 + s_0^2): no events, and the ledger of any friction."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from tests.support.contact.contact_events import begin, cover, even, number
from tests.support.contact.contact_scenes import GRAVITY, bowling_ball, incline, slider
from tests.support.mechanisms.problems import Content

MU, SPEED = 0.3, 1.5
"""Coefficient of the slider, and its first speed [m/s]."""


def smooth(content: Content, speed: float | str) -> Content:
    """Return a scene of contacts whose friction is smoothed over a speed [m/s]."""
    contacts = {name: x | {"smooth_speed": speed} for name, x in content["contacts"].items()}
    return content | {"contacts": contacts}


def way_of_slider(speed: float) -> float:
    """Way to rest: dx = s dt = -sqrt(s^2 + s_0^2) ds/(mu g)."""
    root = math.hypot(SPEED, speed)
    return (SPEED * root + speed**2 * math.asinh(SPEED / speed)) / (2.0 * MU * GRAVITY)


@pytest.mark.parametrize("speed", [0.3, 0.03, 0.003])
@pytest.mark.parametrize("mode", ["located", "stepped"])
def test_a_slider_goes_as_far_as_the_closed_form(mode, speed):
    """At rest after 40 times the time in which it creeps, with all of its energy booked.

    The step must resolve the creeping, or it errs by its order: 2 ms and s_0/(mu g) of 1 ms.
    """
    integrator = begin(smooth(slider(), speed), 0.002, contact_mode=mode)
    passed = cover(integrator, even(0.6 + 40.0 * speed / (MU * GRAVITY), 0.05))
    assert integrator["p.x"] == pytest.approx(way_of_slider(speed), abs=3e-6)
    assert integrator["energy.friction"] == pytest.approx(0.5 * SPEED**2, abs=1e-10)
    assert integrator["floor.mode"] == 2.0
    assert passed.error < 1e-12
    assert passed.loss > -1e-15


@pytest.mark.parametrize("mode", ["located", "stepped"])
@pytest.mark.parametrize("speed", [1e-4, 1e-6])
def test_steps_that_are_long_against_the_creeping_are_solved(speed, mode):
    """Friction could change the slip in one by 1500 and 150000 times s_0.

    A slip of 0.03 m/s is left for the step in which it stops, and divided; 2e-5 m of its way err.
    """
    integrator = begin(smooth(slider(), speed), 0.05, contact_mode=mode)
    passed = cover(integrator, even(1.0, 0.05))
    assert integrator["p.x"] == pytest.approx(way_of_slider(speed), abs=2e-5)
    assert passed.error < 1e-12


def test_the_speed_may_be_a_parameter():
    content = smooth(slider(), "slow") | {"parameters": {"slow": 0.3}}
    assert begin(content, 0.002)["p.x"] == begin(smooth(slider(), 0.3), 0.002)["p.x"]


def test_smooth_friction_has_no_events_and_errors_of_second_order():
    errors = []
    for h in (0.02, 0.01, 0.005):
        integrator = begin(smooth(slider(), 0.3), h)
        for t in np.arange(0.0, 0.6, h):
            integrator.advance(t, h)
            assert number(integrator, "solver.events") == 0.0
        errors.append(number(integrator, "p.x"))
    steps = np.abs(np.diff(errors))
    assert math.log2(steps[0] / steps[1]) == pytest.approx(2.0, abs=0.2)


@pytest.mark.parametrize("damping", [0.0, 0.3])
@pytest.mark.parametrize(("order", "steps"), [(4, (0.02, 0.01)), (6, (0.04, 0.02))])
def test_orders_hold_with_smooth_friction_and_dampers(order, steps, damping):
    """Weighted covers go forward alone: x'' = -k x - c x' - mu g x'/sqrt(x'^2 + s_0^2)."""
    speed, stiffness = 0.3, 60.0
    content = smooth(slider(), speed)
    content["points"] = content["points"] | {"O": {"position": [-1.0, 0.0], "fixed": True}}
    ends = {"points": ["O", "p"]}
    content["forces"] = {
        "spring": ends | {"type": "spring", "stiffness": stiffness, "free_length": 1.0},
        "damper": ends | {"type": "damper", "damping": damping},
    }

    def rates(_: float, y: list[float]) -> list[float]:
        pull = stiffness * y[0] + damping * y[1]
        return [y[1], -pull - MU * GRAVITY * y[1] / math.hypot(y[1], speed)]

    exact = solve_ivp(rates, (0.0, 0.8), [0.0, SPEED], "DOP853", rtol=1e-13, atol=1e-14).y[0, -1]
    errors = []
    for h in steps:
        integrator = begin(content, h, order)
        cover(integrator, even(0.8, 0.08))
        assert number(integrator, "solver.order_in_use") == order
        errors.append(abs(number(integrator, "p.x") - exact))
    assert errors[1] < 1e-6
    assert math.log2(errors[0] / errors[1]) > order - 0.5


def test_smooth_friction_tends_to_coulombs_with_the_square_of_its_speed():
    """The ways differ by s_0^2 (asinh(v/s_0) + 1/2)/(2 mu g), the squares and a logarithm."""
    exact = SPEED**2 / (2.0 * MU * GRAVITY)
    for speed in (0.04, 0.02, 0.01):
        integrator = begin(smooth(slider(), speed), 0.001)
        cover(integrator, even(0.8, 0.05))
        excess = speed**2 * (math.asinh(SPEED / speed) + 0.5) / (2.0 * MU * GRAVITY)
        assert number(integrator, "p.x") - exact == pytest.approx(excess, rel=0.01)


def test_a_block_across_an_incline_moves_as_its_equations_say():
    """In space friction turns with the slip; it creeps down, since nothing sticks."""
    slope, mu, s_0, until = 0.3, 0.5, 0.05, 0.5

    def rates(_: float, y: np.ndarray) -> np.ndarray:
        v = y[2:]
        rub = mu * GRAVITY * math.cos(slope) * v / math.sqrt(v @ v + s_0**2)
        return np.concatenate([v, [-GRAVITY * math.sin(slope), 0.0] - rub])

    start = [0.0, 0.0, 0.0, 1.0]
    expected = solve_ivp(rates, (0.0, until), start, "DOP853", rtol=1e-12, atol=1e-12).y[:, -1]
    integrator = begin(smooth(incline(slope, mu, [0.0, 1.0]), s_0), 0.001)
    passed = cover(integrator, even(until, 0.05))
    found = [number(integrator, f"p.{x}") for x in ("x", "y", "vx", "vy")]
    assert found == pytest.approx(expected, abs=1e-5)
    assert passed.error < 1e-12


def test_a_bowling_ball_begins_to_roll():
    """Its spin follows the same friction: 5/7 of its speed is left, as with Coulomb's."""
    integrator = begin(smooth(bowling_ball(0.7), 0.01), 0.002)
    passed = cover(integrator, even(1.5, 0.1))
    speed = math.hypot(number(integrator, "b.vx"), number(integrator, "b.vy"))
    assert speed == pytest.approx(6.0 * 5.0 / 7.0, abs=1e-9)
    assert number(integrator, "floor.slip") < 1e-9
    assert passed.error < 1e-12


def pendulum(**friction: float) -> Content:
    """Rod of 1 kg and 1 m whose bearing of 20 mm rubs, let go at rest from the horizontal."""
    bearing = {"type": "revolute", "bodies": ["ground", "rod"], "position": [0, 0]}
    return {
        "name": "pendulum",
        "dimension": 2,
        "gravity": [0, -GRAVITY],
        "bodies": {"rod": {"mass": 1.0, "inertia": 1.0 / 12.0, "position": [0.5, 0.0]}},
        "joints": {"bearing": bearing | {"friction": {"radius": 0.02} | friction}},
    }


def test_a_bearing_rubs_as_its_equations_say():
    """I a'' = -m g l cos a - (mu r N + T) a'/sqrt(a'^2 + s_0^2), N the force of the bearing."""
    mu, preload, s_0, until = 0.5, 0.2, 0.1, 2.0
    inertia, arm = 1.0 / 3.0, 0.5

    def forces(y: np.ndarray, growth: float) -> float:
        angle, rate = y
        along = rate**2 * arm - GRAVITY * math.sin(angle)
        across = growth * arm + GRAVITY * math.cos(angle)
        return math.hypot(along, across)

    def rates(_: float, y: np.ndarray) -> list[float]:
        growth = 0.0
        for _ in range(40):  # N depends on the acceleration
            size = mu * 0.02 * forces(y, growth) + preload
            rub = size * y[1] / math.hypot(y[1], s_0)
            growth = (-GRAVITY * arm * math.cos(y[0]) - rub) / inertia
        return [y[1], growth]

    expected = solve_ivp(rates, (0.0, until), [0.0, 0.0], "DOP853", rtol=1e-10, atol=1e-10).y
    content = pendulum(coefficient=mu, preload=preload, smooth_speed=s_0)
    integrator = begin(content, 0.001)
    passed = cover(integrator, even(until, 0.05))
    assert integrator["bearing.angle"] == pytest.approx(expected[0, -1], abs=1e-5)
    assert integrator["bearing.friction_mode"] == 2.0
    assert passed.error < 1e-12
    assert passed.loss > 0.0


@pytest.mark.parametrize("kind", ["spherical", "cylindrical", "prismatic", "revolute"])
def test_smooth_friction_of_joints_tends_to_coulombs(kind):
    """A body swings, or slides down an axis, for a second; a fiftieth of s_0 leaves 0.6 % at most.

    It would be 0.04 % by the square, but for logarithms and rounding.
    """
    axis = {} if kind == "spherical" else {"axis": [0, 0.6, 0.8]}
    arm = {} if kind == "prismatic" else {"radius": 0.05}
    places = []
    for smoothed in ({}, {"smooth_speed": 0.05}, {"smooth_speed": 0.001}):
        friction = {"coefficient": 0.3, "preload": 0.05} | arm | smoothed
        joint = {"type": kind, "bodies": ["ground", "b"], "position": [0, 0, 0]}
        body = {"mass": 1.0, "inertia": [0.1, 0.12, 0.05], "position": [0.3, 0, 0.1]}
        content = {
            "name": "joint", "gravity": [0, 0, -GRAVITY], "bodies": {"b": body},
            "joints": {"j": joint | axis | {"friction": friction}},
        }  # fmt: skip
        integrator = begin(content, 0.005)
        passed = cover(integrator, even(1.0, 0.1))
        places.append([number(integrator, f"b.{x}") for x in "xyz"])
        assert passed.error < 1e-12
        assert passed.loss >= 0.0
    errors = np.abs(np.array(places[1:]) - places[0]).max(axis=1)
    assert 0.0 < errors[1] < 0.006 * errors[0]
