"""What moves a model: the compiled kernel and the NumPy reference look alike."""

from __future__ import annotations

import ctypes
from collections.abc import Sequence
from typing import Protocol

from .model import Model

Doubles = ctypes.Array[ctypes.c_double]


class Engine(Protocol):
    """A model bound to an arithmetic, with its own numbers, state and scratch."""

    name: str
    model: Model
    numbers: Doubles
    state: Doubles
    work: Doubles
    """Scratch: nothing in it survives a step."""

    def evaluate(self, segment: int) -> None:
        """Run one segment of the tape on the numbers."""
        ...

    def initialise(self) -> int:
        """Take the initial configuration into the state; return a status."""
        ...

    def advance(self, step: float) -> int:
        """Advance the state by `step` [s]; return a status."""
        ...

    def measure(self) -> None:
        """Fill the measurements in the numbers from the state."""
        ...

    def set_inputs(self, inputs: Sequence[float], parameters: Sequence[float]) -> None:
        """Change inputs and tunable parameters; a jump of stored energy is booked as work."""
        ...

    def residuals(self) -> tuple[list[float], list[float]]:
        """Return the residuals of the rows and their rates, each in the unit of its row."""
        ...
