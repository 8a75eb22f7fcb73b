"""Problems of the work-precision curves: a mechanism, its equations reduced by hand, its motion."""

from __future__ import annotations

import functools
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from benchmarks.exact import (
    double_pendulum_energy,
    double_pendulum_motion,
    double_pendulum_points,
    double_pendulum_rates,
    four_bar_energy,
    four_bar_motion,
    four_bar_points,
    four_bar_rates,
)
from benchmarks.mechanisms import Content, four_bar, hanging_chain

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, kw_only=True)
class Problem:
    """One mechanism twice: as a scene, and in minimal coordinates y' = rates(t, y)."""

    name: str
    content: Content
    rates: Callable[[float, Sequence[float]], list[float]]
    start: tuple[float, ...]
    energy: Callable[[Array], Array]
    """Energy [J] of states, shape (len(start), n)."""
    points: Callable[[Sequence[float]], tuple[Array, Array]]
    """Positions and velocities of all moving points of the scene, from a state."""
    exact: Callable[[float], tuple[Array, Array]]
    """The same at a time, known independently."""


def double_pendulum(angle: float, words: str) -> Problem:
    """Both rods at `angle` from the vertical, at rest."""

    @functools.cache
    def exact(t: float) -> tuple[Array, Array]:
        a, b, da, db = double_pendulum_motion(angle, t)
        return double_pendulum_points((float(a), float(b), float(da), float(db)))

    return Problem(
        name=f"double pendulum, {words}",
        content=hanging_chain(2, angle),
        rates=double_pendulum_rates,
        start=(angle, angle, 0.0, 0.0),
        energy=double_pendulum_energy,
        points=double_pendulum_points,
        exact=exact,
    )


def two_loop_four_bar() -> Problem:
    """Three parallel cranks, that is, one degree of freedom (IFToMM benchmark A02)."""

    def points(y: Sequence[float]) -> tuple[Array, Array]:
        place, velocity = four_bar_points(*y)
        pivots = np.array([[0.0, 0.0], [1.0, 0.0], [2.0, 0.0]])
        return pivots + place, np.repeat(velocity, 3, axis=0)

    return Problem(
        name="four-bar",
        content=four_bar(2),
        rates=four_bar_rates,
        start=(0.0, 1.0),
        energy=four_bar_energy,
        points=points,
        exact=lambda t: points(four_bar_motion(t)),
    )


def all_problems() -> list[Problem]:
    """Problems of the page, in its order."""
    return [
        double_pendulum(math.pi / 6, "both rods at 30° from the vertical"),
        double_pendulum(math.pi / 2, "from the horizontal"),
        two_loop_four_bar(),
    ]
