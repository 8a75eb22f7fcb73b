"""What an integrator says to names it does not know and to steps from another time than its own."""

from __future__ import annotations

import math

import pytest

from solver.runtime import AssemblyError, Integrator, OptionError, StepError
from tests.hostile.archives import SCENE
from tests.support.kernel.twins import PENDULUM, model_of, start


def test_a_name_that_does_not_exist_is_answered_with_the_nearest_one():
    integrator = Integrator(model_of(PENDULUM))
    for error in (KeyError, OptionError):
        with pytest.raises(error) as reading:
            integrator["A.xx"]
        assert str(reading.value) == "no variable is named 'A.xx'; did you mean 'A.x'?"
        with pytest.raises(error, match=r"^no variable is named 'solver.step'; did you mean"):
            integrator["solver.step"] = 0.1
    with pytest.raises(KeyError, match=r"^no variable is named 'qqqqqqqqqqqq'$"):
        integrator["qqqqqqqqqqqq"]


NAMES = ("length", "push", "solver.step_size", "solver.order", "A.x", "nonsense", "", "A", "\u00e9")
VALUES = (0.0, -1.0, 2.5, 1e308, -1e308, 5e-324, math.nan, math.inf, "", "x", True, None)


@pytest.mark.parametrize("name", NAMES)
def test_any_value_for_any_name_is_taken_or_refused(name):
    for value in VALUES:
        run = Integrator(model_of(SCENE))
        try:
            run[name] = value
            run.advance(0.0, 0.01)
        except (OptionError, AssemblyError, StepError):
            continue
        assert run["energy.error"] < 1e-9, value


@pytest.mark.parametrize("late", [1e-3, 1e-5, -1e-5])
@pytest.mark.parametrize("time", [0.0, 1e6])
def test_a_step_from_another_time_is_refused_however_late_it_is(time, late):
    # At t = 1e6 s half a step of 1 ms is 5e-10 of t: relative to t it looks like round-off.
    integrator = Integrator(model_of(PENDULUM))
    integrator.initialise(start_time=time)
    with pytest.raises(StepError, match="but the mechanism is at"):
        integrator.advance(time + late, 1e-3)
    integrator.advance(time, 1e-3)


@pytest.mark.parametrize("t", [math.inf, -math.inf, math.nan])
def test_a_step_from_no_time_at_all_is_refused(t):
    with pytest.raises(StepError, match="but the mechanism is at"):
        start(PENDULUM).advance(t, 0.1)


@pytest.mark.parametrize("time", [0.0, 1.0, 1e6])
def test_round_off_of_a_communication_point_is_no_other_time(time):
    integrator = Integrator(model_of(PENDULUM))
    integrator.initialise(start_time=time)
    for i in range(50):
        integrator.advance(time + i * 0.001, 0.001)
    assert integrator.time == pytest.approx(time + 0.05, abs=4 * math.ulp(time + 1.0))


def test_a_step_that_is_not_tried_has_no_status_of_the_kernel():
    integrator = start(PENDULUM)
    with pytest.raises(StepError) as untried:
        integrator.advance(1.0, 0.1)
    with pytest.raises(StepError) as failed:
        integrator.advance(0.0, -0.1)
    assert (untried.value.status, failed.value.status) == (0, 6)
