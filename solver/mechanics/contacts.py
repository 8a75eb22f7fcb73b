"""Contacts as gaps and slip rates.

plane      g = (x - p) . n - R                 s = d/dt (x - p) . t - R sum n_i d/dt (c_i . t)
corners    the same of each corner x of a body
sphere     g = |u| - (r_1 + r_2),              s = (r_1 + r_2) u' . J u/|u|^2 - r_1 w_1 - r_2 w_2
clearance  g = (c^2 - |u|^2)/2c,               s = c u' . J u/|u|^2 + r w_2 - (c + r) w_1
journal    g = (c^2 - x^2 - y^2)/2c of both ends, in axes of the bearing; slips around and along it
stop       g = sigma - min, g = max - sigma    (an angle, a displacement, a distance);  s = r w

with u from the first centre to the second (of a clearance: from the hole to the pin), n_i = c_i . n
components of the normal along the directors c_i of the body that carries the ball, w angular
velocities; of a stop along an axis, and of those of a journal, w is that about the axis and r the
mean radius of the faces that rub. In space balls slip by ((r_1 + r_2) u'/|u| - (r_1 w_1 + r_2 w_2)
x n) . t along each of two tangents t of the normal n = u/|u| (``solver.mechanics.slips``). The
gradient of a gap has size 1 where the surfaces touch, so that its multiplier is a force. A slip
rate is that of the materials that touch. The gap of a clearance is smooth where |u| vanishes, too.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import product
from typing import Any

from solver.mechanics.combination import Combination
from solver.mechanics.formulas import leaf_symbol, with_symbols
from solver.mechanics.frames import RigidFrame
from solver.mechanics.kinks import add_kinks_of_contact
from solver.mechanics.mechanism import Contact, Formula, Friction, Leaf, Mechanism, Scale
from solver.mechanics.parts import CompliantContact, JointParts
from solver.mechanics.rows import METRES, RADIANS, Rows
from solver.mechanics.slips import (
    body_of,
    dot_of_pairs,
    is_there,
    plane_tangents,
    sliding,
    slips_along,
    tangents,
    turning,
)
from solver.mechanics.vectors import Vector, add, dot, scale, unit
from solver.runtime.layout import LEAF_RATE
from solver.scene import (
    ClearanceContact,
    CornersContact,
    Gear,
    JournalContact,
    Number,
    PlaneContact,
    PointReference,
    RubbingContact,
    SphereContact,
    Stop,
)
from solver.scene import (
    Contact as ContactPart,
)
from solver.scene.expression import operate, sqrt

Touching = ContactPart | Gear
"""What has gaps: a contact, or a gear with backlash."""
LEAST_DISTANCE = 1e-12
"""Of two points that a stop lets apart [m]."""
SKEW = unit((0.61, 0.53, 0.71))
"""Normal of balls in space where their tangents begin: no axis of a drawing points against it."""


def add_plane(rows: Rows, contact: PlaneContact, _: JointParts) -> None:
    """Keep a ball on one side of a plane that a body carries."""
    ball = body_of(rows, contact.point)
    _add_ball_on_plane(rows, contact, contact.body, rows.parts.place(contact.point), ball)


def add_corners(rows: Rows, contact: CornersContact, _: JointParts) -> None:
    """Keep the corners of a body on one side of a plane."""
    frame = rows.parts.frames[contact.body]
    assert isinstance(frame, RigidFrame)
    corners = contact.corners
    if contact.size is not None:
        corners = box_corners(rows, contact.size, contact.radius)
    for k, corner in enumerate(corners):
        end = f" at corner {k + 1}"
        _add_ball_on_plane(rows, contact, contact.on, frame.at(corner), frame, end)


def box_corners(rows: Rows, size: Vector, radius: Number, title: str = "") -> tuple[Vector, ...]:
    """Return the centres of the rounded corners of a box; in the plane they go round it."""
    half = tuple(0.5 * x - radius for x in size)
    for x in half:
        text = f"half of a length{title} less the radius must be > 0, got {{value:.6g}} m"
        rows.rule(x, ">", text)
    if len(half) == 2:
        x, y = half
        return (-1.0 * x, -1.0 * y), (x, -1.0 * y), half, (-1.0 * x, y)
    return tuple(product(*((-1.0 * x, x) for x in half)))


def _add_ball_on_plane(
    rows: Rows, contact: PlaneContact | CornersContact, carrier: str | None, centre: Combination,
    body: RigidFrame | None, end: str = "",
) -> None:  # fmt: skip
    """Keep a ball about a place of a body on one side of a plane that another one carries."""
    mechanism, frame = rows.mechanism, rows.parts.frame(carrier)
    normal = rows.unit(contact.axis)
    zero = (0.0,) * mechanism.dim
    link = centre - frame.place(contact.position or zero)
    upward, radius = frame.direction(normal), contact.radius
    height = mechanism.leaf(mechanism.component(link, upward))
    slips: list[Formula] = []
    if contact.friction is not None:
        ball = body if is_there(radius) else None
        for tangent in plane_tangents(mechanism, normal):
            along = frame.direction(tangent)
            speed = dot(contact.surface_velocity or zero, tangent)
            slide = mechanism.leaf(mechanism.component(link, along), LEAF_RATE)
            value, leaves = leaf_symbol(0) - speed, [slide]
            if ball is not None:
                pairs, size2 = dot_of_pairs(
                    mechanism, leaves, [(x, upward, along) for x in map(ball.direction, ball.axes)]
                )
                value = value - radius * pairs / size2
            slips.append(Formula(value, tuple(leaves)))
    gap = Formula(leaf_symbol(0) - radius, (height,))
    add_contact(rows, contact, gap, end=end, slips=slips)


def add_balls(rows: Rows, contact: SphereContact, _: JointParts) -> None:
    """Keep two balls apart."""
    first, second = contact.radii
    reach = first + second
    rows.rule(reach, ">", "the sum of the radii must be > 0 m")
    arms = (-1.0 * first, -1.0 * second)
    length = rows.mechanism.length(rows.parts.link(contact.points))
    gap = Formula(leaf_symbol(0) - reach, (rows.mechanism.leaf(length),))
    _add_between(rows, contact, contact.points, gap, reach, arms)


def add_clearance(rows: Rows, contact: ClearanceContact, _: JointParts) -> None:
    """Keep a pin in its hole."""
    pin, hole = contact.points
    arms = (-1.0 * (contact.radius + contact.pin_radius), contact.pin_radius)
    link, radius = rows.parts.link((hole, pin)), contact.radius
    square = rows.mechanism.component(link, link)
    gap = Formula(0.5 * (radius - leaf_symbol(0) / radius), (rows.mechanism.leaf(square),))
    _add_between(rows, contact, (hole, pin), gap, radius, arms)


def _add_between(
    rows: Rows, contact: SphereContact | ClearanceContact,
    ends: tuple[PointReference, PointReference], gap: Formula, reach: Number,
    arms: tuple[Number, Number],
) -> None:  # fmt: skip
    """Add a contact of circles, whose centres are `reach` apart where they touch.

    The arms are what the angular velocities of the first and second body add to the slip rate.
    """
    mechanism, parts = rows.mechanism, rows.parts
    link, axes = parts.link(ends), [parts.axis(k) for k in range(rows.mechanism.dim)]
    spinning = [
        (body, arm)
        for body, arm in zip([body_of(rows, end) for end in ends], arms, strict=True)
        if body is not None and is_there(arm)
    ]
    slips = []
    if contact.friction is not None and mechanism.dim == 2:
        leaves: list[Leaf] = []
        x, y = axes
        pairs, size2 = dot_of_pairs(mechanism, leaves, [(link, x, y), (link.turned(), x, y)])
        slip = reach * pairs / operate("max", size2, 0.25 * reach * reach)  # not where u vanishes
        for body, arm in spinning:
            spokes = [(d, x, y) for d in map(body.direction, body.axes)]
            pairs, size2 = dot_of_pairs(mechanism, leaves, spokes)
            slip = slip + arm * pairs / size2
        slips.append(Formula(slip, tuple(leaves)))
    elif contact.friction is not None:
        forms = [(link, axis) for axis in axes]
        u = [mechanism.leaf(mechanism.component(*form)) for form in forms]
        place = tuple(leaf_symbol(k) for k in range(3))
        length = sqrt(operate("max", dot(place, place), 0.25 * reach * reach))
        normal = tuple(x / length for x in place)

        def velocity(tangent: Vector) -> Formula:
            leaves = list(u)
            slip = reach / length * sliding(mechanism, leaves, forms, tangent)
            for body, arm in spinning:
                spokes = map(body.direction, body.axes)
                slip = slip + arm * turning(mechanism, leaves, spokes, axes, normal, tangent)
            return Formula(slip, tuple(leaves))

        slips = slips_along(tangents(mechanism, normal, SKEW), velocity)
    add_contact(rows, contact, gap, slips=slips)


def add_journal(rows: Rows, contact: JournalContact, _: JointParts) -> None:
    """Keep both ends of a journal in its bearing, and its middle between stops along the axis."""
    mechanism = rows.mechanism
    bearing, journal = (rows.parts.frame(name) for name in contact.bodies)
    axis = rows.unit(contact.axis)
    axes = [bearing.direction(x) for x in (*mechanism.normals(axis), axis)]
    centre, c = bearing.place(contact.position), contact.radius
    spokes = [journal.direction(x) for x in journal.axes]
    x, y = leaf_symbol(0), leaf_symbol(1)
    square = x * x + y * y
    out = sqrt(operate("max", square, 0.25 * c * c))  # not where the centres meet
    normal = (x / out, y / out, 0.0)
    around, along = (-1.0 * y / out, x / out, 0.0), (0.0, 0.0, 1.0)
    for half, end in ((-0.5, " at its first end"), (0.5, " at its second end")):
        place = journal.place(add(contact.position, scale(half * contact.length, axis)))
        forms = [(place - centre, a) for a in axes]
        u = [mechanism.leaf(mechanism.component(*form)) for form in forms[:2]]
        slips = []
        for tangent, stretch in ((around, c / out), (along, 1.0)):
            if contact.friction is None:
                break
            leaves = list(u)
            slip = stretch * sliding(mechanism, leaves, forms, tangent)
            if is_there(contact.pin_radius):
                spin = turning(mechanism, leaves, spokes, axes, normal, tangent)
                slip = slip + contact.pin_radius * spin
            slips.append(Formula(slip, tuple(leaves)))
        gap = Formula(0.5 * (c - square / c), tuple(u))
        add_contact(rows, contact, gap, end=end, slips=slips)
    if contact.axial_play is not None:
        middle = journal.place(contact.position) - centre
        s = mechanism.leaf(mechanism.component(middle, axes[2]))
        for sign in (1.0, -1.0):
            slips = []
            if contact.friction is not None and is_there(contact.collar_radius):
                slips.append(_slip_of_faces(rows, contact.collar_radius, spokes, axes))
            gap = Formula(contact.axial_play + sign * leaf_symbol(0), (s,))
            add_contact(rows, contact, gap, slips=slips)


def _slip_of_faces(
    rows: Rows, radius: Number, spokes: Sequence[Combination], axes: Sequence[Combination]
) -> Formula:
    """Return r w of a body with these axes about the normal of the first two of others."""
    leaves: list[Leaf] = []
    pairs = [(spoke, axes[0], axes[1]) for spoke in spokes]
    turning, size2 = dot_of_pairs(rows.mechanism, leaves, pairs)
    return Formula(radius * turning / size2, tuple(leaves))


def add_stop(rows: Rows, stop: Stop, _: JointParts) -> None:
    """Limit an angle, a displacement or a distance, at one or both ends."""
    mechanism, parts = rows.mechanism, rows.parts
    size = METRES
    if stop.points is not None:
        quantity: int | None = mechanism.length(parts.link(stop.points))
    else:
        assert stop.joint is not None
        joint = parts.joints[stop.joint]
        quantity = joint.angle if stop.turns else joint.displacement
        size = RADIANS if stop.turns else METRES
    assert quantity is not None
    leaf = mechanism.leaf(quantity)
    slips = []
    if stop.friction is not None:
        held: Any = parts.scene.joints[stop.joint or ""]
        A, B = map(parts.frame, held.bodies)
        axes = [A.direction(x) for x in mechanism.normals(unit(held.axis))]
        slips.append(_slip_of_faces(rows, stop.radius, [*map(B.direction, B.axes)], axes))
    if stop.min is not None and stop.max is not None:
        rows.rule(stop.max - stop.min, ">", "max - min must be > 0")
    if stop.min is not None:
        add_contact(rows, stop, Formula(leaf_symbol(0) - stop.min, (leaf,)), size, " at min", slips)
    if stop.max is not None and stop.points is not None:
        text = (
            f"max, a distance, must be > {LEAST_DISTANCE:g} m, got {{value!r}} m: the direction of "
            "a shorter one is round-off; a revolute or spherical joint lets points coincide"
        )
        rows.rule(stop.max, ">", text, LEAST_DISTANCE)
    if stop.max is not None:
        add_contact(rows, stop, Formula(stop.max - leaf_symbol(0), (leaf,)), size, " at max", slips)


def add_contact(
    rows: Rows, contact: Touching, gap: Formula, size: Scale = METRES, end: str = "",
    slips: list[Formula] | None = None,
) -> None:  # fmt: skip
    """Add the rows of a gap and of its slip rates, with what must hold of their numbers.

    A part may have several gaps, such as a stop its two ends, told apart by `end`.
    """
    mechanism = rows.mechanism
    if isinstance(contact, ContactPart) and contact.law != "rigid":
        _add_compliant(rows, contact, gap, end)
        return
    if rows.name not in rows.parts.contacts:
        rows.rule(1.0 - contact.restitution, ">=", "1 - restitution must be >= 0")
    _demand_free(rows, contact, gap, "rad" if size is RADIANS else "m", end)
    kind = "turned" if size is RADIANS else "off"
    row = rows.function(gap, size, kind)
    friction = -1
    if slips:
        assert isinstance(contact, RubbingContact)
        assert contact.friction is not None
        sliding, words = contact.friction, "static_friction - friction"
        static = rows.static(sliding, contact.static_friction, words)
        slip_rows = tuple(rows.velocity(slip, METRES)[1] for slip in slips)
        friction = len(mechanism.frictions)
        smooth = 0.0 if contact.smooth_speed is None else contact.smooth_speed
        found = Friction(slip_rows, ((row,),), sliding, static, smooth_speed=smooth)
        mechanism.frictions.append(found)
    rows.parts.contacts.setdefault(rows.name, []).append(len(mechanism.contacts))
    mechanism.contacts.append(Contact(row[1], contact.restitution, friction))


def _add_compliant(rows: Rows, contact: ContactPart, gap: Formula, end: str) -> None:
    """Add a potential K depth^(n+1)/(n+1), damped by c times the rate of its depth.

    Of Lankarani and Nikravesh c = 3 (1 - e^2)/(4 v), for an impact at the speed v.
    """
    assert contact.stiffness is not None
    power = contact.exponent + 1.0
    rows.rule(contact.exponent - 1.0, ">=", "exponent - 1 must be >= 0")
    opening = gap.value
    if isinstance(contact, ClearanceContact):  # smooth where the centres meet
        radius = contact.radius
        opening = radius - sqrt(operate("max", leaf_symbol(0), radius * radius))
    depth = operate("max", -1.0 * opening, 0.0)
    damping = contact.damping
    if contact.law == "lankarani-nikravesh":
        assert contact.impact_speed is not None
        rows.rule(1.0 - contact.restitution, ">=", "1 - restitution must be >= 0")
        loss = 1.0 - contact.restitution * contact.restitution
        damping = 0.75 * loss / contact.impact_speed
    (leaf,) = gap.leaves
    energy = contact.stiffness / power * depth**power
    rows.mechanism.potentials.append(Formula(energy, gap.leaves, damping))
    if isinstance(contact, ClearanceContact):
        opening = contact.radius - sqrt(leaf_symbol(0))
    force = contact.stiffness * depth**contact.exponent
    found = CompliantContact(leaf.index, opening, depth, force, damping or 0.0)
    rows.parts.compliant.setdefault(rows.name, []).append(found)
    add_kinks_of_contact(rows, found, end)


def distance_left(gap: Number, clearance: Number) -> Number:
    """Return the distance left in a clearance, c - |u|, from its gap (c^2 - |u|^2)/2c."""
    return 2.0 * gap / (1.0 + sqrt(operate("max", 1.0 - 2.0 * gap / clearance, 0.0)))


def _demand_free(rows: Rows, contact: Touching, gap: Formula, unit: str, end: str) -> None:
    """Demand that a gap is drawn open, or closed up to rounding."""
    mechanism = rows.mechanism
    text = f"it is drawn in penetration{end}: its gap is {{value:.6g}} {unit}; draw it open"
    if isinstance(contact, PlaneContact | CornersContact):
        text += ", or turn its axis to the other side"
    value = as_drawn(mechanism, gap.value, gap.leaves)
    if isinstance(contact, ClearanceContact):
        value = contact.radius - sqrt(mechanism.drawn_value(gap.leaves[0].index))
    rows.rule(value, "drawn", text, bound=-mechanism.drawn_into(unit))


def as_drawn(mechanism: Mechanism, value: Number, leaves: Sequence[Leaf]) -> Number:
    """Return a number over leaves for what these are as drawn."""
    drawn = {leaf_symbol(k): mechanism.drawn_value(leaf.index) for k, leaf in enumerate(leaves)}
    return with_symbols(value, drawn)


CONTACTS = {
    PlaneContact: add_plane, CornersContact: add_corners, SphereContact: add_balls,
    ClearanceContact: add_clearance, JournalContact: add_journal, Stop: add_stop,
}  # fmt: skip
