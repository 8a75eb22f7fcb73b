"""Actuators: limits of force, torque and power, gears, controllers; against closed forms."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import solver
from solver.scene import SceneError

LIFT = """
name = "lift"
dimension = 2
[points]
A = { position = [1, 0], mass = 10.0 }
[forces.lift]
type = "actuator"
points = ["ground", "A"]
at = [0, 0]
value = 1000
max_force = 100
max_power = 200
"""
WHEEL = """
name = "wheel"
dimension = 2
[inputs]
u = {{ start = {u} }}
[profiles]
curve = {{ x = [0, 50, 100], y = [2, 2, 0], interpolation = "linear" }}
[bodies]
wheel = {{ mass = 1, inertia = {inertia}, position = [0, 0] }}
[joints]
hinge = {{ type = "revolute", bodies = ["ground", "wheel"], position = [0, 0] }}
[forces]
motor = {{ type = "actuator", joint = "hinge", {fields} }}
load = {{ type = "joint_torque", joint = "hinge", value = {load} }}
"""


def run(text: str, stop: float, points: int, names: list[str], **settings: Any) -> dict:
    names = [*names, "energy.error", "energy.work"]
    return solver.simulate(
        solver.loads(text), stop_time=stop, step_size=stop / points, outputs=names, **settings
    )


LIFTED = ["A.x", "A.vx", "lift.force", "lift.power", "lift.limited", "lift.length"]


@pytest.mark.parametrize(
    ("settings", "within"),
    [
        ({"order": 4, "internal_step": 0.05}, 2e-7),
        ({"order": 4, "internal_step": 0.025}, 1.3e-8),
        ({"tolerance": 1e-4}, 3e-4), ({"tolerance": 1e-6}, 3e-6), ({"tolerance": 1e-8}, 3e-8),
        ({"tolerance": 1e-8, "method": "fastest"}, 3e-8),
    ],
)  # fmt: skip
def test_a_cylinder_is_at_its_force_and_then_at_its_power(
    settings: dict[str, Any], within: float
) -> None:
    """It has F until F v = P at 0.2 s, then m v v' = P: v(1) = 6 and x(1) = 11/3, work 180."""
    found = run(LIFT, 1.0, 10, LIFTED, **settings)
    assert found["A.vx"][-1] == pytest.approx(6.0, abs=6.0 * within)
    assert found["A.x"][-1] - 1.0 == pytest.approx(11.0 / 3.0, abs=4.0 * within)
    assert found["energy.work"][-1] == pytest.approx(180.0, abs=360.0 * within)
    assert found["energy.error"].max() < 1e-14
    limit = found["lift.limited"].tolist()
    assert (limit[:2], limit[3:]) == ([1.0] * 2, [2.0] * 8)
    assert limit[2] in (1.0, 2.0)  # at the switch round-off decides
    assert found["lift.force"][[1, -1]] == pytest.approx([100.0, 200.0 / 6.0], rel=6.0 * within)
    assert found["lift.power"][-1] == pytest.approx(200.0, rel=1e-12)
    assert np.array_equal(found["lift.length"], found["A.x"])


@pytest.mark.parametrize(("order", "within"), [(4, 1e-8), (6, 1e-11), (8, 1e-12)])
def test_equal_steps_end_where_force_goes_over_into_power(order: int, within: float) -> None:
    """With 11 kg that is at 0.22 s, within a step; then m v v' = P, and no order is lost."""
    text = LIFT.replace("mass = 10.0", "mass = 11.0")
    found = run(text, 1.0, 10, LIFTED, order=order, internal_step=0.05)
    rate = math.sqrt(4.0 + 400.0 * 0.78 / 11.0)
    way = 0.5 * 2.0 * 0.22 + (rate**3 - 8.0) * 11.0 / 600.0
    assert found["A.vx"][-1] == pytest.approx(rate, rel=within)
    assert found["A.x"][-1] - 1.0 == pytest.approx(way, rel=3.0 * within)


@pytest.mark.parametrize("tolerance", [1e-4, 1e-6, 1e-8])
def test_a_motor_falls_along_its_torque_curve(tolerance: float) -> None:
    """J w' = 2 to the corner at 50 rad/s, and then J w' = 4 - w/25."""
    fields = 'value = 1000, max_torque = "curve(motor_speed)"'
    text = WHEEL.format(u=0, inertia=0.05, fields=fields, load=0)
    names = ["hinge.angle", "hinge.angular_velocity", "motor.torque", "motor.limited"]
    found = run(text, 2.0, 20, names, tolerance=tolerance)
    assert abs(found["hinge.angular_velocity"][-1] - 72.559418195299) < 3.0 * tolerance * 72.6
    assert abs(found["hinge.angle"][-1] - 78.050727255877) < 3.0 * tolerance * 78.1
    rate = found["hinge.angular_velocity"]
    assert found["motor.torque"] == pytest.approx(np.minimum(2.0, 4.0 - rate / 25.0), abs=1e-12)
    assert np.all(found["motor.limited"] == 1.0)


@pytest.mark.parametrize(
    ("settings", "within"),
    [({"order": 2, "internal_step": 0.01}, 0.009), ({"tolerance": 1e-8}, 3e-7)],  # a step at rest
)
@pytest.mark.parametrize("u", [0.5, 0.3, 0.22, 0.1, -0.2])
def test_a_gear_holds_what_lies_between(u: float, settings: dict[str, Any], within: float) -> None:
    """At ratio 20 and efficiency 0.8 it drives with 16 u, gives way at 25 u, and holds between."""
    fields = 'value = "u", ratio = 20, efficiency = 0.8'
    text = WHEEL.format(u=u, inertia=0.5, fields=fields, load=-5)
    names = ["hinge.angular_velocity", "motor.torque", "motor.motor_speed", "energy.friction"]
    found = run(text, 1.0, 10, names, **settings)
    torque = 16.0 * u if 16.0 * u > 5.0 else 25.0 * u if 0.0 < 25.0 * u < 5.0 else 5.0
    torque = 16.0 * u if u < 0.0 else torque  # it drives with the load
    rate = (torque - 5.0) / 0.5
    assert found["motor.torque"][1:] == pytest.approx(torque, abs=1e-9)
    assert found["hinge.angular_velocity"][-1] == pytest.approx(rate, abs=within)
    assert found["motor.motor_speed"][-1] == 20.0 * found["hinge.angular_velocity"][-1]
    assert np.all(np.diff(found["energy.friction"]) >= 0.0)
    assert found["energy.error"].max() < 1e-13


@pytest.mark.parametrize("settings", [{"tolerance": 1e-8}, {"order": 4, "internal_step": 0.01}])
@pytest.mark.parametrize("load", ["0", "0.5*sin(2*t)"])
def test_a_gear_rubs_also_where_its_motor_begins_without_a_torque(
    load: str, settings: dict[str, object]
) -> None:
    """J w' = n e u + M with u = 0.8 sin 2t, from rest; friction of n u (1/e - e)/2 is taken."""
    fields = 'value = "0.8*sin(2*t)", ratio = 5, efficiency = 0.8'
    text = WHEEL.format(u=0, inertia=0.5, fields=fields, load=f'"{load}"')
    names = ["hinge.angle", "hinge.angular_velocity", "energy.friction"]
    found = run(text, 1.0, 10, names, **settings)
    size = (3.2 + (0.5 if load != "0" else 0.0)) / (0.5 * 2.0)
    rate, angle = size * (1.0 - math.cos(2.0)), size * (1.0 - 0.5 * math.sin(2.0))
    assert found["hinge.angular_velocity"][-1] == pytest.approx(rate, rel=1e-7)
    assert found["hinge.angle"][-1] == pytest.approx(angle, rel=1e-7)
    # the integral of sin 2t (1 - cos 2t) is (1 - cos 2)^2/4
    lost = 5.0 * 0.8 * (1.25 - 0.8) / 2.0 * size * (1.0 - math.cos(2.0)) ** 2 / 4.0
    assert found["energy.friction"][-1] == pytest.approx(lost, rel=1e-6)


@pytest.mark.parametrize(
    ("limits", "rate"),
    [
        ('max_power = "0.5 - t"', math.sqrt(1.5)),  # J w w' = P until P = 0
        ('max_torque = 2, max_power = "0.5 - t"', math.sqrt(1.5)),
        ('max_torque = "0.5 - t"', 1.25),  # J w' = M until M = 0
        ('max_torque = "0.5 - t", max_power = 9', 1.25),
        ('max_torque = "0.5 - t", max_power = "0.9 - t"', 1.25),
    ],
)
def test_a_limit_that_falls_below_0_leaves_nothing(limits: str, rate: float) -> None:
    """At 0.5 s the motor has nothing left, and the wheel goes on as it is; from 1 rad/s."""
    text = WHEEL.format(u=0, inertia=0.5, fields=f"value = 1, {limits}", load=0)
    text = text.replace("mass = 1", "mass = 1, angular_velocity = 1")
    found = run(text, 1.0, 4, ["hinge.angular_velocity", "motor.torque"], tolerance=1e-8)
    assert found["hinge.angular_velocity"][2:] == pytest.approx(rate, abs=3e-8)
    assert found["motor.torque"][3:] == pytest.approx(0.0, abs=1e-99)


PENDULUM = """
name = "pendulum"
dimension = 2
gravity = [0, -9.81]
[bodies]
rod = { mass = 1.0, inertia = 0.3, position = [1, 0] }
[joints]
hinge = { type = "revolute", bodies = ["ground", "rod"], position = [0, 0] }
[forces.motor]
type = "actuator"
joint = "hinge"
value = "2*(1.2 - hinge.angle) - 0.7*rate"
ratio = 15
"""


def held() -> np.ndarray:
    """Angle and rate of the pendulum at 1.5 s, by DOP853."""

    def motion(_: float, y: np.ndarray) -> list[float]:
        torque = 15.0 * (2.0 * (1.2 - y[0]) - 0.7 * y[1])
        return [y[1], (torque - 9.81 * math.cos(y[0])) / 1.3]

    found = solve_ivp(motion, (0.0, 1.5), [0.0, 0.0], method="DOP853", rtol=1e-12, atol=1e-14)
    return found.y[:, -1]


ANGLES = ["hinge.angle", "hinge.angular_velocity"]


@pytest.mark.parametrize("method", ["conserving", "fastest"])
@pytest.mark.parametrize("tolerance", [1e-4, 1e-6, 1e-8])
def test_a_controller_keeps_a_tolerance(tolerance: float, method: str) -> None:
    found = run(PENDULUM, 1.5, 15, ANGLES, tolerance=tolerance, method=method)
    right = held()
    assert abs(found["hinge.angle"][-1] - right[0]) < 3.0 * tolerance * 1.2
    assert abs(found["hinge.angular_velocity"][-1] - right[1]) < 3.0 * tolerance * 2.0
    assert found["energy.error"].max() < 1e-13


@pytest.mark.parametrize("order", [2, 4, 6])
def test_a_controller_holds_every_order(order: int) -> None:
    runs = [run(PENDULUM, 1.5, 1, ANGLES, order=order, internal_step=1.5 / n) for n in (15, 30, 60)]
    errors = [abs(found["hinge.angle"][-1] - held()[0]) for found in runs]
    assert math.log2(errors[-2] / errors[-1]) > order - 0.3


def test_a_strong_controller_is_stable_at_any_step() -> None:
    """Gains that a sampled law could not have: 4e4 N.m.s/rad on 1.3 kg.m2 in steps of 0.1 s."""
    text = PENDULUM.replace(
        "2*(1.2 - hinge.angle) - 0.7*rate", "1e4*(1.2 - hinge.angle) - 3e3*rate"
    )
    found = run(text, 30.0, 30, ANGLES, order=2, internal_step=0.1)
    sag = 9.81 * math.cos(1.2) / 1.5e5  # 2.4e-5 rad
    # A swing of the rate, of one step and back, is left: it decays as the midpoint lets it.
    assert found["hinge.angle"][-1] == pytest.approx(1.2 - sag, abs=0.5 * sag)


@pytest.mark.parametrize(
    ("fields", "words"),
    [
        ("value = 1", "acts along one of points, joint, guide, got nothing"),
        ('points = ["ground","A"], joint = "hinge", value = 1', "got 'points' and 'joint'"),
        ('joint = "hinge"', "'value' is missing"),
        ('joint = "hinge", value = 1, max_force = 3', "about 'joint' has no force"),
        ('joint = "hinge", value = "5 kN"', "is 5 kN, and must be in N.m"),
        ('guide = "hinge", value = 1', "has no displacement"),
        ('joint = "hinge", value = "5 kN"', "value: is 5 kN, and must be in N.m"),
        ('points = ["ground","A"], at = [0,0], value = "5 N.m"', "is 5 N.m, and must be in N"),
        ('joint = "hinge", value = 1, ratio = 0', "must be other than 0"),
        ('joint = "hinge", value = 1, efficiency = 1.2', "above 0, and at most 1"),
        ('joint = "hinge", value = 1, max_torque = -2', "must be > 0 N.m, got -2"),
        ('points = ["ground","A"], at = [0,0], value = 1, ratio = 2', "no motor that turns"),
        ('joint = "hinge", value = "sign(hinge.angle)"', "it would jump where a condition"),
    ],
)
def test_bad_input_is_told(fields: str, words: str) -> None:
    bad = f'[forces.bad]\ntype = "actuator"\n{fields.replace(", ", chr(10))}\n'
    text = f"{PENDULUM}{bad}[points]\nA = {{ position = [5, 0], mass = 1 }}\n"
    with pytest.raises(SceneError, match=words):
        solver.assemble(solver.loads(text))
