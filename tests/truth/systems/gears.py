"""Gear trains: wheels that turn with their ratios, in closed form."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from tests.truth.system import Array, System, Values
from tests.truth.tables import hinge


def _wheel(inertia: float, x: float, **more: object) -> dict[str, object]:
    return {"position": [x, 0.0], "mass": 1.0, "inertia": inertia, **more}


def _axle(body: str, x: float, carrier: str = "ground") -> dict[str, object]:
    return hinge(carrier, body, [x, 0.0])


def _pair() -> System:
    """Two wheels: (J1 + r^2 J2) w' = T of the first."""
    J1, J2, ratio, torque, w0 = 0.03, 0.4, -0.35, 1.7, 4.0
    scene = {
        "dimension": 2,
        "bodies": {
            "a": _wheel(J1, 0.0, angular_velocity=w0),
            "b": _wheel(J2, 0.3, angular_velocity=ratio * w0),
        },
        "joints": {
            "ja": _axle("a", 0.0),
            "jb": _axle("b", 0.3),
            "g": {"type": "gear", "joints": ["ja", "jb"], "ratio": ratio},
        },
        "forces": {"m": {"type": "joint_torque", "joint": "ja", "value": torque}},
    }

    def right(t: Array) -> Values:
        rate = torque / (J1 + ratio**2 * J2)
        angle = w0 * t + rate * t**2 / 2
        return {
            "ja.angle": angle,
            "jb.angle": ratio * angle,
            "a.angular_velocity": w0 + rate * t,
            "b.angular_velocity": ratio * (w0 + rate * t),
        }

    return System(
        name="gear_pair", kind="gears", origin="closed form: (J1 + r^2 J2) w' = T",
        scene=scene, stop=2.0, right=right,
    )  # fmt: skip


def _three_stages() -> System:
    """Reducer of three stages with a brake at its end: one freedom of first order in w."""
    inertias, ratios = (0.002, 0.01, 0.15, 2.0), (-0.4, -0.25, -0.2)
    torque, brake = 0.8, 30.0
    total, found = 1.0, [1.0]
    for ratio in ratios:
        total *= ratio
        found.append(total)
    names = ("a", "b", "c", "d")
    joints: dict[str, object] = {f"j{x}": _axle(x, i * 0.2) for i, x in enumerate(names)}
    for i, ratio in enumerate(ratios):
        pair = [f"j{names[i]}", f"j{names[i + 1]}"]
        joints[f"g{i}"] = {"type": "gear", "joints": pair, "ratio": ratio}
    scene = {
        "dimension": 2,
        "bodies": {
            x: _wheel(J, i * 0.2) for i, (x, J) in enumerate(zip(names, inertias, strict=True))
        },
        "joints": joints,
        "forces": {
            "m": {"type": "joint_torque", "joint": "ja", "value": torque},
            "brake": {"type": "torsion_damper", "joint": "jd", "damping": brake},
        },
    }

    def right(t: Array) -> Values:
        inertia = sum(J * r**2 for J, r in zip(inertias, found, strict=True))
        rate, settled = brake * total**2 / inertia, torque / (brake * total**2)
        w = settled * -np.expm1(-rate * t)
        angle = settled * t - w / rate
        return {
            "ja.angle": angle,
            "jd.angle": total * angle,
            "a.angular_velocity": w,
            "d.angular_velocity": total * w,
        }

    return System(
        name="reducer_of_three_stages", kind="gears",
        origin="closed form: w = T/b (1 - exp(-b t/J)), referred to the first wheel",
        scene=scene, stop=3.0, right=right,
    )  # fmt: skip


def _planetary(spring: float, torque: float, name: str, stop: float) -> System:
    """Sun, planet and carrier in a ring that stands, with a torque on the sun; closed forms.

    Willis: the sun turns by 1 + Nr/Ns per turn of the carrier, the planet by 1 - Nr/Np. The
    kinetic energy is J w^2/2 of the carrier's rate w; a torsion spring holds the carrier.
    """
    Ns, Np = 18.0, 31.0
    Nr = Ns + 2 * Np
    arm, masses = 0.06, (1.2, 0.7, 0.3)
    Jc, Js, Jp = 0.015, 0.0008, 0.00025
    sun, planet = 1 + Nr / Ns, 1 - Nr / Np
    scene: dict[str, object] = {
        "dimension": 2,
        "bodies": {
            "carrier": {"position": [0, 0], "mass": masses[0], "inertia": Jc},
            "sun": {"position": [0, 0], "mass": masses[1], "inertia": Js},
            "planet": {"position": [arm, 0], "mass": masses[2], "inertia": Jp},
        },
        "joints": {
            "jc": _axle("carrier", 0.0),
            "js": _axle("sun", 0.0, "carrier"),
            "jp": _axle("planet", arm, "carrier"),
            "inner": {"type": "gear", "joints": ["js", "jp"], "ratio": -Ns / Np},
            "outer": {"type": "gear", "joints": ["jc", "jp"], "ratio": -Nr / Np},
        },
        "forces": {
            "m": {"type": "torque", "body": "sun", "value": torque},
            "s": {"type": "torsion_spring", "joint": "jc", "stiffness": spring},
        },
    }
    inertia = Jc + Js * sun**2 + Jp * planet**2 + masses[2] * arm**2

    def right(t: Array) -> Values:
        if spring:
            w = np.sqrt(spring / inertia)
            angle = torque * sun / spring * (1 - np.cos(w * t))
            rate = torque * sun / spring * w * np.sin(w * t)
        else:
            angle, rate = torque * sun / inertia * t**2 / 2, torque * sun / inertia * t
        return {
            "carrier.angle": angle,
            "sun.angle": sun * angle,
            "planet.angle": planet * angle,
            "carrier.angular_velocity": rate,
            "sun.angular_velocity": sun * rate,
        }

    # Communication points lie a whole number of swings apart, where rates are near zero: errors of
    # rates are measured by the largest rate of the swing, not by the largest of those.
    swing = {"turn": torque * sun**2 / np.sqrt(spring * inertia)} if spring else {}
    return System(
        name=name, kind="gears", origin="closed form: Willis' equation, one freedom",
        scene=scene, stop=stop, right=right, internal_step=0.002, scale=swing,
    )  # fmt: skip


def _screw_jack() -> System:
    """Nut that a weight drives down a screw: (m + J (2 pi/p)^2) z'' = -m g."""
    mass, inertia, pitch = 3.0, 2e-4, 0.02
    scene = {
        "gravity": [0, 0, -9.81],
        "bodies": {
            "nut": {"position": [0, 0, 1], "mass": mass, "inertia": [inertia, inertia, inertia]}
        },
        "joints": {
            "s": {
                "type": "screw",
                "bodies": ["ground", "nut"],
                "position": [0, 0, 0],
                "axis": [0, 0, 1],
                "pitch": pitch,
            }
        },
    }

    def right(t: Array) -> Values:
        turns = 2 * np.pi / pitch
        a = -9.81 * mass / (mass + inertia * turns**2)
        return {
            "nut.z": 1 + a * t**2 / 2,
            "nut.vz": a * t,
            "s.angle": turns * a * t**2 / 2,
            "s.angular_velocity": turns * a * t,
        }

    return System(
        name="falling_nut", kind="gears", origin="closed form: (m + J (2 pi/p)^2) z'' = -m g",
        scene=scene, stop=1.0, right=right, internal_step=1e-3,
    )  # fmt: skip


def _bevel() -> System:
    """Wheels about axes at right angles in space, on a base that stands; torque on the first."""
    J1, J2, ratio, torque = 0.02, 0.11, 1.6, -0.9

    def wheel(J: float, axis: list[float], place: list[float]) -> Mapping[str, object]:
        across = 0.6 * J
        inertia = [J if abs(x) == 1 else across for x in axis]
        return {"position": place, "mass": 2.0, "inertia": inertia}

    scene = {
        "bodies": {
            "a": wheel(J1, [1, 0, 0], [0, 0, 0]),
            "b": wheel(J2, [0, 0, 1], [0.1, 0, 0.1]),
        },
        "joints": {
            "ja": hinge("ground", "a", [0.05, 0, 0], [1, 0, 0]),
            "jb": hinge("ground", "b", [0.1, 0, 0.05], [0, 0, 1]),
            "g": {"type": "gear", "joints": ["ja", "jb"], "ratio": ratio},
        },
        "forces": {"m": {"type": "joint_torque", "joint": "ja", "value": torque}},
    }

    def right(t: Array) -> Values:
        rate = torque / (J1 + ratio**2 * J2)
        return {
            "ja.angle": rate * t**2 / 2,
            "jb.angle": ratio * rate * t**2 / 2,
            "b.wz": ratio * rate * t,
            "g.torque": np.full_like(t, J2 * ratio * rate),
        }

    return System(
        name="bevel_gears", kind="gears", origin="closed form: (J1 + r^2 J2) w' = T",
        scene=scene, stop=3.0, right=right,
    )  # fmt: skip


SYSTEMS = (
    _pair(),
    _three_stages(),
    _planetary(0.0, 0.6, "planetary_in_free_run", 1.5),
    _planetary(40.0, 0.6, "planetary_on_a_spring", 2.0),
    _screw_jack(),
    _bevel(),
)
