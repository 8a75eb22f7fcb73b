"""What a step adds to the error of a run.

The difference from an embedded solution of order r, e ~ (omega h)^(r+1), tells how fast the motion
changes, and with it the error of the step's own order p, (omega h)^(p+1) times a mean over
mechanisms. How far a mechanism is from the mean is learned by repeating a few steps as two of half
the length. With dampers, the embedded solution is that of all covers but the coarsest.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .composition import embedded
from .mechanism import Mechanism
from .state import Motion

Array = NDArray[np.float64]

LEAST, MOST = 0.25, 100.0
"""Times the mean, that an error is taken for; of weighted covers, on which strong dampers show, up
to MOST squared."""

CHECKED, REGULARLY = (2.0, 8.0, 32.0, 128.0), 256.0
"""Steps of an order whose error is measured: these, and one in so many."""


@dataclass(frozen=True, slots=True)
class Method:
    """What the difference says at an order: means over mechanisms.

    Attributes
    ----------
    pairs : int
        Of half steps in a step.
    lower : float
        r.
    rate : float
        omega h over e^(1/(r + 1)).
    mean : float
        Error over (omega h)^(p + 1).
    remains : float
        What is left in a run of the errors of single steps, which partly cancel.
    round_off : float
        Of the difference: the norm of the weights times that of a solved step.
    fastest : float
        Largest omega h at which Newton's iteration still converges well.
    """

    pairs: int
    lower: float
    rate: float
    mean: float
    remains: float
    round_off: float
    fastest: float


METHODS = {
    2: Method(1, 2.0, 1.0, 1.1e-2, 1.0, 1e-13, 1.0),
    4: Method(5, 3.0, 2.7, 6e-5, 0.24, 1e-13, 1.5),
    6: Method(9, 4.0, 2.9, 5.2e-6, 0.5, 1e-13, 2.0),
    8: Method(15, 6.0, 2.64, 3.1e-7, 0.45, 1e-12, 2.5),
}
"""Compositions."""

WEIGHTED = {
    2: METHODS[2],
    4: Method(3, 2.0, 4.9, 1.2e-3, 0.5, 1e-13, 1.0),
    6: Method(6, 4.0, 5.9, 3e-5, 0.5, 1e-13, 1.5),
    8: Method(10, 6.0, 6.2, 7e-7, 0.5, 1e-12, 2.0),
}
"""Weighted covers, with dampers."""


@dataclass(frozen=True, slots=True)
class StepError:
    """Error of a step in the mean over mechanisms, `mean`, at its `rate` omega [1/s].

    `is_noise` where round-off of velocities is all that the difference shows.
    """

    rate: float
    mean: float
    is_noise: bool


class Estimate:
    """Judges steps; what it learns is in the head of `motion`."""

    def __init__(self, mechanism: Mechanism, motion: Motion) -> None:
        self.mechanism, self.motion, self.head = mechanism, motion, motion.head
        self.free = slice(mechanism.n_free)
        self._weights: tuple[float, ...] = ()
        self._outputs: list[Array] = []
        self._of_covers: Array | None = None
        self.damped = False
        """Whether something takes energy out of the step at hand."""
        self.unweighted = False
        """Whether a step with dampers was left of order 2."""

    @property
    def methods(self) -> dict[int, Method]:
        """What steps may be of, by order."""
        return WEIGHTED if self.damped else METHODS

    # --------------------------------------------------------------------------- difference

    def open(self, order: int) -> None:
        """Begin an internal step of an order."""
        self._weights = embedded(order) if order > 2 and self.head["tolerance"] > 0.0 else ()
        self._outputs = [self.present()]
        self._of_covers = None

    def take_covers(self, difference: Array, *, weighted: bool) -> None:
        """Take the difference (2, n) in q and v from weights of one order less.

        Where the weighted end was not taken, from the end of the finest cover, which was.
        """
        self._of_covers = difference
        self.unweighted |= not weighted

    def gather(self) -> None:
        """Keep the output after a stage."""
        if self._weights:
            self._outputs.append(self.present())

    def present(self) -> Array:
        """Coordinates and velocities with what rounding left over, shape (4, n, dim)."""
        motion = self.motion
        return np.array([motion.q, motion.q_low, motion.v, motion.v_low])

    def size(self, of_q: Array, of_v: Array) -> float:
        """Size of changes of q and v, shape (n, dim), relative to the mechanism and its speed."""
        return self._relative_size(self.norm(of_q), self.norm(of_v))

    def distance(self, difference: Array) -> float:
        """Size of a difference between outputs."""
        return self.size(difference[0] + difference[1], difference[2] + difference[3])

    def _relative_size(self, of_q: float, of_v: float) -> float:
        """Mass norms of differences in q and v relative to size and speed of the mechanism."""
        part = of_v / self._speed if self._speed > 0.0 else 0.0
        return math.hypot(of_q / self.mechanism.section["extent"][1], part)

    @property
    def _speed(self) -> float:
        """Speed in the mass norm; 0 only as long as nothing has moved or could."""
        return max(math.sqrt(2.0 * self.head["energy_reference"]), self.norm(self.motion.v))

    def norm(self, x: Array) -> float:
        """Mass norm of coordinates or velocities of the free nodes."""
        return self.mechanism.norm(x[self.free])

    def _difference(self) -> float:
        if self._of_covers is not None:
            return self.size(*self._of_covers)
        start = self._outputs[0]
        found = np.zeros_like(start)
        for weight, output in zip(self._weights, self._outputs, strict=True):
            found += weight * (output - start)
        return self.distance(found)

    def _difference_of_pairs(self, h: float) -> float | None:
        """From the rate of change of the mean acceleration of pairs; a pair has no stages."""
        between = 0.5 * (h + self.head["last_length"])
        self.head["last_length"] = h
        if self.head["known"] < 4.0:
            return None
        (first, second), change = self.motion.a, self.motion.a_change
        rate = (0.5 * (second - first) + change[0] + 0.5 * change[3]) / between
        of_rate, speed = self.norm(rate), self.norm(self.motion.v)
        omega = math.sqrt(of_rate / speed) if speed > 0.0 else 0.0
        return h**3 * self._relative_size(of_rate, omega * of_rate)

    def error(self, h: float) -> StepError | None:
        """Error of the last step, of length h; None where nothing tells it yet."""
        order = int(self.head["order_in_use"])
        difference = self._difference() if order > 2 else self._difference_of_pairs(h)
        if difference is None:
            return None
        method = self.methods[order]
        turned = method.rate * difference ** (1.0 / (method.lower + 1.0))
        extent = float(self.mechanism.section["extent"][1])
        noise = method.round_off * (1.0 + extent / (h * max(self._speed, 1e-300)))
        is_noise = difference <= noise
        if self.unweighted:  # the end that was not taken tells the error of the one that was
            return StepError(0.0, difference, is_noise)
        return StepError(turned / h, method.mean * turned ** (order + 1), is_noise)

    # ----------------------------------------------------------------------------- learning

    def times_mean(self, order: int) -> float:
        """How many times larger than in the mean the mechanism's errors are at an order."""
        return math.exp(self.head[f"learned_{order}"]) if order > 2 else 1.0

    def checks_before(self) -> int | None:
        """Count the step just judged; return how many before it were measured, if it is to be."""
        order = int(self.head["order_in_use"])
        if order == 2 or self.unweighted:
            return None
        judged = self.head[f"judged_{order}"] = self.head[f"judged_{order}"] + 1.0
        if judged in CHECKED:
            return CHECKED.index(judged)
        return len(CHECKED) if judged % REGULARLY == 0.0 else None

    def learn(self, error: StepError, measured: float, checks: int) -> None:
        """Learn from the measured error of a step how far the mechanism is from the mean."""
        order = int(self.head["order_in_use"])
        if not measured > 0.0:
            return
        times = self.methods[order].remains * measured / error.mean
        found = math.log(min(max(times, LEAST), MOST**2 if self.damped else MOST))
        learned = self.head[f"learned_{order}"]
        # The mean over mechanisms counts as a check.
        self.head[f"learned_{order}"] = learned + (found - learned) / (checks + 2.0)
