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
from tests.exact_motions import four_bar_angle
from tests.mechanism_runs import extrapolated, run, times, vector
from tests.newton_euler import GROUND, Mechanism, hinge
from tests.reduced_models import Array, bars_in_motion

QUIET = ["energy.error", "constraint.position"]


def chain_of_bars(n: int, places: Array, mass: float, t: Array, *, both_ends: bool) -> Array:
    """Motion (len(t), n, 2) of the pins 1 to n of a chain of n bars."""
    points = {f"P{i}": place for i, place in enumerate(places)}
    bars = [(f"P{i}", f"P{i + 1}", mass) for i in range(n)]
    fixed = {"P0", f"P{n}"} if both_ends else {"P0"}
    slack = ("P0", np.array([0.0, 9.0]), 0.0, 0.0)
    moved = bars_in_motion(points, fixed, bars, slack, t)
    return np.stack([moved[f"P{i}"] for i in range(1, n + 1)], axis=1)


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


def test_a_chain_of_rigid_bodies_in_the_plane_falls_as_a_chain_of_bars():
    t = times(0.5, 0.1)
    places = np.array([[0.1 * i, 0.0] for i in range(4)])
    pins = chain_of_bars(3, places, 0.1, t, both_ends=False)
    middles = 0.5 * (pins + np.concatenate([np.zeros((len(t), 1, 2)), pins[:, :-1]], axis=1))
    names = [name for i in (1, 2, 3) for name in vector(f"link{i}", axes="xy")]
    found = extrapolated(solver.loads(rigid_chain(3, 2)), names, 0.002, 0.5, every=0.1)
    assert found == pytest.approx(middles.reshape(len(t), -1), abs=1e-6)


def test_a_chain_of_rigid_bodies_in_space_falls_as_newton_and_euler_say():
    n, t = 4, times(0.4, 0.1)
    places = np.array([[0.1 * i + 0.05, 0.0, 0.0] for i in range(n)] + [[0.0, 0.0, 0.0]])
    rows = []
    for i in range(n):
        body = i - 1 if i else GROUND
        axis = np.array([0.0, 1.0, 0.0] if i % 2 == 0 else [0.0, 0.0, 1.0])
        rows += hinge(body, places[body], i, places[i], np.array([0.1 * i, 0.0, 0.0]), axis)
    across, along = 0.1 * (0.1**2 + 0.02**2) / 12, 0.1 * 2 * 0.02**2 / 12
    exact, _ = Mechanism(
        np.full(n, 0.1), np.tile([along, across, across], (n, 1)), places[:n], rows,
        np.array([0.0, 0.0, -9.81]),
    ).motion(t)  # fmt: skip
    names = [name for i in range(1, n + 1) for name in vector(f"link{i}")]
    found = extrapolated(solver.loads(rigid_chain(n, 3)), names, 0.002, 0.4, every=0.1)
    assert found == pytest.approx(exact.reshape(len(t), -1), abs=1e-6)


def test_a_hanging_chain_swings_as_the_oracle():
    n, t = 6, times(1.0, 0.25)
    turn = np.pi * np.arange(n + 1) / n
    pins = chain_of_bars(
        n, np.column_stack([-np.cos(turn), -np.sin(turn)]), 1.0 / n, t, both_ends=True
    )
    names = [name for i in range(1, n) for name in vector(f"P{i}", axes="xy")]
    found = extrapolated(solver.loads(hanging_chain(n)), names, 0.002, 1.0, every=0.25)
    assert found == pytest.approx(pins[:, :-1].reshape(len(t), -1), abs=1e-6)


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
