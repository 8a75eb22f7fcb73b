"""What is to be moved, and how: M q'' + Phi_q' (alpha Phi + lambda) + V_q = Q, Phi = 0 (eq 4)."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from solver.runtime import OptionError

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]
Vector = Callable[[Array], Array]


@dataclass(frozen=True)
class Functions:
    """Functions of the coordinates q (n,), such as all constraints Phi(q), with their gradients.

    `square`, quadratic or NaN, is that of the distance on which each depends alone (eqs 11, 26).
    Where `hessian` is left out, Newton's tangent takes differences of the gradients.
    """

    value: Vector  # (r,)
    gradient: Vector  # (r, n)
    hessian: Vector | None = None  # (r, n, n)
    square: Functions | None = None


NOTHING = Functions(lambda _: np.zeros(0), lambda q: np.zeros((0, len(q))))


@dataclass(frozen=True, kw_only=True)
class Problem:
    """A mechanism in coordinates with a constant mass matrix M (n, n), from q, v (n,) on.

    Coordinates without a mass are held by rows, such as those that drivers move.
    Q(q, v, t) (n,) are other applied forces than those of potentials, at the midpoint (eq 5).
    Drivers ask for Phi(q) = u(t), with u (r,). `begin_step` is told q_n before each step, so that
    angles may go on beyond half a turn.
    """

    M: Array
    q: Array
    v: Array
    phi: Functions = NOTHING  # constraints
    potentials: Functions = NOTHING  # energies V of springs and weights [J]
    Q: Callable[[Array, Array, float], Array] | None = None
    u: Callable[[float], Array | float] = lambda t: 0.0  # noqa: ARG005
    begin_step: Callable[[Array], None] = lambda q: None  # noqa: ARG005

    def extent(self, q: Array) -> float:
        """Range of the coordinates that have a mass; only rows may hold others."""
        has_mass = np.diag(self.M) > 0.0
        return float(np.ptp(q[has_mass] if np.any(has_mass) else q)) or 1.0


FORMULATIONS = (
    "conserving-al", "conserving-al-beta", "midpoint-al", "conserving-penalty", "midpoint-penalty",
    "penalty-velocity",
)  # fmt: skip
WORDS = {
    "formulation": FORMULATIONS,
    "algorithm": ("nested", "simultaneous"),
    "multiplier_update": ("paper", "end"),
}


@dataclass(frozen=True, kw_only=True)
class Method:
    """One of `FORMULATIONS`: its penalties alpha, one or (r,), and how lambda follows.

    An update adds alpha times the mean of Phi ("paper", eqs 16, 27) or Phi_n1/2 ("end"), after
    Newton's iteration ("nested") or in it ("simultaneous"). xi and omega [rad/s] are those of eq 3.
    """

    alpha: float | Array
    formulation: str = "conserving-al"
    algorithm: str = "nested"
    multiplier_update: str = "paper"
    xi: float = 1.0
    omega: float = 10.0

    def __post_init__(self) -> None:
        """Raise `OptionError` for a word that is none, and a number that is out of its range."""
        for name, words in WORDS.items():
            if (given := getattr(self, name)) not in words:
                message = f"{name}: must be one of {', '.join(words)}, got {given!r}"
                raise OptionError(message)
        for name, given, rule in (
            ("alpha", self.alpha, "> 0"), ("omega", self.omega, "> 0"), ("xi", self.xi, ">= 0"),
        ):  # fmt: skip
            check(name, given, rule)


def check(name: str, given: object, rule: str) -> None:
    """Raise `OptionError` for what is no finite number > 0 or >= 0, nor an array of such."""
    numbers = np.asarray(given)
    fits = numbers.dtype.kind in "fiu" and np.all(np.isfinite(numbers) & (numbers >= 0.0))
    if not fits or (rule == "> 0" and not np.all(numbers > 0.0)):
        message = f"{name}: must be a finite number {rule}, got {given!r}"
        raise OptionError(message)
