"""One half step of García Orden & Ortega, with w = d - h v and mu as unknowns.

With d = q_n1 - q_n and v_n1 = 2 d/h - v_n the momentum balance is

    R = (2/h) M w + h [ G_bar' mu - Q ] = 0,                                                  (15)

with the total multiplier mu = lam + alpha (Phi_n + Phi_n1)/2, and lam is updated (Uzawa) until the
rows hold.
Driven nodes have d = b(t_n1) - q_n; R there, over h, is the force that moves them.
"""

from __future__ import annotations

import numpy as np

from tests.oracle.forces import applied, laws, stored_energy
from tests.oracle.mechanism import TINY, TURN, Array, Mechanism
from tests.oracle.path import Path

HALVES = ("first", "second")


class Residual:
    """Residual of momentum balance and rows of a half step of length h at time t."""

    def __init__(self, mechanism: Mechanism, h: float, t: float | None = None) -> None:
        self.mechanism, self.h = mechanism, h
        head = mechanism.head
        self.signal_n1 = mechanism.signals((head["time"] if t is None else t) + h)
        self.h_v = h * mechanism.vectors["v"] + h * mechanism.vectors["v_low"]
        n, driven = mechanism.n_free, mechanism.n - mechanism.n_free
        q, q_low = mechanism.vectors["q"], mechanism.vectors["q_low"]
        self.d_driven = (self.signal_n1[:driven] - q[n:]) - q_low[n:]
        self.on = mechanism.rows_on()
        self.phi_n = np.where(self.on, rows_now(mechanism) - mechanism.references(), 0.0)
        self.alpha = penalties(mechanism, h)

    def d(self, w: Array) -> Array:
        """Increment q_n1 - q_n of all moving nodes."""
        return np.concatenate([self.h_v[: len(w)] + w, self.d_driven])

    def path(self, w: Array) -> Path:
        """Half step by w."""
        return Path(self.mechanism, self.d(w), self.signal_n1, self.h)

    def rows(self, path: Path) -> tuple[Array, Array, Array]:
        """Changes Phi_n1 - Phi_n (r,) of the rows, G_bar (r, n), and the signals' parts (r,)."""
        mechanism, view = self.mechanism, path.over_step()
        forms, coincidences, functions, velocities = mechanism.row_kinds
        change = np.zeros(mechanism.n_rows, dtype=path.d.dtype)
        by_signals, G_bar = change.copy(), np.zeros((len(change), mechanism.n), path.d.dtype)
        change[forms] = view.ds[mechanism.row_form]
        G_bar[forms] = view.gradients[mechanism.row_form]
        G_bar[coincidences] = mechanism.U[mechanism.coincidence_form].reshape(-1, mechanism.n)
        change[coincidences] = G_bar[coincidences] @ path.d
        for row, function in enumerate(mechanism.function_rows, functions.start):
            value, G_bar[row], slopes = view.function(function)
            change[row] = value.d
            by_signals[row] = slopes @ path.dsignal
        for row, function in enumerate(mechanism.velocity_rows, velocities.start):
            change[row], G_bar[row], by_signals[row] = view.rolling(function)
        return change, G_bar, by_signals

    def balance(self, path: Path, G_bar: Array, mu: Array) -> Array:
        """Residual R (n,) of the momentum balance of all moving nodes [N s]."""
        mechanism, h = self.mechanism, self.h
        Q = mechanism.weight + applied(mechanism, path) + sum(laws(mechanism, path.over_step()))
        return 2.0 / h * mechanism.M @ (path.d - self.h_v) + h * (G_bar.T @ mu - Q)

    def residual(self, w: Array, mu: Array, lam: Array) -> Array:
        """Residual (n_free + r,) of momentum balance and rows, Phi_mean - (mu - lam)/alpha.

        Rows of open contacts have no multipliers, those of sliding frictions follow their cones.
        """
        path = self.path(w)
        change, G_bar, _ = self.rows(path)
        R = self.balance(path, G_bar, mu)[: len(w)]
        rows = self.phi_n + 0.5 * change - (mu - lam) / self.alpha
        if not np.all(self.on):
            cones = self.mechanism.sliding_multipliers(mu, change / self.h)
            rows = np.where(self.on, rows, (cones - mu) / self.alpha)
        return np.concatenate([R, rows])

    def tangent(self, w: Array, mu: Array, lam: Array) -> Array:
        """Derivative of the residual in (w, mu), by complex step in w."""
        change, G_bar, _ = self.rows(self.path(w))
        by_mu = np.vstack([self.h * G_bar[:, : len(w)].T, -np.diag(1.0 / self.alpha)])
        if not np.all(self.on):
            by_mu[len(w) :] += self.mechanism.cone_slopes(mu, change / self.h) / self.alpha[:, None]
        columns = [self.residual(w + 1j * TINY * e, mu, lam).imag / TINY for e in np.eye(len(w))]
        by_w = np.array(columns).reshape(len(w), -1).T
        return np.hstack([by_w, by_mu])

    def held(self, change: Array) -> Array:
        """Phi_n1, which an Uzawa update drives to zero (theory 3)."""
        return np.where(self.on, self.phi_n + change, 0.0)


def rows_now(mechanism: Mechanism) -> Array:
    """Rows Phi (r,) at the present; velocity rows have none."""
    phi, view = np.zeros(mechanism.n_rows), Path(mechanism).over_step()
    _, _, functions, _ = mechanism.row_kinds
    phi[: functions.start] = mechanism.exact_rows()
    phi[functions] = [view.function(f)[0].n for f in mechanism.function_rows]
    return phi


def penalties(mechanism: Mechanism, h: float) -> Array:
    """Penalty alpha of each row, from the dimensionless penalty chi = alpha h^2 sigma/4."""
    chi, sigma = mechanism.head["penalty"], mechanism.section["row_sigma"][: mechanism.n_rows]
    return 4.0 * chi / (h**2 * sigma)


class HalfStep:
    """The solved half step of length h from time t: w, mu, and `end`, the mechanism after it."""

    def __init__(
        self, mechanism: Mechanism, h: float, t: float | None = None, half: int = 0
    ) -> None:
        self.mechanism, self.h, self.half = mechanism, h, half
        t = mechanism.head["time"] if t is None else t
        stored = stored_energy(mechanism)
        mechanism.forces_at(t, h, half)
        self.work_of_laws = stored_energy(mechanism) - stored
        self.equations = Residual(mechanism, h, t)
        # A long step has several roots; the one meant is next to the last acceleration.
        a = mechanism.vectors[f"a_{HALVES[half]}"]
        self.w = 0.5 * h**2 * a[: mechanism.n_free]
        self.mu = self.mechanism.vectors[f"mu_{HALVES[half]}"].copy()
        self.tangent: Array | None = None
        self.uzawa()

    def uzawa(self) -> None:
        """Update lam until the rows hold to round-off, which then no longer shrinks."""
        equations, lam = self.equations, self.mu.copy()
        last, scale = np.inf, self.mechanism.section["row_scale"][: len(lam)]
        for _ in range(200):
            self.newton(lam)
            change, _, _ = equations.rows(equations.path(self.w))
            phi = equations.held(change)
            defect = np.max(np.abs(phi) / scale, initial=0.0)
            if defect < 1e-17 or 0.5 * last < defect < 1e-12:
                return
            # Eq 16 adds alpha (Phi_n + Phi_n1)/2, which is this where Phi_n = 0.
            lam, last = lam + 0.5 * equations.alpha * phi, defect
        message = f"Uzawa's iteration does not converge: {defect:.1e}"
        raise ArithmeticError(message)

    def newton(self, lam: Array) -> None:
        """Add increments to w and mu until they are round-off, and no longer shrink.

        A tangent, which takes as long as a residual for each unknown, is kept where they are small
        and shrink to a tenth.
        """
        last, n, norm = np.inf, len(self.w), np.sqrt(self.mechanism.m_node[: len(self.w)])
        for _ in range(60):
            residual = self.equations.residual(self.w, self.mu, lam)
            if self.tangent is None:
                self.tangent = self.equations.tangent(self.w, self.mu, lam)
            x = np.linalg.solve(self.tangent, -residual)
            self.w, self.mu = self.w + x[:n], self.mu + x[n:]
            size = np.linalg.norm(norm * x[:n])
            moved = np.linalg.norm(norm * self.equations.d(self.w)[:n])
            floor = 1e-10 * moved + 1e-13 * self.mechanism.section["extent"][1]
            if size <= 1e-9 * floor or 0.5 * last < size <= floor:
                return
            if size > min(0.1 * last, 1e-3 * moved):
                self.tangent = None
            last = size
        message = f"Newton's iteration does not converge: {size:.1e}"
        raise ArithmeticError(message)

    def end(self) -> Mechanism:
        """Mechanism after the half step, with work and dissipation booked."""
        mechanism, h, path = self.mechanism, self.h, self.equations.path(self.w)
        change, G_bar, by_signals = self.equations.rows(path)
        balance = self.equations.balance(path, G_bar, self.mu)
        _, damping, drives = laws(mechanism, path.over_step())
        n, d, w = mechanism.n_free, path.d, path.d - self.equations.h_v
        vectors, head = dict(mechanism.vectors), dict(mechanism.head)
        for name, x in (("q", d), ("v", 2.0 * w / h)):
            vectors[name], vectors[f"{name}_low"] = added(vectors[name], vectors[f"{name}_low"], x)
        here = HALVES[self.half]
        vectors[f"mu_{here}"], vectors[f"a_{here}"] = self.mu, 2.0 / h**2 * w
        vectors[f"driven_{here}"], vectors["signal"] = balance[n:] / h, self.equations.signal_n1
        head["work"] += float(self.work_of_laws + self.mu @ by_signals)
        head["work"] += float((applied(mechanism, path) + drives) @ d + d[n:] @ balance[n:] / h)
        head["dissipated"] -= float(damping @ d)
        head["friction"] += float(np.where(self.equations.on, 0.0, self.mu) @ change)
        after = Mechanism(mechanism.model, head, vectors)
        sigma = [path.over_step().quantity(i)[0].n1 for i in range(len(mechanism.quantities))]
        turned = np.round((np.array(sigma) - after.sigma()) / TURN)
        angles = np.array([kind == 2 for kind, _ in mechanism.quantities], dtype=bool)
        after.vectors["turns"] += np.where(angles, turned, 0.0)
        return after


def added(high: Array, low: Array, x: Array) -> tuple[Array, Array]:
    """Sum high + low + x, with what rounding leaves over (Knuth)."""
    y = x + low
    s = high + y
    t = s - high
    return s, (high - (s - t)) + (y - t)


def internal_step(mechanism: Mechanism, h: float) -> Mechanism:
    """Mechanism after a pair of half steps."""
    t = mechanism.head["time"]
    middle = HalfStep(mechanism, 0.5 * h, t, 0).end()
    return HalfStep(middle, 0.5 * h, t + 0.5 * h, 1).end()
