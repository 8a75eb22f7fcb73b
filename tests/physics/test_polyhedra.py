"""Convex bodies in space that hit, rest, tip and tumble on each other, against closed forms."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.spatial.transform import Rotation

from solver.runtime import Integrator
from tests.mechanics.test_contact_rows import Pose
from tests.physics.test_bodies_with_shapes import run, vector
from tests.support.contact.polyhedra import Polyhedron, cuboid, hull_of, separation
from tests.support.mechanisms.problems import GRAVITY, Content, mechanism, start
from tests.support.mechanisms.reduced_models import Array

BOTH_MODES = pytest.mark.parametrize("mode", ["located", "stepped"])


def cuboid_body(mass: float, size: Any, place: Any, turn: Rotation, **more: Any) -> dict[str, Any]:
    """Homogeneous box that is drawn at a place and turned."""
    squares = np.square(size)
    return {
        "mass": mass, "inertia": (mass * (squares.sum() - squares) / 12.0).tolist(),
        "position": list(place), "orientation": turned(turn),
    } | more  # fmt: skip


def turned(turn: Rotation) -> dict[str, Any]:
    """The same turn as a scene has it."""
    vector = turn.as_rotvec()
    angle = float(np.linalg.norm(vector))
    return {"axis": (vector / angle).tolist() if angle else [0, 0, 1], "angle": angle}


def held(name: str) -> dict[str, Any]:
    """Joint that holds a body where it is drawn."""
    return {"type": "fixed", "bodies": ["ground", name]}


# ---------------------------------------------------------------------------------------- impacts


@BOTH_MODES
@pytest.mark.parametrize("restitution", [1.0, 0.5])
@pytest.mark.parametrize("radius", [0.0, 0.01])
def test_boxes_that_hit_edge_to_edge_share_the_impulse_across_both_edges(mode, restitution, radius):
    """P = (1 + e) v/W with W = n . M^-1 n, n along the product of both edges; momenta stay."""
    sizes, masses = np.array([[1.0, 0.2, 0.2], [0.8, 0.3, 0.3]]), (1.0, 2.0)
    turns = [Rotation.from_euler("x", 45, degrees=True)]
    turns.append(Rotation.from_euler("z", 1.1) * turns[0])
    # The lowest edge of one above the highest of the other; they cross where x = y = 0.
    below = [-(0.5 * s[1] - radius) * math.sqrt(2.0) - radius for s in sizes]
    places = [np.array([0.1, 0.0, 0.1 - below[0]]), np.array([0.0, 0.0, below[1]])]
    velocity = np.array([0.0, 0.0, -1.0])
    bodies = {
        name: cuboid_body(masses[k], sizes[k], places[k], turns[k]) for k, name in enumerate("ab")
    }
    bodies["a"]["velocity"] = velocity.tolist()
    contact = {
        "type": "box", "bodies": ["a", "b"], "sizes": sizes.tolist(),
        "radii": [radius, radius], "restitution": restitution,
    }  # fmt: skip
    content = mechanism("edges", 3, gravity=False, bodies=bodies, contacts={"c": contact})
    places[0] = places[0] - [0.0, 0.0, 0.1]  # where they are as they touch
    normal, mobility, arms = np.array([0.0, 0.0, 1.0]), 0.0, []
    inverse = []
    for mass, size, place, turn in zip(masses, sizes, places, turns, strict=True):
        squares = np.square(size)
        inertia = mass * (squares.sum() - squares) / 12.0
        axes = turn.as_matrix()
        inverse.append(axes @ np.diag(1.0 / inertia) @ axes.T)
        arms.append(np.cross([0.0, 0.0, 0.0] - place, normal))
        mobility += 1.0 / mass + arms[-1] @ inverse[-1] @ arms[-1]
    impulse = (1.0 + restitution) / mobility
    ran = run(content, 0.2, h=0.002, contact_mode=mode)
    # In stepped mode the normal turns with the boxes within the half step that they hit in.
    close = 1e-12 if mode == "located" else 2e-3
    assert ran["c.impacts"] == 1.0
    assert vector(ran, "a.v") == pytest.approx(velocity + impulse / masses[0] * normal, abs=close)
    assert vector(ran, "b.v") == pytest.approx(-impulse / masses[1] * normal, abs=close)
    lost = 0.5 * (1.0 - restitution**2) / mobility
    assert ran["energy.impact"] == pytest.approx(lost, abs=close)
    assert vector(ran, "momentum.") == pytest.approx([0.0, 0.0, -1.0], abs=1e-13)


@pytest.mark.parametrize("speed", [0.2, 5.0], ids=["sticks", "slides"])
def test_a_corner_below_the_centre_of_a_tetrahedron_hits_a_box_as_stronge_says(speed):
    """It loses (1 - e^2) m u^2/2, and e m u (1 + e) mu of momentum along the face, or its slip."""
    m, inertia, e, mu, u = 2.0, 0.01, 0.5, 0.3, 1.0
    corners = np.array([[0, 0, -0.3], [0.3, 0, 0.1], [-0.15, 0.25, 0.1], [-0.15, -0.25, 0.1]])
    _, file = hull_of(corners)
    depth = float(np.float32(0.3))
    stone = {
        "mass": m, "inertia": [inertia] * 3, "position": [0.1, 0.05, 0.5 + depth + 0.1],
        "velocity": [speed, 0, -u],
    }  # fmt: skip
    contact = {
        "type": "convex", "bodies": ["stone", "ground"], "file": file.text, "size": [2, 2, 1],
        "restitution": e, "friction": mu,
    }  # fmt: skip
    content = mechanism("stone", 3, gravity=False, bodies={"stone": stone}, contacts={"c": contact})
    ran = run(content, 0.11, h=0.01)
    across = 1.0 / m + depth**2 / inertia
    p = min((1.0 + e) * m * u * mu, speed / across)
    assert vector(ran, "stone.v") == pytest.approx([speed - p / m, 0.0, e * u], abs=1e-9)
    by_slip = p * (speed - 0.5 * p * across)
    assert ran["energy.impact"] == pytest.approx(0.5 * (1 - e**2) * m * u**2 + by_slip, abs=1e-9)


# ------------------------------------------------------------------------------- rest and tipping


@BOTH_MODES
def test_a_beam_across_two_ridges_rests_on_them_as_levers_say(mode):
    """Edges of the beam cross those of the ridges: m g b/(a + b) on the nearer one."""
    edge_up = Rotation.from_euler("y", 45, degrees=True)
    ridge = [0.2, 1.0, 0.2]
    top = 0.1 * math.sqrt(2.0)
    bodies = {"beam": cuboid_body(3.0, [1.0, 0.1, 0.08], [0, 0, top + 0.04], Rotation.identity())}
    contacts = {}
    for name, x in (("left", -0.4), ("right", 0.2)):
        bodies[name] = cuboid_body(1.0, ridge, [x, 0, 0], edge_up)
        contacts[f"on_{name}"] = {
            "type": "box", "bodies": ["beam", name], "sizes": [[1.0, 0.1, 0.08], ridge],
            "friction": 0.3,
        }  # fmt: skip
    joints = {f"foot_{name}": held(name) for name in ("left", "right")}
    content = mechanism("ridges", 3, bodies=bodies, joints=joints, contacts=contacts)
    ran = run(content, 0.1, h=0.01, contact_mode=mode)
    weight = 3.0 * GRAVITY
    assert ran["on_left.force"] == pytest.approx(weight * 0.2 / 0.6, rel=1e-9)
    assert ran["on_right.force"] == pytest.approx(weight * 0.4 / 0.6, rel=1e-9)
    assert vector(ran, "beam.v") == pytest.approx([0.0, 0.0, 0.0], abs=1e-9)


def test_a_plank_tips_over_the_edge_below_it_as_a_pendulum_does():
    """It is wider than its support and has no corner on it: its edges cross the support's edge."""
    length, thick, out = 1.0, 0.05, 0.1
    body = cuboid_body(2.0, [length, 0.4, thick], [out, 0, 0.5 * thick], Rotation.identity())
    contact = {
        "type": "box", "bodies": ["plank", "block"], "sizes": [[length, 0.4, thick], [1, 0.2, 1]],
        "friction": 10.0,
    }  # fmt: skip
    block = cuboid_body(1.0, [1, 0.2, 1], [-0.5, 0, -0.5], Rotation.identity())
    content = mechanism(
        "plank", 3, bodies={"plank": body, "block": block}, joints={"foot": held("block")},
        contacts={"c": contact},
    )  # fmt: skip
    about = (length**2 + thick**2) / 12.0 + out**2 + 0.25 * thick**2

    def slope(_: float, y: Array) -> list[float]:
        arm = out * math.cos(y[0]) + 0.5 * thick * math.sin(y[0])
        return [y[1], GRAVITY * arm / about]

    exact = solve_ivp(slope, (0.0, 0.4), [0.0, 0.0], rtol=1e-11, atol=1e-13).y[0, -1]
    ran = run(content, 0.4, h=0.005, order=4)
    assert 2.0 * math.asin(float(ran["plank.qy"])) == pytest.approx(exact, abs=1e-6)
    assert ran["c.impacts"] == 0.0


OVER = 0.5, 0.1, 2.0
"""Length, height and mass of a box that slides over an edge."""


def over_the_edge(friction: float, begin: float, speed: float, end: float) -> Array:
    """Place (along, up), turn and its rate of that box: flat, on the edge, in flight.

    On the edge its middle is s ahead, and moves with u = s' + h w/2 along the face of height h.
    The balances of momentum, along the face and across it, and of angular momentum,
    N (s + friction h/2) = J w', give the equations below; it leaves the edge where N = 0.
    """
    length, high, mass = OVER
    inertia = mass * (length**2 + high**2) / 12.0
    tips = -0.5 * friction * high  # the resultant of weight and friction meets the edge
    held_up = math.sqrt(speed**2 - 2.0 * friction * GRAVITY * (tips - begin))
    after = 2.0 * (tips - begin) / (speed + held_up)

    def carried(_: float, y: Array) -> float:
        """Weight less what the motion takes of it, over the mass: N = 0 where it is 0."""
        return GRAVITY * math.cos(y[2]) - (2.0 * y[1] - 0.5 * high * y[3]) * y[3]

    def slope(t: float, y: Array) -> list[float]:
        s, u, turn, rate = y
        passes = u - 0.5 * high * rate
        arm = s + 0.5 * friction * high
        normal = carried(t, y) * inertia / (inertia + mass * s * arm)  # over the mass
        along = s * rate**2 + GRAVITY * math.sin(turn) - friction * normal
        return [passes, along, rate, mass * normal * arm / inertia]

    carried.terminal = True  # type: ignore[attr-defined]
    on_it = solve_ivp(
        slope, (after, end), [tips, held_up, 0.0, 0.0], method="DOP853", events=carried,
        rtol=1e-12, atol=1e-14,
    )  # fmt: skip
    assert on_it.y[0, -1] < 0.5 * length  # before its end comes to the edge
    (s, u, turn, rate), flight = on_it.y[:, -1], end - on_it.t[-1]
    c, d = math.cos(turn), math.sin(turn)
    x, z = s * c + 0.5 * high * d, -s * d + 0.5 * high * c
    vx, vz = u * c - s * rate * d, -u * d - s * rate * c
    z += vz * flight - 0.5 * GRAVITY * flight**2
    return np.array([x + vx * flight, z, turn + rate * flight, rate])


@pytest.mark.parametrize(("width", "table"), [(0.2, 1.0), (0.4, 0.2)], ids=["narrow", "wide"])
@pytest.mark.parametrize(
    ("friction", "speed", "settings", "error"),
    [
        pytest.param(0.0, 1.0, {"order": 4, "h": 5e-3}, 1e-7, id="order 4"),
        pytest.param(0.3, 1.5, {"order": 4, "h": 5e-3}, 1e-7, id="order 4 and friction"),
        pytest.param(0.3, 1.5, {"contact_mode": "stepped", "h": 1e-3}, 1e-3, id="stepped"),
    ],
)
def test_a_box_slides_flat_over_an_edge_tips_and_falls_off_it(
    width, table, friction, speed, settings, error
):
    """A narrow one by its edges across that of the table, a wide one by the table's corners."""
    length, high, mass = OVER
    sizes = [[length, width, high], [1.0, table, 0.2]]
    box = cuboid_body(
        mass, sizes[0], [-0.1, 0, 0.5 * high], Rotation.identity(), velocity=[speed, 0, 0]
    )
    block = cuboid_body(1.0, sizes[1], [-0.5, 0, -0.1], Rotation.identity())
    content = mechanism(
        "over", 3, bodies={"box": box, "block": block}, joints={"foot": held("block")},
        contacts={"c": {"type": "box", "bodies": ["box", "block"], "sizes": sizes,
                        "friction": friction}},
    )  # fmt: skip
    ran = run(content, 0.38, **settings)
    found = [ran["box.x"], ran["box.z"], 2.0 * math.asin(float(ran["box.qy"])), ran["box.wy"]]
    assert found == pytest.approx(over_the_edge(friction, -0.1, speed, 0.38), abs=error)
    assert ran["box.y"] == pytest.approx(0.0, abs=1e-9)
    assert ran["c.force"] == 0.0


@BOTH_MODES
@pytest.mark.parametrize(("share", "tips"), [(0.99, False), (1.01, True)])
def test_a_stack_tips_where_its_weight_passes_the_edge(mode, share, tips):
    """The upper box of width b and height h tips at a slope of b/h."""
    b, h = 0.2, 0.5
    slope = math.atan(share * b / h)
    bodies = {
        "low": cuboid_body(3.0, [0.5, 0.5, 0.2], [0, 0, 0.1], Rotation.identity()),
        "high": cuboid_body(1.0, [b, 0.3, h], [0.05, 0, 0.2 + 0.5 * h], Rotation.identity()),
    }
    contacts = {
        "c": {
            "type": "box", "bodies": ["high", "low"], "sizes": [[b, 0.3, h], [0.5, 0.5, 0.2]],
            "friction": 1.0,
        },
        "floor": {
            "type": "corners", "body": "low", "size": [0.5, 0.5, 0.2], "axis": [0, 0, 1],
            "friction": 1.0,
        },
    }  # fmt: skip
    content = mechanism("stack", 3, bodies=bodies, contacts=contacts)
    content["gravity"] = [GRAVITY * math.sin(slope), 0.0, -GRAVITY * math.cos(slope)]
    ran = run(content, 0.2, h=0.005, contact_mode=mode)
    turn = float(ran["high.qy"])
    assert turn > 1e-5 if tips else abs(turn) < 1e-12


# --------------------------------------------------------------------------------------- tumbling


def test_a_cube_on_the_face_of_a_tilted_box_moves_as_on_a_plane():
    """Its corner hits, slides, and the cube tumbles: gaps are the same functions."""
    tilt = Rotation.from_euler("xy", [0.3, -0.2])
    axis = tilt.as_matrix()[:, 2]
    size = [0.2, 0.2, 0.2]
    cube = cuboid_body(
        1.0, size, [0, 0, 0.3], Rotation.from_rotvec([0.5, 0.9, 0.1]),
        velocity=[0.2, 0, -0.5], angular_velocity=[1, 2, 0],
    )  # fmt: skip
    block = cuboid_body(1.0, [4, 4, 1], -0.5 * axis, tilt)
    rubs = {"restitution": 0.4, "friction": 0.2}
    box = {"type": "box", "bodies": ["cube", "block"], "sizes": [size, [4, 4, 1]], **rubs}
    plane = {"type": "corners", "body": "cube", "size": size, "axis": axis.tolist(), **rubs}
    found = []
    for contact in (box, plane):
        content = mechanism(
            "cube", 3, bodies={"cube": cube, "block": block}, joints={"foot": held("block")},
            contacts={"c": contact},
        )  # fmt: skip
        ran = run(content, 0.3, h=0.005)
        found.append([*vector(ran, "cube."), *vector(ran, "cube.v"), *vector(ran, "cube.w")])
        assert float(ran["c.impacts"]) >= 2.0
    assert found[0] == pytest.approx(found[1], abs=1e-8)


def pose(ran: Integrator, name: str) -> Pose:
    """Where a body is."""
    turn = Rotation.from_quat([float(ran[f"{name}.q{x}"]) for x in "xyzw"])
    return Pose(turn.as_matrix(), vector(ran, f"{name}."), np.zeros(3), np.zeros(3))


def tumbling(seed: int) -> tuple[Content, Polyhedron, Polyhedron]:
    """A tetrahedron or a box that falls on a box, which lies on the floor."""
    random = np.random.default_rng(seed)
    low = random.uniform(0.2, 0.5, 3)
    contact: dict[str, Any] = {
        "friction": 0.3 * (seed % 2),
        "restitution": 0.3,
        "bodies": ["a", "b"],
    }
    if seed < 2:
        shape, file = hull_of(0.2 * np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1.0]]))
        contact |= {"type": "convex", "file": file.text, "size": low.tolist()}
    else:
        size = random.uniform(0.1, 0.4, 3)
        shape = cuboid(*size)
        contact |= {"type": "box", "sizes": [size.tolist(), low.tolist()]}
    bodies = {
        "a": cuboid_body(
            1.0, [0.3] * 3, [*random.uniform(-0.2, 0.2, 2), 0.5 * low[2] + 0.4],
            Rotation.from_rotvec(random.normal(size=3)),
            angular_velocity=random.uniform(-4, 4, 3).tolist(),
        ),
        "b": cuboid_body(2.0, low, [0, 0, 0], Rotation.identity()),
    }  # fmt: skip
    floor = {
        "type": "corners", "body": "b", "size": low.tolist(), "axis": [0, 0, 1],
        "position": [0, 0, -0.5 * low[2]],
    }  # fmt: skip
    content = mechanism("tumbles", 3, bodies=bodies, contacts={"c": contact, "floor": floor})
    return content, shape, cuboid(*low)


@pytest.mark.parametrize("seed", range(4))
def test_polyhedra_that_tumble_on_each_other_never_overlap(seed):
    """By separating axes, between steps, which no gap of the model is calculated from."""
    content, first, second = tumbling(seed)
    ran = start(content, h=0.005)
    for k in range(50):
        ran.advance(0.01 * k, 0.01)
        assert separation(first, pose(ran, "a"), second, pose(ran, "b")) > -1e-12
    assert float(ran["energy.error"]) < 1e-9
    assert float(ran["c.impacts"]) >= 2.0
