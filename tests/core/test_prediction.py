"""Where a half step is sought first: on the way that the last ones have gone."""

from __future__ import annotations

import math

import numpy as np
import pytest

from solver.mechanics.assembly import SLOTS
from solver.runtime import Integrator
from tests.problems import assemble, double_pendulum
from tests.twins import block, vector

SWING = double_pendulum(math.pi / 6)


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
    # A polynomial through 4 half steps misses by the fourth power; extrapolating what it missed in the last two pairs
    # leaves two powers more. Without slots the guess is that of the last pair, which misses by the first.
    def missed(h: float, *, slots: bool) -> float:
        run = swinging(2, h, slots=slots)
        run.advance(0.0, 0.4)
        same, last, before, last_before = (
            vector(run, name) for name in ("a_first", "a_second", "a_before_first", "a_before_second")
        )
        now, _, earlier, _ = vector(run, "a_missed").reshape(4, -1) if slots else np.zeros((4, 1))
        guess = 4 * last - 6 * same + 4 * last_before - before + 2 * now - earlier if slots else same
        run.advance(run.time, h)
        return float(np.abs(vector(run, "a_first") - guess).max())

    for slots, power, h in ((True, 6, 0.02), (False, 1, 0.01)):
        coarse, fine = (missed(step, slots=slots) for step in (h, h / 2))
        assert math.log2(coarse / fine) == pytest.approx(power, abs=0.1 * power)


def test_polynomials_lead_no_worse_between_steps_of_two_lengths():
    # Accelerations jump with the length of a step, more than they change on the way: a guess gains little.
    runs = [swinging(2, 0.005, slots=slots) for slots in (True, False)]
    iterations = [0.0, 0.0]
    for i, run in enumerate(runs):
        for k in range(100):
            run.advance(run.time, 0.005 if k % 2 else 0.004)
            iterations[i] += run.state.head["newton_iterations"]
    assert iterations[0] <= 1.1 * iterations[1]


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
