"""Lean factors, without stiffness, change the path of Newton's iteration, not where it ends."""

from __future__ import annotations

import json

import numpy as np
import pytest

import solver
from solver.runtime import Integrator, Model
from solver.runtime.layout import ISLAND
from tests.support.mechanisms.problems import chain, double_pendulum

FALLBACK = 64
"""Steps for which full factors are used after lean ones contracted badly for the first time."""


def assembled(content, **settings) -> Model:
    """Model of a content with settings of the solver."""
    text = json.dumps(content | {"solver": settings})
    return solver.assemble(solver.loads(text, name="chain.json", format="json"))


def moved(model: Model, steps: int) -> tuple[np.ndarray, dict[str, float], float]:
    """Coordinates after some internal steps, memory of the island, Newton iterations a half."""
    integrator = Integrator(model)
    integrator.initialise()
    h = float(integrator["solver.step_size"])
    iterations, halves = 0.0, 0.0
    for _ in range(steps):
        integrator.advance(integrator.time, h)
        iterations += float(integrator["solver.newton_iterations"])
        halves += float(integrator["solver.substeps"])
    vectors = integrator.state.vectors
    island = dict(zip(ISLAND, vectors["islands"], strict=True))
    return np.array(vectors["q"]), island, iterations / halves


def without_lean(model: Model) -> Model:
    """The same model for which full factors alone are known."""
    return model._replace(sizes=dict(model.sizes) | {"n_lean_values": 0})


def test_lean_factors_exist_only_where_they_save_half_the_products():
    lean = assembled(chain(20, dimension=3))
    assert 0 < 2 * len(lean.tables["lean_lu_target"]) <= len(lean.tables["lu_target"])
    assert lean.sizes["n_lean_values"] == lean.tables["lean_lu_ptr"][-1]
    small = assembled(double_pendulum())
    assert small.sizes["n_lean_values"] == 0
    assert not len(small.tables["lean_lu_target"])


def test_a_chain_moves_alike_with_lean_and_with_full_factors():
    # Both end at round-off: 2e-16 of positions of 2 m, over 100 steps that turn the links by 0.3
    # rad, in which a difference grows no faster than linearly. Short steps: lean factors contract
    # by h^2 |mu|/(2 m) < 1e-3, so that no step falls back and none takes more than one more.
    model = assembled(chain(20, dimension=3), step_size=1e-3)
    lean, island, iterations = moved(model, 100)
    full, _, least = moved(without_lean(model), 100)
    assert lean == pytest.approx(full, abs=1e-13)
    assert island["full_wait"] == 0.0
    assert iterations <= least + 1.0


def test_long_steps_fall_back_to_full_factors_and_come_back_less_and_less():
    # At 0.05 s the links soon turn by 0.1 rad a step, and lean factors contract by more than 3e-3:
    # they are given up for 64 half steps, and then each time for twice as many.
    model = assembled(chain(20, dimension=3), step_size=0.05)
    lean, island, _ = moved(model, 4)
    full, _, _ = moved(without_lean(model), 4)
    assert island["full_wait"] == FALLBACK
    assert 0.0 < island["full_steps"] < FALLBACK
    assert lean == pytest.approx(full, abs=1e-12)
    _, island, _ = moved(model, FALLBACK)
    assert island["full_wait"] == 2 * FALLBACK
