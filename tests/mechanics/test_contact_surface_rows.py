"""Gaps and slip rates at curves and surfaces against the motion of the materials that touch.

A point of body `a` is placed where it touches a curve or surface that body `b` carries, both bodies
at random poses. What is compared is written from the geometry alone.
"""

from __future__ import annotations

import json
import math
from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.interpolate import CubicSpline

import solver
from solver.mechanics.build_mechanism import build_mechanism
from solver.mechanics.derivative import derivative
from solver.mechanics.distance_grid import distance_grid
from solver.mechanics.mechanism import Formula
from solver.runtime.layout import LEAF_RATE
from solver.scene import ExpressionError, SceneError, evaluate, parse
from solver.scene.expression import Curve, apply, operate, symbol
from tests.mechanics.test_contact_rows import Moved, Pose, bodies, posed
from tests.support.contact.meshes import ellipsoid
from tests.support.mechanisms.reduced_models import Array

SEEDS = st.integers(0, 2**32 - 1)
RADIUS = 0.3
TIP = [0.4, -0.2, 0.7]

ROAD_X = np.linspace(0.0, 8.0, 33)
ROAD_Y = 0.2 * np.sin(1.3 * ROAD_X) + 0.1 * np.cos(2.1 * ROAD_X)
ROAD = CubicSpline(ROAD_X, ROAD_Y, bc_type="natural")
ANGLES = np.linspace(0.0, 2.0 * np.pi, 73)
RADII = 1.5 + 0.2 * np.cos(ANGLES) + 0.03 * np.cos(3.0 * ANGLES)
RADII[-1] = RADII[0]
"""Convex, as a flat follower needs it."""
FORMULA = "1.2 - x**2 + 0.3*x*y - exp(0.1*y)*y**2"


@dataclass
class Touch:
    """Bodies that touch, and the direction from b to a where they do."""

    content: dict[str, Any]
    poses: dict[str, Pose]
    place: Array
    normal: Array

    @property
    def sliding(self) -> Array:
        """Velocity of the material of a against that of b."""
        a, b = self.poses["a"], self.poses["b"]
        return a.velocity(self.place) - b.velocity(self.place)


def touching(
    random: np.random.Generator, dim: int, contact: dict[str, Any], foot: Array, normal: Array,
    radius: float, **tables: Any,
) -> Touch:  # fmt: skip
    """Place body a so that its tip is `radius` above a foot point of b, given in axes of b."""
    poses = {name: posed(random, dim) for name in "ab"}
    a, b, n = poses["a"], poses["b"], normal / np.linalg.norm(normal)
    world = b.R @ n
    place = b.x + b.R @ foot
    a.x = place + radius * world - a.R @ np.array(TIP[:dim])
    content = {
        "dimension": dim,
        "bodies": bodies(dim, a={"tip": TIP[:dim]}),
        "contacts": {"c": {"friction": 0.1} | contact},
    } | tables
    content["bodies"]["b"]["position"] = [0.0] * dim
    content["bodies"]["a"]["position"] = [0.0, 5.0] + [0.0] * (dim - 2)
    return Touch(content, poses, place, world)


def on_a_profile(random: np.random.Generator) -> Touch:
    """A wheel on a road."""
    x = random.uniform(0.5, 7.5)
    foot, normal = np.array([x, ROAD(x)]), np.array([-ROAD(x, 1), 1.0])
    contact = {
        "type": "profile", "profile": "road", "point": "a.tip", "body": "b", "radius": RADIUS,
    }  # fmt: skip
    road = {"x": ROAD_X.tolist(), "y": ROAD_Y.tolist()}
    return touching(random, 2, contact, foot, normal, RADIUS, profiles={"road": road})


def cam(random: np.random.Generator) -> tuple[Array, Array, dict[str, Any]]:
    lobe = CubicSpline(ANGLES, RADII, bc_type="periodic")
    angle = random.uniform(0.0, 2.0 * np.pi)
    r, slope = lobe(angle), lobe(angle, 1)
    out = np.array([math.cos(angle), math.sin(angle)])
    across = np.array([-out[1], out[0]])
    shaft = {"type": "revolute", "bodies": ["ground", "b"], "position": [0, 0]}
    tables = {
        "joints": {"shaft": shaft},
        "profiles": {"lobe": {"x": ANGLES.tolist(), "y": RADII.tolist(), "periodic": True}},
    }
    return r * out, r * out - slope * across, tables


def on_a_cam(random: np.random.Generator) -> Touch:
    """A roller on a cam."""
    foot, normal, tables = cam(random)
    contact = {
        "type": "cam", "joint": "shaft", "follower": "a.tip", "profile": "lobe", "radius": RADIUS,
    }  # fmt: skip
    return touching(random, 2, contact, foot, normal, RADIUS, **tables)


def flat_on_a_cam(random: np.random.Generator) -> Touch:
    """A flat face on a cam, which it touches away from the follower's point."""
    foot, normal, tables = cam(random)
    contact = {
        "type": "cam", "joint": "shaft", "follower": "a.tip", "profile": "lobe", "face": [0.6, 0.8],
    }  # fmt: skip
    touch = touching(random, 2, contact, foot, normal, 0.0, **tables)
    a, n = touch.poses["a"], touch.normal
    face = -n  # of a, as drawn (0.6, 0.8), towards the cam
    c, s = 0.6 * face[0] + 0.8 * face[1], 0.6 * face[1] - 0.8 * face[0]
    a.R = np.array([[c, -s], [s, c]])
    beside = touch.place + random.normal() * np.array([-n[1], n[0]])
    a.x = beside - a.R @ np.array(TIP[:2])
    return touch


def on_a_formula(random: np.random.Generator, dim: int) -> Touch:
    """A ball whose centre moves on a surface; found along a random ray."""
    formula = FORMULA if dim == 2 else f"{FORMULA} - z**4 - 0.2*x*z"
    value = parse(formula)

    def at(x: Array) -> dict[str, float]:
        return dict(zip("xyz", map(float, x), strict=False))

    ray = random.normal(size=dim)
    ray /= np.linalg.norm(ray)
    low, high = 0.0, 5.0
    for _ in range(100):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if evaluate(value, at(middle * ray)) > 0 else (low, middle)
    centre = low * ray
    normal = np.array([evaluate(derivative(value, axis), at(centre)) for axis in "xyz"[:dim]])
    contact = {
        "type": "surface", "surface": formula, "point": "a.tip", "body": "b", "ball_radius": RADIUS,
    }  # fmt: skip
    n = normal / np.linalg.norm(normal)
    return touching(random, dim, contact, centre - RADIUS * n, normal, RADIUS)


def on_a_superquadric(random: np.random.Generator, dim: int, side: str, p: float) -> Touch:
    """A ball whose centre moves on a superquadric, inside or outside."""
    semi_axes = np.array([1.0, 0.8, 0.6][:dim])
    ray = random.normal(size=dim)
    centre = ray / np.sum(np.abs(ray / semi_axes) ** p) ** (1.0 / p)
    normal = np.sign(centre) * np.abs(centre / semi_axes) ** (p - 1.0) / semi_axes
    normal *= (-1.0 if side == "inside" else 1.0) / np.linalg.norm(normal)
    contact = {
        "type": "superquadric", "point": "a.tip", "body": "b", "semi_axes": semi_axes.tolist(),
        "power": p, "side": side, "ball_radius": RADIUS,
    }  # fmt: skip
    return touching(random, dim, contact, centre - RADIUS * normal, normal, RADIUS)


GRID_X, GRID_Y = np.linspace(-2.0, 2.0, 9), np.linspace(-1.5, 1.5, 7)
HEIGHTS = 0.2 * np.sin(GRID_X[:, None] + 2.0 * GRID_Y) + 0.05 * np.cos(3.0 * GRID_X)[:, None]


def on_a_height_field(random: np.random.Generator) -> Touch:
    """A ball whose centre moves on a field of heights, interpolated along y and then along x."""
    x, y = random.uniform(-1.9, 1.9), random.uniform(-1.4, 1.4)

    def height(x: float, y: float, order: tuple[int, int] = (0, 0)) -> float:
        along_y = CubicSpline(GRID_Y, HEIGHTS, axis=1, bc_type="natural")(y, order[1])
        return float(CubicSpline(GRID_X, along_y, bc_type="natural")(x, order[0]))

    centre = np.array([x, y, height(x, y)])
    normal = np.array([-height(x, y, (1, 0)), -height(x, y, (0, 1)), 1.0])
    contact = {
        "type": "height_field", "point": "a.tip", "body": "b", "x": GRID_X.tolist(),
        "y": GRID_Y.tolist(), "z": HEIGHTS.tolist(), "ball_radius": RADIUS,
    }  # fmt: skip
    n = normal / np.linalg.norm(normal)
    return touching(random, 3, contact, centre - RADIUS * n, normal, RADIUS)


MESH = ellipsoid(2)


def on_a_mesh(random: np.random.Generator, side: str) -> Touch:
    """A ball whose centre is where the spline of distances has its radius; along a random ray."""
    sign = 1.0 if side == "outside" else -1.0
    grid = distance_grid(MESH, 1.0, 0.15, sign * RADIUS).grid
    ray = random.normal(size=3)
    ray /= np.linalg.norm(ray)
    low, high = 0.0, 1.9 / np.abs(ray).max() * 0.7
    for _ in range(100):
        middle = 0.5 * (low + high)
        outside = apply("grid", *(middle * ray), grid) > sign * RADIUS
        low, high = (low, middle) if outside else (middle, high)
    centre = low * ray
    normal = sign * np.array([apply(f"grid_{axis}", *centre, grid) for axis in "xyz"])
    contact = {
        "type": "mesh", "file": MESH.text, "resolution": 0.15, "side": side,
        "point": "a.tip", "body": "b", "ball_radius": RADIUS,
    }  # fmt: skip
    n = normal / np.linalg.norm(normal)
    return touching(random, 3, contact, centre - RADIUS * n, normal, RADIUS)


CASES = {
    "mesh outside": lambda random: on_a_mesh(random, "outside"),
    "mesh inside": lambda random: on_a_mesh(random, "inside"),
    "height field": on_a_height_field,
    "profile": on_a_profile,
    "cam with a roller": on_a_cam,
    "cam with a flat face": flat_on_a_cam,
    "curve": lambda random: on_a_formula(random, 2),
    "surface": lambda random: on_a_formula(random, 3),
    "ellipsoid outside": lambda random: on_a_superquadric(random, 3, "outside", 2.0),
    "superquadric inside": lambda random: on_a_superquadric(random, 3, "inside", 4.0),
    "superellipse inside": lambda random: on_a_superquadric(random, 2, "inside", 3.0),
}


TRACED = frozenset({"profile", "cam with a roller", "cam with a flat face"})
"""Their curves are splines through points of the exact ones: to 1e-9 of their size, slopes 1e-6."""
FEW = settings(max_examples=5)


def rate(moved: Moved, formula: Formula) -> float:
    """Rate of a formula, by central differences of the configuration along the velocities."""
    ends = []
    x = [*moved.x]
    for shift in (-1e-6, 1e-6):
        moved.x = [place + shift * v for place, v in zip(x, moved.v, strict=True)]
        ends.append(moved.value(formula))
    moved.x = x
    return (ends[1] - ends[0]) / 2e-6


@pytest.mark.parametrize("case", CASES)
@FEW
@given(seed=SEEDS)
def test_a_gap_is_zero_where_the_surfaces_touch_and_its_rate_is_theirs(case, seed):
    """The rate at one point, for any velocity, says that its gradient has size 1."""
    touch = CASES[case](np.random.default_rng(seed))
    moved = Moved(touch.content, touch.poses)
    gap = moved.gap.formula
    assert moved.value(gap) == pytest.approx(0.0, abs=1e-8 if case in TRACED else 1e-9)
    error = 1e-5 if case in TRACED else 1e-6
    assert rate(moved, gap) == pytest.approx(touch.sliding @ touch.normal, abs=error)


@pytest.mark.parametrize("case", CASES)
@FEW
@given(seed=SEEDS)
def test_slip_is_the_tangential_velocity_of_the_materials(case, seed):
    touch = CASES[case](np.random.default_rng(seed))
    moved = Moved(touch.content, touch.poses)
    found = [moved.value(formula) for formula in moved.slips]
    n, slip = touch.normal, touch.sliding
    if len(n) == 2:
        error = 1e-5 if case in TRACED else 1e-8
        assert found == pytest.approx([slip @ [n[1], -n[0]]], abs=error)
    else:
        assert np.linalg.norm(found) == pytest.approx(
            np.linalg.norm(slip - (slip @ n) * n), abs=1e-8
        )


@pytest.mark.parametrize("case", CASES)
@FEW
@given(seed=SEEDS)
def test_forces_and_moments_at_a_surface_add_up_to_nothing(case, seed):
    """Rows whose rate vanishes when both bodies move as one push and turn them oppositely."""
    random = np.random.default_rng(seed)
    touch = CASES[case](random)
    dim = len(touch.normal)
    velocity, w = random.normal(size=dim), random.normal(size=2 * dim - 3)
    for pose in touch.poses.values():
        pose.v, pose.w = np.zeros(dim), w
        pose.v = velocity + pose.spun(pose.x)
    moved = Moved(touch.content, touch.poses)
    assert rate(moved, moved.gap.formula) == pytest.approx(0.0, abs=1e-7)
    for formula in moved.slips:
        assert moved.value(formula) == pytest.approx(0.0, abs=1e-8)


def test_friction_has_as_many_slip_rates_as_a_surface_has_tangents():
    for case, make in CASES.items():
        touch = make(np.random.default_rng(1))
        moved = Moved(touch.content, touch.poses)
        assert len(moved.slips) == len(touch.normal) - 1, case
        assert all(any(leaf.kind == LEAF_RATE for leaf in slip.leaves) for slip in moved.slips)


@pytest.mark.parametrize("side", [-1.0, 1.0])
def test_the_gap_of_a_wheel_is_its_distance_to_first_order(side):
    """The error falls with the square of the gap: by four where the gap halves."""
    errors = []
    for gap in (0.04, 0.02, 0.01):
        touch = on_a_profile(np.random.default_rng(3))
        touch.poses["a"].x = touch.poses["a"].x + side * gap * touch.normal
        moved = Moved(touch.content, touch.poses)
        errors.append(abs(moved.value(moved.gap.formula) - side * gap))
    assert errors[0] / errors[1] == pytest.approx(4.0, abs=0.5)
    assert errors[1] / errors[2] == pytest.approx(4.0, abs=0.5)


def test_the_gap_to_a_surface_stays_finite_where_it_has_no_normal():
    touch = on_a_superquadric(np.random.default_rng(1), 3, "inside", 4.0)
    a, b = touch.poses["a"], touch.poses["b"]
    a.x = b.x - a.R @ np.array(TIP)
    moved = Moved(touch.content, touch.poses)
    assert moved.value(moved.gap.formula) == pytest.approx(moved.mechanism.extent)


@pytest.mark.parametrize("side", ["inside", "outside"])
@pytest.mark.parametrize("part", [0.1, 0.5, 0.9])
def test_the_gap_to_a_superquadric_is_no_more_than_the_way_to_it(side, part):
    """Far away it is the distance to first order alone, and on the safe side."""
    for seed in range(20):
        touch = on_a_superquadric(np.random.default_rng(seed), 3, side, 4.0)
        a, b = touch.poses["a"], touch.poses["b"]
        centre = a.x + a.R @ np.array(TIP) - b.x
        way = (part if side == "inside" else 1.0 / part) * centre
        a.x = a.x + way - centre
        moved = Moved(touch.content, touch.poses)
        gap = moved.value(moved.gap.formula)
        assert 0.0 < gap <= (1.0 + 1e-9) * float(np.linalg.norm(way - centre))


def gears(**fields: Any) -> dict[str, Any]:
    shafts = {
        name: {"type": "revolute", "bodies": ["ground", name.lower()], "position": place}
        for name, place in (("A", [0, 0]), ("B", [9, 0]))
    }
    mesh = {"type": "gear", "joints": ["A", "B"], "ratio": -2.0} | fields
    return {"dimension": 2, "bodies": bodies(2), "joints": shafts | {"mesh": mesh}}


@given(seed=SEEDS)
def test_a_gear_with_backlash_has_a_gap_at_either_flank(seed):
    random = np.random.default_rng(seed)
    moved = Moved(gears(backlash=0.02), {name: posed(random, 2) for name in "ab"})
    joints = moved.parts.joints
    (first, w_1), (second, w_2) = (
        moved.quantity(joints[name].angle) for name in "AB"  # pyright: ignore[reportArgumentType]
    )  # fmt: skip
    lead, rate_of_lead = second + 2.0 * first, w_2 + 2.0 * w_1
    rows = [moved.mechanism.function_rows[x.row] for x in moved.mechanism.contacts]
    values = [moved.value(row.formula) for row in rows]
    assert values == pytest.approx([0.01 + lead, 0.01 - lead], abs=1e-12)
    rates = [rate(moved, row.formula) for row in rows]
    assert rates == pytest.approx([rate_of_lead, -rate_of_lead], abs=1e-6)
    assert moved.parts.contacts["mesh"] == [0, 1]


def test_a_gear_without_backlash_is_a_constraint():
    parts = build_mechanism(solver.loads(solver_text(gears()), format="json"))
    assert not parts.mechanism.contacts
    assert parts.joints["mesh"].row == ("function", 0)


def solver_text(content: dict[str, Any]) -> str:
    return json.dumps({"name": "x"} | content)


def hollow(kind: str) -> dict[str, Any]:
    """A wheel, roller or face that its profile is too hollow for."""
    x = np.linspace(0.0, 2.0 * np.pi, 41)
    y = {"profile": np.cos(3.0 * x), "cam": 1.0 + 0.5 * np.cos(3.0 * x)}[kind.partition(" ")[0]]
    y[-1] = y[0]
    content = gears()
    content["profiles"] = {"curve": {"x": x.tolist(), "y": y.tolist(), "periodic": True}}
    follower = {"joint": "A", "follower": "b", "profile": "curve"}
    content["contacts"] = {
        "c": {
            "profile": {"type": "profile", "point": "b", "profile": "curve", "radius": 0.3},
            "cam with a roller": {"type": "cam", "radius": 0.5} | follower,
            "cam with a face": {"type": "cam", "face": [-1, 0]} | follower,
        }[kind]
    }
    return content


@pytest.mark.parametrize(
    ("kind", "sentence"),
    [
        ("profile", r"larger than the hollow of 'curve' at x = .* m, where it touches twice"),
        ("cam with a roller", r"larger than the hollow of 'curve' at .* rad, where it touches"),
        ("cam with a face", r"the cam 'curve' is hollow at .* rad, where a flat face touches it"),
    ],
)
def test_what_would_touch_twice_is_refused(kind, sentence):
    with pytest.raises(SceneError, match=sentence):
        build_mechanism(solver.loads(solver_text(hollow(kind)), format="json"))


def test_the_curvature_of_a_profile_has_no_derivative():
    """It would be zero in silence, and kinks at the points of the profile."""
    curve = Curve("lobe", (0.0,) * 19)
    slope = operate("spline_slope", symbol("x"), curve)
    curvature = derivative(slope, "x")
    with pytest.raises(ExpressionError, match="the curvature of a profile has no derivative"):
        derivative(curvature, "x")


@pytest.mark.parametrize("dim", [2, 3])
@FEW
@given(seed=SEEDS)
def test_corners_are_balls_on_a_plane(dim, seed):
    """Each corner has the gap and the slip rates of a named point of the body at its place."""
    random = np.random.default_rng(seed)
    corners = random.normal(size=(3, dim)).tolist()
    plane = {
        "axis": random.normal(size=dim).tolist(), "position": random.normal(size=dim).tolist(),
        "radius": RADIUS, "friction": 0.1,
    }  # fmt: skip
    poses = {name: posed(random, dim) for name in "ab"}
    named = {f"p{k}": corner for k, corner in enumerate(corners)}
    content = {"dimension": dim, "bodies": bodies(dim, a=named)}
    one = {"type": "corners", "body": "a", "corners": corners, "on": "b"} | plane
    apart = {
        f"c{k}": {"type": "plane", "point": f"a.p{k}", "body": "b"} | plane for k in range(3)
    }  # fmt: skip
    found = []
    for contacts in ({"c": one}, apart):
        moved = Moved(content | {"contacts": contacts}, poses)
        formulas = [row.formula for row in moved.mechanism.function_rows] + moved.slips
        found.append([moved.value(formula) for formula in formulas])
        assert len(moved.mechanism.contacts) == 3
    assert len(found[0]) == 3 * dim
    assert found[0] == pytest.approx(found[1], abs=1e-12)
