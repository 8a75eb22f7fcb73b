"""An FMU that is stepped as long as somebody looks at it, with values that change in between."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from build_fmu.errors import UsageError
from build_fmu.fmpy_slaves import Recorder
from build_fmu.fmu_runner import FmuRunner
from build_fmu.instance import not_said_twice, start_time_of
from build_fmu.run import RECORDED, communication_times
from build_fmu.run_page import Carried
from fmu_src.status import FATAL
from viewer.live import StoppedError
from viewer.packing import channels
from viewer.report import missing_columns

if TYPE_CHECKING:
    from numpy import ndarray

MOST_COLUMNS = 1500
"""Of a row: of a larger mechanism it has places, outputs, energies and residuals."""


class SteppedFmu(FmuRunner):
    """An FMU of ours as the source of a live page."""

    def __init__(self, carried: Carried, values: Mapping[str, object]) -> None:
        """Take an FMU, and values that it has from the beginning."""
        super().__init__(carried.path)
        self._carried, self._given = carried, dict(values)
        self._drawn = carried.drawing(self._given)
        recorded = (*RECORDED, "local")
        columns = [
            v.name for v in self.description.modelVariables
            if v.causality in recorded and v.type == "Real"
        ]  # fmt: skip
        if missing := missing_columns(self._drawn, columns):
            text = f"{carried.path}: has no variable {missing}, by which it is drawn"
            raise UsageError(text)
        if len(columns) > MOST_COLUMNS:
            kept = {*channels(self._drawn)[0], *carried.ports}
            errors = ("energy.", "constraint.")
            columns = [n for n in columns if n in kept or n.startswith(errors)]
        self._columns = columns
        self.start_time = start_time_of(self.description)
        times = communication_times(self.description, None, None)
        self.stop_time, self.step_size = times[-1], times[1] - times[0]

    @property
    def columns(self) -> Sequence[str]:
        """As `viewer.live.Source`."""
        return self._columns

    def begin(self, values: Mapping[str, float]) -> ndarray:
        """As `viewer.live.Source`."""
        self._log.clear()
        with self._stopping():
            fmu = self._ready()
            fmu.setupExperiment(startTime=self.start_time)
            self._set(fmu, {**self._given, **values})
            fmu.enterInitializationMode()
            fmu.exitInitializationMode()
            self._recorder = Recorder(fmu, self._references(self.columns), np.zeros(2))
            self._recorder.go_on(1)
            return self._recorder.values[0].copy()

    def set(self, name: str, value: float) -> None:
        """As `viewer.live.Source`."""
        assert self._fmu is not None
        with self._stopping():
            self._set(self._fmu, {name: value})

    def step(self, time: float, step: float) -> ndarray:
        """As `viewer.live.Source`."""
        with self._stopping():
            self._recorder.times[:] = time, time + step
            self._recorder.go_back(1)
            self._recorder.go_on(2)
            return self._recorder.values[1].copy()

    def drawing(self, values: Mapping[str, float]) -> Mapping[str, Any]:
        """As `viewer.live.Source`; the last one that could be drawn."""
        with contextlib.suppress(UsageError):
            self._drawn = self._carried.drawing({**self._given, **values})
        return self._drawn

    def controls(self) -> list[dict[str, Any]]:
        """What can be set by hand: inputs and parameters, which of them act at once, and ranges."""
        settable = {v.name for v in self.description.modelVariables if v.causality in CONTROLLED}
        return [
            _control(v, float(self._given.get(v.name, v.start)))  # type: ignore[arg-type]
            for v in self._carried.model.variables
            if v.name in settable and v.kind != "option" and v.type == "Real"
        ]

    @contextlib.contextmanager
    def _stopping(self) -> Iterator[None]:
        from fmpy.fmi1 import FMICallException

        try:
            with not_said_twice():
                yield
        except FMICallException as error:
            if error.status == FATAL:
                self._fmu = None  # its memory is gone
            raise StoppedError(self._log.reason(str(error))) from None
        except UsageError as error:
            raise StoppedError(str(error)) from None


CONTROLLED = ("input", "parameter")


def _control(variable: Any, start: float) -> dict[str, Any]:
    """A slider: from its limits, or else three times its value, around zero if that is zero."""
    ends = sorted((0.0, 3.0 * start)) if start else [-1.0, 1.0]
    low, high = (
        end if limit is None or (not 1e-300 < abs(limit) < 1e30 and limit) else float(limit)
        for limit, end in zip((variable.minimum, variable.maximum), ends, strict=True)
    )
    return {
        "name": variable.name, "unit": variable.unit, "description": variable.description,
        "start": start, "low": min(low, start), "high": max(high, start),
        "live": variable.causality == "input" or variable.variability == "tunable",
    }  # fmt: skip
