"""Length and order of internal steps that a tolerance asks for.

A step may add tolerance h/horizon, so that a run over the horizon ends with an error of the
tolerance.
"""

from __future__ import annotations

import math

import numpy as np

from .estimate import Estimate, StepError
from .mechanism import Mechanism
from .state import Motion

SAFETY, REJECTED = 0.5, 2.0
"""Parts of what a step may add: what is aimed at, and what is not accepted."""

SHRINKS, GROWS = 0.2, 2.0

STRETCHED = 1.1
"""Times the length wanted, where that spares a step."""


class Control:
    """Chooses; `motion` holds the choice, which is what survives a step."""

    def __init__(self, mechanism: Mechanism, motion: Motion) -> None:
        self.mechanism, self.motion, self.head = mechanism, motion, motion.head
        self.estimate = Estimate(mechanism, motion)

    @property
    def dissipative(self) -> bool:
        """Whether something takes energy out, which parts that go back in time would give."""
        damped = bool(np.any(self.mechanism.section["damping"]))
        return damped or self.motion.formulation == "penalty-velocity"

    @property
    def extrapolates(self) -> bool:
        """Whether steps with dampers may be weighted covers: if the method conserves.

        Ledger and momenta are put back as those of the whole, so not with separate islands.
        """
        whole = self.mechanism.model.sizes["n_islands"] == 1
        return whole and self.motion.formulation in ("conserving-al", "conserving-al-beta")

    @property
    def limited(self) -> bool:
        """Whether steps with dampers are of order 2 whatever is asked.

        What differences tell is lost on loads that read the mechanism, whose order is less.
        """
        chosen_by_sensors = self.mechanism.model.sizes["sensing"] and self.head["order"] == 0.0
        return self.estimate.damped and (not self.extrapolates or bool(chosen_by_sensors))

    @property
    def tolerated(self) -> float:
        """Error of a run that is asked for, relative to size and speed."""
        extent = float(self.mechanism.section["extent"][0])
        return self.head["tolerance"] + self.head["absolute_tolerance"] / extent

    def look(self) -> None:
        """Look at what the step to come is of."""
        self.estimate.unweighted, self.estimate.damped = False, self.dissipative

    def begin(self) -> None:
        """Choose order and length for a first step: a part of the time in which v changes.

        With dampers order 2 is the one for wide tolerances and strong dampers; its first pairs,
        which nothing judges yet, are shorter. From rest the motion tells no length, and order 4
        judges itself.
        """
        head, asked = self.head, self.head["order"]
        size, norm = float(self.mechanism.section["extent"][1]), self.estimate.norm
        rate = math.sqrt(norm(self.motion.a[0]) / size + (norm(self.motion.v) / size) ** 2)
        self.look()
        damped = self.estimate.damped
        if self.limited:
            head["order_in_use"] = 2.0
        elif asked > 0.0:
            head["order_in_use"] = asked
        elif head["order_in_use"] == 0.0:
            head["order_in_use"] = 2.0 if damped and rate > 0.0 else 4.0
        if head["wanted"] > 0.0:
            return
        part = head["tolerance"] ** (1.0 / (head["order_in_use"] + 1.0))
        part *= 0.25 if damped else 0.5
        head["wanted"] = part / rate if rate > 0.0 else math.inf

    def number_of_steps(self, time: float, wanted: float) -> float:
        """Return the number of equal steps, of about the length wanted, that cover a time."""
        longest = min(STRETCHED * wanted, self.head["longest_step"])
        return max(1.0, np.ceil(time / longest * (1.0 - 1e-10)))

    def rejects(self, error: StepError, h: float, step: float) -> bool:
        """Whether the last step, of length h, is to be repeated; choose for those to come."""
        order = 2 if self.estimate.unweighted else int(self.head["order_in_use"])
        added = error.mean * self.estimate.times_mean(order)
        share = added * self.head["horizon"] / (h * self.tolerated)
        if error.is_noise:
            share = min(share, SAFETY)
        change = (SAFETY / max(share, 1e-30)) ** (1.0 / order)
        self.head["wanted"] = h * min(max(change, SHRINKS), GROWS)
        if share > REJECTED:
            return True
        if self.head["order"] == 0.0 and not self.limited and error.rate > 0.0:
            self._choose_order(error.rate, step)
        return False

    def _length_for(self, order: int, rate: float) -> float:
        """Length of a step of an order that adds what it may where the motion changes at `rate`."""
        method = self.estimate.methods[order]
        mean = method.mean * self.estimate.times_mean(order) * rate * self.head["horizon"]
        return min((SAFETY * self.tolerated / mean) ** (1.0 / order), method.fastest) / rate

    def _choose_order(self, rate: float, step: float) -> None:
        """Choose the order with the least Newton iterations in a communication step."""
        present, least = int(self.head["order_in_use"]), math.inf
        best = present
        for order, method in self.estimate.methods.items():
            n = self.number_of_steps(step, self._length_for(order, rate))
            iterations = 2.0 + 4.0 * rate * step / n
            cost = method.pairs * n * iterations * (0.8 if order == present else 1.0)
            if cost < least:
                least, best = cost, order
        if best != present:
            self.head["order_in_use"] = float(best)
            self.head["wanted"] = self._length_for(best, rate)
