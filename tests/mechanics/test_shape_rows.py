"""Gaps and slip rates of bodies with shapes against the distance and motion of what touches.

Bodies `a` and `b` are placed and moved at random. Distances of hulls are those of their edges.
"""

from __future__ import annotations

from itertools import product
from typing import Any, NamedTuple

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import lsq_linear

from solver.mechanics.mechanism import Formula
from tests.mechanics.test_contact_rows import Moved, Pose, bodies, posed
from tests.support.mechanisms.reduced_models import Array

SEEDS = st.integers(0, 2**32 - 1)
FEW = settings(max_examples=12, deadline=None)
RADII = (0.3, 0.2)


class Pair(NamedTuple):
    """Corners of two hulls, with the segments among them that may touch."""

    contact: dict[str, Any]
    corners: tuple[Array, Array]
    edges: tuple[list[tuple[int, int]], list[tuple[int, int]]]


def turns(n: int) -> list[tuple[int, int]]:
    """Edges of a polygon, a segment or a place."""
    return [(k, (k + 1) % n) for k in range(n if n > 2 else 1)]


def capsules(random: np.random.Generator, dim: int, ends: tuple[int, int] = (2, 2)) -> Pair:
    corners = tuple(random.normal(size=(n, dim)) for n in ends)
    contact = {"type": "capsule", "segments": [x.tolist() for x in corners]}
    return Pair(contact, (corners[0], corners[1]), (turns(ends[0]), turns(ends[1])))


def polygons(random: np.random.Generator) -> Pair:
    corners = []
    for n, sign in ((5, 1.0), (3, -1.0)):  # round it either way
        angles = sign * 2.0 * np.pi * (np.arange(n) + 0.3 * random.uniform(size=n)) / n
        corners.append(random.uniform(0.5, 2.0) * np.array([np.cos(angles), np.sin(angles)]).T)
    contact = {"type": "polygon", "corners": [x.tolist() for x in corners]}
    return Pair(contact, (corners[0], corners[1]), (turns(5), turns(3)))


def closest(first: Array, second: Array) -> tuple[float, Array, Array]:
    """Distance of two segments, and the places that are nearest to each other.

    These are an end of one and its projection, or lie on the line across both.
    """
    pairs = []
    for one, two in ((first, second), (second, first)):
        along = two[1] - two[0]
        for end in one:
            share = np.clip((end - two[0]) @ along / max(along @ along, 1e-300), 0.0, 1.0)
            pairs.append((end, two[0] + share * along)[:: 1 if one is first else -1])
    matrix = np.array([first[1] - first[0], second[0] - second[1]]).T
    s = np.linalg.lstsq(matrix, second[0] - first[0])[0]
    if np.all((s >= 0.0) & (s <= 1.0)) and np.linalg.matrix_rank(matrix) == 2:
        places = (x[0] + t * (x[1] - x[0]) for x, t in zip((first, second), s, strict=True))
        pairs.append(tuple(places))
    return min(((float(np.linalg.norm(x - y)), x, y) for x, y in pairs), key=lambda found: found[0])


def nearest(pair: Pair, poses: dict[str, Pose]) -> tuple[float, Array, Array]:
    """Distance of two hulls that do not meet, and the nearest places."""
    placed = [
        poses[name].x + x @ poses[name].R.T for name, x in zip("ab", pair.corners, strict=True)
    ]
    return min(
        (closest(placed[0][list(i)], placed[1][list(k)]) for i, k in product(*pair.edges)),
        key=lambda found: found[0],
    )


def rows_of(pair: Pair, poses: dict[str, Pose], dim: int, second: str) -> Moved:
    """Mechanism of two bodies, drawn far apart, at these poses; the second may be the ground."""
    contact = {"bodies": ["a", second], "radii": RADII, "friction": 0.1} | pair.contact
    known = {name: pose for name, pose in poses.items() if name in ("a", second)}
    drawn = {name: body for name, body in bodies(dim).items() if name in known}
    drawn["a"]["position"] = [-9.0] + [0.0] * (dim - 1)
    return Moved({"dimension": dim, "bodies": drawn, "contacts": {"c": contact}}, known)


CASES = {
    "capsules": (2, lambda random: capsules(random, 2)),
    "polygons": (2, polygons),
    "capsules in space": (3, lambda random: capsules(random, 3)),
    "capsule and ball": (3, lambda random: capsules(random, 3, (2, 1))),
    "ball and capsule": (3, lambda random: capsules(random, 3, (1, 2))),
}


def apart(random: np.random.Generator, dim: int, pair: Pair, second: str) -> dict[str, Pose]:
    """Poses at which the hulls are more than rounding apart."""
    poses = {name: posed(random, dim) for name in "ab"}
    if second == "ground":
        poses["b"] = Pose(np.eye(dim), np.zeros(dim), np.zeros(dim), np.zeros(2 * dim - 3))
    poses["a"].x = poses["b"].x + 12.0 * poses["a"].R[0]
    assert nearest(pair, poses)[0] > 0.1
    return poses


@pytest.mark.parametrize("case", CASES)
@FEW
@given(seed=SEEDS)
def test_the_least_gap_is_the_distance_of_the_shapes(case, seed):
    random = np.random.default_rng(seed)
    dim, shapes = CASES[case]
    pair = shapes(random)
    poses = apart(random, dim, pair, "b")
    moved = rows_of(pair, poses, dim, "b")
    gaps = [moved.value(row.formula) for row in moved.mechanism.function_rows]
    assert min(gaps) == pytest.approx(nearest(pair, poses)[0] - sum(RADII), abs=1e-7)


@pytest.mark.parametrize("seed", range(4))
def test_the_least_gap_of_round_boxes_is_their_distance(seed):
    """Of corners to faces, or of edges that cross."""
    random = np.random.default_rng(seed)
    sizes = random.uniform(1.0, 3.0, size=(2, 3))
    half = 0.5 * sizes - np.array(RADII)[:, None]
    corners = [np.array(list(product(*([-x, x] for x in own)))) for own in half]
    shapes = Pair({"type": "box", "sizes": sizes.tolist()}, (corners[0], corners[1]), ([], []))
    poses = {name: posed(random, 3) for name in "ab"}
    poses["a"].x = poses["b"].x + 8.0 * poses["a"].R[0]
    matrix = np.column_stack((poses["a"].R, -poses["b"].R))
    high = np.concatenate(half)
    link = poses["b"].x - poses["a"].x
    x = lsq_linear(matrix, link, (-high, high), tol=1e-14, method="bvls").x
    moved = rows_of(shapes, poses, 3, "b")
    gaps = [moved.value(row.formula) for row in moved.mechanism.function_rows]
    assert min(gaps) == pytest.approx(np.linalg.norm(matrix @ x - link) - sum(RADII), abs=1e-7)


def touching(
    random: np.random.Generator, dim: int, pair: Pair, second: str
) -> tuple[Moved, Array, Array]:
    """Bodies that touch, the normal towards a, and the velocity of a against b where they do."""
    poses = apart(random, dim, pair, second)
    distance, one, two = nearest(pair, poses)
    normal = (one - two) / distance
    poses["a"].x = poses["a"].x + (sum(RADII) - distance) * normal
    place = two + RADII[1] * normal
    sliding = poses["a"].velocity(place) - poses["b"].velocity(place)
    return rows_of(pair, poses, dim, second), normal, sliding


def rate_of(moved: Moved, formula: Formula) -> float:
    """Rate of a formula, by central differences of the configuration along the velocities."""
    ends, x = [], [*moved.x]
    for shift in (-1e-6, 1e-6):
        moved.x = [place + shift * v for place, v in zip(x, moved.v, strict=True)]
        ends.append(moved.value(formula))
    moved.x = x
    return (ends[1] - ends[0]) / 2e-6


@pytest.mark.parametrize("second", ["b", "ground"])
@pytest.mark.parametrize("case", CASES)
@FEW
@given(seed=SEEDS)
def test_where_shapes_touch_rates_are_those_of_the_materials(case, second, seed):
    random = np.random.default_rng(seed)
    dim, shapes = CASES[case]
    moved, normal, sliding = touching(random, dim, shapes(random), second)
    contacts = moved.mechanism.contacts
    values = [moved.value(row.formula) for row in moved.mechanism.function_rows]
    closed = int(np.argmin(np.abs(values)))
    assert min(values) > -1e-7
    assert values[closed] == pytest.approx(0.0, abs=1e-7)
    formula = moved.mechanism.function_rows[contacts[closed].row].formula
    assert rate_of(moved, formula) == pytest.approx(sliding @ normal, abs=2e-5)
    friction = moved.mechanism.frictions[contacts[closed].friction]
    slips = [moved.value(moved.mechanism.velocity_rows[k].formula) for k in friction.rows]
    across = sliding - (sliding @ normal) * normal
    assert np.linalg.norm(slips) == pytest.approx(np.linalg.norm(across), abs=2e-5)
    if dim == 2:
        assert slips[0] == pytest.approx(across @ [normal[1], -normal[0]], abs=2e-5)
