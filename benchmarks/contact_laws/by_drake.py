"""Drake on the experiments: point contacts of small spheres; runs where `drake` is.

R. Tedrake et al., "Drake: model-based design and verification for robotics". In continuous time
contacts are springs with the damping of Hunt and Crossley (1975), chosen for the restitution at the
speed of the approach, and friction is regularised below a stiction tolerance. In discrete time (A.
Castro, F. Permenter, X. Han, "An unconstrained convex formulation of compliant contact", IEEE
Transactions on Robotics 39, 2023) nothing is given back. Planar experiments move in x and z.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial

import numpy as np
from pydrake.geometry import (
    AddContactMaterial,
    HalfSpace,
    ProximityProperties,
    SceneGraph,
    Sphere,
)
from pydrake.math import RigidTransform, RotationMatrix
from pydrake.multibody.math import SpatialVelocity
from pydrake.multibody.plant import (
    AddMultibodyPlant,
    CoulombFriction,
    MultibodyPlant,
    MultibodyPlantConfig,
)
from pydrake.multibody.tree import (
    FixedOffsetFrame,
    PrismaticJoint,
    RevoluteJoint,
    RigidBody,
    SpatialInertia,
    UnitInertia,
)
from pydrake.systems.analysis import ResetIntegratorFromFlags, Simulator
from pydrake.systems.framework import DiagramBuilder

from benchmarks.contact_laws.experiments import (
    BOX_TURN,
    GRAVITY,
    KANE_ANGLES,
    KANE_RATES,
    PARK_FRICTION,
    PARK_MASS,
    PARK_SIZE,
    PARK_TIME,
    ROD_ANGLE,
    Impact,
    Rest,
    box_corners,
    box_inertia,
    parked_rows,
    turned_by,
)
from benchmarks.contact_laws.method import Method, RefusedError
from benchmarks.problems.parts import Array

DURATION = 2e-5
"""Of a contact without friction [s]; stiffnesses follow."""
LONG = 5.0
"""Durations of a contact after which velocities are read."""
ACCURACY = 1e-8
LEAST = 0.01
"""Restitution that stands for 0 in continuous time."""
STICTION = 1e-4
"""Slip [m/s] below which friction is smaller than Coulomb's, in continuous time."""
STEP = 1e-5
"""Of an impact in discrete time [s]."""
RIGID = 0.01
"""Threshold of near rigid contacts, in discrete time."""
RELAXATION, PARK_RELAXATION = 1e4, 1.0
"""Relaxation times in steps, of impacts and of the parked box: contacts push back in them."""
PARK_STEP, PARK_STICTION = 1e-4, 1e-5
"""Step in discrete time [s], stiction tolerance in continuous time [m/s]."""
PARK_STIFFNESS = 1e8
"""Of a corner [N/m]."""
PARK_DAMPING = 100.0
"""Its dissipation in continuous time [s/m]."""
RADIUS = 1e-3


def dissipation(e: float, v: float) -> float:
    """Of Hunt and Crossley, with which a speed of approach v [m/s] becomes e v [s/m].

    d (1 + e) v = ln((1 + d v)/(1 - d e v)), the integral of v dv/(1 + d v) over both phases.
    """
    if e == 1.0:
        return 0.0
    low, high = 1e-9, 1.0 / e - 1e-12
    for _ in range(200):
        x = 0.5 * (low + high)
        grown = math.log1p(x) - math.log1p(-x * e) > (1.0 + e) * x
        low, high = (low, x) if grown else (x, high)
    return low / v


class Build:
    """A plant with a ground on which small spheres of bodies touch the plane z = height."""

    def __init__(
        self,
        step: float,
        stiffness: float,
        damping: float,
        mu: float,
        relaxation: float = RELAXATION,
        stiction: float = STICTION,
    ) -> None:
        self.builder = DiagramBuilder()
        config = MultibodyPlantConfig(
            time_step=step, discrete_contact_approximation="sap", sap_near_rigid_threshold=RIGID
        )
        self.plant: MultibodyPlant
        self.scene: SceneGraph
        self.plant, self.scene = AddMultibodyPlant(config, self.builder)
        self.step, self.stiction = step, stiction
        self.properties = ProximityProperties()
        # Two that touch act in series, with the weighted mean of their dampings.
        AddContactMaterial(
            dissipation=damping, point_stiffness=2.0 * stiffness,
            friction=CoulombFriction(mu, mu), properties=self.properties,
        )  # fmt: skip
        self.properties.AddProperty("material", "relaxation_time", relaxation * step)
        self.plant.mutable_gravity_field().set_gravity_vector(np.zeros(3))

    def floor(self, height: float) -> None:
        """Add the ground."""
        pose = RigidTransform(np.array([0.0, 0.0, height]))
        ground = self.plant.world_body()
        self.plant.RegisterCollisionGeometry(ground, pose, HalfSpace(), "floor", self.properties)

    def body(self, name: str, mass: float, inertia: Array, com: Array | None = None) -> RigidBody:
        """Rigid body with moments of inertia (3,) about its centre of mass."""
        unit = UnitInertia(*(inertia / mass))
        centre = np.zeros(3) if com is None else com
        about = unit.ShiftFromCenterOfMass(centre)
        return self.plant.AddRigidBody(name, SpatialInertia(mass, centre, about))

    def ball(self, body: RigidBody, centre: Array, radius: float = RADIUS) -> None:
        """Let a sphere of a body, `centre` in its axes, touch."""
        name = f"ball{self.plant.num_collision_geometries()}"
        pose = RigidTransform(np.asarray(centre, float))
        self.plant.RegisterCollisionGeometry(body, pose, Sphere(radius), name, self.properties)

    def start(self) -> Simulator:
        """End drawing."""
        self.plant.Finalize()
        if not self.step:
            self.plant.set_stiction_tolerance(self.stiction)
        self.diagram = self.builder.Build()
        simulator = Simulator(self.diagram)
        if not self.step:
            ResetIntegratorFromFlags(simulator, "runge_kutta3", DURATION)
            integrator = simulator.get_mutable_integrator()
            integrator.set_fixed_step_mode(False)
            integrator.set_target_accuracy(ACCURACY)
            integrator.request_initial_step_size_target(1e-3 * DURATION)
        self.context = self.plant.GetMyMutableContextFromRoot(simulator.get_mutable_context())
        return simulator

    def run(self, simulator: Simulator, stop: float) -> None:
        """Advance to the end."""
        try:
            simulator.Initialize()
            simulator.AdvanceTo(stop)
        except RuntimeError as error:
            raise RefusedError(str(error).partition("\n")[0][:80]) from error


def _built(step: float, impact: Impact, mu: float, e: float) -> Build:
    if step and e:
        message = "no restitution in discrete time"
        raise RefusedError(message)
    duration = 0.1 * step if step else DURATION
    share = 4.0 if impact.key == "flat" else 1.0
    mass = impact.M[0, 0] if impact.key == "flat" else 1.0 / impact.delassus[0, 0]
    stiffness = (math.pi / duration) ** 2 * mass / share
    damping = dissipation(max(e, LEAST), impact.speed)
    return Build(step, stiffness, damping, mu)


def _stop(step: float, impact: Impact) -> float:
    count = len(impact.before) if impact.key.startswith("cradle") else 1
    return count * (10.0 * step if step else LONG * DURATION)


def _impact(step: float, impact: Impact, mu: float, e: float) -> Array:
    build = _built(step, impact, mu, e)
    if impact.key == "kane":
        read = _kane(build)
    elif impact.key.startswith("cradle"):
        read = _cradle(build, impact)
    else:
        read = _free(build, impact)
    return read(_stop(step, impact))


Read = Callable[[float], Array]
"""Runs to a time [s] and returns velocities."""


def _free(build: Build, impact: Impact) -> Read:
    planar = impact.key == "rod"
    if planar:
        x, z = 0.5 * math.cos(ROD_ANGLE), 0.5 * math.sin(ROD_ANGLE)
        place, Q, inertia = np.array([x, 0.0, z]), np.eye(3), np.ones(3) / 12.0
        places = [np.array([-x, 0.0, -z])]
        v = np.array([impact.before[0], 0.0, impact.before[1]])
    else:
        Q = turned_by(BOX_TURN if impact.key == "corner" else (0.0, 0.0, 0.0))
        places, inertia, v = list(box_corners(Q)), box_inertia(), impact.before[:3]
        place = np.array([0.0, 0.0, -places[0][2]])
    build.floor(0.0)
    body = build.body("b", 1.0, inertia)
    for i in impact.order:
        build.ball(body, Q.T @ (places[i] + np.array([0.0, 0.0, RADIUS])))
    simulator = build.start()
    plant, context = build.plant, build.context
    plant.SetFreeBodyPose(context, body, RigidTransform(RotationMatrix(Q), place))
    plant.SetFreeBodySpatialVelocity(context, body, SpatialVelocity(np.zeros(3), v))

    def read(stop: float) -> Array:
        build.run(simulator, stop)
        found = plant.EvalBodySpatialVelocityInWorld(context, body)
        v, w = found.translational(), found.rotational()
        return np.array([v[0], v[2], -w[1]]) if planar else np.array([*v, *w])

    return read


def _kane(build: Build) -> Read:
    """Angles of the hinges about -y are from the vertical, that of the second from the first."""
    build.floor(-float(np.cos(KANE_ANGLES).sum()))
    parent, joints = build.plant.world_body(), []
    for k in range(2):
        body = build.body(f"b{k}", 1.0, np.ones(3) / 12.0, np.array([0.0, 0.0, -0.5]))
        held = RigidTransform(np.array([0.0, 0.0, -1.0 if k else 0.0]))
        frame = build.plant.AddFrame(FixedOffsetFrame(f"f{k}", parent.body_frame(), held))
        joint = RevoluteJoint(f"j{k}", frame, body.body_frame(), [0.0, -1.0, 0.0])
        joints.append(build.plant.AddJoint(joint))
        parent = body
    up = turned_by((0.0, KANE_ANGLES[1], 0.0)) @ np.array([0.0, 0.0, RADIUS])
    build.ball(parent, np.array([0.0, 0.0, -1.0]) + up)
    simulator = build.start()
    angles, rates = np.diff(KANE_ANGLES, prepend=0.0), np.diff(KANE_RATES, prepend=0.0)
    for joint, angle, rate in zip(joints, angles, rates, strict=True):
        joint.set_angle(build.context, angle)
        joint.set_angular_rate(build.context, rate)

    def read(stop: float) -> Array:
        build.run(simulator, stop)
        return np.cumsum([joint.get_angular_rate(build.context) for joint in joints])

    return read


def _cradle(build: Build, impact: Impact) -> Read:
    joints = []
    for i in range(len(impact.before)):
        body = build.body(f"b{i}", 1.0, np.ones(3))
        world = build.plant.world_frame()
        joint = PrismaticJoint(f"j{i}", world, body.body_frame(), [1.0, 0.0, 0.0])
        joints.append(build.plant.AddJoint(joint))
    # All that have spheres may touch: contacts have the order in which balls get these.
    balls = range(len(joints))
    for i in balls if impact.order != impact.turned else reversed(balls):
        build.ball(build.plant.GetBodyByName(f"b{i}"), np.zeros(3), 0.5)
    simulator = build.start()
    for i, joint in enumerate(joints):
        joint.set_translation(build.context, float(i))
        joint.set_translation_rate(build.context, float(impact.before[i]))

    def read(stop: float) -> Array:
        build.run(simulator, stop)
        return np.array([joint.get_translation_rate(build.context) for joint in joints])

    return read


def _rest(step: float, demand: float) -> Rest:
    h = PARK_STEP if step else 0.0
    build = Build(h, PARK_STIFFNESS, PARK_DAMPING, PARK_FRICTION, PARK_RELAXATION, PARK_STICTION)
    build.floor(0.0)
    gravity = GRAVITY * np.array([demand, 0.0, -1.0])
    build.plant.mutable_gravity_field().set_gravity_vector(gravity)
    M, _ = parked_rows()
    half = 0.5 * np.array(PARK_SIZE)
    body = build.body("b", PARK_MASS, np.diag(M)[3:])
    for x, y in ((-1, -1), (-1, 1), (1, -1), (1, 1)):
        build.ball(body, half * (x, y, -1.0) + np.array([0.0, 0.0, RADIUS]))
    simulator = build.start()
    place = np.array([0.0, 0.0, half[2]])
    build.plant.SetFreeBodyPose(build.context, body, RigidTransform(place))
    build.run(simulator, PARK_TIME)
    pose = build.plant.EvalBodyPoseInWorld(build.context, body)
    moved = pose.translation() - place
    return Rest(float(moved[0]), float(moved[2]))


METHODS = (
    Method(
        name="Drake, continuous",
        settings=(
            f"RK3, accuracy {ACCURACY:g}; point contacts of {1e6 * DURATION:g} us, which sets the "
            f"stiffness, with the dissipation of the restitution, {LEAST:g} for 0; stiction "
            f"tolerance {STICTION:g} m/s; at rest {PARK_STIFFNESS:g} N/m a corner, dissipation "
            f"{PARK_DAMPING:g} s/m, stiction tolerance {PARK_STICTION:g} m/s"
        ),
        impact=partial(_impact, 0.0),
        rest=partial(_rest, 0.0),
    ),
    Method(
        name="Drake, discrete",
        settings=(
            f"SAP, threshold of near rigid contacts {RIGID:g}; steps of {1e6 * STEP:g} us and a "
            f"relaxation time of {RELAXATION:g} of them, at rest of {1e3 * PARK_STEP:g} ms and "
            f"{PARK_RELAXATION:g}; it has no restitution"
        ),
        impact=partial(_impact, STEP),
        rest=partial(_rest, STEP),
    ),
)
