"""Energy, momenta and constraint residuals of a mechanism, calculated here from points alone.

The solver reports the same quantities; these come from the content of the scene and from positions
and velocities, so that a mistake in the solver's own ledger would show.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from benchmarks.problems.mechanisms import Content
from solver.runtime import Integrator

Array = NDArray[np.float64]


class Observer:
    """Reads the points of an integrator; all masses, rods, bars and springs from `content`."""

    def __init__(self, content: Content, integrator: Integrator) -> None:
        self._integrator = integrator
        self._dimension = dimension = content["dimension"]
        points, axes = content["points"], "xyz"[:dimension]
        place = {name: i for i, name in enumerate(points)}
        model = integrator.model
        self._free = [place[name] for name, p in points.items() if not p.get("fixed")]
        free = [name for name, p in points.items() if not p.get("fixed")]
        self._indices = [
            model.index(f"{name}.{kind}{axis}")
            for kind in ("", "v")
            for name in free
            for axis in axes
        ]
        self._start = np.array([p["position"] for p in points.values()], dtype=float)
        self._gravity = np.array(content["gravity"], dtype=float)
        self._mass = _mass_matrix(content, place)
        joints = content.get("joints", {}).values()
        pairs = [part["points"] for part in (*joints, *content.get("bodies", {}).values())]
        self._rods = np.array([[place[a], place[b]] for a, b in pairs])
        lengths = [part.get("length", 0.0) for part in joints]
        lengths += [0.0] * (len(self._rods) - len(lengths))
        drawn = np.linalg.norm(self._stretch(self._start), axis=1)
        self._lengths = np.where(np.array(lengths) > 0.0, lengths, drawn)
        springs = list(content.get("forces", {}).values())
        self._springs = np.array([[place[name] for name in s["points"]] for s in springs], int)
        self._laws = np.array([[s["stiffness"], s["free_length"]] for s in springs]).reshape(-1, 2)

    def _stretch(self, q: Array) -> Array:
        return q[self._rods[:, 1]] - q[self._rods[:, 0]]

    def points(self) -> tuple[Array, Array]:
        """Positions [m] and velocities [m/s] of all points, shape (points, dimension)."""
        values = np.array(self._integrator.get(self._indices), dtype=float)
        moving_q, moving_v = values.reshape(2, len(self._free), self._dimension)
        q, v = self._start.copy(), np.zeros_like(self._start)
        q[self._free], v[self._free] = moving_q, moving_v
        return q, v

    def moving_points(self) -> tuple[Array, Array]:
        """Positions and velocities of the points that are not fixed."""
        q, v = self.points()
        return q[self._free], v[self._free]

    def energy(self) -> float:
        """Kinetic energy, potential energy of gravity and of springs [J]."""
        q, v = self.points()
        energy = 0.5 * float(np.sum(v * (self._mass @ v)))
        energy -= float((self._mass.sum(axis=0) @ q) @ self._gravity)
        if len(self._springs):
            ends = q[self._springs]
            stretch = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1) - self._laws[:, 1]
            energy += 0.5 * float(self._laws[:, 0] @ stretch**2)
        return energy

    def residual(self) -> float:
        """Return the largest relative defect of a rod's squared length."""
        q, _ = self.points()
        squared = np.sum(self._stretch(q) ** 2, axis=1)
        return float(np.max(np.abs(squared - self._lengths**2) / self._lengths**2))

    def momenta(self) -> tuple[Array, Array]:
        """Linear momentum [kg m/s] and angular momentum about the origin [kg m^2/s], in space."""
        q, v = self.points()
        p = self._mass @ v
        return p.sum(axis=0), np.cross(q, p).sum(axis=0)


def _mass_matrix(content: Content, place: dict[str, int]) -> Array:
    """Masses of points; a uniform bar has the consistent mass matrix m/6 [[2, 1], [1, 2]]."""
    mass = np.zeros((len(place), len(place)))
    for name, point in content["points"].items():
        mass[place[name], place[name]] += point.get("mass", 0.0)
    for bar in content.get("bodies", {}).values():
        a, b = (place[name] for name in bar["points"])
        mass[np.ix_([a, b], [a, b])] += bar["mass"] / 6.0 * np.array([[2.0, 1.0], [1.0, 2.0]])
    return mass
