"""Where the solution of a half step is sought first.

Accelerations and multipliers depend on the length of a half step and on which half of its pair it
is, so that they jump from half to half of an internal step, by nearly what they jumped by in the
internal step before. The state keeps these changes in slots, one for each half.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from .state import Motion

Array = NDArray[np.float64]


class Prediction:
    """Changes from half to half of an internal step of so many `halves`, of which `half` is next.

    An internal step of another number of halves forgets those of the last one.
    """

    def __init__(self, motion: Motion, halves: int) -> None:
        self.motion, self.halves, self.half = motion, halves, 0
        if motion.head["halves"] != halves:
            motion.forget_changes()
        motion.head["halves"] = float(halves)

    @property
    def parity(self) -> int:
        """Which half of its pair is next."""
        return self.half % 2

    @property
    def reach(self) -> int:
        """Of how many internal steps before this one the changes are known and used.

        1 is a line, 2 a parabola, 0 leaves the values of the same half of the last pair. The
        formulations that do not conserve swing up from half to half, where a line leads astray.
        """
        slots, known = len(self.motion.a_change), self.motion.head["known"]
        if not self.motion.formulation.startswith("conserving"):
            return 0
        if self.halves > slots or known < self.halves + 1:
            return 0
        return 2 if 2 * self.halves <= slots and known >= 2 * self.halves + 1 else 1

    def _predicted(self, values: Sequence[Array], change: Array, reach: int) -> Array:
        if reach == 0:
            return values[self.parity].copy()
        line = values[1 - self.parity] + change[self.half]
        if reach == 1:
            return line
        return line + (change[self.half] - change[self.half + self.halves])

    def acceleration(self) -> Array:
        """Predicted 2 (d - h v)/h^2 of the moving nodes."""
        return self._predicted(self.motion.a, self.motion.a_change, self.reach)

    def multipliers(self) -> Array:
        """Predicted multipliers."""
        return self._predicted(self.motion.mu, self.motion.mu_change, self.reach)

    def remember(self, a: Array, mu: Array) -> None:
        """Take over what the half step was solved for."""
        motion = self.motion
        for values, change, fresh in (
            (motion.a, motion.a_change, a),
            (motion.mu, motion.mu_change, mu),
        ):
            if self.halves <= len(change):
                if 2 * self.halves <= len(change):
                    change[self.half + self.halves] = change[self.half]
                change[self.half] = fresh - values[1 - self.parity]
            values[self.parity][:] = fresh
        motion.count("known")
