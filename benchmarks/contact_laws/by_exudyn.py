"""Exudyn on the experiments: penalty contacts of small spheres; runs where `exudyn` is.

J. Gerstmayr, "Exudyn - a C++-based Python package for flexible multibody systems", Multibody System
Dynamics 60 (2024) 533-561. Planar experiments move in x and z. Contacts have impact model 2, which
its documentation calls the more accurate one; it asks for a restitution above 0, and at 1 it is
left out: a spring. Friction is proportional to the slip below a limit velocity.
"""

from __future__ import annotations

import math
from typing import Any

import exudyn as exu
import numpy as np
from exudyn.utilities import RigidBodyInertia

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
STEPS = 200
"""Of a contact."""
LONG = 5.0
"""Durations of a contact after which velocities are read."""
LEAST = 1e-3
"""Restitution that stands for 0."""
SLIP = 1e-4
"""Limit velocity of friction [m/s]."""
LEAD = 5.5
"""Steps before a contact; the impact models ask for its speed as it closes."""
RADIUS = 1e-3
PARK_STEP, PARK_SLIP, PARK_STIFFNESS = 1e-3, 1e-6, 1e8
"""Step [s], limit velocity [m/s] and stiffness of a corner [N/m]; damping is critical.

With shorter steps or a smaller limit velocity its iteration fails, and halved steps take minutes.
"""


class Build:
    """A system with a ground on which small spheres of bodies touch the plane z = height."""

    def __init__(self, law: dict[str, Any]) -> None:
        self.container = exu.SystemContainer()
        self.system = self.container.AddSystem()
        self.ground = self.system.CreateGround()
        self.law = law

    def body(
        self,
        mass: float,
        inertia: Array,
        place: Array,
        turn: Array,
        velocity: Array,
        omega: Array,
        gravity: Array | None = None,
    ) -> int:
        """Rigid body; moments of inertia (3,) in its axes, angular velocity in global ones."""
        return self.system.CreateRigidBody(
            referencePosition=list(place), referenceRotationMatrix=turn,
            initialVelocity=list(velocity), initialAngularVelocity=list(omega),
            inertia=RigidBodyInertia(mass=mass, inertiaTensor=np.diag(inertia)),
            gravity=[0.0] * 3 if gravity is None else list(gravity),
        )  # fmt: skip

    def floor(self, body: int, place: Array, turn: Array, at: Array, height: float) -> None:
        """Let the place of a body, `at` of its centre in global axes, touch the ground."""
        centre = turn.T @ (np.asarray(at) + np.array([0.0, 0.0, RADIUS]))
        x, y = np.asarray(place)[:2]
        quad = [[x - 9, y - 9, height], [x + 9, y - 9, height], [x + 9, y + 9, height],
                [x - 9, y + 9, height]]  # fmt: skip
        self.system.CreateSphereQuadContact(
            itemNumbers=[body, self.ground], localPosition0=list(centre), sphereRadius=RADIUS,
            quadPoints=quad, frictionProportionalZone=self.law["zone"], **self.law["fields"],
        )  # fmt: skip

    def run(self, stop: float, h: float) -> None:
        """Integrate to the end."""
        self.system.Assemble()
        settings = exu.SimulationSettings()
        time = settings.timeIntegration
        time.endTime, time.numberOfSteps = stop, round(stop / h)
        time.minimumStepSize = 1e-14
        time.verboseMode = 0
        time.newton.useModifiedNewton = False
        time.newton.maxIterations = 50
        settings.solution.file.write = False
        kind = exu.DynamicSolverType.TrapezoidalIndex2
        try:
            done = self.system.SolveDynamic(settings, solverType=kind, showHints=False)
        except (RuntimeError, ValueError, exu.SolverError) as error:
            raise RefusedError(str(error).strip().partition("\n")[0][:80]) from error
        if not done:
            message = "a step failed"
            raise RefusedError(message)

    def rates(self, body: int) -> tuple[Array, Array]:
        """Velocity and angular velocity, in global axes."""
        kinds = exu.OutputVariableType.Velocity, exu.OutputVariableType.AngularVelocity
        found = [np.array(self.system.GetObjectOutputBody(body, kind)) for kind in kinds]
        return found[0], found[1]


def _lead(impact: Impact) -> float:
    """Way [m] in the steps before a contact."""
    return float(-(impact.G @ impact.before)[0]) * LEAD * DURATION / STEPS


def _law(stiffness: float, mu: float, e: float) -> dict[str, Any]:
    fields: dict[str, Any] = {"contactStiffness": stiffness}
    if e < 1.0:
        fields |= {"impactModel": 2, "restitutionCoefficient": max(e, LEAST)}
    else:
        fields |= {"impactModel": 0, "contactDamping": 0.0}
    return {"zone": SLIP, "fields": fields | {"dynamicFriction": mu}}


def _impact(impact: Impact, mu: float, e: float) -> Array:
    share = 4.0 if impact.key == "flat" else 1.0
    softest = impact.M[0, 0] if impact.key == "flat" else 1.0 / impact.delassus[0, 0]
    build = Build(_law((math.pi / DURATION) ** 2 * softest / share, mu, e))
    read = _drawn(build, impact)
    count = len(impact.before) if impact.key.startswith("cradle") else 1
    build.run(LONG * DURATION * count, DURATION / STEPS)
    return read()


def _drawn(build: Build, impact: Impact) -> Any:
    """Draw an experiment; the function returned reads its velocities."""
    if impact.key == "rod":
        x, z = 0.5 * math.cos(ROD_ANGLE), 0.5 * math.sin(ROD_ANGLE)
        vx, vz, _ = impact.before
        turn, place = np.eye(3), np.array([x, 0.0, z])
        body = build.body(1.0, np.ones(3) / 12.0, place, turn, np.array([vx, 0.0, vz]), np.zeros(3))
        build.floor(body, place, turn, np.array([-x, 0.0, -z]), -_lead(impact))

        def of_rod() -> Array:
            v, w = build.rates(body)
            return np.array([v[0], v[2], -w[1]])

        return of_rod
    if impact.key == "kane":
        return _kane(build, _lead(impact))
    if impact.key.startswith("cradle"):
        return _cradle(build, impact)
    Q = turned_by(BOX_TURN if impact.key == "corner" else (0.0, 0.0, 0.0))
    corners = box_corners(Q)
    place = np.array([0.0, 0.0, -corners[0, 2]])
    body = build.body(1.0, box_inertia(), place, Q, impact.before[:3], np.zeros(3))
    for i in impact.order:
        build.floor(body, place, Q, corners[i], -_lead(impact))
    return lambda: np.concatenate(build.rates(body))


def _kane(build: Build, lead: float) -> Any:
    low, speed, bodies = np.zeros(3), np.zeros(3), []
    place, along = low, low
    for angle, rate in zip(KANE_ANGLES, KANE_RATES, strict=True):
        along = np.array([math.sin(angle), 0.0, -math.cos(angle)])
        across = np.array([math.cos(angle), 0.0, math.sin(angle)])
        place = low + 0.5 * along
        body = build.body(
            1.0, np.ones(3) / 12.0, place, np.eye(3), speed + 0.5 * rate * across,
            np.array([0.0, -rate, 0.0]),
        )  # fmt: skip
        build.system.CreateRevoluteJoint(
            bodyNumbers=[bodies[-1] if bodies else build.ground, body],
            position=list(low), axis=[0, 1, 0], useGlobalFrame=True,
        )  # fmt: skip
        bodies.append(body)
        low, speed = low + along, speed + rate * across
    build.floor(bodies[1], place, np.eye(3), 0.5 * along, float(low[2]) - lead)
    return lambda: np.array([-build.rates(body)[1][1] for body in bodies])


def _cradle(build: Build, impact: Impact) -> Any:
    masses = [
        build.system.CreateMassPoint(
            referencePosition=[i - _lead(impact) * (i == 0), 0.0, 0.0],
            initialVelocity=[float(v), 0.0, 0.0],
            physicsMass=1.0,
        )
        for i, v in enumerate(impact.before)
    ]  # fmt: skip
    fields = {name: value for name, value in build.law["fields"].items()}
    del fields["dynamicFriction"]
    for i in impact.order:
        build.system.CreateSphereSphereContact(
            itemNumbers=[masses[i], masses[i + 1]], spheresRadii=[0.5, 0.5], **fields
        )
    kind = exu.OutputVariableType.Velocity
    return lambda: np.array([build.system.GetObjectOutputBody(m, kind)[0] for m in masses])


def _rest(demand: float) -> Rest:
    damping = 2.0 * math.sqrt(PARK_STIFFNESS * PARK_MASS / 4.0)
    fields = {"contactStiffness": PARK_STIFFNESS, "contactDamping": damping, "impactModel": 0,
              "dynamicFriction": PARK_FRICTION}  # fmt: skip
    build = Build({"zone": PARK_SLIP, "fields": fields})
    M, _ = parked_rows()
    place, Q = np.array([0.0, 0.0, 0.5 * PARK_SIZE[2]]), np.eye(3)
    gravity = GRAVITY * np.array([demand, 0.0, -1.0])
    still = np.zeros(3)
    body = build.body(PARK_MASS, np.diag(M)[3:], place, Q, still, still, gravity)
    half = 0.5 * np.array(PARK_SIZE)
    for x, y in ((-1, -1), (-1, 1), (1, -1), (1, 1)):
        build.floor(body, place, Q, half * (x, y, -1.0), 0.0)
    build.run(PARK_TIME, PARK_STEP)
    kind = exu.OutputVariableType.Displacement
    moved = build.system.GetObjectOutputBody(body, kind)
    return Rest(float(moved[0]), float(moved[2]))


METHODS = (
    Method(
        name="Exudyn",
        settings=(
            f"trapezoidal index 2, {STEPS} steps a contact of {1e6 * DURATION:g} us, which sets "
            f"the stiffness; impact model 2 with e = {LEAST:g} for 0, at e = 1 a spring; limit "
            f"velocity of friction {SLIP:g} m/s; at rest {PARK_STIFFNESS:g} N/m a corner, "
            f"critically damped, limit velocity {PARK_SLIP:g} m/s, steps of {1e3 * PARK_STEP:g} ms"
        ),
        impact=_impact,
        rest=_rest,
    ),
)
