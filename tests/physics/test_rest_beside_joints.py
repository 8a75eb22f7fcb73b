"""Contacts rest beside joints while some forces hold: of joints any, of contacts in their cones.

Whether there are such forces a linear program tells, with cones of many sides in space. Joints hold
most of what contacts hold, often several times, and rub by a preload, which needs no force.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.optimize import linprog

from tests.physics.test_contact_rest import G, run, way

Array = NDArray[np.float64]
ABOVE, BELOW = 1 + 1e-6, 1 - 1e-6
SIDES = 48
"""Of a cone in space; the polygon inside it must hold, or that around it must not."""
AT_HAND = 1e7
"""Largest force [N]: less than what the solver still takes for one."""

FREE = {
    "spherical": "xyz", "revolute": "xyzbc", "prismatic": "yzabc", "cylindrical": "yzbc",
}  # fmt: skip
"""Forces along the axis x and across it (y, z), torques about them (a, b, c), that joints hold."""


@dataclass
class Resting:
    """Bodies side by side, their joints and contacts, and the wrenches that these may bring."""

    random: np.random.Generator
    dimension: int
    bodies: list[str] = field(default_factory=list)
    joints: list[str] = field(default_factory=list)
    contacts: list[str] = field(default_factory=list)
    points: dict[int, list[str]] = field(default_factory=dict)
    forces: list[Array] = field(default_factory=list)
    """Wrenches of a unit force of joints, of any sign."""
    rubbing: list[tuple[Array, float]] = field(default_factory=list)
    """Likewise of their frictions, with the largest force."""
    feet: list[tuple[list[Array], float]] = field(default_factory=list)
    """Wrenches of the normal force and of frictions of each contact, and its coefficient."""

    def __post_init__(self) -> None:
        random, last = self.random, self.dimension - 1
        self.n = int(random.integers(1, 4 if last == 1 else 3))
        self.place = random.uniform(-0.1, 0.3, (self.n, 3)) + np.outer(np.arange(self.n), [1, 0, 0])
        self.place += [20.0, 5.0, -7.0] if random.random() < 0.3 else [0.0, 0.0, 0.0]
        self.place[:, self.dimension :] = 0.0
        self.mass = random.uniform(0.5, 2.0, self.n)
        self.force, self.torque = (
            random.uniform(-3, 3, (self.n, 3)),
            random.uniform(-0.4, 0.4, (self.n, 3)),
        )
        self.force[:, last:] = 0.0
        if last == 1:
            self.torque[:, :2] = 0.0
        for i in range(int(random.integers(1, 5))):
            self.add_foot(f"p{i}")
        for i in range(int(random.integers(1, 4))):
            self.add_joint(f"j{i}")

    def wrench(self, body: int, place: Array, force: Array, torque: Array) -> Array:
        """Forces and torques on all bodies."""
        x = np.zeros((self.n, 6))
        x[body] = *force, *(np.cross(place - self.place[body], force) + torque)
        return x.ravel()

    def vector(self, x: Array) -> object:
        return x[: self.dimension].tolist()

    def frame(self, axis: Array) -> list[Array]:
        """Return the axis of size 1 and two across it, in the plane one in it and its normal."""
        if self.dimension == 2:
            axis[2] = 0.0
        axis = axis / np.linalg.norm(axis)
        across = np.cross([0.3, -0.2, 1.0] if self.dimension == 3 else [0.0, 0.0, 1.0], axis)
        across /= np.linalg.norm(across)
        return [axis, across, np.cross(axis, across)]

    def add_foot(self, name: str) -> None:
        random, last = self.random, self.dimension - 1
        body, friction = int(random.integers(self.n)), float(random.uniform(0.1, 0.9))
        offset = random.uniform(-0.4, 0.4, 3)
        offset[last], offset[self.dimension :] = -random.uniform(0.05, 0.4), 0.0
        normal = random.uniform(-0.7, 0.7, 3)
        normal[last] = 1.0
        axes = self.frame(normal)
        place = self.place[body] + offset
        self.points.setdefault(body, []).append(f"{name} = {self.vector(offset)}")
        self.contacts.append(
            f'{name} = {{ type = "plane", point = "b{body}.{name}", axis = {self.vector(axes[0])}, '
            f"position = {self.vector(place)}, friction = {friction!r} }}"
        )
        wrenches = [self.wrench(body, place, axis, np.zeros(3)) for axis in axes]
        self.feet.append((wrenches[: self.dimension], friction))

    def add_joint(self, name: str) -> None:
        random, flat = self.random, self.dimension == 2
        body = int(random.integers(self.n))
        other = -1 if random.random() < 0.6 else int(random.integers(self.n))
        other = -1 if other == body else other
        kind = str(
            random.choice(
                ["revolute", "prismatic", *([] if flat else ["spherical", "cylindrical"])]
            )
        )
        place = self.place[body] + random.uniform(-0.5, 0.5, 3)
        axes = self.frame(random.normal(size=3))
        if flat:
            place[2] = 0.0
        if flat and kind == "revolute":
            axes = [axes[2], axes[0], axes[1]]
        preload = float(random.uniform(0.05, 1.0)) if random.random() < 0.4 else 0.0

        def both(letter: str) -> Array:
            k, zero = "xyzabc".index(letter), np.zeros(3)
            pair = (axes[k % 3], zero) if k < 3 else (zero, axes[k % 3])
            x = self.wrench(body, place, *pair)
            return x if other < 0 else x - self.wrench(other, place, *pair)

        self.forces += [both(letter) for letter in FREE[kind]]
        parent = "ground" if other < 0 else f"b{other}"
        text = f'type = "{kind}", bodies = ["{parent}", "b{body}"], position = {self.vector(place)}'
        if kind != "spherical" and not (flat and kind == "revolute"):
            text += f", axis = {self.vector(axes[0])}"
        if preload and kind in ("revolute", "prismatic"):
            radius = ", radius = 0.1" if kind == "revolute" else ""
            text += f", friction = {{ preload = {preload!r}{radius} }}"
            self.rubbing.append((both("a" if kind == "revolute" else "x"), preload))
        self.joints.append(f"{name} = {{ {text} }}")

    def text(self) -> str:
        last = self.dimension - 1
        bodies, loads = "", ""
        for k in range(self.n):
            points = ", ".join(self.points.get(k, []))
            inertia = "0.05" if last == 1 else "[0.05, 0.06, 0.04]"
            bodies += (
                f"b{k} = {{ position = {self.vector(self.place[k])}, inertia = {inertia}, "
                f"mass = {float(self.mass[k])!r}, points = {{ {points} }} }}\n"
            )
            torque = float(self.torque[k, 2]) if last == 1 else self.torque[k].tolist()
            loads += f'm{k} = {{ type = "torque", body = "b{k}", value = {torque} }}\n'
            force = self.vector(self.force[k])
            loads += f'f{k} = {{ type = "force", point = "b{k}", value = {force} }}\n'
        down = [0.0] * last + [-G]
        return (
            f'name = "rest"\ndimension = {self.dimension}\ngravity = {down}\n[bodies]\n{bodies}'
            f"[joints]\n{chr(10).join(self.joints)}\n[forces]\n{loads}"
            f"[contacts]\n{chr(10).join(self.contacts)}\n"
        )

    def holds(self, factor: float, wide: float) -> bool:
        """Whether forces hold with this factor of frictions, and with cones this much wider."""
        columns = [*self.forces]
        bounds: list[tuple[float, float]] = [(-math.inf, math.inf)] * len(self.forces)
        for wrench, most in self.rubbing:
            columns.append(wrench)
            bounds.append((-factor * most, factor * most))
        angles = 2 * math.pi * np.arange(SIDES) / SIDES
        for (normal, *across), friction in self.feet:
            ways = [(1.0,), (-1.0,)]
            if self.dimension == 3:
                ways = [(wide * math.cos(a), wide * math.sin(a)) for a in angles]
            for ahead in ways:
                along = sum(x * y for x, y in zip(ahead, across, strict=True))
                columns.append(normal + factor * friction * along)
                bounds.append((0.0, AT_HAND))
        load = np.zeros((self.n, 6))
        load[:, :3], load[:, 3:] = self.force, self.torque
        load[:, self.dimension - 1] -= G * self.mass
        matrix = np.array(columns).T
        rows = np.tile([self.dimension == 3 or k in (0, 1, 5) for k in range(6)], self.n)
        found = linprog(
            np.zeros(len(bounds)), A_eq=matrix[rows], b_eq=-load.ravel()[rows], bounds=bounds
        )
        return found.status == 0


def check(dimension: int, seed: int) -> None:
    bodies = Resting(np.random.default_rng(seed), dimension)
    wide = 1.0 / math.cos(math.pi / SIDES)
    expected = bodies.holds(BELOW, 1.0)
    assert bodies.holds(ABOVE, wide) == expected
    found = run(bodies.text(), stop=0.05)
    places = [f"b{k}.{axis}" for k in range(bodies.n) for axis in "xyz"[:dimension]]
    rests = way(found, *places) < 1e-11 and found["energy.kinetic"].max() < 1e-20
    assert rests == expected
    if rests:
        assert found["solver.events"].sum() == 0
        modes = [name for name in found.names if name.endswith("mode")]
        assert all((found[name] != 2).all() for name in modes)


@pytest.mark.parametrize("seed", [*range(40, 52), 69, 84, 142, 200])
def test_planar_bodies_beside_joints_rest_where_a_linear_program_finds_forces(seed):
    check(2, seed)


@pytest.mark.parametrize("seed", [*range(10), 21, 37, 42, 48, 49, 51])
def test_bodies_in_space_beside_joints_rest_where_a_linear_program_finds_forces(seed):
    check(3, seed)


TIP_ON_A_HINGE = f"""name = "tip"
gravity = [2, 0, {-G}]
[bodies.b]
position = [0.3, 0, 0]
mass = 1
inertia = [0.03, 0.02, 0.02]
points = {{ tip = [0.3, 0, 0] }}
[joints]
j = {{ type = "revolute", bodies = ["ground", "b"], axis = [0, 1, 0], position = [0, 0, 0] }}
[contacts]
c = {{ type = "plane", point = "b.tip", axis = [0, 0, 1], friction = 0.1 }}
"""


def test_a_hinge_holds_a_tip_along_the_floor_and_the_floor_half_of_its_weight():
    found = run(TIP_ON_A_HINGE)
    assert (found["c.mode"] == 1).all()
    assert found["solver.events"].sum() == 0
    assert found["c.force"] == pytest.approx(G / 2, rel=1e-12)
    assert abs(found["c.friction"]).max() < 1e-12


def slider(axis: Array, friction: float) -> str:
    """1 kg far out on a guide without friction, whose tip stands on a floor."""
    return f"""name = "slider"
gravity = [0, 0, {-G}]
[bodies.b]
position = [20, 0, 0]
mass = 1
inertia = [0.03, 0.01, 0.02]
points = {{ tip = [0.3, 0, 0] }}
[joints]
j = {{ type = "prismatic", bodies = ["ground", "b"], axis = {axis.tolist()} }}
[contacts]
c = {{ type = "plane", point = "b.tip", axis = [0, 0, 1], friction = {friction!r} }}
"""


@pytest.mark.parametrize("friction", [0.0, 0.3, 0.9])
def test_a_slider_on_a_guide_presses_a_floor_by_as_little_as_holds_it(friction):
    # Along the guide, s below the horizontal: G s = N s + T c, and T = friction N is the most.
    axis = np.array([0.5, 0.8, -0.3])
    sine = 0.3 / float(np.linalg.norm(axis))
    cosine = math.sqrt(1.0 - sine**2)
    found = run(slider(axis, friction))
    assert found["solver.events"].sum() == 0
    assert way(found, "b.x", "b.y", "b.z") < 1e-12
    assert friction == 0.0 or (found["c.mode"] == 1).all()
    most = min(friction, cosine / sine)
    assert found["c.force"] == pytest.approx(G * sine / (sine + most * cosine), rel=1e-6)


class Rail:
    """A body on random feet and on a rail that rubs by the force which presses it, of any sign."""

    def __init__(self, seed: int) -> None:
        random = np.random.default_rng(5_000_000 + seed)
        self.feet, points, contacts = [], [], []
        for i in range(int(random.integers(1, 5))):
            place = np.array([random.uniform(-0.5, 0.5), -random.uniform(0.05, 0.4)])
            angle = random.uniform(-0.6, 0.6)
            normal = np.array([math.sin(angle), math.cos(angle)])
            friction = float(random.uniform(0.1, 0.9))
            points.append(f"p{i} = {place.tolist()}")
            contacts.append(
                f'p{i} = {{ type = "plane", point = "b.p{i}", axis = {normal.tolist()}, '
                f"position = {place.tolist()}, friction = {friction!r} }}"
            )
            self.feet.append((place, normal, friction))
        angle = random.uniform(-0.7, 0.7)
        self.axis, self.place = (
            np.array([math.cos(angle), math.sin(angle)]),
            random.uniform(-0.3, 0.3, 2),
        )
        self.friction, self.preload = random.uniform((0.05, 0.0), (0.5, 0.3)).tolist()
        self.push, self.turn = random.uniform((-9, -0.5), (9, 0.5)).tolist()
        self.text = f"""name = "rail"
dimension = 2
gravity = [{self.push!r}, {-G}]
[bodies]
b = {{ position = [0, 0], mass = 1, inertia = 0.05, points = {{ {", ".join(points)} }} }}
[joints.j]
type = "prismatic"
bodies = ["ground", "b"]
axis = {self.axis.tolist()}
position = {self.place.tolist()}
friction = {{ coefficient = {self.friction!r}, preload = {self.preload!r} }}
[forces]
turn = {{ type = "torque", body = "b", value = {self.turn!r} }}
[contacts]
{chr(10).join(contacts)}
"""

    def holds(self, factor: float, sign: float) -> bool:
        """Whether forces hold whose force across the rail has this sign."""

        def wrench(place: Array, force: Array) -> list[float]:
            return [*force, place[0] * force[1] - place[1] * force[0]]

        columns = []
        for place, normal, friction in self.feet:
            along = factor * friction * np.array([normal[1], -normal[0]])
            columns += [wrench(place, normal + along), wrench(place, normal - along)]
        bounds = [(0.0, AT_HAND)] * (len(columns) + 1) + [(None, None)] * 2
        columns.append(wrench(self.place, sign * np.array([-self.axis[1], self.axis[0]])))
        columns += [[0.0, 0.0, 1.0], wrench(self.place, self.axis)]
        most = np.zeros((2, len(columns)))
        most[:, -3], most[:, -1] = -factor * self.friction, [1.0, -1.0]
        found = linprog(
            np.zeros(len(columns)),
            A_eq=np.array(columns).T, b_eq=[-self.push, G, -self.turn],
            A_ub=most, b_ub=[factor * self.preload] * 2, bounds=bounds,
        )  # fmt: skip
        return found.status == 0


@pytest.mark.parametrize("seed", [0, 1, 2, 3, 18, 50, 54, 91, 104, 149, 288, 357, 366])
def test_feet_may_press_a_rail_to_its_other_side_to_hold(seed):
    rail = Rail(seed)
    signs = (1.0, -1.0)
    expected = any(rail.holds(BELOW, sign) for sign in signs)
    assert expected == any(rail.holds(ABOVE, sign) for sign in signs)
    found = run(rail.text, stop=0.05)
    assert (way(found, "b.x", "b.y", "b.angle") < 1e-11) == expected
    if expected:
        assert found["solver.events"].sum() == 0
        modes = [name for name in found.names if name.endswith("mode")]
        assert all((found[name] != 2).all() for name in modes)
