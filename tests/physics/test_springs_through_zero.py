"""A mass on a spring with a free length that swings through its anchor, where the force jumps."""

from __future__ import annotations

import functools
import math

import pytest

import solver
from solver.runtime import StepError

STIFFNESS, FREE_LENGTH, SPEED, START = 4e4, 1e-3, 20.0, -0.3
SCENE = """
name = "through"
dimension = 2
[points]
A = {{ position = [0, {start}], velocity = [{across}, {speed}], mass = 1 }}
[forces.tie]
type = "spring"
points = ["ground", "A"]
at = [0, 0]
stiffness = {stiffness}
free_length = {length}
[forces]
brake = {{ type = "damper", points = ["ground", "A"], at = [0, 0], damping = {damping} }}
[solver]
tolerance = {tolerance}
"""


def through(damping: float, tolerance: float, across: float = 0.0) -> solver.Integrator:
    text = SCENE.format(
        start=START, across=across, speed=SPEED, stiffness=STIFFNESS, length=FREE_LENGTH,
        damping=damping, tolerance=tolerance,
    )  # fmt: skip
    return solver.Integrator(solver.assemble(solver.loads(text)), log=lambda _: None)


def _on_side(side: float, a: float, b: float, w: float, decay: float, t: float) -> float:
    turning = a * math.cos(w * t) + b * math.sin(w * t)
    return side * FREE_LENGTH + math.exp(-decay * t) * turning


def in_closed_form(t: float, damping: float) -> float:
    """Height y of  y'' + d y' + k (|y| - l) sign(y) = 0, from crossing to crossing [m].

    On one side y = s l + exp(-d t/2) (a cos w t + b sin w t), s its sign.
    """
    y, v, left, decay = START, SPEED, t, 0.5 * damping
    w = math.sqrt(STIFFNESS - decay**2)
    while True:
        side = math.copysign(1.0, y if y else v)
        a, b = y - side * FREE_LENGTH, (v + decay * (y - side * FREE_LENGTH)) / w

        at = functools.partial(_on_side, side, a, b, w, decay)
        # It leaves with more than a tenth of a period, and is back within one.
        low = 0.1 / w
        while low < left and at(low) * side > 0.0:
            low += 0.01 / w
        if low >= left:
            return at(left)
        low, high = low - 0.01 / w, low
        for _ in range(80):
            middle = 0.5 * (low + high)
            low, high = (middle, high) if at(middle) * side > 0.0 else (low, middle)
        fade, c, s = math.exp(-decay * low), math.cos(w * low), math.sin(w * low)
        y, v = 0.0, fade * ((b * w - decay * a) * c - (a * w + decay * b) * s)
        left -= low


@pytest.mark.parametrize("damping", [0.5, 5.0])
def test_a_damped_mass_crosses_its_anchor_13_times_in_a_communication_step(damping):
    """The tolerance of 1e-8 does not bound what a jump adds: 38 of them may add 1e-7 m each."""
    run = through(damping, 1e-8)
    for _ in range(3):
        run.advance(run.time, 0.2)
    assert run["A.y"] == pytest.approx(in_closed_form(0.6, damping), abs=4e-6)


def test_a_failure_at_length_zero_names_the_point():
    run = through(5.0, 1e-4, across=1e-6)
    run["solver.max_newton"] = 2
    words = "near point 'A': Newton's iteration did not converge"
    with pytest.raises(StepError, match=words):
        run.advance(0.0, 0.2)
