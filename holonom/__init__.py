"""Multibody mechanisms from a scene file: simulate them here, or build FMUs of them.

>>> import holonom
>>> trajectory = holonom.simulate("scenes/double_pendulum.toml", stop_time=10.0)
>>> holonom.build("scenes/four_bar.toml")  # doctest: +SKIP
PosixPath('four_bar.fmu')

It has the names of `solver` and `build_fmu`, where the work is done.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

import build_fmu
import solver

if TYPE_CHECKING:
    from build_fmu import *
    from build_fmu.errors import CommandError, EnvironmentLackError, UnfinishedError, UsageError
    from build_fmu.run import run_fmu
    from solver import *
else:

    def __getattr__(name: str) -> object:
        """Import what is asked for, so that `import holonom` itself waits for no library."""
        for home in map(import_module, _HOMES if name in __all__ else ()):
            if hasattr(home, name):
                return getattr(home, name)
        message = f"module 'holonom' has no attribute {name!r}"
        raise AttributeError(message)


__all__ = ["CommandError", "EnvironmentLackError", "UnfinishedError", "UsageError", "run_fmu"]
__all__ += build_fmu.__all__
__all__ += solver.__all__

_HOMES = ("solver", "build_fmu", "build_fmu.errors", "build_fmu.run")
"""Modules that have these names; the one that takes long to import comes last."""


def __dir__() -> list[str]:
    return sorted(__all__)
