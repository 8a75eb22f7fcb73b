"""What forms, quantities and functions do over a half step by d = q_n1 - q_n.

A quantity's change is a sum of slopes p times changes of its forms,

    form 1,    length 1/(l_n + l_n1),    angle g (-s_mid, c_mid), g = dtheta/(c_mid ds - s_mid dc),

and its discrete gradient sum p grad s(q_mid): exact for any step (theory 2.5). A function of
quantities adds slopes of its operations. d may be complex: its imaginary part is then a derivative.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from solver.runtime.layout import (
    LEAF_RATE,
    LEAF_SIGNAL,
    QUANTITY_ANGLE,
    QUANTITY_FORM,
    QUANTITY_LENGTH,
)
from tests.oracle.mechanism import Array, Mechanism
from tests.oracle.slopes import Change, angle_over, discrete_gradient, moving, still


@dataclass(frozen=True)
class View:
    """Slopes over a step and gradients at its middle, or, with ds = 0, derivatives at a place."""

    mechanism: Mechanism
    s_n: Array
    ds: Array
    sigma_n: Array
    signal_n: Array
    dsignal: Array
    gradients: Array
    h: float

    def quantity(self, index: int) -> tuple[Change, Array]:
        """Change of a quantity, and its discrete gradient (n,)."""
        kind, forms = self.mechanism.quantities[index]
        first, *more = (moving(self.s_n[f], self.ds[f]) for f in forms)
        if kind == QUANTITY_FORM:
            return first, self.gradients[forms[0]]
        if kind == QUANTITY_LENGTH:
            l_n, l_n1 = np.sqrt(first.n), np.sqrt(first.n1)
            slope = 1.0 / (l_n + l_n1)
            return Change(l_n, l_n1, slope * first.d), slope * self.gradients[forms[0]]
        (s,), c = more, first
        cross = c.mid * s.d - s.mid * c.d
        g = angle_over(cross, c.n * c.n1 + s.n * s.n1)
        change = moving(self.sigma_n[index], g * cross)
        return change, g * (c.mid * self.gradients[forms[1]] - s.mid * self.gradients[forms[0]])

    def _leaves(self, leaves) -> tuple[list[Change], list[Array]]:
        """Changes of the leaves of a function, and their discrete gradients."""
        nothing = np.zeros(self.gradients.shape[1])
        found = [
            (moving(self.signal_n[index], self.dsignal[index]), nothing)
            if kind == LEAF_SIGNAL
            else self.quantity(index)
            for kind, index in leaves
        ]
        return [change for change, _ in found], [gradient for _, gradient in found]

    def function(self, function) -> tuple[Change, Array, Array]:
        """Change of a function, its discrete gradient (n,), and its slopes by the signals."""
        leaves, operations = function
        changes, gradients = self._leaves(leaves)
        value, N = discrete_gradient(operations, self.mechanism.numbers, changes)
        signals = np.zeros(len(self.signal_n), dtype=N.dtype)
        for (kind, index), slope in zip(leaves, N, strict=True):
            if kind == LEAF_SIGNAL:
                signals[index] += slope
        return value, N @ np.array(gradients), signals

    def rolling(self, function) -> tuple[float, Array, float]:
        """C = h Psi(sigma_mid, dsigma/h) of a velocity row, its gradient, the signals' part."""
        leaves, operations = function
        changes, gradients = self._leaves(leaves)
        rates = np.array([kind == LEAF_RATE for kind, _ in leaves])
        means = [
            still(change.d / self.h if rate else change.mid)
            for change, rate in zip(changes, rates, strict=True)
        ]
        psi, c = discrete_gradient(operations, self.mechanism.numbers, means)
        by_rates = np.where(rates, c, 0.0)
        moved = sum(x * change.d for x, change in zip(by_rates, changes, strict=True))
        return self.h * psi.n, by_rates @ np.array(gradients), self.h * psi.n - moved


class Path:
    """A step by d from a mechanism's state, while the signals go to `signal_n1`."""

    def __init__(
        self, mechanism: Mechanism, d: Array | None = None, signal_n1=None, h: float = 1.0
    ) -> None:
        self.mechanism, self.h = mechanism, h
        self.d = np.zeros(mechanism.n) if d is None else d
        self.u, self.w = mechanism.links()
        self.du, self.dw = mechanism.U @ self.d, mechanism.W @ self.d
        self.s_n, self.sigma_n = np.sum(self.u * self.w, axis=1), mechanism.sigma()
        self.signal_n = mechanism.vectors["signal"]
        self.dsignal = 0.0 * self.signal_n if signal_n1 is None else signal_n1 - self.signal_n

    def over_step(self) -> View:
        """Slopes over the whole step and gradients at its middle: exact in energy."""
        u, w = self.u + 0.5 * self.du, self.w + 0.5 * self.dw
        ds = np.sum(u * self.dw + w * self.du, axis=1)
        return View(
            self.mechanism, self.s_n, ds, self.sigma_n, self.signal_n, self.dsignal,
            self.mechanism.gradients(u, w), self.h,
        )  # fmt: skip

    def at_end(self) -> View:
        """Derivatives at q_n + d."""
        u, w = self.u + self.du, self.w + self.dw
        s = np.sum(u * w, axis=1)
        sigma = self.sigma_n.astype(s.dtype)
        for index, (kind, f) in enumerate(self.mechanism.quantities):
            if kind == QUANTITY_ANGLE:  # on the turn of the angle at q_n
                (c_n, s_n), (c, t) = self.s_n[f], s[f]
                cross = c_n * t - s_n * c
                sigma[index] += cross * angle_over(cross, c_n * c + s_n * t) if cross else 0.0
        signal, gradients = self.signal_n + self.dsignal, self.mechanism.gradients(u, w)
        return View(
            self.mechanism, s, 0.0 * s, sigma, signal, 0.0 * signal, gradients, self.h
        )  # fmt: skip
