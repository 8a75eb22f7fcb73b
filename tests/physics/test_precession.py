"""The heavy top in closed form: steady precession, and the small nutation about it.

A, C are the moments of inertia about the tip, across and along the axis, L = C omega_3. Steady at
the tilt a where A cos a p^2 - L p + m g l = 0; a disturbance goes there and back at the rate W with
W^2 = (L^2 - 4 A m g l cos a)/A^2 + p^2 sin^2 a, from A a'' = A p^2 sin a cos a - L p sin a
+ m g l sin a with the moment A sin^2 a p + L cos a about the vertical kept. For a fast top W = L/A.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

import solver
from tests.support.mechanisms.mechanism_runs import run, times
from tests.support.mechanisms.reduced_models import Array

ACROSS, ALONG, MOMENT = 5.0, 1.0, 20.0
"""A, C [kg.m2] about the tip and m g l [N.m] of Simo and Wong's top."""


def precession(spin: float, tilt: float, root: int) -> float:
    """Rate p of steady precession [rad/s]: the slow one, root -1, or the fast one, +1."""
    L = ALONG * spin
    bent = 4 * ACROSS * MOMENT * math.cos(tilt)
    return (L + root * math.sqrt(L**2 - bent)) / (2 * ACROSS * math.cos(tilt))


def nutation(spin: float, tilt: float, root: int = -1) -> float:
    """Rate W of the small nutation [rad/s]."""
    p, L = precession(spin, tilt, root), ALONG * spin
    return math.sqrt(
        (L**2 - 4 * ACROSS * MOMENT * math.cos(tilt)) / ACROSS**2 + (p * math.sin(tilt)) ** 2
    )


def top(spin: float, tilt: float, turning: float, falling: float) -> solver.Scene:
    """Top that leans towards +x by `tilt` [rad], turns about the vertical and falls [rad/s]."""
    along = spin - turning * math.cos(tilt)
    s, c = math.sin(tilt), math.cos(tilt)
    return solver.loads(f"""
name = "top"
gravity = [0, 0, -20]
[bodies.top]
position = [0, 0, 0]
orientation = {{ axis = [0, 1, 0], angle = {tilt!r} }}
angular_velocity = [{along * s!r}, {falling!r}, {turning + along * c!r}]
mass = 1.0
inertia = [4, 4, 1]
center_of_mass = [0, 0, 1]
points = {{ nose = [0, 0, 1] }}
[joints]
tip = {{ type = "spherical", points = ["ground", "top"], at = [0, 0, 0] }}
""")


def nose(scene: solver.Scene, h: float, stop: float, every: float) -> tuple[Array, Array]:
    """Tilt [rad] and longitude [rad] of the nose, order 8."""
    names = ["top.nose.x", "top.nose.y", "top.nose.z"]
    x, y, z = run(scene, names, h, stop, every=every, order=8).T
    return np.arctan2(np.hypot(x, y), z), np.unwrap(np.arctan2(y, x))


@pytest.mark.parametrize("root", [-1, 1], ids=["slow", "fast"])
@pytest.mark.parametrize(("spin", "tilt"), [(25.0, 0.6), (50.0, 1.0), (10.0, 2.2)])
def test_a_top_that_starts_in_steady_precession_stays_in_it(spin, tilt, root):
    # Errors of eighth order, 0.3 rad a step, over up to two turns: some 1e-11.
    rate = precession(spin, tilt, root)
    step = 0.3 / max(spin, abs(rate), 10.0)
    lean, longitude = nose(top(spin, tilt, rate, 0.0), step, 80 * step, 8 * step)
    assert lean == pytest.approx(tilt, abs=1e-11)
    assert longitude == pytest.approx(rate * times(80 * step, 8 * step), abs=1e-9)


@pytest.mark.parametrize(("spin", "tilt"), [(25.0, 0.6), (50.0, 1.0)])
def test_a_disturbed_top_nutates_at_the_rate_of_the_closed_form(spin, tilt):
    # 1e-4 rad about the steady lean over four periods; the next term is its square, 1e-4 of it.
    size, rate = 1e-4, nutation(spin, tilt)
    period = 2 * math.pi / rate
    scene = top(spin, tilt, precession(spin, tilt, -1), size * rate)
    lean, _ = nose(scene, period / 40, 4 * period, period / 20)
    swing = size * np.sin(rate * times(4 * period, period / 20))
    assert lean - tilt == pytest.approx(swing, abs=1e-3 * size)
