"""Explicit steps with smooth potentials: they resolve how stiff these are by second derivatives."""

from __future__ import annotations

import math

import numpy as np
import pytest

import solver
from solver.runtime import Integrator
from tests.support.mechanisms.mechanism_runs import steps_explicitly


def started(text: str, tolerance: float, stop: float = 1.0) -> Integrator:
    tail = (
        f"[experiment]\nstop_time = {stop}\n[solver]\ntolerance = {tolerance}\nmethod = 'fastest'\n"
    )
    run = Integrator(solver.assemble(solver.loads(f'name = "well"\ndimension = 2\n{text}{tail}')))
    run.initialise()
    return run


POINT = "[points.P]\nposition = {place}\nvelocity = {velocity}\nmass = {mass}\n"


def well(value: str, place: str = "[1, 0]", velocity: str = "[0, 1]", mass: float = 1.0) -> str:
    shown = POINT.format(place=place, velocity=velocity, mass=mass)
    return f'{shown}[forces.well]\ntype = "potential"\nvalue = "{value}"\n'


@pytest.mark.parametrize("eccentricity", [0.0, 0.6])
@pytest.mark.parametrize("tolerance", [1e-4, 1e-6, 1e-8])
def test_a_planet_follows_keplers_ellipse(eccentricity: float, tolerance: float) -> None:
    """From the nearest place of an orbit of unit half axis: E - e sin E = t."""
    e = eccentricity
    speed = math.sqrt((1 + e) / (1 - e))
    run = started(
        well("-1/sqrt(P.x**2 + P.y**2)", f"[{1 - e}, 0]", f"[0, {speed!r}]"), tolerance, 20.0
    )
    for k in range(100):
        run.advance(0.2 * k, 0.2)
        t = 0.2 * (k + 1)
        angle = t
        for _ in range(60):  # Newton's iteration
            angle -= (angle - e * math.sin(angle) - t) / (1.0 - e * math.cos(angle))
        x, y, vx, vy = (float(run[f"P.{part}"]) for part in ("x", "y", "vx", "vy"))
        exact = [math.cos(angle) - e, math.sqrt(1 - e * e) * math.sin(angle)]
        assert [x, y] == pytest.approx(exact, abs=10.0 * tolerance)
        assert 0.5 * (vx * vx + vy * vy) - 1 / math.hypot(x, y) == pytest.approx(-0.5, abs=2e-14)
        assert x * vy - y * vx == pytest.approx(math.sqrt(1 - e * e), abs=2e-13)
    assert steps_explicitly(run)


@pytest.mark.parametrize("mass", [1.0, 4.0])
@pytest.mark.parametrize(
    ("value", "stiffness"),
    [
        ("50*(P.x**2 + P.y**2)", [[100, 0], [0, 100]]),
        ("300*P.x**2 + 200*P.x*P.y + 150*P.y**2", [[600, 200], [200, 300]]),
        ("40*cosh(3*P.y) - 10*P.x**2", [[-20, 0], [0, 360]]),
        ("100*(1 - cos(2*P.x + P.y))", [[400, 200], [200, 100]]),
    ],
)
def test_the_longest_step_follows_from_the_second_derivatives(
    value: str, stiffness: list[list[float]], mass: float
) -> None:
    """It turns the fastest motion by 5 rad: powers find its rate to some percent, from below."""
    run = started(well(value, "[0, 0]", "[0.01, 0.02]", mass), 1e-6)
    for k in range(3):  # the first step finds how fast it moves
        run.advance(0.01 * k, 0.01)
    assert steps_explicitly(run)
    rate = math.sqrt(np.abs(np.linalg.eigvalsh(np.array(stiffness, float) / mass)).max())
    assert run.state.head["longest_explicit"] == pytest.approx(5.0 / rate, rel=0.03)


def test_a_potential_is_as_stiff_as_the_spring_that_it_writes_out() -> None:
    rod = """
gravity = [0, -9.81]
[bodies.rod]
position = [0.5, 0]
mass = 1.0
inertia = 0.1
points = { tip = [0.5, 0] }
[joints.pin]
type = "revolute"
bodies = ["ground", "rod"]
position = [0, 0]
"""
    spring = (
        rod
        + """[forces.s]
type = "spring"
points = ["ground", "rod.tip"]
at = [1, 2]
stiffness = 3e3
free_length = 1.8
"""
    )
    potential = (
        rod
        + """[forces.s]
type = "potential"
value = "1.5e3*(sqrt((rod.tip.x - 1)**2 + (rod.tip.y - 2)**2) - 1.8)**2"
"""
    )
    runs = [started(text, 1e-7) for text in (spring, potential)]
    for run in runs:
        for k in range(20):
            run.advance(0.05 * k, 0.05)
        assert steps_explicitly(run)
        assert float(run["energy.error"]) < 1e-13
    assert runs[1]["rod.angle"] == pytest.approx(runs[0]["rod.angle"], abs=1e-6)
    # The tension of the spring, which the bound leaves out, is in the second derivatives.
    lengths = [run.state.head["longest_explicit"] for run in runs]
    assert lengths[1] == pytest.approx(lengths[0], rel=0.1)


def test_a_potential_with_a_kink_takes_half_steps() -> None:
    run = started(well("100*max(P.x - 1, 0)**2", "[0, 0]", "[1, 0]"), 1e-6)
    run.advance(0.0, 0.1)
    assert not steps_explicitly(run)
