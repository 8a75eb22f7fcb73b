"""What is to be moved, and how: M q'' + Phi_q' (alpha Phi + lambda) + V_q = Q, Phi = 0 (eq 4)."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]
Vector = Callable[[Array], Array]


@dataclass(frozen=True)
class Functions:
    """Functions of the coordinates q (n,), such as all constraints Phi(q), with their gradients.

    `square`, quadratic or NaN, is that of the distance on which each depends alone (eqs 11, 26).
    """

    value: Vector  # (r,)
    gradient: Vector  # (r, n)
    square: Vector | None = None  # (r,)
    square_gradient: Vector | None = None  # (r, n)


NOTHING = Functions(lambda _: np.zeros(0), lambda q: np.zeros((0, len(q))))


@dataclass(frozen=True, kw_only=True)
class Problem:
    """A mechanism in coordinates with a constant mass matrix M (n, n), from q, v (n,) on.

    Q(q, v, t) (n,) are other applied forces than those of potentials, at the midpoint (eq 5).
    `begin_step` is told q_n before each step, so that angles may go on beyond half a turn.
    """

    M: Array
    q: Array
    v: Array
    phi: Functions = NOTHING  # constraints
    potentials: Functions = NOTHING  # energies V of springs and weights [J]
    Q: Callable[[Array, Array, float], Array] = lambda q, v, t: np.zeros_like(q)  # noqa: ARG005
    begin_step: Callable[[Array], None] = lambda q: None  # noqa: ARG005


@dataclass(frozen=True, kw_only=True)
class Method:
    """One of `FORMULATIONS`: its penalties alpha, one or (r,), and how lambda follows.

    An update adds alpha times the mean of Phi ("paper", eqs 16, 27) or Phi_n1/2 ("end"), after
    Newton's iteration ("nested") or in it ("simultaneous"). xi and omega [rad/s] are those of eq 3.
    """

    alpha: float | Array
    formulation: str = "conserving-al"
    algorithm: str = "nested"
    update: str = "paper"
    xi: float = 1.0
    omega: float = 10.0
