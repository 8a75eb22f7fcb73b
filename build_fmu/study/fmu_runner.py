"""One FMU that is run many times: unpacked once, instantiated once, reset between the runs.

Measured for the four-bar: 10 s in 200 communication steps take 6.3 ms, of which the reset and the
initialization are 0.2 ms; a new instance in a new folder for each would take 60 ms more.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from os import PathLike
from typing import TYPE_CHECKING, Any

from build_fmu.errors import UsageError
from build_fmu.instance import (
    FATAL,
    WARNING,
    Log,
    description_of,
    instantiated,
    interrupts_held,
    not_said_twice,
    unpacked,
)

if TYPE_CHECKING:
    from fmpy.fmi2 import FMU2Slave
    from numpy import ndarray

KINDS = ("Real", "Integer", "Boolean", "String")


@dataclass(frozen=True)
class Record:
    """One run."""

    values: ndarray
    """Shape (points, outputs); the points that were reached."""
    end_time: float
    reason: str
    """Why it ended early, or the first error that the FMU logged; empty if it is a clean run."""
    warnings: tuple[str, ...] = ()
    """Sentences with status Warning that the FMU logged."""


class KeptFmu:
    """An FMU in fmpy, ready to run."""

    def __init__(self, path: str | PathLike[str], folder: str | None = None) -> None:
        """Unpack into a folder of its own below `folder`; None: that for temporary files."""
        self.description = description_of(path)
        self._folder = unpacked(path, folder)
        self._variables = {v.name: v for v in self.description.modelVariables}
        self._fmu: FMU2Slave | None = None
        self._was_made = False
        self._log = Log()

    def run(
        self, settings: Mapping[str, object], times: Sequence[float], outputs: Sequence[str]
    ) -> Record:
        """Run from the first to the last of the times, and read outputs at each of them.

        Raises
        ------
        UsageError
            If the FMU cannot be instantiated; if it could before, that is a run that failed.
        """
        import numpy as np
        from fmpy.fmi1 import FMICallException

        values = np.full((len(times), len(outputs)), np.nan)
        self._log.clear()
        reached = 0
        try:
            with not_said_twice(), interrupts_held() as pass_interrupts:
                fmu = self._ready()
                fmu.setupExperiment(startTime=times[0], stopTime=times[-1])
                self._set(fmu, settings)
                fmu.enterInitializationMode()
                fmu.exitInitializationMode()
                read, step = self._reader(fmu, outputs), _function(fmu, "fmi2DoStep")
                values[0] = read()
                reached = 1
                for i in range(1, len(times)):
                    step(times[i - 1], times[i] - times[i - 1], True)
                    values[i] = read()
                    reached = i + 1
                    pass_interrupts()
        except FMICallException as error:
            if error.status == FATAL:
                self._fmu = None  # its memory is gone
            end, reason = times[max(reached - 1, 0)], self._log.reason(str(error))
            return Record(values[:reached], end, reason, self._log.warnings)
        except UsageError as error:
            if not self._was_made:
                raise
            return Record(values[:0], times[0], str(error))
        return Record(values, times[-1], self._log.error, self._log.warnings)

    def close(self) -> None:
        """Free the instance and remove the folder."""
        fmu, self._fmu = self._fmu, None
        if fmu is not None:
            fmu.freeInstance()
        self._folder.cleanup()

    def _ready(self) -> FMU2Slave:
        """Instance as after instantiation: reset, or a new one where that is not possible."""
        from fmpy.fmi1 import FMICallException

        fmu, self._fmu = self._fmu, None
        if fmu is not None:
            try:
                fmu.reset()
            except FMICallException as error:
                if error.status != FATAL:  # after which it is freed already
                    fmu.freeInstance()
                fmu = None
        self._fmu = fmu or instantiated(self.description, self._folder.name, self._log)
        self._was_made = True
        return self._fmu

    def _set(self, fmu: FMU2Slave, settings: Mapping[str, object]) -> None:
        for kind in KINDS:
            given = {n: x for n, x in settings.items() if self._kind(n) == kind}
            if given:
                references = [self._variables[name].valueReference for name in given]
                getattr(fmu, f"set{kind}")(references, list(given.values()))

    def _kind(self, name: str) -> str:
        kind = self._variables[name].type
        return "Integer" if kind == "Enumeration" else kind

    def _reader(self, fmu: FMU2Slave, outputs: Sequence[str]) -> Any:
        """Function that reads all outputs; nearly always they are Real."""
        kinds = [self._kind(name) for name in outputs]
        references = [self._variables[name].valueReference for name in outputs]
        if not outputs:
            return list
        if set(kinds) <= {"Real"}:
            return _reader_of_reals(fmu, references)
        pairs = list(zip(kinds, references, strict=True))
        return lambda: [getattr(fmu, f"get{kind}")([reference])[0] for kind, reference in pairs]


def _function(fmu: FMU2Slave, name: str) -> Callable[..., None]:
    """Return an FMI function of the instance; it raises FMICallException where it fails.

    fmpy's own looks for a log of calls each time, which takes longer than a step of a small
    mechanism.
    """
    from fmpy.fmi1 import FMICallException

    function, component = getattr(fmu.dll, name), fmu.component

    def call(*arguments: object) -> None:
        status = function(component, *arguments)
        if status > WARNING:
            raise FMICallException(function=name, status=status)

    return call


def _reader_of_reals(fmu: FMU2Slave, references: Sequence[int]) -> Callable[[], ndarray]:
    """Return a function that reads Real variables, into the same memory each time."""
    import numpy as np
    from fmpy.fmi2 import fmi2Real, fmi2ValueReference

    count, get = len(references), _function(fmu, "fmi2GetReal")
    which, values = (fmi2ValueReference * count)(*references), (fmi2Real * count)()
    seen = np.ctypeslib.as_array(values)

    def read() -> ndarray:
        get(which, count, values)
        return seen

    return read
