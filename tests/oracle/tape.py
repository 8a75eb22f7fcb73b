"""The tape: scalar operations on the vector of numbers, in which expressions of a scene arrive.

Each operation is five integers: code, target, three arguments (the last ones unused by most). The
arithmetic is that of IEEE 754: what has no value becomes NaN, which is caught where it matters.
Functions are those of the C library.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from solver.runtime import Model

Array = NDArray[np.float64]


def _truth(test: Callable[..., bool]) -> Callable[..., float]:
    return lambda *values: 1.0 if test(*values) else 0.0


def _library(function: Callable[..., float], ieee: Callable[..., float]) -> Callable[..., float]:
    """Function of the C library; where Python refuses, the infinity or NaN of IEEE 754."""

    def value(*arguments: float) -> float:
        try:
            return function(*arguments)
        except (ValueError, OverflowError):
            return ieee(*arguments)

    return value


def _minimum(a: float, b: float) -> float:
    return a if a <= b or a != a else b


def _maximum(a: float, b: float) -> float:
    return a if a >= b or a != a else b


OPERATIONS: dict[str, tuple[int, Callable[..., float]]] = {
    "copy": (1, lambda a: a),
    "add": (2, np.add),
    "sub": (2, np.subtract),
    "mul": (2, np.multiply),
    "div": (2, np.divide),
    "pow": (2, _library(math.pow, np.power)),
    "neg": (1, np.negative),
    "sin": (1, _library(math.sin, np.sin)),
    "cos": (1, _library(math.cos, np.cos)),
    "tan": (1, _library(math.tan, np.tan)),
    "asin": (1, _library(math.asin, np.arcsin)),
    "acos": (1, _library(math.acos, np.arccos)),
    "atan": (1, _library(math.atan, np.arctan)),
    "atan2": (2, _library(math.atan2, np.arctan2)),
    "sqrt": (1, np.sqrt),
    "exp": (1, _library(math.exp, np.exp)),
    "log": (1, _library(math.log, np.log)),
    "abs": (1, np.abs),
    "min": (2, _minimum),
    "max": (2, _maximum),
    "sign": (1, np.sign),
    "lt": (2, _truth(lambda a, b: a < b)),
    "le": (2, _truth(lambda a, b: a <= b)),
    "gt": (2, _truth(lambda a, b: a > b)),
    "ge": (2, _truth(lambda a, b: a >= b)),
    "eq": (2, _truth(lambda a, b: a == b)),
    "ne": (2, _truth(lambda a, b: a != b)),
    "and": (2, _truth(lambda a, b: a != 0.0 and b != 0.0)),
    "or": (2, _truth(lambda a, b: a != 0.0 or b != 0.0)),
    "not": (1, _truth(lambda a: a == 0.0)),
    "select": (3, lambda condition, a, b: a if condition != 0.0 else b),
    "sinh": (1, _library(math.sinh, np.sinh)),
    "cosh": (1, _library(math.cosh, np.cosh)),
    "tanh": (1, math.tanh),
    "floor": (1, np.floor),
    "ceil": (1, np.ceil),
    "mod": (2, np.mod),
}
"""Number of arguments and meaning of each operation, in the order of the codes."""

NAMES = tuple(OPERATIONS)
"""Operation of each code, as in ``solver/mechanics/tape.py``."""


SEGMENTS = "parameters", "laws", "signals", "outputs"
"""Parts of a tape, in their order: what depends on parameters alone; forces, on time, inputs and
sensors; prescribed values, on time and inputs; what is made of measurements."""


def run_tape(model: Model, numbers: Array, segment: int | str) -> None:
    """Run one segment, by name or place, on `numbers` (modified)."""
    place = SEGMENTS.index(segment) if isinstance(segment, str) else segment
    lengths = [model.sizes[f"n_tape_{name}"] for name in SEGMENTS]
    first = sum(lengths[:place])
    tape = np.asarray(model.tables["tape"]).reshape(-1, 5)
    for code, target, *arguments in tape[first : first + lengths[place]]:
        count, operation = OPERATIONS[NAMES[code]]
        numbers[target] = operation(*(numbers[place] for place in arguments[:count]))
