"""A pole on a cart, and a controller FMU that pythonfmu has built, which keeps it upright.

The controller samples the cart at the communication points and its force is held until the next
one: over a step it gives force times the way of the cart to the mechanism, and `energy.work` of the
cart's FMU has to say the same.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

from pythonfmu import FmuBuilder

from .unit import Unit

SENSORS = {"cart.x": "x", "cart.vx": "vx", "lean": "lean", "lean_rate": "lean_rate"}
"""Outputs of the cart, and the inputs of the controller that they go to."""


@dataclass
class Run:
    """What happened at the communication points, the first one included."""

    lean: list[float] = field(default_factory=list)
    """rad"""
    given: list[float] = field(default_factory=list)
    """J: what the controller's force has done, by force and way"""
    work: list[float] = field(default_factory=list)
    """J: energy.work of the cart's FMU"""


def build_controller(folder: Path) -> Path:
    """Build the FMU of the controller, with pythonfmu's own builder."""
    script = Path(__file__).with_name("controller.py")
    return FmuBuilder.build_FMU(script, dest=folder)


def run_balanced(cart: Unit, controller: Unit, h: float, steps: int) -> Run:
    """Start both, still in their initialization, and take communication steps of h [s]."""
    cart.start()
    controller.start()
    run = Run([cart["lean"]], [0.0], [0.0])
    for i in range(steps):
        controller.set(dict(zip(SENSORS.values(), cart.get(SENSORS), strict=True)))
        controller.step(i * h, h)
        force = controller["force"]
        before = cart["cart.x"]
        cart.set({"force": force})
        cart.step(i * h, h)
        run.lean.append(cart["lean"])
        run.given.append(run.given[-1] + force * (cart["cart.x"] - before))
        run.work.append(cart["energy.work"])
    return run
