"""Contacts of ellipsoids as gaps and slip rates.

plane   g = (c - p) . n - h/|nu|,    h = |A nu|     s = d/dt (c - p) . t + sum x_k d/dt (d_k . t)
ball    g = y . m - h(m) - R,   m = w/|w|,  w_k = y_k/(a_k^2 + b)

with the centre c, directors d_k of the body and semi-axes a_k, A = diag a_k; nu_k = d_k . n the
normal n of the plane in axes of the body, and x_k = -a_k^2 nu_k/(h |nu|) the place that touches it;
|nu| is 1 but for the means of a step: with it, what has equal semi-axes moves as a ball does. The
centre of the ball has the coordinates y, and m is the normal, in axes of the ellipsoid, where it is
nearest. That is the direction in which y . m - h(m) is largest, with the root b of

S(b) = sum (a_k y_k/(a_k^2 + b))^2 = 1,    b := b + S (sqrt(S) - 1)/sum a_k^2 y_k^2/(a_k^2 + b)^3

which are Newton's steps for 1/sqrt(S): for a sphere it is linear, and one step is exact. They begin
where b is for a ball that touches, R h(m) with m as for b = 0. The gap has the square of the error
of m. Of a superquadric of another power the support function h has no bounded curvature where a
nu_k vanishes: it could not tell when a contact opens.
"""

from __future__ import annotations

from solver.mechanics.combination import Combination
from solver.mechanics.contacts import add_contact
from solver.mechanics.formulas import leaf_symbol
from solver.mechanics.frames import RigidFrame
from solver.mechanics.mechanism import Formula
from solver.mechanics.parts import JointParts
from solver.mechanics.rows import Rows
from solver.mechanics.slips import TINY, body_of, is_there, plane_tangents
from solver.mechanics.surfaces import slip_rates
from solver.mechanics.vectors import Vector, dot, identity, norm
from solver.runtime.layout import LEAF_RATE
from solver.scene import EllipsoidContact, Number
from solver.scene.expression import operate, sqrt

STEPS = 5
"""Of Newton's iteration (``tests/mechanics/test_ellipsoid_rows.py`` has what they leave)."""


def add_ellipsoid(rows: Rows, contact: EllipsoidContact, _: JointParts) -> None:
    """Keep an ellipsoid on one side of a plane, or off a ball."""
    body = rows.parts.frames[contact.body]
    assert isinstance(body, RigidFrame)
    if contact.axis is not None:
        _add_on_plane(rows, contact, body, contact.axis)
    else:
        _add_against_ball(rows, contact, body)


def _add_on_plane(rows: Rows, contact: EllipsoidContact, body: RigidFrame, axis: Vector) -> None:
    mechanism, carrier = rows.mechanism, rows.parts.frame(contact.on)
    zero = (0.0,) * mechanism.dim
    normal = rows.unit(axis)
    upward = carrier.direction(normal)
    spokes = [body.along(x) for x in identity(mechanism.dim)]
    link = body.at(zero) - carrier.place(contact.position or zero)
    leaves = [mechanism.leaf(mechanism.component(x, upward)) for x in (link, *spokes)]
    nu = tuple(leaf_symbol(1 + k) for k in range(mechanism.dim))
    reach = _support(contact.semi_axes, nu) / norm(nu)
    slips = []
    for tangent in plane_tangents(mechanism, normal) if contact.friction is not None else ():
        slips.append(_slip_on_plane(rows, contact, tangent, (link, upward), spokes))
    add_contact(rows, contact, Formula(leaf_symbol(0) - reach, tuple(leaves)), slips=slips)


def _slip_on_plane(
    rows: Rows, contact: EllipsoidContact, tangent: Vector,
    height: tuple[Combination, Combination], spokes: list[Combination],
) -> Formula:  # fmt: skip
    mechanism, (link, upward) = rows.mechanism, height
    along = rows.parts.frame(contact.on).direction(tangent)
    leaves = [mechanism.leaf(mechanism.component(link, along), LEAF_RATE)]
    places: list[Number] = []
    turning: Number = 0.0
    for a, spoke in zip(contact.semi_axes, spokes, strict=True):
        nu, rate = leaf_symbol(len(leaves)), leaf_symbol(len(leaves) + 1)
        leaves.append(mechanism.leaf(mechanism.component(spoke, upward)))
        leaves.append(mechanism.leaf(mechanism.component(spoke, along), LEAF_RATE))
        places.append(nu)
        turning = turning + a * a * nu * rate
    speed = dot(contact.surface_velocity or (0.0,) * mechanism.dim, tangent)
    reach = _support(contact.semi_axes, tuple(places)) * norm(places)
    return Formula(leaf_symbol(0) - speed - turning / reach, tuple(leaves))


def _support(semi_axes: Vector, direction: Vector) -> Number:
    """Return how far an ellipsoid reaches from its centre in a direction of its axes."""
    return norm([a * x for a, x in zip(semi_axes, direction, strict=True)])


def _add_against_ball(rows: Rows, contact: EllipsoidContact, body: RigidFrame) -> None:
    mechanism = rows.mechanism
    assert contact.point is not None
    forms = body.coordinates(rows.parts.place(contact.point))
    leaves = [mechanism.leaf(mechanism.component(*form)) for form in forms]
    y = tuple(leaf_symbol(k) for k in range(len(leaves)))
    w = _towards(contact.semi_axes, y, contact.radius)
    length = sqrt(dot(w, w) + TINY)
    gap = (dot(w, y) - _support(contact.semi_axes, w)) / length - contact.radius
    normal = tuple(x / length for x in w)
    ball = body_of(rows, contact.point) if is_there(contact.radius) else None
    slips = slip_rates(rows, contact, ball, leaves, normal, [forms], contact.radius)
    add_contact(rows, contact, Formula(gap, tuple(leaves)), slips=slips)


def _towards(semi_axes: Vector, y: Vector, radius: Number) -> Vector:
    """Return the normal, of any length, of an ellipsoid at the place that is nearest to y."""
    squares = tuple(a * a for a in semi_axes)
    least = squares[0]
    for square in squares[1:]:
        least = operate("min", least, square)
    w = tuple(x / square for x, square in zip(y, squares, strict=True))
    b = radius * _support(semi_axes, w) / sqrt(dot(w, w) + TINY)
    for _ in range(STEPS):
        w = tuple(x / (square + b) for x, square in zip(y, squares, strict=True))
        parts = tuple(square * x * x for square, x in zip(squares, w, strict=True))
        total: Number = TINY
        slope: Number = TINY
        for part, square in zip(parts, squares, strict=True):
            total, slope = total + part, slope + part / (square + b)
        b = operate("max", b + total * (sqrt(total) - 1.0) / slope, -0.5 * least)
    return tuple(x / (square + b) for x, square in zip(y, squares, strict=True))


ELLIPSOIDS = {EllipsoidContact: add_ellipsoid}
"""Contacts of ellipsoids."""
