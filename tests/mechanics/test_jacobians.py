"""Jacobian of every joint against the complex step of rows that are written anew.

A joint's rows may be chosen in many ways, so what is compared is the space that they span, with
the rows of the bodies themselves: the velocities that it allows. Configurations are those after
half a second of motion, where no direction is as it was drawn.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
import pytest

import solver
from solver.mechanics.mobility import constraint_jacobian
from tests.support.mechanisms.joint_rows import LOWER, OF_POINTS, Drawn, Joint, own_rows
from tests.support.mechanisms.joint_scenes import PAIRS, TRAINS, pair, train
from tests.support.mechanisms.reduced_models import Array, matrix_of, rotation

ROWS = LOWER | OF_POINTS
TINY = 1e-30
"""Step in the imaginary direction: its square is nothing, and no digit is lost."""


def plane(angle: float) -> Array:
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s], [s, c]])


TURNED_B = matrix_of(np.array([0.9, 0.1, -0.3, 0.2]))
CENTRE_B = np.array([0.9, 0.3, -0.1]) + TURNED_B @ [0.02, 0.05, -0.03]
CENTRE_B_2 = np.array([0.9, 0.3]) + plane(-0.4) @ [0.02, 0.05]
BODIES = {
    3: [Drawn(np.zeros(3), rotation([0.2, -0.3, 0.4])), Drawn(CENTRE_B, TURNED_B)],
    2: [Drawn(np.zeros(2), plane(0.3)), Drawn(CENTRE_B_2, plane(-0.4))],
}
TRAIN = {
    3: [
        Drawn(np.array([0.4, 0.2, 0.1]), np.eye(3)),
        Drawn(np.array([0.1, 0.1, 0.3]), BODIES[3][0].R),
        BODIES[3][1],
    ],
    2: [Drawn(np.array([0.4, 0.2]), np.eye(2)), Drawn(np.array([0.1, 0.1]), plane(0.3)),
        BODIES[2][1]],
}  # fmt: skip
"""Bodies of `joint_scenes` as drawn."""


def moved(text: str) -> tuple[Array, Array]:
    """Coordinates (bodies, 1 + k, dim) after half a second, and G there."""
    integrator = solver.Integrator(solver.assemble(solver.loads(text)))
    integrator.initialise()
    integrator.advance(0.0, 0.5)
    dim = integrator.model.sizes["dim"]
    q = np.array(integrator.state.vectors["q"]).reshape(-1, 4 if dim == 3 else 2, dim)
    return q, constraint_jacobian(integrator)


def complex_step(rows: Callable[[Array], Sequence[Any]], q: Array) -> Array:
    """Derivatives (rows, q.size) of rows at q."""
    columns = []
    for k in range(q.size):
        pushed = q.astype(complex)
        pushed.ravel()[k] += 1j * TINY
        columns.append(np.imag(rows(pushed)) / TINY)
    return np.array(columns).T


def angle_between(G: Array, H: Array) -> float:
    """Sine of the largest angle between the spaces of the rows of G and H, of full rank."""
    U, V = (np.linalg.qr((M / np.linalg.norm(M, axis=1, keepdims=True)).T)[0] for M in (G, H))
    return float(np.linalg.norm(V - U @ (U.T @ V), 2))


def lower_pair(dimension: int, kind: str, q: Array) -> Sequence[Any]:
    position, axis = np.array([0.5, 0.1, 0.2]), np.array([1.0, 2.0, 2.0])
    first, second = BODIES[dimension]
    joint = Joint(first, second, position[:dimension], axis[:dimension], q[0], q[1])
    return [*own_rows(q[0]), *own_rows(q[1]), *ROWS[kind](joint)]


@pytest.mark.parametrize(("dimension", "kind"), PAIRS)
def test_a_joint_allows_the_velocities_of_the_textbook(dimension: int, kind: str) -> None:
    # 1e-12: the configuration itself is on its constraints to some 1e-15.
    q, G = moved(pair(dimension, kind, 0.01))
    H = complex_step(lambda q: lower_pair(dimension, kind, q), q)
    assert H.shape == G.shape
    assert angle_between(G, H) < 1e-12


def coupled(dimension: int, kind: str, q: Array) -> Sequence[Any]:
    """Rows of a train: both joints, and second = factor times first."""
    frame, A, B = TRAIN[dimension]
    at = np.array([[0.2, 0.1, 0.2], [0.7, 0.3, 0.0]])[:, :dimension]
    second_axis = [2.0, -1.0, 2.0] if dimension == 3 else [1.0, 2.0]
    first = Joint(frame, A, at[0], np.array([1.0, 2.0, 2.0])[:dimension], q[0], q[1])
    second = Joint(frame, B, at[1], np.array(second_axis), q[0], q[2])
    types = ("cylindrical",) * 2 if "sleeves" in kind else ("revolute", "revolute")
    if kind == "rack":
        types = ("revolute", "prismatic")
    law = second.angle() + 1.5 * first.angle()
    if kind.startswith("rack"):
        law = second.displacement() - 0.12 * first.angle()
    own = [row for body in q for row in own_rows(body)]
    return [*own, *LOWER[types[0]](first), *LOWER[types[1]](second), law]


@pytest.mark.parametrize(("dimension", "kind"), TRAINS)
def test_a_coupling_allows_the_velocities_of_its_ratio(dimension: int, kind: str) -> None:
    q, G = moved(train(dimension, kind, 0.01))
    H = complex_step(lambda q: coupled(dimension, kind, q), q)
    assert H.shape == G.shape
    assert angle_between(G, H) < 1e-12


DISC = """
name = "disc"
gravity = [0, 0, -9.81]
[bodies.disc]
position = [0, 0.1, 0.55]
orientation = { rotation_vector = [0.3, 0, 0] }
angular_velocity = { body = [0.2, 3, -0.4] }
mass = 1.0
inertia = [0.05, 0.09, 0.05]
[joints.roll]
type = "rolling"
body = "disc"
radius = 0.5
axis = [0, 0.955336489125606, 0.29552020666133955]
[solver]
assemble = true
"""


def test_a_rolling_disc_allows_no_velocity_where_it_touches_the_plane() -> None:
    """The height z - R |n - (n . e) e|, and x' + sum xi_i d_i' of the contact along the plane."""
    q, G = moved(DISC)
    body, n = q[0], np.array([0.0, 0.0, 1.0])

    def up(body: Array) -> Array:
        across = n - (n @ body[2]) * body[2]  # the body's y is the axis
        return across / np.sqrt(across @ across)

    def rows(q: Array) -> list[Any]:
        across = n - (n @ q[0, 2]) * q[0, 2]
        return [*own_rows(q[0]), q[0, 0, 2] - 0.5 * np.sqrt(across @ across)]

    contact = body[1:] @ (-0.5 * up(body))  # in body axes
    slide = np.zeros((2, 4, 3))
    for axis in (0, 1):
        slide[axis, :, axis] = [1.0, *contact]
    H = np.vstack([complex_step(rows, q), slide.reshape(2, -1)])
    assert H.shape == G.shape
    assert angle_between(G, H) < 1e-12


def test_a_disc_on_a_line_allows_no_velocity_where_it_touches() -> None:
    c, s = math.cos(0.4), math.sin(0.4)
    q, G = moved(f"""
name = "disc"
dimension = 2
gravity = [0, -9.81]
[bodies.disc]
position = [{0.2 - 0.3 * s!r}, {0.1 + 0.3 * c!r}]
mass = 2.0
inertia = 0.09
[joints.roll]
type = "rolling"
body = "disc"
radius = 0.3
position = [0.2, 0.1]
normal = [{-s!r}, {c!r}]
""")
    along, normal = np.array([c, s]), np.array([-s, c])

    def rows(q: Array) -> list[Any]:
        x, y = q[0, 1]
        return [*own_rows(q[0]), q[0, 0] @ normal, q[0, 0] @ along + 0.3 * np.arctan(y / x)]

    assert angle_between(G, complex_step(rows, q)) < 1e-12


def test_rows_of_another_joint_would_be_noticed() -> None:
    q, G = moved(pair(3, "screw", 0.01))
    H = complex_step(lambda q: lower_pair(3, "prismatic", q), q)
    assert angle_between(G, H) > 0.1
