"""Contacts with curves and surfaces as gaps and slip rates.

profile       g = (y - p(x))/sqrt(1 + p'^2)
cam           g = (rho - r(phi))/sqrt(1 + (r'/rho)^2),   flat face  g = (c - p) . m - h(psi)
surface       g = F/sqrt(|grad F|^2 + (F/L)^2)
height field  g = (z - h)/sqrt(1 + |grad h|^2),         h = sum U_k(x) V_k(y), splines
superquadric  F = 1 - S^(1/p) inside, S^(1/p) - 1 outside,   S = |x/a|^p + |y/b|^p + |z/c|^p

with x, y and rho, phi the coordinates of the point in axes that a body carries, of a wheel or
roller those of its centre, whose path p or r is then (``solver.mechanics.curves``); c a cam's axis,
p a place of a face with the normal m towards the cam. Each vanishes exactly where the surfaces
touch, and its gradient has size 1 there; farther off it is the distance to first order alone, and
of a surface at most L, the size of the mechanism, as F is of any size. With n the normal in axes of
the body,

slip          s = xi' . t - R (w x n) . t,               n . t = 0

xi the coordinates there and w the angular velocity of the ball against the body
(``solver.mechanics.slips``); in space the tangents turn with n from those as drawn.
"""

from __future__ import annotations

from collections.abc import Sequence

from solver.mechanics.combination import Combination
from solver.mechanics.contacts import add_contact, as_drawn
from solver.mechanics.curves import centres_above, centres_around, separated, support_function
from solver.mechanics.derivative import derivative
from solver.mechanics.formulas import leaf_symbol, refuse_switches, rewritten
from solver.mechanics.frames import Ground, RigidFrame
from solver.mechanics.mechanism import Formula, Leaf
from solver.mechanics.parts import AXES, JointParts
from solver.mechanics.rows import Rows
from solver.mechanics.slips import (
    TINY,
    body_of,
    is_there,
    sliding,
    slips_along,
    tangents,
    turning,
)
from solver.mechanics.vectors import Vector, dot, scale, turned
from solver.runtime.layout import LEAF_RATE
from solver.scene import (
    CamContact,
    Expr,
    ExpressionError,
    HeightFieldContact,
    MeshContact,
    Number,
    PointReference,
    ProfileContact,
    RubbingContact,
    SuperquadricContact,
    SurfaceContact,
)
from solver.scene.expression import Curve, cos, operate, sin, sqrt, symbol
from solver.scene.profiles import table_of

CENTRE = 1e-12
"""Of a superquadric S = 1: S below which its centre is rounded off."""
Coordinates = Sequence[tuple[Combination, Combination]]
"""Forms link . axis of a place in axes of a body."""


def add_profile(rows: Rows, contact: ProfileContact, _: JointParts) -> None:
    """Keep a point or wheel above a profile that a body carries."""
    mechanism, parts = rows.mechanism, rows.parts
    frame, place = parts.frame(contact.body), parts.place(contact.point)
    upward = rows.unit(contact.axis or (0.0, 1.0))
    link = place - frame.place(contact.position or (0.0, 0.0))
    forms = [(link, frame.direction(x)) for x in (scale(-1.0, turned(upward)), upward)]
    curve = centres_above(rows, parts.scene.profiles[contact.profile], contact.radius)
    leaves = [mechanism.leaf(mechanism.component(*form)) for form in forms]
    x, y = leaf_symbol(0), leaf_symbol(1)
    slope = operate("spline_slope", x, curve)
    steepness = sqrt(1.0 + slope * slope)
    gap = Formula((y - operate("spline", x, curve)) / steepness, tuple(leaves))
    normal = (-1.0 * slope / steepness, 1.0 / steepness)
    slips = _slips(rows, contact, contact.point, leaves, normal, forms, contact.radius)
    add_contact(rows, contact, gap, slips=slips)


def add_cam(rows: Rows, contact: CamContact, _: JointParts) -> None:
    """Keep a point, a roller or a flat face off a cam."""
    parts = rows.parts
    joint = parts.scene.joints[contact.joint]
    body, position = joint.bodies[1], joint.position  # pyright: ignore
    frame = parts.frame(body)
    axes = [frame.direction(x) for x in ((1.0, 0.0), (0.0, 1.0))]
    centre, follower = frame.place(position), parts.place(contact.follower)
    if contact.face is not None:
        _add_flat_face(rows, contact, centre, axes)
        return
    mechanism, link = rows.mechanism, follower - centre
    curve = centres_around(rows, parts.scene.profiles[contact.profile], contact.radius)
    forms = [(link, axis) for axis in axes]
    leaves = [
        mechanism.leaf(mechanism.length(link)), mechanism.leaf(mechanism.angle(*forms))
    ]  # fmt: skip
    rho, phi = leaf_symbol(0), leaf_symbol(1)
    slope = operate("spline_slope", phi, curve) / rho
    steepness = sqrt(1.0 + slope * slope)
    gap = Formula((rho - operate("spline", phi, curve)) / steepness, tuple(leaves))
    c, s = cos(phi), sin(phi)
    normal = (c + slope * s) / steepness, (s - slope * c) / steepness
    slips = _slips(rows, contact, contact.follower, leaves, normal, forms, contact.radius)
    add_contact(rows, contact, gap, slips=slips)


def _add_flat_face(
    rows: Rows, contact: CamContact, centre: Combination, axes: Sequence[Combination]
) -> None:
    """Keep a cam off a face: it reaches h(psi) in the direction psi of the face.

    It touches h'(psi) beside the line from its axis to the face.
    """
    mechanism, parts = rows.mechanism, rows.parts
    assert contact.face is not None
    normal = rows.unit(contact.face, "face must not be of length zero")
    frame = parts.frame((contact.follower.point or "").partition(".")[0])
    link = centre - parts.place(contact.follower)
    towards = frame.direction(scale(-1.0, normal))
    angle = mechanism.angle((towards, axes[0]), (towards, axes[1]))
    height = mechanism.component(link, frame.direction(normal))
    curve = support_function(rows, parts.scene.profiles[contact.profile])
    extent = operate("spline", leaf_symbol(1), curve)
    gap = Formula(leaf_symbol(0) - extent, (mechanism.leaf(height), mechanism.leaf(angle)))
    slips = []
    if contact.friction is not None:
        across = mechanism.component(link, frame.direction(turned(normal)))
        value = -1.0 * leaf_symbol(1) - operate("spline", leaf_symbol(0), curve) * leaf_symbol(2)
        leaves = (
            mechanism.leaf(angle), mechanism.leaf(across, LEAF_RATE),
            mechanism.leaf(angle, LEAF_RATE),
        )  # fmt: skip
        slips.append(Formula(value, leaves))
    add_contact(rows, contact, gap, slips=slips)


def add_surface(rows: Rows, contact: SurfaceContact, _: JointParts) -> None:
    """Keep a point on one side of a surface that a formula gives."""
    parts = rows.parts
    forms = parts.frame(contact.body).coordinates(parts.place(contact.point))
    of_leaf = {symbol(axis): leaf_symbol(k) for k, axis in enumerate(AXES[: len(forms)])}

    def replace(part: Expr) -> Number | None:
        return of_leaf.get(part, part) if part.op == "symbol" else None

    value = rewritten(contact.surface, replace)
    slopes = [derivative(value, str(leaf)) for leaf in of_leaf.values()]
    for number in (value, *slopes):
        try:
            refuse_switches(number)
        except ExpressionError:
            message = "the surface must be smooth: write it without conditions, abs, min, max, mod "
            message += "and rounding of the coordinates"
            raise ExpressionError(message) from None
    gap = _nearby(rows, value, slopes)
    add_implicit(rows, contact, contact.point, forms, gap, slopes)


def add_superquadric(rows: Rows, contact: SuperquadricContact, _: JointParts) -> None:
    """Keep a point inside or outside of a superquadric."""
    forms = coordinates(rows, contact, rows.parts.place(contact.point))
    p, inside = contact.power, contact.side == "inside"
    total: Number = 0.0
    slopes: list[Number] = []
    for k, length in enumerate(contact.semi_axes):
        u = leaf_symbol(k) / length
        rest = operate("abs", u) ** (p - 2.0) if p > 2.0 else 1.0  # u |u|^(p - 2): no sign of u
        total = total + u * u * rest
        slopes.append(u * rest / length)
    # S^(1/p) grows evenly with the distance, 1 - S does not; the centre, where it has a kink, is
    # rounded off without changing where it is 1.
    sign, total = (-1.0 if inside else 1.0), total + CENTRE
    value = sign * (total ** (1.0 / p) - (1.0 + CENTRE) ** (1.0 / p))
    factor = sign * total ** (1.0 / p - 1.0)
    slopes = [factor * x for x in slopes]
    gap = _nearby(rows, value, slopes)
    add_implicit(rows, contact, contact.point, forms, gap, slopes)


def add_height_field(rows: Rows, contact: HeightFieldContact, _: JointParts) -> None:
    """Keep a point above a field of heights, a spline in either direction."""
    mechanism = rows.mechanism
    forms = coordinates(rows, contact, rows.parts.place(contact.point))
    leaves = [mechanism.leaf(mechanism.component(*form)) for form in forms]
    x, y, z = (leaf_symbol(k) for k in range(3))
    height: Number = 0.0
    slopes: list[Number] = [0.0, 0.0]
    for u, v in separated(contact.z):
        first, second = (
            Curve("height", table_of(contact.x, u)),
            Curve("height", table_of(contact.y, v)),
        )
        along, across = operate("spline", x, first), operate("spline", y, second)
        height = height + along * across
        slopes[0] = slopes[0] + operate("spline_slope", x, first) * across
        slopes[1] = slopes[1] + along * operate("spline_slope", y, second)
    steepness = sqrt(1.0 + dot(slopes, slopes))
    gap = Formula((z - height) / steepness, tuple(leaves))
    normal = (*(-1.0 * slope / steepness for slope in slopes), 1.0 / steepness)
    slips = _slips(rows, contact, contact.point, leaves, normal, forms, contact.ball_radius)
    add_contact(rows, contact, gap, slips=slips)


def coordinates(
    rows: Rows, contact: SuperquadricContact | HeightFieldContact | MeshContact, place: Combination
) -> Coordinates:
    """Return the coordinates of a place in axes of the body, from `position` or its origin."""
    frame = rows.parts.frame(contact.body)
    forms = frame.coordinates(place)
    if contact.position is None:
        return forms
    link = place - frame.place(contact.position)
    return tuple((link, axis) for _, axis in forms)


def _nearby(rows: Rows, value: Number, slopes: list[Number]) -> Number:
    """Return the distance to F = 0, to first order near it and finite everywhere."""
    far = value / rows.mechanism.extent
    return value / sqrt(dot(slopes, slopes) + far * far)


def add_implicit(
    rows: Rows, contact: SurfaceContact | SuperquadricContact | MeshContact, point: PointReference,
    forms: Coordinates, gap: Number, slopes: list[Number], end: str = "", up: Vector = (),
) -> None:  # fmt: skip
    """Keep a point off a surface with this normal, of any size; both are functions of coordinates.

    Tangents are smooth until the normal points against `up`, that as drawn unless given.
    """
    mechanism = rows.mechanism
    leaves = [mechanism.leaf(mechanism.component(*form)) for form in forms]
    steepness = sqrt(dot(slopes, slopes) + TINY)
    normal = tuple(slope / steepness for slope in slopes)
    slips = _slips(rows, contact, point, leaves, normal, forms, contact.ball_radius, up)
    add_contact(rows, contact, Formula(gap, tuple(leaves)), end=end, slips=slips)


# ------------------------------------------------------------------------------------- slip rates


def _slips(
    rows: Rows, contact: RubbingContact, point: PointReference, leaves: Sequence[Leaf],
    normal: Vector, forms: Coordinates, radius: Number, up: Vector = (),
) -> list[Formula]:  # fmt: skip
    """Return the slip rates of a ball about a point with these coordinates in axes of a body."""
    ball = body_of(rows, point) if is_there(radius) else None
    return slip_rates(rows, contact, ball, leaves, normal, [forms], radius, up=up)


def slip_rates(
    rows: Rows, contact: RubbingContact, ball: Ground | RigidFrame | None, leaves: Sequence[Leaf],
    normal: Vector, places: Sequence[Coordinates], radius: Number, shares: Vector = (1.0,),
    up: Vector = (),
) -> list[Formula]:  # fmt: skip
    """Return the slip rates of a ball about a place, by its coordinates in axes of a body.

    The place has these shares of others of the body of the ball; shares and normal, in the same
    axes, are functions of the leaves. Tangents turn with the normal from those of `up`, or of the
    normal as drawn.
    """
    if contact.friction is None:
        return []
    mechanism = rows.mechanism
    spokes = [*map(ball.direction, ball.axes)] if ball is not None else []
    axes = [axis for _, axis in places[0]]
    try:
        drawn = up or tuple(mechanism.default(as_drawn(mechanism, x, leaves)) for x in normal)
    except ExpressionError:
        drawn = ()
    if not any(drawn):  # there is no normal where the point is drawn
        drawn = (0.0, 0.0, 1.0)

    def velocity(tangent: Vector) -> Formula:
        used = list(leaves)
        value: Number = 0.0
        for share, forms in zip(shares, places, strict=True):
            value = value + share * sliding(mechanism, used, forms, tangent)
        if spokes:
            value = value - radius * turning(mechanism, used, spokes, axes, normal, tangent)
        return Formula(value, tuple(used))

    return slips_along(tangents(mechanism, normal, drawn), velocity)


SURFACES = {
    ProfileContact: add_profile, CamContact: add_cam, SurfaceContact: add_surface,
    SuperquadricContact: add_superquadric, HeightFieldContact: add_height_field,
}  # fmt: skip
