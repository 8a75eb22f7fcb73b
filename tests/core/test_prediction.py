"""Where a half step is sought first: from what changed there in the last internal step."""

from __future__ import annotations

import math

import numpy as np
import pytest

from solver.runtime import Integrator
from tests.problems import assemble, double_pendulum
from tests.twins import block, vector

SWING = double_pendulum(math.pi / 6)
SLOTS = {2: 4, 4: 10, 6: 18, 8: 30}


def swinging(order: int, h: float, *, slots: bool = True) -> Integrator:
    """Double pendulum from 30 degrees; without slots, the values of the last pair are the guess."""
    model = assemble(SWING, order=order, step_size=h)
    assert model.sizes["n_slots"] == SLOTS[order]
    if not slots:
        model = model._replace(sizes={**model.sizes, "n_slots": 0})
    return Integrator(model)


@pytest.mark.parametrize(
    ("order", "h", "saved"), [(2, 0.005, 0.25), (4, 0.05, 0.1), (6, 0.05, 0.07), (8, 0.05, 0.07)]
)
def test_changes_of_the_last_step_save_iterations_and_move_nothing(order, h, saved):
    runs = [swinging(order, h, slots=slots) for slots in (True, False)]
    for run in runs:
        run.advance(0.0, 2.0)
    with_slots, without = (run.state.head["newton_iterations"] for run in runs)
    assert with_slots < (1.0 - saved) * without
    ends = [vector(run, "q") for run in runs]
    assert ends[0] == pytest.approx(ends[1], abs=1e-12)


def test_a_parabola_leads_to_the_fourth_order_of_what_a_half_step_moves():
    # The guess of w = h^2/2 a misses by h^2/2 times h^3 a'''. Without slots it is h^2/2 times h a'.
    def missed(h: float, *, slots: bool) -> float:
        run = swinging(2, h, slots=slots)
        run.advance(0.0, 0.4)
        last, same, change = (vector(run, name) for name in ("a_second", "a_first", "a_change"))
        run.advance(run.time, h)
        if slots:
            now, _, before, _ = change.reshape(4, -1)
            guess = last + 2 * now - before
        else:
            guess = same
        return float(np.abs(vector(run, "a_first") - guess).max())

    for slots, power in ((True, 3), (False, 1)):
        coarse, fine = (missed(h, slots=slots) for h in (0.01, 0.005))
        assert math.log2(coarse / fine) == pytest.approx(power, abs=0.2)


def test_an_order_with_too_few_slots_takes_the_values_of_the_last_pair():
    small, large = swinging(2, 0.05), swinging(8, 0.05)
    small["solver.order"] = 8.0
    for run in (small, large):
        run.advance(0.0, 0.5)
    assert vector(small, "q") == pytest.approx(vector(large, "q"), abs=1e-13)


@pytest.mark.parametrize("order", SLOTS)
def test_a_saved_state_goes_on_to_the_last_bit_with_its_changes(order):
    first, second = (swinging(order, 0.05) for _ in range(2))
    first.advance(0.0, 0.2)
    second.restore(first.save())
    for run in (first, second):
        run.advance(0.2, 0.15)
    assert np.array_equal(block(first), block(second))
