"""Islands: parts of a mechanism that nothing joins but what stays where it is (theory 4.7).

Nodes belong to the same island if they are of one body, or a mass, row, force or potential depends
on both. Sensors and
laws do not join: they are read before a step and fixed in it. Equations of different islands share
no unknown, so that each island is solved by itself; everything a step loops over is ordered by
islands, one contiguous piece each.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from itertools import accumulate
from typing import Generic, TypeVar

from solver.mechanics.equations import DRIVEN, FIXED, SIGNAL, Formula
from solver.mechanics.mechanism import Mechanism

Item = TypeVar("Item")


@dataclass(frozen=True, slots=True)
class Ordered(Generic[Item]):
    """Items by islands, in their own order within each."""

    items: list[Item]
    place: list[int]
    """Of each item, by its index before ordering."""
    begin: list[int]
    """Where each island's items begin, and the end of all."""

    def __len__(self) -> int:
        return len(self.items)


class Islands:
    """Islands of a mechanism, numbered in the order of their first nodes.

    What driven points belong to counts as one, and comes last: its nodes, free and driven, then lie
    side by side, as those of every other island do.
    """

    def __init__(self, mechanism: Mechanism) -> None:
        self._mechanism = mechanism
        self._root = list(range(len(mechanism.nodes)))
        for group in self._groups():
            first, *others = group or [0]
            for node in others:
                self._join(first, node)
        driven = [n for n, node in enumerate(mechanism.nodes) if node.motion == DRIVEN]
        for node in driven[1:]:
            self._join(driven[0], node)
        last = {self._find(n): None for n in driven}
        moving = [n for n, node in enumerate(mechanism.nodes) if node.motion != FIXED]
        roots = dict.fromkeys([n for n in map(self._find, moving) if n not in last]) | last
        number = {root: island for island, root in enumerate(roots)}
        self.of_node = [number.get(self._find(n), 0) for n in range(len(mechanism.nodes))]
        """Of each node; of one that does not move 0."""
        self.count = max(1, len(number))

    def _find(self, node: int) -> int:
        root = self._root
        while root[node] != node:
            root[node] = node = root[root[node]]
        return node

    def _join(self, a: int, b: int) -> None:
        a, b = self._find(a), self._find(b)
        self._root[max(a, b)] = min(a, b)

    def moving(self, forms: Iterable[int]) -> list[int]:
        """Return the nodes of some forms that move."""
        mechanism = self._mechanism
        nodes = mechanism.nodes
        sides = (side for f in forms for side in (mechanism.forms[f].u, mechanism.forms[f].w))
        return [n for side in sides for n, _, _ in side.terms if nodes[n].motion != FIXED]

    def _groups(self) -> Iterator[list[int]]:
        """Nodes that depend on each other."""
        mechanism = self._mechanism
        yield from (list(nodes) for nodes in mechanism.rigid)
        yield from (list(pair) for pair in mechanism.masses)
        for row in (*mechanism.form_rows, *mechanism.coincidences):
            yield self.moving((row.form,))
        for element in mechanism.elements:
            yield self.moving(mechanism.quantities[element.quantity].forms)
        for row in (*mechanism.function_rows, *mechanism.velocity_rows):
            yield self.moving(self.forms(row.formula))
        yield from (self.moving(self.forms(potential)) for potential in mechanism.potentials)
        for load in mechanism.loads:
            yield [*self.moving((load.form,)), *self._directors(load.axes)]
        yield from (self.moving((moment.place,)) for moment in mechanism.moments)
        yield from (self._directors(moment.place) for moment in mechanism.body_moments)

    def _directors(self, first: int | None) -> list[int]:
        """Nodes of the body with this first director."""
        count = 1 if self._mechanism.dim == 2 else 3
        return [] if first is None else list(range(first, first + count))

    def forms(self, formula: Formula) -> list[int]:
        """Return the forms that a formula depends on."""
        quantities = self._mechanism.quantities
        leaves = [leaf for leaf in formula.leaves if leaf.kind != SIGNAL]
        return [form for leaf in leaves for form in quantities[leaf.index].forms]

    def of_forms(self, forms: Iterable[int]) -> int:
        """Return the island of what depends on some forms; 0 if nothing of it moves."""
        moving = self.moving(forms)
        return self.of_node[moving[0]] if moving else 0

    def ordered(self, items: Iterable[Item], island: Callable[[Item], int]) -> Ordered[Item]:
        """Return items by islands."""
        listed = list(items)
        of_item = [*map(island, listed)] if self.count > 1 else [0] * len(listed)
        order = sorted(range(len(listed)), key=of_item.__getitem__)
        place = [0] * len(listed)
        for k, index in enumerate(order):
            place[index] = k
        sizes = [0] * self.count
        for number in of_item:
            sizes[number] += 1
        return Ordered([listed[k] for k in order], place, [0, *accumulate(sizes)])
