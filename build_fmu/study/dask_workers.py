"""Jobs on the workers of a scheduler of dask.distributed, on this machine or others."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from build_fmu.errors import EnvironmentLackError
from build_fmu.study.processes import DIED, Results, Task

CONNECTION = 10.0
"""Seconds in which a scheduler must answer."""
MOST_CHUNK = 64


def require_scheduler(address: str) -> None:
    """Refuse one that does not answer, before files are made for what it is to do."""
    _client(address).close()


def run_on_dask(task: Task, jobs: Sequence[Any], address: str) -> Results:
    """Results of all jobs, not in their order.

    The workers have this package installed as well.
    """
    with _client(address) as client:
        from distributed import KilledWorker, as_completed  # pyright: ignore[reportMissingImports]

        # A result, which is computed anew where the worker that has it dies; scattered data is not.
        shared = client.submit(_itself, task.shared, pure=False)

        def submit(chunk: Sequence[Any]) -> Any:
            return client.submit(_each, task.function, shared, chunk, pure=False)

        threads = sum(client.nthreads().values()) or 1
        size = max(1, min(len(jobs) // (8 * threads), MOST_CHUNK))
        chunks = [jobs[i : i + size] for i in range(0, len(jobs), size)]
        running = {submit(chunk): chunk for chunk in chunks}
        suspects: list[Any] = []
        for future in as_completed(list(running)):
            chunk = running.pop(future)
            try:
                yield from future.result()
            except KilledWorker:
                suspects += chunk
        for job in suspects:  # alone: a worker takes what waits for it along
            try:
                yield from submit([job]).result()
            except KilledWorker:
                yield task.lost(job, DIED)


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


def _each(function: Callable[[Any, Any], Any], shared: Any, jobs: Sequence[Any]) -> list[Any]:
    return [function(shared, job) for job in jobs]


def _itself(value: Any) -> Any:
    return value
