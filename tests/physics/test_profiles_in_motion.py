"""Profiles in motion: measured springs, dampers and cams keep energy, also inside an FMU."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.interpolate import CubicSpline

import solver
from build_fmu import build
from tests.fmu.test_model_description import root_of
from tests.fmu_instance import instance
from tests.twins import start

SPRING = """
name = "oscillator"
dimension = 2
[profiles]
rubber = { x = [-2, -1, -0.3, 0, 0.4, 1, 2], y = [-9, -3, -0.4, 0, 0.6, 3, 7], integrate = true }
[points]
A = { position = [1.5, 0], mass = 2.0 }
[joints]
rail = { type = "point_on_line", point = "A", axis = [1, 0] }
[forces]
spring = { FORCE }
[outputs]
whole = { value = "A.vx**2 + rubber(A.x)" }
[solver]
step_size = 0.25
"""
LAWS = {
    "potential": 'type = "potential", value = "rubber(A.x)"',
    "spring": 'type = "spring", points = ["ground", "A"], at = [-9, 0], '
    'energy = "rubber(length - 9)"',
}


@pytest.mark.parametrize("law", LAWS)
def test_a_measured_spring_keeps_its_energy_at_large_steps(law):
    """Some 20 steps a period, each of them over several points of the table."""
    run = start(SPRING.replace("FORCE", LAWS[law]))
    energy = run["whole"]
    for k in range(10000):
        run.advance(0.25 * k, 0.25)
        assert run["whole"] == pytest.approx(energy, rel=1e-13)
    assert run["energy.error"] < 1e-13


def test_the_force_of_a_measured_spring_is_its_table():
    run = start(SPRING.replace("FORCE", LAWS["spring"]).replace("1.5, 0", "1, 0"))
    assert run["spring.force"] == pytest.approx(3.0, rel=1e-14)


def test_a_measured_damper_takes_the_energy_of_its_table():
    """The point 2 dv/dt = -f(v), against the time that the velocity takes, the integral of 2/f."""
    v, force = [0.0, 1.0, 2.0, 4.0], [0.0, 1.0, 3.0, 4.0]
    text = (
        SPRING.partition("[profiles]")[0]
        + f"""
[profiles]
drag = {{ x = {v}, y = {force} }}
[points]
A = {{ position = [0, 0], velocity = [4, 0], mass = 2.0 }}
[forces]
brake = {{ type = "force", point = "A", value = ["-drag(A.vx)", 0] }}
[solver]
step_size = 1e-3
"""
    )
    run = start(text)
    for k in range(200):
        run.advance(0.01 * k, 0.01)
    curve = CubicSpline(v, force, bc_type="natural")
    speeds = np.linspace(run["A.vx"], 4.0, 20001)
    values = 2.0 / curve(speeds)
    time = np.sum(0.5 * (values[1:] + values[:-1]) * np.diff(speeds))
    assert time == pytest.approx(2.0, abs=1e-6)  # second order in steps of 1 ms


CAM = """
name = "cam"
dimension = 2
gravity = [0, -9.81]
[profiles]
lobe = { file = "lobe.csv", periodic = true }
[points]
follower = { position = [0, 0.3], mass = 0.5 }
[bodies.disc]
position = [0, 0]
mass = 1.0
inertia = 0.01
[joints]
shaft = { type = "revolute", bodies = ["ground", "disc"], position = [0, 0] }
guide = { type = "point_on_line", point = "follower", axis = [0, 1] }
[constraints]
rise = { value = "follower.y - 0.3 - lobe(shaft.angle)" }
[drivers]
motor = { type = "angle", joint = "shaft", value = "7*t" }
[outputs]
lift = { value = "lobe(7*t)" }
[experiment]
stop_time = 2.0
step_size = 0.01
"""
ANGLES = np.linspace(0.0, 2.0 * math.pi, 25)
LIFTS = 0.02 * (1.0 - np.cos(ANGLES)) ** 2


@pytest.fixture
def cam(tmp_path):
    rows = [
        f"{float(x)!r}, {float(y)!r}"
        for x, y in zip(ANGLES, LIFTS - LIFTS[-1] * (ANGLES > 6.0), strict=True)
    ]
    (tmp_path / "lobe.csv").write_text("\n".join(["angle,lift", *rows]))
    path = tmp_path / "cam.toml"
    path.write_text(CAM)
    return path


def test_a_cam_from_a_file_moves_its_follower_and_books_its_work(cam):
    run = start(cam)
    curve = CubicSpline(ANGLES, [*LIFTS[:-1], LIFTS[0]], bc_type="periodic")
    for k in range(200):
        run.advance(0.01 * k, 0.01)
        angle = 7.0 * run.time
        assert run["follower.y"] - 0.3 == pytest.approx(float(curve(angle)), abs=1e-14)
        assert run["follower.y"] - 0.3 == pytest.approx(
            0.02 * (1.0 - math.cos(angle)) ** 2, abs=2e-5
        )
    assert run["energy.error"] < 1e-12


def test_an_fmu_has_the_numbers_of_a_file_and_the_bits_of_the_library(cam, tmp_path):
    path = build(cam, tmp_path / "cam.fmu")
    run = start(cam)
    (tmp_path / "lobe.csv").unlink()
    names = [v.name for v in run.model.variables if v.causality == "output"]
    assert {"follower.vy", "rise.multiplier", "lift", "motor.torque"} <= set(names)
    with instance(path) as fmu:
        fmu.initialise()
        for k in range(200):
            run.advance(0.01 * k, 0.01)
            assert fmu.step(0.01 * k, 0.01), fmu.log
            assert fmu.outputs() == [run[name] for name in names]


def test_an_fmu_carries_the_points_so_that_it_can_be_built_again(cam, tmp_path):
    path = build(cam, tmp_path / "cam.fmu")
    fingerprint = start(cam).model.fingerprint
    (tmp_path / "lobe.csv").unlink()
    scene = root_of(path).find("VendorAnnotations/Tool[@name='holonom']/Scene")
    overrides = dict(each.text.split("=", 1) for each in scene.findall("Override"))
    again = solver.loads(scene.findtext("Text"), overrides=overrides)
    assert solver.assemble(again).fingerprint == fingerprint
