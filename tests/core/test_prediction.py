"""Where a half step is sought first: on the way that the last ones have gone."""

from __future__ import annotations

import math

import numpy as np
import pytest

import solver
from solver.mechanics.assembly import SLOTS
from solver.runtime import Integrator
from tests.support.kernel.twins import block, vector
from tests.support.mechanisms.problems import assemble, double_pendulum

SWING = double_pendulum(math.pi / 6)
PUSHED = """
name = "pushed"
dimension = 2
[solver]
step_size = 0.2
[points.ball]
position = [0.0, 0.0]
mass = 1.0
[forces.push]
type = "force"
point = "ball"
value = ["(1 + t)**3", 0.0]
"""


def swinging(order: int, h: float, *, slots: bool = True) -> Integrator:
    """Double pendulum from 30 degrees; without slots, the values of the last pair are the guess."""
    model = assemble(SWING, order=order, step_size=h)
    if not slots:
        model = model._replace(sizes={**model.sizes, "n_slots": 0})
    return Integrator(model)


@pytest.mark.parametrize(
    ("order", "h", "saved"), [(2, 0.005, 0.5), (4, 0.05, 0.2), (6, 0.05, 0.2), (8, 0.05, 0.1)]
)
def test_polynomials_save_iterations_and_move_nothing(order, h, saved):
    runs = [swinging(order, h, slots=slots) for slots in (True, False)]
    for run in runs:
        run.advance(0.0, 2.0)
    with_slots, without = (run.state.head["newton_iterations"] for run in runs)
    assert with_slots < (1.0 - saved) * without
    ends = [vector(run, "q") for run in runs]
    assert ends[0] == pytest.approx(ends[1], abs=1e-12)


def test_a_guess_of_order_2_misses_accelerations_by_the_sixth_power_of_the_step():
    # A polynomial through 4 half steps misses by the fourth power; extrapolating what it missed in
    # the last two pairs leaves two powers more. Without slots the guess is that of the last pair,
    # which misses by the first.
    def missed(h: float, *, slots: bool) -> float:
        run = swinging(2, h, slots=slots)
        run.advance(0.0, 0.4)
        names = ("a_first", "a_second", "a_before_first", "a_before_second")
        same, last, before, last_before = (vector(run, name) for name in names)
        guess = same
        if slots:
            now, _, earlier, _ = vector(run, "a_missed").reshape(4, -1)
            guess = 4 * last - 6 * same + 4 * last_before - before + 2 * now - earlier
        run.advance(run.time, h)
        return float(np.abs(vector(run, "a_first") - guess).max())

    for slots, power, h in ((True, 6, 0.02), (False, 1, 0.01)):
        coarse, fine = (missed(step, slots=slots) for step in (h, h / 2))
        assert math.log2(coarse / fine) == pytest.approx(power, abs=0.1 * power)


def test_accelerations_that_are_cubic_in_time_are_foreseen_whatever_the_lengths_of_steps():
    run = Integrator(solver.assemble(solver.loads(PUSHED, name="pushed.toml", format="toml")))
    run.initialise()
    for k in range(12):
        run.advance(run.time, (0.1, 0.13, 0.07)[k % 3])
    first, second = (vector(run, name)[0] for name in ("a_first", "a_second"))
    assert first > 1.0
    misses = vector(run, "a_missed").reshape(4, -1)[:2, 0]  # of both halves of the last pair
    # Weights of up to 10 of a value that is rounded, and of places over h^2.
    assert misses == pytest.approx([0.0, 0.0], abs=1e-11 * second)


def test_an_order_with_too_few_slots_takes_the_values_of_the_last_pair():
    small, large = swinging(2, 0.05), swinging(8, 0.05)
    small["solver.order"] = 8.0
    for run in (small, large):
        run.advance(0.0, 0.5)
    assert vector(small, "q") == pytest.approx(vector(large, "q"), abs=1e-13)


@pytest.mark.parametrize("order", SLOTS)
def test_a_saved_state_goes_on_to_the_last_bit_with_its_history(order):
    first, second = (swinging(order, 0.05) for _ in range(2))
    first.advance(0.0, 0.2)
    second.restore(first.save())
    for run in (first, second):
        run.advance(0.2, 0.15)
    assert np.array_equal(block(first), block(second))
