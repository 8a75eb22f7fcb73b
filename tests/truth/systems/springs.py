"""Springs, dampers, energies and attraction, between all kinds of places."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from scipy.linalg import expm
from scipy.optimize import brentq
from scipy.special import ellipj

from tests.truth.minimal import Body, Number, Parts, about, after, cos, motion, sin, sqrt, turned
from tests.truth.minimal import values as evaluated
from tests.truth.system import Array, System, Values
from tests.truth.tables import hinge, pinned

O = {"position": [0, 0], "fixed": True}  # noqa: E741


def _linear(M: Array, C: Array, K: Array, x0: Array, t: Array) -> tuple[Array, Array]:
    """Displacements and rates (n, m) of M x'' + C x' + K x = 0 from rest at x0, by exp(A t)."""
    n = len(M)
    A = np.block([[np.zeros((n, n)), np.eye(n)], [-np.linalg.solve(M, K), -np.linalg.solve(M, C)]])
    y = np.array([expm(A * x) @ np.concatenate([x0, np.zeros(n)]) for x in t])
    return y[:, :n], y[:, n:]


def _oscillator(damping: float, name: str) -> System:
    """Mass on a guide with a spring and a damper to the ground: one linear equation."""
    m, k, start = 1.7, 90.0, 0.25
    scene = {
        "dimension": 2,
        "bodies": {"b": {"position": [1.0 + start, 0], "mass": m, "inertia": 0.1}},
        "joints": {"guide": {"type": "prismatic", "bodies": ["ground", "b"], "axis": [1, 0]}},
        "forces": {
            "s": {
                "type": "spring",
                "points": ["ground", "b"],
                "at": [0, 0],
                "stiffness": k,
                "free_length": 1.0,
            },
            "d": {"type": "damper", "points": ["ground", "b"], "at": [0, 0], "damping": damping},
        },
    }

    def right(t: Array) -> Values:
        x, v = _linear(np.diag([m]), np.diag([damping]), np.diag([k]), np.array([start]), t)
        return {"b.x": 1 + x[:, 0], "b.vx": v[:, 0]}

    return System(
        name=name, kind="springs", origin="closed form: linear equations, exp(A t)",
        scene=scene, stop=2.0, right=right,
    )  # fmt: skip


def _row_of_masses() -> System:
    """Three masses on one guide, springs and dampers between them and to both walls."""
    M = np.diag([1.0, 0.3, 2.0])
    k, c = (50.0, 200.0, 30.0, 80.0), (0.5, 0.2, 2.0, 0.0)

    def matrix(z: Sequence[float]) -> Array:
        return np.array(
            [[z[0] + z[1], -z[1], 0], [-z[1], z[1] + z[2], -z[2]], [0, -z[2], z[2] + z[3]]]
        )

    x0 = np.array([0.1, -0.05, 0.2])
    walls = ["ground", "m0", "m1", "m2", "ground"]
    forces: dict[str, object] = {}
    for i in range(4):
        pair = [walls[i], walls[i + 1]]
        at = {"at": [0, 0]} if i == 0 else {"at": [4, 0]} if i == 3 else {}
        forces[f"s{i}"] = {
            "type": "spring",
            "points": pair,
            "stiffness": k[i],
            "free_length": 1.0,
            **at,
        }
        if c[i]:
            forces[f"d{i}"] = {"type": "damper", "points": pair, "damping": c[i], **at}
    scene = {
        "dimension": 2,
        "bodies": {
            f"m{i}": {"position": [i + 1 + float(x0[i]), 0], "mass": M[i, i], "inertia": 0.1}
            for i in range(3)
        },
        "joints": {
            f"g{i}": {"type": "prismatic", "bodies": ["ground", f"m{i}"], "axis": [1, 0]}
            for i in range(3)
        },
        "forces": forces,
    }

    def right(t: Array) -> Values:
        x, v = _linear(M, matrix(c), matrix(k), x0, t)
        return {f"m{i}.x": i + 1 + x[:, i] for i in range(3)} | {
            f"m{i}.vx": v[:, i] for i in range(3)
        }

    return System(
        name="three_masses_between_walls", kind="springs",
        origin="closed form: linear equations, exp(A t)",
        scene=scene, stop=3.0, right=right,
    )  # fmt: skip


def _duffing() -> System:
    """Spring of energy a x^2/2 + b x^4/4: x = X cn(w t, k), Jacobi's function."""
    m, a, b, top = 0.8, 12.0, 40.0, 0.9
    scene = {
        "dimension": 2,
        "points": {"A": {"position": [2 + top, 0], "mass": m}},
        "joints": {"g": {"type": "point_on_line", "point": "A", "axis": [1, 0]}},
        "forces": {
            "s": {
                "type": "spring",
                "points": ["ground", "A"],
                "at": [0, 0],
                "energy": f"{a / 2}*(length - 2)**2 + {b / 4}*(length - 2)**4",
            }
        },
    }

    def right(t: Array) -> Values:
        w = math.sqrt((a + b * top**2) / m)
        k2 = b * top**2 / (2 * (a + b * top**2))
        sn, cn, dn, _ = ellipj(w * t, k2)
        return {"A.x": 2 + top * cn, "A.vx": -top * w * sn * dn}

    return System(
        name="duffing_spring", kind="springs", origin="closed form: Jacobi's elliptic functions",
        scene=scene, stop=3.0, right=right,
    )  # fmt: skip


def _torsion_pendulum() -> System:
    """Disc on a torsion spring and damper, free at an angle: J a'' + c a' + k (a - a0) = 0."""
    J, k, c, free = 0.06, 8.0, 0.05, 0.9
    scene = {
        "bodies": {"d": {"position": [0, 0, 0], "mass": 1, "inertia": [0.04, 0.03, J]}},
        "joints": {"j": hinge("ground", "d", [0, 0, 0], [0, 0, 1])},
        "forces": {
            "s": {"type": "torsion_spring", "joint": "j", "stiffness": k, "free_angle": free},
            "b": {"type": "torsion_damper", "joint": "j", "damping": c},
        },
    }

    def right(t: Array) -> Values:
        x, v = _linear(np.diag([J]), np.diag([c]), np.diag([k]), np.array([-free]), t)
        return {"j.angle": free + x[:, 0], "d.wz": v[:, 0], "s.torque": k * x[:, 0]}

    return System(
        name="torsion_pendulum", kind="springs", origin="closed form: linear equation, exp(A t)",
        scene=scene, stop=2.0, right=right,
    )  # fmt: skip


def _kepler(eccentricity: float, name: str, internal_step: float, **more: object) -> System:
    """Two masses that attract each other, from the pericentre: Kepler's equation."""
    masses, a = (3.0, 0.5), 1.4
    mu = 2.0 * sum(masses)
    near = a * (1 - eccentricity)
    fast = math.sqrt(mu / a * (1 + eccentricity) / (1 - eccentricity))
    part = masses[1] / sum(masses), masses[0] / sum(masses)
    scene = {
        "dimension": 2,
        "points": {
            "A": {
                "position": [-part[0] * near, 0],
                "velocity": [0, -part[0] * fast],
                "mass": masses[0],
            },
            "B": {
                "position": [part[1] * near, 0],
                "velocity": [0, part[1] * fast],
                "mass": masses[1],
            },
        },
        "forces": {"g": {"type": "gravitation", "points": ["A", "B"], "constant": 2.0}},
    }

    def right(t: Array) -> Values:
        n = math.sqrt(mu / a**3)
        e = eccentricity
        E = np.array(
            [
                brentq(lambda u, x=x: u - e * math.sin(u) - n * x, -1, n * x + 2, xtol=1e-15)
                for x in t
            ]
        )
        rate = n / (1 - e * np.cos(E))
        x, y = a * (np.cos(E) - e), a * math.sqrt(1 - e * e) * np.sin(E)
        vx, vy = -a * np.sin(E) * rate, a * math.sqrt(1 - e * e) * np.cos(E) * rate
        return {
            "B.x": part[1] * x,
            "B.y": part[1] * y,
            "A.x": -part[0] * x,
            "B.vx": part[1] * vx,
            "B.vy": part[1] * vy,
        }

    return System(
        name=name, kind="springs", origin="closed form: Kepler's equation",
        scene=scene, stop=6.0, right=right, internal_step=internal_step, **more,
    )  # fmt: skip


def _spring_pendulum(space: bool, name: str, **more: object) -> System:
    """Mass on a spring and a damper from a fixed place, in polar or spherical coordinates."""
    m, k, c, free, r0 = 0.9, 70.0, 0.4, 0.8, 1.1
    tilt, around = 0.8, 1.3 if space else 0.0
    zero = [0.0] * (3 if space else 2)

    def place(q: Sequence[Number]) -> list[Number]:
        if not space:
            return [q[0] * sin(q[1]), -q[0] * cos(q[1])]
        side = q[0] * sin(q[1])
        return [side * cos(q[2]), side * sin(q[2]), -q[0] * cos(q[1])]

    start = [r0 * math.sin(tilt), -r0 * math.cos(tilt)]
    speed = [0.0, 0.0]
    if space:
        start, speed = [start[0], 0.0, start[1]], [0.0, start[0] * around, 0.0]
    scene = {
        "dimension": len(zero),
        "gravity": [*zero[:-1], -9.81],
        "points": {
            "O": {"position": zero, "fixed": True},
            "A": {"position": start, "velocity": speed, "mass": m},
        },
        "forces": {
            "s": {"type": "spring", "points": ["O", "A"], "stiffness": k, "free_length": free},
            "d": {"type": "damper", "points": ["O", "A"], "damping": c},
        },
    }

    def mechanism(_: float, q: Sequence[Number]) -> Parts:
        energy = 0.5 * k * (q[0] - free) ** 2 + m * 9.81 * place(q)[-1]
        return Parts([Body(m, place(q))], energy, torques=[-c * q[0].rate, *zero[1:]])

    def right(t: Array) -> Values:
        q, v = motion(mechanism, [r0, tilt, 0.0][: len(zero)], [0.0, 0.0, around][: len(zero)], t)
        x, rates = evaluated(place, q, v)
        axes = "xyz"[: len(zero)]
        return {f"A.{a}": x[:, i] for i, a in enumerate(axes)} | {
            f"A.v{a}": rates[:, i] for i, a in enumerate(axes)
        }

    return System(
        name=name, kind="springs", origin="DOP853 in polar coordinates",
        scene=scene, stop=3.0, right=right, **more,
    )  # fmt: skip


def _bar_with_strut() -> System:
    """Hinged bar held by a spring and a damper from the ground to a place off its axis."""
    J, m, c = 0.3, 2.0, (0.6, 0.0)
    end, wall, k, d, free = (0.9, 0.2), (0.4, 1.3), 150.0, 6.0, 0.9
    scene = {
        "dimension": 2,
        "gravity": [0, -9.81],
        "bodies": {
            "b": {
                "position": [0, 0],
                "mass": m,
                "center_of_mass": list(c),
                "inertia": J,
                "points": {"o": [0, 0], "e": list(end)},
            }
        },
        "joints": {"h": pinned("ground", "b.o", at=[0, 0])},
        "forces": {
            "s": {
                "type": "spring",
                "points": ["ground", "b.e"],
                "at": list(wall),
                "stiffness": k,
                "free_length": free,
            },
            "d": {
                "type": "damper",
                "points": ["ground", "b.e"],
                "at": list(wall),
                "damping": d,
            },
        },
    }

    def length(q: Number) -> Number:
        x = end[0] * cos(q) - end[1] * sin(q) - wall[0]
        y = end[0] * sin(q) + end[1] * cos(q) - wall[1]
        return sqrt(x * x + y * y)

    def mechanism(_: float, q: Sequence[Number]) -> Parts:
        centre = (c[0] * cos(q[0]), c[0] * sin(q[0]))
        stretch = length(q[0])
        energy = 0.5 * k * (stretch - free) ** 2 + m * 9.81 * centre[1]
        brake = -d * stretch.rate * stretch.gradient
        return Parts([Body(m, centre, J, q[0])], energy, torques=brake)

    def right(t: Array) -> Values:
        q, v = motion(mechanism, [0.0], [0.0], t)
        x, _ = evaluated(lambda n: [length(n[0])], q, v)
        return {
            "b.angle": q[:, 0],
            "b.angular_velocity": v[:, 0],
            "s.length": x[:, 0],
            "s.force": k * (x[:, 0] - free),
        }

    return System(
        name="bar_on_a_strut", kind="springs", origin="DOP853 in the angle",
        scene=scene, stop=2.0, right=right,
    )  # fmt: skip


def _spring_between_free_bodies() -> System:
    """Two free bodies in space on a spring between their mass centres, which turns round.

    The relative place moves in a plane as a mass m1 m2/(m1 + m2) on the spring; polar coordinates.
    """
    m1, m2, k, free, r0, w0 = 2.0, 0.7, 30.0, 0.9, 1.2, 2.5
    part1, part2 = m2 / (m1 + m2), m1 / (m1 + m2)
    drift = np.array([0.3, -0.2, 0.1])
    scene = {
        "bodies": {
            "a": {
                "position": [-part1 * r0, 0, 0],
                "mass": m1,
                "inertia": [0.1, 0.2, 0.25],
                "velocity": (drift - np.array([0, 0, part1 * r0 * w0])).tolist(),
            },
            "b": {
                "position": [part2 * r0, 0, 0],
                "mass": m2,
                "inertia": [0.01, 0.02, 0.02],
                "velocity": (drift + np.array([0, 0, part2 * r0 * w0])).tolist(),
            },
        },
        "forces": {
            "s": {"type": "spring", "points": ["a", "b"], "stiffness": k, "free_length": free}
        },
    }
    reduced = m1 * m2 / (m1 + m2)

    def mechanism(_: float, q: Sequence[Number]) -> Parts:
        place = (q[0] * cos(q[1]), q[0] * sin(q[1]))
        return Parts([Body(reduced, place)], 0.5 * k * (q[0] - free) ** 2)

    def right(t: Array) -> Values:
        q, _ = motion(mechanism, [r0, 0.0], [0.0, w0], t)
        x, z = q[:, 0] * np.cos(q[:, 1]), q[:, 0] * np.sin(q[:, 1])
        return {
            "a.x": drift[0] * t - part1 * x,
            "a.z": drift[2] * t - part1 * z,
            "b.x": drift[0] * t + part2 * x,
            "b.y": drift[1] * t,
            "b.z": drift[2] * t + part2 * z,
            "s.length": q[:, 0],
        }

    return System(
        name="spring_between_free_bodies", kind="springs",
        origin="DOP853 of the relative motion in polar coordinates",
        scene=scene, stop=4.0, right=right,
    )  # fmt: skip


def _two_hinges_with_dampers() -> System:
    """Arm of two hinges about y and x with torsion springs and dampers at both, in space."""
    a, m, J1, J2 = 0.5, (1.5, 0.6), (0.01, 0.03, 0.03), (0.002, 0.01, 0.011)
    k, c, free = (20.0, 3.0), (0.3, 0.05), (0.4, -0.6)
    scene = {
        "gravity": [0, 0, -9.81],
        "bodies": {
            "u": {"position": [a / 2, 0, 0], "mass": m[0], "inertia": list(J1)},
            "v": {"position": [a, 0.2, 0], "mass": m[1], "inertia": list(J2)},
        },
        "joints": {
            "p": hinge("ground", "u", [0, 0, 0], [0, 1, 0]),
            "q": hinge("u", "v", [a, 0, 0], [1, 0, 0]),
        },
        "forces": {
            f"{kind}{i}": {"type": f"torsion_{kind}", "joint": j, field: value[i], **more[i]}
            for kind, field, value, more in (
                ("spring", "stiffness", k, [{"free_angle": x} for x in free]),
                ("damper", "damping", c, [{}, {}]),
            )
            for i, j in enumerate("pq")
        },
    }

    def mechanism(_: float, q: Sequence[Number]) -> Parts:
        first = about(1, q[0])
        second = after(first, about(0, q[1]))
        centre = turned(first, [a / 2, 0, 0])
        other = [
            x + y
            for x, y in zip(turned(first, [a, 0, 0]), turned(second, [0, 0.2, 0]), strict=True)
        ]
        energy = 9.81 * (m[0] * centre[2] + m[1] * other[2])
        for i in range(2):
            energy = energy + 0.5 * k[i] * (q[i] - free[i]) ** 2
        bodies = [Body(m[0], centre, J1, rotation=first), Body(m[1], other, J2, rotation=second)]
        return Parts(bodies, energy, torques=[-c[i] * q[i].rate for i in range(2)])

    def right(t: Array) -> Values:
        q, v = motion(mechanism, [0.0, 0.0], [0.0, 0.0], t)
        return {
            "p.angle": q[:, 0],
            "q.angle": q[:, 1],
            "p.angular_velocity": v[:, 0],
            "q.angular_velocity": v[:, 1],
        }

    return System(
        name="sprung_hinges_in_space", kind="springs", origin="DOP853 in the angles",
        scene=scene, stop=3.0, right=right,
    )  # fmt: skip


def _potential() -> System:
    """Point in the well V = a (x^2 + y^2)/2 + b x^2 y - c y^3 of Henon and Heiles, scaled."""
    m, a = 1.3, 20.0

    def energy(x: Number, y: Number) -> Number:
        return 0.5 * a * (x * x + y * y) + a * (x * x * y - y * y * y / 3)

    scene = {
        "dimension": 2,
        "points": {"A": {"position": [0.3, -0.1], "velocity": [0.2, 1.1], "mass": m}},
        "forces": {
            "w": {
                "type": "potential",
                "value": f"{a / 2}*(A.x**2 + A.y**2) + {a}*(A.x**2*A.y - A.y**3/3)",
            }
        },
    }

    def right(t: Array) -> Values:
        def mechanism(_: float, q: Sequence[Number]) -> Parts:
            return Parts([Body(m, q)], energy(*q))

        q, v = motion(mechanism, [0.3, -0.1], [0.2, 1.1], t)
        return {"A.x": q[:, 0], "A.y": q[:, 1], "A.vx": v[:, 0], "A.vy": v[:, 1]}

    return System(
        name="point_in_a_well", kind="springs", origin="DOP853 in x and y",
        scene=scene, stop=5.0, right=right,
    )  # fmt: skip


SYSTEMS = (
    _oscillator(0.0, "mass_on_a_spring"),
    _oscillator(4.0, "mass_on_a_spring_and_damper"),
    _oscillator(60.0, "overdamped_mass"),
    _row_of_masses(),
    _duffing(),
    _torsion_pendulum(),
    _kepler(0.1, "orbit_of_two_masses", 0.01),
    _kepler(0.7, "eccentric_orbit", 0.002),
    _spring_pendulum(False, "damped_spring_pendulum"),
    _spring_pendulum(True, "damped_spring_pendulum_in_space"),
    _bar_with_strut(),
    _spring_between_free_bodies(),
    _two_hinges_with_dampers(),
    _potential(),
)
