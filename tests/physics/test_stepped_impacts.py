"""Stepped contacts land by the law of located ones: losses are the same as the step falls."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import solver
from solver.runtime import Integrator
from tests.support.contact.contact_events import number
from tests.support.mechanisms.scene_files import SCENES

ROD, BOX, BALL = (
    [[-0.5, 0], [0.5, 0]],
    [[-0.2, -0.1], [0.2, -0.1], [0.2, 0.1], [-0.2, 0.1]],
    [[0, 0]],
)
FALLS: dict[str, tuple[Any, float, list[float], list[float], float, float, float, float]] = {
    "rod, elastic": (ROD, 1 / 12, [0, 0.5, 0.5], [1, 0, 0], 0.0, 1.0, 0.4, 0.0),
    "rod, hardly rubs": (ROD, 1 / 12, [0, 0.5, 0.5], [1, 0, 0], 1e-9, 1.0, 0.4, 6.667e-9),
    "rod, 0.9": (ROD, 1 / 12, [0, 0.5, 0.5], [1, 0, 0], 0.1, 0.9, 0.4, 1.678586694308),
    "rod, rubs": (ROD, 1 / 12, [0, 0.5, 0.5], [1, 0, 0], 0.5, 1.0, 0.4, 1.179038590145),
    "rod, sticks": (ROD, 1 / 12, [0, 0.5, 0.5], [1, 0, 0], 1.0, 0.5, 0.3, 0.626779909050),
    "box": (BOX, 0.02, [0, 0.6, 0.3], [0.5, 0, 1], 0.3, 0.8, 0.5, 1.653941175701),
    "box, elastic": (BOX, 0.02, [0, 0.6, 0.3], [0.5, 0, 1], 0.0, 1.0, 0.5, 0.0),
    "box, rubs": (BOX, 0.02, [0, 0.6, 0.3], [2, 0, -1], 0.8, 0.6, 0.5, 6.279779410418),
    "box, fast": (BOX, 0.02, [0, 0.8, 1.0], [-1, -1, 3], 0.2, 0.7, 0.4, 3.621430613852),
    "ball": (BALL, 0.02, [0, 1.0, 0], [1, 0, 0], 0.2, 0.8, 1.5, 6.291824),
}
"""Corners, inertia, pose and rates at the start, friction, restitution, end [s]; what is lost [J].

Losses are those of flights and impacts computed apart, in NumPy, by the law of theory 10.3.
"""


def fall(name: str, half_step: float | None) -> tuple[np.ndarray, float]:
    """Pose of a body at the end, and what it has lost; in located mode without a step."""
    corners, inertia, pose, rates, friction, restitution, end, _ = FALLS[name]
    points = ", ".join(f"c{i} = {corner}" for i, corner in enumerate(corners))
    law = f"axis = [0, 1], friction = {friction}, restitution = {restitution}"
    contacts = "\n".join(
        f'c{i} = {{ type = "plane", point = "b.c{i}", {law} }}' for i in range(len(corners))
    )
    text = f"""name = "fall"
dimension = 2
gravity = [0, -9.81]
[bodies.b]
position = {pose[:2]}
orientation = {pose[2]}
velocity = {rates[:2]}
angular_velocity = {rates[2]}
mass = 1
inertia = {inertia}
points = {{ {points} }}
[contacts]
{contacts}
"""
    run = Integrator(solver.assemble(solver.loads(text)))
    run["solver.contact_mode"] = "stepped" if half_step else "located"
    run["solver.step_size"], run["solver.order"] = (
        (2 * half_step, 2.0) if half_step else (1e-3, 4.0)
    )
    run.initialise()
    for k in range(20):
        run.advance(end / 20 * k, end / 20)
    assert number(run, "energy.error") < 1e-12
    place = np.array([number(run, f"b.{word}") for word in ("x", "y", "angle")])
    return place, number(run, "energy.dissipated")


@pytest.mark.parametrize("name", FALLS)
def test_what_falls_loses_what_the_law_says_as_the_step_falls(name):
    """Errors are of first order: 20 J/s of the loss, 80 /s of the pose, and smaller at a ninth.

    The box hits twice; its second corner multiplies the error of the first one by some ten.
    """
    located, exact = fall(name, None), FALLS[name][-1]
    assert located[1] == pytest.approx(exact, abs=1e-9)
    errors = []
    for half_step in (2.1e-3, 7e-4, 7e-4 / 3):
        pose, loss = fall(name, half_step)
        errors.append(np.abs(pose - located[0]).max())
        if exact == 0.0 or name == "ball":  # straight gap, or nothing to be lost: at any step
            assert loss == pytest.approx(exact, abs=1e-12)
        assert loss == pytest.approx(exact, abs=20 * half_step)
    assert errors[2] < errors[0]
    assert errors[2] < 80 * 7e-4 / 3


@pytest.mark.parametrize(
    ("scene", "step", "stop", "error"),
    [
        ("gear_pair_with_backlash", 1e-2, 0.5, 0.03),
        ("slider_crank_with_play_in_the_guide", 1e-3, 0.08, 0.08),
        ("crossed_sticks", 2e-3, 0.3, 1e-2),
        ("falling_chain", 2e-3, 0.5, 1e-3),
        ("dominoes", 1e-3, 0.2, 1e-2),
        ("woodpecker_toy", 5e-4, 0.4, 0.03),
    ],
)
def test_mechanisms_lose_what_they_lose_by_located_impacts(scene, step, stop, error):
    """The play of gears lost 20 to 30 % too much, at any step; a guide stopped at a dead centre."""
    path, names = SCENES / f"{scene}.toml", ["energy.dissipated", "energy.error"]
    located = solver.simulate(path, outputs=names, stop_time=stop)
    found = solver.simulate(
        path, outputs=names, stop_time=stop, step_size=step, order=2, contact_mode="stepped"
    )
    lost = located["energy.dissipated"][-1]
    assert found["energy.dissipated"][-1] == pytest.approx(lost, rel=error)
    assert found["energy.error"].max() < 1e-12
