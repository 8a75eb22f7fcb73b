"""Small swings of a hanging chain: zeros of Laguerre's polynomials, and Bessel's in the limit.

N equal masses on N massless links of length l, counted from the lowest: the k-th moves by
L_k(x)/L_0 with (k + 1) L_(k+1) = (2 k + 1 - x) L_k - k L_(k-1), where x = w^2 l/g, and the nail
stands still, L_N(x) = 0. With n = 4 N + 2 the k-th zero of L_N is j_k^2/n (1 + (j_k^2 - 2)/(3 n^2)
+ ...) (Abramowitz and Stegun 22.16.8), thus with a chain of length H = N l

    w_k = j_k/2 sqrt(g/H) (1 + 1/(2 N))^(-1/2) (1 + (j_k^2 - 2)/(96 N^2) + ...),

Bernoulli's w = j/2 sqrt(g/H) with a correction of -1/(4 N): each mass hangs at the lower end of its
link, so that the chain is as one that is half a link longer.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.special import eval_laguerre, jn_zeros, roots_laguerre

from tests.support.mechanisms.mechanism_runs import run
from tests.support.mechanisms.problems import Content, mechanism, rods, scene
from tests.support.mechanisms.reduced_models import Array

GRAVITY, HEIGHT = 9.81, 1.0


def swing(n: int, mode: int, size: float) -> Content:
    """Chain at rest in the shape of a mode, its lowest mass `size` [m] to the side."""
    x = roots_laguerre(n)[0][mode]
    aside = size * eval_laguerre(np.arange(n, -1, -1), x)
    aside[0] = 0.0
    link = HEIGHT / n
    points: Content = {"P0": {"position": [0.0, 0.0], "fixed": True}}
    y = 0.0
    for k in range(1, n + 1):
        y -= math.sqrt(link**2 - (aside[k] - aside[k - 1]) ** 2)
        points[f"P{k}"] = {"position": [float(aside[k]), y], "mass": 1.0 / n}
    pairs = ((f"P{k - 1}", f"P{k}") for k in range(1, n + 1))
    return mechanism("swing", 2, points=points, joints=rods(pairs))


def frequency(n: int, mode: int) -> float:
    """Of the chain that swings in a mode [rad/s], from where its lowest mass is then.

    From x = x_0 cos(w t) after a quarter of the continuous chain's period, where x is steepest.
    """
    size = 1e-4
    quarter = math.pi / jn_zeros(0, mode + 1)[mode] / math.sqrt(GRAVITY / HEIGHT)
    start, end = run(scene(swing(n, mode, size)), [f"P{n}.x"], quarter / 60, quarter, order=4)[:, 0]
    return math.acos(end / start) / quarter


@pytest.mark.parametrize(("n", "mode"), [(10, 0), (40, 0), (40, 1)])
def test_a_chain_swings_at_the_zeros_of_laguerres_polynomials(n: int, mode: int) -> None:
    # 1e-4 m lean the lowest link by 8e-4 rad at most: its square over 16, and errors of order 4.
    x = roots_laguerre(n)[0][mode]
    assert frequency(n, mode) == pytest.approx(math.sqrt(x * n * GRAVITY / HEIGHT), rel=1e-7)


def test_a_chain_of_many_links_swings_as_bessels_with_half_a_link_more() -> None:
    bessel = jn_zeros(0, 1)[0] / 2 * math.sqrt(GRAVITY / HEIGHT)
    links = np.array([10, 20, 40, 80])
    ratio: Array = np.array([frequency(int(n), 0) for n in links]) / bessel
    assert np.all(np.abs(ratio - (1 - 1 / (4 * links))) < 0.2 / links**2)
    left = (ratio * np.sqrt(1 + 1 / (2 * links)) - 1) * links**2
    assert left == pytest.approx((jn_zeros(0, 1)[0] ** 2 - 2) / 96, rel=1 / links[0])
    assert left[-1] == pytest.approx((jn_zeros(0, 1)[0] ** 2 - 2) / 96, rel=1 / links[-1])
