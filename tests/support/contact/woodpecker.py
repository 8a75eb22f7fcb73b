"""Glocker's woodpecker between impacts, stops and slips, by equations that are written down here.

Coordinates: height y of the sleeve, angles a of the sleeve and b of the bird. Never more than one
of its three contacts is closed, so that an impact is that of one contact (Routh's path).
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from scipy.integrate import solve_ivp

from tests.support.contact.exact_contacts import impact_by_routh
from tests.support.mechanisms.problems import GRAVITY, Array

SLEEVE, SLEEVE_INERTIA, BIRD, BIRD_INERTIA = 0.0003, 5e-9, 0.0045, 7e-7
TO_SPRING, TO_BIRD, STIFFNESS, FRICTION = 0.01, 0.015, 0.0056, 0.3
POLE, HOLE, HALF, BEAK = 0.0025, 0.0031, 0.0058, (-0.0201, 0.02)
RESTITUTION = (0.5, 0.0, 0.0)
"""Of the beak, and of the upper and lower edge of the sleeve."""

OPEN, STICKS, UP, DOWN = range(4)
"""Of the closed contact; `UP` slips against the axis y."""


def turn(angle: float, place: tuple[float, float]) -> Array:
    """Return a place, turned."""
    c, s = np.cos(angle), np.sin(angle)
    return np.array([c * place[0] - s * place[1], s * place[0] + c * place[1]])


def across(place: Array) -> Array:
    return np.array([-place[1], place[0]])


def rows_of(q: Array, v: Array, contact: int) -> tuple[float, Array, Array]:
    """Return the gap, its rate and slip's as rows over v, and what of their growth is not G v'."""
    _, a, b = q
    if contact == 0:
        arm, beak = turn(a, (TO_SPRING, 0.0)), turn(b, (TO_BIRD + BEAK[0], BEAK[1]))
    else:
        arm, beak = turn(a, (HOLE, HALF if contact == 1 else -HALF)), np.zeros(2)
    place_rate = np.array([[0.0, 1.0], across(arm), across(beak)]).T
    growth = -arm * v[1] ** 2 - beak * v[2] ** 2
    G = np.array([place_rate[0], -place_rate[1]])
    return float(arm[0] + beak[0] - POLE), G, np.array([growth[0], -growth[1]])


def mass_and_force(q: Array, v: Array) -> tuple[Array, Array]:
    _, a, b = q
    arm, to_bird = turn(a, (TO_SPRING, 0.0)), turn(b, (TO_BIRD, 0.0))
    rate = np.array([[0.0, 1.0], across(arm), across(to_bird)]).T
    growth = -arm * v[1] ** 2 - to_bird * v[2] ** 2
    M = BIRD * (rate.T @ rate) + np.diag([SLEEVE, SLEEVE_INERTIA, BIRD_INERTIA])
    spring = STIFFNESS * (b - a)
    force = rate.T @ (BIRD * (np.array([0.0, -GRAVITY]) - growth))
    weight = np.array([-SLEEVE * GRAVITY, spring, -spring], np.float64)
    return np.array(M, np.float64), np.add(force, weight)


def moved(q: Array, v: Array, contact: int, mode: int) -> tuple[Array, Array]:
    """Return v' and the normal force and friction of the contact."""
    M, force = mass_and_force(q, v)
    if mode == OPEN:
        return np.array(np.linalg.solve(M, force), np.float64), np.zeros(2)
    _, G, growth = rows_of(q, v, contact)
    held = G if mode == STICKS else G[:1]
    cone = {UP: -FRICTION, DOWN: FRICTION}.get(mode, 0.0)
    pushed = G.T if mode == STICKS else (G[:1] + cone * G[1:]).T
    by_push = np.linalg.solve(M, pushed)
    free = np.linalg.solve(M, force)
    found = np.linalg.solve(held @ by_push, -(held @ free + growth[: len(held)]))
    N = found[0]
    return free + by_push @ found, np.array([N, found[1] if mode == STICKS else cone * N])


def settled(q: Array, v: Array, contact: int) -> int:
    """Return whether a closed contact without slip sticks, or where it slips to."""
    N, T = moved(q, v, contact, STICKS)[1]
    if abs(T) <= FRICTION * N:
        return STICKS
    return UP if T < 0.0 else DOWN


def pecks(stop_time: float) -> Array:
    """Return the times of the impacts of the beak [s]."""
    t, q, v = 0.0, np.array([0.0, -0.1, -0.2788]), np.array([-0.3411, 0.0, -7.4583])
    contact, mode, found = -1, OPEN, []

    def event(value: Callable[[Array, Array], float], way: int) -> Callable[..., float]:
        def f(_: float, s: Array) -> float:
            return value(s[:3], s[3:])

        f.terminal, f.direction = True, way  # pyright: ignore[reportFunctionMemberAccess]
        return f

    while t < stop_time:
        ends = {
            f"hits {i}": event(lambda q, v, i=i: rows_of(q, v, i)[0], -1)
            for i in range(3)
            if mode == OPEN or i != contact
        }
        if mode != OPEN:
            now = contact, mode
            ends["opens"] = event(lambda q, v, x=now: moved(q, v, *x)[1][0], -1)
            if mode == STICKS:
                ends["slips"] = event(
                    lambda q, v, x=now: float(np.abs(moved(q, v, *x)[1]) @ [FRICTION, -1.0]), -1
                )
            else:
                way = -1 if mode == UP else 1
                ends["stops"] = event(lambda q, v, i=contact: rows_of(q, v, i)[1][1] @ v, way)
        run = solve_ivp(
            lambda _, s, i=contact, m=mode: np.concatenate([s[3:], moved(s[:3], s[3:], i, m)[0]]),
            (t, stop_time), np.concatenate([q, v]), method="DOP853", rtol=1e-9, atol=1e-12,
            events=list(ends.values()), max_step=5e-3,
        )  # fmt: skip
        t, q, v = run.t[-1], run.y[:3, -1], run.y[3:, -1]
        if run.status != 1:
            break
        why = next(name for name, x in zip(ends, run.t_events, strict=True) if len(x))
        if why == "opens":
            mode = OPEN
        elif why == "stops":
            mode = settled(q, v, contact)
        elif why == "slips":
            mode = UP if moved(q, v, contact, mode)[1][1] < 0.0 else DOWN
        else:
            assert mode == OPEN, "two contacts at once"
            contact = int(why[-1])
            _, G, _ = rows_of(q, v, contact)
            by_push = np.linalg.solve(mass_and_force(q, v)[0], G.T)
            p, after = impact_by_routh(G @ by_push, G @ v, FRICTION, RESTITUTION[contact])
            v = v + by_push @ p
            found += [t] if contact == 0 else []
            if RESTITUTION[contact] == 0.0:
                sticks = abs(after[1]) < 1e-12
                mode = settled(q, v, contact) if sticks else UP if after[1] > 0.0 else DOWN
                mode = mode if moved(q, v, contact, mode)[1][0] > 0.0 else OPEN
    return np.array(found)
