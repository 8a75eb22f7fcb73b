"""Ctrl-C ends a long start of the core, or a long step, which then is as if it was not tried."""

from __future__ import annotations

import gc
import os
import signal
import sys
import threading
import weakref
from collections.abc import Callable

import pytest

from build_fmu.run import run_fmu
from solver.mechanics.assembly import assemble
from solver.runtime import AssemblyError, Integrator, Status, StepError
from solver.scene import loads
from tests.core.test_kernel_status import BALL
from tests.support.fmus.fmu_instance import pendulum
from tests.support.kernel.twins import PENDULUM, start

LONG = 9e2
"""[s], in steps of 1e-6 s: an hour of work."""
MOST = 0.9
"""[s]: 2e6 half steps are the most with a tolerance."""
RUNS = {
    "equal steps": (PENDULUM, {"step_size": 1e-6}),
    "compositions": (PENDULUM, {"step_size": 1e-6, "order": 8.0}),
    "a tolerance": (PENDULUM, {"tolerance": 1e-9, "longest_step": 1e-6, "order": 2.0}),
    "located contacts": (BALL, {"step_size": 1e-6}),
    "contacts that are stepped over": (BALL, {"step_size": 1e-6, "contact_mode": "stepped"}),
}


@pytest.fixture(autouse=True)
def _in_a_program_of_python():
    before, interval = (
        signal.signal(signal.SIGINT, signal.default_int_handler),
        sys.getswitchinterval(),
    )
    sys.setswitchinterval(
        1e3
    )  # [s]: a thread runs where this one waits or is in C, and nowhere else
    yield
    sys.setswitchinterval(interval)
    signal.signal(signal.SIGINT, before)


def struck_in_c(call: Callable[[], object]) -> None:
    """Press Ctrl-C as soon as a call has left Python."""
    gate = threading.Lock()
    gate.acquire()

    def strike() -> None:
        gate.acquire()
        os.kill(os.getpid(), signal.SIGINT)

    thread = threading.Thread(target=strike)
    thread.start()
    gate.release()
    try:
        call()
    finally:
        thread.join()


@pytest.mark.parametrize("kind", RUNS)
def test_an_interrupt_ends_a_step_and_leaves_the_state_as_before(kind):
    source, settings = RUNS[kind]
    run, straight = start(source, **settings), start(source, **settings)
    before = run.save()
    with pytest.raises(KeyboardInterrupt):
        struck_in_c(lambda: run.advance(run.time, MOST if "tolerance" in settings else LONG))
    assert run.status is Status.STOPPED
    run.state.head["status"] = Status.OK
    run.state.head["at_fault"] = 0.0
    assert run.save() == before
    for each in (run, straight):
        each.advance(each.time, 1e-3)
    assert run.save() == straight.save()


def test_what_a_handler_of_a_signal_raises_ends_it_as_well():
    class AlarmError(Exception):
        pass

    def ring(*_: object) -> None:
        raise AlarmError

    signal.signal(signal.SIGINT, ring)
    run = start(PENDULUM, step_size=1e-6)
    with pytest.raises(AlarmError):
        struck_in_c(lambda: run.advance(run.time, LONG))


def test_a_handler_that_returns_lets_the_step_go_on():
    heard: list[int] = []
    signal.signal(signal.SIGINT, lambda number, _: heard.append(number))
    run = start(PENDULUM, step_size=1e-5)
    struck_in_c(lambda: run.advance(run.time, 1.0))
    assert (heard, run.time) == ([signal.SIGINT], 1.0)


def test_the_core_says_that_it_was_stopped():
    run = start(PENDULUM, step_size=1e-6)
    caught: list[StepError] = []

    def move() -> None:  # without what Python does of it
        result = run._advance(run._instance, run.time, LONG)
        run._caught.clear()
        with pytest.raises(StepError, match=r"it was interrupted") as error:
            run._end(result)
        caught.append(error.value)

    struck_in_c(move)
    assert caught[0].status is Status.STOPPED


def chain(reach: float) -> str:
    """Scene of 300 links of 1 m whose last one is driven to a place so far along them [m]."""
    links = range(300)
    bodies = [f"b{i} = {{ position = [{i}, 0], mass = 1, inertia = 0.1 }}" for i in links]
    joints = [
        f'j{i} = {{ type = "revolute", bodies = ["{f"b{i - 1}" if i else "ground"}", "b{i}"], '
        f"position = [{i - 0.5}, 0] }}"
        for i in links
    ]
    hand = 'hand = { type = "position", point = "b299", value = ["299 + reach", 3] }'
    reach_of = f"reach = {reach}"
    tables = {"bodies": bodies, "joints": joints, "drivers": [hand], "parameters": [reach_of]}
    text = "\n".join(f"[{name}]\n" + "\n".join(lines) for name, lines in tables.items())
    return f'name = "chain"\ndimension = 2\n{text}\n[solver]\nassemble = true\n'


def test_an_interrupt_ends_a_long_start_that_may_be_tried_again():
    # Out of reach the core tries 20 drawings, with up to 200 rounds each of some 1e5 numbers.
    run = Integrator(assemble(loads(chain(-3.0))), log=lambda _: None)
    run["reach"] = 50.0
    with pytest.raises(KeyboardInterrupt):
        struck_in_c(run.initialise)
    assert b"it was interrupted; start again" in run._library.holonom_message(run._instance)
    assert run.phase == 0
    with pytest.raises(AssemblyError, match="joints contradict each other"):
        run.initialise()
    run["reach"] = -3.0
    run.initialise()
    assert run.phase == 1


def test_an_interrupt_ends_a_long_step_of_an_fmu():
    sys.setswitchinterval(1e-3)
    over, fmu = threading.Event(), pendulum()  # whose files an interrupt would leave open

    def strike() -> None:
        while not over.wait(0.05):
            os.kill(os.getpid(), signal.SIGINT)

    thread = threading.Thread(target=strike)
    thread.start()
    try:
        with pytest.raises(KeyboardInterrupt):
            run_fmu(fmu, stop_time=LONG, step_size=LONG, settings={"solver.step_size": 1e-6})
    finally:
        over.set()
        thread.join()


def test_an_integrator_is_freed_with_its_watch():
    class Watched(Integrator):
        pass

    run = Watched(start(PENDULUM).model)
    gone = weakref.ref(run)
    gc.disable()
    try:
        del run
        assert gone() is None
    finally:
        gc.enable()
