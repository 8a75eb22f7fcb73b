"""Coulomb's friction of contacts and joints: it slides, stops, sticks and slips."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from tests.truth.minimal import Body, Number, Parts, cos, motion, sin
from tests.truth.system import Array, System, Values

G = 9.81


def _block(
    name: str, origin: str, *, tilt: float = 0.0, speed: float = 0.0, friction: float = 0.3,
    belt: float = 0.0, stop: float = 1.0, points: int = 9,
) -> System:  # fmt: skip
    """Block on a slope or a belt; each phase has an even acceleration."""
    m = 1.6
    moving = f", surface_velocity = [{belt}, 0]" if belt else ""
    text = f"""
        dimension = 2
        gravity = [{G * math.sin(tilt)!r}, {-G * math.cos(tilt)!r}]
        [points]
        A = {{ position = [0, 0], velocity = [{speed}, 0], mass = {m} }}
        [contacts]
        c = {{ type = "plane", point = "A", axis = [0, 1], friction = {friction}{moving} }}
    """
    drive, limit = G * math.sin(tilt), friction * G * math.cos(tilt)

    def right(t: Array) -> Values:
        x, v, f = np.zeros_like(t), np.full_like(t, speed), np.zeros_like(t)
        begin, place, rate = 0.0, 0.0, speed
        while True:
            slip = rate - belt
            side = math.copysign(1.0, slip) if slip else (1.0 if drive > limit else 0.0)
            a = drive - side * limit if side else 0.0
            end = begin - slip / a if a and slip and slip * a < 0 else math.inf
            here = t >= begin
            u = t - begin
            x = np.where(here, place + rate * u + a * u**2 / 2, x)
            v = np.where(here, rate + a * u, v)
            f = np.where(here, m * (a - drive), f)
            if math.isinf(end):
                break
            place, rate = place + rate * (end - begin) + a * (end - begin) ** 2 / 2, belt
            begin = end
        return {"A.x": x, "A.vx": v, "c.force": m * G * math.cos(tilt) + 0 * t, "c.friction": f}

    return System(
        name=name, kind="friction", origin=origin, scene=text, stop=stop, points=points, right=right,
        orders=(), scale={"speed": 1.0, "length": 1.0},
    )  # fmt: skip


def _shaft(name: str, friction: str, torque: float, speed: float, stop: float) -> System:
    """Rotor that friction of its bearing stops: w = w0 - T/J t."""
    J, m = 0.4, 5.0
    text = f"""
        dimension = 2
        gravity = [0, {-G}]
        [bodies]
        r = {{ position = [0, 0], mass = {m}, inertia = {J}, angular_velocity = {speed} }}
        [joints]
        j = {{ type = "revolute", bodies = ["ground", "r"], position = [0, 0], friction = {{ {friction} }} }}
    """

    def right(t: Array) -> Values:
        u = np.minimum(t, J * speed / torque)
        return {"j.angle": speed * u - torque / J * u**2 / 2, "j.angular_velocity": speed - torque / J * u,
                "energy.dissipated": J * (speed**2 - (speed - torque / J * u) ** 2) / 2}  # fmt: skip

    return System(
        name=name, kind="friction", origin="closed form: w = w0 - T/J t until it stops",
        scene=text, stop=stop, points=9, right=right, orders=(),
    )  # fmt: skip


def _spatial_guide() -> System:
    """Slider down a guide in space: a = g (sin b - mu cos b)."""
    b, mu, m = 0.7, 0.25, 2.0
    text = f"""
        gravity = [0, 0, {-G}]
        [bodies]
        s = {{ position = [0, 0, 0], mass = {m}, inertia = [0.1, 0.1, 0.1] }}
        [joints]
        g = {{ type = "prismatic", bodies = ["ground", "s"], axis = [{math.cos(b)!r}, 0, {-math.sin(b)!r}], friction = {{ coefficient = {mu} }} }}
    """

    def right(t: Array) -> Values:
        a = G * (math.sin(b) - mu * math.cos(b))
        return {"g.displacement": a * t**2 / 2, "g.velocity": a * t}

    return System(
        name="slider_down_a_rough_guide", kind="friction",
        origin="closed form: a = g (sin b - mu cos b)", scene=text, stop=1.0, right=right, orders=(),
    )  # fmt: skip


def _stick_slip() -> System:
    """Block that a spring pulls from rest: it slips at k v t = mu_s m g, then an oscillation."""
    m, k, v, mu, static = 1.2, 50.0, 0.4, 0.3, 0.5
    begin = static * m * G / (k * v)
    text = f"""
        dimension = 2
        gravity = [0, {-G}]
        [points]
        P = {{ position = [1, 0], mass = 1.0 }}
        A = {{ position = [0, 0], mass = {m} }}
        [drivers]
        hand = {{ type = "position", point = "P", value = ["1 + {v}*t", 0] }}
        [forces]
        s = {{ type = "spring", points = ["P", "A"], stiffness = {k} }}
        [contacts]
        c = {{ type = "plane", point = "A", axis = [0, 1], friction = {mu}, static_friction = {static} }}
    """
    w = math.sqrt(k / m)
    ahead = (static - mu) * m * G / k
    # The block moves at v (1 - cos) + ahead w sin, and rests again where that ends.
    end = begin + (2 * math.pi - 2 * math.atan(ahead * w / v)) / w
    assert begin + 0.5 < end

    def right(t: Array) -> Values:
        u = np.maximum(t - begin, 0.0)
        stretch = np.where(t < begin, v * t,
                           mu * m * G / k + ahead * np.cos(w * u) + v / w * np.sin(w * u))  # fmt: skip
        speed = np.where(t < begin, 0.0, v + ahead * w * np.sin(w * u) - v * np.cos(w * u))
        return {"A.x": v * t - stretch, "A.vx": speed, "s.force": k * stretch,
                "c.friction": -np.where(t < begin, k * v * t, mu * m * G)}  # fmt: skip

    return System(
        name="block_that_a_spring_pulls_loose", kind="friction",
        origin="closed form: it slips at k v t = mu_s m g", scene=text, stop=begin + 0.5, points=9,
        right=right, orders=(),
    )  # fmt: skip


def _oblique() -> System:
    """Puck that slides in space: it stops along its first direction."""
    mu, m = 0.25, 0.4
    velocity = np.array([1.1, -0.7])
    speed = float(np.hypot(*velocity))
    text = f"""
        gravity = [0, 0, {-G}]
        [points]
        A = {{ position = [0, 0, 0], velocity = [1.1, -0.7, 0], mass = {m} }}
        [contacts]
        c = {{ type = "plane", point = "A", axis = [0, 0, 1], friction = {mu} }}
    """

    def right(t: Array) -> Values:
        u = np.minimum(t, speed / (mu * G))
        way, rate = speed * u - mu * G * u**2 / 2, speed - mu * G * u
        x, y = velocity / speed
        return {"A.x": x * way, "A.y": y * way, "A.vx": x * rate, "A.vy": y * rate,
                "c.slip": rate}  # fmt: skip

    return System(
        name="puck_in_space", kind="friction", origin="closed form: it stops after v/(mu g)",
        scene=text, stop=0.7, points=9, right=right, orders=(),
    )  # fmt: skip


def _pressed() -> System:
    """Block pressed down by a force that varies: v = v0 - mu times the integral of N/m."""
    mu, m, speed = 0.2, 1.5, 6.0
    text = f"""
        dimension = 2
        gravity = [0, {-G}]
        [points]
        A = {{ position = [0, 0], velocity = [{speed}, 0], mass = {m} }}
        [forces]
        f = {{ type = "force", point = "A", value = [0, "-(10 + 6*sin(3*t))"] }}
        [contacts]
        c = {{ type = "plane", point = "A", axis = [0, 1], friction = {mu} }}
    """

    def right(t: Array) -> Values:
        push = 10 * t + 2 * (1 - np.cos(3 * t))
        way = 5 * t**2 + 2 * t - 2 * np.sin(3 * t) / 3
        return {"A.x": speed * t - mu * (G * t**2 / 2 + way / m), "A.vx": speed - mu * (G * t + push / m),
                "c.force": m * G + 10 + 6 * np.sin(3 * t)}  # fmt: skip

    return System(
        name="block_pressed_down", kind="friction", origin="closed form: impulse of the friction",
        scene=text, stop=1.5, right=right, orders=(),
    )  # fmt: skip


def _hoop() -> System:
    """Bead that slides inside a rough hoop: r a'' = -g sin a - mu s (g cos a + r a'^2)."""
    r, mu, start = 0.8, 0.2, 1.3
    text = f"""
        dimension = 2
        gravity = [0, {-G}]
        [points]
        A = {{ position = [{r * math.sin(start)!r}, {-r * math.cos(start)!r}], mass = 0.5 }}
        [contacts]
        c = {{ type = "surface", point = "A", surface = "{r} - sqrt(x**2 + y**2)", friction = {mu} }}
    """

    def mechanism(_: float, q: Sequence[Number]) -> Parts:
        a, w = q[0].value, q[0].rate
        load = -G * math.sin(a) + mu * (G * math.cos(a) + r * w * w)  # it slides back: a' < 0
        return Parts([Body(1.0, (r * sin(q[0]), -r * cos(q[0])), 0.0, q[0])], torques=[r * load])

    def right(t: Array) -> Values:
        q, v = motion(mechanism, [start], [0.0], t)
        assert np.all(v[1:] < 0)
        a, w = q[:, 0], v[:, 0]
        return {"A.x": r * np.sin(a), "A.y": -r * np.cos(a), "A.vx": r * w * np.cos(a),
                "c.force": 0.5 * (G * np.cos(a) + r * w**2)}  # fmt: skip

    return System(
        name="bead_in_a_rough_hoop", kind="friction", origin="DOP853 in the angle while it slides",
        scene=text, stop=0.9, right=right, orders=(),
    )  # fmt: skip


def _billiard(name: str, velocity: Sequence[float], spin: Sequence[float], stop: float) -> System:
    """Ball that slides until it rolls: slip u falls at 7/2 mu g (Coriolis 1835)."""
    m, R, mu = 0.17, 0.0285, 0.2
    J = 0.4 * m * R * R
    v0, w0 = np.array([*velocity, 0.0]), np.array(spin)
    text = f"""
        gravity = [0, 0, {-G}]
        [bodies]
        b = {{ position = [0, 0, {R}], velocity = {v0.tolist()}, angular_velocity = {w0.tolist()}, mass = {m}, inertia = [{J!r}, {J!r}, {J!r}] }}
        [contacts]
        c = {{ type = "plane", point = "b", axis = [0, 0, 1], radius = {R}, friction = {mu} }}
    """
    down = np.array([0.0, 0.0, -R])
    slip = v0 + np.cross(w0, down)
    size = float(np.linalg.norm(slip))
    pull = -mu * G * slip / size

    def right(t: Array) -> Values:
        u = np.minimum(t, 2 * size / (7 * mu * G))[:, None]
        v = v0 + pull * u
        w = w0 + m / J * np.cross(down, pull) * u
        x = v0 * u + pull * u**2 / 2 + v * (t[:, None] - u)
        return {"b.x": x[:, 0], "b.y": x[:, 1], "b.vx": v[:, 0], "b.vy": v[:, 1], "b.wx": w[:, 0],
                "b.wy": w[:, 1], "b.wz": w[:, 2]}  # fmt: skip

    return System(
        name=name, kind="friction", origin="closed form: it rolls after 2 u/(7 mu g) (Coriolis 1835)",
        scene=text, stop=stop, points=9, right=right, orders=(),
    )  # fmt: skip


def _feet() -> System:
    """Block on two feet that a force pushes less than it sticks: rest, and loads by moments."""
    m, push, half, height = 3.0, 12.0, 0.2, 0.15
    text = f"""
        dimension = 2
        gravity = [0, {-G}]
        [bodies]
        b = {{ position = [0, {height}], mass = {m}, inertia = 0.05, points = {{ l = [{-half}, {-height}], r = [{half}, {-height}] }} }}
        [forces]
        f = {{ type = "force", point = "b", value = [{push}, 0] }}
        [contacts]
        l = {{ type = "plane", point = "b.l", axis = [0, 1], friction = 0.5 }}
        r = {{ type = "plane", point = "b.r", axis = [0, 1], friction = 0.5 }}
    """

    def right(t: Array) -> Values:
        shift = push * height / (2 * half)
        return {"b.x": 0 * t, "b.y": height + 0 * t, "b.angle": 0 * t, "b.vx": 0 * t,
                "l.force": m * G / 2 - shift + 0 * t, "r.force": m * G / 2 + shift + 0 * t,
                "l.mode": 1 + 0 * t, "r.mode": 1 + 0 * t}  # fmt: skip

    return System(
        name="block_on_two_feet_that_sticks", kind="friction", origin="closed form: moments",
        scene=text, stop=1.0, right=right, orders=(), scale={"speed": 1.0},
    )  # fmt: skip


SYSTEMS = (
    _block("block_slides_down", "closed form: a = g (sin b - mu cos b)", tilt=0.5, friction=0.2),
    _block("block_sticks_on_a_slope", "closed form: tan b < mu", tilt=0.25),
    _block("block_slides_up_and_back", "closed form: two even accelerations", tilt=0.5,
           speed=-3.0, friction=0.2),
    _block("block_slides_up_and_sticks", "closed form: it stops and stays", tilt=0.25, speed=-2.0),
    _block("block_stops", "closed form: it stops after v/(mu g)", speed=1.7),
    _block("block_on_a_belt", "closed form: it slides until it has the belt's speed", belt=1.3),
    _block("block_on_a_belt_that_comes_against", "closed form: it turns round", belt=-0.8,
           speed=1.1),
    _shaft("bearing_with_preload", "preload = 0.9, radius = 0.01", 0.9, 3.0, 2.0),
    _shaft("bearing_that_weight_brakes", "coefficient = 0.1, radius = 0.06", 0.1 * 0.06 * 5.0 * G,
           2.0, 3.0),
    _spatial_guide(),
    _stick_slip(),
    _oblique(),
    _pressed(),
    _hoop(),
    _billiard("billiard_ball_without_spin", (0.9, 0.0), (0.0, 0.0, 0.0), 0.3),
    _billiard("billiard_ball_with_spin_aside", (0.7, 0.2), (25.0, -12.0, 8.0), 0.4),
    _feet(),
)  # fmt: skip
