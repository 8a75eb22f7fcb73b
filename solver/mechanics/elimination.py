"""Elimination order and sparse pattern of the tangent, fixed when a mechanism is assembled.

The KKT graph has nodes (blocks of `dim` coordinates) and rows (blocks of one multiplier, or of
`dim` where vectors coincide). Blocks are eliminated by minimum degree. A row waits until the nodes
that are gone can carry it: each of its multipliers must find a coordinate of its own among them, so
that its pivot is the negative definite -(eps + h G A^-1 G') and never the bare regularisation.
Chains and trees are then eliminated from the leaves without fill-in, at a cost linear in the number
of bodies; loops are bordered by what minimum degree leaves. The pattern itself is scalar: masses
and linear coincidences couple equal components only. (Tinney & Walker 1967; George & Liu 1989.)
"""

from __future__ import annotations

import heapq
from array import array
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass


@dataclass(frozen=True, slots=True, kw_only=True)
class Pattern:
    """Places of the unknowns in the elimination order, and the stored entries of the factors.

    Pivot k owns the entries ``ptr[k]:ptr[k + 1]``: diagonal, U row, L column; ``column`` lists its
    later places, ``target`` the entries that its update goes to, row by row.
    """

    position: array
    """First place of each block."""
    ptr: array
    column: array
    target: array
    _index: Sequence[dict[int, int]]

    def slot(self, i: int, j: int) -> int:
        """Return the stored entry of matrix element (i, j), both places in the order."""
        if i == j:
            return self.ptr[i]
        first, second = min(i, j), max(i, j)
        place = self.ptr[first] + 1 + self._index[first][second]
        return place if i < j else place + len(self._index[first])


@dataclass(frozen=True, slots=True)
class Graph:
    """Blocks and how they are coupled.

    `sizes` of the blocks, the first `n_nodes` of them nodes; `couplings` of two blocks: False where
    equal components are coupled, True where all are; `anchors` of each row: the nodes that can
    carry it, those in which its gradient does not vanish.
    """

    sizes: Sequence[int]
    n_nodes: int
    couplings: Mapping[tuple[int, int], bool]
    anchors: Mapping[int, Sequence[int]]


class Carriers:
    """Assigns multipliers of rows to coordinates of eliminated nodes, one each.

    Augmenting paths of bipartite matching, breadth first (Hopcroft & Karp 1973, one path a time).
    """

    def __init__(self, graph: Graph) -> None:
        self._graph = graph
        self._gone: set[int] = set()
        self._owner: dict[tuple[int, int], tuple[int, int]] = {}
        self._carrier: dict[tuple[int, int], tuple[int, int]] = {}

    def add(self, node: int) -> None:
        """Say that a node is eliminated."""
        self._gone.add(node)

    def carry(self, row: int) -> bool:
        """Whether all multipliers of a row find coordinates, which are then taken."""
        multipliers = [(row, k) for k in range(self._graph.sizes[row])]
        if all(self._assign(multiplier) for multiplier in multipliers):
            return True
        for multiplier in multipliers:
            if multiplier in self._carrier:
                del self._owner[self._carrier.pop(multiplier)]
        return False

    def _choices(self, multiplier: tuple[int, int]) -> Iterable[tuple[int, int]]:
        row, k = multiplier
        for node in self._graph.anchors[row]:
            if node not in self._gone:
                continue
            if self._graph.couplings[node, row]:
                yield from ((node, i) for i in range(self._graph.sizes[node]))
            else:
                yield node, k

    def _assign(self, multiplier: tuple[int, int]) -> bool:
        reached: dict[tuple[int, int], tuple[int, int]] = {}
        queue = [multiplier]
        for asking in queue:
            for choice in self._choices(asking):
                if choice in reached:
                    continue
                reached[choice] = asking
                if choice in self._owner:
                    queue.append(self._owner[choice])
                    continue
                free: tuple[int, int] | None = choice
                while free is not None:
                    taker = reached[free]
                    self._owner[free] = taker
                    free, self._carrier[taker] = self._carrier.get(taker), free
                return True
        return False


def block_order(graph: Graph) -> list[int]:
    """Return the blocks in their elimination order."""
    neighbours, weight = _neighbours(graph), graph.sizes
    degree = [sum(weight[b] for b in near) for near in neighbours]
    done = [False] * len(weight)
    carriers, waiting = Carriers(graph), set()
    # Rows enter the heap as neighbours of an eliminated block, so after one of their nodes.
    heap = [(degree[block], block) for block in range(graph.n_nodes)]
    heapq.heapify(heap)
    order: list[int] = []
    while heap or waiting:
        if not heap:  # dependent rows: nothing is left that could carry them
            block = min(waiting, key=lambda b: (degree[b], b))
        else:
            size, block = heapq.heappop(heap)
            if done[block] or size != degree[block]:
                continue
            if block >= graph.n_nodes and not carriers.carry(block):
                waiting.add(block)
                continue
        done[block] = True
        order.append(block)
        if block < graph.n_nodes:
            carriers.add(block)
        _take_out(block, neighbours, degree, weight)
        waiting -= {block, *neighbours[block]}
        for other in neighbours[block]:
            heapq.heappush(heap, (degree[other], other))
    assert len(order) == len(weight)
    return order


def _neighbours(graph: Graph) -> list[set[int]]:
    neighbours: list[set[int]] = [set() for _ in graph.sizes]
    for a, b in graph.couplings:
        if a != b:
            neighbours[a].add(b)
            neighbours[b].add(a)
    return neighbours


def _take_out(
    block: int, neighbours: list[set[int]], degree: list[int], weight: Sequence[int]
) -> None:
    """Take a block out of the graph: its neighbours become neighbours of each other."""
    near = neighbours[block]
    for other in near:
        neighbours[other] |= near
        neighbours[other] -= {other, block}
    for other in near:
        degree[other] = sum(weight[b] for b in neighbours[other])


def eliminate(graph: Graph) -> Pattern:
    """Return the order and the pattern of the factors of a graph."""
    order = block_order(graph)
    position, size = [0] * len(order), 0
    for block in order:
        position[block] = size
        size += graph.sizes[block]
    coupled: list[list[int]] = [[] for _ in range(size)]
    for (a, b), full in graph.couplings.items():
        for i in range(graph.sizes[a]):
            for k in range(graph.sizes[b]) if full else (i,):
                first, second = sorted((position[a] + i, position[b] + k))
                if first != second:
                    coupled[first].append(second)
    return _pattern(position, _fill(coupled))


def _fill(coupled: Sequence[Sequence[int]]) -> list[list[int]]:
    """Later places of each pivot: those of the matrix and of the pivots that led to it."""
    columns: list[list[int]] = []
    children: list[list[int]] = [[] for _ in coupled]
    for k, later in enumerate(coupled):
        places = set(later)
        for child in children[k]:
            places.update(columns[child])
        places.discard(k)
        columns.append(sorted(places))
        if places:
            children[columns[k][0]].append(k)
    return columns


def _pattern(position: list[int], columns: list[list[int]]) -> Pattern:
    ptr = array("i", [0])
    for places in columns:
        ptr.append(ptr[-1] + 1 + 2 * len(places))
    pattern = Pattern(
        position=array("i", position),
        ptr=ptr,
        column=array("i", [p for places in columns for p in places]),
        target=array("i"),
        _index=[{p: i for i, p in enumerate(places)} for places in columns],
    )
    for places in columns:
        pattern.target.extend(_targets(pattern, places))
    return pattern


def _targets(pattern: Pattern, places: list[int]) -> list[int]:
    """Stored entries of all pairs of places, row by row."""
    m = len(places)
    targets = [0] * (m * m)
    for i, first in enumerate(places):
        index, start = pattern._index[first], pattern.ptr[first]
        targets[i * m + i] = start
        for k in range(i + 1, m):
            upper = start + 1 + index[places[k]]
            targets[i * m + k] = upper
            targets[k * m + i] = upper + len(index)
    return targets
