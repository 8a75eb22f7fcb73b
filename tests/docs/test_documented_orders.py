"""What the theory and `docs/scene.md` say of orders: errors, and loads that sense."""

from __future__ import annotations

import math
import re
from pathlib import Path

import numpy as np
import pytest

import solver
from tests.support.mechanisms.exact_motions import double_pendulum_motion
from tests.support.mechanisms.mechanism_runs import run
from tests.support.mechanisms.problems import double_pendulum, observed_order
from tests.support.mechanisms.problems import scene as scene_of

PAGE = Path(__file__).resolve().parents[2] / "docs" / "theory" / "orders.md"
ROW = re.compile(r"\| ([2468]) \| (\d+) \| (\S+) \| (\S+) \|")


def test_the_table_of_errors_is_what_is_measured() -> None:
    # Two digits are printed; the motion it is compared with is good to 1e-13.
    rows = ROW.findall(PAGE.read_text(encoding="utf-8"))
    assert [row[0] for row in rows] == ["2", "4", "6", "8"]
    names = [f"{point}.{part}" for part in ("x", "y", "vx", "vy") for point in "AB"]
    q, v = double_pendulum_motion(np.array([0.0, 2.0]), math.pi / 6)
    exact = np.concatenate([q[-1].T.ravel(), v[-1].T.ravel()])
    drawn = scene_of(double_pendulum(math.pi / 6))
    for order, solved, of_places, of_rates in rows:
        outputs = [*names, "solver.substeps"]
        *values, steps = run(drawn, outputs, 0.05, 2.0, order=int(order))[-1]
        errors = np.abs(np.array(values) - exact)
        assert steps == int(solved)
        assert errors[:4].max() == pytest.approx(float(of_places), rel=0.1)
        assert errors[4:].max() == pytest.approx(float(of_rates), rel=0.1)


PENDULUM = """
name = "pendulum"
dimension = 2
gravity = [0, -9.81]
[points]
O = { position = [0, 0], fixed = true }
A = { position = [0.6, -0.8], mass = 1.0 }
[joints]
rod = { type = "distance", points = ["O", "A"] }
[forces.push]
"""


@pytest.mark.parametrize("order", [4, 8])
@pytest.mark.parametrize(
    ("value", "kept"),
    [('["-2*A.x", "0.5*A.y*A.x"]', 3), ('["-0.5*A.vx", "-0.5*A.vy"]', 2)],
    ids=["positions", "velocities"],
)
def test_a_force_that_senses_holds_the_order_that_is_documented(value, kept, order) -> None:
    # Differences of neighbours in a row of halved steps fall like the errors themselves.
    drawn = solver.loads(PENDULUM + f'type = "force"\npoint = "A"\nvalue = {value}\n')
    steps = [0.05, 0.025, 0.0125, 0.00625]
    names = ["A.x", "A.y", "A.vx", "A.vy"]
    ends = [run(drawn, names, h, 1.0, order=order)[-1] for h in steps]
    errors = np.abs(np.diff(ends, axis=0)).max(axis=1)
    assert observed_order(steps[:-1], errors) > kept - 0.1


@pytest.mark.parametrize(
    "text",
    [
        'type = "spring"\npoints = ["ground", "A"]\nat = [1, 0]\nstiffness = 5.0\n',
        'type = "potential"\nvalue = "A.x**2 - A.x*A.y**2/6"\n',
        'type = "force"\npoint = "A"\nvalue = ["sin(3*t)", 0]\n',
    ],
    ids=["spring", "potential", "load of time"],
)
def test_what_does_not_sense_keeps_the_order(text) -> None:
    drawn = solver.loads(PENDULUM + text)
    steps = [0.1, 0.05, 0.025]
    names = ["A.x", "A.y", "A.vx", "A.vy"]
    ends = [run(drawn, names, h, 1.0, order=4)[-1] for h in steps]
    errors = np.abs(np.diff(ends, axis=0)).max(axis=1)
    assert observed_order(steps[:-1], errors) > 3.8
