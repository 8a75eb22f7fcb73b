"""Problems with contacts whose motion is known, each listed once, as contents of scenes."""

from __future__ import annotations

import json
import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from tests.support.mechanisms.problems import GRAVITY, Content, mechanism

ORIGIN = {"position": [0.0, 0.0], "fixed": True}


def toml_of(content: Content) -> str:
    """Text of a content as a scene file: keys of JSON strings, one table to a line."""

    def inline(value: Any) -> str:
        if isinstance(value, dict):
            return "{" + ", ".join(f"{json.dumps(k)} = {inline(x)}" for k, x in value.items()) + "}"
        return json.dumps(value)

    return "".join(f"{key} = {inline(value)}\n" for key, value in content.items())


def ball(
    height: float = 1.0, restitution: float | str = 0.8, speed: float = 0.0, **more: Any
) -> Content:
    """Point that falls on the ground from a height; `speed` [m/s] is upwards."""
    return mechanism(
        "ball",
        2,
        points={"p": {"mass": 1.0, "position": [0.0, height], "velocity": [0.0, speed]}},
        contacts={
            "floor": {"type": "plane", "point": "p", "axis": [0, 1], "restitution": restitution}
        },
        **more,
    )


def circle(restitution: float, wall: str = "clearance") -> Content:
    """Point in a circle of radius 1, as a pin in its hole or at a rope."""
    walls = {
        "clearance": {"type": "clearance", "points": ["p", "o"], "radius": 1.0},
        "rope": {"type": "stop", "points": ["o", "p"], "max": 1.0},
    }
    return mechanism(
        "circle",
        2,
        points={"o": ORIGIN, "p": {"mass": 1.0, "position": [0.3, 0.0], "velocity": [0.6, 0.8]}},
        contacts={"wall": walls[wall] | {"restitution": restitution}},
    )


def sphere_of_clearance(restitution: float) -> Content:
    """Likewise in a sphere, in a vertical plane at 0.7 rad from the x axis."""
    c, s = math.cos(0.7), math.sin(0.7)
    return mechanism(
        "sphere",
        3,
        points={
            "o": {"position": [0.0, 0.0, 0.0], "fixed": True},
            "p": {
                "mass": 1.0,
                "position": [0.3 * c, 0.3 * s, 0.0],
                "velocity": [0.6 * c, 0.6 * s, 0.8],
            },
        },
        contacts={
            "wall": {
                "type": "clearance",
                "points": ["p", "o"],
                "radius": 1.0,
                "restitution": restitution,
            }
        },
    )


def pendulum_at_a_stop(dimension: int = 2) -> Content:
    """Body that swings as a point at 1 m, let go at 1 rad; stop at -0.3 rad from hanging, e = 0.7.

    Its centre is at 0.5 m and its inertia about it 0.25 kg m2: inertia over moment is 1 m.
    """
    x, y = 0.5 * math.sin(1.0), -0.5 * math.cos(1.0)
    inertia: Any = 0.25
    hinge: Content = {"type": "revolute", "bodies": ["ground", "bob"], "position": [0.0, 0.0]}
    centre = [x, y]
    if dimension == 3:
        inertia, centre = [0.2, 0.25, 0.3], [x, 0.0, y]
        hinge |= {"position": [0.0, 0.0, 0.0], "axis": [0, -1, 0]}
    return mechanism(
        "pendulum",
        dimension,
        bodies={"bob": {"mass": 1.0, "inertia": inertia, "position": centre}},
        joints={"hinge": hinge},
        contacts={"limit": {"type": "stop", "joint": "hinge", "min": -1.3, "restitution": 0.7}},
    )


def slider_crank_with_clearance(restitution: float = 0.9) -> Content:
    """Slider-crank of Flores with a worn wrist pin, without gravity; the crank turns freely."""
    crank, rod, speed = 0.05, 0.12, 100.0
    turning = -speed * crank / rod
    return mechanism(
        "slider_crank",
        2,
        gravity=False,
        bodies={
            "crank": {
                "mass": 0.30,
                "inertia": 1e-4,
                "position": [crank / 2, 0],
                "velocity": [0, speed * crank / 2],
                "angular_velocity": speed,
            },
            "rod": {
                "mass": 0.21,
                "inertia": 2.5e-4,
                "position": [crank + rod / 2, 0],
                "velocity": [0, speed * crank + turning * rod / 2],
                "angular_velocity": turning,
                "points": {"pin": [rod / 2, 0]},
            },
            "slider": {"mass": 0.14, "inertia": 1e-4, "position": [crank + rod, 0]},
        },
        joints={
            "base": {"type": "revolute", "bodies": ["ground", "crank"], "position": [0, 0]},
            "wrist": {"type": "revolute", "bodies": ["crank", "rod"], "position": [crank, 0]},
            "guide": {
                "type": "prismatic",
                "bodies": ["ground", "slider"],
                "position": [crank + rod, 0],
                "axis": [1, 0],
            },
        },
        contacts={
            "pin": {
                "type": "clearance",
                "points": ["rod.pin", "slider"],
                "radius": 0.5e-3,
                "restitution": restitution,
            }
        },
    )


def cradle(restitution: float, gaps: float = 0.0) -> Content:
    """Five equal balls in a row, `gaps` [m] apart; the first comes at 1 m/s from 0.9 m."""
    pitch = 0.1 + gaps
    return mechanism(
        "cradle",
        2,
        gravity=False,
        points={
            f"b{i}": {
                "mass": 1.0,
                "position": [pitch * i - (0.9 if i == 0 else 0.0), 0.0],
                "velocity": [1.0 if i == 0 else 0.0, 0.0],
            }
            for i in range(5)
        },
        contacts={
            f"c{i}": {
                "type": "sphere",
                "points": [f"b{i}", f"b{i + 1}"],
                "radii": [0.05, 0.05],
                "restitution": restitution,
            }
            for i in range(4)
        },
    )


def rod_that_falls(restitution: float = 0.0, speed: float = 0.0, fallen: float = 0.0) -> Content:
    """Uniform rod of 1 m and 1 kg, its centre 0.8 m high, 0.6 rad from the floor, mu = 0.2.

    It begins as it is after a part of its fall [s].
    """
    x, y = 0.5 * math.cos(0.6), 0.5 * math.sin(0.6)
    centre, velocity = 0.8 - 0.5 * GRAVITY * fallen**2, [speed, -GRAVITY * fallen]
    floor = {"type": "plane", "axis": [0, 1], "friction": 0.2}
    return mechanism(
        "rod",
        2,
        points={
            "a": {"mass": 0.0, "position": [-x, centre - y], "velocity": velocity},
            "b": {"mass": 0.0, "position": [x, centre + y], "velocity": velocity},
        },
        bodies={"rod": {"type": "bar", "points": ["a", "b"], "mass": 1.0}},
        contacts={
            "A": floor | {"point": "a", "restitution": restitution},
            "B": floor | {"point": "b"},
        },
    )


def rocking_block() -> Content:
    """Block of 0.2 m by 0.6 m, let go at rest on its right edge, at 0.2 rad; it cannot slide."""
    b, h, tilt = 0.1, 0.3, 0.2
    c, s = math.cos(tilt), math.sin(tilt)
    # Turned by -tilt about the edge (b, 0) of the block as it stands.
    centre = [b - b * c + h * s, b * s + h * c]
    floor = {"type": "plane", "axis": [0, 1], "friction": 5.0}
    return mechanism(
        "block",
        2,
        bodies={
            "block": {
                "mass": 1.0,
                "inertia": (b * b + h * h) / 3.0,
                "position": centre,
                "orientation": -tilt,
                "points": {"left": [-b, -h], "right": [b, -h]},
            }
        },
        contacts={
            "A": floor | {"point": "block.left"},
            "B": floor | {"point": "block.right"},
        },
    )


def slider(speed: float = 1.5, friction: float = 0.3, **more: Any) -> Content:
    """Point that slides on the ground."""
    return mechanism(
        "slider",
        2,
        points={"p": {"mass": 1.0, "position": [0.0, 0.0], "velocity": [speed, 0.0]}},
        contacts={"floor": {"type": "plane", "point": "p", "axis": [0, 1], "friction": friction}},
        **more,
    )


def incline(slope: float, friction: float, velocity: Sequence[float]) -> Content:
    """Point on an incline of a slope [rad], x up the incline; in space y is across it."""
    dim = len(velocity) + 1
    down = [-GRAVITY * math.sin(slope)] + [0.0] * (dim - 2) + [-GRAVITY * math.cos(slope)]
    floor = {"type": "plane", "point": "p", "axis": [0] * (dim - 1) + [1], "friction": friction}
    return mechanism(
        "incline",
        dim,
        points={"p": {"mass": 1.0, "position": [0.0] * dim, "velocity": [*velocity, 0.0]}},
        contacts={"floor": floor},
    ) | {"gravity": down}


def ball_on_a_strut(restitution: float = 0.7) -> Content:
    """Point of 1 kg below a spring of 20 N/m and a damper of 0.3 N s/m, let go 0.5 m above a floor.

    It would come to rest at 1.1 m - g/(20/s2), 0.11 m above the floor.
    """
    return mechanism(
        "strut",
        2,
        points={
            "o": {"position": [0.0, 2.0], "fixed": True},
            "p": {"mass": 1.0, "position": [0.0, 1.0]},
        },
        forces={
            "spring": {
                "type": "spring",
                "points": ["o", "p"],
                "stiffness": 20.0,
                "free_length": 0.9,
            },
            "damper": {"type": "damper", "points": ["o", "p"], "damping": 0.3},
        },
        contacts={
            "floor": {
                "type": "plane",
                "point": "p",
                "axis": [0, 1],
                "position": [0.0, 0.5],
                "restitution": restitution,
                "friction": 0.2,
            }
        },
    )


def belt(damping: float = 0.0) -> Content:
    """Block on a belt of 0.2 m/s, held by a spring of 100 N/m; mu = 0.3, static 0.5; 10 N.

    A damper [N s/m] may lie beside the spring.
    """
    damper = {"type": "damper", "points": ["o", "p"], "damping": damping}
    return mechanism(
        "belt",
        2,
        points={
            "o": {"position": [-1.0, 0.0], "fixed": True},
            "p": {"mass": 1.0, "position": [0.0, 0.0], "velocity": [0.2, 0.0]},
        },
        forces={
            "spring": {
                "type": "spring",
                "points": ["o", "p"],
                "stiffness": 100.0,
                "free_length": 1.0,
            },
            **({"damper": damper} if damping else {}),
        },
        contacts={
            "belt": {
                "type": "plane",
                "point": "p",
                "axis": [0, 1],
                "friction": 0.3,
                "static_friction": 0.5,
                "surface_velocity": [0.2, 0.0],
            }
        },
    ) | {"gravity": [0.0, -10.0]}


def bowling_disc() -> Content:
    """Disc of radius 0.25 m that slides at 3 m/s without turning, mu = 0.2."""
    return mechanism(
        "disc",
        2,
        bodies={
            "d": {"mass": 1.0, "inertia": 0.03125, "position": [0.0, 0.25], "velocity": [3.0, 0.0]}
        },
        contacts={
            "floor": {
                "type": "plane",
                "point": "d",
                "axis": [0, 1],
                "radius": 0.25,
                "friction": 0.2,
            }
        },
    )


def bowling_ball(direction: float = 0.0) -> Content:
    """Ball of radius 0.108 m that slides at 6 m/s without turning, mu = 0.15."""
    radius = 0.108
    inertia = 0.4 * radius**2
    return mechanism(
        "bowling",
        3,
        bodies={
            "b": {
                "mass": 1.0,
                "inertia": [inertia] * 3,
                "position": [0.0, 0.0, radius],
                "velocity": [6.0 * math.cos(direction), 6.0 * math.sin(direction), 0.0],
            }
        },
        contacts={
            "floor": {
                "type": "plane",
                "point": "b",
                "axis": [0, 0, 1],
                "radius": radius,
                "friction": 0.15,
            }
        },
    )


def cam() -> Content:
    """Flat follower of 0.5 kg, held down by 5 N and a spring, on a disc with its axis off centre.

    The disc of radius 50 mm turns at 80 rad/s about an axis 10 mm above its centre as drawn.
    """
    radius, eccentricity = 0.05, 0.01
    height = radius - eccentricity
    return mechanism(
        "cam",
        2,
        points={"seat": {"position": [0.0, height - 1.0], "fixed": True}},
        bodies={
            "disc": {"mass": 1.0, "inertia": 1e-3, "position": [0.0, -eccentricity]},
            "follower": {"mass": 0.5, "inertia": 1e-3, "position": [0.0, height]},
        },
        joints={
            "shaft": {"type": "revolute", "bodies": ["ground", "disc"], "position": [0.0, 0.0]},
            "guide": {
                "type": "prismatic",
                "bodies": ["ground", "follower"],
                "position": [0.0, height],
                "axis": [0, 1],
            },
        },
        drivers={"motor": {"type": "angle", "joint": "shaft", "value": "80*t"}},
        forces={
            "spring": {
                "type": "spring",
                "points": ["seat", "follower"],
                "stiffness": 800.0,
                "free_length": 1.0,
            },
            "weight": {"type": "force", "point": "follower", "value": [0.0, -5.0]},
        },
        contacts={
            "lifter": {
                "type": "plane",
                "point": "disc",
                "body": "follower",
                "axis": [0, -1],
                "position": [0.0, height],
                "radius": radius,
            }
        },
    )


def point_on_a_ball(angle: float = 0.1, rate: float = 0.3) -> Content:
    """Point that slides off the top of a smooth ball of radius 1 m, from an angle, at a rate."""
    c, s = math.cos(angle), math.sin(angle)
    return mechanism(
        "off_a_ball",
        2,
        points={
            "o": ORIGIN,
            "p": {"mass": 1.0, "position": [s, c], "velocity": [rate * c, -rate * s]},
        },
        contacts={"top": {"type": "sphere", "points": ["o", "p"], "radii": [1.0, 0.0]}},
    )


def two_on_a_spring(stiffness: float, friction: float, height: float) -> Content:
    """Two points that a spring joins fall on a plane in space, one of which rubs on it."""
    plane = {"type": "plane", "axis": [0, 0, 1]}
    return mechanism(
        "two",
        3,
        points={
            "a": {"mass": 0.6, "position": [0.2, 0.1, 0.27], "velocity": [0.7, 1.0, 0.0]},
            "b": {"mass": 1.6, "position": [0.07, 0.39, height], "velocity": [-0.9, 0.1, 0.3]},
        },
        forces={
            "spring": {
                "type": "spring",
                "points": ["a", "b"],
                "stiffness": stiffness,
                "free_length": 0.41,
            }
        },
        contacts={
            "A": plane | {"point": "a"},
            "B": plane | {"point": "b", "restitution": 0.5, "friction": friction},
        },
    )


def pile_of_discs(n: int, restitution: float = 0.3) -> Content:
    """Discs that fall into a box three of them wide, each of which may touch each other one."""
    radius, width, draw = 0.05, 0.31, np.random.default_rng(1)
    walls = {"floor": ([0, 1], 0.0), "left": ([1, 0], 0.0), "right": ([-1, 0], width)}
    points: Content = {}
    contacts: Content = {}
    for i in range(n):
        x = 0.055 + 0.1 * (i % 3) + 0.004 * float(draw.random())
        points[f"p{i}"] = {"mass": 0.1, "position": [x, 0.06 + 0.12 * (i // 3) + 0.03 * (i % 3)]}
        for name, (axis, place) in walls.items():
            contacts[f"{name}_{i}"] = {
                "type": "plane", "point": f"p{i}", "axis": axis, "position": [place, 0.0],
                "radius": radius, "restitution": restitution,
            }  # fmt: skip
        for j in range(i):
            contacts[f"pair_{i}_{j}"] = {
                "type": "sphere", "points": [f"p{i}", f"p{j}"], "radii": [radius, radius],
                "restitution": restitution,
            }  # fmt: skip
    return mechanism("pile", 2, points=points, contacts=contacts)


def chain_over_a_floor(n: int = 12) -> Content:
    """Hanging chain of points, let go, that falls on a floor with friction."""
    points: Content = {}
    x, z, length = 0.0, 0.05, 0.1
    for i in range(n):
        points[f"p{i}"] = {"mass": 0.1, "position": [x, z]}
        slope = 1.2 + 0.25 * math.sin(1.3 * i)
        x, z = x + length * math.cos(slope), z + length * math.sin(slope)
    joints = {f"r{i}": {"type": "distance", "points": [f"p{i}", f"p{i + 1}"]} for i in range(n - 1)}
    floor = {"type": "plane", "axis": [0, 1], "friction": 0.3}
    contacts = {f"c{i}": floor | {"point": f"p{i}"} for i in range(n)}
    return mechanism("chain", 2, points=points, joints=joints, contacts=contacts)


def painleve_rod(friction: float, slope: float) -> Content:
    """Rod whose lower end slides on a floor; with strong friction no forces, or several, obey."""
    x, y = 0.5 * math.cos(slope), 0.5 * math.sin(slope)
    ends = {"a": [-x, 0.0], "b": [x, 2.0 * y]}
    floor = {"type": "plane", "axis": [0, 1], "friction": friction}
    return mechanism(
        "rod",
        2,
        points={k: {"mass": 0.0, "position": p, "velocity": [2.0, 0.0]} for k, p in ends.items()},
        bodies={"rod": {"type": "bar", "points": ["a", "b"], "mass": 1.0}},
        contacts={f"at_{k}": floor | {"point": k} for k in ends},
    )
