"""The slave refuses with a message what cannot be done, and no exception ever leaves it."""

from __future__ import annotations

import math

import pytest

from fmu_src import status
from tests.support.fmus.fmu_instance import (
    instance,
    of_pendulum,
    pendulum,
    slave_of,
    status_of,
    stepping_slave,
    text_fmu,
)

DISCARD, ERROR = 2, 3

FIXED_ENDS = """
name = "fixed_ends"
dimension = 2
[parameters]
length = 2.0
[points]
A = { position = [0, 0], mass = 1.0 }
O = { position = [-1, 0], fixed = true }
P = { position = [1, 0], fixed = true }
[joints]
left = { type = "distance", points = ["O", "A"] }
right = { type = "distance", points = ["A", "P"], length = "length - 1" }
"""


def assert_finite(fmu):
    assert all(math.isfinite(value) for value in fmu.outputs())


# --------------------------------------------------------------------------------- assembly


def test_a_length_that_cannot_be_ends_with_a_message():
    with instance(text_fmu(FIXED_ENDS)) as fmu:
        fmu.initialise(length=5.0)
        level, category, text = fmu.log[-1]
        assert (level, category) == (ERROR, "logStatusError")
        assert "right" in text
        assert "4" in text
        assert not fmu.step(0.0, 0.1)
        assert fmu.log[-1][:2] == (DISCARD, "logStatusDiscard")
        assert "right" in fmu.log[-1][2]
        assert fmu.get("solver.status") == status.ASSEMBLY_FAILED
        assert fmu.last_successful_time == 0.0
        assert fmu.get("length") == 5.0
        assert_finite(fmu)
        fmu.fmu.reset()
        fmu.initialise(length=2.0)
        assert fmu.step(0.0, 0.1)
        assert fmu.get("solver.status") == 0


def test_outputs_that_cannot_be_had_yet_do_not_spoil_the_run():
    with instance(text_fmu(FIXED_ENDS)) as fmu:
        fmu.fmu.setupExperiment(startTime=0.0)
        fmu.set(length=5.0)
        fmu.fmu.enterInitializationMode()
        assert_finite(fmu)
        fmu.set(length=2.0)
        fmu.fmu.exitInitializationMode()
        assert fmu.step(0.0, 0.1)


# ----------------------------------------------------------------------------------- values


@pytest.mark.parametrize("bad", [math.nan, math.inf, -math.inf])
def test_a_value_that_is_not_finite_is_refused_until_a_good_one_comes(bad):
    with instance(pendulum()) as fmu, instance(pendulum()) as straight:
        for each in (fmu, straight):
            each.initialise(push=1.0)
            each.run(0.0, 0.1, 1)
        fmu.set(push=bad)
        assert fmu.log[-1][0] == ERROR
        assert "push" in fmu.log[-1][2]
        assert fmu.get("push") == 1.0
        assert not fmu.step(0.1, 0.1)
        assert fmu.last_successful_time == 0.1
        assert fmu.get("solver.status") == status.VALUE_REFUSED
        fmu.set(push=1.0)
        assert fmu.run(0.1, 0.1, 2) == straight.run(0.1, 0.1, 2)


@pytest.mark.parametrize(
    ("values", "words"),
    [
        ({"solver__start": "50% more"}, ("solver.start", "50% more")),
        ({"solver__step_size": -0.01}, ("solver.step_size", ">= 0")),
        ({"solver__max_newton": -3.0}, ("solver.max_newton", "-3")),
        ({"length": math.nan}, ("length", "nan")),
        ({"A__x": 1.0}, ("A.x",)),
    ],
    ids=str,
)
def test_a_refused_value_is_named_and_no_step_is_taken(values, words):
    with instance(pendulum()) as fmu:
        fmu.initialise(**values)
        texts = [text for level, _, text in fmu.log if level == ERROR]
        assert all(word in texts[0] for word in words)
        assert not fmu.step(0.0, 0.1)
        assert_finite(fmu)


def test_a_list_with_one_bad_value_changes_nothing():
    with instance(pendulum()) as fmu:
        fmu.fmu.setReal([fmu.references["length"], fmu.references["mass"]], [3.0, math.nan])
        assert (fmu.get("length"), fmu.get("mass")) == (1.0, 1.0)


def test_value_references_that_do_not_exist_are_refused():
    with instance(pendulum()) as fmu:
        fmu.initialise()
        assert fmu.fmu.getReal([9999]) == [0.0]
        assert fmu.fmu.getInteger([fmu.references["A.x"]]) == [0]
        assert fmu.fmu.getString([fmu.references["A.x"]]) == [b""]
        assert [level for level, _, _ in fmu.log] == [0, ERROR, ERROR, ERROR]
        assert fmu.step(0.0, 0.1)
        fmu.fmu.setInteger([0], [1])
        assert not fmu.step(0.1, 0.1)


@pytest.mark.parametrize(
    "word", ["nonsense", "it's", 'a "word"', "'both\"", "50 %", "Grün\n\t\\", "\x1b", ""]
)
def test_a_refused_word_is_shown_as_python_shows_it(word):
    with instance(pendulum()) as fmu:
        fmu.set(solver__start=word)
        assert fmu.log[-1][2].endswith(f"got {word!r}")


def test_a_start_that_breaks_several_rules_is_told_in_one_line_with_each_remedy_once():
    two = FIXED_ENDS.replace("[joints]", "B = { position = [-1, 1], mass = 1 }\n[joints]")
    two += 'third = { type = "distance", points = ["B", "O"], length = "length - 1" }\n'
    with instance(text_fmu(two)) as fmu:
        fmu.initialise(length=0.5)
        ((_, _, text),) = [line for line in fmu.log if line[0] == ERROR]
        assert "right" in text
        assert "third" in text
        remedies = text.split("; ")
        assert len(remedies) == len({*remedies})


# ------------------------------------------------------------------------------------ steps


def test_a_step_refused_after_one_that_failed_has_its_own_code():
    with instance(pendulum(push="sqrt(0.15 - t)")) as fmu:
        fmu.initialise()
        assert fmu.step(0.0, 0.1)
        assert not fmu.step(0.1, 0.1)
        assert 0 < fmu.get("solver.status") < 100
        assert not fmu.step(0.5, 0.1)
        assert fmu.get("solver.status") == status.STEP_REFUSED


def test_a_step_that_begins_or_ends_elsewhere_is_discarded_at_a_late_time_too():
    # 1e-9 of the time would be half a step.
    with instance(pendulum()) as fmu:
        fmu.initialise(start=1e6, stop=1e6 + 0.01)
        assert not fmu.step(1e6 + 5e-4, 1e-3)
        assert not fmu.step(1e6, 0.0105)
        assert "stop time" in fmu.log[-1][2]
        assert fmu.step(1e6, 1e-3)


def test_the_start_time_is_where_the_first_step_begins():
    with instance(pendulum()) as fmu:
        fmu.initialise(start=-3.0)
        assert not fmu.step(0.0, 0.1)
        assert fmu.step(-3.0, 0.5)
        assert fmu.get("clock") == -2.5


def test_without_logging_a_failure_still_shows_in_the_status():
    with instance(pendulum(), logging=False) as fmu:
        fmu.initialise(push=math.nan)
        assert not fmu.step(0.0, 0.1)
        assert fmu.get("solver.status") == status.VALUE_REFUSED
        assert not fmu.log


# ------------------------------------------------------------------------- a fault of our own


def broken(name, *_):
    """Stand in for calls of the library."""
    message = f"{name}: 100% broken \udcff"
    raise RuntimeError(message)


def test_no_exception_leaves_the_slave_whatever_breaks():
    with instance(pendulum()) as fmu:
        slave = slave_of(fmu)
    slave._call = broken
    slave.setup_experiment(0.0, None, 1e-6)
    slave.enter_initialization_mode()
    reals, words = ([*of_pendulum(kind).values()] for kind in ("Real", "String"))
    assert slave.get_real(reals) == [0.0] * len(reals)
    slave.set_real(reals[:1], [1.0])
    slave.exit_initialization_mode()
    assert slave.do_step(0.0, 0.1) is False
    assert slave.get_string(words) == [""] * len(words)
    state = slave._get_fmu_state()
    slave._set_fmu_state(state)
    slave.terminate()
    assert all("%%" in message.msg for message in slave._get_log_queue() if "100" in message.msg)


@pytest.mark.parametrize(
    ("fault", "code"),
    [(KeyboardInterrupt, status.INTERRUPTED), (ZeroDivisionError, status.INTERNAL_FAULT)],
)
def test_after_a_step_that_breaks_in_its_midst_only_a_saved_state_helps(monkeypatch, fault, code):
    def break_off(*_):
        raise fault

    slave = stepping_slave()
    state = slave._get_fmu_state()
    with monkeypatch.context() as context:
        context.setattr(slave, "_call", break_off)
        assert not slave.do_step(0.0, 0.1)
    assert status_of(slave) == code
    assert not slave.do_step(0.0, 0.1)
    slave._set_fmu_state(state)
    assert slave.do_step(0.0, 0.1)
