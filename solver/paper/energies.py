"""Energies of one iteration, as eqs 10, 17, 18 and 28 write them."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from .problem import Array


class Trial(NamedTuple):
    """A step as far as it is solved: increment, gradients Phi_q, applied forces, measure of Phi."""

    d: Array
    G: Array
    force: Array
    C: Array
    phi: Array


class Iteration(NamedTuple):
    """An iteration on the multipliers (nested), or one of Newton's (simultaneous).

    A conserving formulation has T_n1 - T_n = `applied` + `eq17` = `applied` + `eq18` =
    `applied` + `eq28` once the momentum balance is solved, for any multipliers; all three vanish with
    Phi_n1 - Phi_n. With a midpoint formulation `eq17` alone is the work, and it does not vanish.
    """

    newton: int
    """Solutions of Newton's linear system in this step so far."""
    lam: Array
    """Multipliers lambda (r,) that were held."""
    mu: Array
    """Total multipliers lambda + alpha Phi, the latter at the formulation's place (r,)."""
    phi: float
    """Largest |Phi_n1|."""
    kinetic: float
    """Change of the kinetic energy, T_n1 - T_n [J]."""
    applied: float
    """Work of the applied forces, those of the potentials among them [J]."""
    eq17: float
    """Work of the constraints, -(q_n1 - q_n)' Phi_q' (alpha Phi + lambda) [J]."""
    eq18: float
    """Of it with eq 8: -(V_n1 - V_n) - (Phi_n1 - Phi_n)' lambda, V = alpha Phi^2/2 [J]."""
    eq28: float
    """And -(Phi_n1 - Phi_n)' (alpha Phi + lambda) [J]."""


def iteration(
    newton: int, lam: Array, mu: Array, alpha: Array, phi_n: Array, now: Trial, kinetic: float
) -> Iteration:
    """Return what an iteration did, from what it held and where it came to."""
    change, size = now.phi - phi_n, float(np.max(np.abs(now.phi), initial=0.0))
    eq17 = -float((now.G @ now.d) @ mu)
    eq18 = -0.5 * float(alpha @ (now.phi**2 - phi_n**2)) - float(change @ lam)
    eq28, applied = -float(change @ mu), float(now.force @ now.d)
    return Iteration(newton, lam, mu, size, kinetic, applied, eq17, eq18, eq28)
