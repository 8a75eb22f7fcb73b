"""Sentences about steps that are not taken, and about those that fail again and again."""

from __future__ import annotations

import math

MANY = 3
"""Failures in a row at the same time after which it is said what else to change."""
STOP_DIGITS, STOP_SLACK = 8.0, 1e-3


def ends_too_late(t: float, step: float, start: float | None, stop: float) -> bool:
    """Whether a step ends after the stop time by more than round-off; all in s.

    That is some last digits, and one for each step of this size from the start, as communication
    points are often sums; never more than a part of the step.
    """
    if stop == math.inf:
        return False
    begin = start or 0.0
    digits = (STOP_DIGITS + (stop - begin) / step) * math.ulp(max(abs(stop), abs(begin)))
    return t + step > stop + min(STOP_SLACK * step, digits)


def impossible_step(current_time: float, step_size: float, stop_time: float) -> str:
    """Sentence for a step without a proper length, or one that ends after the stop time."""
    step = f"step from t = {current_time!r} s with size {step_size!r} s"
    if not step_size > 0.0:
        return f"{step}: the size must be > 0 s"
    if stop_time == math.inf:
        return f"{step}: the size must be a finite number"
    return (
        f"{step}: it ends after the stop time that the importer gave, {stop_time!r} s; "
        "take a shorter step or define no stop time"
    )


def wrong_experiment(start_time: float, stop_time: float | None) -> str:
    """Sentence for times that no experiment has; empty for a sound one."""
    if not abs(start_time) < float("inf"):
        return f"setupExperiment: the start time must be a finite number, got {start_time!r} s"
    if stop_time is not None and not stop_time >= start_time:
        return (
            f"setupExperiment: the stop time must not be before the start time {start_time!r} s, "
            f"got {stop_time!r} s"
        )
    return ""


class Failures:
    """Steps in a row that could not be solved from the same time.

    It is no part of a state: importers restore one between their attempts.
    """

    def __init__(self) -> None:
        self._time: float | None = None
        self._sizes: list[float] = []

    def forget(self) -> None:
        """Begin anew, after a step that succeeded."""
        self._time = None
        self._sizes.clear()

    def remedy(self, time: float, size: float, step_size: float) -> str:
        """Count a failure; from the third one on, what to change, else nothing.

        `step_size` is the internal step; all in s.
        """
        if time != self._time:
            self.forget()
            self._time = time
        self._sizes.append(size)
        if len(self._sizes) < MANY:
            return ""
        count, shortest, longest = len(self._sizes), min(self._sizes), max(self._sizes)
        sizes, advice = f"all of {size:g} s", "take a smaller communication step"
        if shortest != longest:
            sizes = f"from {longest:g} to {shortest:g} s"
            advice = "shorter communication steps alone do not help"
        return (
            f"; {count} steps in a row failed at this time, {sizes}: {advice}, set "
            f"solver.step_size below {min(step_size, shortest):g} s, and look for very small "
            "masses, very stiff springs, dampers or forces that jump, and lengths that cannot be "
            "closed at this time"
        )
