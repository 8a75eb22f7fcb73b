"""What bodies that fly freely keep, whatever joins them."""

from __future__ import annotations

import numpy as np

import solver


def assert_nothing_is_lost(run: solver.Trajectory, dimension: int) -> None:
    """Energy and momenta to 1e-11 of their own size, constraints to 1e-12, all along a run."""
    energy = run["energy.total"]
    assert np.ptp(energy) < 1e-11 * energy[0]
    assert np.max(run["constraint.position"]) < 1e-12
    axes, turning = ("xy", "z") if dimension == 2 else ("xyz", "xyz")
    for name, parts in (("momentum", axes), ("angular_momentum", turning)):
        vector = np.stack([run[f"{name}.{axis}"] for axis in parts])
        drift = np.max(np.abs(vector - vector[:, :1]))
        assert drift < 1e-11 * np.linalg.norm(vector[:, 0])
