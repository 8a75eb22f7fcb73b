"""What an engine is given: a task and its jobs, which it hands out in chunks.

A job and what all of them share are small and can be pickled: a path and values, no instances.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Generator, Sequence
from dataclasses import dataclass
from typing import Any

MOST_CHUNK = 64
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


def chunked(jobs: Sequence[Any], size: int, workers: int) -> list[Sequence[Any]]:
    """Jobs in chunks of `size`, but so that every process has some."""
    size = max(1, min(size, MOST_CHUNK, math.ceil(len(jobs) / (2 * workers))))
    return [jobs[i : i + size] for i in range(0, len(jobs), size)]
