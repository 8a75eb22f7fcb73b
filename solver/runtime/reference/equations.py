"""The equations of one step, of García Orden & Ortega, with w = d - h v and mu as unknowns.

With d = q_n1 - q_n and v_n1 = 2 d/h - v_n the momentum balance is

    R = (2/h) M w + h [ G_bar' mu - Q ] = 0,                                               (5, 15)

and in every formulation the total multiplier is

    mu = lam + alpha C,

    conserving-al, conserving-penalty    C = (Phi_n + Phi_n1)/2                            (15, 9)
    midpoint-al, midpoint-penalty        C = Phi(q_mid)                                    (5, 7)
    penalty-velocity                     C = Phi'' + 2 xi omega Phi' + omega^2 Phi at q_mid (3)

with lam = 0 in the penalty formulations. G_bar is the discrete gradient of ``rows``: that of
quadratic rows is G(q_mid). Nodes that are driven have d = b(t_n1) - q_n, and R there, over h, is
the force that moves them.

Increments are the unknowns, never positions: Phi_n1 = Phi_n + dPhi holds exactly, and the
positions' rounding errors do not get multiplied by 1/h.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from .course import Course, Present
from .forces import step_force
from .laws import over_step
from .mechanism import Mechanism
from .rows import BETA, CLOSED, Rows
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
    else:
        chi *= 100.0**motion.penalty_level
    return 4.0 * chi / (h**2 * sigma)


def rows_at(mechanism: Mechanism, motion: Motion, present: Present) -> Array:
    """Rows Phi (r,) at the present; velocity rows have none."""
    phi = np.zeros(mechanism.n_rows)
    _, _, functions, _ = mechanism.row_kinds
    phi[: functions.start] = mechanism.quadratic_phi(motion.q, motion.q_low)
    values = present.values()
    phi[functions] = [
        over_step(mechanism, function, values).value.n for function in mechanism.function_rows
    ]
    return phi


class Trial:
    """A step by one w: rows and forces over it."""

    def __init__(self, equations: Equations, w: Array) -> None:
        self.w = w
        mechanism, self.d = equations.mechanism, equations.d(w)
        self.course = Course(equations.present, self.d, equations.signal_n1, equations.h)
        self.rows = Rows(mechanism, self.course, BETA if equations.intermediate else CLOSED)
        self.Q, self.Q_d = step_force(mechanism, self.rows.view)


class Equations:
    """Residual and tangent of a step of length h from the present state to `signal_n1`.

    The unknown w covers the free coordinates. Rows of a residual are C - (mu - lam)/alpha.
    """

    def __init__(
        self, mechanism: Mechanism, motion: Motion, h: float, signal_n1: Array | None = None
    ) -> None:
        self.mechanism, self.h = mechanism, h
        self.formulation = motion.formulation
        self.xi, self.omega = motion.head["xi"], motion.head["omega"]
        self.signal_n1 = motion.signal.copy() if signal_n1 is None else signal_n1
        self.h_v = h * motion.v + h * motion.v_low
        free, driven = mechanism.n_free, mechanism.n - mechanism.n_free
        self.d_driven = (self.signal_n1[:driven] - motion.q[free:]) - motion.q_low[free:]
        self.present = Present(mechanism, motion)
        self.phi_n = rows_at(mechanism, motion, self.present)
        if not motion.is_telling(h) and self.augmented:
            self.phi_n[:] = 0.0
        self.alpha = penalties(mechanism, motion, h)
        self._trial: Trial | None = None

    @property
    def augmented(self) -> bool:
        """Whether multipliers are updated (augmented Lagrangian) or stay zero (penalty)."""
        return "-al" in self.formulation

    @property
    def conserving(self) -> bool:
        """Whether Phi is averaged over the ends of the step, not taken at its midpoint."""
        return self.formulation.startswith("conserving")

    @property
    def intermediate(self) -> bool:
        """Whether function rows act at the intermediate configuration of eq 8."""
        return self.formulation.endswith("-beta")

    def trial(self, w: Array) -> Trial:
        """Return the step by w, which is evaluated once."""
        if self._trial is None or not np.array_equal(self._trial.w, w):
            self._trial = Trial(self, w.copy())
        return self._trial

    def d(self, w: Array) -> Array:
        """Increment q_n1 - q_n of all moving nodes, shape (n,)."""
        return np.concatenate([self.h_v[: len(w)] + w, self.d_driven])

    def w_moving(self, w: Array) -> Array:
        """Difference d - h v of all moving nodes, shape (n,)."""
        return np.concatenate([w, self.d_driven - self.h_v[len(w) :]])

    def G_mid(self, w: Array) -> Array:  # noqa: N802
        """Discrete gradient of the rows: G(q_mid) for quadratic ones; shape (r, n)."""
        return self.trial(w).rows.G_bar

    def phi_n1(self, w: Array) -> Array:
        """Rows at the end of the step."""
        return self.phi_n + self.trial(w).rows.change

    def C(self, w: Array) -> tuple[Array, Array]:  # noqa: N802
        """Measure C (r,) of the rows that makes the multipliers, and dC/dw (r, n_free)."""
        rows = self.trial(w).rows
        if self.conserving:
            C, C_d = 0.5 * (self.phi_n + self.phi_n1(w)), 0.5 * rows.G_n1
        elif self.formulation != "penalty-velocity":
            C, C_d = self.phi_mid(w), 0.5 * rows.G_bar
        else:
            C, C_d = self._velocity_measure(w)
        return C, C_d[:, : len(w)]

    def phi_mid(self, w: Array) -> Array:
        """Quadratic rows at the midpoint of the step: (Phi_n + Phi_n1)/2 - d' H d/8."""
        return self.phi_n + 0.5 * self.trial(w).rows.change - 0.125 * self._bend(w)

    def _bend(self, w: Array) -> Array:
        """Second-order terms d' H d = 2 du . dw of quadratic rows."""
        course, bend = self.trial(w).course, np.zeros(self.mechanism.n_rows)
        form = self.mechanism.row_form
        bend[: len(form)] = 2.0 * np.sum(course.du[form] * course.dw[form], axis=1)
        return bend

    def _velocity_measure(self, w: Array) -> tuple[Array, Array]:
        """Measure of eq 3 and its derivative in d, for quadratic rows.

        Phi' = G_mid d/h, Phi'' = G_mid a + d' H d/h^2, a = 2 w/h^2. Half of H d leads from the
        gradient at the middle to that at the end.
        """
        mechanism, rows, h = self.mechanism, self.trial(w).rows, self.h
        G_mid, a = rows.G_bar, 2.0 * self.w_moving(w) / h**2
        H_d, H_a = 2.0 * (rows.G_n1 - G_mid), np.zeros_like(G_mid)
        forms = mechanism.forms
        bent = forms.gradients(forms.U @ a, forms.W @ a)
        H_a[: len(mechanism.row_form)] = bent[mechanism.row_form]
        damping, stiffness = 2.0 * self.xi * self.omega, self.omega**2
        C = G_mid @ a + self._bend(w) / h**2
        C_d = 2.0 * G_mid / h**2 + 0.5 * H_a + 2.0 * H_d / h**2
        C += damping * rows.change / h + stiffness * self.phi_mid(w)
        return C, C_d + damping * rows.G_n1 / h + 0.5 * stiffness * G_mid

    def balance(self, w: Array, mu: Array) -> Array:
        """Residual R (n,) of the momentum balance of all moving nodes [N s]."""
        trial, h = self.trial(w), self.h
        inertia = 2.0 / h * self.mechanism.M @ self.w_moving(w)
        return inertia + h * (trial.rows.G_bar.T @ mu - trial.Q)

    def momentum(self, w: Array, mu: Array) -> Array:
        """Residual R (n_free,) of the momentum balance that shall vanish [N s]."""
        return self.balance(w, mu)[: len(w)]

    def residual(self, w: Array, mu: Array, lam: Array) -> Array:
        """Residual (n_free + r,) of momentum balance and rows."""
        C, _ = self.C(w)
        return np.concatenate([self.momentum(w, mu), C - (mu - lam) / self.alpha])

    def tangent(self, w: Array, mu: Array) -> Array:
        """Derivative (n_free + r, n_free + r) of the residual in (w, mu).

        Not symmetric: the force acts along G_bar, C_w belongs to the end of the step.
        """
        trial, n = self.trial(w), len(w)
        _, C_w = self.C(w)
        K = (trial.rows.stiffness(mu) - trial.Q_d)[:n, :n]
        A = 2.0 / self.h * self.mechanism.M[:n, :n] + self.h * K
        G_bar = trial.rows.G_bar[:, :n]
        return np.block([[A, self.h * G_bar.T], [C_w, -np.diag(1.0 / self.alpha)]])
