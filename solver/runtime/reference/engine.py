"""A model bound to the NumPy reference: start of a run, communication steps, measurements."""

from __future__ import annotations

import ctypes
import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from ..errors import Status
from ..layout import HEAD, PLACE, state_size
from ..model import Model
from .bodies import directors, quaternion
from .clock import Clock
from .composition import stages
from .course import ANGLE, Present, crossings
from .energy import book_step, follow_energy_reference, start_ledger
from .equations import Equations, rows_at
from .measurement import Measurement
from .mechanism import Mechanism
from .projection import assemble_positions, assemble_velocities, find_equilibrium
from .ramps import start_ramps
from .start import derive_scales, first_multipliers, has_dependent_rows, row_rates
from .state import Motion, add
from .step import Step
from .tape import run_tape
from .unsolved import UnsolvedError

Array = NDArray[np.float64]

MAX_HALVINGS = 6


def _quiet(method):  # type: ignore[no-untyped-def]
    return np.errstate(all="ignore")(method)


class Reference:
    """A model with its numbers and state, with the interface of ``solver.runtime.kernel.Kernel``.

    `numbers`, `state` and `work` are ctypes arrays of doubles. Nothing but the first two is kept
    from one call to the next; `work` is not used.
    """

    name = "numpy"

    def __init__(self, model: Model) -> None:
        self.model = model
        self.numbers = (ctypes.c_double * max(len(model.numbers), 1))(*model.numbers)
        self.state = (ctypes.c_double * state_size(model.sizes))()
        self.work = (ctypes.c_double * 1)()
        self._numbers = np.asarray(memoryview(self.numbers).cast("B").cast("d"))
        self._motion = Motion(model, self.state)
        self._clock = Clock(model, self._numbers, self._motion)

    def _mechanism(self) -> Mechanism:
        mechanism = Mechanism(self.model, self._numbers)
        mechanism.derived[:] = self._motion.vectors["derived"]
        return mechanism

    # ------------------------------------------------------------------------------- numbers

    @_quiet
    def evaluate(self, segment: int) -> None:
        """Run one segment of the tape on the numbers."""
        run_tape(self.model, self._numbers, segment)

    @_quiet
    def set_inputs(self, inputs: Sequence[float], parameters: Sequence[float]) -> None:
        """Change inputs and tunable parameters; a jump of stored energy is booked as work."""
        mechanism, t = self._mechanism(), self._motion.head["time"]
        self._clock.set_laws(mechanism, t)
        given = {"inputs": inputs, "parameters": parameters}
        vectors = self._motion.vectors
        held = ~np.array(self.model.tables["input_ramp"], dtype=bool)
        changed = not np.array_equal(vectors["parameters"], parameters)
        changed |= not np.array_equal(vectors["inputs"][held], np.array(inputs)[held])
        for name, values in given.items():
            vectors[name][:] = values
        self._clock.set_laws(mechanism, t, booked=True)
        if changed:  # no line is drawn through means of multipliers from before and after a jump
            self._motion.head["mean_time"] = math.inf

    # ------------------------------------------------------------------------------- start

    @_quiet
    def initialise(self) -> int:
        """Take the initial configuration into the state; return a status."""
        try:
            self._initialise()
        except UnsolvedError as failure:
            return failure.status
        return Status.OK

    def _initialise(self) -> None:
        mechanism, motion, head = self._mechanism(), self._motion, self._motion.head
        for name in HEAD[PLACE["kinetic_start"] : PLACE["formulation"]]:
            head[name] = 0.0
        signal_rates = self._take_initial(mechanism)
        self._clock.set_laws(mechanism, head["time"])
        derive_scales(mechanism, motion)
        motion.vectors["derived"][:] = mechanism.derived
        if not np.all(np.isfinite(self._numbers[: self.model.offsets["measured"]])):
            raise UnsolvedError(Status.NOT_FINITE)
        if head["assemble"]:
            assemble_positions(mechanism, motion)
        if head["assemble"] or len(signal_rates):  # what is not given follows the drivers
            assemble_velocities(mechanism, motion, signal_rates)
        if head["equilibrium"]:
            find_equilibrium(mechanism, motion)
            if len(signal_rates):
                assemble_velocities(mechanism, motion, signal_rates, keep_given=False)
        lam, a, driven_force = first_multipliers(mechanism, motion, self._clock)
        head["dependent"] = float(has_dependent_rows(mechanism, motion))
        for half in (0, 1):
            motion.mu[half][:], motion.a[half][:] = lam, a
            motion.driven_force[half][:] = driven_force
        for name, values in (("mean", lam), ("driven_mean", driven_force)):
            motion.vectors[name][:] = motion.vectors[f"{name}_before"][:] = values
        head["mean_time"] = head["mean_time_before"] = head["time"]
        motion.quaternion[:] = [1.0, 0.0, 0.0, 0.0]
        self._follow_bodies()
        start_ledger(mechanism, motion)
        if not np.all(np.isfinite(motion.block)):
            raise UnsolvedError(Status.NOT_FINITE)

    def _take_initial(self, mechanism: Mechanism) -> Array:
        """Take positions, velocities and signals into the state; return the signals' rates."""
        motion, t = self._motion, self._motion.head["time"]
        for name, vector in motion.vectors.items():
            if name not in ("inputs", "parameters"):
                vector[:] = 0.0
        motion.q[:] = mechanism.section["initial_position"]
        motion.v[:] = mechanism.section["initial_velocity"]
        motion.vectors["inputs_before"][:] = motion.vectors["inputs"]
        motion.signal[:] = self._clock.signals(t)
        rates = self._clock.signal_rates(t)
        driven = slice(mechanism.n_free, None)
        motion.q[driven] = motion.signal[: len(motion.q[driven])]
        motion.v[driven] = rates[: len(motion.v[driven])]
        return rates

    # ------------------------------------------------------------------------------- motion

    @_quiet
    def advance(self, step: float) -> int:
        """Advance the state by `step` [s] in equal internal steps; return a status."""
        mechanism, motion, head = self._mechanism(), self._motion, self._motion.head
        if not 0.0 < step < 1e300:
            return Status.BAD_STEP
        count = np.ceil(step / head["step_size"] * (1.0 - 1e-10))  # robust against the last digit
        if not count < 1e9:
            return Status.BAD_STEP
        backup, start = motion.block.copy(), head["time"]
        for name in ("newton_iterations", "uzawa_iterations", "substeps"):
            head[name] = 0.0
        try:
            start_ramps(mechanism, motion, self._clock, step)
            self._cover(mechanism, start, step, max(1, int(count)))
        except UnsolvedError as failure:
            motion.block[:] = backup
            head["status"] = float(failure.status)
            return failure.status
        motion.vectors["inputs_before"][:] = motion.vectors["inputs"]
        head["time"], head["status"] = start + step, 0.0
        follow_energy_reference(mechanism, motion)
        return Status.OK

    def _cover(self, mechanism: Mechanism, start: float, step: float, n: int) -> None:
        """Cover a communication step by n internal ones."""
        h = step / n
        self._clock.set_laws(mechanism, start)
        for i in range(n):
            self._interval(mechanism, start + h * i, h, 0)
        if self.model.sizes["time_dependent"]:
            self._clock.set_laws(mechanism, start + step, booked=True)
        if not math.isfinite(self._motion.head["work"]):
            raise UnsolvedError(Status.BAD_LAW)

    def _interval(self, mechanism: Mechanism, t: float, h: float, halvings: int) -> None:
        """Cover [t, t + h] by one internal step, or by two of half the length if it fails."""
        motion = self._motion
        backup, numbers = motion.block.copy(), self._numbers.copy()
        try:
            self._internal_step(mechanism, t, h)
        except UnsolvedError:
            motion.block[:], self._numbers[:] = backup, numbers
            motion.head["penalty_level"] = motion.head["slow_steps"] = 0.0
            if halvings == MAX_HALVINGS:
                raise
            self._interval(mechanism, t, 0.5 * h, halvings + 1)
            self._interval(mechanism, t + 0.5 * h, 0.5 * h, halvings + 1)

    def _internal_step(self, mechanism: Mechanism, t: float, h: float) -> None:
        """Pairs of half steps, or one plain step, whose velocities are less smooth.

        The plain step reflects the velocity normal to the constraints; a pair reflects it twice.
        """
        head = self._motion.head
        if not head["paired"] and head["order"] == 2.0:
            self._single_step(mechanism, t, h, int(head["parity"]))
            self._average_multipliers(t, h)
            return
        dissipated = head["dissipated"] - 1e-9 * head["energy_reference"]
        for part in stages(int(head["order"])):
            half = 0.5 * h * part
            self._single_step(mechanism, t, half, 0)
            self._single_step(mechanism, t + half, half, 1)
            self._average_multipliers(t + half, half)
            t += 2.0 * half
        if head["order"] != 2.0 and not head["dissipated"] >= dissipated:
            raise UnsolvedError(Status.DAMPING_REVERSED)

    def _average_multipliers(self, time: float, h: float) -> None:
        """Keep the means of the last two multipliers and forces, of the time between them."""
        vectors, head, motion = self._motion.vectors, self._motion.head, self._motion
        if not motion.is_telling(h):
            return
        for name, (first, second) in (("mean", motion.mu), ("driven_mean", motion.driven_force)):
            vectors[f"{name}_before"][:] = vectors[name]
            vectors[name][:] = 0.5 * (first + second)
        head["mean_time_before"], head["mean_time"] = head["mean_time"], time

    def _single_step(self, mechanism: Mechanism, t: float, h: float, half: int) -> None:
        """Solve one step, laws at its middle and signals at its end, and take it over."""
        motion, head = self._motion, self._motion.head
        if self._clock.follows:
            self._clock.set_laws_of_step(mechanism, t, h, half)
        step = Step(mechanism, motion, h, half, self._clock.signals(t + h))
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
        self._follow_bodies()
        if motion.is_telling(h):
            motion.a[half][:], motion.mu[half][:] = 2.0 / h**2 * w, step.mu
            motion.driven_force[half][:] = balance[mechanism.n_free :] / h
        head["parity"] = 1.0 - half
        motion.count("substeps")

    def _follow_bodies(self) -> None:
        """Let the quaternions follow the directors."""
        motion = self._motion
        for near, node in zip(motion.quaternion, self.model.tables["body_node"], strict=True):
            near[:] = quaternion(directors(motion.q, node).T, near)

    # ------------------------------------------------------------------------------- looks

    @_quiet
    def measure(self) -> None:
        """Fill the measurements in the numbers from the state and run their tape."""
        mechanism, motion, t = self._mechanism(), self._motion, self._motion.head["time"]
        self._clock.set_laws(mechanism, t)
        mechanism.section["signal"][:] = motion.signal
        measurement = Measurement(mechanism, motion, self._clock.signal_rates(t))
        measurement.write(self.model, mechanism.section["measured"])
        run_tape(self.model, self._numbers, "outputs")

    @_quiet
    def residuals(self) -> tuple[list[float], list[float]]:
        """Return Phi and dPhi/dt of each row; of velocity rows 0 and Psi."""
        mechanism, motion = self._mechanism(), self._motion
        phi = rows_at(mechanism, motion, Present(mechanism, motion))
        rates = row_rates(mechanism, motion, self._clock.signal_rates(motion.head["time"]))
        return phi.tolist(), rates.tolist()

    @_quiet
    def probe(
        self, h: float, w: Sequence[float], mu: Sequence[float], x: Sequence[float]
    ) -> tuple[int, list[float], list[float]]:
        """Return status, residual and tangent times `x` of one step.

        As in the kernel, rows of conserving formulations are Phi_n1 - (2/alpha) mu here, which is
        eq 15 with lam = -alpha Phi_n/2, and those of the others C - mu/alpha.
        """
        signal_n1 = self._clock.signals(self._motion.head["time"] + h)
        equations = Equations(self._mechanism(), self._motion, h, signal_n1)
        unknown_w, unknown_mu = np.array(w), np.array(mu)
        scale, lam = 1.0, np.zeros(len(mu))
        if equations.conserving:
            scale, lam = 2.0, -0.5 * equations.alpha * equations.phi_n
        try:
            residual = equations.residual(unknown_w, unknown_mu, lam)
            product = equations.tangent(unknown_w, unknown_mu) @ np.array(x)
        except UnsolvedError as failure:
            return failure.status, [], []
        residual[len(w) :] *= scale
        product[len(w) :] *= scale
        return Status.OK, residual.tolist(), product.tolist()
