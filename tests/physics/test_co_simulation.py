"""Coupled FMUs of examples/: what crosses between them is accounted for; errors fall with H."""

from __future__ import annotations

import functools
import json
import re
import sys
import tempfile
from pathlib import Path

import numpy as np
import pytest

import solver
from examples import __main__ as examples
from examples import balance, couple
from examples.unit import open_units

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

ROOT = Path(__file__).resolve().parents[2]
STEPS = (0.01, 0.005, 0.0025)
SAMPLE = 0.01
"""s: where runs of different steps are compared."""
_FOLDER = tempfile.TemporaryDirectory(prefix="coupled-", ignore_cleanup_errors=True)


@functools.cache
def fmus() -> dict[str, Path]:
    return examples.build_coupled(Path(_FOLDER.name))


@functools.cache
def coupled(scheme: str, h: float) -> couple.Run:
    with open_units(fmus()) as units:
        return couple.run_coupled(units, couple.SCHEMES[scheme], h, round(examples.STOP_TIME / h))


@functools.cache
def whole() -> np.ndarray:
    """Positions of the two points where both mechanisms and the spring are one scene, m."""
    parts = [
        tomllib.loads((ROOT / f"examples/{name}.toml").read_text()) for name in ("swing", "rocker")
    ]
    spring = {"type": "spring", "points": ["tip", "corner"], "stiffness": 40.0, "free_length": 1.0}
    scene = {
        **{key: parts[0][key] for key in ("dimension", "gravity")},
        **{key: parts[0][key] | parts[1][key] for key in ("points", "bodies")},
        "name": "whole",
        "forces": {"spring": spring},
        "solver": {"step_size": 0.001, "order": 4},
    }
    model = solver.assemble(solver.loads(json.dumps(scene), format="json"))
    run = solver.simulate(model, stop_time=examples.STOP_TIME, step_size=SAMPLE)
    return np.transpose([run[name] for name in ("tip.x", "tip.y", "corner.x", "corner.y")])


def position_error(scheme: str, h: float) -> float:
    """Largest error of the two points against the one scene, m."""
    positions = np.array(coupled(scheme, h).positions)[:: round(SAMPLE / h)]
    return float(np.abs(positions - whole()).max())


def orders(errors: list[float]) -> np.ndarray:
    """Observed orders of an error over steps that are halved."""
    return -np.diff(np.log2(errors))


@pytest.mark.parametrize("scheme", couple.SCHEMES)
def test_the_energy_of_all_fmus_changes_by_the_sum_of_their_works(scheme):
    # Each ledger closes to round-off, hundreds of steps of some 7 J, however wrong the coupling is.
    run = coupled(scheme, 0.005)
    change = np.array(run.energy) - run.energy[0]
    assert change == pytest.approx(np.array(run.work), abs=1e-12)
    assert np.ptp(np.array(run.works), axis=0).min() > 0.5  # J: each gives or takes


@pytest.mark.parametrize("scheme", ["parallel", "sequential"])
def test_a_held_force_makes_errors_of_first_order_in_energy_and_position(scheme):
    # The asymptotic slope is 1; terms of second order are still seen at these steps.
    energy = orders([coupled(scheme, h).drift for h in STEPS])
    assert np.all(energy > 0.9)
    assert energy[-1] < 1.3
    assert orders([position_error(scheme, h) for h in STEPS]) == pytest.approx(1.0, abs=0.1)


def test_the_discrete_gradient_of_the_spring_couples_without_loss_and_to_second_order():
    for h in STEPS:
        assert coupled("conserving", h).drift < examples.ROUND_OFF
    errors = [position_error("conserving", h) for h in STEPS]
    assert orders(errors) == pytest.approx(2.0, abs=0.05)
    assert errors[0] < 0.02 * position_error("sequential", STEPS[0])


def test_the_conserving_force_does_what_the_spring_stores():
    d_n, d_n1, k, l0 = [1.2, -0.3], [0.7, 0.9], 40.0, 1.0
    force = couple.discrete_gradient(d_n, d_n1, k, l0)
    stored = [0.5 * k * (np.hypot(*d) - l0) ** 2 for d in (d_n, d_n1)]
    assert np.dot(force, np.subtract(d_n1, d_n)) == pytest.approx(np.diff(stored)[0], rel=1e-14)


def test_the_page_has_the_figures_of_today():
    page = (ROOT / "docs" / "co_simulation.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| [\d.]+ \| .*$", page, re.MULTILINE)
    today = examples.coupled_rows(fmus())
    assert len(rows) == len(today)
    for row, measured in zip(rows, today, strict=True):
        *numbers, last = row.strip("| ").split(" | ")
        *figures, now = measured.strip("| ").split(" | ")
        assert [*map(float, numbers)] == pytest.approx([*map(float, figures)], rel=0.05)
        assert last == now


# --------------------------------------------------------------------------- cart, controller


@pytest.fixture(scope="module")
def cart_paths(tmp_path_factory):
    folder = tmp_path_factory.mktemp("balance")
    cart = examples.build(ROOT / "examples" / "cart_pole.toml", folder / "cart_pole.fmu")
    return {"cart": cart, "controller": balance.build_controller(folder)}


def test_a_controller_fmu_of_pythonfmu_keeps_the_pole_upright_and_its_work_is_booked(cart_paths):
    for _ in range(3):  # instances of both, one after the other
        with open_units(cart_paths) as units:
            run = balance.run_balanced(units["cart"], units["controller"], 0.01, 1000)
        assert abs(run.lean[-1]) < 1e-4 < run.lean[0]
        # 0.07 J flow to and fro in a thousand products: round-off of 1e-14 J.
        assert run.given == pytest.approx(run.work, abs=1e-12)
        assert max(run.work) > 1e-2


def test_without_the_controller_the_pole_falls():
    run = solver.simulate(ROOT / "examples" / "cart_pole.toml", stop_time=2.0, step_size=0.05)
    assert abs(run["lean"]).max() > 1.5
