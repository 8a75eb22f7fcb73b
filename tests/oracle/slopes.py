"""The discrete chain rule: a function's change over a step as slopes times changes of its leaves.

    sum_j N_j dx_j = f(x_n1) - f(x_n)   exactly,

for a function made of the tape's operations. Each operation has slopes that are symmetric in the
two ends and become its derivative where they coincide; composed backwards they give a discrete
gradient N of the whole. Differences are carried forward and never formed from values, so that a
small step loses no digits.

Numbers may be complex with a tiny imaginary part, which then is a derivative (complex step).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from solver.runtime.layout import CODES
from tests.oracle import splines
from tests.oracle.tape import COUNTS, value_of

Array = NDArray[np.float64]
Integers = NDArray[np.int_]

SMALL = 1e-4
"""Below it two terms of a series are exact to the last digit, and 0/0 is not met."""

Number = Any
"""A float of NumPy, or a complex one that carries a derivative."""

WHOLE = 16.0
"""Largest whole exponent that is a product; others are exp(y log x)."""

NONE = np.float64(0.0)


@dataclass(frozen=True, slots=True)
class Change:
    """A number over a step: values at the beginning and the end, and their difference.

    They are NumPy's, so that a division by zero yields what IEEE 754 says, and no exception.
    """

    n: Number
    n1: Number
    d: Number

    @property
    def mid(self) -> Number:
        """Mean of the two ends."""
        return 0.5 * (self.n + self.n1)


def still(value: Number) -> Change:
    """A number that does not change; slopes are then derivatives."""
    return moving(value, NONE)


def moving(value: Number, difference: Number) -> Change:
    """A number that changes by `difference`."""
    n, d = np.asarray(value)[()], np.asarray(difference)[()]
    return Change(n, n + d, d)


def absolute(x: Number) -> Number:
    """Size |x|, with the sign taken from the real part."""
    return -x if x.real < 0.0 else x


def arctan2(y: Number, x: Number) -> Number:
    """Angle of (x, y); of complex numbers, with its derivative as imaginary part."""
    angle = np.arctan2(y.real, x.real)
    if y.imag == 0.0 == x.imag:
        return angle
    turn = (x.real * y.imag - y.real * x.imag) / (x.real**2 + y.real**2)
    return angle + 1j * turn


def sinc(x: Number) -> Number:
    """Quotient sin(x)/x."""
    return 1.0 - x * x / 6.0 if abs(x) < SMALL else np.sin(x) / x


def sinhc(x: Number) -> Number:
    """Quotient sinh(x)/x."""
    return 1.0 + x * x / 6.0 if abs(x) < SMALL else np.sinh(x) / x


def angle_over(cross: Number, dot: Number) -> Number:
    """Quotient atan2(cross, dot)/cross: the angle between two links over their cross product."""
    if dot.real > 0.0 and abs(cross) < SMALL * dot.real:
        return (1.0 - (cross / dot) ** 2 / 3.0) / dot
    return arctan2(cross, dot) / cross


def log_slope(x: Change) -> Number:
    """Slope of the logarithm, 2 atanh(z)/dx with z = dx/(x_n + x_n1)."""
    total = x.n + x.n1
    z = x.d / total
    return 2.0 / total * (1.0 + z * z / 3.0 if abs(z) < SMALL else np.arctanh(z) / z)


def exp_slope(x: Change) -> Number:
    """Slope of the exponential function."""
    return np.exp(x.mid) * sinhc(0.5 * x.d)


def tanh_slope(x: Change) -> Number:
    """Slope of tanh, sinhc(dx)/(cosh x_n cosh x_n1); over a long step the difference itself."""
    if abs(x.d) > 1.0:
        return (np.tanh(x.n1) - np.tanh(x.n)) / x.d
    return 2.0 * sinhc(x.d) / (np.cosh(x.n + x.n1) + np.cosh(x.d))


def abs_slope(x: Change) -> Number:
    """Slope of |x|; 0 where it stays 0."""
    total = absolute(x.n) + absolute(x.n1)
    return (x.n + x.n1) / total if total != 0.0 else NONE


def asin_slope(x: Change) -> Number:
    """Slope of the arcsine; sin(d asin) = x_n1 c_n - x_n c_n1 = dx ratio."""
    c_n, c_n1 = (np.sqrt((1.0 - end) * (1.0 + end)) for end in (x.n, x.n1))
    ratio = 0.5 * (c_n + c_n1) + 0.5 * (x.n + x.n1) ** 2 / (c_n + c_n1)
    return angle_over(x.d * ratio, c_n * c_n1 + x.n * x.n1) * ratio


def whole_power_slope(x: Change, n: int) -> Number:
    """Slope of x^n: sum of x_n1^k x_n^(n-1-k), for negative n that of 1/x^|n|."""
    if n < 0:
        return -whole_power_slope(x, -n) / (x.n**-n * x.n1**-n)
    return sum((x.n1**k * x.n ** (n - 1 - k) for k in range(n)), NONE)


def power_slopes(x: Change, y: Change) -> tuple[Number, Number]:
    """Slopes of x^y: a product for a constant whole exponent, else those of exp(y log x)."""
    if y.d == 0.0 and y.n.real == np.floor(y.n.real) and abs(y.n) <= WHOLE:
        return whole_power_slope(x, int(y.n.real)), NONE
    per_x = log_slope(x)
    log = Change(np.log(x.n), np.log(x.n1), per_x * x.d)
    product = Change(y.n * log.n, y.n1 * log.n1, y.mid * log.d + log.mid * y.d)
    outer = exp_slope(product)
    return outer * y.mid * per_x, outer * log.mid


def atan2_slopes(y: Change, x: Change) -> tuple[Number, Number]:
    """Slopes of the angle of (x, y)."""
    factor = angle_over(x.mid * y.d - y.mid * x.d, x.n * x.n1 + y.n * y.n1)
    return factor * x.mid, -factor * y.mid


def extreme_slopes(x: Change, y: Change, sign: Number) -> tuple[Number, Number]:
    """Slopes of (x + y + sign |x - y|)/2: the maximum for sign 1, the minimum for -1."""
    half = 0.5 * sign * abs_slope(Change(x.n - y.n, x.n1 - y.n1, x.d - y.d))
    return 0.5 + half, 0.5 - half


def _unary(slope: Callable[[Change], Number]) -> Callable[..., tuple[Number, ...]]:
    return lambda x, *_: (slope(x),)


def _flat(*arguments: Change) -> tuple[Number, ...]:
    """No slope: the scene's reader keeps such operations away from all that moves."""
    return (0.0,) * len(arguments)


def _select(condition: Change, *_: Change) -> tuple[Number, ...]:
    return (0.0, 1.0, 0.0) if condition.mid != 0.0 else (0.0, 0.0, 1.0)


SLOPES: dict[str, Callable[..., tuple[Number, ...]]] = {
    "copy": _unary(lambda _: 1.0),
    "add": lambda x, y: (1.0, 1.0),  # noqa: ARG005
    "sub": lambda x, y: (1.0, -1.0),  # noqa: ARG005
    "mul": lambda x, y: (y.mid, x.mid),
    "div": lambda x, y: (y.mid / (y.n * y.n1), -x.mid / (y.n * y.n1)),
    "pow": power_slopes,
    "neg": _unary(lambda _: -1.0),
    "sin": _unary(lambda x: np.cos(x.mid) * sinc(0.5 * x.d)),
    "cos": _unary(lambda x: -np.sin(x.mid) * sinc(0.5 * x.d)),
    "tan": _unary(lambda x: sinc(x.d) / (np.cos(x.n) * np.cos(x.n1))),
    "asin": _unary(asin_slope),
    "acos": _unary(lambda x: -asin_slope(x)),
    "atan": _unary(lambda x: angle_over(x.d, 1.0 + x.n * x.n1)),
    "atan2": atan2_slopes,
    "sqrt": _unary(lambda x: 1.0 / (np.sqrt(x.n) + np.sqrt(x.n1))),
    "exp": _unary(exp_slope),
    "log": _unary(log_slope),
    "sinh": _unary(lambda x: np.cosh(x.mid) * sinhc(0.5 * x.d)),
    "cosh": _unary(lambda x: np.sinh(x.mid) * sinhc(0.5 * x.d)),
    "tanh": _unary(tanh_slope),
    "abs": _unary(abs_slope),
    "min": lambda x, y: extreme_slopes(x, y, -1.0),
    "max": lambda x, y: extreme_slopes(x, y, 1.0),
    "select": _select,
}
"""Slopes of each operation with respect to its arguments; the others have none."""


def operate(code: int, arguments: Sequence[Change]) -> tuple[Change, tuple[Number, ...]]:
    """Change of one operation's value, and its slopes."""
    name = CODES[code]
    used = arguments[: COUNTS[name]]
    slopes = SLOPES.get(name, _flat)(*used)
    pairs = [(slope, x) for slope, x in zip(slopes, used, strict=True) if slope != 0.0]
    ends = ([x.n.real for x in used], [x.n1.real for x in used])
    n, n1 = (np.float64(value_of(code, values)) for values in ends)
    d = sum((slope * x.d for slope, x in pairs if x.d != 0.0), NONE)
    tilt = sum((slope.real * x.n.imag for slope, x in pairs), NONE)
    if tilt != 0.0 or d.imag != 0.0:  # complex step: the slopes carry the derivatives
        n, n1 = n + 1j * tilt, n1 + 1j * (tilt + d.imag)
    return Change(n, n1, d), slopes


def spline(order: int, x: Change, table: Array) -> tuple[Change, tuple[Number, ...]]:
    """Change of a spline or of its derivative of that order, and its slope."""
    slope = splines.slope(order, x.n, x.n1, table)
    ends = (splines.value(order, end, table) for end in (x.n, x.n1))
    return Change(*ends, slope * x.d), (slope,)


def discrete_gradient(
    operations: Iterable[Sequence[int]] | Integers, constants: Array, leaves: Sequence[Change]
) -> tuple[Change, Array]:
    """Change of a function over a step and the slopes N of its leaves.

    Parameters
    ----------
    operations : sequence of (code, a, b, c)
        Arguments a >= 0 are registers, leaves first, then one an operation; a < 0 is
        ``constants[-1 - a]``. The value is the last register.
    constants : ndarray
    leaves : sequence of Change
    """
    registers, slopes, arguments = list(leaves), [], []
    for code, *places in operations:
        given = [registers[a] if a >= 0 else still(constants[-1 - a]) for a in places]
        order = splines.ORDERS.get(CODES[int(code)])
        if order is None:
            value, slope = operate(int(code), given)
        else:
            value, slope = spline(order, given[0], constants[-1 - places[1] : -places[2]])
        registers.append(value)
        slopes.append(slope)
        arguments.append(places)
    adjoint = np.zeros(len(registers), dtype=np.result_type(*(x.n + x.d for x in registers), 1.0))
    adjoint[-1] = 1.0
    for register in range(len(registers) - 1, len(leaves) - 1, -1):
        place = register - len(leaves)
        for a, slope in zip(arguments[place], slopes[place], strict=False):
            if a >= 0:
                adjoint[a] += adjoint[register] * slope
    return registers[-1], adjoint[: len(leaves)]
