"""An importer that has not switched the log on still hears what was refused, from fmpy too."""

from __future__ import annotations

import logging
import subprocess
import sys
import threading
from concurrent.futures import ThreadPoolExecutor

import fmpy
import pytest

from build_fmu.instance import not_said_twice
from build_fmu.run import run_fmu
from fmu_src.log import MOST_TOLD
from fmu_src.status import LOGGER
from tests.support.fmus.fmu_instance import instance, pendulum, scene_fmu
from tests.support.hanging import HANGS

SIMULATE = """
import sys, fmpy
fmpy.simulate_fmu(sys.argv[1], stop_time=0.2, start_values={sys.argv[2]: float(sys.argv[3])})
"""


@pytest.fixture
def heard(caplog):
    """Sentences of the log that stderr would show."""
    with caplog.at_level(logging.WARNING, logger=LOGGER):
        yield lambda: [r.getMessage() for r in caplog.records if r.name == LOGGER]


@pytest.mark.parametrize(
    ("name", "value", "words"),
    [
        ("mass", -1.0, "FMU double_pendulum: mass: must be >= 1e-06 kg, got -1.0"),
        ("solver.order", 3.0, "solver.order: must be 2, 4, 6 or 8"),
        ("solver.tolerance", 1e-20, "solver.tolerance: must be 0 or a number from 1e-14"),
    ],
)
def test_simulate_fmu_with_a_bad_parameter_says_so_on_stderr(name, value, words):
    command = [sys.executable, "-c", SIMULATE, str(scene_fmu("double_pendulum")), name, str(value)]
    process = subprocess.run(command, capture_output=True, text=True, check=False)
    first, second = process.stderr.splitlines()
    assert words in first
    assert "no step is taken" in second
    assert words.partition(": ")[2] in second
    assert not process.stdout


def test_a_run_without_a_fault_says_nothing(heard):
    fmpy.simulate_fmu(str(pendulum()), stop_time=0.2)
    assert not heard()


def test_a_step_that_cannot_be_solved_is_heard_once_and_once_more_with_what_else_to_change(heard):
    with instance(pendulum(push="1e300**(2*push)"), logging=False) as fmu:
        fmu.initialise()
        fmu.set(push=1.0)
        for h in (0.1, 0.05, 0.025, 0.0125):
            assert not fmu.step(0.0, h)
        assert not fmu.log
    first, second = heard()
    assert "step from t = 0" in first
    assert "3 steps in a row failed" in second


def test_a_value_that_is_refused_again_and_again_does_not_fill_the_terminal(heard):
    with instance(pendulum(), logging=False) as fmu:
        for i in range(3 * MOST_TOLD):
            fmu.set(solver__step_size=-1.0)
            fmu.set(solver__penalty=-1.0 - i)
        assert not fmu.log
    assert len(heard()) == MOST_TOLD
    assert len(set(heard())) == MOST_TOLD


def test_a_handler_that_raises_does_not_end_the_instance(monkeypatch):
    def fail(*_, **__):
        raise RuntimeError

    with instance(pendulum()) as fmu:
        fmu.initialise()
        monkeypatch.setattr(logging.getLogger(LOGGER), "handle", fail)
        fmu.set(push=float("nan"))
        assert fmu.log
        fmu.set(push=0.0)
        assert fmu.step(0.0, 0.1)


def test_who_reads_the_log_is_not_told_twice(heard):
    run = run_fmu(pendulum(), stop_time=0.2, settings={"solver.max_newton": 1.0})
    assert "did not converge" in run.reason
    assert not heard()
    assert not logging.getLogger(LOGGER).disabled


def test_who_reads_the_log_in_one_thread_silences_no_other(heard):
    logger, began, said = logging.getLogger(LOGGER), threading.Event(), threading.Event()

    def read() -> None:
        with not_said_twice():
            logger.error("read")
            began.set()
            assert said.wait(HANGS)
        logger.error("after")

    with ThreadPoolExecutor(1) as pool:
        done = pool.submit(read)
        assert began.wait(HANGS)
        with not_said_twice():
            logger.error("read here")
            said.set()
            done.result()
        logger.error("heard")
    assert heard() == ["after", "heard"]


def test_runs_at_the_same_time_have_each_its_own_log():
    began, go_on = threading.Event(), threading.Event()
    with ThreadPoolExecutor(1) as pool:
        first = pool.submit(
            run_fmu,
            pendulum(push="sqrt(0.15 - t)"),  # the second step cannot be solved
            stop_time=0.3,
            progress=lambda _: [began.set(), go_on.wait(HANGS)],
        )
        assert began.wait(HANGS)
        clean = run_fmu(pendulum(), stop_time=0.1, progress=lambda _: [go_on.set(), first.result()])
    assert "step from t = 0.1 s" in first.result().reason
    assert clean.messages == ()


def test_a_per_cent_sign_is_a_single_one_where_fmpy_cannot_format_messages(monkeypatch):
    def lacking(_):
        raise OSError

    monkeypatch.setattr("fmpy.logging.addLoggerProxy", lacking)
    monkeypatch.setattr("build_fmu.study.settings.VERSION", "another")  # so the FMU says it
    run = run_fmu(pendulum(), stop_time=0.2, settings={"solver.start": "50% more"})
    assert "got '50% more'" in run.reason
    assert "got '50% more'" in run.messages[0]
