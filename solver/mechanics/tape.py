"""The vector of numbers of a model, and the tape that computes what is no constant.

A tape is scalar operations on that vector, in five segments: what depends on fixed parameters
alone; what forces also need of time, inputs, tunable parameters and sensors in the middle of a
step; the signals at its end; what outputs need of the measurements; and the next values of sampled
states. All may use the results of
the first one and none those of another. Equal subexpressions of a segment are computed once.

Laws and signals that jump or have a kink are smooth in pieces. What decides between these, such as
t - 0.6 of ``1 if t < 0.6 else -1``, is the argument of a switch; the operation reads on which side
that is, and the core changes the side where a step ends at it (``solver/kernel/tape/switches.h``).
"""

from __future__ import annotations

from array import array
from collections.abc import Callable, Iterable, Mapping, Sequence
from enum import IntEnum
from typing import NamedTuple

from solver.mechanics.knots import has_knots, on_piece, place_among_knots
from solver.mechanics.mechanism import Held, Kink, Leaf
from solver.runtime.layout import CODES, LEAF_RATE, OFFSETS, SWITCH_LEVEL, SWITCH_SIGN
from solver.scene import Expr, Number
from solver.scene.expression import Curve, Grid, Operand, operate, symbol

CODE = {name: code for code, name in enumerate(CODES)}
GRIDS = {code for name, code in CODE.items() if name.startswith("grid")}


class Segment(IntEnum):
    """When an operation runs."""

    PARAMETERS = 0
    LAWS = 1
    SIGNALS = 2
    OUTPUTS = 3
    TICKS = 4


class Motion(IntEnum):
    """Why a number changes within a communication step."""

    STANDS = 0
    WITH_TIME = 1
    WITH_QUANTITIES = 2


MOTION = {"time": Motion.WITH_TIME, "sensor": Motion.WITH_QUANTITIES}
MOTION["sensor_rate"] = Motion.WITH_QUANTITIES
"""Of the numbers of a section; inputs move with the time unless they are held."""
COMPARISONS = ("lt", "le", "gt", "ge", "eq", "ne")
SWITCHING = frozenset({*COMPARISONS, "sign", "abs", "min", "max", "floor", "ceil", "mod", "spline"})
"""Operations that jump or have a kink, or whose derivatives do."""
MOST_SWITCHES = 64
"""Of a mechanism: all are looked at in every step, and each look runs all laws."""


class Switch(NamedTuple):
    """The places of the argument of what jumps or has a kink and of its side, and what does so."""

    argument: int
    side: int
    kind: int
    segment: Segment
    motion: Motion
    operation: Expr
    kink: Kink | None
    """That which reads no side of it."""


def argument_of(number: Expr) -> Number:
    """Return what has another sign, or is above another whole number, where an operation switches.

    Of a comparison, min or max it is the difference.
    """
    x, y = (number.args[0], number.args[-1])
    if number.op == "spline":
        return place_among_knots(number)
    if number.op == "mod":
        return operate("div", x, y)  # pyright: ignore[reportArgumentType]
    if number.op == "ceil":
        return operate("neg", x)  # pyright: ignore[reportArgumentType]
    return x if len(number.args) == 1 else operate("sub", x, y)  # pyright: ignore[reportArgumentType, reportReturnType]


def on_side(number: Expr, side: Number, sign: Number) -> Number:
    """Return an operation as it is on a side of its switch; `sign` is that of its difference."""
    x, y = (number.args[0], number.args[-1])
    match number.op:
        case "sign":
            return sign
        case "abs":
            return operate("mul", sign, x)  # pyright: ignore[reportArgumentType]
        case "min" | "max":
            first = operate("le" if number.op == "min" else "ge", sign, 0.0)
            chosen = operate("select", first, x, y)  # pyright: ignore[reportArgumentType]
            return operate("select", operate("ne", side, side), side, chosen)  # hands a NaN on
        case "floor":
            return side
        case "spline":
            return on_piece(number, side)
        case "ceil":
            return operate("neg", side)
        case "mod":
            return operate("sub", x, operate("mul", side, y))  # pyright: ignore[reportArgumentType]
    return operate(number.op, sign, 0.0)


class Tape:
    """Compiler of expressions.

    Parameters
    ----------
    symbols : callable
        Returns where a symbol lies in the vector of numbers, and PARAMETERS if it is fixed; or the
        Number that it stands for.
    first : int
        First free place in the vector of numbers.
    motion : mapping, optional
        Of the numbers that symbols stand for, by their places; others stand still.
    """

    def __init__(
        self,
        symbols: Callable[[str], tuple[int, Segment] | Number],
        first: int,
        motion: Mapping[int, Motion] | None = None,
    ) -> None:
        self._symbols = symbols
        self._first = first
        self._motion: dict[int, Motion] = dict(motion or {})
        self.switches: dict[tuple[int, Segment, int], Switch] = {}
        """By argument, segment and kind; each depends on those before it alone."""
        self._kink: Kink | None = None
        """The one that is compiled."""
        self.has_more = False
        """Whether operations beyond `MOST_SWITCHES` are left as they are."""
        self._sides: dict[str, int] = {}
        """Places of the sides, by their symbols."""
        self._known: dict[tuple[Operand, Segment], tuple[int, Segment]] = {}
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

    def compile(self, number: Operand, wanted: Segment = Segment.LAWS) -> tuple[int, Segment]:
        """Return where a number's value or a table will lie, and the segment that computes it.

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

    def _found(self, number: Operand, wanted: Segment) -> tuple[int, Segment] | None:
        known = self._known.get((number, Segment.PARAMETERS))
        return known or self._known.get((number, wanted))

    def _operands(self, number: Operand, wanted: Segment) -> list[Operand]:
        """Numbers that are compiled before this one."""
        if not isinstance(number, Expr):
            return []
        if number.op in ("symbol", "call"):
            self.used[wanted].add(name := str(number))
            meaning = self._meaning(name)
            return [] if isinstance(meaning, tuple) else [meaning]
        return [arg for arg in number.args if not isinstance(arg, str)]

    def _compile(
        self, number: Operand, arguments: list[tuple[int, Segment]], wanted: Segment
    ) -> tuple[int, Segment]:
        """Compile a number whose operands lie at `arguments`."""
        if not isinstance(number, Expr):
            content = number.numbers if isinstance(number, Curve) else (float(number),)
            places = [self._new() for _ in content]
            self.constants.update(zip(places, content, strict=True))
            return places[0], Segment.PARAMETERS
        if number.op in ("symbol", "call"):
            found = self._meaning(str(number))
            if not isinstance(found, tuple):
                return arguments[0]
            return found if found[1] is Segment.PARAMETERS else (found[0], wanted)
        segment = max(segment for _, segment in arguments)
        places = [place for place, _ in arguments]
        may_switch = number.op in SWITCHING and (number.op != "spline" or has_knots(number))
        if may_switch and segment in (Segment.LAWS, Segment.SIGNALS):
            motion = max(self._motion.get(place, Motion.STANDS) for place in places)
            may_switch = self._kink is not None or len(self.switches) < MOST_SWITCHES
            if motion is not Motion.STANDS and may_switch:
                return self._switched(number, wanted, motion)
            self.has_more |= motion is not Motion.STANDS
        if isinstance(number.args[-1], Grid):  # its coordinates stand one behind the other
            copies = [self._new() for _ in places[:-1]]
            for copied, place in zip(copies, places, strict=False):
                self._emit(segment, "copy", copied, [place] * 3)
            places = [copies[0], places[-1]]
        target = self._new()
        self._emit(segment, number.op, target, padded(places, number))
        return target, segment

    def _meaning(self, name: str) -> tuple[int, Segment] | Number:
        side = self._sides.get(name)
        return self._symbols(name) if side is None else (side, Segment.LAWS)

    def add_kink(self, kink: Kink) -> None:
        """Add the switch of a kink. All laws and signals have been compiled."""
        self._kink = kink
        arguments = [self.compile(x) for x in self._operands(kink.operation, Segment.LAWS)]
        motion = max(self._motion.get(place, Motion.STANDS) for place, _ in arguments)
        if motion is Motion.WITH_QUANTITIES:
            self._switch(kink.operation, Segment.LAWS, motion)

    def add_clock(self, clock: Number) -> int:
        """Add the switch that a clock ticks by, whatever the number of others; return its side."""
        whole = operate("floor", clock)
        assert isinstance(whole, Expr)  # it goes with the time
        return self._switch(whole, Segment.LAWS, Motion.WITH_TIME)[0].side

    def _switch(self, number: Expr, wanted: Segment, motion: Motion) -> tuple[Switch, bool]:
        """Return the switch of an operation, and whether it has the opposite sign."""
        kind = SWITCH_LEVEL if number.op in ("floor", "ceil", "mod", "spline") else SWITCH_SIGN
        difference = argument_of(number)
        opposite = kind == SWITCH_SIGN and len(number.args) == 2
        reverse = self._found(operate("sub", *reversed(number.args)), wanted) if opposite else None  # pyright: ignore[reportArgumentType]
        turned = reverse is not None and (reverse[0], wanted, kind) in self.switches
        place = (reverse if reverse and turned else self.compile(difference, wanted))[0]
        found = self.switches.get((place, wanted, kind))
        if found is None:
            found = Switch(place, self._new(), kind, wanted, motion, number, self._kink)
            self.switches[place, wanted, kind] = found
            self._sides[f"#side {found.side}"] = found.side
        return found, turned

    def _switched(self, number: Expr, wanted: Segment, motion: Motion) -> tuple[int, Segment]:
        """Compile an operation that jumps or has a kink, as it is on the side of its switch."""
        found, turned = self._switch(number, wanted, motion)
        side = symbol(f"#side {found.side}")
        return self.compile(on_side(number, side, -side if turned else side), wanted)

    def _emit(self, segment: Segment, op: str, target: int, places: list[int]) -> None:
        self._motion[target] = max(self._motion.get(place, Motion.STANDS) for place in places)
        self.operations[segment].extend((CODE[op], target, *places))

    def write(self, target: int, number: Operand, wanted: Segment = Segment.LAWS) -> Segment:
        """Compile a number and have it copied to `target`; return the segment."""
        place, segment = self.compile(number, wanted)
        self._emit(segment, "copy", target, [place] * 3)
        return segment

    def copy(self, number: Operand) -> int:
        """Have a number of the laws copied to a place that nothing else writes; return it."""
        target = self._new()
        self.write(target, number)
        return target


def padded(arguments: list[int], operation: Expr) -> list[int]:
    """Return three arguments of an operation; those it has no use for repeat the last one.

    Of a table these are its first and its last place; below zero, those of ``Numbers.operations``.
    """
    if isinstance(table := operation.args[-1], Curve):
        last = len(table.numbers) - 1
        return [*arguments, arguments[-1] + (last if arguments[-1] >= 0 else -last)]
    return (arguments + 2 * arguments[-1:])[:3]


class Operations(NamedTuple):
    """A formula over leaves: code and three arguments each.

    Attributes
    ----------
    each : list
    still : int
        How many at the beginning no rate enters, where derivatives by rates are all that is asked.
    known : int
        How many at the beginning are those of the formula before, over the same leaves.
    """

    each: list[tuple[int, ...]]
    still: int = 0
    known: int = 0


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
    moving : iterable of int
        Inputs that move within a communication step.
    """

    def __init__(
        self,
        sections: Mapping[str, Sequence[Number]],
        signals: Sequence[Number],
        symbols: Callable[[str], tuple[str, int, Segment] | Number],
        moving: Iterable[int] = (),
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

        motion = {
            self.offsets[section] + place: moves
            for section, moves in MOTION.items()
            for place in range(len(sections[section]))
        }
        motion |= {self.offsets["input"] + place: Motion.WITH_TIME for place in moving}
        self.tape = Tape(place_of, len(self.values), motion)
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

    def tick(self, held: Held) -> tuple[int, int]:
        """Return where the next value of a sampled state lies, and the side of its clock."""
        return self.place(held.next, Segment.TICKS), self.tape.add_clock(held.clock)

    def operations(self, value: Number, n_leaves: int) -> Operations:
        """Return the operations of a formula over leaves ``#0``, ``#1``, ..."""
        operations, (last,) = self._compiled([value], n_leaves)
        if last != n_leaves + len(operations) - 1:  # a leaf with the others folded away
            operations.append((CODE["copy"], last, last, last))
        return Operations(operations)

    def slips(self, values: Sequence[Number], leaves: Sequence[Leaf]) -> list[Operations]:
        """Return the operations of several formulas over the same leaves, linear in rates.

        What no rate enters comes first, in all of them, and then what all of them need. No rate
        may enter a grid: it is not linear in one, and its coordinates stand one behind the other.
        """
        n_leaves = len(leaves)
        operations, ends = self._compiled(values, n_leaves)
        moves = [leaf.kind == LEAF_RATE for leaf in leaves]
        for code, first, *others in operations:
            coordinates = range(first, first + 3) if code in GRIDS else ()
            assert not any(moves[at] for at in coordinates), "a slip has a grid of rates"
            moves.append(any(at >= 0 and moves[at] for at in (first, *others)))
        needed = [self._needed(operations, n_leaves, end) for end in ends]
        places = range(n_leaves, n_leaves + len(operations))
        still = [at for at in places if not moves[at]]
        common = [at for at in places if moves[at] and all(at in x for x in needed)]
        found = []
        for end, own in zip(ends, needed, strict=True):
            rest = [at for at in places if moves[at] and at in own and at not in common]
            order = [*range(n_leaves), *still, *common, *rest]
            register = {at: k for k, at in enumerate(order)}
            moved = [
                (code, *(register.get(at, at) for at in arguments))
                for code, *arguments in (operations[at - n_leaves] for at in order[n_leaves:])
            ]
            if not rest:
                moved.append((CODE["copy"], *3 * [register[end]]))
            known = len(still) + len(common) if found else 0
            found.append(Operations(moved, len(still), known))
        return found

    @staticmethod
    def _needed(operations: Sequence[tuple[int, ...]], n_leaves: int, end: int) -> set[int]:
        """Return the registers that a result depends on, with its own."""
        needed = {end}
        for at in range(end, n_leaves - 1, -1):
            if at in needed:
                needed.update(operations[at - n_leaves][1:])
        return needed

    def _compiled(
        self, values: Sequence[Number], n_leaves: int
    ) -> tuple[list[tuple[int, ...]], list[int]]:
        """Return the operations of formulas over leaves, and the registers of their values.

        Registers hold the leaves, then one result each; -1 - place stands for a number.
        """
        register = {f"#{k}": k for k in range(n_leaves)}
        known: dict[Expr, int] = {}
        triples: dict[tuple[int, ...], int] = {}
        operations: list[tuple[int, ...]] = []

        def copied(arguments: list[int]) -> int:
            """First of the registers, one behind the other, of the coordinates of a grid."""
            first = triples.setdefault(tuple(arguments), n_leaves + len(operations))
            if first == n_leaves + len(operations):
                operations.extend((CODE["copy"], at, at, at) for at in arguments)
            return first

        def compiled(part: Operand | str) -> int | None:
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
            if isinstance(part.args[-1], Grid):
                arguments = [copied(arguments[:-1]), arguments[-1]]
            operations.append((CODE[part.op], *padded(arguments, part)))
            known[part] = n_leaves + len(operations) - 1
            return known[part]

        ends = [compiled(value) for value in values]
        assert None not in ends
        return operations, [end for end in ends if end is not None]

    def _constant(self, number: Operand | str) -> int:
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
