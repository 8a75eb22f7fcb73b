"""Whether a driver, or a constraint that reads the time, has a value or rate that jumps.

The second difference of a signal over a step falls with the square of the step where it is smooth,
with the step where its rate jumps, and not at all where its value does.
"""

from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING

import numpy as np

from solver.runtime import Integrator

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from solver.runtime import Model

POINTS = 1000
"""Steps over the experiment: kinks that hide between them in curves are too small to matter."""
ZOOM = 32
"""Steps into which two neighbours are divided, each time."""
ZOOMS = 3
ROUND_OFF = 64 * np.finfo(float).eps
"""Of a second difference, over the largest value."""


def jumps(model: Model) -> bool:
    """Whether a signal jumps in the default experiment, with parameters and inputs at the start."""
    start, stop, *_ = model.experiment
    integrator = Integrator(model, log=lambda _: None)
    integrator.initialise(start)
    return any(
        _jumps(integrator, signal, start, stop) for signal in range(model.sizes["n_signals"])
    )


def _jumps(integrator: Integrator, signal: int, start: float, stop: float) -> bool:
    last, fall, times = np.inf, 1.0, np.linspace(start, stop, POINTS + 1)
    for _ in range(ZOOMS + 1):
        values = _values(integrator, signal, times)
        bend = abs(np.diff(values, 2))
        at = int(bend.argmax())
        if not bend[at] > ROUND_OFF * abs(values).max():
            return False
        fall, last = bend[at] / last, bend[at]
        times = np.linspace(times[at], times[at + 2], ZOOM + 1)
    return bool(fall > (2.0 / ZOOM) ** 1.5)  # between the fall at a kink and that of a curve


def _values(integrator: Integrator, signal: int, times: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the values of a signal at these times."""
    offsets = integrator.model.offsets
    numbers = (ctypes.c_double * len(integrator.numbers))(*integrator.numbers)
    run = integrator.tape(ctypes.addressof(numbers))
    found = np.empty(len(times))
    for k, time in enumerate(times):
        numbers[offsets["time"]] = time
        run(2)
        found[k] = numbers[offsets["signal"] + signal]
    return found
