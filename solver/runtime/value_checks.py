"""Check of a value before it is set: may it change now, is it a number, is it in its range."""

from __future__ import annotations

import math

from .errors import OptionError
from .options import encode

TYPE_CHECKING = False  # typing's own would be imported with the FMU, for nothing
if TYPE_CHECKING:
    from .model import Variable


def check_settable(variable: Variable, value: float | str | bool, *, moving: bool) -> None:
    """Check that a variable may take a value, in motion or before it.

    Raises
    ------
    OptionError
        Naming the variable, the value and the rule that it breaks.
    """
    name, unit = variable.name, f" {variable.unit}".rstrip()
    if variable.causality not in ("parameter", "input"):
        message = f"{name}: is calculated and cannot be set"
        raise OptionError(message)
    if variable.variability == "fixed" and moving:
        message = f"{name}: is a fixed parameter; set it before the first step, or reset first"
        raise OptionError(message)
    if variable.kind == "option":
        encode(name.removeprefix("solver."), value)
        return
    if not isinstance(value, int | float) or not math.isfinite(value):
        message = f"{name}: must be a finite number{unit and f' in{unit}'}, got {value!r}"
        raise OptionError(message)
    if variable.minimum is not None and value < variable.minimum:
        message = f"{name}: must be >= {variable.minimum:g}{unit}, got {value!r}"
        raise OptionError(message)
    if variable.maximum is not None and value > variable.maximum:
        message = f"{name}: must be <= {variable.maximum:g}{unit}, got {value!r}"
        raise OptionError(message)
