"""The energy of a spring whose force is a formula: V(s) = F integrated over s, from 0 on.

Sums are integrated term by term. A term has a closed form if it is a polynomial of s, or a
function of L = a s + b (a profile, a power, exp, sin, ...):  V = (G(L) - G(b))/a with G' = F. Where
abs, sign, min, max or a comparison goes over at one place r, each side has its own formula:

    V = left side integrated from min(0, r) to min(s, r) + right side from max(0, r) to max(s, r)

All other terms take Gauss and Legendre's quadrature with 16 points, V = s sum w_i F(s x_i), whose
slope is F as far as F is a polynomial of degree 31 between 0 and s.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from itertools import pairwise, zip_longest
from math import inf
from typing import Any

from solver.mechanics.derivative import derivative
from solver.mechanics.formulas import rewritten, with_symbols
from solver.scene import Expr, ExpressionError, Number, evaluate
from solver.scene.expression import Curve, log, operate, select, sqrt, symbol

Between = Callable[[Number, Number], Number]
"""Integral from a lower to an upper end."""

_HIGHEST = 40
"""Degree of a polynomial that is multiplied out."""
_CLOSE = 1e-9
"""Largest error of a force by quadrature, over the largest force."""
_PLACES = 64
"""On either side, at which the force by quadrature is looked at."""
_COMPARISONS = ("lt", "le", "gt", "ge")
_ROW = 6
"""Numbers of a row of a table: x_k and five coefficients (``solver/kernel/tape/spline.c``)."""

GAUSS = (
    (0.09501250983763744, 0.1894506104550685),
    (0.28160355077925891, 0.1826034150449236),
    (0.45801677765722739, 0.16915651939500254),
    (0.61787624440264375, 0.14959598881657673),
    (0.75540440835500303, 0.12462897125553387),
    (0.86563120238783174, 0.09515851168249278),
    (0.94457502307323258, 0.06225352393864789),
    (0.98940093499164993, 0.02715245941175409),
)
"""Nodes in (0, 1) and weights of the rule with 16 points on [-1, 1], which is symmetric."""


def energy_of(force: Number, name: str, reach: float, known: Mapping[str, float]) -> Number:
    """Return the energy of a force, an expression in the symbol `name`, zero where that is 0.

    Parameters
    ----------
    force : Number
        In N or N.m, an expression in `name`, in m or rad.
    name : str
    reach : float
        Where quadrature is needed, its force is compared with `force` from -reach to reach.
    known : mapping of str to float
        Values of all other symbols, for this comparison.

    Raises
    ------
    ExpressionError
        Where the slope of the energy would miss the force by more than 1e-9 of the largest one.
    """
    search = Antiderivative(name)
    try:
        energy = search.between(force)(0.0, symbol(name))
    except ExpressionError as error:
        message = f"its energy from {name} = 0 on has no value: {error.message}"
        raise ExpressionError(message) from None
    if not search.is_exact:
        missed = _missed(force, energy, name, reach, known)
        if not missed <= _CLOSE:
            message = "its energy has no closed form, and quadrature misses the force by "
            message += f"{missed:.1e} of the largest one for '{name}' from {-reach:g} to {reach:g};"
            message += " write it with polynomials, profiles of a linear argument, or abs, min, "
            message += f"max and conditions that go over at one '{name}'"
            raise ExpressionError(message)
    return energy


def _missed(
    force: Number, energy: Number, name: str, reach: float, known: Mapping[str, float]
) -> float:
    """Return the largest error of the slope of an energy within reach, over the largest force."""
    slope, largest, worst = derivative(energy, name), 0.0, 0.0
    for k in range(1 - _PLACES, _PLACES):
        place = reach * k / _PLACES
        values = {**known, name: place}
        try:
            exact = evaluate(force, values)
            worst = max(worst, abs(evaluate(slope, values) - exact))
        except ExpressionError as error:
            message = f"has no value at {name} = {place:g}: {error.message}"
            raise ExpressionError(message) from None
        largest = max(largest, abs(exact))
    return worst / largest if largest else worst


class Antiderivative:
    """Integrals of formulas over one symbol."""

    def __init__(self, name: str) -> None:
        self._s = symbol(name)
        self.is_exact = True
        """Whether nothing needed quadrature."""
        self._is_side = False
        """Whether a side of a split is integrated: L may miss 0 by round-off where it ends."""
        self._range = -inf, inf
        """Where it ends, as far as that is known: nothing goes over beyond."""

    def between(self, force: Number) -> Between:
        """Return the integral of a formula, as a function of its ends."""
        if not self._moves(force):
            return lambda low, high: force * (high - low)
        assert isinstance(force, Expr)
        found = self._of_terms(force) or self._of_pieces(force)
        found = found or self._of_polynomial(force) or self._of_function(force)
        return found or self._by_quadrature(force)

    def _moves(self, number: object) -> bool:
        return isinstance(number, Expr) and str(self._s) in number.mentions

    def _at(self, number: Number, place: Number) -> Number:
        return with_symbols(number, {self._s: place})

    # ----------------------------------------------------------------------------- terms

    def _of_terms(self, force: Expr) -> Between | None:
        """Integrate what is added, or multiplied by a constant."""
        if force.op == "symbol":
            return None
        x, y = _ends(force)
        if force.op == "neg":
            return _times(-1.0, self.between(x))
        if force.op in ("add", "sub"):
            first, second = self.between(x), self.between(y)
            return lambda low, high: operate(force.op, first(low, high), second(low, high))
        if force.op == "select" and not self._moves(x):
            sides: tuple[Any, ...] = force.args[1:]
            one, other = map(self.between, sides)
            return lambda low, high: select(x, one(low, high), other(low, high))
        if force.op == "mul" and not self._moves(x):
            return _times(x, self.between(y))
        if force.op in ("mul", "div") and not self._moves(y):
            return _times(y if force.op == "mul" else _over(1.0, y), self.between(x))
        return None

    # ---------------------------------------------------------------------------- pieces

    def _of_pieces(self, force: Expr) -> Between | None:
        """Integrate on both sides of a place at which abs, min, a condition, ... goes over."""
        for switch in self._switches(force):
            x, y = _ends(switch)
            pair = len(switch.args) == 2
            terms = self._polynomial(operate("sub", x, y) if pair else x)
            if terms is None or len(terms) != 2:
                continue
            slope = terms[1]
            if not isinstance(slope, Expr):
                return self._split(force, switch, terms, 1.0 if slope > 0.0 else -1.0)
            rises, falls = (self._split(force, switch, terms, sign) for sign in (1.0, -1.0))
            positive = operate("gt", slope, 0.0)
            return lambda low, high: select(positive, rises(low, high), falls(low, high))
        return None

    def _split(self, force: Expr, switch: Expr, terms: Sequence[Number], sign: float) -> Between:
        """Integrate on both sides of a switch whose difference rises or falls, by its sign."""
        place = _over(0.0 - terms[0], terms[1]) + 0.0  # and no -0.0
        is_side, (lowest, highest) = self._is_side, self._range
        known = place if isinstance(place, float) else None
        if known is not None and not lowest < known < highest:
            return self.between(_with_side(force, switch, sign if known <= lowest else -sign))
        self._is_side = True
        self._range = lowest, highest if known is None else known
        left = self.between(_with_side(force, switch, -sign))
        self._range = lowest if known is None else known, highest
        right = self.between(_with_side(force, switch, sign))
        self._is_side, self._range = is_side, (lowest, highest)

        def joined(low: Number, high: Number) -> Number:
            below, above = (
                [operate(limit, end, place) for end in (low, high)] for limit in ("min", "max")
            )
            return left(*below) + right(*above)

        return joined

    def _switches(self, force: Expr) -> list[Expr]:
        """Return what goes over in a formula, inner parts first."""
        found: dict[Expr, None] = {}

        def walk(part: object) -> None:
            if isinstance(part, Expr) and self._moves(part):
                for arg in part.args:
                    walk(arg)
                if part.op in ("abs", "sign", "min", "max", *_COMPARISONS):
                    found[part] = None

        walk(force)
        return [*found]

    # ----------------------------------------------------------------------- polynomials

    def _of_polynomial(self, force: Expr) -> Between | None:
        terms = self._polynomial(force)
        if terms is None:
            return None

        def value(x: Number) -> Number:
            total: Number = 0.0
            for k in range(len(terms) - 1, -1, -1):
                total = x * (total + terms[k] / (k + 1.0))
            return total

        return lambda low, high: value(high) - value(low)

    def _polynomial(self, number: Number) -> list[Number] | None:
        """Coefficients of a polynomial, that of the power 0 first; None of what is none."""
        if not self._moves(number):
            return [number]
        assert isinstance(number, Expr)
        if number == self._s:
            return [0.0, 1.0]
        if number.op == "neg":
            return _scaled(-1.0, self._polynomial(_ends(number)[0]))
        if number.op not in ("add", "sub", "mul", "div", "pow"):
            return None
        x, y = _ends(number)
        first = self._polynomial(x)
        if first is None:
            return None
        if number.op == "pow":
            if not isinstance(y, float) or y != int(y) or not 0 <= y * (len(first) - 1) <= _HIGHEST:
                return None
            if first[0] != 0.0 and y > 3.0:  # multiplied out, terms would cancel
                return None
            total: list[Number] = [1.0]
            for _ in range(int(y)):
                total = _product(total, first)
            return total
        second = self._polynomial(y)
        if second is None:
            return None
        if number.op == "div":
            return None if len(second) > 1 else _scaled(_over(1.0, second[0]), first)
        if number.op == "mul":
            return _product(first, second) if len(first) + len(second) <= _HIGHEST else None
        pairs = zip_longest(first, second, fillvalue=0.0)
        terms = [operate(number.op, a, b) for a, b in pairs]
        while len(terms) > 1 and terms[-1] == 0.0:
            terms.pop()
        return terms

    # ------------------------------------------------------------- functions of L = a s + b

    def _of_function(self, force: Expr) -> Between | None:
        """Integrate a function of a linear argument."""
        x, y = _ends(force)
        if force.op == "spline":
            return self._of_profile(x, y)
        if force.op == "pow" and not self._moves(y):
            if isinstance(x, Expr) and x.op == "div" and not self._moves(x.args[0]):
                above, below = _ends(x)
                return _times(operate("pow", above, y), self._of_power(below, -1.0 * y))
            return self._of_power(x, y)
        if force.op == "div" and not self._moves(x):
            if isinstance(y, Expr) and y.op == "pow" and not self._moves(y.args[1]):
                base, power = _ends(y)
                return _times(x, self._of_power(base, -1.0 * power))
            return _times(x, self._of_power(y, -1.0))
        if force.op == "sqrt":
            return self._of_power(x, 0.5)
        known = _INTEGRALS.get(force.op)
        return None if known is None else self._through(x, known)

    def _through(self, argument: Number, integral: Callable[[Number], Number]) -> Between | None:
        """Return (G(L(high)) - G(L(low)))/a; None where the argument is not linear."""
        terms = self._polynomial(argument)
        if terms is None or len(terms) != 2:
            return None
        b, a = terms
        return lambda low, high: _over(integral(a * high + b) - integral(a * low + b), a)

    def _of_power(self, base: Number, power: Number) -> Between | None:
        if power == -1.0:
            terms = self._polynomial(base)
            if terms is None or len(terms) != 2:
                return None
            b, a = terms
            return lambda low, high: _over(log(_over(a * high + b, a * low + b)), a)
        higher = power + 1.0
        is_whole = isinstance(power, float) and power == int(power)

        def integral(x: Number) -> Number:
            if self._is_side and not is_whole:
                x = operate("max", x, 0.0)
            return _over(operate("pow", x, higher), higher)

        return self._through(base, integral)

    def _of_profile(self, argument: Number, curve: Curve) -> Between | None:
        integrated = integral_of_table(tuple(curve.numbers))
        if integrated is None:
            return None
        mean, numbers = integrated
        table = Curve(f"integral of {curve.name}", numbers)
        return self._through(argument, lambda x: mean * x + operate("spline", x, table))

    # ------------------------------------------------------------------------- quadrature

    def _by_quadrature(self, force: Expr) -> Between:
        self.is_exact = False

        def between(low: Number, high: Number) -> Number:
            middle, half = 0.5 * (low + high), 0.5 * (high - low)
            total: Number = 0.0
            for node, weight in GAUSS:
                for x in (-node, node):
                    total = total + weight * self._at(force, middle + x * half)
            return half * total

        return between


def integral_of_table(numbers: Sequence[float]) -> tuple[float, tuple[float, ...]] | None:
    """Return mean and table with mean x + table(x) the integral of a profile from its first x on.

    The mean is 0 but for a profile that repeats, of which the rest repeats as well. None if the
    pieces have degree 4 already.
    """
    period = numbers[0]
    rows = [numbers[k : k + _ROW] for k in range(1, len(numbers), _ROW)]
    if any(row[5] for row in rows):
        return None

    def areas(mean: float) -> list[float]:
        """Integral of the profile less its mean from the first x to each row."""
        found = [0.0, 0.0]
        for row, after in pairwise(rows[1:]):
            h = after[0] - row[0]
            c = (row[1] - mean, row[2] / 2.0, row[3] / 3.0, row[4] / 4.0)
            found.append(found[-1] + h * (c[0] + h * (c[1] + h * (c[2] + h * c[3]))))
        return found

    mean = areas(0.0)[-1] / period if period else 0.0
    table = [period]
    for row, area in zip(rows, areas(mean), strict=True):
        table += row[0], area, row[1] - mean, row[2] / 2.0, row[3] / 3.0, row[4] / 4.0
    return mean, tuple(table)


def _with_side(force: Expr, switch: Expr, side: float) -> Number:
    """Return a formula as it is where the difference of a switch has the sign of `side`."""
    positive = side > 0.0
    x, y = _ends(switch)
    value: Number
    if switch.op == "abs":
        value = x if positive else operate("neg", x)
    elif switch.op == "sign":
        value = 1.0 if positive else -1.0
    elif switch.op in ("min", "max"):
        value = x if positive == (switch.op == "max") else y
    else:
        value = float(positive == (switch.op in ("gt", "ge")))
    meanings: dict[Expr, Number] = {switch: value}
    return rewritten(force, lambda x: meanings.get(x, x if x.op in ("symbol", "call") else None))


def _ends(operation: Expr) -> tuple[Any, Any]:
    """Return the first and the last operand."""
    return operation.args[0], operation.args[-1]


def _over(x: Number, y: Number) -> Number:
    """Return x/y, or raise `ExpressionError` where that is known to have no value."""
    return operate("div", x, y)


def _times(factor: Number, integral: Between | None) -> Between | None:
    return integral and (lambda low, high: factor * integral(low, high))


def _scaled(factor: Number, terms: list[Number] | None) -> list[Number] | None:
    return terms and [factor * term for term in terms]


def _product(first: Sequence[Number], second: Sequence[Number]) -> list[Number]:
    total: list[Number] = [0.0] * (len(first) + len(second) - 1)
    for i, a in enumerate(first):
        for k, b in enumerate(second):
            total[i + k] = total[i + k] + a * b
    return total


_INTEGRALS: dict[str, Callable[[Number], Number]] = {
    "exp": lambda x: operate("exp", x),
    "sin": lambda x: -1.0 * operate("cos", x),
    "cos": lambda x: operate("sin", x),
    "sinh": lambda x: operate("cosh", x),
    "cosh": lambda x: operate("sinh", x),
    "tanh": lambda x: log(operate("cosh", x)),
    "atan": lambda x: x * operate("atan", x) - 0.5 * log(1.0 + x * x),
    "asin": lambda x: x * operate("asin", x) + sqrt(1.0 - x * x),
}
"""Integrals of functions of one number."""
