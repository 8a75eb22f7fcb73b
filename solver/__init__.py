"""Multibody mechanics and time integration: from a scene to a trajectory.

>>> import solver
>>> scene = solver.load("scenes/double_pendulum.toml")
>>> trajectory = solver.simulate(scene, stop_time=10.0)
>>> trajectory["energy.error"].max()

`load` reads a scene, `assemble` turns it into a model, `Integrator` moves it step by step,
`simulate` runs it and returns arrays.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from solver.closing import Closing, close
    from solver.mechanics import assemble
    from solver.runtime import AssemblyError, Integrator, Model, OptionError, StepError
    from solver.scene import Scene, SceneError, SceneWarning, load, loads
    from solver.trajectory import Trajectory, simulate

__all__ = ["AssemblyError", "Integrator", "Model", "OptionError", "StepError"]
__all__ += ["Closing", "Scene", "SceneError", "SceneWarning", "Trajectory"]
__all__ += ["assemble", "close", "load", "loads", "simulate"]

_HOMES = (
    "solver.runtime",
    "solver.scene",
    "solver.mechanics",
    "solver.trajectory",
    "solver.closing",
)
"""Modules that have these names, those that take longest to import last."""


def __getattr__(name: str) -> object:
    """Import what is asked for: `solver.runtime` alone must not bring NumPy or the scene reader."""
    for home in map(import_module, _HOMES if name in __all__ else ()):
        if hasattr(home, name):
            return getattr(home, name)
    message = f"module 'solver' has no attribute {name!r}"
    raise AttributeError(message)


def __dir__() -> list[str]:
    return sorted(__all__)
