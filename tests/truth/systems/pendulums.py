"""Pendulums and open chains of unequal data under gravity."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from scipy.special import ellipj, ellipk

from tests.truth.minimal import (
    Body,
    Number,
    Parts,
    about,
    after,
    cos,
    dot,
    motion,
    sin,
    turned,
    values,
)
from tests.truth.system import Array, System, Values
from tests.truth.tables import hinge

G = 9.81


def _chain(
    name: str, lengths: Sequence[float], masses: Sequence[float], inertias: Sequence[float],
    angles: Sequence[float], stop: float,
) -> System:  # fmt: skip
    """Bars hinged end to end, mass centres in their middles; angles [rad] are from +x."""
    ends = np.cumsum([[0.0, 0.0]] + [
        [a * np.cos(b), a * np.sin(b)] for a, b in zip(lengths, angles, strict=True)
    ], axis=0)  # fmt: skip
    lines = ["dimension = 2", f"gravity = [0, {-G}]", "[bodies]"]
    for i, (a, m, J, b) in enumerate(zip(lengths, masses, inertias, angles, strict=True)):
        x, y = ((ends[i] + ends[i + 1]) / 2).tolist()
        lines.append(
            f"b{i} = {{ position = [{x!r}, {y!r}], orientation = {b!r}, mass = {m}, inertia = {J}, "
            f"points = {{ a = [{-a / 2}, 0], e = [{a / 2}, 0] }} }}"
        )
    lines.append("[joints]")
    lines.append('j0 = { type = "revolute", points = ["ground", "b0.a"], at = [0, 0] }')
    lines += [
        f'j{i} = {{ type = "revolute", points = ["b{i - 1}.e", "b{i}.a"] }}'
        for i in range(1, len(lengths))
    ]

    def mechanism(_: float, q: Sequence[Number]) -> Parts:
        bodies, energy = [], 0.0
        x, y = 0.0, 0.0
        for a, m, J, b in zip(lengths, masses, inertias, q, strict=True):
            half = (a / 2 * cos(b), a / 2 * sin(b))
            bodies.append(Body(m, (x + half[0], y + half[1]), J, b))
            energy = energy + m * G * (y + half[1])
            x, y = x + 2 * half[0], y + 2 * half[1]
        return Parts(bodies, energy)

    def right(t: Array) -> Values:
        q, v = motion(mechanism, angles, [0.0] * len(angles), t)
        found = {f"b{i}.angle": q[:, i] for i in range(len(angles))}
        return found | {f"b{i}.angular_velocity": v[:, i] for i in range(len(angles))}

    return System(
        name=name, kind="pendulums", origin="DOP853 in the angles", scene="\n".join(lines),
        stop=stop, right=right,
    )  # fmt: skip


def _points(
    name: str, lengths: Sequence[float], masses: Sequence[float], angles: Sequence[float],
    rates: Sequence[float], stop: float, **more: object,
) -> System:  # fmt: skip
    """Point masses on massless rods, one below the other; angles [rad] are from -y."""
    x = y = vx = vy = 0.0
    points: dict[str, object] = {"O": {"position": [0, 0], "fixed": True}}
    joints: dict[str, object] = {}
    above = "O"
    for i, (a, m, b, w) in enumerate(zip(lengths, masses, angles, rates, strict=True)):
        x, y = x + a * math.sin(b), y - a * math.cos(b)
        vx, vy = vx + a * w * math.cos(b), vy + a * w * math.sin(b)
        points[f"P{i}"] = {"position": [x, y], "velocity": [vx, vy], "mass": m}
        joints[f"rod{i}"] = {"type": "distance", "points": [above, f"P{i}"]}
        above = f"P{i}"
    scene = {
        "dimension": 2,
        "gravity": [0, -G],
        "points": points,
        "joints": joints,
    }

    def places(q: Sequence[Number]) -> list[tuple[Number, Number]]:
        found, x, y = [], 0.0, 0.0
        for a, b in zip(lengths, q, strict=True):
            x, y = x + a * sin(b), y - a * cos(b)
            found.append((x, y))
        return found

    def mechanism(_: float, q: Sequence[Number]) -> Parts:
        bodies = [Body(m, p) for m, p in zip(masses, places(q), strict=True)]
        return Parts(bodies, sum(m * G * p[1] for m, p in zip(masses, places(q), strict=True)))

    def right(t: Array) -> Values:
        q, v = motion(mechanism, angles, rates, t)
        place, speed = values(lambda n: [x for p in places(n) for x in p], q, v)
        names = [f"P{i}." for i in range(len(lengths))]
        found = {
            n + c: place[:, 2 * i + k] for i, n in enumerate(names) for k, c in enumerate("xy")
        }
        return found | {
            n + c: speed[:, 2 * i + k]
            for i, n in enumerate(names)
            for k, c in enumerate(("vx", "vy"))
        }

    return System(
        name=name, kind="pendulums", origin="DOP853 in the angles",
        scene=scene, stop=stop, right=right, **more,
    )  # fmt: skip


def _large_swing() -> System:
    """Point pendulum of any amplitude: sin(angle/2) = k sn(K + w t), by Jacobi's functions."""
    length, top = 0.7, 2.4
    scene = {
        "dimension": 2,
        "gravity": [0, -G],
        "points": {
            "O": {"position": [0, 0], "fixed": True},
            "A": {"position": [length * math.sin(top), -length * math.cos(top)], "mass": 2},
        },
        "joints": {"rod": {"type": "distance", "points": ["O", "A"]}},
    }

    def right(t: Array) -> Values:
        k = math.sin(top / 2)
        w = math.sqrt(G / length)
        sn, cn, dn, _ = ellipj(w * t + ellipk(k * k), k * k)
        angle, rate = 2 * np.arcsin(k * sn), 2 * k * w * cn
        x, y = np.sin(angle), -np.cos(angle)
        assert np.allclose(np.cos(angle / 2), dn)
        return {
            "A.x": length * x,
            "A.y": length * y,
            "A.vx": -length * y * rate,
            "A.vy": length * x * rate,
        }

    return System(
        name="pendulum_swings_to_137_degrees", kind="pendulums",
        origin="closed form: Jacobi's elliptic functions",
        scene=scene, stop=6.0, right=right,
    )  # fmt: skip


def _spherical() -> System:
    """Point on a rod in space, started across: angles from the vertical and round it."""
    length, tilt, around = 1.3, 1.1, 1.9
    scene = {
        "gravity": [0, 0, -G],
        "points": {
            "O": {"position": [0, 0, 0], "fixed": True},
            "A": {
                "position": [length * math.sin(tilt), 0, -length * math.cos(tilt)],
                "velocity": [0, length * math.sin(tilt) * around, 0],
                "mass": 0.4,
            },
        },
        "joints": {"rod": {"type": "distance", "points": ["O", "A"]}},
    }

    def place(q: Sequence[Number]) -> list[Number]:
        r = length * sin(q[0])
        return [r * cos(q[1]), r * sin(q[1]), -length * cos(q[0])]

    def right(t: Array) -> Values:
        def mechanism(_: float, q: Sequence[Number]) -> Parts:
            return Parts([Body(0.4, place(q))], 0.4 * G * place(q)[2])

        q, v = motion(mechanism, [tilt, 0.0], [0.0, around], t)
        x, speed = values(place, q, v)
        return {f"A.{c}": x[:, k] for k, c in enumerate("xyz")} | {
            f"A.v{c}": speed[:, k] for k, c in enumerate("xyz")
        }

    return System(
        name="spherical_pendulum", kind="pendulums", origin="DOP853 in two angles",
        scene=scene, stop=4.0, right=right,
    )  # fmt: skip


def _on_cart() -> System:
    """Bar hinged to a cart that slides on a rail inclined by 0.3 rad."""
    slope, cart, bar, J, half = 0.3, 4.0, 1.5, 0.09, 0.45
    along = (math.cos(slope), math.sin(slope))
    scene = {
        "dimension": 2,
        "gravity": [0, -G],
        "bodies": {
            "cart": {"position": [0, 0], "mass": cart, "inertia": 0.2},
            "bar": {
                "position": [half, 0],
                "mass": bar,
                "inertia": J,
                "points": {"end": [half, 0]},
            },
        },
        "joints": {
            "rail": {"type": "prismatic", "bodies": ["ground", "cart"], "axis": list(along)},
            "pin": hinge("cart", "bar", [0, 0]),
        },
    }

    def mechanism(_: float, q: Sequence[Number]) -> Parts:
        x, y = along[0] * q[0], along[1] * q[0]
        centre = (x + half * cos(q[1]), y + half * sin(q[1]))
        energy = G * (cart * y + bar * centre[1])
        return Parts([Body(cart, (x, y)), Body(bar, centre, J, q[1])], energy)

    def right(t: Array) -> Values:
        q, v = motion(mechanism, [0.0, 0.0], [0.0, 0.0], t)
        return {
            "rail.displacement": q[:, 0],
            "rail.velocity": v[:, 0],
            "bar.angle": q[:, 1],
            "bar.angular_velocity": v[:, 1],
        }

    return System(
        name="pendulum_on_a_cart_on_a_slope", kind="pendulums",
        origin="DOP853 in displacement and angle",
        scene=scene, stop=2.0, right=right,
    )  # fmt: skip


def _furuta() -> System:
    """Arm that turns about the vertical with a pendulum about it: two hinges at right angles."""
    arm, J_arm, mass, J, low = 0.4, (0.01, 0.055, 0.06), 0.7, (0.03, 0.031, 0.002), 0.3
    scene = {
        "gravity": [0, 0, -G],
        "bodies": {
            "arm": {
                "position": [arm / 2, 0, 0],
                "mass": 1.2,
                "inertia": list(J_arm),
                "angular_velocity": [0, 0, 4.0],
                "velocity": [0, 2.0 * arm, 0],
            },
            "bob": {
                "position": [arm, 0, -low],
                "mass": mass,
                "inertia": list(J),
                "angular_velocity": [1.0, 0, 4.0],
                "velocity": [0, 4.0 * arm + low, 0],
            },
        },
        "joints": {
            "a": hinge("ground", "arm", [0, 0, 0], [0, 0, 1]),
            "b": hinge("arm", "bob", [arm, 0, 0], [1, 0, 0]),
        },
    }

    def mechanism(_: float, q: Sequence[Number]) -> Parts:
        first = about(2, q[0])
        second = after(first, about(0, q[1]))
        hinge, hang = turned(first, [arm, 0, 0]), turned(second, [0, 0, -low])
        bob = [x + y for x, y in zip(hinge, hang, strict=True)]
        bodies = [
            Body(1.2, turned(first, [arm / 2, 0, 0]), J_arm, rotation=first),
            Body(mass, bob, J, rotation=second),
        ]
        return Parts(bodies, mass * G * bob[2])

    def right(t: Array) -> Values:
        q, v = motion(mechanism, [0.0, 0.0], [4.0, 1.0], t)
        return {
            "a.angle": q[:, 0],
            "b.angle": q[:, 1],
            "a.angular_velocity": v[:, 0],
            "b.angular_velocity": v[:, 1],
        }

    return System(
        name="furuta_pendulum", kind="pendulums", origin="DOP853 in two angles",
        scene=scene, stop=3.0, right=right,
    )  # fmt: skip


def _arm_in_space() -> System:
    """Three bodies in a row, hinges about z, y and x, unequal data, gravity across."""
    sizes, masses = (0.5, 0.35, 0.2), (3.0, 1.0, 0.3)
    inertias = ((0.02, 0.08, 0.085), (0.004, 0.012, 0.013), (0.0005, 0.001, 0.0012))
    axes, rates = (2, 1, 0), (1.0, -2.0, 5.0)
    gravity = (0.0, -3.0, -9.0)
    bodies: dict[str, object] = {}
    joints: dict[str, object] = {}
    x, omega, velocity = 0.0, np.zeros(3), np.zeros(3)
    before = "ground"
    for i, (a, m, J, axis, rate) in enumerate(
        zip(sizes, masses, inertias, axes, rates, strict=True)
    ):
        direction = np.eye(3)[axis]
        omega = omega + rate * direction
        half = np.array([a / 2, 0, 0])
        bodies[f"b{i}"] = {
            "position": [x + a / 2, 0, 0],
            "mass": m,
            "inertia": list(J),
            "velocity": (velocity + np.cross(omega, half)).tolist(),
            "angular_velocity": omega.tolist(),
        }
        joints[f"j{i}"] = hinge(before, f"b{i}", [x, 0, 0], direction.tolist())
        velocity = velocity + np.cross(omega, 2 * half)
        before, x = f"b{i}", x + a
    scene = {"gravity": list(gravity), "bodies": bodies, "joints": joints}

    def mechanism(_: float, q: Sequence[Number]) -> Parts:
        found, energy = [], 0.0
        start: list[Number | float] = [0.0, 0.0, 0.0]
        R = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
        for a, m, J, axis, angle in zip(sizes, masses, inertias, axes, q, strict=True):
            R = after(R, about(axis, angle))
            half = turned(R, [a / 2, 0, 0])
            centre = [u + w for u, w in zip(start, half, strict=True)]
            found.append(Body(m, centre, J, rotation=R))
            energy = energy - m * dot(gravity, centre)
            start = [u + 2 * w for u, w in zip(start, half, strict=True)]
        return Parts(found, energy)

    def right(t: Array) -> Values:
        q, v = motion(mechanism, [0.0] * 3, rates, t)
        found = {f"j{i}.angle": q[:, i] for i in range(3)}
        return found | {f"j{i}.angular_velocity": v[:, i] for i in range(3)}

    return System(
        name="arm_of_three_hinges_in_space", kind="pendulums", origin="DOP853 in the joint angles",
        scene=scene, stop=2.0, right=right, fails={"fastest 1e-6": 46, "fastest 1e-8": 46},
    )  # fmt: skip


SYSTEMS = (
    _large_swing(),
    _chain("compound_pendulum", [0.8], [1.5], [0.02], [0.4], 5.0),
    _chain("double_pendulum_of_bars", [1.0, 0.3], [2.0, 0.5], [0.1, 0.01], [-1.0, -0.2], 3.0),
    _chain("three_unequal_bars", [0.3, 1.1, 0.5], [0.2, 5.0, 1.0], [0.002, 0.5, 0.001],
           [-0.6, -1.2, -1.9], 3.0),
    _chain("chain_of_six_bars", [0.3, 0.2, 0.25, 0.15, 0.3, 0.1], [1.0, 0.5, 2.0, 0.3, 0.8, 3.0],
           [0.01, 0.002, 0.02, 0.0005, 0.006, 0.004], [-1.3, -1.4, -1.6, -1.7, -1.5, -1.2], 2.0),
    _points("two_point_masses", [1.0, 0.6], [1.0, 3.0], [1.2, -0.4], [0.0, 2.0], 3.0),
    _points("light_point_above_a_heavy_one", [0.5, 0.9], [0.01, 4.0], [0.3, 0.5], [0.0, 0.0], 1.0,
            internal_step=1e-3),
    _spherical(),
    _on_cart(),
    _furuta(),
    _arm_in_space(),
)  # fmt: skip
