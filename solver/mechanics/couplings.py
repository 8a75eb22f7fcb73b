"""Joints that are relations: distance, point on a line or surface, angle, gear, rack, rolling.

    gear  theta_2 - k theta_1 = 0        rack  x_2 - R theta_1 = 0        surface  F(xi) = 0

with xi the coordinates of a place in the axes of a body. A rolling disc has one holonomic row, the
height of its centre, and one velocity row for each tangent of the plane (theory 6.2).
"""

from __future__ import annotations

from solver.mechanics.bodies import add_distance
from solver.mechanics.derivative import derivative
from solver.mechanics.equations import RATE, VALUE, Leaf, Scale
from solver.mechanics.formulas import Compiler, leaf_symbol
from solver.mechanics.joints import angle_between
from solver.mechanics.parts import AXES, JointParts, Parts
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
from solver.runtime.model import Row
from solver.scene import (
    ConstantAngle,
    Constraint,
    Distance,
    Gear,
    Number,
    PointOnLine,
    PointOnPlane,
    PointOnSurface,
    Rack,
    Rolling,
)
from solver.scene.expression import cos, sqrt

PARALLEL = 1e-12
"""Least squared sine of an angle that is held: the gradient of its cosine vanishes with it."""


def _rows(parts: Parts, name: str, table: str = "joints", word: str = "joint") -> Rows:
    return Rows(parts.mechanism, f"{table}.{name}", f"{word} '{name}'")


def add_rod(parts: Parts, name: str, joint: Distance) -> None:
    """Add a massless rod."""
    row = Row(f"joints.{name}", f"joint '{name}'", "length")
    add_distance(parts.mechanism, parts.link(joint.points), joint.length, row)
    parts.joints[name] = JointParts(row=("form", len(parts.mechanism.form_rows) - 1))


def add_point_on(parts: Parts, name: str, joint: PointOnLine | PointOnPlane) -> None:
    """Let a point stay on a line or plane of a body."""
    mechanism, frame = parts.mechanism, parts.frame(joint.body)
    rows = _rows(parts, name)
    place = parts.place(joint.point)
    found = parts.joints[name] = JointParts()
    part = (rows.location, rows.name)
    mechanism.rule(dot(joint.axis, joint.axis), ">", part, "axis must not be of length zero")
    axis = unit(joint.axis)
    link = place - frame.place(joint.position or mechanism.drawn(place))
    normals: tuple[Vector, ...] = (axis,)
    if isinstance(joint, PointOnLine):
        plane = mechanism.dim == 2
        normals = (turned(axis),) if plane else perpendicular(axis, mechanism.default)
    for normal in normals:
        rows.offset(link, frame.direction(normal))
    found.reaction = rows.close()


def add_point_on_surface(
    parts: Parts, compiler: Compiler, name: str, joint: PointOnSurface
) -> None:
    """Let a point stay on a surface F = 0 of a body."""
    mechanism, frame = parts.mechanism, parts.frame(joint.body)
    forms = frame.coordinates(parts.place(joint.point))
    own = {
        axis: Leaf(VALUE, mechanism.component(*form))
        for axis, form in zip(AXES, forms, strict=False)
    }
    formula = compiler.formula(joint.surface, signals=True, own=own)
    rows = _rows(parts, name)
    row = rows.function(formula.value, formula.leaves, compiler.scale(formula))
    found = parts.joints[name] = JointParts(row=("function", row))
    normals = [w for _, w in forms]
    slopes = [derivative(joint.surface, axis) for axis in AXES[: mechanism.dim]]
    found.pushes = [
        (("function", row), slope, normal) for slope, normal in zip(slopes, normals, strict=True)
    ]
    found.own = own


def add_angle(parts: Parts, name: str, joint: ConstantAngle) -> None:
    """Keep the angle between an axis of one body and one of another."""
    mechanism = parts.mechanism
    rows = _rows(parts, name)
    part = (rows.location, rows.name)
    for axis in joint.axes:
        mechanism.rule(dot(axis, axis), ">", part, "an axis must not be of length zero")
    first, second = (unit(axis) for axis in joint.axes)
    cosine = dot(first, second) if joint.value is None else cos(joint.value)
    text = "an angle of 0 or pi cannot be held: use a joint that keeps the axes parallel"
    mechanism.rule(1.0 - cosine * cosine - PARALLEL, ">", part, f"{text} ({{value!r}})")
    frames = [parts.frame(body) for body in joint.bodies]
    row = rows.direction(frames[0].direction(first), frames[1].direction(second), cosine, "angle")
    found = parts.joints[name] = JointParts(row=("form", row))
    # mu acts along the cosine, a torque along the angle: d cos = -sin d angle.
    found.factor = -1.0 * sqrt(1.0 - cosine * cosine)


def add_gear(parts: Parts, name: str, joint: Gear) -> None:
    """Couple the angles of two joints."""
    angles = [parts.joints[other].angle for other in joint.joints]
    _couple(parts, name, (angles[0], angles[1]), joint.ratio, RADIANS)


def add_rack(parts: Parts, name: str, joint: Rack) -> None:
    """Couple the displacement of the second joint to the angle of the first."""
    first, second = (parts.joints[other] for other in joint.joints)
    _couple(parts, name, (first.angle, second.displacement), joint.radius, METRES)


def _couple(
    parts: Parts, name: str, quantities: tuple[int | None, int | None], ratio: Number, size: Scale
) -> None:
    if None in quantities:
        parts.problems.append((f"joints.{name}", "a joint it names has no such motion"))
        parts.joints[name] = JointParts()
        return
    leaves = tuple(Leaf(VALUE, parts.mechanism.use(q)) for q in quantities if q is not None)
    rows = _rows(parts, name)
    row = rows.function(leaf_symbol(1) - ratio * leaf_symbol(0), leaves, size)
    parts.joints[name] = JointParts(row=("function", row))


def add_constraint(
    parts: Parts, compiler: Compiler, name: str, constraint: Constraint
) -> None:  # fmt: skip
    """Add a formula that stays zero."""
    rows = _rows(parts, name, "constraints", "constraint")
    if constraint.value is not None:
        formula = compiler.formula(constraint.value, signals=True)
        row = rows.function(formula.value, formula.leaves, compiler.scale(formula))
        parts.joints[name] = JointParts(row=("function", row))
        return
    assert constraint.velocity is not None
    formula = compiler.formula(constraint.velocity, signals=False)
    if not compiler.is_linear_in_rates(formula):
        text = "velocity must be linear in the velocities, without a part that contains none"
        parts.problems.append((f"constraints.{name}.velocity", text))
    row = rows.velocity(formula.value, formula.leaves, compiler.scale(formula))
    parts.joints[name] = JointParts(row=("velocity", row))


def add_rolling(parts: Parts, name: str, joint: Rolling) -> None:
    """Let a disc roll on a fixed plane; in the plane on a fixed line."""
    mechanism = parts.mechanism
    rows = _rows(parts, name)
    part = (rows.location, rows.name)
    mechanism.rule(joint.radius, ">", part, "radius must be > 0 m")
    normal = identity(mechanism.dim)[-1]
    if joint.normal is not None:
        mechanism.rule(dot(joint.normal, joint.normal), ">", part, "normal must not be zero")
        normal = unit(joint.normal)
    found = parts.joints[name] = JointParts()
    if mechanism.dim == 2:
        _roll_on_a_line(parts, rows, joint, normal, found)
    else:
        _roll_on_a_plane(parts, rows, joint, normal, found)


def _roll_on_a_line(
    parts: Parts, rows: Rows, joint: Rolling, normal: Vector, found: JointParts
) -> None:
    """Hold the height at R, and (x - x_0) . t + R theta, with t to the right of the normal."""
    mechanism, ground, body = parts.mechanism, parts.frame(None), parts.frame(joint.body)
    centre = parts.named(joint.body)
    link = centre - ground.place(joint.position or (0.0, 0.0))
    height = rows.offset(link, ground.direction(normal), joint.radius, "height")
    tangent = scale(-1.0, turned(normal))
    travel = mechanism.component(
        centre - ground.place(mechanism.drawn(centre)), ground.direction(tangent)
    )
    angle = angle_between(mechanism, ground, body, None)
    leaves = tuple(Leaf(VALUE, mechanism.use(q)) for q in (travel, angle))
    row = rows.function(leaf_symbol(0) + joint.radius * leaf_symbol(1), leaves, METRES)
    found.pushes = [
        (("form", height), 1.0, ground.direction(normal)),
        (("function", row), 1.0, ground.direction(tangent)),
    ]


def _roll_on_a_plane(
    parts: Parts, rows: Rows, joint: Rolling, normal: Vector, found: JointParts
) -> None:
    """Hold the height of the centre, and the velocity of the disc's material where it touches.

    With c_1, c_2 in the plane of the disc, n_i = c_i . n and l = sqrt(n_1^2 + n_2^2), the contact
    lies at -(R/l) sum n_i c_i from the centre x: (x - p) . n - R l = 0, and for both tangents t
    x' . t - (R/l) sum n_i (c_i' . t) = 0.
    """
    mechanism, ground, body = parts.mechanism, parts.frame(None), parts.frame(joint.body)
    assert joint.axis is not None
    centre, axis = parts.named(joint.body), unit(joint.axis)
    upright = dot(axis, normal)
    text = "a disc that lies flat on its plane cannot roll; draw it upright ({value!r})"
    part = (rows.location, rows.name)
    mechanism.rule(1.0 - upright * upright - PARALLEL, ">", part, text)
    n = ground.direction(normal)
    spokes = [body.direction(c) for c in perpendicular(axis, mechanism.default)]
    up = [Leaf(VALUE, mechanism.use(mechanism.component(c, n))) for c in spokes]
    link = centre - ground.place(joint.position or (0.0, 0.0, 0.0))
    height = Leaf(VALUE, mechanism.use(mechanism.component(link, n)))
    n_1, n_2 = leaf_symbol(0), leaf_symbol(1)
    lean = sqrt(n_1 * n_1 + n_2 * n_2)
    row = rows.function(leaf_symbol(2) - joint.radius * lean, (*up, height), METRES, "height")
    found.pushes = [(("function", row), 1.0, n)]
    first = perpendicular(normal, mechanism.default)[0]
    for tangent in (first, cross(normal, first)):
        t = ground.direction(tangent)
        slide = [Leaf(RATE, mechanism.use(mechanism.component(x, t))) for x in (*spokes, centre)]
        turning = n_1 * leaf_symbol(2) + n_2 * leaf_symbol(3)
        value = leaf_symbol(4) - joint.radius * turning / lean
        row = rows.velocity(value, (*up, *slide), METRES)
        found.pushes.append((("velocity", row), 1.0, t))
