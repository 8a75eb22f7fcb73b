"""Where a run begins: drawn inexactly, a mechanism is closed; hung, nothing accelerates it."""

from __future__ import annotations

from array import array

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from tests.oracle import Mechanism
from tests.oracle.start import first_multipliers, rows_of
from tests.oracle.step import rows_now
from tests.support.kernel.kernel_calls import kernel_of
from tests.support.kernel.kernel_cases import SOURCES, ZOO
from tests.support.kernel.twins import Array, model_of, start, vector

ALL = SOURCES | ZOO


def disturbed(name: str, size: float):
    """Model drawn elsewhere: points by `size` times its extent at random, bodies turned by it."""
    model, random = model_of(ALL[name]), np.random.default_rng(1)
    dim, numbers, at = (
        model.sizes["dim"],
        np.array(model.numbers),
        model.offsets["initial_position"],
    )
    places = numbers[at : at + dim * model.sizes["n_free"]].reshape(-1, dim)
    extent, drawn = np.ptp(places), places.copy()
    places += size * extent * random.normal(size=places.shape)
    for a in model.tables["body_node"]:
        turn = Rotation.from_rotvec(
            size * random.normal(size=3) * ([1, 1, 1] if dim == 3 else [0, 0, 1])
        )
        directors = slice(a, a + 2 * dim - 3)
        places[directors] = drawn[directors] @ turn.as_matrix()[:dim, :dim].T
    return model._replace(numbers=array("d", numbers)), extent


def moved(oracle: Mechanism) -> Array:
    """What the start has changed of the free coordinates."""
    return (oracle.x - oracle.section["initial_position"])[: oracle.n_free]


@pytest.mark.parametrize("name", ALL)
def test_an_assembled_mechanism_is_closed_and_was_moved_along_its_rows_alone(name):
    model, extent = disturbed(name, 1e-4)
    run = start(model, assemble=True)
    oracle = Mechanism.of(model, run.state)
    phi, rates = kernel_of(run).residuals()
    assert phi == pytest.approx(rows_now(oracle), abs=1e-12)
    assert np.max(np.abs(phi), initial=0.0) < 1e-12 * max(1.0, extent)
    assert np.max(np.abs(rates), initial=0.0) < 1e-9
    # M d + G' mu = 0: a displacement that is stationary in d' M d.
    n, G = oracle.n_free, rows_of(oracle)[0]
    pull = oracle.M[:n, :n] @ moved(oracle)
    mu = np.linalg.lstsq(G[:, :n].T, -pull, rcond=None)[0]
    assert G[:, :n].T @ mu == pytest.approx(-pull, abs=1e-9 * np.max(np.abs(pull)) + 1e-13)


@pytest.mark.parametrize("name", ["double_pendulum", "spring_pendulum", "triangle", "watt"])
def test_in_equilibrium_nothing_accelerates(name):
    run = start(ALL[name], assemble=True, start="equilibrium")
    oracle = Mechanism.of(run.model, run.state)
    assert np.max(np.abs(moved(oracle))) > 0.01
    assert not vector(run, "v").any()
    # displacements of the last step are 1e-10 of the size, with 1e3 and more step sizes
    assert np.max(np.abs(first_multipliers(oracle)[1])) < 1e-8
