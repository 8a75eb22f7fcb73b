"""Multibody mechanisms from a scene file: simulate them here, or build FMUs of them.

>>> import holonom
>>> trajectory = holonom.simulate("scenes/double_pendulum.toml", stop_time=10.0)
>>> holonom.build("scenes/four_bar.toml")  # doctest: +SKIP
PosixPath('four_bar.fmu')

It has the names of `solver` and `build_fmu`, where the work is done.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import build_fmu
import solver
from solver.extras import from_homes

if TYPE_CHECKING:
    from build_fmu import *
    from build_fmu.errors import CommandError, EnvironmentLackError, UnfinishedError, UsageError
    from build_fmu.run import run_fmu
    from solver import *

__all__ = ["CommandError", "EnvironmentLackError", "UnfinishedError", "UsageError", "run_fmu"]
__all__ += build_fmu.__all__
__all__ += solver.__all__

if not TYPE_CHECKING:  # so that `import holonom` itself waits for no library
    _HOMES = "solver", "build_fmu", "build_fmu.errors", "build_fmu.run"
    __getattr__, __dir__ = from_homes(__name__, __all__, _HOMES)
