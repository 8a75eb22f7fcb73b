"""The settings of the solver, each declared once.

The table [solver] of a scene, its schema, the variables of a model and what a state holds derive
from this one.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import KW_ONLY, dataclass
from typing import Any

TINY = 2.2250738585072014e-308
"""Least normal number, for what must be greater than zero."""

ORDERS = (2.0, 4.0, 6.0, 8.0)
"""Orders of accuracy: a pair of half steps, compositions or weighted covers, or explicit steps."""

AUTOMATIC = 0.0
"""Order that the tolerance chooses; 2 without one."""

USUAL_STEP = 0.01
"""Longest internal step of equal steps where an order is given alone [s]."""

USUAL_TOLERANCE = 1e-4
"""Tolerance where neither step, order nor tolerance is given."""

LEAST_TOLERANCE = 1e-14
"""Some round-off: no run comes closer."""


@dataclass(frozen=True)
class Option:
    """One setting; `default` tells whether it is a word, true or false, or a number."""

    name: str
    default: str | bool | float
    meaning: str
    _: KW_ONLY
    unit: str = ""
    words: tuple[str, ...] = ()  # all that a word may be, the default first; a state has the index
    low: float = TINY  # least number
    below: str = ""  # what to do for a lower one
    high: float = 1.0  # largest number
    least: float = 0.0  # smallest number other than 0, which turns the setting off
    allowed: tuple[float, ...] = ()  # all that a number may be, where these are few
    whole: bool = False  # whether a number counts something
    place: str = ""  # scalar of the state's head that holds it; empty: of the same name
    of_contacts: bool = False  # whether only scenes with contacts or friction have it
    of_tolerance: bool = False  # whether only steps that a tolerance chooses follow it

    @property
    def is_switch(self) -> bool:
        """Whether it is true or false."""
        return isinstance(self.default, bool)

    @property
    def stored_as(self) -> str:
        """Scalar of the state's head that holds it."""
        return self.place or self.name

    @property
    def limits(self) -> str:
        """Between which limits a number must lie, without its unit."""
        low = "> 0" if self.low == TINY else f">= {self.low:g}"
        return f"{low} and <= {self.high:g}"

    @property
    def rule(self) -> str:
        """What a value must be."""
        if self.words:
            return f"one of {', '.join(self.words)}"
        if self.is_switch:
            return "true or false"
        if self.allowed:
            *few, last = (f"{order:g}" for order in ORDERS)
            return f"{', '.join(few)} or {last}, or 0 for the one that a tolerance chooses"
        if self.least:
            return f"0 or a number from {self.least:g}, some round-off, to {self.high:g}"
        kind = "a whole number" if self.whole else "a number"
        below = f" ({self.below})" if self.below else ""
        return f"{kind} {self.limits} {self.unit}".rstrip() + below

    def holds(self, value: object) -> bool:
        """Whether a value is allowed; NaN never is, nor true for a number."""
        if self.words or self.is_switch:
            return value in (self.words or (True, False))
        if isinstance(value, bool) or not isinstance(value, int | float):
            return False
        if self.allowed:
            return value in self.allowed
        if not self.low <= value <= self.high or 0.0 < value < self.least:
            return False
        return not self.whole or value == int(value)


# fmt: off
_TABLE = (
    Option("step_size", 0.0,
           "longest internal step of a run in equal steps, which a communication step may shorten; "
           f"0: not given, {USUAL_STEP:g} s where an order is",
           low=0.0, high=1e6, unit="s"),
    Option("newton_tolerance", 1e-12, "relative error of a step's solution in the energy norm",
           high=1e-3),
    Option("penalty", 1e8, "dimensionless penalty alpha h^2 sigma/4 of each constraint row",
           low=1e6, high=1e14, below="solver.paper steps with lower ones: "
           "holonom.simulate(scene, formulation=..., penalty=...)"),
    Option("max_newton", 20.0, "Newton iterations for one value of the multipliers",
           low=1.0, high=1e3, whole=True),
    Option("max_uzawa", 20.0, "Uzawa updates in a step", low=1.0, high=1e3, whole=True),
    Option("order", AUTOMATIC,
           "order of accuracy: 2, 4, 6 or 8; 0: chosen by the tolerance, 2 in equal steps",
           allowed=(AUTOMATIC, *ORDERS), low=0.0, high=max(ORDERS)),
    Option("tolerance", 0.0,
           "relative error of a run, which chooses the steps; 0: not given, equal steps where a "
           f"step_size or an order is, else {USUAL_TOLERANCE:g}",
           low=0.0, high=0.1, least=LEAST_TOLERANCE),
    Option("method", "conserving",
           "steps of a run with a tolerance: conserving half steps alone, or explicit ones as well "
           "wherever they are possible (fastest)",
           words=("conserving", "fastest"), of_tolerance=True),
    Option("absolute_tolerance", 0.0, "allowed absolute error, added to the relative one",
           low=0.0, high=1e6, unit="m", of_tolerance=True),
    Option("longest_step", 1e6, "longest internal step with a tolerance", high=1e6, unit="s",
           of_tolerance=True),
    Option("assemble", False,
           "close a mechanism that is drawn inexactly, and make its velocities consistent"),
    Option("start", "drawn", "begin as drawn, or at rest in the static equilibrium next to it",
           words=("drawn", "equilibrium"), place="equilibrium"),
    Option("rest_speed", 1e-4, "normal speed below which contacts hit without rebound",
           low=0.0, high=1e3, unit="m/s", of_contacts=True),
    Option("rest_time", 1e-6, "flight after an impact below which contacts stay closed instead",
           low=0.0, high=1.0, unit="s", of_contacts=True),
    Option("max_events", 50.0,
           "impacts and other changes of contacts in a communication step, beyond which it is "
           "stepped",
           low=1.0, high=1e6, whole=True, of_contacts=True),
    Option("contact_mode", "located",
           "impacts at their times (located), or one for each half step (stepped), in equal steps",
           words=("located", "stepped"), of_contacts=True),
    Option("impact_law", "simultaneous",
           "contacts that hit together: all at once, or the fastest first (sequential)",
           words=("simultaneous", "sequential"), of_contacts=True),
)
# fmt: on

OPTIONS: dict[str, Option] = {option.name: option for option in _TABLE}
"""All settings, by name."""

_PAPER = (
    "the core steps by conserving-al with nested updates; holonom.simulate(scene, formulation=..., "
    "algorithm=..., multiplier_update=...) runs the others by solver.paper"
)
_VELOCITY = (
    "it belongs to penalty-velocity, and "
    'holonom.simulate(scene, formulation="penalty-velocity", xi=..., omega=...) runs that by '
    "solver.paper"
)
REMOVED = {
    **dict.fromkeys(("formulation", "algorithm", "multiplier_update"), _PAPER),
    "paired": "half steps always come in pairs, which makes velocities smooth",
    **dict.fromkeys(("xi", "omega"), _VELOCITY),
    "energy": "half steps are solved to newton_tolerance; where it was to save time under a "
    'tolerance, method = "fastest" does',
}
"""Settings of before, by name, and where what they did has gone."""


def removed(name: object) -> str:
    """Sentence on a variable of before, such as ``solver.energy``; empty for any other name."""
    table, _, setting = str(name).partition(".")
    there = REMOVED.get(setting) if table == "solver" else None
    return f"the setting '{setting}' left in version 2.0: {there}" if there else ""


DEFAULTS = {name: option.default for name, option in OPTIONS.items()}


CHOSEN = {
    # Equal steps where contacts are stepped, or a step or order is given without a tolerance.
    "tolerance": "(contact_mode == 0) * "
    "(tolerance + usual_tolerance * (step_size + order + tolerance == 0))",
    "step": "step_size + usual_step * (step_size == 0)",
}
"""What settings choose: tolerance, or 0 for equal steps, and the longest of these [s].

Formulas of settings as a state has them, in Python and C.
"""


def _chosen(what: str, settings: Mapping[str, Any]) -> float:
    known = {"usual_tolerance": USUAL_TOLERANCE, "usual_step": USUAL_STEP}
    for name, option in OPTIONS.items():
        value = settings.get(name, option.default)
        known[name] = option.words.index(value) if option.words else value
    return float(eval(CHOSEN[what], {}, known))


def tolerance_of(settings: Mapping[str, Any]) -> float:
    """Tolerance that settings choose, or 0: equal steps of `step_of` them."""
    return _chosen("tolerance", settings)


def step_of(settings: Mapping[str, Any]) -> float:
    """Length of equal steps that settings choose, at most the communication step [s]."""
    return _chosen("step", settings)
