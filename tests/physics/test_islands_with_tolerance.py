"""Explicit steps of several islands: each keeps its own, and reactions are those of the place.

Right values are closed forms, statics, or Newton's law; energies are worked out from places and
velocities.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import solver
from solver.runtime import Integrator
from tests.support.mechanisms.exact_motions import pendulum_angle
from tests.support.mechanisms.mechanism_runs import steps_explicitly
from tests.support.mechanisms.problems import Array

G = 9.81


def started(text: str, tolerance: float, dimension: int = 2, stop: float = 2.0) -> Integrator:
    gravity = [0, -G] if dimension == 2 else [0, 0, -G]
    head = f'name = "parts"\ndimension = {dimension}\ngravity = {gravity}\n'
    tail = (
        f"[experiment]\nstop_time = {stop}\n[solver]\ntolerance = {tolerance}\nmethod = 'fastest'\n"
    )
    run = Integrator(solver.assemble(solver.loads(head + text + tail)))
    run.initialise()
    return run


def of(run: Integrator, *names: str) -> Array:
    return np.array([float(run[name]) for name in names])


def pendulum(name: str, angle: float, more: str = "") -> str:
    """A unit mass on a unit rod under (0, 0), `angle` from the lowest place."""
    x, y = math.sin(angle), -math.cos(angle)
    return f"""
[points.{name}]
position = [{x!r}, {y!r}]
mass = 1.0
[joints.rod_{name}]
type = "distance"
points = ["ground", "{name}"]
at = [0, 0]
length = 1.0
{more}"""


FREE = """
[points.F]
position = [3, 0]
velocity = [1, 2]
mass = 0.5
"""


@pytest.mark.parametrize("tolerance", [1e-4, 1e-8])
def test_pendulums_swing_side_by_side_and_each_keeps_its_energy(tolerance: float) -> None:
    angles = {"A": 2.0, "B": 0.3, "C": 1.2}
    run = started("".join(pendulum(name, at) for name, at in angles.items()), tolerance, stop=10.0)
    for k in range(100):
        run.advance(0.1 * k, 0.1)
        for name, angle in angles.items():
            x, y, vx, vy = of(run, *(f"{name}.{part}" for part in ("x", "y", "vx", "vy")))
            exact = pendulum_angle(np.array([0.1 * (k + 1)]), angle)[0]
            assert [x, y] == pytest.approx(
                [math.sin(exact), -math.cos(exact)], abs=3.0 * tolerance * math.sqrt(3.0)
            )
            assert 0.5 * (vx * vx + vy * vy) + G * y == pytest.approx(
                -G * math.cos(angle), abs=2e-13
            )
    assert steps_explicitly(run)


def test_a_damped_pendulum_takes_no_energy_from_its_neighbour() -> None:
    damper = '[forces.d]\ntype = "damper"\npoints = ["ground", "A"]\nat = [1, 0]\ndamping = 0.4\n'
    run = started(pendulum("A", 1.0, damper) + pendulum("B", 1.5), 1e-8, stop=5.0)

    def rates(_: float, state: Array) -> Array:
        angle, rate = state
        arm = np.array([math.sin(angle) - 1.0, -math.cos(angle)])
        turn = np.array([math.cos(angle), math.sin(angle)])
        along = arm @ turn / np.linalg.norm(arm)
        return np.array([rate, -G * math.sin(angle) - 0.4 * along * along * rate])

    exact = solve_ivp(rates, (0, 5), [1.0, 0.0], method="DOP853", rtol=1e-12, atol=1e-12).y[0, -1]
    for k in range(50):
        run.advance(0.1 * k, 0.1)
    assert steps_explicitly(run)
    assert of(run, "A.x", "A.y") == pytest.approx([math.sin(exact), -math.cos(exact)], abs=5e-8)
    y, vx, vy = of(run, "B.y", "B.vx", "B.vy")
    assert 0.5 * (vx * vx + vy * vy) + G * y == pytest.approx(-G * math.cos(1.5), abs=1e-13)
    y, vx, vy = of(run, "A.y", "A.vx", "A.vy")
    lost = -G * math.cos(1.0) - 0.5 * (vx * vx + vy * vy) - G * y
    assert float(run["energy.dissipated"]) == pytest.approx(lost, abs=1e-12)


@pytest.mark.parametrize("tolerance", [1e-3, 1e-6])
def test_a_driver_beside_a_free_point_feels_its_own_mass_alone(tolerance: float) -> None:
    """A mass of 2 kg at 0.3 sin(4 t): 2 (x'' + g)."""
    point = "[points.A]\nposition = [0, 0]\nvelocity = [1.2, 0]\nmass = 2.0\n"
    driver = '[drivers.hand]\ntype = "position"\npoint = "A"\nvalue = ["0.3*sin(4*t)", "0"]\n'
    run = started(FREE + point + driver, tolerance)
    for k in range(20):
        run.advance(0.1 * k, 0.1)
        t = 0.1 * (k + 1)
        force = of(run, "hand.force.x", "hand.force.y")
        assert force == pytest.approx([-9.6 * math.sin(4.0 * t), 2.0 * G], abs=1e-9)
        assert of(run, "F.x", "F.y") == pytest.approx([3 + t, 2 * t - G * t * t / 2], abs=1e-12)
        assert of(run, "F.vx", "F.vy") == pytest.approx([1, 2 - G * t], abs=1e-12)
        assert float(run["energy.error"]) < 1e-13


@pytest.mark.parametrize("tolerance", [1e-3, 1e-6])
def test_a_truss_beside_a_pendulum_carries_its_load(tolerance: float) -> None:
    """At 45 degrees: (load - weight)/sqrt(2), which the pendulum does not change."""
    truss = """
[points.T]
position = [1, 1]
mass = 1.0
[joints.left]
type = "distance"
points = ["ground", "T"]
at = [0, 0]
[joints.right]
type = "distance"
points = ["ground", "T"]
at = [2, 0]
[forces.load]
type = "force"
point = "T"
value = ["5*sin(3*t)", "0"]
"""
    run = started(truss + pendulum("A", 1.0), tolerance)
    for k in range(20):
        run.advance(0.1 * k, 0.1)
        exact = (5.0 * math.sin(0.3 * (k + 1)) - G) / math.sqrt(2.0)
        assert float(run["left.force"]) == pytest.approx(exact, abs=1e-9)
        y, vx, vy = of(run, "A.y", "A.vx", "A.vy")
        tension = vx * vx + vy * vy - G * y
        assert float(run["rod_A.force"]) == pytest.approx(tension, abs=1e-9)
    assert steps_explicitly(run)


def test_two_driven_bodies_need_each_its_own_torque() -> None:
    """Bars of 1 m and 1 and 2 kg, hinged 0.5 m from their middles: (J + m/4) a'' + m g cos(a)/2."""
    text, laws = "", {"b": ("2*sin(3*t)", 1.0), "d": ("1.5*t**2", 2.0)}
    for name, (law, mass) in laws.items():
        text += f"""
[bodies.{name}]
position = [0.5, 0]
mass = {mass}
inertia = {mass / 12.0!r}
angular_velocity = {6.0 if name == "b" else 0.0}
velocity = [0, {3.0 if name == "b" else 0.0}]
[joints.hinge_{name}]
type = "revolute"
bodies = ["ground", "{name}"]
position = [0, 0]
[drivers.motor_{name}]
type = "angle"
joint = "hinge_{name}"
value = "{law}"
"""
    run = started(text, 1e-6)
    for k in range(20):
        run.advance(0.1 * k, 0.1)
        t = 0.1 * (k + 1)
        for name, angle, bend in (
            ("b", 2.0 * math.sin(3.0 * t), -18.0 * math.sin(3.0 * t)), ("d", 1.5 * t * t, 3.0)
        ):  # fmt: skip
            mass = laws[name][1]
            torque = mass / 3.0 * bend + mass * G * math.cos(angle) / 2.0
            assert float(run[f"motor_{name}.torque"]) == pytest.approx(torque, abs=1e-8)


def test_a_force_that_reads_another_part_does_the_work_that_it_gives() -> None:
    """F follows the swing of A: its speed is the integral of 2 A.x, and its energy that work."""
    push = '[forces.push]\ntype = "force"\npoint = "F"\nvalue = ["2*A.x", "0"]\n'
    run = started(FREE + pendulum("A", 1.0) + push, 1e-8)
    for k in range(20):
        run.advance(0.1 * k, 0.1)

    def rates(_: float, state: Array) -> Array:
        angle, rate, _, speed = state
        return np.array([rate, -G * math.sin(angle), speed, 4.0 * math.sin(angle)])

    start = [1.0, 0.0, 3.0, 1.0]
    angle, _, place, speed = solve_ivp(
        rates, (0, 2), start, method="DOP853", rtol=1e-12, atol=1e-12
    ).y[:, -1]
    assert steps_explicitly(run)
    assert of(run, "A.x", "F.x", "F.vx") == pytest.approx([math.sin(angle), place, speed], abs=1e-7)
    y, vx, vy = of(run, "A.y", "A.vx", "A.vy")
    assert 0.5 * (vx * vx + vy * vy) + G * y == pytest.approx(-G * math.cos(1.0), abs=1e-13)
    assert float(run["energy.work"]) == pytest.approx(0.25 * (speed**2 - 1.0), abs=1e-7)
    assert float(run["energy.error"]) < 1e-13


def test_a_linkage_beside_what_flies_costs_the_flight_no_momentum() -> None:
    """A spinning dumbbell falls beside a double pendulum: both keep what is theirs."""
    flying = """
[points.P]
position = [5, 0]
velocity = [0, 3]
mass = 1.0
[points.Q]
position = [6, 0]
velocity = [0, -1]
mass = 2.0
[joints.bar]
type = "distance"
points = ["P", "Q"]
"""
    lower = """
[points.B]
position = [2.0, 0.0]
mass = 1.0
[joints.low]
type = "distance"
points = ["A", "B"]
"""
    run = started(flying + pendulum("A", math.pi / 2) + lower, 1e-6, stop=5.0)
    for k in range(50):
        run.advance(0.1 * k, 0.1)
    t = 5.0
    assert steps_explicitly(run)
    p, q, vp, vq = (of(run, f"{name}x", f"{name}y") for name in ("P.", "Q.", "P.v", "Q.v"))
    assert (p + 2.0 * q) / 3.0 == pytest.approx([17.0 / 3.0, t / 3.0 - G * t * t / 2], abs=1e-11)
    # It turns at (vq - vp)/1 m about its centre: -4 rad/s.
    assert q - p == pytest.approx([math.cos(-4.0 * t), math.sin(-4.0 * t)], abs=1e-5)
    (rx, ry), (wx, wy) = q - p, vq - vp
    assert rx * wy - ry * wx == pytest.approx(-4.0, abs=1e-12)
    energy = 0.0
    for name in "AB":
        vx, vy, y = of(run, f"{name}.vx", f"{name}.vy", f"{name}.y")
        energy += 0.5 * (vx * vx + vy * vy) + G * y
    assert energy == pytest.approx(0.0, abs=5e-13)


def damped(name: str, y: float, stiffness: float, damping: float) -> str:
    """A mass of 1 kg on a spring, drawn 0.1 m off its rest."""
    ends = f'points = ["ground", "{name}"]\nat = [0, {y}]\n'
    return (
        f"[points.{name}]\nposition = [1.1, {y}]\nmass = 1.0\n"
        f'[forces.spring_{name}]\ntype = "spring"\n{ends}stiffness = {stiffness}\n'
        f"free_length = 1.0\n"
        f'[forces.damper_{name}]\ntype = "damper"\n{ends}damping = {damping}\n'
    )


@pytest.mark.parametrize("step", [0.1, 0.01])
@pytest.mark.parametrize("tolerance", [1e-4, 1e-6, 1e-8, 1e-10])
@pytest.mark.parametrize("other", [None, 0.0, 2.0])
def test_a_damped_part_comes_to_rest_alone_and_beside_another(other, tolerance, step):
    """X - 1 = 0.1 exp(-ct/2m)(cos wt + c/(2mw) sin wt) falls on, far below round-off of 50 J.

    The other part, of 100 N/m, swings on by itself or settles ten times as slowly.
    """
    text = 'name = "rest"\ndimension = 2\n' + damped("B", 0.0, 1e4, 20.0)
    laws = {"B": (1e4, 20.0)}
    if other is not None:
        text += damped("A", 3.0, 100.0, other)
        laws["A"] = (100.0, other)
    run = solver.Integrator(
        solver.assemble(
            solver.loads(f"{text}[solver]\ntolerance = {tolerance}\nmethod = 'fastest'\n")
        ),
        log=lambda _: None,
    )
    for _ in range(round(5.0 / step)):
        run.advance(run.time, step)
    for name, (k, c) in laws.items():
        omega = math.sqrt(k - 0.25 * c * c)
        swing = math.cos(omega * run.time) + 0.5 * c / omega * math.sin(omega * run.time)
        right = 1.0 + 0.1 * math.exp(-0.5 * c * run.time) * swing
        assert run[f"{name}.x"] == pytest.approx(right, abs=10.0 * tolerance + 1e-12)
    assert run["energy.error"] < 1e-13


@pytest.mark.parametrize("step", [0.1, 0.02])
@pytest.mark.parametrize("tolerance", [1e-4, 1e-6])
@pytest.mark.parametrize("mass", [1e-2, 1e-4])
def test_a_light_part_keeps_the_tolerance_beside_a_heavy_one(mass, tolerance, step):
    """A damped swing of 8 rad/s beside 1 kg that flies straight on, in steps that conserve.

    In a norm that sums both masses, 1e-4 kg may err by a hundred times the tolerance.
    """
    omega, zeta, drawn = 8.0, 0.05, 0.1
    text = damped("P", 0.0, mass * omega**2, 2 * zeta * mass * omega)
    text = text.replace("mass = 1.0", f"mass = {mass}")
    text += "[points.F]\nposition = [0, -1]\nvelocity = [0.2, 0]\nmass = 1.0\n"
    text += f"[solver]\ntolerance = {tolerance}\n[experiment]\nstop_time = 2.0\n"
    run = solver.Integrator(solver.assemble(solver.loads(f'name = "light"\ndimension = 2\n{text}')))
    fast = omega * math.sqrt(1.0 - zeta**2)
    for _ in range(round(2.0 / step)):
        run.advance(run.time, step)
        turn = fast * run.time
        swing = math.cos(turn) + zeta * omega / fast * math.sin(turn)
        right = 1.0 + drawn * math.exp(-zeta * omega * run.time) * swing
        assert run["P.x"] == pytest.approx(right, abs=3.0 * tolerance)
