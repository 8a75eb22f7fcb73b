"""Cams, roads, bowls and gears with play: when they part, where they land, what that takes."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from scipy.interpolate import CubicSpline
from scipy.optimize import brentq as scipy_brentq

from solver.runtime import Integrator
from tests.support.mechanisms.problems import GRAVITY, Content, mechanism, start

LIFT, LAND, LOSS = 0.0301611762602959, 0.0665961038986019, 0.0557996132142155
"""Of a flat follower on an eccentric disc, in closed form: times [s] and energy [J]."""
BOWL = (-0.4749804981274, 0.0216948615393, -0.5922149662330)
"""Of a point in a superellipsoid after 2 s, by integration of reduced equations to 1e-15 [m]."""
THROWN = 0.3457383117521
"""Time at which a block stops that is thrown across an incline [s], by the same."""


def brentq(function: Callable[[float], float], low: float, high: float) -> float:
    """Root of a function to the last digits."""
    return float(scipy_brentq(function, low, high, xtol=1e-15))  # pyright: ignore


def run(content: Content, times: list[float], **settings: Any) -> list[Integrator]:
    """Run to each time, anew, in steps of the settings; the ledger of each run closes."""
    runs = []
    for time in times:
        integrator = start(content, **settings)
        integrator.advance(0.0, time)
        assert float(integrator["energy.error"]) < 1e-12
        runs.append(integrator)
    return runs


def eccentric_cam(count: int = 288, face: bool = True, **more: Any) -> Content:
    """Disc of radius 0.05 m, 0.01 m off its axis, at 80 rad/s under a follower with a spring."""
    radius, off = 0.05, 0.01
    angles = np.linspace(0.0, 2.0 * np.pi, count + 1)
    across = off * np.cos(angles)  # its centre is below the axis, at -y
    along = -off * np.sin(angles)
    radii = along + np.sqrt(radius**2 - across**2)
    radii[-1] = radii[0]
    low = radius - off
    shaft = {"type": "revolute", "bodies": ["ground", "shaft"], "position": [0, 0]}
    guide = {"type": "prismatic", "bodies": ["ground", "slide"], "axis": [0, 1]}
    lifter = {"type": "cam", "joint": "camshaft", "follower": "slide", "profile": "lobe"}
    return mechanism(
        "cam",
        2,
        profiles={"lobe": {"x": angles.tolist(), "y": radii.tolist(), "periodic": True}},
        points={"roof": {"position": [0, 1], "fixed": True}},
        bodies={
            "shaft": {"mass": 1, "inertia": 0.02, "position": [0, 0]},
            "slide": {"mass": 0.5, "inertia": 0.05, "position": [0, low]},
        },
        joints={"camshaft": shaft, "guide": guide},
        contacts={"lifter": lifter | ({"face": [0, -1]} if face else {}) | more},
        drivers={"drive": {"type": "angle", "joint": "camshaft", "value": "80*t"}},
        forces={
            "spring": {
                "type": "spring",
                "points": ["roof", "slide"],
                "energy": f"400*({1.0 - low!r} - length)**2 - 5*length",
            }
        },
    )


def test_a_flat_follower_lifts_off_an_eccentric_cam_and_lands_as_in_closed_form():
    near = 2e-6
    times = [LIFT - near, LIFT + near, LAND - near, LAND + near]
    closed, lifted, flying, landed = run(eccentric_cam(), times, h=5e-4, order=4)
    assert (closed["lifter.mode"], lifted["lifter.mode"]) == (1.0, 0.0)
    assert (flying["lifter.impacts"], landed["lifter.impacts"]) == (0.0, 1.0)
    assert landed["energy.impact"] == pytest.approx(LOSS, abs=1e-7)  # of the points of the disc


def test_the_loss_of_a_cam_depends_on_its_points_and_not_on_the_step():
    losses = [
        run(eccentric_cam(72), [0.08], h=h, order=order)[0]["energy.impact"]
        for h, order in ((1e-3, 4), (5e-4, 4), (1e-3, 6))
    ]
    assert losses == pytest.approx([losses[-1]] * 3, abs=1e-9)
    assert losses[-1] == pytest.approx(LOSS, abs=1e-6)


def test_a_roller_follows_the_centre_of_an_eccentric_disc():
    """A roller of 0.02 m on a disc of 0.05 m: the centres stay 0.07 m apart."""
    content = eccentric_cam(288, face=False, radius=0.02)
    content["bodies"]["slide"]["position"] = [0, 0.06]
    content["drivers"]["drive"]["value"] = "8*t"  # too slow to lift
    for time in (0.1, 0.3, 0.5):
        (ran,) = run(content, [time], h=5e-3, order=4)
        across, along = 0.01 * math.sin(8 * time), -0.01 * math.cos(8 * time)
        height = along + math.sqrt(0.07**2 - across**2)
        assert ran["lifter.mode"] == 1.0
        assert ran["slide.y"] == pytest.approx(height, abs=2e-9)


def bowl(contact: dict[str, Any]) -> Content:
    """Point that slides in a superellipsoid without friction."""
    x, y = 0.6, 0.1
    z = -0.6 * (1.0 - x**4 - (y / 0.8) ** 4) ** 0.25
    down = -0.5 * ((y / 0.8) ** 3 / 0.8) / ((z / 0.6) ** 3 / 0.6)
    ball = {"mass": 1.0, "position": [x, y, z], "velocity": [0.0, 0.5, down]}
    return mechanism("bowl", 3, points={"p": ball}, contacts={"bowl": {"point": "p"} | contact})


FORMULA = {"type": "surface", "surface": "1 - x**4 - (y/0.8)**4 - (z/0.6)**4"}
SUPERQUADRIC = {"type": "superquadric", "semi_axes": [1, 0.8, 0.6], "power": 4}


@pytest.mark.parametrize("contact", [FORMULA, SUPERQUADRIC], ids=["formula", "superquadric"])
@pytest.mark.parametrize(
    ("order", "h", "error"), [(2, 0.01, 1e-5), (4, 0.02, 1e-9), (6, 0.02, 1e-12)]
)
def test_a_point_in_a_superellipsoid_follows_the_reduced_equations(contact, order, h, error):
    """The reference has thirteen digits."""
    (ran,) = run(bowl(contact), [2.0], h=h, order=order)
    assert [ran[f"p.{axis}"] for axis in "xyz"] == pytest.approx(BOWL, abs=error)
    assert ran["bowl.mode"] == 1.0
    assert abs(float(ran["bowl.gap"])) < 1e-12


def test_a_block_on_a_surface_stops_where_one_on_a_plane_does():
    """Its formula is not a distance, and is in axes of a body of any orientation."""
    slope = 0.3
    g = [-GRAVITY * math.sin(slope), 0.0, -GRAVITY * math.cos(slope)]
    content = mechanism(
        "thrown",
        3,
        points={"p": {"mass": 1.0, "position": [0, 0, 0], "velocity": [0, 1, 0]}},
        bodies={
            "base": {
                "mass": 1.0,
                "inertia": [1, 1, 1],
                "position": [0, 0, 0],
                "orientation": {"axis": [0, 0, 1], "angle": 0.7},
            }
        },
        joints={"base_joint": {"type": "fixed", "bodies": ["ground", "base"]}},
    )
    content["gravity"] = g
    surface = {"type": "surface", "surface": "3*z + z**3", "body": "base"}
    plane = {"type": "plane", "axis": [0, 0, 1]}
    places = []
    for contact in (surface, plane):
        content["contacts"] = {"floor": contact | {"point": "p", "friction": 0.5}}
        (ran,) = run(content, [THROWN + 1e-3], h=2e-3, order=4)
        assert ran["floor.mode"] == 1.0
        places.append([ran["p.x"], ran["p.y"], ran["energy.friction"]])
    assert places[0] == pytest.approx(places[1], abs=1e-8)


HILLS = (0.2816252221903, 0.4481808782893, 0.8520982395137, 0.9976538522032)
"""Times at which a point leaves hills and lands on them, by integration of reduced equations."""
ON_HILLS = (5.433959678356, 0.08536587499792, 0.03812644165997)
"""Where it is after 1.2 s [m], and the energy that its landings took [J]."""


def hills(contact: dict[str, Any]) -> Content:
    """Point of 1 kg that slides on z = 0.1 cos 3x cos 3y, from (0.8, 0.05) at (4, 0.5) m/s."""
    x, y = 2.4, 0.15
    height = 0.1 * math.cos(x) * math.cos(y)
    climb = -0.3 * (4.0 * math.sin(x) * math.cos(y) + 0.5 * math.cos(x) * math.sin(y))
    ball = {"mass": 1.0, "position": [0.8, 0.05, height], "velocity": [4.0, 0.5, climb]}
    return mechanism("hills", 3, points={"p": ball}, contacts={"hills": contact | {"point": "p"}})


def test_a_point_leaves_hills_and_lands_on_them_as_by_the_reduced_equations():
    content = hills({"type": "surface", "surface": "z - 0.1*cos(3*x)*cos(3*y)"})
    near = 1e-8
    times = [time + side for time in HILLS for side in (-near, near)]
    *runs, last = run(content, [*times, 1.2], h=1e-2, order=6)
    assert [ran["hills.mode"] for ran in runs] == [1.0, 0.0, 0.0, 1.0] * 2
    assert [ran["hills.impacts"] for ran in runs] == [0.0] * 3 + [1.0] * 4 + [2.0]
    found = last["p.x"], last["p.y"], last["energy.impact"]
    assert found == pytest.approx(ON_HILLS, abs=1e-10)


def test_a_height_field_is_the_surface_that_its_grid_is_taken_from():
    """To what a spline of 0.05 m makes of waves of 2 m: 2e-7 m, and in curvature 2e-3 of it."""
    x, y = np.linspace(0.0, 6.0, 121), np.linspace(-1.0, 1.0, 41)
    z = 0.1 * np.outer(np.cos(3.0 * x), np.cos(3.0 * y))
    content = hills({"type": "height_field", "x": x.tolist(), "y": y.tolist(), "z": z.tolist()})
    content["points"]["p"]["position"][2] += 1e-6  # not below the spline
    (ran,) = run(content, [1.2], h=1e-2, order=4)
    found = ran["p.x"], ran["p.y"], ran["energy.impact"]
    assert found == pytest.approx(ON_HILLS, abs=1e-4)
    assert ran["hills.mode"] == 1.0


class Road:
    """Height of the centre of a wheel that rolls on a spline, and its second derivative."""

    def __init__(self, x: np.ndarray, y: np.ndarray, radius: float) -> None:
        self.spline, self.radius = CubicSpline(x, y, bc_type="natural"), radius

    def foot(self, x: float) -> float:
        def beside(u: float) -> float:
            slope = self.spline(u, 1)
            return u - self.radius * slope / math.hypot(1.0, slope) - x

        return brentq(beside, x - self.radius, x + self.radius)

    def height(self, x: float) -> tuple[float, float, float]:
        """Height with both derivatives."""
        u = self.foot(x)
        slope, bend = self.spline(u, 1), self.spline(u, 2)
        s = math.hypot(1.0, slope)
        return (
            float(self.spline(u)) + self.radius / s, slope, bend / (1 - self.radius * bend / s**3)
        )  # fmt: skip


def test_the_wheel_of_a_car_lifts_off_a_hump_and_lands_as_by_the_reduced_equation():
    """Wheel of 0.3 m and 30 kg at 16 m/s under a spring; flight is an oscillation about rest."""
    x = np.linspace(-2.0, 16.0, 91)
    y = 0.08 * np.exp(-(((x - 5.5) / 1.2) ** 2))
    radius, mass, stiffness, speed = 0.3, 30.0, 1e3, 16.0
    road = Road(x, y, radius)
    low = road.height(0.0)[0]
    preload = 50.0

    def force(t: float) -> float:  # vertical part of the contact force
        height, _, bend = road.height(speed * t)
        return mass * (GRAVITY + speed**2 * bend) + stiffness * (height - low) + preload

    grid = np.linspace(0.0, 0.8, 400)
    k = next(k for k in range(400) if force(grid[k]) < 0.0)
    lift = brentq(force, grid[k - 1], grid[k])
    height, slope, _ = road.height(speed * lift)
    rest, w = low - (mass * GRAVITY + preload) / stiffness, math.sqrt(stiffness / mass)

    def flight(t: float) -> float:
        s = w * (t - lift)
        return rest + (height - rest) * math.cos(s) + speed * slope / w * math.sin(s)

    def above(t: float) -> float:
        return flight(t) - road.height(speed * t)[0]

    k = next(k for k in range(400) if grid[k] > lift + 0.01 and above(grid[k]) < 0.0)
    land = brentq(above, grid[k - 1], grid[k])
    s = w * (land - lift)
    falling = w * ((rest - height) * math.sin(s) + speed * slope / w * math.cos(s))
    there = road.height(speed * land)[1]
    loss = 0.5 * mass * (falling - speed * there) ** 2
    content = mechanism(
        "quarter_car",
        2,
        profiles={"road": {"x": x.tolist(), "y": y.tolist()}},
        bodies={
            "car": {"mass": 300, "inertia": 100, "position": [0, 1], "points": {"seat": [0, 0]}},
            "wheel": {"mass": mass, "inertia": 1, "position": [0, low]},
        },
        joints={
            "way": {"type": "prismatic", "bodies": ["ground", "car"], "axis": [1, 0]},
            "strut": {"type": "prismatic", "bodies": ["car", "wheel"], "axis": [0, 1]},
        },
        contacts={
            "tyre": {"type": "profile", "point": "wheel", "profile": "road", "radius": radius}
        },
        drivers={"pull": {"type": "displacement", "joint": "way", "value": f"{speed}*t"}},
        forces={
            "spring": {
                "type": "spring",
                "points": ["car.seat", "wheel"],
                "energy": f"{stiffness}/2*({1.0 - low!r} - length)**2 - {preload}*length",
            }
        },
    )
    near = 1e-5  # the curvature of the centre's path, which decides the force, is known to 1e-5/m
    times = [lift - near, lift + near, land - near, land + near]
    closed, lifted, flying, landed = run(content, times, h=2e-3, order=4)
    assert (closed["tyre.mode"], lifted["tyre.mode"]) == (1.0, 0.0)
    before = float(lifted["tyre.impacts"])  # of the wheel that starts without the slope of the road
    assert (flying["tyre.impacts"], landed["tyre.impacts"]) == (before, before + 1.0)
    assert landed["energy.impact"] == pytest.approx(loss, rel=1e-5)


@pytest.mark.parametrize("restitution", [0.0, 0.5, 1.0])
def test_teeth_with_play_lose_what_restitution_says(restitution):
    """Wheels of 0.02 and 0.05 kg m2 at -1:2, the first at 3 rad/s: they close 0.005 rad at 6."""
    shafts = {
        name: {"type": "revolute", "bodies": ["ground", name.lower()], "position": place}
        for name, place in (("A", [0, 0]), ("B", [1, 0]))
    }
    mesh = {
        "type": "gear",
        "joints": ["A", "B"],
        "ratio": -2,
        "backlash": 0.01,
        "restitution": restitution,
    }
    content = mechanism(
        "gears",
        2,
        gravity=False,
        bodies={
            "a": {"mass": 1, "inertia": 0.02, "position": [0, 0], "angular_velocity": 3.0},
            "b": {"mass": 1, "inertia": 0.05, "position": [1, 0]},
        },
        joints=shafts | {"mesh": mesh},
    )
    hit = 0.005 / 6.0
    before, after = run(content, [hit - 1e-9, hit + 1e-4], h=0.01)
    impulse = (1.0 + restitution) * 6.0 / 220.0  # 220 = 1/0.05 + 2^2/0.02
    assert before["mesh.impacts"] == 0.0
    assert after["mesh.impacts"] == 1.0
    assert after["mesh.impulse"] == pytest.approx(impulse, rel=1e-9)
    loss = 0.5 * 36.0 / 220.0 * (1.0 - restitution**2)
    assert after["energy.impact"] == pytest.approx(loss, abs=1e-12)
    assert after["b.angular_velocity"] == pytest.approx(-20.0 * impulse, rel=1e-9)
    assert after["mesh.torque"] == pytest.approx(0.0, abs=1e-9)


ROCKING = (0.338045483931156, 0.781462847122351, 1.11940175098697)
"""Times at which a block lands that rocks from corner to corner, in closed form [s]."""


@pytest.mark.parametrize("dimension", [2, 3])
def test_a_block_rocks_from_corner_to_corner_as_in_closed_form(dimension):
    """Half width 0.1 m, half height 0.3 m, let go at 0.2 rad: it keeps 0.85 of its rate."""
    b, h, tilt = 0.1, 0.3, 0.2
    c, s = math.cos(tilt), math.sin(tilt)
    inertia: Any = (b * b + h * h) / 3.0
    centre = [c * b - s * h, s * b + c * h]
    orientation: Any = tilt
    corners: Any = [[-b, -h], [b, -h]]
    if dimension == 3:  # with the depth of the block along y, and turned about -y
        inertia, centre = [0.03, inertia, 0.01], [centre[0], 0.0, centre[1]]
        orientation = {"axis": [0, -1, 0], "angle": tilt}
        corners = [[x, y, z] for x, z in corners for y in (-0.2, 0.2)]
    block = {"mass": 1, "inertia": inertia, "position": centre, "orientation": orientation}
    floor = {"type": "corners", "body": "block", "corners": corners, "friction": 2.0}
    floor["axis"] = [0] * (dimension - 1) + [1]
    content = mechanism("block", dimension, bodies={"block": block}, contacts={"floor": floor})
    near = 1e-7
    energy = GRAVITY * (centre[-1] - h)
    times = [hit + side for hit in ROCKING for side in (-near, near)]
    for k, ran in enumerate(run(content, times, h=5e-3, order=6)):
        landed = (k + 1) // 2
        hits = float(ran["floor.impacts"]) / (1 if dimension == 2 else 2)
        assert hits == landed
        kept = 0.85 ** (2 * landed)
        assert ran["energy.impact"] == pytest.approx(energy * (1.0 - kept), rel=1e-9)
        assert ran["floor.mode"] == 1.0
        assert abs(float(ran["floor.slip"])) < 1e-10


@pytest.mark.parametrize(
    ("restitution", "friction"), [(1.0, None), (0.5, None), (0.0, 0.3), (0.5, 0.3)]
)
def test_losses_in_a_bowl_depend_neither_on_the_step_nor_on_how_it_is_written(
    restitution, friction
):
    """Flight is exact at any order: impacts up to the first sliding are those of round-off."""
    rubbing = {} if friction is None else {"friction": friction}
    lost, seen = [], set()
    for contact in (FORMULA, SUPERQUADRIC):
        content = bowl(contact | {"restitution": restitution} | rubbing)
        content["points"]["p"] |= {"position": [0.1, 0.05, 0.1], "velocity": [0.7, 0.3, 0.2]}
        for h, order in ((0.02, 2), (0.01, 4), (0.01, 6)):
            ran = start(content, h=h, order=order, max_events=1000)
            for k in range(30):
                ran.advance(0.1 * k, 0.1)
            assert float(ran["energy.error"]) < 1e-13
            assert float(ran["bowl.gap"]) > -1e-14
            lost.append(float(ran["energy.impact"]))
            seen.add(ran["bowl.impacts"])
    assert lost == pytest.approx([lost[0]] * 6, rel=1e-10, abs=1e-12)
    assert len(seen) == 1
    assert abs(lost[0]) < 1e-12 or restitution < 1.0


def test_a_point_that_falls_past_the_centre_of_a_superquadric_slips_along_its_faces():
    """Its normal turns over there: by hand g t along an end, then 1 m/s along a floor."""
    box = {"type": "superquadric", "point": "p", "power": 40, "semi_axes": [1, 0.2, 0.1]}
    content: Content = {
        "name": "past_the_centre", "dimension": 3, "gravity": [0, 0, -9.81],
        "points": {"p": {"position": [0, 0, 0.001], "velocity": [-1, 0, 0], "mass": 1}},
        "contacts": {"c": box | {"side": "inside", "friction": 1e-9, "restitution": 0.5}},
    }  # fmt: skip
    ran = start(content, h=0.01)
    slips = []
    for k in range(4):
        ran.advance(0.02 * k, 0.02)
        slips.append(float(ran["c.slip"]))
    assert slips == pytest.approx([9.81 * 0.02, 1.0, 1.0, 1.0], rel=1e-9)
