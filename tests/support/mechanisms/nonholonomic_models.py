"""Oracles of mechanisms with rows of velocities: rolling disc, Chaplygin's sleigh, snakeboard."""

from __future__ import annotations

import math

import numpy as np

from tests.support.mechanisms.reduced_models import Array, integrate


def snakeboard(times: Array) -> Array:
    """x, y [m] and angle [rad] of the board of `scenes/snakeboard.toml`, (n, 3), from rest.

    M q'' + A'mu = -J_r psi'' e_3 and A q'' = -A' q' with rows of the trucks' angles a = theta -+
    s cos(w t): x' sin a - y' cos a -+ b theta' cos(a - theta) = 0.
    """
    half, steer, swing, omega = 0.25, 0.4, 0.7, 3.0
    of_rotor = 0.1
    M = np.diag([6.0, 6.0, 0.1 + of_rotor + 2 * (0.002 + 0.5 * half**2)])

    def rates(y: Array) -> Array:
        theta, v, t = y[2], y[3:6], y[6]
        K, right = np.zeros((5, 5)), np.zeros(5)
        K[:3, :3] = M
        right[2] = -of_rotor * swing * omega**2 * math.cos(omega * t)
        for row, sign in ((3, 1.0), (4, -1.0)):
            turned = -sign * steer * math.cos(omega * t)
            turning = sign * steer * omega * math.sin(omega * t)
            s, c = math.sin(theta + turned), math.cos(theta + turned)
            lever = sign * half * math.cos(turned)
            K[row, :3] = K[:3, row] = [s, -c, -lever]
            bent = np.array([c, s, 0.0]) * (v[2] + turning)
            bent[2] = sign * half * math.sin(turned) * turning
            right[row] = -bent @ v
        return np.concatenate([v, np.linalg.solve(K, right)[:3], [1.0]])

    return integrate(rates, np.zeros(7), times)[:, :3]
