"""Ctrl-C in any call of the slave: no exception leaves it, and no step is taken afterwards."""

from __future__ import annotations

import ctypes
import functools
import inspect
import sys
from collections.abc import Callable
from operator import methodcaller
from pathlib import Path

import pytest

from build_fmu.payload import SLAVE_NAME, payload
from fmu_src import status
from fmu_src.slave import Slave
from tests.support.fmus.fmu_instance import instance, of_pendulum, pendulum, slave_of, status_of

SEQUENCE: dict[str, Callable[[Slave], object]] = {
    "setup_experiment": lambda slave: slave.setup_experiment(0.0, 1.0, 1e-6),
    "get_real before": lambda slave: slave.get_real(references("Real")),
    "set_real": lambda slave: slave.set_real([of_pendulum()["push"]], [1.0]),
    "set_integer": lambda slave: slave.set_integer([], []),
    "set_boolean": lambda slave: slave.set_boolean(references("Boolean")[:1], [True]),
    "set_string": lambda slave: slave.set_string(
        [of_pendulum("String")["solver.start"]], ["drawn"]
    ),
    "enter_initialization_mode": lambda slave: slave.enter_initialization_mode(),
    "exit_initialization_mode": lambda slave: slave.exit_initialization_mode(),
    "get_real": lambda slave: slave.get_real(references("Real")),
    "get_integer": lambda slave: slave.get_integer([]),
    "get_boolean": lambda slave: slave.get_boolean(references("Boolean")),
    "get_string": lambda slave: slave.get_string(references("String")),
    "_get_fmu_state": lambda slave: slave._get_fmu_state(),
    "do_step": lambda slave: slave.do_step(0.0, 0.1),
    "terminate": lambda slave: slave.terminate(),
}
"""Calls in an order that FMI allows."""


def references(kind: str) -> list[int]:
    return sorted(of_pendulum(kind).values())


@pytest.fixture(scope="module")
def fresh():
    """Slaves as after instantiation."""
    with instance(pendulum()) as fmu:
        yield lambda: slave_of(fmu)


def package() -> str:
    """Name of the code that travels."""
    return payload(2, "points")[SLAVE_NAME].decode().removesuffix("_slave\n")


def struck(call: Callable[[], object], at: int) -> tuple[object, bool]:
    """Answer of a call with an interrupt before its line number `at`, and whether it had so many.

    Lines of the slave's files count, in the order in which they run.
    """
    left, folder = at, str(Path(sys.modules[package() + ".slave"].__file__ or "").parent)

    def look(frame, event, _):
        nonlocal left
        file = frame.f_code.co_filename
        if not file.startswith(folder) or file.endswith("interrupt_guard.py"):
            return None
        if event == "line":
            left -= 1
            if left < 0:
                sys.settrace(None)
                raise KeyboardInterrupt
        return look

    before = sys.gettrace()
    sys.settrace(look)
    try:
        answer = call()
    except KeyboardInterrupt:
        pytest.fail(f"an interrupt before line number {at} of a call left it")
    finally:
        sys.settrace(before)
    return answer, left < 0


def sequence_struck(slave: Slave, name: str, at: int) -> tuple[object, bool]:
    """All calls up to a first step, of which one is interrupted: its answer, and if it was."""
    answer, hit = None, False
    for each, call in SEQUENCE.items():
        if each == name:
            answer, hit = struck(lambda: call(slave), at)  # noqa: B023 - called at once
            if name == "terminate":
                break
        elif each not in ("do_step", "terminate"):
            call(slave)
    return answer, hit


@pytest.mark.parametrize("name", SEQUENCE)
def test_an_interrupt_in_any_line_of_a_call_ends_it_with_a_refusal(fresh, name):
    at = 0
    while True:
        slave = fresh()
        answer, hit = sequence_struck(slave, name, at)
        if not hit:
            break
        texts = [message.msg for message in slave._get_log_queue()]
        assert any("interrupted from the keyboard" in text for text in texts)
        assert slave.do_step(0.0, 0.1) is False
        assert status_of(slave) == status.INTERRUPTED
        if name.startswith("get_"):
            assert isinstance(answer, list)
        if name == "do_step":
            assert answer is False
        at += 1
    assert at > 1


def test_a_state_that_was_saved_before_an_interrupt_ends_the_refusal(fresh):
    slave = fresh()
    for name in ("setup_experiment", "enter_initialization_mode", "exit_initialization_mode"):
        SEQUENCE[name](slave)
    state = slave._get_fmu_state()
    at = 0
    while struck(lambda: slave._set_fmu_state(state), at)[1]:
        assert slave.do_step(0.0, 0.1) is False
        assert status_of(slave) == status.INTERRUPTED
        slave._set_fmu_state(state)
        assert status_of(slave) == 0.0
        at += 1
    assert at > 3
    assert slave.do_step(0.0, 0.1)


def test_a_state_that_was_being_saved_at_an_interrupt_is_refused(fresh):
    slave = fresh()
    for name in ("setup_experiment", "enter_initialization_mode", "exit_initialization_mode"):
        SEQUENCE[name](slave)
    state, hit = struck(slave._get_fmu_state, 0)
    assert hit
    assert isinstance(state, bytes)  # pythonfmu's library asks for its size
    slave._set_fmu_state(state)
    assert status_of(slave) == status.STATE_REFUSED
    assert not slave.do_step(0.0, 0.1)


def test_bytes_of_states_are_passed_on_without_code_that_an_interrupt_could_strike():
    assert Slave._fmu_state_to_bytes(b"a") == Slave._fmu_state_from_bytes(b"a") == b"a"
    assert not inspect.isfunction(Slave._fmu_state_to_bytes)
    assert not inspect.isfunction(Slave._fmu_state_from_bytes)


# ------------------------------------------------------------- an interrupt that waits at the door


class InC:
    """A slave whose methods are called from C, an interrupt just before each.

    No line of Python runs between them that it could strike.
    """

    def __init__(self, slave: Slave) -> None:
        self._slave = slave

    def __getattr__(self, name: str) -> object:
        def call(*arguments: object) -> object:
            interrupt = functools.partial(ctypes.pythonapi.PyErr_SetInterrupt)
            method = functools.partial(methodcaller(name, *arguments), self._slave)
            return list(map(functools.partial.__call__, [interrupt, method]))[1]

        return call


@pytest.mark.usefixtures("interruptible")
@pytest.mark.parametrize("name", SEQUENCE)
def test_an_interrupt_that_waits_for_a_call_lets_it_answer_and_refuses_steps(fresh, name):
    slave, straight = fresh(), fresh()
    for each, call in SEQUENCE.items():
        if each == name:
            try:
                answer, expected = call(InC(slave)), call(straight)
            except KeyboardInterrupt:
                pytest.fail("an interrupt left the call")
            break
        if each not in ("do_step", "terminate"):
            call(slave)
            call(straight)
    if name.startswith("get_real"):
        code = references("Real").index(of_pendulum()["solver.status"])
        assert answer.pop(code) == status.INTERRUPTED
        assert expected.pop(code) == 0.0
    if name.startswith("get_"):
        assert answer == expected
    texts = [message.msg for message in slave._get_log_queue()]
    assert sum(text.startswith("interrupted from the keyboard") for text in texts) == 1
    assert slave.do_step(0.0, 0.1) is False
    assert status_of(slave) == status.INTERRUPTED
