"""Steps that cannot be, however short: an error, which ends the run until a state comes back.

FMI 2.0.5, 2.1.6 and 4.2.2; FMI 3.0.1, 2.3 and 4.2. pythonfmu's library answers OK or Discard alone.
"""

from __future__ import annotations

import math

import pytest
from fmpy.fmi1 import FMICallException

from fmu_src import status
from tests.fmu.test_state_machine import fmu_of
from tests.support.fmus.fmu_instance import Instance, instance

OK, DISCARD, ERROR = 0, 2, 3
STOP, H = 2.0, 0.1
KINDS = {"python": DISCARD, "native": ERROR, "native 3": ERROR}
"""Kinds of FMUs, and what each can answer to a step that cannot be."""
IMPOSSIBLE = {
    "of no length": (H, 0.0, "must be > 0 s"),
    "of a negative length": (H, -H, "must be > 0 s"),
    "of length -0": (H, -0.0, "must be > 0 s"),
    "of length NaN": (H, math.nan, "must be > 0 s"),
    "without end": (H, math.inf, "stop time"),
    "without beginning": (H, -math.inf, "must be > 0 s"),
    "from NaN": (math.nan, H, "the mechanism is at 0.1 s"),
    "from infinity": (math.inf, H, "s"),
    "from earlier": (0.5 * H, H, "the mechanism is at 0.1 s"),
    "from later": (1.5 * H, H, "the mechanism is at 0.1 s"),
    "from the start again": (0.0, H, "the mechanism is at 0.1 s"),
    "beyond the stop time": (H, STOP, "stop time that the importer gave, 2.0 s"),
    "a millionth beyond the stop time": (H, STOP - H + 1e-6, "stop time"),
    "of the greatest length": (H, 1.7e308, "stop time"),
}
"""Time and size of a step from 0.1 s [s], and words of its refusal."""


def answer(fmu: Instance, t: float, h: float) -> int:
    """Status of doStep."""
    try:
        fmu.fmu.doStep(t, h)
    except FMICallException as error:
        return error.status
    return OK


def begun(fmu: Instance, stop: float | None = STOP) -> None:
    fmu.initialise(stop=stop)
    assert answer(fmu, 0.0, H) == OK


@pytest.mark.parametrize("what", IMPOSSIBLE)
@pytest.mark.parametrize("kind", KINDS)
def test_an_impossible_step_is_an_error_with_a_line_and_moves_nothing(kind, what):
    t, h, words = IMPOSSIBLE[what]
    with instance(fmu_of(kind)) as fmu, instance(fmu_of(kind)) as straight:
        for each in (fmu, straight):
            begun(each)
        before, first = fmu.outputs()[:-1], len(fmu.log)
        assert answer(fmu, t, h) == KINDS[kind]
        ((level, category, text),) = fmu.log[first:]
        assert (level, category) == (
            KINDS[kind],
            "logStatusError" if KINDS[kind] == ERROR else "logStatusDiscard",
        )
        assert words in text
        assert fmu.outputs()[:-1] == before
        assert fmu.get("solver.status") == status.STEP_REFUSED
        if kind == "python":  # the wrapper's library has told of no error
            assert fmu.run(H, H, 3) == straight.run(H, H, 3)


@pytest.mark.parametrize("what", [name for name in IMPOSSIBLE if "the stop time" not in name])
@pytest.mark.parametrize("kind", KINDS)
def test_it_is_one_without_a_stop_time_too(kind, what):
    t, h, words = IMPOSSIBLE[what]
    with instance(fmu_of(kind)) as fmu:
        begun(fmu, stop=None)
        # The greatest length has too many internal steps: a shorter one has fewer.
        assert answer(fmu, t, h) == (DISCARD if what == "of the greatest length" else KINDS[kind])
        told = {"without end": "must be a finite number", "of the greatest length": "1e9 internal"}
        assert told.get(what, words) in fmu.log[-1][2]


@pytest.mark.parametrize("kind", ["native", "native 3"])
def test_after_the_error_values_can_be_read_and_no_call_goes_on(kind):
    """As in state `error` of FMI 2.0 and `Terminated` of FMI 3.0."""
    with instance(fmu_of(kind)) as fmu:
        begun(fmu)
        x = fmu.get("A.x")
        assert answer(fmu, H, -H) == ERROR
        refused = (
            lambda: fmu.fmu.doStep(H, H),
            lambda: fmu.set(push=0.5),
            lambda: fmu.set(stiffness=30.0),
            fmu.fmu.enterInitializationMode,
            fmu.fmu.exitInitializationMode,
        )
        for call in refused:
            first = len(fmu.log)
            with pytest.raises(FMICallException) as caught:
                call()
            assert caught.value.status == ERROR
            ((level, category, text),) = fmu.log[first:]
            assert (level, category) == (ERROR, "logStatusError")
            assert len(text) > 20
        assert fmu.get("A.x") == x
        fmu.fmu.terminate()  # a liberty: importers end a run with it, however it went
        assert fmu.get("A.x") == x


def back_by_state(fmu: Instance, saved: object) -> None:
    fmu.fmu.setFMUState(saved)


def back_by_bytes(fmu: Instance, saved: object) -> None:
    fmu.fmu.setFMUState(fmu.fmu.deserializeFMUState(fmu.fmu.serializeFMUState(saved)))


def back_by_reset(fmu: Instance, _: object) -> None:
    fmu.fmu.reset()
    begun(fmu)


@pytest.mark.parametrize("back", [back_by_state, back_by_bytes, back_by_reset])
@pytest.mark.parametrize("kind", KINDS)
def test_a_saved_state_or_a_reset_leads_back_as_if_nothing_had_happened(kind, back):
    with instance(fmu_of(kind)) as fmu, instance(fmu_of(kind)) as straight:
        for each in (fmu, straight):
            begun(each)
        saved = fmu.fmu.getFMUState()
        assert answer(fmu, H, STOP) == KINDS[kind]
        back(fmu, saved)
        assert fmu.run(H, H, 10) == straight.run(H, H, 10)
        assert fmu.get("solver.status") == OK


@pytest.mark.parametrize("kind", ["native", "native 3"])
def test_the_state_of_the_error_can_be_saved_and_is_it_again(kind):
    with instance(fmu_of(kind)) as fmu:
        begun(fmu)
        assert answer(fmu, H, 0.0) == ERROR
        saved = fmu.fmu.getFMUState()
        fmu.fmu.reset()
        begun(fmu)
        back_by_bytes(fmu, saved)
        assert answer(fmu, H, H) == ERROR


# ------------------------------------------------------------------------------- the stop time


@pytest.mark.parametrize(
    ("start", "stop", "n"), [(0.0, 1.0, 10), (0.0, 1.0, 3000), (1e3, 1001.7, 17), (-0.3, 0.4, 7)]
)
@pytest.mark.parametrize("kind", KINDS)
def test_sums_of_steps_reach_the_stop_time_and_a_step_from_there_is_beyond_it(kind, start, stop, n):
    """Sums are off by up to half a last digit for each addition."""
    with instance(fmu_of(kind)) as fmu:
        fmu.initialise(start=start, stop=stop, solver__step_size=0.1)
        t, h = start, (stop - start) / n
        for _ in range(n):
            assert answer(fmu, t, h) == OK, fmu.log
            t += h
        assert answer(fmu, t, h) == KINDS[kind]
        assert "ends after the stop time" in fmu.log[-1][2]


@pytest.mark.parametrize("kind", KINDS)
def test_a_step_may_pass_the_stop_time_by_round_off_alone(kind):
    digit = math.ulp(STOP)
    for beyond, taken in ((0, True), (4, True), (50, False)):
        with instance(fmu_of(kind)) as fmu:
            begun(fmu)
            assert answer(fmu, H, 1.0) == OK
            last = STOP - 1.1 + beyond * digit
            assert (answer(fmu, 1.1, last) == OK) == taken, beyond


# ------------------------------------------------------------------ where a shorter one could help


@pytest.mark.parametrize("kind", KINDS)
def test_a_step_that_cannot_be_solved_is_discarded_and_the_run_goes_on(kind):
    """The root of a negative number, at once and later: no slave knows which."""
    with instance(fmu_of(kind)) as fmu:
        begun(fmu)
        fmu.set(push=-4.0)
        assert answer(fmu, H, H) == DISCARD
        fmu.set(push=0.0)
        assert answer(fmu, H, H) == OK


@pytest.mark.parametrize("kind", KINDS)
def test_a_step_that_fails_and_leaves_the_time_as_it_is_cannot_be_shorter(kind):
    with instance(fmu_of(kind)) as fmu:
        begun(fmu)
        fmu.set(push=-4.0)
        assert answer(fmu, H, 1e-20) == KINDS[kind]


@pytest.mark.parametrize("kind", KINDS)
def test_a_step_whose_square_is_no_number_is_impossible(kind):
    """1e-300 s moves the time from 0, but accelerations act over h^2: no shorter step helps."""
    with instance(fmu_of(kind)) as fmu:
        fmu.initialise()
        assert answer(fmu, 0.0, 1e-300) == KINDS[kind]
        assert "must be a finite number > 1e-100 s" in fmu.log[-1][2]
