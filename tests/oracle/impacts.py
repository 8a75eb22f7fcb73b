"""Impacts at a fixed configuration: the energetic sweep with Coulomb's cone (theory 10.3).

    0 <= p_N' _|_ gamma_N - c >= 0, c = tau v until the contact has given back e^2 of its work,
    |p_T'| <= mu p_N', p_T' against gamma_T

with gamma = gamma- + W p, W = G M^-1 G' of the contacts that touch while the bilateral rows hold.
"""

from __future__ import annotations

from itertools import product

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import solve_ivp

from tests.oracle.contacts import MOST, State, TooManyChoicesError, set_contact, set_friction
from tests.oracle.mechanism import OFF, Array, Mechanism
from tests.oracle.start import Accelerations, constrained, row_rates, rows_of

Mask = NDArray[np.bool_]
Choice = tuple[str | float, ...]

SMALL = 1e-11
"""Of the largest rate or impulse: what counts as zero in an inequality."""
HELD = 1e-10
"""Of W without bilateral rows: what these leave of a row that depends on them."""


class Law:
    """The impulses of contacts, of which contact k has the rows `rows[k]`, normal first.

    It knows no way out of a jam, and no slip in space that begins beside others: these are not
    unique to it.
    """

    def __init__(self, W: Array, before: Array, rows: list[list[int]], e: Array, c: Array) -> None:
        self.W, self.before, self.e, self.c = W, before, np.array(e), c
        self.rows = [r if mu > 0.0 else r[:1] for r, mu in zip(rows, c, strict=True)]
        self.unique = True
        self.size = np.max(np.abs(before), initial=1e-300)
        self.scale = 1.0 / np.sqrt(np.maximum(np.diag(W), 1e-12 * np.max(np.diag(W), initial=1.0)))

    def _rates(self, gamma: Array, active: Mask, wall: Array) -> Array:
        """Rates p' with which the active contacts follow their walls."""
        slips = [float(np.linalg.norm(gamma[t])) for _, *t in self.rows]
        ways = []
        for (_, *t), acts, slip in zip(self.rows, active, slips, strict=True):
            stuck = acts and t and slip <= SMALL * self.size
            turns = [1.0, -1.0] if len(t) == 1 else []
            ways.append(["parts"] if not acts else ["sticks", "parts", *turns] if stuck
                        else ["slides", "parts"])  # fmt: skip
        if np.prod([float(len(way)) for way in ways]) > MOST:
            raise TooManyChoicesError
        found: list[Array] = []
        for choice in product(*ways):
            q = self._of_choice(choice, gamma, slips, active, wall)
            if q is not None and not any(
                np.max(np.abs(self.W @ (q - other))) <= 1e-9 * self.size for other in found
            ):
                found.append(q)
        if not found:
            message = "no rates obey the law of impact"
            raise ArithmeticError(message)
        self.unique &= len(found) == 1
        return min(found, key=lambda q: float(q @ self.W @ q))

    def _of_choice(
        self, choice: Choice, gamma: Array, slips: list[float], active: Mask, wall: Array
    ) -> Array | None:
        n = len(gamma)
        A, b = np.eye(n), np.zeros(n)
        for (k, *t), way, slip, c, speed in zip(
            self.rows, choice, slips, self.c, wall, strict=True
        ):
            if way == "parts":
                continue
            A[k], b[k] = self.W[k], speed
            if way == "sticks":
                A[t] = self.W[t]
            elif isinstance(way, float):
                A[t[0], k] = way * c
            elif t:
                A[t, k] = c * gamma[t] / slip
        scaled = A * self.scale / self.scale[:, None]
        y = np.linalg.lstsq(scaled, b / self.scale, rcond=1e-11)[0]
        if np.max(np.abs(scaled @ y - b / self.scale), initial=0.0) > 1e-9 * self.size:
            return None
        q = y * self.scale
        rate, most = self.W @ q, np.max(np.abs(q), initial=0.0)
        for (k, *t), way, c, acts, speed in zip(
            self.rows, choice, self.c, active, wall, strict=True
        ):
            if q[k] < -SMALL * most or (acts and rate[k] < speed - SMALL * self.size):
                return None
            if way == "sticks" and t and np.linalg.norm(q[t]) > c * q[k] + SMALL * most:
                return None
            if isinstance(way, float) and way * rate[t[0]] < -SMALL * self.size:
                return None
        return q

    def solve(self) -> tuple[Array, bool]:
        """Impulses, and whether the path that leads to them is unique."""
        normal = [k for k, *_ in self.rows]
        v = np.maximum(0.0, -self.before[normal])
        v[v <= 1e-12 * np.max(v)] = 0.0
        n, m, tau, live = len(v), len(self.before), -1.0, v > 0.0
        gamma, p, works = self.before.astype(float), np.zeros(m), np.zeros((2, n))
        for _ in range(60 * n):
            if tau >= 0.0:
                live &= self.e**2 * works[0] - works[1] > 1e-13 * works[0]
            if not np.any(live):
                return p, self.unique
            for _, *t in self.rows:
                if t and np.linalg.norm(gamma[t]) <= SMALL * self.size:
                    gamma[t] = 0.0
            wall, start = np.where(live, v, 0.0), np.where(live, tau * v, 0.0)
            active = gamma[normal] <= start + SMALL * self.size
            gamma, p, work, h = self._piece(gamma, p, active, wall, start, tau, live, works)
            works[0] -= np.minimum(work, 0.0)
            works[1] += np.maximum(work, 0.0)
            tau = 0.0 if abs(tau + h) < 1e-14 else tau + h
        message = "the path of an impact has no end"
        raise ArithmeticError(message)

    def _piece(
        self, gamma: Array, p: Array, active: Mask, wall: Array, start: Array, tau: float,
        live: Mask, works: Array,
    ) -> tuple[Array, Array, Array, float]:  # fmt: skip
        """Follow the path until a slip stops, a wall is met, the clock is 0 or a contact ends."""
        m, normal = len(gamma), [k for k, *_ in self.rows]
        left = self.e**2 * works[0] - works[1]
        q0 = self._rates(gamma, active, wall)
        pushes = active & (q0[normal] > 1e-11 * np.max(np.abs(q0)))

        if all(len(row) <= 2 for row in self.rows):
            return self._straight_piece(gamma, p, q0, pushes, wall, start, tau, live, left)

        def slope(_: float, y: Array) -> Array:
            q = self._rates(y[:m], pushes, wall)
            return np.concatenate([self.W @ q, q, q[normal] * y[normal]])

        events = []
        for i, (k, *t) in enumerate(self.rows):
            if pushes[i]:
                if t and np.linalg.norm(gamma[t]) > SMALL * self.size:
                    events.append(lambda _, y, t=t: np.linalg.norm(y[t]) - 0.5 * SMALL * self.size)
                if live[i] and tau >= 0.0:
                    events.append(lambda _, y, i=i: left[i] - y[2 * m + i])
            else:
                events.append(
                    lambda s, y, i=i, k=k: y[k] - start[i] - wall[i] * s + 1e-13 * self.size
                )
        for event in events:
            event.terminal, event.direction = True, -1
        y0 = np.concatenate([gamma, p, np.zeros(len(normal))])
        span = (0.0, -tau if tau < 0.0 else 10.0)
        path = solve_ivp(slope, span, y0, method="DOP853", rtol=1e-12, atol=1e-14 * self.size,
                         events=events)  # fmt: skip
        if not path.success:
            raise ArithmeticError(path.message)
        y = path.y[:, -1]
        return y[:m], y[m : 2 * m], y[2 * m :], float(path.t[-1])

    def _straight_piece(
        self, gamma: Array, p: Array, q: Array, pushes: Mask, wall: Array, start: Array,
        tau: float, live: Mask, left: Array,
    ) -> tuple[Array, Array, Array, float]:  # fmt: skip
        """Likewise with slips of one rate each, which keep their directions."""
        rate, normal = self.W @ q, [k for k, *_ in self.rows]
        ends = [-tau if tau < 0.0 else 10.0]
        for i, (k, *t) in enumerate(self.rows):
            if not pushes[i]:
                if rate[k] < wall[i]:
                    above = gamma[k] - start[i] + 1e-13 * self.size
                    ends.append(max(0.0, above / (wall[i] - rate[k])))
                continue
            if t and gamma[t[0]] * rate[t[0]] < 0.0:
                ends.append(-gamma[t[0]] / rate[t[0]])
            if live[i] and tau >= 0.0:  # the work that is left is q (gamma h + rate h^2/2)
                a, b = q[k] * gamma[k], 0.5 * q[k] * rate[k]
                ends.append(2.0 * left[i] / (a + np.sqrt(a * a + 4.0 * b * left[i])))
        h = min(ends)
        work = h * q[normal] * (gamma[normal] + 0.5 * h * rate[normal])
        return gamma + h * rate, p + h * q, work, h

    def loss(self, p: Array) -> float:
        """What the impulses take, -p (gamma- + gamma+)/2 [J]."""
        return -float(p @ (self.before + 0.5 * self.W @ p))


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
    taking = state.touches.copy()
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
        if p[k] > SMALL * np.max(p):
            mechanism.of_contacts[i, 3] += law.before[k] < -state.speed_tolerance
            mechanism.of_contacts[i, 4] += p[k]
    return True, unique
