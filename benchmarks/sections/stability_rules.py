"""When a run has survived: the same rule for every solver. Needs no package.

A run of `steps(stop, h)` equal steps survives if every step was solved as it was asked for (none
divided), if whenever it is looked at the energy, from positions and velocities, has moved by no
more than a part of the reference energy, and if no constraint is violated by more than a
hundredth of the length of a link. The largest step is that below which all smaller ones survive.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

LOOSE, TIGHT = 1.0, 0.01
"""Parts of the reference energy: the motion is not of this energy any more; it still is."""
CONSTRAINT = 0.01
LOOKS = 500
"""Times that a run is looked at, at most; each step of a shorter one."""


def steps(stop: float, h: float) -> int:
    """Steps that reach `stop`, or go beyond it by less than one."""
    return max(1, math.ceil(stop / h * (1.0 - 1e-9)))


def stride(count: int) -> int:
    """Steps from one look at a run of `count` steps to the next."""
    return math.ceil(count / LOOKS)


@dataclass(slots=True)
class Outcome:
    """What was seen in a run; `end` says why it did not come to its end (empty if it did)."""

    energy: float = 0.0
    """Largest change of energy over the reference energy."""
    constraint: float = 0.0
    """Largest violation over the length."""
    newton: float | None = None
    """Newton iterations per implicit solve."""
    end: str = ""

    def see(self, energy: float, constraint: float, t: float) -> bool:
        """Take note of the state at `t` [s]; False where the run is lost. NaN is lost."""
        self.energy = _larger(self.energy, abs(energy))
        self.constraint = _larger(self.constraint, constraint)
        if not self.energy <= LOOSE:
            self.end = f"energy lost at {t:.3g} s"
        elif not self.constraint <= CONSTRAINT:
            self.end = f"constraints lost at {t:.3g} s"
        return not self.end

    def survived(self, bound: float) -> bool:
        """Whether all steps were taken within a part of the reference energy."""
        return not self.end and self.energy <= bound


def _larger(a: float, b: float) -> float:
    """Larger of two numbers, NaN where one of them is."""
    return math.nan if math.isnan(a) or math.isnan(b) else max(a, b)


Seen = list[tuple[float, Outcome]]
"""Steps [s] and what became of them, from the smallest."""


def scan(grid: Sequence[float], outcome_of: Callable[[float], Outcome]) -> Seen:
    """Outcomes of growing steps up to the first that is lost."""
    seen: Seen = []
    for h in sorted(grid):
        seen.append((h, outcome_of(h)))
        if not seen[-1][1].survived(LOOSE):
            break
    return seen


def largest(seen: Seen, bound: float) -> tuple[float, Outcome] | None:
    """The largest step which, like all smaller ones, survived within a bound; with its outcome."""
    found = None
    for h, outcome in seen:
        if not outcome.survived(bound):
            break
        found = h, outcome
    return found
