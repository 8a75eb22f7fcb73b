"""Forces that vanish within a step and come back: contacts open, and frictions give way, there."""

from __future__ import annotations

import math

import pytest

import holonom
import solver
from solver.runtime.layout import MESH, MESH_ENDS
from tests.support.kernel.twins import start
from tests.support.mechanisms.mechanism_runs import SCENES

PUSHED = """
name = "pushed"
dimension = 2
gravity = [0, -9.81]
[points]
A = {{ position = [0, 0], mass = 1.0 }}
[contacts]
floor = {{ type = "plane", point = "A", axis = [0, 1], friction = {friction} }}
[forces]
push = {{ type = "force", point = "A", value = [{force}] }}
"""
SETTINGS = {
    "1e-3": ({"tolerance": 1e-3}, 1e-3),
    "1e-4": ({"tolerance": 1e-4}, 1e-4),
    "1e-6": ({"tolerance": 1e-6}, 1e-6),
    "1e-8": ({"tolerance": 1e-8}, 1e-8),
    "1e-6, order 8": ({"tolerance": 1e-6, "order": 8}, 1e-6),
    "0.2 s, order 8": ({"step_size": 0.2, "order": 8}, 1e-6),  # its error there, from 5e-4 without
}
END = 0.65
"""A step to here begins and ends where the force is below what holds the block."""


def way(most, held):
    """Return how far ``most`` sin^2(pi t) N moves 1 kg until END, from when it beats ``held``."""
    begin = math.asin(math.sqrt(held / most)) / math.pi
    rest, turn = most / 2 - held, 2 * math.pi

    def speed(t):
        return rest * t - most / 2 * math.sin(turn * t) / turn

    def place(t):
        return rest * t**2 / 2 + most / 2 * math.cos(turn * t) / turn**2

    return place(END) - place(begin) - speed(begin) * (END - begin)


def moved(force, friction, settings, output):
    text = PUSHED.format(force=force, friction=friction)
    block = start(solver.assemble(solver.loads(text)), **settings)
    block.advance(0.0, END)
    return float(block[output])


@pytest.mark.parametrize("settings", SETTINGS)
@pytest.mark.parametrize("most", [11, 12, 14])
def test_a_block_lifts_off_where_a_load_is_more_than_its_weight_for_a_while(most, settings):
    options, error = SETTINGS[settings]
    found = moved(f'0, "{most}*sin(pi*t)**2"', 0, options, "A.y")
    assert found == pytest.approx(way(most, 9.81), abs=error)


@pytest.mark.parametrize("settings", SETTINGS)
@pytest.mark.parametrize("most", [5.5, 6, 7])
def test_a_block_slides_where_a_push_is_more_than_its_friction_for_a_while(most, settings):
    options, error = SETTINGS[settings]
    found = moved(f'"{most}*sin(pi*t)**2", 0', 0.5, options, "A.x")
    assert found == pytest.approx(way(most, 0.5 * 9.81), abs=error)


@pytest.mark.parametrize("tolerance", [1e-7, 1e-8])
def test_a_contact_opens_where_its_force_vanishes_not_later(tolerance):
    """The pawl is thrown off a tooth; it was held by -0.1 N for a while at these tolerances."""
    run = holonom.simulate(SCENES / "ratchet.toml", tolerance=tolerance, record_mesh=True)
    assert run.mesh is not None
    value, end = MESH.index("value"), MESH.index("end")
    events = run.mesh.steps[run.mesh.steps[:, end] == MESH_ENDS.index("event")]
    assert len(events) > 5
    assert abs(events[:, value]).max() < 1e-6
