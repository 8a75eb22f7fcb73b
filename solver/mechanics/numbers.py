"""The vector of numbers of a model: sections of known values, and the tape for the rest."""

from __future__ import annotations

from array import array
from collections.abc import Callable, Mapping, Sequence

from solver.mechanics.tape import CODE, Segment, Tape, padded
from solver.runtime.layout import OFFSETS
from solver.scene import Expr, Number


class Numbers:
    """Sections in the order of ``solver.runtime.layout.OFFSETS``, then what the tape needs.

    Parameters
    ----------
    sections : mapping of str to sequence of Number
        Contents of each section. Those that the kernel or the caller fills hold zeros.
    signals : sequence of Number
        Prescribed values, written to the section ``signal``.
    symbols : callable
        Returns what a symbol of an expression means: (section, place, Segment) or a Number.
    calls : callable
        Returns the expression of a mechanism function.
    """

    def __init__(
        self,
        sections: Mapping[str, Sequence[Number]],
        signals: Sequence[Number],
        symbols: Callable[[str], tuple[str, int, Segment] | Number],
        calls: Callable[[Expr], Number],
    ) -> None:
        assert tuple(sections) == tuple(OFFSETS)
        self.offsets: dict[str, int] = {}
        self.values = array("d")
        formulas: dict[str, list[tuple[int, Expr]]] = {}
        for name, content in sections.items():
            self.offsets[name] = len(self.values)
            formulas[name] = []
            if Expr in set(map(type, content)):  # few are, among many plain numbers
                formulas[name] = [(k, x) for k, x in enumerate(content) if isinstance(x, Expr)]
                content = [0.0 if isinstance(x, Expr) else x for x in content]
            self.values.extend(map(float, content))

        def place_of(name: str) -> tuple[int, Segment] | Number:
            meaning = symbols(name)
            if not isinstance(meaning, tuple):
                return meaning
            section, place, segment = meaning
            return self.offsets[section] + place, segment

        self.tape = Tape(place_of, calls, len(self.values))
        self.segment_of: dict[str, Segment] = {}
        """Latest segment that writes to each section."""
        for name, found in formulas.items():
            latest = Segment.PARAMETERS
            for place, number in found:
                latest = max(latest, self.tape.write(self.offsets[name] + place, number))
            self.segment_of[name] = latest
        self.formulas_vary = False
        """Whether a formula contains a number of the laws."""
        self._copies: dict[int, int] = {}
        for place, number in enumerate(signals):
            target = self.offsets["signal"] + place
            if isinstance(number, Expr):
                self.tape.write(target, number, Segment.SIGNALS)
            else:
                self.values[target] = float(number)

    def place(self, number: Number, segment: Segment = Segment.LAWS) -> int:
        """Return where the value of a number lies; `segment` is when it is needed."""
        return self.tape.compile(number, segment)[0]

    def operations(self, value: Number, n_leaves: int) -> list[int]:
        """Return the operations of a formula over leaves ``#0``, ``#1``, ..., four integers each.

        Registers hold the leaves, then one result each; -1 - place stands for a number.
        """
        register = {f"#{k}": k for k in range(n_leaves)}
        known: dict[Expr, int] = {}
        operations: list[int] = []

        def compiled(part: Number | str) -> int | None:
            """Register of a part; None for one without leaves."""
            if not isinstance(part, Expr):
                return None
            if part.op == "symbol":
                return register.get(str(part.args[0]))
            if part in known:
                return known[part]
            found = [compiled(arg) for arg in part.args]
            if all(argument is None for argument in found):
                return None
            arguments = [
                -1 - self._constant(arg) if at is None else at
                for arg, at in zip(part.args, found, strict=True)
            ]
            operations.extend((CODE[part.op], *padded(arguments)))
            known[part] = n_leaves + len(operations) // 4 - 1
            return known[part]

        last = compiled(value)
        assert last is not None
        if last != n_leaves + len(operations) // 4 - 1:  # a leaf with the others folded away
            operations.extend((CODE["copy"], last, last, last))
        return operations

    def _constant(self, number: Number | str) -> int:
        assert not isinstance(number, str)
        place, segment = self.tape.compile(number)
        if segment is not Segment.LAWS:
            return place
        self.formulas_vary = True
        if place >= len(self.values):
            return place
        # The time, an input or a parameter itself: signals set it to other times, laws do not.
        if place not in self._copies:
            self._copies[place] = self.tape.copy(number)
        return self._copies[place]

    def finish(self) -> array[float]:
        """Return all numbers, with the tape's constants in place."""
        values = self.values + array("d", bytes(8 * (self.tape.end - len(self.values))))
        for place, constant in self.tape.constants.items():
            values[place] = constant
        return values
