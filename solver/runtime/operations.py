"""Operations of the core, one at a time: a value from here has the bits of one from a run."""

from __future__ import annotations

import functools
from collections.abc import Callable

from .kernel import shared_library
from .layout import CODES


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
