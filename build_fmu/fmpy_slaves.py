"""Slaves of fmpy, of FMI 2.0 and 3.0, with the same calls; the slow ones without fmpy's detours.

fmpy finds the version of the standard by the first letters of a class, FMU2 or FMU3.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from ctypes import POINTER, byref, cast
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np
from fmpy.fmi1 import FMICallException
from fmpy.fmi2 import FMU2Slave, fmi2Real, fmi2ValueReference
from fmpy.fmi3 import FMU3Slave, fmi3Boolean, fmi3Float64

from fmu_src.status import WARNING

if TYPE_CHECKING:
    from build_fmu.instance import Log


class FMU2Run(FMU2Slave):
    """A slave of FMI 2.0."""

    def make(self, log: Log) -> None:
        """Instantiate, with this log."""
        self.instantiate(callbacks=log.callbacks(), loggingOn=True)

    def advance(self) -> Callable[[float, float], None]:
        """Return the function that makes a step, from a time on, of a length; both in s.

        fmpy's own looks for a log of calls each time, which takes longer than a step of a small
        mechanism.
        """
        call, component = self.dll.fmi2DoStep, self.component

        def advance(time: float, step: float) -> None:
            if (status := call(component, time, step, True)) > WARNING:
                raise FMICallException(function="fmi2DoStep", status=status)

        return advance

    def reader(self, references: Sequence[int]) -> Callable[[], np.ndarray]:
        """Return a function that reads Real variables, into the same memory each time."""
        return _reader(partial(self.dll.fmi2GetReal, self.component), "fmi2GetReal", references)


class FMU3Run(FMU3Slave):
    """A slave of FMI 3.0, called as one of FMI 2.0."""

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

    def advance(self) -> Callable[[float, float], None]:
        """As ``FMU2Run.advance``."""
        call, flags, last = self.dll.fmi3DoStep, [fmi3Boolean() for _ in range(3)], fmi3Float64()
        results = [*map(byref, flags), byref(last)]

        def advance(time: float, step: float) -> None:
            status = call(self.component, fmi3Float64(time), fmi3Float64(step), True, *results)
            if status > WARNING:
                raise FMICallException(function="fmi3DoStep", status=status)

        return advance

    def reader(self, references: Sequence[int]) -> Callable[[], np.ndarray]:
        """As ``FMU2Run.reader``."""
        call = partial(self.dll.fmi3GetFloat64, self.component)
        return _reader(call, "fmi3GetFloat64", references, len(references))


def _reader(
    call: Callable[..., int], name: str, references: Sequence[int], *more: int
) -> Callable[[], Any]:
    count = len(references)
    values = (fmi2Real * count)()
    seen = np.ctypeslib.as_array(values)
    which = cast((fmi2ValueReference * count)(*references), POINTER(fmi2ValueReference))
    get = partial(call, which, count, cast(values, POINTER(fmi2Real)), *more)

    def read() -> np.ndarray:
        if (status := get()) > WARNING:
            raise FMICallException(function=name, status=status)
        return seen

    return read
