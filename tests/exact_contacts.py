"""Motions of two problems with contacts, in closed form between events whose times are roots."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import expm
from scipy.optimize import brentq

from tests.problems import GRAVITY

BELT, GRIP = 0.2, 5.0
"""Speed of the belt [m/s] and force up to which the block sticks to it [N]."""


def swung(
    start: Sequence[float], t: float, stiffness: float, damping: float, rest: float
) -> NDArray[np.float64]:
    """Place and speed, a time after they were `start`, of 1 kg on a spring and a damper."""
    flow = expm(np.array([[0.0, 1.0], [-stiffness, -damping]]) * t)
    return flow @ np.subtract(start, [rest, 0.0]) + [rest, 0.0]


def next_root(value: Callable[[float], float], step: float = 1e-3) -> float:
    """Return the first time, after one `step` and within 10 s, at which a value passes zero."""
    times = step * np.arange(1, round(10.0 / step))
    low = next(t for t in times if value(t) * value(t + step) <= 0.0)
    return float(brentq(value, low, low + step, xtol=1e-16, rtol=1e-15))


def on_a_strut(state: Sequence[float], t: float) -> NDArray[np.float64]:
    """Height and speed of `ball_on_a_strut`, a time after they were `state`, without the floor."""
    return swung(state, t, 20.0, 0.3, 1.1 - GRAVITY / 20.0)


def hits_on_a_strut(n: int, restitution: float = 0.7) -> tuple[list[float], list[float]]:
    """Times of the first hits of `ball_on_a_strut`, and its state after the last one."""
    times, state = [0.0], [1.0, 0.0]
    for _ in range(n):
        t = next_root(lambda t, s=state: on_a_strut(s, t)[0] - 0.5)
        times.append(times[-1] + t)
        state = [0.5, -restitution * on_a_strut(state, t)[1]]
    return times[1:], state


def slips_on_a_belt(n: int, damping: float) -> tuple[list[float], float, float]:
    """Times at which the block of `belt` begins to slip, and time and place where the last ends."""
    breaks, times, now, x = (GRIP - BELT * damping) / 100.0, [], 0.0, 0.0
    for _ in range(n):
        now += (breaks - x) / BELT
        times.append(now)
        t = next_root(lambda t: swung([breaks, BELT], t, 100.0, damping, 0.03)[1] - BELT)
        now, x = now + t, float(swung([breaks, BELT], t, 100.0, damping, 0.03)[0])
    return times, now, x
