"""What moves in the outputs of a run: how large it is, whether it does, how far runs are apart.

Also whether velocities follow the constraints: they do not after a driver that jumps.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

STILL = 1e-9
"""Motions below this are round-off: over the largest coordinate, or in rad."""
OF_THE_SOLUTION = ("energy.balance", "energy.error", "constraint.", "solver.")
"""Beginnings of the names of outputs that say how exact a run is, not how it moves."""

RESIDUAL = "constraint.velocity"
LARGEST_SHARE = 0.1
"""Of the fastest motion; all scenes stay below 0.006, after a jump it is 1 and more."""
SMALLEST = 1e-9
"""Coordinates in m below this tell nothing about the size of a mechanism."""
ROUND_OFF = 1e-6
"""Residual in 1/s below which nothing is said: what stands still moves by round-off."""


def largest_by_unit(
    units: Mapping[str, str | None], sizes: Mapping[str, float]
) -> dict[str, float]:
    """Return the largest size of what moves, by unit; `units` and `sizes` are by output."""
    largest: dict[str, float] = {}
    for name, size in sizes.items():
        unit = units[name]
        if unit and not name.startswith(OF_THE_SOLUTION):
            largest[unit] = max(largest.get(unit, 0.0), size)
    return dict(sorted(largest.items()))


def largest_residual(by_unit: Mapping[str, float]) -> float:
    """Return what the residual of the velocities may be [1/s].

    `by_unit` has the largest sizes of outputs of the run, by unit. A speed counts by the largest
    coordinate, where one is not round-off.
    """
    size = by_unit.get("m", 0.0)
    speed = by_unit.get("m/s", 0.0) / size if size > SMALLEST else 0.0
    fastest = max(by_unit.get("rad/s", 0.0), speed)
    return LARGEST_SHARE * fastest + ROUND_OFF


def lag_of_velocities(
    largest: float, by_unit: Mapping[str, float], jumps: Callable[[], bool]
) -> str:
    """Return a sentence about the largest residual of a run [1/s]; empty if it may be as large.

    `jumps` finds whether a driver or a constraint jumps.
    """
    limit = largest_residual(by_unit)
    if not largest > limit:
        return ""
    remedy = (
        "look for a driver or a constraint whose value or rate jumps, and let it go smoothly"
        if jumps()
        else "set a solver.tolerance, or a shorter solver.step_size"
    )
    return (
        f"velocities do not follow the constraints: {RESIDUAL} reaches {largest:.2g} 1/s, and "
        f"{limit:.2g} would be a tenth of the fastest motion; {remedy}"
    )


def quaternions_among(units: Mapping[str, Any]) -> list[list[str]]:
    """Return the four names of each quaternion, from the units of all outputs by name."""
    turned = [x[:-1] for x, unit in units.items() if x.endswith(".qw") and unit]
    found = [[f"{x}{k}" for k in "wxyz"] for x in turned]
    return [names for names in found if units.keys() >= {*names}]


def rotation_between(p: np.ndarray, q: np.ndarray) -> np.ndarray:
    """Return the angle of the rotation between orientations [rad], of quaternions (..., 4).

    |p - q| = 2 sin(angle/4); the sign of a quaternion means nothing.
    """
    chord = np.minimum(np.linalg.norm(p - q, axis=-1), np.linalg.norm(p + q, axis=-1))
    return 4.0 * np.arcsin(np.minimum(0.5 * chord, 1.0))


class Poses:
    """Which outputs are positions, angles and quaternions.

    `names` are theirs, and an array of poses has a row for each time and a column for each name.
    """

    def __init__(self, units: Mapping[str, Any]) -> None:
        """Take the units of all outputs, by name."""
        positions = [x for x, unit in units.items() if unit == "m" and x[-2:] in (".x", ".y", ".z")]
        angles = [x for x, unit in units.items() if unit == "rad" and x.endswith(".angle")]
        quaternions = quaternions_among(units)
        self.names = [*positions, *angles, *(name for names in quaternions for name in names)]
        self._ends = [len(positions), len(positions) + len(angles)]
        self.turn = len(self.names) > len(positions)
        """Whether there is any angle or orientation."""

    def apart(self, a: np.ndarray, b: np.ndarray) -> tuple[float, float]:
        """Return the largest difference of a coordinate [m], and of a turn or orientation [rad]."""
        count = (len(self.names) - self._ends[1]) // 4
        p, q = (x[:, self._ends[1] :].reshape(len(x), count, 4) for x in (a, b))
        rotation = rotation_between(p, q)
        off, angle, _ = np.split(abs(a - b), self._ends, axis=1)
        return float(off.max(initial=0.0)), float(angle.max(initial=rotation.max(initial=0.0)))

    def moved(self, poses: np.ndarray) -> bool:
        """Whether anything moved since the first row; True of an FMU that has no poses."""
        position, angle = self.apart(poses, poses[:1])
        size = float(abs(poses[:, : self._ends[0]]).max(initial=0.0))
        return not self.names or position > STILL * size or angle > STILL


LOSSES = {f"energy.{cause}": cause for cause in ("damping", "friction", "impact")}
"""Outputs of a mechanism with contacts or friction, and the causes that take energy out."""


def losses(ends: Mapping[str, float]) -> dict[str, float]:
    """Energy that each cause has taken out [J], from the outputs at the end of a run."""
    return {cause: ends[name] for name, cause in LOSSES.items() if name in ends}
