"""Which contacts hold and which frictions stick or slide at a state (theory 10.4).

    0 <= N _|_ g'' >= 0,     |T| <= c_s N + N_0 where nothing slips, else T = (c N + N_0) t,

found by trying all choices: those that stick first, those that are open last.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import product
from math import prod

import numpy as np

from tests.oracle.mechanism import OFF, SLIDES, STICKS, Array, Mechanism
from tests.oracle.start import Accelerations, row_rates
from tests.oracle.step import rows_now

TOUCHING = RESTING = 1e-10
"""Gap and speed that count as zero, relative to the size and speed of the mechanism."""
NONE = 1e-9
"""Force, acceleration and friction that count as zero, relative to the largest ones."""
MOST = 3000
"""Choices that are tried, at most."""

Choice = tuple[float, Array | None]
"""Mode of a friction and the direction of its slip, None if that is to be found."""


class TooManyChoicesError(ArithmeticError):
    """More contacts at rest than can be tried."""


@dataclass
class Ended:
    """What an event has just ended: it may not go on as before."""

    opened: set[int] = field(default_factory=set)
    sliding: dict[int, Array] = field(default_factory=dict)
    """Directions in which frictions give way."""


class State:
    """Gaps (contacts,), rates (r,) of the rows and slips of a mechanism, and their scales."""

    def __init__(self, mechanism: Mechanism) -> None:
        self.mechanism = mechanism
        head, extent = mechanism.head, mechanism.section["extent"]
        gap_rows = [row for row, _ in mechanism.contacts]
        self.rates = row_rates(mechanism, mechanism.signal_rates(head["time"]))
        self.gaps, self.gap_rates = rows_now(mechanism)[gap_rows], self.rates[gap_rows]
        v = mechanism.v
        speed = max(np.sqrt(2.0 * head["energy_reference"]), np.sqrt(v @ mechanism.M @ v))
        self.gap_tolerance = TOUCHING * extent[0]
        self.speed_tolerance = RESTING * speed * extent[0] / extent[1]
        self.touches = self.gaps <= self.gap_tolerance
        self.rests = self.touches & (np.abs(self.gap_rates) <= self.speed_tolerance)

    def slip(self, f: int) -> tuple[float, Array]:
        """Size of the slip of a friction, and its direction."""
        slip = self.rates[self.mechanism.frictions[f].rows]
        size = float(np.sqrt(slip @ slip))
        return size, slip / (size or 1.0)


def set_contact(mechanism: Mechanism, i: int, *, closed: bool, gap: float = 0.0) -> None:
    """Open contact i, or close it at the gap that it has."""
    own = mechanism.of_contacts[i]
    own[1] = own[1] if closed and own[0] else gap
    own[0] = closed


def set_friction(mechanism: Mechanism, f: int, mode: float, along: Array | None) -> None:
    """Set the mode of friction f and the direction of its slip."""
    own = mechanism.of_frictions[f]
    own[0] = mode
    own[1 : 1 + len(mechanism.frictions[f].rows)] = 0.0 if along is None else along


def _choices(state: State, f: int | None, ended: Ended) -> list[Choice]:
    """What friction f may do where its contact is closed."""
    mechanism = state.mechanism
    if f is None or not mechanism.section["static"][f] + mechanism.section["preload"][f] > 0.0:
        return [(OFF, None)]
    if f in ended.sliding:
        return [(SLIDES, ended.sliding[f] if len(ended.sliding[f]) == 1 else None)]
    size, along = state.slip(f)
    if size > state.speed_tolerance:
        return [(SLIDES, along)]
    one = len(mechanism.frictions[f].rows) == 1
    ways = [np.array([1.0]), np.array([-1.0])] if one else [None]
    return [(STICKS, None), *((SLIDES, way) for way in ways)]


def _agrees(at: Accelerations, state: State, tried: dict[int, Choice]) -> Array | None:
    """Accelerations of the choice at hand; None where forces or accelerations contradict it."""
    mechanism, unknown = at.mechanism, [f for f, (_, t) in tried.items() if t is None]
    unknown = [f for f in unknown if tried[f][0] == SLIDES]
    mu, a = at.solve()
    for _ in range(300 if unknown else 0):  # of several slip rates, the way in which they grow
        for f in unknown:
            rows = mechanism.frictions[f].rows
            G, t = at.G[rows], mechanism.of_frictions[f, 1 : 1 + len(rows)]
            stiffness = np.linalg.norm(G / mechanism.m_node @ G.T, 2)
            pull = mechanism.cone(f, mu) * t + at.second_rates(a)[rows] / stiffness
            set_friction(mechanism, f, SLIDES, pull / (np.sqrt(pull @ pull) or 1.0))
        mu, a = at.solve()
    second = at.second_rates(a)
    closed = [mu[row] for row, _ in mechanism.contacts if mechanism.rows_on()[row]]
    force = np.max(np.abs(closed), initial=0.0)
    force += mechanism.head["energy_reference"] / max(mechanism.section["extent"][0], 1.0)
    growth = np.max(np.abs(a), initial=np.max(np.abs(mechanism.section["gravity"])))
    for (row, _), (is_closed, *_), rests in zip(
        mechanism.contacts, mechanism.of_contacts, state.rests, strict=True
    ):
        if is_closed and mu[row] > NONE * force:
            return None
        if rests and not is_closed and second[row] < -NONE * growth:
            return None
    for f, (mode, along) in tried.items():
        rows = mechanism.frictions[f].rows
        if mode == STICKS:
            limit = mechanism.cone(f, mu, "static")
            if np.sqrt(np.sum(mu[rows] ** 2)) > limit * (1.0 + NONE) + NONE * NONE * force:
                return None
        elif mode == SLIDES and state.slip(f)[0] <= state.speed_tolerance:
            t = mechanism.of_frictions[f, 1 : 1 + len(rows)] if along is None else along
            if t @ second[rows] < -NONE * growth:
                return None
    return a


def agreeing(mechanism: Mechanism, ended: Ended) -> Iterator[tuple[Array, Array, Array]]:
    """Accelerations, modes of contacts and of frictions of all choices that the forces allow."""
    state = State(mechanism)
    joints = [f for f, friction in enumerate(mechanism.frictions) if not friction.pushes]
    lists: list[list[tuple[bool, Choice]]] = []
    for i, (_, f) in enumerate(mechanism.contacts):
        may_close = state.rests[i] and i not in ended.opened
        closed = [(True, x) for x in _choices(state, f, ended)] if may_close else []
        lists.append([*closed, (False, (OFF, None))])
    lists += [[(True, x) for x in _choices(state, f, ended)] for f in joints]
    if prod(map(len, lists)) > MOST:
        raise TooManyChoicesError
    at = Accelerations(mechanism)
    for choice in product(*lists):
        tried = {}
        for i, ((closed, x), (_, f)) in enumerate(zip(choice, mechanism.contacts, strict=False)):
            set_contact(mechanism, i, closed=closed, gap=state.gaps[i])
            if f is not None:
                tried[f] = x
        tried |= {
            f: x for f, (_, x) in zip(joints, choice[len(lists) - len(joints) :], strict=True)
        }
        for f, x in tried.items():
            set_friction(mechanism, f, *x)
        a = _agrees(at, state, tried)
        if a is not None:
            yield a, mechanism.of_contacts.copy(), mechanism.of_frictions.copy()


def settle(mechanism: Mechanism, ended: Ended) -> None:
    """Let contacts and frictions do what the forces allow; multipliers begin with those here."""
    found = next(agreeing(mechanism, ended), None)
    if found is None:  # what has been opened has to close again
        found = next(agreeing(mechanism, Ended(sliding=ended.sliding)), None)
    if found is None:
        message = "no choice of closed contacts agrees with the forces"
        raise ArithmeticError(message)
    mu, a = Accelerations(mechanism).solve()
    for half in ("first", "second"):
        mechanism.vectors[f"mu_{half}"], mechanism.vectors[f"a_{half}"] = mu.copy(), a.copy()
