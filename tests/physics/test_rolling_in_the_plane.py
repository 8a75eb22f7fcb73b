"""A disc that rolls down a slope without slip, and one that rolls on a table for long.

With J = m R^2/2 the disc gains 3/4 m v^2 = m g s sin(a), and v = 2/3 g sin(a) t.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

import solver
from tests.support.mechanisms.mechanism_runs import run
from tests.support.mechanisms.reduced_models import Array

RADIUS, MASS, SLOPE, GRAVITY = 0.3, 2.0, 0.4, 9.81
FOOT = np.array([0.2, 0.1])
"""A place on the line [m]."""
NORMAL, UPHILL = (
    np.array([-math.sin(SLOPE), math.cos(SLOPE)]),
    np.array([math.cos(SLOPE), math.sin(SLOPE)]),
)


def slope(share: float = 0.5) -> solver.Scene:
    """Disc at rest on a line through FOOT, 1 m uphill; its inertia is `share` m R^2."""
    x, y = (FOOT + UPHILL + RADIUS * NORMAL).tolist()
    nx, ny = (5 * NORMAL).tolist()
    return solver.loads(f"""
name = "slope"
dimension = 2
gravity = [0, {-GRAVITY}]
[bodies.disc]
position = [{x!r}, {y!r}]
orientation = 0.7
mass = {MASS}
inertia = {share * MASS * RADIUS**2!r}
[joints.roll]
type = "rolling"
body = "disc"
radius = {RADIUS}
position = {FOOT.tolist()}
normal = [{nx!r}, {ny!r}]
""")


NAMES = ["disc.x", "disc.y", "disc.angle"]


def ways(values: Array) -> tuple[Array, Array, Array]:
    """Way downhill [m], height of the centre over the line [m], and turn [rad]."""
    place = values[:, :2] - FOOT
    return 1.0 - place @ UPHILL, place @ NORMAL, values[:, 2] - 0.7


@pytest.mark.parametrize("h", [0.1, 0.01])
def test_a_disc_rolls_without_slip_and_without_work_at_any_step(h):
    # 25 rad/s at the end: 2.5 rad in the longest step, half of it in its halves.
    names = [*NAMES, "energy.kinetic", "energy.balance", "energy.error"]
    values = run(slope(), names, h, 3.0, every=0.1)
    way, height, turn = ways(values)
    kinetic, balance, error = values[:, 3:].T
    assert way[-1] > 10.0
    # Downhill is to the left here: the disc turns counterclockwise.
    assert turn == pytest.approx(way / RADIUS, abs=1e-12)
    assert height == pytest.approx(RADIUS, abs=1e-13)
    # The work of the weight is all there is, of 85 J.
    assert kinetic == pytest.approx(MASS * GRAVITY * math.sin(SLOPE) * way, abs=1e-11)
    assert np.abs(balance).max() < 1e-11
    assert error.max() < 1e-13


def test_the_line_carries_the_disc_and_a_third_of_its_push_is_friction():
    force = run(slope(), ["roll.force.x", "roll.force.y"], 1e-3, 1.0, every=0.25)[1:]
    expected = MASS * GRAVITY * (math.cos(SLOPE) * NORMAL + math.sin(SLOPE) / 3 * UPHILL)
    # Second order: (h w)^2 for 1 ms at up to 9 rad/s is 1e-4.
    assert force == pytest.approx(np.tile(expected, (4, 1)), abs=1e-5 * MASS * GRAVITY)


def test_a_coin_rolls_on_for_ten_thousand_large_steps_with_all_its_energy():
    # 15 rad/s and its wobble, 0.15 rad a step.
    names = ["energy.error", "constraint.position", "energy.kinetic"]
    error, gap, kinetic = run("rolling_disc", names, 0.01, 100.0, every=0.5).T
    assert error.max() < 1e-12
    assert gap.max() < 1e-12
    assert np.ptp(kinetic) > 1e-3
