"""What each unknown of a model depends on, as FMI wants it said.

FMI means the structure of the equations, not of their solution: positions and velocities are
states, so that an input acts on them only where a driver prescribes them; multipliers, and with
them reactions, follow the forces of their island at once. At the start, a mechanism can be closed
or brought to rest with everything that its island contains, so that all of that counts.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from itertools import chain
from typing import Any, NamedTuple

from solver.mechanics.mechanism import FIXED
from solver.mechanics.sensors import Ref
from solver.mechanics.structure import Structure
from solver.mechanics.variables import SENSORS, Symbols
from solver.options import OPTIONS
from solver.runtime.layout import LEAF_SIGNAL
from solver.runtime.model import Variable
from solver.scene import Expr, Number, Scene, symbols
from solver.scene.quantities import place_in_whole

Sources = frozenset[str | Ref]
"""Names of known variables, and measurements; what a sensor reads is one."""
Sets = list[Sources]
"""What acts on each island."""
Acting = tuple[Sets, Iterable[Number], Callable[[Any], Iterable[int]], Any]
"""How some numbers act; ``nodes(part)`` are the nodes on whose islands they do."""
NOTHING: Sources = frozenset()
AT_THE_START: Sources = frozenset({
    "solver.start", "solver.assemble", "solver.step_size", "solver.penalty",
    "solver.newton_tolerance",
})  # fmt: skip
"""Settings that the initial values follow: how it is closed, how exactly, or brought to rest."""
STATES = {
    "position", "velocity", "place", "place_velocity", "quantity", "quantity_rate", "quaternion",
    "body_rate", "residual", "momentum", "angular_momentum",
}  # fmt: skip
"""Measurements that are states, or follow from them and from drivers."""
OF_A_STEP = ("solver", "contact_solver")
"""Measurements that tell of the last step alone."""
COUNTED = {*(("contact", k) for k in (0, 2, 3, 4)), ("friction", 2)}
"""Gap, mode, impacts and impulse of contacts, mode of frictions: states as well; forces are not."""
KINETIC, STATUS = (
    Ref(name, place_in_whole(name, word))
    for name, word in (("energy", "kinetic"), ("solver", "status"))
)


class KnownVariables(NamedTuple):
    """Variables that an unknown depends on, by their indices in the model."""

    directly: tuple[int, ...]
    """Inputs on which it depends at a communication point."""
    at_the_start: tuple[int, ...]
    """Parameters and inputs on which it depends in the initialization mode."""


def dependencies(
    scene: Scene, structure: Structure, known: Symbols, variables: Sequence[Variable]
) -> dict[int, KnownVariables]:
    """Return what all outputs and calculated parameters depend on, by the index of each."""
    search = _Search(scene, structure, known)
    place = {variable.name: index for index, variable in enumerate(variables)}
    listed: dict[Sources, tuple[int, ...]] = {}
    found = {}
    for index, variable in enumerate(variables):
        if variable.causality not in ("output", "calculatedParameter"):
            continue
        both = search.of_unknown(variable.name)
        for names in both:
            if names not in listed:
                listed[names] = tuple(sorted([place[name] for name in names]))
        found[index] = KnownVariables(*[listed[names] for names in both])
    return found


def _union(*sets: Sources) -> Sources:
    """All of some sets; the only one that is not empty is not copied."""
    some = [x for x in sets if x]
    return some[0] if len(some) == 1 else NOTHING.union(*some)


def _measured(sources: Sources) -> list[Ref]:
    return [x for x in sources if isinstance(x, Ref)]


class _Search:
    """Known variables that drive, push and shape the islands of a mechanism."""

    def __init__(self, scene: Scene, structure: Structure, known: Symbols) -> None:
        self._scene, self._structure, self._symbols = scene, structure, known
        self._mechanism, count = structure.mechanism, structure.islands.count
        self._inputs = frozenset(scene.inputs)
        settings = (
            f"solver.{option.name}"
            for option in OPTIONS.values()
            if structure.sizes["unilateral"] or not option.of_contacts
        )
        free = (name for name, p in scene.parameters.items() if not isinstance(p.value, Expr))
        self._settable = self._inputs.union(free, settings)
        self._made_of: dict[str, Sources] = {"t": NOTHING}
        for name in self._mechanism.defaults:  # each behind those that it is calculated from
            value = scene.parameters[name].value if name in scene.parameters else 0.0
            own = self._of(value) if isinstance(value, Expr) else frozenset({name})
            self._made_of.setdefault(name, own)
        driven, forced, shaped = ([NOTHING] * count for _ in range(3))
        numbers_act = self._acting(driven, forced, shaped) if len(self._made_of) > 1 else ()
        for acting, numbers, nodes, part in numbers_act:
            sources = self._of(*numbers)
            for island in self._islands(nodes(part)) if sources else ():
                acting[island] |= sources
        self._driven = [x & self._inputs for x in driven]
        self._forced = [self._directly(x | y) for x, y in zip(forced, driven, strict=True)]
        self._shaped = [_union(*sets) for sets in zip(driven, forced, shaped, strict=True)]
        for _ in range(count):  # a sensor's island may have sensors of another one
            self._shaped = [
                _union(x, *(self._of_islands(self._shaped, ref) for ref in _measured(x)))
                for x in self._shaped
            ]
        self._shaped = [x.difference(_measured(x)) | AT_THE_START for x in self._shaped]

    def of_unknown(self, name: str) -> tuple[Sources, Sources]:
        """Return what acts on an output or a calculated parameter: inputs directly, first all."""
        if name in self._scene.parameters:
            return NOTHING, self._made_of[name]
        output = self._scene.outputs.get(name)
        if output is None and isinstance(meaning := self._symbols.measured(name), Ref):
            return self._direct(meaning), self._first(meaning)
        sources = self._of(output.value) if output else self._of_symbol(name)
        refs = _measured(sources)
        first = _union(sources.difference(refs), *map(self._first, refs))
        return self._directly(sources), first

    def _of(self, *numbers: Number) -> Sources:
        """What some numbers are made of."""
        return _union(*[self._of_symbol(name) for x in numbers for name in symbols(x)])

    def _of_symbol(self, name: str) -> Sources:
        if name not in self._made_of:
            kind, _, item = name.partition(" ")
            meaning: Ref | Number = 0.0  # of a leaf
            if kind in SENSORS:
                meaning = Ref("quantity", int(item))
            elif item or not name.startswith("#"):
                meaning = self._symbols.measured(name)
            measured = isinstance(meaning, Ref)
            self._made_of[name] = frozenset({meaning}) if measured else self._of(meaning)
        return self._made_of[name]

    def _directly(self, sources: Sources) -> Sources:
        """Inputs that act on what is made of these at a communication point."""
        return _union(sources & self._inputs, *map(self._direct, _measured(sources)))

    def _direct(self, ref: Ref) -> Sources:
        if ref.section in OF_A_STEP:
            return NOTHING
        if ref.section in STATES or ref == KINETIC or (ref.section, ref.k) in COUNTED:
            return self._of_islands(self._driven, ref)
        if ref.section != "element_force":
            return self._of_islands(self._forced, ref)
        own = self._of(*self._mechanism.elements[ref.item].numbers)
        return _union(self._directly(own), self._of_islands(self._driven, ref))

    def _first(self, ref: Ref) -> Sources:
        """Known variables that act on a measurement before the first step."""
        if ref == STATUS:  # not 0 where what was set cannot be
            return self._settable
        return NOTHING if ref.section in OF_A_STEP else self._of_islands(self._shaped, ref)

    # --------------------------------------------------------------------------------- islands

    def _acting(self, driven: Sets, forced: Sets, shaped: Sets) -> Iterator[Acting]:
        """Yield all numbers of a mechanism."""
        mechanism = self._mechanism
        nodes, joined = mechanism.nodes, mechanism.joined
        for n, node in enumerate(nodes):
            yield shaped, (*node.position, *node.velocity, node.mass, node.weight), tuple, (n,)
        for pair, mass in mechanism.masses.items():
            yield shaped, (mass,), tuple, pair
        for f, form in enumerate(mechanism.forms):
            terms = [term for side in form for term in side.terms]
            places = [nodes[n].position for n, _, _ in terms if nodes[n].motion == FIXED]
            yield shaped, chain(*(term[1:] for term in terms), *places), mechanism.moving, f
        for row in mechanism.form_rows:
            yield shaped, (row.constant, row.scale.base), joined, row
        for row in (*mechanism.function_rows, *mechanism.velocity_rows):
            yield forced, (row.formula.value,), joined, row
            signals = [leaf.index for leaf in row.formula.leaves if leaf.kind == LEAF_SIGNAL]
            yield driven, [mechanism.signals[k] for k in signals], joined, row
        for contact in mechanism.contacts:
            row = mechanism.function_rows[contact.row]
            yield forced, (contact.restitution,), joined, row
        for friction in mechanism.frictions:
            yield forced, friction.numbers, joined, mechanism.velocity_rows[friction.rows[0]]
        for potential in mechanism.potentials:
            numbers = potential.value, potential.damping or 0.0
            yield forced, numbers, joined, potential
        for element in mechanism.elements:
            yield forced, element.numbers, joined, element
        for load in (*mechanism.loads, *mechanism.moments, *mechanism.body_moments):
            yield forced, load.value, joined, load
        yield driven, mechanism.driven_signals, tuple, self._structure.driven_nodes.items
        yield forced, self._scene.gravity, tuple, range(len(nodes))

    def _islands(self, nodes: Iterable[int]) -> set[int]:
        """Islands of some nodes."""
        motion, of_node = self._mechanism.nodes, self._structure.islands.of_node
        return {of_node[n] for n in nodes if motion[n].motion != FIXED}

    def _of_islands(self, sets: Sets, ref: Ref) -> Sources:
        """What acts on the islands that a measurement is taken of."""
        if len(sets) == 1:
            return sets[0]
        return _union(*(sets[island] for island in self._islands(self._nodes(ref))))

    def _nodes(self, ref: Ref) -> Iterable[int]:
        """Nodes that a measurement is taken of."""
        mechanism, item = self._mechanism, ref.item
        match ref.section:
            case "position" | "velocity" | "driven_force":
                return (item,)
            case "place" | "place_velocity":
                return mechanism.moving(mechanism.places[item])
            case "quantity" | "quantity_rate":
                return mechanism.moving(*mechanism.quantities[item].forms)
            case "element_force":
                return mechanism.joined(mechanism.elements[item])
            case "rod_force":
                return mechanism.joined(mechanism.form_rows[item])
            case "multiplier":
                structure = self._structure
                return mechanism.joined(structure.multipliers[structure.multiplier_of[item]])
            case "contact":
                return mechanism.joined(mechanism.function_rows[mechanism.contacts[item].row])
            case "friction":
                row = mechanism.frictions[item].rows[0]
                return mechanism.joined(mechanism.velocity_rows[row])
            case "quaternion" | "body_rate":
                return mechanism.rigid[item]
            case "reaction_force" | "reaction_torque":
                rows = mechanism.coincidences, mechanism.form_rows, mechanism.form_rows
                found = (rows[kind][row] for kind, row, _ in mechanism.reactions[item])
                return [n for row in found for n in mechanism.joined(row)]
        return range(len(mechanism.nodes))
