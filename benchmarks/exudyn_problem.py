"""A problem of the work-precision curves as a model of Exudyn, body by body and joint by joint.

Planar bodies have three coordinates, points two or three, bodies in space Euler parameters; point
chains have distance constraints. Nothing of holonom's solver is used here.
"""

from __future__ import annotations

import math

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

from benchmarks.problems_parts import GROUND, Body, Joint, Place, Problem, Spring


class Build:
    """System of a problem, assembled; its sensors record while `period` [s] is not None."""

    def __init__(self, problem: Problem, period: float | None = None) -> None:
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
        self._sensors: dict[tuple[str, str], int] = {}
        if period is not None:
            self._watch()
        self.system.Assemble()

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
        elif joint.redundant:
            self.system.CreateGenericJoint(
                itemNumbers=pair, position=list(joint.position), constrainedAxes=[1, 1, 1, 0, 1, 0]
            )
        elif joint.kind == "spherical":
            self.system.CreateSphericalJoint(itemNumbers=pair, position=list(joint.position))
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

    def _watch(self) -> None:
        kinds = exu.OutputVariableType
        for name, body in self.problem.bodies.items():
            self._sensor(name, "x", kinds.Position)
            self._sensor(name, "v", kinds.Velocity)
            if not body.is_point:
                planar = self.problem.planar
                self._sensor(
                    name, "w", kinds.AngularVelocity if planar else kinds.AngularVelocityLocal
                )
        for i, (name, place) in enumerate(self.problem.watch):
            self._sensor(name, f"watch{i}", kinds.Position, place)
            self._sensor(name, f"speed{i}", kinds.Velocity, place)
        for i, spring in enumerate(self.problem.springs):
            for j, (name, place) in enumerate(spring.ends):
                if name != GROUND:
                    self._sensor(name, f"spring{i}{j}", kinds.Position, place)

    def _sensor(
        self, name: str, what: str, kind: exu.OutputVariableType, place: tuple[float, ...] = ()
    ) -> None:
        sensor = SensorBody(
            bodyNumber=self.bodies[name],
            localPosition=[float(x) for x in place or (0, 0, 0)],
            outputVariableType=kind,
            storeInternal=True,
        )
        self._sensors[name, what] = self.system.AddSensor(sensor)

    def recorded(self) -> dict[tuple[str, str], np.ndarray]:
        """(samples, 3) of each sensor."""
        return {
            key: np.array(self.system.GetSensorStoredData(number))[:, 1:]
            for key, number in self._sensors.items()
        }
