"""Communication points of a run, and inputs that change at them: arrays, or functions of time.

Between the times of an array an input goes in a straight line; before and after them it stays. A
time that stands twice is a jump, from its first value to its second.

What an input is set to before the step from t to t + H depends on how it goes there: one that is
held gets its value at t, a ramped or smooth one the value at t + H, to which it moves.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from solver.runtime.errors import OptionError, is_double, shown

if TYPE_CHECKING:
    from numpy.typing import NDArray

MOST_STEPS = 10_000_000
"""Most communication steps of a run: all rows are kept in memory until its end."""
ROUNDING = 1e-6
"""Part of a communication step below which two times are one."""
FAR = 2.0
"""Communication steps between rows from which on these are corners and not a sampled curve."""
NOISE = 1e-6
"""Part of the largest rate by which rates of one line differ."""
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
    count = max(1, math.ceil(steps - ROUNDING))
    return [*(start + i * step for i in range(count)), stop]


def _is_finite(value: object) -> bool:
    """Whether a value is a finite number; true and false are none."""
    return not isinstance(value, bool) and is_double(value) and math.isfinite(value)  # type: ignore[arg-type]


def changes(signal: object) -> bool:
    """Whether it is an array or a function, rather than one value for the whole run."""
    return callable(signal) or (not isinstance(signal, str) and np.iterable(signal))


@dataclass(frozen=True, slots=True)
class Moving:
    """How an input goes within a step: `interpolation`, "ramp" or "smooth", and its unit."""

    interpolation: str
    unit: str


def moving_inputs(interpolations: Mapping[str, str], variables: Iterable[Any]) -> dict[str, Moving]:
    """Inputs that move within a step, with their units, which the variables tell."""
    units = {v.name: v.unit or "" for v in variables if v.name in interpolations}
    return {name: Moving(interpolations[name], unit) for name, unit in units.items()}


@dataclass(frozen=True, slots=True)
class Courses:
    """Inputs that change over the communication points of a run."""

    times: list[float]
    """Communication points, and jumps of inputs between them, which end a step too [s]."""
    rows: Sequence[int]
    """Which of the times are the communication points."""
    values: Mapping[str, NDArray[np.float64]] = field(default_factory=dict)
    """By name, shape (len(rows),): at each communication point, and behind it at a jump."""
    sent: Mapping[str, NDArray[np.float64]] = field(default_factory=dict)
    """By name, shape (len(times),): set before the step that ends there; the first at the start."""
    remarks: Sequence[str] = ()
    """Sentences on inputs that go otherwise than their interpolation needs."""


def arrays_over_time(
    columns: Mapping[str, Any],
    problems: list[Problem],
    *,
    jumps: bool = False,
    places: Sequence[str] = (),
) -> dict[str, NDArray[np.float64]]:
    """Arrays by name, checked: ascending times, and a finite value for each of them.

    With `jumps` a time may stand twice. `places` says where each row is in a file.
    """
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
        problems += _wrong_times(arrays, jumps, places)
    return arrays


def _wrong_times(
    arrays: Mapping[str, NDArray[np.float64]], jumps: bool, places: Sequence[str]
) -> list[Problem]:
    times = arrays.get("time")
    if times is None:
        help = "one must be named 'time'; names in a file are separated by commas"
        help = f"columns: {', '.join(arrays)}; {help}"
        return [("has no column 'time'", help)]
    if times.ndim != 1 or len(times) < 2:
        message = f"time must ascend, from at least two rows, got {times.size}"
        return [(message, "give a row for the start and one for the end")]
    rises = np.diff(times) > 0.0
    thrice = ~rises[1:] & ~rises[:-1] & (times[2:] == times[:-2])
    falls = np.diff(times) < 0.0 if jumps else ~rises
    sorting = "sort the rows" if jumps else "sort the rows, and leave out repeated times"
    mistakes = (
        (falls, 1, "time must ascend: {} has {:.15g} s after {:.15g} s", sorting),
        (thrice, 2, "{} is the third row at {:.15g} s", "a jump has two rows of one time"),
    )
    for wrong, further, message, help in mistakes:
        if wrong.any():
            k = int(wrong.argmax()) + further
            place = places[k] if places else f"row {k + 1}"
            return [(message.format(place, times[k], times[k - 1]), help)]
    return [
        (f"{name}: not one value for each time", f"give {len(times)} values")
        for name, values in arrays.items()
        if values.shape != times.shape
    ]


def courses(
    signals: Mapping[str, Any],
    times: Sequence[float],
    moving: Mapping[str, Moving],
    problems: list[Problem],
    places: Sequence[str] = (),
) -> Courses:
    """Inputs over these communication points [s].

    Parameters
    ----------
    signals
        By name arrays, their "time" [s], and functions of the time.
    times
        Communication points; at jumps between them further ones are put in.
    moving
        Inputs that move within a step; all others are held.
    problems
        Gets what is wrong with the signals; the result then has none.
    places
        Where the rows of arrays are in a file.
    """
    at = np.asarray(times, float)
    if callable(signals.get("time")):
        problems.append(("'time' must be an array", "leave it out if all inputs are functions"))
    arrays = {name: signal for name, signal in signals.items() if not callable(signal)}
    if arrays and not problems:
        arrays = arrays_over_time(arrays, problems, jumps=True, places=places)
    if problems:
        return Courses([*times], range(len(times)))
    row_times = _on_points(arrays.pop("time", np.empty(0)), at)
    points = np.union1d(at, _jumps(row_times, [*arrays.values()], at))
    functions = {
        name: [signal(t) for t in points.tolist()]
        for name, signal in signals.items()
        if callable(signal)
    }
    functions = arrays_over_time({"time": points, **functions}, problems)
    if problems:
        return Courses([*times], range(len(times)))
    rows = np.searchsorted(points, at).tolist()
    values, sent, remarks = {}, {}, []
    for name in signals:
        if name == "time":
            continue
        if name in arrays:
            before, after = (_at(points, row_times, arrays[name], side) for side in _SIDES)
        else:
            before = after = functions[name]
        values[name] = after[rows]
        sent[name] = np.append(after[:1], before[1:] if name in moving else after[:-1])
        if name in arrays and name in moving and moving[name].interpolation == "smooth":
            remarks += _turns(name, moving[name].unit, row_times, arrays[name], at)
    return Courses(points.tolist(), rows, values, sent, remarks)


_SIDES: tuple[Literal["left"], Literal["right"]] = "left", "right"


def _at(
    at: NDArray[np.float64],
    times: NDArray[np.float64],
    values: NDArray[np.float64],
    side: Literal["left", "right"],
) -> NDArray[np.float64]:
    """Values on straight lines between rows, at a jump those from one side."""
    behind = np.searchsorted(times, at, side)
    left, right = np.maximum(behind - 1, 0), np.minimum(behind, len(times) - 1)
    length = np.where(times[right] > times[left], times[right] - times[left], 1.0)
    part = np.where(right > left, (at - times[left]) / length, 0.0)
    return np.where(part < 1.0, values[left] + part * (values[right] - values[left]), values[right])


def _on_points(times: NDArray[np.float64], at: NDArray[np.float64]) -> NDArray[np.float64]:
    """Times of rows, those of jumps on the communication points that they miss by rounding."""
    twice = np.flatnonzero(np.diff(times) == 0.0)
    behind = np.clip(np.searchsorted(at, times[twice]), 1, len(at) - 1)
    left, right = at[behind - 1], at[behind]
    nearest = np.where(times[twice] - left < right - times[twice], left, right)
    near = abs(nearest - times[twice]) <= ROUNDING * (right - left)
    moved = times.copy()
    moved[twice[near]] = moved[twice[near] + 1] = nearest[near]
    return moved


def _jumps(
    times: NDArray[np.float64], columns: Sequence[NDArray[np.float64]], at: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Times within the run at which a column jumps."""
    differs = np.zeros(max(len(times) - 1, 0), bool)
    for values in columns:
        differs |= np.diff(values) != 0.0
    found = times[1:][differs & (np.diff(times) == 0.0)]
    return found[(found > at[0]) & (found < at[-1])]


def _turns(
    name: str,
    unit: str,
    times: NDArray[np.float64],
    values: NDArray[np.float64],
    at: NDArray[np.float64],
) -> list[str]:
    """A sentence if a smooth input turns at rows that are far apart against a step.

    Its rate then changes within a step of length H by what the lines differ, so that its
    acceleration there grows as 1/H. Rows at the communication points themselves make no corners.
    """
    inside = (times > at[0]) & (times < at[-1])
    ends = _at(at[[0]], times, values, "right"), _at(at[[-1]], times, values, "left")
    t = np.concatenate([at[:1], times[inside], at[-1:]])
    y = np.concatenate([ends[0], values[inside], ends[1]])
    step, lengths = float(np.median(np.diff(at))), np.diff(t)
    rate = np.append(0.0, np.diff(y) / np.where(lengths > 0.0, lengths, step))  # it begins at rest
    change = abs(np.diff(rate))
    before = np.append(lengths[0], lengths[:-1])
    far = 0.5 * (before + lengths) > FAR * step
    change *= (far | (lengths == 0.0)) & (change > NOISE * abs(rate).max(initial=0.0))
    worst = int(change.argmax())
    if not change[worst]:
        return []
    per = unit or "1"
    return [
        f"{name}: is smooth and gets straight lines, which turn at t = {t[worst]:.6g} s by "
        f"{change[worst]:.3g} {per}/s within a communication step of {step:.6g} s: an "
        f"acceleration of {change[worst] / step:.3g} {per}/s2, which grows as steps become "
        "shorter; give a row for each communication point, a function of the time, or a profile "
        'in a formula of t, or write interpolation = "ramp" if it is to go by straight lines'
    ]
