"""Symbolic derivatives of expressions: the forces that belong to formulas, for outputs."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

from solver.scene import Expr, ExpressionError, Number, symbols
from solver.scene.expression import Operand, cos, log, operate, select, sign, sin, sqrt

SLOPES: dict[str, tuple[Callable[..., Number], ...]] = {
    "add": (lambda *_: 1.0, lambda *_: 1.0),
    "sub": (lambda *_: 1.0, lambda *_: -1.0),
    "mul": (lambda _, y: y, lambda x, _: x),
    "div": (lambda _, y: 1.0 / y, lambda x, y: -1.0 * x / (y * y)),
    "pow": (lambda x, y: y * x ** (y - 1.0), lambda x, y: x**y * log(x)),
    "neg": (lambda _: -1.0,),
    "sin": (cos,),
    "cos": (lambda x: -1.0 * sin(x),),
    "tan": (lambda x: 1.0 / (cos(x) * cos(x)),),
    "asin": (lambda x: 1.0 / sqrt(1.0 - x * x),),
    "acos": (lambda x: -1.0 / sqrt(1.0 - x * x),),
    "atan": (lambda x: 1.0 / (1.0 + x * x),),
    "atan2": (lambda y, x: x / (x * x + y * y), lambda y, x: -1.0 * y / (x * x + y * y)),
    "sqrt": (lambda x: 0.5 / sqrt(x),),
    "exp": (lambda x: operate("exp", x),),
    "log": (lambda x: 1.0 / x,),
    "sinh": (lambda x: operate("cosh", x),),
    "cosh": (lambda x: operate("sinh", x),),
    "tanh": (lambda x: 1.0 - operate("tanh", x) ** 2.0,),
    "abs": (sign,),
    "spline": (lambda x, table: operate("spline_slope", x, table),),
    "spline_slope": (lambda x, table: operate("spline_curvature", x, table),),
    "grid": tuple(partial(operate, f"grid_{axis}") for axis in "xyz"),
    "min": (lambda x, y: operate("le", x, y), lambda x, y: operate("gt", x, y)),
    "max": (lambda x, y: operate("ge", x, y), lambda x, y: operate("lt", x, y)),
}  # fmt: skip
"""Partial derivatives of the operations; those that are not listed are constant in pieces,
or, as mod, refused where they would move."""

NO_SLOPES = {
    "spline_curvature": "the curvature of a profile has no derivative: it has kinks at the points",
    **{f"grid_{axis}": "the slope of a grid has no derivative" for axis in "xyz"},
}
"""Operations of which nothing needs one, and what is said if something does."""


def derivative(number: Number, name: str) -> Number:
    """Return the derivative of a number with respect to the symbol `name`.

    Where a function has a kink, it is that of one side.
    """
    known: dict[Expr, Number] = {}

    def walk(part: Operand | str) -> Number:
        if not isinstance(part, Expr) or name not in symbols(part):
            return 0.0
        if part not in known:
            known[part] = 1.0 if part.op == "symbol" else chain(part)
        return known[part]

    def chain(part: Expr) -> Number:
        args: list[Any] = [arg for arg in part.args if not isinstance(arg, str)]
        if part.op == "select":
            return select(args[0], walk(args[1]), walk(args[2]))
        if part.op in NO_SLOPES:
            raise ExpressionError(NO_SLOPES[part.op])
        total: Number = 0.0
        for arg, slope in zip(args, SLOPES.get(part.op, ()), strict=False):
            inner = walk(arg)
            if inner != 0.0:
                total = total + slope(*args) * inner
        return total

    return walk(number)
