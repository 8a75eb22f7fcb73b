"""Compiles expressions to the kernel's tape: scalar operations on one vector of numbers.

Four segments: what depends on fixed parameters alone; what forces also need of time, inputs,
tunable parameters and sensors in the middle of a step; the signals at its end; and what outputs
need of the measurements. All may use the results of the first one and none those of another. Equal
subexpressions of a segment are computed once.
"""

from __future__ import annotations

from collections.abc import Callable
from enum import IntEnum

from solver.runtime.layout import CODES
from solver.scene import Expr, Number

CODE = {name: code for code, name in enumerate(CODES)}


class Segment(IntEnum):
    """When an operation runs."""

    PARAMETERS = 0
    LAWS = 1
    SIGNALS = 2
    OUTPUTS = 3


class Tape:
    """Compiler of expressions.

    Parameters
    ----------
    symbols : callable
        Returns where a symbol lies in the vector of numbers, and PARAMETERS if it is fixed; or the
        Number that it stands for.
    calls : callable
        Returns the expression of a mechanism function such as ``distance(A, B)``.
    first : int
        First free place in the vector of numbers.
    """

    def __init__(
        self,
        symbols: Callable[[str], tuple[int, Segment] | Number],
        calls: Callable[[Expr], Number],
        first: int,
    ) -> None:
        self._symbols = symbols
        self._calls = calls
        self._first = first
        self._known: dict[tuple[Number, Segment], tuple[int, Segment]] = {}
        self.operations: dict[Segment, list[int]] = {segment: [] for segment in Segment}
        self.constants: dict[int, float] = {}
        """Constants by their place."""
        self.used: dict[Segment, set[str]] = {segment: set() for segment in Segment}
        """Symbols that were met for each segment."""

    @property
    def end(self) -> int:
        """First place behind all that the tape uses."""
        return self._first

    def _new(self) -> int:
        self._first += 1
        return self._first - 1

    def compile(self, number: Number, wanted: Segment = Segment.LAWS) -> tuple[int, Segment]:
        """Return where a number's value will lie, and the segment that computes it.

        That is PARAMETERS for what depends on fixed parameters alone, else the segment `wanted`.
        """
        pending, found = [number], None
        while pending:  # and no recursion: parameters may be calculated from each other in a chain
            part = pending[-1]
            found = self._found(part, wanted)
            if found is None:
                operands = self._operands(part, wanted)
                places = [self._found(operand, wanted) for operand in operands]
                missing = [x for x, at in zip(operands, places, strict=True) if at is None]
                if missing:
                    pending += reversed(missing)
                    continue
                found = self._compile(part, [at for at in places if at], wanted)
                self._known[part, found[1]] = found
            pending.pop()
        assert found is not None
        return found

    def _found(self, number: Number, wanted: Segment) -> tuple[int, Segment] | None:
        known = self._known.get((number, Segment.PARAMETERS))
        return known or self._known.get((number, wanted))

    def _operands(self, number: Number, wanted: Segment) -> list[Number]:
        """Numbers that are compiled before this one."""
        if not isinstance(number, Expr):
            return []
        if number.op == "call":
            return [self._calls(number)]
        if number.op == "symbol":
            self.used[wanted].add(name := str(number.args[0]))
            meaning = self._symbols(name)
            return [] if isinstance(meaning, tuple) else [meaning]
        return [arg for arg in number.args if not isinstance(arg, str)]

    def _compile(
        self, number: Number, arguments: list[tuple[int, Segment]], wanted: Segment
    ) -> tuple[int, Segment]:
        """Compile a number whose operands lie at `arguments`."""
        if not isinstance(number, Expr):
            place = self._new()
            self.constants[place] = float(number)
            return place, Segment.PARAMETERS
        if number.op in ("call", "symbol") and arguments:
            return arguments[0]
        if number.op == "symbol":
            found = self._symbols(str(number.args[0]))
            assert isinstance(found, tuple)
            return found if found[1] is Segment.PARAMETERS else (found[0], wanted)
        segment = max(segment for _, segment in arguments)
        places = [place for place, _ in arguments]
        target = self._new()
        self._emit(segment, number.op, target, places)
        return target, segment

    def _emit(self, segment: Segment, op: str, target: int, places: list[int]) -> None:
        self.operations[segment].extend((CODE[op], target, *padded(places)))

    def write(self, target: int, number: Number, wanted: Segment = Segment.LAWS) -> Segment:
        """Compile a number and have it copied to `target`; return the segment."""
        place, segment = self.compile(number, wanted)
        self._emit(segment, "copy", target, [place])
        return segment

    def copy(self, number: Number) -> int:
        """Have a number of the laws copied to a place that nothing else writes; return it."""
        target = self._new()
        self.write(target, number)
        return target


def padded(arguments: list[int]) -> list[int]:
    """Return three arguments of an operation; those it has no use for repeat the last one."""
    return (arguments + 2 * arguments[-1:])[:3]
