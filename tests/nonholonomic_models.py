"""Oracles of mechanisms with rows of velocities: rolling disc, Chaplygin's sleigh, snakeboard."""

from __future__ import annotations

import math

import numpy as np

from tests.reduced_models import Array, integrate, matrix_of, quaternion_of, quaternion_rates


def rolling_disc(
    R0: Array, omega0: Array, times: Array, *, radius: float, mass: float, gravity: float
) -> tuple[Array, Array, Array]:
    """Centres (n, 3), attitudes and angular velocities (n, 3), global, of a coin on z = 0.

    Its axis is the body's y; u points from the contact to the centre, n up. Balance of moment of
    momentum about the contact with v = omega x radius u:
    (J + m r^2 (1 - u u')) omega' = J omega x omega - m r u x (r omega x u' + g n).
    """
    n = np.array([0.0, 0.0, 1.0])
    J0 = mass * radius**2 * np.diag([0.25, 0.5, 0.25])

    def rates(y: Array) -> Array:
        q, omega = y[3:7], y[7:]
        R = matrix_of(q)
        e, J = R[:, 1], R @ J0 @ R.T
        de, w = np.cross(omega, e), n - e[2] * e
        u = w / np.linalg.norm(w)
        dw = -de[2] * e - e[2] * de
        du = (dw - (u @ dw) * u) / np.linalg.norm(w)
        load = mass * radius * np.cross(u, radius * np.cross(omega, du) + gravity * n)
        about_contact = J + mass * radius**2 * (np.eye(3) - np.outer(u, u))
        slope = np.linalg.solve(about_contact, np.cross(J @ omega, omega) - load)
        v = np.cross(omega, radius * u)
        return np.concatenate([v, quaternion_rates(q, R.T @ omega), slope])

    e = R0[:, 1]
    u = (n - e[2] * e) / np.linalg.norm(n - e[2] * e)
    y = integrate(rates, np.concatenate([radius * u, quaternion_of(R0), omega0]), times)
    return y[:, :3], np.array([matrix_of(q) for q in y[:, 3:7]]), y[:, 7:]


def chaplygin_sleigh(
    times: Array, *, a: float, mass: float, inertia: float, speed: float, spin: float
) -> Array:
    """x, y [m], angle [rad], speed [m/s] and spin [rad/s] of the knife edge, (n, 5).

    u' = a w^2, w' = -a u w/b^2 with b^2 = inertia/mass + a^2, thus u^2 + b^2 w^2 = c^2 and
    u = c tanh(a c (t - t0)/b^2), w = c/b sech(...), angle = b/a (gd(...) - gd at 0).
    """
    b = math.sqrt(inertia / mass + a**2)
    c = math.hypot(speed, b * spin)
    begin = math.atanh(speed / c)

    def of_time(t: Array) -> tuple[Array, Array, Array]:
        s = begin + a * c / b**2 * np.asarray(t)
        angle = b / a * (2 * np.arctan(np.tanh(s / 2)) - 2 * math.atan(math.tanh(begin / 2)))
        return (
            c * np.tanh(s),
            math.copysign(c / b, spin) / np.cosh(s),
            math.copysign(1, spin) * angle,
        )

    def rates(y: Array) -> Array:
        u, _, angle = of_time(y[2])
        return np.array([u * math.cos(angle), u * math.sin(angle), 1.0])

    u, w, angle = of_time(times)
    path = integrate(rates, [0.0, 0.0, 0.0], times)
    return np.column_stack([path[:, :2], angle, u, w])


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
