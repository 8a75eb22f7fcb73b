"""Impacts at a fixed configuration: Newton's restitution with Coulomb's cone (theory 10.3).

    0 <= p_N _|_ gamma_N+ + e gamma_N- >= 0,    |p_T| <= c p_N,    p_T against gamma_T+ if not 0

with gamma+ = gamma- + W p, W = G M^-1 G' of the contacts that touch while the bilateral rows hold.
"""

from __future__ import annotations

from itertools import product

import numpy as np
from scipy.optimize import root

from tests.oracle.contacts import MOST, State, TooManyChoicesError, set_contact, set_friction
from tests.oracle.mechanism import OFF, Array, Mechanism
from tests.oracle.start import Accelerations, constrained, row_rates, rows_of

SMALL = 1e-11
"""Of the largest rate or impulse: what counts as zero in an inequality."""
HELD = 1e-10
"""Of W without bilateral rows: what these leave of a row that depends on them."""
SWEEPS = 300


class Law:
    """The impulses of contacts, of which contact k has the rows `rows[k]`, normal first."""

    def __init__(self, W: Array, before: Array, rows: list[list[int]], e: Array, c: Array) -> None:
        self.W, self.before, self.rows, self.e, self.c = W, before, rows, np.array(e), c

    def solutions(self) -> list[Array]:
        """Impulses with different velocities after the impact; usually one."""
        if any(len(rows) > 2 and c > 0.0 for rows, c in zip(self.rows, self.c, strict=True)):
            return [self.fixed_point()]
        ways = [
            ["parts", "sticks", 1.0, -1.0] if len(rows) > 1 and c > 0.0 else ["parts", "closed"]
            for rows, c in zip(self.rows, self.c, strict=True)
        ]
        if np.prod([float(len(way)) for way in ways]) > MOST:
            raise TooManyChoicesError
        found: list[Array] = []
        for choice in product(*ways):
            p = self._of_choice(choice)
            if p is not None and not any(self._alike(p, other) for other in found):
                found.append(p)
        return found

    def _alike(self, p: Array, other: Array) -> bool:
        return np.max(np.abs(self.W @ (p - other))) <= 1e-9 * np.max(np.abs(self.before))

    def _of_choice(self, choice: tuple[str | float, ...]) -> Array | None:
        """Impulses with which contacts part, are closed, stick or slide as chosen, or None."""
        n = len(self.before)
        A, b = np.eye(n), np.zeros(n)
        for (k, *t), e, c, way in zip(self.rows, self.e, self.c, choice, strict=True):
            if way == "parts":
                continue
            A[k], b[k] = self.W[k], -(1.0 + e) * self.before[k]
            if way == "sticks":
                A[t], b[t] = self.W[t], -self.before[t]
            elif isinstance(way, float):
                A[t[0], k] = way * c
        stiffness = np.diag(self.W)
        scale = np.sqrt(np.maximum(stiffness, 1e-12 * np.max(stiffness)))
        y = np.linalg.lstsq(A / scale[:, None] / scale, b / scale, rcond=1e-11)[0]
        p = y / scale
        rate, push = np.max(np.abs(self.before)), np.max(np.abs(p), initial=0.0)
        if np.max(np.abs(A @ p - b) / scale) > 1e-9 * np.max(np.abs(self.before) / scale):
            return None
        after = self.before + self.W @ p
        for (k, *t), e, c, way in zip(self.rows, self.e, self.c, choice, strict=True):
            if p[k] < -SMALL * push or after[k] + e * self.before[k] < -SMALL * rate:
                return None
            if way == "sticks" and abs(p[t[0]]) > c * p[k] + SMALL * push:
                return None
            if isinstance(way, float) and way * after[t[0]] < -SMALL * rate:
                return None
        return p

    def _projected(self, p: Array) -> Array:
        """Impulses p less their rates over their stiffness, projected onto the cones.

        Those that obey the law stay as they are. In turn, as Gauss and Seidel do.
        """
        p, W = p.copy(), self.W
        for (k, *t), e, c in zip(self.rows, self.e, self.c, strict=True):
            excess = self.before[k] + W[k] @ p + e * self.before[k]
            p[k] = max(0.0, p[k] - excess / W[k, k]) if W[k, k] > 0.0 else 0.0
            if t and c > 0.0:
                stiffness = np.linalg.norm(W[np.ix_(t, t)], 2) or 1.0
                pull = p[t] - (self.before[t] + W[t] @ p) / stiffness
                size = np.sqrt(pull @ pull)
                p[t] = pull * min(1.0, c * p[k] / size) if size > 0.0 else 0.0
        return p

    def _moved(self, x: Array, scale: float) -> Array:
        return self._projected(x * scale) / scale - x

    def fixed_point(self) -> Array:
        """Impulses that stay as they are when they are projected."""
        p = np.zeros(len(self.before))
        scale = np.max(np.abs(self.before)) / np.max(np.diag(self.W))
        for _ in range(4):
            for _ in range(SWEEPS):
                last, p = p, self._projected(p)
            if np.max(np.abs(p - last)) > 1e-14 * scale:
                fine = {"xtol": 1e-15, "ftol": 1e-30}
                p = scale * root(self._moved, p / scale, (scale,), method="lm", options=fine).x
            last = p
            if np.max(np.abs(self._projected(p) - p)) <= 1e-13 * scale:
                return p
        message = "impulses do not settle"
        raise ArithmeticError(message)

    def loss(self, p: Array) -> float:
        """What the impulses take, -p (gamma- + gamma+)/2 [J]."""
        return -float(p @ (self.before + 0.5 * self.W @ p))

    def solve(self) -> tuple[Array, bool]:
        """Impulses that create no energy, with smaller restitution if need be; whether unique."""
        while True:
            found = self.solutions()
            stiffness = np.diag(self.W)[np.diag(self.W) > 0.0]
            size = np.max(np.abs(self.before)) ** 2 / np.min(stiffness, initial=np.inf)
            fine = [p for p in found if self.loss(p) >= -1e-12 * size]
            if fine:
                return fine[0], len(found) == 1
            if not np.any(self.e):
                message = "no impulses obey the law of impact"
                raise ArithmeticError(message)
            self.e = np.where(self.e < 2e-3, 0.0, 0.5 * self.e)


def across(mechanism: Mechanism, on: Array) -> Array:
    """Part y (n_free,) of the velocities that the rows `on` do not allow."""
    n, G = mechanism.n_free, rows_of(mechanism)[0]
    rate = row_rates(mechanism, mechanism.signal_rates(mechanism.head["time"]))
    off = np.diag(np.where(on, 0.0, -1.0))
    M = mechanism.M[:n, :n]
    g = np.where(on, rate, 0.0)
    return constrained(mechanism, M, G[:, :n], np.zeros(n), g, off=off)[0]


def add_velocities(mechanism: Mechanism, dv: Array) -> float:
    """Add to the velocities of the free nodes; returns the change of the kinetic energy."""
    n, M = mechanism.n_free, mechanism.M
    change = float(dv @ (M @ mechanism.v)[:n] + 0.5 * dv @ M[:n, :n] @ dv)
    mechanism.vectors["v"][:n] += mechanism.vectors["v_low"][:n] + dv
    mechanism.vectors["v_low"][:n] = 0.0
    return change


def project(mechanism: Mechanism, account: str) -> None:
    """Take from the velocities what the rows that hold do not allow, and book its energy."""
    y = across(mechanism, mechanism.rows_on())
    n = mechanism.n_free
    loss = 0.5 * float(y @ mechanism.M[:n, :n] @ y)
    change = add_velocities(mechanism, -y)
    mechanism.head[account] += loss
    mechanism.head["work"] += change + loss


def restitutions(mechanism: Mechanism, state: State) -> Array:
    """Restitution of each contact; 0 of slow ones and where the next flight would be short."""
    head, e = mechanism.head, mechanism.section["restitution"].copy()
    second = None
    for i, (row, _) in enumerate(mechanism.contacts):
        speed = -state.gap_rates[i]
        if not (e[i] > 0.0 and speed > max(head["rest_speed"], state.speed_tolerance)):
            e[i] = 0.0
        elif head["rest_time"] > 0.0 and not mechanism.of_contacts[i, 0]:
            if second is None:
                at = Accelerations(mechanism)
                second = at.second_rates(at.solve()[1])
            if 2.0 * e[i] * speed < head["rest_time"] * -second[row]:
                e[i] = 0.0
    return e


def hit(mechanism: Mechanism) -> tuple[bool, bool]:
    """One impact of the contacts that touch and approach; whether there is one and is unique.

    By the sequential law the one that approaches fastest hits alone, unless it does not rebound.
    """
    state, n = State(mechanism), mechanism.n_free
    if not np.any(state.touches & (state.gap_rates < -state.speed_tolerance)):
        return False, True
    taking = state.touches & (state.gap_rates <= state.speed_tolerance)
    fastest = int(np.argmin(np.where(taking, state.gap_rates, np.inf)))
    e = restitutions(mechanism, state)
    if mechanism.head["impact_law"] and e[fastest] > 0.0:
        taking = np.arange(len(taking)) == fastest
    for i in range(len(mechanism.contacts)):
        set_contact(mechanism, i, closed=False)
    for f in range(len(mechanism.frictions)):
        set_friction(mechanism, f, OFF, None)
    y = across(mechanism, mechanism.bilateral)
    add_velocities(mechanism, -y)
    here = State(mechanism).rates
    rows, places, c = [], [], []
    for i in np.flatnonzero(taking):
        row, f = mechanism.contacts[i]
        own = [row, *(mechanism.frictions[f].rows if f is not None else [])]
        places.append(list(range(len(rows), len(rows) + len(own))))
        rows += own
        c.append(mechanism.section["sliding"][f] if f is not None else 0.0)
    G = rows_of(mechanism)[0][:, :n]
    M, off = mechanism.M[:n, :n], np.diag(np.where(mechanism.bilateral, 0.0, -1.0))
    nothing = np.zeros(mechanism.n_rows)
    reach = [constrained(mechanism, M, G, G[row], nothing, off=off)[0] for row in rows]
    W, before = G[rows] @ np.array(reach).T, here[rows]
    held = np.diag(W) <= HELD * np.sum(G[rows] ** 2 / mechanism.m_node[:n], axis=1)
    held &= np.abs(before) <= state.speed_tolerance
    W[held, :] = W[:, held] = before[held] = 0.0
    law = Law(W, before, places, e[taking], np.array(c))
    p, unique = law.solve()
    loss = law.loss(p)
    change = add_velocities(mechanism, p @ np.array(reach))
    after = law.before + law.W @ p
    stays = any(
        (e_k == 0.0 and p[k] > 0.0) or after[k] + (G[rows[k]] @ y) < -state.speed_tolerance
        for (k, *_), e_k in zip(places, law.e, strict=True)
    )
    if stays:
        loss += 0.5 * float(y @ M @ y)
        change -= 0.5 * float(y @ M @ y)
    else:
        add_velocities(mechanism, y)
    mechanism.head["impact"] += loss
    mechanism.head["work"] += change + loss
    for i, (k, *_) in zip(np.flatnonzero(taking), places, strict=True):
        if p[k] > 0.0:
            mechanism.of_contacts[i, 3] += law.before[k] < -state.speed_tolerance
            mechanism.of_contacts[i, 4] += p[k]
    return True, unique
