"""Expression trees: numbers that are known only once parameters, inputs or the motion are.

    Expr(op, args),    op(args) = x + y, sin(x), x if c else y, ...

Constants fold as a tree is built, so a scene without parameters yields plain floats.
"""

from __future__ import annotations

from typing import NoReturn, TypeAlias

from solver.scene.operations import apply, written


class Expr:
    """One operation on numbers: an immutable, hashable tree.

    Attributes
    ----------
    op : str
        "symbol", "call", or a name of ``operations.OPERATIONS``.
    args : tuple
        Operands, each a float or an ``Expr``. Of a symbol: its name. Of a call: the mechanism
        function and the names of its parts, ``("distance", "A", "B")``.
    mentions : frozenset of str
        Its symbols, and its calls as text.
    """

    __slots__ = ("_hash", "args", "mentions", "op")

    op: str
    args: tuple[Number | str, ...]
    mentions: frozenset[str]

    def __init__(self, op: str, args: tuple[Number | str, ...]) -> None:
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

    def __add__(self, other: Number) -> Number:
        return operate("add", self, other)

    def __radd__(self, other: Number) -> Number:
        return operate("add", other, self)

    def __sub__(self, other: Number) -> Number:
        return operate("sub", self, other)

    def __rsub__(self, other: Number) -> Number:
        return operate("sub", other, self)

    def __mul__(self, other: Number) -> Number:
        return operate("mul", self, other)

    def __rmul__(self, other: Number) -> Number:
        return operate("mul", other, self)

    def __truediv__(self, other: Number) -> Number:
        return operate("div", self, other)

    def __rtruediv__(self, other: Number) -> Number:
        return operate("div", other, self)

    def __pow__(self, other: Number) -> Number:
        return operate("pow", self, other)

    def __rpow__(self, other: Number) -> Number:
        return operate("pow", other, self)

    def __neg__(self) -> Number:
        return operate("neg", self)


Number: TypeAlias = float | Expr
"""A number of the scene: known now (float) or once the parameters are (Expr)."""

Vector: TypeAlias = tuple[Number, ...]
"""As many numbers as the scene has dimensions."""


def _text(arg: Number | str) -> str:
    return f"({arg!r})" if isinstance(arg, float) and str(arg).startswith("-") else str(arg)


def symbol(name: str) -> Expr:
    """Expression that stands for the value called `name`, such as ``length`` or ``A.x``."""
    return Expr("symbol", (name,))


def operate(op: str, *args: Number) -> Number:
    """Apply an operation; constants fold at once, and so do its neutral elements.

    Parameters
    ----------
    op : str
        Name of an operation in ``operations.OPERATIONS``.
    *args : float or Expr
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
    numbers = tuple(arg if isinstance(arg, Expr) else float(arg) for arg in args)
    if not any(isinstance(number, Expr) for number in numbers):
        return apply(op, *numbers)  # pyright: ignore[reportArgumentType]
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
