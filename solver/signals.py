"""Communication points of a run, and inputs that change at them: arrays, or functions of time.

Between the times of an array an input goes in a straight line; before and after them it stays.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from solver.runtime.errors import OptionError, is_double, shown

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

MOST_STEPS = 10_000_000
"""Most communication steps of a run: all rows are kept in memory until its end."""
Problem = tuple[str, str]
"""What is wrong, and what helps."""


def communication_points(
    start: float, stop: float, step: float, *, step_is_chosen: bool
) -> list[float]:
    """Start of each communication step and the end of the last, which is exactly `stop` [s].

    Point i is ``start + i * step``, so that rounding does not add up. A step that somebody chose
    must not be longer than the run.

    Raises
    ------
    OptionError
        If there is no such run, or it has more than `MOST_STEPS`.
    """
    number = "must be a finite number"
    if not (_is_finite(stop) and start < stop):
        message = f"the stop time {number} after the start time {start!r} s, got {shown(stop)}"
        raise OptionError(message + "; give another stop time")
    if not (_is_finite(step) and step > 0.0):
        message = f"the communication step {number} > 0 s, got {shown(step)}"
        raise OptionError(message + "; give another step")
    length, steps = f"{stop - start:g} s", (stop - start) / step
    if step_is_chosen and steps < 1.0 - 1e-9:
        message = f"the communication step of {step:g} s is longer than the run of {length}"
        raise OptionError(message + "; take a shorter step")
    if steps > MOST_STEPS:
        message = f"{length} in steps of {step:g} s are {steps:.3g} communication steps"
        raise OptionError(
            message + f", more than the {MOST_STEPS:g} of one run; take a longer step"
        )
    count = max(1, math.ceil(steps - 1e-6))  # a last step of a millionth is rounding
    return [*(start + i * step for i in range(count)), stop]


def _is_finite(value: object) -> bool:
    """Whether a value is a finite number; true and false are none."""
    return not isinstance(value, bool) and is_double(value) and math.isfinite(value)  # type: ignore[arg-type]


def changes(signal: object) -> bool:
    """Whether it is an array or a function, rather than one value for the whole run."""
    return callable(signal) or (not isinstance(signal, str) and np.iterable(signal))


def arrays_over_time(
    columns: Mapping[str, Any], problems: list[Problem]
) -> dict[str, NDArray[np.float64]]:
    """Arrays by name, checked: ascending times, and a finite value for each of them."""
    arrays: dict[str, NDArray[np.float64]] = {}
    for name, values in columns.items():
        try:
            arrays[name] = np.asarray(values, float)
        except OverflowError:  # an integer that no double can hold
            arrays[name] = np.array(np.inf)
        except (TypeError, ValueError) as error:
            problems.append((f"{name}: not numbers: {error}", "give one number for each time"))
            continue
        if not np.isfinite(arrays[name]).all():
            help = "leave out the times at which there is none"
            problems.append((f"{name}: must be finite numbers", help))
    if not problems:
        problems += _wrong_times(arrays)
    return arrays


def _wrong_times(arrays: Mapping[str, NDArray[np.float64]]) -> list[Problem]:
    times = arrays.get("time")
    if times is None:
        help = "one must be named 'time'; names in a file are separated by commas"
        help = f"columns: {', '.join(arrays)}; {help}"
        return [("has no column 'time'", help)]
    falls = np.flatnonzero(~(np.diff(times) > 0.0)) if times.ndim == 1 else np.empty(0)
    if times.ndim != 1 or len(times) < 2 or len(falls):
        row = f"; row {falls[0] + 2} does not" if len(falls) else f", got {times.size}"
        message = f"time must ascend, from at least two rows{row}"
        return [(message, "sort the rows, and leave out repeated times")]
    return [
        (f"{name}: not one value for each time", f"give {len(times)} values")
        for name, values in arrays.items()
        if values.shape != times.shape
    ]


def sampled(
    signals: Mapping[str, Any], times: ArrayLike, problems: list[Problem]
) -> dict[str, NDArray[np.float64]]:
    """Values of all inputs at these times [s], by name.

    `signals` has arrays, their "time" [s], and functions of the time; what is wrong with them goes
    to `problems`.
    """
    at = np.asarray(times, float)
    if callable(signals.get("time")):
        problems.append(("'time' must be an array", "leave it out if all inputs are functions"))
        return {}
    arrays = {name: signal for name, signal in signals.items() if not callable(signal)}
    arrays = arrays_over_time(arrays, problems) if arrays else {}
    if problems:
        return {}
    functions = {
        name: [signal(t) for t in at.tolist()]
        for name, signal in signals.items()
        if callable(signal)
    }
    functions = arrays_over_time({"time": at, **functions}, problems)
    found = {**arrays, **functions}
    return {
        name: found[name] if name not in arrays else np.interp(at, arrays["time"], arrays[name])
        for name in signals
        if name != "time"
    }
