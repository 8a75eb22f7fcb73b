"""Parts of a mechanism that nothing joins are solved by themselves."""

from __future__ import annotations

import pytest

from solver.runtime import Integrator
from tests.support.mechanisms.island_scenes import (
    HANGING,
    SWINGING,
    H,
    assembled,
    beside,
    driven,
    started,
)
from tests.support.mechanisms.problems import chain, pendulum

CASES = {
    "one mechanism": (SWINGING, 1),
    "two, held by the ground alone": (beside(SWINGING, HANGING), 2),
    "tied by a spring": (
        beside(SWINGING, HANGING)
        | {"forces": {"tie": {"type": "spring", "points": ["B_0", "A_1"], "stiffness": 1.0}}},
        1,
    ),
    "tied by a potential": (
        beside(SWINGING, HANGING)
        | {"forces": {"tie": {"type": "potential", "value": "distance(B_0, A_1)**2"}}},
        1,
    ),
    "driven points and what they hold count as one, and come last": (
        driven(beside(SWINGING, HANGING, SWINGING), 0, 2)
        | {
            "drivers": {
                f"d{k}": {"type": "position", "point": f"O_{k}", "value": ["sin(t)", "0"]}
                for k in (0, 2)
            }
        },
        2,
    ),
    "a rigid body is one, though its mass couples nothing to its axes": (
        {
            "name": "free",
            "dimension": 3,
            "bodies": {"top": {"position": [0, 0, 0], "mass": 1.0, "inertia": [1.0, 2.0, 2.5]}},
        },
        1,
    ),
}


@pytest.mark.parametrize("case", CASES)
def test_islands_are_what_no_mass_row_or_force_joins(case):
    content, count = CASES[case]
    assert assembled(content).sizes["n_islands"] == count


def test_counted_are_the_iterations_of_the_island_that_takes_most():
    # Of two that are alike each takes what one takes alone: the count does not grow with them. One
    # alone also tries factors of the half step before, which costs an iteration now and then.
    alone = started(assembled(chain(8)))
    together = started(assembled(beside(chain(8), chain(8))))
    for mechanism in (alone, together):
        mechanism.advance(0.0, 50 * H)
    counts = [float(x["solver.newton_iterations"]) for x in (together, alone)]
    assert counts[0] == pytest.approx(counts[1], rel=0.05)
    assert counts[0] > 100.0


def energy(run: Integrator, number: int) -> float:
    """Of one of several double pendulums of unit masses, in J, from what is shown of its points."""
    total = 0.0
    for point in (f"A_{number}", f"B_{number}"):
        vx, vy, y = (float(run[f"{point}.{part}"]) for part in ("vx", "vy", "y"))
        total += 0.5 * (vx * vx + vy * vy) + 9.81 * y
    return total


@pytest.mark.parametrize("tolerance", [0.0, 1e-6], ids=["covers", "explicit"])
def test_dampers_of_one_island_cost_no_other_its_energy(tolerance):
    content = beside(SWINGING, SWINGING)
    content["points"]["W"] = {"position": [-2.0, -1.0], "fixed": True}
    content["forces"] = {"d": {"type": "damper", "points": ["W", "A_0"], "damping": 1.0}}
    mechanism = started(assembled(content, order=4 if not tolerance else 0, tolerance=tolerance))
    before = [energy(mechanism, number) for number in range(2)]
    mechanism.advance(0.0, 5.0)
    lost = [before[number] - energy(mechanism, number) for number in range(2)]
    assert mechanism["solver.order_in_use"] == (8.0 if tolerance else 4.0)
    assert lost[0] == pytest.approx(float(mechanism["energy.dissipated"]), abs=1e-12)
    assert lost[0] > 1.0
    assert abs(lost[1]) < 1e-12  # of 30 J


def test_an_island_that_cannot_take_a_step_makes_all_take_shorter_ones():
    # A long step turns the fast pendulum too far; with its halves both move as with short steps.
    fast = pendulum(0.3, 40.0)
    content = beside(fast, SWINGING)
    together = started(assembled(content, step_size=0.2))
    together.advance(0.0, 0.2)
    assert float(together["solver.substeps"]) >= 2.0
    assert abs(float(together["energy.error"])) < 1e-12
