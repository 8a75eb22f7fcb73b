"""Islands that stand still are left alone, to the last bit, until something touches them."""

from __future__ import annotations

import json

import numpy as np
import pytest

from tests.island_scenes import (
    GRAVITY,
    HANGING,
    MASS,
    SWINGING,
    H,
    assembled,
    beside,
    resting,
    started,
)
from tests.kernel_calls import kernel_of
from tests.kernels_without_skips import integrator_without, needs_compiler
from tests.problems import chain, pendulum

REST = 256
"""Bit of the skip, `SKIP_REST` of internal.h."""


def test_an_island_at_rest_is_left_alone_to_the_last_bit():
    together = started(assembled(beside(SWINGING, HANGING, chain(3))))
    hangs = [float(together[f"A_1.{axis}"]) for axis in "xy"]
    together.advance(0.0, 100 * H)
    swings, rests, falls = resting(together)
    assert swings == falls == 0.0
    assert rests > together.model.sizes["n_slots"] + 2
    assert [float(together[f"A_1.{axis}"]) for axis in "xy"] == hangs
    assert float(together["A_1.vx"]) == float(together["A_1.vy"]) == 0.0
    # what holds it is still told: the weight
    assert abs(float(together["rod1_1.force"])) == pytest.approx(MASS * GRAVITY, rel=1e-12)


def test_a_mechanism_that_hangs_at_rest_takes_no_iteration():
    mechanism = started(assembled(HANGING))
    mechanism.advance(0.0, 10 * H)
    assert mechanism["solver.newton_iterations"] == 0.0
    assert mechanism["energy.error"] == 0.0


@needs_compiler
def test_a_force_that_begins_wakes_an_island():
    # The island has slept for a second; a kernel without the skip knows no sleep.
    push = {"type": "force", "point": "A_1", "value": ["push", 0.0]}
    content = beside(SWINGING, HANGING, inputs={"push": {"unit": "N"}}, forces={"pushed": push})
    model = assembled(content)
    twins = started(model), integrator_without(REST, model, step_size=H)
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
    assert bytes(kernel_of(first).state) == bytes(kernel_of(second).state)


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
    work = np.frombuffer(kernel_of(twin).work, dtype=float)
    work[:] = np.nan
    for running in (mechanism, twin):
        running.advance(0.5, 0.1)
    assert bytes(kernel_of(mechanism).state) == bytes(kernel_of(twin).state)


def test_an_inverted_pendulum_that_is_drawn_upright_stays_so():
    # sin(pi) is 1e-16: its moment is round-off, though it would grow by e^(3.1 t).
    mechanism = started(assembled(pendulum(np.pi)))
    mechanism.advance(0.0, 10.0)
    assert float(mechanism["A.y"]) == 1.0


FOLLOWERS = {
    "a driven point": (
        {"S": {"position": [0.0, 0.0]}, "B": {"position": [0.0, -1.0], "mass": 1.0}},
        {"joints": {"rod": {"type": "distance", "points": ["S", "B"]}}},
        {"drivers": {"d": {"type": "position", "point": "S", "value": ["LATE", "0"]}}},
        "S.x",
    ),
    "a driven distance": (
        {"S": {"position": [0.0, 0.0], "fixed": True}, "B": {"position": [0.0, -1.0], "mass": 1.0}},
        {},
        {"drivers": {"d": {"type": "distance", "points": ["S", "B"], "value": "1 + LATE"}}},
        "B.y",
    ),
    "a constraint that follows": (
        {"B": {"position": [0.0, -1.0], "mass": 1.0}},
        {},
        {"constraints": {"x": {"value": "B.x"}, "y": {"value": "B.y + 1 + LATE"}}},
        "B.y",
    ),
}


@needs_compiler
@pytest.mark.parametrize("late", ["max(0, t - 0.3)**2", "max(0, u - 0.3)**2"])
@pytest.mark.parametrize("case", FOLLOWERS)
def test_what_follows_time_or_a_ramp_never_sleeps(case, late):
    # What it follows stays as it is for a while, long enough to fall asleep, and then moves.
    points, joints, follows, name = FOLLOWERS[case]
    text = json.dumps(follows).replace("LATE", late)
    content = {"name": "late", "dimension": 2, "gravity": [0, -9.81], "points": points}
    content |= joints | json.loads(text)
    content["inputs"] = {"u": {"interpolation": "ramp"}}
    model = assembled(content)
    for steps in (1, 8):
        twins = started(model), integrator_without(REST, model, step_size=H)
        for mechanism in twins:
            for k in range(steps):
                mechanism["u"] = 0.8 * (k + 1) / steps
                mechanism.advance(mechanism.time, 0.8 / steps)
        ours, theirs = (float(mechanism[name]) for mechanism in twins)
        assert ours == pytest.approx(theirs, abs=1e-9)
        assert abs(ours - float(started(model)[name])) > 0.2


def test_an_island_is_judged_by_its_own_size():
    # Beside a heavy and fast mass a light pendulum, drawn 1e-9 rad off, still swings, and points
    # that drift with a damper between them keep their momentum.
    content = beside(pendulum(1e-9, mass=1e-3))
    content["points"] |= {
        "heavy": {"position": [50.0, 0.0], "velocity": [0.0, 100.0], "mass": 1e6},
        "a": {"position": [9.0, 0.0], "velocity": [1e-6, 0.0], "mass": 1e-3},
        "b": {"position": [9.5, 0.0], "velocity": [1e-6, 0.0], "mass": 1e-3},
    }
    content["forces"] = {"d": {"type": "damper", "points": ["a", "b"], "damping": 1.0}}
    content["gravity"] = [0.0, -9.81]
    mechanism = started(assembled(content))
    mechanism.advance(0.0, 1.0)
    assert float(mechanism["A_0.x"]) == pytest.approx(1e-9 * np.cos(np.sqrt(9.81)), rel=1e-3)
    assert float(mechanism["a.vx"]) == pytest.approx(1e-6, rel=1e-9)


@pytest.mark.parametrize("tolerance", [1e-3, 1e-12])
def test_rest_is_round_off_whatever_a_step_is_solved_to(tolerance):
    mechanism = started(assembled(pendulum(0.1 * tolerance), newton_tolerance=tolerance))
    mechanism.advance(0.0, 1.0)
    assert float(mechanism["A.x"]) < 0.0  # past the lowest place: it swings


def test_a_sleeping_island_stays_so_with_steps_of_another_length():
    mechanism = started(assembled(beside(HANGING, SWINGING)))
    mechanism.advance(0.0, 0.5)
    before = [float(mechanism[f"A_0.{axis}"]) for axis in "xy"]
    for h in (0.0013, 0.05, 0.007):
        mechanism.advance(mechanism.time, h)
    assert [float(mechanism[f"A_0.{axis}"]) for axis in "xy"] == before
    assert resting(mechanism)[0] > 0.0
