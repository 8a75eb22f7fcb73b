"""Laws that jump: in time, in a place, in a rate; and drivers with kinks."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence

import numpy as np

from tests.truth.minimal import Body, Number, Parts, cos, motion, sin
from tests.truth.system import Array, System, Values

G = 9.81
ORIGIN = "closed form, piece by piece"


def _pushed(
    name: str, law: str, pieces: Callable[[float], Sequence[tuple[float, float, float, float]]],
    stop: float, points: int, scale: Mapping[str, float] | None = None,
) -> System:  # fmt: skip
    """Mass of 1 kg under a force that is c0 + c1 t on each piece (begin, end, c0, c1)."""
    text = f"""
        dimension = 2
        [points]
        A = {{ position = [0, 0], mass = 1.0 }}
        [forces]
        f = {{ type = "force", point = "A", value = ["{law}", 0] }}
    """

    def right(t: Array) -> Values:
        x, v = np.zeros_like(t), np.zeros_like(t)
        for begin, end, c0, c1 in pieces(stop):
            # The piece's impulse, and the way that it makes until t.
            last = np.minimum(t, end)
            u = np.maximum(last - begin, 0.0)
            force = c0 + c1 * begin
            impulse = force * u + c1 * u**2 / 2
            moment = force * u**2 / 2 + c1 * u**3 / 3  # of the impulse about `begin`
            v += impulse
            x += np.where(u > 0, impulse * (t - begin) - moment, 0.0)
        return {"A.x": x, "A.vx": v}

    return System(
        name=name, kind="jumps", origin=ORIGIN, scene=text, stop=stop, points=points, right=right,
        orders=(), scale=scale or {},
    )  # fmt: skip


def _floor(stop: float) -> list[tuple[float, float, float, float]]:
    return [(k / 3.7, (k + 1) / 3.7, float(k), 0.0) for k in range(math.ceil(3.7 * stop))]


def _sign_of_sine(stop: float) -> list[tuple[float, float, float, float]]:
    half = math.pi / 7
    return [(k * half, (k + 1) * half, (-1.0) ** k, 0.0) for k in range(math.ceil(stop / half))]


def _saw(stop: float) -> list[tuple[float, float, float, float]]:
    return [(0.3 * k, 0.3 * (k + 1), -0.3 * k, 1.0) for k in range(math.ceil(stop / 0.3))]


def _kinked_driver() -> System:
    """Mass on a spring whose other end begins to move with a jump of its acceleration."""
    m, k, begin = 0.7, 90.0, 0.4173
    text = f"""
        dimension = 2
        [points]
        P = {{ position = [0, 0], mass = 1.0 }}
        A = {{ position = [1, 0], mass = {m} }}
        [drivers]
        hand = {{ type = "position", point = "P", value = ["3*max(t - {begin}, 0)**2", 0] }}
        [forces]
        s = {{ type = "spring", points = ["P", "A"], stiffness = {k} }}
    """

    def right(t: Array) -> Values:
        w = math.sqrt(k / m)
        u = np.maximum(t - begin, 0.0)
        return {"P.vx": 6 * u, "A.x": 1 + 3 * u**2 - 6 / w**2 * (1 - np.cos(w * u)),
                "A.vx": 6 * u - 6 / w * np.sin(w * u)}  # fmt: skip

    return System(
        name="driver_with_a_kink", kind="jumps", origin=ORIGIN, scene=text, stop=1.0, right=right,
        orders=(),
    )  # fmt: skip


def _brake(name: str, speed: float, stop: float) -> System:
    """Rotor braked by -T sign(w): it stops at J w/T and stays."""
    J, T = 1.3, 3.0
    text = f"""
        dimension = 2
        [bodies]
        b = {{ position = [0, 0], mass = 1, inertia = {J}, angular_velocity = {speed} }}
        [joints]
        j = {{ type = "revolute", bodies = ["ground", "b"], position = [0, 0] }}
        [forces]
        f = {{ type = "joint_torque", joint = "j", value = "-{T}*sign(b.angular_velocity)" }}
    """

    def right(t: Array) -> Values:
        u = np.minimum(t, J * abs(speed) / T)
        sign = math.copysign(1, speed)
        return {"b.angle": speed * u - sign * T / J * u**2 / 2,
                "b.angular_velocity": speed - sign * T / J * u}  # fmt: skip

    return System(
        name=name, kind="jumps", origin="closed form: it stops at J w/T", scene=text, stop=stop,
        right=right, orders=(),
    )  # fmt: skip


def _rubbing_oscillator(name: str, start: float, stop: float) -> System:
    """Mass on a spring with friction -F sign(v): cosines about +-F/k (Den Hartog 1930)."""
    m, k, F = 1.0, 40.0, 4.0
    text = f"""
        dimension = 2
        [points]
        A = {{ position = [{1 + start}, 0], mass = {m} }}
        [forces]
        s = {{ type = "spring", points = ["ground", "A"], at = [0, 0], stiffness = {k}, free_length = 1 }}
        f = {{ type = "force", point = "A", value = ["-{F}*sign(A.vx)", 0] }}
    """

    def right(t: Array) -> Values:
        w, shift = math.sqrt(k / m), F / k
        half = math.pi / w
        x, v = np.full_like(t, start), np.zeros_like(t)
        at, n = start, 0
        while abs(at) > shift:
            side = math.copysign(shift, at)
            u = t - n * half
            here = u >= 0
            x = np.where(here, side + (at - side) * np.cos(w * u), x)
            v = np.where(here, -(at - side) * w * np.sin(w * u), v)
            at, n = 2 * side - at, n + 1
        x, v = np.where(t >= n * half, at, x), np.where(t >= n * half, 0.0, v)
        return {"A.x": 1 + x, "A.vx": v}

    return System(
        name=name, kind="jumps", origin="closed form: half waves (Den Hartog 1930)", scene=text,
        stop=stop, right=right, orders=(),
    )  # fmt: skip


def _between_forces() -> System:
    """Mass that a force of one size pushes back to x = 0: parabolas of one period."""
    F, speed = 5.0, 1.4
    text = f"""
        dimension = 2
        [points]
        A = {{ position = [0, 0], velocity = [{speed}, 0], mass = 1.0 }}
        [forces]
        f = {{ type = "force", point = "A", value = ["-{F} if A.x > 0 else {F}", 0] }}
    """

    def right(t: Array) -> Values:
        half = 2 * speed / F
        n = np.floor(t / half)
        u, sign = t - n * half, (-1.0) ** n
        return {"A.x": sign * (speed * u - F * u**2 / 2), "A.vx": sign * (speed - F * u)}

    return System(
        name="force_that_jumps_at_a_place", kind="jumps", origin=ORIGIN, scene=text, stop=2.0,
        right=right, orders=(),
    )  # fmt: skip


def _speed_switch() -> System:
    """Wagon whose motor is off above a speed and on below: v' = a, then v' = a - b."""
    limit, a, b = 1.137, 2.0, 3.5
    text = f"""
        dimension = 2
        [points]
        A = {{ position = [0, 0], mass = 1.0 }}
        [forces]
        f = {{ type = "force", point = "A", value = ["{a} if A.vx < {limit} else {a - 1.2}", 0] }}
        g = {{ type = "force", point = "A", value = [0, "0 if A.vx < {limit} else -{b}"] }}
    """

    def right(t: Array) -> Values:
        at = limit / a
        u = np.maximum(t - at, 0.0)
        before = np.minimum(t, at)
        return {"A.x": a * before**2 / 2 + limit * u + (a - 1.2) * u**2 / 2,
                "A.vx": a * before + (a - 1.2) * u, "A.y": -b * u**2 / 2, "A.vy": -b * u}  # fmt: skip

    return System(
        name="law_that_switches_at_a_rate", kind="jumps", origin=ORIGIN, scene=text, stop=1.0,
        right=right, orders=(),
    )  # fmt: skip


def _free_angle() -> System:
    """Rotor on a spring whose free angle jumps: w^2 = k/J about the new angle."""
    J, k, jump, at = 0.3, 25.0, 0.5, 0.4173
    text = f"""
        dimension = 2
        [bodies]
        b = {{ position = [0, 0], mass = 1, inertia = {J} }}
        [joints]
        j = {{ type = "revolute", bodies = ["ground", "b"], position = [0, 0] }}
        [forces]
        s = {{ type = "torsion_spring", joint = "j", stiffness = {k}, free_angle = "{jump} if t > {at} else 0" }}
    """

    def right(t: Array) -> Values:
        w, u = math.sqrt(k / J), np.maximum(t - at, 0.0)
        return {
            "j.angle": jump * (1 - np.cos(w * u)),
            "j.angular_velocity": jump * w * np.sin(w * u),
        }

    return System(
        name="free_angle_that_jumps", kind="jumps", origin=ORIGIN, scene=text, stop=1.0, right=right,
        orders=(),
    )  # fmt: skip


def _struck_pendulum() -> System:
    """Double pendulum whose first hinge has a torque that changes its sign."""
    at = 0.4173
    (l1, m1, J1), (l2, m2, J2) = (0.7, 1.2, 0.05), (0.5, 0.8, 0.02)
    start = (-1.2, -0.6)
    ends = [(l1 * math.cos(start[0]), l1 * math.sin(start[0]))]
    middle = (ends[0][0] + l2 / 2 * math.cos(start[1]), ends[0][1] + l2 / 2 * math.sin(start[1]))
    text = f"""
        dimension = 2
        gravity = [0, {-G}]
        [bodies]
        a = {{ position = [{ends[0][0] / 2!r}, {ends[0][1] / 2!r}], orientation = {start[0]}, mass = {m1}, inertia = {J1}, points = {{ e = [{l1 / 2}, 0] }} }}
        b = {{ position = [{middle[0]!r}, {middle[1]!r}], orientation = {start[1]}, mass = {m2}, inertia = {J2}, points = {{ a = [{-l2 / 2}, 0] }} }}
        [joints]
        j = {{ type = "revolute", bodies = ["ground", "a"], position = [0, 0] }}
        k = {{ type = "revolute", points = ["a.e", "b.a"] }}
        [forces]
        m = {{ type = "joint_torque", joint = "j", value = "3 if t < {at} else -3" }}
    """

    def mechanism(t: float, q: Sequence[Number]) -> Parts:
        x, y = l1 * cos(q[0]), l1 * sin(q[0])
        bx, by = x + l2 / 2 * cos(q[1]), y + l2 / 2 * sin(q[1])
        energy = m1 * G * y * 0.5 + m2 * G * by
        return Parts([Body(m1, (x * 0.5, y * 0.5), J1, q[0]), Body(m2, (bx, by), J2, q[1])],
                     energy, torques=[3.0 if t < at else -3.0, 0.0])  # fmt: skip

    def right(t: Array) -> Values:
        q, v = motion(mechanism, start, [0.0, 0.0], t, jumps=[at])
        return {"a.angle": q[:, 0], "b.angle": q[:, 1], "a.angular_velocity": v[:, 0],
                "b.angular_velocity": v[:, 1]}  # fmt: skip

    return System(
        name="double_pendulum_with_a_torque_that_jumps", kind="jumps",
        origin="DOP853 in the angles, anew at the jump", scene=text, stop=1.5, right=right, orders=(),
    )  # fmt: skip


SYSTEMS = (
    _pushed("force_that_turns_round", "1 if t < 0.6137 else -1",
            lambda stop: [(0.0, 0.6137, 1.0, 0.0), (0.6137, stop, -1.0, 0.0)], 1.0, 10),
    _pushed("force_in_stairs", "floor(3.7*t)", _floor, 1.0, 1),
    _pushed("force_by_the_sign_of_a_sine", "sign(sin(7*t))", _sign_of_sine, 2.0, 4),
    _pushed("force_of_a_saw", "mod(t, 0.3)", _saw, 1.0, 1),
    _pushed("short_pulse", "200 if t > 0.5031 and t < 0.5055 else 0",
            lambda _: [(0.5031, 0.5055, 200.0, 0.0)], 1.0, 2),
    _pushed("force_with_a_kink", "min(t, 0.4173)",
            lambda stop: [(0.0, 0.4173, 0.0, 1.0), (0.4173, stop, 0.4173, 0.0)], 1.0, 1),
    _kinked_driver(),
    _free_angle(),
    _struck_pendulum(),
    _brake("brake_by_a_sign", 2.0, 1.5),
    _brake("brake_by_a_sign_until_it_turns_slowly", -2.0, 0.8),
    _rubbing_oscillator("oscillator_with_dry_friction", 1.03, 1.4),
    _rubbing_oscillator("oscillator_that_dry_friction_stops", 0.45, 2.5),
    _between_forces(),
    _speed_switch(),
)  # fmt: skip
