"""Islands: parts of a mechanism that nothing joins but what stays where it is (theory 4.7).

Nodes belong to the same island if they are of one body, or a mass, row, force or potential depends
on both. Sensors and laws do not join: they are read before a step and fixed in it. Equations of
different islands share no unknown, so that each island is solved by itself; everything a step loops
over is ordered by islands, one contiguous piece each.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Generic, TypeVar

from solver.mechanics.mechanism import DRIVEN, FIXED, Mechanism

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
        motions = [node.motion for node in mechanism.nodes]
        driven = [n for n, motion in enumerate(motions) if motion == DRIVEN]
        self._root = list(range(len(motions)))
        for first, *others in filter(None, (driven, *self._groups(mechanism))):
            for node in others:
                self._join(first, node)
        last = {self._find(n): None for n in driven}
        moving = [self._find(n) for n, motion in enumerate(motions) if motion != FIXED]
        roots = dict.fromkeys([n for n in moving if n not in last]) | last
        number = {root: island for island, root in enumerate(roots)}
        self.of_node = [number.get(self._find(n), 0) for n in range(len(motions))]
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

    @staticmethod
    def _groups(mechanism: Mechanism) -> Iterator[Sequence[int]]:
        """Nodes that depend on each other."""
        yield from mechanism.rigid
        yield from mechanism.masses
        for parts in mechanism.parts:
            yield from map(mechanism.joined, parts)

    def ordered(
        self, items: Iterable[Item], nodes: Callable[[Item], Sequence[int]]
    ) -> Ordered[Item]:  # fmt: skip
        """Return items by islands, each in that of its first node; in the first if it has none."""
        listed = list(items)
        of_item = [0] * len(listed)
        if self.count > 1:
            of_item = [self.of_node[found[0]] if found else 0 for found in map(nodes, listed)]
        order = sorted(range(len(listed)), key=of_item.__getitem__)
        place = [0] * len(listed)
        for k, index in enumerate(order):
            place[index] = k
        islands = [of_item[index] for index in order]
        begin = [bisect_left(islands, island) for island in range(self.count + 1)]
        return Ordered([listed[k] for k in order], place, begin)
