"""Orders 2, 4, 6 and 8 in coordinates and velocities, with energy at round-off.

Without dampers a step is a composition of conserving pairs: Suzuki's five stages, nine of Kahan and
Li 1997 and fifteen of Suzuki and Umeno. With dampers it is the weighted end of covers by pairs, put
back onto what pairs keep: every cover goes forwards, so that each of its dampers takes energy;
constraints, momenta and ledger hold after the step as after a pair. That every scene has the order
asked for is in `test_steps_of_scenes.py`.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

import solver
from solver.runtime import Integrator
from tests.support.mechanisms.exact_motions import double_pendulum_motion
from tests.support.mechanisms.mechanism_runs import run as values_of
from tests.support.mechanisms.mechanism_runs import scene
from tests.support.mechanisms.problems import Array, double_pendulum, observed_order
from tests.support.mechanisms.problems import scene as scene_of

pytestmark = pytest.mark.filterwarnings("ignore:joints do not allow the velocity")  # flying

ORDERS = (4, 6, 8)
QUIET = ["energy.error", "constraint.position"]
MANIPULATOR = """
name = "manipulator"
gravity = [0, 0, -3]
[bodies.crank]
position = [0.25, 0, 0]
mass = 1.0
inertia = [0.02, 0.05, 0.06]
[bodies.arm]
position = [0.5, 0.3, 0]
mass = 0.8
inertia = [0.1, 0.08, 0.12]
[bodies.tool]
position = [0.5, 0.6, -0.2]
mass = 0.5
inertia = [0.05, 0.06, 0.08]
[joints.bearing]
type = "revolute"
bodies = ["ground", "crank"]
position = [0, 0, 0]
axis = [0, 0, 1]
[joints.elbow]
type = "revolute"
bodies = ["crank", "arm"]
position = [0.5, 0, 0]
axis = [1, 0, 0.3]
[joints.wrist]
type = "universal"
bodies = ["arm", "tool"]
position = [0.5, 0.6, 0]
axes = [[1, 0, 0], [0, 1, 0]]
[drivers]
motor = { type = "angle", joint = "bearing", value = "0.8*sin(2*t) + 0.3*t" }
[forces]
spring = { type = "torsion_spring", joint = "elbow", stiffness = 1.0, free_angle = 0.3 }
[solver]
assemble = true
"""
"""A driven crank, an arm on a skew hinge with a spring, and a tool on a universal joint."""
BRAKE = '[forces.brake]\ntype = "torsion_damper"\njoint = "elbow"\ndamping = 0.2\n'
DRIVEN = MANIPULATOR + BRAKE
"""Two bodies on a crank that a motor turns, with a damper in the elbow."""

FLYING = """
name = "flying"
[points]
A = { position = [0, 0, 0], velocity = [0.3, 0, 0.2], mass = 1.0 }
B = { position = [1, 0, 0], velocity = [0, 1, 0], mass = 0.7 }
C = { position = [1, 1, 0], velocity = [-1, 0, 0.5], mass = 0.4 }
D = { position = [0.2, 0.9, 0.5], velocity = [0, -1, 0.3], mass = 1.3 }
[joints]
AB = { type = "distance", points = ["A", "B"] }
CD = { type = "distance", points = ["C", "D"] }
[forces]
BC = { type = "spring", points = ["B", "C"], stiffness = 20.0, free_length = 0.8 }
AD = { type = "spring", points = ["A", "D"], stiffness = 10.0, free_length = 0.8 }
brake = { type = "damper", points = ["B", "C"], damping = 0.5 }
second = { type = "damper", points = ["A", "D"], damping = 0.3 }
[solver]
assemble = true
"""
"""Four points on two rods, springs and dampers, which nothing else holds."""

OSCILLATOR = """
name = "oscillator"
dimension = 2
gravity = [0, 0]
[points]
A = { position = [2, 0], mass = 2.0, velocity = [0.5, 0] }
[forces.spring]
type = "spring"
points = ["ground", "A"]
at = [0, 0]
stiffness = 18.0
free_length = 1.5
[forces.brake]
type = "damper"
points = ["ground", "A"]
at = [0, 0]
damping = 2.0
"""

RESTLESS = """
name = "restless"
dimension = 2
gravity = [0, -9.81]
[points]
O = { position = [0, 0], fixed = true }
A = { position = [0.8, -0.6], mass = 1.0 }
B = { position = [1.5, -0.4], mass = 0.5 }
[joints]
rod = { type = "distance", points = ["O", "A"] }
[forces.spring]
type = "spring"
points = ["A", "B"]
stiffness = "20 + 8*sin(5*t)"
free_length = "0.7 + 0.1*cos(3*t)"
[forces]
brake = { type = "damper", points = ["A", "B"], damping = "0.3 + 0.2*cos(4*t)" }
pull = { type = "force", point = "B", value = ["sin(2*t)", 0] }
"""
"""Laws of spring and damper, and a load, that follow the time."""


LOCKED = """
name = "locked"
dimension = 2
gravity = [0, -9.81]
[points]
O = { position = [0, 0], fixed = true }
A = { position = [0.8, -0.6], mass = 1.0 }
B = { position = [1.4, 0.2], mass = 1.0 }
[joints]
upper = { type = "distance", points = ["O", "A"] }
lower = { type = "distance", points = ["A", "B"] }
[forces]
brake = { type = "damper", points = ["O", "A"], damping = 2.0 }
[solver]
order = 4
step_size = 0.025
"""


def moved(text: str, order: int, n: int, stop: float) -> Integrator:
    """Run of n steps."""
    run = Integrator(solver.assemble(solver.loads(text)))
    run["solver.step_size"], run["solver.order"] = stop / n, float(order)
    run.advance(0.0, stop)
    return run


def coordinates(run: Integrator) -> Array:
    """Coordinates and velocities, with what rounding left over."""
    q, q_low, v, v_low = (
        np.array(run.state.vectors[name]) for name in ("q", "q_low", "v", "v_low")
    )
    return np.concatenate([q + q_low, v + v_low])


@pytest.mark.parametrize(
    ("order", "steps"),
    [(2, (100, 200, 400)), (4, (20, 40, 80)), (6, (20, 40, 80)), (8, (16, 24, 32))],
)
def test_a_double_pendulum_is_met_to_the_order_asked_for(order, steps):
    names = [f"{point}.{part}" for part in ("x", "y", "vx", "vy") for point in "AB"]
    q, v = double_pendulum_motion(np.array([0.0, 2.0]), math.pi / 6)
    exact = np.concatenate([q[-1].T.ravel(), v[-1].T.ravel()])
    drawn = scene_of(double_pendulum(math.pi / 6))
    ends = np.array(
        [values_of(drawn, [*names, *QUIET], 2.0 / n, 2.0, order=order)[-1] for n in steps]
    )
    errors = np.abs(ends[:, :8] - exact)
    lengths = [1.0 / n for n in steps]
    assert observed_order(lengths, errors[:, :4].max(axis=1)) == pytest.approx(order, abs=0.2)
    assert observed_order(lengths, errors[:, 4:].max(axis=1)) == pytest.approx(order, abs=0.2)
    assert ends[:, 8:].max() < 1e-14


@pytest.mark.parametrize("order", ORDERS)
@pytest.mark.parametrize(
    ("text", "counts"),
    [
        (DRIVEN, {4: (10, 20, 40), 6: (6, 10, 14), 8: (4, 6, 8)}),
        (FLYING, {4: (20, 40, 80), 6: (20, 28, 40), 8: (6, 10, 15)}),
        (RESTLESS, {4: (20, 40, 80), 6: (10, 16, 24), 8: (8, 11, 15)}),
    ],
    ids=["driven", "flying", "laws_of_time"],
)
def test_with_dampers_the_order_is_the_one_asked_for(text, counts, order):
    exact = coordinates(moved(text, 8, 60, 1.0))
    errors = [np.abs(coordinates(moved(text, order, n, 1.0)) - exact).max() for n in counts[order]]
    # What brings the energy onto the ledger has a size of its own: some slopes are steeper.
    assert order - 0.4 < observed_order([1.0 / n for n in counts[order]], errors) < order + 1.2


@pytest.mark.parametrize("order", ORDERS)
def test_a_damped_oscillator_loses_what_the_exact_one_loses(order):
    # x'' + x' + 9 x = 0 from (0.5, 0.5): x = e^(-t/2) (a cos wt + b sin wt), w^2 = 9 - 1/4.
    run = moved(OSCILLATOR, order, {4: 40, 6: 16, 8: 10}[order], 1.0)
    w = math.sqrt(8.75)
    a, b = 0.5, 0.75 / w
    decay, c, s = math.exp(-0.5), math.cos(w), math.sin(w)
    x = decay * (a * c + b * s)
    v = decay * ((b * w - 0.5 * a) * c - (a * w + 0.5 * b) * s)
    lost = 0.5 * 2.0 * (0.25 - v * v) + 0.5 * 18.0 * (0.25 - x * x)
    assert run["A.x"] == pytest.approx(1.5 + x, abs=1e-6)
    assert run["energy.dissipated"] == pytest.approx(lost, abs=1e-5)
    assert abs(float(run["energy.balance"])) < 1e-14


@pytest.mark.parametrize("order", ORDERS)
@pytest.mark.parametrize(
    "name", ["flyball_governor", "double_wishbone", "cardan_shaft", "differential"]
)
def test_ledger_and_constraints_hold_and_no_step_gives_energy(name, order):
    run = Integrator(solver.assemble(solver.load(scene(name))))
    step = 2.0 * run.state.head["step_size"]
    run["solver.step_size"], run["solver.order"] = step, float(order)
    lost = [0.0]
    for _ in range(20):
        run.advance(run.time, step)
        lost.append(float(run["energy.dissipated"]))
        assert run["solver.order_in_use"] == order
        assert float(run["energy.error"]) < 1e-13
        assert float(run["constraint.position"]) < 1e-14
        # Rates of drivers are difference quotients, with a rounding error of 1e-14 over the step.
        assert float(run["constraint.velocity"]) < 1e-10
    assert min(np.diff(lost)) >= 0.0
    assert lost[-1] > 0.0


@pytest.mark.parametrize("order", ORDERS)
def test_momenta_stay_where_nothing_external_acts(order):
    run = Integrator(solver.assemble(solver.loads(FLYING)))
    run["solver.step_size"], run["solver.order"] = 0.05, float(order)
    names = [v.name for v in run.model.variables if "momentum" in v.name]
    assert len(names) == 6
    before = run.get([run.model.index(name) for name in names])
    run.advance(0.0, 1.0)
    after = run.get([run.model.index(name) for name in names])
    assert np.abs(np.array(after) - np.array(before)).max() < 1e-14
    assert float(run["energy.dissipated"]) > 0.1


@pytest.mark.parametrize("order", ORDERS)
def test_about_the_vertical_the_angular_momentum_stays_under_gravity(order):
    # Spring and damper hang on the origin: of all momenta this one is kept, and found to be.
    run = Integrator(solver.assemble(solver.load(scene("spring_pendulum"))))
    run["solver.step_size"], run["solver.order"] = 0.05, float(order)
    before = float(run["angular_momentum.z"])
    run.advance(0.0, 5.0)
    assert float(run["angular_momentum.z"]) == pytest.approx(before, abs=1e-13)


UNRESOLVED = """
name = "pendulum_with_a_light_point"
dimension = 2
gravity = [0, -9.81]
[points]
A = { position = [0.6, -0.8], mass = 1.0 }
B = { position = [1.2, -0.8], mass = 1e-4 }
[joints]
rod = { type = "distance", points = ["ground", "A"], at = [0, 0] }
[forces]
spring = { type = "spring", points = ["A", "B"], stiffness = 1e4 }
"""


def test_steps_too_long_for_weights_are_left_of_order_two_and_that_is_said():
    # Half a period of the spring in a step: the ends of covers do not tell powers of their length.
    said: list[str] = []
    run = Integrator(solver.assemble(solver.loads(OSCILLATOR)), log=said.append)
    run["solver.step_size"], run["solver.order"] = 1.0, 4.0
    run.advance(0.0, 2.0)
    assert run["solver.order_in_use"] == 2.0
    assert abs(float(run["energy.balance"])) < 1e-14
    (sentence,) = said
    assert sentence.startswith("solver.order is 4, but steps are of order 2")


KICKED = """
name = "kicked"
dimension = 2
[points]
A = { position = [1.5, 0], mass = 1.0 }
[forces]
spring = { type = "spring", points = ["ground", "A"], at = [0, 0], stiffness = 9, free_length = 1 }
brake = { type = "damper", points = ["ground", "A"], at = [0, 0], damping = 1.0 }
kick = { type = "force", point = "A", value = ["100*exp(-((t - 0.3)/0.02)**2)", 0] }
[solver]
order = 4
step_size = 0.25
"""
FAR_FLOOR = """
[points.B]
position = [0, 1e3]
mass = 1.0
[contacts]
floor = { type = "plane", point = "B", axis = [0, 1] }
"""


@pytest.mark.parametrize("contacts", ["", FAR_FLOOR], ids=["none", "far"])
def test_a_step_of_order_two_among_others_is_counted_and_said(contacts):
    # The second of four equal steps has the kick, whose weights change it by more than its size.
    said: list[str] = []
    run = Integrator(solver.assemble(solver.loads(KICKED + contacts)), log=said.append)
    counts = []
    for _ in range(2):
        run.advance(run.time, 1.0)
        assert run["solver.order_in_use"] == 4.0  # of the last one
        counts.append(float(run["solver.as_pairs"]))
    assert counts == [1.0, 0.0]
    (sentence,) = said
    assert sentence.startswith("solver.order is 4, but steps are of order 2: dampers take energy")


def test_springs_that_a_tolerance_leaves_unresolved_are_named_and_no_losses():
    # 1e4 rad/s beside a pendulum of 1 s: nothing takes energy out.
    said: list[str] = []
    run = Integrator(solver.assemble(solver.loads(UNRESOLVED)), log=said.append)
    run["solver.order"], run["solver.tolerance"] = 4.0, 1e-3
    run.advance(0.0, 0.5)
    assert run["solver.order_in_use"] == 2.0
    (sentence,) = [text for text in said if "order 2" in text]
    assert "springs are much faster than the motion" in sentence
    assert "energy out" not in sentence


def test_a_damper_that_cannot_move_leaves_the_order():
    # It lies along a rod: its weighted losses are round-off, of either sign.
    model = solver.assemble(solver.loads(LOCKED))
    mechanism = Integrator(model)
    mechanism.initialise()
    for _ in range(40):
        mechanism.advance(mechanism.time, 0.025)
        assert mechanism["solver.order_in_use"] == 4.0
    assert float(mechanism["energy.dissipated"]) >= 0.0
