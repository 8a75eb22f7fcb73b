"""What a step leaves out changes nothing of the motion of any scene, and hardly ever costs more."""

from __future__ import annotations

import json
from functools import cache
from typing import NamedTuple

import numpy as np
import pytest
from hypothesis import HealthCheck, given
from hypothesis import settings as trials

import solver
from benchmarks.sections.skips import ALL, SKIPS
from solver.options import USUAL_STEP
from solver.runtime import Integrator, Model
from tests.support.kernel.kernel_cases import SOURCES, ZOO
from tests.support.kernel.kernels_without_skips import counted, integrator_without, needs_compiler
from tests.support.kernel.twins import Array, model_of
from tests.support.mechanisms.random_mechanisms import driven_systems, free_systems

SCENES = SOURCES | ZOO
STEPS = {2: 100, 4: 40, 8: 15}
"""Internal steps by order: some hundred half steps of each."""
MOST = 1.02
"""A skip costs at most so many times the iterations or products of a kernel without it."""

TRADES = ("stiffness", "factorisation", "fresh factors", "all")
"""Skips that take some iterations more for fewer products of factors and solves."""

DEARER = {
    ("fresh factors", "bifilar", 2, "products"): 1.31,
    ("stiffness", "differential", 2, "products"): 1.04,
    ("fresh factors", "differential", 2, "products"): 1.03,
    ("fresh factors", "double_pendulum", 2, "products"): 1.03,
    ("stiffness", "double_wishbone", 2, "products"): 1.03,
    ("fresh factors", "dzhanibekov", 2, "products"): 1.04,
    ("stiffness", "flyball_governor", 2, "products"): 1.03,
    ("fresh factors", "gears and a cam in the plane", 2, "products"): 1.03,
    ("fresh factors", "pendulum", 2, "products"): 1.04,
    ("old guess", "spring_pendulum", 2, "iterations"): 1.18,
    ("islands", "zoo in space", 2, "iterations"): 1.06,
    ("stiffness", "differential", 4, "products"): 1.03,
    ("islands", "zoo in space", 4, "iterations"): 1.07,
    ("outer iteration", "bifilar", 4, "iterations"): 1.11,
    ("fresh factors", "bifilar", 4, "products"): 1.09,
    ("outer iteration", "bifilar", 8, "iterations"): 1.13,
    ("fresh factors", "bifilar", 8, "products"): 1.14,
    ("low penalty", "double_wishbone", 8, "products"): 1.04,
    ("old guess", "flyball_governor", 8, "iterations"): 1.03,
    ("outer iteration", "pendulum", 8, "iterations"): 1.06,
    ("outer iteration", "pendulum", 8, "products"): 1.05,
    ("old guess", "pendulum", 8, "iterations"): 1.06,
    ("old guess", "pendulum", 8, "products"): 1.05,
}
"""Where a skip does not pay, by order and measure: at most so much (docs/skips.md)."""

pytestmark = needs_compiler


class Run(NamedTuple):
    """End of a run: coordinates, velocities times the step, all over the extent; its cost."""

    q: Array
    hv: Array
    iterations: float
    products: float


def moved(model: Model, bits: int, order: int, steps: int) -> Run:
    """Run of some internal steps by the kernel without these skips."""
    run = integrator_without(bits, model)
    run.state.head["order"] = float(order)
    before, iterations = counted(bits, model.sizes["dim"]), 0.0
    h = run.state.head["step_size"] or USUAL_STEP
    for _ in range(steps):
        run.advance(run.time, h)
        iterations += run.state.head["newton_iterations"]
    after = counted(bits, model.sizes["dim"])
    products = (after.products_of_factors - before.products_of_factors) + (
        after.products_of_solves - before.products_of_solves
    )
    return Run(*ends(run), iterations, products)


def ends(run: Integrator) -> tuple[Array, Array]:
    """Coordinates, and velocities times the step, over the extent of the mechanism."""
    vectors, extent = run.state.vectors, run.numbers[run.model.offsets["extent"]]
    q = np.asarray(vectors["q"]) + np.asarray(vectors["q_low"])
    h = run.state.head["step_size"] or USUAL_STEP
    return q / extent, h * np.array(vectors["v"]) / extent


@cache
def model_for(name: str, order: int) -> Model:
    """Model of a scene whose state has room for the changes of a step of this order."""
    if order == 2:
        return model_of(SCENES[name])
    source, overrides = SCENES[name], {"solver.order": order}
    load = solver.loads if isinstance(source, str) else solver.load
    return solver.assemble(load(source, overrides=overrides))


def assert_alike(ours: Run, theirs: Run, tolerance: float) -> None:
    """Every step is solved to less than the tolerance of its size, and steps are smooth."""
    assert np.max(np.abs(ours.q - theirs.q), initial=0.0) <= 10.0 * tolerance
    assert np.max(np.abs(ours.hv - theirs.hv), initial=0.0) <= 10.0 * tolerance


@pytest.mark.parametrize("order", STEPS)
@pytest.mark.parametrize("name", SCENES)
def test_a_scene_moves_alike_without_each_skip_and_costs_no_more_with_it(name, order):
    model = model_for(name, order)
    with_all = moved(model, 0, order, STEPS[order])
    for skip, bits in [*SKIPS.items(), ("all", ALL)]:
        without = moved(model, bits, order, STEPS[order])
        assert_alike(with_all, without, 1e-12)
        for measure in ("products",) if skip in TRADES else ("iterations", "products"):
            ratio = getattr(with_all, measure) / max(getattr(without, measure), 1.0)
            most = DEARER.get((skip, name, order, measure), MOST)
            assert ratio <= most, f"{skip} takes {ratio:.3f} times the {measure}"


@trials(max_examples=25, suppress_health_check=list(HealthCheck))
@given(free_systems())
def test_a_free_mechanism_moves_alike_without_skips(drawn):
    content, h = drawn
    assert_alike_without_skips(content, h)


@trials(max_examples=25, suppress_health_check=list(HealthCheck))
@given(driven_systems())
def test_a_driven_mechanism_moves_alike_without_skips(content):
    assert_alike_without_skips(content, 0.01)


def assert_alike_without_skips(content, h: float) -> None:
    content = content | {"solver": {"step_size": h}}
    model = solver.assemble(solver.loads(json.dumps(content), format="json"))
    with_all = moved(model, 0, 2, 20)
    for bits in (*SKIPS.values(), ALL):
        # Loops may be nearly stretched: rounding is then multiplied, more from step to step.
        assert_alike(with_all, moved(model, bits, 2, 20), 1e-10)
