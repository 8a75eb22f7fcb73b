"""Expressions of a scene: what they are built from, their text, their symbols, their value.

A number of the scene is a float or an ``Expr``. Text is read through Python's own grammar
(``ast``) and never run as Python; trees are evaluated in plain Python, operation by operation.
"""

from __future__ import annotations

from collections.abc import Mapping

from solver.scene.grammar import parse, read
from solver.scene.operations import ExpressionError, apply
from solver.scene.tree import Expr, Number, Vector, operate, symbol

__all__ = [
    "Expr",
    "ExpressionError",
    "Number",
    "Vector",
    "atan2",
    "cos",
    "evaluate",
    "log",
    "operate",
    "parse",
    "read",
    "select",
    "sign",
    "sin",
    "sqrt",
    "symbol",
    "symbols",
]


def sin(x: Number) -> Number:
    """Sine of an angle in rad."""
    return operate("sin", x)


def cos(x: Number) -> Number:
    """Cosine of an angle in rad."""
    return operate("cos", x)


def atan2(y: Number, x: Number) -> Number:
    """Angle in [-pi, pi] of the vector (x, y)."""
    return operate("atan2", y, x)


def sqrt(x: Number) -> Number:
    """Non-negative square root."""
    return operate("sqrt", x)


def log(x: Number) -> Number:
    """Natural logarithm."""
    return operate("log", x)


def sign(x: Number) -> Number:
    """-1, 0 or 1."""
    return operate("sign", x)


def select(condition: Number, x: Number, y: Number) -> Number:
    """Return x where the condition is not zero, else y; ``x if condition else y`` in a scene."""
    return operate("select", condition, x, y)


def symbols(number: Number) -> frozenset[str]:
    """Names of all symbols in a number, and its calls as text, such as ``distance(A, B)``."""
    return number.mentions if isinstance(number, Expr) else frozenset()


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
        missing = [arg for arg in _needed(node, known) if id(arg) not in known]
        if missing:
            pending.extend(missing)
            continue
        pending.pop()
        if node.op in ("symbol", "call"):
            known[id(node)] = float(values[str(node)])
        elif node.op == "select":
            known[id(node)] = _value(_chosen(node, known), known)
        else:
            known[id(node)] = apply(node.op, *(_value(arg, known) for arg in node.args))
    return known[id(number)]


def _value(arg: Number | str, known: Mapping[int, float]) -> float:
    return known[id(arg)] if isinstance(arg, Expr) else float(arg)


def _chosen(node: Expr, known: Mapping[int, float]) -> Number | str:
    return node.args[1] if _value(node.args[0], known) != 0.0 else node.args[2]


def _needed(node: Expr, known: Mapping[int, float]) -> list[Expr]:
    """Operands to evaluate before `node`; of a choice first the condition, then the chosen side."""
    args = node.args
    if node.op == "select":
        decided = not isinstance(args[0], Expr) or id(args[0]) in known
        args = (args[0], _chosen(node, known)) if decided else args[:1]
    return [arg for arg in args if isinstance(arg, Expr)]
