"""An importer that has not switched the log on still hears what was refused, from fmpy too."""

from __future__ import annotations

import logging
import subprocess
import sys

import fmpy
import pytest

from build_fmu.run import run_fmu
from fmu_src.log import MOST_TOLD
from fmu_src.status import LOGGER
from tests.fmu_instance import instance, pendulum, scene_fmu

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
    run = run_fmu(pendulum(), stop_time=0.2, settings={"solver.order": 3.0})
    assert "solver.order" in run.reason
    assert not heard()
    assert not logging.getLogger(LOGGER).disabled
