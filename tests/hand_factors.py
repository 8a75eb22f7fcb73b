"""Places in dense factors for models written by hand, so that they run on the kernel too.

Nodes come first in the elimination, then rows; every pivot is coupled to all later ones.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import accumulate, pairwise, product
from typing import Any

from solver.runtime.layout import SIZES

TURNED, LINEAR = 4, 2

SEGMENTS = ("parameters", "laws", "signals", "outputs")

Tables = dict[str, list]


def unique(values: Sequence[int]) -> list[int]:
    """Values in the order in which they first appear."""
    return list(dict.fromkeys(values))


def composites(tables: Tables, n_free: int) -> None:
    """Write forms and nodes of the composites, and the leaves' local forms."""
    ptr, nodes = tables["form_ptr"], tables["form_node"]
    for name in ("composite_form_ptr", "composite_node_ptr", "composite_local_ptr"):
        tables[name] = [0]
    for begin, end in zip(tables["leaf_ptr"], tables["leaf_ptr"][1:], strict=False):
        quantities = [
            tables["leaf"][4 * i + 1] for i in range(begin, end) if tables["leaf"][4 * i] != 2
        ]
        made_of = {q: tables["quantity_form"][2 * q : 2 * q + 2] for q in quantities}
        forms = unique([form for q in quantities for form in made_of[q] if form >= 0])
        for i in range(begin, end):
            if tables["leaf"][4 * i] != 2:
                local = [
                    forms.index(f) if f >= 0 else -1 for f in made_of[tables["leaf"][4 * i + 1]]
                ]
                tables["leaf"][4 * i + 2 : 4 * i + 4] = local
        free = [[n for n in nodes[ptr[f] : ptr[f + 1]] if n < n_free] for f in forms]
        union = unique([node for entries in free for node in entries])
        tables["composite_form"] += forms
        tables["composite_form_ptr"].append(len(tables["composite_form"]))
        tables["composite_node"] += union
        tables["composite_node_ptr"].append(len(tables["composite_node"]))
        tables["composite_local"] += [union.index(node) for entries in free for node in entries]
        tables["composite_local_ptr"].append(len(tables["composite_local"]))


class Factors:
    """Dense factors of `size` unknowns: slots of matrix elements."""

    def __init__(self, tables: Tables, sizes: dict[str, int]) -> None:
        self.tables, self.dim = tables, sizes["dim"]
        self.n = self.dim * sizes["n_free"]
        self.size = self.n + sizes["n_rows"]
        self.ptr = [0]
        for k in range(self.size):
            self.ptr.append(self.ptr[-1] + 1 + 2 * (self.size - 1 - k))

    def slot(self, i: int, j: int) -> int:
        """Stored entry of matrix element (i, j)."""
        first, second = min(i, j), max(i, j)
        upper = self.ptr[first] + second - first
        return upper + self.size - 1 - first if i > j else upper

    def free(self, form: int) -> list[int]:
        """Free nodes of a form's entries."""
        begin = self.tables["form_ptr"][form]
        return self.tables["form_node"][begin : begin + self.tables["form_free"][form]]

    def block(self, a: int, b: int) -> Iterator[int]:
        """Slots of the block between two nodes."""
        for i, k in product(range(self.dim), repeat=2):
            yield self.slot(self.dim * a + i, self.dim * b + k)

    def pairs(self, nodes: Sequence[int]) -> list[int]:
        """Slots of all blocks between some nodes."""
        return [slot for a, b in product(nodes, repeat=2) for slot in self.block(a, b)]

    def border(self, nodes: Sequence[int], row: int) -> list[int]:
        """Slots of a row's column, then of its row."""
        places = [self.dim * a + k for a in nodes for k in range(self.dim)]
        upper = [self.slot(place, self.n + row) for place in places]
        return upper + [self.slot(self.n + row, place) for place in places]

    def form_row(self, row: int, form: int) -> list[int]:
        """Slots of a form row."""
        kind, nodes = self.tables["form_kind"][form], self.free(form)
        stiffness: list[int] = []
        if kind & TURNED and not kind & LINEAR:
            stiffness = self.pairs(nodes)
        elif not kind & LINEAR:
            stiffness = [
                self.slot(self.dim * a + k, self.dim * b + k)
                for a, b in product(nodes, repeat=2)
                for k in range(self.dim)
            ]
        return stiffness + self.border(nodes, row)

    def coincidence(self, first: int, form: int) -> list[int]:
        """Slots of a coincidence whose first row is `first`."""
        slots, rows = [], [self.n + first + k for k in range(self.dim)]
        for node in self.free(form):
            places = [self.dim * node + k for k in range(self.dim)]
            if self.tables["form_kind"][form] & TURNED:
                slots += [self.slot(i, j) for i, j in product(places, rows)]
                slots += [self.slot(j, i) for j, i in product(rows, places)]
            else:
                slots += [self.slot(i, j) for i, j in zip(places, rows, strict=True)]
                slots += [self.slot(j, i) for i, j in zip(places, rows, strict=True)]
        return slots

    def write(self, sizes: dict[str, int]) -> None:
        """Write all tables of the factors."""
        t, size, dim = self.tables, self.size, self.dim
        t["linked_form"] = list(range(sizes["n_forms"]))
        t["node_position"] = list(range(0, self.n, dim))
        t["row_position"] = list(range(self.n, size))
        t["lu_ptr"] = self.ptr
        t["lu_column"] = [later for k in range(size) for later in range(k + 1, size)]
        t["lu_target"] = [
            self.slot(i, j) for k in range(size) for i, j in product(range(k + 1, size), repeat=2)
        ]
        masses = zip(t["mass_node"][::2], t["mass_node"][1::2], strict=True)
        t["mass_slot"] = [
            self.slot(dim * a + k, dim * b + k)
            for a, b in list(masses)[: sizes["n_mass_free"]]
            for k in range(dim)
        ]
        t["lu_island"] = [0, 0, size, len(t["lu_target"])]
        self._list("row", (self.form_row(row, form) for row, form in enumerate(t["row_form"])))
        first = sizes["n_form_rows"]
        forms = enumerate(t["coincidence_form"])
        self._list("coincidence", (self.coincidence(first + dim * j, form) for j, form in forms))
        self._list("moment", (self.pairs(self.free(form)) for form in t["moment_form"]))
        self._composites(sizes)
        self._list("load", map(self._load, t["load_form"], t["load_axes"]))
        for first in t["body_moment"][::2]:
            places = range(dim * first, dim * first + 9)
            t["body_moment_slot"] += [self.slot(i, j) for i, j in product(places, repeat=2)]
        sizes["n_lu_values"] = self.ptr[-1]

    def _list(self, name: str, slots: Iterable[list[int]]) -> None:
        """Write lists of slots one after the other, and where each begins."""
        t, listed = self.tables, [*slots]
        t[f"{name}_slot"] = [slot for part in listed for slot in part]
        t[f"{name}_slot_ptr"] = [0, *accumulate(map(len, listed))]

    def _load(self, form: int, axes: int) -> list[int]:
        directors = range(axes, axes + (1 if self.dim == 2 else 3)) if axes >= 0 else ()
        return [slot for a, b in product(self.free(form), directors) for slot in self.block(a, b)]

    def _composites(self, sizes: dict[str, int]) -> None:
        t = self.tables
        first_row = sizes["n_form_rows"] + self.dim * sizes["n_coincidences"]
        n_rows = sizes["n_function_rows"] + sizes["n_velocity_rows"]
        ends, listed = t["composite_node_ptr"], []
        for j, (begin, end) in enumerate(pairwise(ends)):
            nodes, row = t["composite_node"][begin:end], j - sizes["n_elements"]
            places = [self.dim * a + k for a in nodes for k in range(self.dim)]
            listed.append([self.slot(i, k) for i, k in product(places, repeat=2)])
            if 0 <= row < n_rows:
                listed[-1] += self.border(nodes, first_row + row)
        self._list("composite", listed)


def write_sizes(tables: Tables, sizes: dict[str, int]) -> None:
    """Write the sizes of scratch that composites need."""

    def most(name: str) -> int:
        ends = tables[name]
        return max((b - a for a, b in pairwise(ends)), default=0)

    sizes["n_local_forms"] = max(most("composite_form_ptr"), 1)
    sizes["n_local_nodes"] = max(most("composite_node_ptr"), 1)
    sizes["n_registers"] = max(most("leaf_ptr") + most("function_ptr"), 1)


def sizes_of(hand: Any, counts: dict[str, int]) -> dict[str, int]:
    """Sizes of a model, but for those of its factors."""
    tables, nodes = hand.tables, hand.nodes
    rows = {
        "n_form_rows": len(tables["row_form"]),
        "n_coincidences": len(tables["coincidence_form"]),
        "n_function_rows": counts["row"],
        "n_velocity_rows": counts["velocity"],
    }
    sizes = dict.fromkeys(SIZES, 0) | rows
    sizes |= {f"n_tape_{segment}": len(hand.operations[segment]) for segment in SEGMENTS}
    sizes |= {
        "dim": hand.dim, "n_free": len(nodes["free"]), "n_driven": len(nodes["driven"]),
        "n_support": len(nodes["fixed"]), "n_forms": len(hand.forms),
        "n_entries": len(tables["form_node"]), "n_quantities": len(tables["quantity_kind"]),
        "n_active": len(tables["quantity_kind"]), "n_linked": len(hand.forms),
        "n_elements": len(hand.elements),
        "n_rows": sum(rows.values()) + (hand.dim - 1) * rows["n_coincidences"],
        "n_potentials": counts["potential"], "n_loads": len(tables["load_form"]),
        "n_moments": len(tables["moment_form"]),
        "n_body_moments": len(tables["body_moment"]) // 2, "n_mass": len(hand.masses),
        "n_mass_free": sum(map(are_free, hand.masses)),
        "n_bodies": len(tables["body_node"]), "n_places": len(tables["place_form"]),
        "n_reactions": hand.flags.get("n_reactions", 0),
        "n_reaction_entries": len(tables["reaction_entry"]) // 4,
        "n_signals": len(hand.numbers["signal"]), "n_inputs": len(hand.inputs),
        "time_dependent": hand.flags.get("time_dependent", 0),
        "variable_potential": hand.flags.get("variable_potential", 0),
        "sensing": hand.flags.get("sensing", 0),
    }  # fmt: skip
    return sizes


def are_free(pair: tuple[tuple[str, int], tuple[str, int]]) -> bool:
    """Whether both nodes are unknown."""
    return all(kind == "free" for kind, _ in pair)


def write_island(tables: Tables, sizes: dict[str, int]) -> None:
    """Write the tables of the islands of a model that has one."""
    composites = ("n_elements", "n_function_rows", "n_velocity_rows", "n_potentials")
    ends = [0, *accumulate(sizes[name] for name in composites)]
    n_free = sizes["n_free"]
    names = ("n_form_rows", "n_coincidences", "n_loads", "n_moments", "n_body_moments")
    pieces = [
        (0, n_free), (n_free, n_free + sizes["n_driven"]), *pairwise(ends),
        *((0, sizes[name]) for name in names), (0, sizes["n_mass"]),
        *((0, sizes[name]) for name in ("n_linked", "n_active", "n_bodies")),
    ]  # fmt: skip
    sizes["n_islands"], sizes["n_sampled"] = 1, 0
    tables["island_begin"] = [begin for begin, _ in pieces] + [end for _, end in pieces]
