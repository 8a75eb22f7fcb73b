"""Exudyn on the mechanisms of the stability maps, watched from outside.

Runs where the package `exudyn` is, without anything of holonom.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import exudyn as exu
import numpy as np

from benchmarks import exudyn_models, exudyn_planar
from benchmarks.exudyn_system import DENSE, Drawing
from benchmarks.stability_rules import Outcome, steps, stride

Kind = exu.OutputVariableType
METHODS: dict[str, tuple[exu.DynamicSolverType, float]] = {
    "generalized alpha, 0.9": (exu.DynamicSolverType.GeneralizedAlpha, 0.9),
    "generalized alpha, 0.5": (exu.DynamicSolverType.GeneralizedAlpha, 0.5),
    "trapezoidal, index 2": (exu.DynamicSolverType.TrapezoidalIndex2, 1.0),
}
"""Integrator and spectral radius."""
NEWTON = 50
"""Iterations of a step, at most: twice what Exudyn allows by itself."""


def waving_chain(n: int) -> Drawing:
    """`benchmarks.mechanisms.waving_chain` in space."""
    drawing = Drawing((0.0, 0.0, 0.0))
    last = drawing.ground
    for i in range(1, n + 1):
        across = 0.5 * math.sin(2 * math.pi * i / n)
        last = _point(drawing, last, (0.1 * i, 0, 0), 0.1, 0.1, (0.0, across, 0.0))
    return drawing


def elastic_pendulum(stiffness: float) -> Drawing:
    """`benchmarks.stability_cases.elastic_pendulum`."""
    drawing = Drawing((0.0, -9.81, 0.0))
    system = drawing.system
    bob = _mass(drawing, (1.0, 0.0, 0.0), 1.0, (0.0, 0.0, 0.0))
    system.CreateSpringDamper(
        itemNumbers=[drawing.ground, bob], referenceLength=1.0, stiffness=stiffness
    )
    _point(drawing, bob, (2.0, 0.0, 0.0), 1.0, 1.0, (0.0, 0.0, 0.0))
    return drawing


def _mass(drawing: Drawing, place: Any, mass: float, velocity: Any) -> int:
    drawing.bodies += 1
    return drawing.system.CreateMassPoint(
        referencePosition=list(place),
        initialVelocity=list(velocity),
        mass=mass,
        gravity=drawing.gravity,
    )


def _point(
    drawing: Drawing, before: int, place: Any, length: float, mass: float, velocity: Any
) -> int:
    """Point on a massless rod."""
    body = _mass(drawing, place, mass, velocity)
    drawing.system.CreateDistanceConstraint(itemNumbers=[before, body], distance=length)
    return body


BUILD: dict[str, Callable[..., Drawing]] = {
    "chain": waving_chain,
    "four-bar": lambda: exudyn_planar.n_four_bar(2),
    "bricard": exudyn_models.bricard,
    "stiff spring": elastic_pendulum,
}


class Watch:
    """Energy of a system [J] and the largest violation of its constraints [m], from outside."""

    def __init__(self, drawing: Drawing) -> None:
        self.drawing, system = drawing, drawing.system
        parts = [system.GetObject(i) for i in range(system.systemData.NumberOfObjects())]
        self.points = [(i, p) for i, p in enumerate(parts) if p["objectType"] == "MassPoint"]
        self.bodies = [(i, p) for i, p in enumerate(parts) if "RigidBody" in p["objectType"]]
        self.springs = [p for p in parts if p["objectType"] == "ConnectorSpringDamper"]
        self.pairs = [
            (p["markerNumbers"], float(p.get("distance", 0.0)))
            for p in parts
            if "Joint" in p["objectType"] or p["objectType"] == "ConnectorDistance"
        ]

    def energy(self) -> float:
        """Kinetic energy and that of gravity and springs [J]."""
        gravity = np.array(self.drawing.gravity)
        energy = 0.0
        for i, part in (*self.points, *self.bodies):
            x, v = self._output(i, Kind.Position), self._output(i, Kind.Velocity)
            energy += part["mass"] * (0.5 * float(v @ v) - float(gravity @ x))
        for i, part in self.bodies:
            rate = self._output(i, Kind.AngularVelocityLocal)
            energy += 0.5 * float(rate @ _tensor(part["inertia"]) @ rate)
        for spring in self.springs:
            stretch = self._distance(spring["markerNumbers"]) - spring["referenceLength"]
            energy += 0.5 * spring["stiffness"] * stretch**2
        return energy

    def violation(self) -> float:
        """Largest distance [m] by which two points of a joint are too far from each other."""
        return max(abs(self._distance(pair) - length) for pair, length in self.pairs)

    def _output(self, body: int, kind: Any) -> np.ndarray:
        return np.array(self.drawing.system.GetObjectOutputBody(body, kind, [0, 0, 0]))

    def _distance(self, pair: Any) -> float:
        system = self.drawing.system
        a, b = (np.array(system.GetMarkerOutput(marker, Kind.Position)) for marker in pair)
        return float(np.linalg.norm(b - a))


def _tensor(inertia: Any) -> np.ndarray:
    """From Exudyn's numbers: of the one axis in the plane, or xx, yy, zz, yz, xz, xy."""
    if np.ndim(inertia) == 0:
        return np.diag([0.0, 0.0, float(inertia)])
    xx, yy, zz, yz, xz, xy = inertia
    return np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])


class ChainWatch(Watch):
    """The same of the chain without gravity, from all coordinates at once."""

    def __init__(self, drawing: Drawing) -> None:
        super().__init__(drawing)
        data = drawing.system.systemData
        self.reference = np.array(data.GetODE2Coordinates(exu.ConfigurationType.Reference))

    def energy(self) -> float:
        """Kinetic energy [J]."""
        v = np.array(self.drawing.system.systemData.GetODE2Coordinates_t())
        return 0.05 * float(v @ v)

    def violation(self) -> float:
        """Largest error of a rod's length [m]."""
        data = self.drawing.system.systemData
        q = (self.reference + np.array(data.GetODE2Coordinates())).reshape(-1, 3)
        rods = np.diff(q, axis=0, prepend=np.zeros((1, 3)))
        return float(np.max(np.abs(np.linalg.norm(rods, axis=1) - 0.1)))


def run(
    mechanism: str, size: list[float], method: str, h: float, case: dict[str, float]
) -> Outcome:
    """Take steps of h [s] until `case["stop"]`, watched on the way."""
    drawing = BUILD[mechanism](*size)
    drawing.system.Assemble()
    watch = (ChainWatch if mechanism == "chain" else Watch)(drawing)
    outcome, before = Outcome(), watch.energy()
    count, taken = steps(case["stop"], h), 0

    def after_step(_: Any, t: float) -> bool:
        nonlocal taken
        taken += 1
        if taken % stride(count) and taken < count:
            return True
        energy = (watch.energy() - before) / case["reference"]
        return outcome.see(energy, watch.violation() / case["length"], t)

    drawing.system.SetPostStepUserFunction(after_step)
    try:
        finished = drawing.system.SolveDynamic(
            _settings(drawing, method, h, count), solverType=METHODS[method][0], showHints=False
        )
    except (ValueError, RuntimeError, exu.SolverError) as error:
        finished = False
        outcome.end = outcome.end or str(error).strip().partition("\n")[0] or "a step failed"
    iterations = drawing.system.sys["dynamicSolver"].it
    outcome.newton = iterations.newtonStepsCount / count
    if not (finished or outcome.end):
        outcome.end = "a step failed"
    return outcome


def _settings(drawing: Drawing, method: str, h: float, count: int) -> Any:
    settings = exu.SimulationSettings()
    time = settings.timeIntegration
    time.endTime, time.numberOfSteps = count * h, count
    time.automaticStepSize = time.adaptiveStep = False
    time.verboseMode = 0
    time.generalizedAlpha.spectralRadius = METHODS[method][1]
    time.newton.useModifiedNewton = False
    time.newton.maxIterations = NEWTON
    settings.solution.file.write = False
    kinds = exu.LinearSolverType
    sparse = drawing.bodies > DENSE
    settings.linearSolver.solverType = kinds.EigenSparse if sparse else kinds.EXUdense
    return settings
