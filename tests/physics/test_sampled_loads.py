"""Loads that read the mechanism are sampled; a run says where that is too seldom."""

from __future__ import annotations

import math
import random
import zipfile
from pathlib import Path

import numpy as np
import pytest

import solver
from build_fmu import build
from build_fmu.command_line import main
from build_fmu.run import run_fmu

PINNED = """
dimension = 2
[bodies]
B = {{ position = [0, 0], mass = 1.0, inertia = {J}, angular_velocity = 2.0 }}
[joints]
pin = {{ type = "revolute", bodies = ["ground", "B"], position = [0, 0] }}
[forces]
law = {{ type = "joint_torque", joint = "pin", value = "{law}" }}
"""
PIN = f'name = "pinned"{PINNED}[solver]\nstep_size = {{h}}\n'

LOADS = {
    "force": """
dimension = 2
[points]
A = {{ position = [0, 0], mass = {J}, velocity = [2, 0] }}
[forces]
law = {{ type = "force", point = "A", value = ["-{c}*A.vx", 0] }}
""",
    "joint_torque": PINNED.replace("{law}", "-{c}*pin.angular_velocity"),
    "torque": """
dimension = 2
[bodies]
B = {{ position = [0, 0], mass = 1.0, inertia = {J}, angular_velocity = 2.0 }}
[forces]
law = {{ type = "torque", body = "B", value = "-{c}*B.angular_velocity" }}
""",
    "spatial torque": """
[bodies]
B = {{ position = [0, 0, 0], mass = 1, inertia = [{J}, {J}, {J}], angular_velocity = [2, 0, 0] }}
[joints.pin]
type = "revolute"
bodies = ["ground", "B"]
position = [0, 0, 0]
axis = [1, 0, 0]
[forces]
law = {{ type = "torque", body = "B", value = ["-{c}*pin.angular_velocity", 0, 0] }}
""",
}
"""A damper of constant c on an inertia J, by each kind of load."""


def said_of(text: str, *, stop: float = 2.0) -> tuple[list[str], float]:
    """What a run says, and the largest sampling; one that has been reported may blow up and end."""
    said: list[str] = []
    run = solver.Integrator(solver.assemble(solver.loads(text)), log=said.append)
    largest = 0.0
    for _ in range(100):
        try:
            run.advance(run.time, stop / 100)
        except solver.StepError:
            assert said
            break
        largest = max(largest, float(run["solver.sampling"]))
    return [text for text in said if "evaluated too seldom" in text], largest


@pytest.mark.parametrize("kind", LOADS)
def test_a_damper_written_as_a_load_is_reported_beyond_its_sampled_stability(kind):
    """That is c h/J = 1 with h half a step: the velocity is then zero after it."""
    chance = random.Random(kind)
    for _ in range(5):
        inertia, step = 10.0 ** chance.uniform(-3, 3), 10.0 ** chance.uniform(-4, -2)
        limit = inertia / (0.5 * step)
        for gain in (0.1, 0.8, 1.3, 3.0):
            text = LOADS[kind].format(J=inertia, c=gain * limit)
            text = f'name = "damped"{text}[solver]\nstep_size = {step}\n'
            said, largest = said_of(text, stop=100 * step)
            assert bool(said) == (gain > 1.0) == (largest > 1.0)
            assert all(text.startswith("force 'law' is evaluated too seldom") for text in said)


@pytest.mark.parametrize("damping", [5, 50, 150, 250, 500, 2000])
def test_an_end_stop_is_reported_where_it_throws_back_faster_than_it_was_hit(damping):
    law = f"-(1000*(pin.angle - 1) + {damping}*pin.angular_velocity) if pin.angle > 1 else 0"
    said, _ = said_of(PIN.format(J=1.0, h=0.01, law=law))
    assert len(said) == (damping * 0.005 > 1.0)


@pytest.mark.parametrize("h", [0.01, 0.001, 0.0001])
def test_a_law_that_alternates_from_half_step_to_half_step_is_reported_at_any_step(h):
    (sentence,), _ = said_of(PIN.format(J=1.0, h=h, law=f"-2*tanh({10 / h}*pin.angular_velocity)"))
    assert "it alternates or reverses what it should stop" in sentence


@pytest.mark.parametrize(
    "law",
    [
        "-2*atan(pin.angular_velocity/0.05)",
        "-3*pin.angle - 0.2*pin.angular_velocity",
        "5*sin(40*t) - 3*pin.angle**3",
        "-0.3*pin.angular_velocity*abs(pin.angular_velocity)",
        "-100*(pin.angle - 1) - 2*pin.angular_velocity if pin.angle > 1 else 0",
    ],
)
def test_loads_that_are_sampled_often_enough_are_not_reported(law):
    said, largest = said_of(PIN.format(J=1.0, h=0.01, law=law), stop=6.0)
    assert said == []
    assert 0.0 < largest < 0.5


@pytest.fixture
def chattering(tmp_path) -> Path:
    scene = tmp_path / "chattering.toml"
    law = "-2*tanh(1000*pin.angular_velocity)"
    scene.write_text(PIN.format(J=1.0, h=0.01, law=law) + "[experiment]\nstop_time = 2.0\n")
    return scene


def test_check_fails_and_says_why(chattering, capsys):
    assert main(["check", str(chattering)]) == 1
    shown = capsys.readouterr()
    row = next(line for line in shown.out.splitlines() if "solver.sampling" in line)
    assert row.split()[-1] == "NO"
    assert "is evaluated too seldom" in shown.err


def test_the_log_and_the_page_of_an_fmu_say_it(chattering, tmp_path):
    fmu = build(chattering, tmp_path / "chattering.fmu")
    assert any("is evaluated too seldom" in text for text in run_fmu(fmu).messages)
    with zipfile.ZipFile(fmu) as archive:
        assert "is evaluated too seldom" in archive.read("documentation/index.html").decode()


@pytest.mark.parametrize("order", [0, 2, 4, 8])
@pytest.mark.parametrize("gain", [1.0, 300.0, 3e4])
def test_under_a_tolerance_loads_read_the_step_and_slow_a_body_as_their_formula_says(gain, order):
    """J w' = -c w: it turns by w_0 J/c until it stands."""
    text = PIN.format(J=1.0, h=0.01, law=f"-{gain}*pin.angular_velocity")
    run = solver.Integrator(
        solver.assemble(solver.loads(f"{text}tolerance = 1e-6\norder = {order}\n"))
    )
    first, speed = float(run["pin.angle"]), float(run["pin.angular_velocity"])
    for _ in range(10):
        run.advance(run.time, 0.1)
    turned = speed / gain * -math.expm1(-gain)
    assert run["pin.angle"] - first == pytest.approx(turned, abs=3e-6)
    assert run["pin.angular_velocity"] == pytest.approx(speed * math.exp(-gain), abs=3e-6 * speed)
    assert run["solver.sampling"] == 0.0


@pytest.mark.parametrize("tolerance", [1e-8, 1e-9, 1e-10])
def test_a_charge_that_drifts_in_a_magnetic_field_keeps_a_tight_tolerance(tolerance):
    """Of x'' = B y', y'' = -B x' - g: a circle of radius (1 + g/B)/B that drifts with -g/B."""
    field, weight = 20.0, 1.0
    text = """
    name = "charge"
    dimension = 2
    gravity = [0, -1]
    [points]
    A = { position = [0, 0], mass = 1, velocity = [1, 0] }
    [forces]
    magnet = { type = "force", point = "A", value = ["20*A.vy", "-20*A.vx"] }
    """
    run = solver.simulate(solver.loads(text), stop_time=10.0, step_size=1.0, tolerance=tolerance)
    drift = -weight / field
    speed = 1.0 - drift
    right = {
        "A.x": drift * run.t + speed / field * np.sin(field * run.t),
        "A.y": speed / field * (np.cos(field * run.t) - 1.0),
        "A.vx": drift + speed * np.cos(field * run.t),
        "A.vy": -speed * np.sin(field * run.t),
    }
    for name, value in right.items():  # of a size of 1 m and a speed of 1.1 m/s
        assert run[name] == pytest.approx(value, rel=0.0, abs=tolerance)


MOTOR = """
name = "motor"
dimension = 2
[inputs]
u = {{ unit = "1", start = 0.0 }}
[bodies.rotor]
position = [0, 0]
mass = 1.0
inertia = 1.0
[joints]
shaft = {{ type = "revolute", bodies = ["ground", "rotor"], position = [0, 0] }}
[forces]
motor = {{ type = "joint_torque", joint = "shaft", value = "{law}" }}
[experiment]
stop_time = 2
"""


@pytest.mark.parametrize(
    "law",
    [
        "u - 0.1*shaft.angular_velocity", "5*sin(t) - 2*shaft.angular_velocity",
        "max(t - 0.5, 0) - 0.1*shaft.angular_velocity",
        "20*(u - shaft.angle) - 6*shaft.angular_velocity",
        "sin(9*t) - 0.1*shaft.angular_velocity", "floor(3*t) - shaft.angular_velocity",
    ],
)  # fmt: skip
@pytest.mark.parametrize("order", [2.0, 0.0])
def test_a_motor_that_starts_from_rest_is_sampled_well(law, order, recwarn):
    """Its damping is far below the limit 2 J/h = 400 N.m.s, its stiffness below 4 J/h^2."""
    inputs = {"time": [0, 0.5, 1, 2], "u": [0, 0, 1, 1]}
    scene = solver.loads(MOTOR.format(law=law))
    trajectory = solver.simulate(scene, inputs=inputs, order=order)
    assert trajectory["solver.sampling"].max() <= 1.0
    assert not [w for w in recwarn if "too seldom" in str(w.message)]
