"""What each unknown of a model depends on, read off its tape, its tables and its islands.

FMI means the structure of the equations, not of their solution: positions and velocities are
states, so that an input acts on them only where a driver prescribes them; multipliers, and with
them reactions, follow the forces of their island at once. At the start, a mechanism can be closed
or brought to rest with everything that its island contains, so that all of that counts.

Sets of known variables are integers: bit i is set for variable i of the model.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import cached_property, reduce
from operator import or_
from typing import TYPE_CHECKING, NamedTuple

from build_fmu.island_map import DRIVEN, FORCED, SHAPED, Places
from solver.runtime.layout import measured_sections

if TYPE_CHECKING:
    from solver.runtime import Model, Variable

SEGMENTS = ("parameters", "laws", "signals", "outputs")
AT_THE_START = (
    "solver.start", "solver.assemble", "solver.step_size", "solver.penalty",
    "solver.newton_tolerance",
)  # fmt: skip
"""Settings that the initial values follow: how it is closed, how exactly, or brought to rest."""

_STATES = {
    "position", "velocity", "place", "place_velocity", "quantity", "quantity_rate", "quaternion",
    "body_rate", "residual", "momentum", "angular_momentum",
}  # fmt: skip
"""Measurements that are states, or follow from them and from drivers."""
_OF_NOTHING = {"solver"}
"""What tells of the last step alone."""


class Known(NamedTuple):
    """Variables that an unknown depends on, by their indices in the model."""

    directly: tuple[int, ...]
    """Inputs on which it depends at a communication point."""
    at_the_start: tuple[int, ...]
    """Parameters and inputs on which it depends in the initialization mode."""


def dependencies(model: Model) -> dict[int, Known]:
    """Dependencies of all outputs and calculated parameters, by the index of each."""
    search = _Search(model)
    unknown = ("output", "calculatedParameter")
    return {
        index: Known(_indices(search.directly(variable)), _indices(search.at_the_start(variable)))
        for index, variable in enumerate(model.variables)
        if variable.causality in unknown
    }


def _indices(known: int) -> tuple[int, ...]:
    found = []
    while known:
        lowest = known & -known
        found.append(lowest.bit_length() - 1)
        known ^= lowest
    return tuple(found)


def union(sets: Iterable[int]) -> int:
    """All variables of some sets."""
    return reduce(or_, sets, 0)


class _Search:
    """Sets of known variables by places of the vector of numbers, then by islands."""

    def __init__(self, model: Model) -> None:
        self.model, self.places = model, Places(model)
        variables = list(enumerate(model.variables))
        self.inputs = union(1 << i for i, v in variables if v.causality == "input")
        self.settings = union(1 << i for i, v in variables if v.name in AT_THE_START)
        self.settable = union(1 << i for i, v in variables if v.causality in ("parameter", "input"))
        self._sensor = len(variables)
        """First bit that stands for the quantity of a sensor."""
        self._numbers = self._base(variables)
        for segment in SEGMENTS[:3]:
            self._run(segment, self._numbers)
        self._of_islands()

    def _base(self, variables: Iterable[tuple[int, Variable]]) -> dict[int, int]:
        model = self.model
        found = {
            model.offsets[v.kind] + v.place: 1 << i
            for i, v in variables
            if v.kind in ("parameter", "input")
        }
        if model.sizes["sensing"]:
            for q in range(model.sizes["n_quantities"]):
                for section in ("sensor", "sensor_rate"):
                    found[model.offsets[section] + q] = 1 << (self._sensor + q)
        return found

    def _run(self, segment: str, sets: dict[int, int]) -> None:
        """Follow a segment of the tape; places that depend on nothing are left out."""
        lengths = [self.model.sizes[f"n_tape_{name}"] for name in SEGMENTS]
        place = SEGMENTS.index(segment)
        first, tape = 5 * sum(lengths[:place]), self.model.tables["tape"]
        for k in range(first, first + 5 * lengths[place], 5):
            _, target, *arguments = tape[k : k + 5]
            known = union(sets.get(x, 0) for x in arguments)
            if known:
                sets[target] = known
            else:
                sets.pop(target, None)

    # ------------------------------------------------------------------------------- islands

    def _of_islands(self) -> None:
        """Collect what each island is driven by, pushed by and made of."""
        count = self.model.sizes["n_islands"]
        found: dict[str, list[int]] = {level: [0] * count for level in (DRIVEN, FORCED, SHAPED)}
        self._own: dict[int, int] = defaultdict(int)
        for place, known in self._numbers.items():
            for level, islands, element in self.places.of_number(place):
                for island in islands:
                    found[level][island] |= known
                if element is not None:
                    self._own[element] |= known
        driven = [x & self.inputs for x in found[DRIVEN]]
        forced = [x | y for x, y in zip(found[FORCED], driven, strict=True)]
        shaped = [x | y for x, y in zip(found[SHAPED], found[DRIVEN], strict=True)]
        shaped = [x | y for x, y in zip(shaped, found[FORCED], strict=True)]
        self.driven = driven
        self.forced = [self._sensed(x, driven) & self.inputs for x in forced]
        for _ in range(count):  # a sensor's island may have sensors of another one
            before = shaped
            shaped = [self._sensed(x, before, keep=True) for x in before]
            if shaped == before:
                break
        self.shaped = [self._variables(x) for x in shaped]

    def _sensed(self, known: int, islands: Sequence[int], *, keep: bool = False) -> int:
        """Put what the islands of sensors depend on in the place of the sensors."""
        sensed = known >> self._sensor
        quantities = _indices(sensed)
        of_islands = {island for q in quantities for island in self.places.of_quantity(q)}
        own = known if keep else self._variables(known)
        return own | union(islands[island] for island in of_islands)

    def _variables(self, known: int) -> int:
        return known & ((1 << self._sensor) - 1)

    # -------------------------------------------------------------------------------- unknowns

    def directly(self, variable: Variable) -> int:
        """Inputs that act on a variable at a communication point."""
        return self._of(variable, self._now) & self.inputs

    def at_the_start(self, variable: Variable) -> int:
        """Parameters and inputs that act on a variable in the initialization mode."""
        if variable.name == "solver.status":  # not 0 where what was set cannot be
            return self.settable
        return self._of(variable, self._first)

    def _of(self, variable: Variable, measured: Mapping[int, int]) -> int:
        if variable.kind == "measured":
            return measured[self.model.offsets["measured"] + variable.place]
        return self._variables(measured.get(variable.place, 0))

    @cached_property
    def _now(self) -> dict[int, int]:
        return self._measured(self._direct)

    @cached_property
    def _first(self) -> dict[int, int]:
        return self._measured(self._initial)

    def _measured(self, level: Callable[[str, int], int]) -> dict[int, int]:
        """Sets of all numbers, with measurements and what outputs make of them."""
        sets, base = dict(self._numbers), self.model.offsets["measured"]
        for section, (start, count) in measured_sections(self.model.sizes).items():
            for k in range(count):
                sets[base + start + k] = level(section, k)
        self._run("outputs", sets)
        return sets

    def _direct(self, section: str, k: int) -> int:
        if section in _OF_NOTHING:
            return 0
        islands = self.places.of_measured(section, k)
        if section in _STATES or (section == "energy" and k == 0):
            return union(self.driven[island] for island in islands)
        if section == "element_force":
            own = self._sensed(self._own[k], self.driven) & self.inputs
            return own | union(self.driven[island] for island in islands)
        return union(self.forced[island] for island in islands)

    def _initial(self, section: str, k: int) -> int:
        if section in _OF_NOTHING:
            return 0
        islands = self.places.of_measured(section, k)
        return self.settings | union(self.shaped[island] for island in islands)
