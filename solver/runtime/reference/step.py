"""Solves one step: the nested Uzawa iteration of section 2.2 of the paper, or the simultaneous one.

Nested: Newton's iteration with lam held fixed, then lam is updated, until the rows hold.
Simultaneous: lam follows every Newton increment.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..errors import Status
from .equations import Equations
from .mechanism import DIRECTION, Mechanism
from .prediction import Prediction
from .state import Motion
from .unsolved import UnsolvedError

Array = NDArray[np.float64]

EPSILON = float(np.finfo(np.float64).eps)

HUGE = 1e300
"""No entry of a tangent that can be factorised is larger."""

LEAK = 1e-3
"""Part of the last multipliers that is forgotten: what dependent rows leave undetermined would grow
without bound; what is determined comes back in the first solve."""

FAR = 2.5
"""Largest turn of a body in a step [rad]."""

QUARTER_ULP = 5.6e-17
"""Of 1: no row is evaluated better."""

MARGIN = 1e-5
"""What is left when an iteration ends, over the tolerance: it adds up over steps in the energy."""


class Step:
    """One step of length h from the present state; `solve` leaves w, mu and `equations`."""

    def __init__(
        self,
        mechanism: Mechanism,
        motion: Motion,
        h: float,
        prediction: Prediction,
        signal_n1: Array | None = None,
    ) -> None:
        self.mechanism, self.motion, self.h = mechanism, motion, h
        self.head = motion.head
        self.equations = Equations(mechanism, motion, h, signal_n1)
        self.w = 0.5 * h**2 * prediction.acceleration()[: mechanism.n_free]
        leak = LEAK if motion.dependent else 0.0
        self.mu_held = (1.0 - leak) * motion.mu[prediction.parity]
        self.mu = self.mu_held.copy() if motion.dependent else prediction.multipliers()
        self.paper_update = bool(self.head["paper_update"])
        self.simultaneous = bool(self.head["simultaneous"])
        self.target = self.head["newton_tolerance"] * np.sqrt(
            mechanism.norm(self.equations.d(self.w)) ** 2
            + 2.0 * h**2 * self.head["energy_reference"]
        )
        self.floor = 32.0 * EPSILON * float(mechanism.section["extent"][1])

    @property
    def d(self) -> Array:
        """Increment q_n1 - q_n."""
        return self.equations.d(self.w)

    def first_multipliers(self) -> Array:
        """Multipliers lam to begin with: the last ones.

        They decide what dependent rows leave undetermined; predicted ones would amplify it.
        """
        equations = self.equations
        if not equations.augmented:
            return np.zeros_like(self.mu)
        if equations.conserving and not self.paper_update:
            return self.mu_held - 0.5 * equations.alpha * equations.phi_n
        return self.mu_held.copy()

    def updated(self, lam: Array) -> Array:
        """Uzawa update of lam.

        "paper" is eq 16, lam + alpha (Phi_n + Phi_n1)/2: its fixed point is Phi_n1 = -Phi_n. "end"
        is lam + alpha Phi_n1/2, with the fixed point Phi_n1 = 0. They agree if Phi_n = 0.
        """
        equations = self.equations
        if not equations.augmented:
            return lam
        if not equations.conserving:
            return lam + equations.alpha * equations.phi_mid(self.w)
        if self.paper_update:
            return lam + 0.5 * equations.alpha * (equations.phi_n + equations.phi_n1(self.w))
        return lam + 0.5 * equations.alpha * equations.phi_n1(self.w)

    def defect(self) -> float:
        """Largest |Phi| over the scale of the rows that the update drives to zero."""
        equations = self.equations
        if equations.conserving and not self.paper_update:
            phi = equations.phi_n1(self.w)
        else:
            phi, _ = equations.C(self.w)
        return float(np.max(np.abs(phi) / self.mechanism.row_scale, initial=0.0))

    def balanced(self) -> bool:
        """Whether the energy v_mid' R that the residual R would add is below the tolerance.

        Increments alone do not tell: they also become small where mu grows beyond all bounds.
        """
        added = self.d[: len(self.w)] @ self.equations.momentum(self.w, self.mu) / self.h
        energy = self.head["energy_reference"] + 0.5 * (self.mechanism.norm(self.d) / self.h) ** 2
        noise = 0.5 * (self.floor / self.h) ** 2  # kinetic energy of the round-off of positions
        return bool(abs(added) <= self.head["newton_tolerance"] * energy + noise)

    def newton_increment(self, lam: Array) -> float:
        """Add one Newton increment to w and mu; return its size in the mass norm."""
        residual = self.equations.residual(self.w, self.mu, lam)
        tangent = self.equations.tangent(self.w, self.mu)
        if not np.all(np.abs(tangent) < HUGE):
            raise UnsolvedError(Status.SINGULAR_TANGENT)
        try:
            increment: Array = np.linalg.solve(tangent, -residual).astype(np.float64)
        except np.linalg.LinAlgError:
            raise UnsolvedError(Status.SINGULAR_TANGENT) from None
        n = len(self.w)
        self.w, self.mu = self.w + increment[:n], self.mu + increment[n:]
        self.motion.count("newton_iterations")
        size = self.mechanism.norm(increment[:n])
        if not size < 1e150:
            raise UnsolvedError(Status.NOT_FINITE)
        return size

    def newton(self, lam: Array) -> Array:
        """Iterate until increments below the tolerance stop shrinking; return lam."""
        previous, tolerance, size = np.inf, self.head["newton_tolerance"], np.inf
        follows = self.simultaneous and self.equations.augmented
        for _ in range(int(self.head["max_newton"])):
            size = self.newton_increment(lam)
            stalled = size > 0.5 * previous and size <= max(self.target, self.floor)
            done, previous = stalled or size <= MARGIN * self.target, size
            if follows:
                lam = self.updated(lam)
                done = done and self.defect() <= (tolerance if stalled else MARGIN * tolerance)
            if done and self.balanced():
                return lam
        if not (size <= self.target and self.balanced()):
            raise UnsolvedError(Status.NEWTON_DIVERGED)
        if follows and not self.defect() <= tolerance:
            raise UnsolvedError(Status.UZAWA_DIVERGED)
        return lam

    def check_turns(self) -> None:
        """Refuse a step in which a direction is about to turn far.

        It would be solved by the shorter way round, with an exact ledger and the wrong motion.
        """
        is_direction = self.mechanism.node_kind[: self.mechanism.n_moving] == DIRECTION
        changes = self.equations.h_v.reshape(-1, self.mechanism.dim)[is_direction]
        if not np.all(np.linalg.norm(changes, axis=1) <= FAR):
            raise UnsolvedError(Status.TURN_TOO_LARGE)

    def solve(self) -> None:
        """Solve the step; raises `UnsolvedError`."""
        self.check_turns()
        lam = self.newton(self.first_multipliers())
        if not self.simultaneous and self.equations.augmented:
            self.motion.follow_contraction(self.uzawa(lam))

    def uzawa(self, lam: Array) -> int:
        """Update lam until the rows hold; return how many updates it took."""
        tolerance, last = self.head["newton_tolerance"], np.inf
        for updates in range(int(self.head["max_uzawa"])):
            defect = self.defect()
            if not defect < np.inf:
                raise UnsolvedError(Status.NOT_FINITE)
            if defect <= max(MARGIN * tolerance, QUARTER_ULP) or 0.5 * last < defect <= tolerance:
                return updates
            last = defect
            self.motion.count("uzawa_iterations")
            lam = self.newton(self.updated(lam))
        if not self.defect() <= tolerance:
            raise UnsolvedError(Status.UZAWA_DIVERGED)
        return int(self.head["max_uzawa"])
