"""Jobs in several processes of this machine.

One that dies takes its job with it and nothing else: what was on its way is repeated one by one,
and the job that ends a process again is lost.
"""

from __future__ import annotations

import contextlib
import math
import multiprocessing
import multiprocessing.util
import os
import signal
import threading
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from multiprocessing.connection import Connection
from typing import Any

from build_fmu.errors import EnvironmentLackError
from build_fmu.instance import interrupts_held
from build_fmu.study.jobs import DIED, Results, Task, chunked


def run_in_processes(
    task: Task, jobs: Sequence[Any], workers: int, size: int | None = None
) -> Results:
    """Results of all jobs, not in their order, from processes that get `size` of them at a time."""
    return _Processes(task, jobs, workers, size or math.ceil(len(jobs) / (8 * workers))).results()


class _Processes:
    """Processes that know nothing of this one (spawn): an FMU cannot be loaded and forked."""

    def __init__(self, task: Task, jobs: Sequence[Any], workers: int, size: int) -> None:
        self._task = task
        self._workers = min(workers, len(jobs)) or 1
        self._chunks = deque(chunked(jobs, size, self._workers))
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
        self._pool.kill()  # one that has just begun would else wait for a lock of a dead one
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
        with _interrupts_wait():
            super().__init__(workers, context, _begin_process, (end,))

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future:
        """Hand out a job, which may start processes."""
        with _interrupts_wait():
            return super().submit(fn, *args, **kwargs)

    def kill(self) -> None:
        """End all processes, whatever they are doing."""
        self._leash.close()


@contextlib.contextmanager
def _interrupts_wait() -> Iterator[None]:
    """Let Ctrl-C wait until the pool is whole.

    Processes begin with the mask of this thread: it cannot end their imports with a traceback.
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
