"""Relations: distance, point on a line or surface, angle, gear, rack, rolling; and drivers.

    gear  theta_2 - k theta_1 = 0        rack  x_2 - R theta_1 = 0        surface  F(xi) = 0

    gear with backlash b   g = b/2 + (theta_2 - k theta_1),  g = b/2 - (theta_2 - k theta_1)

with xi the coordinates of a place in the axes of a body. A rolling disc has one holonomic row, the
height of its centre, and one velocity row for each tangent of the plane (theory 6.2).

A driven point is a node whose coordinates are signals; every other driver is a row
sigma - f(t) = 0 whose multiplier is the force that it exerts, F = -mu along +sigma (theory 6.1).
"""

from __future__ import annotations

from solver.mechanics.contacts import add_contact
from solver.mechanics.derivative import derivative
from solver.mechanics.formulas import formula, leaf_symbol
from solver.mechanics.joints import angle_between
from solver.mechanics.mechanism import Formula, Leaf, Scale
from solver.mechanics.parts import AXES, JointParts, RowOf
from solver.mechanics.rows import METRES, RADIANS, Rows
from solver.mechanics.vectors import (
    Vector,
    cross,
    dot,
    identity,
    perpendicular,
    scale,
    turned,
    unit,
)
from solver.runtime.layout import LEAF_RATE, LEAF_SIGNAL, LEAF_VALUE
from solver.scene import (
    AngleDriver,
    ConstantAngle,
    Constraint,
    DisplacementDriver,
    Distance,
    DistanceDriver,
    Gear,
    JointDriver,
    Number,
    PointOnLine,
    PointOnPlane,
    PointOnSurface,
    PositionDriver,
    Rack,
    Rolling,
    Scene,
)
from solver.scene.expression import cos, sqrt

PARALLEL = 1e-12
"""Least squared sine of an angle that is held: the gradient of its cosine vanishes with it."""


def add_rod(rows: Rows, joint: Distance, found: JointParts) -> None:
    """Add a massless rod."""
    rows.distance(rows.parts.link(joint.points), joint.length)
    found.row = "form", len(rows.mechanism.form_rows) - 1


def add_point_on(rows: Rows, joint: PointOnLine | PointOnPlane, found: JointParts) -> None:
    """Let a point stay on a line or plane of a body."""
    mechanism, frame = rows.mechanism, rows.parts.frame(joint.body)
    place = rows.parts.place(joint.point)
    axis = rows.unit(joint.axis)
    link = place - frame.place(joint.position or mechanism.drawn(place))
    for normal in mechanism.normals(axis) if isinstance(joint, PointOnLine) else (axis,):
        rows.offset(link, frame.direction(normal))
    found.reaction = rows.close()


def add_point_on_surface(rows: Rows, joint: PointOnSurface, found: JointParts) -> None:
    """Let a point stay on a surface F = 0 of a body."""
    mechanism, parts = rows.mechanism, rows.parts
    forms = parts.frame(joint.body).coordinates(parts.place(joint.point))
    axes = AXES[: mechanism.dim]
    found.own = {
        axis: Leaf(LEAF_VALUE, mechanism.component(*form))
        for axis, form in zip(axes, forms, strict=True)
    }
    row = found.row = rows.function(formula(parts, joint.surface, signals=True, own=found.own))
    found.pushes = [
        (row, derivative(joint.surface, axis), normal)
        for axis, (_, normal) in zip(axes, forms, strict=True)
    ]


def add_angle(rows: Rows, joint: ConstantAngle, found: JointParts) -> None:
    """Keep the angle between an axis of one body and one of another."""
    first, second = (rows.unit(x, "an axis must not be of length zero") for x in joint.axes)
    cosine = dot(first, second) if joint.value is None else cos(joint.value)
    text = "an angle of 0 or pi cannot be held: use a joint that keeps the axes parallel"
    rows.rule(1.0 - cosine * cosine - PARALLEL, ">", f"{text} ({{value!r}})")
    A, B = (rows.parts.frame(body) for body in joint.bodies)
    found.row = rows.direction(A.direction(first), B.direction(second), cosine, "angle")
    # mu acts along the cosine, a torque along the angle: d cos = -sin d angle.
    found.factor = -1.0 * sqrt(1.0 - cosine * cosine)


def add_gear(rows: Rows, joint: Gear, found: JointParts) -> None:
    """Couple the angles of two joints."""
    first, second = (rows.parts.joints[other] for other in joint.joints)
    if joint.backlash is None:
        _couple(rows, found, first.angle, second.angle, joint.ratio, RADIANS)
        return
    assert first.angle is not None
    assert second.angle is not None
    leaves = tuple(map(rows.mechanism.leaf, (first.angle, second.angle)))
    lead, half = leaf_symbol(1) - joint.ratio * leaf_symbol(0), 0.5 * joint.backlash
    for flank in (half + lead, half - lead):
        add_contact(rows, joint, Formula(flank, leaves), RADIANS)


def add_rack(rows: Rows, joint: Rack, found: JointParts) -> None:
    """Couple the displacement of the second joint to the angle of the first."""
    first, second = (rows.parts.joints[other] for other in joint.joints)
    _couple(rows, found, first.angle, second.displacement, joint.radius, METRES)


def _couple(
    rows: Rows, found: JointParts, first: int | None, second: int | None, ratio: Number,
    size: Scale,
) -> None:  # fmt: skip
    assert first is not None
    assert second is not None
    leaves = rows.mechanism.leaf(first), rows.mechanism.leaf(second)
    found.row = rows.function(Formula(leaf_symbol(1) - ratio * leaf_symbol(0), leaves), size)


def add_constraint(rows: Rows, constraint: Constraint, found: JointParts) -> None:
    """Add a formula that stays zero."""
    if constraint.value is not None:
        found.row = rows.function(formula(rows.parts, constraint.value, signals=True))
        return
    assert constraint.velocity is not None
    found.row = rows.velocity(formula(rows.parts, constraint.velocity, signals=False))


def add_rolling(rows: Rows, joint: Rolling, found: JointParts) -> None:
    """Let a disc roll on a fixed plane; in the plane on a fixed line."""
    normal = identity(rows.mechanism.dim)[-1]
    if joint.normal is not None:
        normal = rows.unit(joint.normal, "normal must not be zero")
    roll = _roll_on_a_line if rows.mechanism.dim == 2 else _roll_on_a_plane
    roll(rows, joint, normal, found)


def _roll_on_a_line(rows: Rows, joint: Rolling, normal: Vector, found: JointParts) -> None:
    """Hold the height at R, and (x - x_0) . t + R theta, with t to the right of the normal."""
    mechanism, parts = rows.mechanism, rows.parts
    ground, body, centre = parts.frame(None), parts.frame(joint.body), parts.named(joint.body)
    link = centre - ground.place(joint.position or (0.0, 0.0))
    upward = ground.direction(normal)
    height = rows.offset(link, upward, joint.radius, "height")
    way = centre - ground.place(mechanism.drawn(centre))
    tangent = ground.direction(scale(-1.0, turned(normal)))
    travel = mechanism.component(way, tangent)
    angle = angle_between(mechanism, ground, body, None)
    value = leaf_symbol(0) + joint.radius * leaf_symbol(1)
    row = rows.function(Formula(value, (mechanism.leaf(travel), mechanism.leaf(angle))), METRES)
    found.pushes = [(height, 1.0, upward), (row, 1.0, tangent)]


def _roll_on_a_plane(rows: Rows, joint: Rolling, normal: Vector, found: JointParts) -> None:
    """Hold the height of the centre, and the velocity of the disc's material where it touches.

    With c_1, c_2 in the plane of the disc, n_i = c_i . n and l = sqrt(n_1^2 + n_2^2), the contact
    lies at -(R/l) sum n_i c_i from the centre x: (x - p) . n - R l = 0, and for both tangents t
    x' . t - (R/l) sum n_i (c_i' . t) = 0.
    """
    mechanism, parts = rows.mechanism, rows.parts
    ground, body, centre = parts.frame(None), parts.frame(joint.body), parts.named(joint.body)
    assert joint.axis is not None
    axis = unit(joint.axis)
    upright = dot(axis, normal)
    text = "a disc that lies flat on its plane cannot roll; draw it upright ({value!r})"
    rows.rule(1.0 - upright * upright - PARALLEL, ">", text)
    n = ground.direction(normal)
    spokes = [body.direction(c) for c in mechanism.normals(axis)]
    up = [mechanism.leaf(mechanism.component(c, n)) for c in spokes]
    link = centre - ground.place(joint.position or (0.0, 0.0, 0.0))
    height = mechanism.leaf(mechanism.component(link, n))
    n_1, n_2 = leaf_symbol(0), leaf_symbol(1)
    lean = sqrt(n_1 * n_1 + n_2 * n_2)
    value = leaf_symbol(2) - joint.radius * lean
    found.pushes = [(rows.function(Formula(value, (*up, height)), METRES, "height"), 1.0, n)]
    first = perpendicular(normal, mechanism.default)[0]
    for tangent in (first, cross(normal, first)):
        t = ground.direction(tangent)
        slide = [mechanism.leaf(mechanism.component(x, t), LEAF_RATE) for x in (*spokes, centre)]
        turning = n_1 * leaf_symbol(2) + n_2 * leaf_symbol(3)
        value = leaf_symbol(4) - joint.radius * turning / lean
        found.pushes.append((rows.velocity(Formula(value, (*up, *slide)), METRES), 1.0, t))


def driven_points(scene: Scene) -> dict[str, tuple[str, Vector]]:
    """Return the driver of each driven point, and the path that it prescribes."""
    return {
        driver.point.point: (name, driver.value)
        for name, driver in scene.drivers.items()
        if isinstance(driver, PositionDriver)
        and driver.point.point in scene.points
        and not scene.points[driver.point.point].fixed
    }


def drive_position(rows: Rows, driver: PositionDriver, found: JointParts) -> None:
    """Let a point of a body follow a path; a point of its own has it as coordinates."""
    parts = rows.parts
    if driver.point.point not in parts.paths:
        place = parts.place(driver.point)
        for k, value in enumerate(driver.value):
            axis = parts.axis(k)
            row = _row(rows, rows.mechanism.component(place, axis), value, METRES)
            found.pushes.append((row, 1.0, axis))


def drive_joint(rows: Rows, driver: JointDriver, found: JointParts) -> None:
    """Prescribe the angle or displacement of a joint."""
    joint, turns = rows.parts.joints[driver.joint], driver.type == "angle"
    found.driven = joint.angle if turns else joint.displacement
    assert found.driven is not None
    found.row = _row(rows, found.driven, driver.value, RADIANS if turns else METRES)


def drive_distance(rows: Rows, driver: DistanceDriver, found: JointParts) -> None:
    """Prescribe the distance of two places."""
    found.driven = rows.mechanism.length(rows.parts.link(driver.points))
    found.row = _row(rows, found.driven, driver.value, METRES)


def _row(rows: Rows, quantity: int, value: Number, scale: Scale) -> RowOf:
    mechanism = rows.mechanism
    leaves = mechanism.leaf(quantity), Leaf(LEAF_SIGNAL, mechanism.signal(value))
    return rows.function(Formula(leaf_symbol(0) - leaf_symbol(1), leaves), scale, "driver")


COUPLINGS = {
    Distance: add_rod, PointOnLine: add_point_on, PointOnPlane: add_point_on,
    PointOnSurface: add_point_on_surface, ConstantAngle: add_angle, Gear: add_gear,
    Rack: add_rack, Rolling: add_rolling, Constraint: add_constraint,
    PositionDriver: drive_position, DistanceDriver: drive_distance,
    AngleDriver: drive_joint, DisplacementDriver: drive_joint,
}  # fmt: skip
