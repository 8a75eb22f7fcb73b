"""How much is measured: the published run, a quick look, or the least that exercises all code."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True, kw_only=True)
class Effort:
    """Sizes of a run."""

    name: str
    scale: float
    """Factor on the lengths of runs."""
    repetitions: int
    """Repetitions of each timed entry, of which the minimum counts."""
    budget: float
    """Seconds after which an entry is not repeated any more, once it was timed three times."""
    largest: int
    """Largest number of points of a chain."""
    steps: int
    """Step sizes of a work-precision curve, from the largest."""

    def count(self, full: int, least: int = 1) -> int:
        """Scaled length of a run."""
        return max(least, round(full * self.scale))


FULL = Effort(name="full", scale=1.0, repetitions=15, budget=2.0, largest=100_000, steps=10)
QUICK = Effort(name="quick", scale=0.05, repetitions=3, budget=0.3, largest=10_000, steps=6)
TINY = Effort(name="tiny", scale=1e-4, repetitions=1, budget=0.0, largest=10, steps=2)


def repeated(repetitions: int, budget: float) -> Effort:
    """So many repetitions, each until its budget [s] is spent; of a process that times alone."""
    return Effort(
        name="child", scale=1.0, repetitions=repetitions, budget=budget, largest=1, steps=1
    )
