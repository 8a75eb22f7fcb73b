"""Jobs on the workers of a scheduler of dask.distributed, on this machine or others."""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Sequence
from typing import Any

from build_fmu.errors import EnvironmentLackError
from build_fmu.study.jobs import DIED, Results, Task, chunked

CONNECTION = 10.0
"""Seconds in which a scheduler must answer."""


def require_scheduler(address: str) -> None:
    """Refuse one that does not answer, before files are made for what it is to do."""
    _client(address).close()


def run_on_dask(task: Task, jobs: Sequence[Any], address: str) -> Results:
    """Results of all jobs, not in their order.

    The workers have this package installed as well.
    """
    client = _client(address)
    from distributed import KilledWorker, as_completed  # pyright: ignore[reportMissingImports]

    with client:
        threads = sum(client.nthreads().values()) or 1
        chunks = chunked(jobs, math.ceil(len(jobs) / (8 * threads)), threads)
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
        text = "the package distributed is missing; install it: pip install 'holonom[dask]'"
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
