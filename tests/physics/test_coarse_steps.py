"""Equal steps that are too long for the motion are said so, with part, figure and remedy.

Right paths are closed forms, or DOP853 of SciPy with a tolerance of 1e-12. Errors are those of
places over the size, or of angles in rad, the largest over a run. Cases whose error is between 0.01
and 0.04 are left out: there the estimate may be below the limit.
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
from tests.commands import run as command

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
        return abs(found - path).max() / np.ptp(path, axis=0).max()

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
    "circle": (planet(0.0), 0.05),
    "ellipse": (planet(0.3), 0.02), "spring": (spring_pendulum(), 0.01),
    "spring in long steps": (spring_pendulum(), 0.05), "top": (heavy_top(60.0), 0.0005),
    "slow top": (heavy_top(20.0), 0.002), "top in long steps": (heavy_top(60.0), 0.002),
    "fast top": (heavy_top(150.0), 0.001), "top of half a radian": (heavy_top(60.0), 0.01),
}  # fmt: skip


@pytest.mark.parametrize(("case", "step"), CASES.values(), ids=CASES)
def test_steps_are_too_long_where_the_path_is_off_and_the_figure_is_its_error(case, step):
    times = np.linspace(0.0, case.stop, POINTS + 1)
    said: list[str] = []
    run = solver.Integrator(
        solver.assemble(
            solver.loads(
                f"{case.text}[solver]\nstep_size = {step}\n[experiment]\nstop_time = {case.stop}\n"
            )
        ),
        log=said.append,
    )
    rows = [[float(run[name]) for name in case.names]]
    for before, after in itertools.pairwise(times):
        run.advance(before, after - before)
        rows.append([float(run[name]) for name in case.names])
    error = case.error(times, np.array(rows))
    assert not 0.01 < error < 0.04
    assert len(said) == (error > 0.01) == (float(run["solver.coarseness"]) > 1.0)
    for text in said:
        ((number, unit),) = re.findall(r"the path is off by about ([\d.]+) (%|times)", text)
        figure = float(number) * (0.01 if unit == "%" else 1.0)
        assert error / 3.0 < figure < 3.0 * error
        assert next(name for name in ("'wheel'", "'planet'", "'bob'", "'top'") if name in text)


def of_a_rotor(settings: str, omega: float = 30.0) -> str:
    return f"{ROTOR.format(omega=omega)}[solver]\n{settings}\n[experiment]\nstop_time = 2.0\n"


def said_of(settings: str, omega: float = 30.0) -> list[str]:
    said: list[str] = []
    model = solver.assemble(solver.loads(of_a_rotor(settings, omega)))
    run = solver.Integrator(model, log=said.append)
    for _ in range(20):
        run.advance(run.time, 0.1)
    return said


def test_the_remedy_is_enough():
    (text,) = said_of("step_size = 0.01")
    (longest,) = re.findall(r"step_size <= ([\d.e-]+) s", text)
    assert "set solver.tolerance = 1e-4" in text
    assert said_of(f"step_size = {longest}") == said_of("tolerance = 1e-4") == []


@pytest.mark.parametrize(("order", "longest"), [(2, 0.22), (4, 1.0), (6, 2.0), (8, 2.5)])
def test_steps_of_a_higher_order_may_turn_further(order, longest):
    """A step of order 4 and 1 rad errs by 6e-5 rad, one of order 2 and 0.22 rad by 2e-4 rad."""
    settings = f"step_size = 0.01\norder = {order}"
    (text,) = said_of(settings, 102.0 * longest)
    assert text.startswith(f"body 'wheel' turns {1.02 * longest:.3g} rad in a step of 0.01 s")
    if order > 2:
        assert said_of(settings, 98.0 * longest) == []


def test_check_fails_and_says_why_and_so_do_the_log_and_the_page(tmp_path: Path, capsys):
    scene = tmp_path / "rotor.toml"
    scene.write_text(of_a_rotor("step_size = 0.01"))
    code, out, err = command(capsys, "check", str(scene))
    row = next(line for line in out.splitlines() if "solver.coarseness" in line)
    assert (code, row.split()[-1]) == (1, "NO")
    assert "body 'wheel' turns 0.3 rad in a step of 0.01 s" in err
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
    said: list[str] = []
    run = solver.Integrator(solver.assemble(solver.loads(text)), log=said.append)
    run.advance(0.0, 0.1)
    assert [x.partition(";")[2].strip()[:24] for x in said] == ["the path may be far off;"]
