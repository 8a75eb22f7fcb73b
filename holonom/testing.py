"""Assertions for tests of FMUs."""

from build_fmu.testing import assert_conserves, assert_follows

__all__ = ["assert_conserves", "assert_follows"]
