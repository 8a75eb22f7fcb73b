"""A pause of Python's cyclic garbage collector while a scene or a model is made."""

from __future__ import annotations

import gc
from collections.abc import Iterator
from contextlib import contextmanager


@contextmanager
def collector_paused() -> Iterator[None]:
    """Make objects without a search for cycles among them; works as a decorator as well.

    A large scene is millions of objects that all stay. The collector would look at every one of
    them again and again: for 10^5 points that is a third of the time.
    """
    running = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if running:
            gc.enable()
