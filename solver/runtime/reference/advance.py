"""Advances by pairs of half steps, each a conserving step, and halves those that fail."""

from __future__ import annotations

import math

from ..errors import Status
from ..model import Model
from .bodies import directors, quaternion
from .clock import Clock
from .composition import stages
from .course import ANGLE, Present, crossings
from .energy import book_step
from .mechanism import Mechanism
from .prediction import Prediction
from .state import Motion, add
from .step import Step
from .unsolved import UnsolvedError

MAX_HALVINGS = 6


def follow_bodies(model: Model, motion: Motion) -> None:
    """Let the quaternions follow the directors."""
    for near, node in zip(motion.quaternion, model.tables["body_node"], strict=True):
        near[:] = quaternion(directors(motion.q, node).T, near)


class Advance:
    """Moves a mechanism; `motion` is modified, and so are the numbers of the `clock`."""

    def __init__(self, mechanism: Mechanism, motion: Motion, clock: Clock) -> None:
        self.mechanism, self.motion, self.clock = mechanism, motion, clock

    def cover(self, start: float, step: float, n: int) -> None:
        """Cover a communication step by n internal ones."""
        h = step / n
        self.clock.set_laws(self.mechanism, start)
        for i in range(n):
            self._interval(start + h * i, h, 0)
        if self.clock.model.sizes["time_dependent"]:
            self.clock.set_laws(self.mechanism, start + step, booked=True)
        if not math.isfinite(self.motion.head["work"]):
            raise UnsolvedError(Status.BAD_LAW)

    def _interval(self, t: float, h: float, halvings: int) -> None:
        """Cover [t, t + h] by one internal step, or by two of half the length if it fails."""
        motion = self.motion
        backup, numbers = motion.block.copy(), self.clock.numbers.copy()
        try:
            self._internal_step(t, h)
        except UnsolvedError:
            motion.block[:], self.clock.numbers[:] = backup, numbers
            motion.head["penalty_level"] = motion.head["slow_steps"] = 0.0
            if halvings == MAX_HALVINGS:
                raise
            self._interval(t, 0.5 * h, halvings + 1)
            self._interval(t + 0.5 * h, 0.5 * h, halvings + 1)

    def _internal_step(self, t: float, h: float) -> None:
        """Pairs of half steps, or one plain step, whose velocities are less smooth.

        The plain step reflects the velocity normal to the constraints; a pair reflects it twice.
        """
        head = self.motion.head
        if not head["paired"] and head["order"] == 2.0:
            prediction = Prediction(self.motion, 2)
            prediction.half = int(head["parity"])
            self._single_step(t, h, prediction)
            self._average_multipliers(t, h)
            return
        dissipated = head["dissipated"] - 1e-9 * head["energy_reference"]
        parts = stages(int(head["order"]))
        prediction = Prediction(self.motion, 2 * len(parts))
        for part in parts:
            half = 0.5 * h * part
            self._single_step(t, half, prediction)
            self._single_step(t + half, half, prediction)
            self._average_multipliers(t + half, half)
            t += 2.0 * half
        if head["order"] != 2.0 and not head["dissipated"] >= dissipated:
            raise UnsolvedError(Status.DAMPING_REVERSED)

    def _average_multipliers(self, time: float, h: float) -> None:
        """Keep the means of the last two multipliers and forces, of the time between them."""
        vectors, head, motion = self.motion.vectors, self.motion.head, self.motion
        if not motion.is_telling(h):
            return
        for name, (first, second) in (("mean", motion.mu), ("driven_mean", motion.driven_force)):
            vectors[f"{name}_before"][:] = vectors[name]
            vectors[name][:] = 0.5 * (first + second)
        head["mean_time_before"], head["mean_time"] = head["mean_time"], time

    def _single_step(self, t: float, h: float, prediction: Prediction) -> None:
        """Solve one step, laws at its middle and signals at its end, and take it over."""
        mechanism, motion = self.mechanism, self.motion
        head, half = motion.head, prediction.parity
        if self.clock.follows:
            self.clock.set_laws_of_step(self.mechanism, t, h, half)
        step = Step(mechanism, motion, h, prediction, self.clock.signals(t + h))
        step.solve()
        balance = book_step(step)
        s_n, w = Present(mechanism, motion).s, step.equations.w_moving(step.w)
        add(motion.q, motion.q_low, step.d)
        add(motion.v, motion.v_low, 2.0 / h * w)
        motion.signal[:] = step.equations.signal_n1
        s_n1 = Present(mechanism, motion).s
        for index, (kind, forms) in enumerate(mechanism.quantities):
            if kind == ANGLE:
                motion.turns[index] += crossings(*s_n[forms], *s_n1[forms])
        follow_bodies(self.clock.model, motion)
        if motion.is_telling(h):
            prediction.remember(2.0 / h**2 * w, step.mu)
            motion.driven_force[half][:] = balance[mechanism.n_free :] / h
        head["parity"] = 1.0 - half
        prediction.half += 1
        motion.count("substeps")
