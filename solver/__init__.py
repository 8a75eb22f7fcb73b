"""Multibody mechanics and time integration: from a scene to a trajectory.

>>> import solver
>>> scene = solver.load("scenes/double_pendulum.toml")
>>> trajectory = solver.simulate(scene, stop_time=10.0)
>>> trajectory["energy.error"].max()

`load` reads a scene, `assemble` turns it into a model, `Integrator` moves it step by step,
`simulate` runs it and returns arrays.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from solver.mechanics import assemble
    from solver.runtime import AssemblyError, Integrator, Model, OptionError, StepError
    from solver.scene import Scene, SceneError, SceneWarning, load, loads
    from solver.trajectory import Trajectory, simulate

__all__ = ["AssemblyError", "Integrator", "Model", "OptionError", "StepError"]
__all__ += ["Scene", "SceneError", "SceneWarning", "Trajectory"]
__all__ += ["assemble", "load", "loads", "simulate"]

_HOMES = ("solver.runtime", "solver.scene", "solver.mechanics", "solver.trajectory")
"""Modules that have these names, the one that takes longest to import last."""


def lazy(module: str, names: Sequence[str], homes: Sequence[str]) -> Callable[[str], object]:
    """Return a `__getattr__` that imports what is asked for, so that `module` waits for nothing."""

    def find(name: str) -> object:
        for home in map(import_module, homes if name in names else ()):
            if hasattr(home, name):
                return getattr(home, name)
        message = f"module {module!r} has no attribute {name!r}"
        raise AttributeError(message)

    return find


if not TYPE_CHECKING:  # `solver.runtime` alone must not bring NumPy or the scene reader
    __getattr__ = lazy(__name__, __all__, _HOMES)


def __dir__() -> list[str]:
    return sorted(__all__)
