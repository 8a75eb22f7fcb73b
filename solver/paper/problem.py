"""What is to be moved, and how: M q'' + Phi_q' (alpha Phi + lambda) = Q - V_q, Phi(q) = 0 (eq 4)."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from solver.options import FORMULATIONS

Array = NDArray[np.float64]
Vector = Callable[[Array], Array]


@dataclass(frozen=True)
class Functions:
    """Some functions of the coordinates, such as all constraints Phi(q), with their gradients.

    Each may be a function of one scalar whose square is quadratic in q, such as a distance. Where
    `square` tells it, eqs 11 and 26 serve in the place of eq 8.
    """

    value: Vector
    """From q (n,) to the values (r,)."""
    gradient: Vector
    """From q (n,) to the gradients (r, n)."""
    square: Vector | None = None
    """From q (n,) to the square of each function's scalar (r,), quadratic in q."""
    square_gradient: Vector | None = None
    """From q (n,) to the gradients (r, n) of the squares."""


NOTHING = Functions(lambda _: np.zeros(0), lambda q: np.zeros((0, len(q))))


@dataclass(frozen=True, kw_only=True)
class Problem:
    """A mechanism in coordinates with a constant mass matrix: points, or natural coordinates."""

    M: Array
    """ndarray, shape (n, n)."""
    q: Array
    """Coordinates (n,) at the start."""
    v: Array
    """Velocities (n,) at the start."""
    phi: Functions = NOTHING
    """Constraints, zero where they hold."""
    potentials: Functions = NOTHING
    """Energies V [J] of springs and weights."""
    Q: Callable[[Array, Array, float], Array] = lambda q, v, t: np.zeros_like(q)  # noqa: ARG005
    """Other applied forces (n,) of q, v and t, taken at the midpoint (eq 5)."""
    begin_step: Callable[[Array], None] = lambda q: None  # noqa: ARG005
    """Is told q_n before each step, so that angles go on from there beyond half a turn."""


@dataclass(frozen=True, kw_only=True)
class Method:
    """A formulation with its penalties."""

    alpha: float | Array
    """Penalty of all constraints, or of each (r,)."""
    formulation: str = FORMULATIONS[0]
    algorithm: str = "nested"
    """Newton's iteration with fixed multipliers ("nested"), or multipliers that follow each of its
    iterations ("simultaneous")."""
    update: str = "paper"
    """lambda + alpha (Phi_n + Phi_n1)/2 ("paper", eqs 16 and 27) or lambda + alpha Phi_n1/2 ("end")
    in the conserving formulations."""
    xi: float = 1.0
    """Damping ratio of eq 3."""
    omega: float = 10.0
    """Natural frequency of eq 3 [rad/s]."""

    @property
    def conserves(self) -> bool:
        """Whether it takes the constraint's mean and a conserving gradient (eqs 9, 15, 26)."""
        return self.formulation.startswith("conserving")

    @property
    def updates(self) -> bool:
        """Whether it has multipliers besides the penalty."""
        return "-al" in self.formulation

    @property
    def ends(self) -> bool:
        """Whether it updates until Phi_n1 = 0, and not until the measured constraint is 0."""
        return self.conserves and self.update == "end"


def penalties(problem: Problem, chi: float, h: float) -> Array:
    """Penalties (r,) at which an update divides what is missed by 1 + chi (theory 3.3)."""
    G = problem.phi.gradient(problem.q)
    return 4.0 * chi / (h**2 * np.sum(G * np.linalg.solve(problem.M, G.T).T, axis=1))
