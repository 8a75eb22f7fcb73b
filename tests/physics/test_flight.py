"""Bodies in flight take explicit steps: momenta leave no velocity that would change their energy.

A turn along the gradient of the kinetic energy at fixed angular momentum brings it back; where that
gradient is 0, in steady spins and in spheres, nothing is to be brought back. Energies and momenta
are worked out here, from poses and velocities.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import pytest
from scipy.special import ellipj

import solver
from solver.runtime import Integrator
from tests.mechanism_runs import steps_explicitly, vector
from tests.problems import Array

G = 9.81

BODY = """
[bodies.{name}]
position = {position}
velocity = {velocity}
mass = {mass}
inertia = {inertia}
angular_velocity = {{ body = {spin} }}
points = {{ arm = [0.5, 0, 0], left = [-0.5, 0, 0] }}
"""


def body(
    name: str, inertia: Sequence[float] | Array, spin: Sequence[float] | Array, **given: object
) -> str:
    shown = {"position": [0, 0, 0], "velocity": [0, 0, 0], "mass": 1.0} | given
    return BODY.format(name=name, inertia=[*map(float, inertia)], spin=[*map(float, spin)], **shown)


def flight(*parts: str, tolerance: float, stop: float, gravity: float = 0.0) -> Integrator:
    head = f'name = "flight"\ngravity = [0, 0, {-gravity}]\n'
    tail = f"[experiment]\nstop_time = {stop}\n[solver]\ntolerance = {tolerance}\n"
    run = Integrator(solver.assemble(solver.loads("\n".join((head, *parts, tail)))))
    run.initialise()
    return run


def spin(run: Integrator, name: str = "b") -> Array:
    """Angular velocity in the body's own axes."""
    w, *u = (float(run[f"{name}.q{part}"]) for part in "wxyz")
    omega, axis = np.array([float(run[at]) for at in vector(name, "w")]), np.array(u)
    across = np.cross(omega, axis)
    return omega + 2.0 * (w * across + np.cross(across, axis))


def turned(run: Integrator, own: Array, name: str = "b") -> Array:
    """A vector in the body's own axes, in those of the ground."""
    w, *u = (float(run[f"{name}.q{part}"]) for part in "wxyz")
    axis = np.array(u)
    across = np.cross(axis, own)
    return own + 2.0 * (w * across + np.cross(axis, across))


def places(run: Integrator, name: str) -> tuple[Array, Array]:
    """Place and velocity of the centre of mass."""
    place, velocity = (np.array([float(run[at]) for at in vector(name, of)]) for of in ("", "v"))
    return place, velocity


def balance(
    run: Integrator, masses: dict[str, float], inertia: Array, g: float = 0.0
) -> tuple[float, Array, Array]:
    """Energy, momentum, and angular momentum about the common centre of mass."""
    mass = np.array([*masses.values()])
    place, velocity = np.swapaxes([places(run, name) for name in masses], 0, 1)
    spins = [spin(run, name) for name in masses]
    energy = 0.5 * mass @ np.sum(velocity**2, axis=1) + g * mass @ place[:, 2]
    energy += sum(0.5 * omega @ (inertia * omega) for omega in spins)
    momentum = mass @ velocity
    arm, drift = (x - mass @ x / mass.sum() for x in (place, velocity))
    angular = mass @ np.cross(arm, drift)
    for name, omega in zip(masses, spins, strict=True):
        angular = angular + turned(run, inertia * omega, name)
    return float(energy), momentum, angular


@pytest.mark.parametrize("axis", range(3))
def test_a_spin_about_a_principal_axis_goes_on(axis: int) -> None:
    """Round-off grows only about the middle axis: with exp(t/sqrt(3)) at 1 rad/s, 3e4 at last."""
    steps = 40 if axis == 1 else 10_000
    omega = np.eye(3)[axis]
    run = flight(body("b", [1, 2, 3], omega), tolerance=1e-6, stop=0.45 * steps)
    for k in range(steps):
        run.advance(0.45 * k, 0.45)
    assert steps_explicitly(run)
    assert run.state.head["held"] == 0.0
    assert spin(run) == pytest.approx(omega, abs=1e-11)
    angle = 0.45 * steps
    other = np.eye(3)[(axis + 1) % 3]
    across = np.eye(3)[(axis + 2) % 3]
    assert turned(run, other) == pytest.approx(
        math.cos(angle) * other + math.sin(angle) * across, abs=1e-9
    )
    assert float(run["energy.error"]) < 1e-12


def test_a_symmetric_top_precesses_steadily() -> None:
    """Its axis goes about its angular momentum L at |L|/A, A the inertia across the axis."""
    inertia, omega = np.array([2.0, 2.0, 1.0]), np.array([0.6, 0.0, 1.5])
    run = flight(body("b", inertia, omega), tolerance=1e-9, stop=3000.0)
    angular = inertia * omega
    rate, unit = np.linalg.norm(angular) / 2.0, angular / np.linalg.norm(angular)
    for k in range(10_000):
        run.advance(0.3 * k, 0.3)
    axis, angle = np.array([0.0, 0.0, 1.0]), 3000.0 * rate
    exact = unit * (unit @ axis) + math.cos(angle) * (axis - unit * (unit @ axis))
    exact += math.sin(angle) * np.cross(unit, axis)
    assert steps_explicitly(run)
    assert turned(run, axis) == pytest.approx(exact, abs=3e-9)
    energy, _, kept = balance(run, {"b": 1.0}, inertia)
    assert energy == pytest.approx(0.5 * omega @ angular, rel=1e-13)
    assert kept == pytest.approx(angular, abs=1e-12)


def test_a_sphere_has_no_turn_that_would_change_its_energy() -> None:
    run = flight(
        body("b", [0.4, 0.4, 0.4], [1, 2, 3], velocity=[1, 0, 2]), tolerance=1e-6, stop=100.0
    )
    for k in range(200):
        run.advance(0.5 * k, 0.5)
    assert steps_explicitly(run)
    assert run.state.head["held"] == 0.0
    assert spin(run) == pytest.approx([1, 2, 3], abs=1e-11)
    assert float(run["energy.error"]) < 1e-14


@pytest.mark.parametrize("push", [0.8, 1e-3], ids=["tumbling", "turning over"])
def test_a_tumbling_body_follows_jacobis_elliptic_functions(push: float) -> None:
    """In the body omega = (a cn, b sn, c dn)(p t | m), from Euler's equations (Landau, 37).

    A body that turns over multiplies errors along its path by 1e3: the request counts for these.
    """
    steps, h = 10_000 if push > 0.5 else 300, 0.3
    inertia, tolerance = np.array([1.0, 2.0, 2.5]), 1e-8
    j1, j2, j3 = inertia
    edge = math.sqrt(j1 * (j2 - j1) / (j3 * (j3 - j2)))  # of c/a: it turns over the more rarely
    a, c = (push, 1.0) if push > 0.5 else (1.0, edge * (1.0 + push))
    b = a * math.sqrt((j3 - j1) * j1 / (j2 * (j3 - j2)))
    p = (j3 - j1) * c * a / (j2 * b)
    m = (j2 - j1) * a * b / (j3 * c * p)
    run = flight(body("b", inertia, [a, 0, c]), tolerance=tolerance, stop=steps * h)
    start = balance(run, {"b": 1.0}, inertia)
    for k in range(steps):
        run.advance(k * h, h)
        if k % (steps // 20) == 0:
            sn, cn, dn, _ = ellipj(p * (k + 1) * h, m)
            assert spin(run) == pytest.approx([a * cn, b * sn, c * dn], abs=3 * tolerance)
    assert steps_explicitly(run)
    assert run.state.head["held"] == 0.0
    energy, _, angular = balance(run, {"b": 1.0}, inertia)
    assert energy == pytest.approx(start[0], rel=1e-13)
    assert angular == pytest.approx(start[2], abs=1e-12)


def test_a_thrown_body_flies_on_a_parabola_and_keeps_its_spin() -> None:
    inertia = np.array([0.1, 0.25, 0.3])
    thrown = body("b", inertia, [3, 1, 2], position=[5, -2, 1], velocity=[3, 1, 12], mass=2.0)
    run = flight(thrown, tolerance=1e-7, stop=2.0, gravity=G)
    start = balance(run, {"b": 2.0}, inertia, G)
    for k in range(40):
        run.advance(0.05 * k, 0.05)
    place, _ = places(run, "b")
    assert place == pytest.approx([11.0, 0.0, 25.0 - 2.0 * G], abs=1e-12)
    energy, momentum, angular = balance(run, {"b": 2.0}, inertia, G)
    assert steps_explicitly(run)
    assert energy == pytest.approx(start[0], rel=1e-14)
    assert momentum == pytest.approx(start[1] - [0, 0, 4.0 * G], abs=1e-12)
    assert angular == pytest.approx(start[2], abs=1e-13)


@pytest.mark.parametrize("gravity", [0.0, G])
@pytest.mark.parametrize("kind", ["spherical", "revolute"])
def test_two_bodies_in_flight_keep_energy_and_momenta(kind: str, gravity: float) -> None:
    """Joined at x = 0.5; its hinge turns about z."""
    inertia = np.array([0.2, 0.5, 0.6])
    first = body("b", inertia, [0, 0, 3] if kind == "revolute" else [1, -2, 3])
    omega, moves = ([0, 0, -1], [0, 1, 0]) if kind == "revolute" else ([2, 0, 1], [0, 2, 1])
    second = body("d", inertia, omega, position=[1, 0, 0], velocity=moves)
    axis = "axis = [0, 0, 1]\n" if kind == "revolute" else ""
    joint = f'[joints.j]\ntype = "{kind}"\nbodies = ["b", "d"]\nposition = [0.5, 0, 0]\n{axis}'
    run = flight(first, second, joint, tolerance=1e-7, stop=10.0, gravity=gravity)
    masses = {"b": 1.0, "d": 1.0}
    start = balance(run, masses, inertia, gravity)
    for k in range(200):
        run.advance(0.05 * k, 0.05)
    assert steps_explicitly(run)
    energy, momentum, angular = balance(run, masses, inertia, gravity)
    assert energy == pytest.approx(start[0], abs=1e-11)
    assert momentum == pytest.approx(start[1] - [0, 0, 20.0 * gravity], abs=1e-11)
    assert angular == pytest.approx(start[2], abs=1e-11)
