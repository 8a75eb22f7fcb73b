"""Equal steps that are too long for the motion are said so, with part, figure and remedy.

Right paths are closed forms, or DOP853 of SciPy with a tolerance of 1e-12. Errors are those of
places in m or of angles in rad, the largest over a run. Cases whose error is between 0.007 and 0.06
of the size are left out: there the estimate, right within a factor of 3, may be on either side.
"""

from __future__ import annotations

import itertools
import re
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import solver
from build_fmu import build
from build_fmu.run import run_fmu
from tests.support.fmus.commands import run as command

POINTS = 200

ROTOR = """
name = "rotor"
dimension = 2
[bodies]
wheel = {{ position = [0, 0], mass = 1, inertia = 1, angular_velocity = {omega} }}
[joints]
pin = {{ type = "revolute", bodies = ["ground", "wheel"], position = [0, 0] }}
"""
PLANET = """
name = "planet"
dimension = 2
[points]
sun = {{ position = [0, 0], fixed = true }}
planet = {{ position = [1, 0], velocity = [0, {speed!r}], mass = 1 }}
[forces]
w = {{ type = "gravitation", points = ["sun", "planet"], constant = 1.0, masses = [1.0, 1.0] }}
"""
SPRING = """
name = "spring_pendulum"
dimension = 2
gravity = [0, -9.81]
[points]
O = { position = [0, 0], fixed = true }
bob = { position = [1.2, 0], mass = 1 }
[forces]
spring = { type = "spring", points = ["O", "bob"], stiffness = 100, free_length = 1 }
"""
TOP = """
name = "top"
dimension = 3
gravity = [0, 0, -9.81]
[bodies.top]
position = [0, {y!r}, {z!r}]
orientation = {{ axis = [1, 0, 0], angle = 0.3 }}
mass = 1
inertia = [0.1, 0.1, 0.05]
velocity = [0, 0, 0]
angular_velocity = [0, {wy!r}, {wz!r}]
[joints]
tip = {{ type = "spherical", bodies = ["ground", "top"], position = [0, 0, 0] }}
"""


@dataclass(frozen=True)
class Case:
    """A scene without settings, what it measures, and how far that is off."""

    text: str
    names: tuple[str, ...]
    error: Callable[[np.ndarray, np.ndarray], float]  # of times, and values by time and name
    stop: float


def exact(rates: Callable, start: list[float], times: np.ndarray) -> np.ndarray:
    span = (float(times[0]), float(times[-1]))
    found = solve_ivp(rates, span, start, "DOP853", rtol=1e-12, atol=1e-13, t_eval=times)
    return found.y.T


def rotor(omega: float) -> Case:
    def error(times: np.ndarray, found: np.ndarray) -> float:
        return abs(found[:, 0] - omega * times).max()

    return Case(ROTOR.format(omega=omega), ("pin.angle",), error, 10.0)


def of_a_point(text: str, name: str, start: list[float], pull: Callable) -> Case:
    """Case of a point of 1 kg in a plane; `pull` is its force at a place."""

    def error(times: np.ndarray, found: np.ndarray) -> float:
        path = exact(lambda _, y: [*y[2:], *pull(y[:2])], start, times)[:, :2]
        return np.hypot(*(found - path).T).max()

    return Case(text, (f"{name}.x", f"{name}.y"), error, 10.0)


def planet(eccentricity: float) -> Case:
    """From its farthest point, with a period of up to 2 pi."""
    speed = (1.0 - eccentricity) ** 0.5
    start = [1.0, 0.0, 0.0, speed]
    return of_a_point(PLANET.format(speed=speed), "planet", start, lambda r: -r / np.hypot(*r) ** 3)


def spring_pendulum() -> Case:
    def pull(r: np.ndarray) -> np.ndarray:
        return -100.0 * (1.0 - 1.0 / np.hypot(*r)) * r - [0.0, 9.81]

    return of_a_point(SPRING, "bob", [1.2, 0.0, 0.0, 0.0], pull)


def heavy_top(spin: float) -> Case:
    """Euler's equations about the tip, in axes of the body, and quaternions."""
    axis = np.array([0.0, -np.sin(0.3), np.cos(0.3)])
    inertia = np.array([0.35, 0.35, 0.05])

    def rates(_: float, y: np.ndarray) -> list[float]:
        (a, b, c, d), w = y[:4], y[4:]
        down = np.array([2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d])
        torque = np.cross([0.0, 0.0, 0.5], -9.81 * down)
        turn = [-b * w[0] - c * w[1] - d * w[2], *(a * w + np.cross([b, c, d], w))]
        return [*(0.5 * np.array(turn)), *((torque - np.cross(w, inertia * w)) / inertia)]

    def error(times: np.ndarray, found: np.ndarray) -> float:
        path = exact(rates, [np.cos(0.15), np.sin(0.15), 0, 0, 0, 0, spin], times)[:, :4]
        cosine = abs((path * found).sum(axis=1)) / np.linalg.norm(path, axis=1)
        return 2.0 * np.arccos(np.minimum(cosine, 1.0)).max()

    (_, y, z), (_, wy, wz) = 0.5 * axis, spin * axis
    text = TOP.format(y=float(y), z=float(z), wy=float(wy), wz=float(wz))
    return Case(text, tuple(f"top.q{k}" for k in "wxyz"), error, 5.0)


CASES = {
    "slow rotor": (rotor(3.0), 0.01), "rotor": (rotor(20.0), 0.01),
    "fast rotor": (rotor(40.0), 0.01), "rotor of 100 rad/s": (rotor(100.0), 0.002),
    "rotor of 1 rad a step": (rotor(100.0), 0.01), "circle": (planet(0.0), 0.05),
    "ellipse": (planet(0.3), 0.05), "spring": (spring_pendulum(), 0.01),
    "spring in long steps": (spring_pendulum(), 0.05), "top": (heavy_top(60.0), 0.0005),
    "slow top": (heavy_top(20.0), 0.002), "top in long steps": (heavy_top(60.0), 0.002),
    "fast top": (heavy_top(150.0), 0.001), "top of half a radian": (heavy_top(60.0), 0.01),
}  # fmt: skip


def run_of(text: str, names: tuple[str, ...], times: np.ndarray, **values: float):
    """Values of these names at these times, what was said, and the integrator; inputs by name."""
    said: list[str] = []
    run = solver.Integrator(solver.assemble(solver.loads(text)), log=said.append)
    for name, value in values.items():
        run[name] = value
    rows = [[float(run[name]) for name in names]]
    for before, after in itertools.pairwise(times):
        run.advance(before, after - before)
        rows.append([float(run[name]) for name in names])
    return np.array(rows), said, run


def settings_of(step: float, stop: float) -> str:
    return f"[solver]\nstep_size = {step!r}\n[experiment]\nstop_time = {stop!r}\n"


def proposed(text: str) -> float:
    """Length of steps that a sentence proposes [s]."""
    assert "leave solver.step_size out, so that steps follow the motion, or set" in text
    ((length, aim),) = re.findall(
        r"step_size <= ([\d.e-]+) s, for an error of about ([\d.e-]+)", text
    )
    assert float(aim) == 1e-4
    return float(length)


@pytest.mark.parametrize(("case", "step"), CASES.values(), ids=CASES)
def test_steps_are_too_long_where_the_path_is_off_and_the_figure_is_its_error(case, step):
    """It is said once as soon as it is so, and once at the end of the run, with the figure."""
    times = np.linspace(0.0, case.stop, POINTS + 1)
    found, said, run = run_of(case.text + settings_of(step, case.stop), case.names, times)
    error = case.error(times, found)
    unit = "m" if case.names[0].endswith(".x") else "rad"
    of_the_size = error / (float(np.ptp(found, axis=0).max()) if unit == "m" else 1.0)
    assert not 0.007 < of_the_size < 0.06
    is_long = of_the_size > 0.02
    assert is_long == (float(run["solver.coarseness"]) > 1.0)
    assert len(said) == 2 * is_long
    for text in said:
        (taken,) = re.findall(r"steps of ([\d.]+) s are too long for this motion", text)
        assert 0.8 * step < float(taken) <= step  # as many as fill a communication step
        assert next(name for name in ("'wheel'", "'planet'", "'bob'", "'top'") if name in text)
    for text in said[1:]:
        ((figure, of),) = re.findall(r"s (?:angles|places) are off by about ([\d.]+) (rad|m)", text)
        assert of == unit
        assert min(error, np.pi / 3.0) / 3.0 < float(figure)  # of orientations at most half a turn
        assert float(figure) < 3.0 * error or error > 2.0


PUSHED = """
name = "pushed"
dimension = 2
[bodies]
wheel = { position = [0, 0], mass = 1, inertia = 0.01 }
[joints]
pin = { type = "revolute", bodies = ["ground", "wheel"], position = [0, 0] }
[forces]
motor = { type = "joint_torque", joint = "pin", value = 2.4 }
"""


@pytest.mark.parametrize(
    ("case", "step"),
    [
        (Case(PUSHED, ("pin.angle",), lambda t, x: abs(x[:, 0] - 120.0 * t**2).max(), 1.0), 0.01),
        (rotor(100.0), 0.01), (heavy_top(60.0), 0.002), (spring_pendulum(), 0.05),
    ],
    ids=["rotor that is pushed", "rotor", "top", "spring"],
)  # fmt: skip
def test_the_step_that_is_proposed_holds_its_error_and_is_silent(case, step):
    """Errors fall with the square of the step; estimates are right within a factor of 3."""
    times = np.linspace(0.0, case.stop, 11)
    _, said, _ = run_of(case.text + settings_of(step, case.stop), case.names, times)
    length = proposed(said[-1])
    # Of such an even motion a part is enough.
    stop = 0.1 * case.stop if length < 1e-4 else case.stop
    times = np.linspace(0.0, case.stop, 11)
    times = times[times <= stop * 1.001]
    found, said, _ = run_of(case.text + settings_of(length, case.stop), case.names, times)
    assert said == []
    assert case.error(times, found) < 3e-4


def driven(value: str, **more: str) -> str:
    return f"""
    name = "driven"
    dimension = 2
    gravity = [0, -9.81]
    {more.get("inputs", "")}
    [bodies]
    arm = {{ position = [0.5, 0], mass = 1, inertia = 0.1 }}
    {more.get("bodies", "")}
    [joints]
    pin = {{ type = "revolute", bodies = ["ground", "arm"], position = [0, 0] }}
    {more.get("joints", "")}
    [drivers]
    motor = {{ type = "angle", joint = "pin", value = "{value}" }}
    """


@pytest.mark.parametrize(
    ("value", "rate"), [("60*t**2", lambda t: 120 * t), ("100*t", lambda t: 100 + 0 * t)]
)
def test_of_a_driven_arm_velocities_and_reactions_are_off_and_not_its_place(value, rate):
    """The driver's angle is exact in steps of any length; forces are m r w^2 and m r w'."""
    times = np.linspace(0.0, 2.0, 81)
    names = ("arm.angle", "arm.angular_velocity", "pin.force.x", "pin.force.y")
    found, said, _ = run_of(driven(value) + settings_of(0.01, 2.0), names, times)
    angle, omega = rate(times) * times / (2.0 if "**" in value else 1.0), rate(times)
    assert abs(found[:, 0] - angle).max() < 1e-9
    assert "places are off" not in said[-1]
    assert "angles are off" not in said[-1]
    assert "path" not in said[-1]
    ((velocity, reaction),) = re.findall(
        r"'arm' turns [\d.]+ rad in one; drivers give its place, but velocities are off by about "
        r"([\d.]+) % and reactions by about ([\d.]+) %",
        said[-1],
    )
    off = abs(found[:, 1] - omega).max() / omega.max()
    assert off / 3.0 < 0.01 * float(velocity) < 3.0 * off
    pull = np.hypot(*found[1:, 2:].T) - [0.0]
    turning = 0.5 * omega[1:] ** 2
    off = abs(pull - turning).max() / turning.max()
    assert off / 3.0 < 0.01 * float(reaction) < 3.0 * off
    assert proposed(said[-1]) < 0.001


@pytest.mark.parametrize(("order", "turn"), [(4, 1.2), (4, 2.2), (6, 2.2)])
def test_of_a_driven_arm_at_high_orders_reactions_are_off_as_said(order, turn):
    """The driver's angle is exact in steps of any length; the force is m r w^2."""
    omega, step = 10.0, turn / 10.0
    times = step * np.arange(41)
    names = ("arm.angle", "pin.force.x", "pin.force.y")
    text = driven(f"{omega}*t").replace("-9.81", "0")
    settings = settings_of(step, float(times[-1])).replace("[solver]", f"[solver]\norder = {order}")
    found, said, _ = run_of(text + settings, names, times)
    assert abs(found[:, 0] - omega * times).max() < 1e-9
    (figure,) = re.findall(
        r"drivers give its place, but reactions are off by about ([\d.e-]+) %", said[-1]
    )
    angle = found[1:, 0]
    right = -0.5 * omega**2 * np.array([np.cos(angle), np.sin(angle)]).T
    off = abs(found[1:, 1:] - right).max() / (0.5 * omega**2)
    assert off / 3.0 < 0.01 * float(figure) < 3.0 * off


def test_of_a_driven_wheel_beside_a_free_one_only_the_free_one_counts_for_the_path():
    """The motor holds its angle; the other one, at 30 rad/s, loses x^3/48 in a step."""
    text = driven(
        "100*t",
        bodies="wheel = { position = [3, 0], mass = 1, inertia = 1, angular_velocity = 30 }",
        joints='hub = { type = "revolute", bodies = ["ground", "wheel"], position = [3, 0] }',
    )
    times = np.linspace(0.0, 2.0, 101)
    found, said, _ = run_of(text + settings_of(0.01, 2.0), ("arm.angle", "hub.angle"), times)
    error = abs(found[:, 1] - 30.0 * times).max()
    assert abs(found[:, 0] - 100.0 * times).max() < 1e-9
    assert error == pytest.approx(200 * 0.3**3 / 48, rel=0.05)
    assert "body 'arm' turns 1.04 rad in one; drivers give its place" in said[-1]
    (figure,) = re.findall(r"angles are off by about ([\d.]+) rad", said[-1])
    assert float(figure) == pytest.approx(error, rel=0.1)


def of_a_rotor(settings: str, omega: float = 30.0) -> str:
    return f"{ROTOR.format(omega=omega)}[solver]\n{settings}\n[experiment]\nstop_time = 2.0\n"


def said_of(settings: str, omega: float = 30.0) -> list[str]:
    return run_of(of_a_rotor(settings, omega), (), np.linspace(0.0, 2.0, 21))[1]


@pytest.mark.parametrize(("order", "longest"), [(2, 0.22), (4, 1.0), (6, 2.0), (8, 2.5)])
def test_steps_of_a_higher_order_may_turn_further(order, longest):
    """A step of order 4 and 1 rad errs by 6e-5 rad, one of order 2 and 0.22 rad by 2e-4 rad."""
    settings = f"step_size = 0.01\norder = {order}"
    text, at_the_end = said_of(settings, 102.0 * longest)
    assert f"body 'wheel' turns {1.02 * longest:.3g} rad in one" in text
    assert "leave solver.step_size and solver.order out" in text
    length = proposed(at_the_end.replace("and solver.order ", ""))
    assert said_of(settings.replace("0.01", f"{length}"), 102.0 * longest) == []
    if order > 2:
        assert said_of(settings, 98.0 * longest) == []


def test_check_fails_and_says_why_and_so_do_the_log_and_the_page(tmp_path: Path, capsys):
    scene = tmp_path / "rotor.toml"
    scene.write_text(of_a_rotor("step_size = 0.01"))
    code, out, err = command(capsys, "check", str(scene))
    row = next(line for line in out.splitlines() if "solver.coarseness" in line)
    assert (code, row.split()[-1]) == (1, "NO")
    assert err.count("too long for this motion") == 1  # what is measured counts, no estimate
    assert "it is off in angles by about 0.11 rad" in err
    code, _, err = command(capsys, "simulate", str(scene))
    assert code == 0
    assert "body 'wheel' turns 0.3 rad" in err
    fmu = build(scene, tmp_path / "rotor.fmu")
    assert any("turns 0.3 rad" in text for text in run_fmu(fmu).messages)
    assert command(capsys, "check", str(scene), "--set", "solver.tolerance=1e-4")[0] == 0


def test_a_contact_leaves_the_turn_alone():
    text = of_a_rotor("step_size = 0.01").replace(
        "[solver]", '[contacts]\nstop = { type = "stop", joint = "pin", max = 1e6 }\n[solver]'
    )
    said = run_of(text, (), np.linspace(0.0, 2.0, 21))[1]
    assert "turns 0.3 rad in one; leave" in said[0]
    assert "turns 0.3 rad in one; after 2 s the path may be far off;" in said[1]
    length = proposed(said[1])  # as if it turned so fast all the time, as it does
    assert run_of(text.replace("0.01", repr(length)), (), np.linspace(0.0, 2.0, 21))[1] == []
    assert 200 * 0.3**3 / 48 * (length / 0.01) ** 2 < 2e-4


SLIDER = """
name = "slider"
dimension = 2
[inputs]
push = {{ start = 0.0, unit = "N", interpolation = "{kind}" }}
[points]
O = {{ position = [0, 0], fixed = true }}
A = {{ position = [1, 0], mass = 1 }}
[forces]
f = {{ type = "force", point = "A", value = [0, "{value}"] }}
s = {{ type = "spring", points = ["O", "A"], stiffness = {stiffness}, free_length = 1 }}
"""


@pytest.mark.parametrize("shift", [0.0, 0.0025], ids=["between steps", "in the middle of one"])
@pytest.mark.parametrize("by_input", [False, True], ids=["load", "input"])
def test_a_force_that_jumps_leaves_no_error_and_is_not_said_to(by_input, shift):
    """Half steps are exact with a constant force: 1000 N to and fro, for 21 steps each."""
    wave = f"(1000 if sin(2*pi*(t - {shift})/0.21) > 0 else -1000)"
    text = SLIDER.format(kind="hold", value="push" if by_input else wave, stiffness=0.0)
    said: list[str] = []
    run = solver.Integrator(
        solver.assemble(solver.loads(text + settings_of(0.005, 4.2))), log=said.append
    )
    place, rate = 0.0, 0.0
    for k in range(40):
        force = 1000.0 * (-1.0) ** k
        parts = [(-force, shift), (force, 0.105 - shift)] if not by_input else [(force, 0.105)]
        for push, time in parts:
            place += rate * time + 0.5 * push * time**2
            rate += push * time
        run["push"] = force
        run.advance(run.time, 0.105)
        assert float(run["A.y"]) == pytest.approx(place, abs=1e-9)
    assert said == []
    assert float(run["solver.coarseness"]) < 1e-6


@pytest.mark.parametrize("kind", ["ramp", "smooth"])
@pytest.mark.parametrize("every", [0.05, 0.1])
def test_kinks_of_an_input_from_rest_are_no_fast_motion(kind, every):
    """What it pushes moves slowly: steps of 5 ms resolve each ramp."""
    text = SLIDER.format(kind=kind, value="push", stiffness=30.0) + settings_of(0.005, 4.0)
    said: list[str] = []
    run = solver.Integrator(solver.assemble(solver.loads(text)), log=said.append)
    for k in range(round(4.0 / every)):
        run["push"] = float(k > 10) * (-1.0) ** (k // 3)
        run.advance(run.time, every)
    assert said == []
    assert float(run["solver.coarseness"]) < 0.5


def test_with_inputs_that_move_an_estimate_is_made_as_without():
    """A stiff spring, omega h = 0.5: off by about its amplitude after some seconds."""
    text = SLIDER.format(kind="ramp", value="100*push", stiffness=2500.0) + settings_of(0.01, 4.0)
    said: list[str] = []
    run = solver.Integrator(solver.assemble(solver.loads(text)), log=said.append)
    for k in range(10):
        run["push"] = 1.0
        run.advance(0.4 * k, 0.4)
    assert len(said) == 2
    assert "places are off by about" in said[1]
