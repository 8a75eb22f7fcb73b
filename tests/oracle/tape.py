"""The tape: scalar operations on the vector of numbers, in which expressions of a scene arrive.

Each operation is five integers: code, target, three arguments (the last ones unused by most). The
arithmetic is that of IEEE 754: what has no value becomes NaN.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from solver.runtime import Model
from solver.runtime.layout import CODES
from tests.oracle import splines

Array = NDArray[np.float64]

MEANINGS: dict[str, Callable[..., float]] = {
    "copy": lambda a: a, "add": np.add, "sub": np.subtract, "mul": np.multiply, "div": np.divide,
    "pow": np.power, "neg": np.negative, "sin": np.sin, "cos": np.cos, "tan": np.tan,
    "asin": np.arcsin, "acos": np.arccos, "atan": np.arctan, "atan2": np.arctan2, "sqrt": np.sqrt,
    "exp": np.exp, "log": np.log, "abs": np.abs, "min": np.minimum, "max": np.maximum,
    "sign": np.sign, "lt": np.less, "le": np.less_equal, "gt": np.greater,
    "ge": np.greater_equal, "eq": np.equal, "ne": np.not_equal, "and": np.logical_and,
    "or": np.logical_or, "not": np.logical_not, "select": lambda c, a, b: a if c else b,
    "sinh": np.sinh, "cosh": np.cosh, "tanh": np.tanh, "floor": np.floor, "ceil": np.ceil,
    "mod": np.mod,
}  # fmt: skip
"""What each operation computes; conditions give 1 or 0."""

COUNTS = {name: getattr(meaning, "nin", 1) for name, meaning in MEANINGS.items()} | {"select": 3}
"""How many arguments each operation has."""

SEGMENTS = "parameters", "laws", "signals", "outputs"
"""Parts of a tape, in their order: what depends on parameters alone; forces, on time, inputs and
sensors; prescribed values, on time and inputs; what is made of measurements."""


def value_of(code: int, arguments: list[float]) -> float:
    """Value of one operation; `arguments` may be more than it has."""
    name = CODES[code]
    with np.errstate(all="ignore"):
        return float(MEANINGS[name](*arguments[: COUNTS[name]]))


def run_tape(model: Model, numbers: Array, segment: str) -> None:
    """Run one segment on `numbers` (modified)."""
    place = SEGMENTS.index(segment)
    lengths = [model.sizes[f"n_tape_{name}"] for name in SEGMENTS]
    first = sum(lengths[:place])
    tape = np.asarray(model.tables["tape"]).reshape(-1, 5)
    for code, target, *places in tape[first : first + lengths[place]]:
        if CODES[code] in splines.ORDERS:
            x, table = numbers[places[0]], numbers[places[1] : places[2] + 1]
            numbers[target] = splines.value(splines.ORDERS[CODES[code]], x, table)
        else:
            numbers[target] = value_of(code, [numbers[place] for place in places])
