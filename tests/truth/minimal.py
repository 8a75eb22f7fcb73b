"""Motions in fewest coordinates: M(q) q'' + h(q, q') = Q by DOP853 at 1e-12; nothing of the solver.

Kane's form: M = sum m J'J + W'J W, h = sum m J'a + W'(J alpha + omega x J omega), where J and W are
the partial velocities of mass centres and bodies, and a, alpha their accelerations for q'' = 0
(Kane and Levinson, Dynamics: Theory and Applications, 1985, section 4). Places are written as
formulas of the coordinates; numbers that carry their derivatives give the rest exactly.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import solve_ivp

Array = NDArray[np.float64]
ACCURACY = 1e-13
"""Relative tolerance of DOP853: its error is some ten times that in the runs of this folder."""


@dataclass(frozen=True)
class Number:
    """Value, gradient by the coordinates, rate, and second rate where coordinates' rates stay."""

    value: float
    gradient: Array
    rate: float
    bias: float

    def of(self, value: float, slope: float, curvature: float) -> Number:
        """Return f(self) from f, f' and f''."""
        bias = slope * self.bias + curvature * self.rate**2
        return Number(value, slope * self.gradient, slope * self.rate, bias)

    def __add__(self, other: Number | float) -> Number:
        """Return the sum."""
        if not isinstance(other, Number):
            return Number(self.value + other, self.gradient, self.rate, self.bias)
        return Number(
            self.value + other.value, self.gradient + other.gradient,
            self.rate + other.rate, self.bias + other.bias,
        )  # fmt: skip

    def __mul__(self, other: Number | float) -> Number:
        """Return the product."""
        if not isinstance(other, Number):
            return self.of(self.value * other, other, 0.0)
        return Number(
            self.value * other.value,
            self.gradient * other.value + self.value * other.gradient,
            self.rate * other.value + self.value * other.rate,
            self.bias * other.value + 2 * self.rate * other.rate + self.value * other.bias,
        )

    __radd__ = __add__
    __rmul__ = __mul__

    def __neg__(self) -> Number:
        """Return the negative."""
        return self * -1.0

    def __sub__(self, other: Number | float) -> Number:
        """Return the difference."""
        return self + -1.0 * other

    def __rsub__(self, other: float) -> Number:
        """Return the difference of a plain number."""
        return -self + other

    def __truediv__(self, other: Number | float) -> Number:
        """Return the quotient."""
        if not isinstance(other, Number):
            return self * (1.0 / other)
        x = other.value
        return self * other.of(1 / x, -1 / x**2, 2 / x**3)

    def __pow__(self, power: float) -> Number:
        """Return a power with a plain exponent."""
        x = self.value
        # math.pow raises where a loop cannot be closed; ** gives a complex number.
        slope = power * math.pow(x, power - 1)
        curvature = power * (power - 1) * (math.pow(x, power - 2) if power != 1 else 0.0)
        return self.of(math.pow(x, power), slope, curvature)


Value = Number | float
Place = Sequence[Value]


def sin(x: Number) -> Number:
    """Sine."""
    s, c = math.sin(x.value), math.cos(x.value)
    return x.of(s, c, -s)


def cos(x: Number) -> Number:
    """Cosine."""
    s, c = math.sin(x.value), math.cos(x.value)
    return x.of(c, -s, -c)


def sqrt(x: Number) -> Number:
    """Square root."""
    return x**0.5


def exp(x: Number) -> Number:
    """Exponential."""
    y = math.exp(x.value)
    return x.of(y, y, y)


def asin(x: Number) -> Number:
    """Arcsine, where the slope is finite."""
    c = math.sqrt(1 - x.value**2)
    return x.of(math.asin(x.value), 1 / c, x.value / c**3)


def atan2(y: Number, x: Number) -> Number:
    """Angle of a direction in the plane."""
    r2 = x.value**2 + y.value**2
    gradient = (x.value * y.gradient - y.value * x.gradient) / r2
    rate = (x.value * y.rate - y.value * x.rate) / r2
    across = x.value * y.bias - y.value * x.bias
    along = x.value * x.rate + y.value * y.rate
    bias = across / r2 - 2 * along * rate / r2
    return Number(math.atan2(y.value, x.value), gradient, rate, bias)


def dot(a: Place, b: Place) -> Value:
    """Scalar product."""
    total: Value = 0.0
    for x, y in zip(a, b, strict=True):
        total = total + x * y
    return total


def turned(R: Sequence[Place], r: Place) -> list[Value]:
    """R r, of rows R."""
    return [dot(row, r) for row in R]


def about(axis: int, angle: Number) -> list[list[Value]]:
    """Rows of the rotation about x (0), y (1) or z (2)."""
    c, s = cos(angle), sin(angle)
    i, j = (axis + 1) % 3, (axis + 2) % 3
    rows: list[list[Value]] = [[0.0] * 3 for _ in range(3)]
    rows[axis][axis] = 1.0
    rows[i][i], rows[j][j], rows[j][i], rows[i][j] = c, c, s, -s
    return rows


def after(A: Sequence[Place], B: Sequence[Place]) -> list[list[Value]]:
    """A B, of rows."""
    return [turned([[*column] for column in zip(*B, strict=True)], row) for row in A]


@dataclass(frozen=True)
class Body:
    """Mass centre, and how the body turns: an angle in the plane, or a rotation matrix in space.

    `inertia` [kg.m2] is a number in the plane, three principal ones or a matrix in space.
    """

    mass: float
    place: Place
    inertia: float | Sequence[float] | Array = 0.0
    angle: Value = 0.0
    rotation: Sequence[Place] | None = None


@dataclass(frozen=True)
class Parts:
    """What moves: bodies, an energy, loads (force, place) and generalized forces (n,)."""

    bodies: Sequence[Body]
    energy: Value = 0.0
    loads: Sequence[tuple[Sequence[float], Place]] = ()
    torques: Sequence[float] | Array = field(default_factory=tuple)


Mechanism = Callable[[float, Sequence[Number]], Parts]


def numbers(q: Array, v: Array) -> list[Number]:
    """Coordinates as numbers that know their derivatives."""
    eye = np.eye(len(q))
    return [Number(float(x), eye[i], float(v[i]), 0.0) for i, x in enumerate(q)]


def _derivatives(x: Value, n: int) -> tuple[Array, float]:
    """Gradient and bias of a number or a constant."""
    return (x.gradient, x.bias) if isinstance(x, Number) else (np.zeros(n), 0.0)


def _plain(x: Value) -> float:
    return x.value if isinstance(x, Number) else float(x)


def _turning(R: Sequence[Place], v: Array) -> tuple[Array, Array, Array]:
    """Partial angular velocities (3, n), angular velocity and its bias (3,), in body axes."""
    n = len(v)
    value = np.array([[_plain(x) for x in row] for row in R])
    found = [[_derivatives(x, n) for x in row] for row in R]
    gradient = np.array([[x for x, _ in row] for row in found])
    bias = np.array([[x for _, x in row] for row in found])
    skew = np.einsum("ki,kjn->ijn", value, gradient)
    W = np.array([skew[2, 1], skew[0, 2], skew[1, 0]])
    second = value.T @ bias
    across = 0.5 * (second - second.T)
    return W, W @ v, np.array([across[2, 1], across[0, 2], across[1, 0]])


def accelerations(mechanism: Mechanism, t: float, q: Array, v: Array) -> Array:
    """Second rates of the coordinates, shape (n,)."""
    n = len(q)
    parts = mechanism(t, numbers(q, v))
    M, f = np.zeros((n, n)), np.zeros(n)
    for body in parts.bodies:
        for x in body.place:
            gradient, bias = _derivatives(x, n)
            M += body.mass * np.outer(gradient, gradient)
            f -= body.mass * bias * gradient
        if body.rotation is None:
            gradient, bias = _derivatives(body.angle, n)
            M += body.inertia * np.outer(gradient, gradient)
            f -= body.inertia * bias * gradient
        else:
            J = np.asarray(body.inertia, dtype=float)
            J = np.diag(J) if J.ndim == 1 else J
            W, omega, alpha = _turning(body.rotation, v)
            M += W.T @ J @ W
            f -= W.T @ (J @ alpha + np.cross(omega, J @ omega))
    f -= _derivatives(parts.energy, n)[0]
    for force, place in parts.loads:
        for F, x in zip(force, place, strict=True):
            f += F * _derivatives(x, n)[0]
    if len(parts.torques):
        f += np.asarray(parts.torques)
    return np.linalg.solve(M, f)


def dop853(
    rates: Callable[[float, Array], Sequence[float] | Array], span: tuple[float, float],
    y: Sequence[float] | Array, accuracy: float = ACCURACY, *, least: float | None = None, **more: Any,
) -> Any:  # fmt: skip
    """Integrate y' = rates(t, y) over the span; the result of SciPy's `solve_ivp`, with `more`.

    `least` is the error of y that counts as none, if it is not the relative `accuracy`.
    """
    found = solve_ivp(
        rates, span, y, method="DOP853", rtol=accuracy,
        atol=accuracy if least is None else least, **more,
    )  # fmt: skip
    assert found.success, found.message
    return found


def motion(
    mechanism: Mechanism, q0: Sequence[float], v0: Sequence[float], times: Array,
    *, jumps: Sequence[float] = (),
) -> tuple[Array, Array]:  # fmt: skip
    """Coordinates and rates, (len(times), n) each; integration begins anew at the `jumps` [s]."""
    n = len(q0)

    def rates(t: float, y: Array) -> Array:
        return np.concatenate([y[n:], accelerations(mechanism, t, y[:n], y[n:])])

    y = np.array([*q0, *v0], dtype=float)
    found = [y] if times[0] == 0.0 else []
    edges = [0.0, *(t for t in jumps if 0.0 < t < times[-1]), float(times[-1])]
    for begin, end in pairwise(edges):
        # Laws are those of the open interval: its ends belong to this side of a jump.
        inside = [t for t in times if begin < t <= end]
        inset = 1e-12 * (end - begin)
        solution = dop853(
            lambda t, y, a=begin + inset, b=end - inset: rates(min(max(t, a), b), y),
            (begin, end), y, t_eval=sorted({*inside, end}),
        )  # fmt: skip
        columns = dict(zip(solution.t, solution.y.T, strict=True))
        found += [columns[t] for t in inside]
        y = columns[end]
    table = np.array(found)
    return table[:, :n], table[:, n:]


def values(
    formulas: Callable[[Sequence[Number]], Sequence[Value]], q: Array, v: Array
) -> tuple[Array, Array]:
    """Values and rates (len(q), m) of formulas of the coordinates."""
    found = [[(_plain(x), getattr(x, "rate", 0.0)) for x in formulas(numbers(*s))]
             for s in zip(q, v, strict=True)]  # fmt: skip
    table = np.array(found)
    return table[:, :, 0], table[:, :, 1]


def in_time(formula: Callable[[Number], Sequence[Value]], t: Array) -> tuple[Array, Array, Array]:
    """Values, rates and second rates (len(t), m) of formulas of the time."""
    one = np.ones(1)
    found = [[(_plain(x), getattr(x, "rate", 0.0), getattr(x, "bias", 0.0))
              for x in formula(Number(float(s), one, 1.0, 0.0))] for s in t]  # fmt: skip
    table = np.array(found)
    return table[:, :, 0], table[:, :, 1], table[:, :, 2]


def torque(mechanism: Mechanism, t: Array, q: Array, v: Array, a: Array) -> Array:
    """Generalized force (len(t),) that moves a mechanism of one coordinate with q, q' and q''."""
    found = []
    for time, *state, acceleration in zip(t, q, v, a, strict=True):
        place, rate = (np.array([x]) for x in state)
        free = accelerations(mechanism, time, place, rate)[0]

        def with_one(time: float, q: Sequence[Number]) -> Parts:
            parts = mechanism(time, q)
            before = np.asarray(parts.torques) if len(parts.torques) else np.zeros(1)
            return Parts(parts.bodies, parts.energy, parts.loads, before + 1.0)

        each = accelerations(with_one, time, place, rate)[0] - free
        found.append((acceleration - free) / each)
    return np.array(found)
