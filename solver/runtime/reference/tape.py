"""The tape: scalar operations on the vector of numbers, in which expressions of a scene arrive.

Each operation is five integers: code, target, three arguments (the last ones unused by most). The
arithmetic is that of IEEE 754: what has no value becomes NaN, which is caught where it matters.
Functions are those of the C library, bit for bit those of the kernel.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from ..model import Model

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


OPERATIONS: tuple[tuple[int, Callable[..., float]], ...] = (
    (1, lambda a: a),
    (2, np.add),
    (2, np.subtract),
    (2, np.multiply),
    (2, np.divide),
    (2, _library(math.pow, np.power)),
    (1, np.negative),
    (1, _library(math.sin, np.sin)),
    (1, _library(math.cos, np.cos)),
    (1, _library(math.tan, np.tan)),
    (1, _library(math.asin, np.arcsin)),
    (1, _library(math.acos, np.arccos)),
    (1, _library(math.atan, np.arctan)),
    (2, _library(math.atan2, np.arctan2)),
    (1, np.sqrt),
    (1, _library(math.exp, np.exp)),
    (1, _library(math.log, np.log)),
    (1, np.abs),
    (2, _minimum),
    (2, _maximum),
    (1, np.sign),
    (2, _truth(lambda a, b: a < b)),
    (2, _truth(lambda a, b: a <= b)),
    (2, _truth(lambda a, b: a > b)),
    (2, _truth(lambda a, b: a >= b)),
    (2, _truth(lambda a, b: a == b)),
    (2, _truth(lambda a, b: a != b)),
    (2, _truth(lambda a, b: a != 0.0 and b != 0.0)),
    (2, _truth(lambda a, b: a != 0.0 or b != 0.0)),
    (1, _truth(lambda a: a == 0.0)),
    (3, lambda condition, a, b: a if condition != 0.0 else b),
)
"""Number of arguments and meaning of each code, in the order of the codes."""


def run_tape(model: Model, numbers: Array, segment: int) -> None:
    """Run one segment on `numbers` (modified): 0 parameters, 1 time and inputs, 2 measurements."""
    lengths = [model.sizes[f"n_tape_{name}"] for name in ("parameters", "laws", "outputs")]
    first = sum(lengths[:segment])
    tape = np.asarray(model.tables["tape"]).reshape(-1, 5)
    for code, target, *arguments in tape[first : first + lengths[segment]]:
        count, operation = OPERATIONS[code]
        numbers[target] = operation(*(numbers[place] for place in arguments[:count]))
