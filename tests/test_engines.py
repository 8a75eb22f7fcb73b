"""Engines of a study: every job has one result, whatever happens to the process it runs in."""

from __future__ import annotations

import os

import pytest

from build_fmu.errors import EnvironmentLackError, UsageError
from build_fmu.study.engines import DIED, Task, run_jobs

FATAL = 7


def square(shared: int, jobs) -> list[tuple[int, int]]:
    """A job of the tests; the one called FATAL takes its process with it."""
    if FATAL in jobs and shared < 0:
        os._exit(3)
    return [(job, job * job) for job in jobs]


def lost(job: int, reason: str) -> tuple[int, str]:
    return job, reason


@pytest.mark.parametrize("engine", ["auto", "serial", "processes:2"])
def test_every_job_has_its_result(engine):
    found = run_jobs(Task(square, 0, lost), range(20), engine)
    assert sorted(found) == [(i, i * i) for i in range(20)]


def test_a_job_that_ends_its_process_is_lost_and_no_other():
    found = dict(run_jobs(Task(square, -1, lost), range(20), "processes:2"))
    assert found == {i: i * i for i in range(20)} | {FATAL: DIED}


def test_no_jobs_have_no_results():
    assert list(run_jobs(Task(square, 0, lost), [], "processes:2")) == []


@pytest.mark.parametrize("engine", ["threads", "processes:0", "processes:x", "dask", "dask://"])
def test_an_engine_that_is_not_there_is_refused(engine):
    with pytest.raises(UsageError, match=f"no engine '{engine}'; write auto, serial"):
        run_jobs(Task(square, 0, lost), [1], engine)


def test_a_number_of_processes_is_at_least_one():
    with pytest.raises(UsageError, match="must be at least 1, got 0"):
        run_jobs(Task(square, 0, lost), [1], "processes", 0)


def test_without_dask_or_its_scheduler_the_environment_lacks_something():
    with pytest.raises(EnvironmentLackError, match=r"holonom\[dask\]|no scheduler"):
        list(run_jobs(Task(square, 0, lost), [1], "dask://127.0.0.1:9"))
