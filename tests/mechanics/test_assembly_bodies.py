"""Rigid bodies become nodes with the right masses, also where a body has no extent."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import solver
from solver.mechanics.inertia import FLOOR, euler_tensor, floored
from tests.support.mechanisms.problems import Array

HEAD = 'name = "body"\n'

BODY = """
[bodies.b]
position = [1, 2, 3]
center_of_mass = {centre}
orientation = {{ rotation_vector = [0.4, -0.7, 0.2] }}
velocity = [0.3, -0.2, 0.1]
angular_velocity = [1.0, 2.0, -0.5]
mass = 2.5
inertia = {inertia}
points = {{ tip = [0.3, -0.1, 0.2] }}
"""


def start(text: str) -> solver.Integrator:
    integrator = solver.Integrator(solver.assemble(solver.loads(HEAD + text)))
    integrator.initialise()
    return integrator


def rotation(vector: list[float]) -> Array:
    """Rodrigues' formula."""
    angle = np.linalg.norm(vector)
    k = np.cross(np.eye(3), np.array(vector) / angle)
    return np.eye(3) + math.sin(angle) * k + (1 - math.cos(angle)) * k @ k


def matrix(E: object) -> Array:
    return np.array(E, dtype=float)


# --------------------------------------------------------------------------- energy and momentum


@pytest.mark.parametrize("centre", [[0, 0, 0], [0.1, -0.2, 0.05]])
def test_a_body_has_the_energy_and_momentum_of_its_mass_and_inertia(centre):
    J = np.array([[0.3, 0.02, 0.01], [0.02, 0.4, -0.03], [0.01, -0.03, 0.5]])
    body = start(BODY.format(centre=centre, inertia=J.tolist()))
    R, omega = rotation([0.4, -0.7, 0.2]), np.array([1.0, 2.0, -0.5])
    arm = R @ np.array(centre)
    x, v = np.array([1.0, 2.0, 3.0]) + arm, np.array([0.3, -0.2, 0.1]) + np.cross(omega, arm)
    spin = R @ J @ R.T @ omega
    energy = 0.5 * 2.5 * v @ v + 0.5 * omega @ spin
    moment = 2.5 * np.cross(x, v) + spin
    assert body["energy.kinetic"] == pytest.approx(energy, rel=1e-14)
    for k, axis in enumerate("xyz"):
        assert body[f"momentum.{axis}"] == pytest.approx(2.5 * v[k], abs=1e-14)
        assert body[f"angular_momentum.{axis}"] == pytest.approx(moment[k], abs=1e-14)
        assert body[f"b.w{axis}"] == pytest.approx(omega[k], abs=1e-14)
        assert body[f"b.{axis}"] == pytest.approx([1, 2, 3][k], abs=1e-15)
        assert body[f"b.v{axis}"] == pytest.approx([0.3, -0.2, 0.1][k], abs=1e-15)
        tip = np.array([1.0, 2.0, 3.0]) + R @ np.array([0.3, -0.1, 0.2])
        assert body[f"b.tip.{axis}"] == pytest.approx(tip[k], abs=1e-14)


def test_a_planar_body_has_the_energy_and_momentum_of_its_mass_and_inertia():
    body = start(
        "dimension = 2\n[bodies.b]\nposition = [1, 2]\ncenter_of_mass = [0.3, -0.1]\n"
        "orientation = 0.7\nvelocity = [0.4, -0.2]\nangular_velocity = 1.5\nmass = 2.0\n"
        "inertia = 0.3\npoints = { tip = [0.5, 0.2] }\n"
    )
    c, s = math.cos(0.7), math.sin(0.7)
    arm = np.array([[c, -s], [s, c]]) @ np.array([0.3, -0.1])
    x, v = np.array([1.0, 2.0]) + arm, np.array([0.4, -0.2]) + 1.5 * np.array([-arm[1], arm[0]])
    assert body["energy.kinetic"] == pytest.approx(v @ v + 0.5 * 0.3 * 1.5**2, rel=1e-14)
    moment = 2.0 * (x[0] * v[1] - x[1] * v[0]) + 0.3 * 1.5
    assert body["angular_momentum.z"] == pytest.approx(moment, rel=1e-14)
    assert body["b.angle"] == pytest.approx(0.7, rel=1e-15)
    assert body["b.tip.x"] == pytest.approx(1 + 0.5 * c - 0.2 * s, rel=1e-14)


# ----------------------------------------------------------------------------- slender limits


@given(st.permutations([0, 1, 2]), st.floats(1e-6, 1e6))
def test_a_rod_keeps_its_transverse_inertia_and_gets_the_least_spin_inertia(axes, size):
    J = np.zeros((3, 3))
    for k in axes[1:]:
        J[k, k] = size
    E = matrix(floored(euler_tensor(tuple(map(tuple, J.tolist()))), float))
    found = np.trace(E) * np.eye(3) - E
    for k in axes[1:]:
        assert found[k, k] == pytest.approx(size, rel=1e-14)
    # The sum of two eigenvalues 10^7 apart: the last digits of the small one are rounding.
    assert found[axes[0], axes[0]] == pytest.approx(2 * FLOOR * size, rel=1e-7)
    assert np.linalg.eigvalsh(E).min() >= 0.999 * FLOOR * size


@given(st.lists(st.floats(-3, 3), min_size=3, max_size=3))
def test_a_rod_along_any_axis_is_treated_alike(direction):
    d = np.array(direction)
    if np.linalg.norm(d) < 0.1:
        return
    d /= np.linalg.norm(d)
    J = 0.4 * (np.eye(3) - np.outer(d, d))
    J = (J + J.T) / 2
    E = matrix(floored(euler_tensor(tuple(map(tuple, J.tolist()))), float))
    found = np.trace(E) * np.eye(3) - E
    across = np.linalg.svd(d[None])[2][1:]
    assert across @ found @ across.T == pytest.approx(0.4 * np.eye(2), abs=1e-12)
    assert d @ found @ d == pytest.approx(2 * FLOOR * 0.4, rel=1e-6)


def test_a_body_with_extent_in_space_keeps_its_inertia_exactly():
    E = euler_tensor(((0.3, 0.02, 0.01), (0.02, 0.4, -0.03), (0.01, -0.03, 0.5)))
    assert floored(E, float) == E


def test_a_plate_is_biased_by_the_floor_alone():
    E = matrix(floored(euler_tensor(((1.0, 0.0, 0.0), (0.0, 2.0, 0.0), (0.0, 0.0, 3.0))), float))
    found = np.trace(E) - np.diag(E)
    assert found == pytest.approx([1.0, 2.0, 3.0], rel=3 * FLOOR)


def test_a_body_without_inertia_moves_like_the_point_that_it_is():
    # A pendulum of length 1, with a bob of no size: no inertia but a part in 10^7.
    point = start(
        "gravity = [0, 0, -9.81]\n[bodies.bob]\nposition = [0.6, 0, -0.8]\nmass = 2.0\n"
        "inertia = [0, 0, 0]\n[joints.hook]\n"
        'type = "spherical"\nbodies = ["ground", "bob"]\nposition = [0, 0, 0]\n'
    )
    for _ in range(10):
        point.advance(point.time, 1e-4)
    force = [float(point[f"hook.force.{axis}"]) for axis in "xyz"]
    # At rest the string carries the weight along itself, 2 g 0.8; after 1 ms a part in 10^5 more.
    expected = [-2 * 9.81 * 0.8 * 0.6, 0.0, 2 * 9.81 * 0.8 * 0.8]
    assert force == pytest.approx(expected, rel=3e-5, abs=1e-9)


# ---------------------------------------------------------------------------------- mistakes


def report(text: str) -> str:
    with pytest.raises(solver.SceneError) as caught:
        solver.assemble(solver.loads(HEAD + text))
    return str(caught.value)


def test_parameters_that_break_the_triangle_inequality_are_named():
    text = (
        "[parameters]\nJ = 0.3\n[bodies.b]\nposition = [0, 0, 0]\nmass = 1.0\n"
        'inertia = ["J", 0.2, 0.2]\n'
    )
    integrator = start(text)
    integrator["J"] = 0.5
    with pytest.raises(solver.AssemblyError, match=r"^body 'b': inertia breaks the triangle"):
        integrator.initialise()
