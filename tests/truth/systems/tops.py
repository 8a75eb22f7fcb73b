"""Tops and free bodies: turning in space, by closed forms or Euler's equations and quaternions."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from tests.support.mechanisms.reduced_models import (
    Top,
    integrate,
    matrix_of,
    quaternion_of,
    quaternion_rates,
    rotation,
)
from tests.truth.minimal import Body, Number, Parts, about, after, motion, turned
from tests.truth.system import Array, System, Values
from tests.truth.tables import hinge


def _axes(body: str, R: Array, places: dict[str, Sequence[float]]) -> dict[str, Array]:
    """Places (n,) of named points of a body that turns by R (n, 3, 3) about the origin."""
    return {
        f"{body}.{name}.{axis}": (R @ np.array(place))[:, k]
        for name, place in places.items()
        for k, axis in enumerate("xyz")
    }


def _spins(body: str, R: Array, omega: Array) -> dict[str, Array]:
    """Angular velocity (n, 3) in body axes, as the variables in global axes."""
    turned_rates = np.einsum("nij,nj->ni", R, omega)
    return {f"{body}.w{axis}": turned_rates[:, k] for k, axis in enumerate("xyz")}


def _free(
    name: str, inertia: Sequence[float], spin: Sequence[float], stop: float, **more: object
) -> System:
    """Free body without loads: Euler's equations; its mass centre stands."""
    scene = {
        "bodies": {
            "b": {
                "position": [0, 0, 0],
                "mass": 1.3,
                "inertia": list(inertia),
                "angular_velocity": list(spin),
                "points": {"p": [0.3, -0.2, 0.5]},
            }
        },
    }

    def right(t: Array) -> Values:
        top = Top(np.array(inertia), np.zeros(3), np.zeros(3))
        R, omega = top.motion(np.eye(3), np.array(spin), t)
        return _axes("b", R, {"p": [0.3, -0.2, 0.5]}) | _spins("b", R, omega)

    return System(
        name=name, kind="tops", origin="DOP853 of Euler's equations and quaternions",
        scene=scene, stop=stop, right=right, **more,
    )  # fmt: skip


def _symmetric() -> System:
    """Free symmetric body: its axis goes round L at |L|/A while it spins about itself.

    R(t) = rot(L t/A) rot(e3 (1 - C/A) w3 t) for R(0) = 1 (Landau and Lifshitz, Mechanics, section
    33).
    """
    A, C = 0.3, 0.5
    spin = np.array([1.2, 0.0, 7.0])
    scene = {
        "bodies": {
            "b": {
                "position": [0, 0, 0],
                "mass": 2.0,
                "inertia": [A, A, C],
                "angular_velocity": spin.tolist(),
                "points": {"p": [0.1, 0.0, 0.4]},
            }
        },
    }

    def right(t: Array) -> Values:
        L = np.array([A, A, C]) * spin
        own = np.array([0.0, 0.0, (1 - C / A) * spin[2]])
        R = np.array([rotation(L * x / A) @ rotation(own * x) for x in t])
        omega = np.array([rotation(-own * x) @ spin for x in t])
        return _axes("b", R, {"p": [0.1, 0.0, 0.4]}) | _spins("b", R, omega)

    return System(
        name="free_symmetric_body", kind="tops", origin="closed form: precession at L/A",
        scene=scene, stop=5.0, right=right,
    )  # fmt: skip


def _heavy(
    name: str, inertia: Sequence[float], centre: Sequence[float], mass: float,
    tilt: Sequence[float], spin: Sequence[float], stop: float, **more: object,
) -> System:  # fmt: skip
    """Top on a fixed tip; `inertia` about the mass centre, `spin` in body axes, tilt a rotation."""
    scene = {
        "gravity": [0, 0, -9.81],
        "bodies": {
            "b": {
                "position": [0, 0, 0],
                "orientation": {"rotation_vector": list(tilt)},
                "mass": mass,
                "center_of_mass": list(centre),
                "inertia": list(inertia),
                "angular_velocity": {"body": list(spin)},
                "points": {"tip": [0, 0, 0], "c": list(centre)},
            }
        },
        "joints": {"tip": {"type": "spherical", "points": ["ground", "b.tip"], "at": [0, 0, 0]}},
    }
    c = np.array(centre)
    about_tip = np.diag(inertia) + mass * (c @ c * np.eye(3) - np.outer(c, c))

    def right(t: Array) -> Values:
        weight = np.array([0.0, 0.0, -9.81 * mass])

        def rates(y: Array) -> Array:
            q, omega = y[:4], y[4:]
            torque = np.cross(c, matrix_of(q).T @ weight)
            change = np.linalg.solve(about_tip, torque - np.cross(omega, about_tip @ omega))
            return np.concatenate([quaternion_rates(q, omega), change])

        y = integrate(rates, [*quaternion_of(rotation(tilt)), *spin], t)
        R = np.array([matrix_of(q) for q in y[:, :4]])
        return _axes("b", R, {"c": centre}) | _spins("b", R, y[:, 4:])

    return System(
        name=name, kind="tops", origin="DOP853 of Euler's equations and quaternions",
        scene=scene, stop=stop, right=right, **more,
    )  # fmt: skip


def _steady() -> System:
    """Fast top that goes round evenly at a tilt of 40 degrees, without nutation; closed form.

    (A - C) cos(b) p^2 - C s p + m g l/1 = 0 for the rate p round the vertical and the spin s about
    its own axis against the nodes, about the tip (Goldstein, Classical Mechanics, section 5.7).
    """
    mass, length, A, C, tilt, p = 0.5, 0.08, 0.004, 0.0006, np.radians(40.0), 3.0
    own = ((A - C) * np.cos(tilt) * p**2 + mass * 9.81 * length) / (C * p)
    # Omega = p e_z + own e_3; the body is tilted about y.
    spin = [-p * np.sin(tilt), 0.0, p * np.cos(tilt) + own]
    centre = A - mass * length**2
    scene = {
        "gravity": [0, 0, -9.81],
        "bodies": {
            "b": {
                "position": [0, 0, 0],
                "orientation": {"rotation_vector": [0, float(tilt), 0]},
                "mass": mass,
                "center_of_mass": [0, 0, length],
                "inertia": [centre, centre, C],
                "angular_velocity": {"body": [float(x) for x in spin]},
                "points": {"tip": [0, 0, 0], "c": [0, 0, length]},
            }
        },
        "joints": {"tip": {"type": "spherical", "points": ["ground", "b.tip"], "at": [0, 0, 0]}},
    }

    def right(t: Array) -> Values:
        around, w = length * np.sin(tilt), own * np.sin(tilt)
        return {
            "b.c.x": around * np.cos(p * t),
            "b.c.y": around * np.sin(p * t),
            "b.c.z": np.full_like(t, length * np.cos(tilt)),
            "b.wx": w * np.cos(p * t),
            "b.wy": w * np.sin(p * t),
            "b.wz": np.full_like(t, p + own * np.cos(tilt)),
        }

    return System(
        name="steady_precession", kind="tops", origin="closed form: steady precession",
        scene=scene, stop=2.0, right=right, internal_step=1e-3,
    )  # fmt: skip


def _gimbals() -> System:
    """Wheel in two gimbals: three hinges about z, x and z, a torque on the outer one."""
    outer, inner, wheel = (0.02, 0.03, 0.025), (0.004, 0.006, 0.005), (0.002, 0.002, 0.0035)
    spin, torque = 60.0, 0.15
    scene = {
        "bodies": {
            "outer": {"position": [0, 0, 0.1], "mass": 1, "inertia": list(outer)},
            "inner": {"position": [0.05, 0, 0], "mass": 1, "inertia": list(inner)},
            "wheel": {
                "position": [0, 0, 0.02],
                "mass": 1,
                "inertia": list(wheel),
                "angular_velocity": [0, 0, spin],
            },
        },
        "joints": {
            "a": hinge("ground", "outer", [0, 0, 0.0], [0, 0, 1]),
            "b": hinge("outer", "inner", [0, 0, 0.0], [1, 0, 0]),
            "c": hinge("inner", "wheel", [0, 0, 0.0], [0, 0, 1]),
        },
        "forces": {"m": {"type": "joint_torque", "joint": "b", "value": torque}},
    }

    def mechanism(_: float, q: Sequence[Number]) -> Parts:
        first = about(2, q[0])
        second = after(first, about(0, q[1]))
        third = after(second, about(2, q[2]))
        return Parts(
            [
                Body(1.0, turned(first, [0, 0, 0.1]), outer, rotation=first),
                Body(1.0, turned(second, [0.05, 0, 0]), inner, rotation=second),
                Body(1.0, turned(third, [0, 0, 0.02]), wheel, rotation=third),
            ],
            torques=[0.0, torque, 0.0],
        )

    def right(t: Array) -> Values:
        q, v = motion(mechanism, [0.0, 0.0, 0.0], [0.0, 0.0, spin], t)
        found = {f"{name}.angle": q[:, i] for i, name in enumerate("abc")}
        return found | {f"{name}.angular_velocity": v[:, i] for i, name in enumerate("abc")}

    return System(
        name="wheel_in_gimbals", kind="tops", origin="DOP853 in the angles of the gimbals",
        scene=scene, stop=2.0, right=right, internal_step=2e-3,
    )  # fmt: skip


SYSTEMS = (
    _free("tumbling_body", [1.0, 2.1, 2.9], [0.3, 5.0, 0.2], 4.0),
    _free("slow_long_body", [0.05, 1.1, 1.12], [9.0, 0.4, -0.3], 3.0),
    _symmetric(),
    _heavy("heavy_top", [0.02, 0.02, 0.005], [0, 0, 0.2], 1.1, [0.5, 0.3, 0.0], [0, 0, 40.0], 2.0,
           internal_step=2e-3),
    _heavy("kovalevskaya_top", [0.6, 0.465, 0.165], [0.3, 0, 0], 1.5, [0.4, 0.1, 0.7],
           [0.5, 2.0, 1.0], 2.0),
    _heavy("sleeping_top", [0.0011, 0.0011, 0.0004], [0, 0, 0.05], 0.4, [0.002, 0.0, 0.0],
           [0, 0, 150.0], 2.0, internal_step=5e-4),
    _heavy("swinging_body", [0.08, 0.05, 0.06], [0.1, -0.05, -0.4], 1.7, [0.9, -0.4, 0.0],
           [0.0, 0.0, 1.5], 3.0),
    _steady(),
    _gimbals(),
)  # fmt: skip
