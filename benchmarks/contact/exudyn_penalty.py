"""Exudyn on problems with impacts: penalty contact; runs where the package `exudyn` is.

J. Gerstmayr, "Exudyn - a C++-based Python package for flexible multibody systems", Multibody System
Dynamics 60 (2024) 533-561. The ball has `ObjectContactCoordinate`, the other two a sphere in a
hollow one (`ObjectContactSphereSphere`), with the impact model that its documentation calls the
more accurate one (2, of Gonthier and Carvalho-Martins); at e = 1 it is a spring. An impact is when
the gap closes, between two steps. Integrator, number of steps and contact are set, and the bound
below which steps are not divided: with its default of 1e-8 s stiff contacts fail.
"""

from __future__ import annotations

import math
from collections.abc import Iterable

import exudyn as exu
import numpy as np
from exudyn.itemInterface import (
    LoadCoordinate,
    MarkerBodyPosition,
    MarkerNodeCoordinate,
    Node1D,
    NodeGenericData,
    NodePointGround,
    NodeRigidBody2D,
    ObjectContactCoordinate,
    ObjectJointRevolute2D,
    ObjectMass1D,
    ObjectRigidBody2D,
    SensorNode,
)

from benchmarks.contact.methods import PHASES, Method, Setting, steps
from benchmarks.contact.problems import (
    CRANK,
    GRAVITY,
    START,
    Problem,
    Score,
    gap_of,
    score,
    touches,
)
from benchmarks.measuring.timing import Entry
from benchmarks.peers.peer_methods import GaveUpError

Kind = exu.OutputVariableType
PIN = 1e-3
"""Radius of the inner sphere [m]; the hollow one is larger by the clearance."""
MODEL = 2
SOLVERS = {
    "generalized alpha": exu.DynamicSolverType.GeneralizedAlpha,
    "trapezoidal": exu.DynamicSolverType.TrapezoidalIndex2,
    "RK44": exu.DynamicSolverType.RK44,
}


class Run:
    """A problem with a setting, at its start."""

    def __init__(self, problem: Problem, setting: Setting, period: float = math.inf) -> None:
        """Draw the problem; sensors record every `period` [s]."""
        self.problem, self.setting = problem, setting
        self.container = exu.SystemContainer()
        self.system = self.container.AddSystem()
        self.nodes: list[int] = []
        """Those whose coordinates are looked at."""
        self.law = {
            "contactStiffness": setting["stiffness"],
            "restitutionCoefficient": problem.restitution,
            "impactModel": MODEL if problem.restitution < 1.0 else 0,
        }
        getattr(self, f"_{problem.kind}")()
        # Sensors record in compiled code; where steps are divided, at most one part of each.
        self.period, self.sensors = period, []
        if math.isfinite(period):
            kinds = (Kind.Coordinates, Kind.Coordinates_t)
            self.sensors = [self._sensor(node, kind) for kind in kinds for node in self.nodes]
        self.system.Assemble()

    def _sensor(self, node: int, kind: exu.OutputVariableType) -> int:
        sensor = SensorNode(nodeNumber=node, outputVariableType=kind, storeInternal=True)
        return self.system.AddSensor(sensor)

    def _ball(self) -> None:
        system = self.system
        ground = system.AddNode(NodePointGround())
        node = system.AddNode(Node1D(referenceCoordinates=[0.0], initialCoordinates=[1.0]))
        self.nodes = [node]
        system.AddObject(ObjectMass1D(mass=1.0, nodeNumber=node))
        markers = [
            system.AddMarker(MarkerNodeCoordinate(nodeNumber=n, coordinate=0))
            for n in (ground, node)
        ]
        system.AddLoad(LoadCoordinate(markerNumber=markers[1], load=-GRAVITY))
        size = 2 if self.law["impactModel"] else 1
        data = NodeGenericData(initialCoordinates=[1.0, 0.0][:size], numberOfDataCoordinates=size)
        system.AddObject(
            ObjectContactCoordinate(
                markerNumbers=markers, nodeNumber=system.AddNode(data), **self.law
            )
        )

    def _circle(self) -> None:
        (x, y), (vx, vy) = START
        body = self.system.CreateMassPoint(
            referencePosition=[x, y, 0.0], initialVelocity=[vx, vy, 0.0], mass=1.0,
            gravity=[0.0, -GRAVITY, 0.0],
        )  # fmt: skip
        self.nodes = [self.system.GetObject(body)["nodeNumber"]]
        self._hollow([body, self.system.CreateGround()], 1.0, [0.0, 0.0, 0.0])

    def _slider_crank(self) -> None:
        system = self.system
        ground = system.CreateGround()
        crank = self._bar(0.0, CRANK.crank, CRANK.crank_mass, CRANK.crank_inertia, CRANK.speed, 0.0)
        speed = CRANK.crank * CRANK.speed
        rod = self._bar(
            CRANK.crank, CRANK.rod, CRANK.rod_mass, CRANK.rod_inertia, CRANK.rod_speed, speed
        )
        half, pin = CRANK.crank / 2, CRANK.rod / 2
        for places in (((ground, 0.0), (crank, -half)), ((crank, half), (rod, -pin))):
            markers = [
                system.AddMarker(MarkerBodyPosition(bodyNumber=b, localPosition=[x, 0.0, 0.0]))
                for b, x in places
            ]
            system.AddObject(ObjectJointRevolute2D(markerNumbers=markers))
        node = system.AddNode(Node1D(referenceCoordinates=[CRANK.crank + CRANK.rod]))
        self.nodes.append(node)
        slider = system.AddObject(ObjectMass1D(mass=CRANK.slider_mass, nodeNumber=node))
        self._hollow([rod, slider], CRANK.clearance, [pin, 0.0, 0.0])

    def _bar(
        self, start: float, length: float, mass: float, inertia: float, turn: float, lift: float
    ) -> int:
        """Bar along x; `lift` is the velocity of its left end along y [m/s]."""
        node = self.system.AddNode(
            NodeRigidBody2D(
                referenceCoordinates=[start + length / 2, 0.0, 0.0],
                initialVelocities=[0.0, lift + turn * length / 2, turn],
            )
        )
        self.nodes.append(node)
        return self.system.AddObject(ObjectRigidBody2D(mass=mass, inertia=inertia, nodeNumber=node))

    def _hollow(self, bodies: list[int], clearance: float, place: list[float]) -> None:
        self.system.CreateSphereSphereContact(
            itemNumbers=bodies, localPosition0=place, spheresRadii=[PIN, PIN + clearance],
            isHollowSphere1=True, **self.law,
        )  # fmt: skip

    def run(self) -> None:
        """Integrate to the end."""
        settings = exu.SimulationSettings()
        time = settings.timeIntegration
        time.endTime, time.numberOfSteps = self.problem.stop, self._count()
        time.minimumStepSize = 1e-16
        time.verboseMode = 0
        settings.solution.file.write = False
        settings.solution.sensors.writePeriod = min(self.period, 10.0 * self.problem.stop)
        kind = SOLVERS[self.setting["solver"]]
        try:
            done = self.system.SolveDynamic(settings, solverType=kind, showHints=False)
        except (RuntimeError, ValueError, exu.SolverError) as error:
            raise GaveUpError(str(error).strip().partition("\n")[0][:80]) from error
        if not done:
            message = "a step failed"
            raise GaveUpError(message)

    def _count(self) -> int:
        return round(self.problem.stop / self.setting["h"])

    def scored(self) -> Score:
        """Integrate to the end, and look at what was recorded."""
        self.run()
        stored = [np.array(self.system.GetSensorStoredData(sensor)).T for sensor in self.sensors]
        half = len(self.nodes)
        q = np.concatenate([table[1:] for table in stored[:half]])
        v = np.concatenate([table[1:] for table in stored[half:]])
        gap, rate, energy = OBSERVE[self.problem.kind](q, v)
        lost = float(energy[0] - energy[-1])
        return score(self.problem, touches(stored[0][0], gap, rate), lost)


Seen = tuple[np.ndarray, np.ndarray, np.ndarray]
"""Gap [m], its rate [m/s] and the energy [J] of the first and the last sample."""


def _ball(q: np.ndarray, v: np.ndarray) -> Seen:
    return *gap_of("ball", q, v), 0.5 * v[0, [0, -1]] ** 2 + GRAVITY * q[0, [0, -1]]


def _circle(q: np.ndarray, v: np.ndarray) -> Seen:
    q = q[:2] + np.array(START[0])[:, None]
    energy = 0.5 * np.sum(v * v, axis=0) + GRAVITY * q[1]
    return *gap_of("circle", q, v), energy[[0, -1]]


def _slider_crank(q: np.ndarray, v: np.ndarray) -> Seen:
    q, v = q[[2, 5, 6]], v[[2, 5, 6]]
    energy = [0.5 * v[:, i] @ CRANK.mass(q[:, i]) @ v[:, i] for i in (0, -1)]
    q[2] += CRANK.crank + CRANK.rod
    return *gap_of("slider_crank", q, v), np.array(energy)


OBSERVE = {"ball": _ball, "circle": _circle, "slider_crank": _slider_crank}


def _families(problem: Problem) -> Iterable[Iterable[Setting]]:
    for solver in SOLVERS:
        if solver == "RK44" and problem.kind == "slider_crank":
            continue  # it has constraints
        for phase in PHASES:
            yield [
                {"h": h, "solver": solver, "stiffness": problem.mass * (phase / h) ** 2}
                for h in steps(problem)
            ]


def _label(setting: Setting) -> str:
    return f"{setting['solver']}, h = {setting['h']:g} s, k = {setting['stiffness']:.3g} N/m"


def _entry(problem: Problem, setting: Setting) -> Entry:
    """Each run has a system of its own, made beforehand: a system goes on from where it ended."""
    waiting: list[Run] = []
    return Entry(lambda: waiting.pop().run(), lambda: waiting.append(Run(problem, setting)))


METHODS = (
    Method(
        name="Exudyn",
        families=_families,
        label=_label,
        entry=_entry,
        score=lambda problem, setting: Run(problem, setting, setting["h"]).scored(),
    ),
)
