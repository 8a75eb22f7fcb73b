"""What a step leaves out where it can changes its cost, not the motion."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from benchmarks.measuring.effort import TINY
from benchmarks.sections import skips
from build_kernel.compiler import CompilerError
from solver.options import step_of
from solver.runtime.kernel import load_library
from tests.support.kernel.kernels_without_skips import kernel_without, needs_compiler

ROOT = Path(__file__).resolve().parents[2]
STEPS = 100
ROUND_OFF = 1e-12
MODELS = skips.mechanisms(10) | {"chain": (skips.model_of(skips.waving_chain(30, 3)), 30)}


def moved(model, library, steps=STEPS):
    """Step [s], positions and velocities after some internal steps, and their solves."""
    integrator = skips.bound(model, library)
    h = step_of(model.settings)
    solved = np.zeros(2)
    for _ in range(steps):
        integrator.advance(integrator.time, h)
        solved += [float(integrator[f"solver.{n}"]) for n in ("newton_iterations", "substeps")]
    q, v = (np.array(integrator.state.vectors[name]) for name in ("q", "v"))
    return h, q, v, solved[0] / solved[1]


def delivered(model):
    """The same by the kernel that is delivered."""
    return moved(model, load_library(model.sizes["dim"]))


@cache
def reference(name):
    """The same of a mechanism of MODELS, by the kernel that is delivered."""
    return delivered(MODELS[name][0])


@needs_compiler
@pytest.mark.parametrize(
    ("skip", "mechanism", "saved"),
    [
        ("old guess", "spatial rigid chain, N = 10", 0.7),
        ("low penalty", "andrews", 0.5),
    ],
)
def test_skips_that_save_iterations_save_them(skip, mechanism, saved):
    # A third to a half of what is measured; counts are the same on every machine.
    model, _ = MODELS[mechanism]
    *_, least = reference(mechanism)
    *_, more = moved(model, kernel_without(skips.SKIPS[skip], model.sizes["dim"]))
    assert more > least + saved


def test_the_benchmark_knows_every_skip_of_the_kernel_and_the_page_lists_it():
    header = (ROOT / "solver" / "kernel" / "internal.h").read_text(encoding="utf-8")
    page = (ROOT / "docs" / "skips.md").read_text(encoding="utf-8")
    bits = {
        n.lower().replace("_", " "): int(b) for n, b in re.findall(r"SKIP_(\w+) = (\d+)", header)
    }
    assert bits == skips.SKIPS
    for name in bits:
        assert f"| {name} |" in page


@needs_compiler
@pytest.mark.long
def test_the_benchmark_compiles_kernels_without_skips():
    model, _ = MODELS["heavy_top"]
    _, q, *_ = moved(model, skips.variant(skips.ALL, 3))
    _, expected, *_ = moved(model, kernel_without(skips.ALL, 3))
    assert q == pytest.approx(expected, abs=ROUND_OFF)


def test_scenes_that_are_compared_move_alike():
    for cheap, dear, _ in skips.pairs(10).values():
        _, q, *_ = delivered(cheap)
        _, q_dear, *_ = delivered(dear)
        in_plane = q_dear.reshape(-1, dear.sizes["dim"])[:, :2].ravel()
        # Rows of a formula are solved to the tolerance of a row's round-off: 1e-12 of 2 m.
        assert in_plane == pytest.approx(q, abs=ROUND_OFF * np.abs(q).max())


def test_without_a_compiler_a_sentence_stands_for_the_kernels(monkeypatch):
    def refuse(*_):
        message = "there is no C compiler here"
        raise CompilerError(message)

    monkeypatch.setattr(skips, "variants", refuse)
    section = skips.measure(TINY)
    assert "no C compiler" in section.remarks[0]
    assert all("Time without" not in table.title for table in section.tables)
