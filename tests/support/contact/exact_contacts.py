"""Motions of two problems with contacts, in closed form between events whose times are roots."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import solve_ivp
from scipy.linalg import expm
from scipy.optimize import brentq

from tests.support.mechanisms.problems import GRAVITY

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


def impact_by_routh(
    W: NDArray[np.float64], before: NDArray[np.float64], coefficient: float, restitution: float
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return impulses and rates (normal, slip) after an impact of one contact in the plane.

    Routh's straight path over the normal impulse, with Stronge's restitution: until the work of
    expansion is e^2 of that of compression. Its normal rate must grow all along.
    """
    p, gamma = np.zeros(2), np.array(before, float)
    taken, compressed = 0.0, None
    for _ in range(6):
        if gamma[1]:
            push = np.array([1.0, -coefficient * np.sign(gamma[1])])
        else:
            held = -W[1, 0] / W[1, 1]
            push = np.array([1.0, np.clip(held, -coefficient, coefficient)])
        rate = W @ push
        if abs(rate[1]) < 1e-14 * W[1, 1]:
            rate[1] = 0.0
        ends = []
        if gamma[1] * rate[1] < 0.0:
            ends.append((-gamma[1] / rate[1], "stops"))
        if compressed is None:
            ends.append((-gamma[0] / rate[0], "expands"))
        else:  # gamma way + rate way^2/2 = what is left
            left = restitution**2 * compressed - taken
            root = np.sqrt(gamma[0] ** 2 + 2.0 * rate[0] * left)
            ends.append((2.0 * left / (gamma[0] + root) if root else 0.0, "ends"))
        way, why = min(ends)
        taken += way * (gamma[0] + 0.5 * way * rate[0])
        p, gamma = p + way * push, gamma + way * rate
        if why == "stops":
            gamma[1] = 0.0
        elif why == "expands":
            compressed, taken, gamma[0] = -taken, 0.0, 0.0
        else:
            return p, gamma
    msg = "the path has no end"
    raise AssertionError(msg)


def rod_that_bounces() -> tuple[float, float]:
    """When the far end of `rod_that_falls(0.5, 1.0)` lands [s], and what its impact takes [J]."""
    x, y = 0.5 * np.cos(0.6), 0.5 * np.sin(0.6)
    fall = np.sqrt(2.0 * (0.8 - y) / GRAVITY)
    G = np.array([[0.0, 1.0, -x], [1.0, 0.0, y]])  # of the near end: up, along
    M = np.array([1.0, 1.0, 1.0 / 12.0])
    v = np.array([1.0, -GRAVITY * fall, 0.0])
    p, after = impact_by_routh((G / M) @ G.T, G @ v, 0.2, 0.5)
    after_v = v + G.T @ p / M

    def height(t: float) -> float:
        angle = 0.6 + after_v[2] * t
        return y + after_v[1] * t - 0.5 * GRAVITY * t * t + 0.5 * np.sin(angle)

    return fall + next_root(height), float(-p @ (G @ v + after) / 2.0)


def loss_of_a_pendulum_that_rubs(t: float, rebound: float) -> float:
    """Energy [J] that the pendulum of `scenes/pendulum_with_stop.toml` loses until a time.

    1 kg, 0.5 m from a bearing of mu r = 0.002 m whose force is m (a - g); it leaves its stop with
    `rebound` times its speed.
    """
    inertia, half, rub = 0.5, 0.5, 0.1 * 0.02

    def rate(_: float, state: Sequence[float]) -> list[float]:
        angle, w = state
        along = half * w * w + GRAVITY * np.cos(angle)
        a = -GRAVITY * half / inertia * np.sin(angle)
        for _ in range(20):  # the force has a share of a in it, which rub makes small
            force = np.hypot(along, half * a + GRAVITY * np.sin(angle))
            a = (-GRAVITY * half * np.sin(angle) - np.sign(w) * rub * force) / inertia
        return [w, a]

    def energy(angle: float, w: float) -> float:
        return 0.5 * inertia * w * w - GRAVITY * half * np.cos(angle)

    now, angle, w = 0.0, 1.0, -1e-300
    while now < t:

        def stop(_: float, state: Sequence[float]) -> float:
            return state[0] + 0.3

        def turn(_: float, state: Sequence[float]) -> float:
            return state[1]

        stop.terminal = turn.terminal = True  # pyright: ignore[reportFunctionMemberAccess]
        stop.direction = -1  # pyright: ignore[reportFunctionMemberAccess]
        turn.direction = 1 if w < 0.0 else -1  # pyright: ignore[reportFunctionMemberAccess]
        run = solve_ivp(
            rate, (now, t), [angle, w], method="DOP853", rtol=1e-11, atol=1e-12,
            events=[stop, turn], max_step=0.05,
        )  # fmt: skip
        now, angle, w = run.t[-1], *run.y[:, -1]
        if len(run.t_events[0]):
            angle, w = -0.3 + 1e-15, -rebound * w
        elif run.status == 1:
            w = -1e-12 * np.sign(angle)
    return energy(1.0, 0.0) - energy(angle, w)
