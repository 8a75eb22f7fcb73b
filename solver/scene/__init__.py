"""What a user writes: scene files, read and checked, with errors like a compiler's.

scene = load("double_pendulum.toml", {"length": 2.0, "points.A.mass": 3.0})
"""

from __future__ import annotations

from solver.scene.actuators import Actuator
from solver.scene.bodies import Bar, Body, Point, Rigid
from solver.scene.contact_laws import Contact, RubbingContact
from solver.scene.contacts import (
    ClearanceContact,
    CornersContact,
    JournalContact,
    PlaneContact,
    SphereContact,
    Stop,
)
from solver.scene.couplings import (
    ConstantAngle,
    Distance,
    Gear,
    PointOn,
    PointOnLine,
    PointOnPlane,
    PointOnSurface,
    Rack,
    Rolling,
)
from solver.scene.drivers import (
    AngleDriver,
    Constraint,
    DisplacementDriver,
    DistanceDriver,
    JointDriver,
    PositionDriver,
)
from solver.scene.ellipsoids import EllipsoidContact
from solver.scene.expression import Expr, ExpressionError, Number, Vector, evaluate, symbols
from solver.scene.fields import Part, PointReference
from solver.scene.forces import (
    Damper,
    Force,
    Gravitation,
    JointTorque,
    Potential,
    Spring,
    Torque,
    TorsionDamper,
    TorsionSpring,
)
from solver.scene.friction import JointFriction
from solver.scene.grammar import parse
from solver.scene.joints import (
    BodyJoint,
    Cylindrical,
    Fixed,
    Planar,
    Prismatic,
    Revolute,
    Screw,
    Spherical,
    Universal,
)
from solver.scene.meshes import ConvexContact, MeshContact
from solver.scene.mistakes import Given, Problem, SceneError, SceneWarning, Source
from solver.scene.parameters import Input, Parameter
from solver.scene.profiles import Profile
from solver.scene.reader import load, loads
from solver.scene.scene import Output, Scene, json_schema
from solver.scene.sensors import Imu, Relative
from solver.scene.settings import Experiment, SolverSettings
from solver.scene.shapes import (
    BoxContact,
    CapsuleContact,
    CylinderContact,
    PairContact,
    PolygonContact,
    RoundedContact,
)
from solver.scene.surfaces import (
    CamContact,
    HeightFieldContact,
    ProfileContact,
    SuperquadricContact,
    SurfaceContact,
)
