"""Engines of a study: every job has one result, whatever happens to the process it runs in."""

from __future__ import annotations

import multiprocessing
import os
import sys
import time
from collections.abc import Sequence

import pytest

from build_fmu.errors import EnvironmentLackError, UsageError
from build_fmu.study.engines import run_jobs
from build_fmu.study.jobs import DIED, Task
from tests.ending_jobs import FATAL, lost, square

PATIENCE = 60.0
"""Seconds after which something is taken to hang."""


@pytest.mark.parametrize("engine", ["auto", "serial", "processes:2"])
def test_every_job_has_its_result(engine):
    found = run_jobs(Task(square, 0, lost), range(20), engine)
    assert sorted(found) == [(i, i * i) for i in range(20)]


def test_a_job_that_ends_its_process_is_lost_and_no_other():
    found = dict(run_jobs(Task(square, -1, lost), range(20), "processes:2"))
    assert found == {i: i * i for i in range(20)} | {FATAL: DIED}


@pytest.mark.parametrize("engine", ["processes:1", "processes:2"])
def test_a_death_while_results_are_taken_costs_one_job(engine):
    jobs = range(FATAL - 3, 24)  # it is in the second chunk, which runs while the first is taken
    found = {}
    for job, result in run_jobs(Task(square, -1, lost), jobs, engine):
        if not found:
            wait_until(lambda: not multiprocessing.active_children())
        found[job] = result
    assert found == {i: i * i for i in jobs} | {FATAL: DIED}


def wait_until(condition) -> None:
    until = time.monotonic() + PATIENCE
    while not condition():
        assert time.monotonic() < until
        time.sleep(0.01)


def test_processes_that_are_killed_while_idle_cost_nothing():
    found = {}
    for job, result in run_jobs(Task(square, 0, lost), range(12), "processes:2"):
        found[job] = result
        for process in multiprocessing.active_children():
            process.kill()
            process.join()
    assert found == {i: i * i for i in range(12)}


def test_a_job_is_lost_when_it_has_ended_two_processes(tmp_path):
    task = Task(end_once, str(tmp_path / "seen"), lost)
    assert list(run_jobs(task, [1], "processes:1")) == [(1, 1)]


def end_once(seen: str, jobs) -> list[tuple[int, int]]:
    """End the process at the first time, as one does that the system takes the memory from."""
    if not os.path.exists(seen):
        os.mkdir(seen)
        os._exit(3)
    return square(0, jobs)


class Watched(Sequence):
    """Jobs that count how often one of them is looked at."""

    def __init__(self, count: int) -> None:
        self.jobs, self.looks = range(count), 0

    def __len__(self) -> int:
        return len(self.jobs)

    def __getitem__(self, at):
        self.looks += len(self.jobs[at]) if isinstance(at, slice) else 1
        return self.jobs[at]


def test_the_effort_for_jobs_is_linear_in_their_number():
    jobs = Watched(2000)
    assert len(list(run_jobs(Task(square, 0, lost), jobs, "auto", 2))) == 2000
    assert jobs.looks <= 2 * 2000 + 1


def test_no_jobs_have_no_results():
    assert list(run_jobs(Task(square, 0, lost), [], "processes:2")) == []


@pytest.mark.parametrize("engine", ["threads", "processes:0", "processes:x", "dask", "dask://"])
def test_an_engine_that_is_not_there_is_refused(engine):
    with pytest.raises(UsageError, match=f"no engine '{engine}'; write auto, serial"):
        run_jobs(Task(square, 0, lost), [1], engine)


def test_a_number_of_processes_is_at_least_one():
    with pytest.raises(UsageError, match="must be at least 1, got 0"):
        run_jobs(Task(square, 0, lost), [1], "processes", 0)


def test_without_dask_the_environment_lacks_something(monkeypatch):
    monkeypatch.setitem(sys.modules, "distributed", None)
    with pytest.raises(EnvironmentLackError, match=r"pip install 'holonom\[dask\]'"):
        list(run_jobs(Task(square, 0, lost), [1], "dask://127.0.0.1:9"))
