"""A platform on six legs and a wheel's suspension; see `benchmarks.problems.catalogue`."""

from __future__ import annotations

import math

import numpy as np

from benchmarks.problems.parts import (
    GRAVITY,
    GROUND,
    Body,
    Joint,
    O,
    Problem,
    Spring,
    Vector,
    X,
    Z,
)

DOWN = (0.0, 0.0, -GRAVITY)


def stewart() -> Problem:
    """Stewart platform of `scenes/stewart.toml`, each leg two tubes with a spring in them.

    The springs differ by up to 0.1 m, so that the platform, let go as drawn, moves in all six
    ways. Legs are 1.48 m long and end in ball joints.
    """
    s, height = math.sqrt(3) / 2, 1.2
    base = [(1.0, 0.0, 0.0), (-0.5, s, 0.0), (-0.5, -s, 0.0)]
    top = [(0.3, 0.6 * s, height), (-0.6, 0.0, height), (0.3, -0.6 * s, height)]
    mass, flat = 40.0, 40.0 * (3 * 0.36 + 0.0025) / 12
    bodies = {"platform": Body(mass=mass, position=(0, 0, height), inertia=(flat, flat, 7.2))}
    joints: list[Joint] = []
    springs: list[Spring] = []
    for i in range(6):
        foot, head = np.array(base[(i + 1) // 2 % 3]), np.array(top[i // 2])
        length = float(np.linalg.norm(head - foot))
        along = (head - foot) / length
        low, high = f"low{i}", f"high{i}"
        bodies[low] = _tube(foot + 0.4 * along, along)
        bodies[high] = _tube(head - 0.4 * along, along)
        joints += [
            Joint(kind="spherical", pair=(GROUND, low), position=_vector(foot)),
            Joint(
                kind="prismatic",
                pair=(low, high),
                position=bodies[high].position,
                axis=_vector(along),
            ),
            Joint(kind="spherical", pair=(high, "platform"), position=_vector(head)),
        ]
        ends = ((GROUND, _vector(foot)), ("platform", _vector(head - (0, 0, height))))
        springs.append(Spring(ends=ends, stiffness=2e4, length=length + 0.02 * i))
    return Problem(
        key="stewart",
        title="Stewart platform on springs",
        stop=1.0,
        gravity=DOWN,
        bodies=bodies,
        joints=tuple(joints),
        watch=(("platform", O), ("platform", (-0.6, 0.0, 0.0))),
        springs=tuple(springs),
        planar=False,
    )


def _tube(middle: np.ndarray, along: np.ndarray) -> Body:
    """Tube of 2 kg, 0.8 m and a radius of 0.05 m, its z axis along it."""
    across = np.cross(Z, along)
    turn = across / np.linalg.norm(across) * math.acos(along[2])
    inertia = (0.11, 0.11, 0.005)
    return Body(mass=2.0, position=_vector(middle), inertia=inertia, turn=_vector(turn))


def _vector(values: np.ndarray) -> Vector:
    return tuple(float(x) for x in values)


def double_wishbone(speed: float = 1.0) -> Problem:
    """`scenes/double_wishbone.toml` on a flat road, landing at `speed` [m/s]; axle in upright."""
    # Upright of 20 kg and axle of 5 kg, 0.05 m beside its centre of mass.
    share, shift = 20 * 5 / 25 * 0.05**2, 0.05 * 5 / 25
    landing = {"velocity": (0.0, 0.0, -speed)}
    bodies = {
        "car": Body(mass=400, position=(0, 0, 0.5), inertia=(40, 40, 40), **landing),
        "lower": Body(mass=4, position=(0, -0.5, 0.21), inertia=(0.04, 0.03, 0.06), **landing),
        "upper": Body(mass=2, position=(-0.01, -0.52, 0.43), inertia=(0.01, 0.01, 0.02), **landing),
        "upright": Body(
            mass=25,
            position=(0, -0.7 - shift, 0.31),
            inertia=(0.5 + share, 0.7, 0.5 + share),
            **landing,
        ),
    }
    tie = Joint(
        kind="distance",
        pair=("car", "upright"),
        ends=((-0.15, -0.35, -0.28), (-0.15, 0.02 + shift, -0.08)),
    )
    axle = ("upright", (0.0, shift - 0.05, 0.0))
    slope = math.hypot(1.0, 0.05)
    return Problem(
        key="double_wishbone",
        title="Double wishbone suspension",
        stop=0.3,
        gravity=DOWN,
        bodies=bodies,
        joints=(
            Joint(kind="prismatic", pair=(GROUND, "car"), position=(0, 0, 0.5)),
            Joint(kind="revolute", pair=("car", "lower"), position=(0, -0.35, 0.22), axis=X),
            Joint(
                kind="revolute",
                pair=("car", "upper"),
                position=(0, -0.4, 0.44),
                axis=(1 / slope, 0.0, 0.05 / slope),
            ),
            Joint(kind="spherical", pair=("lower", "upright"), position=(0, -0.7, 0.2)),
            Joint(kind="spherical", pair=("upper", "upright"), position=(-0.02, -0.65, 0.43)),
            tie,
        ),
        watch=(("car", O), axle),
        springs=(
            Spring(
                ends=(("lower", (0, -0.1, 0)), ("car", (0, -0.45, 0.2))),
                stiffness=60e3,
                damping=5e3,
                length=math.hypot(0.15, 0.49) + 5.9e3 / 60e3,
            ),
            Spring(
                ends=((GROUND, (0.0, -0.75, 0.0)), axle),
                stiffness=200e3,
                damping=500.0,
                length=0.31 + GRAVITY * 431 / 200e3,
            ),
        ),
        planar=False,
        conserves=False,
    )
