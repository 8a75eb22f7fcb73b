"""What each unknown of a model depends on, as FMI wants it said.

At a communication point the motion is a state. Under a tolerance and without contacts reactions are
those of the state, and follow at once all inputs that push its island; else multipliers, and with
them reactions, are those of the step that led there, and an input acts on them by the next step
alone. Accelerations are always those of the state. What always follows it at once are formulas
that read it: those of outputs, of springs and other forces, of the energy that springs store, and
of prescribed rates; and this only of an input that is held, as the others begin a step with the
value that they had. At the start, a mechanism can be closed or brought to rest with everything that
its island contains, so that all of that counts.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from itertools import chain
from typing import Any, NamedTuple

from solver.mechanics.derivative import derivative
from solver.mechanics.formulas import leaf_symbol
from solver.mechanics.mechanism import FIXED
from solver.mechanics.sensors import Ref
from solver.mechanics.structure import Structure
from solver.mechanics.variables import SENSORS, Symbols
from solver.options import OPTIONS, tolerance_of
from solver.runtime.layout import LEAF_SIGNAL
from solver.runtime.model import Variable
from solver.scene import Expr, ExpressionError, Number, Scene, symbols
from solver.scene.quantities import place_in_whole
from solver.scene.states import sampled_states

Sources = frozenset[str | Ref]
"""Names of known variables, and measurements; what a sensor reads is one."""
Sets = list[Sources]
"""What acts on each island."""
Acting = tuple[Iterable[Number], Callable[[Any], Iterable[int]], Any]
"""How some numbers act; ``nodes(part)`` are the nodes on whose islands they do."""
NOTHING: Sources = frozenset()
AT_THE_START: Sources = frozenset({
    "solver.start", "solver.assemble", "solver.step_size", "solver.penalty",
    "solver.newton_tolerance",
})  # fmt: skip
"""Settings that the initial values follow: how it is closed, how exactly, or brought to rest."""
OF_A_STEP = ("solver", "contact_solver")
"""Measurements that tell of the last step alone."""
OF_THE_FORCES = ("rod_force", "multiplier", "driven_force", "reaction_force", "reaction_torque")
"""Measurements of forces that rows and drivers take."""
ACCELERATIONS = (
    *("acceleration", "place_acceleration"),
    *("quantity_acceleration", "body_acceleration"),
)
"""Measurements of what forces bring about, at every order."""
STORED = tuple(Ref("energy", place_in_whole("energy", x)) for x in ("potential", "total", "work"))
"""Energies that jump with what springs store: the jump is work."""
ROW_RATE = Ref("residual", place_in_whole("constraint", "velocity"))
STATUS = Ref("solver", place_in_whole("solver", "status"))
SLIP = 1
"""Component of a friction."""


class KnownVariables(NamedTuple):
    """Variables that an unknown depends on, by their indices in the model."""

    directly: tuple[int, ...]
    """Inputs that move it where they are set at a communication point, before the next step."""
    at_the_start: tuple[int, ...]
    """Parameters and inputs on which it depends in the initialization mode."""


def dependencies(
    scene: Scene, structure: Structure, known: Symbols, variables: Sequence[Variable]
) -> dict[int, KnownVariables]:
    """Return what all outputs and calculated parameters depend on, by the index of each."""
    search = _Search(scene, structure, known)
    place = {variable.name: index for index, variable in enumerate(variables)}
    known_of: dict[tuple[Sources, Sources], KnownVariables] = {}
    found = {}
    for index, variable in enumerate(variables):
        if variable.causality not in ("output", "calculatedParameter"):
            continue
        both = search.of_unknown(variable.name)
        if both not in known_of:
            listed = (tuple(sorted([place[name] for name in names])) for names in both)
            known_of[both] = KnownVariables(*listed)
        found[index] = known_of[both]
    return found


def _union(*sets: Sources) -> Sources:
    """All of some sets; the only one that is not empty is not copied."""
    some = [x for x in sets if x]
    return some[0] if len(some) == 1 else NOTHING.union(*some)


def _measured(sources: Sources) -> list[Ref]:
    return [x for x in sources if isinstance(x, Ref)]


def _rate(signal: Number, by: str = "t") -> Number:
    """Return the rate of a signal; the signal where it has none, which no fewer inputs are in."""
    try:
        return derivative(signal, by)
    except ExpressionError:
        return signal


class _Search:
    """Known variables that drive, push and shape the islands of a mechanism."""

    def __init__(self, scene: Scene, structure: Structure, known: Symbols) -> None:
        self._scene, self._structure, self._symbols = scene, structure, known
        self._mechanism, count = structure.mechanism, structure.islands.count
        self._held = frozenset(
            x for x, given in scene.inputs.items() if given.interpolation == "hold"
        )
        of_steps = tolerance_of(vars(scene.solver)) > 0.0 or scene.solver.order > 2
        self._tells_forces = of_steps and not structure.sizes["unilateral"]
        settings = (
            f"solver.{option.name}"
            for option in OPTIONS.values()
            if structure.sizes["unilateral"] or not option.of_contacts
        )
        free = (name for name, p in scene.parameters.items() if not isinstance(p.value, Expr))
        self._settable = frozenset(scene.inputs).union(free, settings)
        self._made_of: dict[str, Sources] = {"t": NOTHING}
        self._states = {name for name, *_ in sampled_states(scene.states)}
        self._made_of |= dict.fromkeys(self._states, frozenset({STATUS}))
        for name in self._mechanism.defaults:  # each behind those that it is calculated from
            value = scene.parameters[name].value if name in scene.parameters else 0.0
            own = self._of(value) if isinstance(value, Expr) else frozenset({name})
            self._made_of.setdefault(name, own)
        acting = (self._acting(), self._pushing()) if len(self._made_of) > 1 else ((), ())
        self._shaped, self._pushed = (self._sets(x, count) for x in acting)
        shaken = self._shaking() if self._mechanism.accelerates else ()
        self._accelerated = [
            _union(*x) for x in zip(self._pushed, self._sets(shaken, count), strict=True)
        ]
        while (grown := self._grown()) != self._shaped:
            self._shaped = grown
        shaped = [x.difference(_measured(x)) | AT_THE_START for x in self._shaped]
        self._shaped = shaped[:1] if len({*shaped}) == 1 else shaped  # no need to tell them apart

    def of_unknown(self, name: str) -> tuple[Sources, Sources]:
        """Return what acts on an output or a calculated parameter: inputs directly, first all."""
        if name in self._scene.parameters:
            return NOTHING, self._made_of[name]
        if name in self._states:
            return NOTHING, self._settable
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
        return _union(sources & self._held, *map(self._direct, _measured(sources)))

    def _direct(self, ref: Ref) -> Sources:
        """Held inputs that formulas read with which a measurement is taken, or that it answers."""
        if not self._held:
            return NOTHING
        if ref.section in OF_THE_FORCES and self._tells_forces:
            return self._directly(self._of_islands(self._pushed, ref))
        if ref.section in ACCELERATIONS:
            return self._directly(self._of_islands(self._accelerated, ref))
        return self._directly(self._of(*self._read(ref)))

    def _read(self, ref: Ref) -> Iterable[Number]:
        """Numbers with which a measurement is taken; all other measurements are states."""
        mechanism = self._mechanism
        if ref.section == "element_force":
            return mechanism.elements[ref.item].numbers
        if ref in STORED:
            springs = [x for x in mechanism.elements if x.stiffness != 0.0]
            stored = [number for x in springs for number in (x.stiffness, x.rest)]
            return chain(stored, (potential.value for potential in mechanism.potentials))
        if ref == ROW_RATE:
            of_frictions = {row for friction in mechanism.frictions for row in friction.rows}
            rows = (x for k, x in enumerate(mechanism.velocity_rows) if k not in of_frictions)
            return chain(map(_rate, mechanism.signals), (row.formula.value for row in rows))
        if ref.section == "friction" and ref.k == SLIP:
            rows = mechanism.frictions[ref.item].rows
            return [mechanism.velocity_rows[row].formula.value for row in rows]
        return ()

    def _first(self, ref: Ref) -> Sources:
        """Known variables that act on a measurement before the first step."""
        if ref == STATUS:  # not 0 where what was set cannot be
            return self._settable
        return NOTHING if ref.section in OF_A_STEP else self._of_islands(self._shaped, ref)

    # --------------------------------------------------------------------------------- islands

    def _sets(self, acting: Iterable[Acting], count: int) -> Sets:
        """What numbers that act are made of, for each island."""
        found = [NOTHING] * count
        for numbers, nodes, part in acting:
            sources = self._of(*numbers)
            for island in self._islands(nodes(part)) if sources else ():
                found[island] |= sources
        return found

    def _acting(self) -> Iterator[Acting]:
        """Yield all numbers of a mechanism."""
        mechanism = self._mechanism
        nodes, joined = mechanism.nodes, mechanism.joined
        for n, node in enumerate(nodes):
            yield (*node.position, *node.velocity, node.mass, node.weight), tuple, (n,)
        for pair, mass in mechanism.masses.items():
            yield (mass,), tuple, pair
        for f, form in enumerate(mechanism.forms):
            terms = [term for side in form for term in side.terms]
            places = [nodes[n].position for n, _, _ in terms if nodes[n].motion == FIXED]
            yield chain(*(term[1:] for term in terms), *places), mechanism.moving, f
        for row in mechanism.form_rows:
            yield (row.constant, row.scale.base), joined, row
        for row in (*mechanism.function_rows, *mechanism.velocity_rows):
            yield (row.formula.value,), joined, row
            signals = [leaf.index for leaf in row.formula.leaves if leaf.kind == LEAF_SIGNAL]
            yield [mechanism.signals[k] for k in signals], joined, row
        for contact in mechanism.contacts:
            row = mechanism.function_rows[contact.row]
            yield (contact.restitution,), joined, row
        for friction in mechanism.frictions:
            yield friction.numbers, joined, mechanism.velocity_rows[friction.rows[0]]
        yield from self._pushing()
        yield mechanism.driven_signals, tuple, self._structure.driven_nodes.items
        yield self._scene.gravity, tuple, range(len(nodes))

    def _pushing(self) -> Iterator[Acting]:
        """Yield the numbers of what makes force."""
        mechanism = self._mechanism
        joined = mechanism.joined
        for potential in mechanism.potentials:
            yield (potential.value, potential.damping or 0.0), joined, potential
        for element in mechanism.elements:
            yield element.numbers, joined, element
        for load in (*mechanism.loads, *mechanism.moments, *mechanism.body_moments):
            yield load.value, joined, load

    def _shaking(self) -> Iterator[Acting]:
        """Yield the numbers by which rows make accelerations: of drivers, slips and velocities.

        The second derivative of a signal is one; its rate is where the row is not linear in it.
        """
        mechanism = self._mechanism
        joined, signals = mechanism.joined, mechanism.signals
        bends = [_rate(_rate(signal)) for signal in mechanism.driven_signals]
        yield bends, tuple, self._structure.driven_nodes.items
        for row in mechanism.velocity_rows:
            yield (row.formula.value,), joined, row
        for friction in mechanism.frictions:
            yield friction.numbers, joined, mechanism.velocity_rows[friction.rows[0]]
        for row in mechanism.function_rows:
            for k, leaf in enumerate(row.formula.leaves):
                if leaf.kind != LEAF_SIGNAL:
                    continue
                rate = _rate(signals[leaf.index])
                slope = _rate(row.formula.value, str(leaf_symbol(k)))
                is_linear = not any(name.startswith("#") for name in symbols(slope))
                yield (_rate(rate), 0.0 if is_linear else rate), joined, row

    def _islands(self, nodes: Iterable[int]) -> set[int]:
        """Islands of some nodes."""
        motion, of_node = self._mechanism.nodes, self._structure.islands.of_node
        return {of_node[n] for n in nodes if motion[n].motion != FIXED}

    def _grown(self) -> Sets:
        """What shapes each island, and all islands whose sensors do; these may have others'."""
        shaped = self._shaped
        return [_union(x, *(self._of_islands(shaped, ref) for ref in _measured(x))) for x in shaped]

    def _of_islands(self, sets: Sets, ref: Ref) -> Sources:
        """What acts on the islands that a measurement is taken of."""
        if len(sets) == 1:
            return sets[0]
        return _union(*(sets[island] for island in self._islands(self._nodes(ref))))

    def _nodes(self, ref: Ref) -> Iterable[int]:
        """Nodes that a measurement is taken of."""
        mechanism, item = self._mechanism, ref.item
        match ref.section:
            case "position" | "velocity" | "acceleration" | "driven_force":
                return (item,)
            case "place" | "place_velocity" | "place_acceleration":
                return mechanism.moving(mechanism.places[item])
            case "quantity" | "quantity_rate" | "quantity_acceleration":
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
            case "quaternion" | "body_rate" | "body_acceleration":
                return mechanism.rigid[item]
            case "reaction_force" | "reaction_torque":
                rows = mechanism.coincidences, mechanism.form_rows, mechanism.form_rows
                found = (rows[kind][row] for kind, row, _ in mechanism.reactions[item])
                return [n for row in found for n in mechanism.joined(row)]
        return range(len(mechanism.nodes))
