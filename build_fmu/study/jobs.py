"""What an engine is given: a task and its jobs.

A job and what all of them share are small and can be pickled: a path and values, no instances.
"""

from __future__ import annotations

from collections.abc import Callable, Generator
from typing import Any, NamedTuple

DIED = "the process that worked on it died"

Results = Generator[Any, None, None]


class Task(NamedTuple):
    """What is done with each job."""

    function: Callable[[Any, Any], Any]
    """Result of what all jobs share and one job."""
    shared: Any
    lost: Callable[[Any, str], Any]
    """Result of a job that ended its process, from the job and the reason."""
