"""Profiles in motion: measured springs, dampers and cams keep energy, also inside an FMU."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.interpolate import CubicSpline, PchipInterpolator, make_interp_spline
from scipy.optimize import brentq

import solver
from build_fmu import build
from build_fmu.run import run_fmu
from tests.fmu.test_model_description import root_of
from tests.support.kernel.twins import start

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


def test_an_fmu_carries_the_points_so_that_it_can_be_built_again(cam, tmp_path):
    path = build(cam, tmp_path / "cam.fmu")
    fingerprint = solver.assemble(solver.load(cam)).fingerprint
    (tmp_path / "lobe.csv").unlink()
    scene = root_of(path).find("VendorAnnotations/Tool[@name='holonom']/Scene")
    overrides = dict(each.text.split("=", 1) for each in scene.findall("Override"))
    again = solver.loads(scene.findtext("Text"), overrides=overrides)
    assert solver.assemble(again).fingerprint == fingerprint


KERB = """
name = "kerb"
dimension = 2
[profiles]
road = { FILE, interpolation = "WORD" }
[points]
A = { position = [0, 0], mass = 1 }
[drivers]
d = { type = "position", point = "A", value = ["t", "road(t)"] }
"""
ROAD = [0.0, 1.0, 2.0, 2.1, 3.0, 4.0], [0.0, 0.0, 0.0, 0.1, 0.1, 0.1]
CURVES = {
    "cubic": CubicSpline(*ROAD, bc_type="natural"),
    "monotone": PchipInterpolator(*ROAD),
    "linear": make_interp_spline(*ROAD, k=1),
}


@pytest.mark.filterwarnings("ignore::solver.SceneWarning")  # of swings and corners
@pytest.mark.parametrize("kind", ["python", "FMU with Python", "native FMU", "native FMU of FMI 3"])
@pytest.mark.parametrize("word", CURVES)
def test_a_point_goes_along_a_curve_of_each_interpolation(tmp_path, kind, word):
    """From a file, against SciPy's curves; along corners its velocity does not follow."""
    (tmp_path / "road.csv").write_text("".join(f"{x},{y}\n" for x, y in zip(*ROAD, strict=True)))
    file = tmp_path / "kerb.toml"
    file.write_text(KERB.replace("FILE", 'file = "road.csv"').replace("WORD", word))
    if kind == "python":
        moved = solver.simulate(solver.load(file), stop_time=4.0, step_size=0.03)
        t, found = moved.t, moved
    else:
        of_native = {"native": True, "fmi": 3 if kind.endswith("3") else 2}
        path = build(file, tmp_path / "kerb.fmu", **(of_native if "native" in kind else {}))
        found = run_fmu(path, stop_time=4.0, step_size=0.03).values
        t = found["time"]
    assert found["A.y"] == pytest.approx(CURVES[word](t), abs=1e-14)
    if word != "linear":
        assert found["A.vy"] == pytest.approx(CURVES[word](t, 1), abs=1e-10)


@pytest.mark.parametrize("tolerance", [0.0, 1e-6])
@pytest.mark.parametrize("word", ["monotone", "linear"])
def test_a_measured_spring_of_any_interpolation_keeps_its_energy(word, tolerance):
    """And goes from end to end: a spring of straight lines is softer than its cubic."""
    text = SPRING.replace("FORCE", LAWS["potential"])
    text = text.replace("integrate = true", f'integrate = true, interpolation = "{word}"')
    run = start(text.replace("step_size = 0.25", f"step_size = 0.05\ntolerance = {tolerance}"))
    energy = run["whole"]
    low = 0.0
    for k in range(400):
        run.advance(0.05 * k, 0.05)
        low = min(low, float(run["A.x"]))
        assert run["whole"] == pytest.approx(energy, rel=1e-12)
    x, force = [-2, -1, -0.3, 0, 0.4, 1, 2], [-9, -3, -0.4, 0, 0.6, 3, 7]
    curve = PchipInterpolator(x, force) if word == "monotone" else make_interp_spline(x, force, k=1)
    stored = curve.antiderivative()
    turn = brentq(lambda x: float(stored(x) - stored(1.5)), -2.0, -0.5)
    assert low == pytest.approx(turn, abs=0.01)  # rows are 0.05 s apart


@pytest.mark.parametrize("radius", [0.0, 0.05])
def test_a_wheel_rolls_over_a_monotone_kerb_and_keeps_its_energy_between_impacts(radius):
    """It climbs 0.1 m: its speed on top is what is left, up to the square of the step.

    The curvature jumps at the points, so that its speed upwards is off by 2 mm/s behind them.
    """
    text = f"""
name = "wheel"
dimension = 2
gravity = [0, -9.81]
[profiles]
road = {{ x = [0, 1, 2, 4], y = [0, 0, 0.1, 0.1], interpolation = "monotone" }}
[points]
A = {{ position = [0.2, {radius}], mass = 1, velocity = [2.5, 0] }}
[contacts]
c = {{ type = "profile", point = "A", profile = "road", radius = {radius} }}
"""
    moved = solver.simulate(solver.loads(text), stop_time=1.2, step_size=0.01)
    assert moved["energy.error"].max() < 1e-13
    assert moved["c.gap"].min() > -1e-10
    assert moved["A.x"][-1] > 2.2
    assert moved["A.y"][-1] == pytest.approx(0.1 + radius, abs=1e-9)
    lost = moved["energy.impact"][-1]
    speed = math.sqrt(2.5**2 - 2.0 * (9.81 * 0.1 + lost))
    assert moved["A.vx"][-1] == pytest.approx(speed, rel=1e-6)
