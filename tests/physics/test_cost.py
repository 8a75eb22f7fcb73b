"""Cost is linear in the number of bodies: counted, not timed.

Work of a step is Newton iterations times the operations of the factors, both known without a clock.
"""

from __future__ import annotations

import numpy as np
import pytest

from scenes.generate import hanging_chain, rigid_chain
from tests.support.mechanisms.problems import (
    Content,
    assemble,
    chain,
    mechanism,
    observe,
    rods,
    start,
    travelling_wave,
    tree,
)
from tests.support.mechanisms.scene_files import tomllib

DIMENSIONS = pytest.mark.parametrize("dimension", [2, 3], ids=["plane", "space"])


def chain_of_bars(n: int, *, dimension: int = 2) -> Content:
    """Uniform bars hung on each other: masses couple the points too."""
    content = chain(n, dimension=dimension, mass=0.0)
    bodies = {
        name: {"type": "bar", "points": joint["points"], "mass": 1.0}
        for name, joint in content["joints"].items()
    }
    return content | {"name": f"bars{n}", "joints": {}, "bodies": bodies}


def star(n: int, *, dimension: int = 2) -> Content:
    """N points on rods round one hub: a point that all rows share."""
    angles = 2 * np.pi * np.arange(n) / n
    flat = np.stack([np.cos(angles), np.sin(angles), 0 * angles], axis=-1)[:, :dimension]
    points = {f"P{i}": {"position": place.tolist(), "mass": 1.0} for i, place in enumerate(flat)}
    points["hub"] = {"position": [0.0] * dimension, "mass": 1.0}
    return mechanism(
        f"star{n}", dimension, points=points, joints=rods(("hub", f"P{i}") for i in range(n))
    )


def stored_and_updated(content: Content) -> tuple[int, int]:
    """Entries of the factors, and products of one factorisation."""
    model = assemble(content)
    return model.sizes["n_lu_values"], len(model.tables["lu_target"])


@DIMENSIONS
@pytest.mark.parametrize("build", [chain, chain_of_bars, tree, star])
def test_factors_of_chains_and_trees_grow_exactly_linearly(build, dimension):
    # From ten bodies on every further one costs the same. The sizes are those of complete binary
    # trees, whose last level is always half of all.
    sizes = np.array([15, 31, 63, 127, 255])
    counts = np.array([stored_and_updated(build(n, dimension=dimension)) for n in sizes])
    slopes = np.diff(counts, axis=0) / np.diff(sizes)[:, np.newaxis]
    assert (slopes == slopes[0]).all()


@DIMENSIONS
def test_a_chain_has_no_fill_in_beyond_its_neighbours(dimension):
    # A node with its row and its neighbour: (d^2 + (d + 1)^2 + ...) stays below the full block of
    # two nodes and two rows.
    stored, updated = stored_and_updated(chain(1000, dimension=dimension))
    block = 2 * (dimension + 1)
    assert stored < 1000 * block**2
    assert updated < 1000 * block**3


@DIMENSIONS
def test_newton_iterations_do_not_grow_with_the_number_of_links(dimension):
    # A straight spatial chain with a wave of velocity, half steps of 1 ms. Round-off of longer
    # chains may cost one iteration more or less, not a factor.
    mean = {}
    for n in (10, 100, 1000):
        names = [
            "solver.newton_iterations",
            "solver.substeps",
            "energy.error",
            "constraint.position",
        ]
        integrator = start(travelling_wave(n, dimension), h=2e-3)
        iterations, substeps, energy, constraint = observe(integrator, 2e-3, 50, names)[1:].T
        assert substeps.max() == 2
        assert energy.max() < 1e-12
        assert constraint.max() < 1e-12
        mean[n] = iterations.mean() / 2.0
    assert max(mean.values()) < 5
    assert mean[1000] < mean[10] + 1


def test_long_chains_of_bodies_take_as_few_increments_as_short_ones():
    # Hinged bodies let go from the horizontal: the least eigenvalue of G M^-1 G' falls like 1/N^2.
    # With the penalty 1e8 for all, a chain of 1000 took three increments a half step, and its
    # energy was off by 1e-14.
    mean = {}
    for n in (10, 1000):
        run = start(tomllib.loads(rigid_chain(n)), h=1e-3)
        names = ["solver.newton_iterations", "energy.error", "constraint.position"]
        iterations, energy, constraint = observe(run, 1e-3, 20, names)[1:].T
        assert energy.max() < 5e-15
        assert constraint.max() < 1e-14
        mean[n] = iterations[5:].mean() / 2.0
    assert max(mean.values()) <= 2.5
    assert mean[1000] <= mean[10] + 0.2


def test_a_long_chain_between_two_nails_is_not_taken_for_one_of_dependent_rows():
    # Its last pivots are as small as those of dependent rows, whose penalty is never raised: 14 to
    # 17 increments a half step.
    run = start(tomllib.loads(hanging_chain(4000)), h=1e-3)
    names = ["solver.newton_iterations", "energy.error", "constraint.position"]
    iterations, energy, constraint = observe(run, 1e-3, 4, names)[1:].T
    assert energy.max() < 5e-15
    assert constraint.max() < 1e-14
    assert iterations.max() / 2.0 <= 8.0


def test_long_steps_take_few_increments_where_fresh_factors_pay():
    # Kept factors contract by 0.02 there: ten increments, each with one more digit and a half.
    run = start(tomllib.loads(rigid_chain(100)), h=2e-2)
    names = ["solver.newton_iterations", "energy.error"]
    iterations, energy = observe(run, 2e-2, 10, names)[1:].T
    assert energy.max() < 1e-13
    assert iterations[1:].mean() / 2.0 <= 5.0
