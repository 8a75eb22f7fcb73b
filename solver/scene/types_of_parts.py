"""The type that each part has in the file, by what the reader makes of it."""

from __future__ import annotations

from solver.scene.vocabulary import (
    Bar,
    Body,
    BodyJoint,
    ConstantAngle,
    Damper,
    Distance,
    DistanceDriver,
    Driver,
    Force,
    ForceElement,
    Gear,
    Gravitation,
    Joint,
    JointDriver,
    JointTorque,
    PointOn,
    PositionDriver,
    Potential,
    Rack,
    Rigid,
    Rolling,
    Spring,
    Torque,
    TorsionDamper,
    TorsionSpring,
)

SHARED_POINT = "shared_point"
"""Type of a spherical or revolute joint that is given by points: it has a force and no angle."""

_TYPES: dict[type, str] = {
    Bar: "bar", Rigid: "rigid",
    Distance: "distance", ConstantAngle: "angle", Gear: "gear", Rack: "rack", Rolling: "rolling",
    Spring: "spring", Damper: "damper", TorsionSpring: "torsion_spring",
    TorsionDamper: "torsion_damper", JointTorque: "joint_torque", Force: "force", Torque: "torque",
    Potential: "potential", Gravitation: "gravitation",
    PositionDriver: "position", DistanceDriver: "distance",
}  # fmt: skip


def type_of(part: Body | Joint | ForceElement | Driver) -> str:
    """Return the type of a part; ``SHARED_POINT`` for a joint that is given by points."""
    if isinstance(part, BodyJoint):
        return part.type if part.bodies is not None else SHARED_POINT
    if isinstance(part, PointOn | JointDriver):
        return part.type
    return _TYPES[type(part)]
