"""Elimination order and sparse pattern of the tangent, fixed when a mechanism is assembled.

The KKT graph has nodes (blocks of `dim` coordinates) and rows (one multiplier each). Blocks are
eliminated by minimum degree; a row waits until one of its nodes is gone, so that its pivot is the
negative definite -(eps + h G A^-1 G') and never the bare regularisation. Chains and trees are then
eliminated from the leaves without fill-in, at a cost linear in the number of bodies; loops are
bordered by what minimum degree leaves. (Tinney & Walker 1967; George & Liu 1989.)
"""

from __future__ import annotations

import heapq
from array import array
from collections.abc import Iterable, Sequence
from dataclasses import dataclass


@dataclass(frozen=True, slots=True, kw_only=True)
class Pattern:
    """Places of the unknowns in the elimination order, and the stored entries of the factors.

    Pivot k owns the entries ``ptr[k]:ptr[k + 1]``: diagonal, U row, L column; ``column`` lists its
    later places, ``target`` the entries that its update goes to, row by row.
    """

    node_position: array
    row_position: array
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


def block_order(neighbours: list[set[int]], n_nodes: int, dim: int) -> list[int]:
    """Return the blocks in their elimination order; the first `n_nodes` are nodes, the rest rows.

    `neighbours` (modified) holds the blocks that each block is coupled to.
    """
    weight = [dim] * n_nodes + [1] * (len(neighbours) - n_nodes)
    degree = [sum(weight[b] for b in near) for near in neighbours]
    done = [False] * len(weight)
    # Rows enter the heap as neighbours of an eliminated block, so after one of their nodes.
    heap = [(degree[block], block) for block in range(n_nodes)]
    heapq.heapify(heap)
    order = []
    while heap:
        size, block = heapq.heappop(heap)
        if done[block] or size != degree[block]:
            continue
        done[block] = True
        order.append(block)
        near = neighbours[block]
        for other in near:
            neighbours[other] |= near
            neighbours[other] -= {other, block}
        for other in near:
            degree[other] = sum(weight[b] for b in neighbours[other])
            heapq.heappush(heap, (degree[other], other))
    assert len(order) == len(weight)
    return order


def eliminate(
    n_nodes: int, dim: int, rows: Sequence[Sequence[int]], couplings: Iterable[Sequence[int]]
) -> Pattern:
    """Return the pattern for nodes coupled by rows and by `couplings` (masses and forces).

    Parameters
    ----------
    n_nodes, dim : int
        Number of free nodes and coordinates of each.
    rows : sequence of sequences of int
        Free nodes of each constraint row.
    couplings : iterable of sequences of int
        Free nodes that a mass or a force couples with each other.
    """
    neighbours: list[set[int]] = [set() for _ in range(n_nodes + len(rows))]
    for nodes in (*rows, *couplings):
        for node in nodes:
            neighbours[node].update(other for other in nodes if other != node)
    for row, nodes in enumerate(rows):
        neighbours[n_nodes + row].update(nodes)
        for node in nodes:
            neighbours[node].add(n_nodes + row)
    adjacent = [sorted(near) for near in neighbours]
    order = block_order(neighbours, n_nodes, dim)
    position, size = [0] * len(order), 0
    for block in order:
        position[block] = size
        size += dim if block < n_nodes else 1
    scalars = [
        range(position[b], position[b] + (dim if b < n_nodes else 1)) for b in range(len(order))
    ]
    columns = _fill([[scalars[b] for b in (block, *adjacent[block])] for block in order], size)
    return _pattern(position[:n_nodes], position[n_nodes:], columns)


def _fill(coupled: Sequence[Sequence[range]], size: int) -> list[list[int]]:
    """Later places of each pivot: those of the matrix and of the pivots that led to it."""
    columns: list[list[int]] = [[] for _ in range(size)]
    children: list[list[int]] = [[] for _ in range(size)]
    for ranges in coupled:
        own = ranges[0]
        for k in own:
            places = {p for places in ranges for p in places if p > k}
            for child in children[k]:
                places.update(columns[child])
            places.discard(k)
            columns[k] = sorted(places)
            if places:
                children[columns[k][0]].append(k)
    return columns


def _pattern(
    node_position: list[int], row_position: list[int], columns: list[list[int]]
) -> Pattern:
    ptr = array("i", [0])
    for places in columns:
        ptr.append(ptr[-1] + 1 + 2 * len(places))
    pattern = Pattern(
        node_position=array("i", node_position),
        row_position=array("i", row_position),
        ptr=ptr,
        column=array("i", [p for places in columns for p in places]),
        target=array("i"),
        _index=[{p: i for i, p in enumerate(places)} for places in columns],
    )
    for places in columns:
        pattern.target.extend(pattern.slot(i, j) for i in places for j in places)
    return pattern
