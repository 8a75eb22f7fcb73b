"""Jobs of which one can take its process with it."""

from __future__ import annotations

import os
import time

FATAL = 7


def square(shared: int, job: int) -> tuple[int, int]:
    """A job of the tests; the one called FATAL takes its process with it."""
    if job == FATAL and shared < 0:
        os._exit(3)
    return job, job * job


def slow(_shared: object, job: int) -> tuple[int, int]:
    """A job that takes 20 ms at least."""
    time.sleep(0.02)
    return job, job


def lost(job: int, reason: str) -> tuple[int, str]:
    return job, reason
