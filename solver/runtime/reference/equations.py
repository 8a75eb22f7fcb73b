"""The equations of one step, of García Orden & Ortega, with w = d - h v and mu as unknowns.

With d = q_n1 - q_n and v_n1 = 2 d/h - v_n the momentum balance is

    R = (2/h) M w + h [ G(q_mid)' mu - Q ] = 0,                                            (5, 15)

and in every formulation the total multiplier is

    mu = lam + alpha C,

    conserving-al, conserving-penalty    C = (Phi_n + Phi_n1)/2                            (15, 9)
    midpoint-al, midpoint-penalty        C = Phi(q_mid)                                    (5, 7)
    penalty-velocity                     C = Phi'' + 2 xi omega Phi' + omega^2 Phi at q_mid (3)

with lam = 0 in the penalty formulations. Rows are quadratic, so that beta = 1/2 in eq 8 and the
discrete gradient of Phi is G(q_mid).

Increments are the unknowns, never positions: Phi_n1 = Phi_n + G(q_mid) d holds exactly, and the
positions' rounding errors do not get multiplied by 1/h.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from .forces import step_force
from .mechanism import Mechanism
from .state import Motion

Array = NDArray[np.float64]


def penalties(mechanism: Mechanism, motion: Motion, h: float) -> Array:
    """Penalty alpha_i of each row, from the dimensionless penalty chi = alpha h^2 sigma/4.

    A penalty formulation stores the energy alpha Phi^2/2: its alpha must not follow h, and is that
    of the configured step. That of penalty-velocity has the dimension of a mass, chi/sigma.
    """
    chi, sigma = motion.head["penalty"], mechanism.sigma
    if motion.formulation == "penalty-velocity":
        return chi / sigma
    if motion.formulation.endswith("-penalty"):
        h = motion.head["step_size"] * (0.5 if motion.head["paired"] else 1.0)
    return 4.0 * chi / (h**2 * sigma)


class Equations:
    """Residual and tangent of a step of length h from the present state.

    Rows of a residual are C - (mu - lam)/alpha.
    """

    def __init__(self, mechanism: Mechanism, motion: Motion, h: float) -> None:
        self.mechanism, self.h = mechanism, h
        self.formulation = motion.formulation
        self.xi, self.omega = motion.head["xi"], motion.head["omega"]
        self.h_v = h * motion.v + h * motion.v_low
        self.phi_n = mechanism.phi(motion.q, motion.q_low)
        if not motion.is_telling(h) and self.formulation.endswith("-al"):
            self.phi_n[:] = 0.0
        self.G_n = mechanism.G(motion.q, motion.q_low)
        self.alpha = penalties(mechanism, motion, h)
        links = (*mechanism.lines, *mechanism.moment_links)
        self.u_n = {form: form.links(motion.q, motion.q_low)[0] for form in links}
        self.H = np.reshape(
            [row.H for row in mechanism.rows], (len(self.phi_n), mechanism.n, mechanism.n)
        )

    @property
    def augmented(self) -> bool:
        """Whether multipliers are updated (augmented Lagrangian) or stay zero (penalty)."""
        return self.formulation.endswith("-al")

    @property
    def conserving(self) -> bool:
        """Whether Phi is averaged over the ends of the step, not taken at its midpoint."""
        return self.formulation.startswith("conserving")

    def d(self, w: Array) -> Array:
        """Increment q_n1 - q_n."""
        return self.h_v + w

    def G_mid(self, w: Array) -> Array:  # noqa: N802
        """Jacobian G(q_mid), shape (r, n)."""
        return self.G_n + 0.5 * self.H @ self.d(w)

    def phi_n1(self, w: Array) -> Array:
        """Rows at the end of the step."""
        return self.phi_n + self.G_mid(w) @ self.d(w)

    def phi_mid(self, w: Array) -> Array:
        """Rows at the midpoint of the step."""
        half = 0.5 * self.d(w)
        return self.phi_n + (self.G_n + 0.5 * self.H @ half) @ half

    def C(self, w: Array) -> tuple[Array, Array]:  # noqa: N802
        """Measure C (r,) of the rows that makes the multipliers, and dC/dw (r, n)."""
        d, h, H, G_mid = self.d(w), self.h, self.H, self.G_mid(w)
        if self.conserving:
            return 0.5 * (self.phi_n + self.phi_n1(w)), 0.5 * (G_mid + 0.5 * H @ d)
        if self.formulation != "penalty-velocity":
            return self.phi_mid(w), 0.5 * G_mid
        a, v_mid = 2.0 * w / h**2, d / h
        phi_dot, phi_dot_w = G_mid @ v_mid, G_mid / h + 0.5 * H @ v_mid
        phi_dot2 = G_mid @ a + H @ v_mid @ v_mid
        phi_dot2_w = 2.0 * G_mid / h**2 + 0.5 * H @ a + 2.0 * H @ v_mid / h
        damping, stiffness = 2.0 * self.xi * self.omega, self.omega**2
        C = phi_dot2 + damping * phi_dot + stiffness * self.phi_mid(w)
        return C, phi_dot2_w + damping * phi_dot_w + 0.5 * stiffness * G_mid

    def momentum(self, w: Array, mu: Array) -> Array:
        """Residual R (n,) of the momentum balance [N s]."""
        Q, _ = step_force(self.mechanism, self.u_n, self.d(w), self.h)
        return 2.0 / self.h * self.mechanism.M @ w + self.h * (self.G_mid(w).T @ mu - Q)

    def residual(self, w: Array, mu: Array, lam: Array) -> Array:
        """Residual (n + r,) of momentum balance and rows."""
        C, _ = self.C(w)
        return np.concatenate([self.momentum(w, mu), C - (mu - lam) / self.alpha])

    def tangent(self, w: Array, mu: Array) -> Array:
        """Derivative (n + r, n + r) of the residual in (w, mu).

        Not symmetric: the force acts along G(q_mid), C_w belongs to the end of the step.
        """
        _, Q_d = step_force(self.mechanism, self.u_n, self.d(w), self.h)
        _, C_w = self.C(w)
        K = 0.5 * np.tensordot(mu, self.H, axes=1) - Q_d
        A = 2.0 / self.h * self.mechanism.M + self.h * K
        return np.block([[A, self.h * self.G_mid(w).T], [C_w, -np.diag(1.0 / self.alpha)]])
