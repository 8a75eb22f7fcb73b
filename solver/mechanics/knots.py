"""Knots of profiles in laws: which piece of a curve counts is the whole number below a switch.

The switch reads k + (x - x_k)/(x_k+1 - x_k) in piece k, and less or more beyond the ends. A piece
is a cubic p; with its middle b and d = x - b it goes on, beyond its knots, as

    p(x) = p(b) + d (p'(b) + d (3 p''(b) + d p''')/6)
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from itertools import pairwise

from solver.scene import Expr, Number
from solver.scene.expression import Curve, operate

_ROW = 6
"""Numbers of a row of a table: x_k and five coefficients (``solver/kernel/tape/spline.c``)."""
_BEYOND = 1e-3
"""Part of the slope beside it that the argument has beyond an end, which it seldom leaves again."""


class Knots(Curve):
    """A table of knots, which has none that count."""

    __slots__ = ()


def has_knots(number: Expr) -> bool:
    """Whether an operation looks up a curve made of cubics."""
    table = number.args[-1]
    if number.op != "spline" or not isinstance(table, Curve) or isinstance(table, Knots):
        return False
    return not any(row[5] for row in _rows(table.numbers))


def place_among_knots(number: Expr) -> Number:
    """Return the argument of the switch."""
    return operate("spline", _within(number), _tables(_numbers(number))[0])


def on_piece(number: Expr, side: Number) -> Number:
    """Return the curve as it is in the piece that a side tells."""
    curve, x, numbers = number.args[-1], _within(number), _numbers(number)
    assert isinstance(curve, Curve)
    rows, inverse = _rows(numbers), _tables(numbers)[1]
    piece = operate("max", operate("min", side, len(rows) - 2.0), -1.0)
    middle, later = (operate("spline", operate("add", piece, s), inverse) for s in (0.5, 0.75))
    d = operate("sub", x, middle)
    slope: Number = operate("spline_slope", middle, curve)
    if any(row[3] or row[4] for row in rows):
        bend, other = (operate("spline_curvature", at, curve) for at in (middle, later))
        third = operate("div", operate("sub", other, bend), operate("sub", later, middle))
        rest = operate("add", operate("mul", 3.0, bend), operate("mul", d, third))
        slope = operate("add", slope, operate("div", operate("mul", d, rest), 6.0))
    return operate("add", operate("spline", middle, curve), operate("mul", d, slope))


def _numbers(number: Expr) -> tuple[float, ...]:
    curve = number.args[-1]
    assert isinstance(curve, Curve)
    return tuple(curve.numbers)


def _rows(numbers: Sequence[float]) -> list[Sequence[float]]:
    return [numbers[k : k + _ROW] for k in range(1, len(numbers), _ROW)]


def _within(number: Expr) -> Number:
    """Return the argument of a curve, within its first period if it repeats."""
    x, numbers = number.args[0], _numbers(number)
    assert isinstance(x, Expr)  # it moves
    if not numbers[0]:
        return x
    first = numbers[1]
    return operate("add", operate("mod", operate("sub", x, first), numbers[0]), first)


@cache
def _tables(numbers: tuple[float, ...]) -> tuple[Curve, Curve]:
    """Curves from the argument to its place among the knots, and back."""
    knots = [row[0] for row in _rows(numbers)][1:]
    h = [right - left for left, right in pairwise(knots)]
    around = zip((0, *range(len(knots))), (knots[0], *knots), (h[0], *h, h[-1]), strict=True)
    there, back = [0.0], [0.0]
    for row, (k, x, step) in enumerate(around):
        is_end = row in (0, len(knots))
        there += x, float(k), (_BEYOND if is_end else 1.0) / step, 0.0, 0.0, 0.0
        back += float(k), x, step, 0.0, 0.0, 0.0
    return Knots("place among knots", tuple(there)), Knots("knots", tuple(back))
