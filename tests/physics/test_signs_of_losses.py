"""Each damper and each friction takes energy or none, also where some weights are negative.

Weighted covers and explicit steps have negative weights: of a loss that is an error of the step
alone they would make a gain, which a sum over all losses hides. Such steps are taken as pairs.
"""

from __future__ import annotations

import numpy as np
import pytest

import solver

APART = """
name = "apart"
dimension = 2
[solver]
order = {order}
tolerance = {tolerance}
step_size = {step}
[points]
A = {{ position = [1.3, 0], mass = 1.0 }}
B = {{ position = [1.2, 3], velocity = [0, 0.8], mass = 2.0 }}
[forces]
a = {{ type = "spring", points = ["ground", "A"], at = [0, 0], stiffness = 40, free_length = 1 }}
b = {{ type = "spring", points = ["ground", "B"], at = [0, 3], stiffness = 90, free_length = 1 }}
brake_a = {{ type = "damper", points = ["ground", "A"], at = [0, 0], damping = {weak} }}
brake_b = {{ type = "damper", points = ["ground", "B"], at = [0, 3], damping = 3.0 }}
"""


def own_energy(table: solver.Trajectory, name: str, mass: float, stiffness: float, y: float):
    """Energy of a point and its spring at each communication point, from outputs [J]."""
    at = {part: table[f"{name}.{part}"] for part in ("x", "y", "vx", "vy")}
    stretch = np.hypot(at["x"], at["y"] - y) - 1.0
    return 0.5 * mass * (at["vx"] ** 2 + at["vy"] ** 2) + 0.5 * stiffness * stretch**2


@pytest.mark.parametrize(
    ("order", "tolerance", "step"),
    [(4, 0.0, 0.1), (6, 0.0, 0.2), (8, 0.0, 0.3), (0, 1e-3, 0.1), (4, 1e-4, 0.1), (0, 1e-8, 0.1)],
)
@pytest.mark.parametrize("weak", [0.01, 1.0])
def test_each_damper_of_two_parts_takes_energy_in_every_step(order, tolerance, step, weak):
    text = APART.format(order=order, tolerance=tolerance, step=step, weak=weak)
    names = [f"{p}.{part}" for p in "AB" for part in ("x", "y", "vx", "vy")]
    table = solver.simulate(
        solver.loads(text), stop_time=6.0, step_size=0.3, outputs=[*names, "energy.dissipated"]
    )
    own = [own_energy(table, "A", 1.0, 40.0, 0.0), own_energy(table, "B", 2.0, 90.0, 3.0)]
    for energy in own:
        assert np.diff(energy).max() < 1e-14
        assert energy[-1] < 0.99 * energy[0]
    lost = sum(energy[0] - energy for energy in own)
    assert table["energy.dissipated"] == pytest.approx(lost, abs=1e-13)


TAPPED = """
name = "tapped"
dimension = 2
[points]
A = {{ position = [1, 0], mass = 1.0 }}
B = {{ position = [1, 3], velocity = [2, 0], mass = 1.0 }}
[forces]
tap = {{ type = "force", point = "A", value = ["0.1*exp(-((t - {time})/0.002)**2)", 0] }}
held = {{ type = "damper", points = ["ground", "A"], at = [0, 0], damping = 1.0 }}
brake = {{ type = "damper", points = ["ground", "B"], at = [0, 3], damping = 1.0 }}
[solver]
order = {order}
step_size = 0.1
"""


@pytest.mark.parametrize(("order", "time"), [(4, 0.425), (6, 0.4125), (8, 0.425)])
def test_a_step_in_which_one_of_two_dampers_would_give_energy_is_taken_as_pairs(order, time):
    """Of the covers from 0.4 s on one of a negative weight alone sees the tap, in the middle.

    Of the loss to `held` it would leave a gain, within a positive sum.
    """
    run = solver.Integrator(solver.assemble(solver.loads(TAPPED.format(order=order, time=time))))
    pairs, lost = [], [0.0]
    for _ in range(10):
        run.advance(run.time, 0.1)
        pairs.append(float(run["solver.as_pairs"]))
        lost.append(float(run["energy.dissipated"]))
        assert abs(float(run["energy.balance"])) < 1e-14
    assert pairs == [0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0]
    assert np.diff(lost).min() > 0.0


@pytest.mark.parametrize("tolerance", [1e-3, 1e-6])
def test_under_a_tolerance_too(tolerance):
    text = TAPPED.format(order=0, time=0.425).replace("step_size = 0.1", f"tolerance = {tolerance}")
    table = solver.simulate(
        solver.loads(text), stop_time=1.0, step_size=0.1, outputs=["A.vx", "B.vx", "energy.work"]
    )
    own = 0.5 * table["A.vx"] ** 2 - table["energy.work"], 0.5 * table["B.vx"] ** 2
    for energy in own:
        assert np.diff(energy).max() < 1e-14
