"""A mesh is repeated where laws switch: right values are closed forms, piece by piece.

A mass of 1 kg begins at 1 m, at rest, or at 0 where its law reads the time alone.
"""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cache

import numpy as np
import pytest

import solver
from solver.mesh import MESH_ENDS, Mesh
from solver.runtime import OptionError, Status, StepError

POINT = """
name = "point"
dimension = 2
[parameters]
m = {{ value = 1.0, min = 0.1 }}
{parameter} = {{ value = {value} }}
[points]
A = {{ position = [{place}, 0], velocity = [{speed}, 0], mass = "m" }}
[forces]
f = {{ type = "force", point = "A", value = ["{law}", 0] }}
"""
TIMED = POINT.format(parameter="off", value=0.6137, place=0, speed=0, law="1 if t < off else -1")
SIGN = POINT.format(parameter="start", value=1.0, place='"start"', speed=0, law="-sign(A.x)")
BOUNDED = POINT.format(
    parameter="bound", value=0.3, place=1, speed=0, law="-4*min(max(A.x, -bound), bound)"
)
RUBBED = POINT.format(
    parameter="c", value=0.8, place=0, speed=1, law="0.5 - c*sign(A.vx) - (0.2 if t > 1.2 else 0)"
)
TOGETHER = POINT.format(
    parameter="c", value=0.2, place=0.9, speed=0, law="-sign(A.x) - c*floor(6*A.x)"
)
BOUNCING = """
name = "ball"
dimension = 2
gravity = [0, "-g"]
[parameters]
g = { value = 9.81 }
push = { value = 1.5 }
[points]
A = { position = [0, 1], velocity = [1, 0], mass = 2.0 }
[contacts]
floor = { type = "plane", point = "A", axis = [0, 1], restitution = 0.8 }
[forces]
up = { type = "force", point = "A", value = ["push if A.vy > 0 else 0", 0] }
"""
ARM = """
name = "arm"
dimension = 2
[parameters]
begin = { value = 0.413 }
[bodies]
arm = { position = [0, 0], mass = 6.0, inertia = 5.0 }
rod = { position = [1, 0], mass = 2.0, inertia = 0.5 }
[joints]
slew = { type = "revolute", bodies = ["ground", "arm"], position = [0, 0] }
tip = { type = "revolute", bodies = ["arm", "rod"], position = [1, 0] }
[drivers]
motor = { type = "angle", joint = "slew", value = "2*max(t - begin, 0)" }
"""
AT = {"stop_time": 3.0, "step_size": 1.0}
METHODS = (
    {"tolerance": 1e-8},
    {"tolerance": 1e-6, "method": "fastest"},
    {"internal_step": 0.01, "order": 4.0},
)


def of_the_time(m, off):
    """Place after 3 s: pushed forwards, then back."""
    left = 3.0 - off
    return (off * off / 2 + off * left - left * left / 2) / m


def of_the_sign(m, start):
    """It falls to 0 in sqrt(2 m x0), with the speed sqrt(2 x0/m), and is braked behind it."""
    left = 3.0 - math.sqrt(2 * m * start)
    return -math.sqrt(2 * start / m) * left + left * left / (2 * m)


def of_the_bounds(m, bound):
    """A constant force to `bound`, a spring to -`bound`, a constant force back."""
    first = math.sqrt((1 - bound) * m / (2 * bound))
    speed, omega = 4 * bound * first / m, 2 / math.sqrt(m)
    size, phase = math.hypot(bound, speed / omega), math.atan2(speed / omega, bound)
    second = (math.acos(-bound / size) - phase) / omega
    left = 3.0 - first - second
    return (
        -bound
        - size * omega * math.sin(omega * second + phase) * left
        + (2 * bound / m * left * left)
    )


CASES = {
    "time": (TIMED, "off", 0.6137, lambda x: of_the_time(1.0, x)),
    "time, mass": (TIMED, "m", 1.0, lambda x: of_the_time(x, 0.6137)),
    "sign": (SIGN, "start", 1.0, lambda x: of_the_sign(1.0, x)),
    "sign, mass": (SIGN, "m", 1.0, lambda x: of_the_sign(x, 1.0)),
    "bounds": (BOUNDED, "bound", 0.3, lambda x: of_the_bounds(1.0, x)),
    "bounds, mass": (BOUNDED, "m", 1.0, lambda x: of_the_bounds(x, 0.3)),
}


@cache
def model(text):
    return solver.assemble(solver.loads(text))


def recorded(text, **options):
    return solver.simulate(model(text), record_mesh=True, **{**AT, **options})


def last(text, values, **options):
    run = solver.simulate(model(text), parameters=values, outputs=["A.x"], **{**AT, **options})
    return float(run["A.x"][-1])


def slope(text, name, value, d, **options):
    """Central difference."""
    high, low = (last(text, {name: value + x}, **options) for x in (d, -d))
    return (high - low) / (2 * d)


def slope_of(place, value):
    """Slope of a closed form, by differences that are extrapolated to 1e-11."""
    wide, narrow = ((place(value + d) - place(value - d)) / (2 * d) for d in (1e-3, 5e-4))
    return (4 * narrow - wide) / 3


@pytest.mark.parametrize("options", METHODS, ids=str)
@pytest.mark.parametrize("text", [TIMED, SIGN, BOUNDED, RUBBED, TOGETHER, BOUNCING, ARM])
def test_the_same_numbers_give_the_same_bits(text, options):
    first = recorded(text, **options)
    assert np.isin(first.mesh["end"], [MESH_ENDS.index(x) for x in ("switch", "time")]).any()
    again = solver.simulate(model(text), mesh=first.mesh, **AT)
    for variable in first:
        if not variable.startswith("solver."):
            assert np.array_equal(first[variable], again[variable]), variable


@pytest.mark.parametrize("options", METHODS, ids=str)
@pytest.mark.parametrize("text", [SIGN, BOUNDED, BOUNCING, ARM])
def test_recording_does_not_change_a_run(text, options):
    assert recorded(text, **options) == solver.simulate(model(text), **{**AT, **options})


@pytest.mark.parametrize("case", CASES)
def test_laws_change_where_the_new_numbers_have_them_change(case):
    """Runs go where the closed form goes, as near as the recorded one: at 1e-8."""
    text, name, value, place = CASES[case]
    mesh = recorded(text, tolerance=1e-8).mesh
    for factor in (0.97, 1.0, 1.03):
        found = last(text, {name: factor * value}, mesh=mesh)
        assert found == pytest.approx(place(factor * value), abs=3e-8)


@pytest.mark.parametrize("case", CASES)
def test_differences_converge_to_the_slope_with_the_square_of_the_change(case):
    """Their third derivatives differ; the slope is that of the motion whose switches move."""
    text, name, value, place = CASES[case]
    mesh, right = recorded(text, tolerance=1e-8).mesh, slope_of(place, value)
    left = [slope(text, name, value, d, mesh=mesh) - right for d in (0.02, 0.01, 1e-4)]
    if case == "time":  # a parabola
        assert max(map(abs, left)) < 1e-9
    else:
        assert left[0] / left[1] == pytest.approx(4.0, rel=0.03)
        assert abs(left[2]) < 3e-6


def test_small_differences_are_right_where_runs_with_their_own_steps_jitter():
    """At 1e-6 the latter err by some 1e-9 m, which a change of 1e-6 enlarges a million times."""
    options = {"tolerance": 1e-6, "method": "fastest"}
    right = slope_of(lambda x: of_the_bounds(1.0, x), 0.3)
    mesh = recorded(BOUNDED, **options).mesh
    changes = (1e-4, 3e-5, 1e-5, 3e-6, 1e-6)
    kept, own = (
        max(abs(slope(BOUNDED, "bound", 0.3, d, **settings) - right) for d in changes)
        for settings in ({"mesh": mesh}, options)
    )
    assert kept < 3e-6
    assert own > 100 * kept


@pytest.mark.parametrize("options", METHODS, ids=str)
def test_friction_that_a_force_is_holds_where_the_new_one_does(options):
    """Braked by c - 0.5 for 1.2 s, then by c - 0.3 until it stops, and holds."""

    def place(c):
        speed = 1 + (0.5 - c) * 1.2
        return 1.2 + (0.5 - c) * 0.72 + speed * speed / (2 * (c - 0.3))

    mesh = recorded(RUBBED, **options).mesh
    assert np.count_nonzero(mesh["end"] == MESH_ENDS.index("time")) == 1
    assert np.count_nonzero(mesh["end"] == MESH_ENDS.index("event")) == 1
    for c in (0.78, 0.8, 0.82):
        assert last(RUBBED, {"c": c}, mesh=mesh) == pytest.approx(place(c), abs=1e-9)
    found = slope(RUBBED, "c", 0.8, 1e-3, mesh=mesh)
    assert found == pytest.approx(slope_of(place, 0.8), abs=1e-4)


def test_sides_change_with_an_impact_and_in_flight():
    """Pushed while it rises: from sqrt(2/g) for 2 e sqrt(2/g)/2, with 0.75 m/s^2."""

    def place(g):
        fall = math.sqrt(2 / g)
        rise = 0.8 * fall
        return 1.0 + 0.75 * (rise * rise / 2 + rise * (1.0 - fall - rise))

    at = {"stop_time": 1.0, "step_size": 1.0}
    mesh = recorded(BOUNCING, tolerance=1e-6, **at).mesh
    for g in (9.7, 9.81, 9.9):
        assert last(BOUNCING, {"g": g}, mesh=mesh, **at) == pytest.approx(place(g), abs=1e-10)
    found = slope(BOUNCING, "g", 9.81, 1e-3, mesh=mesh, **at)
    assert found == pytest.approx(slope_of(place, 9.81), abs=1e-8)


def of_two_at_once(c, time):
    """From 0.9 pulled by 1 + n c to n/6, n from 5 to 0, and pushed back by 1 + c behind 0."""
    speed = spent = 0.0
    for n in range(5, -1, -1):
        way = 0.9 - 5 / 6 if n == 5 else 1 / 6
        faster = math.sqrt(speed * speed + 2 * (1 + n * c) * way)
        spent += (faster - speed) / (1 + n * c)
        speed = faster
    left = time - spent
    assert left > 0
    return -speed * left + (1 + c) / 2 * left * left


@pytest.mark.parametrize("options", METHODS, ids=str)
def test_two_switches_at_once_go_on_together(options):
    """The sign of A.x and the whole number below 6 A.x change at 0."""
    at = {"stop_time": 1.02, "step_size": 1.02}
    mesh = recorded(TOGETHER, **at, **options).mesh
    for c in (0.19, 0.2, 0.21):
        right = of_two_at_once(c, 1.02)
        assert -1 / 6 < right < 0
        assert last(TOGETHER, {"c": c}, mesh=mesh, **at) == pytest.approx(right, abs=1e-10)


def test_velocities_jump_when_the_driver_of_the_new_numbers_begins():
    """The arm has turned by 2 (t - begin)."""
    mesh = recorded(ARM, tolerance=1e-6).mesh
    for begin in (0.40, 0.42):
        run = solver.simulate(model(ARM), parameters={"begin": begin}, mesh=mesh, **AT)
        own = solver.simulate(model(ARM), parameters={"begin": begin}, tolerance=1e-8, **AT)
        assert run["slew.angle"][-1] == pytest.approx(2 * (3.0 - begin), abs=1e-12)
        assert run["tip.angle"][-1] == pytest.approx(own["tip.angle"][-1], abs=1e-5)


@pytest.mark.parametrize(
    ("text", "values", "switch"),
    [
        (TIMED, {"off": 1.02}, "force 'f': t < off"),  # behind the communication point
        (TIMED, {"off": -1.0}, "force 'f': t < off"),
        (SIGN, {"start": -1.0}, "force 'f': sign(A.x)"),
        (SIGN, {"m": 0.2}, "force 'f': sign(A.x)"),  # sooner, and back again
        (SIGN, {"m": 5.0}, "force 'f': sign(A.x)"),
        (BOUNDED, {"bound": 1.2}, "force 'f': "),
    ],
)
def test_other_changes_of_sides_are_refused_by_name(text, values, switch):
    mesh = recorded(text, tolerance=1e-6).mesh
    with pytest.raises(StepError, match="changes in another order") as caught:
        solver.simulate(model(text), parameters=values, mesh=mesh, **AT)
    assert caught.value.status == Status.MESH_SWITCHES
    assert switch in str(caught.value)


def test_a_file_has_the_sides_and_damaged_ones_are_refused(tmp_path):
    first = recorded(BOUNDED, tolerance=1e-6)
    mesh = Mesh.load(first.mesh.save(tmp_path / "bounded.npz"))
    assert np.array_equal(mesh.sides, first.mesh.sides)
    assert repr(mesh) == f"<Mesh: {len(mesh.steps)} steps, 0 events, 2 switches, to 3 s>"
    function, end = (Mesh.columns.index(name) for name in ("function", "end"))
    at = int(np.flatnonzero(mesh["end"] == MESH_ENDS.index("switch"))[0])
    for column, value in ((function, -1.0), (function, 2.0), (end, MESH_ENDS.index("event"))):
        steps = mesh.steps.copy()
        steps[at, column] = value
        with pytest.raises(OptionError, match="record it again"):
            Mesh.load(replace(mesh, steps=steps).save(tmp_path / "damaged.npz"))
    with pytest.raises(OptionError, match="the side of each condition"):
        solver.simulate(model(BOUNDED), mesh=replace(mesh, sides=mesh.sides[:, :1]), **AT)
