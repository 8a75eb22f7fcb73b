"""Settings of the tests of benchmarks."""

from __future__ import annotations

import gc

import pytest


@pytest.fixture(autouse=True)
def no_collections(monkeypatch):
    """What is timed here need not be exact: collections take half the time, for that sake."""
    monkeypatch.setattr(gc, "collect", lambda: 0)
