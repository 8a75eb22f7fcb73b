"""A problem as a model of Exudyn, body by body and joint by joint, and its solution.

Exudyn (J. Gerstmayr, "Exudyn - a C++-based Python package for flexible multibody systems",
Multibody System Dynamics 60 (2024) 533-561): planar bodies have three coordinates, points two or
three, bodies in space Euler parameters; point chains have distance constraints. Nothing of
holonom's solver is used here.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator

import exudyn as exu
import numpy as np
from exudyn.itemInterface import (
    LoadMassProportional,
    LoadTorqueVector,
    MarkerBodyMass,
    MarkerBodyPosition,
    MarkerBodyRigid,
    NodePoint2D,
    NodeRigidBody2D,
    ObjectJointPrismatic2D,
    ObjectJointRevolute2D,
    ObjectMassPoint2D,
    ObjectRigidBody2D,
)
from exudyn.utilities import RigidBodyInertia, SensorBody

from benchmarks.problems.parts import GROUND, Body, Joint, O, Place, Problem, Spring

DENSE = 4
"""Bodies up to which Exudyn's dense solver is the faster one."""
KINDS = exu.DynamicSolverType
ALPHA, TRAPEZOIDAL = (KINDS.GeneralizedAlpha, 0.9), (KINDS.TrapezoidalIndex2, 1.0)
"""Methods: integrator and spectral radius; generalized alpha is of index 3."""


class Build:
    """System of a problem, assembled; its sensors record while `period` [s] is not None.

    `more` draws what a `Problem` has no words for.
    """

    def __init__(
        self, problem: Problem, period: float | None = None,
        more: Callable[[Build], None] = lambda _: None,
    ) -> None:  # fmt: skip
        self.problem, self.period = problem, period
        self.container = exu.SystemContainer()
        self.system = self.container.AddSystem()
        self.ground = self.system.CreateGround()
        self.bodies = {name: self._body(name, body) for name, body in problem.bodies.items()}
        for joint in problem.joints:
            self._joint(joint)
        for spring in problem.springs:
            self._spring(spring)
        if problem.torque:
            name, value = problem.torque
            marker = self.system.AddMarker(MarkerBodyRigid(bodyNumber=self.bodies[name]))
            self.system.AddLoad(LoadTorqueVector(markerNumber=marker, loadVector=[0, 0, value]))
        if problem.key == "car_axis":
            self._axle()
        self.looks = {key: look for key, look in self._looks()}
        """What is read of bodies, and at which place in their axes."""
        self.sensors: dict[tuple[str, str], int] = {}
        for key, (kind, place) in self.looks.items() if period is not None else ():
            sensor = SensorBody(
                bodyNumber=self.bodies[key[0]], localPosition=place, outputVariableType=kind,
                storeInternal=True,
            )  # fmt: skip
            self.sensors[key] = self.system.AddSensor(sensor)
        more(self)
        self.system.Assemble()

    def solve(
        self, count: int, stop: float | None = None, method: tuple = ALPHA, newton: float = 1e-8,
        iterations: int | None = None,
    ) -> None:  # fmt: skip
        """Take so many equal steps to `stop` [s], by default the problem's end.

        `newton` is the relative tolerance of Newton's iteration, modified unless a number of
        `iterations` is allowed.

        Raises
        ------
        ArithmeticError
            When a step fails; the text is Exudyn's reason.
        """
        settings, (kind, radius) = exu.SimulationSettings(), method
        time, solution = settings.timeIntegration, settings.solution
        stop = self.problem.stop if stop is None else stop
        time.endTime, time.numberOfSteps = stop, count
        time.automaticStepSize = time.adaptiveStep = False
        time.verboseMode = 0
        time.generalizedAlpha.spectralRadius = radius
        time.newton.useModifiedNewton = iterations is None
        time.newton.maxIterations = iterations or time.newton.maxIterations
        time.newton.relativeTolerance, time.newton.absoluteTolerance = newton, 1e-2 * newton
        solution.file.write = False
        solution.sensors.writePeriod = self.period or 10.0 * stop
        sparse, solvers = len(self.problem.bodies) > DENSE, exu.LinearSolverType
        settings.linearSolver.solverType = solvers.EigenSparse if sparse else solvers.EXUdense
        try:
            done = self.system.SolveDynamic(settings, solverType=kind, showHints=False)
        except (RuntimeError, ValueError, exu.SolverError) as error:
            raise ArithmeticError(str(error).strip().partition("\n")[0][:80]) from error
        if not done:
            message = "a step failed"
            raise ArithmeticError(message)

    @property
    def newton(self) -> int:
        """Newton iterations of the last solution."""
        return self.system.sys["dynamicSolver"].it.newtonStepsCount

    # ----------------------------------------------------------------------------------- bodies

    def _body(self, name: str, body: Body) -> int:
        if self.problem.planar:
            return self._planar(body, slides=(self.problem.key, name) == ("car_axis", "A"))
        gravity = list(self.problem.gravity)
        if body.is_point:
            return self.system.CreateMassPoint(
                referencePosition=list(body.position),
                initialVelocity=list(body.velocity),
                mass=body.mass,
                gravity=gravity,
            )
        tensor = np.diag(np.array(body.inertia))
        return self.system.CreateRigidBody(
            referencePosition=list(body.position),
            inertia=RigidBodyInertia(body.mass, tensor, np.zeros(3), inertiaTensorAtCOM=True),
            gravity=gravity,
            referenceRotationMatrix=body.attitude,
            initialVelocity=list(body.velocity),
            initialAngularVelocity=list(body.attitude @ np.array(body.omega)),
        )

    def _planar(self, body: Body, slides: bool) -> int:
        """What slides turns with its guide, which is told how to turn: its inertia is idle."""
        place, speed = list(body.position[:2]), list(body.velocity[:2])
        system = self.system
        if body.is_point and not slides:
            node = system.AddNode(NodePoint2D(referenceCoordinates=place, initialVelocities=speed))
            number = system.AddObject(ObjectMassPoint2D(mass=body.mass, nodeNumber=node))
        else:
            node = NodeRigidBody2D(
                referenceCoordinates=[*place, body.turn[2]],
                initialVelocities=[*speed, body.omega[2]],
            )
            number = system.AddObject(
                ObjectRigidBody2D(
                    mass=body.mass,
                    inertia=body.inertia[2] or body.mass,
                    nodeNumber=system.AddNode(node),
                )
            )
        if any(self.problem.gravity):
            marker = system.AddMarker(MarkerBodyMass(bodyNumber=number))
            load = list(self.problem.gravity)
            system.AddLoad(LoadMassProportional(markerNumber=marker, loadVector=load))
        return number

    # ----------------------------------------------------------------------------------- joints

    def _number(self, name: str) -> int:
        return self.ground if name == GROUND else self.bodies[name]

    def _at(self, name: str, position: tuple[float, ...]) -> list[float]:
        """Place in a body's axes of a position as drawn."""
        if name == GROUND:
            return [float(x) for x in position]
        body = self.problem.bodies[name]
        local = body.attitude.T @ (np.array(position) - np.array(body.position))
        return [float(x) for x in local]

    def _joint(self, joint: Joint) -> None:
        pair = [self._number(name) for name in joint.pair]
        if joint.kind == "distance":
            places = {f"localPosition{i}": list(end) for i, end in enumerate(joint.ends)}
            self.system.CreateDistanceConstraint(itemNumbers=pair, **places)
        elif self.problem.planar:
            markers = [self._marker((n, tuple(self._at(n, joint.position)))) for n in joint.pair]
            self.system.AddObject(ObjectJointRevolute2D(markerNumbers=markers))
        elif joint.kind == "spherical":
            self.system.CreateSphericalJoint(
                itemNumbers=pair, position=list(joint.position),
                constrainedAxes=[1, 1, not joint.redundant],
            )  # fmt: skip
        elif joint.redundant:
            self.system.CreateGenericJoint(
                itemNumbers=pair, position=list(joint.position), constrainedAxes=[1, 1, 1, 0, 1, 0]
            )
        else:
            create = getattr(self.system, f"Create{joint.kind.capitalize()}Joint")
            create(itemNumbers=pair, position=list(joint.position), axis=list(joint.axis))

    def _marker(self, place: Place) -> int:
        marker = MarkerBodyPosition(
            bodyNumber=self._number(place[0]), localPosition=[float(x) for x in place[1]]
        )
        return self.system.AddMarker(marker)

    def _spring(self, spring: Spring) -> None:
        (a, at_a), (b, at_b) = spring.ends
        self.system.CreateSpringDamper(
            itemNumbers=[self._number(a), self._number(b)],
            localPosition0=[float(x) for x in at_a],
            localPosition1=[float(x) for x in at_b],
            referenceLength=spring.length or None,
            stiffness=spring.stiffness,
            damping=spring.damping,
        )

    def _axle(self) -> None:
        """The car's axle, a light body that turns as told; A slides on it, B hangs on its end."""
        k, system = self.problem.data, self.system
        ratio, omega = k["wave"] / k["length"], k["omega"]

        def turned(_system: object, t: float, _item: int, _offset: float) -> float:
            return math.asin(ratio * math.sin(omega * t))

        def turning(_system: object, t: float, _item: int, _offset: float) -> float:
            s = ratio * math.sin(omega * t)
            return ratio * omega * math.cos(omega * t) / math.sqrt(1.0 - s * s)

        node = NodeRigidBody2D(
            referenceCoordinates=[0, 0, 0], initialVelocities=[0, 0, ratio * omega]
        )
        axle = system.AddObject(
            ObjectRigidBody2D(mass=1.0, inertia=1.0, nodeNumber=system.AddNode(node))
        )
        for axis in range(3):
            moved = {"offsetUserFunction": turned, "offsetUserFunction_t": turning}
            system.CreateCoordinateConstraint(
                itemNumbers=[None, axle], coordinates=[None, axis], **(moved if axis == 2 else {})
            )
        rigid = system.AddMarker(MarkerBodyRigid(bodyNumber=axle))
        slide = system.AddMarker(MarkerBodyRigid(bodyNumber=self.bodies["A"]))
        system.AddObject(
            ObjectJointPrismatic2D(
                markerNumbers=[rigid, slide], axisMarker0=[0, 1, 0], normalMarker1=[1, 0, 0]
            )
        )
        spring = {"referenceLength": k["free_length"], "stiffness": k["stiffness"]}
        for foot, end in (((0, 0, 0), "A"), ((k["length"], 0, 0), "B")):
            system.CreateSpringDamper(
                itemNumbers=[axle, self.bodies[end]], localPosition0=list(foot), **spring
            )

    # ---------------------------------------------------------------------------------- sensors

    def _looks(self) -> Iterator[tuple[tuple[str, str], tuple[exu.OutputVariableType, list]]]:
        """Body, what is read of it, in which way, and at which place from its centre of mass."""
        kinds, problem = exu.OutputVariableType, self.problem
        turning = kinds.AngularVelocity if problem.planar else kinds.AngularVelocityLocal
        found = []
        for name, body in problem.bodies.items():
            found += [(name, "x", kinds.Position, O), (name, "v", kinds.Velocity, O)]
            found += [] if body.is_point else [(name, "w", turning, O)]
        for i, (name, place) in enumerate(problem.watch):
            found += [(name, f"watch{i}", kinds.Position, place)]
            found += [(name, f"speed{i}", kinds.Velocity, place)]
        for i, spring in enumerate(problem.springs):
            ends = enumerate(spring.ends)
            found += [(n, f"spring{i}{j}", kinds.Position, at) for j, (n, at) in ends if n]
        for name, what, kind, place in found:
            yield (name, what), (kind, [float(x) for x in place])

    def now(self, name: str, what: str) -> np.ndarray:
        """What is read of a body at present, (1, 3)."""
        kind, place = self.looks[name, what]
        return np.array([self.system.GetObjectOutputBody(self.bodies[name], kind, place)])

    def recorded(self) -> dict[tuple[str, str], np.ndarray]:
        """(samples, 3) of each sensor."""
        return {
            key: np.array(self.system.GetSensorStoredData(number))[:, 1:]
            for key, number in self.sensors.items()
        }
