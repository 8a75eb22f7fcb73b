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
from scipy.integrate import solve_ivp
from scipy.special import ellipj

import solver
from solver.runtime import Integrator
from tests.support.mechanisms.mechanism_runs import steps_explicitly, vector
from tests.support.mechanisms.problems import Array

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


def flight(
    *parts: str, tolerance: float, stop: float, gravity: float = 0.0, method: str = "fastest"
) -> Integrator:
    head = f'name = "flight"\ngravity = [0, 0, {-gravity}]\n'
    tail = f"[experiment]\nstop_time = {stop}\n[solver]\ntolerance = {tolerance}\n"
    tail += f"method = '{method}'\n"
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


@pytest.mark.parametrize(
    ("inertia", "omega"),
    [
        ([1, 2, 3], [1, 0, 0]),
        ([1, 2, 3], [0, 1, 0]),
        ([1, 2, 3], [0, 0, 1]),
        ([2, 2, 2], [1, 2, 3]),
    ],
    ids=["least", "middle", "largest", "sphere"],
)
def test_covers_keep_a_steady_spin(inertia: list[int], omega: list[int]) -> None:
    """No turn and no velocity changes its energy, and any beside it would be an error."""
    axis = np.array(omega) / np.linalg.norm(omega)
    across = np.cross(axis, [0.6, 0.0, 0.8])
    across /= np.linalg.norm(across)
    run = flight(body("b", inertia, omega), tolerance=1e-6, stop=18.0, method="conserving")
    for k in range(40):
        run.advance(0.45 * k, 0.45)
        assert run["solver.order_in_use"] > 2.0
    angle = 18.0 * float(np.linalg.norm(omega))
    place = math.cos(angle) * across + math.sin(angle) * np.cross(axis, across)
    assert spin(run) == pytest.approx(np.array(omega), abs=1e-12)
    assert turned(run, across) == pytest.approx(place, abs=3e-6)
    assert float(run["energy.error"]) < 1e-13


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


ROD = """
name = "rod"
gravity = [0, 0, {down}]
[bodies.b]
mass = 1.0
inertia = {inertia}
position = {position}
velocity = {velocity}
orientation = {{ axis = [1, 2, 3], angle = {angle} }}
angular_velocity = {{ body = {spin} }}
[experiment]
stop_time = 2.0
"""
STEPS = {
    "tolerance": "tolerance = 1e-6\nmethod = 'fastest'",
    **{f"order {order}": f"order = {order}\nstep_size = 0.01" for order in (2, 4, 8)},
}


def run_rod(text: str, steps: str, axis: Array) -> tuple[float, Array, Array]:
    """Increments that 2 s take, and the rod's axis and spin about it after each tenth."""
    run = Integrator(solver.assemble(solver.loads(f"{text}[solver]\n{STEPS[steps]}\n")))
    run.initialise()
    work, axes, spins = 0.0, list[Array](), list[float]()
    for k in range(20):
        run.advance(0.1 * k, 0.1)
        work += run.state.head["newton_iterations"]
        axes.append(turned(run, axis))
        spins.append(float(spin(run) @ axis))
    assert float(run["energy.error"]) < 1e-13
    return work, np.array(axes), np.array(spins)


def rod_in_flight(
    inertia: Array, omega: Sequence[float] | Array, axis: Array, angle: float, steps: str
) -> tuple[float, Array, Array]:
    values = {"inertia": inertia.tolist(), "spin": [*map(float, omega)], "angle": angle}
    text = ROD.format(down=0.0, position=[0, 0, 0], velocity=[0, 0, 0], **values)
    return run_rod(text, steps, axis)


def about(axis: Array, angle: float, x: Array) -> Array:
    """A vector x turned by an angle about an axis."""
    unit = axis / np.linalg.norm(axis)
    along = unit * (unit @ x)
    return along + math.cos(angle) * (x - along) + math.sin(angle) * np.cross(unit, x)


@pytest.mark.parametrize("start", ["along x", "tilted", "oblique"])
@pytest.mark.parametrize("steps", STEPS)
def test_a_rod_in_flight_turns_steadily_and_does_not_spin(steps: str, start: str) -> None:
    """It has no inertia about its axis, which turns about L = J omega across it.

    Round-off of its torques, 1e-16 J |omega|^2, over the 2e-7 J that it gets along its axis makes
    1e-8 rad/s in 2 s. It costs what a spin about an axis of the drawing does, which has none; but
    that of an oblique rod hovers about what Newton's iteration asks for.
    """
    tilted, oblique = np.array([1.0, 2.0, 3.0]), start == "oblique"
    axis = tilted / np.linalg.norm(tilted) if oblique else np.array([1.0, 0.0, 0.0])
    inertia = np.eye(3) - np.outer(axis, axis)
    across = np.cross(axis, [1.0, 2.0, -1.0])
    omega = math.sqrt(5.0) / np.linalg.norm(across) * across
    angle = 0.7 if start == "tilted" else 0.0
    work, axes, spins = rod_in_flight(inertia, omega, axis, angle, steps)
    about_it = about(tilted, angle, omega)
    first = about(tilted, angle, axis)
    exact = np.array([about(about_it, math.sqrt(5.0) * 0.1 * (k + 1), first) for k in range(20)])
    # Order 2 turns by 2 tan(omega h/4) in each half step, late by (omega h/2)^2/12: 5e-5 in all.
    error = {"tolerance": 1e-6, "order 2": 6e-5, "order 4": 1e-9, "order 8": 1e-12}[steps]
    assert axes == pytest.approx(exact, abs=error)
    assert np.abs(spins).max() < 1e-7
    steady = rod_in_flight(
        np.diag([0.0, 1.0, 1.0]), [0, math.sqrt(5.0), 0], np.array([1.0, 0.0, 0.0]), 0.0, steps
    )
    assert work < (4.0 if oblique and steps == "order 2" else 2.0) * steady[0]


@pytest.mark.parametrize("thin", [1e-12, 1e-9, 1e-6, 1e-3])
def test_a_thin_body_in_flight_costs_no_more_than_a_thick_one(thin: float) -> None:
    axis = np.array([1.0, 0.0, 0.0])
    work = [
        rod_in_flight(np.diag([inertia, 1.0, 1.0]), [0, 2, 1], axis, 0.0, "tolerance")[0]
        for inertia in (thin, 0.5)
    ]
    assert work[0] < 2.0 * work[1]


def test_a_disc_that_turns_about_a_diameter_costs_no_more_than_a_sphere() -> None:
    """Errors do not grow along its path, however small its precession."""
    axis = np.array([0.0, 0.0, 1.0])
    work = [
        rod_in_flight(np.diag([1.0, 1.0, J]), [1, 2, 0], axis, 0.7, "tolerance")[0]
        for J in (2.0, 1.0)
    ]
    assert work[0] < 1.5 * work[1]


@pytest.mark.parametrize("angle", [0.0, 0.7])
@pytest.mark.parametrize("steps", STEPS)
def test_a_rod_on_a_ball_joint_is_a_spherical_pendulum(steps: str, angle: float) -> None:
    """Of 1 m, with e'' = 3/2 (g - (g . e) e)/l - |e'|^2 e, by a method of order 8."""
    tilted, omega = np.array([1.0, 2.0, 3.0]), np.array([0.0, 2.0, 1.0])
    first, turning = (about(tilted, angle, x) for x in (np.array([1.0, 0.0, 0.0]), omega))

    def rate(_: float, y: Array) -> Array:
        e, down = y[:3], np.array([0.0, 0.0, -1.5 * G])
        return np.concatenate([y[3:], down - (down @ e) * e - (y[3:] @ y[3:]) * e])

    start, ends = np.concatenate([first, np.cross(turning, first)]), 0.1 * np.arange(1, 21)
    exact = solve_ivp(rate, (0.0, 2.0), start, "DOP853", ends, rtol=1e-13, atol=1e-13).y[:3].T
    work = []
    for thin in (0.0, 1e-3):
        text = ROD.format(
            inertia=[thin, 1.0 / 12.0, 1.0 / 12.0], spin=omega.tolist(), angle=angle, down=-G,
            position=(0.5 * first).tolist(), velocity=np.cross(turning, 0.5 * first).tolist(),
        )  # fmt: skip
        joint = '[joints.j]\ntype = "spherical"\nbodies = ["ground", "b"]\nposition = [0, 0, 0]\n'
        needed, axes, spins = run_rod(text + joint, steps, np.array([1.0, 0.0, 0.0]))
        error = {"tolerance": 1e-6, "order 2": 5e-4, "order 4": 3e-9, "order 8": 1e-11}[steps]
        assert axes == pytest.approx(exact, abs=error)
        assert np.abs(spins).max() < 1e-6
        work.append(needed)
    assert work[0] < 3.0 * work[1]


POINT = """
name = "point"
dimension = 2
[parameters]
m = { value = 1.3 }
[points]
A = { position = [-0.5, 0], velocity = [1, 0], mass = "m" }
[forces]
f = { type = "force", point = "A", value = ["-A.x", "0.5"] }
"""


@pytest.mark.parametrize(
    "settings", [{}, {"tolerance": 1e-6}, {"tolerance": 1e-6, "method": "fastest"}], ids=str
)
def test_a_point_alone_has_no_angular_momentum_to_keep(settings: dict[str, float | str]) -> None:
    """About itself, also where its mass times its place over its mass is not its place.

    It swings about x = 0 with omega = 1/sqrt(m), and is pushed up with 0.5/m.
    """
    model = solver.assemble(solver.loads(POINT))
    for mass in np.linspace(1.2, 1.4, 41):
        run = solver.simulate(
            model, stop_time=1.0, step_size=0.25, parameters={"m": mass}, **settings
        )
        omega = 1.0 / math.sqrt(mass)
        speed = 0.5 * omega * math.sin(omega) + math.cos(omega)
        error = 3.0 * float(settings.get("tolerance", 1e-4))
        assert run["A.vx"][-1] == pytest.approx(speed, abs=error)
        assert run["A.vy"][-1] == pytest.approx(0.5 / mass, abs=error)
