"""Explicit steps of mechanisms with contacts, wherever no friction slides, against closed forms."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.special import ellipj, ellipk

import holonom
import solver
from tests.support.kernel.twins import start
from tests.support.mechanisms.mechanism_runs import SCENES

EXPLICIT = 2
TOLERANCES = [1e-4, 1e-6, 1e-8, 1e-10]
G = 9.81


def fastest(text, tolerance):
    return start(solver.assemble(solver.loads(text)), tolerance=tolerance, method="fastest")


def advance(run, step, count):
    """Take so many communication steps; return what methods they ended with."""
    methods = set()
    for _ in range(count):
        run.advance(run.time, step)
        methods.add(int(run["solver.method_in_use"]))
    return methods


HILL = """
name = "hill"
dimension = 2
gravity = [0, -9.81]
[points]
centre = { position = [0, 0], fixed = true }
bead = { position = [0, 2], velocity = [0.5, 0], mass = 0.3 }
[contacts]
hill = { type = "sphere", points = ["bead", "centre"], radii = [0.5, 1.5] }
"""


@pytest.mark.parametrize("tolerance", TOLERANCES)
def test_a_bead_leaves_a_round_hill_where_nothing_presses_it(tolerance):
    """From speed u on top: where cos(angle) is 2/3 + u^2/(3 g R). It keeps vx then."""
    run = fastest(HILL, tolerance)
    assert advance(run, 0.1, 14) == {EXPLICIT}
    cosine = 2 / 3 + 0.5**2 / (3 * G * 2)
    assert run["bead.vx"] == pytest.approx(math.sqrt(G * 2 * cosine) * cosine, abs=3 * tolerance)
    assert abs(run["energy.error"]) < 1e-14


BOWL = """
name = "bowl"
dimension = 2
gravity = [0, -9.81]
[points]
centre = { position = [0, 0], fixed = true }
mass = { position = ["sin(1.2)", "-cos(1.2)"], mass = 0.7 }
[contacts]
wall = { type = "clearance", points = ["mass", "centre"], radius = 1.0 }
"""


@pytest.mark.parametrize("tolerance", TOLERANCES)
def test_a_mass_that_slides_in_a_bowl_swings_as_a_pendulum(tolerance):
    """Jacobi's elliptic functions tell the angle; the normal force is m (v^2/R + g cos(angle))."""
    run = fastest(BOWL, tolerance)
    modulus = math.sin(0.6)
    for count in range(1, 25):
        assert advance(run, 0.1, 1) == {EXPLICIT}
        sn, *_ = ellipj(ellipk(modulus**2) - math.sqrt(G) * 0.1 * count, modulus**2)
        angle = 2 * math.asin(modulus * sn)
        assert run["mass.x"] == pytest.approx(math.sin(angle), abs=3 * tolerance)
        speed2 = 2 * G * (math.cos(angle) - math.cos(1.2))
        assert run["wall.force"] == pytest.approx(
            0.7 * (speed2 + G * math.cos(angle)), rel=100 * tolerance
        )


def test_a_rocking_block_keeps_housners_share_of_its_turning_speed():
    """Steps between its landings are explicit: it sticks to the floor at one edge."""
    run = start(
        holonom.assemble(holonom.load(SCENES / "rocking_block.toml")),
        order=0,
        tolerance=1e-9,
        method="fastest",
    )
    share = 1 - 1.5 * math.sin(math.atan2(0.1, 0.3)) ** 2
    peaks, methods = [run["energy.kinetic"] + run["energy.potential"]], set()
    while len(peaks) < 4:
        landings = 0
        while not landings:
            methods |= advance(run, 0.01, 1)
            landings = run["solver.events"]
        peaks.append(run["energy.kinetic"] + run["energy.potential"])
    assert methods == {EXPLICIT}
    lowest = 9.81 * 0.3  # J: of the block that stands
    excess = np.array(peaks) - lowest
    assert excess[1:] / excess[:-1] == pytest.approx(share**2, abs=1e-8)
