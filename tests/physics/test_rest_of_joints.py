"""Joints that rub and contacts that slide hold together with what sticks: by hand and by LP."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.optimize import linprog

from tests.physics.test_contact_rest import PLANE, G, run, way

ABOVE, BELOW = 1 + 1e-6, 1 - 1e-6


def drawer(push: float) -> str:
    """Two rails that press with half of 2 kg each: 0.1 and 0.5 of it hold 0.6 of the weight/2."""
    rails = "\n".join(
        f'r{i} = {{ type = "prismatic", bodies = ["ground", "b"], axis = [1, 0], '
        f"position = [0, {y}], friction = {{ coefficient = {c} }} }}"
        for i, (y, c) in enumerate([(0.1, 0.1), (-0.1, 0.5)])
    )
    return f"""{PLANE}gravity = [0, {-G!r}]
[bodies]
b = {{ position = [0, 0], mass = 2, inertia = 0.1 }}
[joints]
{rails}
[forces]
f = {{ type = "force", point = "b", value = [{push!r}, 0] }}
"""


def turned(kind: str, axis: str, places: list, radii: list, body: str, torque: list) -> str:
    """A body in two joints, both of coefficient 0.3, under a torque."""
    of_axis = "" if kind == "spherical" else f"axis = {axis}, "
    joints = "\n".join(
        f'r{i} = {{ type = "{kind}", bodies = ["ground", "b"], {of_axis}position = {place}, '
        f"friction = {{ coefficient = 0.3, radius = {radius} }} }}"
        for i, (place, radius) in enumerate(zip(places, radii, strict=True))
    )
    return f"""name = "turned"
gravity = [0, 0, {-G!r}]
[bodies]
b = {{ {body} }}
[joints]
{joints}
[forces]
f = {{ type = "torque", body = "b", value = {torque} }}
"""


def shaft(torque: float) -> str:
    """2 kg in the middle of two bearings of unlike radii."""
    body = "position = [0, 0, 0], mass = 2, inertia = [0.1, 0.1, 0.1]"
    places = [[-0.5, 0, 0], [0.5, 0, 0]]
    return turned("revolute", "[1, 0, 0]", places, [0.05, 0.02], body, [torque, 0, 0])


def door(torque: float) -> str:
    """20 kg, 0.4 m from two balls 1 m apart: each carries half of it, and 0.4 of it across.

    Frictions t of each ball across the axis press it by 2 t more, of which c r becomes friction:
    the most that (c r)^2 ((H + 2 t)^2 + V^2) - t^2 comes to is (c r)^2 (V^2 + H^2/(1 - 4 c^2 r^2)).
    """
    body = "position = [0.4, 0, 0], mass = 20, inertia = [1, 1.5, 1]"
    places = [[0, 0, 0.5], [0, 0, -0.5]]
    return turned("spherical", "", places, [0.05, 0.05], body, [0, 0, torque])


DOOR = 2 * 0.3 * 0.05 * 20 * G * math.hypot(0.5, 0.4 / math.sqrt(1 - 4 * (0.3 * 0.05) ** 2))


@pytest.mark.parametrize(
    ("build", "limit", "place"),
    [
        (drawer, 0.6 * G, "b.x"),
        (shaft, 0.3 * (0.05 + 0.02) * G, "r0.angle"),
        (door, DOOR, "b.y"),
    ],
    ids=["drawer", "shaft", "door"],
)
def test_two_joints_hold_up_to_the_sum_of_their_limits(build, limit, place):
    for share in (0.3, 0.99, BELOW):
        held = run(build(share * limit))
        assert way(held, place) < 1e-12
        assert held["solver.events"].sum() == 0
        assert held["solver.stepped"].sum() == 0
        assert (held["r0.friction_mode"] == 1).all()
        assert (held["r1.friction_mode"] == 1).all()
    for share in (ABOVE, 1.5):
        slid = run(build(share * limit), stop=0.2)
        assert way(slid, place) > 1e-9
        assert slid["solver.events"].sum() == 0
        assert (slid["r0.friction_mode"][1:] == 2).all()
        assert (slid["r1.friction_mode"][1:] == 2).all()


def test_unlike_rails_of_a_drawer_share_a_push_inside_their_cones():
    # Each would take half of 0.9 of the limit, 2.65 N, more than 0.1 of 9.81 N.
    found = run(drawer(0.9 * 0.6 * G))
    assert found["r0.friction"] == pytest.approx(-0.1 * G, rel=2e-7)
    assert found["r1.friction"] == pytest.approx(-0.44 * G, rel=2e-7)


@pytest.mark.parametrize("push", [0.0, 0.5, 2.0, -2.6, -3.0])
def test_feet_beside_a_belt_hold_by_forces_that_lean_on_them(push):
    # With 5.45 N on the belt in the middle the outer feet would hold less than 2.18 N.
    text = three_feet(push)
    found = run(text)
    assert way(found, "b.x", "b.y", "b.angle") < 1e-12
    assert found["solver.events"].sum() == 0
    assert (found["p1.mode"] == 2).all()
    force = {name: found[f"{name}.force"] for name in ("p0", "p1", "p2")}
    friction = {name: found[f"{name}.friction"] for name in force}
    assert friction["p1"] == pytest.approx(0.4 * force["p1"], rel=1e-13)
    for name in ("p0", "p2"):
        assert (found[f"{name}.mode"] == 1).all()
        assert (abs(friction[name]) <= 0.4 * force[name] * (1 + 1e-8)).all()
    assert sum(force.values()) == pytest.approx(G, rel=1e-8)
    assert sum(friction.values()) == pytest.approx(-push, abs=1e-7)


def three_feet(push: float) -> str:
    """Block of 1 kg on three feet, the middle one on a belt."""
    contacts = "\n".join(
        f'p{i} = {{ type = "plane", point = "b.p{i}", axis = [0, 1], position = [0, -0.1], '
        f"friction = 0.4{', surface_velocity = [1, 0]' if i == 1 else ''} }}"
        for i in range(3)
    )
    return f"""{PLANE}gravity = [{push!r}, {-G!r}]
[bodies.b]
position = [0, 0]
mass = 1
inertia = 0.05
points = {{ p0 = [-0.3, -0.1], p1 = [0, -0.1], p2 = [0.3, -0.1] }}
[contacts]
{contacts}
"""


class Random:
    """A body on random feet, one of them on a belt or not, with a hinge that rubs or not."""

    def __init__(self, seed: int) -> None:
        random = np.random.default_rng(seed)
        self.n = int(random.integers(2, 5))
        self.has_belt, self.has_hinge = bool(random.integers(2)), bool(random.integers(2))
        angle = random.uniform(-0.6, 0.6, self.n)
        self.normal = np.stack([np.sin(angle), np.cos(angle)], axis=1)
        self.place = np.stack(
            [np.sort(random.uniform(-0.5, 0.5, self.n)), -random.uniform(0.05, 0.4, self.n)], axis=1
        )
        self.friction = random.uniform(0.1, 0.9, self.n)
        self.push, self.turn, self.preload = random.uniform((-6, -0.5, 0.05), (6, 0.5, 1))
        self.pin = random.uniform(-0.3, 0.3, 2)

    def text(self, order: np.ndarray) -> str:
        points = ", ".join(f"p{i} = {place.tolist()}" for i, place in enumerate(self.place))
        contacts = ""
        for i in order.tolist():
            a, b = self.normal[i].tolist()
            contacts += (
                f'p{i} = {{ type = "plane", point = "b.p{i}", axis = [{a!r}, {b!r}], '
                f"position = {self.place[i].tolist()}, friction = {float(self.friction[i])!r}"
                + (f", surface_velocity = [{b!r}, {-a!r}] }}\n" if self.slides(i) else " }\n")
            )
        hinge = f"""[joints]
j = {{ type = "revolute", bodies = ["ground", "b"], position = {self.pin.tolist()}, \
friction = {{ preload = {float(self.preload)!r}, radius = 0.1 }} }}
"""
        return f"""{PLANE}gravity = [{float(self.push)!r}, {-G!r}]
[bodies]
b = {{ position = [0, 0], mass = 1, inertia = 0.05, points = {{ {points} }} }}
{hinge if self.has_hinge else ""}[forces]
turn = {{ type = "torque", body = "b", value = {float(self.turn)!r} }}
[contacts]
{contacts}"""

    def slides(self, i: int) -> bool:
        return self.has_belt and i == 0

    def holds(self, factor: float) -> bool:
        """Whether there are forces inside cones of this factor, by a linear program."""
        columns, bounds = [], []
        for i, (place, normal) in enumerate(zip(self.place, self.normal, strict=True)):
            along = np.array([normal[1], -normal[0]])
            for sign in (1.0,) if self.slides(i) else (1.0, -1.0):
                share = 1.0 if self.slides(i) else factor
                edge = normal + sign * share * self.friction[i] * along
                columns.append([*edge, place[0] * edge[1] - place[1] * edge[0]])
                bounds.append((0.0, None))
        if self.has_hinge:
            columns += [[1.0, 0.0, -self.pin[1]], [0.0, 1.0, self.pin[0]], [0.0, 0.0, 1.0]]
            most = factor * self.preload
            bounds += [(None, None), (None, None), (-most, most)]
        matrix, load = np.array(columns).T, np.array([self.push, -G, self.turn])
        found = linprog(np.zeros(len(bounds)), A_eq=matrix, b_eq=-load, bounds=bounds)
        return found.status == 0


@pytest.mark.parametrize("seed", range(20))
def test_random_feet_belts_and_hinges_rest_where_a_linear_program_finds_forces(seed):
    body = Random(seed)
    order = np.arange(body.n)
    assert body.holds(BELOW) == body.holds(ABOVE)
    found = run(body.text(order), stop=0.05)
    rests = way(found, "b.x", "b.y", "b.angle") < 1e-12
    assert rests == body.holds(1.0)
    if not rests:
        return
    assert found["solver.events"].sum() == 0
    turned = run(body.text(order[::-1]), stop=0.05)
    for i in order.tolist():
        name = f"p{i}"
        assert (found[f"{name}.mode"] == (2 if body.slides(i) else 1)).all()
        limit = body.friction[i] * found[f"{name}.force"]
        assert (abs(found[f"{name}.friction"]) <= limit * (1 + 1e-8) + 1e-7).all()
        for kind in ("mode", "force", "friction"):
            told, other = found[f"{name}.{kind}"], turned[f"{name}.{kind}"]
            assert told == pytest.approx(other, rel=1e-6, abs=1e-6)
