"""Inputs that change during a run: columns by name, from a CSV file or arrays."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from build_fmu.reference import Reference, columns_of, name_of
from build_fmu.study.values import Mistake, nearest, refuse

if TYPE_CHECKING:
    from fmpy.model_description import ModelDescription
    from numpy import ndarray


def input_signals(
    inputs: Reference, description: ModelDescription, held: Mapping[str, object]
) -> ndarray:
    """Inputs over time, as fmpy takes them: one row for each time, straight lines between them.

    `held` has the values of inputs that do not change; an input that is neither there nor a column
    keeps its start value.

    Raises
    ------
    UsageError
        If a column is no input, an input has a value besides its column, or what `columns_of`
        raises.
    """
    import numpy as np

    columns, where = columns_of(inputs), name_of(inputs)
    known = {v.name: v.start for v in description.modelVariables if v.causality == "input"}
    mistakes = []
    for name in columns.keys() - {"time"}:
        if name not in known:
            message = f"{description.modelName} has no input {name!r}"
            mistakes.append(Mistake(where, message, nearest(name, known)))
        elif name in held:
            help = "leave out the column, or the value"
            mistakes.append(Mistake(where, f"{name}: there is a value for the whole run", help))
    if columns.keys() <= {"time"}:
        mistakes.append(Mistake(where, "has no column of an input", nearest("", known)))
    refuse(mistakes)
    signals = np.empty(len(columns["time"]), [(name, float) for name in ("time", *known)])
    signals["time"] = columns["time"]
    for name, start in known.items():
        signals[name] = columns.get(name, float(held.get(name, start or 0.0)))  # type: ignore[arg-type]
    return signals
