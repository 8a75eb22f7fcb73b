"""One step of eqs 3, 5, 7, 9, 15 or 26 with Uzawa's update of the multipliers (eqs 16, 27).

    R(w, mu) = M (v_n1 - v_n) + h [ Phi_q' mu + V_q - Q ] = 0,     (v_n + v_n1)/2 = (q_n1 - q_n)/h

The paper's alpha Phi + lambda is the total multiplier mu, a second unknown with the row
Phi - (mu - lambda)/alpha = 0: the same equations, which lose no digits to a large penalty. The
first unknown is w = d - h v_n, with d = q_n1 - q_n, so that v_n1 = v_n + 2 w/h.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from solver.runtime import StepError

from .energies import Iteration, Trial, iteration
from .gradients import GRADIENTS, midpoint
from .problem import Array, Method, Problem

MOST = 500
"""Newton's iterations in a step."""


class Moment(NamedTuple):
    """Where a motion is, and the iterations of the step that led there."""

    t: float
    q: Array
    v: Array
    lam: Array
    iterations: tuple[Iteration, ...] = ()


def measured(problem: Problem, method: Method, at: Moment, h: float, d: Array) -> Array:
    """What the penalty multiplies: the mean of Phi (eqs 9, 15), Phi at the midpoint (5, 7), or eq 3."""
    phi, end = problem.phi, at.q + d
    if method.conserves:
        return 0.5 * (phi.value(at.q) + phi.value(end))
    middle = phi.value(at.q + 0.5 * d)
    if method.formulation != "penalty-velocity":
        return middle
    rates = phi.gradient(at.q) @ at.v, phi.gradient(end) @ (2.0 * d / h - at.v)
    rate = midpoint(phi, at.q, end) @ d / h
    return (rates[1] - rates[0]) / h + 2.0 * method.xi * method.omega * rate + method.omega**2 * middle


def trial(problem: Problem, method: Method, at: Moment, h: float, w: Array) -> Trial:
    """Evaluate the step by w."""
    d, gradient = h * at.v + w, GRADIENTS[method.formulation]
    end = at.q + d
    Q = problem.Q(at.q + 0.5 * d, d / h, at.t + 0.5 * h)
    force = Q - gradient(problem.potentials, at.q, end).sum(axis=0)
    C = measured(problem, method, at, h, d)
    return Trial(d, gradient(problem.phi, at.q, end), force, C, problem.phi.value(end))


def tangent(
    problem: Problem, method: Method, at: Moment, h: float, now: Trial, mu: Array
) -> Array:
    """Derivative of momentum balance and rows in (w, mu), with gradients at the midpoint.

    Central differences, and beta held fixed: it decides how fast Newton's iteration converges, and
    not where it ends.
    """

    def of(d: Array) -> Array:
        end, middle = at.q + d, at.q + 0.5 * d
        force = problem.Q(middle, d / h, at.t + 0.5 * h)
        force = force - midpoint(problem.potentials, at.q, end).sum(axis=0)
        R = h * (midpoint(problem.phi, at.q, end).T @ mu - force)
        return np.concatenate([R, measured(problem, method, at, h, d)])

    n, d, delta = len(now.d), now.d, 1e-5 * (np.ptp(at.q) or 1.0)
    K = np.zeros((n + len(mu), n + len(mu)))
    for k, e in enumerate(delta * np.eye(n)):
        K[:, k] = (of(d + e) - of(d - e)) / (2.0 * delta)
    K[:n, :n] += 2.0 / h * problem.M
    K[:n, n:] = h * now.G.T
    K[n:, n:] = -np.diag(1.0 / (method.alpha + np.zeros(len(mu))))
    return K


@np.errstate(over="ignore", invalid="ignore")
def step(problem: Problem, method: Method, at: Moment, h: float) -> Moment:
    """Take a step of length h: two nested loops, or one in which the multipliers follow.

    Raises
    ------
    StepError
        Where Newton's iteration or that of the multipliers does not converge.
    """
    problem.begin_step(at.q)
    lam, mu, w = at.lam, at.lam, np.zeros_like(at.q)
    alpha, phi_n, found = method.alpha + 0.0 * lam, problem.phi.value(at.q), list[Iteration]()
    extent = np.ptp(at.q) or 1.0
    size = extent * np.abs(problem.phi.gradient(at.q)).sum(axis=1)
    mass, last, defect, newton = np.sqrt(np.diag(problem.M)), np.inf, np.inf, 0
    now, nested = trial(problem, method, at, h, w), method.algorithm == "nested"
    while newton < MOST and np.all(np.isfinite(w)):
        R = 2.0 / h * problem.M @ w + h * (now.G.T @ mu - now.force)
        K = tangent(problem, method, at, h, now, mu)
        x = np.linalg.solve(K, -np.concatenate([R, now.C - (mu - lam) / alpha]))
        w, mu, newton = w + x[: len(w)], mu + x[len(w) :], newton + 1
        now = trial(problem, method, at, h, w)
        increment, moved = (np.linalg.norm(mass * y) for y in (x[: len(w)], now.d))
        limit = 1e-10 * moved + 1e-13 * extent * np.linalg.norm(mass)
        solved = increment <= 1e-6 * limit or 0.5 * last < increment <= limit
        last = np.inf if solved and nested else increment
        if nested and not solved:
            continue
        v = at.v + 2.0 * w / h
        kinetic = float((now.d / h) @ problem.M @ (2.0 * w / h))
        found.append(iteration(newton, lam, mu, alpha, phi_n, now, kinetic))
        held = now.phi if method.ends else now.C
        before, defect = defect, np.max(np.abs(held) / size, initial=0.0)
        met = defect <= 1e-16 or 0.9 * before < defect <= 1e-12
        if solved and (met or not method.updates):
            return Moment(at.t + h, at.q + now.d, v, mu if method.updates else lam, tuple(found))
        if method.updates:  # eqs 16 and 27; the mean is half of Phi_n1 where Phi_n = 0
            lam = lam + alpha * (0.5 * held if method.ends else held)
    message = (
        f"step from t = {at.t:g} s with h = {h:g} s: {MOST} Newton iterations do not solve it; "
        f"a smaller step_size usually helps (rows missed by {defect:.1e})"
    )
    raise StepError(message)


def motion(problem: Problem, method: Method, h: float, t: float = 0.0) -> Iterator[Moment]:
    """Yield the start at time t, and then the end of one step of length h after the other."""
    rows = len(problem.phi.value(problem.q))
    at = Moment(t, problem.q, problem.v, np.zeros(rows))
    while True:
        yield at
        at = step(problem, method, at, h)
