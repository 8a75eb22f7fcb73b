"""Settings of all tests: no clock, and the same examples in every run."""

import gc

from hypothesis import settings

settings.register_profile("holonom", deadline=None, derandomize=True, database=None)
settings.load_profile("holonom")


def pytest_collection_finish() -> None:
    """Keep the collector from looking through thousands of tests again and again."""
    gc.collect()
    gc.freeze()
