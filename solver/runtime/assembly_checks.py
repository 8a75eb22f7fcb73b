"""Checks of a mechanism when its parameters have arrived: numbers, drawn lengths, velocities."""

from __future__ import annotations

import math
from collections.abc import Iterable

TYPE_CHECKING = False  # typing's own would be imported with the FMU, for nothing
if TYPE_CHECKING:
    from .engine import Doubles, Engine
    from .model import Model, Rule

DRAWN = 1e-9
"""Largest relative error of a drawn length: the first step would turn a larger one into a jolt."""


def rules_of_laws(model: Model) -> tuple[Rule, ...]:
    """Return the rules that inputs and tunable parameters can break in motion, unnoticed.

    A law that is not finite is noticed: the step fails. So plain loads need no check.
    """
    sizes, offsets = model.sizes, model.offsets
    start = 5 * sizes["n_tape_parameters"]  # an operation is code, target and three arguments
    laws = model.tables["tape"][start : start + 5 * sizes["n_tape_laws"]]
    moved = {*laws[1::5], *range(offsets["input"], offsets["input"] + sizes["n_inputs"])}
    for variable in model.variables:
        if variable.kind == "parameter" and variable.variability == "tunable":
            moved.add(offsets["parameter"] + variable.place)
    return tuple(rule for rule in model.rules if rule.number in moved and rule.relation != "finite")


def broken_rules(rules: Iterable[Rule], numbers: Doubles) -> list[str]:
    """Return one sentence for each rule that the numbers break."""
    return [
        rule.message.format(value=numbers[rule.number])
        for rule in rules
        if not rule.holds(numbers[rule.number])
    ]


def _drawn(model: Model, numbers: Doubles, row: int) -> tuple[float, ...]:
    """Return a row's drawn length, the velocities of its ends along it, and the larger speed."""
    dim, n_free = model.sizes["dim"], model.sizes["n_free"]
    offsets, tables = model.offsets, model.tables
    form = tables["row_form"][row]
    link, ends = [0.0] * dim, []
    for entry in range(tables["form_ptr"][form], tables["form_ptr"][form + 1]):
        node, sign = tables["form_node"][entry], numbers[offsets["alpha"] + entry]
        at = offsets["initial_position"] + dim * node
        velocity = offsets["initial_velocity"] + dim * node
        if node >= n_free:
            at = offsets["support"] + dim * (node - n_free)
        link = [u + sign * numbers[at + k] for k, u in enumerate(link)]
        moving = [numbers[velocity + k] if node < n_free else 0.0 for k in range(dim)]
        ends.append((sign, moving))
    length = math.hypot(*link)
    speeds = [
        sum(v * u for v, u in zip(moving, link, strict=True)) / (length or 1.0)
        for _, moving in sorted(ends)
    ]
    return length, *speeds, max(math.hypot(*moving) for _, moving in ends)


def contradicted_rows(model: Model, engine: Engine) -> list[str]:
    """Return one sentence for each row that the drawn configuration or velocities contradict."""
    problems = []
    for row, (name, phi, rate) in enumerate(zip(model.row_names, *engine.residuals(), strict=True)):
        scale = engine.numbers[model.offsets["row_scale"] + row]
        length, first, second, fastest = _drawn(model, engine.numbers, row)
        if not abs(phi) <= 2.0 * DRAWN * scale:
            problems.append(
                f"{name}: length is {math.sqrt(scale):.12g} m, but its points are drawn "
                f"{length:.12g} m apart; move a point, correct the length, or leave it out "
                f"to take it as drawn"
            )
        elif not abs(rate) <= 2.0 * DRAWN * math.sqrt(scale) * fastest:
            problems.append(
                f"{name}: the velocities of its points contradict it: along it they are "
                f"{first:.12g} m/s and {second:.12g} m/s, and must be equal"
            )
    return problems
