"""Many jobs, in this process, in several, or on other machines; results come as they are ready.

A job and what all of them share are small and can be pickled: a path and values, no instances. A
process that dies takes its job with it and nothing else: its jobs are repeated one by one, and the
one that ends a process again is lost.
"""

from __future__ import annotations

import math
import multiprocessing
import multiprocessing.util
import os
import time
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from dataclasses import dataclass
from typing import Any

from build_fmu.errors import EnvironmentLackError, UsageError

POOL_PAYS = 2.0
"""Seconds of work left above which processes are started, each of which takes half a second."""
CHUNK = 0.3
"""Seconds of work that a process is given at a time: messages cost little then, and it is the most
that is repeated after an interruption."""
MOST_CHUNK = 64
FORMS = "auto, serial, processes, processes:N or dask://HOST:PORT"
DIED = "the process that worked on it died"


@dataclass(frozen=True)
class Task:
    """What is done with each job."""

    function: Callable[[Any, Sequence[Any]], list[Any]]
    """Of what all jobs share and some jobs; a result for each of them, in their order."""
    shared: Any
    lost: Callable[[Any, str], Any]
    """Result of a job that ended its process, from the job and the reason."""


def run_jobs(
    task: Task, jobs: Sequence[Any], engine: str = "auto", workers: int | None = None
) -> Iterator[Any]:
    """Results of all jobs, not in their order.

    Parameters
    ----------
    task, jobs
        What to do with which.
    engine
        "auto": in this process, and in several where that pays; "serial"; "processes", perhaps
        with their number, "processes:4"; or the scheduler of dask.distributed, "dask://host:8786".
    workers
        Number of processes; None: one for each processor.
    """
    kind, _, rest = engine.partition(":")
    if workers is not None and workers < 1:
        text = f"the number of processes must be at least 1, got {workers}"
        raise UsageError(text)
    workers = workers or processors()
    if kind == "auto" and not rest:
        return _auto(task, jobs, workers)
    if kind == "serial" and not rest:
        return _serial(task, jobs)
    if kind == "processes" and (not rest or (rest.isdecimal() and int(rest) > 0)):
        workers = int(rest or workers)
        return _processes(task, jobs, workers, math.ceil(len(jobs) / (8 * workers)))
    if kind == "dask" and rest.startswith("//") and len(rest) > 2:
        return _dask(task, jobs, rest[2:])
    text = f"there is no engine {engine!r}; write {FORMS}"
    raise UsageError(text)


def processors() -> int:
    """Number of processors that this process may use."""
    affinity = getattr(os, "sched_getaffinity", None)
    return len(affinity(0)) if affinity else os.cpu_count() or 1


def _serial(task: Task, jobs: Sequence[Any]) -> Iterator[Any]:
    for job in jobs:
        yield from task.function(task.shared, [job])


def _auto(task: Task, jobs: Sequence[Any], workers: int) -> Iterator[Any]:
    """Here, until it is known that what is left is worth the start of processes."""
    spent: list[float] = []
    for done, job in enumerate(jobs, start=1):
        begin = time.perf_counter()
        results = task.function(task.shared, [job])
        spent.append(time.perf_counter() - begin)
        yield from results
        usual = sum(spent[1:]) / (len(spent) - 1) if len(spent) > 1 else 0.5 * spent[0]
        left = jobs[done:]
        if workers > 1 and len(left) > 1 and usual * len(left) > POOL_PAYS:
            yield from _processes(task, left, workers, int(CHUNK / usual) + 1)
            return


# ------------------------------------------------------------------------------------ processes


def _processes(task: Task, jobs: Sequence[Any], workers: int, size: int) -> Iterator[Any]:
    return _Processes(task, jobs, workers, size).results()


class _Processes:
    """Processes that know nothing of this one (spawn): an FMU cannot be loaded and forked."""

    def __init__(self, task: Task, jobs: Sequence[Any], workers: int, size: int) -> None:
        self._task = task
        self._workers = min(workers, len(jobs)) or 1
        self._chunks = deque(_chunks(jobs, size, self._workers))
        self._suspects: deque[Any] = deque()
        """Jobs of which one has ended its process."""
        self._running: dict[Future, Sequence[Any]] = {}
        self._pool = _pool(self._workers)

    def results(self) -> Iterator[Any]:
        try:
            while self._chunks or self._suspects or self._running:
                self._submit()
                broken = []
                for future in wait(self._running, return_when=FIRST_COMPLETED).done:
                    chunk = self._running.pop(future)
                    if isinstance(future.exception(), BrokenProcessPool):
                        broken.append(chunk)
                    else:
                        yield from future.result()
                if broken:
                    yield from self._recovered([*broken, *self._running.values()])
        finally:
            self._pool.shutdown(cancel_futures=True)

    def _submit(self) -> None:
        if self._suspects:
            if not self._running:
                self._start([self._suspects.popleft()])
            return
        while self._chunks and len(self._running) < 2 * self._workers:
            self._start(self._chunks.popleft())

    def _start(self, chunk: Sequence[Any]) -> None:
        future = self._pool.submit(self._task.function, self._task.shared, chunk)
        self._running[future] = chunk

    def _recovered(self, broken: Sequence[Sequence[Any]]) -> Iterator[Any]:
        """Processes anew; the job that was alone is lost, of several each is tried alone."""
        self._running.clear()
        self._pool.shutdown(cancel_futures=True)
        self._pool = _pool(self._workers)
        try:
            self._pool.submit(os.getpid).result()
        except BrokenProcessPool:
            text = (
                "processes cannot be started; in a script, call this below "
                '`if __name__ == "__main__":`, or take the engine "serial"'
            )
            raise EnvironmentLackError(text) from None
        jobs = [job for chunk in broken for job in chunk]
        if len(jobs) == 1:
            yield self._task.lost(jobs[0], DIED)
        else:
            self._suspects.extend(jobs)


def _pool(workers: int) -> ProcessPoolExecutor:
    context = multiprocessing.get_context("spawn")
    return ProcessPoolExecutor(workers, mp_context=context, initializer=_leave_without_handlers)


def _leave_without_handlers() -> None:
    """Make a process of the pool end so: the handler of pythonfmu's library aborts now and then."""
    multiprocessing.util.Finalize(None, os._exit, args=(0,), exitpriority=-100)


def _chunks(jobs: Sequence[Any], size: int, workers: int) -> list[Sequence[Any]]:
    """Jobs in chunks of `size`, but so that every process has some."""
    size = max(1, min(size, MOST_CHUNK, math.ceil(len(jobs) / (2 * workers))))
    return [jobs[i : i + size] for i in range(0, len(jobs), size)]


# ----------------------------------------------------------------------------------------- dask


def _dask(task: Task, jobs: Sequence[Any], address: str) -> Iterator[Any]:
    """On the workers of a scheduler, which have this package installed as well."""
    try:
        from distributed import (  # pyright: ignore[reportMissingImports]
            Client,
            KilledWorker,
            as_completed,
        )
    except ImportError:
        text = "the package distributed is missing; install it: pip install holonom[dask]"
        raise EnvironmentLackError(text) from None
    try:
        client = Client(f"tcp://{address}", timeout=10)
    except OSError as error:
        text = f"no scheduler of dask answers at {address}: {error}"
        raise EnvironmentLackError(text) from None
    with client:
        threads = sum(client.nthreads().values()) or 1
        chunks = _chunks(jobs, math.ceil(len(jobs) / (8 * threads)), threads)
        shared = client.scatter(task.shared, broadcast=True)
        futures = {
            client.submit(task.function, shared, chunk, pure=False): chunk for chunk in chunks
        }
        for future in as_completed(futures):
            error = future.exception() if future.status == "error" else None
            if isinstance(error, KilledWorker):
                yield from (task.lost(job, DIED) for job in futures[future])
            else:
                yield from future.result()
