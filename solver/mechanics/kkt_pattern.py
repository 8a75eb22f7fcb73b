"""Where in the factors of the tangent each contribution goes, and what is coupled there.

A contribution is a list of pieces, each between some blocks and others; blocks are the free nodes,
then the rows in the order of the multipliers. Masses, the stiffness of forms without quarter turns
and coincidences join equal components of two blocks only; all others fill blocks of the matrix.
Which nodes can carry a row is told by their shares of its G M^-1 G' as drawn.
"""

from __future__ import annotations

from array import array
from collections.abc import Iterable, Sequence
from functools import cached_property
from itertools import accumulate, chain, pairwise

import numpy as np
from numpy.typing import NDArray

from solver.mechanics.elimination import Graph, Integers, eliminate
from solver.mechanics.mechanism import Load
from solver.mechanics.structure import ROW_KINDS, Composite, Structure, flat, pointers
from solver.runtime.layout import FORM_LINEAR, FORM_TURNED, TABLES

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
    all their slots.
    """

    def __init__(
        self, structure: Structure, anchors: Sequence[Nodes], kind: str = ""
    ) -> None:  # fmt: skip
        self.structure, self.kind = structure, kind
        self.lean = lean = kind in ("lean_", "bare_")
        self.n_nodes, dim = structure.n_free, structure.mechanism.dim
        self.kinds = (
            (dim, structure.free_nodes), (1, structure.form_rows), (dim, structure.coincidences),
            (1, structure.function_rows), (1, structure.velocity_rows),
        )  # fmt: skip
        """Multipliers or coordinates of a block, and the blocks of each kind by islands."""
        self.sizes = [width for width, part in self.kinds for _ in range(len(part))]
        ends = [*accumulate(len(part) for _, part in self.kinds)]
        n_elements, n_potentials = len(structure.elements), len(structure.potentials)
        forms, links = structure.form_rows.items, structure.coincidences.items
        functions = [None] * n_elements + [*range(ends[2], ends[4])] + [None] * n_potentials
        composites = [*zip(structure.composites, functions, strict=True)]
        between_free = structure.masses[: len(structure.free_masses)]
        self.contributions: dict[str, list[list[Piece]]] = {
            "mass": [[((a,), (b,), EQUAL)] for a, b, _ in between_free],
            "row": [self._form_row(row.form, k) for k, row in enumerate(forms, ends[0])],
            "coincidence": [self._link(row.form, k) for k, row in enumerate(links, ends[1])],
            "composite": [self._composite(composite, row) for composite, row in composites],
            "cone": self._cones(ends),
        }
        if not lean:
            turned = [self.directors(moment.node) for moment in structure.body_moments.items]
            moved = [structure.free(moment.form) for moment in structure.moments.items]
            self.contributions |= {
                "load": [
                    [(*x, BLOCKS)] if (x := self._follower(load)) else []
                    for load in structure.loads.items
                ],
                "moment": [[(nodes, nodes, BLOCKS)] for nodes in moved],
                "body_moment": [[(nodes, nodes, ROWS)] for nodes in turned],
            }
        loose, asleep = self._loose(ends), frozenset[int]()
        if kind in ("open_", "bare_"):
            frictions = [row for x in structure.mechanism.frictions for row in x.rows]
            asleep = loose | {ends[3] + structure.velocity_rows.place[row] for row in frictions}
        for pieces in (*self.contributions["composite"], *self.contributions["cone"]):
            row = pieces[-1][0] if pieces else ()
            if asleep.issuperset(row):
                pieces[:] = [(row, row, BLOCKS)] * self._n_elements(pieces)
        self.islands = self._islands(asleep)
        self.pattern = eliminate(
            Graph(
                self.sizes, self.n_nodes, self._couplings(),
                dict(enumerate(anchors, self.n_nodes)), self.islands, loose,
            )
        )  # fmt: skip

    def directors(self, first: int) -> list[int]:
        """Return the blocks of the directors of a body, given the first one's node."""
        structure = self.structure
        return [structure.node_of[n] for n in structure.mechanism.directors(first)]

    # -------------------------------------------------------------------------- contributions

    def _form_row(self, form: int, row: int) -> list[Piece]:
        free, kind = self.structure.free(form), self.structure.kinds[form]
        if self.lean or kind & FORM_LINEAR:
            return _border(free, row)
        return [(free, free, BLOCKS if kind & FORM_TURNED else EQUAL), *_border(free, row)]

    def _link(self, form: int, row: int) -> list[Piece]:
        how = BLOCKS if self.structure.kinds[form] & FORM_TURNED else EQUAL
        pairs = [((a,), (row,)) for a in self.structure.free(form)]
        return [(*x, how) for first, second in pairs for x in ((first, second), (second, first))]

    def _composite(self, composite: Composite, row: int | None) -> list[Piece]:
        nodes = composite.nodes
        square: list[Piece] = [] if self.lean else [(nodes, nodes, ROWS)]
        return square if row is None else square + _border(nodes, row)

    def _loose(self, ends: Sequence[int]) -> frozenset[int]:
        """Blocks of the rows of contacts and their frictions."""
        structure, mechanism = self.structure, self.structure.mechanism
        functions, slips = structure.function_rows.place, structure.velocity_rows.place
        touching = [contact for contact in mechanism.contacts]
        return frozenset(
            [ends[2] + functions[contact.row] for contact in touching]
            + [
                ends[3] + slips[row]
                for contact in touching
                if contact.friction >= 0
                for row in mechanism.frictions[contact.friction].rows
            ]
        )

    def _cones(self, ends: Sequence[int]) -> list[list[Piece]]:
        """Each velocity row of a friction with the rows that make its normal force."""
        structure = self.structure
        first = {
            kind: (end, part.place)
            for kind, end, (_, part) in zip(ROW_KINDS, ends, self.kinds[1:], strict=False)
        }

        def block(kind: str, row: int) -> tuple[int]:
            return (first[kind][0] + first[kind][1][row],)

        return [
            [
                (block("velocity", slip), block(*row), BLOCKS)
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

    def _couplings(self) -> dict[tuple[int, int], bool]:
        """Of coupled blocks: False where equal components are coupled, True where all are."""
        pieces = chain.from_iterable(chain.from_iterable(self.contributions.values()))
        followers = map(self._follower, () if self.lean else self.structure.loads.items)
        whole = [[*x[0], *x[1]] for x in followers if x]
        couplings: dict[tuple[int, int], bool] = {}
        cones = chain.from_iterable(self.contributions["cone"])
        others = chain(((x, x, BLOCKS) for x in whole), ((b, a, how) for a, b, how in cones))
        for firsts, seconds, how in chain(pieces, others):
            for a in firsts:
                for b in seconds:
                    if a <= b:
                        couplings[a, b] = couplings.get((a, b), False) or how != EQUAL
        return couplings

    def _islands(self, last: frozenset[int]) -> list[int]:
        """Islands of the blocks; some come last, behind those of all islands."""
        ends = [pairwise(part.begin) for _, part in self.kinds]
        found = [island for x in ends for island, (a, b) in enumerate(x) for _ in range(a, b)]
        return [len(self.kinds[0][1].begin) if k in last else x for k, x in enumerate(found)]

    def _n_elements(self, pieces: Sequence[Piece]) -> int:
        """Elements of the pieces of a composite or a cone."""
        sizes = self.sizes
        return sum([sizes[a] * sizes[b] for x, y, _ in pieces for a in x for b in y])

    # ------------------------------------------------------------------------------- the slots

    @cached_property
    def _places(self) -> list[range]:
        """Places of the components of each block in the elimination order."""
        position = self.pattern.position.tolist()
        return [range(at, at + size) for at, size in zip(position, self.sizes, strict=True)]

    def tables(self) -> dict[str, array]:
        """Return the tables of the elimination."""
        pattern, places = self.pattern, self._places
        tables = {
            "node_position": array("i", (place[0] for place in places[: self.n_nodes])),
            "row_position": flat(places[self.n_nodes :]),
            "lu_ptr": _table(pattern.ptr),
            "lu_column": _table(pattern.column),
            "lu_target": _table(pattern.target),
            "lu_island": self._pieces_of_islands(),
        }
        listed = {
            name: [[x for piece in pieces for x in self._elements(*piece)] for pieces in each]
            for name, each in self.contributions.items()
        }
        elements = np.array([x for each in listed.values() for items in each for x in items], int)
        slots = pattern.slots(*np.divmod(elements, len(pattern.counts)))
        ends = np.cumsum([sum(map(len, each)) for each in listed.values()])
        for (name, each), part in zip(listed.items(), np.split(slots, ends[:-1]), strict=True):
            tables[f"{name}_slot_ptr"], tables[f"{name}_slot"] = pointers(each), _table(part)
        named = {f"{self.kind}{x}": table for x, table in tables.items()}
        return {name: table for name, table in named.items() if name in TABLES}

    def _pieces_of_islands(self) -> array:
        """Of each island, and the end: its first pivot, and where the targets of this begin."""
        targets = [0, *np.cumsum(self.pattern.counts**2).tolist()]
        sizes = np.bincount(self.islands, self.sizes, self.structure.islands.count)
        pivots = [0, *np.cumsum(sizes).astype(int).tolist()][: self.structure.islands.count + 1]
        return flat((pivot, targets[pivot]) for pivot in pivots)

    def _elements(self, firsts: Nodes, seconds: Nodes, how: int) -> list[int]:
        """Elements (i, j) of a piece as n i + j."""
        n = len(self.pattern.counts)
        rows, columns = ([self._places[block] for block in x] for x in (firsts, seconds))
        if how == EQUAL:
            return [n * i + j for a in rows for b in columns for i, j in zip(a, b, strict=True)]
        if how == ROWS:
            return [n * i + j for a in rows for i in a for b in columns for j in b]
        return [n * i + j for a in rows for b in columns for i in a for j in b]


def _border(nodes: Nodes, row: int) -> list[Piece]:
    """Pieces of a row: the upper ones of all its nodes, then the lower ones."""
    return [(nodes, (row,), BLOCKS), ((row,), nodes, BLOCKS)]


def eliminations(structure: Structure) -> dict[str, array]:
    """Return the tables of the full tangent's elimination, and of others where they are cheaper.

    Newton's iteration takes a step or two more with lean factors: they must save half the products.
    Open ones are made where no forces need slots of their own.
    """
    anchors = RowOrder(structure).of_rows()
    full, lean = TangentPattern(structure, anchors), TangentPattern(structure, anchors, "lean_")
    used = {"": full}
    if 2 * lean.pattern.n_products <= full.pattern.n_products:
        used["lean_"] = lean
    if structure.mechanism.contacts:
        forces = (*structure.moments.items, *structure.body_moments.items, *structure.loads.items)
        kinds = [x for x, of in (("open_", ""), ("bare_", "lean_")) if of in used]
        used |= {
            x: TangentPattern(structure, anchors, x) for x in kinds if x == "bare_" or not forces
        }
    found = {name: array("i") for name in TABLES if name.startswith(("lean_", "open_", "bare_"))}
    for pattern in used.values():
        if pattern.pattern.n_entries <= full.pattern.n_entries:  # all live in the same memory
            found |= pattern.tables()
    return found


def _table(integers: Integers) -> array:
    return array("i", integers.astype("i").tobytes())
