"""Joints, constraints, forces and drivers arrive as written, and name what they measure."""

import re
import sys
from pathlib import Path

import pytest

from solver.scene import (
    Actuator,
    AngleDriver,
    BoxContact,
    CamContact,
    CapsuleContact,
    ClearanceContact,
    ConstantAngle,
    Constraint,
    ConvexContact,
    CornersContact,
    CylinderContact,
    DisplacementDriver,
    DistanceDriver,
    EllipsoidContact,
    Force,
    Gear,
    Gravitation,
    HeightFieldContact,
    JointFriction,
    JointTorque,
    PlaneContact,
    PointOnLine,
    PointOnPlane,
    PointOnSurface,
    PointReference,
    PolygonContact,
    PositionDriver,
    Potential,
    Prismatic,
    ProfileContact,
    Rack,
    Revolute,
    Rolling,
    SceneError,
    Screw,
    SphereContact,
    Spherical,
    Spring,
    Stop,
    SuperquadricContact,
    SurfaceContact,
    Torque,
    TorsionDamper,
    TorsionSpring,
    Universal,
    loads,
    parse,
)
from solver.scene.scene import TYPES
from tests.support.mechanisms.scene_quantities import quantities_of

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

FOLDER = Path(__file__).parents[1] / "whole_scenes"
SPACE = (FOLDER / "space.toml").read_text(encoding="utf-8")
PLANE = (FOLDER / "plane.toml").read_text(encoding="utf-8")
ROUGH = (FOLDER / "rough.toml").read_text(encoding="utf-8")
SCENE = loads(SPACE)
POINT_A = PointReference(point="A")
TIP = PointReference(point="b1.tip")


def test_the_scenes_of_this_test_use_every_type_there_is():
    data = tomllib.loads(SPACE), tomllib.loads(PLANE), tomllib.loads(ROUGH)
    for table, types in TYPES.items():
        used = {part.get("type", "rigid") for d in data for part in d.get(table, {}).values()}
        assert used == set(types), table


@pytest.mark.parametrize(
    ("name", "joint"),
    [
        ("j2", Spherical(points=(PointReference(point="S"), PointReference(point="b1")))),
        ("j3", Revolute(bodies=(None, "b1"), position=(0.0, 0.0, 0.0),
                         axis=(0.0, 0.0, 1.0))),
        ("j4", Universal(bodies=("b1", "b2"), position=(0.0, 0.0, 0.0),
                         axes=((0.0, 0.0, 1.0), (1.0, 0.0, 0.0)))),
        ("j6", Prismatic(bodies=("b2", "b3"), position=(0.0, 0.0, 2.0),
                         axis=(0.0, 0.0, 1.0))),
        ("j9", Screw(bodies=("b3", "b4"), position=(0.0, 0.0, 0.0),
                         axis=(0.0, 0.0, 1.0), pitch=0.01)),
        ("k1", PointOnLine(point=POINT_A, body="b1", axis=(0.0, 0.0, 1.0))),
        ("k2", PointOnPlane(point=TIP, body=None, axis=(0.0, 0.0, 1.0))),
        ("k3", PointOnSurface(point=PointReference(point="b2", at=(0.0, 0.0, 1.0)), body=None,
                       surface=parse("x**2 + a*y**2 + z - 1"))),
        ("k4", ConstantAngle(bodies=("b1", "b2"), axes=((0.0, 0.0, 1.0), (1.0, 0.0, 0.0)))),
        ("k5", Gear(joints=("j3", "j5"), ratio=-2.0)),
        ("k6", Rack(joints=("j3", "j6"), radius=parse("a"))),
        ("k7", Rolling(body="b1", radius=0.5, axis=(0.0, 1.0, 0.0))),
    ],
)  # fmt: skip
def test_joints_arrive_as_written(name, joint):
    assert SCENE.joints[name] == joint


def test_friction_of_joints_arrives_as_written():
    (joint,) = (x for x in loads(PLANE).joints.values() if getattr(x, "friction", None))
    assert joint.friction == JointFriction(coefficient=0.1, preload=0.2)


def test_constraints_and_drivers_arrive_as_written():
    assert SCENE.constraints == {
        "c1": Constraint(value=parse("A.x**2 - b1.tip.x - sin(t)*u")),
        "c2": Constraint(velocity=parse("A.vx*sin(A.x) - b1.vy")),
    }
    ends = (POINT_A, PointReference(point="b2"))
    assert SCENE.drivers == {
        "d1": PositionDriver(point=POINT_A, value=(parse("sin(t)"), 0.0, parse("u"))),
        "d2": DistanceDriver(points=ends, value=parse("1 + t")),
        "d3": AngleDriver(joint="j3", value=parse("t")),
        "d4": DisplacementDriver(joint="j6", value=parse("0.1*t")),
    }
    assert SCENE.inputs["u"].interpolation == "ramp"


@pytest.mark.parametrize(
    ("name", "force"),
    [
        ("f1", Spring(points=(POINT_A, TIP), energy=parse("k*(length - 1)**4"))),
        ("f4", TorsionSpring(joint="j3", stiffness=2.0)),
        ("f5", TorsionDamper(joint="j3", damping=2.0)),
        ("f6", JointTorque(joint="j5", value=parse("-k*j5.angular_velocity + u"))),
        ("f7", Force(point=TIP, value=(parse("u"), parse("-A.vx"), 0.0), axes="body")),
        ("f8", Torque(body="b1", value=(0.0, 0.0, parse("j3.angle")))),
        ("f9", Potential(value=parse("A.x**2 + distance(A, b1.tip)"))),
        ("a1", Actuator(points=(POINT_A, TIP), value=parse("u"), max_force=3.0,
                        max_power=parse("k"))),
        ("a2", Actuator(joint="j3", value=parse("-rate"), ratio=20.0, efficiency=0.9)),
        ("a3", Actuator(guide="j6", value=parse("u"))),
        ("g1", Gravitation(points=(POINT_A, PointReference(point="b1")), masses=(1.0, 2.0))),
        ("g2", Gravitation(points=(PointReference(point="S"), PointReference(point="b1")),
                           masses=(1.0, 2.0), constant=1.0)),
    ],
)  # fmt: skip
def test_forces_arrive_as_written(name, force):
    assert SCENE.forces[name] == force


@pytest.mark.parametrize(
    ("name", "contact"),
    [
        ("n1", PlaneContact(point=TIP, body="link", axis=(0.0, 1.0), position=(0.0, -3.0),
                            radius=0.1, restitution=0.5, friction=0.3, static_friction=0.4,
                            surface_velocity=(parse("sin(t)"), 0.0))),
        ("n2", SphereContact(points=(POINT_A, PointReference(point="b2")), radii=(0.0, 0.1),
                             friction=0.2)),
        ("n3", ClearanceContact(points=(POINT_A, PointReference(point="b1")), radius=0.1,
                                pin_radius=0.2)),
        ("n4", Stop(joint="j1", of="angle", min=-1.0, max=2.0)),
        ("n5", Stop(joint="j3", of="displacement", max=1.0, restitution=1.0)),
        ("n6", Stop(points=(PointReference(point="O"), PointReference(point="b1")), max=2.0)),
        ("n7", ProfileContact(point=TIP, profile="road", body="link", position=(0.0, -3.0),
                              axis=(0.0, 2.0), radius=0.1)),
        ("n8", CamContact(joint="j1", follower=PointReference(point="b2"), profile="lobe",
                          radius=0.2, friction=0.1)),
        ("n9", CamContact(joint="j1", follower=PointReference(point="b2"), profile="lobe",
                          face=(0.0, -2.0))),
        ("n10", SurfaceContact(point=POINT_A, body="b4", surface=parse("x**2 + y**2 - 1"),
                              ball_radius=0.1)),
        ("n12", CornersContact(body="b4", corners=((1.0, 0.5), (1.0, -0.5)), axis=(0.0, 1.0),
                               position=(0.0, -3.0), on="link", radius=0.1, friction=0.3,
                               surface_velocity=(parse("sin(t)"), 0.0))),
        ("n13", PolygonContact(bodies=("b1", "b4"), friction=0.2, radii=(0.0, 0.1), corners=(
            ((-5.0, 0.0), (-4.0, 0.0), (-4.0, 2.0)), ((1.0, 0.0),)))),
        ("n14", CapsuleContact(bodies=("b1", None), radii=(0.1, pytest.approx(0.2)), segments=(
            ((0.0, 0.0), (1.0, 0.0)), ((9.0, 9.0),)))),
        ("n15", BoxContact(bodies=(None, "b4"), sizes=((0.1, 0.1), (1.0, 1.0)),
                           radii=(0.0, 0.1))),
        ("n17", BoxContact(bodies=("b4", None), sizes=((2.0, 1.0),), radii=(0.0, 0.1),
                           segment=((9.0, 9.0), (9.0, 8.0)))),
        ("n16", CornersContact(body="b4", size=(2.0, 1.0), axis=(0.0, 1.0),
                               position=(0.0, -3.0))),
        ("n11", SuperquadricContact(point=POINT_A, semi_axes=(3.0, 2.0), power=4.0,
                                   position=(0.0, 1.0))),
    ],
)  # fmt: skip
def test_contacts_arrive_as_written(name, contact):
    assert loads(PLANE).contacts[name] == contact


def test_a_height_field_arrives_as_written():
    assert loads(ROUGH).contacts["n1"] == HeightFieldContact(
        point=POINT_A, body="b1", x=(0.0, 1.0), y=(0.0, 1.0, 2.0),
        z=((0.0, 0.1, 0.0), (0.0, 0.0, 1.0)), position=(0.0, 0.0, 1.0), friction=0.1,
        ball_radius=parse("a"),
    )  # fmt: skip


def test_convex_parts_arrive_as_written():
    found = loads(ROUGH).contacts["n7"]
    assert isinstance(found, ConvexContact)
    assert (found.bodies, found.size, found.scale) == (("b2", None), (1.0, 1.0, 2.0), 0.5)
    assert found.files == {"file": found.file}
    assert b"v 0 0 1" in found.file.content


def test_a_cylinder_arrives_as_written():
    assert loads(ROUGH).contacts["n3"] == CylinderContact(
        body="b1", radius=parse("a"), length=0.2, along=(1.0, 0.0, 0.0), axis=(0.0, 0.0, 1.0),
        position=(0.0, 0.0, -1.0), friction=0.1, surface_velocity=(parse("sin(t)"), 0.0, 0.0),
    )  # fmt: skip


def test_ellipsoids_arrive_as_written():
    contacts = loads(ROUGH).contacts
    assert contacts["n5"] == EllipsoidContact(
        body="b1", semi_axes=(1.0, parse("a"), 2.0), axis=(0.0, 0.0, 1.0),
        position=(0.0, 0.0, -2.0), friction=0.1, surface_velocity=(parse("sin(t)"), 0.0, 0.0),
    )  # fmt: skip
    assert contacts["n6"] == EllipsoidContact(
        body="b2", semi_axes=(1.0, 1.0, 2.0), point=POINT_A, radius=parse("a"), friction=0.1
    )


def test_a_place_on_a_body_and_on_the_ground_are_kept_and_that_of_a_point_is_not():
    assert SCENE.forces["f2"].points == (
        PointReference(point=None, at=(1.0, 1.0, 1.0)),
        PointReference(point="b1"),
    )
    assert SCENE.joints["j1"].points == (TIP, PointReference(point="b2", at=(0.0, 0.0, 1.0)))


def own(names, *prefixes):
    return {name for name in names if name.split(".")[0] in prefixes}


def test_positions_and_rates_are_those_of_points_bodies_and_joints():
    levels = quantities_of(PLANE)
    positions, rates = (
        {name for name, level in levels.items() if level == wanted}
        for wanted in ("position", "rate")
    )
    assert own(positions, "A", "link") == {"A.x", "A.y", "link.angle"}
    assert own(positions, "b1") == {"b1.x", "b1.y", "b1.angle", "b1.tip.x", "b1.tip.y"}
    assert own(rates, "b2", "link") == {
        "b2.vx", "b2.vy", "b2.angular_velocity", "link.angular_velocity",
    }  # fmt: skip
    assert own(positions | rates, "j1") == {"j1.angle", "j1.angular_velocity"}
    assert own(positions | rates, "j3") == {"j3.displacement", "j3.velocity"}
    assert not own(positions | rates, "j2", "f1", "energy")


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("j1", "force"),
        ("j2", "force.x force.y force.z"),
        ("j3", "angle angular_velocity angular_acceleration"
               " force.x force.y force.z torque.x torque.y torque.z"),
        ("j5", "angle angular_velocity angular_acceleration displacement velocity acceleration"
               " force.x force.y force.z torque.x torque.y torque.z"),
        ("j8", "force.x force.y force.z torque.x torque.y torque.z"),
        ("k1", "force.x force.y force.z"),
        ("k4", "torque"),
        ("k5", "torque"),
        ("k6", "force"),
        ("k7", "force.x force.y force.z"),
        ("c1", "multiplier"),
        ("f1", "length force power"),
        ("f4", "torque power"),
        ("f7", "power"),
        ("f9", "energy power"),
        ("a1", "length force power limited"),
        ("a2", "torque motor_speed power limited"),
        ("a3", "force power limited"),
        ("g1", "length force power"),
        ("d1", "force.x force.y force.z power"),
        ("d2", "force power"),
        ("d3", "torque power"),
        ("d4", "force power"),
        ("b2", "x y z vx vy vz ax ay az qw qx qy qz wx wy wz wdx wdy wdz"),
        ("i1", "fx fy fz wx wy wz"),
        ("i2", "x y z vx vy vz distance angle psi_x psi_y psi_z wx wy wz"),
        ("i3", "x y z vx vy vz distance"),
    ],
)  # fmt: skip
def test_quantities_in_space(name, words):
    expected = {f"{name}.{word}" for word in words.split()}
    assert own(quantities_of(SPACE), name) == expected


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("j1", "angle angular_velocity angular_acceleration force.x force.y"),
        ("j2", "force.x force.y"),
        (
            "j3",
            "displacement velocity acceleration force.x force.y torque.z"
            " friction slip friction_mode power",
        ),
        ("j4", "force.x force.y torque.z"),
        ("b2", "x y vx vy ax ay angle angular_velocity angular_acceleration"),
        ("n1", "gap force mode impacts impulse friction slip"),
        ("n3", "gap force mode impacts impulse"),
        ("n4", "gap force mode impacts impulse"),
        ("n8", "gap force mode impacts impulse friction slip"),
        ("n12", "gap force mode impacts impulse friction slip"),
        ("n10", "gap force mode impacts impulse"),
        ("j9", "torque gap force mode impacts impulse"),
        ("f1", "power"),
        ("i1", "fx fy w"),
        ("i2", "x y vx vy distance angle angular_velocity"),
    ],
)
def test_quantities_in_the_plane(name, words):
    expected = {f"{name}.{word}" for word in words.split()}
    assert own(quantities_of(PLANE), name) == expected


def test_a_scene_has_losses_of_contacts_only_where_something_touches():
    """They are quantities that an output may use; without contacts and friction unknown."""
    text = '[outputs]\nlost = { value = "energy.impact + energy.friction + solver.events" }\n'
    plane = PLANE.replace("[outputs]", text)
    assert "lost" in loads(plane).outputs
    rubbing = "".join(x for x in plane.splitlines(keepends=True) if x[0] != "n" or x[1] == "a")
    assert "lost" in loads(rubbing.replace("[contacts]", "")).outputs
    free = re.sub(", (friction = {.*?}|backlash.*0.5)", "", rubbing.replace("[contacts]", ""))
    with pytest.raises(SceneError, match=r"unknown quantity 'energy\.impact'"):
        loads(free)


def test_a_joint_of_unknown_type_is_reported_alone():
    """Neither the gear nor the output that name it add a mistake of their own."""
    text = PLANE.replace('j1 = { type = "revolute"', 'j1 = { type = "revolut"')
    with pytest.raises(SceneError) as caught:
        loads(text)
    (problem,) = caught.value.problems
    assert problem.location == "joints.j1.type"


@pytest.mark.parametrize(
    ("expression", "linear"),
    [
        ("A.vx*sin(A.x) - A.vy", True),
        ("2*t*A.vx/(1 + A.x**2) - sin(t)*A.vy", True),
        ("A.vx if A.x > 0 else A.vy", True),
        ("A.vx if A.x > 0 else 0", True),
        ("A.vx - 2*t", False),
        ("A.vx/(1 + A.x**2) + 3", False),
        ("A.vx*A.vy", False),
        ("1/A.vx", False),
        ("A.vx**2", False),
        ("sin(A.vx)", False),
        ("A.vy if A.vx > 0 else 1", False),
    ],
)
def test_rows_on_velocities_must_be_linear_in_them(expression, linear):
    text = PLANE + f'[constraints]\nrow = {{ velocity = "{expression}" }}\n'
    if linear:
        assert loads(text).constraints["row"].velocity == parse(expression)
    else:
        with pytest.raises(SceneError, match="must be linear in the velocities"):
            loads(text)
