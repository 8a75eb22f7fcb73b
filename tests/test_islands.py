"""Parts of a mechanism that nothing joins are solved by themselves, and not while they rest."""

from __future__ import annotations

import json

import numpy as np
import pytest

import solver
from solver.runtime import Integrator, Model, State
from solver.runtime.layout import ISLAND
from tests.problems import chain, double_pendulum, pendulum

H = 0.01
MASS, GRAVITY = 1.0, 9.81


def assembled(content: dict, **settings) -> Model:
    text = json.dumps(content | {"solver": {"step_size": H} | settings})
    return solver.assemble(solver.loads(text, name="islands.json", format="json"))


def beside(*contents: dict, **more) -> dict:
    """One scene of several, their names with the number of each behind them."""
    first, joined = contents[0], {"points": {}, "joints": {}}
    for k, content in enumerate(contents):
        for name, point in content["points"].items():
            joined["points"][f"{name}_{k}"] = dict(point)
        for name, joint in content["joints"].items():
            ends = [f"{point}_{k}" for point in joint["points"]]
            joined["joints"][f"{name}_{k}"] = joint | {"points": ends}
    return first | joined | more


def driven(content: dict, *numbers: int) -> dict:
    """The scene with the supports of some of its parts as points that move."""
    for k in numbers:
        del content["points"][f"O_{k}"]["fixed"]
    return content


def started(model: Model, kernel: str = "c") -> Integrator:
    integrator = Integrator(model, kernel=kernel)
    integrator.initialise()
    return integrator


def resting(integrator: Integrator) -> list[float]:
    """How many half steps each island has rested."""
    values = State(integrator.model, integrator.engine.state).vectors["islands"]
    return list(values[ISLAND.index("resting") :: len(ISLAND)])


HANGING = pendulum(0.0)
SWINGING = double_pendulum(0.5)
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


@pytest.mark.parametrize("order", [2, 6])
def test_each_island_moves_as_it_would_alone(order):
    # What differs is where iterations stop, a margin of 1e-6 below 1e-12: round-off, which grows
    # little in a second.
    contents = chain(8), SWINGING, pendulum(2.0)
    together = started(assembled(beside(*contents), order=order))
    together.advance(0.0, 1.0)
    for k, content in enumerate(contents):
        alone = started(assembled(content, order=order))
        alone.advance(0.0, 1.0)
        for name in [name for name, at in content["points"].items() if "mass" in at]:
            for axis in "xy":
                ours, theirs = together[f"{name}_{k}.{axis}"], alone[f"{name}.{axis}"]
                assert ours == pytest.approx(theirs, abs=1e-13), (k, name)
    assert abs(float(together["energy.error"])) < 1e-15


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


def test_an_island_at_rest_is_left_alone_to_the_last_bit():
    together = started(assembled(beside(SWINGING, HANGING, chain(3))))
    vectors = State(together.model, together.engine.state).vectors
    hangs = [float(together[f"A_1.{axis}"]) for axis in "xy"]
    together.advance(0.0, 100 * H)
    swings, rests, falls = resting(together)
    assert swings == falls == 0.0
    assert rests > together.model.sizes["n_slots"] + 2
    assert [float(together[f"A_1.{axis}"]) for axis in "xy"] == hangs
    assert float(together["A_1.vx"]) == float(together["A_1.vy"]) == 0.0
    place = {name: k for k, name in enumerate(vectors)}
    assert "islands" in place
    # what holds it is still told: the weight
    assert abs(float(together["rod1_1.force"])) == pytest.approx(MASS * GRAVITY, rel=1e-12)


def test_a_mechanism_that_hangs_at_rest_takes_no_iteration():
    mechanism = started(assembled(HANGING))
    mechanism.advance(0.0, 10 * H)
    assert mechanism["solver.newton_iterations"] == 0.0
    assert mechanism["energy.error"] == 0.0


def test_a_force_that_begins_wakes_an_island():
    # The kernel's island has slept for a second; the oracle knows no sleep.
    push = {"type": "force", "point": "A_1", "value": ["push", 0.0]}
    content = beside(SWINGING, HANGING, inputs={"push": {"unit": "N"}}, forces={"pushed": push})
    model = assembled(content)
    twins = [started(model, kernel) for kernel in ("c", "numpy")]
    for mechanism in twins:
        mechanism.advance(0.0, 1.0)
    assert resting(twins[0])[1] > 0.0
    for mechanism in twins:
        mechanism["push"] = 0.7
        mechanism.advance(1.0, 0.5)
    ours, theirs = twins
    assert abs(float(ours["A_1.x"])) > 1e-2
    for name in ("A_1.x", "A_1.vx", "B_0.x", "energy.work"):
        assert ours[name] == pytest.approx(theirs[name], abs=1e-12), name


def test_islands_wake_alike_after_a_save_and_a_restore():
    content = beside(SWINGING, HANGING, inputs={"push": {"unit": "N"}})
    content["forces"] = {"pushed": {"type": "force", "point": "A_1", "value": ["push", 0.0]}}
    model = assembled(content)
    first, second = started(model), started(model)
    first.advance(0.0, 0.5)
    second.restore(first.save())
    for mechanism in (first, second):
        mechanism.advance(0.5, 0.3)
        mechanism["push"] = 0.4
        mechanism.advance(0.8, 0.3)
    assert bytes(first.engine.state) == bytes(second.engine.state)


def test_what_dampers_bring_to_rest_rests_with_a_closed_ledger():
    # 27 time constants of 2 m/c = 0.5 s take the amplitude to 1e-12: the island rests before 40 s.
    content = beside(HANGING, SWINGING)
    content["points"]["W"] = {"position": [-2.0, -1.0], "fixed": True}
    content["points"]["A_0"]["velocity"] = [0.3, 0.0]
    content["forces"] = {"d": {"type": "damper", "points": ["W", "A_0"], "damping": 4.0}}
    mechanism = started(assembled(content))
    mechanism.advance(0.0, 40.0)
    assert resting(mechanism)[0] > 0.0
    assert float(mechanism["A_0.vx"]) == 0.0
    assert float(mechanism["energy.dissipated"]) == pytest.approx(0.5 * 0.3**2, rel=1e-9)
    assert abs(float(mechanism["energy.balance"])) < 1e-13


def test_nothing_rests_under_laws_that_follow_time():
    content = beside(SWINGING, HANGING)
    content["forces"] = {
        "push": {"type": "force", "point": "A_1", "value": ["1.0 if t > 0.5 else 0.0", 0.0]}
    }
    mechanism = started(assembled(content))
    mechanism.advance(0.0, 1.0)
    assert resting(mechanism) == [0.0, 0.0]
    assert abs(float(mechanism["A_1.x"])) > 1e-2


def test_scratch_of_sleeping_islands_is_never_read():
    mechanism = started(assembled(beside(HANGING, SWINGING)))
    mechanism.advance(0.0, 0.5)
    twin = started(mechanism.model)
    twin.restore(mechanism.save())
    work = np.frombuffer(twin.engine.work, dtype=float)
    work[:] = np.nan
    for running in (mechanism, twin):
        running.advance(0.5, 0.1)
    assert bytes(mechanism.engine.state) == bytes(twin.engine.state)


def test_an_inverted_pendulum_that_is_drawn_upright_stays_so():
    # sin(pi) is 1e-16: its moment is round-off, though it would grow by e^(3.1 t).
    mechanism = started(assembled(pendulum(np.pi)))
    mechanism.advance(0.0, 10.0)
    assert float(mechanism["A.y"]) == 1.0
