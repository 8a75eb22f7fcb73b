"""Every force does the work of its law, to the last digit, in the plane and in space.

Where a law's force is constant over a step, its work is a sum over steps that a test can form from
outputs alone; tolerances are round-off of the energies exchanged (some 10 J) over a few hundred
steps. Where only the continuous law is known, its integral is met to second order.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

import solver
from tests.support.mechanisms.joint_scenes import pair
from tests.support.mechanisms.problems import Array, observed_order
from tests.support.mechanisms.work_sums import ROUND_OFF, HalfSteps, sums, trapezoids, vector

DIMENSIONS = pytest.mark.parametrize("dimension", [2, 3], ids=["plane", "space"])
STEPS = pytest.mark.parametrize("h", [0.02, 0.1])

STORING: dict[str, tuple[str, Callable[[HalfSteps], Array]]] = {
    # law between two hinged bodies that fly freely: (its text, its energy)
    "spring": (
        'type = "spring", points = ["A.tip", "B.tip"], stiffness = 40, free_length = 0.3',
        lambda run: 20 * (run["law.length"] - 0.3) ** 2,
    ),
    "spring without free length": (
        'type = "spring", points = ["A.tip", "B.tip"], stiffness = 40, free_length = 0',
        lambda run: 20 * run["law.length"] ** 2,
    ),
    "spring with a law of its own": (
        'type = "spring", points = ["A.tip", "B.tip"], '
        'energy = "20*(length - 0.3)**2 + 5*(length - 0.3)**4"',
        lambda run: 20 * (run["law.length"] - 0.3) ** 2 + 5 * (run["law.length"] - 0.3) ** 4,
    ),
    "torsion spring": (
        'type = "torsion_spring", joint = "joint", stiffness = 3, free_angle = 0.2',
        lambda run: 1.5 * (run["joint.angle"] - 0.2) ** 2,
    ),
    "spring by a curve": (
        'type = "spring", points = ["A.tip", "B.tip"], free_length = 0.3, '
        'force = "40*elongation + 20*elongation*abs(elongation)"',
        lambda run: (
            20 * (run["law.length"] - 0.3) ** 2 + 20 / 3 * np.abs(run["law.length"] - 0.3) ** 3
        ),
    ),
    "torsion spring by a curve": (
        'type = "torsion_spring", joint = "joint", torque = "3*sin(2*angle)", free_angle = 0.2',
        lambda run: 1.5 - 1.5 * np.cos(2 * (run["joint.angle"] - 0.2)),
    ),
    "potential": (
        'type = "potential", value = "30*distance(A.tip, B.tip)**4 + cos(joint.angle)"',
        lambda run: 30 * run["reach"] ** 4 + np.cos(run["joint.angle"]),
    ),
    "gravitation": (
        'type = "gravitation", points = ["A.tip", "B.tip"], masses = [2, 3], constant = 0.1',
        lambda run: -0.6 / run["law.length"],
    ),
}
DAMPERS = {
    # (its text, what it slows, c)
    "damper": (
        'type = "damper", points = ["A.tip", "B.tip"], damping = 2',
        *("law.length", 2.0),
    ),
    "torsion damper": (
        'type = "torsion_damper", joint = "joint", damping = 0.3',
        "joint.angle",
        0.3,
    ),
}
TORQUES: dict[str, tuple[str, Callable[[Array], Array]]] = {
    "constant": ("0.7", lambda t: 0.7 + 0.0 * t),
    "of time": ("0.7*sin(3*t)", lambda t: 0.7 * np.sin(3 * t)),
}


def joined(dimension: int, law: str, h: float, stop: float = 4.0) -> HalfSteps:
    """Two bodies on a common hinge in free flight with one law between them."""
    reach = '\n[outputs]\nreach = { value = "distance(A.tip, B.tip)" }\n'
    text = pair(dimension, "revolute", h) + f"[forces]\nlaw = {{ {law} }}\n"
    return HalfSteps(solver.loads(text + reach), stop_time=stop, h=h)


# ------------------------------------------------------------------------ laws between two bodies


@DIMENSIONS
@STEPS
@pytest.mark.parametrize("name", STORING)
def test_a_law_with_an_energy_gives_back_exactly_what_it_takes(name, h, dimension):
    text, energy = STORING[name]
    run = joined(dimension, text, h)
    stored, size = energy(run), np.ptp(run["energy.kinetic"]) + run["energy.kinetic"][0]
    assert np.ptp(stored) > 1e-2 * size
    assert run["energy.potential"] == pytest.approx(stored, abs=ROUND_OFF * size)
    assert np.ptp(run["energy.kinetic"] + stored) < ROUND_OFF * size
    assert not run["energy.work"].any()
    assert not run["energy.dissipated"].any()


@DIMENSIONS
@STEPS
@pytest.mark.parametrize("name", DAMPERS)
def test_a_damper_takes_c_times_the_square_of_what_it_slows_in_every_step(name, h, dimension):
    text, slowed, c = DAMPERS[name]
    run = joined(dimension, text, h)
    lost = run["energy.dissipated"]
    assert (np.diff(lost) >= 0).all()
    assert lost[-1] > 1e-3
    assert lost == pytest.approx(sums(c * np.diff(run[slowed]) ** 2 / h), abs=ROUND_OFF)
    assert run["energy.total"] + lost == pytest.approx(run["energy.total"][0], abs=ROUND_OFF)
    assert not run["energy.work"].any()


@DIMENSIONS
@pytest.mark.parametrize("name", DAMPERS)
def test_a_damper_is_said_to_pull_with_c_times_the_rate_of_what_it_slows(name, dimension):
    text, slowed, c = DAMPERS[name]
    errors, steps = [], [0.02, 0.01, 0.005]
    for h in steps:
        run = joined(dimension, text, h, stop=2.0)
        force = run["law.torque" if name == "torsion damper" else "law.force"][1:-1]
        rate = (run[slowed][2:] - run[slowed][:-2]) / (2 * h)
        errors.append(np.abs(force - c * rate).max() / np.abs(force).max())
    assert observed_order(steps, errors) == pytest.approx(2.0, abs=0.1)
    assert errors[-1] < 2e-4


@DIMENSIONS
@STEPS
@pytest.mark.parametrize("name", TORQUES)
def test_a_torque_at_a_joint_does_torque_times_angle(name, h, dimension):
    text, torque = TORQUES[name]
    run = joined(
        dimension, f'type = "joint_torque", joint = "joint", value = "{text}"', h, stop=2.0
    )
    middle = h * (np.arange(len(run.t) - 1) + 0.5)
    work = sums(torque(middle) * np.diff(run["joint.angle"]))
    size = np.abs(run["energy.work"]).max() + run["energy.kinetic"][0]
    assert run["energy.work"] == pytest.approx(work, abs=ROUND_OFF * size)
    assert np.abs(run["energy.balance"]).max() < ROUND_OFF * size


@DIMENSIONS
def test_the_work_of_a_controlled_torque_is_the_integral_of_its_power(dimension):
    # Sensors are read once, in the middle of a step: the sum of trapezoids is met to second order.
    law = (
        'type = "joint_torque", joint = "joint", '
        'value = "0.5*sin(3*t) - 0.2*joint.angular_velocity - 3*joint.angle"'
    )
    errors, steps = [], [0.02, 0.01, 0.005]
    for h in steps:
        run = joined(dimension, law, h, stop=2.0)
        power = run["law.torque"] * run["joint.angular_velocity"]
        errors.append(np.abs(run["energy.work"] - trapezoids(power, h)).max())
        assert np.abs(run["energy.balance"]).max() < ROUND_OFF
        assert np.ptp(run["energy.work"]) > 0.05
    assert observed_order(steps, errors) == pytest.approx(2.0, abs=0.2)


INTERNAL = {
    **{name: law[0] for name, law in (STORING | DAMPERS).items()},
    "torque": 'type = "joint_torque", joint = "joint", value = "2*sin(t) - joint.angle"',
}


@pytest.mark.filterwarnings("ignore:force 'law' is evaluated too seldom")
@DIMENSIONS
@STEPS
@pytest.mark.parametrize("name", INTERNAL)
def test_what_acts_between_two_bodies_changes_no_momentum(name, h, dimension):
    run = joined(dimension, INTERNAL[name], h)
    axes, turning = ("xyz", "xyz") if dimension == 3 else ("xy", "z")
    assert np.ptp(vector(run, "momentum.", axes), axis=0).max() < ROUND_OFF
    assert np.ptp(vector(run, "angular_momentum.", turning), axis=0).max() < ROUND_OFF
