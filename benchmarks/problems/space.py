"""The problems in space; see `benchmarks.problems.catalogue`."""

from __future__ import annotations

import math

from benchmarks.problems.parts import (
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


def box(mass: float, size: Vector) -> Vector:
    """Moments of inertia of a box about its centre [kg m2]."""
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
            inertia=box(1.0, sizes[along]),
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


def rigid_chain(n: int) -> Problem:
    """N hinged boxes of 0.1 kg and 0.1 m, let go from the horizontal (`generate.rigid_chain`)."""
    names = [GROUND, *(f"link{i + 1}" for i in range(n))]
    inertia = box(0.1, (0.1, 0.02, 0.02))
    bodies = {
        name: Body(mass=0.1, position=(0.1 * i + 0.05, 0.0, 0.0), inertia=inertia)
        for i, name in enumerate(names[1:])
    }
    joints = tuple(
        Joint(
            kind="revolute",
            pair=(names[i], names[i + 1]),
            position=(0.1 * i, 0.0, 0.0),
            axis=Z if i % 2 else Y,
        )
        for i in range(n)
    )
    return Problem(
        key=f"rigid_chain_{n}",
        title=f"Chain of {n} hinged rigid bodies",
        stop=1.0,
        gravity=(0.0, 0.0, -GRAVITY),
        bodies=bodies,
        joints=joints,
        watch=((names[n], (0.05, 0.0, 0.0)), (names[(n + 1) // 2], (0.05, 0.0, 0.0))),
        planar=False,
    )


def net(n: int) -> Problem:
    """N x N points of 0.1 kg on rods of 0.1 m, flat, moving across, without gravity or support."""
    bodies = {
        f"P{i}_{j}": Body(
            mass=0.1,
            position=(0.1 * i, 0.1 * j, 0.0),
            velocity=(0.0, 0.0, 0.5 * math.sin(5 * i / n) * math.sin(3 * j / n)),
        )
        for i in range(n)
        for j in range(n)
    }
    pairs = [(f"P{i}_{j}", f"P{i + 1}_{j}") for i in range(n - 1) for j in range(n)]
    pairs += [(f"P{i}_{j}", f"P{i}_{j + 1}") for i in range(n) for j in range(n - 1)]
    return Problem(
        key=f"net_{n}",
        title=f"Net of {n} x {n} points",
        stop=1.0,
        gravity=O,
        bodies=bodies,
        joints=tuple(Joint(kind="distance", pair=pair) for pair in pairs),
        watch=((f"P{n - 1}_{n - 1}", O), (f"P{n // 2}_{n // 2}", O)),
        planar=False,
    )


GOVERNOR = {
    "rod": 0.3, "ball": 5.0, "slider": 3.0, "stiffness": 8e5, "damping": 4e4, "gravity": GRAVITY,
    "speed": 2 * math.pi, "alpha": math.pi / 6,
}  # fmt: skip
"""Masses [kg], SI units, angle of the rods below the horizontal [rad]."""


def governor() -> Problem:
    """Flyball governor (IFToMM A05): 3000 kg/m3, balls of 5 kg, stiff spring-dampers."""
    middle = (0.0, 0.0, 0.5)
    spun = {"position": middle, "omega": (0.0, 0.0, GOVERNOR["speed"])}
    bodies = {
        "shaft": Body(mass=0.3, inertia=box(0.3, (0.01, 0.01, 1)), **spun),
        "slider": Body(mass=3.0, inertia=box(3.0, (0.1,) * 3), **spun),
        "right": _loaded_rod(1),
        "left": _loaded_rod(-1),
    }
    joints = [
        Joint(kind="revolute", pair=(GROUND, "shaft")),
        Joint(kind="prismatic", pair=("shaft", "slider"), position=middle),
    ]
    springs = []
    for side, name in ((1, "right"), (-1, "left")):
        joints.append(
            Joint(kind="revolute", pair=("shaft", name), position=(0.05 * side, 0, 1), axis=Y)
        )
        eye: Place = (name, (-side * OFFSET, 0.0, 0.0))
        law = {"stiffness": GOVERNOR["stiffness"], "damping": GOVERNOR["damping"]}
        springs.append(Spring(ends=(("slider", (0.05 * side, 0, 0)), eye), length=0.5, **law))
    return Problem(
        key="governor",
        title="Flyball governor (IFToMM A05)",
        stop=10.0,
        gravity=(0.0, 0.0, -GRAVITY),
        bodies=bodies,
        joints=tuple(joints),
        watch=(("slider", O), ("right", (0.5 - OFFSET, 0.0, 0.0))),
        springs=tuple(springs),
        planar=False,
        conserves=False,
        data=GOVERNOR,
    )


OFFSET = 5.0 * 0.5 / 5.3
"""From the middle of a rod to the centre of mass of rod and ball [m]."""


def _loaded_rod(side: int) -> Body:
    """Rod with its ball, on the right (1) or left (-1) of the shaft."""
    c, s = math.cos(GOVERNOR["alpha"]), math.sin(GOVERNOR["alpha"])
    speed = GOVERNOR["speed"]
    radius, height = 0.05 + (0.5 + OFFSET) * c, 1.0 - (0.5 + OFFSET) * s
    ix, iy, iz = box(0.3, (1.0, 0.01, 0.01))
    across = 0.3 * OFFSET**2 + 5.0 * (0.5 - OFFSET) ** 2
    return Body(
        mass=5.3,
        position=(side * radius, 0.0, height),
        inertia=(ix, iy + across, iz + across),
        turn=(0.0, side * GOVERNOR["alpha"], 0.0),
        velocity=(0.0, side * speed * radius, 0.0),
        omega=(-side * speed * s, 0.0, speed * c),
    )
