"""Rolling and edges that move along themselves alone: constraints on velocities."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from tests.truth.minimal import Body, Number, Parts, cos, dop853, motion, sin
from tests.truth.system import Array, System, Values

G = 9.81
ACROSS = 0.26
"""Inertia of discs across their axis, in m R^2: a flat one would have 1/4."""


def _slope(name: str, part: float) -> System:
    """Disc that rolls down a slope: x'' = g sin a/(1 + J/(m R^2))."""
    m, R, tilt = 2.0, 0.3, 0.5
    text = f"""
        dimension = 2
        gravity = [{G * math.sin(tilt)!r}, {-G * math.cos(tilt)!r}]
        [bodies]
        d = {{ position = [0, {R}], mass = {m}, inertia = {part * m * R * R!r} }}
        [joints]
        wheel = {{ type = "rolling", body = "d", radius = {R} }}
    """

    def right(t: Array) -> Values:
        a = G * math.sin(tilt) / (1 + part)
        return {"d.x": a * t**2 / 2, "d.vx": a * t, "d.angle": -a * t**2 / (2 * R),
                "wheel.force.x": m * a - m * G * math.sin(tilt) + 0 * t,
                "wheel.force.y": m * G * math.cos(tilt) + 0 * t}  # fmt: skip

    return System(
        name=name, kind="rolling", origin="closed form: x'' = g sin a/(1 + J/(m R^2))",
        scene=text, stop=2.0, right=right,
    )  # fmt: skip


def _eccentric() -> System:
    """Wheel whose mass centre is off its centre: one coordinate, the angle."""
    m, R, e, J = 1.5, 0.25, 0.11, 0.03
    text = f"""
        dimension = 2
        gravity = [0, {-G}]
        [bodies]
        d = {{ position = [0, {R}], velocity = [0.6, 0], angular_velocity = {-0.6 / R}, mass = {m}, inertia = {J}, center_of_mass = [{e}, 0] }}
        [joints]
        wheel = {{ type = "rolling", body = "d", radius = {R} }}
    """

    def mechanism(_: float, q: Sequence[Number]) -> Parts:
        y = e * sin(q[0])
        return Parts([Body(m, (-R * q[0] + e * cos(q[0]), y), J, q[0])], m * G * y)

    def right(t: Array) -> Values:
        q, v = motion(mechanism, [0.0], [-0.6 / R], t)
        return {"d.angle": q[:, 0], "d.angular_velocity": v[:, 0], "d.x": -R * q[:, 0]}

    return System(
        name="eccentric_wheel", kind="rolling", origin="DOP853 in the angle", scene=text,
        stop=3.0, right=right,
    )  # fmt: skip


def _rack() -> System:
    """Pinion with a torque and a rack on a slope: (J + m r^2) w' = T - m g r sin a."""
    m, r, J, T, rise = 2.5, 0.06, 0.004, 1.8, 0.4
    text = f"""
        dimension = 2
        gravity = [{-G * math.sin(rise)!r}, {-G * math.cos(rise)!r}]
        [bodies]
        p = {{ position = [0, 0], mass = 1, inertia = {J} }}
        b = {{ position = [0, {-r}], mass = {m}, inertia = 0.01 }}
        [joints]
        axle = {{ type = "revolute", bodies = ["ground", "p"], position = [0, 0] }}
        slide = {{ type = "prismatic", bodies = ["ground", "b"], axis = [1, 0] }}
        teeth = {{ type = "rack", joints = ["axle", "slide"], radius = {r} }}
        [forces]
        motor = {{ type = "joint_torque", joint = "axle", value = {T} }}
    """

    def right(t: Array) -> Values:
        w = (T - m * G * r * math.sin(rise)) / (J + m * r * r) * t
        return {"axle.angular_velocity": w, "axle.angle": w * t / 2, "b.x": r * w * t / 2,
                "b.vx": r * w}  # fmt: skip

    return System(
        name="rack_and_pinion", kind="rolling", origin="closed form: even acceleration",
        scene=text, stop=1.0, right=right,
    )  # fmt: skip


def _sleigh(name: str, speed: float, spin: float, stop: float) -> System:
    """Chaplygin's sleigh: v' = a w^2, v^2 + b^2 w^2 = c^2 with b^2 = a^2 + J/m."""
    m, J, a = 2.0, 0.6, 0.4
    text = f"""
        dimension = 2
        [bodies]
        s = {{ position = [0, 0], velocity = [{speed}, 0], angular_velocity = {spin}, center_of_mass = [{a}, 0], mass = {m}, inertia = {J} }}
        [constraints]
        edge = {{ velocity = "s.vx*sin(s.angle) - s.vy*cos(s.angle)" }}
    """

    def right(t: Array) -> Values:
        b = math.sqrt(a * a + J / m)
        c = math.hypot(speed, b * spin)
        u0 = math.atanh(speed / c)
        u = a * c * t / b**2 + u0
        sign = math.copysign(1, spin)
        v, w = c * np.tanh(u), sign * c / b / np.cosh(u)
        angle = sign * b / a * 2 * (np.arctan(np.tanh(u / 2)) - math.atan(math.tanh(u0 / 2)))
        return {"s.angle": angle, "s.angular_velocity": w, "s.vx": v * np.cos(angle),
                "s.vy": v * np.sin(angle)}  # fmt: skip

    return System(
        name=name, kind="rolling",
        origin="closed form: v = c tanh(a c t/b^2 + u) (Chaplygin 1911)",
        scene=text, stop=stop, right=right,
    )  # fmt: skip


def _knife() -> System:
    """Knife edge that turns on a slope: its place moves on a cycloid (Neimark and Fufaev 1972)."""
    w, pull = 2.1, 3.0
    text = f"""
        dimension = 2
        gravity = [{pull}, 0]
        [bodies]
        s = {{ position = [0, 0], angular_velocity = {w}, mass = 0.7, inertia = 0.02 }}
        [constraints]
        edge = {{ velocity = "s.vx*sin(s.angle) - s.vy*cos(s.angle)" }}
    """

    def right(t: Array) -> Values:
        return {"s.x": pull / (2 * w**2) * np.sin(w * t) ** 2,
                "s.y": pull / (2 * w) * (t - np.sin(2 * w * t) / (2 * w)), "s.angle": w * t,
                "s.vy": pull / w * np.sin(w * t) ** 2}  # fmt: skip

    return System(
        name="knife_edge_on_a_slope", kind="rolling",
        origin="closed form: a cycloid (Neimark and Fufaev 1972)", scene=text, stop=3.0, right=right,
    )  # fmt: skip


def _roll(state: Array, m: float, R: float, A: float, C: float) -> tuple[Array, Array, Array]:
    """Rates of (lean, heading, w1, w2, w3, x, y), and w and v of the centre in global axes.

    Axes: e1 along the trace, e3 the disc's axis, e2 = e3 x e1, up. The contact lies at -R e2; the
    moments about it hold H' + R e2 x m (v' + g) = 0 (Neimark and Fufaev, 1972, chapter 1).
    """
    lean, heading, w1, w2, w3 = state[:5]
    s, c = math.sin(lean), math.cos(lean)
    frame = np.array([w1, w2, w2 * c / s])
    H, v = np.array([A * w1, A * w2, C * w3]), R * np.array([-w3, 0.0, w1])
    turn, bend = np.cross(frame, H), np.cross(frame, v)
    first = -(turn[0] + m * R * (bend[2] + G * c)) / (A + m * R * R)
    third = (m * R * bend[0] - turn[2]) / (C + m * R * R)
    e1 = np.array([math.cos(heading), math.sin(heading), 0.0])
    e3 = np.array([math.sin(heading) * s, -math.cos(heading) * s, c])
    e2 = np.cross(e3, e1)
    axes = np.array([e1, e2, e3]).T
    v, w = axes @ v, axes @ np.array([w1, w2, w3])
    return np.array([w1, w2 / s, first, -turn[1] / A, third, v[0], v[1]]), w, v


def _disc(name: str, lean: float, w: Sequence[float], stop: float, origin: str) -> System:
    """Disc that rolls on a plane in space; `lean` is the angle of its axis to the vertical."""
    m, R = 1.3, 0.2
    A, C = ACROSS * m * R * R, m * R * R / 2
    e2 = np.array([0.0, math.cos(lean), math.sin(lean)])
    e3 = np.array([0.0, -math.sin(lean), math.cos(lean)])
    start = np.array([lean, 0.0, *w, 0.0, R * e2[1]])
    turning = w[0] * np.array([1.0, 0, 0]) + w[1] * e2 + w[2] * e3
    velocity = np.cross(turning, R * e2)
    # The disc's axis is the body's z axis.
    text = f"""
        gravity = [0, 0, {-G}]
        [bodies.d]
        position = {(R * e2).tolist()}
        orientation = {{ axis = [1, 0, 0], angle = {lean!r} }}
        velocity = {velocity.tolist()}
        angular_velocity = {turning.tolist()}
        mass = {m}
        inertia = [{A!r}, {A!r}, {C!r}]
        [joints]
        rim = {{ type = "rolling", body = "d", radius = {R}, axis = {e3.tolist()} }}
    """

    def right(t: Array) -> Values:
        found = dop853(lambda _, y: _roll(y, m, R, A, C)[0], (0, t[-1]), start, t_eval=t).y.T
        spins = np.array([_roll(y, m, R, A, C)[1] for y in found])
        return {"d.x": found[:, 5], "d.y": found[:, 6], "d.z": R * np.sin(found[:, 0]),
                "d.wx": spins[:, 0], "d.wy": spins[:, 1], "d.wz": spins[:, 2]}  # fmt: skip

    return System(
        name=name, kind="rolling", origin=origin, scene=text, stop=stop, right=right,
        internal_step=0.005,
    )  # fmt: skip


def _circling(lean: float, turn: float) -> list[float]:
    """Rates (w1, w2, w3) at which a disc rolls in a steady circle, turning at `turn` [rad/s]."""
    R, A, C = 0.2, ACROSS, 0.5  # the inertias in m R^2
    s, c = math.sin(lean), math.cos(lean)
    w2 = turn * s
    w3 = (A * w2 * w2 * c / s - G * c / R) / (w2 * (C + 1))
    return [0.0, w2, w3]


SPATIAL = "DOP853 of the equations of Neimark and Fufaev (1972)"
SYSTEMS = (
    _slope("disc_down_a_slope", 0.5),
    _slope("ring_down_a_slope", 1.0),
    _eccentric(),
    _rack(),
    _sleigh("chaplygin_sleigh_forwards", 0.8, 1.5, 4.0),
    _sleigh("chaplygin_sleigh_that_turns_back", -1.2, 0.3, 6.0),
    _knife(),
    _disc("disc_rolls_straight", math.pi / 2, [0.0, 0.0, -9.0], 2.0, "closed form: even rolling"),
    _disc("disc_in_a_steady_circle", 1.2, _circling(1.2, 2.5), 3.0,
          "closed form: steady circle, DOP853"),
    _disc("disc_that_wobbles", 1.0, [0.4, 1.5, -12.0], 1.5, SPATIAL),
    _disc("coin_that_lies_low", 0.35, [0.0, 3.5, 1.0], 0.5, SPATIAL),
)  # fmt: skip
