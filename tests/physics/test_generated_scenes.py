"""Scenes written by a program: chains and loops of any size."""

from __future__ import annotations

import math
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from scipy.optimize import brentq

import solver
from scenes.generate import GENERATORS, hanging_chain, n_four_bar, rigid_chain
from tests.support.mechanisms.exact_motions import four_bar_angle
from tests.support.mechanisms.mechanism_runs import extrapolated, run, times, vector

QUIET = ["energy.error", "constraint.position"]


@pytest.mark.parametrize("name", GENERATORS)
@pytest.mark.parametrize("n", [2, 7])
def test_every_generated_scene_is_free_of_mistakes(name, n):
    scene = solver.loads(GENERATORS[name](n))
    assert scene.name == f"{name}_{n}"
    assert scene.description


def test_the_generator_writes_what_it_is_asked_for():
    root = Path(__file__).resolve().parents[2]
    command = [sys.executable, "-m", "scenes.generate", "hanging_chain", "3"]
    said = subprocess.run(command, capture_output=True, text=True, check=True, cwd=root).stdout
    assert said == hanging_chain(3)


def test_the_generated_four_bars_turn_as_the_benchmark():
    angle = four_bar_angle(times(2.0, 0.5), 3)
    found = extrapolated(solver.loads(n_four_bar(3)), ["B3.x", "B3.y"], 0.005, 2.0, every=0.5)
    exact = np.column_stack([3.0 + np.sin(angle), np.cos(angle)])
    assert found == pytest.approx(exact, abs=1e-5)


@pytest.mark.parametrize("n", [2, 10, 40])
def test_a_chain_at_rest_hangs_as_a_catenary_of_links(n):
    # Links of weight w between pins that pull along with H: slopes are whole or half w/H apart.
    text = hanging_chain(n).replace("[solver]", '[solver]\nstart = "equilibrium"')
    length, step = 2 * math.sin(math.pi / 2 / n), np.arange(n) - 0.5 * (n - 1)
    pull = brentq(lambda H: (length / np.hypot(1, step / H)).sum() - 2.0, 1e-6, 1e3)
    links = np.column_stack([np.ones(n), step / pull])
    links *= length / np.linalg.norm(links, axis=1, keepdims=True)
    exact = np.cumsum(links, axis=0)[:-1] - [1.0, 0.0]
    names = [name for i in range(1, n) for name in vector(f"P{i}", axes="xy")]
    found = run(solver.loads(text), names, 0.002, 0.02)
    assert found == pytest.approx(np.array([exact.ravel()] * 2), abs=1e-11)


@pytest.mark.parametrize(
    "text", [rigid_chain(40, 2), rigid_chain(20, 3), hanging_chain(100), n_four_bar(20)]
)
def test_long_chains_keep_energy_and_lengths(text):
    assert run(solver.loads(text), QUIET, 0.002, 0.2, every=0.02).max() < 1e-11


@pytest.mark.parametrize("text", [hanging_chain(1000), rigid_chain(1000, 2), rigid_chain(1000, 3)])
def test_chains_of_a_thousand_links_keep_energy_and_lengths(text):
    assert run(solver.loads(text), QUIET, 0.002, 0.1, every=0.02).max() < 1e-10
