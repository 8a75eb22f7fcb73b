"""Oracles of the mechanisms in fewest coordinates, by DOP853 at 1e-12; nothing of the solver.

Attitudes are rotation matrices (n, 3, 3) whose columns are the body's axes.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import solve_ivp
from scipy.special import ellipk

Array = NDArray[np.float64]

TOLERANCE = 1e-12


def integrate(rates: Callable[[Array], Array], y0: Sequence[float] | Array, times: Array) -> Array:
    """Solution (len(times), n) of the autonomous equations y' = rates(y)."""
    solution = solve_ivp(
        lambda _, y: rates(y), (0.0, times[-1]), y0, method="DOP853", t_eval=times,
        rtol=TOLERANCE, atol=TOLERANCE,
    )  # fmt: skip
    assert solution.success, solution.message
    return solution.y.T


# -------------------------------------------------------------------------------- bodies that spin


def rotation(vector: Sequence[float] | Array) -> Array:
    """Rotation matrix of a rotation vector [rad], by Rodrigues' formula."""
    angle = float(np.linalg.norm(vector))
    if angle == 0.0:
        return np.eye(3)
    x, y, z = np.asarray(vector) / angle
    K = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + math.sin(angle) * K + (1 - math.cos(angle)) * K @ K


def matrix_of(q: Array) -> Array:
    """Rotation matrix of a quaternion w, x, y, z of any length."""
    w, x, y, z = q / np.linalg.norm(q)
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def quaternion_of(R: Array) -> Array:
    """Quaternion w, x, y, z of a rotation by less than 180 degrees."""
    w = 0.5 * math.sqrt(1.0 + np.trace(R))
    return np.array([w, *(R[[2, 0, 1], [1, 2, 0]] - R[[1, 2, 0], [2, 0, 1]]) / (4 * w)])


def quaternion_rates(q: Array, omega: Array) -> Array:
    """Rates q omega/2 for the angular velocity in body axes [rad/s]."""
    w, v = q[0], q[1:]
    return 0.5 * np.array([-v @ omega, *(w * omega + np.cross(v, omega))])


@dataclass(frozen=True)
class Top:
    """A body on a fixed tip: J omega' = J omega x omega + m c x R'g, omega in body axes.

    `inertia` (3,) [kg.m2] about the tip, principal; `moment` m c (3,) [kg.m] in body axes;
    `gravity` (3,) [m/s2].
    """

    inertia: Array
    moment: Array
    gravity: Array

    def motion(self, R0: Array, omega0: Array, times: Array) -> tuple[Array, Array]:
        """Attitudes (n, 3, 3) and angular velocities (n, 3) in body axes."""

        def rates(y: Array) -> Array:
            q, omega = y[:4], y[4:]
            torque = np.cross(self.moment, matrix_of(q).T @ self.gravity)
            slope = (np.cross(self.inertia * omega, omega) + torque) / self.inertia
            return np.concatenate([quaternion_rates(q, omega), slope])

        y = integrate(rates, np.concatenate([quaternion_of(R0), omega0]), times)
        return np.array([matrix_of(q) for q in y[:, :4]]), y[:, 4:]

    def energy(self, R: Array, omega: Array) -> float:
        """Kinetic energy and that of gravity [J]."""
        return float(0.5 * omega @ (self.inertia * omega) - self.gravity @ R @ self.moment)


def heavy_top() -> Top:
    """Top of Simo and Wong (1991): 5, 5, 1 kg.m2 about the tip, m g l = 20 N.m."""
    return Top(np.array([5.0, 5.0, 1.0]), np.array([0.0, 0.0, 1.0]), np.array([0.0, 0.0, -20.0]))


def turn_over_time(inertia: Array, omega: Array) -> float:
    """Time between sign changes of the middle angular velocity of a free body [s].

    2 K(m)/p; the formulas are for L^2 > 2 T J2, otherwise with the first and third axis swapped
    (Landau and Lifshitz, Mechanics, section 37).
    """
    first, middle, third = inertia
    T2, L2 = float(omega**2 @ inertia), float(omega**2 @ inertia**2)
    if T2 * middle > L2:
        first, third = third, first
    p2 = (third - middle) * (L2 - T2 * first) / (first * middle * third)
    m = (middle - first) * (T2 * third - L2) / ((third - middle) * (L2 - T2 * first))
    return float(2 * ellipk(m) / math.sqrt(p2))


# -------------------------------------------------------------------------------- flyball governor


@dataclass(frozen=True)
class Governor:
    """A05 of the IFToMM benchmark in the angle a of the rods below the horizontal and the height s.

    The shaft's turning follows from its moment of momentum, I(a) w = p. Masses [kg] of a rod, a
    ball and the slider; density 3000 kg/m3, g = 9.81 m/s2.
    """

    rod: float = 0.3
    ball: float = 5.0
    slider: float = 3.0
    stiffness: float = 8e5
    damping: float = 4e4
    gravity: float = 9.81

    def about_axis(self, a: float) -> tuple[float, float]:
        """Moment of inertia about the shaft [kg.m2], and its derivative by the angle."""
        c, s = math.cos(a), math.sin(a)
        across, along = self.rod * 1.0001 / 12, self.rod * 2e-4 / 12
        both = self.rod * (0.05 + 0.5 * c) ** 2 + self.ball * (0.05 + c) ** 2
        slope = -self.rod * (0.05 + 0.5 * c) * s - 2 * self.ball * (0.05 + c) * s
        inertia = both + across * c**2 + along * s**2
        fixed = self.slider * 0.02 / 12 + self.rod * 2e-4 / 12
        return fixed + 2 * inertia, 2 * (slope + 2 * (along - across) * s * c)

    def motion(self, times: Array, speed: float = 2 * math.pi) -> Array:
        """Height [m], angle [rad], their rates, and the turning of the shaft [rad], (n, 5)."""
        momentum = self.about_axis(math.pi / 6)[0] * speed
        of_angle = 2 * (self.rod / 4 + self.ball + self.rod * 1.0001 / 12)
        weight = 2 * self.gravity * (0.5 * self.rod + self.ball)

        def rates(y: Array) -> Array:
            s, a, ds, da, _ = y
            x, z = 0.5 * math.cos(a), 1 - 0.5 * math.sin(a) - s
            length = math.hypot(x, z)
            along_a = (-x * 0.5 * math.sin(a) - z * x) / length
            along_s = -z / length
            rate = along_a * da + along_s * ds
            pull = 2 * (self.stiffness * (length - 0.5) + self.damping * rate)
            inertia, slope = self.about_axis(a)
            turning = momentum / inertia
            dda = (0.5 * turning**2 * slope + weight * math.cos(a) - pull * along_a) / of_angle
            dds = -self.gravity - pull * along_s / self.slider
            return np.array([ds, da, dds, dda, turning])

        return integrate(rates, [0.5, math.pi / 6, 0.0, 0.0, 0.0], times)


# --------------------------------------------------------------------------------- planar linkages


def bars_in_motion(
    points: dict[str, Array],
    fixed: set[str],
    bars: Sequence[tuple[str, str, float]],
    spring: tuple[str, Array, float, float],
    times: Array,
) -> dict[str, Array]:
    """Motion of uniform bars (two points, mass) from rest, (n, 2) of each point, g = 9.81 m/s2.

    The spring ties a point to a place: stiffness and free length. Rows |p - q|^2 = L^2,
    differentiated twice: M a + G'mu = f, G a = -2 |p' - q'|^2.
    """
    names = list(points)
    n = len(names)
    M, f = np.zeros((n, n)), np.zeros((n, 2))
    ends = [(names.index(p), names.index(q), mass) for p, q, mass in bars]
    for i, j, mass in ends:
        M[np.ix_([i, j], [i, j])] += mass / 6 * np.array([[2, 1], [1, 2]])
        f[[i, j], 1] -= 0.5 * mass * 9.81
    free = np.array(
        [2 * i + k for i, name in enumerate(names) if name not in fixed for k in (0, 1)]
    )
    heavy = np.kron(M, np.eye(2))[np.ix_(free, free)]
    tied, place, stiffness, free_length = spring

    def rates(y: Array) -> Array:
        q, v = y[: 2 * n].reshape(n, 2), y[2 * n :].reshape(n, 2)
        load = f.copy()
        pull = place - q[names.index(tied)]
        length = float(np.linalg.norm(pull))
        load[names.index(tied)] += stiffness * (length - free_length) * pull / length
        G, right = np.zeros((len(ends), n, 2)), np.zeros(len(ends))
        for row, (i, j, _) in enumerate(ends):
            G[row, i], G[row, j] = 2 * (q[i] - q[j]), 2 * (q[j] - q[i])
            right[row] = -2 * (v[i] - v[j]) @ (v[i] - v[j])
        G_free = G.reshape(len(ends), -1)[:, free]
        none = np.zeros((len(ends), len(ends)))
        K = np.block([[heavy, G_free.T], [G_free, none]])
        slope = np.zeros(2 * n)
        slope[free] = np.linalg.solve(K, np.concatenate([load.ravel()[free], right]))[: len(free)]
        return np.concatenate([y[2 * n :], slope])

    q0 = np.concatenate([points[name] for name in names])
    y = integrate(rates, np.concatenate([q0, np.zeros(2 * n)]), times)
    return {name: y[:, 2 * i : 2 * i + 2] for i, name in enumerate(names)}
