"""Many jobs, in this process, in several, or on other machines; results come as they are ready."""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Sequence
from functools import partial
from typing import Any

from build_fmu.errors import UsageError
from build_fmu.study.dask_workers import require_client, require_scheduler, run_on_dask
from build_fmu.study.processes import Results, Task, run_in_processes

POOL_PAYS = 2.0
"""Seconds of work left above which processes are started, each of which takes a third of one."""
FORMS = "auto, serial, processes, processes:N or dask://HOST:PORT"


def engine_of(name: Any, workers: int | None = None) -> Callable[[Task, Sequence[Any]], Results]:
    """Function of a task and jobs that has their results, not in the order of the jobs.

    Parameters
    ----------
    name
        "auto": in this process, and in several where that pays; "serial"; "processes", perhaps
        with their number, "processes:4"; or the scheduler of dask.distributed, "dask://host:8786",
        which must answer now; or a `dask.distributed.Client`, which stays open.
    workers
        Number of processes; None: one for each processor.
    """
    if workers is not None and workers < 1:
        text = f"the number of processes must be at least 1, got {workers}"
        raise UsageError(text)
    if not isinstance(name, str):
        require_client(name)
        return partial(run_on_dask, scheduler=name)
    kind, _, rest = name.partition(":")
    workers = workers or processors()
    if kind == "auto" and not rest:
        return partial(_auto, workers=workers)
    if kind == "serial" and not rest:
        return partial(_auto, workers=1)
    if kind == "processes" and (not rest or (rest.isdecimal() and int(rest) > 0)):
        return partial(run_in_processes, workers=int(rest or workers))
    if kind == "dask" and rest.startswith("//") and len(rest) > 2:
        require_scheduler(rest[2:])
        return partial(run_on_dask, scheduler=rest[2:])
    text = f"there is no engine {name!r}; write {FORMS}"
    raise UsageError(text)


def processors() -> int:
    """Number of processors that this process may use."""
    affinity = getattr(os, "sched_getaffinity", None)
    return len(affinity(0)) if affinity else os.cpu_count() or 1


def _auto(task: Task, jobs: Sequence[Any], workers: int) -> Results:
    """Here, until it is known that what is left is worth the start of processes."""
    first = spent = 0.0
    for done, job in enumerate(jobs, start=1):
        begin = time.perf_counter()
        result = task.function(task.shared, job)
        spent += time.perf_counter() - begin
        yield result
        if done == 1:
            first = spent  # with loading: the others take less
        usual = (spent - first) / (done - 1) if done > 1 else 0.5 * first
        left = len(jobs) - done
        if workers > 1 and left > 1 and usual * left > POOL_PAYS:
            yield from run_in_processes(task, jobs[done:], workers)
            return
