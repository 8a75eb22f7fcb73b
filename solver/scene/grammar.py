"""Reader of expression text: Python's own grammar, cut down to arithmetic.

The text becomes an abstract syntax tree (``ast.parse``), and that tree is translated node by node
into numbers; whatever has no translation is an error. Nothing is ever run as Python.
"""

from __future__ import annotations

import ast
import re
import warnings
from collections.abc import Mapping
from dataclasses import dataclass
from difflib import get_close_matches
from typing import Any, Literal, NamedTuple, NoReturn

from solver.scene.expression import (
    FUNCTIONS,
    MECHANISM_FUNCTIONS,
    Curve,
    Expr,
    ExpressionError,
    Number,
    operate,
    symbol,
)
from solver.scene.substitution import in_one_line, put_texts_for_names

CONSTANTS = {"pi": 3.141592653589793}

_BINARY: dict[type[ast.AST], str] = {
    ast.Add: "add", ast.Sub: "sub", ast.Mult: "mul", ast.Div: "div", ast.Pow: "pow",
    ast.Lt: "lt", ast.LtE: "le", ast.Gt: "gt", ast.GtE: "ge", ast.Eq: "eq", ast.NotEq: "ne",
    ast.And: "and", ast.Or: "or",
}  # fmt: skip

_CHAINS = {"add": "sub", "sub": "add", "mul": "div", "div": "mul"}
"""Operations that stand beside each other without brackets."""
_MANY = ("and", "or", "min", "max", "add", "mul")
"""Operations whose operands may be grouped in any way."""

MOST_OPERATIONS, MOST_NESTED = 1000, 50
"""Operations of an expression, and how many of them within each other; sums, products and the
arguments of a function count once for the depth, however many there are."""
_TOO_LARGE = f"more than {MOST_OPERATIONS} operations, or {MOST_NESTED} within each other"
_SHORT = 16
"""Terms that are added one after the other; longer sums are halved, so that they are not deep."""

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
    within: tuple[str, ...] = ()
    """Named expressions that stand for it in the text, the outermost first."""


class ParsedNumber(NamedTuple):
    """A number together with every name mentioned in its text, folded away or not."""

    given: str | float
    """As it stands in the file."""
    number: Number
    mentions: tuple[Mention, ...] = ()
    named: frozenset[str] = frozenset()
    """Named expressions whose texts stand in it."""
    unit: str = ""
    """Unit that the file writes behind the number, which is in SI here."""

    @property
    def text(self) -> str:
        """The number as text."""
        return str(self.given)

    @property
    def is_constant(self) -> bool:
        """Whether it is a plain number, which may stand anywhere."""
        return not self.mentions and not self.named and isinstance(self.number, float)


def parse(text: str) -> Number:
    """Read an expression.

    Raises
    ------
    ExpressionError
        With the column, when the text is not an expression or a constant part has no value.
    """
    return read(text).number


def read(
    text: str,
    profiles: Mapping[str, Curve] | None = None,
    expressions: Mapping[str, str] | None = None,
) -> ParsedNumber:
    """Read an expression, which may call `profiles`, and note every name; raises like ``parse``.

    Names of `expressions` stand for their texts, in brackets.
    """
    stripped = in_one_line(text)
    if not stripped or "\0" in stripped or not is_readable(stripped):
        message = "not a readable text" if stripped else "empty expression"
        raise ExpressionError(message, 1)
    translator = _Translator(stripped, len(text) - len(text.lstrip()), profiles or {})
    translator.texts = expressions or {}
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # Python's remarks on style, such as '1if x else 2'
            tree = ast.parse(stripped, mode="eval")
            if expressions:
                put_texts_for_names(tree, expressions, translator.within)
        if (len(stripped) > MOST_NESTED or translator.within) and not _is_of_size(tree.body):
            raise RecursionError
        number = translator.number(tree.body)
    except SyntaxError as error:
        column = translator.indent + min(error.offset or len(stripped) + 1, len(stripped) + 1)
        raise ExpressionError(_plain(error.msg), column) from None
    except (RecursionError, MemoryError):
        with_them = "with the expressions that it mentions, " if translator.within else ""
        message = f"{with_them}{_TOO_LARGE}"
        raise ExpressionError(message, 1, "split it into several parameters") from None
    named = frozenset(name for names in translator.within.values() for name in names)
    return ParsedNumber(text, number, tuple(translator.mentions), named)


def is_readable(text: str) -> bool:
    """Whether a text has whole characters alone; JSON can write halves of one, as surrogates."""
    return text.isascii() or not re.search("[\ud800-\udfff]", text)


def _chain(node: ast.expr) -> tuple[ast.expr, list[tuple[ast.BinOp, str]]]:
    """First operand of a sum or product, and the operations that follow it."""
    links: list[tuple[ast.BinOp, str]] = []
    while isinstance(node, ast.BinOp) and (op := _BINARY.get(type(node.op), "")) in _CHAINS:
        if links and links[0][1] not in (op, _CHAINS[op]):
            break
        links.append((node, op))
        node = node.left
    return node, links[::-1]


def _operands(node: ast.expr) -> list[ast.expr]:
    first, links = _chain(node)
    if links:
        return [first, *(link.right for link, _ in links)]
    if isinstance(node, ast.Call):
        return [] if getattr(node.func, "id", "") in MECHANISM_FUNCTIONS else node.args
    children = () if isinstance(node, ast.Attribute) else ast.iter_child_nodes(node)
    return [child for child in children if isinstance(child, ast.expr)]


def _is_of_size(node: ast.expr) -> bool:
    """Whether an expression keeps the limits of size and depth."""
    level, size = [node], 0
    for _ in range(MOST_NESTED + 1):
        operands = [found for each in level if (found := _operands(each))]
        size += sum(max(len(found) - 1, 1) for found in operands)
        level = [operand for found in operands for operand in found]
        if not level or size > MOST_OPERATIONS:
            return size <= MOST_OPERATIONS
    return False


def _plain(message: str) -> str:
    """Python's message in our words: the first clause, without advice meant for programs."""
    if message.startswith(("invalid syntax", "f-string", "cannot assign", "expression cannot")):
        return "not an expression"
    if message.startswith("Exceeds the limit"):
        return "number larger than any floating-point number"
    if message.startswith("invalid decimal literal"):
        return "a number with letters behind it, which are no unit that is known here"
    return re.split(r"[.;] |\. Did", message)[0]


class _Translator:
    """Translation of one syntax tree; notes names as it passes them."""

    def __init__(self, text: str, indent: int, profiles: Mapping[str, Curve]) -> None:
        self.text = text
        self.indent = indent
        self.profiles = profiles
        self.texts: Mapping[str, str] = {}
        self.within: dict[ast.expr, tuple[str, ...]] = {}
        """In which named expressions nodes are that stand in the place of their names."""
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
            case ast.BinOp(left=left, op=ast.Pow(), right=right):
                return self.operate(node, "pow", left, right)
            case ast.BinOp(op=op) if type(op) in _BINARY:
                first, links = _chain(node)
                return self.joined(
                    self.number(first), [(link, op, self.number(link.right)) for link, op in links]
                )
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
        words: list[str] = []
        while isinstance(node, ast.Attribute):
            words.insert(0, node.attr)
            node = node.value
        if isinstance(node, ast.Name):
            return ".".join([node.id, *words])
        raise self.error(node, "only a name can stand before or after a dot")

    def symbol(self, node: ast.expr) -> Number:
        name = self.name(node)
        if name in CONSTANTS:
            return CONSTANTS[name]
        self.mention(node, name)
        return symbol(name)

    def operate(self, node: ast.AST, op: str, *operands: ast.expr) -> Number:
        """Apply an operation to operands that are still to be translated."""
        return self.combine(node, op, [self.number(operand) for operand in operands])

    def joined(self, first: Number, terms: list[tuple[ast.BinOp, str, Number]]) -> Number:
        """Translate a sum or product; a long one as that of what is added less what is not."""
        if len(terms) <= _SHORT:
            for node, op, number in terms:
                first = self.combine(node, op, [first, number])
            return first
        (node, op, _), *_ = terms
        whole, less = ("add", "sub") if op in ("add", "sub") else ("mul", "div")
        total = self.combine(node, whole, [first, *(x for _, op, x in terms if op == whole)])
        rest = [x for _, op, x in terms if op == less]
        return self.combine(node, less, [total, self.combine(node, whole, rest)]) if rest else total

    def combine(self, node: ast.AST, op: str, numbers: list[Any]) -> Number:
        """Apply an operation; one of two operands to any number of them, in halves."""
        try:
            if op in _MANY and len(numbers) > 2:
                half = (len(numbers) + 1) // 2
                return operate(
                    op, *(self.combine(node, op, numbers[k : k + half]) for k in (0, half))
                )
            return numbers[0] if op in _MANY and len(numbers) == 1 else operate(op, *numbers)
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
        known = FUNCTIONS | MECHANISM_FUNCTIONS | dict.fromkeys(self.profiles, 1)
        if name not in known:
            close = get_close_matches(name, known, 1)
            help = f"did you mean '{close[0]}'? " if close else ""
            help += f"functions: {', '.join(known)}"
            if name in self.texts:
                help = f"'{name}' is an expression: write {name} without brackets"
            raise self.error(node, f"unknown function '{name}'", help)
        count, wanted = len(node.args), known[name]
        many = name in ("min", "max")
        if node.keywords or count < wanted or (count > wanted and not many):
            words = f"{'at least ' if many else ''}{wanted} argument{'s' if wanted > 1 else ''}"
            raise self.error(node, f"{name}() takes {words}, got {count + len(node.keywords)}")
        if name in FUNCTIONS:
            return self.operate(node, name, *node.args)
        if name in self.profiles:
            return self.combine(node, "spline", [self.number(node.args[0]), self.profiles[name]])
        parts = [self.name(part) for part in node.args]
        self.mention(node, name, "function")
        for part, argument in zip(parts, node.args, strict=True):
            self.mention(argument, part, "part")
        return Expr("call", (name, *parts))

    def mention(
        self, node: ast.expr, name: str, role: Literal["symbol", "function", "part"] = "symbol"
    ) -> None:
        """Note a name that stands in the text, or in that of a named expression."""
        self.mentions.append(Mention(name, self.column(node), role, self.within.get(node, ())))
