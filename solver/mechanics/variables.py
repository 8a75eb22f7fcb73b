"""The variable table of a model, and what the symbols of its expressions mean."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import cached_property

from solver.mechanics.parts import AXES
from solver.mechanics.sensors import Named, Ref, Sensors
from solver.mechanics.structure import Structure
from solver.mechanics.tape import Numbers, Segment
from solver.options import OPTIONS
from solver.runtime.model import Variable
from solver.scene import Expr, Number, Scene
from solver.scene.expression import sqrt, symbol
from solver.scene.states import sampled_states

Meaning = tuple[str, int, Segment] | Number
"""A place - section, index there, and when it is known - or an expression."""


class Symbols:
    """What the symbols of expressions stand for.

    A large mechanism has many more names than its expressions mention: each is found when it is
    asked for.
    """

    def __init__(
        self, scene: Scene, sensors: Sensors, table: Iterable[Named], structure: Structure
    ) -> None:  # fmt: skip
        self._structure, self._sensors, self._table = structure, sensors, table
        self._given = dict(_given(scene))

    def meaning(self, name: str) -> Meaning:
        """Return what a symbol stands for."""
        if name in self._given:
            return self._given[name]
        kind, _, quantity = name.partition(" ")
        if kind in SENSORS:
            return SENSORS[kind], self._structure.quantity_of[int(quantity)], Segment.LAWS
        found = self.measured(name)
        if not isinstance(found, Ref):
            return found
        return "measured", found.place(self._structure), Segment.OUTPUTS

    def measured(self, name: str) -> Ref | Number:
        """Return what is measured under a name, or by the symbol of an expression."""
        if name.startswith("distance("):
            return self._distance(name)
        return self._sensors.refs.get(name) or self._named[name]

    def _distance(self, call: str) -> Number:
        """Return the expression of ``distance(A, B)`` in the coordinates of its places."""
        first, second = call.removeprefix("distance(").removesuffix(")").split(", ")
        total: Number = 0.0
        for axis in AXES[: self._structure.mechanism.dim]:
            gap = symbol(f"{second}.{axis}") - symbol(f"{first}.{axis}")
            total = total + gap * gap
        return sqrt(total)

    @cached_property
    def _named(self) -> dict[str, Ref | Number]:
        return {quantity.name: quantity.meaning for quantity in self._table}


SENSORS = {"#value": "sensor", "#rate": "sensor_rate"}


def _given(scene: Scene) -> Iterator[tuple[str, Meaning]]:
    """Yield the time, parameters and inputs."""
    yield "t", ("time", 0, Segment.LAWS)
    place = 0
    for name, parameter in scene.parameters.items():
        if isinstance(parameter.value, Expr):
            yield name, parameter.value
            continue
        tunable = parameter.variability == "tunable"
        yield name, ("parameter", place, Segment.LAWS if tunable else Segment.PARAMETERS)
        place += 1
    for place, name in enumerate(scene.inputs):
        yield name, ("input", place, Segment.LAWS)
    for place, (name, *_) in enumerate(sampled_states(scene.states)):
        yield name, ("held", place, Segment.LAWS)


def variables_of(
    scene: Scene, table: Iterable[Named], structure: Structure, numbers: Numbers
) -> Iterator[Variable]:
    """Yield all variables: parameters, inputs, settings, outputs of the scene, measurements."""

    def output(name: str, unit: str, text: str, meaning: Ref | Number, shown: str = "") -> Variable:
        if isinstance(meaning, Ref):
            kind, place = "measured", meaning.place(structure)
        else:
            kind, place = "number", numbers.place(meaning, Segment.OUTPUTS)
        limits = None, None, None  # start, minimum, maximum
        return Variable(
            name, "Real", "output", "continuous", unit, text, *limits, kind, place,
            display_unit=shown,
        )  # fmt: skip

    yield from _parameters(scene, numbers)
    for place, (name, given) in enumerate(scene.inputs.items()):
        yield Variable(
            name=name, type="Real", causality="input", variability="continuous",
            unit=given.unit, description=given.told, start=given.start,
            minimum=given.min, maximum=given.max, kind="input", place=place,
            clips=given.limit == "clip", display_unit=given.display_unit,
        )  # fmt: skip
    mechanism = structure.mechanism
    yield from _settings(scene, unilateral=bool(mechanism.contacts or mechanism.frictions))
    for name, _, _, found in sampled_states(scene.states):
        if found.listed:
            yield output(name, found.unit, found.text, symbol(name))
    for name, given in scene.outputs.items():
        yield output(name, given.unit, given.description, given.value, given.display_unit)
    for named in table:
        if named.listed:
            yield output(named.name, named.unit, named.text, named.meaning)


def _parameters(scene: Scene, numbers: Numbers) -> Iterator[Variable]:
    free = 0
    for name, given in scene.parameters.items():
        common = {
            "name": name, "type": "Real", "variability": given.variability, "unit": given.unit,
            "description": given.description, "minimum": given.min, "maximum": given.max,
            "display_unit": given.display_unit,
        }  # fmt: skip
        if isinstance(given.value, Expr):
            place = numbers.place(given.value)
            yield Variable(causality="calculatedParameter", kind="number", place=place, **common)
        else:
            start = float(given.value)
            yield Variable(
                causality="parameter", kind="parameter", place=free, start=start, **common
            )
            free += 1


def _settings(scene: Scene, *, unilateral: bool) -> Iterator[Variable]:
    for option in OPTIONS.values():
        if option.of_contacts and not unilateral:
            continue
        start = getattr(scene.solver, option.name)
        kind = "String" if option.words else "Boolean" if option.is_switch else "Real"
        words = f": one of {', '.join(option.words)}" if len(option.words) > 2 else ""
        yield Variable(
            name=f"solver.{option.name}", type=kind, causality="parameter", variability="fixed",
            unit=option.unit, description=f"{option.meaning}{words}",
            start=float(start) if kind == "Real" else start,
            minimum=option.low if kind == "Real" else None,
            maximum=option.high if kind == "Real" else None, kind="option",
        )  # fmt: skip
