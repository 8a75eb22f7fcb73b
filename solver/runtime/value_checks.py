"""Check of a value before it is set: may it change now, is it a number, is it in its range."""

from __future__ import annotations

import math
import sys

from .errors import OptionError
from .options import encode

TYPE_CHECKING = False  # typing's own would be imported with the FMU, for nothing
if TYPE_CHECKING:
    from .model import Variable


def check_is_double(name: str, value: object) -> None:
    """Check that a value, if it is an integer, is one that a double can hold.

    Raises
    ------
    OptionError
        Naming the variable; such an integer has too many digits to be shown.
    """
    if isinstance(value, int) and abs(value) > sys.float_info.max:
        message = f"{name}: must be a finite number, got an integer of more than 308 digits"
        raise OptionError(message)


def check_settable(variable: Variable, value: float | str | bool, *, moving: bool) -> None:
    """Check that a variable may take a value, in motion or before it.

    Raises
    ------
    OptionError
        Naming the variable, the value and the rule that it breaks.
    """
    name, unit = variable.name, f" {variable.unit}".rstrip()
    check_is_double(name, value)
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
    limit = _limit_before(variable, value)
    if limit is not None and not variable.clips:
        sign = ">=" if value < limit else "<="
        message = f"{name}: must be {sign} {limit:g}{unit}, got {value!r}"
        if variable.causality == "input":
            message += f'; with limit = "clip" in the scene\'s [inputs] it is {limit:g} instead'
        raise OptionError(message)


def clipped(variable: Variable, value: float | str | bool) -> tuple[float | str | bool, str]:
    """Value to take, and a sentence if that is the limit of an input that clips."""
    limit = _limit_before(variable, float(value)) if variable.clips else None
    if limit is None:
        return value, ""
    unit = f" {variable.unit}".rstrip()
    sentence = f"{variable.name}: {value!r}{unit} is beyond {limit:g}{unit}"
    return limit, f"{sentence}, and is clipped to this limit (reported once)"


def _limit_before(variable: Variable, value: float) -> float | None:
    """The limit that a value is beyond; None if it is within both."""
    if variable.minimum is not None and value < variable.minimum:
        return variable.minimum
    if variable.maximum is not None and value > variable.maximum:
        return variable.maximum
    return None
