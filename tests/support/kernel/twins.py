"""Integrators at the start of a run, their memory as arrays, and mechanisms to try them on."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

import solver
from solver.options import USUAL_STEP, tolerance_of
from solver.runtime import Integrator, Model
from tests.support.kernel.kernel_calls import kernel_of

Array = NDArray[np.float64]

PENDULUM = """
name = "pendulum"
dimension = 2
gravity = [0, -9.81]
[points]
O = { position = [0, 0], fixed = true }
A = { position = [0.6, -0.8], velocity = [0.8, 0.6], mass = 2.0 }
[joints]
rod = { type = "distance", points = ["O", "A"] }
"""
"""A point of 2 kg on a rod of 1 m, already moving."""

EVERYTHING = {
    2: """
name = "everything"
dimension = 2
gravity = [0.3, -9.81]
[inputs]
push = { start = 0.7 }
[points]
O = { position = [0.1, 0.2], fixed = true }
A = { position = [1.1, 0.2], velocity = [0, 1.0], mass = 0.5 }
B = { position = [1.1, 1.4], velocity = [0.4, 1.0] }
C = { position = [0.3, 1.7], velocity = [-0.2, 0.6], mass = 1.5 }
[bodies]
bar = { type = "bar", points = ["A", "B"], mass = 1.2 }
[joints]
rod = { type = "distance", points = ["O", "A"] }
[forces]
spring = { type = "spring", points = ["B", "C"], stiffness = 90.0, free_length = 0.7 }
loose = { type = "spring", points = ["C", "ground"], at = [0, 3], stiffness = 20, free_length = 0 }
damper = { type = "damper", points = ["A", "C"], damping = 3.0 }
pusher = { type = "force", point = "C", value = ["push", "0.3*sin(3*t)"] }
motor = { type = "torque", body = "bar", value = "2 + push*t" }
""",
    3: """
name = "everything"
gravity = [0.3, 0.2, -9.81]
[inputs]
push = { start = 0.7 }
[points]
O = { position = [0.1, 0.2, -0.3], fixed = true }
A = { position = [1.1, 0.2, -0.3], velocity = [0, 1.0, 0.5], mass = 0.5 }
B = { position = [1.1, 1.4, -0.3], velocity = [0.4, 1.0, -0.7] }
C = { position = [0.3, 1.7, 0.6], velocity = [-0.2, 0.6, 0.1], mass = 1.5 }
[bodies]
bar = { type = "bar", points = ["A", "B"], mass = 1.2 }
[joints]
rod = { type = "distance", points = ["O", "A"] }
[forces]
spring = { type = "spring", points = ["B", "C"], stiffness = 90.0, free_length = 0.7 }
[forces.loose]
type = "spring"
points = ["C", "ground"]
at = [0, 0, 3]
stiffness = 20.0
free_length = 0
[forces.damper]
type = "damper"
points = ["A", "C"]
damping = 3.0
[forces.pusher]
type = "force"
point = "C"
value = ["push", "0.3*sin(3*t)", -0.2]
[forces.motor]
type = "torque"
body = "bar"
value = ["0.4*push", 1.0, "2 + push*t"]

""",
}
"""Rods, a bar, springs with and without a free length, a damper, a load and a torque."""


@cache
def _assembled(source: str | Path) -> Model:
    read = solver.load if isinstance(source, Path) else solver.loads
    scene = read(source)
    if tolerance_of(vars(scene.solver)) and not scene.solver.tolerance:
        scene = read(source, overrides={"solver.step_size": USUAL_STEP})
    return solver.assemble(scene)


def model_of(source: str | Path | Model) -> Model:
    """Model of a scene's text or file, assembled once; in equal steps unless it asks for others."""
    return source if isinstance(source, Model) else _assembled(source)


def start(source: str | Path | Model, **settings: float | str | bool) -> Integrator:
    """Integrator at the start of its run; `settings` are those of the solver."""
    integrator = Integrator(model_of(source))
    for name, value in settings.items():
        integrator[f"solver.{name}"] = value
    integrator.initialise()
    return integrator


def block(integrator: Integrator) -> Array:
    """The whole state, as a view."""
    return np.asarray(memoryview(kernel_of(integrator).state).cast("B").cast("d"))


def numbers(integrator: Integrator) -> Array:
    """The vector of numbers, as a view."""
    return np.asarray(memoryview(kernel_of(integrator).numbers).cast("B").cast("d"))


def vector(integrator: Integrator, *names: str) -> Array:
    """Vectors of the state, summed, as a copy."""
    return np.sum([np.array(integrator.state.vectors[name]) for name in names], axis=0)


def internal_step(integrator: Integrator) -> None:
    """Advance by one internal step, a pair of half steps."""
    integrator.advance(integrator.time, integrator.state.head["step_size"] or USUAL_STEP)


def advance(integrator: Integrator, count: int) -> None:
    """Advance by internal steps."""
    for _ in range(count):
        internal_step(integrator)
