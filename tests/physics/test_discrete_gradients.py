"""Discrete gradients side by side: all keep energy, only the invariant form keeps angular momentum.

Ours against the one of Gonzalez 1996 and the average vector field (mean value), which are written
here in plain NumPy; `tests/paper` has the gradient at an intermediate point (paper, eq 8).
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

import solver
from tests.support.mechanisms.problems import Array, observed_order
from tests.support.mechanisms.work_sums import HalfSteps, vector

# ----------------------------------------------------- a stiff bond of two particles, alpha/2 Phi^2

ALPHA, MASS = 5.0, np.array([1.0, 1.0, 3.0, 3.0])
START = np.array([0.5, 0.1, -0.4, -0.35])
SPEED = np.array([0.4, 0.9, -0.2, -0.3])
"""1 and 3 kg, drawn 1.006 m apart; they turn at 1.3 rad/s and stretch at 0.3 m/s."""

Gradient = Callable[[Array, Array], Array]


def phi(q: Array) -> float:
    """Phi = l^4 - 1."""
    r = q[:2] - q[2:]
    return float(r @ r) ** 2 - 1.0


def slope(q: Array) -> Array:
    """Gradient of Phi."""
    r = q[:2] - q[2:]
    along = 4.0 * (r @ r) * r
    return np.concatenate([along, -along])


def gonzalez_gradient(q_n: Array, q_1: Array) -> Array:
    """Gradient at the midpoint, corrected along M dq until the energy is met."""
    d, middle = q_1 - q_n, 0.5 * (q_n + q_1)
    gradient = ALPHA * phi(middle) * slope(middle)
    change = 0.5 * ALPHA * (phi(q_1) ** 2 - phi(q_n) ** 2)
    size = d @ (MASS * d)
    return gradient if size == 0.0 else gradient + (change - gradient @ d) / size * MASS * d


def average_gradient(q_n: Array, q_1: Array) -> Array:
    """Mean of the gradient over the segment: seventh degree, so that 4 Gauss points are exact."""
    at, weight = np.polynomial.legendre.leggauss(4)
    places = [q_n + 0.5 * (1.0 + s) * (q_1 - q_n) for s in at]
    return 0.5 * sum(w * ALPHA * phi(q) * slope(q) for w, q in zip(weight, places, strict=True))


def conserving_step(gradient: Gradient, q_n: Array, v_n: Array, h: float) -> tuple[Array, Array]:
    """M (v_1 - v_n) + h D(q_n, q_1) = 0 and q_1 - q_n = h (v_n + v_1)/2, by Newton to round-off."""

    def residual(d: Array) -> Array:
        return 2.0 / h * MASS * d - 2.0 * MASS * v_n + h * gradient(q_n, q_n + d)

    d = h * v_n
    columns = [residual(d + e) - residual(d - e) for e in 1e-6 * np.eye(4)]
    inverse = np.linalg.inv(np.transpose(columns) / 2e-6)  # kept: each iteration wins two digits
    for _ in range(10):
        d = d - inverse @ residual(d)
    return q_n + d, 2.0 * d / h - v_n


def bond(gradient: Gradient, h: float, n: int) -> tuple[Array, Array, Array]:
    """Motion (n + 1, 4), energy (n + 1,) and angular momentum (n + 1,)."""
    q, v = START, SPEED
    rows = [(q, v)]
    for _ in range(n):
        q, v = conserving_step(gradient, q, v, h)
        rows.append((q, v))
    q, v = (np.array(column) for column in zip(*rows, strict=True))
    energy = 0.5 * v**2 @ MASS + 0.5 * ALPHA * np.array([phi(x) for x in q]) ** 2
    momentum = MASS * v
    moment = q[:, 0] * momentum[:, 1] - q[:, 1] * momentum[:, 0]
    return q, energy, moment + q[:, 2] * momentum[:, 3] - q[:, 3] * momentum[:, 2]


def bond_of_ours(h: float, n: int) -> HalfSteps:
    """The same bond as a scene."""
    text = f"""
name = "bond"
dimension = 2
[points]
A = {{ position = {START[:2].tolist()}, velocity = {SPEED[:2].tolist()}, mass = 1.0 }}
B = {{ position = {START[2:].tolist()}, velocity = {SPEED[2:].tolist()}, mass = 3.0 }}
[forces]
bond = {{ type = "potential", value = "{0.5 * ALPHA}*(distance(A, B)**4 - 1)**2" }}
"""
    return HalfSteps(solver.loads(text), stop_time=n * h, h=h)


OTHERS = {"Gonzalez": gonzalez_gradient, "average": average_gradient}


def test_the_invariant_form_keeps_energy_and_angular_momentum():
    run = bond_of_ours(0.05, 200)
    assert np.ptp(run["bond.energy"]) > 0.01
    assert np.ptp(run["energy.total"]) < 1e-11
    assert np.ptp(run["angular_momentum.z"]) < 1e-10


@pytest.mark.parametrize("name", OTHERS)
def test_other_discrete_gradients_keep_energy_but_not_angular_momentum(name):
    _, energy, moment = bond(OTHERS[name], 0.05, 200)
    assert np.ptp(energy) < 1e-11
    assert np.ptp(moment) > 5e-5


# ----------------------------------------------------------------- constraints between three points

TRIPLE = """
name = "triple"
dimension = {dimension}
[points]
A = {{ position = {A}, velocity = {a}, mass = 1.0 }}
B = {{ position = {B}, velocity = {b}, mass = 3.0 }}
C = {{ position = {C}, velocity = {c}, mass = 2.0 }}
[constraints]
tie = {{ value = "{value}" }}
[solver]
assemble = true
step_size = {h}
"""
PLACES = {"A": [0.9, 0.1, 0.2], "B": [-0.7, 0.2, -0.1], "C": [0.2, 1.1, 0.3]}
SPEEDS = {"a": [0.3, 1.1, -0.4], "b": [0.1, -0.6, 0.5], "c": [-1.0, 0.3, 0.6]}

INVARIANT = {
    "ellipse": "distance(A, C) + distance(B, C) - 2.5",
    "product": "distance(A, C)*distance(B, C) - 1.5",
    "power": "distance(A, C)**3 + 2*distance(A, B)*sin(distance(B, C)) - 5",
}
AREA = "(B.x - A.x)*(C.y - A.y) - (B.y - A.y)*(C.x - A.x) + 1.5"
SIXTH = (
    "(A.x - C.x)**6 + 3*(A.x - C.x)**4*(A.y - C.y)**2 + 3*(A.x - C.x)**2*(A.y - C.y)**4"
    " + (A.y - C.y)**6 + distance(B, C)**2 - 3"
)
"""The same at every turn of the axes, but not written in what is."""


def triple(dimension: int, value: str, h: float = 0.05) -> solver.Trajectory:
    """Three points in free flight, tied by one formula."""
    numbers = {name: place[:dimension] for name, place in (PLACES | SPEEDS).items()}
    text = TRIPLE.format(dimension=dimension, value=value, h=h, **numbers)
    return solver.simulate(solver.loads(text), stop_time=10.0, step_size=0.05)


def losses(run: solver.Trajectory, dimension: int) -> tuple[float, float]:
    """Changes of energy and of angular momentum, whose sizes are 2 J and 3 N.m.s."""
    moment = vector(run, "angular_momentum.", "xyz" if dimension == 3 else "z")
    assert run["constraint.position"].max() < 1e-12
    return float(np.ptp(run["energy.total"])), float(np.ptp(moment, axis=0).max())


@pytest.mark.parametrize("dimension", [2, 3])
@pytest.mark.parametrize("name", INVARIANT)
def test_a_constraint_of_several_distances_keeps_energy_and_momentum(name, dimension):
    energy, moment = losses(triple(dimension, INVARIANT[name]), dimension)
    assert energy < 1e-11
    assert moment < 1e-11


def test_the_area_of_a_triangle_is_quadratic_so_that_its_momentum_is_kept_too():
    energy, moment = losses(triple(2, AREA), 2)
    assert energy < 1e-11
    assert moment < 1e-11


def test_a_formula_in_coordinates_keeps_energy_and_momentum_only_to_second_order():
    found = [losses(triple(2, SIXTH, h), 2) for h in (0.05, 0.025, 0.0125)]
    assert max(energy for energy, _ in found) < 1e-11
    moments = [moment for _, moment in found]
    assert moments[-1] > 1e-5
    assert observed_order([4, 2, 1], moments) == pytest.approx(2.0, abs=0.3)
