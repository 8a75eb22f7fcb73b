"""Numbers of a scene: floats, or expression trees that are known once parameters or the motion are.

    Expr(op, args),    op(args) = x + y, sin(x), x if c else y, ...

One table has one meaning per operation. Every operation takes finite floats and either returns a
finite float or raises ``ExpressionError``: no NaN and no infinity ever enters a scene. Truth is
1.0, falsehood is 0.0, and every number but zero counts as true. Constants fold as a tree is built,
so a scene without parameters yields plain floats; trees are evaluated in plain Python.
"""

from __future__ import annotations

import math
import operator
from array import array
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import Any, NamedTuple, NoReturn, TypeAlias

from solver.runtime.kernel import in_core

# ----------------------------------------------------------------------------------- operations


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


def _whole(rounding: Callable[[float], int]) -> Callable[[float], float]:
    """Round to a whole number, with the sign of zero that C gives."""
    return lambda x: math.copysign(float(rounding(x)), x)


def _in_core(name: str) -> Callable[..., float]:
    """Let the core calculate an elementary function: every machine then builds the same model."""
    return lambda *values: in_core(name)(*values)


class Curve(NamedTuple):
    """Numbers of a profile, in the form of ``solver/kernel/tape/spline.c``: operand of a spline."""

    name: str
    numbers: Sequence[float]

    def __format__(self, _: str) -> str:
        return self.name

    def __str__(self) -> str:
        return self.name


class Grid(Curve):
    """Numbers of a spline of three coordinates, in the form of ``solver/kernel/tape/grid.c``.

    They are an array, of up to a million; two grids are equal if they share it.
    """

    __slots__ = ()

    def __hash__(self) -> int:
        return id(self.numbers)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Grid) and self.numbers is other.numbers

    def __ne__(self, other: object) -> bool:
        return not self == other


_SPLINES = ("spline", "spline_slope", "spline_curvature")
_GRIDS = ("grid", "grid_x", "grid_y", "grid_z")


def _spline(name: str) -> Callable[..., float]:
    return lambda x, table: in_core(name)(x, *table.numbers)


def _grid(name: str) -> Callable[..., float]:
    return lambda x, y, z, table: in_core(name)(array("d", (x, y, z)) + table.numbers)


_ELEMENTARY = (
    *("pow", "exp", "log", "sin", "cos", "tan", "asin", "acos", "atan", "atan2"),
    *("sinh", "cosh", "tanh"),
)

OPERATIONS: dict[str, Callable[..., float]] = {
    **{name: _in_core(name) for name in _ELEMENTARY},
    "add": operator.add,
    "sub": operator.sub,
    "mul": operator.mul,
    "div": operator.truediv,
    "neg": operator.neg,
    "sqrt": math.sqrt,
    "abs": math.fabs,
    "floor": _whole(math.floor),
    "ceil": _whole(math.ceil),
    "mod": operator.mod,
    "min": lambda x, y: y if y < x else x,
    "max": lambda x, y: y if y > x else x,
    "sign": lambda x: 0.0 if x == 0.0 else math.copysign(1.0, x),
    **{name: _truth(getattr(operator, name)) for name in ("lt", "le", "gt", "ge", "eq", "ne")},
    "and": _truth(lambda x, y: x != 0.0 and y != 0.0),
    "or": _truth(lambda x, y: x != 0.0 or y != 0.0),
    "not": _truth(lambda x: x == 0.0),
    "select": lambda condition, x, y: x if condition != 0.0 else y,
    **{name: _spline(name) for name in _SPLINES},
    **{name: _grid(name) for name in _GRIDS},
}
"""Operation by name. ``select(condition, x, y)`` is x where the condition is true, else y;
``mod(x, y)`` is what x exceeds a multiple of y by, with the sign of y; ``spline(x, table)`` and its
two derivatives are those of a profile, ``grid(x, y, z, table)`` and its three those of a grid."""

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
    if op in _SPLINES:
        return args[1] + "'" * _SPLINES.index(op) + f"({args[0]})"
    if op in _GRIDS:
        return f"{args[-1]}{op.removeprefix('grid')}({', '.join(args[:-1])})"
    return f"{op}({', '.join(args)})"


def apply(op: str, *values: Any) -> float:
    """Value of one operation.

    Raises
    ------
    ExpressionError
        When the result is not a finite real number.
    """
    value, reason = math.nan, "no real value"
    try:
        value = OPERATIONS[op](*values)
    except ZeroDivisionError:
        reason = "division by zero"
    except OverflowError:
        reason = _TOO_LARGE
    except ValueError:
        pass
    if math.isfinite(value):
        return value
    if math.isinf(value) and op != "log" and not (op == "pow" and values[0] == 0.0):
        reason = _TOO_LARGE
    shown = (f"({v:g})" if op in INFIX and v < 0.0 else f"{v:g}" for v in values)
    text = written(op, tuple(shown))
    message = f"{text[1:-1] if text.startswith('(') else text}: {reason}"
    raise ExpressionError(message)


_TOO_LARGE = "larger than any floating-point number"


# ---------------------------------------------------------------------------------------- trees


def _operators(
    op: str,
) -> tuple[Callable[[Expr, Number], Number], Callable[[Expr, Number], Number]]:
    """Return an operator of Python, and the same with the operands in the other order."""
    return lambda x, y: operate(op, x, y), lambda x, y: operate(op, y, x)


class Expr:
    """One operation on numbers: an immutable, hashable tree.

    Attributes
    ----------
    op : str
        "symbol", "call", or a name of ``OPERATIONS``.
    args : tuple
        Operands, each a float, an ``Expr`` or a ``Curve``. Of a symbol: its name. Of a call: the
        mechanism function and the names of its parts, ``("distance", "A", "B")``.
    mentions : frozenset of str
        Its symbols, and its calls as text.
    """

    __slots__ = ("_hash", "args", "mentions", "op")

    op: str
    args: tuple[Operand | str, ...]
    mentions: frozenset[str]

    def __init__(self, op: str, args: tuple[Operand | str, ...]) -> None:
        object.__setattr__(self, "op", op)
        object.__setattr__(self, "args", args)
        object.__setattr__(self, "_hash", hash((op, args)))
        if op in ("symbol", "call"):
            mentions = frozenset([str(self)])
        else:
            mentions = frozenset().union(*(x.mentions for x in args if isinstance(x, Expr)))
        object.__setattr__(self, "mentions", mentions)

    def __setattr__(self, name: str, value: object) -> NoReturn:
        message = f"Expr is immutable: {name} cannot be set to {value!r}"
        raise AttributeError(message)

    def __reduce__(self) -> tuple[type[Expr], tuple[object, ...]]:
        return Expr, (self.op, self.args)

    def __hash__(self) -> int:
        return self._hash

    def __eq__(self, other: object) -> bool:
        if self is other:
            return True
        if not isinstance(other, Expr):
            return False
        pending: list[tuple[Expr, Expr]] = [(self, other)]
        while pending:  # and no recursion, as trees may be deeper than Python's stack
            one, two = pending.pop()
            if one._hash != two._hash or one.op != two.op or len(one.args) != len(two.args):
                return False
            for x, y in zip(one.args, two.args, strict=True):
                if isinstance(x, Expr) and isinstance(y, Expr):
                    pending += [(x, y)] if x is not y else []
                elif x != y:
                    return False
        return True

    def __bool__(self) -> NoReturn:
        message = f"the truth of {self} is known only once its symbols have values; use select()"
        raise TypeError(message)

    def __repr__(self) -> str:
        return f"Expr({str(self)!r})"

    def __str__(self) -> str:
        if self.op == "symbol":
            return str(self.args[0])
        if self.op == "call":
            return f"{self.args[0]}({', '.join(str(name) for name in self.args[1:])})"
        return written(self.op, tuple(_text(arg) for arg in self.args))

    __add__, __radd__ = _operators("add")
    __sub__, __rsub__ = _operators("sub")
    __mul__, __rmul__ = _operators("mul")
    __truediv__, __rtruediv__ = _operators("div")
    __pow__, __rpow__ = _operators("pow")

    def __neg__(self) -> Number:
        return operate("neg", self)


Number: TypeAlias = float | Expr
"""A number of the scene: known now (float) or once the parameters are (Expr)."""

Operand: TypeAlias = Number | Curve
"""What operations take."""

Vector: TypeAlias = tuple[Number, ...]
"""As many numbers as the scene has dimensions."""


def _text(arg: Operand | str) -> str:
    return f"({arg!r})" if isinstance(arg, float) and str(arg).startswith("-") else str(arg)


def symbol(name: str) -> Expr:
    """Expression that stands for the value called `name`, such as ``length`` or ``A.x``."""
    return Expr("symbol", (name,))


def operate(op: str, *args: Operand) -> Number:
    """Apply an operation; constants fold at once, and so do its neutral elements.

    Parameters
    ----------
    op : str
        Name of an operation in ``OPERATIONS``.
    *args : float, Expr or Curve
        Its operands.

    Returns
    -------
    float or Expr
        A float when the value is known, else an expression with the same value.

    Raises
    ------
    ExpressionError
        When the value is known and not a finite real number.
    """
    numbers: tuple[Any, ...] = tuple(
        arg if isinstance(arg, (Expr, Curve)) else float(arg) for arg in args
    )
    if not any(isinstance(number, Expr) for number in numbers):
        return apply(op, *numbers)
    if op == "select" and isinstance(numbers[0], float):
        return numbers[1] if numbers[0] != 0.0 else numbers[2]
    folded = _neutral(op, *numbers) if op in ("add", "sub", "mul", "div", "pow", "neg") else None
    return Expr(op, numbers) if folded is None else folded


def _neutral(op: str, x: Number, y: Number = 0.0) -> Number | None:
    """Fold x + 0, x - 0, x*1, x*0, x/1, 0/x, x**1, x**0 and --x; None where nothing folds.

    An Expr is never equal to a float, so each comparison also asks whether the operand is known.
    """
    if op == "neg":
        return x.args[0] if isinstance(x, Expr) and x.op == "neg" else None  # pyright: ignore[reportReturnType]
    if y == {"add": 0.0, "sub": 0.0, "mul": 1.0, "div": 1.0, "pow": 1.0}[op]:
        return x
    if op == "mul" and (x == 0.0 or y == 0.0):
        return 0.0
    if op == "div" and x == 0.0:
        return 0.0
    if op == "pow" and y == 0.0:
        return 1.0
    if (op == "add" and x == 0.0) or (op == "mul" and x == 1.0):
        return y
    if op == "sub" and x == 0.0:
        return operate("neg", y)
    return None


sin, cos, atan2, sqrt, log, sign = (
    partial(operate, name) for name in ("sin", "cos", "atan2", "sqrt", "log", "sign")
)
"""Functions of numbers: angles are in rad, ``atan2(y, x)`` is that of the vector (x, y)."""


def select(condition: Number, x: Number, y: Number) -> Number:
    """Return x where the condition is not zero, else y; ``x if condition else y`` in a scene."""
    return operate("select", condition, x, y)


def symbols(number: Number) -> frozenset[str]:
    """Names of all symbols in a number, and its calls as text, such as ``distance(A, B)``."""
    return number.mentions if isinstance(number, Expr) else frozenset()


def curves_of(number: object) -> set[str]:
    """Return the names of the profiles that a number calls."""
    found, pending, seen = set[str](), [number], set[int]()
    while pending:
        node = pending.pop()
        if isinstance(node, Curve):
            found.add(node.name)
        elif isinstance(node, Expr) and id(node) not in seen:
            seen.add(id(node))
            pending += node.args
    return found


def evaluate(number: Number, values: Mapping[str, float]) -> float:
    """Value of a number.

    Parameters
    ----------
    number : float or Expr
        What to evaluate. Of a choice ``x if c else y`` only the chosen side is evaluated.
    values : mapping of str to float
        Value of each symbol, and of each mechanism function under its text, ``"distance(A, B)"``.

    Raises
    ------
    ExpressionError
        When an operation has no finite real value.
    KeyError
        When a symbol has no value.
    """
    if not isinstance(number, Expr):
        return number
    known: dict[int, float] = {}
    pending = [number]
    while pending:
        node = pending[-1]
        op, args = node.op, node.args
        if op in ("symbol", "call"):
            known[id(pending.pop())] = float(values[str(node)])
            continue
        if op == "select":  # first the condition, then the chosen side
            condition, *sides = args
            decided = known.get(id(condition)) if isinstance(condition, Expr) else condition
            args = (condition,) if decided is None else (sides[0] if decided else sides[1],)
        missing = [arg for arg in args if isinstance(arg, Expr) and id(arg) not in known]
        if missing:
            pending.extend(missing)
            continue
        numbers: list[Any] = [known[id(arg)] if isinstance(arg, Expr) else arg for arg in args]
        known[id(pending.pop())] = numbers[0] if op == "select" else apply(op, *numbers)
    return known[id(number)]
