"""Bodies that spin: the heavy top, the sleeping top and Dzhanibekov's body."""

from __future__ import annotations

import numpy as np
import pytest

import solver
from tests.support.mechanisms.mechanism_runs import extrapolated, run, scene, times, vector
from tests.support.mechanisms.reduced_models import Array, Top, turn_over_time

NOSE = vector("top.nose")
NOSE_AT_2_S = (0.03801721, -0.03291846, 0.99873473)
"""By DOP853 at 1e-13 in an earlier program; a check of the oracle here."""
FREE = Top(np.array([1.0, 2.0, 3.0]), np.zeros(3), np.zeros(3))
PUSHED = 5.0 * np.array([1e-3, 1.0, 1e-3])


def test_the_heavy_top_is_where_it_must_be():
    # 50 rad/s times 0.005 s is 0.25 rad in a step: 2e-5 of error, of second order.
    assert run("heavy_top", NOSE, 0.005, 2.0)[-1] == pytest.approx(NOSE_AT_2_S, abs=2.5e-5)
    assert extrapolated("heavy_top", NOSE, 0.005, 2.0)[-1] == pytest.approx(NOSE_AT_2_S, abs=1e-7)


def swing_of(spin: float, h: float, stop: float, every: float) -> Array:
    """Sine of the tilt of the sleeping top."""
    found = solver.simulate(
        scene("sleeping_top"), stop_time=stop, step_size=every, internal_step=h,
        parameters={"spin": spin}, outputs=["swing"],
    )  # fmt: skip
    return found["swing"]


@pytest.mark.parametrize(("spin", "asleep"), [(25.0, True), (21.0, True), (15.0, False)])
def test_a_top_sleeps_above_twenty_radians_a_second(spin, asleep):
    swing = swing_of(spin, 0.01, 10.0, every=0.1)
    if asleep:
        assert swing.max() < 0.02
    else:
        assert swing.max() > 0.5


def spin_about_the_middle_axis(h: float, stop: float) -> tuple[Array, Array]:
    names = [*vector("nut.wing"), *vector("nut", "w")]
    values = run("dzhanibekov", names, h, stop, every=0.01)
    return times(stop, 0.01), np.einsum("ni,ni->n", values[:, :3], values[:, 3:])


def sign_changes(t: Array, value: Array) -> Array:
    """Times of sign changes; the middle one turns at most 7 rad/s in 0.01 s: straight to 1e-5."""
    i = np.flatnonzero(np.diff(np.sign(value)))
    return t[i] - value[i] * (t[i + 1] - t[i]) / (value[i + 1] - value[i])


def test_dzhanibekovs_body_turns_over_in_the_time_of_the_elliptic_integral():
    found = [np.diff(sign_changes(*spin_about_the_middle_axis(h, 20.0))) for h in (0.01, 0.005)]
    exact = turn_over_time(FREE.inertia, PUSHED)
    assert len(found[1]) == 3
    assert (4 * found[1] - found[0]) / 3 == pytest.approx(exact, abs=2e-5)


def test_the_quaternion_of_a_tumbling_body_is_continuous_and_of_length_one():
    q = run("dzhanibekov", [f"nut.q{part}" for part in "wxyz"], 0.01, 20.0, every=0.02)
    assert np.einsum("ni,ni->n", q[1:], q[:-1]).min() > 0.99
    assert np.linalg.norm(q, axis=1) == pytest.approx(1.0, rel=1e-15)
