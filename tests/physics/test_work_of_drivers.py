"""What drivers feed in: the change of energy to round-off, the integral of their power, force.

A driver's work is its multiplier times the change of what it prescribes, so that energy minus work
stays to the last digit; power and force are those of the output's time, exact to second order.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

import solver
from tests.support.mechanisms.mechanism_runs import steps_explicitly
from tests.support.mechanisms.problems import Array, observed_order
from tests.support.mechanisms.work_sums import ROUND_OFF, trapezoids, vector

_PLANE = 'name = "driven"\ndimension = 2\ngravity = [0, -10]\n[solver]\nassemble = true\n'
_SPACE = 'name = "driven"\ngravity = [0, 0, -10]\n[solver]\nassemble = true\n'
_FLAT = "mass = 2.0\ninertia = 0.2\n"
_BULKY = "mass = 2.0\ninertia = [0.1, 0.2, 0.25]\n"
_HINGE = '[joints]\nj = { type = "revolute", bodies = ["ground", "A"], position = '

SCENES = {
    "place of a point in the plane": _PLANE
    + """[points]
P = { position = [0.3, 0] }
Q = { position = [0.3, -1], mass = 2.0 }
[joints]
rod = { type = "distance", points = ["P", "Q"] }
[drivers]
motor = { type = "position", point = "P", value = ["0.3 + 0.2*t**2", "0.8*sin(2*t)"] }
""",
    "place of a body in the plane": _PLANE
    + f"""[bodies.A]
position = [0.3, 0]
{_FLAT}points = {{ tip = [0.4, 0.1] }}
[drivers.motor]
type = "position"
point = "A.tip"
value = ["0.7 + 0.2*t**2", "0.1 + 0.8*sin(2*t)"]
""",
    "distance in the plane": _PLANE
    + """[points]
P = { position = [0.3, -0.4], mass = 2.0 }
[drivers.motor]
type = "distance"
points = ["ground", "P"]
at = [0, 0]
value = "0.5 + 0.2*sin(t)**2"
""",
    "angle in the plane": _PLANE
    + f"""[bodies.A]
position = [0, 0]
{_FLAT}center_of_mass = [0.3, 0]
{_HINGE}[0, 0] }}
[drivers]
motor = {{ type = "angle", joint = "j", value = "0.8*sin(2*t)" }}
""",
    "displacement in the plane": _PLANE
    + f"""[bodies.A]
position = [0, 0]
{_FLAT}[joints]
j = {{ type = "prismatic", bodies = ["ground", "A"], axis = [3, 4] }}
[drivers]
motor = {{ type = "displacement", joint = "j", value = "0.8*sin(2*t)" }}
""",
    "place of a point in space": _SPACE
    + """[points]
P = { position = [0.3, 0, 0] }
Q = { position = [0.3, 0, -1], mass = 2.0 }
[joints]
rod = { type = "distance", points = ["P", "Q"] }
[drivers.motor]
type = "position"
point = "P"
value = ["0.3 + 0.2*t**2", "0.8*sin(2*t)", "0.1*sin(t)"]
""",
    "place of a body in space": _SPACE
    + f"""[bodies.A]
position = [0.3, 0, 0]
{_BULKY}points = {{ tip = [0.4, 0.1, 0] }}
[drivers.motor]
type = "position"
point = "A.tip"
value = ["0.7 + 0.2*t**2", "0.1 + 0.8*sin(2*t)", "0.1*t"]
""",
    "distance in space": _SPACE
    + """[points]
P = { position = [0.3, 0.1, -0.4], velocity = [-0.05, 0.15, 0], mass = 2.0 }
[drivers.motor]
type = "distance"
points = ["ground", "P"]
at = [0, 0, 0]
value = "sqrt(0.26) + 0.2*sin(t)**2"
""",
    "angle in space": _SPACE
    + f"""[bodies.A]
position = [0, 0, 0]
{_BULKY}center_of_mass = [0.3, 0, 0]
{_HINGE}[0, 0, 0], axis = [0, -1, 0] }}
[drivers]
motor = {{ type = "angle", joint = "j", value = "0.8*sin(2*t)" }}
""",
    "displacement in space": _SPACE
    + f"""[bodies.A]
position = [0, 0, 0]
{_BULKY}[joints]
j = {{ type = "cylindrical", bodies = ["ground", "A"], position = [0, 0, 0], axis = [3, 0, 4] }}
[drivers]
motor = {{ type = "displacement", joint = "j", value = "0.8*sin(2*t)" }}
""",
}


def run(name: str, h: float, **settings: str) -> solver.Trajectory:
    """The scene over a second, at every pair of half steps."""
    scene = solver.loads(SCENES[name])
    return solver.simulate(scene, stop_time=1.0, step_size=h, internal_step=h, **settings)


@pytest.mark.parametrize("name", SCENES)
def test_the_work_of_a_driver_is_the_change_of_energy_and_the_integral_of_its_power(name):
    errors, steps = [], [0.02, 0.01, 0.005]
    for h in steps:
        found = run(name, h)
        work, energy = found["energy.work"], found["energy.total"]
        assert energy - energy[0] == pytest.approx(work, abs=20 * ROUND_OFF)
        assert np.ptp(work) > 1.0
        errors.append(np.abs(work - trapezoids(found["motor.power"], h)).max())
    assert observed_order(steps, errors) == pytest.approx(2.0, abs=0.2)


def swing_torque(t: Array) -> Array:
    """J theta'' + m g l cos theta about the hinge."""
    return -0.38 * 3.2 * np.sin(2 * t) + 6.0 * np.cos(0.8 * np.sin(2 * t))


def slope_force(t: Array) -> Array:
    """M (s'' + g sin) along an axis that rises by 4 in 5."""
    return 2.0 * (-3.2 * np.sin(2 * t) + 8.0)


KNOWN: dict[str, tuple[str, Callable[[Array], Array]]] = {
    "angle in the plane": ("motor.torque", swing_torque),
    "angle in space": ("motor.torque", swing_torque),
    "displacement in the plane": ("motor.force", slope_force),
    "displacement in space": ("motor.force", slope_force),
}


@pytest.mark.parametrize("name", KNOWN)
def test_a_driver_feels_what_the_equations_of_motion_ask_of_it(name):
    output, law = KNOWN[name]
    errors, steps = [], [0.02, 0.01, 0.005]
    for h in steps:
        found = run(name, h)[output]
        errors.append(np.abs(found - law(h * np.arange(len(found)))).max())
    assert observed_order(steps, errors) == pytest.approx(2.0, abs=0.1)
    assert errors[-1] < 1e-3


def test_a_hand_that_moves_a_mass_feels_its_inertia_and_weight():
    text = (
        _PLANE
        + """[points]
P = { position = [0.3, 0], mass = 2.0 }
[drivers]
motor = { type = "position", point = "P", value = ["0.3 + 0.2*t**2", "0.8*sin(2*t)"] }
"""
    )
    h = 0.005
    found = solver.simulate(solver.loads(text), stop_time=1.0, step_size=h, internal_step=h)
    t = h * np.arange(len(found.t))
    force = np.column_stack([np.full_like(t, 0.8), 20 - 6.4 * np.sin(2 * t)])
    assert vector(found, "motor.force.", "xy") == pytest.approx(force, abs=10 * h**2)
    power = np.sum(force * np.column_stack([0.4 * t, 1.6 * np.cos(2 * t)]), axis=1)
    assert found["motor.power"] == pytest.approx(power, abs=20 * h**2)


def follow(name: str, tolerance: float, h: float, outputs: list[str]) -> dict[str, Array]:
    """Outputs at every communication step of explicit steps over a second."""
    integrator = solver.Integrator(solver.assemble(solver.loads(SCENES[name])))
    integrator["solver.tolerance"], integrator["solver.method"] = tolerance, "fastest"
    integrator.initialise()
    found = [[float(integrator[output]) for output in outputs]]
    for _ in range(round(1.0 / h)):
        integrator.advance(integrator.time, h)
        assert steps_explicitly(integrator)
        found.append([float(integrator[output]) for output in outputs])
    return dict(zip(outputs, np.transpose(found), strict=True))


@pytest.mark.parametrize("name", SCENES)
def test_explicit_steps_know_a_drivers_work_that_is_the_integral_of_its_power(name):
    h = 0.01  # Simpson's rule is right to 2e-6 J
    found = follow(name, 1e-9, h, ["energy.work", "energy.total", "motor.power"])
    power, work = found["motor.power"], found["energy.work"]  # which is what the ledger lacked
    assert found["energy.total"] - found["energy.total"][0] == pytest.approx(work, abs=ROUND_OFF)
    simpson = h / 3.0 * (power[:-2:2] + 4.0 * power[1::2] + power[2::2])
    assert np.cumsum(simpson) == pytest.approx(work[2::2], abs=1e-5)


@pytest.mark.parametrize("name", KNOWN)
def test_a_driver_of_explicit_steps_feels_what_the_equations_of_motion_ask_of_it(name):
    output, law = KNOWN[name]
    found = follow(name, 1e-9, 0.1, [output])[output]
    assert found == pytest.approx(law(0.1 * np.arange(len(found))), abs=1e-7)


LEVER = """
name = "lever"
dimension = 2
gravity = [0, -10]
[inputs]
u = {{ interpolation = "{interpolation}" }}
[bodies]
A = {{ position = [0, 0], mass = 2.0, inertia = 0.2, center_of_mass = [0.3, 0] }}
[joints]
j = {{ type = "revolute", bodies = ["ground", "A"], position = [0, 0] }}
[drivers]
motor = {{ type = "angle", joint = "j", value = "{value}" }}
"""


FASTEST = [{"tolerance": x, "method": "fastest"} for x in (1e-4, 1e-8)]
CONSERVING = [{"tolerance": x} for x in (1e-4, 1e-8)]


@pytest.mark.parametrize(
    ("interpolation", "value", "settings"),
    [
        *(("ramp", "u", x) for x in ({"step_size": 0.01}, *FASTEST, *CONSERVING)),
        *(("hold", "u*t", x) for x in ({"step_size": 0.01}, *FASTEST, *CONSERVING)),
    ],
)
def test_a_driver_from_an_input_is_where_the_input_says_and_books_its_work(
    interpolation, value, settings
):
    text = LEVER.format(interpolation=interpolation, value=value)
    integrator = solver.Integrator(solver.assemble(solver.loads(text)))
    for name, setting in settings.items():
        integrator[f"solver.{name}"] = setting
    integrator.initialise()
    start = float(integrator["energy.total"])
    before = 0.0
    for k in range(60):
        u = 0.1 * np.sin(0.3 * (k + 1))
        integrator["u"] = u
        integrator.advance(integrator.time, 0.05)
        angle = u if value == "u" else u * integrator.time
        assert integrator["j.angle"] == pytest.approx(angle, abs=1e-12)
        if interpolation == "ramp":  # the rate jumps at a communication point, from the first on
            assert integrator["j.angular_velocity"] == pytest.approx((u - before) / 0.05, abs=1e-4)
            before = u
        elif "step_size" not in settings:  # steps for a tolerance turn it at u from the jump on
            assert integrator["j.angular_velocity"] == pytest.approx(u, abs=1e-4)
        gained = float(integrator["energy.total"]) - start
        near = 20 * ROUND_OFF + 1e-14 * abs(gained)  # held inputs jump: thousands of joules
        assert gained == pytest.approx(float(integrator["energy.work"]), abs=near)
        assert abs(float(integrator["energy.balance"])) < near
