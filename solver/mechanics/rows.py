"""Rows between places and directions of two bodies, with the reactions they bring.

coincidence  x_A - x_B = 0          lambda is the force on the second body
offset       (x_B - x_A) . c = 0    -mu c is the force on the second body
direction    a . b = 0              -mu b x a is the torque on the second body
"""

from __future__ import annotations

from dataclasses import dataclass, field

from solver.mechanics.combination import Combination
from solver.mechanics.equations import Coincidence, FormRow, Formula, FunctionRow, Leaf, Scale
from solver.mechanics.mechanism import Mechanism
from solver.runtime.model import Row
from solver.scene import Number

COINCIDENCE, FORCE, TORQUE = 0, 1, 2
"""Kinds of reaction entries."""
METRES, RADIANS = Scale(1.0, 1), Scale(1.0, 0)


@dataclass(slots=True)
class Rows:
    """Rows of one part of the scene, and the entries of its reaction."""

    mechanism: Mechanism
    location: str
    name: str
    detail: str = ""
    entries: list[tuple[int, int, int]] = field(default_factory=list)
    """Kind, index of the row among its kind, sign."""

    def _row(self, kind: str) -> Row:
        return Row(self.location, self.name, kind, self.detail)

    def coincidence(self, first: Combination, second: Combination) -> None:
        """Let two places coincide."""
        self.entries.append((COINCIDENCE, len(self.mechanism.coincidences), 1))
        form = self.mechanism.link(first - second)
        self.mechanism.coincidences.append(Coincidence(form, self._row("apart")))

    def offset(
        self, link: Combination, direction: Combination, value: Number = 0.0, kind: str = "off"
    ) -> int:
        """Hold link . direction, the link to the second body; return the form row."""
        return self._form_row(FORCE, link, direction, value, METRES, kind)

    def direction(
        self, first: Combination, second: Combination, value: Number = 0.0, kind: str = "turned"
    ) -> int:
        """Hold the dot product of unit directions of the two bodies; return the form row."""
        return self._form_row(TORQUE, first, second, value, RADIANS, kind)

    def _form_row(
        self, entry: int, u: Combination, w: Combination, value: Number, scale: Scale, kind: str
    ) -> int:  # fmt: skip
        form, sign = self.mechanism.form(u, w)
        rows = self.mechanism.form_rows
        rows.append(FormRow(form, value, scale, self._row(kind)))
        self.entries.append((entry, len(rows) - 1, sign))
        return len(rows) - 1

    def function(
        self, value: Number, leaves: tuple[Leaf, ...], scale: Scale, kind: str = "value"
    ) -> int:
        """Hold a formula at zero; return the function row."""
        rows = self.mechanism.function_rows
        rows.append(FunctionRow(Formula(value, leaves), scale, self._row(kind)))
        return len(rows) - 1

    def velocity(self, value: Number, leaves: tuple[Leaf, ...], scale: Scale) -> int:
        """Hold a formula that is linear in rates at zero; return the velocity row."""
        rows = self.mechanism.velocity_rows
        rows.append(FunctionRow(Formula(value, leaves), scale, self._row("velocity")))
        return len(rows) - 1

    def close(self) -> int | None:
        """Add the reaction of these rows to what is measured; return its index."""
        if not self.entries:
            return None
        self.mechanism.reactions.append(self.entries)
        return len(self.mechanism.reactions) - 1
