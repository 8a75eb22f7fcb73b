"""Under a tolerance reactions are those of the state at the end of a step, at every order.

Newton's law along a rod, T = m (g cos a + l w^2), of places and velocities that the run itself
tells, so that errors of the path do not count; a driver's torque is J a'' + m g l sin a.
"""

from __future__ import annotations

import math

import pytest

import solver

PENDULUM = """
name = "p"
dimension = 2
gravity = [0, -9.81]
[points]
O = {{ position = [0, 0], fixed = true }}
P = {{ position = [0.6, -0.8], mass = 2.0 }}
[joints]
rod = {{ type = "distance", points = ["O", "P"] }}
[forces]
air = {{ type = "damper", points = ["P", "W"], damping = {damping} }}
[points.W]
position = [3, 0]
fixed = true
[solver]
tolerance = {tolerance}
order = {order}
"""
"""A rod of 1 m; its damper to the wall W pulls along the line to it."""

DRIVEN = """
name = "d"
gravity = [0, 0, -9.81]
[bodies]
arm = {{ position = [0.5, 0, 0], mass = 2.0, inertia = [0.1, 0.2, 0.3] }}
[joints.hinge]
type = "revolute"
bodies = ["ground", "arm"]
position = [0, 0, 0]
axis = [0, -1, 0]
[drivers]
motor = {{ type = "angle", joint = "hinge", value = "sin(2*t)" }}
[solver]
tolerance = {tolerance}
order = {order}
"""


@pytest.mark.parametrize("order", [2, 4, 6, 8])
@pytest.mark.parametrize("damping", [0.0, 0.5])
def test_a_rod_pulls_as_newtons_law_asks_for_at_the_end_of_a_step(order, damping):
    text = PENDULUM.format(damping=damping, tolerance=1e-6, order=order)
    run = solver.Integrator(solver.assemble(solver.loads(text)))
    for _ in range(10):
        run.advance(run.time, 0.1)
        x, y, vx, vy = (float(run[f"P.{name}"]) for name in ("x", "y", "vx", "vy"))
        to_wall = math.hypot(3.0 - x, y)
        along = ((3.0 - x) / to_wall, -y / to_wall)
        of_damper = -damping * (vx * along[0] + vy * along[1])  # on P, towards W
        inward = (-x, -y)
        pull = 2.0 * (vx**2 + vy**2) + 2.0 * 9.81 * -y
        pull -= of_damper * (along[0] * inward[0] + along[1] * inward[1])
        # Rows and their rates hold to the tolerance, which the pull multiplies by 2 v^2, and 2 g.
        assert abs(float(run["rod.force"]) - pull) < 60.0 * 1e-6


@pytest.mark.parametrize("order", [2, 4, 6, 8])
def test_a_driver_holds_what_its_formula_asks_for_at_the_end_of_a_step(order):
    run = solver.Integrator(
        solver.assemble(solver.loads(DRIVEN.format(tolerance=1e-6, order=order)))
    )
    for _ in range(10):
        run.advance(run.time, 0.1)
        turned, bend = math.sin(2.0 * run.time), -4.0 * math.sin(2.0 * run.time)
        asked = (0.2 + 2.0 * 0.25) * bend + 2.0 * 9.81 * 0.5 * math.cos(turned)
        assert float(run["motor.torque"]) == pytest.approx(asked, abs=1e-6 * 10.0)


@pytest.mark.parametrize("order", [0, 2, 4, 6, 8])
def test_reactions_leave_formulas_of_time_as_they_are(order):
    """Reactions are those before a jump at the present time; a formula has its value there."""
    text = PENDULUM.format(damping=0.5, tolerance=1e-6, order=order)
    text += '[outputs]\nload = { value = "-7*(t >= 0.5)", unit = "N" }\n'
    text += '[forces.push]\ntype = "force"\npoint = "P"\nvalue = ["-7*(t >= 0.5)", 0]\n'
    run = solver.Integrator(solver.assemble(solver.loads(text)))
    for _ in range(5):
        run.advance(run.time, 0.1)
    assert run.get(range(len(run.model.variables)))[run.model.index("load")] == -7.0


STOPPED = """
name = "s"
dimension = 2
[inputs]
push = {{ start = 0.0, unit = "N" }}
[points]
O = {{ position = [0, 0], fixed = true }}
A = {{ position = [1, 0], mass = 1 }}
[joints]
rod = {{ type = "distance", points = ["O", "A"] }}
[forces]
f = {{ type = "force", point = "A", value = ["{value}", 0] }}
[outputs]
load = {{ value = "{value}", unit = "N" }}
"""


@pytest.mark.parametrize("order", [0, 2, 4, 8])
@pytest.mark.parametrize(
    "value",
    ["(100 if t >= 0.5 else 20) + push", "push*(3 if t >= 0.5 else 1)"],
)  # fmt: skip
def test_where_a_load_jumps_its_reaction_is_on_the_side_of_outputs_by_a_formula(value, order):
    """A rod along the load carries all of it, at once."""
    run = solver.Integrator(solver.assemble(solver.loads(STOPPED.format(value=value))))
    run["solver.tolerance"], run["solver.order"] = 1e-6, order
    for k in range(10):
        run["push"] = 50.0 if k in (2, 5) else 10.0
        assert float(run["rod.force"]) == pytest.approx(float(run["load"]), abs=1e-9)
        run.advance(run.time, 0.1)


def test_a_driver_whose_rate_jumps_asks_for_the_torque_of_what_follows():
    """From t = 0.5 on it accelerates by 4 rad/s2: J = 0.1 + 2 (0.5)^2 about the hinge."""
    text = DRIVEN.replace("sin(2*t)", "2*max(t - 0.5, 0)**2").replace("-9.81", "0")
    run = solver.Integrator(solver.assemble(solver.loads(text.format(tolerance=1e-6, order=0))))
    for k in range(10):
        run.advance(run.time, 0.1)
        asked = 4.0 * (0.2 + 2.0 * 0.25) if k >= 4 else 0.0
        assert float(run["motor.torque"]) == pytest.approx(asked, abs=1e-6)


HUNG_TWICE = """
name = "door"
gravity = [0, 0, -10]
[bodies.door]
position = [0.4, 0, 1.0]
mass = 2
inertia = [0.7, 0.8, 0.11]
velocity = [0, 0.4, 0]
angular_velocity = [0, 0, 1.0]
[joints]
h1 = {{ type = "{kind}", bodies = ["ground", "door"], position = [0, 0, {low}], axis = [0, 0, 1] }}
[joints.h2]
type = "revolute"
bodies = ["ground", "door"]
position = [0, 0, {high}]
axis = [0, 0, 1]
"""


@pytest.mark.parametrize("kind", ["revolute", "cylindrical"])
@pytest.mark.parametrize(("low", "high"), [(0.3, 1.7), (0.2, 1.3), (1.0, 1.1)])
@pytest.mark.parametrize("tolerance", [0.0, 1e-8])
def test_what_a_door_asks_of_two_hinges_is_split_at_the_start_as_later(kind, low, high, tolerance):
    """The sum is m a = (-0.8, 0, 20) N; nothing changes along the axis, and little in 1 ms."""
    text = HUNG_TWICE.format(kind=kind, low=low, high=high)
    run = solver.Integrator(solver.assemble(solver.loads(text)))
    run["solver.tolerance"] = tolerance
    forces = []
    for step in (1e-3, 1e-3, 0.1):
        forces.append([[float(run[f"{h}.force.{k}"]) for k in "xyz"] for h in ("h1", "h2")])
        run.advance(run.time, step)
    for at_a_time in forces:
        assert sum(z for *_, z in at_a_time) == pytest.approx(20.0, abs=1e-6)
    assert sum(x for x, *_ in forces[0]) == pytest.approx(-0.8, abs=1e-6)
    largest = max(abs(x) for x in (*forces[0][0], *forces[0][1]))
    for first, later in zip(*forces[:2], strict=True):
        assert first == pytest.approx(later, abs=0.01 * largest)
        assert first[2] == pytest.approx(later[2], abs=1e-6 * largest)
