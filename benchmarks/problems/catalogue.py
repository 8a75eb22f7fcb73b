"""The problems of the work-precision curves: the one place that every code takes its numbers from.

Models for the other codes are built from these bodies and joints, their reduced equations take
their constants from here, and a test compares our scenes with them.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from itertools import pairwise

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
    added,
)
from benchmarks.problems.space import bricard, governor, heavy_top, net, rigid_chain
from benchmarks.problems.vehicles import double_wishbone, stewart

# ------------------------------------------------------------------------------ points and bars


def double_pendulum(key: str, degrees: float) -> Problem:
    """Two points of 1 kg on massless rods of 1 m, both at an angle from the vertical, at rest."""
    s, c = math.sin(math.radians(degrees)), math.cos(math.radians(degrees))
    bodies = {f"P{i}": Body(mass=1.0, position=(i * s, -i * c, 0.0)) for i in (1, 2)}
    return Problem(
        key=key,
        title=f"Double pendulum, from rest at {degrees:g}°",
        stop=10.0,
        bodies=bodies,
        joints=_rods(["P1", "P2"]),
        watch=(("P1", O), ("P2", O)),
        data={"angle": math.radians(degrees), "length": 1.0, "mass": 1.0, "gravity": GRAVITY},
    )


def _rods(names: list[str]) -> tuple[Joint, ...]:
    pairs = zip([GROUND, *names], names, strict=False)
    return tuple(Joint(kind="distance", pair=pair) for pair in pairs)


def point_chain(n: int) -> Problem:
    """N points of 0.1 kg on rods of 0.1 m in space, straight, moving across, without gravity."""
    bodies = {
        f"P{i}": Body(
            mass=0.1,
            position=(0.1 * i, 0.0, 0.0),
            velocity=(0.0, 0.5 * math.sin(2 * math.pi * i / n), 0.0),
        )
        for i in range(1, n + 1)
    }
    return Problem(
        key=f"chain_{n}",
        title=f"Chain of {n} points",
        stop=1.0,
        gravity=O,
        bodies=bodies,
        joints=_rods(list(bodies)),
        watch=((f"P{n}", O), (f"P{(n + 1) // 2}", O)),
        planar=False,
        data={"count": n, "mass": 0.1, "length": 0.1},
    )


def _bar(a: Vector, b: Vector, mass: float, velocity: Vector = O, spin: float = 0.0) -> Body:
    """Uniform bar from a to b, its x axis along it."""
    along = [q - p for p, q in zip(a, b, strict=True)]
    moment = mass * (along[0] ** 2 + along[1] ** 2) / 12
    return Body(
        mass=mass,
        position=tuple(0.5 * (p + q) for p, q in zip(a, b, strict=True)),
        inertia=(moment, moment, moment),
        turn=(0.0, 0.0, math.atan2(along[1], along[0])),
        velocity=velocity,
        omega=(0.0, 0.0, spin),
    )


def planar_chain(n: int) -> Problem:
    """N hinged bars of 0.1 kg and 0.1 m, let go from the horizontal (`generate.rigid_chain`)."""
    names = [GROUND, *(f"link{i + 1}" for i in range(n))]
    pins = [(*pair, (0.1 * i, 0.0, 0.0)) for i, pair in enumerate(pairwise(names))]
    return Problem(
        key=f"planar_chain_{n}",
        title=f"Chain of {n} bars",
        stop=1.0,
        bodies={b: _bar(at, added(at, (0.1, 0.0, 0.0)), 0.1) for _, b, at in pins},
        joints=tuple(Joint(kind="revolute", pair=(a, b), position=at) for a, b, at in pins),
        watch=((names[n], (0.05, 0.0, 0.0)),),
    )


def elastic_pendulum(stiffness: float) -> Problem:
    """Two masses of 1 kg from the horizontal: on a spring of 1 m, and on a rod of 1 m behind it."""
    return Problem(
        key="elastic_pendulum",
        title="Elastic pendulum",
        stop=10.0,
        bodies={"A": Body(mass=1.0, position=X), "B": Body(mass=1.0, position=added(X, X))},
        joints=(Joint(kind="distance", pair=("A", "B")),),
        watch=(("B", O),),
        springs=(Spring(ends=((GROUND, O), ("A", O)), stiffness=stiffness, length=1.0),),
    )


def four_bar(n: int) -> Problem:
    """N loops of uniform unit bars on N + 1 cranks, upright, at 1 m/s (IFToMM A02)."""
    bodies = {f"crank{i}": _bar((i, 0, 0), (i, 1, 0), 1.0, (0.5, 0, 0), -1.0) for i in range(n + 1)}
    bodies |= {f"coupler{i}": _bar((i, 1, 0), (i + 1, 1, 0), 1.0, X) for i in range(n)}
    pins = [(GROUND, f"crank{i}", (i, 0, 0)) for i in range(n + 1)]
    for i in range(n):
        pins += [(f"crank{i}", f"coupler{i}", (i, 1, 0))]
        pins += [(f"coupler{i}", f"crank{i + 1}", (i + 1, 1, 0))]
    return Problem(
        key=f"four_bar_{n}",
        title=f"Four-bar with {n} loops (IFToMM A02)",
        stop=10.0,
        bodies=bodies,
        joints=tuple(Joint(kind="revolute", pair=(a, b), position=at) for a, b, at in pins),
        watch=tuple((f"crank{i}", (0.5, 0, 0)) for i in (0, n)),
        data={"loops": n, "gravity": GRAVITY},
    )


def hanging_chain(n: int = 10, damping: float = 0.5) -> Problem:
    """N uniform bars in a half circle between two nails, 1 kg, with a damper in the middle."""
    turns = [math.pi * i / n for i in range(n + 1)]
    nodes = [(-math.cos(a), -math.sin(a), 0.0) for a in turns]
    nodes[0], nodes[n] = (-1.0, 0.0, 0.0), X
    length = 2 * math.sin(0.5 * math.pi / n)
    bodies = {f"link{i + 1}": _bar(nodes[i], nodes[i + 1], 1.0 / n) for i in range(n)}
    names = [GROUND, *bodies, GROUND]
    middle: Place = (f"link{n // 2}", (0.5 * length, 0.0, 0.0))
    return Problem(
        key="hanging_chain",
        title=f"Hanging chain of {n} bars with a damper",
        stop=2.0,
        bodies=bodies,
        joints=tuple(
            Joint(kind="revolute", pair=(names[i], names[i + 1]), position=nodes[i])
            for i in range(n + 1)
        ),
        watch=(middle, ("link2", (0.5 * length, 0.0, 0.0))),
        springs=(Spring(ends=((GROUND, (0.0, -2.0, 0.0)), middle), damping=damping),),
        conserves=False,
        data={"count": n, "mass": 1.0 / n, "gravity": GRAVITY, "damping": damping},
    )


# ------------------------------------------------------------------------------- planar machines


def _turned(angle: float, place: Vector) -> Vector:
    c, s = math.cos(angle), math.sin(angle)
    return (c * place[0] - s * place[1], s * place[0] + c * place[1], 0.0)


ANDREWS = {
    "m1": 0.04325, "m2": 0.00365, "m3": 0.02373, "m4": 0.00706, "m5": 0.07050, "m6": 0.00706,
    "m7": 0.05498, "i1": 2.194e-6, "i2": 4.410e-7, "i3": 5.255e-6, "i4": 5.667e-7, "i5": 1.169e-5,
    "i6": 5.667e-7, "i7": 1.912e-5, "xa": -0.06934, "ya": -0.00227, "xb": -0.03635, "yb": 0.03273,
    "xc": 0.014, "yc": 0.072, "c0": 4530.0, "l0": 0.07785, "d": 0.028, "da": 0.0115, "e": 0.02,
    "ea": 0.01421, "rr": 0.007, "ra": 0.00092, "ss": 0.035, "sa": 0.01874, "sb": 0.01043,
    "sc": 0.018, "sd": 0.02, "ta": 0.02308, "tb": 0.00916, "u": 0.04, "ua": 0.01228, "ub": -0.00449,
    "zf": 0.02, "zt": 0.04, "fa": 0.01421, "torque": 0.033, "beta": -0.0617138900142764496,
}  # fmt: skip
"""Of the Test Set for IVP Solvers (Mazzia & Magherini, 2008), part II.3, with its names."""


def andrews() -> Problem:
    """Andrews' squeezing mechanism; bodies K1 to K7 as in the test set."""
    k = ANDREWS
    gamma, phi = 0.455279819163070380, 0.222668390165885885
    delta, epsilon, half = 0.487364979543842550, 1.23054744454982119, math.pi / 2
    A, B = (k["xa"], k["ya"], 0.0), (k["xb"], k["yb"], 0.0)
    upper = added(A, _turned(delta, (k["zt"], 0)))
    lower = added(A, _turned(epsilon - half, (k["u"], 0)))
    tip = _turned(k["beta"], (k["rr"], 0))
    rows = (
        (O, k["beta"], (k["ra"], 0)),
        (tip, k["beta"] + math.pi, (k["da"], 0)),
        (B, gamma - half, (k["sa"], k["sb"])),
        (upper, phi + delta - half, (k["e"] - k["ea"], 0)),
        (A, delta, (k["ta"], k["tb"])),
        (lower, epsilon - phi, (k["zf"] - k["fa"], 0)),
        (A, epsilon - half, (k["ua"], k["ub"])),
    )
    bodies = {f"K{i}": _squeezer_body(i, *row) for i, row in enumerate(rows, start=1)}
    pin = added(tip, _turned(k["beta"] + math.pi, (k["d"], 0)))
    pins = [(GROUND, "K1", O), (GROUND, "K3", B), (GROUND, "K5", A), (GROUND, "K7", A)]
    pins += [("K1", "K2", tip), ("K5", "K4", upper), ("K7", "K6", lower)]
    pins += [("K2", name, pin) for name in ("K3", "K4", "K6")]
    return Problem(
        key="andrews",
        title="Andrews' squeezer",
        stop=0.03,
        gravity=O,
        bodies=bodies,
        joints=tuple(Joint(kind="revolute", pair=(a, b), position=at) for a, b, at in pins),
        watch=(("K1", (k["rr"] - k["ra"], 0, 0)), ("K2", (k["d"] - k["da"], 0, 0))),
        springs=(_squeezer_spring(k),),
        torque=("K1", k["torque"]),
        conserves=False,
        data=k,
    )


def _squeezer_body(i: int, at: Vector, angle: float, com: Vector) -> Body:
    return Body(
        mass=ANDREWS[f"m{i}"],
        position=added(at, _turned(angle, com)),
        inertia=(ANDREWS[f"i{i}"],) * 3,
        turn=(0.0, 0.0, angle),
    )


def _squeezer_spring(k: dict[str, float]) -> Spring:
    eye = (k["sc"] - k["sa"], k["sd"] - k["sb"], 0.0)
    ends: tuple[Place, Place] = (("K3", eye), (GROUND, (k["xc"], k["yc"], 0.0)))
    return Spring(ends=ends, stiffness=k["c0"], length=k["l0"])


CAR_AXIS = {
    "mass": 5e-4, "length": 1.0, "free_length": 0.5, "wave": 0.1, "omega": 10.0, "stiffness": 1.0,
    "gravity": 1.0,
}  # fmt: skip
"""Of the same test set, part II.5; the mass is M eps^2/2."""


def car_axis() -> Problem:
    """Chassis bar on two springs; its left end A moves across the axle, B follows at a distance.

    The axle turns about the origin by asin(r sin(omega t)/L): `data` says how, no body does.
    """
    ends = {"A": (0.0, 0.5, 0.0), "B": (1.0, 0.5, 0.0)}
    bodies = {n: Body(mass=5e-4, position=p, velocity=(-0.5, 0, 0)) for n, p in ends.items()}
    return Problem(
        key="car_axis",
        title="Car axis",
        stop=3.0,
        gravity=(0.0, -CAR_AXIS["gravity"], 0.0),
        bodies=bodies,
        joints=(Joint(kind="distance", pair=("A", "B")),),
        watch=(("A", O), ("B", O)),
        conserves=False,
        data=CAR_AXIS,
    )


PROBLEMS: dict[str, Callable[[], Problem]] = {
    "double_pendulum_30": lambda: double_pendulum("double_pendulum_30", 30.0),
    "double_pendulum_90": lambda: double_pendulum("double_pendulum_90", 90.0),
    "four_bar_2": lambda: four_bar(2),
    "four_bar_40": lambda: four_bar(40),
    "andrews": andrews,
    "bricard": bricard,
    "heavy_top": heavy_top,
    "car_axis": car_axis,
    "chain_10": lambda: point_chain(10),
    "chain_100": lambda: point_chain(100),
    "chain_1000": lambda: point_chain(1000),
    "hanging_chain": hanging_chain,
    "governor": governor,
    "rigid_chain_10": lambda: rigid_chain(10),
    "rigid_chain_100": lambda: rigid_chain(100),
    "stewart": stewart,
    "double_wishbone": double_wishbone,
    "net_30": lambda: net(30),
}
"""By key, in the order of the page."""
MAPS: dict[str, Callable[..., Problem]] = {
    "chain": lambda n: point_chain(int(n)),
    "four-bar": lambda: four_bar(2),
    "bricard": bricard,
    "stiff spring": elastic_pendulum,
}
"""Those of the stability maps, by the names of their cases."""
