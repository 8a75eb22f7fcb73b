"""What is made of quantities: springs and dampers, potentials, function rows and velocity rows.

Every law has slopes g with respect to the forms of the mechanism; its generalised force is

    sum_f g_f grad s_f,

with g from the discrete chain rule and the gradients at the middle of the step. For a function phi
this makes the work over a step exactly phi_n1 - phi_n, whatever the step (theory 2.5).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..errors import Status
from .course import LENGTH, RATE, SIGNAL, Values, View
from .mechanism import Integers, Mechanism
from .slopes import Change, discrete_gradient
from .unsolved import UnsolvedError

Array = NDArray[np.float64]

Function = tuple[Integers, Integers]
"""Leaves (kind, index) and operations of a function."""


def forms_of(mechanism: Mechanism, leaves: Integers) -> list[int]:
    """Forms that the quantities of some leaves are made of."""
    quantities = {int(index) for kind, index in leaves if kind != SIGNAL}
    return sorted({form for index in quantities for form in mechanism.quantities[index][1]})


@dataclass(frozen=True, slots=True)
class Element:
    """Spring, damper and drive on one quantity: N = k (sigma_mean - rest) + c dsigma/h - drive."""

    index: int
    quantity: int
    stiffness: float
    rest: float
    damping: float
    drive: float

    def check(self, kind: int) -> None:
        """Refuse numbers that no spring or damper has."""
        given = (self.stiffness, self.damping, self.rest if kind == LENGTH else 0.0)
        if not (all(x >= 0.0 for x in given) and abs(self.drive) < np.inf):
            raise UnsolvedError(Status.BAD_LAW)

    def slopes(self, values: Values) -> Array:
        """Slopes g (n_forms,): N times those of the quantity."""
        kind, forms = values.quantities[self.quantity]
        self.check(kind)
        if kind == LENGTH and self.rest == self.damping == self.drive == 0.0:
            g = np.zeros(len(values.s_n))  # V = k s/2: no direction is needed
            g[forms[0]] = 0.5 * self.stiffness
            return g
        sigma, p = values.quantity(self.quantity)
        return self.force(sigma, sigma.d / values.h) * p

    def force(self, sigma: Change, rate: float) -> float:
        """Generalised force N along -sigma."""
        spring = self.stiffness * (sigma.n + 0.5 * sigma.d - self.rest)
        return spring + self.damping * rate - self.drive


def elements(mechanism: Mechanism) -> list[Element]:
    """Springs and dampers with their present numbers."""
    names = ("stiffness", "rest", "damping", "drive")
    laws = zip(*(mechanism.section[name].tolist() for name in names), strict=True)
    return [
        Element(index, quantity, *law)
        for index, (quantity, law) in enumerate(zip(mechanism.elements, laws, strict=True))
    ]


@dataclass(frozen=True, slots=True)
class Slopes:
    """A function over a step: its change, slopes g (n_forms,) in the forms and in the signals."""

    value: Change
    g: Array
    signals: Array


def over_step(mechanism: Mechanism, function: Function, values: Values) -> Slopes:
    """Change of a function of quantities and signals, and its slopes."""
    leaves, operations = function
    changes, p = zip(*(values.leaf(*leaf) for leaf in leaves), strict=True)
    value, N = discrete_gradient(operations, mechanism.numbers, changes)
    signals = np.zeros(len(values.signal_n), dtype=N.dtype)
    for (kind, index), slope in zip(leaves, N, strict=True):
        if kind == SIGNAL:
            signals[index] += slope
    return Slopes(value, N @ np.array(p), signals)


def rolling(mechanism: Mechanism, function: Function, values: Values) -> tuple[float, Array]:
    """Velocity row C = h Psi(sigma_mean, dsigma/h), and its slopes g by the rates alone."""
    leaves, operations = function
    means = [values.mean_leaf(*leaf) for leaf in leaves]
    psi, c = discrete_gradient(operations, mechanism.numbers, means)
    g = np.zeros(len(values.s_n), dtype=c.dtype)
    for (kind, index), slope in zip(leaves, c, strict=True):
        if kind == RATE:
            g = g + slope * values.quantity(index)[1]
    return values.h * psi.n, g


def tangent(view: View, slopes: Callable[[Values], Array], forms: list[int]) -> Array:
    """Derivative (n, n) in d of the force g grad s."""
    g = slopes(view.values)
    curvature = view.part * view.course.forms.curvature(g)
    return curvature + view.gradients.T @ view.derivative(slopes, forms)
