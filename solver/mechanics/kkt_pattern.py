"""Where in the factors of the tangent each contribution goes, and what is coupled there.

A *diagonal* coupling of two nodes joins equal components only: masses, the stiffness of forms
without quarter turns, coincidences. All others fill dim x dim blocks.
"""

from __future__ import annotations

from array import array
from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise

import numpy as np

from solver.mechanics.elimination import Graph, Integers, Pattern, eliminate
from solver.mechanics.islands import Ordered
from solver.mechanics.row_order import Anchors
from solver.mechanics.structure import LINEAR, TURNED, Structure, flat, pointers
from solver.runtime.layout import TABLES


class Layout:
    """Blocks of a mechanism's tangent: free nodes, then rows in the order of the multipliers.

    A lean one has no stiffness: only masses couple nodes.
    """

    def __init__(self, structure: Structure, *, lean: bool = False) -> None:
        self.structure, self.lean = structure, lean
        mechanism = structure.mechanism
        self.dim, self.n_nodes = mechanism.dim, structure.n_free
        self.form_rows = [row.form for row in structure.form_rows.items]
        self.coincidences = [row.form for row in structure.coincidences.items]
        n_rows, n_elements = len(structure.functions), len(structure.elements)
        self.row_composites = range(n_elements, n_elements + n_rows)
        self.first_coincidence = self.n_nodes + len(self.form_rows)
        self.first_function = self.first_coincidence + len(self.coincidences)
        self.pattern: Pattern = eliminate(self.graph())

    # -------------------------------------------------------------------------------- the graph

    def graph(self) -> Graph:
        """Return what is coupled with what."""
        sizes = [self.dim] * self.n_nodes + [1] * len(self.form_rows)
        sizes += [self.dim] * len(self.coincidences) + [1] * len(self.row_composites)
        couplings: dict[tuple[int, int], bool] = {}
        for nodes, rows, full in self._cliques():
            for a in nodes:
                for b in nodes:
                    if a <= b:
                        couplings[a, b] = couplings.get((a, b), False) or full
            for row, whole in rows:
                for a in nodes:
                    couplings[a, row] = whole
        return Graph(sizes, self.n_nodes, couplings, self._anchors(), self._islands())

    def _islands(self) -> list[int]:
        """Islands of the blocks."""
        of_parts = (
            [island for island, (a, b) in enumerate(pairwise(part.begin)) for _ in range(a, b)]
            for part in self._parts()
        )
        return [island for of_part in of_parts for island in of_part]

    def _parts(self) -> tuple[Ordered, ...]:
        """Kinds of blocks."""
        structure = self.structure
        rows = (structure.form_rows, structure.coincidences)
        return (structure.free_nodes, *rows, structure.function_rows, structure.velocity_rows)

    def _cliques(self) -> Iterator[tuple[Sequence[int], Sequence[tuple[int, bool]], bool]]:
        """Free nodes that are coupled with each other, rows coupled to them, and how."""
        structure, kinds = self.structure, self.structure.kinds
        free = structure.free
        for a, b, _ in structure.masses:
            if max(a, b) < self.n_nodes:
                yield (a, b), (), False
        for row, form in enumerate(self.form_rows, start=self.n_nodes):
            if self.lean or kinds[form] & LINEAR:
                for a in free(form):
                    yield (a,), ((row, True),), False
            else:
                yield free(form), ((row, True),), bool(kinds[form] & TURNED)
        for row, form in enumerate(self.coincidences, start=self.first_coincidence):
            for a in free(form):
                yield (a,), ((row, bool(kinds[form] & TURNED)),), False
        for k, composite in enumerate(structure.composites):
            row = self.first_function + k - self.row_composites.start
            rows = ((row, True),) if k in self.row_composites else ()
            if self.lean:
                yield from (((a,), rows, False) for a in composite.nodes)
            else:
                yield composite.nodes, rows, True
        if not self.lean:
            yield from ((nodes, (), True) for nodes in self._moment_nodes())

    def _moment_nodes(self) -> Iterator[list[int]]:
        """Nodes that moments and follower loads couple."""
        structure = self.structure
        for moment in structure.moments.items:
            yield structure.free(moment.form)
        for moment in structure.body_moments.items:
            yield self.directors(structure.node_of[moment.node], 3)
        for load in structure.loads.items:
            if load.axes is not None:
                first = structure.node_of[load.axes]
                yield [*structure.free(load.form), *self.directors(first, self.n_directors)]

    @property
    def n_directors(self) -> int:
        """Directors of a body."""
        return 1 if self.dim == 2 else 3

    @staticmethod
    def directors(first: int, count: int) -> list[int]:
        """Return the directors of a body."""
        return list(range(first, first + count))

    def _anchors(self) -> dict[int, list[int]]:
        anchors, composites = Anchors(self.structure), self.structure.composites
        rows = {self.n_nodes + k: anchors.of_forms([f]) for k, f in enumerate(self.form_rows)}
        for k, composite in enumerate(self.row_composites):
            rows[self.first_function + k] = anchors.of_forms(composites[composite].forms)
        for row, form in enumerate(self.coincidences, start=self.first_coincidence):
            rows[row] = anchors.of_coincidence(form)
        return rows

    # --------------------------------------------------------------------------------- the slots

    def tables(self) -> dict[str, array]:
        """Return the tables of the elimination."""
        position = self._position = self.pattern.position.tolist()
        self._n = len(self.pattern.counts)
        rows = position[self.n_nodes : self.first_coincidence]
        for block in range(self.first_coincidence, self.first_function):
            rows.extend(position[block] + k for k in range(self.dim))
        rows.extend(position[self.first_function :])
        between_free = self.structure.masses[: len(self.structure.free_masses)]
        masses = (self._equal(a, b) for a, b, _ in between_free)
        tables = {
            "node_position": array("i", position[: self.n_nodes]),
            "row_position": array("i", rows),
            "lu_ptr": _table(self.pattern.ptr),
            "lu_column": _table(self.pattern.column),
            "lu_target": _table(self.pattern.target),
            "lu_island": self._pieces(),
            "mass_slot": self._slots("mass", masses)["mass_slot"],
            **self._slots("row", self._of_form_rows()),
            **self._slots("coincidence", self._of_coincidences()),
            **self._slots("composite", self._of_composites()),
        }
        if self.lean:
            return {f"lean_{name}": table for name, table in tables.items()}
        moments = (self.structure.free(form) for form in self._moment_forms())
        body_moments = self._slots("body_moment", self._of_body_moments())
        return {
            **tables,
            **self._slots("load", self._of_loads()),
            **self._slots("moment", (self._full(free, free) for free in moments)),
            "body_moment_slot": body_moments["body_moment_slot"],
        }

    def _pieces(self) -> array:
        """Of each island, and the end: its first pivot, and where the targets of this begin."""
        widths = (self.dim, 1, self.dim, 1, 1)
        pairs = [*zip(widths, self._parts(), strict=True)]
        targets = [0, *np.cumsum(self.pattern.counts**2).tolist()]
        pivots = [
            sum([width * part.begin[island] for width, part in pairs])
            for island in range(self.structure.islands.count + 1)
        ]
        return flat((pivot, targets[pivot]) for pivot in pivots)

    def _moment_forms(self) -> list[int]:
        return [moment.form for moment in self.structure.moments.items]

    def _slots(self, name: str, elements: Iterable[Sequence[int]]) -> dict[str, array]:
        """Slots of lists of elements, one list after the other, and where each begins."""
        listed = [*elements]
        all_elements = np.fromiter((x for items in listed for x in items), dtype=np.int64)
        slots = self.pattern.slots(*np.divmod(all_elements, self._n))
        return {f"{name}_slot_ptr": pointers(listed), f"{name}_slot": _table(slots)}

    def _equal(self, a: int, b: int) -> list[int]:
        """Elements of equal components of two blocks; element (i, j) is n i + j."""
        first = self._n * self._position[a] + self._position[b]
        return [first + k * (self._n + 1) for k in range(self.dim)]

    def _full(self, firsts: Sequence[int], seconds: Sequence[int]) -> list[int]:
        """Elements of blocks, in the order first node, second node, component, component."""
        at, n, components = self._position, self._n, range(self.dim)
        return [
            n * (at[a] + i) + at[b] + k
            for a in firsts
            for b in seconds
            for i in components
            for k in components
        ]

    def _places(self, nodes: Iterable[int]) -> list[int]:
        """Places of all components of some nodes."""
        return [self._position[a] + k for a in nodes for k in range(self.dim)]

    def _square(self, nodes: Iterable[int]) -> list[int]:
        """Elements of some nodes, in the order of their places."""
        places = self._places(nodes)
        return [self._n * p + q for p in places for q in places]

    def _border(self, nodes: Iterable[int], row: int) -> list[int]:
        """Elements of a row: the upper ones of all its nodes, then the lower ones."""
        places, last = self._places(nodes), self._position[row]
        upper = [self._n * p + last for p in places]
        return upper + [self._n * last + p for p in places]

    def _of_form_rows(self) -> Iterator[list[int]]:
        for row, form in enumerate(self.form_rows, start=self.n_nodes):
            free, kind = self.structure.free(form), self.structure.kinds[form]
            border = self._border(free, row)
            if self.lean or kind & LINEAR:
                yield border
            elif kind & TURNED:
                yield self._full(free, free) + border
            else:
                yield [x for a in free for b in free for x in self._equal(a, b)] + border

    def _of_coincidences(self) -> Iterator[list[int]]:
        for row, form in enumerate(self.coincidences, start=self.first_coincidence):
            turned = self.structure.kinds[form] & TURNED
            elements: list[int] = []
            for a in self.structure.free(form):
                for i, k in ((a, row), (row, a)):
                    elements += self._full([i], [k]) if turned else self._equal(i, k)
            yield elements

    def _of_composites(self) -> Iterator[list[int]]:
        for k, composite in enumerate(self.structure.composites):
            square = [] if self.lean else self._square(composite.nodes)
            if k in self.row_composites:
                row = self.first_function + k - self.row_composites.start
                square += self._border(composite.nodes, row)
            yield square

    def _of_loads(self) -> Iterator[list[int]]:
        structure = self.structure
        for load in structure.loads.items:
            if load.axes is None:
                yield []
                continue
            axes = self.directors(structure.node_of[load.axes], self.n_directors)
            yield self._full(structure.free(load.form), axes)

    def _of_body_moments(self) -> Iterator[list[int]]:
        for moment in self.structure.body_moments.items:
            yield self._square(self.directors(self.structure.node_of[moment.node], 3))


def eliminations(structure: Structure) -> dict[str, array]:
    """Return the tables of the full tangent's elimination, and of the lean one's if it is cheaper.

    Newton's iteration takes a step or two more with lean factors: they must save half the products.
    """
    full, lean = Layout(structure), Layout(structure, lean=True)
    fits = lean.pattern.n_entries <= full.pattern.n_entries  # both live in the same memory
    worth = fits and 2 * lean.pattern.n_products <= full.pattern.n_products
    empty = {name: array("i") for name in TABLES if name.startswith("lean_")}
    return full.tables() | (lean.tables() if worth else empty)


def _table(integers: Integers) -> array:
    return array("i", integers.astype("i").tobytes())
