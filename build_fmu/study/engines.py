"""Many jobs, in this process, in several, or on other machines; results come as they are ready.

A job and what all of them share are small and can be pickled: a path and values, no instances. One
of several processes that dies takes its job with it and nothing else: what was on its way is
repeated one by one, and the job that ends a process again is lost.
"""

from __future__ import annotations

import math
import multiprocessing
import multiprocessing.util
import os
import signal
import threading
import time
from collections import deque
from collections.abc import Callable, Generator, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from dataclasses import dataclass
from functools import partial
from multiprocessing.connection import Connection
from typing import Any

from build_fmu.errors import EnvironmentLackError, UsageError

POOL_PAYS = 2.0
"""Seconds of work left above which processes are started, each of which takes half a second."""
CHUNK = 0.3
"""Seconds of work that a process is given at a time: messages cost little then, and it is the most
that is repeated after an interruption."""
MOST_CHUNK = 64
CONNECTION = 10.0
"""Seconds in which a scheduler must answer."""
FORMS = "auto, serial, processes, processes:N or dask://HOST:PORT"
DIED = "the process that worked on it died"

Results = Generator[Any, None, None]


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
) -> Results:
    """Results of all jobs, not in their order, from the engine of this name."""
    return engine_of(engine, workers)(task, jobs)


def engine_of(name: str, workers: int | None = None) -> Callable[[Task, Sequence[Any]], Results]:
    """Function of a task and jobs that has their results, not in the order of the jobs.

    Parameters
    ----------
    name
        "auto": in this process, and in several where that pays; "serial"; "processes", perhaps
        with their number, "processes:4"; or the scheduler of dask.distributed, "dask://host:8786".
    workers
        Number of processes; None: one for each processor.
    """
    kind, _, rest = name.partition(":")
    if workers is not None and workers < 1:
        text = f"the number of processes must be at least 1, got {workers}"
        raise UsageError(text)
    workers = workers or processors()
    if kind == "auto" and not rest:
        return partial(_auto, workers=workers)
    if kind == "serial" and not rest:
        return _serial
    if kind == "processes" and (not rest or (rest.isdecimal() and int(rest) > 0)):
        return partial(_processes, workers=int(rest or workers))
    if kind == "dask" and rest.startswith("//") and len(rest) > 2:
        return partial(_dask, address=rest[2:])
    text = f"there is no engine {name!r}; write {FORMS}"
    raise UsageError(text)


def processors() -> int:
    """Number of processors that this process may use."""
    affinity = getattr(os, "sched_getaffinity", None)
    return len(affinity(0)) if affinity else os.cpu_count() or 1


def _serial(task: Task, jobs: Sequence[Any]) -> Results:
    for job in jobs:
        yield from task.function(task.shared, [job])


def _auto(task: Task, jobs: Sequence[Any], workers: int) -> Results:
    """Here, until it is known that what is left is worth the start of processes."""
    first = spent = 0.0
    for done, job in enumerate(jobs, start=1):
        begin = time.perf_counter()
        results = task.function(task.shared, [job])
        spent += time.perf_counter() - begin
        yield from results
        if done == 1:
            first = spent  # with loading: the others take less
        usual = (spent - first) / (done - 1) if done > 1 else 0.5 * first
        left = len(jobs) - done
        if workers > 1 and left > 1 and usual * left > POOL_PAYS:
            yield from _processes(task, jobs[done:], workers, int(CHUNK / usual) + 1)
            return


# ------------------------------------------------------------------------------------ processes


def _processes(task: Task, jobs: Sequence[Any], workers: int, size: int | None = None) -> Results:
    return _Processes(task, jobs, workers, size or math.ceil(len(jobs) / (8 * workers))).results()


class _Processes:
    """Processes that know nothing of this one (spawn): an FMU cannot be loaded and forked."""

    def __init__(self, task: Task, jobs: Sequence[Any], workers: int, size: int) -> None:
        self._task = task
        self._workers = min(workers, len(jobs)) or 1
        self._chunks = deque(_chunks(jobs, size, self._workers))
        self._suspects: deque[Sequence[Any]] = deque()
        """Jobs of which one has ended its process, each as a chunk of its own."""
        self._running: dict[Future, Sequence[Any]] = {}
        self._on_trial = False
        """Whether all that runs is one suspect, in processes that have done nothing before."""
        self._pool = _Pool(self._workers)

    def results(self) -> Results:
        try:
            while self._chunks or self._suspects or self._running:
                alive = self._submit()
                for future in wait(self._running, return_when=FIRST_COMPLETED).done:
                    if isinstance(future.exception(), BrokenProcessPool):
                        alive = False
                    else:
                        del self._running[future]
                        self._on_trial = False
                        yield from future.result()
                if not alive:
                    yield from self._recovered()
        except BaseException:  # nobody waits for what they do
            self._pool.kill()
            raise
        finally:
            self._pool.shutdown(cancel_futures=True)

    def _submit(self) -> bool:
        """Hand out jobs; False if a process has died since the last time."""
        if self._suspects:
            return bool(self._running) or self._start(self._suspects)
        while self._chunks and len(self._running) < 2 * self._workers:
            if not self._start(self._chunks):
                return False
        return True

    def _start(self, queue: deque[Sequence[Any]]) -> bool:
        try:
            future = self._pool.submit(self._task.function, self._task.shared, queue[0])
        except BrokenProcessPool:
            return False
        self._running[future] = queue.popleft()
        return True

    def _recovered(self) -> Results:
        """Processes anew; a job that was on trial is lost, any other gets one."""
        suspects = [job for chunk in self._running.values() for job in chunk]
        self._running.clear()
        self._pool.shutdown(cancel_futures=True)
        self._pool = _Pool(self._workers)
        try:
            self._pool.submit(os.getpid).result()
        except BrokenProcessPool:
            text = (
                "processes cannot be started; in a script, call this below "
                '`if __name__ == "__main__":`, or take the engine "serial"'
            )
            raise EnvironmentLackError(text) from None
        if self._on_trial:
            yield from (self._task.lost(job, DIED) for job in suspects)
        else:
            self._suspects.extendleft([job] for job in reversed(suspects))
        self._on_trial = bool(self._suspects)


class _Pool(ProcessPoolExecutor):
    """Processes that end with this one, and at once if that is wanted.

    Each waits for the end of a pipe of which only this process has the other side.
    """

    def __init__(self, workers: int) -> None:
        context = multiprocessing.get_context("spawn")
        end, self._leash = context.Pipe(duplex=False)
        super().__init__(workers, context, _begin_process, (end,))

    def kill(self) -> None:
        """End all processes, whatever they are doing."""
        self._leash.close()


def _begin_process(leash: Connection) -> None:
    """Prepare a process of the pool."""
    # The handler of pythonfmu's library aborts now and then when a process ends.
    multiprocessing.util.Finalize(None, os._exit, args=(0,), exitpriority=-100)
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C goes to all; the first process decides
    threading.Thread(target=_end_with, args=(leash,), daemon=True).start()


def _end_with(leash: Connection) -> None:
    try:
        leash.recv_bytes()
    except (EOFError, OSError):
        os._exit(1)


def _chunks(jobs: Sequence[Any], size: int, workers: int) -> list[Sequence[Any]]:
    """Jobs in chunks of `size`, but so that every process has some."""
    size = max(1, min(size, MOST_CHUNK, math.ceil(len(jobs) / (2 * workers))))
    return [jobs[i : i + size] for i in range(0, len(jobs), size)]


# ----------------------------------------------------------------------------------------- dask


def _dask(task: Task, jobs: Sequence[Any], address: str) -> Results:
    """On the workers of a scheduler, which have this package installed as well."""
    client = _client(address)
    from distributed import KilledWorker, as_completed  # pyright: ignore[reportMissingImports]

    with client:
        threads = sum(client.nthreads().values()) or 1
        chunks = _chunks(jobs, math.ceil(len(jobs) / (8 * threads)), threads)
        # A result, which is computed anew where the worker that has it dies; scattered data is not.
        shared = client.submit(_itself, task.shared, pure=False)

        def submit(chunk: Sequence[Any]) -> Any:
            return client.submit(task.function, shared, chunk, pure=False)

        running = {submit(chunk): chunk for chunk in chunks}
        finished = as_completed(running)
        suspects: deque[Any] = deque()
        on_trial = False
        for future in finished:
            chunk = running.pop(future)
            error = future.exception() if future.status == "error" else None
            if not isinstance(error, KilledWorker):
                yield from future.result()
            elif on_trial:
                yield task.lost(chunk[0], DIED)
            else:
                suspects.extend(chunk)
            if suspects and not running:  # alone: a worker takes what waits for it along
                on_trial = True
                job = suspects.popleft()
                future = submit([job])
                running[future] = [job]
                finished.add(future)


def _client(address: str) -> Any:
    try:
        from distributed import Client  # pyright: ignore[reportMissingImports]
    except ImportError:
        text = "the package distributed is missing; install it: pip install holonom[dask]"
        raise EnvironmentLackError(text) from None
    try:
        return Client(f"tcp://{address}", timeout=CONNECTION)
    except OSError as error:
        text = f"no scheduler of dask answers at {address}: {error}"
        raise EnvironmentLackError(text) from None


def folder_of_worker() -> str:
    """Folder of the worker of dask that this runs on, which is removed with it."""
    from distributed import get_worker  # pyright: ignore[reportMissingImports]

    return get_worker().local_directory


def _itself(value: Any) -> Any:
    return value
