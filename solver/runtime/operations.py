"""Operations of the core, one at a time: a value from here has the bits of one from a run."""

from __future__ import annotations

import functools
from collections.abc import Callable

from .kernel import shared_library

CODES = (
    "copy", "add", "sub", "mul", "div", "pow", "neg", "sin", "cos", "tan", "asin", "acos", "atan",
    "atan2", "sqrt", "exp", "log", "abs", "min", "max", "sign", "lt", "le", "gt", "ge", "eq", "ne",
    "and", "or", "not", "select", "sinh", "cosh", "tanh", "floor", "ceil", "mod",
)  # fmt: skip
"""Operation codes in the order of ``tape_code`` in ``solver/kernel/internal.h``."""


@functools.cache
def in_core(name: str) -> Callable[..., float]:
    """Return an operation on floats.

    Its value is NaN where there is no real one, and an infinity where the result is too large.

    Raises
    ------
    KernelMissingError
        When there is no compiled kernel.
    """
    operate, code = shared_library(2).holonom_operate, CODES.index(name)
    return lambda a, b=0.0: operate(code, a, b, 0.0)
