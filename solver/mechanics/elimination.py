"""Elimination order and sparse pattern of the tangent, fixed at assembly (theory 4.2).

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
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache, cached_property
from itertools import chain, combinations_with_replacement
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from solver.runtime.errors import AssemblyError
from solver.runtime.layout import BODY_UNKNOWNS

Integers = NDArray[np.integer]

PAIRS_AT_ONCE = 100_000
"""Pairs whose stored entries are looked up in one go, which takes some 100 bytes a pair."""

MOST_PRODUCTS = 5_000_000
"""Products of one factorisation that every mechanism may need."""
MOST_OF_A_NET = 150
"""Products over n^1.5, of n unknowns, that a large one may need; nets of springs need 110."""
ROWS_OF_A_PILE = 10
"""Rows of contacts and frictions over coordinates from which on other rows are not tried first."""

NO_JOINT, GROUND = -2, -1


@dataclass(frozen=True, kw_only=True)
class Pattern:
    """Places of the unknowns in the elimination order, and the stored entries of the factors.

    A group has the later places of its last pivot, among which those of the others lie; what these
    lack is stored as zeros. p pivots with m later places have a block p x p, row by row, then the
    entries of U, then those of L: for `lanes` later places side by side, 2 in groups, those of one
    pivot after the other. The last place is listed twice where that makes m a multiple of `lanes`.
    A pivot alone has its diagonal, a row of U and a column of L.
    """

    position: Integers
    """First place of each block."""
    counts: Integers
    """Number of later places of each pivot."""
    column: Integers
    """These places, increasing, of one pivot after the other."""
    groups: Integers
    """First pivot of each group, and the end."""
    lanes: int
    parents: Integers
    """Of each group that is a body with its joint: `GROUND`, or the first later place of the other
    body, whose `BODY_UNKNOWNS` (turn, place) come first among these; of all others `NO_JOINT`."""

    @property
    def n_products(self) -> int:
        """Products of one factorisation."""
        return int(np.sum(self.counts**2))

    @property
    def n_operations(self) -> float:
        """Instructions of one factorisation and two solutions, see `_operations`."""
        groups = Counter(
            zip(self._size.tolist(), self.later.tolist(), self.parents == NO_JOINT, strict=True)
        )
        return sum(
            count * (_operations(p, m) if alone else _joint_operations(m))
            for (p, m, alone), count in groups.items()
        )

    @property
    def n_entries(self) -> int:
        """Stored entries of the factors."""
        return int(self.ptr[-1])

    @cached_property
    def _size(self) -> Integers:
        """Pivots of each group."""
        return np.diff(self.groups)

    @cached_property
    def _group(self) -> Integers:
        """Group of each pivot."""
        return np.repeat(np.arange(len(self._size)), self._size)

    @cached_property
    def later(self) -> Integers:
        """Number of later places of each group, a multiple of `lanes`."""
        own = self.counts[self.groups[1:] - 1]
        return own + -own % self.lanes

    @cached_property
    def begin(self) -> Integers:
        """Where the entries of each group begin, and the end of all."""
        return _pointers(self._size * (self._size + 2 * self.later))

    @cached_property
    def ptr(self) -> Integers:
        """Place of the diagonal of each pivot, one for all rows of a joint, and the end of all."""
        size = self._size[self._group]
        within = np.arange(len(self.counts)) - self.groups[self._group]
        of_joint = (self.parents[self._group] != NO_JOINT) & (within >= BODY_UNKNOWNS)
        within[of_joint] = size[of_joint] - 1
        return np.append(self.begin[self._group] + within * (size + 1), self.begin[-1])

    @cached_property
    def columns(self) -> Integers:
        """Later places of the groups, one after the other: of the parent first, then increasing."""
        last = self.groups[1:] - 1
        columns = np.empty(self.later.sum(), dtype=np.int64)
        group = np.repeat(np.arange(len(last)), self.counts[last])
        skipped = self._first[last] - _pointers(self.counts[last])[:-1]
        own = np.arange(len(group)) + skipped[group]
        columns[_pointers(self.later)[group] + self._rank[own]] = self.column[own]
        ends = _pointers(self.later)[1:][self.counts[last] < self.later]
        columns[ends - 1] = columns[ends - 2]
        return columns

    @cached_property
    def _rank(self) -> Integers:
        """Place of each element above the diagonal among those of the last pivot of a group."""
        rank = np.arange(len(self.column)) - np.repeat(self._first[:-1], self.counts)
        for group in np.flatnonzero(self.parents >= 0):
            first, end = self._first[self.groups[group + 1] - 1 :][:2]
            places, parent = self.column[first:end], self.parents[group]
            order = np.argsort(
                (places < parent) | (places >= parent + BODY_UNKNOWNS), kind="stable"
            )
            rank[first + order] = np.arange(end - first)
        return rank

    @cached_property
    def _first(self) -> Integers:
        """Where the later places of each pivot begin, and the end of all."""
        return _pointers(self.counts)

    @cached_property
    def _elements(self) -> Integers:
        """Of each stored element (i, j) above the diagonal n i + j; increasing."""
        n = len(self.counts)
        return n * np.repeat(np.arange(n), self.counts) + self.column

    def slots(self, i: Integers, j: Integers) -> Integers:
        """Return the stored entries of the matrix elements (i, j), both places in the order."""
        first, second = np.minimum(i, j), np.maximum(i, j)
        group = self._group[first]
        begin, p, last = self.groups[group], self._size[group], self.groups[group + 1] - 1
        element = len(self.counts) * last + second
        found = np.searchsorted(self._elements, element)
        inside = second <= last
        assert np.all(inside | (np.append(self._elements, -1)[found] == element)), "not stored"
        place = np.where(inside, 0, np.append(self._rank, 0)[found]) + np.where(
            i < j, 0, self.later[group]
        )
        whole, lane = np.divmod(place, self.lanes)
        beside = p * p + self.lanes * (p * whole + first - begin) + lane
        return self.begin[group] + np.where(inside, p * (i - begin) + j - begin, beside)

    @cached_property
    def target(self) -> Integers:
        """Entries that the update of each group goes to: all pairs of its places, row by row."""
        begin, first = _pointers(self.later**2), _pointers(self.later)
        target = np.empty(begin[-1], dtype=np.intc)
        for m in np.unique(self.later):
            alike = np.flatnonzero(self.later == m)
            for groups in np.array_split(alike[:, None], 1 + len(alike) * m * m // PAIRS_AT_ONCE):
                places = self.columns[first[groups] + np.arange(m)]
                rows, columns = np.repeat(places, m, axis=1), np.tile(places, (1, m))
                target[begin[groups] + np.arange(m * m)] = self.slots(rows, columns)
        return target


def _pointers(counts: Integers) -> Integers:
    """Where each of consecutive pieces begins, and the end of all."""
    return np.concatenate([[0], np.cumsum(counts)])


class TreeBody(NamedTuple):
    """Blocks of a body of a tree: its turn, its place, rows of the joint that carries it.

    These are a coincidence, which is one block, and up to three directions; none of a free body.
    """

    blocks: tuple[int, ...]
    parent: int | None = None
    """Turn of the other body of the joint, if it is not the ground."""


@dataclass(frozen=True, slots=True)
class Graph:
    """Blocks and how they are coupled.

    `sizes` of the blocks, the first `n_nodes` of them nodes; `couplings` of two blocks: False where
    equal components are coupled, True where all are; `anchors` of each row: the nodes that can
    carry it, those in which its gradient does not vanish; `islands` of the blocks: nothing is
    coupled to another island, and the order keeps each in one piece.
    """

    sizes: Sequence[int]
    n_nodes: int
    couplings: Mapping[tuple[int, int], bool]
    anchors: Mapping[int, Sequence[int]]
    islands: Sequence[int]
    loose: frozenset[int] = frozenset()
    """Rows of contacts and frictions: where too many of them couple the same nodes, they are
    eliminated first, by their bare regularisation."""
    trees: Sequence[TreeBody] = ()
    """Bodies of trees, which are eliminated with their joints."""

    def couplings_of_trees(self) -> dict[tuple[int, int], bool]:
        """Return those that the factors of a body with its joint store, zero or not: all to all.

        A joint at the centre of mass of a body does not couple the turn of this one to its place.
        """
        own = {None: ()} | {body.blocks[0]: body.blocks[:2] for body in self.trees}
        whole = ((*x.blocks, *own[x.parent]) for x in self.trees if len(x.blocks) > 2)
        pairs = chain.from_iterable(combinations_with_replacement(sorted(x), 2) for x in whole)
        return dict.fromkeys(pairs, True)

    def joined(self) -> Graph:
        """Return the graph in which each body of a tree is one node, its joint's rows with it."""
        first = {block: body.blocks[0] for body in self.trees for block in body.blocks}
        kept = [block for block in range(len(self.sizes)) if first.get(block, block) == block]
        number = {block: k for k, block in enumerate(kept)}
        sizes, couplings = [0] * len(kept), dict[tuple[int, int], bool]()
        of = [number[first.get(block, block)] for block in range(len(self.sizes))]
        for block, size in enumerate(self.sizes):
            sizes[of[block]] += size
        for (x, y), full in self.couplings.items():
            a, b = sorted((of[x], of[y]))
            couplings[a, b] = couplings.get((a, b), False) or full or x in first or y in first
        anchors = {
            of[x]: [of[y] for y in near] for x, near in self.anchors.items() if x not in first
        }
        return Graph(
            sizes, sum(block < self.n_nodes for block in kept), couplings, anchors,
            [self.islands[block] for block in kept], frozenset(of[x] for x in self.loose),
            [
                TreeBody((of[x.blocks[0]],), None if x.parent is None else of[x.parent])
                for x in self.trees
            ],
        )  # fmt: skip


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
                while choice is not None:
                    taker = self._owner[choice] = reached[choice]
                    choice, self._carrier[taker] = self._carrier.get(taker), choice
                return True
        return False


def block_order(graph: Graph) -> list[int]:
    """Return the blocks in their elimination order.

    Each of n balls may touch each other one, so that their rows are n^2/2, of which few hold at a
    time. Between the nodes they would fill the whole pattern. Eliminated first, a row adds the four
    or so products of its own nodes. Iterations lose the digits that this costs, not the solution.
    So they come first where they are many more than the coordinates, or take too many products.

    Raises
    ------
    AssemblyError
        When the factorisation would need too many products.
    """
    coordinates = sum(graph.sizes[: graph.n_nodes])
    if sum([graph.sizes[row] for row in graph.loose]) > ROWS_OF_A_PILE * coordinates:
        return _order(graph, graph.loose)
    try:
        return _order(graph, frozenset())
    except AssemblyError:
        if not graph.loose:
            raise
        return _order(graph, graph.loose)


def _order(graph: Graph, loose: frozenset[int]) -> list[int]:
    """Return such an order, with loose rows first; bodies of trees come after those they carry."""
    weight, neighbours = graph.sizes, [set[int]() for _ in graph.sizes]
    for a, b in graph.couplings:
        if a != b:
            neighbours[a].add(b)
            neighbours[b].add(a)
    left = _most_products(graph)
    loose |= {row for row in range(graph.n_nodes, len(weight)) if not neighbours[row]}
    degree = [sum([weight[b] for b in near]) for near in neighbours]
    done = [False] * len(weight)
    carriers, waiting = Carriers(graph), set()
    children = Counter(body.parent for body in graph.trees)
    parent = {body.blocks[0]: body.parent for body in graph.trees}
    # Rows enter the heap as neighbours of an eliminated block, so after one of their nodes.
    heap = [(degree[block], block) for block in chain(range(graph.n_nodes), loose)]
    heapq.heapify(heap)
    order: list[int] = []
    while heap or waiting:
        if not heap:  # dependent rows: nothing is left that could carry them
            block = min(waiting, key=lambda b: (degree[b], b))
        else:
            size, block = heapq.heappop(heap)
            if done[block] or size != degree[block] or children[block]:
                continue
            carried = block < graph.n_nodes or block in loose or carriers.carry(block)
            if not carried:
                waiting.add(block)
                continue
        done[block] = True
        order.append(block)
        children[parent.get(block)] -= 1
        left -= weight[block] * degree[block] ** 2
        # Its neighbours are neighbours of each other now, whatever their own order will be.
        if left < degree[block] ** 3 / 3:
            raise AssemblyError(_too_dense(graph))
        waiting.discard(block)
        if block < graph.n_nodes:
            carriers.add(block)
            waiting -= neighbours[block]
        _take_out(block, neighbours, degree, weight)
        for other in neighbours[block] - waiting:
            heapq.heappush(heap, (degree[other], other))
    assert len(order) == len(weight)
    return order


def _most_products(graph: Graph) -> float:
    return max(MOST_PRODUCTS, MOST_OF_A_NET * sum(graph.sizes) ** 1.5)


def _too_dense(graph: Graph) -> str:
    moving, rows = sum(graph.sizes[: graph.n_nodes]), sum(graph.sizes[graph.n_nodes :])
    remedy = "constraints that repeat others" if rows > moving else "forces between distant parts"
    most = f"{_most_products(graph):,.0f} products"
    return (
        f"the {moving} moving coordinates are coupled too densely, by {rows} constraint rows and "
        f"by forces: one factorisation would take more than {most}; remove {remedy}"
    )


def _take_out(
    block: int, neighbours: list[set[int]], degree: list[int], weight: Sequence[int]
) -> None:
    """Take a block out of the graph: its neighbours become neighbours of each other."""
    near = neighbours[block]
    for other in near:
        around = neighbours[other]
        new = near - around
        new.discard(other)
        around |= new
        around.discard(block)
        degree[other] += sum([weight[b] for b in new]) - weight[block]


def eliminate(graph: Graph, most: int | None = None) -> Pattern:
    """Return the order and pattern of a graph's factors, alone or in groups of `most` pivots."""
    order = sorted(_expanded_order(graph), key=graph.islands.__getitem__)
    sizes = np.array(graph.sizes, dtype=np.int64)
    position = np.empty(len(order), dtype=np.int64)
    position[order] = _pointers(sizes[order])[:-1]
    columns = _fill(_coupled(graph, position, sizes))
    parents, with_joints = dict[int, int](), dict[int, int]()
    for body in graph.trees:
        if len(body.blocks) > 2:
            first = int(position[body.blocks[0]])
            parents[first] = GROUND if body.parent is None else int(position[body.parent])
            with_joints[first] = int(sizes[[*body.blocks]].sum())
    groups = _groups(columns, most, with_joints) if most else range(len(columns) + 1)
    return Pattern(
        position=position,
        counts=np.array([len(places) for places in columns], dtype=np.int64),
        column=np.fromiter(chain.from_iterable(columns), dtype=np.int64),
        groups=np.array(groups, dtype=np.int64),
        lanes=2 if most else 1,
        parents=np.array([parents.get(first, NO_JOINT) for first in groups[:-1]], dtype=np.int64),
    )


def _expanded_order(graph: Graph) -> list[int]:
    """Return the elimination order of the blocks; those of a body of a tree follow each other."""
    if not graph.trees:
        return block_order(graph)
    blocks = {body.blocks[0]: body.blocks for body in graph.trees}
    inner = {block for body in graph.trees for block in body.blocks[1:]}
    kept = [block for block in range(len(graph.sizes)) if block not in inner]
    try:
        found = [kept[k] for k in block_order(graph.joined())]
    except AssemblyError:  # the joined graph would count rows of joints as coordinates
        raise AssemblyError(_too_dense(graph)) from None
    return [x for block in found for x in blocks.get(block, (block,))]


def _groups(
    columns: Sequence[Sequence[int]], most: int, with_joints: Mapping[int, int]
) -> list[int]:
    """First pivots of groups, and the end, of those that take the fewest operations.

    A pivot whose first later place is the next pivot has all other later places with it, and can
    share its group; what that one has besides is stored as zeros. `with_joints` are the sizes of
    groups of a body with its joint, by their first pivots.
    """
    least, first = [0.0], [0]
    inside = {k: begin for begin, size in with_joints.items() for k in range(begin, begin + size)}
    for end in range(1, len(columns) + 1):
        if (begin := inside.get(end - 1)) is not None:
            least.append(least[begin])
            first.append(begin)
            continue
        begins = [end - 1]
        for begin in range(end - 1, max(end - most, 0), -1):
            if columns[begin - 1][:1] != [begin] or begin - 1 in inside:
                break
            begins.append(begin - 1)
        later = len(columns[end - 1])
        costs = [least[begin] + _operations(end - begin, later) for begin in begins]
        least.append(min(costs))
        first.append(begins[costs.index(least[-1])])
    found = [len(columns)]
    while found[-1] > 0:
        found.append(first[found[-1]])
    return found[::-1]


def _joint_operations(m: int) -> float:
    """Instructions that a body with its joint takes in one factorisation and two solutions.

    Counted for a hinge, of articulated.h compiled for x86-64: 2.4 thousand with m = 6.
    """
    m += m % 2
    return 1800.0 + 60.0 * m + 6.0 * m * m


@cache
def _operations(p: int, m: int) -> float:
    """Instructions that a group takes in one factorisation and two solutions.

    Of p pivots with m later places; counted, of block_lu.c compiled for x86-64.
    """
    m += m % 2
    factors = 45 + m * m * (1.4 * p + 7.3) + m * p * (p + 10.6) + 1.7 * p**3
    return factors + 2 * (30 + m * (3.4 * p + 9.8) + p * (0.8 * p + 21))


def _coupled(graph: Graph, position: Integers, sizes: Integers) -> list[list[int]]:
    """Later places that the matrix couples each place to, increasing."""
    n = int(sizes.sum())
    couplings = {**graph.couplings, **graph.couplings_of_trees()}
    pairs = np.fromiter(chain.from_iterable(couplings), dtype=np.int64).reshape(-1, 2)
    full = np.fromiter(couplings.values(), dtype=bool)
    elements: list[Integers] = [np.empty(0, dtype=np.int64)]
    for i in range(sizes.max(initial=0)):
        for k in range(sizes.max()):
            a, b = pairs[full | (i == k)].T
            x, y = position[a] + i, position[b] + k
            kept = (i < sizes[a]) & (k < sizes[b]) & (x != y)
            elements.append((n * np.minimum(x, y) + np.maximum(x, y))[kept])
    found = np.sort(np.concatenate(elements))
    found = found[np.append(True, found[1:] != found[:-1])[: len(found)]]
    first, second = np.divmod(found, n)
    begin = np.searchsorted(first, np.arange(n + 1)).tolist()
    later = second.tolist()
    return [later[begin[k] : begin[k + 1]] for k in range(n)]


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
