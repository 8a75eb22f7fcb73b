"""Exact motions of the reference problems: closed forms, and equations in fewest coordinates."""

from __future__ import annotations

import math

import numpy as np
from scipy.integrate import solve_ivp
from scipy.special import ellipj, ellipkinc

from tests.support.mechanisms.problems import GRAVITY, Array


def pendulum_angle(t: Array, angle: float, rate: float = 0.0) -> Array:
    """Angle of the swinging unit pendulum: sin(theta/2) = k sn(omega t + u0, k)."""
    omega = math.sqrt(GRAVITY)
    modulus = math.sqrt(math.sin(angle / 2) ** 2 + (rate / (2 * omega)) ** 2)
    phase = math.asin(min(1.0, math.sin(angle / 2) / modulus))
    if rate < 0:
        phase = math.pi - phase
    sn, _, _, _ = ellipj(omega * np.asarray(t) + ellipkinc(phase, modulus**2), modulus**2)
    return 2 * np.arcsin(modulus * sn)


def pendulum_multiplier(t: Array, angle: float, rate: float = 0.0) -> Array:
    """Multiplier of |q|^2 - 1: from G q'' = -2 |v|^2, lambda = (|v|^2 - g y)/2 for unit mass."""
    y, y0 = -np.cos(pendulum_angle(t, angle, rate)), -math.cos(angle)
    return 0.5 * (rate**2 + 2 * GRAVITY * (y0 - y) - GRAVITY * y)


def double_pendulum_motion(times: Array, angle: float) -> tuple[Array, Array]:
    """Positions and velocities (len(times), 2, 2) of `double_pendulum`, in angles, by DOP853."""

    def rates(_: float, y: Array) -> Array:
        a, b, da, db = y
        c, s = math.cos(a - b), math.sin(a - b)
        right = [-s * db**2 - 2 * GRAVITY * math.sin(a), s * da**2 - GRAVITY * math.sin(b)]
        return np.array([da, db, *np.linalg.solve([[2, c], [c, 1]], right)])

    y0 = [angle, angle, 0.0, 0.0]
    solution = solve_ivp(
        rates, (0, times[-1]), y0, method="DOP853", t_eval=times, rtol=1e-13, atol=1e-13
    )
    a, b, da, db = solution.y
    upper = np.stack([np.sin(a), -np.cos(a)], axis=-1)
    lower = np.stack([np.sin(b), -np.cos(b)], axis=-1)
    v_upper = np.stack([np.cos(a) * da, np.sin(a) * da], axis=-1)
    v_lower = np.stack([np.cos(b) * db, np.sin(b) * db], axis=-1)
    positions = np.stack([upper, upper + lower], axis=1)
    return positions, np.stack([v_upper, v_upper + v_lower], axis=1)


def four_bar_angle(times: Array, n: int) -> Array:
    """Angle of the cranks from the vertical, clockwise: I phi'' = W g sin(phi), by DOP853."""
    inertia, weight = (n + 1) / 3 + n, (n + 1) / 2 + n
    solution = solve_ivp(
        lambda _, y: [y[1], weight * GRAVITY / inertia * math.sin(y[0])],
        (0, times[-1]), [0.0, 1.0], method="DOP853", t_eval=times, rtol=1e-13, atol=1e-13,
    )  # fmt: skip
    return solution.y[0]
