"""One FMU in a co-simulation: fmpy's instance, spoken to by names of variables."""

from __future__ import annotations

import contextlib
import tempfile
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any

import fmpy
from fmpy.fmi2 import FMU2Slave


class Unit:
    """An instance of an FMU, unpacked in `folder`, that steps from communication point to point."""

    def __init__(self, path: Path, folder: str) -> None:
        description = fmpy.read_model_description(str(path))
        self._references = {v.name: v.valueReference for v in description.modelVariables}
        fmpy.extract(str(path), folder)
        self._fmu = FMU2Slave(
            guid=description.guid,
            unzipDirectory=folder,
            modelIdentifier=description.coSimulation.modelIdentifier,
            instanceName=path.stem,
        )
        self._fmu.instantiate()
        self._fmu.setupExperiment(startTime=0.0)
        self._fmu.enterInitializationMode()

    def start(self) -> None:
        """End the initialization: the mechanism is assembled with what has been set."""
        self._fmu.exitInitializationMode()

    def set(self, values: Mapping[str, float]) -> None:
        """Set Real inputs or parameters."""
        self._fmu.setReal([self._references[name] for name in values], list(values.values()))

    def get(self, names: Iterable[str]) -> list[float]:
        """Values of Real variables."""
        return self._fmu.getReal([self._references[name] for name in names])

    def __getitem__(self, name: str) -> float:
        return self.get([name])[0]

    def step(self, t: float, h: float) -> None:
        """Advance from t to t + h; a step that is discarded is an exception of fmpy."""
        self._fmu.doStep(t, h)

    def save(self) -> Any:
        """State as it is now, to be given back by `forget`."""
        return self._fmu.getFMUState()

    def restore(self, state: Any) -> None:
        """Return to a saved state."""
        self._fmu.setFMUState(state)

    def forget(self, state: Any) -> None:
        """Free a saved state."""
        self._fmu.freeFMUState(state)

    def close(self) -> None:
        """End the run."""
        self._fmu.terminate()
        self._fmu.freeInstance()


@contextlib.contextmanager
def open_units(paths: Mapping[str, Path]) -> Iterator[dict[str, Unit]]:
    """Instances of FMUs, each in an unpack folder of its own; all are gone afterwards."""
    with contextlib.ExitStack() as stack:
        units = {}
        for name, path in paths.items():
            folder = stack.enter_context(tempfile.TemporaryDirectory(ignore_cleanup_errors=True))
            units[name] = Unit(path, folder)
            stack.callback(units[name].close)
        yield units
