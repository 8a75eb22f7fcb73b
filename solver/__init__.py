"""Multibody mechanics and time integration: from a scene to a trajectory.

>>> import solver
>>> scene = solver.load("scenes/double_pendulum.toml")
>>> trajectory = solver.simulate(scene, stop_time=10.0)
>>> trajectory["energy.error"].max()

`load` reads a scene, `assemble` turns it into a model, `Integrator` moves it step by step,
`simulate` runs it and returns arrays.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from solver.extras import from_homes

if TYPE_CHECKING:
    from solver.closing import Closing, close
    from solver.mechanics import assemble
    from solver.mesh import Mesh
    from solver.runtime import AssemblyError, Integrator, Model, OptionError, StepError
    from solver.scene import Scene, SceneError, SceneWarning, load, loads
    from solver.trajectory import Trajectory, simulate

__all__ = ["AssemblyError", "Integrator", "Model", "OptionError", "StepError"]
__all__ += ["Closing", "Mesh", "Scene", "SceneError", "SceneWarning", "Trajectory"]
__all__ += ["assemble", "close", "load", "loads", "simulate"]

# `solver.runtime` alone must not bring NumPy or the scene reader: what takes longest comes last.
_HOMES = "runtime", "scene", "mechanics", "mesh", "trajectory", "closing"
__getattr__, __dir__ = from_homes(__name__, __all__, [f"solver.{home}" for home in _HOMES])
