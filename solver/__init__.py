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
    from solver.mechanics import assemble
    from solver.runtime import AssemblyError, Integrator, Model, OptionError, StepError
    from solver.scene import Scene, SceneError, SceneWarning, load, loads
    from solver.trajectory import Trajectory, simulate

_HOMES = {
    "AssemblyError": "solver.runtime",
    "Integrator": "solver.runtime",
    "Model": "solver.runtime",
    "OptionError": "solver.runtime",
    "Scene": "solver.scene",
    "SceneError": "solver.scene",
    "SceneWarning": "solver.scene",
    "StepError": "solver.runtime",
    "Trajectory": "solver.trajectory",
    "assemble": "solver.mechanics",
    "load": "solver.scene",
    "loads": "solver.scene",
    "simulate": "solver.trajectory",
}

__all__ = [
    "AssemblyError",
    "Integrator",
    "Model",
    "OptionError",
    "Scene",
    "SceneError",
    "SceneWarning",
    "StepError",
    "Trajectory",
    "assemble",
    "load",
    "loads",
    "simulate",
]


def __getattr__(name: str) -> object:
    """Import what is asked for: `solver.runtime` alone must not bring NumPy or the scene reader."""
    if name not in _HOMES:
        message = f"module 'solver' has no attribute {name!r}"
        raise AttributeError(message)
    return getattr(import_module(_HOMES[name]), name)


def __dir__() -> list[str]:
    return sorted(__all__)
