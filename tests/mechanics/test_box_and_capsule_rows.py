"""Gaps and slip rates of boxes against capsules and balls, against the nearest places of both.

These are the solution of a convex least-squares problem: a place of the box is within bounds, one
of the segment a share of its length.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import lsq_linear

from solver.scene import SceneError
from tests.mechanics.test_contact_rows import Moved, Pose, bodies, posed
from tests.mechanics.test_shape_rows import rate_of
from tests.support.mechanisms.reduced_models import Array

SEEDS = st.integers(0, 2**32 - 1)
FEW = settings(max_examples=12, deadline=None)
RADII = (0.1, 0.2)


class Touching:
    """A box of body a and a capsule, or a ball, of body b."""

    def __init__(self, seed: int, dim: int, ends: int, distance: float | None) -> None:
        random = np.random.default_rng(seed)
        self.half = random.uniform(0.5, 1.5, size=dim)
        self.ends = random.normal(size=(ends, dim))
        self.poses = {name: posed(random, dim) for name in "ab"}
        a, b = self.poses["a"], self.poses["b"]
        b.x = a.x + 8.0 * a.R @ (x := random.normal(size=dim)) / np.linalg.norm(x)
        found, self.place, self.normal = self.nearest()
        if distance is not None:  # along the normal, by which both stay the nearest places
            shift = (distance + sum(RADII) - found) * self.normal
            b.x = b.x + shift
        self.contact: dict[str, Any] = {
            "type": "box", "bodies": ["a", "b"], "sizes": [(2.0 * (self.half + RADII[0])).tolist()],
            "segment": self.ends.tolist(), "radii": RADII, "friction": 0.1,
        }  # fmt: skip
        drawn = bodies(dim)
        drawn["b"]["position"] = [19.0] + [0.0] * (dim - 1)
        content = {"dimension": dim, "bodies": drawn, "contacts": {"c": self.contact}}
        self.moved = Moved(content, self.poses)

    def nearest(self) -> tuple[float, Array, Array]:
        """Distance of box and segment, the place of the box, and the normal from there."""
        a, b, dim = self.poses["a"], self.poses["b"], len(self.half)
        places = (b.x + self.ends @ b.R.T - a.x) @ a.R
        matrix = np.column_stack((np.eye(dim), *(places[0] - x for x in places[1:])))
        low = np.concatenate((-self.half, [0.0] * (len(places) - 1)))
        high = np.concatenate((self.half, [1.0] * (len(places) - 1)))
        x = lsq_linear(matrix, places[0], (low, high), tol=1e-14, method="bvls").x
        link = places[0] - matrix @ x
        distance = float(np.linalg.norm(link))
        return distance, a.x + a.R @ x[:dim], a.R @ link / distance

    @property
    def gaps(self) -> list[float]:
        """Values of all gaps."""
        return [self.moved.value(row.formula) for row in self.moved.mechanism.function_rows]


CASES = [(2, 1), (2, 2), (3, 1), (3, 2)]
"""Dimension, and ends of the segment."""


@pytest.mark.parametrize(("dim", "ends"), CASES)
@FEW
@given(seed=SEEDS)
def test_the_least_gap_is_the_distance_of_the_shapes(dim, ends, seed):
    found = Touching(seed, dim, ends, None)
    assert min(found.gaps) == pytest.approx(found.nearest()[0] - sum(RADII), abs=1e-7)


@pytest.mark.parametrize(("dim", "ends"), CASES)
@FEW
@given(seed=SEEDS)
def test_where_they_touch_rates_are_those_of_the_materials(dim, ends, seed):
    found = Touching(seed, dim, ends, 0.0)
    a, b, n = found.poses["a"], found.poses["b"], found.normal
    place = found.place + RADII[0] * n
    sliding = b.velocity(place) - a.velocity(place)
    gaps, mechanism = found.gaps, found.moved.mechanism
    closed = int(np.argmin(np.abs(gaps)))
    assert min(gaps) == pytest.approx(0.0, abs=1e-7)
    row = mechanism.function_rows[mechanism.contacts[closed].row]
    assert rate_of(found.moved, row.formula) == pytest.approx(sliding @ n, abs=2e-5)
    friction = mechanism.frictions[mechanism.contacts[closed].friction]
    slips = [found.moved.value(mechanism.velocity_rows[k].formula) for k in friction.rows]
    across = sliding - (sliding @ n) * n
    assert np.linalg.norm(slips) == pytest.approx(np.linalg.norm(across), abs=2e-5)


def test_a_capsule_that_pierces_a_box_with_no_end_in_it_is_refused():
    drawn = bodies(3)
    drawn["b"]["position"] = [0.1, 0.2, 0.0]
    contact = {
        "type": "box", "bodies": ["a", "b"], "sizes": [[4.0, 4.0, 1.0]],
        "segment": [[0, 0, -3], [0, 0, 3]], "radii": [0, 0.1],
    }  # fmt: skip
    still = Pose(np.eye(3), np.zeros(3), np.zeros(3), np.zeros(3))
    with pytest.raises(SceneError, match="the bodies overlap by"):
        Moved({"dimension": 3, "bodies": drawn, "contacts": {"c": contact}}, {"a": still})
