"""How settings of the solver are stored in a state, and what that refuses."""

from __future__ import annotations

from solver.options import OPTIONS

from .errors import OptionError

SLOTS = {2: 4, 4: 10, 6: 18, 8: 30}
"""Half steps of an internal one whose changes a state keeps, as they predict those of the next: all
of one internal step, and at order 2, where that saves a third of the iterations, of two."""


def slots_for(order: int, *, chosen: bool) -> int:
    """Return how many half steps a state keeps at an `order`, or at any that a tolerance chooses.

    A tolerance that is set after the assembly works with fewer, and takes up to a third longer.
    """
    return SLOTS[order or (max(SLOTS) if chosen else min(SLOTS))]


def encode(name: str, value: object) -> tuple[str, float]:
    """Return the scalar of the state's head that holds a setting, and its value there.

    Raises
    ------
    OptionError
        When there is no such setting, or the value is not allowed.
    """
    option = OPTIONS.get(name)
    if option is None:
        message = f"solver.{name}: no such setting; known are {', '.join(OPTIONS)}"
        raise OptionError(message)
    if not option.holds(value):
        message = f"solver.{name}: must be {option.rule}, got {value!r}"
        raise OptionError(message)
    stored = option.words.index(value) if option.words else value  # type: ignore[arg-type]
    return option.stored_as, float(stored)  # type: ignore[arg-type]
