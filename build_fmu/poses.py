"""What moves in the outputs of a run: how large it is, does it move, and how far are runs apart."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from numpy import ndarray

STILL = 1e-9
"""Motions below this are round-off: over the largest coordinate, or in rad."""


OF_THE_SOLUTION = ("energy.balance", "energy.error", "constraint.", "solver.")
"""Beginnings of the names of outputs that say how exact a run is, not how it moves."""


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


class Poses:
    """Which outputs are positions, angles and quaternions.

    `names` are theirs, and an array of poses has a row for each time and a column for each name.
    """

    def __init__(self, units: Mapping[str, Any]) -> None:
        """Take the units of all outputs, by name."""
        positions = [x for x, unit in units.items() if unit == "m" and x[-2:] in (".x", ".y", ".z")]
        angles = [x for x, unit in units.items() if unit == "rad" and x.endswith(".angle")]
        bodies = [
            x.removesuffix(".qw")
            for x, unit in units.items()
            if x[-3:] == ".qw" and unit and all(f"{x[:-1]}{k}" in units for k in "xyz")
        ]
        self.names = [*positions, *angles, *(f"{body}.q{k}" for body in bodies for k in "wxyz")]
        self._positions = slice(len(positions))
        self._angles = slice(len(positions), len(positions) + len(angles))
        self._quaternions = slice(len(positions) + len(angles), None)
        self._bodies = len(bodies)
        self.turn = bool(angles or bodies)
        """Whether there is any angle or orientation."""

    def apart(self, a: ndarray, b: ndarray) -> tuple[float, float]:
        """Return the largest difference of a coordinate [m], and of an angle or orientation [rad].

        That of two orientations is the angle of the rotation between them, |p - q| = 2 sin(angle/4)
        of their quaternions, whose sign means nothing.
        """
        import numpy as np

        p, q = (x[:, self._quaternions].reshape(len(x), self._bodies, 4) for x in (a, b))
        chord = np.minimum(np.linalg.norm(p - q, axis=2), np.linalg.norm(p + q, axis=2))
        turned = 4.0 * np.arcsin(np.minimum(0.5 * chord, 1.0))
        off = abs(a - b)
        angle = off[:, self._angles].max(initial=turned.max(initial=0.0))
        return float(off[:, self._positions].max(initial=0.0)), float(angle)

    def moved(self, poses: ndarray) -> bool:
        """Whether anything moved since the first row; True of an FMU that has no poses."""
        position, angle = self.apart(poses, poses[:1])
        size = float(abs(poses[:, self._positions]).max(initial=0.0))
        return not self.names or position > STILL * size or angle > STILL
