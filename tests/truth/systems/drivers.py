"""Drivers: prescribed motions, and the forces, torques and powers that they need."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from tests.truth.minimal import (
    Body,
    Number,
    Parts,
    Value,
    cos,
    in_time,
    motion,
    sin,
    sqrt,
    torque,
)
from tests.truth.system import Array, System, Values

G = 9.81


def _hand(name: str, rate: float, stop: float) -> System:
    """Point led about an ellipse: F = m (r'' - g), P = F r'."""
    m, a, b = 1.7, 0.8, 0.35
    text = f"""
        dimension = 2
        gravity = [0, {-G}]
        [points]
        B = {{ position = [0, {-b}], mass = {m} }}
        [drivers]
        hand = {{ type = "position", point = "B", value = ["{a}*sin({rate}*t)", "{-b}*cos({rate}*t)"] }}
    """

    def right(t: Array) -> Values:
        s, c = np.sin(rate * t), np.cos(rate * t)
        x, y = -m * a * rate**2 * s, m * (b * rate**2 * c + G)
        vx, vy = a * rate * c, b * rate * s
        return {"B.vx": vx, "B.vy": vy, "hand.force.x": x, "hand.force.y": y,
                "hand.power": x * vx + y * vy}  # fmt: skip

    return System(
        name=name, kind="drivers", origin="closed form: F = m (r'' - g), P = F r'",
        scene=text, stop=stop, right=right, internal_step=0.1 / rate,
    )  # fmt: skip


def _crank(speed: float) -> System:
    """Slider-crank whose crank turns evenly: its torque is that of one coordinate."""
    r, c, m, mc = 0.12, 0.43, 0.9, 1.6
    text = f"""
        dimension = 2
        gravity = [0, {-G}]
        [bodies]
        crank = {{ position = [0, 0], angular_velocity = {speed}, mass = 2, inertia = 0.02, center_of_mass = [0.03, 0.01], points = {{ e = [{r}, 0] }} }}
        rod = {{ position = [{r + c / 2}, 0], mass = {m}, inertia = 0.03, points = {{ a = [{-c / 2}, 0], e = [{c / 2}, 0] }} }}
        slider = {{ position = [{r + c}, 0], mass = {mc}, inertia = 0.01 }}
        [joints]
        bearing = {{ type = "revolute", bodies = ["ground", "crank"], position = [0, 0] }}
        pin = {{ type = "revolute", points = ["crank.e", "rod.a"] }}
        wrist = {{ type = "revolute", points = ["rod.e", "slider"] }}
        guide = {{ type = "prismatic", bodies = ["ground", "slider"], axis = [1, 0] }}
        [drivers]
        motor = {{ type = "angle", joint = "bearing", value = "{speed}*t" }}
        [solver]
        assemble = true
    """

    def place(q: Number) -> tuple[Value, Value, Value]:
        x, y = r * cos(q), r * sin(q)
        return x, y, x + sqrt(c * c - y * y)

    def mechanism(_: float, q: Sequence[Number]) -> Parts:
        x, y, end = place(q[0])
        down = y * -(1 / c)
        level = y * 0.5
        centre = (0.03 * cos(q[0]) - 0.01 * sin(q[0]), 0.03 * sin(q[0]) + 0.01 * cos(q[0]))
        # The rod's angle enters by its rate alone: cos(b) b' = -(y/c)'.
        rate_of_angle = Number(
            math.asin(down.value), down.gradient / math.sqrt(1 - down.value**2),
            down.rate / math.sqrt(1 - down.value**2),
            down.bias / math.sqrt(1 - down.value**2)
            + down.value * down.rate**2 / (1 - down.value**2) ** 1.5,
        )  # fmt: skip
        bodies = [
            Body(2, centre, 0.02, q[0]),
            Body(m, ((x + end) * 0.5, level), 0.03, rate_of_angle),
            Body(mc, (end, 0.0)),
        ]
        return Parts(bodies, 2 * G * centre[1] + m * G * level)

    def right(t: Array) -> Values:
        places, rates, _ = in_time(lambda s: [place(speed * s)[2]], t)
        T = torque(mechanism, t, speed * t, np.full_like(t, speed), np.zeros_like(t))
        return {"slider.x": places[:, 0], "slider.vx": rates[:, 0], "motor.torque": T,
                "motor.power": T * speed}  # fmt: skip

    return System(
        name=f"driven_crank_{speed:g}", kind="drivers",
        origin="closed form of places; torque of the one coordinate, Kane's form",
        scene=text, stop=1.0, right=right, internal_step=0.1 / speed,
    )  # fmt: skip


def _lift() -> System:
    """Slider in space on an inclined axis: F = m (s'' + g sin a)."""
    m, rise, rate = 3.0, 0.6, 2.3
    axis = np.array([math.cos(rise) * 0.8, math.cos(rise) * 0.6, math.sin(rise)])
    text = f"""
        gravity = [0, 0, {-G}]
        [bodies]
        b = {{ position = [0.2, -0.1, 0.3], mass = {m}, inertia = [0.1, 0.2, 0.15] }}
        [joints]
        guide = {{ type = "prismatic", bodies = ["ground", "b"], axis = {axis.tolist()} }}
        [drivers]
        d = {{ type = "displacement", joint = "guide", value = "0.4*sin({rate}*t)**2 + 0.1*t" }}
    """

    def right(t: Array) -> Values:
        s, v, a = in_time(lambda x: [0.4 * sin(rate * x) ** 2 + 0.1 * x], t)
        F = m * (a[:, 0] + G * math.sin(rise))
        return {"guide.displacement": s[:, 0], "b.vz": v[:, 0] * axis[2], "d.force": F,
                "d.power": F * v[:, 0]}  # fmt: skip

    return System(
        name="driven_lift_in_space", kind="drivers", origin="closed form: F = m (s'' + g sin a)",
        scene=text, stop=2.0, right=right, internal_step=0.02,
    )  # fmt: skip


def _hoist() -> System:
    """Load that swings while its rope is drawn in: a'' = -(2 l' a' + g sin a)/l."""
    m, length = 2.5, 1.6
    text = f"""
        dimension = 2
        gravity = [0, {-G}]
        [points]
        load = {{ position = [{length * math.sin(0.5)}, {-length * math.cos(0.5)}], mass = {m} }}
        [drivers]
        rope = {{ type = "distance", points = ["ground", "load"], at = [0, 0], value = "{length} - 0.3*t + 0.05*sin(2*t)" }}
    """

    def at(t: float) -> tuple[float, float, float]:
        return (length - 0.3 * t + 0.05 * math.sin(2 * t), -0.3 + 0.1 * math.cos(2 * t),
                -0.2 * math.sin(2 * t))  # fmt: skip

    def mechanism(t: float, q: Sequence[Number]) -> Parts:
        # In units of the rope's length at t: inertia 1, torque by the equation above.
        own, rate, _ = at(t)
        load = -(2 * rate * q[0].rate + G * math.sin(q[0].value)) / own
        return Parts([Body(1.0, (0.0,), 1.0, q[0])], torques=[load])

    def right(t: Array) -> Values:
        q, v = motion(mechanism, [0.5], [0.0], t)
        own, rate, second = np.array([at(x) for x in t]).T
        a, w = q[:, 0], v[:, 0]
        pull = m * (G * np.cos(a) + own * w**2 - second)
        return {"load.x": own * np.sin(a), "load.y": -own * np.cos(a),
                "load.vx": rate * np.sin(a) + own * w * np.cos(a),
                "load.vy": -rate * np.cos(a) + own * w * np.sin(a),
                "rope.force": -pull, "rope.power": -pull * rate}  # fmt: skip

    return System(
        name="hoist", kind="drivers", origin="DOP853 of a'' = -(2 l' a' + g sin a)/l",
        scene=text, stop=3.0, right=right,
    )  # fmt: skip


def _two_axes() -> System:
    """Robot of two driven axes in space: Lagrange's equations in both angles."""
    m, r, J1, J2, Jr = 4.0, 0.35, 0.3, 0.06, 0.01
    text = f"""
        gravity = [0, 0, {-G}]
        [bodies]
        table = {{ position = [0, 0, 0], mass = 5, inertia = [0.2, 0.2, {J1}] }}
        arm = {{ position = [{r}, 0, 0.4], mass = {m}, inertia = [{Jr}, {J2}, {J2}] }}
        [joints]
        turn = {{ type = "revolute", bodies = ["ground", "table"], position = [0, 0, 0], axis = [0, 0, 1] }}
        tilt = {{ type = "revolute", bodies = ["table", "arm"], position = [0, 0, 0.4], axis = [0, -1, 0] }}
        [drivers]
        a = {{ type = "angle", joint = "turn", value = "1.2*sin(2*t)" }}
        b = {{ type = "angle", joint = "tilt", value = "0.7*(1 - cos(3*t))" }}
    """

    def right(t: Array) -> Values:
        _, v1, a1 = in_time(lambda s: [1.2 * sin(2 * s)], t)
        q2, v2, a2 = in_time(lambda s: [0.7 * (1 - cos(3 * s))], t)
        c, s = np.cos(q2[:, 0]), np.sin(q2[:, 0])
        J = J1 + (J2 + m * r * r) * c**2 + Jr * s**2
        slope = -2 * (J2 + m * r * r - Jr) * c * s
        first = J * a1[:, 0] + slope * v2[:, 0] * v1[:, 0]
        second = (J2 + m * r * r) * a2[:, 0] - slope / 2 * v1[:, 0] ** 2 + m * G * r * c
        return {"arm.z": 0.4 + r * s, "a.torque": first, "b.torque": second,
                "a.power": first * v1[:, 0], "b.power": second * v2[:, 0]}  # fmt: skip

    return System(
        name="two_driven_axes", kind="drivers", origin="closed form: Lagrange in two angles",
        scene=text, stop=2.0, right=right,
    )  # fmt: skip


def _cylinder() -> System:
    """Arm in space that a cylinder lifts: the triangle of the cylinder gives the angle."""
    a, b, m, r, J = 0.5, 0.8, 12.0, 0.7, 0.9
    start = math.sqrt(a * a + b * b)
    text = f"""
        gravity = [0, 0, {-G}]
        [bodies]
        arm = {{ position = [{r}, 0, 0], mass = {m}, inertia = [0.02, {J}, {J}], points = {{ c = [{b - r}, 0, 0] }} }}
        [joints]
        hinge = {{ type = "revolute", bodies = ["ground", "arm"], position = [0, 0, 0], axis = [0, -1, 0] }}
        [drivers]
        ram = {{ type = "distance", points = ["ground", "arm.c"], at = [0, 0, {-a}], value = "{start!r} + 0.12*(1 - cos(1.5*t))" }}
    """

    def angle(t: Number) -> Number:
        length = start + 0.12 * (1 - cos(1.5 * t))
        sine = (length**2 - (a * a + b * b)) / (2 * a * b)
        c = math.sqrt(1 - sine.value**2)
        return sine.of(math.asin(sine.value), 1 / c, sine.value / c**3)

    def right(t: Array) -> Values:
        q, v, w = (x[:, 0] for x in in_time(lambda s: [angle(s)], t))
        length, speed, _ = (
            x[:, 0] for x in in_time(lambda s: [start + 0.12 * (1 - cos(1.5 * s))], t)
        )
        T = (J + m * r * r) * w + m * G * r * np.cos(q)
        F = T * length / (a * b * np.cos(q))
        return {"hinge.angle": q, "hinge.angular_velocity": v, "ram.force": F,
                "ram.power": F * speed}  # fmt: skip

    return System(
        name="lifting_cylinder", kind="drivers", origin="closed form: cosine rule, lever arm",
        scene=text, stop=2.0, right=right, internal_step=0.04,
    )  # fmt: skip


def _reaction_wheel() -> System:
    """Free body and a wheel in it: the body turns back as the momentum asks."""
    J, wheel = 0.8, 0.05
    text = f"""
        dimension = 2
        [bodies]
        b = {{ position = [0, 0], mass = 10, inertia = {J} }}
        w = {{ position = [0, 0], mass = 1, inertia = {wheel} }}
        [joints]
        axle = {{ type = "revolute", bodies = ["b", "w"], position = [0, 0] }}
        [drivers]
        motor = {{ type = "angle", joint = "axle", value = "20*t*t/(1 + t)" }}
    """

    def right(t: Array) -> Values:
        q, v, a = (x[:, 0] for x in in_time(lambda s: [20 * s * s / (1 + s)], t))
        part = -wheel / (J + wheel)
        T = wheel * (1 + part) * a
        return {"b.angle": part * q, "b.angular_velocity": part * v, "motor.torque": T,
                "motor.power": T * v, "angular_momentum.z": 0 * t}  # fmt: skip

    return System(
        name="reaction_wheel", kind="drivers", origin="closed form: angular momentum stays zero",
        scene=text, stop=2.0, right=right,
    )  # fmt: skip


def _shaken_pivot() -> System:
    """Pendulum on a pivot that moves up and down fast: (J + m l^2) a'' = -m l (g + y'') sin a."""
    m, r, J, size, rate = 0.8, 0.25, 0.012, 0.03, 60.0
    text = f"""
        dimension = 2
        gravity = [0, {-G}]
        [points]
        P = {{ position = [0, {size}], mass = 0.1 }}
        [bodies]
        b = {{ position = [{r * math.sin(0.7)}, {size - r * math.cos(0.7)}], orientation = {0.7 - math.pi / 2}, mass = {m}, inertia = {J}, points = {{ a = [{-r}, 0] }} }}
        [joints]
        pin = {{ type = "revolute", points = ["P", "b.a"] }}
        [drivers]
        shaker = {{ type = "position", point = "P", value = ["0", "{size}*cos({rate}*t)"] }}
    """

    def mechanism(t: float, q: Sequence[Number]) -> Parts:
        lift = G - size * rate**2 * math.cos(rate * t)
        return Parts([Body(m, (r * sin(q[0]), -r * cos(q[0])), J, q[0])],
                     energy=-m * r * lift * cos(q[0]))  # fmt: skip

    def right(t: Array) -> Values:
        q, v = motion(mechanism, [0.7], [0.0], t)
        return {"b.angle": q[:, 0] - math.pi / 2, "b.angular_velocity": v[:, 0]}

    return System(
        name="pendulum_on_a_shaken_pivot", kind="drivers", origin="DOP853 in the angle",
        scene=text, stop=1.0, right=right, internal_step=0.002,
    )  # fmt: skip


SYSTEMS = (
    _hand("hand_about_an_ellipse", 2.5, 3.0),
    _hand("fast_hand", 80.0, 0.1),
    _crank(6.0),
    _crank(150.0),
    _lift(),
    _hoist(),
    _two_axes(),
    _cylinder(),
    _reaction_wheel(),
    _shaken_pivot(),
)
