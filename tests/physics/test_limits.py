"""Where scales degenerate: at rest, steps of almost no length, far from the origin, at jumps."""

from __future__ import annotations

import math

import pytest

import solver
from tests.support.kernel.kernel_calls import kernel_of
from tests.support.kernel.twins import PENDULUM, start

ROD = """
name = "rod"
dimension = 2
[inputs]
pull = {{ start = 0.0 }}
[points]
A = {{ position = [0, 0], mass = 1.0 }}
B = {{ position = [0.6, 0.8], mass = 2.0 }}
[joints]
rod = {{ type = "distance", points = ["A", "B"] }}
[forces]
{force}
"""

PULLED = ROD.format(
    force="""a = { type = "force", point = "A", value = ["-6*sin(t)", "-8*sin(t)"] }
b = { type = "force", point = "B", value = ["6*sin(t)", "8*sin(t)"] }"""
)
SWITCHED = ROD.format(
    force="""a = { type = "force", point = "A", value = ["-0.6*pull", "-0.8*pull"] }
b = { type = "force", point = "B", value = ["0.6*pull", "0.8*pull"] }"""
)
AT_AN_ANGLE = """
name = "still"
dimension = 2
[points]
O = { position = [0.1, 0.2], fixed = true }
A = { position = [0.7, 1.3], mass = 1.0 }
B = { position = [-0.31, 0.9], mass = 2.0 }
[joints]
upper = { type = "distance", points = ["O", "A"] }
lower = { type = "distance", points = ["A", "B"] }
"""
PRESTRESSED = ROD.format(
    force="""s = { type = "spring", points = ["A", "B"], stiffness = 33.3, free_length = 0.1 }"""
)


@pytest.mark.parametrize("source", [PULLED, SWITCHED, PRESTRESSED], ids=["pull", "jump", "spring"])
def test_a_mechanism_at_rest_without_weight_stays_at_rest(source):
    # No energy is there to measure round-off against: positions are known to 1e-16 of a metre.
    run = start(source)
    for i in range(60):
        run["pull"] = 10.0 if i > 3 else 0.0
        run.advance(i * 0.05, 0.05)
        assert run["A.x"] == pytest.approx(0.0, abs=1e-13)
        assert run["constraint.position"] < 1e-15
    tension = {PULLED: 10 * math.sin(run.time), SWITCHED: 10.0, PRESTRESSED: -33.3 * 0.9}[source]
    assert run["rod.force"] == pytest.approx(tension, rel=1e-2)  # means lag by half a step at most
    assert run["energy.error"] < 1e-9


@pytest.mark.parametrize("communication_step", [5e-4, 0.05, 50.0])
@pytest.mark.parametrize("tolerance", [0.0, 1e-6])
def test_what_stands_still_without_weight_has_no_error_but_round_off(tolerance, communication_step):
    # Kinetic energy and balance are both of 1e-16 m a step, and no more than the limit of a check.
    run = start(AT_AN_ANGLE, tolerance=tolerance)
    for _ in range(30):
        run.advance(run.time, communication_step)
        assert run["energy.error"] < 1e-9


@pytest.mark.parametrize("tiny", [1e-7, 1e-9, 1e-10, 1e-11, 1e-12])
def test_a_step_of_almost_no_length_changes_almost_nothing(tiny):
    # Rounding errors enter accelerations and multipliers over h^2; the state must not keep them.
    run = start(PENDULUM)
    run.advance(0.0, 0.1)
    before, energy = run["rod.force"], run["energy.total"]
    for i in range(5):
        run.advance(0.1 + i * tiny, tiny)
    assert run["rod.force"] == pytest.approx(before, rel=1e-4)
    assert run["energy.total"] == pytest.approx(energy, abs=5e-14)
    run.advance(run.time, 0.1)
    assert run["solver.substeps"] == 20
    assert run["energy.error"] < 1e-14


@pytest.mark.parametrize("offset", [0.0, 1e3, 1e6])
def test_a_mechanism_far_from_the_origin_loses_no_digits(offset):
    text = PENDULUM.replace("[0, 0]", f"[{offset}, {offset}]").replace(
        "[0.6, -0.8]", f"[{offset + 0.5}, {offset - 0.75}]"
    )
    run = start(text.replace("[0.8, 0.6]", "[0.75, 0.5]"))
    run.advance(0.0, 10.0)
    assert run["energy.error"] < 1e-13
    assert run["constraint.position"] < 1e-15


def test_the_force_in_a_rod_does_not_overshoot_at_a_jump_of_an_input():
    run = start(SWITCHED)
    run.advance(0.0, 0.1)
    run["pull"] = 10.0
    for _ in range(4):
        run.advance(run.time, 0.01)
        assert run["rod.force"] == pytest.approx(10.0, rel=1e-9)


def test_an_input_that_is_set_to_what_it_is_changes_nothing():
    # Importers set inputs before every step, changed or not: no jump, so reactions stay as sharp.
    left, told = (start(MOVING) for _ in range(2))
    for i in range(5):
        for run in (left, told):
            run.advance(i * 0.01, 0.01)
        told["push"] = 1.0
    assert bytes(kernel_of(told).state) == bytes(kernel_of(left).state)


MOVING = (
    PENDULUM
    + """
[inputs]
push = { start = 1.0 }
[forces.pusher]
type = "force"
point = "A"
value = ["push", 0]
"""
)


def test_an_input_with_the_name_of_a_remark_does_not_silence_it():
    """Nor is it said that an input is clipped where the whole change is refused."""
    text = """
name = "parts"
dimension = 2
[inputs]
order = { start = 0.0, max = 1.0, limit = "clip" }
other = { start = 0.0, max = 1.0 }
[points]
A = { position = [0, 0], mass = 1.0, velocity = [1, 0] }
B = { position = [0, 1], mass = 1.0, velocity = [1, 0] }
[forces]
a = { type = "damper", points = ["A", "ground"], at = [-1, 0], damping = 1.0 }
b = { type = "damper", points = ["B", "ground"], at = [-1, 1], damping = 1.0 }
push = { type = "force", point = "A", value = ["order + other - 0.1*A.x", 0] }
[contacts]
stop = { type = "plane", point = "B", axis = [-1, 0], position = [9, 0] }
[solver]
tolerance = 1e-7
contact_mode = "stepped"
"""
    said: list[str] = []
    run = solver.Integrator(solver.assemble(solver.loads(text)), log=said.append)
    with pytest.raises(solver.OptionError, match="other"):
        run.set([run.model.index("order"), run.model.index("other")], [3.0, 4.0])
    assert said == []
    run["order"] = 3.0
    run.advance(0.0, 0.1)
    clipped, limited = said
    assert clipped.startswith("order: 3.0 is beyond 1")
    assert "are equal steps" in limited
