"""What forms, quantities and signals do over a step.

A quantity sigma is a form, a length sqrt(s) or an angle atan2(s, c), unwrapped. Its change over a
step is a sum of slopes p times changes of its forms,

    form 1,    length 1/(l_n + l_n1),    angle g (-s_mid, c_mid), g = dtheta/(c_mid ds - s_mid dc),

and its discrete gradient sum p grad s(q_mid): exact for any step, and blind to rigid motions
(theory 2.5). Forms are quadratic, so that grad s(q_mid) . d = ds.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from ..errors import Status
from .mechanism import Mechanism
from .slopes import Change, angle_over, moving, still
from .state import Motion
from .unsolved import UnsolvedError

Array = NDArray[np.float64]

FORM, LENGTH, ANGLE = 0, 1, 2
"""Kinds of a quantity."""

VALUE, RATE, SIGNAL = 0, 1, 2
"""Kinds of a leaf: a quantity, its rate, a prescribed value."""

TURN = 2.0 * np.pi


@dataclass(frozen=True, slots=True)
class Values:
    """Forms s, quantities and signals at the beginning of a step, and their changes.

    Attributes
    ----------
    quantities : list of (kind, forms)
    s_n, ds : ndarray, shape (n_forms,)
    sigma_n : ndarray, shape (n_quantities,)
        For their turns: of angles, the unwrapped values at the beginning.
    signal_n, dsignal : ndarray, shape (n_signals,)
    h : float
    """

    quantities: list[tuple[int, list[int]]]
    s_n: Array
    ds: Array
    sigma_n: Array
    signal_n: Array
    dsignal: Array
    h: float

    def quantity(self, index: int) -> tuple[Change, Array]:
        """Change of a quantity, and its slopes p (n_forms,) with respect to all forms."""
        kind, forms = self.quantities[index]
        p = np.zeros(len(self.s_n), dtype=np.result_type(self.s_n, self.ds))
        changes = [moving(self.s_n[form], self.ds[form]) for form in forms]
        if kind == FORM:
            p[forms[0]] = 1.0
            return changes[0], p
        if kind == LENGTH:
            l_n, l_n1 = np.sqrt(changes[0].n), np.sqrt(changes[0].n1)
            if not (l_n.real > 0.0 and l_n1.real > 0.0):
                raise UnsolvedError(Status.ZERO_LENGTH)
            p[forms[0]] = 1.0 / (l_n + l_n1)
            return Change(l_n, l_n1, changes[0].d / (l_n + l_n1)), p
        c, s = changes
        c_mid, s_mid = c.n + 0.5 * c.d, s.n + 0.5 * s.d
        if not min((c.n**2 + s.n**2).real, (c.n1**2 + s.n1**2).real) > 0.0:
            raise UnsolvedError(Status.ZERO_LENGTH)
        cross = c_mid * s.d - s_mid * c.d
        g = angle_over(cross, c.n * c.n1 + s.n * s.n1)
        p[forms] = -g * s_mid, g * c_mid
        return moving(self.sigma_n[index], g * cross), p

    def end(self) -> Values:
        """The end of the step as a step without changes, whose slopes are derivatives."""
        sigma = self.sigma_n.astype(np.result_type(self.sigma_n, self.ds))
        for index, (kind, _) in enumerate(self.quantities):
            if kind == ANGLE:
                sigma[index] = self.quantity(index)[0].n1
        return replace(
            self,
            s_n=self.s_n + self.ds,
            ds=np.zeros_like(self.ds),
            sigma_n=sigma,
            signal_n=self.signal_n + self.dsignal,
            dsignal=np.zeros_like(self.dsignal),
        )

    def leaf(self, kind: int, index: int) -> tuple[Change, Array]:
        """Change of a leaf of a function that holds no rates, and its slopes p (n_forms,)."""
        if kind == VALUE:
            return self.quantity(index)
        assert kind == SIGNAL
        return moving(self.signal_n[index], self.dsignal[index]), np.zeros(len(self.s_n))

    def mean_leaf(self, kind: int, index: int) -> Change:
        """Leaf of a velocity row: a value at the middle of the step, or a mean rate."""
        change, _ = self.quantity(index) if kind == RATE else self.leaf(kind, index)
        return still(change.d / self.h if kind == RATE else change.mid)


class Present:
    """Links, forms and quantities at the present state, from which a step begins."""

    def __init__(self, mechanism: Mechanism, motion: Motion) -> None:
        self.mechanism = mechanism
        self.u, self.w = mechanism.forms.links(motion.q, motion.q_low)
        self.s = np.sum(self.u * self.w, axis=1)
        self.sigma = np.array(
            [
                quantity_at(kind, self.s[forms], turns)
                for (kind, forms), turns in zip(mechanism.quantities, motion.turns, strict=True)
            ]
        )
        self.x = motion.q + motion.q_low
        self.signal = motion.signal.copy()

    def values(self, h: float = 1.0) -> Values:
        """Values of a step of no length, whose slopes are derivatives."""
        ds, dsignal = np.zeros_like(self.s), np.zeros_like(self.signal)
        quantities = self.mechanism.quantities
        return Values(quantities, self.s, ds, self.sigma, self.signal, dsignal, h)

    def gradients(self) -> Array:
        """Gradients of the forms, shape (n_forms, n)."""
        return self.mechanism.forms.gradients(self.u, self.w)

    def form_rates(self, v: Array) -> Array:
        """Rates ds/dt of the forms."""
        forms = self.mechanism.forms
        return np.sum(self.u * (forms.W @ v) + self.w * (forms.U @ v), axis=1)


class Course:
    """A step by d = q_n1 - q_n from the present, while the signals change too."""

    def __init__(self, present: Present, d: Array, signal_n1: Array, h: float) -> None:
        forms = present.mechanism.forms
        self.present, self.d = present, d
        self.du, self.dw = forms.U @ d, forms.W @ d
        self.forms = forms
        u_mid, w_mid = self.links(0.5)
        ds = np.sum(u_mid * self.dw + w_mid * self.du, axis=1)
        dsignal = signal_n1 - present.signal
        self.values = replace(present.values(h), ds=ds, dsignal=dsignal)
        self.gradients = forms.gradients(u_mid, w_mid)
        """Discrete gradients of the forms: those at the middle, shape (n_forms, n)."""

    def links(self, part: float) -> tuple[Array, Array]:
        """Links u, w (n_forms, dim) at q_n + part d."""
        return self.present.u + part * self.du, self.present.w + part * self.dw

    def over_step(self) -> View:
        """Slopes over the whole step and gradients at its middle: exact in energy."""
        end = self.forms.gradients(*self.links(1.0))
        return View(self, 0.5, self.values, self.gradients, end)

    def at(self, part: float) -> View:
        """Derivatives at q_n + part d."""
        linear = np.sum(self.present.u * self.dw + self.present.w * self.du, axis=1)
        ds = part * (linear + part * np.sum(self.du * self.dw, axis=1))
        values = replace(self.values, ds=ds, dsignal=part * self.values.dsignal).end()
        gradients = self.forms.gradients(*self.links(part))
        return View(self, part, values, gradients, part * gradients)

    def size(self, form: int) -> float:
        """Size |u| |w| of a form, against which a small change of s is small."""
        u, w = self.links(1.0)
        return float(np.linalg.norm(u[form]) * np.linalg.norm(w[form])) or 1.0


@dataclass(frozen=True, slots=True)
class View:
    """Where in a step a law's slopes g and the forms' gradients are taken: its force is g grad s.

    Attributes
    ----------
    course : Course
    part : float
        The forms' gradients belong to q_n + part d.
    values : Values
        What the slopes are made of.
    gradients : ndarray, shape (n_forms, n)
    reach : ndarray, shape (n_forms, n)
        Derivatives in d of the forms' values that the slopes depend on.
    """

    course: Course
    part: float
    values: Values
    gradients: Array
    reach: Array

    @property
    def of_end(self) -> float:
        """Factor of a derivative in the end of a link, for one in d.

        A law that is symmetric in both ends depends on a link at one place twice as much.
        """
        return 2.0 * self.part if self.is_point else 1.0

    @property
    def is_point(self) -> bool:
        """Whether slopes are derivatives at a place, not slopes over the step."""
        return self.values is not self.course.values

    def link(self, form: int) -> tuple[Array, Array]:
        """Link u of a form at the beginning, and its change; at a point, there is none."""
        if self.is_point:
            u, _ = self.course.links(self.part)
            return u[form], np.zeros_like(u[form])
        return self.course.present.u[form], self.course.du[form]

    def coordinates(self) -> Array:
        """Coordinates q_n + part d."""
        return self.course.present.x + self.part * self.course.d

    def moved(self, form: int, change: complex) -> Values:
        """Values with one form changed where the slopes depend on it."""
        ds = self.values.ds.astype(complex)
        ds[form] += change
        moved = replace(self.values, ds=ds)
        return moved.end() if self.is_point else moved

    def derivative(self, law: Callable[[Values], Array], forms: Iterable[int]) -> Array:
        """Derivative in d (..., n) of numbers that are functions of some forms' values.

        By complex step, which has no truncation error and no cancellation.
        """
        total = 0.0
        for form in forms:
            step = 1e-30 * self.course.size(form)
            rate = np.imag(law(self.moved(form, 1j * step))) / step
            total = total + np.multiply.outer(rate, self.reach[form])
        return np.asarray(total)


def quantity_at(kind: int, s: Array, turns: float) -> float:
    """Quantity from its forms; an angle with its full turns."""
    if kind == ANGLE:
        # + 0.0: no negative zero, whose angle would be -pi
        return float(np.arctan2(s[1] + 0.0, s[0])) + TURN * turns
    return float(np.sqrt(s[0]) if kind == LENGTH else s[0])


def quantity_rate(kind: int, s: Array, s_dot: Array) -> float:
    """Rate of a quantity from its forms and their rates; 0 where its direction is undefined."""
    if kind == ANGLE:
        size2 = s[0] ** 2 + s[1] ** 2
        return float((s[0] * s_dot[1] - s[1] * s_dot[0]) / size2) if size2 > 0.0 else 0.0
    if kind == LENGTH:
        return float(0.5 * s_dot[0] / np.sqrt(s[0])) if s[0] > 0.0 else 0.0
    return float(s_dot[0])


def crossings(c_n: float, s_n: float, c_n1: float, s_n1: float) -> float:
    """Full turns that an angle gains when it crosses the negative axis: -1, 0 or 1."""
    turn = c_n * s_n1 - s_n * c_n1
    if s_n >= 0.0 > s_n1 and turn > 0.0:
        return 1.0
    return -1.0 if s_n < 0.0 <= s_n1 and turn < 0.0 else 0.0
