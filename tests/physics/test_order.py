"""Accuracy against exact solutions: pairs of half steps are of second order."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.special import ellipk

from tests.support.kernel.kernel_calls import kernel_of
from tests.support.mechanisms.problems import (
    GRAVITY,
    Motion,
    double_pendulum,
    move,
    observed_order,
    pendulum,
    start,
)

STEPS = [0.02, 0.01, 0.005, 0.0025]


def swing(h: float, stop: float = 2.0) -> Motion:
    """Double pendulum from 30 degrees: regular motion, so that errors are those of the step."""
    return move(start(double_pendulum(math.pi / 6), h=h), h, round(stop / h))


def test_velocities_leave_the_constraints_by_a_second_order_term_that_does_not_grow():
    # G v is a smooth part h^2/8 d(v'Hv)/dt and one that changes sign every step; neither is damped,
    # neither drifts.
    normal = [np.abs(swing(h).phi_dot).max() for h in STEPS]
    assert observed_order(STEPS, normal) == pytest.approx(2.0, abs=0.05)
    later = np.abs(swing(0.01, stop=20.0).phi_dot)
    assert later[1000:].max() < 1.5 * later[:1000].max()


def test_pairs_move_velocities_smoothly_where_half_steps_reflect_them():
    # The second difference of G v is h^2 (G v)'' = O(h^4) when smooth, four times the alternating
    # part = O(h^2) when not. A start in motion excites that part, a start from rest does not.
    def roughness(h: float, *, every: int) -> float:
        run = start(pendulum(1.0, 2.0), h=2.0 * h)
        rates = [kernel_of(run).residuals()[1]]
        for k in range(round(2 / h)):
            assert kernel_of(run).half_step(h, k % 2) == 0
            rates.append(kernel_of(run).residuals()[1])
        return float(np.abs(np.diff(rates[::every], n=2, axis=0)).max())

    halves, pairs = ([roughness(h, every=every) for h in STEPS] for every in (1, 2))
    assert observed_order(STEPS, halves) == pytest.approx(2.0, abs=0.1)
    assert observed_order(STEPS, pairs) == pytest.approx(4.0, abs=0.2)


# ------------------------------------------------------------------------------- published motions

PENDULUM_A01 = {
    1.0: (0.986291751131875, -0.165010853125541),
    2.0: (-0.793566195343322, -0.608483930443791),
    10.0: (-0.275087462576117, -0.961419205099125),
}
"""Positions of the IFToMM benchmark's pendulum A01 at t [s]; closed form in elliptic functions."""

DOUBLE_PENDULUM = {
    1.0: (-0.585168391999, -0.810911803469, -1.444818849943, -1.321794461381),
    2.0: (-0.4644128687, -0.885618816075, -1.434124817464, -1.129870195647),
    5.0: (-0.586869209816, -0.809681746472, -1.55077846947, -1.075912734813),
}
"""Double pendulum from the horizontal: (x1, y1, x2, y2) at t [s], by DOP853, 12 digits."""

PERIODS = {
    10: 2.0098926272986,
    30: 2.0409898895191,
    60: 2.1528746668805,
    90: 2.3678419475762375,
    120: 2.7540898288879,
    170: 4.8935242741055,
}
"""Period [s] of the unit pendulum by its amplitude in degrees: 4 sqrt(L/g) K(sin^2(theta/2))."""


def richardson(coarse: np.ndarray, fine: np.ndarray) -> np.ndarray:
    """Limit of a second-order method from two steps, one half of the other."""
    return (4 * fine - coarse) / 3


@pytest.mark.parametrize("t", PENDULUM_A01)
def test_the_pendulum_of_the_iftomm_benchmark_is_met(t):
    # Error h^2 times 7 at most over 10 s; half the step, a quarter of the error; the extrapolated
    # value keeps the h^4 term, (0.01 * 5)^4 over some ten swings.
    def position(h: float) -> np.ndarray:
        return move(start(pendulum(-math.pi / 2), h=h), t, 1).q[-1, 0]

    coarse, fine = position(0.01), position(0.005)
    exact = np.array(PENDULUM_A01[t])
    assert np.abs(coarse - exact).max() < 7 * 0.01**2 * t
    assert np.linalg.norm(coarse - exact) / np.linalg.norm(fine - exact) == pytest.approx(
        4, abs=0.1
    )
    assert richardson(coarse, fine) == pytest.approx(exact, abs=1e-5)


@pytest.mark.parametrize("t", DOUBLE_PENDULUM)
def test_the_double_pendulum_from_the_horizontal_is_met(t):
    # Chaotic: errors grow by some e^(2 t), so the step is small and the longest run the least
    # exact.
    def position(h: float) -> np.ndarray:
        return move(start(double_pendulum(), h=h), t, 1).q[-1].ravel()

    coarse, fine = position(1e-3), position(5e-4)
    exact = np.array(DOUBLE_PENDULUM[t])
    assert np.linalg.norm(coarse - exact) / np.linalg.norm(fine - exact) == pytest.approx(
        4, abs=0.1
    )
    assert richardson(coarse, fine) == pytest.approx(exact, abs=1e-6)


@pytest.mark.parametrize("degrees", PERIODS)
def test_the_period_of_a_pendulum_depends_on_its_amplitude_as_an_elliptic_integral(degrees):
    amplitude, period = math.radians(degrees), PERIODS[degrees]
    assert period == pytest.approx(
        4 / math.sqrt(GRAVITY) * ellipk(math.sin(amplitude / 2) ** 2), rel=1e-12
    )

    def measured(n: int) -> float:
        h = period / n
        motion = move(start(pendulum(amplitude), h=h), h, n // 2)
        x = motion.q[:, 0, 0]
        k = int(
            np.flatnonzero((x[:-1] > 0) & (x[1:] <= 0))[0]
        )  # lowest place: a quarter of a period
        near = slice(k - 2, k + 4)
        return 4 * crossing(motion.t[near], x[near])

    errors = [abs(measured(n) - period) for n in (200, 400, 800)]
    assert observed_order([4, 2, 1], errors) == pytest.approx(2.0, abs=0.1)
    assert errors[-1] < 1e-4 * period


def crossing(t: np.ndarray, x: np.ndarray) -> float:
    """Time at which x is zero, by inverse interpolation of fifth degree."""
    return float(np.polyval(np.polyfit(x / np.ptp(x), t - t[0], 5), 0.0) + t[0])
