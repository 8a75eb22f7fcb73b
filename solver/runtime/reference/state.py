"""The state's block of doubles as NumPy arrays, and sums that keep what rounding leaves over."""

from __future__ import annotations

import ctypes

import numpy as np
from numpy.typing import NDArray

from ..layout import ISLAND
from ..model import Model
from ..options import CHOICES
from ..state import State

Array = NDArray[np.float64]


def add(high: Array, low: Array, x: Array | float) -> None:
    """Add x to the sum high + low (both modified), which keeps about twice the digits (Knuth)."""
    y = x + low
    s = high + y
    t = s - high
    low[...] = (high - (s - t)) + (y - t)
    high[...] = s


class Motion:
    """Views of a state: q, q_low, v, v_low of moving nodes, a, mu, forces of either half of a pair.

    Writing to them writes the state.
    """

    def __init__(self, model: Model, block: ctypes.Array[ctypes.c_double]) -> None:
        named = State(model, block)
        self.head = named.head
        self.block = np.asarray(memoryview(block).cast("B").cast("d"))
        vectors = {name: np.asarray(view) for name, view in named.vectors.items()}
        self.vectors = vectors
        self.q, self.q_low = vectors["q"], vectors["q_low"]
        self.v, self.v_low = vectors["v"], vectors["v_low"]
        self.a = (vectors["a_first"], vectors["a_second"])
        self.mu = (vectors["mu_first"], vectors["mu_second"])
        slots = model.sizes["n_slots"]
        self.a_change = vectors["a_change"].reshape(slots, len(self.q))
        self.mu_change = vectors["mu_change"].reshape(slots, len(self.mu[0]))
        self.driven_force = (vectors["driven_first"], vectors["driven_second"])
        self.turns, self.signal = vectors["turns"], vectors["signal"]
        self.direction = vectors["direction"].reshape(-1, 2)
        self.islands = vectors["islands"].reshape(-1, len(ISLAND))
        self.quaternion = vectors["quaternion"].reshape(-1, 4)

    def of_islands(self, name: str) -> Array:
        """One scalar of all islands, shape (n_islands,); here they are solved all at once."""
        return self.islands[:, ISLAND.index(name)]

    @property
    def penalty_level(self) -> float:
        """How often the penalty was raised, a hundredfold each time."""
        return float(self.of_islands("penalty_level").max())

    @property
    def dependent(self) -> bool:
        """Whether rows depend on each other."""
        return bool(self.of_islands("dependent").any())

    @dependent.setter
    def dependent(self, found: bool) -> None:
        self.of_islands("dependent")[:] = float(found)

    @property
    def formulation(self) -> str:
        """Name of the formulation."""
        return CHOICES["formulation"][int(self.head["formulation"])]

    def is_telling(self, h: float) -> bool:
        """Whether a step of length h is long enough to tell an acceleration and a multiplier.

        Rounding errors enter both over h^2. A shorter step leaves those of the last one, and the
        round-off of the constraints as it is. What a tolerance wants may be far from `step_size`.
        """
        usual = self.head["step_size"]
        if self.head["tolerance"] > 0.0:
            usual = min(usual, self.head["wanted"])
        return abs(h) >= 1e-5 * usual

    def at_present(self, name: str) -> Array:
        """Multipliers ("") or forces on driven nodes ("driven_") at the present time.

        Those of a step are constant over it and have a component of alternating sign, which the
        mean of two neighbours removes; the line through the last two means leads to the present.
        """
        mean, before = self.vectors[f"{name}mean"], self.vectors[f"{name}mean_before"]
        gap = self.head["mean_time"] - self.head["mean_time_before"]
        beyond = self.head["time"] - self.head["mean_time"]
        return mean + (beyond / gap if 0.0 < gap < np.inf else 0.0) * (mean - before)

    def start_anew(self) -> None:
        """Draw no line through means and changes from before and after a jump."""
        self.head["mean_time"] = np.inf
        self.forget_changes()

    def forget_changes(self) -> None:
        """Draw no line through changes over internal steps of another kind."""
        self.head["known"] = 0.0

    def follow_contraction(self, updates: int) -> None:
        """Raise the penalty of steps to come a hundredfold, twice at most, where Uzawa stays slow.

        In long chains the least eigenvalue of G M^-1 G' falls like 1/N^2. Not from the start: with
        dependent rows a large penalty multiplies their rounding errors.
        """
        level, slow = self.of_islands("penalty_level"), self.of_islands("slow_steps")
        slow[:] = slow + 1.0 if updates >= 3 else 0.0
        if slow[0] >= 8.0 and level[0] < 2.0:
            level += 1.0
            slow[:] = 0.0

    def lower_penalty(self) -> None:
        """Return to the penalty that was asked for."""
        self.of_islands("penalty_level")[:] = self.of_islands("slow_steps")[:] = 0.0

    def count(self, name: str, number: int = 1) -> None:
        """Add to a counter of the head."""
        self.head[name] += number

    def book(self, account: str, amount: float) -> None:
        """Add to an account of the energy ledger [J]."""
        high, low = (np.array(self.head[name]) for name in (account, f"{account}_low"))
        add(high, low, amount)
        self.head[account], self.head[f"{account}_low"] = float(high), float(low)
