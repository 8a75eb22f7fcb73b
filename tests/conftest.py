"""Settings of all tests: no clock, and the same examples in every run."""

from hypothesis import settings

settings.register_profile("holonom", deadline=None, derandomize=True, database=None)
settings.load_profile("holonom")
