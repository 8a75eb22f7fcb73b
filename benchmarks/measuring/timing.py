"""CPU time of one process, the minimum of interleaved repetitions.

Noise only ever adds time, so that the minimum is the best estimate; the ratio of median to minimum
shows how noisy the machine was. Entries that are compared take turns, so that a machine that slows
down in between slows all of them.
"""

from __future__ import annotations

import gc
import statistics
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass

from benchmarks.measuring.effort import Effort

LEAST_REPETITIONS = 3


def _nothing() -> None:
    """Prepare nothing."""


@dataclass(frozen=True, slots=True)
class Entry:
    """What is timed, and what is done before each repetition without being timed."""

    run: Callable[[], object]
    prepare: Callable[[], object] = _nothing


@dataclass(frozen=True, slots=True)
class Times:
    """CPU seconds of each repetition."""

    seconds: tuple[float, ...]

    @property
    def minimum(self) -> float:
        """Least of all repetitions [s]."""
        return min(self.seconds)

    @property
    def noise(self) -> float:
        """Median over minimum."""
        return statistics.median(self.seconds) / max(self.minimum, 1e-9)


def interleave(
    entries: Mapping[str, Entry],
    effort: Effort,
    clock: Callable[[], float] = time.process_time,
) -> dict[str, Times]:
    """Time entries in turn, `effort.repetitions` times or until their budget is spent."""
    seconds: dict[str, list[float]] = {name: [] for name in entries}
    for repetition in range(effort.repetitions):
        for name, entry in entries.items():
            if repetition >= LEAST_REPETITIONS and sum(seconds[name]) > effort.budget:
                continue
            entry.prepare()
            seconds[name].append(_time(entry.run, clock))
    return {name: Times(tuple(values)) for name, values in seconds.items()}


def _time(run: Callable[[], object], clock: Callable[[], float]) -> float:
    gc.collect()
    gc.disable()
    try:
        begin = clock()
        run()
        return clock() - begin
    finally:
        gc.enable()
