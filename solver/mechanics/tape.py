"""Compiles expressions to the kernel's tape: scalar operations on one vector of numbers.

Three segments: what depends on fixed parameters alone, what also depends on time, inputs or tunable
parameters, and what depends on measurements. Equal subexpressions are computed once.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from enum import IntEnum

from solver.scene import Expr, Number

CODES = (
    "copy", "add", "sub", "mul", "div", "pow", "neg", "sin", "cos", "tan", "asin", "acos", "atan",
    "atan2", "sqrt", "exp", "log", "abs", "min", "max", "sign", "lt", "le", "gt", "ge", "eq", "ne",
    "and", "or", "not", "select",
)  # fmt: skip
"""Operation codes in the order of ``solver/kernel/tape.c``."""

CODE = {name: code for code, name in enumerate(CODES)}


class Segment(IntEnum):
    """When an operation runs."""

    PARAMETERS = 0
    LAWS = 1
    OUTPUTS = 2


class Tape:
    """Compiler of expressions.

    Parameters
    ----------
    symbols : mapping of str to (int, Segment) or Number
        Where each symbol lies in the vector of numbers and when it is known, or what it stands for.
    calls : callable
        Returns the expression of a mechanism function such as ``distance(A, B)``.
    first : int
        First free place in the vector of numbers.
    """

    def __init__(
        self,
        symbols: Mapping[str, tuple[int, Segment] | Number],
        calls: Callable[[Expr], Number],
        first: int,
    ) -> None:
        self._symbols = symbols
        self._calls = calls
        self._first = first
        self._known: dict[Number, tuple[int, Segment]] = {}
        self.operations: dict[Segment, list[int]] = {segment: [] for segment in Segment}
        self.constants: dict[int, float] = {}
        """Constants by their place."""
        self.used: set[str] = set()
        """Symbols that were met."""

    @property
    def end(self) -> int:
        """First place behind all that the tape uses."""
        return self._first

    def _new(self) -> int:
        self._first += 1
        return self._first - 1

    def compile(self, number: Number) -> tuple[int, Segment]:
        """Return where a number's value will lie, and the segment that computes it."""
        if number not in self._known:
            self._known[number] = self._compile(number)
        return self._known[number]

    def _compile(self, number: Number) -> tuple[int, Segment]:
        if not isinstance(number, Expr):
            place = self._new()
            self.constants[place] = float(number)
            return place, Segment.PARAMETERS
        if number.op == "call":
            return self.compile(self._calls(number))
        if number.op == "symbol":
            name = str(number.args[0])
            self.used.add(name)
            found = self._symbols[name]
            return found if isinstance(found, tuple) else self.compile(found)
        arguments = [self.compile(arg) for arg in number.args if not isinstance(arg, str)]
        segment = max(segment for _, segment in arguments)
        places = [place for place, _ in arguments]
        target = self._new()
        self._emit(segment, number.op, target, places)
        return target, segment

    def _emit(self, segment: Segment, op: str, target: int, places: list[int]) -> None:
        padded = (places * 3)[:3] if len(places) < 2 else (places + places[-1:])[:3]
        self.operations[segment].extend((CODE[op], target, *padded))

    def write(self, target: int, number: Number) -> Segment:
        """Compile a number and have it copied to `target`; return the segment."""
        place, segment = self.compile(number)
        self._emit(segment, "copy", target, [place])
        return segment
