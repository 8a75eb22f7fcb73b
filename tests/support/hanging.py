"""When a test takes something to hang."""

from __future__ import annotations

import time
from collections.abc import Callable

HANGS = 900.0
"""Seconds after which something is taken to hang, on the slowest and busiest machine.

It ends a test that would wait for ever, and decides nothing else.
"""


def wait_until(condition: Callable[[], bool]) -> None:
    """Return when a condition holds."""
    until = time.monotonic() + HANGS
    while not condition():
        assert time.monotonic() < until
        time.sleep(0.01)
