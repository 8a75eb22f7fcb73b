"""Energy and momenta are constants of the discrete motion, whatever the step.

García Orden & Ortega, section 3: the conserving augmented Lagrangian keeps energy and constraints
to round-off where the midpoint rule (their eq. 5) gains energy without bound.
"""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings

import solver
from tests.support.mechanisms.problems import (
    GRAVITY,
    Content,
    chain,
    conical_pendulum,
    double_pendulum,
    four_bar,
    move,
    observe,
    pendulum,
    start,
    tree,
    view,
)
from tests.support.mechanisms.random_mechanisms import free_systems

SCENES = Path(__file__).parents[2] / "scenes"


# ------------------------------------------------------------------------------------------ chains


@pytest.mark.parametrize("n", [1, 2, 5])
def test_a_chain_from_the_horizontal_keeps_energy_and_length_for_20_s(n):
    # 1e-10 N m g L and 1e-12 are what a solve to 1e-12 of each step may leave after 2000 steps,
    # with a factor of 100 to spare.
    motion = move(start(chain(n), h=0.01), 0.01, 2000)
    assert np.abs(motion.balance).max() < 1e-10 * n * GRAVITY
    assert np.abs(motion.phi).max() < 1e-12


def test_a_double_pendulum_keeps_its_energy_to_a_picojoule_over_400000_half_steps():
    # With increments as unknowns and compensated sums nothing adds up but the residuals, some 1e-16
    # J each and of either sign.
    balance = observe(start(double_pendulum(), h=1e-3), 1.0, 200, ["energy.balance"])
    assert np.abs(balance).max() <= 1e-12


@pytest.mark.parametrize("name", ["double_pendulum", "heavy_top", "flyball_governor"])
def test_what_newton_leaves_of_the_momentum_balance_does_not_add_up_in_the_energy(name):
    # Second differences of it are left, whose energies are those of round-off, 1e-16 of the energy
    # in a step, of either sign: some 1e-20 a step in the mean of 20 000. Without them it is 1e-19.
    integrator = solver.Integrator(solver.assemble(solver.load(SCENES / f"{name}.toml")))
    steps = 20_000
    for i in range(steps // 100):
        integrator.advance(float(i), 1.0)  # 100 steps of the default length
    head = integrator.state.head
    left = head["residual"] + head["residual_low"]
    assert abs(left) < 3e-20 * steps * head["energy_reference"]


@pytest.mark.parametrize("h", [1e-3, 1e-2, 1e-1])
@pytest.mark.parametrize(
    "problem",
    [
        pendulum(1.0, 2.0),
        double_pendulum(1.0),
        conical_pendulum(1.0),
        four_bar(2),
        tree(6, dimension=3),
    ],
    ids=lambda content: content["name"],
)
def test_energy_and_constraints_hold_at_every_step_size(problem, h):
    # Relative to the energy that is exchanged; 1e-12 is the tolerance of one step.
    observed = observe(start(problem, h=h), h, 300, ["energy.error", "constraint.position"])
    assert observed.max(axis=0) == pytest.approx([0.0, 0.0], abs=1e-12)


# ------------------------------------------------------------------------------------ free systems


def momenta(dimension: int) -> list[str]:
    return [
        *(f"momentum.{axis}" for axis in "xyz"[:dimension]),
        *(f"angular_momentum.{axis}" for axis in ("z" if dimension == 2 else "xyz")),
    ]


def assert_momenta_and_energy_hold(content: Content, h: float, n_steps: int) -> None:
    """Watch a free system over `n_steps` steps, at a hundred times."""
    dimension = content["dimension"]
    integrator = start(content, h=h)
    mass = integrator.model.numbers[integrator.model.offsets["node_mass"] :][
        : len(content["points"])
    ]
    values = observe(
        integrator,
        h * n_steps / 100,
        100,
        ["energy.balance", "energy.kinetic", *momenta(dimension)],
    )
    energy, kinetic, moved = values[:, 0], values[:, 1], np.abs(values[:, 2:] - values[0, 2:])
    # Scales: the energy in motion, and the momentum that it means for the whole mass, at the lever
    # of the mechanism's farthest point from the origin.
    speed = math.sqrt(2 * kinetic.max() / sum(mass))
    momentum, lever = sum(mass) * speed, np.linalg.norm(view(integrator, "q"), axis=1).max()
    assert np.abs(energy).max() < 1e-11 * kinetic.max()
    assert moved[:, :dimension].max() < 1e-11 * momentum
    assert moved[:, dimension:].max() < 1e-11 * momentum * lever


@settings(max_examples=50, suppress_health_check=[HealthCheck.too_slow])
@given(free_systems())
def test_energy_and_momenta_of_any_free_system_hold_over_ten_thousand_large_steps(system):
    content, h = system
    assert_momenta_and_energy_hold(content, h, 10_000)


WHEELS = {
    2: """
name = "wheel"
dimension = 2
gravity = [0, 0]
[bodies]
wheel = { position = [0, 0], angular_velocity = 47.0, mass = 1.0, inertia = 1.0 }
""",
    3: """
name = "wheel"
gravity = [0, 0, 0]
[bodies.wheel]
position = [0, 0, 0]
angular_velocity = { body = [0, 0, 47] }
mass = 1.0
inertia = [4, 4, 1]
""",
}


@pytest.mark.parametrize("h", [0.01, 0.02, 0.03])
@pytest.mark.parametrize("dimension", [2, 3])
def test_a_wheel_spins_as_fast_after_200000_steps(dimension, h):
    """I omega is constant.

    Each of 4e5 half steps rounds what it changes velocities of directors by, up to 33 m/s, to half
    of 7e-15 m/s: at random that is 4e-14 of omega. With one sign it would be 100 times as much, as
    where the rounding of h omega was left out of the momenta.
    """
    text = f"{WHEELS[dimension]}[solver]\nstep_size = {h}\n"
    run = solver.Integrator(solver.assemble(solver.loads(text)))
    run.advance(0.0, 200_000 * h)
    spin = "wheel.angular_velocity" if dimension == 2 else "wheel.wz"
    assert run[spin] == pytest.approx(47.0, rel=1e-13)
