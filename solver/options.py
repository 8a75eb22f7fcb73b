"""The settings of the solver, each declared once.

The table [solver] of a scene, its schema, the variables of a model and what a state holds derive
from this one.
"""

from __future__ import annotations

from dataclasses import dataclass

TINY = 2.2250738585072014e-308
"""Least normal number, for what must be greater than zero."""

ORDERS = (2.0, 4.0, 6.0, 8.0)
"""Orders of accuracy: symmetric compositions of 1, 5, 9 and 15 pairs of half steps."""

AUTOMATIC = 0.0
"""Order that the tolerance chooses; 2 without one."""


@dataclass(frozen=True, kw_only=True)
class Option:
    """One setting; `default` tells whether it is a word, true or false, or a number.

    Attributes
    ----------
    name : str
    default : str, bool or float
    meaning : str
    unit : str
    words : tuple of str
        All that a word may be, the default first; a state holds the index.
    low, high : float
        Least and largest number.
    least : float
        Smallest number other than 0, which turns the setting off.
    allowed : tuple of float
        All that a number may be, where these are few.
    whole : bool
        Whether a number counts something.
    place : str
        Scalar of the state's head that holds it; empty: of the same name.
    """

    name: str
    default: str | bool | float
    meaning: str
    unit: str = ""
    words: tuple[str, ...] = ()
    low: float = TINY
    high: float = 1.0
    least: float = 0.0
    allowed: tuple[float, ...] = ()
    whole: bool = False
    place: str = ""

    @property
    def is_switch(self) -> bool:
        """Whether it is true or false."""
        return isinstance(self.default, bool)

    @property
    def is_number(self) -> bool:
        """Whether it is any number between limits."""
        return not (self.words or self.is_switch or self.allowed)

    @property
    def stored_as(self) -> str:
        """Scalar of the state's head that holds it."""
        return self.place or self.name

    @property
    def rule(self) -> str:
        """What a number must be."""
        if self.least:
            return f"0 or a number from {self.least:g}, some round-off, to {self.high:g}"
        kind = "a whole number" if self.whole else "a number"
        low = ">= 0" if self.low == 0.0 else "> 0"
        return f"{kind} {low} and <= {self.high:g} {self.unit}".rstrip()

    def holds(self, number: float) -> bool:
        """Whether a number is between the limits; NaN never is."""
        if not self.low <= number <= self.high or 0.0 < number < self.least:
            return False
        return not self.whole or number == int(number)


OPTIONS: dict[str, Option] = {
    option.name: option
    for option in (
        Option(
            name="formulation",
            default="conserving-al",
            words=(
                "conserving-al",
                "midpoint-al",
                "conserving-penalty",
                "midpoint-penalty",
                "penalty-velocity",
                "conserving-al-beta",
            ),
            meaning="how constraints act",
        ),
        Option(
            name="algorithm",
            default="nested",
            words=("nested", "simultaneous"),
            place="simultaneous",
            meaning="multipliers held fixed while Newton iterates (nested) or not (simultaneous)",
        ),
        Option(
            name="multiplier_update",
            default="end",
            words=("end", "paper"),
            place="paper_update",
            meaning="with the constraint at the end of the step (end) or its mean (paper)",
        ),
        Option(
            name="paired",
            default=True,
            meaning="advance by pairs of half steps, which makes velocities smooth",
        ),
        Option(
            name="step_size",
            default=0.01,
            high=1e6,
            unit="s",
            meaning="internal step of a run without tolerance, at most the communication step",
        ),
        Option(
            name="newton_tolerance",
            default=1e-12,
            high=1e-3,
            meaning="relative error of a step's solution in the energy norm",
        ),
        Option(
            name="penalty",
            default=1e8,
            high=1e14,
            meaning="dimensionless penalty alpha h^2 sigma/4 of each constraint row",
        ),
        Option(
            name="xi",
            default=1.0,
            low=0.0,
            high=1e6,
            meaning="damping ratio of penalty-velocity",
        ),
        Option(
            name="omega",
            default=10.0,
            high=1e9,
            unit="rad/s",
            meaning="natural frequency of penalty-velocity",
        ),
        Option(
            name="max_newton",
            default=20.0,
            low=1.0,
            high=1e3,
            whole=True,
            meaning="Newton iterations for one value of the multipliers",
        ),
        Option(
            name="max_uzawa",
            default=20.0,
            low=1.0,
            high=1e3,
            whole=True,
            meaning="Uzawa updates in a step",
        ),
        Option(
            name="order",
            default=AUTOMATIC,
            allowed=(AUTOMATIC, *ORDERS),
            high=max(ORDERS),
            low=0.0,
            meaning="order of accuracy: 2, 4, 6 or 8, with 1, 5, 9 or 15 pairs of half steps in a "
            "step; 0: chosen by the tolerance, 2 without one",
        ),
        Option(
            name="tolerance",
            default=0.0,
            low=0.0,
            high=0.1,
            least=1e-14,
            meaning="relative error of a run, or 0: steps of step_size",
        ),
        Option(
            name="absolute_tolerance",
            default=0.0,
            low=0.0,
            high=1e6,
            unit="m",
            meaning="allowed absolute error, added to the relative one",
        ),
        Option(
            name="longest_step",
            default=1e6,
            high=1e6,
            unit="s",
            meaning="longest internal step with a tolerance",
        ),
        Option(
            name="assemble",
            default=False,
            meaning="close a mechanism that is drawn inexactly, and make its velocities consistent",
        ),
        Option(
            name="start",
            default="drawn",
            words=("drawn", "equilibrium"),
            place="equilibrium",
            meaning="begin as drawn, or at rest in the static equilibrium next to it",
        ),
    )
}
"""All settings, by name."""

CHOICES = {name: option.words for name, option in OPTIONS.items() if option.words}
"""Words of the settings that choose one."""

DEFAULTS = {name: option.default for name, option in OPTIONS.items()}
