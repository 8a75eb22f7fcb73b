"""From the tables of a scene file to a ``Scene``: references, symbols, values, every mistake.

Each table has one function. A broken field counts as reported; a part that was left out of a table
because its type is unknown still lends its name, so that nothing is reported twice.
"""

from __future__ import annotations

from graphlib import CycleError, TopologicalSorter
from typing import Any

from solver.scene.draft import Draft
from solver.scene.elements import Elements
from solver.scene.names import check_name, check_names, quantities
from solver.scene.numbers import (
    GEOMETRY,
    NOT_NEGATIVE,
    OUTPUT,
    PARAMETER,
    POSITIVE,
    Known,
    Numbers,
)
from solver.scene.report import did_you_mean
from solver.scene.schema import BROKEN, TYPES, Experiment, File, Heading, Solver
from solver.scene.vocabulary import (
    Experiment as ExperimentSettings,
)
from solver.scene.vocabulary import (
    Input,
    Output,
    Parameter,
    Scene,
    SolverSettings,
    Vector,
)

_KINDS = {
    "parameters": "parameter", "inputs": "input", "outputs": "output", "points": "point",
    "bodies": "bar", "joints": "joint", "forces": "force", "drivers": "driver",
}  # fmt: skip


def build(draft: Draft) -> Scene:
    """Check a draft and turn it into a scene; the draft collects the mistakes."""
    tables = {**Heading.model_fields, **File.model_fields}
    for name in draft.data:
        if name not in tables:
            draft.error((name,), "unknown field", did_you_mean(name, tables, "known"))
    heading = draft.part(
        (), Heading, {k: v for k, v in draft.data.items() if k in Heading.model_fields}
    )
    check_names(draft)
    if heading.name is not BROKEN:
        check_name(draft, ("name",), heading.name)
    known = Known({name: kind for table, kind in _KINDS.items() for name in _names(draft, table)})
    numbers = Numbers(draft, known)
    parameters = _parameters(draft, numbers)
    elements = Elements(numbers, heading.dimension, "dimension" in draft.data)
    inputs = _inputs(draft, numbers)
    points, bodies, joints, forces = elements.read()
    known.quantities |= set(
        quantities(
            elements.dimension or 3,
            _names(draft, "points"),
            _names(draft, "bodies"),
            _names(draft, "joints"),
            {name: _type(data) for name, data in _items(draft, "forces")},
        )
    )
    outputs = {
        name: Output(
            value=numbers.number(("outputs", name, "value"), part.value, OUTPUT),
            unit=part.unit,
            description=part.description,
        )
        for name, part in draft.parts("outputs").items()
    }
    solver, experiment = _settings(draft, numbers)
    return Scene(
        name=heading.name,
        description=heading.description,
        dimension=elements.dimension or 3,
        gravity=_gravity(elements, heading),
        parameters=parameters,
        inputs=inputs,
        points=points,
        bodies=bodies,
        joints=joints,
        forces=forces,
        outputs=outputs,
        solver=solver,
        experiment=experiment,
        source=draft.source,
    )


def _items(draft: Draft, table: str) -> list[tuple[str, Any]]:
    entries = draft.data.get(table)
    return list(entries.items()) if isinstance(entries, dict) else []


def _names(draft: Draft, table: str) -> list[str]:
    return [name for name, _ in _items(draft, table)]


def _type(data: Any) -> Any:
    """Type of a force; one of unknown type may have any quantity."""
    wanted = data.get("type") if isinstance(data, dict) else None
    return wanted if wanted in TYPES["forces"] else "spring"


def _gravity(elements: Elements, heading: Any) -> Vector:
    if heading.gravity is None:
        return (0.0,) * (elements.dimension or 3)
    return elements.vector(("gravity",), heading.gravity, GEOMETRY)


def _parameters(draft: Draft, numbers: Numbers) -> dict[str, Parameter]:
    parts = draft.parts("parameters")
    known = numbers.known
    for name in _order(draft, parts):
        part = parts[name]
        path = _value_path(draft, name)
        number = numbers.number(path, part.value, PARAMETER)
        uses = {mention.name for mention in getattr(part.value, "mentions", ())}
        if part.variability == "tunable" or uses & known.tunable:
            known.tunable.add(name)
        if uses and part.variability is not None and part.variability is not BROKEN:
            message = "a calculated parameter has the variability of what it is calculated from"
            draft.error(("parameters", name, "variability"), message, "leave it out")
        unread = part.value is BROKEN or (uses and number == 0.0 and not uses <= set(known.values))
        value = None if unread else numbers.default(path, part.value)
        if value is not None:
            known.values[name] = value
    read = {}
    for name, part in parts.items():
        low, high = _range(numbers, "parameters", name, part, known.values.get(name))
        broken = part.value is BROKEN
        read[name] = Parameter(
            value=0.0 if broken else part.value.number,
            unit=part.unit,
            description=part.description,
            minimum=low,
            maximum=high,
            variability="tunable" if name in known.tunable else "fixed",
        )
    return read


def _value_path(draft: Draft, name: str) -> tuple[str, ...]:
    """Place of a parameter's value, in the short form or in a table."""
    short = not isinstance(draft.data["parameters"][name], dict)
    return ("parameters", name) if short else ("parameters", name, "value")


def _order(draft: Draft, parts: dict[str, Any]) -> list[str]:
    """Parameters in the order of their calculation; those in a circle are reported and come last."""
    uses = {
        name: {m.name for m in getattr(part.value, "mentions", ()) if m.name in parts}
        for name, part in parts.items()
    }
    circular: list[str] = []
    while True:
        try:
            return [*TopologicalSorter(uses).static_order(), *circular]
        except CycleError as error:
            circle = error.args[1][:-1]
            first = min(circle, key=list(parts).index)
            start = circle.index(first)
            names = [*circle[start:], *circle[:start], first]
            draft.error(
                _value_path(draft, first), f"parameters defined in a circle: {' <- '.join(names)}"
            )
            circular += circle
            uses = {name: used - set(circle) for name, used in uses.items() if name not in circle}


def _inputs(draft: Draft, numbers: Numbers) -> dict[str, Input]:
    read = {}
    for name, part in draft.parts("inputs").items():
        start = numbers.constant(("inputs", name, "start"), part.start, 0.0)
        low, high = _range(numbers, "inputs", name, part, start)
        read[name] = Input(
            start=start,
            unit=part.unit,
            description=part.description,
            minimum=low,
            maximum=high,
        )
    return read


def _range(
    numbers: Numbers, table: str, name: str, part: Any, value: float | None
) -> tuple[float | None, float | None]:
    """Read min and max of a parameter or input and hold its value against them."""
    path, unit = (table, name), f" {part.unit}" if isinstance(part.unit, str) and part.unit else ""
    given = [
        None if bound is None or bound is BROKEN else numbers.constant((*path, word), bound, 0.0)
        for word, bound in (("min", part.min), ("max", part.max))
    ]
    low, high = given
    if low is not None and high is not None and low > high:
        numbers.draft.error((*path, "min"), f"min {low:g} is larger than max {high:g}")
    elif value is not None and low is not None and not value >= low:
        numbers.draft.error(path, f"must be >= {low:g}{unit} (its min), got {value:.15g}")
    elif value is not None and high is not None and not value <= high:
        numbers.draft.error(path, f"must be <= {high:g}{unit} (its max), got {value:.15g}")
    return low, high


def _settings(draft: Draft, numbers: Numbers) -> tuple[SolverSettings, ExperimentSettings]:
    solver = draft.part(("solver",), Solver, draft.table("solver"))
    experiment = draft.part(("experiment",), Experiment, draft.table("experiment"))

    def time(table: str, part: Any, name: str, default: float, rule: Any = None) -> float:
        return numbers.constant((table, name), getattr(part, name), default, rule, "s")

    outer = time("experiment", experiment, "step_size", 0.0, POSITIVE)
    inner = time("solver", solver, "step_size", min(0.01, outer) if outer > 0.0 else 0.01, POSITIVE)
    if outer > 0.0 and inner > outer:
        message = f"the internal step {inner:g} s is larger than the communication step {outer:g} s"
        draft.error(("solver", "step_size"), message)
    start = time("experiment", experiment, "start_time", 0.0)
    stop = time("experiment", experiment, "stop_time", start + 1.0)
    if experiment.stop_time not in (None, BROKEN) and not stop > start:
        message = f"must be > start_time = {start:g} s, got {stop:g}"
        draft.error(("experiment", "stop_time"), message)
    for name in ("max_newton", "max_uzawa"):
        count = getattr(solver, name)
        if count is not BROKEN and not 1 <= count <= 1000:
            draft.error(("solver", name), f"must be from 1 to 1000, got {count}")

    def setting(name: str, rule: Any) -> float:
        default = getattr(SolverSettings(), name)
        return numbers.constant(("solver", name), getattr(solver, name), default, rule)

    given = numbers.constant(("experiment", "tolerance"), experiment.tolerance, 0.0, POSITIVE)
    return SolverSettings(
        **{name: getattr(solver, name) for name in _CHOICES},
        step_size=inner,
        tolerance=setting("tolerance", POSITIVE),
        penalty=setting("penalty", POSITIVE),
        xi=setting("xi", NOT_NEGATIVE),
        omega=setting("omega", POSITIVE),
    ), ExperimentSettings(
        start_time=start,
        stop_time=stop,
        step_size=outer or 10.0 * inner,
        tolerance=given or None,
    )


_CHOICES = (
    "formulation", "algorithm", "multiplier_update", "order", "paired", "max_newton", "max_uzawa",
)  # fmt: skip
