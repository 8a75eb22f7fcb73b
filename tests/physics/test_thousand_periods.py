"""A thousand periods: phase and amplitudes with equal steps, and under a tolerance.

Compositions of equal steps are symmetric, so that their phase error grows with time alone, and no
amplitude with it. Right values: elliptic functions by mpmath, and DOP853 at 1e-13.
"""

from __future__ import annotations

import math

import mpmath
import numpy as np
import pytest

import solver
from tests.support.mechanisms.mechanism_runs import scene

SPRING = """
name = "spring"
dimension = 2
[points]
A = { position = [1.2, 0], mass = 1.0 }
[forces]
s = { type = "spring", points = ["ground", "A"], at = [0, 0], stiffness = 100, free_length = 1 }
"""


def ends(text: str | solver.Scene, names: list[str], stop: float, step: float, **settings: float):
    """Values at all communication points."""
    drawn = solver.loads(text) if isinstance(text, str) else text
    table = solver.simulate(drawn, stop_time=stop, step_size=step, outputs=names, **settings)
    return np.array([table[name] for name in names]).T


@pytest.mark.parametrize(
    ("settings", "allowed"),
    [
        ({"order": 8, "internal_step": 0.05}, 3e-6),
        ({"order": 4, "internal_step": 0.02}, 3e-3),
        ({"tolerance": 1e-8}, 3e-8),
    ],
)
def test_a_spring_swings_a_thousand_periods(settings, allowed):
    stop = 1000 * 2.0 * math.pi / 10.0
    x, v = ends(SPRING, ["A.x", "A.vx"], stop, stop / 400, **settings).T
    t = np.linspace(0.0, stop, 401)
    assert x - 1.0 == pytest.approx(0.2 * np.cos(10.0 * t), abs=allowed)
    amplitude = np.hypot(x - 1.0, v / 10.0)
    assert amplitude == pytest.approx(0.2, abs=1e-12)  # of the energy


SWINGS = """
name = "swings"
dimension = 2
[points]
A = { position = [1, 0.3], mass = 1.0 }
[forces]
bowl = { type = "potential", value = "0.5*(A.x**2 + 30*A.y**2)" }
"""
BRAKE = """
[points.B]
position = [5, 0]
velocity = [1, 0]
mass = 1.0
[forces.brake]
type = "damper"
points = ["ground", "B"]
at = [0, 0]
damping = 0.3
"""


READS = BRAKE + '[forces.pull]\ntype = "force"\npoint = "B"\nvalue = ["0.01*A.x", 0]\n'


@pytest.mark.parametrize(
    ("beside", "order", "least", "most"),
    [
        ("", 4, 0.0, 1e-13),
        (BRAKE, 2, 0.0, 1e-13),
        (BRAKE, 4, 0.0, 1e-13),
        (READS, 4, 2e-3, 4e-3),
        (READS, 6, 3e-6, 1e-5),
    ],
)
def test_swings_keep_energy_but_for_dampers_beside_formulas_of_the_motion(
    beside, order, least, most
):
    """Swings of 1 and 30**0.5 rad/s do not know of each other; the page of settings has figures.

    The sum of both energies is kept: what one loses the other one gains.
    """
    names = ["A.x", "A.vx", "A.y", "A.vy"]
    x, vx, y, vy = ends(SWINGS + beside, names, 100.0, 0.1, order=order, internal_step=0.1).T
    slow, fast = 0.5 * (vx**2 + x**2), 0.5 * (vy**2 + 30.0 * y**2)
    assert slow + fast == pytest.approx(0.5 + 1.35, rel=1e-13)
    assert least <= abs(slow[-1] / 0.5 - 1.0) <= most


def nutation(t: float, spin: float = 50, tilt: str = "0.05", push: str = "0") -> mpmath.mpf:
    """Height of the nose of a top by elliptic functions; by default of the heavy top.

    u = cos(theta) of a top with A = 5, C = 1, m g l = 20 obeys u'^2 = (alpha - beta u)(1 - u^2) -
    (b - a u)^2, a = C w_3/A, b = L_z/A, beta = 2 m g l/A. It begins without rate of tilt and of
    precession, or upright with the angular velocity `push` across its spin.
    """
    mpmath.mp.dps = 30
    A, C, weight = 5, 1, 20
    a = mpmath.mpf(C * spin) / A
    beta = mpmath.mpf(2 * weight) / A
    start = mpmath.cos(mpmath.mpf(tilt))
    b, alpha = a * start, beta * start + mpmath.mpf(push) ** 2
    cubic = [alpha - b**2, 2 * a * b - beta, -(alpha + a**2), beta]
    u = sorted(mpmath.polyroots(cubic, maxsteps=200, extraprec=200, asc=True), key=lambda z: z.real)
    low, high, far = (z.real for z in u)
    k2 = (high - low) / (far - low)
    w = mpmath.sqrt(beta * (far - low)) / 2
    sn = mpmath.ellipfun("sn", w * t + mpmath.ellipk(k2), m=k2)
    return low + (high - low) * sn**2


@pytest.mark.parametrize(
    ("settings", "phase"),
    [({"order": 8, "internal_step": 0.02}, 1e-3), ({"tolerance": 1e-7}, 1e-5)],
)
def test_a_heavy_top_nutates_a_thousand_periods(settings, phase):
    top = solver.load(scene("heavy_top"))
    stop = 1000 * 2.0 * math.pi / 10.0
    step = stop / 1000.0
    height = ends(top, ["top.nose.z"], stop, step, **settings)[-40:, 0]
    exact = np.array([float(nutation(k * step)) for k in range(961, 1001)])
    swing = np.ptp([float(nutation(x)) for x in np.linspace(0.0, 0.7, 50)])
    assert height == pytest.approx(exact, abs=phase * swing)


def test_a_sleeping_top_nutates_a_thousand_periods():
    # Nothing puts its nutation back, of 0.007 rad, and no ledger sees it.
    stop = 1000 * 2.0 * math.pi / 3.0
    settings = {"order": 4, "internal_step": 0.02}
    sine = ends(solver.load(scene("sleeping_top")), ["swing"], stop, stop / 2000, **settings)
    found = sine[-40:, 0] ** 2
    times = (k * stop / 2000 for k in range(1961, 2001))
    exact = np.array([float(1 - nutation(t, 25, "0", "0.01") ** 2) for t in times])
    assert found == pytest.approx(exact, abs=1e-3 * exact.max())


@pytest.mark.parametrize(
    ("settings", "allowed"),
    [({"order": 8, "internal_step": 0.1}, 1e-4), ({"tolerance": 1e-9}, 1e-6)],
)
def test_a_small_double_pendulum_swings_a_thousand_periods(settings, allowed):
    text = """
name = "small"
dimension = 2
gravity = [0, -9.81]
[points]
O = { position = [0, 0], fixed = true }
A = { position = ["sin(0.1)", "-cos(0.1)"], mass = 1.0 }
B = { position = ["2*sin(0.1)", "-2*cos(0.1)"], mass = 1.0 }
[joints]
upper = { type = "distance", points = ["O", "A"] }
lower = { type = "distance", points = ["A", "B"] }
"""
    stop = 2621.0524300890147
    found = ends(text, ["A.x", "B.x"], stop, stop / 10, **settings)
    # SciPy's DOP853 at 1e-13, as in double_pendulum_motion of exact_motions.py, which takes 17 s.
    exact = [[-0.0693888956038479, -0.20299768050599348]]
    exact += [[-0.07622932992996996, -0.15912985436481772]]
    assert found[-2:] == pytest.approx(np.array(exact), abs=allowed)
