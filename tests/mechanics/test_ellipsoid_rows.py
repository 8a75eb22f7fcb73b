"""Gaps and slip rates of ellipsoids against the geometry and the motion of what touches.

Bodies `a`, with the ellipsoid, and `b` are placed and moved at random.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import brentq

from tests.mechanics.test_contact_rows import Moved, Pose, bodies, posed
from tests.mechanics.test_shape_rows import rate_of
from tests.support.mechanisms.reduced_models import Array

SEEDS = st.integers(0, 2**32 - 1)
FEW = settings(max_examples=10, deadline=None)
RADIUS = 0.4


def shaped(random: np.random.Generator, dim: int, ratio: float = 4.0) -> Array:
    """Semi-axes whose longest is 1, and whose shortest is 1/ratio of it."""
    half = random.uniform(1.0 / ratio, 1.0, size=dim)
    half[:2] = 1.0, 1.0 / ratio
    return random.permutation(half)


def pointing(random: np.random.Generator, dim: int) -> Array:
    n = random.normal(size=dim)
    return n / np.linalg.norm(n)


def touching(half: Array, n: Array) -> Array:
    """Return the place of an ellipsoid whose outward normal is n, in its axes."""
    return half**2 * n / np.linalg.norm(half * n)


def still(dim: int) -> Pose:
    return Pose(np.eye(dim), np.zeros(dim), np.zeros(dim), np.zeros(2 * dim - 3))


def moved(dim: int, contact: dict[str, Any], poses: dict[str, Pose]) -> Moved:
    """Ellipsoid of `a`, with its origin off its centre of mass, against ground or `b`."""
    drawn = bodies(dim, b={"tip": [0.3] * dim})
    drawn["a"]["center_of_mass"] = [0.2] + [0.0] * (dim - 1)
    common = {"type": "ellipsoid", "body": "a", "friction": 0.1}
    content = {"dimension": dim, "bodies": drawn, "contacts": {"c": common | contact}}
    of_masses = dict(poses)
    a = poses["a"]
    centre = a.x + a.R @ drawn["a"]["center_of_mass"]
    of_masses["a"] = Pose(a.R, centre, a.velocity(centre), a.w)
    return Moved(content, of_masses)


def on_a_plane(seed: int, dim: int, *, carried: bool) -> tuple[Any, ...]:
    random = np.random.default_rng(seed)
    half, axis = shaped(random, dim), random.normal(size=dim)
    axis[0] = -2.0 - abs(axis[0])
    place = [8.0] + [0.0] * (dim - 1)
    poses = {name: posed(random, dim) for name in "ab"}
    contact = {"semi_axes": half.tolist(), "axis": axis.tolist(), "position": place}
    base, drawn = (poses["b"], [9.0] + [0.0] * (dim - 1)) if carried else (still(dim), [0.0] * dim)
    n = base.R @ axis / np.linalg.norm(axis)
    p = base.x + base.R @ (np.array(place) - np.array(drawn))
    lowest = poses["a"].x + poses["a"].R @ touching(half, -poses["a"].R.T @ n)
    made = moved(dim, contact | ({"on": "b"} if carried else {}), poses)
    return made, poses["a"], base, half, n, p, lowest


@pytest.mark.parametrize("dim", [2, 3])
@pytest.mark.parametrize("carried", [False, True])
@FEW
@given(seed=SEEDS)
def test_an_ellipsoid_is_as_far_from_a_plane_as_its_lowest_place(dim, carried, seed):
    made, a, base, half, n, p, lowest = on_a_plane(seed, dim, carried=carried)
    gap = made.value(made.gap.formula)
    assert gap == pytest.approx((lowest - p) @ n, abs=1e-9)
    others = np.random.default_rng(seed).normal(size=(400, dim))
    others = half * others / np.linalg.norm(others, axis=1)[:, None]
    assert gap <= ((a.x + others @ a.R.T - p) @ n).min() + 1e-12
    sliding = a.velocity(lowest) - base.velocity(lowest)
    assert rate_of(made, made.gap.formula) == pytest.approx(sliding @ n, abs=1e-7)
    found = np.linalg.norm([made.value(x) for x in made.slips])
    assert found == pytest.approx(np.linalg.norm(sliding - (sliding @ n) * n), abs=1e-9)


def off_a_ball(seed: int, dim: int, distance: float) -> tuple[Any, ...]:
    """Return an ellipsoid and a ball of `b` at this distance, with the normal from a to b."""
    random = np.random.default_rng(seed)
    half, n = shaped(random, dim), pointing(random, dim)
    poses = {name: posed(random, dim) for name in "ab"}
    a, b = poses["a"], poses["b"]
    place = a.x + a.R @ touching(half, n)
    b.x = place + (distance + RADIUS) * (a.R @ n) - b.R @ ([0.3] * dim)
    contact = {"semi_axes": half.tolist(), "point": "b.tip", "radius": RADIUS}
    return moved(dim, contact, poses), a, b, a.R @ n, place


@pytest.mark.parametrize("dim", [2, 3])
@pytest.mark.parametrize("distance", [0.0, 0.01, 0.5, 20.0])
@FEW
@given(seed=SEEDS)
def test_an_ellipsoid_is_as_far_from_a_ball_as_its_nearest_place(dim, distance, seed):
    made, _, _, _, _ = off_a_ball(seed, dim, distance)
    assert made.value(made.gap.formula) == pytest.approx(distance, abs=1e-11)


@pytest.mark.parametrize("dim", [2, 3])
@FEW
@given(seed=SEEDS)
def test_where_an_ellipsoid_touches_a_ball_rates_are_those_of_the_materials(dim, seed):
    made, a, b, n, place = off_a_ball(seed, dim, 0.0)
    sliding = b.velocity(place) - a.velocity(place)
    assert rate_of(made, made.gap.formula) == pytest.approx(sliding @ n, abs=2e-6)
    found = np.linalg.norm([made.value(x) for x in made.slips])
    assert found == pytest.approx(np.linalg.norm(sliding - (sliding @ n) * n), abs=2e-6)


@pytest.mark.parametrize(("ratio", "limit"), [(10.0, 1e-7), (30.0, 1e-3)])
def test_what_five_steps_leave_of_the_gap_of_a_thin_ellipsoid(ratio, limit):
    """The gap is never more than the distance, which a root of the exact equation gives."""
    for seed in range(20):
        random = np.random.default_rng(seed)
        half, y = shaped(random, 3, ratio), 2.0 * pointing(random, 3)

        def excess(b: float, half: Array = half, y: Array = y) -> float:
            return float(np.sum((half * y / (half**2 + b)) ** 2)) - 1.0

        if excess(0.0) < 0.0:
            continue
        root: Any = brentq(excess, 0.0, 100.0, xtol=1e-15)
        nearest = half**2 * y / (half**2 + root)
        poses = {"a": still(3), "b": Pose(np.eye(3), y - 0.3, np.zeros(3), np.zeros(3))}
        contact = {"semi_axes": half.tolist(), "point": "b.tip", "radius": RADIUS}
        made = moved(3, contact, poses)
        distance = np.linalg.norm(y - nearest) - RADIUS
        assert -limit < made.value(made.gap.formula) - distance < 1e-12
