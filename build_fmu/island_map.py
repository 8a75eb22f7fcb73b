"""Which island a number of a model belongs to, and what a measurement is taken of.

The order of everything is that of the tables of ``solver.runtime.layout``; all is asked of indices,
so that a large mechanism costs no more than the few numbers that depend on something.
"""

from __future__ import annotations

from bisect import bisect_right
from collections import defaultdict
from collections.abc import Iterator
from functools import cached_property
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from solver.runtime import Model

DRIVEN, FORCED, SHAPED = "driven", "forced", "shaped"
"""How a number acts on an island: it prescribes a motion, is part of a force, or of anything."""

COLUMNS = 15
"""Of the table `island_begin`, as ``holonom_island_column`` lists them."""
SIGNAL = 2
"""Kind of a leaf that is a signal."""

_FORCES = {"stiffness", "rest", "damping", "drive", "load", "moment", "body_moment", "gravity"}
_KINDS = {
    **dict.fromkeys(_FORCES, FORCED),
    "signal": DRIVEN,
}

Islands = frozenset[int]
Action = tuple[str, Islands, int | None]
"""How a number acts, on which islands, and on which element if on one."""


class Places:
    """Islands of everything that a model's tables list."""

    def __init__(self, model: Model) -> None:
        self.model, self.sizes, self.tables = model, model.sizes, model.tables
        self.dim, self.n_free = model.sizes["dim"], model.sizes["n_free"]
        self.n_moving = self.n_free + model.sizes["n_driven"]
        self.all: Islands = frozenset(range(model.sizes["n_islands"]))
        self._first_free = list(self.tables["island_begin"])[::COLUMNS]
        self._starts = list(model.offsets.values())
        self._sections = list(model.offsets)

    # ---------------------------------------------------------------------------- islands of

    def of_node(self, node: int) -> Islands:
        """Island of a node; none of one that does not move."""
        if node >= self.n_moving:
            return frozenset()
        last = self.sizes["n_islands"] - 1
        if node >= self.n_free:
            return frozenset((last,))  # what is driven is one island, the last
        return frozenset((min(last, bisect_right(self._first_free, node) - 1),))

    def of_form(self, form: int) -> Islands:
        """Island of a form: that of its first node, which moves if any does."""
        first, end = self.tables["form_ptr"][form], self.tables["form_ptr"][form + 1]
        if first == end:
            return frozenset()
        return self.of_node(self.tables["form_node"][first])

    def of_quantity(self, quantity: int) -> Islands:
        """Island of a quantity."""
        forms = self.tables["quantity_form"][2 * quantity : 2 * quantity + 2]
        return frozenset().union(*(self.of_form(form) for form in forms if form >= 0))

    def of_composite(self, composite: int) -> Islands:
        """Island of an element, function row, velocity row or potential."""
        ptr = self.tables["composite_form_ptr"]
        forms = self.tables["composite_form"][ptr[composite] : ptr[composite + 1]]
        return frozenset().union(*map(self.of_form, forms))

    def of_row(self, row: int) -> Islands:
        """Island of a multiplier."""
        n_forms, vectors = self.sizes["n_form_rows"], self.dim * self.sizes["n_coincidences"]
        if row < n_forms:
            return self.of_form(self.tables["row_form"][row])
        if row < n_forms + vectors:
            return self.of_form(self.tables["coincidence_form"][(row - n_forms) // self.dim])
        return self.of_composite(self.sizes["n_elements"] + row - n_forms - vectors)

    # ------------------------------------------------------------------------------- numbers

    def of_number(self, place: int) -> Iterator[Action]:
        """Yield how a number acts on islands."""
        for composite in self._formulas_with.get(place, ()):
            yield FORCED, self.of_composite(composite), None
        index = bisect_right(self._starts, place) - 1
        if self._sections[index] == "measured":
            return
        # Sections without entries begin where the next one does; the last of them has the place.
        section = self._sections[index]
        k = place - self._starts[index]
        element = k if section in ("stiffness", "rest", "damping", "drive") else None
        yield _KINDS.get(section, SHAPED), self._of_item(section, k), element

    def _of_item(self, section: str, k: int) -> Islands:
        """Islands on which number k of a section acts."""
        tables, dim = self.tables, self.dim
        wide = 1 if dim == 2 else 3
        if section in ("initial_position", "initial_velocity"):
            return self.of_node(k // dim)
        if section in ("node_mass", "node_weight", "velocity_weight"):
            return self.of_node(k)
        if section == "mass":
            return self.of_node(tables["mass_node"][2 * k]) | self.of_node(
                tables["mass_node"][2 * k + 1]
            )
        if section in ("alpha", "beta", "alpha_turn", "beta_turn"):
            return self.of_form(bisect_right(tables["form_ptr"], k) - 1)
        if section in ("row_constant", "row_base"):
            return self.of_row(k)
        if section in ("stiffness", "rest", "damping", "drive"):
            return self.of_composite(k)
        if section == "load":
            return self.of_form(tables["load_form"][k // dim])
        if section == "moment":
            return self.of_form(tables["moment_form"][k // wide])
        if section == "body_moment":
            return self.of_node(tables["body_moment"][2 * (k // 3)])
        if section == "signal":
            return self._of_signal(k)
        if section == "support":
            return self._of_support(self.n_moving + k // dim)
        return self.all if section == "gravity" else frozenset()

    def _of_signal(self, signal: int) -> Islands:
        if signal < self.dim * self.sizes["n_driven"]:
            return self.of_node(self.n_free + signal // self.dim)
        return frozenset().union(*map(self.of_composite, self._composites_of_signal[signal]))

    def _of_support(self, node: int) -> Islands:
        nodes, ptr = self.tables["form_node"], self.tables["form_ptr"]
        forms = [bisect_right(ptr, k) - 1 for k, n in enumerate(nodes) if n == node]
        return frozenset().union(*map(self.of_form, forms))

    @cached_property
    def _composites_of_signal(self) -> dict[int, list[int]]:
        found: dict[int, list[int]] = defaultdict(list)
        ptr, leaves = self.tables["leaf_ptr"], self.tables["leaf"]
        for composite in range(len(ptr) - 1):
            for k in range(4 * ptr[composite], 4 * ptr[composite + 1], 4):
                if leaves[k] == SIGNAL:
                    found[leaves[k + 1]].append(composite)
        return found

    @cached_property
    def _formulas_with(self) -> dict[int, list[int]]:
        """Function rows, velocity rows and potentials by the numbers that they contain."""
        found: dict[int, list[int]] = defaultdict(list)
        ptr, operations = self.tables["function_ptr"], self.tables["operation"]
        for formula in range(len(ptr) - 1):
            for k in range(4 * ptr[formula], 4 * ptr[formula + 1], 4):
                for argument in operations[k + 1 : k + 4]:
                    if argument < 0:
                        found[-1 - argument].append(self.sizes["n_elements"] + formula)
        return found

    # --------------------------------------------------------------------------- measurements

    def of_measured(self, section: str, k: int) -> Islands:
        """Islands that a measurement, number k of its section, is taken of."""
        if len(self.all) == 1:
            return self.all
        tables, dim = self.tables, self.dim
        if section in ("position", "velocity"):
            return self.of_node(k // dim)
        if section in ("place", "place_velocity"):
            return self.of_form(tables["place_form"][k // dim])
        if section in ("quantity", "quantity_rate"):
            return self.of_quantity(k)
        if section == "element_force":
            return self.of_composite(k)
        if section in ("rod_force", "multiplier"):
            return self.of_row(k)
        if section in ("quaternion", "body_rate"):
            return self.of_node(tables["body_node"][k // (4 if section == "quaternion" else 3)])
        if section == "driven_force":
            return self.of_node(self.n_free + k // dim)
        if section in ("reaction_force", "reaction_torque"):
            wide = dim if section == "reaction_force" or dim == 3 else 1
            return self._of_reactions.get(k // wide, frozenset())
        return self.all

    @cached_property
    def _of_reactions(self) -> dict[int, Islands]:
        """Islands of each joint."""
        entries, found = self.tables["reaction_entry"], defaultdict(frozenset)
        first = self.sizes["n_form_rows"]
        for k in range(0, len(entries), 4):
            joint, kind, row, _ = entries[k : k + 4]
            place = row if kind else first + self.dim * row
            found[joint] |= self.of_row(place)
        return found
