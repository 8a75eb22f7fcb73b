"""Length and order of internal steps that a tolerance asks for.

The differences from two solutions of lower order r and l, e_high ~ (omega h)^(r+1) and
e_low ~ (omega h)^(l+1), tell the error of the step's own order p,
C e_high (e_high/e_low)^((p-r)/(r-l)), and the first how fast the motion changes. A step may add
tolerance h/horizon, so that a run over the horizon ends with an error of the tolerance.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .composition import embedded, stages
from .mechanism import Mechanism
from .state import Motion

Array = NDArray[np.float64]

SAFETY, REJECTED = 0.5, 2.0
"""Parts of what a step may add: what is aimed at, and what is not accepted."""

SHRINKS, GROWS = 0.2, 2.0


@dataclass(frozen=True, slots=True)
class Method:
    """What a difference says at an order, the mean over mechanisms.

    Attributes
    ----------
    pairs : int
        Of half steps in a step.
    high, gap : float
        r and r - l.
    rate : float
        omega h over e_high^(1/(r + 1)).
    error : float
        Error over e_high (e_high/e_low)^((p - r)/gap).
    predicted : float
        Error over (omega h)^(p + 1).
    fastest : float
        Largest omega h at which Newton's iteration still converges well.
    """

    pairs: int
    high: float
    gap: float
    rate: float
    error: float
    predicted: float
    fastest: float


METHODS = {
    2: Method(1, 2.0, 2.0, 1.0, 1.1e-2, 1.1e-2, 1.0),
    4: Method(5, 3.0, 1.0, 2.7, 2.5e-3, 5e-5, 1.5),
    6: Method(9, 4.0, 2.0, 2.9, 4e-3, 5e-6, 2.0),
    8: Method(15, 5.0, 2.0, 2.6, 5e-4, 1e-7, 2.5),
}


@dataclass(frozen=True, slots=True)
class StepError:
    """Error of a step: `share` over what it may add, `size` over the mean one at its `rate`."""

    rate: float
    size: float
    share: float


class Control:
    """Chooses; `motion` holds the choice, which is what survives a step."""

    def __init__(self, mechanism: Mechanism, motion: Motion) -> None:
        self.mechanism, self.motion, self.head = mechanism, motion, motion.head
        self.free = slice(mechanism.n_free)
        self._weights: tuple[tuple[float, ...], ...] = ()
        self._outputs: list[Array] = []

    @property
    def dissipative(self) -> bool:
        """Whether something takes energy out, which parts that go back in time would give."""
        damped = bool(np.any(self.mechanism.section["damping"]))
        return damped or self.motion.formulation == "penalty-velocity"

    @property
    def tolerated(self) -> float:
        """Error of a run that is asked for, relative to size and speed."""
        extent = float(self.mechanism.section["extent"][0])
        return self.head["tolerance"] + self.head["absolute_tolerance"] / extent

    # -------------------------------------------------------------------------- differences

    def open(self, order: int) -> None:
        """Begin an internal step of an order."""
        self._weights = embedded(order) if order > 2 and self.head["tolerance"] > 0.0 else ()
        self._outputs = [self._present()]

    def gather(self) -> None:
        """Keep the output after a stage."""
        if self._weights:
            self._outputs.append(self._present())

    def _present(self) -> Array:
        motion = self.motion
        return np.array([motion.q, motion.q_low, motion.v, motion.v_low])

    def _relative_size(self, of_q: float, of_v: float) -> float:
        """Mass norms of differences in q and v relative to size and speed of the mechanism."""
        part = of_v / self._speed if self._speed > 0.0 else 0.0
        return math.hypot(of_q / self.mechanism.section["extent"][1], part)

    def size(self, of_q: Array, of_v: Array) -> float:
        """Size of changes of q and v (n,), relative to that of the mechanism and its speed."""
        return self._relative_size(self._norm(of_q), self._norm(of_v))

    @property
    def _speed(self) -> float:
        """Speed in the mass norm; 0 only as long as nothing has moved or could."""
        return max(math.sqrt(2.0 * self.head["energy_reference"]), self._norm(self.motion.v))

    def _norm(self, x: Array) -> float:
        return self.mechanism.norm(x[self.free])

    def _differences(self) -> tuple[float, float]:
        start, found = self._outputs[0], []
        for weights in self._weights:
            q, v = np.zeros(len(start[0])), np.zeros(len(start[0]))
            for weight, output in zip(weights, self._outputs, strict=True):
                moved = output - start
                q += weight * (moved[0] + moved[1])
                v += weight * (moved[2] + moved[3])
            found.append(self._relative_size(self._norm(q), self._norm(v)))
        return found[0], found[1]

    def _differences_of_pairs(self, h: float) -> tuple[float, float] | None:
        """From the rate of change of the mean acceleration of pairs; a pair has no stages."""
        between = 0.5 * (h + self.head["last_length"])
        self.head["last_length"] = h
        if self.head["known"] < 4.0:
            return None
        (first, second), change = self.motion.a, self.motion.a_change
        rate = (0.5 * (second - first) + change[0] + 0.5 * change[3]) / between
        of_rate, speed = self._norm(rate), self._norm(self.motion.v)
        omega = math.sqrt(of_rate / speed) if speed > 0.0 else 0.0
        high = h**3 * self._relative_size(of_rate, omega * of_rate)
        return high, h * self._relative_size(speed, self._norm(second))

    def estimate(self, h: float) -> StepError | None:
        """Error of the last step, of length h; None where nothing tells it yet."""
        order = int(self.head["order_in_use"])
        found = self._differences() if order > 2 else self._differences_of_pairs(h)
        if found is None:
            return None
        method, (high, low) = METHODS[order], found
        ratio = min(high / low, 1e3) if low > 0.0 else 0.0
        error = method.error * high * ratio ** ((order - method.high) / method.gap)
        turned = method.rate * high ** (1.0 / (method.high + 1.0))
        share = error * self.head["horizon"] / (h * self.tolerated)
        # Velocities are only known to round-off of places over h.
        extent = float(self.mechanism.section["extent"][1])
        if high <= 1e-13 * (1.0 + extent / (h * max(self._speed, 1e-300))):
            share = min(share, SAFETY)
        return StepError(
            rate=turned / h,
            size=error / (method.predicted * turned ** (order + 1)) if turned > 0.0 else 0.0,
            share=share,
        )

    # ------------------------------------------------------------------------------- choice

    def begin(self) -> None:
        """Choose order and length for a first step: a part of the time in which v changes."""
        head, asked = self.head, self.head["order"]
        if self.dissipative:
            head["order_in_use"] = 2.0
        elif asked > 0.0:
            head["order_in_use"] = asked
        elif head["order_in_use"] == 0.0:
            head["order_in_use"] = 4.0
        if head["wanted"] > 0.0:
            return
        size = float(self.mechanism.section["extent"][1])
        rate = math.sqrt(
            self._norm(self.motion.a[0]) / size + (self._norm(self.motion.v) / size) ** 2
        )
        part = head["tolerance"] ** (1.0 / (head["order_in_use"] + 1.0))
        head["wanted"] = 0.5 / rate * part if rate > 0.0 else math.inf

    def rejects(self, h: float, step: float) -> bool:
        """Whether the last step, of length h, is to be repeated; choose for those to come."""
        error = self.estimate(h)
        if error is None:
            return False
        change = (SAFETY / max(error.share, 1e-30)) ** (1.0 / self.head["order_in_use"])
        self.head["wanted"] = h * min(max(change, SHRINKS), GROWS)
        if error.share > REJECTED:
            return True
        if self.head["order"] == 0.0 and not self.dissipative and error.size > 0.0:
            self._choose_order(error, step)
        return False

    def _length_for(self, order: int, error: StepError) -> float:
        """Length of a step of an order that adds what it may, at the rate and size of `error`."""
        method = METHODS[order]
        mean = method.predicted * error.size * error.rate * self.head["horizon"]
        turned = (SAFETY * self.tolerated / mean) ** (1.0 / order)
        return min(turned, method.fastest) / error.rate

    def _choose_order(self, error: StepError, step: float) -> None:
        """Choose the order with the least Newton iterations in a communication step."""
        present, least = int(self.head["order_in_use"]), math.inf
        best = present
        for order, method in METHODS.items():
            h = min(self._length_for(order, error), self.head["longest_step"])
            n = max(1.0, np.ceil(step / h * (1.0 - 1e-10)))
            iterations = 2.0 + 3.0 * error.rate * step / n
            cost = method.pairs * n * iterations * (0.8 if order == present else 1.0)
            if cost < least and 2 * len(stages(order)) <= len(self.motion.a_change):
                least, best = cost, order
        if best != present:
            self.head["order_in_use"] = float(best)
            self.head["wanted"] = self._length_for(best, error)
