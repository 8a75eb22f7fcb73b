"""One FMU that is run many times: unpacked once, instantiated once, reset between the runs.

Measured for the four-bar: 10 s in 200 communication steps take 6 ms, of which the reset and the
initialization are 0.1 ms; a new instance in a new folder for each would take 60 ms more.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from os import PathLike
from time import perf_counter
from typing import TYPE_CHECKING, Any

from build_fmu.errors import UsageError
from build_fmu.instance import (
    Log,
    description_of,
    instantiated,
    interrupts_held,
    not_said_twice,
    unpacked,
)
from fmu_src.status import FATAL

if TYPE_CHECKING:
    from tempfile import TemporaryDirectory

    from numpy import ndarray

    from build_fmu.fmpy_slaves import FMU2Run, FMU3Run, Recorder

KINDS = {"Real": float, "Integer": int, "Boolean": bool, "String": str}
"""What values of each type are in Python."""
MOST_STEPS, UNINTERRUPTED = 100, 0.02
"""Communication steps for which Ctrl-C waits; how long they may take, by the last ones [s]."""


@dataclass(frozen=True)
class Record:
    """One run."""

    values: ndarray
    """Shape (points, outputs); the points that were reached."""
    end_time: float
    reason: str
    """Why it ended early, or the first error that the FMU logged; empty if it is a clean run."""
    messages: tuple[str, ...] = ()
    """Sentences with status Warning and above that the FMU logged."""
    warnings: tuple[str, ...] = ()
    """Those of them with status Warning."""


class FmuRunner:
    """An FMU in fmpy, ready to run."""

    def __init__(self, path: str | PathLike[str], folder: str | None = None) -> None:
        """Take an FMU, which is unpacked below `folder` when it runs; None: that for such files."""
        self.description = description_of(path)
        self._unpack = partial(unpacked, path, folder)
        self._folder: TemporaryDirectory[str] | None = None
        self._variables = {v.name: v for v in self.description.modelVariables}
        self._fmu: FMU2Run | FMU3Run | None = None
        self._was_made = False
        self._log = Log()
        self._recorded: Any = None

    def run(
        self,
        settings: Mapping[str, object],
        times: Sequence[float],
        outputs: Sequence[str],
        inputs: Mapping[str, ndarray] | None = None,
        progress: Callable[[float], object] | None = None,
    ) -> Record:
        """Run from the first to the last of the times, and read outputs at each of them.

        `inputs` has those that change, with what is set before each of the times is reached, the
        first of them in the initialization mode. `progress` is called after each step with the part
        that is done.

        Raises
        ------
        UsageError
            If the FMU cannot be instantiated; if it could before, that is a run that failed.
        EnvironmentLackError
            As `unpacked`.
        """
        import numpy as np
        from fmpy.fmi1 import FMICallException

        driven = [{n: x[i] for n, x in inputs.items()} for i in range(len(times))] if inputs else []
        is_plain = {*map(self._kind, outputs)} <= {"Real"}
        most = MOST_STEPS if is_plain and not driven and not progress else 1
        recorder: Recorder | None = None
        rows: list[list[float]] = []  # where not all outputs are Real
        self._log.clear()
        try:
            with not_said_twice(), interrupts_held() as pass_interrupts:
                fmu = self._ready()
                fmu.setupExperiment(startTime=times[0], stopTime=times[-1])
                self._set(fmu, settings)
                fmu.enterInitializationMode()
                self._set(fmu, driven[0] if driven else {})
                fmu.exitInitializationMode()
                recorder = self._recorder_of(fmu, outputs if is_plain else [], times)
                count = 1
                while (reached := recorder.reached) < len(times):
                    if driven and reached:
                        self._set(fmu, driven[reached])
                    begin = perf_counter()
                    recorder.go_on(min(reached + count, len(times)))
                    took = perf_counter() - begin
                    count = max(1, min(most, int(UNINTERRUPTED * count / max(took, 1e-9))))
                    if not is_plain:
                        rows.append(self._read(fmu, outputs))
                    pass_interrupts()
                    if progress and reached:
                        progress((times[reached] - times[0]) / (times[-1] - times[0]))
                fmu.terminate()
        except FMICallException as error:
            if error.status == FATAL:
                self._fmu = None  # its memory is gone
            reason = self._log.reason(str(error))
        except UsageError as error:
            if not self._was_made:
                raise
            reason = str(error)
        else:
            reason = self._log.error
        if recorder and is_plain:
            values = recorder.values[: recorder.reached].copy()
        else:
            values = np.array(rows, float).reshape(len(rows), len(outputs))
        end = times[max(len(values) - 1, 0)]
        return Record(values, end, reason, self._log.messages, self._log.warnings)

    def close(self) -> None:
        """Free the instance and remove the folder."""
        fmu, self._fmu = self._fmu, None
        if fmu is not None:
            fmu.freeInstance()
        if self._folder is not None:
            self._folder.cleanup()

    def _ready(self) -> FMU2Run | FMU3Run:
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
        self._folder = self._folder or self._unpack()
        self._fmu = fmu or instantiated(self.description, self._folder.name, self._log)
        self._was_made = True
        return self._fmu

    def _recorder_of(
        self, fmu: FMU2Run | FMU3Run, outputs: Sequence[str], times: Sequence[float]
    ) -> Recorder:
        """Recorder at its beginning: that of the run before, if it is the same."""
        import numpy as np

        from build_fmu.fmpy_slaves import Recorder

        if self._recorded != (fmu, outputs, times):
            self._recorder = Recorder(fmu, self._references(outputs), np.array(times, float))
            self._recorded = fmu, outputs, times
        self._recorder.go_back()
        return self._recorder

    def _set(self, fmu: FMU2Run | FMU3Run, settings: Mapping[str, object]) -> None:
        for kind, python_type in KINDS.items():
            given = {n: python_type(x) for n, x in settings.items() if self._kind(n) == kind}  # type: ignore[arg-type]
            if given:
                getattr(fmu, f"set{kind}")(self._references(list(given)), list(given.values()))

    def _kind(self, name: str) -> str:
        kind = self._variables[name].type
        return "Integer" if kind == "Enumeration" else kind

    def _references(self, names: Sequence[str]) -> list[int]:
        return [self._variables[name].valueReference for name in names]

    def _read(self, fmu: FMU2Run | FMU3Run, names: Sequence[str]) -> list[float]:
        """Values of variables of any kind."""
        pairs = zip(map(self._kind, names), self._references(names), strict=True)
        return [getattr(fmu, f"get{kind}")([reference])[0] for kind, reference in pairs]
