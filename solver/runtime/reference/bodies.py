"""Orientation of bodies in space: unit quaternions (w, x, y, z) of R = [d1 d2 d3], and their rates.

A quaternion and its negative are the same orientation; the sign that is next to the last one is
taken, so that components are continuous in time.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def quaternion(R: Array, near: Array) -> Array:
    """Quaternion of the rotation R (3, 3) with `near` . quaternion >= 0 (Shepperd 1978).

    Begins with the largest of its components, which is a root far from zero.
    """
    trace = np.trace(R)
    squares = np.array([trace, *np.diag(R)])
    largest = int(np.argmax(squares))
    if largest == 0:
        parts = [1.0 + trace, R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]]
    else:
        i = largest - 1
        j, k = (i + 1) % 3, (i + 2) % 3
        parts = [R[k, j] - R[j, k], 0.0, 0.0, 0.0]
        parts[1 + i] = 1.0 + 2.0 * R[i, i] - trace
        parts[1 + j], parts[1 + k] = R[j, i] + R[i, j], R[k, i] + R[i, k]
    turned = np.array(parts) / np.linalg.norm(parts)
    return turned if turned @ near >= 0.0 else -turned


def directors(x: Array, node: int) -> Array:
    """Directors of a body as rows, from the coordinates or velocities of all nodes."""
    return x[3 * node : 3 * node + 9].reshape(3, 3)


def angular_velocity(d: Array, v: Array) -> Array:
    """Angular velocity sum d_i x v_i/2 [rad/s]."""
    return 0.5 * np.cross(d, v).sum(axis=0)
