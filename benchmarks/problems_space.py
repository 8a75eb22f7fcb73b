"""The problems in space; see `benchmarks.problems`."""

from __future__ import annotations

import math

from benchmarks.problems_parts import (
    GRAVITY,
    GROUND,
    Body,
    Joint,
    O,
    Place,
    Problem,
    Spring,
    Vector,
    X,
    Y,
    Z,
    added,
    rotation,
)


def _box(mass: float, size: Vector) -> Vector:
    x, y, z = (side * side for side in size)
    return (mass * (y + z) / 12, mass * (z + x) / 12, mass * (x + y) / 12)


def bricard() -> Problem:
    """Five rods of 1 kg and 1 m, 0.1 m thick, six hinges across each other (IFToMM A04)."""
    sizes = {"x": (1.0, 0.1, 0.1), "y": (0.1, 1.0, 0.1), "z": (0.1, 0.1, 1.0)}
    corners = [O, X, (1.0, -1.0, 0.0), (1.0, -1.0, 1.0), (0.0, -1.0, 1.0), Z]
    names = [GROUND, *(f"rod{i}" for i in range(1, 6)), GROUND]
    bodies = {
        names[i + 1]: Body(
            mass=1.0,
            position=tuple(0.5 * q for q in added(corners[i], corners[i + 1])),
            inertia=_box(1.0, sizes[along]),
        )
        for i, along in enumerate("xyzxy")
    }
    hinges = [
        Joint(
            kind="revolute",
            pair=(names[i], names[i + 1]),
            position=corner,
            axis=axis,
            redundant=i == 5,
        )
        for i, (corner, axis) in enumerate(zip(corners, (Y, Z, X, Y, Z, X), strict=True))
    ]
    return Problem(
        key="bricard",
        title="Bricard's mechanism (IFToMM A04)",
        stop=10.0,
        bodies=bodies,
        joints=tuple(hinges),
        watch=(("rod3", (0.0, 0.0, 0.5)),),
        planar=False,
        data={"length": 1.0, "mass": 1.0, "width": 0.1, "gravity": GRAVITY},
    )


def heavy_top() -> Problem:
    """Fast heavy top (Simo and Wong 1991): 5, 5, 1 kg m2 about the tip, 50 rad/s, tilted 0.05."""
    turn = (0.05, 0.0, 0.0)
    top = Body(
        mass=1.0,
        position=tuple(float(x) for x in rotation(turn)[:, 2]),
        inertia=(4.0, 4.0, 1.0),
        turn=turn,
        omega=(0.0, 0.0, 50.0),
    )
    return Problem(
        key="heavy_top",
        title="Heavy top",
        stop=2.0,
        gravity=(0.0, 0.0, -20.0),
        bodies={"top": top},
        joints=(Joint(kind="spherical", pair=(GROUND, "top")),),
        watch=(("top", O),),
        planar=False,
        data={"transverse": 5.0, "axial": 1.0, "moment": 1.0, "gravity": 20.0, "spin": 50.0},
    )


def governor() -> Problem:
    """Flyball governor (IFToMM A05): 3000 kg/m3, balls of 5 kg, stiff spring-dampers."""
    speed, alpha = 2 * math.pi, math.pi / 6
    spun = {"omega": (0.0, 0.0, speed)}
    bodies = {
        "shaft": Body(mass=0.3, position=(0, 0, 0.5), inertia=_box(0.3, (0.01, 0.01, 1)), **spun),
        "slider": Body(mass=3.0, position=(0, 0, 0.5), inertia=_box(3.0, (0.1,) * 3), **spun),
    }
    joints = [
        Joint(kind="revolute", pair=(GROUND, "shaft")),
        Joint(kind="prismatic", pair=("shaft", "slider"), position=(0.0, 0.0, 0.5)),
    ]
    springs = []
    for side, name in ((1, "right"), (-1, "left")):
        rod, offset = _loaded_rod()
        c, s = math.cos(alpha), math.sin(alpha)
        radius, height = 0.05 + (0.5 + offset) * c, 1.0 - (0.5 + offset) * s
        bodies[name] = Body(
            mass=5.3,
            position=(side * radius, 0.0, height),
            inertia=rod,
            turn=(0.0, side * alpha, 0.0),
            velocity=(0.0, side * speed * radius, 0.0),
            omega=(-side * speed * s, 0.0, speed * c),
        )
        joints.append(
            Joint(kind="revolute", pair=("shaft", name), position=(0.05 * side, 0, 1), axis=Y)
        )
        ends: tuple[Place, Place] = (
            ("slider", (0.05 * side, 0, 0)),
            (name, (-side * offset, 0, 0)),
        )
        springs.append(Spring(ends=ends, stiffness=8e5, length=0.5, damping=4e4))
    return Problem(
        key="governor",
        title="Flyball governor (IFToMM A05)",
        stop=10.0,
        gravity=(0.0, 0.0, -GRAVITY),
        bodies=bodies,
        joints=tuple(joints),
        watch=(("slider", O), ("right", (0.5 - _loaded_rod()[1], 0.0, 0.0))),
        springs=tuple(springs),
        planar=False,
        conserves=False,
        data={
            "rod": 0.3,
            "ball": 5.0,
            "slider": 3.0,
            "stiffness": 8e5,
            "damping": 4e4,
            "gravity": GRAVITY,
            "speed": speed,
            "alpha": alpha,
        },
    )


def _loaded_rod() -> tuple[Vector, float]:
    """Inertia of a rod with its ball about their common centre, and how far out that is [m]."""
    offset = 5.0 * 0.5 / 5.3
    ix, iy, iz = _box(0.3, (1.0, 0.01, 0.01))
    across = 0.3 * offset**2 + 5.0 * (0.5 - offset) ** 2
    return (ix, iy + across, iz + across), offset
