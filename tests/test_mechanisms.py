"""What holds for every mechanism in `scenes/`: energy and constraints stay exact."""

from __future__ import annotations

import pytest

import solver
from tests.mechanism_runs import SCENES

MECHANISMS = sorted(SCENES.glob("*.toml"))
STEPS = 200


@pytest.mark.parametrize("path", MECHANISMS, ids=lambda path: path.stem)
def test_energy_is_balanced_and_no_joint_opens(path):
    # Solved to 1e-12 in each step, 200 of which do not add up: errors are not of one sign.
    scene = solver.load(path)
    every = scene.experiment.step_size
    count = max(1, round(STEPS * scene.solver.step_size / every))
    found = solver.simulate(
        scene, stop_time=count * every, outputs=["energy.error", "constraint.position"]
    )
    assert found["energy.error"].max() < 1e-11
    assert found["constraint.position"].max() < 1e-12
