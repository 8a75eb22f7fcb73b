"""Measurements: where the kernel puts them, and how expressions of outputs are made of them."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property
from typing import NamedTuple

from solver.mechanics.combination import Combination
from solver.mechanics.formulas import with_symbols
from solver.mechanics.mechanism import FIXED
from solver.mechanics.parts import JointParts, Parts
from solver.mechanics.structure import Structure
from solver.mechanics.vectors import Vector, add, scale, turned
from solver.scene import Expr, Number
from solver.scene.expression import symbol

_VECTORS = (
    *("position", "velocity", "acceleration", "place", "place_velocity", "place_acceleration"),
    *("reaction_force", "driven_force"),
)

_ALWAYS = {"quaternion": 4, "body_rate": 3, "body_acceleration": 3, "contact": 5, "friction": 3}
WIDTHS = {
    2: _ALWAYS | dict.fromkeys(_VECTORS, 2),
    3: _ALWAYS | {"reaction_torque": 3} | dict.fromkeys(_VECTORS, 3),
}
"""Components of an item of each section, by the dimension; 1 where nothing is said."""


class Ref(NamedTuple):
    """A measurement: component k of an item of a section, the item by its index before ordering."""

    section: str
    item: int
    k: int = 0

    def place(self, structure: Structure) -> int:
        """Return its place among the measurements."""
        places = structure.place_of.get(self.section)
        item = self.item if places is None else places[self.item]
        width = WIDTHS[structure.mechanism.dim].get(self.section, 1)
        return structure.measured[self.section][0] + width * item + self.k


class Named(NamedTuple):
    """A quantity with a name; one that is `listed` is a variable of the model."""

    name: str
    unit: str
    text: str
    meaning: Ref | Number
    listed: bool = True


Values = list[Ref] | Vector


@dataclass
class Sensors:
    """Measurements of a mechanism, as they stand in expressions of outputs."""

    parts: Parts
    asked: frozenset[str] = frozenset()
    """Names of quantities that are wanted: what is measured on demand is measured for these."""
    refs: dict[str, Ref] = field(default_factory=dict)
    """Measurements in expressions, by their symbols."""
    _places: dict[int, int] = field(default_factory=dict)

    @cached_property
    def asked_of(self) -> frozenset[str]:
        """Parts whose quantities are asked for."""
        return frozenset(name.rpartition(".")[0] for name in self.asked)

    def value(self, ref: Ref) -> Expr:
        """Return the symbol of a measurement, to be used in expressions."""
        name = f"#{ref.section} {ref.item} {ref.k}"
        self.refs[name] = ref
        return symbol(name)

    def multiplier(self, row: tuple[str, int]) -> Expr:
        """Return the symbol of mu of a row."""
        return self.value(self.ref(row))

    def ref(self, row: tuple[str, int]) -> Ref:
        """Return mu of a row, given by its kind and its index among those."""
        mechanism = self.parts.mechanism
        first = {"form": 0, "function": len(mechanism.form_rows)}
        first["function"] += mechanism.dim * len(mechanism.coincidences)
        first["velocity"] = first["function"] + len(mechanism.function_rows)
        return Ref("multiplier", first[row[0]] + row[1])

    def vector(self, combination: Combination) -> Vector:
        """Return a direction at the time of the measurement."""
        mechanism = self.parts.mechanism
        total: Vector = (0.0,) * mechanism.dim
        for n, straight, turn in combination.terms:
            node = mechanism.nodes[n]
            x: Vector = node.position
            if node.motion != FIXED:
                x = tuple(self.value(Ref("position", n, k)) for k in range(mechanism.dim))
            total = add(total, scale(straight, x))
            if turn != 0.0:
                total = add(total, scale(turn, turned(x)))
        return total

    def pushed(self, found: JointParts) -> Vector:
        """Return the force -sum mu slope direction of the rows of a joint."""
        total: Vector = (0.0,) * self.parts.mechanism.dim
        seen = {symbol(x): self.value(Ref("quantity", y.index)) for x, y in found.own.items()}
        for row, slope, direction in found.pushes:
            force = -1.0 * self.multiplier(row) * (with_symbols(slope, seen) if seen else slope)
            total = add(total, scale(force, self.vector(direction)))
        return total

    def motion(self, place: Combination) -> tuple[Values, Values]:
        """Return position and velocity of a place: measurements, or numbers where it stays."""
        mechanism = self.parts.mechanism
        if not mechanism.moves(place):
            return mechanism.drawn(place), (0.0,) * mechanism.dim
        item, kind = self._item(place)
        first = "place" if kind else "position"
        both = first, f"{kind}velocity"
        x, v = (references(section, item, mechanism.dim) for section in both)
        return x, v

    def velocity(self, place: Combination) -> Vector:
        """Return the velocity of a place, or the rate of a link, for expressions."""
        return self.numbers(self.motion(place)[1])

    def numbers(self, values: Values) -> Vector:
        """Return measurements as they stand in expressions."""
        return tuple(self.value(x) if isinstance(x, Ref) else x for x in values)

    def acceleration(self, place: Combination) -> Values:
        """Return the acceleration of a place, likewise."""
        mechanism = self.parts.mechanism
        if not mechanism.moves(place):
            return (0.0,) * mechanism.dim
        item, kind = self._item(place)
        return self.accelerations(f"{kind}acceleration", item, mechanism.dim)

    def accelerations(self, section: str, item: int, count: int) -> list[Ref]:
        """Return components of a measurement that accelerations are solved for."""
        self.parts.mechanism.accelerates = True
        return references(section, item, count)

    def _item(self, place: Combination) -> tuple[int, str]:
        """Return the node of a place, or its index among the places and what tells these apart."""
        if place.single is not None:
            return place.single, ""
        mechanism = self.parts.mechanism
        form = mechanism.link(place)
        if form not in self._places:
            self._places[form] = len(mechanism.places)
            mechanism.places.append(form)
        return self._places[form], "place_"


def references(section: str, item: int, count: int) -> list[Ref]:
    """Return the components of a measured vector."""
    return [Ref(section, item, k) for k in range(count)]
