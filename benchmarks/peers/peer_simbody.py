"""Simbody, driven by OpenSim, on the problems of the work-precision curves; needs `opensim`.

M. A. Sherman, A. Seth, S. L. Delp, "Simbody: multibody dynamics for biomedical research", Procedia
IUTAM 2 (2011) 241-261: joint coordinates, loops closed by constraints with projection, and an
error-controlled Runge-Kutta-Merson method.
"""

from __future__ import annotations

import math

import numpy as np
import opensim as osim

from benchmarks.measuring.timing import Entry
from benchmarks.peers.peer_frames import Frames
from benchmarks.peers.peer_methods import SAMPLES, GaveUpError, Method, Observed, too_large
from benchmarks.problems.parts import GROUND, Array, Joint, Problem

osim.Logger.setLevelString("Off")

TOLERANCES = tuple(10.0**-k for k in range(2, 13))
TO_AXIS = {
    (1.0, 0.0, 0.0): (0.0, 0.5 * math.pi, 0.0),
    (0.0, 1.0, 0.0): (-0.5 * math.pi, 0.0, 0.0),
    (0.0, 0.0, 1.0): (0.0, 0.0, 0.0),
}
"""Rotations that turn z to an axis, about x, y, z in turn."""
X_TO_Z = (0.0, -0.5 * math.pi, 0.0)


def _vector(values: Array | tuple[float, ...]) -> osim.Vec3:
    return osim.Vec3(*(float(x) for x in values))


class Build(Frames):
    """Model of a problem. Bodies' frames are drawn parallel to the global ones, in their joints."""

    def __init__(self, problem: Problem) -> None:
        super().__init__(problem)
        self.model = osim.Model()
        self.model.setGravity(_vector(problem.gravity))
        self._bodies: dict[str, osim.PhysicalFrame] = {GROUND: self.model.getGround()}
        waiting, loops = list(problem.joints), []
        while waiting:
            joint = next((j for j in waiting if self._leads_on(j)), waiting[0])
            waiting.remove(joint)
            if self._leads_on(joint):
                self._add(joint)
            else:
                loops.append(joint)
        for joint in loops:
            self._close(joint)
        self._forces()
        self.model.finalizeConnections()
        self.state = self.model.initSystem()
        self._start()

    def _leads_on(self, joint: Joint) -> bool:
        return sum(name in self._bodies for name in joint.pair) == 1

    def _add(self, joint: Joint) -> None:
        a, b = joint.pair if joint.pair[0] in self._bodies else joint.pair[::-1]
        body = self.problem.bodies[b]
        held, com = self.hang(b, joint, a)
        inertia = osim.Inertia(*map(float, self.inertia(b)))
        added = osim.Body(b, body.mass, _vector(com), inertia)
        self.model.addBody(added)
        self._bodies[b] = added
        kind, turn = self._kind(joint)
        turned, zero = _vector(turn), osim.Vec3(0)
        parent = self._bodies[a]
        self.model.addJoint(kind(f"joint_{b}", parent, _vector(held), turned, added, zero, turned))

    def _kind(self, joint: Joint) -> tuple[type[osim.Joint], tuple[float, ...]]:
        axis = (float(joint.axis[0]), float(joint.axis[1]), float(joint.axis[2]))
        if self.problem.planar or joint.kind == "revolute":
            return osim.PinJoint, TO_AXIS[axis]
        if joint.kind == "distance":
            return osim.UniversalJoint, X_TO_Z
        if joint.kind == "spherical":
            return osim.BallJoint, (0.0, 0.0, 0.0)
        x, y, z = joint.axis
        return osim.SliderJoint, (0.0, math.atan2(-z, x), math.asin(y))  # its x axis along ours

    def _close(self, joint: Joint) -> None:
        """A point that both bodies share; in space also a second one on the hinge's axis."""
        a, b = joint.pair
        points = [np.array(joint.position, dtype=float)]
        if not self.problem.planar and joint.kind == "revolute":
            points.append(points[0] + np.array(joint.axis))
        for point in points:
            places = (_vector(point - self.origins[name]) for name in (a, b))
            at_a, at_b = places
            shared = osim.PointConstraint(self._bodies[a], at_a, self._bodies[b], at_b)
            self.model.addConstraint(shared)

    def _forces(self) -> None:
        for spring in self.problem.springs:
            (a, at_a), (b, at_b) = spring.ends
            ends = (self._bodies[a], _vector(self.local(a, at_a)))
            ends += (self._bodies[b], _vector(self.local(b, at_b)))
            self.model.addForce(osim.PointToPointSpring(*ends, spring.stiffness, spring.length))
        if self.problem.torque:
            name, value = self.problem.torque
            coordinate = self.model.getJointSet().get(f"joint_{name}").get_coordinates(0)
            force = osim.ExpressionBasedCoordinateForce(coordinate.getName(), repr(value))
            self.model.addForce(force)

    def _start(self) -> None:
        """Rates of the joints for which all bodies have the velocities of the problem."""
        self.model.realizePosition(self.state)
        matrix = osim.Matrix()
        self.model.getMatterSubsystem().calcSystemJacobian(self.state, matrix)
        jacobian = matrix.to_numpy()

        def motion(name: str) -> tuple[Array, Array]:
            first = 6 * int(self._bodies[name].getMobilizedBodyIndex())
            turning, moving = jacobian[first : first + 3], jacobian[first + 3 : first + 6]
            x, y, z = self.local(name, (0.0, 0.0, 0.0))
            arm = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
            return turning, moving - arm @ turning

        self.state.setU(osim.Vector.createFromMat(self.rates(motion)))

    def manager(self, tolerance: float) -> osim.Manager:
        """Integrator at the start."""
        manager = osim.Manager(self.model)
        manager.setIntegratorMethod(osim.Manager.IntegratorMethod_RungeKuttaMerson)
        manager.setIntegratorAccuracy(tolerance)
        manager.setWriteToStorage(False)
        manager.setPerformAnalyses(False)
        manager.initialize(self.state)
        return manager

    def energy(self, state: osim.State) -> float:
        """Kinetic and potential energy [J]."""
        self.model.realizeVelocity(state)
        return self.model.calcKineticEnergy(state) + self.model.calcPotentialEnergy(state)

    def watched(self, state: osim.State) -> tuple[Array, Array]:
        """Positions and velocities of the watched places."""
        self.model.realizeVelocity(state)
        places, speeds = [], []
        for name, place in self.problem.watch:
            body, local = self._bodies[name], _vector(self.local(name, place))
            places.append(body.findStationLocationInGround(state, local).to_numpy())
            speeds.append(body.findStationVelocityInGround(state, local).to_numpy())
        return np.array(places), np.array(speeds)


def _integrate(manager: osim.Manager, t: float) -> osim.State:
    try:
        return manager.integrate(t)
    except RuntimeError as error:
        raise GaveUpError(str(error).strip().partition("\n")[0][:80]) from error


def _observe(problem: Problem, tolerance: float) -> Observed:
    build = Build(problem)
    manager = build.manager(tolerance)
    found = [build.energy(build.state)]
    for i in range(SAMPLES):
        state = _integrate(manager, (i + 1) / SAMPLES * problem.stop)
        found.append(build.energy(state))
    # Stops on the way shorten steps: the end is that of a run without them.
    manager = build.manager(tolerance)
    state = _integrate(manager, problem.stop)
    found.append(build.energy(state))
    return Observed.of(*build.watched(state), found)


def _entry(problem: Problem, tolerance: float) -> Entry:
    build = Build(problem)
    waiting: list[osim.Manager] = []

    def prepare() -> None:
        waiting[:] = [build.manager(tolerance)]

    return Entry(lambda: _integrate(waiting[0], problem.stop), prepare)


def _excuse(problem: Problem) -> str:
    if any(spring.damping for spring in problem.springs):
        return "not modelled: OpenSim has no damper between two points"
    if problem.key == "car_axis":
        return "not modelled: its axle moves as told"
    return too_large(problem)


METHODS = (
    Method(
        name="Simbody RK-Merson",
        label="accuracy {:.0e}",
        settings=lambda _: TOLERANCES,
        observe=_observe,
        entry=_entry,
        excuse=_excuse,
    ),
)
