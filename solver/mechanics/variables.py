"""The variable table of a model, and what the symbols of its expressions mean."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from functools import cached_property

from solver.mechanics.parts import AXES
from solver.mechanics.sensors import Measures, Named, Ref
from solver.mechanics.structure import Structure
from solver.mechanics.tape import Segment
from solver.options import OPTIONS
from solver.runtime.layout import measured_sections
from solver.runtime.model import Variable
from solver.scene import Expr, Number, Scene
from solver.scene.expression import sqrt, symbol

Meaning = tuple[str, int, Segment] | Number
"""A place - section, index there, and when it is known - or an expression."""


class Symbols:
    """What the symbols of expressions stand for.

    A large mechanism has many more names than its expressions mention: each is found when it is
    asked for.
    """

    def __init__(
        self, scene: Scene, measures: Measures, table: Iterable[Named], structure: Structure
    ) -> None:  # fmt: skip
        self._structure, self._measures, self._table = structure, measures, table
        self._sections = measured_sections(structure.sizes)
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
        return "measured", found.place(self._structure, self._sections), Segment.OUTPUTS

    def measured(self, name: str) -> Ref | Number:
        """Return what is measured under a name, or by the symbol of an expression."""
        return self._measures.refs.get(name) or self._named[name]

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


def distance_between(dim: int, call: str) -> Number:
    """Return the expression of ``distance(A, B)`` in the coordinates of its places."""
    first, second = call.removeprefix("distance(").removesuffix(")").split(", ")
    total: Number = 0.0
    for axis in AXES[:dim]:
        gap = symbol(f"{second}.{axis}") - symbol(f"{first}.{axis}")
        total = total + gap * gap
    return sqrt(total)


def variable_table(
    scene: Scene, outputs: Iterable[Variable], measured: Iterable[Variable],
    calculated: Mapping[str, int],
) -> tuple[Variable, ...]:  # fmt: skip
    """Return all variables: parameters, inputs, settings, outputs of the scene, measurements."""
    return (
        *_parameters(scene, calculated),
        *(
            Variable(
                name=name, type="Real", causality="input", variability="continuous",
                unit=given.unit, description=given.description, start=given.start,
                minimum=given.min, maximum=given.max, kind="input", place=place,
                clips=given.limit == "clip",
            )
            for place, (name, given) in enumerate(scene.inputs.items())
        ),
        *_settings(scene),
        *outputs,
        *measured,
    )  # fmt: skip


def output(name: str, unit: str, text: str, kind: str, place: int) -> Variable:
    """Return the variable of an output: a measurement or a number of the tape."""
    limits = None, None, None  # start, minimum, maximum
    return Variable(name, "Real", "output", "continuous", unit, text, *limits, kind, place)


def _parameters(scene: Scene, calculated: Mapping[str, int]) -> Iterator[Variable]:
    place = 0
    for name, given in scene.parameters.items():
        free = not isinstance(given.value, Expr)
        yield Variable(
            name=name, type="Real", causality="parameter" if free else "calculatedParameter",
            variability=given.variability, unit=given.unit, description=given.description,
            start=None if isinstance(given.value, Expr) else float(given.value),
            minimum=given.min, maximum=given.max,
            kind="parameter" if free else "number", place=place if free else calculated[name],
        )  # fmt: skip
        place += free


def _settings(scene: Scene) -> Iterator[Variable]:
    for option in OPTIONS.values():
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
