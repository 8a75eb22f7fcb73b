"""Jobs in several processes of this machine, each with a pipe of its own.

What the first process has not got back from one that died is known, so a death costs nothing but
the job that was worked on. That one is repeated alone in a new process, as the system may have
taken the old one's memory for another's sake; a job that ends a process again is lost.
"""

from __future__ import annotations

import contextlib
import multiprocessing
import os
import signal
import threading
from collections import deque
from collections.abc import Callable, Generator, Iterator, Sequence
from multiprocessing.connection import Connection, wait
from queue import SimpleQueue
from typing import Any, NamedTuple

from build_fmu.errors import EnvironmentLackError
from build_fmu.instance import interrupts_held

DIED = "the process that worked on it died"

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
    return _Team(task, jobs).results(min(workers, len(jobs)))


class _Team:
    """Processes and the jobs that wait for them."""

    def __init__(self, task: Task, jobs: Sequence[Any]) -> None:
        self._task = task
        self._waiting = deque(jobs)
        self._suspects: deque[Any] = deque()
        """Jobs whose process has died once."""
        self._on_trial = False
        """Whether all that runs is one suspect."""
        self._failed_starts = 0
        self._processes: list[_Process] = []

    def results(self, count: int) -> Results:
        try:
            with _interrupts_wait():
                self._processes += [_Process(self._task) for _ in range(count)]
            while self._hand_out():
                ready = wait([process.pipe for process in self._processes])
                for process in [each for each in self._processes if each.pipe in ready]:
                    try:
                        message = process.pipe.recv()
                    except (EOFError, OSError):
                        yield from self._replaced(process)
                    else:
                        yield from self._taken(process, message)
        finally:  # nobody waits for what they do
            for process in self._processes:
                process.end()

    def _hand_out(self) -> bool:
        """Give jobs to processes; False if there are no more, and all are done."""
        busy = any(process.jobs for process in self._processes)
        if self._suspects and not busy:
            self._renewed(self._processes[0]).give(self._suspects.popleft())
            self._on_trial = True
        elif not self._suspects and not self._on_trial:
            for most in (1, 2):  # a second one, so that none need wait, where there are many
                for process in self._processes:
                    left = len(self._waiting) - (most - 1) * len(self._processes)
                    if len(process.jobs) < most and left > 0:
                        process.give(self._waiting.popleft())
        return any(process.jobs for process in self._processes)

    def _taken(self, process: _Process, message: tuple[Any, Exception | None] | None) -> Results:
        if message is None:
            process.is_started, self._failed_starts = True, 0
            return
        process.jobs.popleft()
        self._on_trial = False
        result, error = message
        if error is not None:
            raise error
        yield result

    def _replaced(self, process: _Process) -> Results:
        """A process anew; a job that was on trial is lost, any other gets one."""
        self._failed_starts += not process.is_started
        if self._failed_starts > len(self._processes):
            text = (
                "processes cannot be started; in a script, call this below "
                '`if __name__ == "__main__":`, or take the engine "serial"'
            )
            raise EnvironmentLackError(text) from None
        self._renewed(process)
        if process.jobs and self._on_trial:
            self._on_trial = False
            yield self._task.lost(process.jobs[0], DIED)
        elif process.jobs:
            suspect, *others = process.jobs
            self._suspects.append(suspect)
            self._waiting.extendleft(reversed(others))

    def _renewed(self, process: _Process) -> _Process:
        with _interrupts_wait():
            process.end()
            new = _Process(self._task)
            self._processes[self._processes.index(process)] = new
        return new


class _Process:
    """A process that knows nothing of this one (spawn): an FMU cannot be loaded and forked."""

    def __init__(self, task: Task) -> None:
        context = multiprocessing.get_context("spawn")
        self.jobs: deque[Any] = deque()
        """What it was given and has not done; it works on the first."""
        self.is_started = False
        self.pipe, theirs = context.Pipe()
        arguments = (theirs, task.function, task.shared)
        self._process = context.Process(target=_work, args=arguments)
        self._process.start()
        theirs.close()

    def give(self, job: Any) -> None:
        """Hand out a job."""
        self.jobs.append(job)
        with contextlib.suppress(OSError):  # it has died, as its pipe is about to say
            self.pipe.send(job)

    def end(self) -> None:
        """End it, whatever it is doing."""
        self._process.kill()
        self._process.join()
        self.pipe.close()


@contextlib.contextmanager
def _interrupts_wait() -> Iterator[None]:
    """Let Ctrl-C wait until the processes are known to this one.

    They begin with the mask of this thread: it cannot end their imports with a traceback.
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


def _work(pipe: Connection, function: Callable[[Any, Any], Any], shared: Any) -> None:
    """Do jobs of the first process until it ends this one."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C goes to all; the first process decides
    jobs: SimpleQueue[Any] = SimpleQueue()
    threading.Thread(target=_listen, args=(pipe, jobs), daemon=True).start()
    pipe.send(None)  # it is started
    while True:
        job = jobs.get()
        try:
            message = function(shared, job), None
        except Exception as error:
            message = None, error
        pipe.send(message)


def _listen(pipe: Connection, jobs: SimpleQueue[Any]) -> None:
    """Take jobs, and end this process with the first one, whatever it is doing."""
    with contextlib.suppress(EOFError, OSError):
        while True:
            jobs.put(pipe.recv())
    os._exit(1)
