"""Checks of a mechanism when its parameters have arrived: numbers, drawn lengths, velocities."""

from __future__ import annotations

import math
from collections.abc import Sequence

from .kernel import Kernel
from .model import Model

DRAWN = 1e-9
"""Largest relative error of a drawn length. A larger one would be turned into a jolt by the first step."""


def broken_rules(model: Model, numbers: Sequence[float]) -> list[str]:
    """Return one sentence for each rule that the numbers break."""
    return [
        rule.message.format(value=numbers[rule.number])
        for rule in model.rules
        if not rule.holds(numbers[rule.number])
    ]


def _ends(model: Model, engine: Kernel, row: int) -> tuple[list[float], list[float], float]:
    """Positions along the link, velocities along it, and length, of the two ends of a row."""
    dim, n_free = model.sizes["dim"], model.sizes["n_free"]
    numbers, offsets, tables = engine.numbers, model.offsets, model.tables
    form = tables["row_form"][row]
    begin, end = tables["form_ptr"][form], tables["form_ptr"][form + 1]
    places, speeds = [], []
    for entry in range(begin, end):
        node = tables["form_node"][entry]
        if node < n_free:
            at, rate = (
                offsets[f"initial_{what}"] + dim * node for what in ("position", "velocity")
            )
            speeds.append(list(numbers[rate : rate + dim]))
        else:
            at = offsets["support"] + dim * (node - n_free)
            speeds.append([0.0] * dim)
        places.append(list(numbers[at : at + dim]))
    signs = numbers[offsets["alpha"] + begin : offsets["alpha"] + end]
    link = [sum(s * x[k] for s, x in zip(signs, places, strict=True)) for k in range(dim)]
    length = math.hypot(*link)
    along = [sum(a * b for a, b in zip(v, link, strict=True)) / (length or 1.0) for v in speeds]
    ordered = sorted(zip(signs, along, strict=True), key=lambda pair: pair[0])
    return link, [rate for _, rate in ordered], length


def contradicted_rows(model: Model, engine: Kernel) -> list[str]:
    """Return one sentence for each row that the drawn configuration or its velocities contradict."""
    problems = []
    phi, phi_dot = engine.residuals()
    for row, name in enumerate(model.row_names):
        scale = engine.numbers[model.offsets["row_scale"] + row]
        _, speeds, length = _ends(model, engine, row)
        wanted = math.sqrt(scale)
        if not abs(phi[row]) <= 2.0 * DRAWN * scale:
            problems.append(
                f"{name}: length is {wanted:.12g} m, but its points are drawn {length:.12g} m apart; "
                f"move a point, correct the length, or leave it out to take it as drawn"
            )
        elif not abs(phi_dot[row]) <= 2.0 * DRAWN * scale**0.5 * max(map(abs, speeds), default=0.0):
            problems.append(
                f"{name}: the velocities of its points contradict it: along it they are "
                f"{speeds[0]:.12g} m/s and {speeds[-1]:.12g} m/s, and must be equal"
            )
    return problems
