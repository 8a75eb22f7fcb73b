"""Settings of all tests: no clock, one thread, and the same examples in every run."""

import gc
import os
import signal
from collections.abc import Iterator

import pytest
from hypothesis import settings

settings.register_profile("holonom", deadline=None, derandomize=True, database=None)
settings.load_profile("holonom")
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # in each process of xdist


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Begin with what waits for a browser, beside which another process computes."""
    items.sort(key=lambda item: "browser" not in item.path.name)


def pytest_collection_finish() -> None:
    """Keep the collector from looking through thousands of tests and models again and again."""
    gc.collect()
    gc.freeze()
    gc.set_threshold(20_000, 20, 100)


@pytest.fixture
def interruptible() -> Iterator[None]:
    """Ctrl-C raises KeyboardInterrupt, even where nohup or a script has it ignored."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)
