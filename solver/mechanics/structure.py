"""The integers of a model: nodes, forms, rows and composites in their final order.

A composite is what is built of quantities - an element, a function row, a velocity row, a potential
- with its forms, the free nodes of these, and its leaves.
"""

from __future__ import annotations

from array import array
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import accumulate, chain
from typing import NamedTuple

from solver.mechanics.islands import Islands, Ordered
from solver.mechanics.mechanism import (
    DRIVEN,
    FIXED,
    FREE,
    Coincidence,
    Form,
    FormRow,
    Friction,
    FunctionRow,
    Leaf,
    Mechanism,
)
from solver.runtime import layout
from solver.scene import Number

ROW_KINDS = "form", "coincidence", "function", "velocity"
"""Kinds of rows, in their order."""
MOST_HIT_ROWS = 240
"""Rows that one impact can have: its matrix is dense."""
COUNTED = (
    "forms", "quantities", "active", "form_rows", "coincidences", "function_rows", "velocity_rows",
    "elements", "potentials", "loads", "moments", "body_moments", "bodies", "places", "reactions",
    "contacts", "frictions", "held",
)  # fmt: skip
"""Lists of a mechanism whose lengths a model has."""


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
    """Final indices of a mechanism: free nodes first, then driven, then fixed ones; all by islands.

    `form_rows` to `body_moments` are those of the mechanism in their final order.
    """

    def __init__(self, mechanism: Mechanism) -> None:
        self.mechanism = mechanism
        self.islands = islands = Islands(mechanism)
        motions = [node.motion for node in mechanism.nodes]
        free, driven, fixed = (
            [n for n, found in enumerate(motions) if found == motion]
            for motion in (FREE, DRIVEN, FIXED)
        )
        ordered, joined = islands.ordered, mechanism.joined
        self.free_nodes, self.driven_nodes = (ordered(x, lambda n: (n,)) for x in (free, driven))
        order = [*self.free_nodes.items, *self.driven_nodes.items, *fixed]
        self.nodes = [mechanism.nodes[n] for n in order]
        self.node_of = {n: k for k, n in enumerate(order)}
        self.n_free, self.n_driven, self.n_support = len(free), len(driven), len(fixed)
        self.n_moving = self.n_free + self.n_driven
        self.entries = [self._entries(form) for form in mechanism.forms]

        rigid = [row.row.kind == "axes" for row in mechanism.form_rows]
        self.joint_rows, self.rigidity_rows = (
            ordered(
                [row for row, x in zip(mechanism.form_rows, rigid, strict=True) if x == own], joined
            )
            for own in (False, True)
        )
        self.form_rows = self._form_rows(rigid)
        self.coincidences = ordered(mechanism.coincidences, joined)
        self.function_rows = ordered(mechanism.function_rows, joined)
        self.velocity_rows = ordered(mechanism.velocity_rows, joined)
        self.functions = [*self.function_rows.items, *self.velocity_rows.items]
        self.elements = ordered(mechanism.elements, joined)
        self.potentials = ordered(mechanism.potentials, joined)
        self.loads = ordered(mechanism.loads, joined)
        self.moments = ordered(mechanism.moments, joined)
        self.body_moments = ordered(mechanism.body_moments, joined)
        self.bodies = ordered(mechanism.bodies, mechanism.directors)
        free_pairs = (pair for pair in mechanism.masses if {motions[n] for n in pair} == {FREE})
        self.free_masses = ordered(free_pairs, lambda pair: pair)
        pairs = dict.fromkeys((*self.free_masses.items, *mechanism.masses))
        self.masses = [(self.node_of[a], self.node_of[b], mechanism.masses[a, b]) for a, b in pairs]
        forms_of = [quantity.forms for quantity in mechanism.quantities]
        touching = self._quantities_of_contacts()
        self.active, self.touching = (
            ordered(
                [q for q in mechanism.active if (q in touching) == touches],
                lambda q: mechanism.moving(*forms_of[q]),
            )
            for touches in (False, True)
        )
        rest = (q for q in range(len(forms_of)) if q not in mechanism.active)
        self.quantities = [*self.active.items, *self.touching.items, *rest]
        self.quantity_of = {q: k for k, q in enumerate(self.quantities)}

    def _form_rows(self, rigid: Sequence[bool]) -> Ordered[FormRow]:
        """Return the rows of joints, then those that keep bodies rigid."""
        parts = self.joint_rows, self.rigidity_rows
        places = iter(parts[0].place), (len(parts[0]) + k for k in parts[1].place)
        items = [*parts[0].items, *parts[1].items]
        return Ordered(items, [next(places[x]) for x in rigid], [0, len(items)])

    def _quantities_of_contacts(self) -> set[int]:
        """Quantities that a step needs only while a contact or friction is on."""
        mechanism = self.mechanism
        gaps = {contact.row for contact in mechanism.contacts}
        slips = {row for friction in mechanism.frictions for row in friction.rows}
        found: dict[bool, set[int]] = {True: set(), False: {e.quantity for e in mechanism.elements}}
        formulas = [
            *((k in gaps, row.formula) for k, row in enumerate(mechanism.function_rows)),
            *((k in slips, row.formula) for k, row in enumerate(mechanism.velocity_rows)),
            *((False, potential) for potential in mechanism.potentials),
        ]
        for of_contact, formula in formulas:
            found[of_contact] |= {x.index for x in formula.leaves if x.kind != layout.LEAF_SIGNAL}
        return found[True] - found[False]

    def _entries(self, form: Form) -> list[Entry]:
        nothing: tuple[Number, Number] = (0.0, 0.0)
        sides = [{n: (c, t) for n, c, t in side.terms} for side in (form.u, form.w)]
        used = sorted({self.node_of[n]: n for side in sides for n in side}.items())
        return [Entry(k, sides[0].get(n, nothing), sides[1].get(n, nothing)) for k, n in used]

    def free(self, form: int) -> list[int]:
        """Return the free nodes of a form; they come first among its entries."""
        return [entry.node for entry in self.entries[form] if entry.node < self.n_free]

    @cached_property
    def node_kinds(self) -> list[int]:
        """Kinds of the nodes, as the core has them."""
        found = [node.kind for node in self.nodes]
        for body in self.bodies.items:
            for k, n in enumerate(self.mechanism.directors(body)):
                found[self.node_of[n]] = layout.NODE_DIRECTION + k
        return found

    def unknown(self, node: int) -> int:
        """Return the free node whose unknowns move a free node.

        They are its own or, of a director, those of the first one: the turn of the body.
        """
        return node - max(0, self.node_kinds[node] - layout.NODE_DIRECTION)

    @cached_property
    def kinds(self) -> list[int]:
        """Flags of the forms."""
        found = []
        for form, entries in zip(self.mechanism.forms, self.entries, strict=True):
            moving = [entry for entry in entries if entry.node < self.n_moving]
            turned = any([e.alpha[1] != 0.0 or e.beta[1] != 0.0 for e in entries])
            linear = all([x == 0.0 for entry in moving for x in entry.beta])
            kind = layout.FORM_SQUARE * (form.u == form.w) | layout.FORM_LINEAR * linear
            found.append(kind | layout.FORM_TURNED * turned | self._axes(form))
        return found

    def _axes(self, form: Form) -> int:
        """Flags of a form whose sides each turn with one body, or not at all."""
        places = [[self.node_of[n] for n, _, _ in side.terms] for side in form]
        turns = [all([k < self.n_free and self.node_kinds[k] for k in nodes]) for nodes in places]
        still = all([k >= self.n_moving for k in places[1]])
        if not (turns[0] and (turns[1] or still)):
            return 0
        u, w = ({self.unknown(k) for k in nodes if k < self.n_free} for nodes in places)
        if len(u) != 1 or len(w) > 1 or u == w:
            return 0
        return layout.FORM_AXES | layout.FORM_AXES_OF_W * (bool(w) and min(w) < min(u))

    @cached_property
    def place_of(self) -> dict[str, Sequence[int] | dict[int, int]]:
        """Of each section of measurements: place of an item, by its index before ordering."""
        return {
            **dict.fromkeys(("position", "velocity", "acceleration"), self.node_of),
            **dict.fromkeys(
                ("quantity", "quantity_rate", "quantity_acceleration"), self.quantity_of
            ),
            **dict.fromkeys(("quaternion", "body_rate", "body_acceleration"), self.bodies.place),
            "element_force": self.elements.place,
            "rod_force": self.form_rows.place,
            "multiplier": self.multiplier_of,
            "driven_force": {n: k for k, n in enumerate(self.driven_nodes.items)},
        }

    @property
    def _rows(self) -> tuple[tuple[Ordered, int], ...]:
        """Kinds of rows, and how many multipliers one has."""
        vectors = self.coincidences, self.mechanism.dim
        return (self.form_rows, 1), vectors, (self.function_rows, 1), (self.velocity_rows, 1)

    @cached_property
    def multipliers(self) -> list[FormRow | Coincidence | FunctionRow]:
        """The row of each multiplier."""
        return [row for rows, width in self._rows for row in rows.items for _ in range(width)]

    @cached_property
    def multiplier_of(self) -> list[int]:
        """Place of each multiplier among all, by its index before ordering."""
        found: list[int] = []
        for rows, width in self._rows:
            first = len(found)
            found += [first + width * place + k for place in rows.place for k in range(width)]
        return found

    # ------------------------------------------------------------------------------ composites

    @cached_property
    def composites(self) -> list[Composite]:
        """Elements, function rows, velocity rows, potentials."""
        elements = [(Leaf(layout.LEAF_VALUE, element.quantity),) for element in self.elements.items]
        formulas = [*(row.formula for row in self.functions), *self.potentials.items]
        return [self._composite(x) for x in (*elements, *(formula.leaves for formula in formulas))]

    def _composite(self, leaves: Sequence[Leaf]) -> Composite:
        forms: dict[int, int] = {}
        found = []
        for leaf in leaves:
            if leaf.kind == layout.LEAF_SIGNAL:
                shift = len(self.mechanism.driven_signals)
                found.append((layout.LEAF_SIGNAL, shift + leaf.index, -1, -1))
                continue
            used = self.mechanism.quantities[leaf.index].forms
            local = [forms.setdefault(form, len(forms)) for form in used]
            found.append((leaf.kind, self.quantity_of[leaf.index], *([*local, -1])[:2]))
        free = [self.free(form) for form in forms]
        nodes = {node: k for k, node in enumerate(sorted({n for near in free for n in near}))}
        local_nodes = tuple(nodes[n] for near in free for n in near)
        return Composite(tuple(found), tuple(forms), tuple(nodes), local_nodes)

    @cached_property
    def linked(self) -> tuple[Ordered[int], ...]:
        """Forms that a step needs at its beginning.

        Always, and for contacts and frictions; others are only measured. Rows between axes take
        these from directors.
        """
        mechanism = self.mechanism
        rows = {row.form for row in self.joint_rows.items}
        between = {f for f in rows if self.kinds[f] & layout.FORM_AXES}
        between -= {f for f in rows if self.kinds[f] & layout.FORM_LINEAR}
        needed = (rows - between) | {moment.form for moment in mechanism.moments}
        needed.update(f for q in self.active.items for f in mechanism.quantities[q].forms)
        touching = {f for q in self.touching.items for f in mechanism.quantities[q].forms}
        lists = needed, touching - needed
        return tuple(self.islands.ordered(sorted(x), mechanism.moving) for x in lists)

    # ----------------------------------------------------------------------- sizes and tables

    @cached_property
    def sizes(self) -> dict[str, int]:
        """Sizes of the mechanism's arrays."""
        mechanism, composites = self.mechanism, self.composites
        return {
            **{f"n_{name}": len(getattr(mechanism, name)) for name in COUNTED},
            "dim": mechanism.dim,
            "n_free": self.n_free,
            "n_driven": self.n_driven,
            "n_support": self.n_support,
            "n_entries": sum(map(len, self.entries)),
            "n_linked": sum(map(len, self.linked)),
            "n_always_linked": len(self.linked[0]),
            "n_always_active": len(self.active),
            "n_rigidity_rows": len(self.rigidity_rows),
            "n_rows": len(self.multipliers),
            "n_mass": len(self.masses),
            "n_mass_free": len(self.free_masses),
            "n_reaction_entries": sum(map(len, mechanism.reactions)),
            "n_signals": len(mechanism.driven_signals) + len(mechanism.signals),
            "n_local_forms": max([1, *(len(c.forms) for c in composites)]),
            "n_local_nodes": max([1, *(len(c.nodes) for c in composites)]),
            "n_islands": self.islands.count,
            "n_hit_rows": min(MOST_HIT_ROWS, self._rows_of_impacts),
            "n_hit_forces": sum(len(self.normal_rows[f]) for f in self._joints_in_impacts),
            "unilateral": int(bool(mechanism.contacts or mechanism.frictions)),
            "n_sampled": len(self.sampled),
            "sensing": int(mechanism.sensing),
            "accelerates": int(mechanism.accelerates),
        }

    @cached_property
    def measured(self) -> dict[str, tuple[int, int]]:
        """Offset and length of each group of measurements."""
        return layout.measured_sections(self.sizes)

    def tables(self) -> dict[str, array]:
        """Return the tables that describe the mechanism, without those of the elimination."""
        mechanism, composites = self.mechanism, self.composites
        quantities = [mechanism.quantities[q] for q in self.quantities]
        pairs = [((*q.forms, -1))[:2] for q in quantities]
        node_of, loads = self.node_of, self.loads.items
        rows = {
            layout.REACTION_COINCIDENCE: self.coincidences,
            layout.REACTION_FORCE: self.form_rows, layout.REACTION_TORQUE: self.form_rows,
        }  # fmt: skip
        return {
            "node_kind": array("i", self.node_kinds),
            "form_ptr": pointers(self.entries),
            "form_free": array("i", (len(self.free(f)) for f in range(len(self.entries)))),
            "form_moving": array(
                "i", (sum(e.node < self.n_moving for e in entries) for entries in self.entries)
            ),
            "form_node": flat([e.node for e in entries] for entries in self.entries),
            "form_kind": array("i", self.kinds),
            "quantity_kind": array("i", (q.kind for q in quantities)),
            "quantity_form": flat(pairs),
            "linked_form": flat(part.items for part in self.linked),
            "row_form": array("i", (row.form for row in self.form_rows.items)),
            "row_power": array("i", (row.scale.power for row in self.multipliers)),
            "coincidence_form": array("i", (row.form for row in self.coincidences.items)),
            **listed("composite_form", [c.forms for c in composites]),
            **listed("composite_node", [c.nodes for c in composites]),
            **listed("composite_local", [c.local for c in composites]),
            "leaf_ptr": pointers(c.leaves for c in composites),
            "leaf": flat(leaf for c in composites for leaf in c.leaves),
            "load_form": array("i", (load.form for load in loads)),
            "load_axes": array("i", (-1 if x.axes is None else node_of[x.axes] for x in loads)),
            "moment_form": array("i", (moment.form for moment in self.moments.items)),
            "body_moment": flat((node_of[m.node], m.body_axes) for m in self.body_moments.items),
            "sampled_load": flat(place[:2] for place in self.sampled),
            "body_node": array("i", (node_of[body] for body in self.bodies.items)),
            "place_form": array("i", mechanism.places),
            "reaction_entry": flat(
                (joint, kind, rows[kind].place[row], sign)
                for joint, entries in enumerate(mechanism.reactions)
                for kind, row, sign in entries
            ),
            "mass_node": flat(pair[:2] for pair in self.masses),
            **self._unilateral(),
            "island_begin": flat(zip(*self._windows(), strict=True)),
        }

    def _unilateral(self) -> dict[str, array]:
        """Return the tables of contacts and frictions."""
        contacts, frictions = self.mechanism.contacts, self.mechanism.frictions
        gaps, slips = self.function_rows, self.velocity_rows
        first_slip = len(gaps)
        owner = [-1] * (len(gaps) + len(slips) if contacts or frictions else 0)
        for k, contact in enumerate(contacts):
            owner[gaps.place[contact.row]] = k
        rows = [[first_slip + slips.place[row] for row in friction.rows] for friction in frictions]
        for k, found in enumerate(rows, start=len(contacts)):
            for row in found:
                owner[row] = k
        first = len(self.elements)
        return {
            "contact_row": array("i", (first + gaps.place[x.row] for x in contacts)),
            "contact_friction": array("i", (x.friction for x in contacts)),
            **listed("friction_row", [[first + row for row in found] for found in rows]),
            "normal_ptr": pointers(self.normal_rows),
            "normal_row": flat(entry for entries in self.normal_rows for entry in entries),
            "row_owner": array("i", owner),
        }

    @property
    def slips_together(self) -> list[range]:
        """Functions of the slips of one friction, where these have the same leaves."""
        first, place = len(self.function_rows), self.velocity_rows.place
        found = [[first + place[row] for row in x.rows] for x in self.mechanism.frictions]
        groups = [range(min(x), max(x) + 1) for x in found if len(x) > 1]
        return [x for x in groups if len({self.functions[k].formula.leaves for k in x}) == 1]

    @property
    def _joints_in_impacts(self) -> list[int]:
        """Frictions of joints, where there are impacts."""
        own = {contact.friction for contact in self.mechanism.contacts}
        return [f for f in range(len(self.mechanism.frictions)) if own and f not in own]

    @property
    def _rows_of_impacts(self) -> int:
        """Rows of all contacts and frictions; a joint that rubs has one for its normal force."""
        mechanism = self.mechanism
        own = {contact.friction for contact in mechanism.contacts}
        joints = sum(f not in own for f in range(len(mechanism.frictions)))
        slips = sum(len(friction.rows) for friction in mechanism.frictions)
        return len(mechanism.contacts) + slips + joints

    @cached_property
    def normal_rows(self) -> list[list[tuple[int, int]]]:
        """Multipliers that make the normal force of each friction, and 1 where a group begins."""
        first, begin = {}, 0
        for kind, (rows, width) in zip(ROW_KINDS, self._rows, strict=True):
            first[kind] = begin, width, rows.place
            begin += len(rows) * width
        return [
            [
                (begin + width * place[row] + k, _sum_of(friction, kind, number + k))
                for group in friction.normal
                for number, (kind, row) in enumerate(group)
                for begin, width, place in (first[kind],)
                for k in range(width)
            ]
            for friction in self.mechanism.frictions
        ]

    @cached_property
    def sampled(self) -> list[tuple[int, int, str]]:
        """Kind, place and name of the loads that read the mechanism."""
        kinds = {
            layout.SAMPLED_LOAD: self.loads, layout.SAMPLED_MOMENT: self.moments,
            layout.SAMPLED_BODY_MOMENT: self.body_moments, layout.SAMPLED_DRIVE: self.elements,
        }  # fmt: skip
        return [
            (kind, place, load.sampled)
            for kind, loads in kinds.items()
            for place, load in enumerate(loads.items)
            if load.sampled
        ]

    def _windows(self) -> list[list[int]]:
        """Where each island begins among free nodes and so on: ``layout.ISLAND_PARTS``."""
        composites = self.elements, self.function_rows, self.velocity_rows, self.potentials
        others = (
            self.joint_rows, self.coincidences, self.loads, self.moments,
            self.body_moments, self.free_masses, self.bodies, *self.linked, self.active,
            self.touching,
        )  # fmt: skip
        parts = self.free_nodes, self.driven_nodes, *composites, *others
        shifts = [0, self.n_free, 0, *accumulate(map(len, composites[:-1]))] + [0] * len(others)
        columns = [*layout.ISLAND_PARTS]
        behind = {
            "touching_linked": self.linked[:1],
            "touching_active": (self.active,),
        }
        for name, before in behind.items():
            shifts[columns.index(name)] = sum(map(len, before))
        windows = [
            [shift + k for k in part.begin] for part, shift in zip(parts, shifts, strict=True)
        ]
        # The last island has the masses of driven nodes too.
        windows[columns.index("mass")][-1] = len(self.masses)
        return windows


def _sum_of(friction: Friction, kind: str, k: int) -> int:
    """Return how a multiplier enters a normal force: `layout.NORMAL_SUMS`."""
    alone = len(friction.normal) == 1 and len(friction.normal[0]) == 1 and kind == "function"
    return layout.NORMAL_SUMS.index("pushes" if alone else "continues" if k else "begins")


def flat(lists: Iterable[Iterable[int]]) -> array:
    """Return all integers of the lists, one after the other."""
    return array("i", chain.from_iterable(lists))


def listed(name: str, lists: Sequence[Sequence[int]]) -> dict[str, array]:
    """Return a table of lists, one after the other, and the table of where each begins."""
    return {f"{name}_ptr": pointers(lists), name: flat(lists)}


def pointers(lists: Iterable[Sequence[object]]) -> array:
    """Return where each list begins among all of them, and the end."""
    return array("i", accumulate(map(len, lists), initial=0))
