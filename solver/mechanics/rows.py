"""A part of the scene as it is added: its rows, the reaction they bring, and what it demands.

coincidence  x_A - x_B = 0          lambda is the force on the second body
offset       (x_B - x_A) . c = 0    -mu c is the force on the second body
direction    a . b = 0              -mu b x a is the torque on the second body
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import cache
from sys import intern
from typing import Literal

from solver.mechanics.combination import Combination
from solver.mechanics.formulas import scale_of
from solver.mechanics.mechanism import Coincidence, FormRow, Formula, FunctionRow, Scale
from solver.mechanics.parts import Parts, RowOf
from solver.mechanics.vectors import Vector, dot, unit
from solver.runtime.layout import REACTION_COINCIDENCE, REACTION_FORCE, REACTION_TORQUE
from solver.runtime.model import Row, Rule
from solver.scene import Expr, Number, symbols
from solver.scene.fields import Part, fields_of

METRES, RADIANS = Scale(1.0, 1), Scale(1.0, 0)


class Rows:
    """Rows of one part of the scene, ``joints.bearing``."""

    def __init__(self, parts: Parts, table: str, name: str) -> None:
        self.parts, self.mechanism, self.name = parts, parts.mechanism, name
        self.location, word = f"{table}.{name}", {"bodies": "body"}.get(table, table[:-1])
        self.title = f"{word} '{name}'"
        """What the part is called in a sentence."""
        self.detail = ""
        self.entries: list[tuple[int, int, int]] = []
        """Of the reaction: kind, index of the row among its kind, sign."""

    # --------------------------------------------------------------------------------- demands

    def rule(
        self, number: Number, relation: Literal[">", ">=", "finite", "drawn", "noted"], text: str,
        bound: float = 0.0,
    ) -> None:  # fmt: skip
        """Demand that a number is `relation` to a bound (or finite); `text` has its value."""
        message = intern(text if "{value" in text else f"{text}, got {{value!r}}")
        self.mechanism.rule_numbers.append(number)
        self.mechanism.rules.append(Rule(-1, relation, bound, self.location, self.title, message))

    def finite(self, vector: Iterable[Number], what: str) -> None:
        """Demand that what the expressions of a vector yield is a finite number."""
        for number in vector:
            if isinstance(number, Expr):
                self.rule(number, "finite", f"{what} must be a finite number")

    def demand(self, part: Part) -> None:
        """Demand what the fields of a part declare of their numbers, but of those that move."""
        for name, relation, text in _demands(type(part)):
            value = getattr(part, name)
            for number in value if isinstance(value, tuple) else (value,):
                if number is not None and self.is_known(number):
                    self.rule(number, relation, text)

    def is_known(self, number: Number) -> bool:
        """Whether a number depends on parameters, inputs and the time alone."""
        known = self.mechanism.varying, self.parts.scene.parameters.keys()
        return isinstance(number, float) or not symbols(number).difference(*known)

    def unit(self, vector: Vector, text: str = "axis must not be of length zero") -> Vector:
        """Return a/|a|, and demand that it exists."""
        self.rule(dot(vector, vector), ">", text)
        return unit(vector)

    def problem(self, text: str, field: str = "") -> None:
        """Report a mistake of the scene at a field of the part."""
        self.parts.problems.append((f"{self.location}{field}", text))

    # ------------------------------------------------------------------------------------ rows

    def row(self, kind: str) -> Row:
        """Return what a row of this part is called."""
        return Row(self.location, self.title, kind, self.detail)

    def coincidence(self, first: Combination, second: Combination) -> None:
        """Let two places coincide."""
        self.entries.append((REACTION_COINCIDENCE, len(self.mechanism.coincidences), 1))
        form = self.mechanism.link(first - second)
        self.mechanism.coincidences.append(Coincidence(form, self.row("apart")))

    def offset(
        self, link: Combination, direction: Combination, value: Number = 0.0, kind: str = "off"
    ) -> RowOf:
        """Hold link . direction, the link to the second body."""
        return self._form_row(REACTION_FORCE, link, direction, value, METRES, kind)

    def direction(
        self, first: Combination, second: Combination, value: Number = 0.0, kind: str = "turned"
    ) -> RowOf:
        """Hold the dot product of unit directions of the two bodies."""
        return self._form_row(REACTION_TORQUE, first, second, value, RADIANS, kind)

    def _form_row(
        self, entry: int, u: Combination, w: Combination, value: Number, scale: Scale, kind: str
    ) -> RowOf:  # fmt: skip
        form, sign = self.mechanism.form(u, w)
        self.entries.append((entry, len(self.mechanism.form_rows), sign))
        return self.form_row(form, value, scale, kind)

    def form_row(self, form: int, value: Number, scale: Scale, kind: str) -> RowOf:
        """Hold a form."""
        rows = self.mechanism.form_rows
        rows.append(FormRow(form, value, scale, self.row(kind)))
        return "form", len(rows) - 1

    def distance(self, link: Combination, length: Number | None) -> Number:
        """Add the row |u|^2 = L^2, as drawn unless `length` is given; return L^2."""
        form, _ = self.mechanism.form(link, link)
        length2 = self.mechanism.value(form) if length is None else length * length
        if length is None:
            text = "its points coincide; draw them apart (squared distance {value!r} m^2)"
            self.rule(length2, ">", text)
        self.form_row(form, length2, Scale(length2, 0), "length")
        return length2

    def function(
        self, formula: Formula, scale: Scale | None = None, kind: str | None = None
    ) -> RowOf:  # fmt: skip
        """Hold a formula at zero; its `scale` is given where it is one of m or rad."""
        rows = self.mechanism.function_rows
        kind = kind or ("coupled" if scale else "value")
        scale = scale or scale_of(self.mechanism, formula)
        rows.append(FunctionRow(formula, scale, self.row(kind)))
        return "function", len(rows) - 1

    def velocity(self, formula: Formula, scale: Scale | None = None) -> RowOf:
        """Hold a formula that is linear in rates at zero."""
        rows = self.mechanism.velocity_rows
        scale = scale or scale_of(self.mechanism, formula)
        rows.append(FunctionRow(formula, scale, self.row("velocity")))
        return "velocity", len(rows) - 1

    def static(self, sliding: Number, static: Number | None, words: str) -> Number:
        """Return the coefficient of what sticks, that of what slides or more."""
        if static is None:
            return sliding
        self.rule(static - sliding, ">=", f"{words} must be >= 0")
        return static

    def close(self) -> int | None:
        """Add the reaction of these rows to what is measured; return its index."""
        if not self.entries:
            return None
        self.mechanism.reactions.append(self.entries)
        return len(self.mechanism.reactions) - 1


@cache
def _demands(part: type[Part]) -> tuple[tuple[str, Literal[">", ">="], str], ...]:
    """Field, relation to zero and sentence of each number of a part that must hold one."""
    return tuple(
        (name, rule.relation, f"{name} must be {rule.words} {field.kind.unit}".rstrip())
        for name, field in fields_of(part).items()
        if (rule := field.kind.rule) is not None and rule.relation is not None
    )
