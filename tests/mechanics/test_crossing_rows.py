"""Gaps and slip rates of convex polyhedra, against separating axes and motions."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from tests.mechanics.test_contact_rows import Moved, bodies, posed
from tests.mechanics.test_shape_rows import rate_of
from tests.support.contact.polyhedra import Polyhedron, axes_of, cuboid, hull_of


def boxes(random: np.random.Generator) -> tuple[dict[str, Any], Polyhedron, Polyhedron]:
    sizes = random.uniform(1.0, 3.0, size=(2, 3))
    return {"type": "box", "sizes": sizes.tolist()}, cuboid(*sizes[0]), cuboid(*sizes[1])


def wedge_and_box(random: np.random.Generator) -> tuple[dict[str, Any], Polyhedron, Polyhedron]:
    wedge, file = hull_of(random.normal(size=(4, 3)))
    size = random.uniform(1.0, 3.0, size=3)
    return {"type": "convex", "file": file.text, "size": size.tolist()}, wedge, cuboid(*size)


def hulls(random: np.random.Generator) -> tuple[dict[str, Any], Polyhedron, Polyhedron]:
    one, first = hull_of(random.normal(size=(5, 3)))
    two, second = hull_of(random.normal(size=(4, 3)))
    return {"type": "convex", "file": first.text, "other_file": second.text}, one, two


class Touching:
    """Two polyhedra at random, a moved towards b until they touch, or are `distance` apart."""

    def __init__(self, seed: int, shapes: Any, distance: float = 0.0, **fields: float) -> None:
        random = np.random.default_rng(seed)
        contact, first, second = shapes(random)
        poses = {name: posed(random, 3) for name in "ab"}
        one, two = poses["a"], poses["b"]
        way = random.normal(size=3)
        axes = axes_of(first, one, second, two)
        a, b = first.corners @ one.R.T, second.corners @ two.R.T
        short = distance - ((a @ axes.T).min(0) - (b @ axes.T).max(0))
        along = axes @ way
        self.normal = axes[int(np.where(along > 0.0, short / along, np.inf).argmin())]
        one.x = two.x + float(np.where(along > 0.0, short / along, np.inf).min()) * way
        a, b, n = a + one.x, b + two.x, self.normal
        lowest = a[a @ n < (a @ n).min() + 1e-9]
        highest = b[b @ n > (b @ n).max() - 1e-9]
        self.place = (lowest if len(lowest) == 1 else highest)[0]
        self.crosses = len(lowest) == len(highest) == 2
        if self.crosses:
            matrix = np.array([lowest[1] - lowest[0], highest[0] - highest[1]]).T
            s = np.linalg.lstsq(matrix, highest[0] - lowest[0])[0][0]
            self.place = lowest[0] + s * (lowest[1] - lowest[0])
        self.sliding = one.velocity(self.place) - two.velocity(self.place)
        drawn = bodies(3)
        drawn["b"]["position"] = [19.0, 0.0, 0.0]
        contact = {"bodies": ["a", "b"], **fields} | contact
        content = {"dimension": 3, "bodies": drawn, "contacts": {"c": contact}}
        self.moved = Moved(content, poses)
        self.gaps = [self.moved.value(row.formula) for row in self.moved.mechanism.function_rows]


KINDS = pytest.mark.parametrize("shapes", [boxes, wedge_and_box, hulls])


@KINDS
@pytest.mark.parametrize("seed", range(4))
def test_a_gap_closes_where_polyhedra_touch_and_none_before(shapes, seed):
    assert min(Touching(seed, shapes).gaps) == pytest.approx(0.0, abs=1e-12)
    assert min(Touching(seed, shapes, 0.02).gaps) > 1e-4  # and less than 0.02 beside an edge


@KINDS
@pytest.mark.parametrize("seed", [4, 5])
def test_where_polyhedra_touch_rates_are_those_of_the_materials(shapes, seed):
    found = Touching(seed, shapes, friction=0.1)
    closed, mechanism, n = int(np.argmin(np.abs(found.gaps))), found.moved.mechanism, found.normal
    row = mechanism.function_rows[mechanism.contacts[closed].row]
    assert rate_of(found.moved, row.formula) == pytest.approx(found.sliding @ n, abs=1e-4)
    friction = mechanism.frictions[mechanism.contacts[closed].friction]
    slips = [found.moved.value(mechanism.velocity_rows[k].formula) for k in friction.rows]
    across = found.sliding - (found.sliding @ n) * n
    assert np.linalg.norm(slips) == pytest.approx(np.linalg.norm(across), abs=1e-6)


def test_the_poses_of_these_tests_touch_at_corners_and_at_edges_that_cross():
    """Without both kinds the tests above would say less than they seem to."""
    crossing = [Touching(seed, boxes).crosses for seed in range(4)]
    assert {True, False} <= set(crossing)
