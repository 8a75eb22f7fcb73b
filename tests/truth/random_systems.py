"""Random trees and loops of rigid bodies, and their scenes.

All frames are drawn with the axes of the ground, so that a scene says the same as a tree in joint
coordinates (tests/truth/random_reference.py).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Scene = dict[str, Any]

STOP = 0.5
HALF = 0.25
POINTS = 10
KINDS = ("tree", "fast", "stiff", "driven", "jumps", "loop", "gear", "rolling", "stop")
"""What a system has beside hinges, slides, springs, dampers and gravity."""
WAYS = ("in one run", "restarted", "from a saved state", "with a smooth input", "with new values")
"""How a run goes: see tests/truth/random_runs.py."""


@dataclass
class Link:
    """A body and the joint that carries it; places are those of the drawing, in global axes."""

    parent: int  # -1: the ground
    kind: str  # revolute or prismatic
    place: Array
    axis: Array
    centre: Array
    mass: float
    inertia: Array  # 3 x 3, global axes as drawn
    rate: float
    torque: str = "0"
    stiffness: float = 0.0
    free: float = 0.0
    damping: float = 0.0


@dataclass
class System:
    """A random mechanism: links in the order of their parents, and what ties them further."""

    seed: int
    kind: str
    planar: bool
    gravity: Array
    links: list[Link]
    driver: tuple[int, str] | None = None  # of a link, its angle or displacement over t
    gear: tuple[int, int, float] | None = None  # q[second] = ratio q[first]
    rods: list[tuple[int, Array, int, Array]] = field(
        default_factory=list
    )  # links, places as drawn
    stop: tuple[int, float, float] | None = None  # link, largest coordinate, restitution
    jumps: list[float] = field(default_factory=list)
    way: str = WAYS[0]
    changing: int | None = None  # link whose torque is an input or a parameter of the scene

    @property
    def name(self) -> str:
        """Name of the scene."""
        return f"random_{self.seed}_{self.kind}"


def drawn(seed: int) -> System:
    """Random system of a seed; the kinds take turns."""
    random = np.random.default_rng(seed)
    kind = KINDS[seed % len(KINDS)]
    planar = bool(random.random() < 0.5) or kind == "rolling"
    n = int(random.integers(1 if kind in ("tree", "fast", "jumps", "stop") else 2, 6))
    gravity = np.array([0, -9.81, 0]) if planar else random.normal(size=3) * 5
    links: list[Link] = []
    for i in range(n):
        links.append(_link(random, i, links, planar, kind))
    system = System(seed, kind, planar, gravity, links)
    _ties(random, system)
    _change(random, system, WAYS[seed % len(WAYS)])
    return system


def _change(random: np.random.Generator, system: System, way: str) -> None:
    """Let the torque of a link come from outside, as a parabola or as a value that jumps once."""
    driven = system.driver[0] if system.driver else -1
    free = [i for i, x in enumerate(system.links) if x.kind == "revolute" and i != driven]
    if system.kind in ("jumps", "stop", "rolling") or not free:
        way = way if way in WAYS[:3] else WAYS[0]
    system.way = way
    if way in WAYS[3:]:
        system.changing = free[0]
        a, b = (float(f"{x:.4f}") for x in random.uniform(-4, 4, 2))
        smooth = way == WAYS[3]
        system.links[free[0]].torque = f"{a}*t**2" if smooth else f"{a} if t < {HALF} else {b}"
        system.jumps = [] if smooth else [HALF]


def _link(
    random: np.random.Generator, i: int, links: Sequence[Link], planar: bool, kind: str
) -> Link:
    """Link i, whose parent is the ground, the link before or one that carries that.

    Links then come depth first, which Pinocchio's crba takes for granted and does not check.
    """
    before, ancestors = i - 1, [-1]
    while before >= 0:
        ancestors.append(before)
        before = links[before].parent
    parent = int(random.choice(ancestors))
    flat = np.array([1.0, 1.0, 0.0]) if planar else np.ones(3)
    start = links[parent].centre if parent >= 0 else np.zeros(3)
    place = start + random.uniform(-0.5, 0.5, 3) * flat
    centre = place + random.uniform(-0.4, 0.4, 3) * flat
    slides = bool(random.random() < 0.2) and kind not in ("gear", "rolling")
    axis = random.normal(size=3)
    axis /= np.linalg.norm(axis)
    if planar:
        axis = np.array([axis[0], axis[1], 0.0]) if slides else np.array([0.0, 0.0, 1.0])
        axis /= np.linalg.norm(axis)
    mass = float(10 ** random.uniform(-1, 1))
    moments = random.uniform(0.3, 1.0, 3)
    moments *= min(1.0, 0.99 * (moments.sum() - moments.max()) / moments.max())
    moments = np.sort(moments) + moments.max() * np.array([0.5, 0.5, 0.5])
    Q, _ = np.linalg.qr(random.normal(size=(3, 3)))
    inertia = mass * 0.05 * Q @ np.diag(moments) @ Q.T
    if planar:
        inertia = np.diag(np.diag(inertia))
    fast = 40.0 if kind == "fast" and not slides else 2.0
    link = Link(
        parent, "prismatic" if slides else "revolute", place, axis, centre, mass, inertia,
        float(random.normal() * fast),
    )  # fmt: skip
    if random.random() < 0.5 or kind == "stiff":
        scale = 400.0 if kind == "stiff" else 10.0
        if not slides:
            link.stiffness = float(random.uniform(0.2, 1.0) * scale)
            link.free = float(random.uniform(-0.5, 0.5))
            link.damping = float(random.uniform(0, 0.02) * scale)
    if not slides:
        size, w = random.uniform(-3, 3), random.uniform(1, 15)
        link.torque = f"{size:.6g}*sin({w:.6g}*t)"
    return link


def _ties(random: np.random.Generator, system: System) -> None:
    """Drivers, gears, rods, stops and jumps of the system's kind."""
    links, kind = system.links, system.kind
    turning = [i for i, x in enumerate(links) if x.kind == "revolute"]
    if kind == "driven":
        i = int(random.integers(len(links)))
        size, w, rate = random.uniform(0.2, 1.0), random.uniform(2, 8), random.uniform(-2, 2)
        system.driver = (i, f"{rate:.6g}*t + {size:.6g}*sin({w:.6g}*t)**2")
        links[i].rate = float(f"{rate:.6g}")
        links[i].torque = "0"
    elif kind == "jumps":
        time = float(f"{random.uniform(0.05, 0.45):.4f}")
        system.jumps = [time]
        for i in turning[:1]:
            a, b = random.uniform(-4, 4, 2)
            links[i].torque = f"{a:.6g} if t < {time} else {b:.6g}"
    elif kind in ("gear", "rolling"):
        i, k = turning[0], turning[1]
        ratio = float(f"{random.choice([-1, 1]) * random.uniform(0.3, 3):.4g}")
        system.gear = (i, k, ratio)
        links[k].rate = ratio * links[i].rate
        if kind == "rolling":
            _wheel(random, system)
    elif kind == "loop":
        _rod(random, system)
    elif kind == "stop":
        link = links[0]
        link.rate = abs(link.rate) + 1.0
        system.stop = (
            0,
            float(f"{random.uniform(0.1, 0.4):.4f}"),
            float(random.choice([0.3, 0.8, 1.0])),
        )


def _wheel(random: np.random.Generator, system: System) -> None:
    """Make the first two links a wheel that rolls along x: its slide and its turning."""
    radius = float(f"{random.uniform(0.1, 0.4):.4f}")
    axle = np.array([0.0, radius, 0.0])
    slide, wheel = system.links[:2]
    slide.parent, slide.kind, slide.place, slide.axis = -1, "prismatic", axle, np.array([1.0, 0, 0])
    slide.centre = axle
    for link in (slide, wheel):
        link.torque, link.stiffness, link.damping = "0", 0.0, 0.0
    wheel.parent, wheel.place, wheel.centre, wheel.kind = 0, axle, axle, "revolute"
    wheel.axis = np.array([0.0, 0, 1])
    system.gear = (1, 0, -radius)
    slide.mass = slide.inertia[2, 2] = 0.0
    slide.inertia = np.zeros((3, 3))
    slide.rate = -radius * wheel.rate
    for link in system.links[2:]:
        link.parent = max(link.parent, 1) if link.parent >= 0 else -1


def _rod(random: np.random.Generator, system: System) -> None:
    """Tie two links, or one and the ground, by a rod; rates that the rod allows."""
    links = system.links
    flat = np.array([1.0, 1.0, 0.0]) if system.planar else np.ones(3)
    first = len(links) - 1
    second = int(random.integers(-1, first))
    a = links[first].centre + random.uniform(-0.3, 0.3, 3) * flat
    start = links[second].centre if second >= 0 else np.zeros(3)
    b = start + random.uniform(-0.3, 0.3, 3) * flat + 0.4 * flat
    system.rods.append((first, a, second, b))


# ---------------------------------------------------------------------------------------- the scene


def scene_of(system: System, rates: Sequence[tuple[Array, Array]]) -> Scene:
    """Tables of the scene; `rates` are the velocities and angular velocities (3,) of the bodies."""
    cut = 2 if system.planar else 3

    def vector(x: Array) -> list[float]:
        return [float(v) for v in x[:cut]]

    bodies: Scene = {}
    joints: Scene = {}
    forces: Scene = {}
    drivers: Scene = {}
    rolls = system.kind == "rolling"
    for i, link in enumerate(system.links):
        if rolls and i == 0:
            continue
        velocity, omega = rates[i]
        bodies[f"b{i}"] = {
            "position": vector(link.centre),
            "mass": link.mass,
            "inertia": float(link.inertia[2, 2]) if system.planar else link.inertia.tolist(),
            "velocity": vector(velocity),
            "angular_velocity": float(omega[2]) if system.planar else vector(omega),
        }
        parent = "ground" if link.parent < 0 else f"b{link.parent}"
        if rolls and i == 1:
            radius = -system.gear[2] if system.gear else 0.0
            joints["wheel"] = {"type": "rolling", "body": "b1", "radius": radius}
            continue
        joint: Scene = {
            "type": link.kind,
            "bodies": [parent, f"b{i}"],
            "position": vector(link.place),
        }
        if not (system.planar and link.kind == "revolute"):
            joint["axis"] = vector(link.axis)
        joints[f"j{i}"] = joint
        if link.torque != "0":
            value = "u" if i == system.changing else link.torque
            forces[f"m{i}"] = {"type": "joint_torque", "joint": f"j{i}", "value": value}
        if link.stiffness:
            forces[f"s{i}"] = {
                "type": "torsion_spring", "joint": f"j{i}",
                "stiffness": link.stiffness, "free_angle": link.free,
            }  # fmt: skip
        if link.damping:
            forces[f"d{i}"] = {
                "type": "torsion_damper", "joint": f"j{i}", "damping": link.damping,
            }  # fmt: skip
    if system.driver:
        i, value = system.driver
        of = "angle" if system.links[i].kind == "revolute" else "displacement"
        drivers["drive"] = {"type": of, "joint": f"j{i}", "value": value}
    if system.gear and not rolls:
        i, k, ratio = system.gear
        joints["gear"] = {"type": "gear", "joints": [f"j{i}", f"j{k}"], "ratio": ratio}
    for i, (first, a, second, b) in enumerate(system.rods):
        ends = [f"b{first}", f"b{second}" if second >= 0 else "ground"]
        joints[f"rod{i}"] = {"type": "distance", "points": ends, "at": [vector(a), vector(b)]}
    contacts: Scene = {}
    if system.stop:
        i, largest, restitution = system.stop
        contacts["bump"] = {
            "type": "stop", "joint": f"j{i}", "max": largest, "restitution": restitution,
        }  # fmt: skip
    tables = {"bodies": bodies, "joints": joints, "forces": forces, "drivers": drivers}
    tables["contacts"] = contacts
    if system.way == WAYS[3]:
        tables["inputs"] = {"u": {"interpolation": "smooth"}}
    if system.way == WAYS[4]:
        start = float(system.links[system.changing or 0].torque.split()[0])
        tables["parameters"] = {"u": {"value": start, "variability": "tunable"}}
    return {
        "name": system.name,
        "dimension": cut,
        "gravity": vector(system.gravity),
        **{name: table for name, table in tables.items() if table},
    }
