"""Jobs in several processes of this machine.

A process that dies takes its pool with it. What was handed out and has not come back is repeated,
one job at a time, as the system may have taken the process's memory for another's sake; a job that
ends one of its own is lost.
"""

from __future__ import annotations

import contextlib
import multiprocessing
import os
import signal
import threading
import time
from collections import deque
from collections.abc import Callable, Generator, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from functools import partial
from multiprocessing.connection import Connection
from multiprocessing.synchronize import Semaphore
from typing import Any, NamedTuple

from build_fmu.errors import EnvironmentLackError
from build_fmu.instance import interrupts_held

DIED = "the process that worked on it died"
TOGETHER, MOST_TOGETHER = 0.02, 50
"""Seconds of work and number of jobs that go to a process at once: each way takes 0.3 ms."""

Results = Generator[Any, None, None]


class Task(NamedTuple):
    """What is done with each job.

    A job and what all share are small and can be pickled: a path and values, no instances.
    """

    function: Callable[[Any, Any], Any]
    """Result of what all jobs share and one job."""
    shared: Any
    lost: Callable[[Any, str], Any]
    """Result of a job that ended its process, from the job and the reason."""


def run_in_processes(task: Task, jobs: Sequence[Any], workers: int) -> Results:
    """Results of all jobs, not in their order."""
    waiting, count = deque(jobs), min(workers, len(jobs))
    while waiting:
        suspects: deque[Any] = deque()
        yield from _results_of_a_pool(task, waiting, count, suspects)
        while suspects:
            again: deque[Any] = deque()
            yield from _results_of_a_pool(task, suspects, 1, again, most=1)
            for job in again:  # which may have been handed to a process that was dead already
                lost: deque[Any] = deque()
                yield from _results_of_a_pool(task, deque([job]), 1, lost)
                yield from (task.lost(each, DIED) for each in lost)


def _results_of_a_pool(
    task: Task, waiting: deque[Any], count: int, suspects: deque[Any], most: int | None = None
) -> Results:
    """Results of the jobs that wait; after a death those that were handed out become suspects.

    At most so many are handed out at the same time.
    """
    # Processes know nothing of this one (spawn): an FMU cannot be loaded and forked.
    context = multiprocessing.get_context("spawn")
    end, ours = context.Pipe(duplex=False)
    all_there = context.Semaphore(0)
    shared = (task.function, task.shared, end, all_there)
    pool = ProcessPoolExecutor(count, context, _begin, shared)
    running: dict[Future[Any], list[Any]] = {}
    size = 1
    try:
        _require_start(pool)
        _start_all(pool, count, all_there)
        while waiting or running:
            while waiting and len(running) < (most or 2 * count):  # so that none need wait
                share = min(size, -(-len(waiting) // (2 * count)))
                jobs = [waiting[at] for at in range(most or share)]
                with _interrupts_wait():
                    future = pool.submit(_do, jobs)
                running[future] = jobs
                for _ in jobs:
                    waiting.popleft()
            ended = wait(running, return_when=FIRST_COMPLETED).done
            future = min(ended, key=_was_lost)  # results first: they need not be had again
            seconds, results = future.result()
            size = together(seconds, len(results), TOGETHER, MOST_TOGETHER)
            del running[future]
            yield from results
    except BrokenProcessPool:
        for jobs in running.values():
            suspects.extend(jobs)
    finally:
        ours.close()  # ends the processes, whatever they are doing
        pool.shutdown(cancel_futures=True)
        end.close()


def _was_lost(future: Future[Any]) -> bool:
    return isinstance(future.exception(), BrokenProcessPool)


def _require_start(pool: ProcessPoolExecutor) -> None:
    try:
        with _interrupts_wait():
            pool.submit(int).result()
    except BrokenProcessPool:
        text = (
            "processes cannot be started; in a script, call this below "
            '`if __name__ == "__main__":`, or take the engine "serial"'
        )
        raise EnvironmentLackError(text) from None


def _start_all(pool: ProcessPoolExecutor, count: int, all_there: Semaphore) -> None:
    """Start every process before the first job.

    The pool starts one for each job that finds none idle. Before Python 3.12.1 an error within the
    pool (python/cpython issue 109047) loses a study where it starts one as another dies.
    """
    with _interrupts_wait():
        for _ in range(count):
            pool.submit(_wait_for_all)
    for _ in range(count):
        all_there.release()


@contextlib.contextmanager
def _interrupts_wait() -> Iterator[None]:
    """Let Ctrl-C wait until a process is known to this one.

    It begins with the mask of this thread: Ctrl-C cannot end its imports with a traceback.
    """
    with interrupts_held():  # another thread of this process may take the signal in spite of a mask
        if not hasattr(signal, "pthread_sigmask"):  # Windows
            yield
            return
        from multiprocessing import resource_tracker

        resource_tracker.ensure_running()  # when it starts, it takes SIGINT from the mask
        before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
        try:
            yield
        finally:
            signal.pthread_sigmask(signal.SIG_SETMASK, before)


_work: Callable[[Any], Any]
"""What a process of a pool does with a job."""
_all_there: Semaphore
"""Released once for each process of a pool, when all have been started."""


def _begin(
    function: Callable[[Any, Any], Any], shared: Any, end: Connection, all_there: Semaphore
) -> None:
    """Get a process ready for jobs; it ends with the first one, or when that closes the pipe."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C goes to all; the first process decides
    global _work, _all_there
    _work, _all_there = partial(function, shared), all_there
    threading.Thread(target=_end_with, args=(end,), daemon=True).start()


def _end_with(pipe: Connection) -> None:
    with contextlib.suppress(EOFError, OSError):
        pipe.recv()
    os._exit(1)


def _wait_for_all() -> None:
    _all_there.acquire()


def _do(jobs: Sequence[Any]) -> tuple[float, list[Any]]:
    return timed(_work, jobs)


def timed(work: Callable[[Any], Any], jobs: Sequence[Any]) -> tuple[float, list[Any]]:
    """Seconds that jobs took, and their results."""
    begin = time.perf_counter()
    results = [work(job) for job in jobs]
    return time.perf_counter() - begin, results


def together(seconds: float, count: int, enough: float, most: int) -> int:
    """Number of jobs that go out at once, after so many took so long; for `enough` s of work."""
    return max(1, min(most, int(enough * count / max(seconds, 1e-9))))
