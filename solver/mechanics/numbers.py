"""The vector of numbers of a model: sections of known values, and the tape for the rest."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

from solver.mechanics.tape import Segment, Tape
from solver.runtime.layout import OFFSETS
from solver.scene import Expr, Number


class Numbers:
    """Sections in the order of ``solver.runtime.layout.OFFSETS``, then what the tape needs.

    Parameters
    ----------
    sections : mapping of str to sequence of Number
        Contents of each section. Those that the kernel or the caller fills hold zeros.
    symbols : mapping of str to (section, place, Segment) or Number
        What each symbol of an expression means.
    calls : callable
        Returns the expression of a mechanism function.
    """

    def __init__(
        self,
        sections: Mapping[str, Sequence[Number]],
        symbols: Mapping[str, tuple[str, int, Segment] | Number],
        calls: Callable[[Expr], Number],
    ) -> None:
        assert tuple(sections) == OFFSETS
        self.offsets: dict[str, int] = {}
        self.values: list[float] = []
        for name, content in sections.items():
            self.offsets[name] = len(self.values)
            self.values.extend(0.0 if isinstance(x, Expr) else float(x) for x in content)
        places = {
            name: (self.offsets[meaning[0]] + meaning[1], meaning[2])
            if isinstance(meaning, tuple)
            else meaning
            for name, meaning in symbols.items()
        }
        self.tape = Tape(places, calls, len(self.values))
        self.segment_of: dict[str, Segment] = {}
        """Latest segment that writes to each section."""
        for name, content in sections.items():
            latest = Segment.PARAMETERS
            for place, number in enumerate(content):
                if isinstance(number, Expr):
                    target = self.offsets[name] + place
                    latest = max(latest, self.tape.write(target, number))
            self.segment_of[name] = latest
        self.time_dependent = "t" in self.tape.used
        """Whether the laws read the time; outputs are compiled later and do not count."""

    def place(self, number: Number) -> int:
        """Return where the value of a number lies."""
        return self.tape.compile(number)[0]

    def finish(self) -> list[float]:
        """Return all numbers, with the tape's constants in place."""
        tail = [0.0] * (self.tape.end - len(self.values))
        values = self.values + tail
        for place, constant in self.tape.constants.items():
            values[place] = constant
        return values
