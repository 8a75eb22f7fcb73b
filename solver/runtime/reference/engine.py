"""A model bound to the NumPy reference: start of a run, communication steps, measurements."""

from __future__ import annotations

import ctypes
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from ..errors import Status
from ..layout import HEAD, PLACE, state_size
from ..model import Model
from .advance import Advance, follow_angles, follow_bodies
from .clock import Clock
from .course import Present
from .energy import follow_energy_reference, start_ledger
from .equations import Equations, rows_at
from .measurement import Measurement
from .mechanism import Mechanism
from .projection import assemble_positions, assemble_velocities, find_equilibrium
from .ramps import start_ramps
from .start import derive_scales, first_multipliers, has_dependent_rows, row_rates
from .state import Motion
from .tape import run_tape
from .unsolved import UnsolvedError

Array = NDArray[np.float64]


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
        if not np.array_equal(vectors["parameters"], parameters):
            self._motion.start_anew()
        if self._have_jumped(vectors["inputs"], np.array(inputs)):
            self._motion.head["mean_time"] = np.inf
        for name, values in given.items():
            vectors[name][:] = values
        self._clock.set_laws(mechanism, t, booked=True)

    def _have_jumped(self, before: Array, inputs: Array) -> bool:
        """Whether an input that is held over a communication step differs."""
        held = ~np.array(self.model.tables["input_ramp"], dtype=bool)
        return not np.array_equal(before[held], inputs[held])

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
        motion.islands[:] = 0.0
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
        motion.dependent = has_dependent_rows(mechanism, motion)
        for half in (0, 1):
            motion.mu[half][:], motion.a[half][:] = lam, a
            motion.driven_force[half][:] = driven_force
        for name, values in (("mean", lam), ("driven_mean", driven_force)):
            motion.vectors[name][:] = motion.vectors[f"{name}_before"][:] = values
        head["mean_time"] = head["mean_time_before"] = head["time"]
        motion.quaternion[:] = [1.0, 0.0, 0.0, 0.0]
        follow_angles(mechanism, motion)
        follow_bodies(self.model, motion)
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
        backup, start = motion.block.copy(), head["time"]
        for name in ("newton_iterations", "uzawa_iterations", "substeps"):
            head[name] = 0.0
        try:
            if self._have_jumped(motion.vectors["inputs_before"], motion.vectors["inputs"]):
                motion.forget_changes()
            start_ramps(mechanism, motion, self._clock, step)
            course = Advance(mechanism, motion, self._clock)
            course.cover(start, step)
        except UnsolvedError as failure:
            motion.block[:] = backup
            head["status"] = float(failure.status)
            return failure.status
        motion.vectors["inputs_before"][:] = motion.vectors["inputs"]
        head["time"], head["status"] = start + step, 0.0
        follow_energy_reference(mechanism, motion)
        return Status.OK

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
