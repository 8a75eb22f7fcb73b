"""Distances to a mesh: as exact as they say, and the finer the grid the more."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from solver.mechanics.distance_grid import distance_grid, spread
from solver.mechanics.meshes import accuracy
from solver.runtime import Integrator
from solver.scene import SceneError
from solver.scene.expression import apply
from tests.support.contact.meshes import box, ellipsoid
from tests.support.mechanisms.problems import Content, assemble, mechanism, start

Array = NDArray[np.float64]
SIZE = np.array([1.0, 0.6, 0.4])


def of_the_box(x: Array) -> float:
    """Signed distance to a box."""
    beyond = np.abs(x) - 0.5 * SIZE
    return float(np.linalg.norm(np.maximum(beyond, 0.0)) + min(0.0, beyond.max()))


def near_the_surface(spacing: float, count: int = 300) -> list[Array]:
    random = np.random.default_rng(2)
    places = random.uniform(-0.6, 0.6, (20 * count, 3))
    return [x for x in places if abs(of_the_box(x)) <= spacing][:count]


def error(spacing: float) -> Array:
    grid = distance_grid(box(*SIZE), 1.0, spacing, 0.0).grid
    places = near_the_surface(spacing)
    return np.array([apply("grid", *x, grid) - of_the_box(x) for x in places])


def test_distances_to_a_box_are_as_exact_as_the_grid_says():
    found = distance_grid(box(*SIZE), 1.0, 0.05, 0.0)
    errors = error(0.05)
    assert np.abs(errors).max() <= 1.2 * found.largest_error  # other random places
    assert np.sqrt(np.mean(errors**2)) <= 1.5 * found.mean_error
    assert found.largest_error <= 0.25 * found.spacing  # edges are rounded off within a cell


def test_far_from_edges_distances_to_a_box_are_exact():
    """A spline reproduces what is linear.

    What edges and the middle of the box do to it, 7 cells away, falls by 0.27 from cell to cell.
    """
    found = distance_grid(box(*SIZE), 1.0, 0.02, 0.0)
    for x in np.random.default_rng(3).uniform(-0.06, 0.06, (50, 3)):
        place = x + np.array([0.1, 0.0, 0.2])
        assert apply("grid", *place, found.grid) == pytest.approx(place[2] - 0.2, abs=1e-6)
        slopes = [apply(f"grid_{axis}", *place, found.grid) for axis in "xyz"]
        assert slopes == pytest.approx([0.0, 0.0, 1.0], abs=1e-4)


def test_errors_at_edges_fall_with_the_cells_and_of_smooth_surfaces_faster():
    edges = [distance_grid(box(*SIZE), 1.0, h, 0.0).largest_error for h in (0.08, 0.04)]
    assert edges[0] / edges[1] == pytest.approx(2.0, rel=0.3)
    smooth = [distance_grid(ellipsoid(5, (1, 1, 1)), 1.0, h, 0.0) for h in (0.4, 0.2)]
    assert smooth[0].mean_error / smooth[1].mean_error > 12.0


def test_slopes_are_differences_of_distances():
    grid = distance_grid(ellipsoid(2), 1.0, 0.1, 0.2).grid
    for x in np.random.default_rng(4).uniform(-0.9, 0.9, (30, 3)):
        for axis, step in zip("xyz", 1e-5 * np.eye(3), strict=True):
            ends = [apply("grid", *(x + s), grid) for s in (-step, step)]
            slope = apply(f"grid_{axis}", *x, grid)
            assert slope == pytest.approx((ends[1] - ends[0]) / 2e-5, abs=1e-7)


def gap_at(place: list[float], **contact: Any) -> float:
    content: Content = mechanism(
        "ball", 3,
        points={"A": {"position": place, "mass": 1.0}},
        contacts={"c": {"type": "mesh", "point": "A", "resolution": 0.05} | contact},
    )  # fmt: skip
    value = start(content)["c.gap"]
    assert isinstance(value, float)
    return value


def test_beyond_the_grid_the_gap_grows_with_the_way_and_never_jumps():
    """The grid ends 0.1 m from the box; what it adds is rounded off within a cell of 0.05 m."""
    text = box(*SIZE).text
    heights = [0.29, 0.2999, 0.3001, 0.32, 0.5, 3.0, 300.0]
    gaps = [gap_at([0.0, 0.0, z], file=text) for z in heights]
    assert gaps[1] == pytest.approx(gaps[2], abs=3e-4)
    assert np.diff(gaps).min() > 0.0
    for z, gap in zip(heights, gaps, strict=True):
        assert z - 0.2 - 0.05 <= gap <= z - 0.2 + 1e-3


@pytest.mark.parametrize(
    ("height", "deeper", "contact"),
    [(0.5, 1e-4, {"ball_radius": 0.3}), (0.15, 4e-4, {"side": "inside", "ball_radius": 0.05})],
)
def test_a_ball_touches_where_its_radius_is_the_distance(height, deeper, contact):
    """Drawn deeper by less than the error of the grid it touches, too; by more it is refused."""
    contact["file"] = box(*SIZE).text
    inwards = -1.0 if "side" not in contact else 1.0
    assert gap_at([0.1, 0.0, height], **contact) == pytest.approx(0.0, abs=3e-4)
    assert gap_at([0.1, 0.0, height + deeper * inwards], **contact) == pytest.approx(0.0, abs=1e-15)
    with pytest.raises(SceneError, match=r"drawn in penetration: its gap is -0\.0[12]"):
        gap_at([0.1, 0.0, height + 0.02 * inwards], **contact)


@pytest.mark.parametrize(
    ("height", "side", "limit"), [(3.0, "outside", r"0\.11"), (0.1, "inside", r"0\.1[0-9]")]
)
def test_a_ball_that_a_parameter_makes_larger_than_the_grid_is_refused(height, side, limit):
    file = box(*SIZE).text
    contact = {"type": "mesh", "point": "A", "file": file, "side": side, "ball_radius": "R"}
    content = mechanism(
        "ball", 3,
        parameters={"R": {"value": 0.05, "min": 0.0}},
        points={"A": {"position": [0, 0, height], "mass": 1.0}},
        contacts={"c": contact},
    )  # fmt: skip
    run = Integrator(assemble(content))
    run["R"] = 0.2
    with pytest.raises(
        Exception, match=rf"ball_radius must be < {limit}.* m, what the grid has {side}"
    ):
        run.initialise()


def test_corners_are_thinned_to_those_farthest_apart():
    corners = np.random.default_rng(1).normal(size=(200, 3))
    chosen, left = spread(corners, 40)
    assert len(chosen) == 40
    ways = np.linalg.norm(corners[:, None] - chosen[None], axis=-1).min(axis=1)
    assert ways.max() == pytest.approx(left)
    between = np.linalg.norm(chosen[:, None] - chosen[None], axis=-1)
    assert between[~np.eye(40, dtype=bool)].min() >= left
    assert spread(corners, 500)[1] == 0.0


def test_distances_that_are_far_from_exact_are_told():
    rough = {"file": "a.stl", "largest_error": 0.02, "size": 1.0, "resolution": 0.1}
    (sentence,) = accuracy("c", rough)
    assert sentence == (
        "contact 'c': distances to the mesh 'a.stl' are up to 0.02 m from exact ones, 2 % of its "
        "size; a resolution below 0.1 m makes them more exact"
    )
    assert not [*accuracy("c", rough | {"largest_error": 0.009})]
