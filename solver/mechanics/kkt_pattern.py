"""Where in the factors of the tangent each contribution goes, and what is coupled there.

A contribution is a list of pieces, each between some blocks and others; blocks are the free nodes,
then the rows in the order of the multipliers. Masses, the stiffness of forms without quarter turns
and coincidences join equal components of two blocks only; all others fill blocks of the matrix.
Which nodes can carry a row is told by their shares of its G M^-1 G' as drawn.
"""

from __future__ import annotations

from array import array
from collections.abc import Iterable, Sequence
from itertools import accumulate, chain, pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from solver.mechanics.elimination import Graph, Integers, TreeBody, eliminate
from solver.mechanics.mechanism import Load
from solver.mechanics.structure import ROW_KINDS, Composite, Structure, flat, pointers
from solver.mechanics.trees import CarriedBody, carried_bodies
from solver.runtime.layout import (
    FACTORS,
    FEW_CONTACTS,
    FORM_AXES,
    FORM_LINEAR,
    FORM_TURNED,
    MOST_IN_GROUP,
    TABLES,
)

WEAK = 1e-4
"""A node whose share of a row's G M^-1 G' is smaller than this part of the largest carries none."""

Reals = NDArray[np.float64]


class RowOrder:
    """Shares of the nodes in the rows of a mechanism, with the default numbers."""

    def __init__(self, structure: Structure) -> None:
        self._structure, mechanism = structure, structure.mechanism
        self._default = mechanism.default
        masses = ((a, self._default(mass)) for a, b, mass in structure.masses if a == b)
        self._masses = {node: mass for node, mass in masses if mass > 0.0}
        self._begin = np.cumsum([0, *map(len, structure.entries)]).tolist()
        entries = [entry for entries in structure.entries for entry in entries]
        self._nodes = [entry.node for entry in entries]
        self._alpha = self._values(x for entry in entries for x in entry.alpha).reshape(-1, 2)
        self._beta = self._values(x for entry in entries for x in entry.beta).reshape(-1, 2)
        with np.errstate(over="ignore", invalid="ignore"):  # checked when numbers are final
            gradients = self._gradients(mechanism.dim)
            self._squares = (gradients**2).sum(axis=1).tolist()
            self._direct = (self._alpha**2).sum(axis=1).tolist()

    def _values(self, numbers: Iterable) -> Reals:
        return np.array([x if type(x) is float else self._default(x) for x in numbers])

    def _gradients(self, dim: int) -> Reals:
        """Gradient of each entry's form with respect to its node: ndarray, shape (entries, dim)."""
        places = self._values(x for node in self._structure.nodes for x in node.position)
        places = places.reshape(-1, dim)[self._nodes]
        counts = np.diff(self._begin)
        form = np.repeat(np.arange(len(counts)), counts)
        u, w = np.zeros((2, len(counts), dim))
        for side, coefficients in ((u, self._alpha), (w, self._beta)):
            straight, turn = coefficients.T[:, :, None]
            np.add.at(side, form, straight * places + (turn * _turned(places) if dim == 2 else 0.0))
        a, a_turn, b, b_turn = np.column_stack([self._alpha, self._beta]).T[:, :, None]
        gradients = a * w[form] + b * u[form]
        if dim == 2:  # the transpose of J is -J
            gradients -= a_turn * _turned(w[form]) + b_turn * _turned(u[form])
        return gradients

    def of_rows(self) -> list[list[int]]:
        """Return the nodes that can carry each row, in the order of the multipliers."""
        structure, first = self._structure, len(self._structure.elements)
        functions = structure.composites[first : first + len(structure.functions)]
        return [
            *(self._heavy([row.form], self._squares) for row in structure.form_rows.items),
            *(self._heavy([row.form], self._direct) for row in structure.coincidences.items),
            *(self._heavy(composite.forms, self._squares) for composite in functions),
        ]

    def _heavy(self, forms: Sequence[int], sizes: Sequence[float]) -> list[int]:
        """Free nodes with a share of G M^-1 G' that is not negligible."""
        shares: dict[int, float] = {}
        for form in forms:
            for entry in range(self._begin[form], self._begin[form + 1]):
                node = self._nodes[entry]
                if node < self._structure.n_free:
                    share = sizes[entry] / self._masses.get(node, 1.0)
                    shares[node] = shares.get(node, 0.0) + share
        least = WEAK * max(shares.values(), default=0.0)
        return [node for node, share in shares.items() if share >= least]


def _turned(vectors: Reals) -> Reals:
    """Return the rows turned by a right angle."""
    return np.column_stack([-vectors[:, 1], vectors[:, 0]])


EQUAL, BLOCKS, ROWS = range(3)
"""Elements of a piece: of equal components; all, block by block; all, row by row."""
Nodes = Sequence[int]
Piece = tuple[Nodes, Nodes, int]
"""Blocks, those that they are coupled with, and how."""


class TangentPattern:
    """Blocks of a mechanism's tangent, and the contributions to it by their names in the tables.

    A lean one (or a bare one) has no stiffness: only masses couple nodes. An open or bare one has
    no rows of contacts and frictions: they come last, coupled to nothing, with their diagonals for
    all their slots. The turn of each body has the place of its directors, and rows that keep these
    rigid have none.
    """

    def __init__(
        self,
        structure: Structure,
        anchors: Sequence[Nodes],
        kind: str = "",
        trees: Sequence[CarriedBody] = (),
    ) -> None:  # fmt: skip
        self.structure, self.kind = structure, kind
        self.lean = kind in ("lean_", "bare_")
        dim, nodes = structure.mechanism.dim, range(structure.n_free)
        self.kinds = (
            (dim, structure.free_nodes), (1, structure.joint_rows), (1, structure.rigidity_rows),
            (dim, structure.coincidences), (1, structure.function_rows),
            (1, structure.velocity_rows),
        )  # fmt: skip
        """Coordinates or multipliers of nodes and of each kind of rows: items, in this order."""
        self.sizes = [width for width, part in self.kinds for _ in range(len(part))]
        """Entries of each item in a piece."""
        self.ends = [*accumulate(len(part) for _, part in self.kinds)]
        self.turning = [False] * self.ends[-1]
        """Whether an item is a director that turns with its body."""
        self.block = [*range(self.ends[-1])]
        """Of an item: the one whose places in the order it has. Rows that hold anyway have -1."""
        self.turning[: len(nodes)] = [structure.node_kinds[n] > 0 for n in nodes]
        self.block[: len(nodes)] = map(structure.unknown, nodes)
        self.block[self.ends[1] : self.ends[2]] = [-1] * (self.ends[2] - self.ends[1])
        self.sizes[: len(nodes)] = [
            2 * dim - 3 if turns else dim for turns in self.turning[: len(nodes)]
        ]
        self.contributions = self._contributions()
        loose = self._loose()
        asleep: frozenset[int] = frozenset()
        if kind in ("open_", "bare_"):
            slips, first = structure.velocity_rows.place, self.ends[4]
            rows = (row for x in structure.mechanism.frictions for row in x.rows)
            asleep = loose | {first + slips[row] for row in rows}
        for pieces in (*self.contributions["composite"], *self.contributions["cone"]):
            row = pieces[-1][0] if pieces else ()
            if asleep.issuperset(row):
                pieces[:] = [(row, row, BLOCKS)] * self._n_elements(pieces)
        few = bool(asleep) or len(structure.mechanism.contacts) <= FEW_CONTACTS
        self.grouped = bool(structure.bodies.items) and few
        """Whether pivots make groups: of many contacts few are closed, and most entries zero."""
        blocks = sorted({*self.block} - {-1})
        number = {block: k for k, block in enumerate(blocks)}
        self.of = [number.get(block, -1) for block in self.block]
        """Number of an item's block in the graph, or -1."""
        islands = self._islands(asleep)
        self.islands = [islands[block] for block in blocks]
        self.block_sizes = [self.sizes[block] for block in blocks]
        self.pattern = eliminate(
            Graph(
                self.block_sizes, sum(block < len(nodes) for block in blocks), self._couplings(),
                {
                    of: [*dict.fromkeys([self.of[n] for n in carrying])]
                    for of, carrying in zip(self.of[len(nodes) :], anchors, strict=True)
                    if of >= 0
                },
                self.islands, frozenset([self.of[row] for row in loose]),
                self._tree_bodies(trees) if self.grouped else (),
            ),
            MOST_IN_GROUP if self.grouped else None,
        )  # fmt: skip

    def directors(self, first: int | None) -> list[int]:
        """Return the directors of a body, given the first one's node."""
        structure = self.structure
        return [structure.node_of[n] for n in structure.mechanism.directors(first)]

    # -------------------------------------------------------------------------- contributions

    def _contributions(self) -> dict[str, list[list[Piece]]]:
        structure, ends, links = self.structure, self.ends, self.structure.coincidences.items
        n_elements, n_potentials = len(structure.elements), len(structure.potentials)
        rows = [None] * n_elements + [*range(ends[3], ends[5])] + [None] * n_potentials
        between_free = structure.masses[: len(structure.free_masses)]
        kept = structure.joint_rows.items
        first = [structure.node_of[body] for body in structure.bodies.items]
        found: dict[str, list[list[Piece]]] = {
            "mass": [[] if self.turning[a] else [((a,), (b,), EQUAL)] for a, b, _ in between_free],
            "inertia": [[((a,), (a,), BLOCKS)] for a in first],
            "row": [self._form_row(row.form, k) for k, row in enumerate(kept, ends[0])],
            "coincidence": [
                self._link(row.form, k) for k, row in enumerate(links, ends[2])
            ],
            "composite": [
                self._composite(composite, row)
                for composite, row in zip(structure.composites, rows, strict=True)
            ],
            "cone": self._cones(),
            "load": [[] for _ in structure.loads.items],
            "moment": [[] for _ in structure.moments.items],
            "body_moment": [],
        }  # fmt: skip
        found["row"] += [[] for _ in range(len(structure.form_rows) - len(kept))]
        if not self.lean:
            followers = map(self._follower, structure.loads.items)
            found["load"] = [[(*x, BLOCKS)] if x else [] for x in followers]
            moved = [structure.free(moment.form) for moment in structure.moments.items]
            found["moment"] = [[(nodes, nodes, BLOCKS)] for nodes in moved]
            turned = [self.directors(moment.node) for moment in structure.body_moments.items]
            found["body_moment"] = [[(nodes, nodes, BLOCKS)] for nodes in turned]
        return found

    def _unknown(self, nodes: Iterable[int]) -> list[int]:
        """Return the nodes whose unknowns move some nodes, each once."""
        return [*dict.fromkeys(map(self.block.__getitem__, nodes))]

    def _form_row(self, form: int, row: int) -> list[Piece]:
        free, kind = self._unknown(self.structure.free(form)), self.structure.kinds[form]
        if self.lean or kind & FORM_LINEAR:
            return _border(free, row)
        between_axes = kind & FORM_AXES and self.turning[free[0]]
        if between_axes:  # what each body does to itself goes to its inertia
            pairs = (free, free[::-1])
            return [*(((a,), (b,), BLOCKS) for a, b in pairs), *_border(free, row)]
        return [(free, free, BLOCKS if kind & FORM_TURNED else EQUAL), *_border(free, row)]

    def _link(self, form: int, row: int) -> list[Piece]:
        how = BLOCKS if self.structure.kinds[form] & FORM_TURNED else EQUAL
        pairs = [((a,), (row,)) for a in self._unknown(self.structure.free(form))]
        return [(*x, how) for first, second in pairs for x in ((first, second), (second, first))]

    def _composite(self, composite: Composite, row: int | None) -> list[Piece]:
        nodes = self._unknown(composite.nodes)
        square: list[Piece] = [] if self.lean else [(nodes, nodes, ROWS)]
        return square if row is None else square + _border(nodes, row)

    def _loose(self) -> frozenset[int]:
        """Rows of contacts and their frictions."""
        structure, mechanism = self.structure, self.structure.mechanism
        functions, slips = structure.function_rows.place, structure.velocity_rows.place
        touching = mechanism.contacts
        return frozenset(
            [self.ends[3] + functions[contact.row] for contact in touching]
            + [
                self.ends[4] + slips[row]
                for contact in touching
                if contact.friction >= 0
                for row in mechanism.frictions[contact.friction].rows
            ]
        )

    def _cones(self) -> list[list[Piece]]:
        """Each velocity row of a friction with the rows that make its normal force."""
        structure, ends = self.structure, self.ends
        parts = structure.form_rows, structure.coincidences, structure.function_rows
        places = (part.place for part in (*parts, structure.velocity_rows))
        begin = ends[0], ends[2], ends[3], ends[4]
        first: dict[str, tuple[int, list[int]]]
        first = dict(zip(ROW_KINDS, zip(begin, places, strict=True), strict=True))

        def item(kind: str, row: int) -> tuple[int]:
            return (first[kind][0] + first[kind][1][row],)

        return [
            [
                (item("velocity", slip), item(*row), BLOCKS)
                for slip in friction.rows
                for group in friction.normal
                for row in group
            ]
            for friction in structure.mechanism.frictions
        ]

    def _follower(self, load: Load) -> tuple[Nodes, Nodes] | None:
        """Free nodes of a load in body axes, and the directors of these."""
        if load.axes is None:
            return None
        return self.structure.free(load.form), self.directors(load.axes)

    # ------------------------------------------------------------------------------- the graph

    def _tree_bodies(self, trees: Sequence[CarriedBody]) -> list[TreeBody]:
        """Return the blocks of bodies that are eliminated with the joints that carry them."""
        first, found = self.ends, []
        for body in trees:
            blocks, joint = [body.turn, body.place], body.joint
            if joint is not None:
                blocks.append(first[2] + joint.coincidence)
                blocks += [first[0] + row for row in joint.directions]
            parent = None if body.parent is None else self.of[body.parent]
            found.append(TreeBody(tuple([self.of[item] for item in blocks]), parent))
        return found

    def _couplings(self) -> dict[tuple[int, int], bool]:
        """Of coupled blocks: False where equal components are coupled, True where all are."""
        followers = map(self._follower, () if self.lean else self.structure.loads.items)
        whole = [[*x[0], *x[1]] for x in followers if x]
        cones = chain.from_iterable(self.contributions["cone"])
        pairs = _pairs([
            *chain.from_iterable(chain.from_iterable(self.contributions.values())),
            *((x, x, BLOCKS) for x in whole),
            *((b, a, how) for a, b, how in cones),
        ])  # fmt: skip
        of, n = np.array(self.of, dtype=np.int64), len(self.block_sizes)
        x, y = of[pairs.a], of[pairs.b]
        if (x < 0).any() or (y < 0).any():
            msg = "a row that needs no block of its own is coupled to others"
            raise ValueError(msg)
        keys = 2 * (n * x + y) + ((pairs.how != EQUAL) | self._turns(pairs))
        keys = np.sort(keys[x <= y])
        keys = keys[np.append(keys[1:] // 2 != keys[:-1] // 2, True)[: len(keys)]]
        x, y = np.divmod(keys // 2, n)
        return dict(zip(zip(x.tolist(), y.tolist(), strict=True), keys % 2 == 1, strict=True))

    def _turns(self, pairs: Pairs) -> NDArray[np.bool_]:
        """Whether one of the items of each pair is a director that turns with its body."""
        turning = np.array(self.turning, dtype=bool)
        return turning[pairs.a] | turning[pairs.b]

    def _islands(self, last: frozenset[int]) -> list[int]:
        """Islands of the items; some come last, behind those of all islands."""
        ends = [pairwise(part.begin) for _, part in self.kinds]
        found = [island for x in ends for island, (a, b) in enumerate(x) for _ in range(a, b)]
        return [len(self.kinds[0][1].begin) if k in last else x for k, x in enumerate(found)]

    def _n_elements(self, pieces: Sequence[Piece]) -> int:
        """Elements of the pieces of a composite or a cone."""
        sizes = self.sizes
        return sum([sizes[a] * sizes[b] for x, y, _ in pieces for a in x for b in y])

    # ------------------------------------------------------------------------------- the slots

    def tables(self) -> dict[str, array]:
        """Return the tables of the elimination."""
        pattern, n_nodes, dim = self.pattern, self.ends[0], self.structure.mechanism.dim
        first, sizes = np.append(pattern.position, -1)[self.of], np.array(self.sizes, int)
        own = np.where(np.array(self.block[:n_nodes]) == np.arange(n_nodes), first[:n_nodes], -1)
        item, k = _counted(np.where(first < 0, 1, sizes)[n_nodes:])
        tables = {
            "node_position": _table(own),
            "row_position": _table(first[n_nodes:][item] + k),
            "lu_ptr": _table(pattern.ptr),
            "lu_group": _table(self._groups() if self.grouped else pattern.groups[:0]),
            "lu_column": _table(pattern.columns),
            "lu_target": _table(pattern.target),
            "lu_island": self._pieces_of_islands(),
        }
        pieces = [*chain.from_iterable(chain.from_iterable(self.contributions.values()))]
        piece, i, j = self._elements(pieces, first, sizes)
        slots, begin = pattern.slots(i, j), np.searchsorted(piece, np.arange(len(pieces) + 1))
        end = 0
        for name, each in self.contributions.items():
            ptr = begin[end + np.array(pointers(each))]
            end += sum(map(len, each))
            tables[f"{name}_slot_ptr"] = _table(ptr - ptr[0])
            tables[f"{name}_slot"] = _table(slots[ptr[0] : ptr[-1]])
        masses = np.full((len(self.contributions["mass"]), dim), -1)
        masses[[bool(x) for x in self.contributions["mass"]]] = np.reshape(
            tables["mass_slot"], (-1, dim)
        )
        tables["mass_slot"] = _table(masses.ravel())
        named = {f"{self.kind}{x}": table for x, table in tables.items()}
        return {name: table for name, table in named.items() if name in TABLES}

    def _groups(self) -> Integers:
        """Of each group first pivot, number of later places, 1 with a parent; and the end."""
        pattern = self.pattern
        columns = pattern.groups[:-1], pattern.later, (pattern.parents >= 0).astype(np.int64)
        return np.append(np.column_stack(columns), pattern.groups[-1])

    def _pieces_of_islands(self) -> array:
        """Of each island, and the end: its first pivot, its group, targets and columns of this."""
        count, pattern = self.structure.islands.count, self.pattern
        sizes = np.bincount(self.islands, self.block_sizes, count)
        pivots = np.array([0, *np.cumsum(sizes)][: count + 1], dtype=np.int64)
        groups = np.searchsorted(pattern.groups, pivots)
        targets, columns = (np.append(0, np.cumsum(x)) for x in (pattern.later**2, pattern.later))
        return _table(np.column_stack([pivots, groups, targets[groups], columns[groups]]).ravel())

    def _elements(
        self, pieces: Sequence[Piece], first: Integers, sizes: Integers
    ) -> tuple[Integers, Integers, Integers]:
        """Return the elements (i, j) of pieces, each with the number of its piece.

        `first` is the first place of each item in the order, `sizes` how many follow.
        """
        pairs = _pairs(pieces)
        equal = (pairs.how == EQUAL) & ~self._turns(pairs)
        width = np.where(equal, 1, sizes[pairs.b])
        pair, k = _counted(sizes[pairs.a] * width)
        row, column = np.divmod(k, width[pair])
        column = np.where(equal[pair], row, column)
        piece, i, j = pairs.piece[pair], first[pairs.a][pair] + row, first[pairs.b][pair] + column
        by_rows = np.flatnonzero((pairs.how == ROWS)[pair])
        order = by_rows[np.lexsort((row[by_rows], pairs.row[pair][by_rows], piece[by_rows]))]
        i[by_rows], j[by_rows] = i[order], j[order]
        return piece, i, j


class Pairs(NamedTuple):
    """Pairs of items of pieces, block by block."""

    piece: Integers
    """Number of the piece."""
    a: Integers
    b: Integers
    row: Integers
    """Place of the first item among those of the piece."""
    how: Integers


def _pairs(pieces: Sequence[Piece]) -> Pairs:
    firsts, seconds, how = zip(*pieces, strict=True) if pieces else ((), (), ())
    begin, of_b = pointers(firsts), np.array(pointers(seconds), dtype=np.int64)
    width = np.diff(of_b)
    piece, k = _counted(np.diff(begin) * width)
    row, column = np.divmod(k, width[piece])
    a = np.array(flat(firsts))[np.array(begin)[piece] + row]
    return Pairs(
        piece, a, np.array(flat(seconds))[of_b[piece] + column], row, np.array(how, int)[piece]
    )


def _counted(counts: Integers) -> tuple[Integers, Integers]:
    """Return the numbers of some lists, each as often as it has items, and the items' places."""
    of = np.repeat(np.arange(len(counts)), counts)
    return of, np.arange(len(of)) - (np.cumsum(counts) - counts)[of]


def _border(nodes: Nodes, row: int) -> list[Piece]:
    """Pieces of a row: the upper ones of all its nodes, then the lower ones."""
    return [(nodes, (row,), BLOCKS), ((row,), nodes, BLOCKS)]


def eliminations(structure: Structure) -> dict[str, array]:
    """Return the tables of the whole tangent's elimination, and of others where they are cheaper.

    Newton's iteration takes a step or two more with lean factors: they must save half the products.
    Of one to three bodies they can take more instructions, in more groups of pivots; they are left
    out then.
    """
    anchors, trees = RowOrder(structure).of_rows(), carried_bodies(structure)
    whole = TangentPattern(structure, anchors, trees=trees)

    def smaller(kind: str) -> TangentPattern:
        """Return a tangent that fits into the memory of the whole one, with trees if it can."""
        found = TangentPattern(structure, anchors, kind, trees)
        if trees and found.pattern.n_entries > whole.pattern.n_entries:
            return TangentPattern(structure, anchors, kind)
        return found

    lean = smaller("lean_")
    used = [whole]
    kinds = ["open_"]
    cheaper = lean.pattern.n_operations <= whole.pattern.n_operations
    if cheaper and 2 * lean.pattern.n_products <= whole.pattern.n_products:
        used.append(lean)
        kinds.append("bare_")
    if structure.mechanism.contacts:
        used += map(smaller, kinds)
    kinds = tuple(f"{kind}_" for kind in FACTORS)
    found = {name: array("i") for name in TABLES if name.startswith(kinds)}
    for pattern in used:
        if pattern.pattern.n_entries <= whole.pattern.n_entries:  # all live in the same memory
            found |= pattern.tables()
    return found


def _table(integers: Integers) -> array:
    return array("i", integers.astype("i").tobytes())
