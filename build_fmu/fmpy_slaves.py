"""Slaves of fmpy, of FMI 2.0 and 3.0, with the same calls, and their steps in C.

fmpy finds the version of the standard by the first letters of a class, FMU2 or FMU3.
"""

from __future__ import annotations

import ctypes
from collections.abc import Sequence
from ctypes import c_int32, c_void_p
from typing import TYPE_CHECKING

import numpy as np
from fmpy.fmi1 import FMICallException
from fmpy.fmi2 import FMU2Slave
from fmpy.fmi3 import FMU3Slave

from fmu_src.status import WARNING
from solver.runtime.kernel import shared_library

if TYPE_CHECKING:
    from numpy import ndarray

    from build_fmu.instance import Log


class FMU2Run(FMU2Slave):
    """A slave of FMI 2.0."""

    calls = ("fmi2DoStep", "fmi2GetReal")
    """Those of each communication step."""

    def make(self, log: Log) -> None:
        """Instantiate, with this log."""
        self.instantiate(callbacks=log.callbacks(), loggingOn=True)


class FMU3Run(FMU3Slave):
    """A slave of FMI 3.0, called as one of FMI 2.0."""

    calls = ("fmi3DoStep", "fmi3GetFloat64")
    """As of ``FMU2Run``."""

    _times: tuple[float, float | None] = (0.0, None)

    def make(self, log: Log) -> None:
        """Instantiate, with this log."""
        self.instantiate(loggingOn=True, logMessage=log.hear)

    def setupExperiment(  # noqa: N802 - the name of FMI 2.0
        self,
        startTime: float = 0.0,
        stopTime: float | None = None,
    ) -> None:
        """Remember the times for the call that takes them in FMI 3.0."""
        self._times = startTime, stopTime

    def enterInitializationMode(self) -> None:  # type: ignore[override]  # noqa: N802
        """Enter it with the times that were set up."""
        start, stop = self._times
        FMU3Slave.enterInitializationMode(self, startTime=start, stopTime=stop)

    def getReal(self, references: Sequence[int]) -> list[float]:  # noqa: N802
        """Values of Real variables."""
        return self.getFloat64(references)

    def setReal(self, references: Sequence[int], values: Sequence[float]) -> None:  # noqa: N802
        """Set Real variables."""
        self.setFloat64(references, values)


class _Host(ctypes.Structure):
    """As in solver/kernel/run/host.c."""

    _fields_ = (
        *((name, c_void_p) for name in ("fmu", "step", "get", "reference")),
        *((name, c_int32) for name in ("is_fmi3", "n_read", "reached", "is_read")),
    )


class Recorder:
    """Goes from one communication point to the next, and reads Real variables at each, in C.

    Calls of fmpy take longer than the step of a small mechanism, and those of ctypes half as long.

    Parameters
    ----------
    times
        Communication points in s; those to come may be changed in place.
    """

    def __init__(self, fmu: FMU2Run | FMU3Run, references: Sequence[int], times: ndarray) -> None:
        self.fmu, self.times = fmu, times
        self.values = np.empty((len(times), len(references)))
        """Shape (times, references); of those that are reached."""
        self._references = (ctypes.c_uint32 * len(references))(*references)
        functions = (ctypes.cast(getattr(fmu.dll, name), c_void_p) for name in fmu.calls)
        of_variables = ctypes.addressof(self._references), isinstance(fmu, FMU3Run), len(references)
        self._host = _Host(fmu.component, *functions, *of_variables)
        self._run = shared_library(2).holonom_run_fmu
        self._memory = times.ctypes.data, self.values.ctypes.data

    @property
    def reached(self) -> int:
        """Number of points of which there are values."""
        return self._host.reached

    def go_back(self, reached: int = 0) -> None:
        """Take so many points for reached; what the FMU does is another's concern."""
        self._host.reached = reached

    def go_on(self, end: int) -> None:
        """Go on to the points before this one.

        Raises
        ------
        FMICallException
            With the call that failed and its status; `reached` tells when.
        """
        times, values = self._memory
        status = self._run(ctypes.byref(self._host), times, end, values)
        if status > WARNING:
            call = self.fmu.calls[self._host.is_read]
            raise FMICallException(function=call, status=status)
