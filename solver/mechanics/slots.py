"""Where in the factors of the tangent each contribution goes, and what is coupled there.

A *diagonal* coupling of two nodes joins equal components only: masses, the stiffness of forms
without quarter turns, coincidences. All others fill dim x dim blocks.
"""

from __future__ import annotations

from array import array
from collections.abc import Iterable, Iterator, Sequence

import numpy as np

from solver.mechanics.anchors import Anchors
from solver.mechanics.elimination import Graph, Integers, Pattern, eliminate
from solver.mechanics.structure import LINEAR, TURNED, Structure


class Layout:
    """Blocks of a mechanism's tangent: free nodes, then rows in the order of the multipliers.

    A lean one has no stiffness: only masses couple nodes.
    """

    def __init__(self, structure: Structure, *, lean: bool = False) -> None:
        self.structure, self.lean = structure, lean
        mechanism = structure.mechanism
        self.dim, self.n_nodes = mechanism.dim, structure.n_free
        self.form_rows = [row.form for row in mechanism.form_rows]
        self.coincidences = [row.form for row in mechanism.coincidences]
        n_rows = len(mechanism.function_rows) + len(mechanism.velocity_rows)
        n_elements = len(mechanism.elements)
        self.row_composites = range(n_elements, n_elements + n_rows)
        self.first_coincidence = self.n_nodes + len(self.form_rows)
        self.first_function = self.first_coincidence + len(self.coincidences)

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
        return Graph(sizes, self.n_nodes, couplings, self._anchors())

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
        structure, mechanism = self.structure, self.structure.mechanism
        for moment in mechanism.moments:
            yield structure.free(moment.place)
        for moment in mechanism.body_moments:
            yield self.directors(structure.node_of[moment.place], 3)
        for load in mechanism.loads:
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
        self.pattern: Pattern = eliminate(self.graph())
        position = self._position = self.pattern.position.tolist()
        self._n = len(self.pattern.counts)
        rows = position[self.n_nodes : self.first_coincidence]
        for block in range(self.first_coincidence, self.first_function):
            rows.extend(position[block] + k for k in range(self.dim))
        rows.extend(position[self.first_function :])
        masses = (
            self._equal(a, b) for a, b, _ in self.structure.masses if max(a, b) < self.n_nodes
        )
        tables = {
            "node_position": array("i", position[: self.n_nodes]),
            "row_position": array("i", rows),
            "lu_ptr": _table(self.pattern.ptr),
            "lu_column": _table(self.pattern.column),
            "lu_target": _table(self.pattern.target),
            "mass_slot": self._slots(masses),
            "row_slot": self._slots(self._of_form_rows()),
            "coincidence_slot": self._slots(self._of_coincidences()),
            "composite_slot": self._slots(self._of_composites()),
        }
        if self.lean:
            return {f"lean_{name}": table for name, table in tables.items()}
        moments = (self.structure.free(form) for form in self._moment_forms())
        return tables | {
            "load_slot": self._slots(self._of_loads()),
            "moment_slot": self._slots(self._full(free, free) for free in moments),
            "body_moment_slot": self._slots(self._of_body_moments()),
        }

    def _moment_forms(self) -> list[int]:
        return [moment.place for moment in self.structure.mechanism.moments]

    def _slots(self, elements: Iterable[Iterable[int]]) -> array:
        """Slots of lists of elements, one list after the other."""
        flat = np.fromiter((x for listed in elements for x in listed), dtype=np.int64)
        return _table(self.pattern.slots(*np.divmod(flat, self._n)))

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
            linear = self.lean or kind & LINEAR
            if kind & TURNED and not linear:
                yield self._full(free, free)
            elif not linear:
                yield [x for a in free for b in free for x in self._equal(a, b)]
            yield self._border(free, row)

    def _of_coincidences(self) -> Iterator[list[int]]:
        for row, form in enumerate(self.coincidences, start=self.first_coincidence):
            for a in self.structure.free(form):
                if self.structure.kinds[form] & TURNED:
                    yield [*self._full([a], [row]), *self._full([row], [a])]
                else:
                    yield [*self._equal(a, row), *self._equal(row, a)]

    def _of_composites(self) -> Iterator[list[int]]:
        for k, composite in enumerate(self.structure.composites):
            if not self.lean:
                yield self._square(composite.nodes)
            if k in self.row_composites:
                row = self.first_function + k - self.row_composites.start
                yield self._border(composite.nodes, row)

    def _of_loads(self) -> Iterator[list[int]]:
        structure = self.structure
        for load in structure.mechanism.loads:
            if load.axes is not None:
                axes = self.directors(structure.node_of[load.axes], self.n_directors)
                yield self._full(structure.free(load.form), axes)

    def _of_body_moments(self) -> Iterator[list[int]]:
        for moment in self.structure.mechanism.body_moments:
            yield self._square(self.directors(self.structure.node_of[moment.place], 3))


def eliminations(structure: Structure) -> dict[str, array]:
    """Return the tables of the full tangent's elimination, and of the lean one's if it is cheaper.

    Newton's iteration takes a step or two more with lean factors: they must save half the products.
    """
    full = Layout(structure).tables()
    lean = Layout(structure, lean=True).tables()
    fits = [*lean["lean_lu_ptr"]][-1:] <= [*full["lu_ptr"]][-1:]  # both live in the same memory
    worth = fits and 2 * len(lean["lean_lu_target"]) <= len(full["lu_target"])
    return full | (lean if worth else {name: array("i") for name in lean})


def _table(integers: Integers) -> array:
    return array("i", integers.astype("i").tobytes())
