"""Steps of order 4, 6 and 8 where dampers take energy out.

A composition goes back in time in between, where dampers would give energy. Here a step is covered
by 1, 2, ... pairs of half steps, all forwards. Their ends have errors in even powers of the pairs'
length, which weights cancel (Richardson). Each pair conserves, weighted ends do so up to the order:
they are put back onto the constraints, onto the momenta that every pair kept, and onto the energy
that the weighted ledger asks for.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from ..errors import Status
from .clock import Clock
from .control import Control
from .course import Present
from .energy import kinetic_energy, momentum, potential_change
from .equations import rows_at
from .mechanism import POINT, Mechanism
from .start import constrained, row_rates, rows_of
from .state import Motion, add
from .unsolved import UnsolvedError

Array = NDArray[np.float64]

SURE = 1e-2
"""Largest change by the weights relative to size and speed: beyond, errors have no powers yet."""

KEPT = 1e-12
"""Relative change of a momentum that is round-off."""

GENTLE = 0.1
"""Largest part by which velocities are changed for the energy."""

ACCOUNTS = ("work", "dissipated", "defect", "residual")
KEEPS = ("q", "q_low", "v", "v_low", "turns", "direction", "signal", "quaternion")
"""What a cover begins with; what predicts half steps goes on from cover to cover."""


def weights(first: int, last: int) -> list[float]:
    """Weights of the ends after 1, 2, ... `last` pairs: errors in even powers of lengths cancel.

    Of `first` pairs and more alone; those before have none.
    """
    used = range(first, last + 1)
    return [0.0] * (first - 1) + [
        math.prod(j * j / (j * j - k * k) for k in used if k != j) for j in used
    ]


def is_extrapolating(motion: Motion, control: Control) -> bool:
    """Whether steps are of these."""
    return motion.head["order_in_use"] > 2.0 and control.extrapolates and control.dissipative


def rigid_velocities(mechanism: Mechanism, motion: Motion) -> Array:
    """Velocities (dim + turning, n) of the mechanism moving as one rigid body.

    Along each axis, which moves points alone, and about each axis at the origin.
    """
    dim, x = mechanism.dim, motion.q.reshape(-1, mechanism.dim)
    is_point = (mechanism.node_kind[: mechanism.n_moving] == POINT).astype(float)
    along = [np.outer(is_point, axis).ravel() for axis in np.eye(dim)]
    if dim == 2:
        return np.array([*along, np.column_stack([-x[:, 1], x[:, 0]]).ravel()])
    return np.array([*along, *(np.cross(axis, x).ravel() for axis in np.eye(3))])


class Extrapolation:
    """One internal step of length h from t; `motion` is modified by the covers and at the end."""

    def __init__(self, mechanism: Mechanism, motion: Motion, clock: Clock, t: float, h: float):
        self.mechanism, self.motion, self.clock, self.t, self.h = mechanism, motion, clock, t, h
        self.start = {name: motion.vectors[name].copy() for name in KEEPS}
        self.accounts = {
            name: motion.head[name] for part in ACCOUNTS for name in (part, f"{part}_low")
        }
        self.before, self.scale = self._momenta()
        self.kept = np.full(len(self.before), mechanism.n == mechanism.n_free)
        self.momentum = self.before.copy()
        self.dq, self.dv = np.zeros(mechanism.n), np.zeros(mechanism.n)
        self.from_less = np.zeros((2, mechanism.n))
        """Difference in q and v of the weighted end from that of one order less."""
        self.from_finest = np.zeros((2, mechanism.n))
        """And from the end of the finest cover."""
        self.booked = dict.fromkeys(("work", "dissipated"), 0.0)

    def _momenta(self) -> tuple[Array, Array]:
        """Momenta as in `rigid_velocities`, and the sums of their terms' sizes."""
        terms = rigid_velocities(self.mechanism, self.motion)
        terms = terms * momentum(self.mechanism, self.motion).ravel()
        return terms.sum(axis=1), np.abs(terms).sum(axis=1)

    def go_back(self) -> None:
        """Return to where the step began, for its next cover."""
        for name, values in self.start.items():
            self.motion.vectors[name][:] = values
        for name, value in self.accounts.items():
            self.motion.head[name] = value

    def weigh(self, weight: float, less: float) -> None:
        """Add the end of a cover, `weight` times, to what the step does.

        Without the coarsest cover, which leaves one order less, its weight is `less`.
        """
        dq, dv = self._moved()
        self.from_less += (weight - less) * np.array([dq, dv])
        self.dq += weight * dq
        self.dv += weight * dv
        for name in self.booked:
            change = self.motion.head[name] - self.accounts[name]
            low = self.motion.head[f"{name}_low"] - self.accounts[f"{name}_low"]
            self.booked[name] += weight * (change + low)
        total, size = self._momenta()
        self.momentum += weight * (total - self.before)
        self.kept &= np.abs(total - self.before) <= KEPT * np.maximum(size, self.scale)

    def _moved(self) -> tuple[Array, Array]:
        """Changes of q and v since the start of the step."""
        motion, start = self.motion, self.start
        dq = (motion.q - start["q"]) + (motion.q_low - start["q_low"])
        return dq, (motion.v - start["v"]) + (motion.v_low - start["v_low"])

    def take_over(self, size: Callable[[Array, Array], float]) -> None:
        """Take the weighted end over; `size` is that of changes of q and v.

        Raises
        ------
        UnsolvedError
            Where it cannot be put back; the motion is then to be restored.
        """
        motion = self.motion
        dq, dv = self._moved()
        dq, dv = self.from_finest[:] = self.dq - dq, self.dv - dv
        round_off = 1e-15 * motion.head["energy_reference"]  # weights take differences of losses
        if not self.booked["dissipated"] >= -round_off:
            raise UnsolvedError(Status.DAMPING_REVERSED)
        self.booked["dissipated"] = max(self.booked["dissipated"], 0.0)
        if not size(dq, dv) <= SURE:
            raise UnsolvedError(Status.NOT_FINITE)
        add(motion.q, motion.q_low, dq)
        add(motion.v, motion.v_low, dv)
        for name, amount in self.booked.items():
            motion.head[name] = self.accounts[name]
            motion.head[f"{name}_low"] = self.accounts[f"{name}_low"]
            motion.book(name, amount)
        self.G, _, _ = rows_of(self.mechanism, motion)
        """Gradients of the rows for all corrections, which are small."""
        self._close_rows()
        self._follow_rows()
        rigid = self._kept_motions()
        total, _ = self._momenta()
        add(motion.v, motion.v_low, self._rigid(rigid, self.momentum - total))
        if len(
            motion.signal
        ):  # drivers leave little or nothing free; their work is known to the order
            motion.book("work", self._excess())
        else:
            self._balance_energy(self._free_velocities(rigid))

    # ------------------------------------------------------------------------------- put back

    def _add_free(self, high: Array, low: Array, x: Array) -> None:
        change = np.zeros(self.mechanism.n)
        change[: len(x)] = x
        add(high, low, change)

    def _smallest(self, g: Array) -> Array:
        """Smallest x in the mass metric with G x = -g, shape (n_free,)."""
        mechanism, free = self.mechanism, slice(self.mechanism.n_free)
        nothing = np.zeros(mechanism.n_free)
        return constrained(mechanism, mechanism.M[free, free], self.G[:, free], nothing, -g)[0]

    def _close_rows(self) -> None:
        """Put coordinates back onto the rows, by displacements as small as can be."""
        mechanism, motion, last = self.mechanism, self.motion, np.inf
        tolerance = motion.head["newton_tolerance"]
        for _ in range(8):
            phi = rows_at(mechanism, motion, Present(mechanism, motion))
            defect = float(np.max(np.abs(phi) / mechanism.row_scale, initial=0.0))
            if defect < 1e-17 or (defect <= tolerance and not defect < 0.5 * last):
                return
            last = defect
            self._add_free(motion.q, motion.q_low, self._smallest(phi))
        if not last <= tolerance:
            raise UnsolvedError(Status.UZAWA_DIVERGED)

    def _follow_rows(self) -> None:
        """Let velocities follow rows and signals, by the smallest change."""
        mechanism, motion = self.mechanism, self.motion
        signal_rates = self.clock.signal_rates(self.t + self.h)
        for _ in range(3):
            rates = row_rates(mechanism, motion, signal_rates)
            self._add_free(motion.v, motion.v_low, self._smallest(rates))

    def _kept_motions(self) -> Array:
        """Kept rigid motions that are independent, orthonormal in the mass metric; shape (k, n)."""
        M, basis = self.mechanism.M, list[Array]()
        rigid = rigid_velocities(self.mechanism, self.motion)
        for xi, kept in zip(rigid, self.kept, strict=True):
            rest = xi - sum(((b @ M @ xi) * b for b in basis), np.zeros_like(xi))
            square = rest @ M @ rest
            if kept and square > 1e-10 * (xi @ M @ xi):
                basis.append(rest / math.sqrt(square))
        return np.array(basis).reshape(-1, self.mechanism.n)

    def _rigid(self, basis: Array, momenta: Array) -> Array:
        """Rigid motion (n,) of kept momenta, as far as they are independent."""
        rigid = rigid_velocities(self.mechanism, self.motion)
        K = rigid @ self.mechanism.M @ basis.T
        c, *_ = np.linalg.lstsq(K[self.kept], momenta[self.kept], rcond=1e-10)
        return c @ basis

    def _free_velocities(self, basis: Array) -> Array:
        """Velocities' part (n,) that rows leave free, without the kept momenta."""
        mechanism, motion, free = self.mechanism, self.motion, slice(self.mechanism.n_free)
        G, _, _ = rows_of(mechanism, motion)
        u = np.zeros(mechanism.n)
        u[free] = (motion.v + motion.v_low)[free]
        u[free] += self._smallest(G @ u)
        return u - (basis @ mechanism.M @ u) @ basis

    def _excess(self) -> float:
        """Energy that the ledger does not know of."""
        mechanism, motion, head = self.mechanism, self.motion, self.motion.head
        kinetic = kinetic_energy(mechanism, motion) - head["kinetic_start"]
        spent = head["work"] - head["dissipated"]
        return (kinetic + potential_change(mechanism, motion)) - spent

    def _balance_energy(self, u: Array) -> None:
        """Bring the energy onto the ledger by a change of the velocities along u.

        u' M u s^2/2 + v' M u s + excess = 0
        """
        mechanism, motion = self.mechanism, self.motion
        square = u @ mechanism.M @ u
        for _ in range(3):
            excess = self._excess()
            if excess == 0.0:
                return
            along = u @ mechanism.M @ (motion.v + motion.v_low)
            root = np.sqrt(along**2 - 2.0 * square * excess)
            part = -2.0 * excess / (along + math.copysign(root, along))
            if not abs(part) <= GENTLE:
                raise UnsolvedError(Status.NOT_FINITE)
            add(motion.v, motion.v_low, part * u)
