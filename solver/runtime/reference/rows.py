"""Constraint rows over a step: changes, discrete gradients, and derivatives of both.

Form rows and coincidences are quadratic or linear, so that their discrete gradient is the gradient
at the middle. Function rows have the closed form of ``laws``, or the gradient at the intermediate
configuration q_n + beta d of eq 8,

    grad Phi(q_n + beta d) . d = Phi_n1 - Phi_n.

Velocity rows are C = h Psi and act along dPsi/d rate.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from .course import Course, View
from .laws import Function, forms_of, over_step, rolling, tangent
from .mechanism import Mechanism

Array = NDArray[np.float64]

CLOSED, BETA, END = "closed", "beta", "end"
"""Where rows have their gradients: over the step, functions at q_n + beta d, all at the end."""

PARTS = 0.5 + np.arange(1, 17) / 32.0
"""Where a sign change is looked for beyond 1/2; by symmetry below it too."""


def excess(
    mechanism: Mechanism, function: Function, course: Course, part: float, change: float
) -> float:
    """Derivative of Phi(q_n + s d) with respect to s at `part`, signals included, less `change`."""
    view = course.at(part)
    slopes = over_step(mechanism, function, view.values)
    forms = slopes.g @ (view.gradients @ course.d)
    return float(forms + slopes.signals @ course.values.dsignal) - change


def intermediate(
    mechanism: Mechanism, function: Function, course: Course, change: float, scale: float
) -> float:
    """Part beta of eq 8 nearest 1/2; the mean value theorem says that there is one."""

    def off(part: float) -> float:
        return excess(mechanism, function, course, part, change)

    middle = off(0.5)
    if not abs(middle) > 1e-14 * scale:
        return 0.5
    low, off_low = {1: 0.5, -1: 0.5}, {1: middle, -1: middle}
    for part in PARTS:
        for side in (-1, 1):  # of two roots as near, that of the first half
            high = 0.5 + side * (part - 0.5)
            off_high = off(high)
            if off_low[side] * off_high <= 0.0:
                return _bisect(off, low[side], off_low[side], high)
            low[side], off_low[side] = high, off_high
    return 0.5  # rounding hides the root


def _bisect(off, low: float, off_low: float, high: float) -> float:  # type: ignore[no-untyped-def]
    """Root between two parts of opposite sign, to the last digit."""
    while low != (mid := 0.5 * (low + high)) != high:
        off_mid = off(mid)
        if off_low * off_mid <= 0.0:
            high = mid
        else:
            low, off_low = mid, off_mid
    return low


class Rows:
    """All rows over a step.

    Attributes
    ----------
    change : ndarray, shape (r,)
        Phi_n1 - Phi_n; of velocity rows, C.
    by_signals : ndarray, shape (r,)
        Part of it that the signals make.
    G_bar, G_n1 : ndarray, shape (r, n)
        Discrete gradients, and derivatives of `change` in d.
    """

    def __init__(self, mechanism: Mechanism, course: Course, scheme: str = CLOSED) -> None:
        self.mechanism, self.course = mechanism, course
        shape = (mechanism.n_rows, mechanism.n)
        self.change, self.by_signals = np.zeros(shape[0]), np.zeros(shape[0])
        self.G_bar, self.G_n1 = np.zeros(shape), np.zeros(shape)
        self.view = course.at(1.0) if scheme == END else course.over_step()
        forms, coincidences, functions, velocities = mechanism.row_kinds
        self.change[forms] = course.values.ds[mechanism.row_form]
        self.G_bar[forms] = self.view.gradients[mechanism.row_form]
        self.G_n1[forms] = course.over_step().reach[mechanism.row_form]
        self.G_bar[coincidences] = self.G_n1[coincidences] = mechanism.coincidences
        self.change[coincidences] = mechanism.coincidences @ course.d
        self.function_views = [
            self._function(row, function, scheme)
            for row, function in zip(_places(functions), mechanism.function_rows, strict=True)
        ]
        for row, function in zip(_places(velocities), mechanism.velocity_rows, strict=True):
            if scheme != END:  # a configuration alone has no rates
                self._velocity(row, function)

    def _function(self, row: int, function: Function, scheme: str) -> View:
        mechanism, course = self.mechanism, self.course
        step = over_step(mechanism, function, course.values)
        self.change[row] = step.value.d
        end = course.at(1.0)
        self.G_n1[row] = over_step(mechanism, function, end.values).g @ end.gradients
        view = self.view
        if scheme == BETA:
            scale = mechanism.row_scale[row]
            view = course.at(intermediate(mechanism, function, course, step.value.d, scale))
        slopes = over_step(mechanism, function, view.values)
        self.G_bar[row] = slopes.g @ view.gradients
        self.by_signals[row] = slopes.signals @ course.values.dsignal
        return view

    def _velocity(self, row: int, function: Function) -> None:
        mechanism, course, view = self.mechanism, self.course, self.view
        C, g = rolling(mechanism, function, view.values)
        self.change[row], self.by_signals[row] = C, C - g @ course.values.ds
        self.G_bar[row] = g @ view.gradients
        self.G_n1[row] = view.derivative(
            lambda values: np.asarray(rolling(mechanism, function, values)[0]),
            forms_of(mechanism, function[0]),
        )

    def stiffness(self, mu: Array) -> Array:
        """Derivative (n, n) of the force G_bar' mu in d."""
        mechanism, view = self.mechanism, self.view
        forms, _, functions, velocities = mechanism.row_kinds
        g = np.zeros(len(mechanism.forms.U))
        np.add.at(g, mechanism.row_form, mu[forms])
        K = view.part * mechanism.forms.curvature(g)
        rows = zip(mechanism.function_rows, self.function_views, mu[functions], strict=True)
        for function, where, factor in rows:
            K += factor * tangent(
                where,
                lambda values, function=function: over_step(mechanism, function, values).g,
                forms_of(mechanism, function[0]),
            )
        for function, factor in zip(mechanism.velocity_rows, mu[velocities], strict=True):
            if not view.is_point:
                K += factor * tangent(
                    view,
                    lambda values, function=function: rolling(mechanism, function, values)[1],
                    forms_of(mechanism, function[0]),
                )
        return K


def _places(rows: slice) -> range:
    return range(rows.start, rows.stop)
