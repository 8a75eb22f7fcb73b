"""Jobs on the workers of a scheduler of dask.distributed, on this machine or others."""

from __future__ import annotations

import time
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from functools import partial
from typing import Any

from build_fmu.errors import EnvironmentLackError, UsageError
from build_fmu.study.processes import DIED, Results, Task, timed, together
from solver.extras import missing

CONNECTION = 10.0
"""Seconds in which a scheduler must answer."""
TOGETHER, MOST_TOGETHER = 0.2, 64
"""Seconds of work and number of jobs that go to a worker at once, to come back at once: a scheduler
takes some milliseconds for each time."""
NEWS = 1.0
"""Seconds after which workers are counted again: they come and go."""


def require_scheduler(address: str) -> None:
    """Refuse one that does not answer, before files are made for what it is to do."""
    _client(address).close()


def require_client(client: Any) -> None:
    """Refuse what is no client of dask.distributed, or one whose answers must be awaited."""
    if not all(hasattr(client, name) for name in ("submit", "nthreads", "cancel")):
        text = f"engine: must be a text or a dask.distributed.Client, got {type(client).__name__}"
        raise UsageError(text)
    if getattr(client, "asynchronous", False):
        text = "engine: the Client is asynchronous; make one without asynchronous=True"
        raise UsageError(text)


def run_on_dask(task: Task, jobs: Sequence[Any], scheduler: Any) -> Results:
    """Results of all jobs as they end, not in their order.

    `scheduler` is an address or a client, which stays open. The workers have this package installed
    as well.
    """
    with _open(scheduler) as client:
        from distributed import KilledWorker, as_completed  # pyright: ignore[reportMissingImports]

        # A result, which is computed anew where the worker that has it dies; scattered data is not.
        shared = client.submit(_itself, task.shared, pure=False)
        waiting, suspects, running = deque(jobs), [], {}
        count, counted, threads = 1, -NEWS, 1
        ended = as_completed()

        def submit(chunk: Sequence[Any]) -> Any:
            return client.submit(_each, task.function, shared, chunk, pure=False)

        try:
            while waiting or running:
                if waiting and time.monotonic() - counted >= NEWS:
                    counted, threads = time.monotonic(), sum(client.nthreads().values()) or 1
                while waiting and len(running) < 2 * threads:  # so that no worker need wait
                    share = min(count, -(-len(waiting) // (2 * threads)))
                    chunk = [waiting.popleft() for _ in range(share)]
                    future = submit(chunk)
                    running[future] = chunk
                    ended.add(future)
                future = next(ended)
                try:
                    seconds, results = future.result()
                except KilledWorker:
                    suspects += running.pop(future)
                    continue
                del running[future]
                count = together(seconds, len(results), TOGETHER, MOST_TOGETHER)
                yield from results
            for job in suspects:  # alone: a worker takes what waits for it along
                try:
                    yield from submit([job]).result()[1]
                except KilledWorker:
                    yield task.lost(job, DIED)
        finally:
            client.cancel(list(running))


@contextmanager
def _open(scheduler: Any) -> Iterator[Any]:
    if isinstance(scheduler, str):
        with _client(scheduler) as client:
            yield client
    else:
        yield scheduler


def _client(address: str) -> Any:
    if text := missing("distributed", "dask"):
        raise EnvironmentLackError(text)
    from distributed import Client  # pyright: ignore[reportMissingImports]

    try:
        return Client(f"tcp://{address}", timeout=CONNECTION)
    except OSError as error:
        text = f"no scheduler of dask answers at {address}: {error}"
        raise EnvironmentLackError(text) from None


def folder_of_worker() -> str:
    """Folder of the worker of dask that this runs on, which is removed with it."""
    from distributed import get_worker  # pyright: ignore[reportMissingImports]

    return get_worker().local_directory


def _each(
    function: Callable[[Any, Any], Any], shared: Any, jobs: Sequence[Any]
) -> tuple[float, list[Any]]:
    return timed(partial(function, shared), jobs)


def _itself(value: Any) -> Any:
    return value
