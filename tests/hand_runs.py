"""Runs of models written by hand."""

from __future__ import annotations

from array import array

import numpy as np
from numpy.typing import NDArray

from solver.options import DEFAULTS
from solver.runtime import State, Status
from solver.runtime.layout import measured_sections
from solver.runtime.options import encode
from tests.hand_models import Hand
from tests.kernel_calls import Kernel

Array = NDArray[np.float64]


class Run:
    """A model in motion; the integrator's checks of scenes are left out."""

    def __init__(self, hand: Hand, **settings: float | str | bool) -> None:
        self.model = hand.model()
        self.kernel = Kernel(self.model)
        self.state = State(self.model.sizes, self.kernel.state)
        self.head, self.vectors = self.state.head, self.state.vectors
        for name, default in (DEFAULTS | {"assemble": False}).items():
            place, number = encode(name, settings.get(name, default))
            self.head[place] = number
        self.vectors["inputs"][:] = array("d", hand.inputs)
        for segment in (0, 1):
            self.kernel.evaluate(segment)
        self.status = Status(self.kernel.initialise())

    def advance(self, count: int, step: float | None = None) -> None:
        """Advance by a number of communication steps, by default of one internal step each."""
        for _ in range(count):
            status = Status(self.kernel.advance(step or self.head["step_size"]))
            assert status is Status.OK, status.name

    def vector(self, *names: str) -> Array:
        """Vectors of the state, summed."""
        return np.sum([np.array(self.vectors[name]) for name in names], axis=0)

    def __getitem__(self, name: str) -> Array:
        """Return a section of the measurements."""
        self.kernel.measure()
        start, count = measured_sections(self.model.sizes)[name]
        start += self.model.offsets["measured"]
        return np.array(self.kernel.numbers[start : start + count])

    def set_inputs(self, *values: float) -> None:
        """Change the inputs."""
        self.kernel.set_inputs(values, [])

    @property
    def balance(self) -> float:
        """Energy that the ledger does not account for [J]."""
        return float(self["energy"][5])
