"""Advances by pairs of half steps, each a conserving step, and halves those that fail."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from ..errors import Status
from ..model import Model
from .bodies import directors, quaternion
from .clock import Clock
from .composition import stages
from .control import Control
from .course import ANGLE, Present, crossings
from .energy import book_step, follow_energy_reference
from .extrapolation import Extrapolation, is_extrapolating, weights
from .mechanism import Mechanism
from .prediction import Prediction
from .state import Motion, add
from .step import Step
from .unsolved import UnsolvedError

Array = NDArray[np.float64]

MOST_STEPS = 1e6
MAX_HALVINGS, MAX_REPEATS = 6, 40

COSTS = ("newton_iterations", "uzawa_iterations")
LEARNED = tuple(f"{what}_{order}" for what in ("judged", "learned") for order in (4, 6, 8))
"""Scalars of the head that survive a step that is taken back."""


def follow_angles(mechanism: Mechanism, motion: Motion) -> None:
    """Count the turns of angles since their directions were last looked at."""
    s = Present(mechanism, motion).s
    for index, (kind, forms) in enumerate(mechanism.quantities):
        if kind == ANGLE:
            motion.turns[index] += crossings(*motion.direction[index], *s[forms])
            motion.direction[index] = s[forms]


def follow_bodies(model: Model, motion: Motion) -> None:
    """Let the quaternions follow the directors."""
    for near, node in zip(motion.quaternion, model.tables["body_node"], strict=True):
        near[:] = quaternion(directors(motion.q, node).T, near)


class Advance:
    """Moves a mechanism; `motion` is modified, and so are the numbers of the `clock`."""

    def __init__(self, mechanism: Mechanism, motion: Motion, clock: Clock) -> None:
        self.mechanism, self.motion, self.clock = mechanism, motion, clock
        self.control = Control(mechanism, motion)

    def cover(self, start: float, step: float) -> None:
        """Cover a communication step by internal ones."""
        self.clock.set_laws(self.mechanism, start)
        if self.motion.head["tolerance"] > 0.0:
            self._cover_to_tolerance(start, step)
        else:
            self._cover_evenly(start, step)
        if self.clock.model.sizes["time_dependent"]:
            self.clock.set_laws(self.mechanism, start + step, booked=True)
        if not math.isfinite(self.motion.head["work"]):
            raise UnsolvedError(Status.BAD_LAW)

    def _cover_evenly(self, start: float, step: float) -> None:
        """Take equal steps of at most the option step_size, of the order asked for."""
        head = self.motion.head
        n = math.ceil(step / head["step_size"] * (1.0 - 1e-10))  # robust against the last digit
        if not n < 1e9:
            raise UnsolvedError(Status.BAD_STEP)
        n = max(1, n)
        head["order_in_use"] = max(head["order"], 2.0)
        if self.control.dissipative and not is_extrapolating(self.motion, self.control):
            head["order_in_use"] = 2.0
        self.control.estimate.unweighted = False
        for i in range(n):
            self._interval(start + step / n * i, step / n, 0)
        if self.control.estimate.unweighted:
            head["order_in_use"] = 2.0

    def _cover_to_tolerance(self, start: float, step: float) -> None:
        """Take steps that the control chooses; the end is met exactly."""
        head, control, done, repeats = self.motion.head, self.control, 0.0, 0
        control.begin()
        while done < step:
            rest = step - done
            # A pair is judged by the one before it: after a jump two are needed.
            least = 2.0 if head["order_in_use"] == 2.0 and head["known"] < 2.0 else 1.0
            n = max(least, control.number_of_steps(rest, head["wanted"]))
            if not n < MOST_STEPS:
                raise UnsolvedError(Status.STEP_COLLAPSED)
            h = rest / n
            backup, numbers = self.motion.block.copy(), self.clock.numbers.copy()
            solved = True
            control.look()
            try:
                self._internal_step(start + done, h)
                repeated = self._rejects(start + done, h, step, (backup, numbers))
                wanted = head["wanted"]
            except UnsolvedError:
                if repeats >= MAX_REPEATS:
                    raise
                solved, repeated, wanted = False, True, 0.5 * h
            if repeated and repeats < MAX_REPEATS:
                repeats += 1
                self._undo(backup, numbers)
                head["wanted"] = wanted
                if not solved:
                    self.motion.lower_penalty()
                if not solved and Prediction(self.motion, int(head["halves"])).reach:
                    self.motion.forget_changes()
                    head["wanted"] = h
                continue
            repeats = 0
            done = step if n == 1.0 else done + h
            follow_energy_reference(self.mechanism, self.motion)
        if control.estimate.unweighted:
            head["order_in_use"] = 2.0

    def _rejects(self, t: float, h: float, step: float, before: tuple[Array, Array]) -> bool:
        """Judge the step of length h just taken from t; measure what some of them add."""
        estimate = self.control.estimate
        error = estimate.error(h)
        if error is None:
            return False
        checks = estimate.checks_before()
        measured = not error.is_noise and not self.clock.model.sizes["sensing"]
        if checks is not None and measured:
            estimate.learn(error, self._difference_from_halves(t, h, before), checks)
        return self.control.rejects(error, h, step)

    def _difference_from_halves(self, t: float, h: float, before: tuple[Array, Array]) -> float:
        """Difference of a step just taken from two of half the length; 0 if they fail."""
        head, estimate = self.motion.head, self.control.estimate
        after = self.motion.block.copy(), self.clock.numbers.copy()
        whole, spent = estimate.present(), {name: head[name] for name in COSTS}
        self.motion.block[:], self.clock.numbers[:] = before
        costs = {name: head[name] for name in COSTS}
        try:
            for start in (t, t + 0.5 * h):
                self._internal_step(start, 0.5 * h)
                if estimate.unweighted:
                    raise UnsolvedError(Status.NOT_FINITE)
            difference = estimate.distance(estimate.present() - whole)
        except UnsolvedError:
            difference = 0.0
        estimate.unweighted = False
        spent = {name: spent[name] + head[name] - costs[name] for name in COSTS}
        self.motion.block[:], self.clock.numbers[:] = after
        for name, count in spent.items():
            head[name] = count
        return difference

    def _undo(self, backup: Array, numbers: Array) -> None:
        """Take an internal step back; what it cost stays counted, what was learned known."""
        head = self.motion.head
        spent = {name: head[name] for name in (*COSTS, *LEARNED)}
        self.motion.block[:], self.clock.numbers[:] = backup, numbers
        for name, count in spent.items():
            head[name] = count

    def _interval(self, t: float, h: float, halvings: int) -> None:
        """Cover [t, t + h] by one internal step, or by two of half the length if it fails."""
        motion = self.motion
        backup, numbers = motion.block.copy(), self.clock.numbers.copy()
        try:
            self._internal_step(t, h)
        except UnsolvedError:
            self._undo(backup, numbers)
            motion.lower_penalty()
            if Prediction(motion, int(motion.head["halves"])).reach:  # lines miss what turns fast
                motion.forget_changes()
                self._interval(t, h, halvings)
                return
            if halvings == MAX_HALVINGS:
                raise
            self._interval(t, 0.5 * h, halvings + 1)
            self._interval(t + 0.5 * h, 0.5 * h, halvings + 1)

    def _internal_step(self, t: float, h: float) -> None:
        """Pairs of half steps, or one plain step, whose velocities are less smooth.

        The plain step reflects the velocity normal to the constraints; a pair reflects it twice.
        """
        head = self.motion.head
        order = int(head["order_in_use"])
        if not head["paired"] and order == 2 and not head["tolerance"] > 0.0:
            prediction = Prediction(self.motion, 2)
            prediction.half = int(head["parity"])
            self._single_step(t, h, prediction)
            self._average_multipliers(t, h)
            return
        if is_extrapolating(self.motion, self.control):
            self._extrapolated_step(t, h)
            return
        dissipated = head["dissipated"] - 1e-9 * head["energy_reference"]
        parts = stages(order)
        self.control.estimate.open(order)
        prediction = Prediction(self.motion, 2 * len(parts))
        for part in parts:
            half = 0.5 * h * part
            self._single_step(t, half, prediction)
            self._single_step(t + half, half, prediction)
            self._average_multipliers(t + half, half)
            self.control.estimate.gather()
            t += 2.0 * half
        if order != 2 and not head["dissipated"] >= dissipated:
            raise UnsolvedError(Status.DAMPING_REVERSED)

    def _extrapolated_step(self, t: float, h: float) -> None:
        """Weigh the ends of covers by 1, 2, ... pairs; where that fails the finest one stands."""
        mechanism, motion, clock = self.mechanism, self.motion, self.clock
        covers, numbers = int(motion.head["order_in_use"]) // 2, clock.numbers.copy()
        step = Extrapolation(mechanism, motion, clock, t, h)
        prediction = Prediction(motion, covers * (covers + 1))
        ends = zip(weights(1, covers), weights(2, covers), strict=True)
        for pairs, (weight, less) in enumerate(ends, 1):
            if pairs > 1:
                step.go_back()
                clock.numbers[:] = numbers
            half = 0.5 * h / pairs
            for middle in (t + (2 * pair + 1) * half for pair in range(pairs)):
                self._single_step(middle - half, half, prediction)
                self._single_step(middle, half, prediction)
                self._average_multipliers(middle, half)
            if clock.model.sizes["time_dependent"]:  # ends are compared under the same laws
                clock.set_laws(mechanism, t + h, booked=True)
            step.weigh(weight, less)
        finest = motion.block.copy()
        try:
            step.take_over(self.control.estimate.size)
        except UnsolvedError:
            motion.block[:] = finest
            self.control.estimate.take_covers(step.from_finest, weighted=False)
            return
        self.control.estimate.take_covers(step.from_less, weighted=True)
        follow_angles(mechanism, motion)
        follow_bodies(clock.model, motion)

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
        w = step.equations.w_moving(step.w)
        add(motion.q, motion.q_low, step.d)
        add(motion.v, motion.v_low, 2.0 * w / h)  # 2/h, rounded, would bias the energy
        motion.signal[:] = step.equations.signal_n1
        follow_angles(mechanism, motion)
        follow_bodies(self.clock.model, motion)
        if motion.is_telling(h):
            prediction.remember(2.0 / h**2 * w, step.mu)
            motion.driven_force[half][:] = balance[mechanism.n_free :] / h
        head["parity"] = 1.0 - half
        prediction.half += 1
        motion.count("substeps")
