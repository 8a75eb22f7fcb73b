"""Where in the factors of the tangent each contribution goes, and what is coupled there.

A *diagonal* coupling of two nodes joins equal components only: masses, the stiffness of forms
without quarter turns, coincidences. All others fill dim x dim blocks.
"""

from __future__ import annotations

from array import array
from collections.abc import Iterable, Iterator, Sequence

from solver.mechanics.elimination import Graph, Pattern, eliminate
from solver.mechanics.structure import LINEAR, TURNED, Structure
from solver.mechanics.vectors import add, dot, scale, turned

WEAK = 1e-4
"""A node whose share of a row's G M^-1 G' is smaller than this part of the largest carries none."""


class Layout:
    """Blocks of a mechanism's tangent: free nodes, then rows in the order of the multipliers."""

    def __init__(self, structure: Structure) -> None:
        self.structure = structure
        mechanism = structure.mechanism
        self.dim, self.n_nodes = mechanism.dim, structure.n_free
        self.form_rows = [row.form for row in mechanism.form_rows]
        self.coincidences = [row.form for row in mechanism.coincidences]
        own = ((a, mechanism.default(mass)) for a, b, mass in structure.masses if a == b)
        self._masses = {node: mass for node, mass in own if mass > 0.0}
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
            if kinds[form] & LINEAR:
                for a in free(form):
                    yield (a,), ((row, True),), False
            else:
                yield free(form), ((row, True),), bool(kinds[form] & TURNED)
        for row, form in enumerate(self.coincidences, start=self.first_coincidence):
            for a in free(form):
                yield (a,), ((row, bool(kinds[form] & TURNED)),), False
        for k, composite in enumerate(structure.composites):
            row = self.first_function + k - self.row_composites.start
            yield composite.nodes, ((row, True),) if k in self.row_composites else (), True
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
        rows = {self.n_nodes + k: [form] for k, form in enumerate(self.form_rows)}
        for k, composite in enumerate(self.row_composites):
            rows[self.first_function + k] = list(self.structure.composites[composite].forms)
        anchors = {row: self._carriers(forms) for row, forms in rows.items()}
        for row, form in enumerate(self.coincidences, start=self.first_coincidence):
            anchors[row] = self._heavy(
                {e.node: self._square((e.alpha,)) for e in self.structure.entries[form]}
            )
        return anchors

    def _carriers(self, forms: Iterable[int]) -> list[int]:
        """Nodes in which the gradient of a row does not vanish as drawn."""
        mechanism, shares = self.structure.mechanism, {}
        for f in forms:
            form = mechanism.forms[f]
            u, w = (
                [mechanism.default(x) for x in mechanism.drawn(side)] for side in (form.u, form.w)
            )
            for entry in self.structure.entries[f]:
                (a, a_turn), (b, b_turn) = (
                    [mechanism.default(x) for x in pair] for pair in (entry.alpha, entry.beta)
                )
                gradient = add(scale(a, w), scale(b, u))
                if self.dim == 2:  # the transpose of J is -J
                    turn = add(scale(a_turn, turned(w)), scale(b_turn, turned(u)))
                    gradient = add(gradient, scale(-1.0, turn))
                share = float(dot(gradient, gradient))  # pyright: ignore[reportArgumentType]
                shares[entry.node] = shares.get(entry.node, 0.0) + share
        return self._heavy(shares)

    def _square(self, pairs: Iterable[tuple]) -> float:
        default = self.structure.mechanism.default
        return sum(default(x) ** 2 for pair in pairs for x in pair)

    def _heavy(self, shares: dict[int, float]) -> list[int]:
        """Free nodes with a share of G M^-1 G' that is not negligible."""
        sizes = {
            node: share / self._masses.get(node, 1.0)
            for node, share in shares.items()
            if node < self.n_nodes
        }
        least = WEAK * max(sizes.values(), default=0.0)
        return [node for node, size in sizes.items() if size >= least]

    # --------------------------------------------------------------------------------- the slots

    def tables(self) -> dict[str, array]:
        """Return the tables of the elimination."""
        self.pattern: Pattern = eliminate(self.graph())
        position = self.pattern.position
        rows = [*position[self.n_nodes : self.first_coincidence]]
        for block in range(self.first_coincidence, self.first_function):
            rows.extend(position[block] + k for k in range(self.dim))
        rows.extend(position[self.first_function :])
        masses = (
            self._equal(a, b) for a, b, _ in self.structure.masses if max(a, b) < self.n_nodes
        )
        return {
            "node_position": position[: self.n_nodes],
            "row_position": array("i", rows),
            "lu_ptr": self.pattern.ptr,
            "lu_column": self.pattern.column,
            "lu_target": self.pattern.target,
            "mass_slot": _joined(masses),
            "row_slot": _joined(self._of_form_rows()),
            "coincidence_slot": _joined(self._of_coincidences()),
            "composite_slot": _joined(self._of_composites()),
            "load_slot": _joined(self._of_loads()),
            "moment_slot": _joined(
                self._full(free, free)
                for free in map(self.structure.free, self._moment_forms())
            ),
            "body_moment_slot": _joined(self._of_body_moments()),
        }  # fmt: skip

    def _moment_forms(self) -> list[int]:
        return [moment.place for moment in self.structure.mechanism.moments]

    def _equal(self, a: int, b: int) -> list[int]:
        """Slots of equal components of two blocks."""
        at = self.pattern.position
        return [self.pattern.slot(at[a] + k, at[b] + k) for k in range(self.dim)]

    def _full(self, firsts: Sequence[int], seconds: Sequence[int]) -> list[int]:
        """Slots of blocks, in the order first node, second node, component, component."""
        at, components = self.pattern.position, range(self.dim)
        return [
            self.pattern.slot(at[a] + i, at[b] + k)
            for a in firsts
            for b in seconds
            for i in components
            for k in components
        ]

    def _border(self, nodes: Sequence[int], row: int) -> list[int]:
        """Slots of a row: the upper ones of all its nodes, then the lower ones."""
        at = self.pattern.position
        places = [at[a] + k for a in nodes for k in range(self.dim)]
        upper = [self.pattern.slot(p, at[row]) for p in places]
        return upper + [self.pattern.slot(at[row], p) for p in places]

    def _of_form_rows(self) -> Iterator[list[int]]:
        for row, form in enumerate(self.form_rows, start=self.n_nodes):
            free, kind = self.structure.free(form), self.structure.kinds[form]
            if kind & TURNED and not kind & LINEAR:
                yield self._full(free, free)
            elif not kind & LINEAR:
                yield [slot for a in free for b in free for slot in self._equal(a, b)]
            yield self._border(free, row)

    def _of_coincidences(self) -> Iterator[list[int]]:
        for row, form in enumerate(self.coincidences, start=self.first_coincidence):
            for a in self.structure.free(form):
                if self.structure.kinds[form] & TURNED:
                    yield [*self._full([a], [row]), *self._full([row], [a])]
                else:
                    yield [*self._equal(a, row), *self._equal(row, a)]

    def _of_composites(self) -> Iterator[list[int]]:
        at, dim = self.pattern.position, self.dim
        for k, composite in enumerate(self.structure.composites):
            places = [at[a] + i for a in composite.nodes for i in range(dim)]
            yield [self.pattern.slot(p, q) for p in places for q in places]
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
        at = self.pattern.position
        for moment in self.structure.mechanism.body_moments:
            axes = self.directors(self.structure.node_of[moment.place], 3)
            places = [at[a] + i for a in axes for i in range(3)]
            yield [self.pattern.slot(p, q) for p in places for q in places]


def _joined(lists: Iterable[Iterable[int]]) -> array:
    return array("i", (slot for items in lists for slot in items))
