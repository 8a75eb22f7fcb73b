"""Random names and values for the variables of a mechanism: taken, or refused with a sentence."""

from __future__ import annotations

import random
from pathlib import Path

import solver

NAMES = ("length", "push", "solver.step_size", "solver.order", "A.x", "nonsense", "", "A", "é")
VALUES = (0.0, -1.0, 2.5, 1e308, -1e308, 5e-324, float("nan"), float("inf"), "", "x", True, None)
SCENE = """
name = "pulled"
dimension = 2
[parameters]
length = { value = 1.0, min = 0.01 }
[inputs]
push = { start = 0.0, max = 50 }
[points]
O = { position = [0, 0], fixed = true }
A = { position = ["length", 0], mass = 1.0 }
[joints]
rod = { type = "distance", points = ["O", "A"] }
[forces]
pull = { type = "force", point = "A", value = [0, "push"] }
"""


def prepare(folder: Path) -> None:
    """Write the scene."""
    (folder / "pulled.toml").write_text(SCENE, encoding="utf-8")


def case(seed: str, number: int, folder: Path) -> str | None:
    """Set a random variable and take a step."""
    chance = random.Random(f"{seed}/{number}")
    run = solver.Integrator(solver.assemble(solver.load(folder / "pulled.toml")))
    try:
        run[chance.choice(NAMES)] = chance.choice(VALUES)
        run.advance(0.0, 0.01)
    except (solver.OptionError, solver.AssemblyError, solver.StepError):
        return None
    return None if run["energy.error"] < 1e-9 else f"energy error {run['energy.error']:.1e}"
