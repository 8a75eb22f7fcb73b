"""Ctrl-C in a run ends the run, not the FMU."""

from __future__ import annotations

import signal

import pytest

from build_fmu.instance import Log, interrupts_held, interrupts_taken
from build_fmu.run import run_fmu
from tests.support.fmus.fmu_instance import pendulum


@pytest.fixture(autouse=True)
def _in_a_program_of_python():
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler
    signal.signal(signal.SIGINT, before)


def test_an_interrupt_while_the_fmu_works_ends_the_run(monkeypatch):
    def strike(*_):  # called by the FMU, where a step fails
        signal.raise_signal(signal.SIGINT)

    monkeypatch.setattr(Log, "_hear", strike)
    seen: list[float] = []
    with pytest.raises(KeyboardInterrupt):
        run_fmu(
            pendulum(), stop_time=0.3, settings={"solver.max_newton": 1.0}, progress=seen.append
        )
    assert not seen


def test_an_interrupt_between_steps_ends_the_run():
    with pytest.raises(KeyboardInterrupt):
        run_fmu(pendulum(), stop_time=0.3, progress=lambda _: signal.raise_signal(signal.SIGINT))
    assert run_fmu(pendulum(), stop_time=0.3).finished


def test_an_interrupt_that_is_taken_strikes_at_once_where_it_is_not_held():
    seen = []

    def strike_and_go_on() -> None:
        signal.raise_signal(signal.SIGINT)
        seen.append("held")

    with interrupts_taken():
        with pytest.raises(KeyboardInterrupt):
            signal.raise_signal(signal.SIGINT)
        with pytest.raises(KeyboardInterrupt), interrupts_held(), interrupts_held():
            strike_and_go_on()
        with interrupts_held() as pass_interrupts:
            strike_and_go_on()
            with pytest.raises(KeyboardInterrupt):
                pass_interrupts()
    assert seen == ["held", "held"]
