"""Settings of the solver: their names, their ranges, and how they are stored in a state."""

from __future__ import annotations

from .errors import OptionError

CHOICES = {
    "formulation": (
        "conserving-al",
        "midpoint-al",
        "conserving-penalty",
        "midpoint-penalty",
        "penalty-velocity",
        "conserving-al-beta",
    ),
    "algorithm": ("nested", "simultaneous"),
    "multiplier_update": ("end", "paper"),
    "start": ("drawn", "equilibrium"),
}
"""Settings that choose one of several words; the first is the default."""

STORED_AS = {
    "formulation": "formulation",
    "algorithm": "simultaneous",
    "multiplier_update": "paper_update",
    "start": "equilibrium",
}
"""Scalar of the state's head that holds the index of the chosen word."""

SWITCHES = ("paired", "assemble")
"""Settings that are true or false."""

RANGES: dict[str, tuple[float, float, str, str]] = {
    "step_size": (0.0, 1e6, "s", "internal step of a run without tolerance"),
    "tolerance": (-5e-324, 0.1, "", "relative error of a run, or 0: steps of step_size"),
    "absolute_tolerance": (
        -5e-324,
        1e6,
        "m",
        "allowed absolute error, added to the relative one",
    ),
    "longest_step": (0.0, 1e6, "s", "longest internal step with a tolerance"),
    "newton_tolerance": (0.0, 1e-3, "", "relative error of a step's solution in the energy norm"),
    "penalty": (0.0, 1e14, "", "dimensionless penalty alpha h^2 sigma/4 of each constraint row"),
    "xi": (-5e-324, 1e6, "", "damping ratio of penalty-velocity"),
    "omega": (0.0, 1e9, "rad/s", "natural frequency of penalty-velocity"),
    "max_newton": (0.0, 1e3, "", "Newton iterations for one value of the multipliers"),
    "max_uzawa": (0.0, 1e3, "", "Uzawa updates in a step"),
}
"""Settings that are numbers: above the first, up to the second, unit, meaning.

``solver.scene.settings`` has the same ranges; a test compares them."""

LEAST = {"tolerance": 1e-14}
"""Least value other than 0, which turns the setting off: no run comes closer than round-off."""

TINY = 2.2250738585072014e-308
"""Least normal number, for what must be greater than zero."""

MOST_SAMPLING = 1.0
"""Largest `solver.sampling`: beyond it loads that read the mechanism drive it by their delay."""

NO_LIMITS = None, None
LIMITS: dict[str, tuple[float, float]] = {
    "order": (0.0, 8.0),
    **{
        name: (0.0 if low < 0.0 else 1.0 if name in ("max_newton", "max_uzawa") else TINY, high)
        for name, (low, high, _, _) in RANGES.items()
    },
}
"""Least and largest value of the settings that are numbers, as far as an interval tells it."""

MEANINGS = {
    "formulation": "how constraints act: one of " + ", ".join(CHOICES["formulation"]),
    "algorithm": "multipliers held fixed while Newton iterates (nested) or not (simultaneous)",
    "multiplier_update": "with the constraint at the end of the step (end) or its mean (paper)",
    "order": "order of accuracy: 2, 4, 6 or 8, with 1, 5, 9 or 15 pairs of half steps in a step; "
    "0: chosen by the tolerance, 2 without one",
    "start": "begin as drawn, or at rest in the static equilibrium next to it",
    "assemble": "close a mechanism that is drawn inexactly, and make its velocities consistent",
    "paired": "advance by pairs of half steps, which makes velocities smooth",
    **{name: text for name, (_, _, _, text) in RANGES.items()},
}
"""What each setting means."""

WHOLE = ("max_newton", "max_uzawa")

AUTOMATIC = 0.0
"""Order that the tolerance chooses; 2 without one."""

ORDERS = (2.0, 4.0, 6.0, 8.0)
"""Orders of accuracy: symmetric compositions of 1, 5, 9 and 15 pairs of half steps."""

SLOTS = {2: 4, 4: 10, 6: 18, 8: 30}
"""Half steps of an internal one whose changes a state keeps, as they predict those of the next: all
of one internal step, and at order 2, where that saves a third of the iterations, of two."""


def slots_for(order: int, *, chosen: bool) -> int:
    """Return how many half steps a state keeps at an `order`, or at any that a tolerance chooses.

    A tolerance that is set after the assembly works with fewer, and takes up to a third longer.
    """
    return SLOTS[order or (max(SLOTS) if chosen else min(SLOTS))]


DEFAULTS: dict[str, str | bool | float] = {
    "formulation": "conserving-al",
    "algorithm": "nested",
    "multiplier_update": "end",
    "paired": True,
    "step_size": 0.01,
    "newton_tolerance": 1e-12,
    "penalty": 1e8,
    "xi": 1.0,
    "omega": 10.0,
    "max_newton": 20.0,
    "max_uzawa": 20.0,
    "order": AUTOMATIC,
    "tolerance": 0.0,
    "absolute_tolerance": 0.0,
    "longest_step": 1e6,
    "assemble": False,
    "start": "drawn",
}


def encode(name: str, value: object) -> tuple[str, float]:
    """Return the scalar of the state's head that holds a setting, and its value there.

    Raises
    ------
    OptionError
        When there is no such setting, or the value is not allowed.
    """
    if name in CHOICES:
        if value not in CHOICES[name]:
            message = f"solver.{name}: must be one of {', '.join(CHOICES[name])}, got {value!r}"
            raise OptionError(message)
        return STORED_AS[name], float(CHOICES[name].index(value))  # type: ignore[arg-type]
    if name in SWITCHES:
        if value not in (True, False):
            message = f"solver.{name}: must be true or false, got {value!r}"
            raise OptionError(message)
        return name, float(bool(value))
    if name == "order":
        if value not in (AUTOMATIC, *ORDERS) or isinstance(value, bool):
            rule = "2, 4, 6 or 8, or 0 for the one that a tolerance chooses"
            message = f"solver.order: must be {rule}, got {value!r}"
            raise OptionError(message)
        return name, float(value)  # type: ignore[arg-type]
    if name not in RANGES:
        message = f"solver.{name}: no such setting; known are {', '.join(DEFAULTS)}"
        raise OptionError(message)
    return name, _in_range(name, value)


def _in_range(name: str, value: object) -> float:
    low, high, unit, _ = RANGES[name]
    number = float(value) if isinstance(value, int | float) else float("nan")
    too_small = 0.0 < number < LEAST.get(name, 0.0)
    if not low < number <= high or too_small or (name in WHOLE and number != int(number)):
        kind = "a whole number" if name in WHOLE else "a number"
        rule = f"{kind} {'>= 0' if low < 0 else '> 0'} and <= {high:g}"
        if name in LEAST:
            rule = f"0 or a number from {LEAST[name]:g}, some round-off, to {high:g}"
        message = f"solver.{name}: must be {rule} {unit}".rstrip() + f", got {value!r}"
        raise OptionError(message)
    return number
