"""Errors of steps that end at switches, or are made anew to look for them, are known and bounded.

A point on springs that are straight in pieces: between two switches its motion is a cosine.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

import solver

SCENE = """
name = "springs"
dimension = 2
[points]
A = {{ position = [{start}, 0], mass = 1.0 }}
[forces]
f = {{ type = "force", point = "A", value = ["{force}", "0"] }}
"""


def swing(x, v, omega, centre, time):
    """Place and velocity after a time on a spring of rate omega around a centre."""
    cos, sin = math.cos(omega * time), math.sin(omega * time)
    return centre + (x - centre) * cos + v / omega * sin, v * cos - omega * (x - centre) * sin


def on_stairs(start, stop):
    """Solve x'' = -9 x + 0.2 floor(20 x) from rest, by its crossings."""
    t, x, v, omega = 0.0, start, 0.0, 3.0
    stair = math.floor(20 * start)
    while True:
        centre = 0.2 * stair / omega**2
        size = math.hypot(x - centre, v / omega)
        begin = math.atan2(v / omega, x - centre)  # x = centre + size cos(omega t - begin)
        ways = {}
        for level, way in ((stair / 20, -1), ((stair + 1) / 20, 1)):
            if abs(level - centre) < size:
                angle = -way * math.acos((level - centre) / size)
                ways[(angle + begin) % (2 * math.pi) / omega] = way
        next_one = min(ways, default=math.inf)
        x, v = swing(x, v, omega, centre, min(next_one, stop - t))
        t += next_one
        if t >= stop:
            return x, v
        stair += ways[next_one]


def in_a_dead_zone(stop):
    """Solve x'' = -1.2 from x = 1 to 0.3, then x'' = -4 x."""
    t = math.sqrt(1.4 / 1.2)
    return swing(0.3, -1.2 * t, 2.0, 0.0, stop - t)


def moved(force, start, stop, points, tolerance, method):
    """Place, velocity and estimated error at the end."""
    text = SCENE.format(start=start, force=force)
    run = solver.simulate(
        solver.loads(text), stop_time=stop, step_size=stop / points, tolerance=tolerance,
        method=method, outputs=["A.x", "A.vx", "solver.error_estimate"],
    )  # fmt: skip
    return run["A.x"][-1], run["A.vx"][-1], run["solver.error_estimate"][-1]


@pytest.mark.parametrize("method", ["conserving", "fastest"])
@pytest.mark.parametrize("tolerance", [1e-4, 1e-6, 1e-8])
@pytest.mark.parametrize("points", [1, 20])
def test_what_steps_to_switches_add_is_estimated(points, tolerance, method):
    x, v, estimated = moved("-9*A.x + 0.2*floor(20*A.x)", 0.99, 2.0, points, tolerance, method)
    right = on_stairs(0.99, 2.0)
    error = max(abs(x - right[0]) / 0.99, abs(v - right[1]) / (3 * 0.99))
    rounded = 150 * 1e-14  # crossings, of which each is known to rounding of times and places
    assert error < tolerance
    assert error < estimated + rounded


@pytest.mark.parametrize("tolerance", [1e-6, 1e-8])
def test_an_error_is_not_forgotten_where_a_step_is_made_anew(tolerance):
    x, v, estimated = moved("-4*min(max(A.x, -0.3), 0.3)", 1.0, 1.5, 30, tolerance, "fastest")
    right = in_a_dead_zone(1.5)
    error = max(abs(x - right[0]), abs(v - right[1]) / 1.43)
    assert error < tolerance
    assert np.isclose(math.log10(estimated), math.log10(error), atol=0.5)
