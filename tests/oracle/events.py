"""Located contacts: steps with frozen modes, cut where a mode ends (theory 10.1 and 10.2).

Each trial is the whole step anew; its length is found by SciPy's `brentq`.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from scipy.optimize import brentq

from tests.oracle.contacts import Ended, State, settle
from tests.oracle.impacts import hit, project
from tests.oracle.mechanism import OFF, SLIDES, STICKS, Array, Mechanism
from tests.oracle.start import Accelerations
from tests.oracle.step import internal_step

FOURTH = 1.0 / (4.0 - 4.0 ** (1.0 / 3.0))
STAGES = {
    0.0: (1.0,), 2.0: (1.0,), 4.0: (FOURTH, FOURTH, 1.0 - 4.0 * FOURTH, FOURTH, FOURTH),
}  # fmt: skip
"""Parts of a step of each order (Suzuki 1990)."""
SLIVER = 1e-3
"""Of a step: what is left of one that is shorter belongs to the next."""
BEFORE_STOP, STOPPED = 0.9, 1e-7
"""Part of the time to the stop of a slip in space that a piece covers; slip that counts as none."""


def piece(mechanism: Mechanism, h: float) -> Mechanism:
    """Mechanism after a step of length h in which no mode changes."""
    section = mechanism.section
    damped = np.any(section["damping"]) or np.any(section["depth_damping"])
    for part in STAGES[2.0 if damped else mechanism.head["order"]]:
        t = mechanism.head["time"] + part * h
        mechanism = internal_step(mechanism, part * h)
        mechanism.head["time"] = t
        mechanism.forces_at(t, 0.0, 0)
    return mechanism


def functions(mechanism: Mechanism) -> tuple[Array, Array]:
    """What is positive while the modes hold, of contacts and then frictions; what counts as 0."""
    state = State(mechanism)
    mu, _ = Accelerations(mechanism).solve()
    closed = mechanism.of_contacts[:, 0] != 0.0
    normals = np.array([-mu[row] for row, _ in mechanism.contacts])
    force = np.max(np.abs(normals), initial=0.0)
    energy = mechanism.head["energy_reference"] / max(mechanism.section["extent"][0], 1.0)
    values = [*np.where(closed, normals, state.gaps)]
    none = [*np.where(closed, 1e-11 * max(force, energy), 1e-15 * mechanism.section["extent"][0])]
    for f, (mode, *along) in enumerate(mechanism.of_frictions):
        rows, value, small = mechanism.frictions[f].rows, np.inf, 0.0
        if mode == STICKS:
            limit = mechanism.cone(f, mu, "static")
            value = limit - np.sqrt(np.sum(mu[rows] ** 2))
            small = 1e-11 * max(abs(limit), mechanism.section["static"][f] * max(force, energy))
        elif mode == SLIDES and len(rows) == 1:
            value, small = along[0] * state.rates[rows[0]], 1e-3 * state.speed_tolerance
        elif mode == SLIDES:
            value, small = state.slip(f)[0], STOPPED / 1e-10 * state.speed_tolerance
        values.append(value)
        none.append(small)
    return np.array(values), np.array(none)


@dataclass
class Located:
    """A run: the mechanism, times of its events, whether all impacts had one solution."""

    mechanism: Mechanism
    events: list[float] = field(default_factory=list)
    unique: bool = True

    def settle(self, ended: Ended | None = None) -> None:
        """Impacts and new modes at the present state."""
        for _ in range(2000):
            has_hit, unique = hit(self.mechanism)
            self.unique &= unique
            if not has_hit:
                break
        settle(self.mechanism, ended or Ended())
        self.mechanism.head["unsettled"] = 0.0

    def advance(self, step: float) -> None:
        """Cover a communication step by steps of at most the option step_size, cut at events."""
        start, n = self.mechanism.head["time"], step / self.mechanism.head["step_size"]
        h, done = step / max(1.0, np.ceil(n * (1.0 - 1e-10))), 0.0
        if self.mechanism.head["unsettled"]:
            self.project()
            self.settle()
        while done < step:
            grid = (np.floor(done / h + SLIVER) + 1.0) * h
            end = step if grid > step - SLIVER * h else grid
            whole = end - done
            length = self.before_stop(whole)
            covered, after, ended = self.first_event(length)
            self.mechanism = after
            done = end if covered == whole else done + covered
            self.mechanism.head["time"] = start + done
            if ended:
                self.events.append(start + done)
                self.end_modes(ended)
            self.follow_slips()

    def project(self) -> None:
        """Take from the velocities what rows do not allow, if contacts or frictions have any."""
        mechanism = self.mechanism
        if np.any(mechanism.of_contacts[:, 0]) or np.any(mechanism.of_frictions[:, 0] != OFF):
            project(mechanism, "impact")

    def before_stop(self, length: float) -> float:
        """Length of a piece that ends before a slip in space would stop at its present rate."""
        for f, (mode, *_) in enumerate(self.mechanism.of_frictions):
            rows = self.mechanism.frictions[f].rows
            if mode != SLIDES or len(rows) == 1:
                continue
            at = Accelerations(self.mechanism)
            size, along = State(self.mechanism).slip(f)
            rate = along @ at.second_rates(at.solve()[1])[rows]
            if rate < 0.0 and BEFORE_STOP * size / -rate < length:
                project(self.mechanism, "impact")
                size, along = State(self.mechanism).slip(f)
                at = Accelerations(self.mechanism)
                rate = along @ at.second_rates(at.solve()[1])[rows]
                length = min(length, BEFORE_STOP * size / -rate)
        return length

    def follow_slips(self) -> None:
        """Directions of slips in space at the end of a piece."""
        state = State(self.mechanism)
        for f, own in enumerate(self.mechanism.of_frictions):
            n = len(self.mechanism.frictions[f].rows)
            if own[0] == SLIDES and n > 1 and state.slip(f)[0] > state.speed_tolerance:
                own[1 : 1 + n] = state.slip(f)[1]

    def first_event(self, h: float) -> tuple[float, Mechanism, list[int]]:
        """Length of the step of at most h in which the first mode ends, its end, and that mode."""
        begin, low = self.mechanism, functions(self.mechanism)
        trials = {0.0: begin, h: piece(begin, h)}

        def value(length: float, k: int) -> float:
            if length not in trials:
                trials[length] = piece(begin, length)
            return float(functions(trials[length])[0][k])

        end, which = h, []
        for part in (1.0, 0.75, 0.5, 0.25):  # gaps that close and open again, too
            if part < 1.0 and not self._may_touch(h):
                break
            if part * h > end:
                continue
            values, none = functions(trials.setdefault(part * h, piece(begin, part * h)))
            late = np.flatnonzero(values < -none)
            if len(late):
                end, which = part * h, late.tolist()
        if not which:
            values, none = functions(trials[h])
            stopped = [
                len(begin.contacts) + f
                for f, (mode, *_) in enumerate(begin.of_frictions)
                if mode == SLIDES and len(begin.frictions[f].rows) > 1
            ]
            return h, trials[h], [k for k in stopped if values[k] <= none[k]]
        for k in which:
            values, none = functions(trials[end])
            if values[k] >= -none[k]:
                continue
            first = 0.0
            if low[0][k] <= low[1][k]:  # a mode that has just begun
                first = next(
                    (s for s in end * 0.5 ** np.arange(1, 30) if value(s, k) > none[k]), 0.0
                )
                if first == 0.0:  # a contact that carries nothing
                    return 0.0, begin, [k]
            end = float(brentq(value, first, end, args=(k,), xtol=1e-16, rtol=1e-15))
            value(end, k)
        values, none = functions(trials[end])
        ended = [k for k in range(len(values)) if values[k] <= 10.0 * none[k]]
        return end, trials[end], sorted({*ended, k})

    def _may_touch(self, h: float) -> bool:
        """Whether an open gap may close within a step."""
        state = State(self.mechanism)
        is_open = self.mechanism.of_contacts[:, 0] == 0.0
        second = h * np.max(np.abs(self.mechanism.vectors["a_first"]), initial=0.0)
        fastest = np.max(np.abs(self.mechanism.v), initial=0.0) + second
        return bool(np.any(state.gaps[is_open] < 2.0 * h * fastest))

    def end_modes(self, which: list[int]) -> None:
        """Open contacts without force, let frictions slide at their cones and stick at rest."""
        mechanism, ended = self.mechanism, Ended()
        closed, n = mechanism.of_contacts[:, 0] != 0.0, len(mechanism.contacts)
        self.project()
        mu, _ = Accelerations(mechanism).solve()
        ended.opened = {k for k in which if k < n and closed[k]}
        for f, own in enumerate(mechanism.of_frictions):
            if n + f not in which or own[0] == OFF:
                continue
            if own[0] == SLIDES:
                own[0] = STICKS
                project(mechanism, "friction")
            else:
                rows = mechanism.frictions[f].rows
                ended.sliding[f] = mu[rows] / np.sqrt(np.sum(mu[rows] ** 2))
        self.settle(ended)
