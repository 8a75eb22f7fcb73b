"""Jobs of which one can take its process with it."""

from __future__ import annotations

import os

FATAL = 7


def square(shared: int, jobs) -> list[tuple[int, int]]:
    """A job of the tests; the one called FATAL takes its process with it."""
    if FATAL in jobs and shared < 0:
        os._exit(3)
    return [(job, job * job) for job in jobs]


def lost(job: int, reason: str) -> tuple[int, str]:
    return job, reason
