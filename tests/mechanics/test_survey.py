"""Mobility by Kutzbach and by rank, and which joints carry what is redundant."""

from __future__ import annotations

import numpy as np
import pytest

import solver
from solver.mechanics.mobility import constraint_jacobian, survey
from tests.support.kernel.kernel_calls import kernel_of
from tests.support.mechanisms.mechanism_runs import SCENES
from tests.support.mechanisms.zoo import PLANE, SPACE


def of(name: str):
    return survey(solver.assemble(solver.load(SCENES / f"{name}.toml")))


@pytest.mark.parametrize(
    ("name", "by_count", "mobility", "redundant"),
    [
        ("double_pendulum", 2, 2, 0),
        ("four_bar", 1, 1, 0),
        ("bricard", 0, 1, 1),  # six hinges in a loop: paradoxical
        ("spatial_slider_crank", 0, 1, 1),  # a planar mechanism, built in space
        ("cardan_shaft", -2, 1, 3),
        ("heavy_top", 3, 3, 0),
        ("stewart", 6, 6, 0),
    ],
)
def test_mobility_is_that_of_the_textbook(name, by_count, mobility, redundant):
    found = of(name)
    assert (found.mobility_by_count, found.mobility) == (by_count, mobility)
    assert found.redundant_rows == redundant
    assert bool(found.redundant_parts) == bool(redundant)


def test_drivers_take_the_freedom_that_they_prescribe():
    found = of("stewart")
    assert (found.drivers, found.degrees_of_freedom) == (6, 0)


def test_rolling_takes_freedom_from_velocities_alone():
    # A disc on a plane: 5 coordinates, 3 velocities.
    found = of("rolling_disc")
    assert (found.mobility, found.degrees_of_freedom, found.velocity_freedom) == (5, 5, 3)


def test_redundant_rows_are_those_of_the_joints_in_their_loop():
    text = """
name = "door"
[bodies]
door = { position = [0.4, 0, 1], mass = 20.0, inertia = [2, 3, 1] }
knob = { position = [0.8, 0.1, 1], mass = 0.1, inertia = [1e-4, 1e-4, 1e-4] }
[joints]
lower = { type = "revolute", bodies = ["ground", "door"], position = [0, 0, 0], axis = [0, 0, 1] }
upper = { type = "revolute", bodies = ["ground", "door"], position = [0, 0, 2], axis = [0, 0, 1] }
latch = { type = "revolute", bodies = ["door", "knob"], position = [0.8, 0, 1], axis = [0, 1, 0] }
"""
    found = survey(solver.assemble(solver.loads(text)))
    assert found.redundant_rows == 5
    assert found.redundant_parts == ("joint 'lower'", "joint 'upper'")
    assert found.mobility == 2


@pytest.mark.parametrize("text", [PLANE, SPACE], ids=["plane", "space"])
def test_the_jacobian_is_the_derivative_of_the_rows(text):
    # Central differences of Phi with 1e-6: 1e-10 of truncation and of rounding.
    integrator = solver.Integrator(solver.assemble(solver.loads(text)))
    integrator.initialise()
    G, q = constraint_jacobian(integrator), integrator.state.vectors["q"]
    holonomic = integrator.model.sizes["n_rows"] - integrator.model.sizes["n_velocity_rows"]
    for k in range(len(q)):
        kept, ends = q[k], []
        for x in (kept - 1e-6, kept + 1e-6):
            q[k] = x
            ends.append(np.array(kernel_of(integrator).residuals()[0]))
        q[k] = kept
        slope = (ends[1] - ends[0]) / 2e-6
        assert slope[:holonomic] == pytest.approx(G[:holonomic, k], abs=1e-8)
