"""Reader of expression text: Python's own grammar, cut down to arithmetic.

The text becomes an abstract syntax tree (``ast.parse``), and that tree is translated node by node
into numbers; whatever has no translation is an error. Nothing is ever run as Python.
"""

from __future__ import annotations

import ast
import re
import warnings
from dataclasses import dataclass
from difflib import get_close_matches
from typing import Literal, NamedTuple, NoReturn

from solver.scene.operations import FUNCTIONS, MECHANISM_FUNCTIONS, ExpressionError
from solver.scene.tree import Expr, Number, operate, symbol

CONSTANTS = {"pi": 3.141592653589793}

_BINARY: dict[type[ast.AST], str] = {
    ast.Add: "add", ast.Sub: "sub", ast.Mult: "mul", ast.Div: "div", ast.Pow: "pow",
    ast.Lt: "lt", ast.LtE: "le", ast.Gt: "gt", ast.GtE: "ge", ast.Eq: "eq", ast.NotEq: "ne",
    ast.And: "and", ast.Or: "or",
}  # fmt: skip

_REFUSED: dict[type[ast.AST], tuple[str, str | None]] = {
    ast.BitXor: ("operator '^' is not available", "write ** for a power"),
    ast.FloorDiv: ("operator '//' is not available", "write floor(x / y)"),
    ast.Mod: ("operator '%' is not available", "write mod(x, y)"),
    ast.MatMult: ("operator '@' is not available", None),
    ast.BitAnd: ("operator '&' is not available", "write 'and'"),
    ast.BitOr: ("operator '|' is not available", "write 'or'"),
    ast.Subscript: ("square brackets are not available", None),
    ast.Tuple: ("a comma is possible only between the arguments of a function", None),
    ast.List: ("square brackets are not available", None),
    ast.Lambda: ("'lambda' is not available", None),
}


@dataclass(frozen=True, slots=True)
class Mention:
    """A name as it stands in the text: a symbol, or distance, A or B of distance(A, B)."""

    name: str
    column: int
    role: Literal["symbol", "function", "part"] = "symbol"


class Reading(NamedTuple):
    """A number together with every name mentioned in its text, folded away or not."""

    given: str | float
    """As it stands in the file."""
    number: Number
    mentions: tuple[Mention, ...] = ()

    @property
    def text(self) -> str:
        """The number as text."""
        return str(self.given)

    @property
    def is_constant(self) -> bool:
        """Whether it is a plain number, which may stand anywhere."""
        return not self.mentions and isinstance(self.number, float)


def parse(text: str) -> Number:
    """Read an expression.

    Raises
    ------
    ExpressionError
        With the column, when the text is not an expression or a constant part has no value.
    """
    return read(text).number


def read(text: str) -> Reading:
    """Read an expression and note every name in it; raises like ``parse``."""
    stripped = re.sub(r"\s", " ", text).strip()
    if not stripped or "\0" in stripped:
        message = "not a readable text" if stripped else "empty expression"
        raise ExpressionError(message, 1)
    reader = _Reader(stripped, len(text) - len(text.lstrip()))
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # Python's remarks on style, such as '1if x else 2'
            tree = ast.parse(stripped, mode="eval")
        number = reader.number(tree.body)
    except SyntaxError as error:
        column = reader.indent + min(error.offset or len(stripped) + 1, len(stripped) + 1)
        raise ExpressionError(_plain(error.msg), column) from None
    except (RecursionError, MemoryError):
        message = "nested too deeply"
        raise ExpressionError(message, 1, "split it into several parameters") from None
    return Reading(text, number, tuple(reader.mentions))


def _plain(message: str) -> str:
    """Python's message in our words: the first clause, without advice meant for programs."""
    if message.startswith(("invalid syntax", "f-string", "cannot assign", "expression cannot")):
        return "not an expression"
    if message.startswith("invalid decimal literal"):
        return "a number with letters behind it; a unit is not written here"
    return re.split(r"[.;] |\. Did", message)[0]


class _Reader:
    """Translation of one syntax tree; notes names as it passes them."""

    def __init__(self, text: str, indent: int) -> None:
        self.text = text
        self.indent = indent
        self.mentions: list[Mention] = []

    def number(self, node: ast.expr) -> Number:
        match node:
            case ast.Constant(value=value):
                return self.constant(node, value)
            case ast.Name() | ast.Attribute():
                return self.symbol(node)
            case ast.UnaryOp(op=ast.UAdd(), operand=operand):
                return self.number(operand)
            case ast.UnaryOp(op=ast.USub(), operand=operand):
                return self.operate(node, "neg", operand)
            case ast.UnaryOp(op=ast.Not(), operand=operand):
                return self.operate(node, "not", operand)
            case ast.BinOp(left=left, op=op, right=right) if type(op) in _BINARY:
                return self.operate(node, _BINARY[type(op)], left, right)
            case ast.BoolOp(op=op, values=values):
                return self.operate(node, _BINARY[type(op)], *values)
            case ast.Compare():
                return self.comparison(node)
            case ast.IfExp(test=test, body=body, orelse=orelse):
                return self.operate(node, "select", test, body, orelse)
            case ast.Call():
                return self.call(node)
        return self.refuse(node)

    def refuse(self, node: ast.expr) -> NoReturn:
        key = type(node.op) if isinstance(node, (ast.BinOp, ast.UnaryOp)) else type(node)
        message, help = _REFUSED.get(key, ("only arithmetic is possible here", None))
        raise self.error(node, message, help)

    def error(self, node: ast.AST, message: str, help: str | None = None) -> ExpressionError:
        return ExpressionError(message, self.column(node), help)

    def column(self, node: ast.AST) -> int:
        """Column from 1, in characters (``ast`` counts bytes)."""
        before = self.text.encode()[: getattr(node, "col_offset", 0)]
        return self.indent + len(before.decode(errors="ignore")) + 1

    def constant(self, node: ast.expr, value: object) -> Number:
        if isinstance(value, bool) or not isinstance(value, (int, float)):
            raise self.error(node, f"{value!r} is not a real number")
        try:
            number = float(value)
        except OverflowError:
            number = float("inf")
        if number == float("inf"):
            raise self.error(node, "number larger than any floating-point number")
        return number

    def name(self, node: ast.expr) -> str:
        """Read a dotted name, such as ``A.x``."""
        if isinstance(node, ast.Name):
            return node.id
        if isinstance(node, ast.Attribute):
            return f"{self.name(node.value)}.{node.attr}"
        raise self.error(node, "only a name can stand before or after a dot")

    def symbol(self, node: ast.expr) -> Number:
        name = self.name(node)
        if name in CONSTANTS:
            return CONSTANTS[name]
        self.mentions.append(Mention(name, self.column(node)))
        return symbol(name)

    def operate(self, node: ast.AST, op: str, *operands: ast.expr) -> Number:
        """Apply an operation of two operands from left to right to any number of them."""
        return self.combine(node, op, [self.number(operand) for operand in operands])

    def combine(self, node: ast.AST, op: str, numbers: list[Number]) -> Number:
        try:
            if op in ("and", "or", "min", "max"):
                result = numbers[0]
                for number in numbers[1:]:
                    result = operate(op, result, number)
                return result
            return operate(op, *numbers)
        except ExpressionError as error:
            raise self.error(node, error.message) from None

    def comparison(self, node: ast.Compare) -> Number:
        """Translate ``a < b <= c`` as ``a < b and b <= c``."""
        if not all(type(op) in _BINARY for op in node.ops):
            raise self.error(node, "comparisons are < <= > >= == !=")
        values = [self.number(operand) for operand in (node.left, *node.comparators)]
        tests = [
            self.combine(node, _BINARY[type(op)], [x, y])
            for op, x, y in zip(node.ops, values, values[1:], strict=False)
        ]
        return self.combine(node, "and", tests)

    def call(self, node: ast.Call) -> Number:
        name = self.name(node.func)
        known = FUNCTIONS | MECHANISM_FUNCTIONS
        if name not in known:
            close = get_close_matches(name, known, 1)
            help = f"did you mean '{close[0]}'? " if close else ""
            help += f"functions: {', '.join(known)}"
            raise self.error(node, f"unknown function '{name}'", help)
        count, wanted = len(node.args), known[name]
        many = name in ("min", "max")
        if node.keywords or count < wanted or (count > wanted and not many):
            words = f"{'at least ' if many else ''}{wanted} argument{'s' if wanted > 1 else ''}"
            raise self.error(node, f"{name}() takes {words}, got {count + len(node.keywords)}")
        if name in FUNCTIONS:
            return self.operate(node, name, *node.args)
        parts = [self.name(part) for part in node.args]
        columns = [self.column(part) for part in node.args]
        self.mentions.append(Mention(name, self.column(node), "function"))
        self.mentions += [Mention(p, c, "part") for p, c in zip(parts, columns, strict=True)]
        return Expr("call", (name, *parts))
