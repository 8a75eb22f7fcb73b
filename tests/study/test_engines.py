"""Engines of a study: every job has one result, whatever happens to the process it runs in."""

from __future__ import annotations

import multiprocessing
import os
import subprocess
import sys
from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor

import pytest

from build_fmu.errors import UsageError
from build_fmu.study.engines import engine_of
from build_fmu.study.processes import DIED, Task
from tests.support.fmus.ending_jobs import FATAL, lost, square
from tests.support.hanging import wait_until


@pytest.mark.parametrize("engine", ["auto", "serial", "processes:2"])
@pytest.mark.parametrize("count", [0, 1, 20])
def test_every_job_has_its_result(engine, count):
    found = engine_of(engine)(Task(square, 0, lost), range(count))
    assert sorted(found) == [(i, i * i) for i in range(count)]
    assert multiprocessing.active_children() == []


@pytest.mark.parametrize("engine", ["processes:1", "processes:2"])
@pytest.mark.parametrize("first", [0, FATAL - 1, FATAL])
def test_a_job_that_ends_its_process_is_lost_and_no_other(engine, first):
    """Also where none went before it, where others go with it, and a result is taken meanwhile."""
    jobs = range(first, 20)
    found = {}
    for job, result in engine_of(engine)(Task(square, -1, lost), jobs):
        if job == first == FATAL - 1 and engine == "processes:1":
            wait_until(lambda: not multiprocessing.active_children())
        found[job] = result
    assert found == {i: i * i for i in jobs} | {FATAL: DIED}


def test_every_process_is_there_before_the_first_job(monkeypatch):
    """A pool of Python 3.11 that starts one as another dies loses the study."""
    there = []

    class Counted(ProcessPoolExecutor):
        def submit(self, function, /, *arguments):
            if arguments:  # jobs; what only starts processes has none
                there.append(len(multiprocessing.active_children()))
            return super().submit(function, *arguments)

    monkeypatch.setattr("build_fmu.study.processes.ProcessPoolExecutor", Counted)
    assert len(list(engine_of("processes:3")(Task(square, 0, lost), range(20)))) == 20
    assert set(there) == {3}


def test_processes_that_are_killed_while_idle_cost_nothing():
    found = {}
    for job, result in engine_of("processes:2")(Task(square, 0, lost), range(12)):
        found[job] = result
        for process in multiprocessing.active_children():
            process.kill()
            process.join()
    assert found == {i: i * i for i in range(12)}


def test_a_job_is_lost_when_it_has_ended_two_processes(tmp_path):
    task = Task(end_once, str(tmp_path / "seen"), lost)
    assert list(engine_of("processes:1")(task, [1])) == [(1, 1)]


def end_once(seen: str, job) -> tuple[int, int]:
    """End the process at the first time, as one does that the system takes the memory from."""
    if not os.path.exists(seen):
        os.mkdir(seen)
        os._exit(3)
    return square(0, job)


def test_an_error_of_a_job_is_one_of_the_first_process():
    with pytest.raises(UsageError, match="no such unit"):
        list(engine_of("processes:2")(Task(refuse, 0, lost), range(20)))
    assert multiprocessing.active_children() == []


def refuse(_shared: int, _job: int) -> None:
    text = "no such unit"
    raise UsageError(text)


UNGUARDED = """
from build_fmu.study.engines import engine_of
from build_fmu.study.processes import Task
from tests.support.fmus.ending_jobs import lost, square
list(engine_of("processes:2")(Task(square, 0, lost), range(4)))
"""


def test_a_script_without_a_guard_is_told_about_it(tmp_path):
    """Each process runs it anew."""
    (tmp_path / "script.py").write_text(UNGUARDED)
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
    command = [sys.executable, tmp_path / "script.py"]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    last = done.stderr.splitlines()[-1]
    assert last.startswith("build_fmu.errors.EnvironmentLackError: processes cannot be started")


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
    assert len(list(engine_of("auto", 2)(Task(square, 0, lost), jobs))) == 2000
    assert jobs.looks <= 2 * 2000 + 1


@pytest.mark.parametrize("engine", ["threads", "processes:0", "processes:x", "dask", "dask://"])
def test_an_engine_that_is_not_there_is_refused(engine):
    with pytest.raises(UsageError, match=f"no engine '{engine}'; write auto, serial"):
        engine_of(engine)


def test_a_number_of_processes_is_at_least_one():
    with pytest.raises(UsageError, match="must be at least 1, got 0"):
        engine_of("processes", 0)
