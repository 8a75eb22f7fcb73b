"""Arithmetic of scene expressions on plain floats: one table, one meaning per operation.

Every operation takes finite floats and either returns a finite float or raises
``ExpressionError``: no NaN and no infinity ever enters a scene. Truth is 1.0, falsehood is 0.0,
and every number but zero counts as true.
"""

import math
import operator
from collections.abc import Callable

from solver.runtime.operations import in_core


class ExpressionError(ValueError):
    """An expression that cannot be read or has no value.

    Parameters
    ----------
    message : str
        What is wrong.
    column : int, optional
        Position in the text of the expression, counted from 1.
    help : str, optional
        What to write instead.
    """

    def __init__(self, message: str, column: int | None = None, help: str | None = None) -> None:
        super().__init__(message)
        self.message = message
        self.column = column
        self.help = help


def _truth(test: Callable[..., bool]) -> Callable[..., float]:
    return lambda *values: 1.0 if test(*values) else 0.0


def _sign(x: float) -> float:
    return 0.0 if x == 0.0 else math.copysign(1.0, x)


def _whole(rounding: Callable[[float], int]) -> Callable[[float], float]:
    """Round to a whole number, with the sign of zero that C gives."""
    return lambda x: math.copysign(float(rounding(x)), x)


def _minimum(x: float, y: float) -> float:
    return y if y < x else x


def _maximum(x: float, y: float) -> float:
    return y if y > x else x


def _in_core(name: str) -> Callable[..., float]:
    """Let the core calculate an elementary function: every machine then builds the same model."""
    return lambda *values: in_core(name)(*values)


OPERATIONS: dict[str, Callable[..., float]] = {
    "add": operator.add,
    "sub": operator.sub,
    "mul": operator.mul,
    "div": operator.truediv,
    "pow": _in_core("pow"),
    "neg": lambda x: -x,
    "sin": _in_core("sin"),
    "cos": _in_core("cos"),
    "tan": _in_core("tan"),
    "asin": _in_core("asin"),
    "acos": _in_core("acos"),
    "atan": _in_core("atan"),
    "atan2": _in_core("atan2"),
    "sqrt": math.sqrt,
    "exp": _in_core("exp"),
    "log": _in_core("log"),
    "sinh": _in_core("sinh"),
    "cosh": _in_core("cosh"),
    "tanh": _in_core("tanh"),
    "abs": math.fabs,
    "floor": _whole(math.floor),
    "ceil": _whole(math.ceil),
    "mod": operator.mod,
    "min": _minimum,
    "max": _maximum,
    "sign": _sign,
    "lt": _truth(operator.lt),
    "le": _truth(operator.le),
    "gt": _truth(operator.gt),
    "ge": _truth(operator.ge),
    "eq": _truth(operator.eq),
    "ne": _truth(operator.ne),
    "and": _truth(lambda x, y: x != 0.0 and y != 0.0),
    "or": _truth(lambda x, y: x != 0.0 or y != 0.0),
    "not": _truth(lambda x: x == 0.0),
    "select": lambda condition, x, y: x if condition != 0.0 else y,
}
"""Operation by name. ``select(condition, x, y)`` is x where the condition is true, else y;
``mod(x, y)`` is what x exceeds a multiple of y by, with the sign of y."""

FUNCTIONS: dict[str, int] = {
    "sin": 1, "cos": 1, "tan": 1, "asin": 1, "acos": 1, "atan": 1, "atan2": 2,
    "sqrt": 1, "exp": 1, "log": 1, "sinh": 1, "cosh": 1, "tanh": 1, "abs": 1, "min": 2, "max": 2,
    "sign": 1, "floor": 1, "ceil": 1, "mod": 2,
}  # fmt: skip
"""Functions a scene may call, with their number of arguments (at least two for min and max)."""

MECHANISM_FUNCTIONS: dict[str, int] = {"distance": 2}
"""Functions of named parts, possible where their positions are: ``distance(A, B)``."""

INFIX: dict[str, str] = {
    "add": "+", "sub": "-", "mul": "*", "div": "/", "pow": "**",
    "lt": "<", "le": "<=", "gt": ">", "ge": ">=", "eq": "==", "ne": "!=",
    "and": "and", "or": "or",
}  # fmt: skip
"""How an operation on two numbers is written."""


def written(op: str, args: tuple[str, ...]) -> str:
    """Text of one operation, given the texts of its arguments."""
    if op in INFIX:
        return f"({args[0]} {INFIX[op]} {args[1]})"
    if op == "neg":
        return f"(-{args[0]})"
    if op == "not":
        return f"(not {args[0]})"
    if op == "select":
        return f"({args[1]} if {args[0]} else {args[2]})"
    return f"{op}({', '.join(args)})"


def apply(op: str, *values: float) -> float:
    """Value of one operation.

    Raises
    ------
    ExpressionError
        When the result is not a finite real number.
    """
    try:
        value = OPERATIONS[op](*values)
    except ZeroDivisionError:
        value, reason = math.nan, "division by zero"
    except OverflowError:
        value, reason = math.nan, "larger than any floating-point number"
    except ValueError:
        value, reason = math.nan, "no real value"
    else:
        pole = op == "log" or (op == "pow" and values[0] == 0.0)
        reason = (
            "no real value"
            if pole or math.isnan(value)
            else "larger than any floating-point number"
        )
    if not math.isfinite(value):
        text = written(
            op, tuple(f"({v:g})" if v < 0.0 and op in INFIX else f"{v:g}" for v in values)
        )
        message = f"{text[1:-1] if text.startswith('(') else text}: {reason}"
        raise ExpressionError(message)
    return value
