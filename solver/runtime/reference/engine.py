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
from .energy import (
    Measurement,
    book_step,
    crossings,
    follow_energy_reference,
    kinetic_energy,
    penalty_energy,
    spring_energy,
)
from .equations import Equations
from .forces import UnsolvedError
from .mechanism import Mechanism
from .start import derive_scales, first_multipliers
from .state import Motion, add
from .step import Step
from .tape import run_tape

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
        self._lawful = bool(model.sizes["n_tape_laws"])

    def _mechanism(self) -> Mechanism:
        return Mechanism(self.model, self._numbers)

    # ------------------------------------------------------------------------------- numbers

    @_quiet
    def evaluate(self, segment: int) -> None:
        """Run one segment of the tape on the numbers."""
        run_tape(self.model, self._numbers, segment)

    def _load_inputs(self) -> None:
        """Copy inputs and parameters of the state to where the tape reads them."""
        for name in ("input", "parameter"):
            start, values = self.model.offsets[name], self._motion.vectors[f"{name}s"]
            self._numbers[start : start + len(values)] = values

    def _set_laws(self, mechanism: Mechanism, t: float, *, booked: bool) -> None:
        """Run the tape of the laws at time t; a jump of the springs' energy is booked as work."""
        if not self._lawful:
            return
        before = spring_energy(mechanism, self._motion)
        self._numbers[self.model.offsets["time"]] = t
        run_tape(self.model, self._numbers, 1)
        if booked and self.model.sizes["variable_potential"]:
            self._motion.book("work", spring_energy(mechanism, self._motion) - before)

    @_quiet
    def set_inputs(self, inputs: Sequence[float], parameters: Sequence[float]) -> None:
        """Change inputs and tunable parameters; a jump of stored energy is booked as work."""
        mechanism, t = self._mechanism(), self._motion.head["time"]
        self._load_inputs()
        self._set_laws(mechanism, t, booked=False)
        given = {"inputs": inputs, "parameters": parameters}
        vectors = self._motion.vectors
        changed = any(not np.array_equal(vectors[name], given[name]) for name in given)
        for name, values in given.items():
            vectors[name][:] = values
        self._load_inputs()
        self._set_laws(mechanism, t, booked=True)
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
        for vector in (motion.q_low, motion.v_low, motion.turns):
            vector[:] = 0.0
        motion.q[:] = mechanism.section["initial_position"]
        motion.v[:] = mechanism.section["initial_velocity"]
        self._load_inputs()
        self._set_laws(mechanism, head["time"], booked=False)
        derive_scales(mechanism, motion)
        if not np.all(np.isfinite(self._numbers[: self.model.offsets["measured"]])):
            raise UnsolvedError(Status.NOT_FINITE)
        lam, a = first_multipliers(mechanism, motion)
        for half in (0, 1):
            motion.mu[half][:], motion.a[half][:] = lam, a
        motion.vectors["mean"][:] = motion.vectors["mean_before"][:] = lam
        head["mean_time"] = head["mean_time_before"] = head["time"]
        kinetic = kinetic_energy(mechanism, motion)
        weight = mechanism.m_node * np.tile(mechanism.gravity, mechanism.n_free)
        head["kinetic_start"] = kinetic
        head["stored_start"] = spring_energy(mechanism, motion) + penalty_energy(mechanism, motion)
        head["potential_start"] = head["stored_start"] - float(weight @ motion.q)
        # A floor, so that a mechanism at rest has a finite relative error.
        mass = float(np.sum(mechanism.section["node_mass"]))
        weight_times_size = mass * math.hypot(*mechanism.gravity) * mechanism.section["extent"][0]
        floor = 1e-3 * (weight_times_size + head["stored_start"])
        head["energy_reference"] = max(kinetic, floor)
        if not np.all(np.isfinite(motion.block)):
            raise UnsolvedError(Status.NOT_FINITE)

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
        backup = motion.block.copy()
        for name in ("newton_iterations", "uzawa_iterations", "substeps"):
            head[name] = 0.0
        n, start = max(1, int(count)), head["time"]
        h = step / n
        self._load_inputs()
        self._set_laws(mechanism, start, booked=False)
        try:
            for i in range(n):
                self._interval(mechanism, start + h * i, h, 0)
            if self.model.sizes["time_dependent"]:
                self._set_laws(mechanism, start + step, booked=True)
            if not math.isfinite(head["work"]):
                raise UnsolvedError(Status.BAD_LAW)
        except UnsolvedError as failure:
            motion.block[:] = backup
            head["status"] = float(failure.status)
            return failure.status
        head["time"], head["status"] = start + step, 0.0
        follow_energy_reference(mechanism, motion)
        return Status.OK

    def _interval(self, mechanism: Mechanism, t: float, h: float, halvings: int) -> None:
        """Cover [t, t + h] by one internal step, or by two of half the length if it fails."""
        motion = self._motion
        backup, numbers = motion.block.copy(), self._numbers.copy()
        try:
            self._internal_step(mechanism, t, h)
        except UnsolvedError:
            motion.block[:], self._numbers[:] = backup, numbers
            if halvings == MAX_HALVINGS:
                raise
            self._interval(mechanism, t, 0.5 * h, halvings + 1)
            self._interval(mechanism, t + 0.5 * h, 0.5 * h, halvings + 1)

    def _internal_step(self, mechanism: Mechanism, t: float, h: float) -> None:
        """One step, or the pair of half steps in its place, whose velocities are smooth.

        The plain step reflects the velocity normal to the constraints; a pair reflects it twice.
        """
        if self._motion.head["paired"]:
            self._single_step(mechanism, t, 0.5 * h, 0)
            self._single_step(mechanism, t + 0.5 * h, 0.5 * h, 1)
            self._average_multipliers(t + 0.5 * h, 0.5 * h)
        else:
            self._single_step(mechanism, t, h, int(self._motion.head["parity"]))
            self._average_multipliers(t, h)

    def _average_multipliers(self, time: float, h: float) -> None:
        """Keep the mean of the last two multipliers, which belongs to the time between them."""
        vectors, head = self._motion.vectors, self._motion.head
        if not self._motion.is_telling(h):
            return
        vectors["mean_before"][:] = vectors["mean"]
        vectors["mean"][:] = 0.5 * (self._motion.mu[0] + self._motion.mu[1])
        head["mean_time_before"], head["mean_time"] = head["mean_time"], time

    def _single_step(self, mechanism: Mechanism, t: float, h: float, half: int) -> None:
        """Solve one step with the laws at its midpoint and take it over into the state."""
        motion, head = self._motion, self._motion.head
        if self.model.sizes["time_dependent"]:
            self._set_laws(mechanism, t + 0.5 * h, booked=True)
        step = Step(mechanism, motion, h, half)
        step.solve()
        book_step(step)
        u_n = [form.links(motion.q, motion.q_low)[0] for form in mechanism.angle_links]
        add(motion.q, motion.q_low, step.d)
        add(motion.v, motion.v_low, 2.0 / h * step.w)
        u_n1 = [form.links(motion.q, motion.q_low)[0] for form in mechanism.angle_links]
        motion.turns[:] += [crossings(*links) for links in zip(u_n, u_n1, strict=True)]
        if motion.is_telling(h):
            motion.a[half][:], motion.mu[half][:] = 2.0 / h**2 * step.w, step.mu
        head["parity"] = 1.0 - half
        motion.count("substeps")

    # ------------------------------------------------------------------------------- looks

    @_quiet
    def measure(self) -> None:
        """Fill the measurements in the numbers from the state and run their tape."""
        mechanism, t = self._mechanism(), self._motion.head["time"]
        self._load_inputs()
        self._set_laws(mechanism, t, booked=False)
        self._numbers[self.model.offsets["time"]] = t
        Measurement(mechanism, self._motion).write(self.model, mechanism.section["measured"])
        run_tape(self.model, self._numbers, 2)

    def residuals(self) -> tuple[list[float], list[float]]:
        """Return Phi [m^2] and G v [m^2/s] of each row."""
        mechanism, motion = self._mechanism(), self._motion
        phi = mechanism.phi(motion.q, motion.q_low)
        return phi.tolist(), (mechanism.G(motion.q, motion.q_low) @ motion.v).tolist()

    @_quiet
    def probe(
        self, h: float, w: Sequence[float], mu: Sequence[float], x: Sequence[float]
    ) -> tuple[int, list[float], list[float]]:
        """Return status, residual and tangent times `x` of one step.

        As in the kernel, rows of conserving formulations are Phi_n1 - (2/alpha) mu here, which is
        eq 15 with lam = -alpha Phi_n/2, and those of the others C - mu/alpha.
        """
        mechanism = self._mechanism()
        equations, unknown_w, unknown_mu = (
            Equations(mechanism, self._motion, h),
            np.array(w),
            np.array(mu),
        )
        scale, lam = 1.0, np.zeros(len(mu))
        if equations.conserving:
            scale, lam = 2.0, -0.5 * equations.alpha * equations.phi_n
        try:
            residual = equations.residual(unknown_w, unknown_mu, lam)
            product = equations.tangent(unknown_w, unknown_mu) @ np.array(x)
        except UnsolvedError as failure:
            return failure.status, [], []
        residual[mechanism.n :] *= scale
        product[mechanism.n :] *= scale
        return Status.OK, residual.tolist(), product.tolist()
