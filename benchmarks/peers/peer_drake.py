"""Drake on the problems of the work-precision curves that are trees; runs where `drake` is.

R. Tedrake et al., "Drake: model-based design and verification for robotics": a continuous plant in
joint coordinates, integrated with an error-controlled Runge-Kutta method of order 3.
"""

from __future__ import annotations

import numpy as np
from pydrake.math import RigidTransform, RotationMatrix
from pydrake.multibody.plant import MultibodyPlant
from pydrake.multibody.tree import (
    BallRpyJoint,
    FixedOffsetFrame,
    JacobianWrtVariable,
    LinearSpringDamper,
    PrismaticJoint,
    RevoluteJoint,
    SpatialInertia,
    UnitInertia,
    UniversalJoint,
)
from pydrake.systems.analysis import ResetIntegratorFromFlags, Simulator

from benchmarks.measuring.timing import Entry
from benchmarks.peers.peer_frames import Frames
from benchmarks.peers.peer_methods import SAMPLES, GaveUpError, Method, Observed, too_large
from benchmarks.problems.parts import GROUND, Array, Joint, Problem

TOLERANCES = tuple(10.0**-k for k in range(2, 11))
ROOM = RotationMatrix(np.array([[0.0, 0.0, -1.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]]))
"""Axes of a universal joint: first z, then y."""


class Build(Frames):
    """Plant of a problem. Bodies' frames are drawn parallel to the global ones, in their joints."""

    def __init__(self, problem: Problem, tolerance: float) -> None:
        super().__init__(problem)
        self.plant = plant = MultibodyPlant(0.0)
        plant.mutable_gravity_field().set_gravity_vector(problem.gravity)
        self._bodies = {GROUND: plant.world_body()}
        for joint in problem.joints:
            self._add(joint)
        for spring in problem.springs:
            (a, at_a), (b, at_b) = spring.ends
            ends = (self._bodies[a], self.local(a, at_a), self._bodies[b], self.local(b, at_b))
            law = (spring.length, spring.stiffness, spring.damping)
            plant.AddForceElement(LinearSpringDamper(*ends, *law))
        plant.Finalize()
        self.simulator = Simulator(plant)
        ResetIntegratorFromFlags(self.simulator, "runge_kutta3", problem.stop / 10)
        integrator = self.simulator.get_mutable_integrator()
        integrator.set_fixed_step_mode(False)
        integrator.set_target_accuracy(tolerance)
        self.context = self.simulator.get_mutable_context()
        self._places = plant.GetPositions(self.context).copy()
        self._speeds = self.rates(self._motion)
        self.reset()

    def _add(self, joint: Joint) -> None:
        a, b = joint.pair
        body = self.problem.bodies[b]
        held, com = self.hang(b, joint, a)
        unit = UnitInertia(*(self.inertia(b) / body.mass))
        about = unit.ShiftFromCenterOfMass(com)
        added = self.plant.AddRigidBody(b, SpatialInertia(body.mass, com, about))
        self._bodies[b] = added
        turned = ROOM if joint.kind == "distance" and not self.problem.planar else RotationMatrix()
        frames = [
            self.plant.AddFrame(
                FixedOffsetFrame(f"{b}_{i}", parent.body_frame(), RigidTransform(turned, place))
            )
            for i, (parent, place) in enumerate(((self._bodies[a], held), (added, np.zeros(3))))
        ]
        self.plant.AddJoint(self._joint(joint, f"joint_{b}", *frames))

    def _joint(self, joint: Joint, name: str, *frames: FixedOffsetFrame) -> object:
        if self.problem.planar or joint.kind == "revolute":
            return RevoluteJoint(name, *frames, joint.axis)
        if joint.kind == "distance":
            return UniversalJoint(name, *frames)
        if joint.kind == "spherical":
            return BallRpyJoint(name, *frames)
        return PrismaticJoint(name, *frames, joint.axis)

    def _motion(self, name: str) -> tuple[Array, Array]:
        """Angular velocity of a body and the velocity of its centre of mass by the rates."""
        speeds = self._jacobian(name, (0.0, 0.0, 0.0))
        return speeds[:3], speeds[3:]

    def _jacobian(self, name: str, place: tuple[float, ...]) -> Array:
        world = self.plant.world_frame()
        return self.plant.CalcJacobianSpatialVelocity(
            self.context,
            JacobianWrtVariable.kV,
            self._bodies[name].body_frame(),
            self.local(name, place),
            world,
            world,
        )

    def reset(self) -> None:
        """Return to the start."""
        self.context.SetTime(0.0)
        self.plant.SetPositions(self.context, self._places)
        self.plant.SetVelocities(self.context, self._speeds)
        self.simulator.Initialize()

    def run(self, t: float | None = None) -> None:
        """Advance to a time, by default the end."""
        try:
            self.simulator.AdvanceTo(self.problem.stop if t is None else t)
        except RuntimeError as error:
            raise GaveUpError(str(error).partition("\n")[0][:80]) from error

    def energy(self) -> float:
        """Kinetic and potential energy [J]."""
        plant, context = self.plant, self.context
        return plant.CalcKineticEnergy(context) + plant.CalcPotentialEnergy(context)

    def watched(self) -> tuple[Array, Array]:
        """Positions and velocities of the watched places."""
        rates = self.plant.GetVelocities(self.context)
        places, speeds = [], []
        for name, place in self.problem.watch:
            pose = self.plant.EvalBodyPoseInWorld(self.context, self._bodies[name])
            places.append(pose @ self.local(name, place))
            speeds.append((self._jacobian(name, place) @ rates)[3:])
        return np.array(places), np.array(speeds)


def _observe(problem: Problem, tolerance: float) -> Observed:
    build = Build(problem, tolerance)
    found = [build.energy()]
    for i in range(SAMPLES):
        build.run((i + 1) / SAMPLES * problem.stop)
        found.append(build.energy())
    # Stops on the way shorten steps: the end is that of a run without them.
    build.reset()
    build.run()
    found.append(build.energy())
    return Observed.of(*build.watched(), found)


def _entry(problem: Problem, tolerance: float) -> Entry:
    build = Build(problem, tolerance)
    return Entry(build.run, build.reset)


def _excuse(problem: Problem) -> str:
    if len(problem.joints) != len(problem.bodies) or problem.key == "car_axis":
        return "cannot model it in continuous time: no loops, nothing that moves as told"
    return too_large(problem)


METHODS = (
    Method(
        name="Drake RK3",
        label="accuracy {:.0e}",
        settings=lambda _: TOLERANCES,
        observe=_observe,
        entry=_entry,
        excuse=_excuse,
    ),
)
