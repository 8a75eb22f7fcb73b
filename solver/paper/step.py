"""One step of eqs 3, 5, 7, 9, 15 or 26, with Uzawa's update of the multipliers (eqs 16, 27).

    M (v_n1 - v_n) + h [ Phi_q' mu + V_q - Q ] = 0,     (v_n + v_n1)/2 = (q_n1 - q_n)/h

The unknowns are w = q_n1 - q_n - h v_n, so that v_n1 = v_n + 2 w/h, and the paper's alpha Phi +
lambda as mu with the row Phi - (mu - lambda)/alpha = 0: no digits are lost to a large penalty.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from solver.runtime import StepError

from .energies import Iteration, Trial, iteration
from .gradients import GRADIENTS, bend, hessian, midpoint, scalar
from .problem import Array, Method, Problem


class Moment(NamedTuple):
    """Where a motion is, and the iterations of the step that led there."""

    t: float
    q: Array
    v: Array
    lam: Array
    iterations: tuple[Iteration, ...] = ()


def measured(problem: Problem, method: Method, at: Moment, h: float, d: Array) -> tuple:
    """What the penalty multiplies: mean of Phi (eqs 9, 15), Phi at the midpoint (5, 7), or eq 3.

    The second is its derivative in d; that of eq 3 leaves third derivatives of Phi out.
    """
    phi, q, twice = problem.phi, at.q + 0.5 * d, 2.0 * method.xi * method.omega
    u_n, u_mid, u_n1 = (problem.u(at.t + part * h) for part in (0.0, 0.5, 1.0))
    if method.formulation.startswith("conserving"):
        mean = 0.5 * (phi.value(at.q) - u_n + phi.value(at.q + d) - u_n1)
        return mean, 0.5 * phi.gradient(at.q + d)
    G, C = phi.gradient(q), phi.value(q)
    if method.formulation != "penalty-velocity":
        return C - 0.5 * (u_n + u_n1), 0.5 * G  # so linear rows have u at the ends, too
    H = hessian(phi, q)
    second = 2.0 * G @ (d - h * at.v) + H @ d @ d - 4.0 * (u_n1 - 2.0 * u_mid + u_n)
    C = second / h**2 + twice * (G @ d - (u_n1 - u_n)) / h + method.omega**2 * (C - u_mid)
    bend = H @ ((3.0 * d - h * at.v) / h**2 + 0.5 * twice * d / h)
    return C, (2.0 / h**2 + twice / h + 0.5 * method.omega**2) * G + bend


def applied(problem: Problem, at: Moment, h: float, d: Array) -> Array:
    """Forces Q at the midpoint."""
    Q = problem.Q
    return np.zeros_like(d) if Q is None else Q(at.q + 0.5 * d, d / h, at.t + 0.5 * h)


def trial(problem: Problem, method: Method, at: Moment, h: float, w: Array) -> Trial:
    """Evaluate the step by w."""
    d, gradient = h * at.v + w, GRADIENTS[method.formulation]
    end, of_V = at.q + d, midpoint if gradient is midpoint else scalar
    force = applied(problem, at, h, d) - of_V(problem.potentials, at.q, end).sum(axis=0)
    C, C_q = measured(problem, method, at, h, d)
    phi = problem.phi.value(end) - problem.u(at.t + h)
    return Trial(d, gradient(problem.phi, at.q, end), force, C, C_q, phi)


def tangent(problem: Problem, method: Method, at: Moment, h: float, now: Trial, mu: Array) -> Array:
    """Derivative of momentum balance and rows in (w, mu), exact where Phi are quadratic."""
    n, end, gradient = len(at.q), at.q + now.d, GRADIENTS[method.formulation]
    K, of_V = np.zeros((n + len(mu), n + len(mu))), midpoint if gradient is midpoint else scalar
    K[:n, :n] = bend(gradient, problem.phi, at.q, end, mu)
    K[:n, :n] += bend(
        of_V, problem.potentials, at.q, end, np.ones(len(problem.potentials.value(end)))
    )
    for k, e in enumerate(1e-5 * problem.extent(at.q) * np.eye(n) if problem.Q else ()):
        a, b = (applied(problem, at, h, now.d + x) for x in (-e, e))
        K[:n, k] -= (b - a) / (2.0 * e[k])
    K[:n, :n] = h * K[:n, :n] + 2.0 / h * problem.M
    K[:n, n:], K[n:, :n] = h * now.G.T, now.C_q
    K[n:, n:] = -np.diag(1.0 / (method.alpha + 0.0 * mu))
    return K


@np.errstate(over="ignore", invalid="ignore", divide="ignore")
def step(problem: Problem, method: Method, at: Moment, h: float) -> Moment:
    """Take a step of length h; `StepError` where the iterations do not converge."""
    problem.begin_step(at.q)
    nested, updates = method.algorithm == "nested", "-al" in method.formulation
    conserves = method.formulation.startswith("conserving")
    ends = method.multiplier_update == "end" and conserves
    lam, mu, w, extent = at.lam, at.lam, np.zeros_like(at.q), problem.extent(at.q)
    alpha, found, K = method.alpha + 0.0 * lam, list[Iteration](), None
    phi_n, mass = problem.phi.value(at.q) - problem.u(at.t), np.sqrt(np.diag(problem.M))
    size = extent * np.abs(problem.phi.gradient(at.q)).sum(axis=1)
    last = defect = before = np.inf
    now, updated, remedy = trial(problem, method, at, h, w), 0, "smaller step_size"
    for newton in range(1, 2001):  # most are needed where updates contract slowly
        if K is None:
            K = np.linalg.inv(tangent(problem, method, at, h, now, mu))
        R = 2.0 / h * problem.M @ w + h * (now.G.T @ mu - now.force)
        x = -K @ np.concatenate([R, now.C - (mu - lam) / alpha])
        w, mu = w + x[: len(w)], mu + x[len(w) :]
        if not np.all(np.isfinite(w)) or (nested and newton > updated + 200):
            break
        now = trial(problem, method, at, h, w)
        increment, moved = (np.linalg.norm(mass * y) for y in (x[: len(w)], now.d))
        limit = 1e-12 * moved + 1e-15 * extent * np.linalg.norm(mass)
        if (
            conserves and newton > updated + 20
        ):  # quotients of small differences have more round-off
            limit *= 100.0
        solved = increment <= 1e-4 * limit or 0.5 * last < increment <= limit
        K = None if limit < increment and increment > 0.1 * last else K
        last = np.inf if solved and nested else increment
        if nested and not solved:
            continue
        kinetic = float(now.d / h @ problem.M @ (2.0 * w / h))
        found.append(iteration(newton, lam, mu, alpha, phi_n, now, kinetic))
        held, before = now.phi if ends else now.C, defect
        defect = np.max(np.abs(held) / size, initial=0.0)
        met = not updates or defect <= 1e-16 or 0.9 * before < defect <= 1e-12
        if solved and met:
            v = at.v + 2.0 * w / h
            return Moment(at.t + h, at.q + now.d, v, mu if updates else lam, tuple(found))
        if updates:  # eqs 16, 27
            lam, updated = lam + alpha * (0.5 * held if ends else held), newton
    else:
        if updates and 0.5 * before < defect < before:
            remedy = "larger penalty"  # each update takes its part of what the rows miss
    text = f"step from t = {at.t:g} s with h = {h:g} s did not converge (rows off by {defect:.1e})"
    raise StepError(text + f"; a {remedy} usually helps")


def motion(problem: Problem, method: Method, h: float, t: float = 0.0) -> Iterator[Moment]:
    """Yield the start at time t [s], and then the end of one step of length h after the other."""
    at = Moment(t, problem.q, problem.v, np.zeros(len(problem.phi.value(problem.q))))
    while True:
        yield at
        at = step(problem, method, at, h)
