"""A system of Exudyn being drawn, what is read of it, and its solution with generalized alpha.

Exudyn (J. Gerstmayr, "Exudyn - a C++-based Python package for flexible multibody systems",
Multibody System Dynamics 60 (2024) 533-561): rigid bodies with Euler parameters, Lagrange
multipliers, generalized alpha of index 3. Nothing of holonom is used here.
"""

from __future__ import annotations

from collections.abc import Sequence

import exudyn as exu
import numpy as np
from exudyn.utilities import RigidBodyInertia, SensorBody, SensorObject

Vector = Sequence[float]

DENSE = 4
"""Bodies up to which Exudyn's dense solver is the faster one."""


class Drawing:
    """A system under gravity [m/s2] with its ground, and what is read of it, by name."""

    def __init__(self, gravity: Vector = (0.0, 0.0, -9.81)) -> None:
        self.container = exu.SystemContainer()
        self.system = self.container.AddSystem()
        self.gravity = list(gravity)
        self.bodies = 0
        self.ground = self.system.CreateGround()
        self.sensors: dict[str, int] = {}

    def body(self, position: Vector, inertia: RigidBodyInertia, **start: object) -> int:
        """Rigid body with its origin at a position [m]."""
        self.bodies += 1
        return self.system.CreateRigidBody(
            referencePosition=list(position), inertia=inertia, gravity=self.gravity, **start
        )

    def joint(self, kind: str, pair: Sequence[int], position: Vector, **more: object) -> int:
        """Joint of a kind (Revolute, Prismatic, Spherical, Generic) at a position as drawn [m]."""
        create = getattr(self.system, f"Create{kind}Joint")
        return create(itemNumbers=list(pair), position=list(position), **more)

    def watch(self, name: str, body: int, place: Vector = (0.0, 0.0, 0.0)) -> None:
        """Record where a point of a body is."""
        kind = exu.OutputVariableType.Position
        sensor = SensorBody(
            bodyNumber=body, localPosition=list(place), outputVariableType=kind, storeInternal=True
        )
        self.sensors[name] = self.system.AddSensor(sensor)

    def watch_torque(self, name: str, joint: int) -> None:
        """Record the torque of a joint on its second body, in the joint's axes."""
        kind = exu.OutputVariableType.TorqueLocal
        sensor = SensorObject(objectNumber=joint, outputVariableType=kind, storeInternal=True)
        self.sensors[name] = self.system.AddSensor(sensor)

    def values(self) -> dict[str, np.ndarray]:
        """What was recorded, (times, components) by name."""
        stored = {n: self.system.GetSensorStoredData(s) for n, s in self.sensors.items()}
        return {name: np.array(table)[:, 1:] for name, table in stored.items()}


def solve(
    drawing: Drawing, step: float, stop: float, period: float, tolerance: float = 1e-10
) -> None:
    """Integrate to `stop` with a constant step [s] and record every `period` [s].

    Spectral radius 0.9; `tolerance` is that of Newton's iteration, relative.
    """
    settings = exu.SimulationSettings()
    time, solution = settings.timeIntegration, settings.solution
    time.endTime, time.numberOfSteps = stop, round(stop / step)
    time.automaticStepSize = time.adaptiveStep = False
    time.generalizedAlpha.spectralRadius = 0.9
    time.newton.useModifiedNewton = True
    time.newton.relativeTolerance = tolerance
    time.newton.absoluteTolerance = 0.01 * tolerance
    solution.file.write = False
    solution.sensors.writePeriod = period
    sparse = drawing.bodies > DENSE
    kinds = exu.LinearSolverType
    settings.linearSolver.solverType = kinds.EigenSparse if sparse else kinds.EXUdense
    if not drawing.system.SolveDynamic(settings):
        message = f"Exudyn did not finish with step {step} s"
        raise ArithmeticError(message)
