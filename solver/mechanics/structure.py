"""The integers of a model: nodes, forms, rows and composites in their final order.

A composite is what is built of quantities - an element, a function row, a velocity row, a potential
- with its forms, the free nodes of these, and its leaves.
"""

from __future__ import annotations

from array import array
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

from solver.mechanics.equations import DRIVEN, FIXED, FREE, SIGNAL, VALUE, Form, Leaf
from solver.mechanics.mechanism import Mechanism
from solver.scene import Number

SQUARE, LINEAR, TURNED = 1, 2, 4
"""Flags of forms."""


class Entry(NamedTuple):
    """One node of a form, with its coefficients (straight, turned) in u and in w."""

    node: int
    alpha: tuple[Number, Number]
    beta: tuple[Number, Number]


@dataclass(frozen=True, slots=True)
class Composite:
    """Leaves with their forms, the free nodes, and where each free entry is among these."""

    leaves: tuple[tuple[int, int, int, int], ...]
    forms: tuple[int, ...]
    nodes: tuple[int, ...]
    local: tuple[int, ...]


class Structure:
    """Final indices of a mechanism: free nodes first, then driven, then fixed ones."""

    def __init__(self, mechanism: Mechanism) -> None:
        self.mechanism = mechanism
        motions = [node.motion for node in mechanism.nodes]
        order = sorted(range(len(motions)), key=lambda n: motions[n])
        self.nodes = [mechanism.nodes[n] for n in order]
        self.node_of = {n: k for k, n in enumerate(order)}
        self.n_free, self.n_driven, self.n_support = (
            motions.count(motion) for motion in (FREE, DRIVEN, FIXED)
        )
        self.entries = [self._entries(form) for form in mechanism.forms]
        rest = (q for q in range(len(mechanism.quantities)) if q not in mechanism.active)
        self.quantities = [*mechanism.active, *rest]
        self.quantity_of = {q: k for k, q in enumerate(self.quantities)}
        pairs = [(self.node_of[a], self.node_of[b], m) for (a, b), m in mechanism.masses.items()]
        self.masses = sorted(pairs, key=lambda pair: max(pair[:2]) >= self.n_free)

    @property
    def n_moving(self) -> int:
        """Nodes that move."""
        return self.n_free + self.n_driven

    def _entries(self, form: Form) -> list[Entry]:
        nothing: tuple[Number, Number] = (0.0, 0.0)
        sides = [{n: (c, t) for n, c, t in side.terms} for side in (form.u, form.w)]
        used = sorted({self.node_of[n]: n for side in sides for n in side}.items())
        return [Entry(k, sides[0].get(n, nothing), sides[1].get(n, nothing)) for k, n in used]

    def free(self, form: int) -> list[int]:
        """Return the free nodes of a form; they come first among its entries."""
        return [entry.node for entry in self.entries[form] if entry.node < self.n_free]

    def moving(self, form: int) -> int:
        """Return how many entries of a form move."""
        return sum(entry.node < self.n_moving for entry in self.entries[form])

    @cached_property
    def kinds(self) -> list[int]:
        """Flags of the forms."""
        return [self._kind(f, form) for f, form in enumerate(self.mechanism.forms)]

    def _kind(self, f: int, form: Form) -> int:
        moving = self.entries[f][: self.moving(f)]
        turned = any([e.alpha[1] != 0.0 or e.beta[1] != 0.0 for e in self.entries[f]])
        linear = all([x == 0.0 for entry in moving for x in entry.beta])
        return SQUARE * (form.u == form.w) | LINEAR * linear | TURNED * turned

    @cached_property
    def any_turned(self) -> bool:
        """Whether quarter turns are stored."""
        return any(kind & TURNED for kind in self.kinds)

    # ------------------------------------------------------------------------------ composites

    @cached_property
    def composites(self) -> list[Composite]:
        """Elements, function rows, velocity rows, potentials."""
        mechanism = self.mechanism
        elements = [(Leaf(VALUE, element.quantity),) for element in mechanism.elements]
        rows = (*mechanism.function_rows, *mechanism.velocity_rows)
        formulas = [*(row.formula for row in rows), *mechanism.potentials]
        return [self._composite(x) for x in (*elements, *(formula.leaves for formula in formulas))]

    def _composite(self, leaves: Sequence[Leaf]) -> Composite:
        forms: dict[int, int] = {}
        found = []
        for leaf in leaves:
            if leaf.kind == SIGNAL:
                shift = len(self.mechanism.driven_signals)
                found.append((SIGNAL, shift + leaf.index, -1, -1))
                continue
            used = self.mechanism.quantities[leaf.index].forms
            local = [forms.setdefault(form, len(forms)) for form in used]
            found.append((leaf.kind, self.quantity_of[leaf.index], *([*local, -1])[:2]))
        free = [self.free(form) for form in forms]
        nodes = {node: k for k, node in enumerate(sorted({n for near in free for n in near}))}
        local_nodes = tuple(nodes[n] for near in free for n in near)
        return Composite(tuple(found), tuple(forms), tuple(nodes), local_nodes)

    @cached_property
    def linked(self) -> list[int]:
        """Forms that a step needs at its beginning: all but those that are only measured."""
        mechanism = self.mechanism
        needed = {row.form for row in mechanism.form_rows}
        needed.update(form for composite in self.composites for form in composite.forms)
        needed.update(moment.place for moment in mechanism.moments)
        needed.update(f for q in mechanism.active for f in mechanism.quantities[q].forms)
        return sorted(needed)

    # ---------------------------------------------------------------------------------- tables

    def tables(self) -> dict[str, array]:
        """Return the tables that describe the mechanism, without those of the elimination."""
        mechanism, composites = self.mechanism, self.composites
        quantities = [mechanism.quantities[q] for q in self.quantities]
        pairs = [((*q.forms, -1))[:2] for q in quantities]
        reactions = [(r, *e) for r, entries in enumerate(mechanism.reactions) for e in entries]
        node_of, loads = self.node_of, mechanism.loads
        return {
            "node_kind": array("i", (node.kind for node in self.nodes)),
            "form_ptr": pointers(self.entries),
            "form_free": array("i", (len(self.free(f)) for f in range(len(self.entries)))),
            "form_moving": array("i", (self.moving(f) for f in range(len(self.entries)))),
            "form_node": flat([e.node for e in entries] for entries in self.entries),
            "form_kind": array("i", self.kinds),
            "quantity_kind": array("i", (q.kind for q in quantities)),
            "quantity_form": flat(pairs),
            "linked_form": array("i", self.linked),
            "row_form": array("i", (row.form for row in mechanism.form_rows)),
            "row_power": array("i", self._row_powers()),
            "coincidence_form": array("i", (row.form for row in mechanism.coincidences)),
            "composite_form_ptr": pointers(c.forms for c in composites),
            "composite_form": flat(c.forms for c in composites),
            "composite_node_ptr": pointers(c.nodes for c in composites),
            "composite_node": flat(c.nodes for c in composites),
            "composite_local": flat(c.local for c in composites),
            "leaf_ptr": pointers(c.leaves for c in composites),
            "leaf": flat(leaf for c in composites for leaf in c.leaves),
            "load_form": array("i", (load.form for load in loads)),
            "load_axes": array("i", (-1 if x.axes is None else node_of[x.axes] for x in loads)),
            "moment_form": array("i", (moment.place for moment in mechanism.moments)),
            "body_moment": flat((node_of[m.place], m.body_axes) for m in mechanism.body_moments),
            "body_node": array("i", (node_of[body] for body in mechanism.bodies)),
            "place_form": array("i", mechanism.places),
            "reaction_entry": flat(reactions),
            "mass_node": flat(pair[:2] for pair in self.masses),
        }

    def _row_powers(self) -> list[int]:
        mechanism = self.mechanism
        functions = (*mechanism.function_rows, *mechanism.velocity_rows)
        return [
            *(row.scale.power for row in mechanism.form_rows),
            *([1] * (mechanism.dim * len(mechanism.coincidences))),
            *(row.scale.power for row in functions),
        ]


def flat(lists: Iterable[Iterable[int]]) -> array:
    """Return all integers of the lists, one after the other."""
    return array("i", (int(x) for items in lists for x in items))


def pointers(lists: Iterable[Sequence[object]]) -> array:
    """Return where each list begins among all of them, and the end."""
    ptr = array("i", [0])
    for items in lists:
        ptr.append(ptr[-1] + len(items))
    return ptr
