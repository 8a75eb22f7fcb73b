"""Reactions of joints, rods and gears, and momenta: by Newton's law on motions in closed form."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from scipy.special import ellipj, ellipk

from tests.truth.minimal import Body, Number, Parts, accelerations, cos, in_time, motion, sin, sqrt
from tests.truth.system import Array, System, Values

G = 9.81


def _pendulum(start: float, stop: float) -> System:
    """Pendulum on a rod: sin(a/2) = k sn(K + w t), pull m (g cos a + l a'^2)."""
    m, r = 1.7, 0.9
    text = f"""
        dimension = 2
        gravity = [0, {-G}]
        [points]
        A = {{ position = [{r * math.sin(start)!r}, {-r * math.cos(start)!r}], mass = {m} }}
        [joints]
        rod = {{ type = "distance", points = ["ground", "A"], at = [0, 0] }}
    """

    def right(t: Array) -> Values:
        w, k = math.sqrt(G / r), math.sin(start / 2)
        sn, cn, _, _ = ellipj(ellipk(k * k) + w * t, k * k)
        a, rate = 2 * np.arcsin(k * sn), 2 * k * w * cn
        return {"A.x": r * np.sin(a), "A.y": -r * np.cos(a), "A.vx": r * rate * np.cos(a),
                "rod.force": m * (G * np.cos(a) + r * rate**2)}  # fmt: skip

    return System(
        name=f"pull_of_a_pendulum_from_{start:g}", kind="reactions",
        origin="closed form: Jacobi's elliptic functions", scene=text, stop=stop, right=right,
    )  # fmt: skip


def _bearing() -> System:
    """Compound pendulum: the bearing carries m (a - g)."""
    m, r, J, start = 2.2, 0.35, 0.06, 2.4
    text = f"""
        dimension = 2
        gravity = [0, {-G}]
        [bodies]
        b = {{ position = [0, 0], orientation = {start - math.pi / 2!r}, mass = {m}, inertia = {J}, center_of_mass = [{r}, 0] }}
        [joints]
        j = {{ type = "revolute", bodies = ["ground", "b"], position = [0, 0] }}
    """

    def mechanism(_: float, q: Sequence[Number]) -> Parts:
        y = -r * cos(q[0])
        return Parts([Body(m, (r * sin(q[0]), y), J, q[0])], m * G * y)

    def right(t: Array) -> Values:
        q, v = motion(mechanism, [start], [0.0], t)
        second = np.array([accelerations(mechanism, 0.0, *s)[0] for s in zip(q, v, strict=True)])
        a, w = q[:, 0], v[:, 0]
        return {"j.angle": a - start, "j.angular_velocity": w,
                "j.force.x": m * r * (second * np.cos(a) - w**2 * np.sin(a)),
                "j.force.y": m * (G + r * (second * np.sin(a) + w**2 * np.cos(a)))}  # fmt: skip

    return System(
        name="bearing_of_a_compound_pendulum", kind="reactions",
        origin="DOP853 in the angle, F = m (a - g)", scene=text, stop=3.0, right=right,
    )  # fmt: skip


def _cantilever() -> System:
    """Bar fixed to a driven arm in the plane: force and torque of the fixed joint."""
    m, J, root, reach = 1.2, 0.04, 0.5, 0.8
    text = f"""
        dimension = 2
        gravity = [0, {-G}]
        [bodies]
        arm = {{ position = [0, 0], mass = 3, inertia = 0.3 }}
        b = {{ position = [{reach}, 0], mass = {m}, inertia = {J} }}
        [joints]
        j = {{ type = "revolute", bodies = ["ground", "arm"], position = [0, 0] }}
        weld = {{ type = "fixed", bodies = ["arm", "b"], position = [{root}, 0] }}
        [drivers]
        m = {{ type = "angle", joint = "j", value = "1.1*sin(2*t) + 0.5*t" }}
    """

    def right(t: Array) -> Values:
        q, w, e = (x[:, 0] for x in in_time(lambda s: [1.1 * sin(2 * s) + 0.5 * s], t))
        c, s = np.cos(q), np.sin(q)
        x = m * reach * (-e * s - w**2 * c)
        y = m * (G + reach * (e * c - w**2 * s))
        arm = root - reach
        return {"j.angle": q, "weld.force.x": x, "weld.force.y": y,
                "weld.torque.z": J * e - arm * (c * y - s * x)}  # fmt: skip

    return System(
        name="fixed_joint_of_a_driven_arm", kind="reactions", origin="closed form: Newton and Euler",
        scene=text, stop=2.0, right=right,
    )  # fmt: skip


def _rod() -> System:
    """Slider on a massless rod from an even crank: rod m x''/cos b, guide by the rod's slope."""
    r, c, m, w = 0.15, 0.5, 2.0, 12.0
    text = f"""
        dimension = 2
        [points]
        S = {{ position = [{r + c}, 0], mass = {m} }}
        [bodies]
        crank = {{ position = [0, 0], mass = 1, inertia = 0.02, points = {{ e = [{r}, 0] }} }}
        [joints]
        j = {{ type = "revolute", bodies = ["ground", "crank"], position = [0, 0] }}
        rod = {{ type = "distance", points = ["crank.e", "S"] }}
        guide = {{ type = "point_on_line", point = "S", axis = [1, 0] }}
        [drivers]
        m = {{ type = "angle", joint = "j", value = "{w}*t" }}
        [solver]
        assemble = true
    """

    def right(t: Array) -> Values:
        x, v, a = (
            z[:, 0]
            for z in in_time(lambda s: [r * cos(w * s) + sqrt(c * c - (r * sin(w * s)) ** 2)], t)
        )
        # From the slider to the crank pin: the rod in tension pulls along it.
        along, up = (r * np.cos(w * t) - x) / c, r * np.sin(w * t) / c
        pull = m * a / along
        return {"S.x": x, "S.vx": v, "rod.force": pull, "guide.force.y": -pull * up,
                "m.torque": m * a * v / w}  # fmt: skip

    return System(
        name="rod_of_a_slider_crank", kind="reactions", origin="closed form: Newton's law",
        scene=text, stop=1.0, right=right, internal_step=0.005,
    )  # fmt: skip


def _gear() -> System:
    """Two rotors with a gear: torque of the second one, J2 n T/(J1 + n^2 J2)."""
    J1, J2, n, T = 0.02, 0.11, -0.4, 1.5
    text = f"""
        dimension = 2
        [bodies]
        a = {{ position = [0, 0], mass = 1, inertia = {J1} }}
        b = {{ position = [1, 0], mass = 1, inertia = {J2} }}
        [joints]
        ja = {{ type = "revolute", bodies = ["ground", "a"], position = [0, 0] }}
        jb = {{ type = "revolute", bodies = ["ground", "b"], position = [1, 0] }}
        g = {{ type = "gear", joints = ["ja", "jb"], ratio = {n} }}
        [forces]
        m = {{ type = "joint_torque", joint = "ja", value = "{T}*cos(3*t)" }}
    """

    def right(t: Array) -> Values:
        e = T / (J1 + n * n * J2)
        return {"ja.angular_velocity": e * np.sin(3 * t) / 3, "jb.angle": n * e * (1 - np.cos(3 * t)) / 9,
                "g.torque": J2 * n * e * np.cos(3 * t)}  # fmt: skip

    return System(
        name="torque_of_a_gear", kind="reactions", origin="closed form: J2 n T/(J1 + n^2 J2)",
        scene=text, stop=2.0, right=right,
    )  # fmt: skip


def _wobbling_rotor() -> System:
    """Rotor in space whose axis is no principal one, turned evenly: torque w x J w."""
    w, J = 25.0, np.array([[0.3, 0.02, 0.05], [0.02, 0.4, -0.03], [0.05, -0.03, 0.5]])
    text = f"""
        [bodies]
        r = {{ position = [0, 0, 0], mass = 4, inertia = {J.tolist()} }}
        [joints]
        j = {{ type = "revolute", bodies = ["ground", "r"], position = [0, 0, 0], axis = [0, 0, 1] }}
        [drivers]
        m = {{ type = "angle", joint = "j", value = "{w}*t" }}
    """

    def right(t: Array) -> Values:
        c, s = np.cos(w * t), np.sin(w * t)
        x, y = -w * w * J[1, 2], w * w * J[0, 2]
        return {"j.angle": w * t, "j.torque.x": c * x - s * y, "j.torque.y": s * x + c * y}

    return System(
        name="hinge_of_a_wobbling_rotor", kind="reactions", origin="closed form: M = w x J w",
        scene=text, stop=1.0, right=right, internal_step=0.004,
    )  # fmt: skip


def _turntable() -> System:
    """Post fixed on a turntable that speeds up: force and torque of the fixed joint in space."""
    m, J = 2.5, np.diag([0.05, 0.06, 0.02])
    place, root = np.array([0.6, 0.2, 0.7]), np.array([0.5, 0.2, 0.1])
    text = f"""
        gravity = [0, 0, {-G}]
        [bodies]
        table = {{ position = [0, 0, 0], mass = 6, inertia = [1, 1, 2] }}
        post = {{ position = {place.tolist()}, mass = {m}, inertia = {np.diag(J).tolist()} }}
        [joints]
        j = {{ type = "revolute", bodies = ["ground", "table"], position = [0, 0, 0], axis = [0, 0, 1] }}
        foot = {{ type = "fixed", bodies = ["table", "post"], position = {root.tolist()} }}
        [drivers]
        m = {{ type = "angle", joint = "j", value = "0.9*t*t + 0.3*sin(4*t)" }}
    """

    def right(t: Array) -> Values:
        q, w, e = (x[:, 0] for x in in_time(lambda s: [0.9 * s * s + 0.3 * sin(4 * s)], t))
        found = []
        for angle, rate, second in zip(q, w, e, strict=True):
            turn, rise = np.array([0, 0, rate]), np.array([0, 0, second])
            a = np.cross(rise, place) + np.cross(turn, np.cross(turn, place))
            F = m * (a + np.array([0, 0, G]))
            M = J @ rise + np.cross(turn, J @ turn) - np.cross(root - place, F)
            c, s = math.cos(angle), math.sin(angle)
            R = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
            found.append([*(R @ F), *(R @ M)])
        table = np.array(found)
        names = [f"foot.{part}.{axis}" for part in ("force", "torque") for axis in "xyz"]
        return {"j.angle": q} | dict(zip(names, table.T, strict=True))

    return System(
        name="fixed_joint_on_a_turntable", kind="reactions", origin="closed form: Newton and Euler",
        scene=text, stop=1.5, right=right,
    )  # fmt: skip


def _slider() -> System:
    """Slider pushed above its mass centre: the guide's torque holds it level."""
    m, c, h = 1.8, (0.1, 0.25), (-0.2, 0.6)
    text = f"""
        dimension = 2
        gravity = [0, {-G}]
        [bodies]
        b = {{ position = [0, 0], mass = {m}, inertia = 0.07, center_of_mass = {list(c)}, points = {{ h = {list(h)} }} }}
        [joints]
        guide = {{ type = "prismatic", bodies = ["ground", "b"], axis = [1, 0] }}
        [forces]
        push = {{ type = "force", point = "b.h", value = ["4*cos(2*t)", "1.5*sin(t)"] }}
    """

    def right(t: Array) -> Values:
        x, y = 4 * np.cos(2 * t), 1.5 * np.sin(t)
        moment = c[0] * m * G - c[1] * x  # of what moves the mass centre: m (a - g)
        return {"guide.displacement": (1 - np.cos(2 * t)) / m, "guide.velocity": 2 * np.sin(2 * t) / m,
                "guide.force.y": m * G - y,
                "guide.torque.z": moment - (h[0] * y - h[1] * x)}  # fmt: skip

    return System(
        name="guide_of_a_slider", kind="reactions", origin="closed form: Newton and Euler",
        scene=text, stop=2.0, right=right,
    )  # fmt: skip


def _two_in_flight() -> System:
    """Two hinged bodies that spin about each other: force m1 m2/(m1 + m2) d w^2."""
    m1, m2, d, w = 2.0, 0.7, 0.9, 9.0
    one, two = -d * m2 / (m1 + m2), d * m1 / (m1 + m2)
    text = f"""
        dimension = 2
        [bodies]
        a = {{ position = [{one!r}, 0], velocity = [0.5, {one * w!r}], angular_velocity = {w}, mass = {m1}, inertia = 0.1 }}
        b = {{ position = [{two!r}, 0], velocity = [0.5, {two * w!r}], angular_velocity = {w}, mass = {m2}, inertia = 0.03 }}
        [joints]
        j = {{ type = "revolute", bodies = ["a", "b"], position = [0.1, 0] }}
    """

    def right(t: Array) -> Values:
        pull = m1 * m2 / (m1 + m2) * d * w * w
        spin = (0.1 + 0.03 + m1 * m2 / (m1 + m2) * d * d) * w
        return {"a.angle": w * t, "b.x": 0.5 * t + two * np.cos(w * t), "j.force.x": -pull * np.cos(w * t),
                "j.force.y": -pull * np.sin(w * t), "momentum.x": 0.5 * (m1 + m2) + 0 * t,
                "angular_momentum.z": spin + 0 * t}  # fmt: skip

    return System(
        name="hinge_of_two_bodies_in_flight", kind="reactions",
        origin="closed form: m1 m2/(m1 + m2) d w^2", scene=text, stop=1.0, right=right,
        internal_step=0.01, scale={"momentum": 1.0},
    )  # fmt: skip


def _conical() -> System:
    """Conical pendulum: pull m g/cos a at w^2 = g/(l cos a)."""
    m, r, a = 0.8, 1.1, 0.7
    w = math.sqrt(G / (r * math.cos(a)))
    x = r * math.sin(a)
    text = f"""
        gravity = [0, 0, {-G}]
        [points]
        A = {{ position = [{x!r}, 0, {-r * math.cos(a)!r}], velocity = [0, {x * w!r}, 0], mass = {m} }}
        [joints]
        rod = {{ type = "distance", points = ["ground", "A"], at = [0, 0, 0] }}
    """

    def right(t: Array) -> Values:
        return {"A.x": x * np.cos(w * t), "A.y": x * np.sin(w * t), "rod.force": m * G / math.cos(a) + 0 * t,
                "angular_momentum.z": m * x * x * w + 0 * t}  # fmt: skip

    return System(
        name="conical_pendulum", kind="reactions", origin="closed form: w^2 = g/(l cos a)",
        scene=text, stop=3.0, right=right,
    )  # fmt: skip


def _pushed_body() -> System:
    """Free body under a force that grows: momenta and work."""
    m, J, y0 = 3.0, 0.2, 0.4
    text = f"""
        dimension = 2
        [bodies]
        b = {{ position = [0, {y0}], velocity = [0, 0.5], angular_velocity = -2, mass = {m}, inertia = {J} }}
        [forces]
        f = {{ type = "force", point = "b", value = ["6*t", 0] }}
        g = {{ type = "torque", body = "b", value = "0.3*cos(5*t)" }}
    """

    def right(t: Array) -> Values:
        px, vy = 3 * t**2, 0.5
        x, y = t**3 / m, y0 + vy * t
        spin = -2 + 0.3 * np.sin(5 * t) / (5 * J)
        return {"b.x": x, "b.angular_velocity": spin, "momentum.x": px, "momentum.y": m * vy + 0 * t,
                "angular_momentum.z": J * spin + m * x * vy - y * px,
                "energy.kinetic": px**2 / (2 * m) + m * vy**2 / 2 + J * spin**2 / 2}  # fmt: skip

    return System(
        name="momenta_of_a_pushed_body", kind="reactions", origin="closed form: impulse of the loads",
        scene=text, stop=1.0, right=right, scale={"momentum": 3.0},
    )  # fmt: skip


SYSTEMS = (
    _pendulum(1.2, 4.0),
    _pendulum(2.9, 3.0),
    _bearing(),
    _cantilever(),
    _rod(),
    _gear(),
    _wobbling_rotor(),
    _turntable(),
    _slider(),
    _two_in_flight(),
    _conical(),
    _pushed_body(),
)
