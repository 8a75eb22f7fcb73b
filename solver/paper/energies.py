"""The energies of one iteration, as eqs 10, 17, 18 and 28 write them."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from .problem import Array


class Trial(NamedTuple):
    """A step as far as it is solved."""

    d: Array  # q_n1 - q_n
    G: Array  # gradients Phi_q over the step
    force: Array  # Q - V_q
    C: Array  # Phi - u as the penalty measures it
    C_q: Array  # its derivative in q_n1
    phi: Array  # Phi_n1 - u_n1


class Iteration(NamedTuple):
    """One iteration on the multipliers (nested), or one of Newton's (simultaneous); energies in J.

    A conserving formulation has `kinetic` = `applied` + `eq17`, and without drivers any of the last
    three, which then vanish with Phi_n1 - Phi_n. With a midpoint formulation `eq17` alone is the
    work, and does not vanish.
    """

    newton: int  # solutions of Newton's linear system in this step so far
    lam: Array  # multipliers lambda that were held
    mu: Array  # total multipliers lambda + alpha Phi
    phi: float  # largest |Phi_n1|
    kinetic: float  # T_n1 - T_n
    applied: float  # work of forces and potentials
    eq17: float  # -(q_n1 - q_n)' Phi_q' (alpha Phi + lambda)
    eq18: float  # -(V_n1 - V_n) - (Phi_n1 - Phi_n)' lambda, with V = alpha Phi^2/2
    eq28: float  # -(Phi_n1 - Phi_n)' (alpha Phi + lambda)


def iteration(
    newton: int, lam: Array, mu: Array, alpha: Array, phi_n: Array, now: Trial, kinetic: float
) -> Iteration:
    """Return what an iteration held and where it came to."""
    change, size = now.phi - phi_n, float(np.max(np.abs(now.phi), initial=0.0))
    eq18 = -0.5 * float(alpha @ (now.phi**2 - phi_n**2)) - float(change @ lam)
    works = float(now.force @ now.d), -float(now.G @ now.d @ mu), eq18, -float(change @ mu)
    return Iteration(newton, lam, mu, size, kinetic, *works)
