"""Contacts of bodies with shapes: capsules, polygons, boxes, and cylinders on planes.

A shape is the hull of some corners with all that lies within a radius of it. A corner c of one is
as far from the other as its signed distance D to the hull of that, less both radii R,

segment   D = |x|,  x = c - p - s u,  s = max(0, min(1, (c - p) . u/u^2))
polygon   m = max d_k, the largest distance to the line of an edge;  D = m + min |x_k| - |m|
box       m = max q_k, q_k = |c_k| - a_k/2;  D = sqrt(sum max(q_k, 0)^2) + min(m, 0)

and for R = 0, where D has kinks, m, which is 0 on the same surface. In the plane, corners both ways
see all; in space capsules also cross each other and edges of boxes, at s and t of p + s u, o + t v,

crossing  g = sqrt(|p + s u - o - t v|^2 + more) - R

Two corners that touch each other would be two equal gaps: of the shape named first the distance
grows faster beyond its faces or ends, by `more`, so that one gap is open, and has no jump of slope
where they change over. A cylinder touches a plane with the lowest places of its rims,

cylinder  g = (c - p) . n - R |n x a|,        s = d/dt (c - p) . t - R (w x e) . t

with the centre c of a rim, the axis a, and e the direction of steepest ascent in the plane of it.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise, product
from typing import NamedTuple

from solver.mechanics.combination import Combination
from solver.mechanics.contacts import SKEW, add_contact, box_corners
from solver.mechanics.derivative import derivative
from solver.mechanics.formulas import leaf_symbol
from solver.mechanics.frames import Ground, RigidFrame
from solver.mechanics.mechanism import Formula
from solver.mechanics.parts import JointParts
from solver.mechanics.rows import Rows
from solver.mechanics.slips import dot_of_pairs, is_there, plane_tangents
from solver.mechanics.surfaces import slip_rates
from solver.mechanics.vectors import (
    Vector,
    add,
    cross,
    dot,
    norm,
    perpendicular,
    scale,
    subtract,
    turned,
    unit,
)
from solver.runtime.layout import LEAF_RATE
from solver.scene import (
    BoxContact,
    CapsuleContact,
    CylinderContact,
    Number,
    PairContact,
    PolygonContact,
)
from solver.scene.expression import operate, sqrt

PARALLEL = 1e-12
"""Square of the sine below which capsules do not cross: their ends touch, at 1e-13 of the size."""
EDGES = [(i, i + k) for k in (4, 2, 1) for i in range(8) if not i & k]
"""Corners of a box in space, by their numbers, at the ends of its edges."""
MARGIN = 1e-4
"""Share of its length before an end of a face from which its distance grows faster: a corner that
is there is seen by the other shape, whose own is 1e-9 farther off at most."""
FLAT = 1e-10
"""Sine of the tilt that rounds off where a rim lies on a plane as a whole and has no lowest place;
a cylinder is drawn with more than 1e4 of it."""
Distance = Callable[[Vector, bool], Number]
"""Of a place in body axes to a hull; of places beyond its faces or ends larger, if asked for."""


class Shape(NamedTuple):
    """Hull of corners of a body, in its axes, with all within a radius."""

    frame: Ground | RigidFrame
    title: str
    corners: tuple[Vector, ...]
    radius: Number
    distance: Distance

    @property
    def up(self) -> Vector:
        """Normal whose tangents the others turn from; of a box no face points against it."""
        return SKEW if len(self.corners) == 8 else ()

    def place(self, corner: Vector) -> Combination:
        """Return where a corner is."""
        frame = self.frame
        return frame.place(corner) if isinstance(frame, Ground) else frame.at(corner)

    @property
    def ball(self) -> Ground | RigidFrame | None:
        """What turns about the corners; None where the radius is no arm."""
        return self.frame if is_there(self.radius) else None


# ---------------------------------------------------------------------------------------- hulls


def _larger(x: Number, y: Number) -> Number:
    return operate("max", x, y)


def _smaller(x: Number, y: Number) -> Number:
    return operate("min", x, y)


def _within(x: Number, low: float, high: float) -> Number:
    return _larger(_smaller(x, high), low)


def _beyond(share: Number) -> Number:
    """Return the square of how far a share of a length lies out of it, or nearly."""
    out = share - _within(share, MARGIN, 1.0 - MARGIN)
    return out * out


def _place(corner: Vector) -> Distance:
    return lambda x, _: norm(subtract(x, corner))


def _segment(first: Vector, second: Vector) -> Distance:
    u = subtract(second, first)
    length2 = dot(u, u)

    def distance(x: Vector, grows: bool) -> Number:
        link = subtract(x, first)
        share = dot(link, u) / length2
        across = subtract(link, scale(_within(share, 0.0, 1.0), u))
        more = length2 * _beyond(share) if grows else 0.0
        return sqrt(dot(across, across) + more)

    return distance


def _polygon(rows: Rows, corners: tuple[Vector, ...], rounded: bool, end: str) -> Distance:
    """Return the distance to a convex polygon, whose corners go round it either way."""
    default = rows.mechanism.default
    edges = list(zip(corners, (*corners[1:], corners[0]), strict=True))
    area = sum(default(a[0] * b[1] - a[1] * b[0]) for a, b in edges)
    faces = []
    for k, (one, two) in enumerate(edges):
        along = subtract(two, one)
        length = norm(along)
        rows.rule(length, ">", f"two corners of the polygon{end} coincide: length {{value:.6g}} m")
        outward = scale((-1.0 if area > 0.0 else 1.0) / length, turned(along))
        faces.append((one, outward))
        for other in set(range(len(corners))) - {k, (k + 1) % len(corners)}:
            depth = -1.0 * dot(subtract(corners[other], one), outward)
            text = f"the polygon{end} is not convex, or its corners are not in turn: corner "
            text += f"{other + 1} is {{value:.6g}} m within edge {k + 1}, which must be > 0"
            rows.rule(depth, ">", text)
    segments = [_segment(*edge) for edge in edges]

    def distance(x: Vector, grows: bool) -> Number:
        depth, *others = (dot(subtract(x, one), outward) for one, outward in faces)
        for other in others:
            depth = _larger(depth, other)
        if not rounded:
            return depth
        nearest, *others = (segment(x, grows) for segment in segments)
        for other in others:
            nearest = _smaller(nearest, other)
        return depth + nearest - operate("abs", depth)

    return distance


def _box(half: Vector, rounded: bool) -> Distance:
    def distance(x: Vector, grows: bool) -> Number:
        heights = [operate("abs", y) - a for y, a in zip(x, half, strict=True)]
        highest = _larger(_larger(heights[0], heights[1]), heights[2])
        if not rounded:
            return highest
        beyond = [_larger(height, 0.0) for height in heights]
        if grows:
            least = _smaller(_smaller(heights[0], heights[1]), heights[2])
            beyond.append(_larger(least + MARGIN * norm(half), 0.0))
        return sqrt(_larger(dot(beyond, beyond), 1e-300)) + _smaller(highest, 0.0)

    return distance


# ---------------------------------------------------------------------------------------- pairs


def add_capsules(rows: Rows, contact: CapsuleContact, _: JointParts) -> None:
    """Keep two capsules, or a capsule and a ball, apart."""
    _add_pair(rows, contact, _hulls(rows, contact, contact.segments))


def add_polygons(rows: Rows, contact: PolygonContact, _: JointParts) -> None:
    """Keep two convex polygons apart."""
    _add_pair(rows, contact, _hulls(rows, contact, contact.corners))


def add_boxes(rows: Rows, contact: BoxContact, _: JointParts) -> None:
    """Keep two boxes apart, as far as corners see them, or a box and a capsule."""
    first, *others = (
        box_corners(rows, size, radius, title)
        for size, radius, title in zip(contact.sizes, contact.radii, _titles(contact), strict=False)
    )
    second = contact.segment or others[0]
    _add_pair(rows, contact, _hulls(rows, contact, (first, second)))


def _titles(contact: PairContact) -> list[str]:
    return [f" of '{name}'" if name else " of the ground" for name in contact.bodies]


def _hulls(
    rows: Rows, contact: PairContact, corners: tuple[tuple[Vector, ...], tuple[Vector, ...]]
) -> list[Shape]:
    first, second = contact.radii
    rounded = is_there(first) or is_there(second)
    if rounded:
        rows.rule(first + second, ">", "the sum of the radii must be > 0 m")
    shapes = []
    for name, title, places, radius in zip(
        contact.bodies, _titles(contact), corners, contact.radii, strict=True
    ):
        if len(places) == 1:
            distance = _place(places[0])
        elif len(places) == 2:
            distance = _segment(*places)
        elif rows.mechanism.dim == 2:
            distance = _polygon(rows, places, rounded, title)
        else:
            distance = _box(places[-1], rounded)
        frame = rows.parts.frame(name)
        assert isinstance(frame, Ground | RigidFrame)
        shapes.append(Shape(frame, title, places, radius, distance))
    return shapes


def _add_pair(rows: Rows, contact: PairContact, shapes: list[Shape]) -> None:
    """Keep two shapes apart: corners both ways, and the crossing of two capsules in space."""
    first, second = sorted(shapes, key=lambda shape: len(shape.corners) > 1)  # a ball is the first
    if rows.mechanism.dim == 3 and len(second.corners) == 2 <= len(first.corners):
        if len(first.corners) == 2:
            _add_sticks(rows, contact, first, second)
        else:
            _add_stick_on_box(rows, contact, second, first)
            _demand_apart(rows, first, second)
        return
    for k in range(len(first.corners)):
        _add_corner(rows, contact, first, k, second, grows=False)
    if len(first.corners) == 1:
        return
    for k in range(len(second.corners)):
        _add_corner(rows, contact, second, k, first, grows=True)
    _demand_apart(rows, first, second)


def _demand_apart(rows: Rows, first: Shape, second: Shape) -> None:
    """Demand that hulls are drawn apart: they may overlap with no corner of one in the other.

    Else each direction, of the normals of faces and of the products of edges, has them overlap.
    """
    mechanism, number = rows.mechanism, rows.mechanism.default
    both = [
        [tuple(map(number, mechanism.drawn(shape.place(x)))) for x in shape.corners]
        for shape in (first, second)
    ]
    if mechanism.dim == 2:
        pairs = [pair for x in both for pair in pairwise((*x, x[0]))]
        axes = [turned(unit(subtract(b, a))) for a, b in pairs if a != b]
    else:
        edges = [[unit(subtract(x[k], x[0])) for k in (1, 2, 4) if k < len(x)] for x in both]
        axes = [axis for x in edges if len(x) > 1 for axis in x]
        axes += [cross(a, b) for a, b in product(*edges)]
    overlap = mechanism.extent
    for axis in axes:
        if number(norm(axis)) > 1e-6:
            one, two = ([number(dot(x, unit(axis))) for x in places] for places in both)
            overlap = min(overlap, max(one) - min(two), max(two) - min(one))
    if overlap > mechanism.drawn_into("m"):
        text = f"it is drawn in penetration: the bodies overlap by {overlap:.6g} m"
        rows.problem(f"{text}; draw them apart")


def _add_corner(
    rows: Rows, contact: PairContact, of: Shape, k: int, other: Shape, *, grows: bool
) -> None:
    mechanism = rows.mechanism
    forms = other.frame.coordinates(of.place(of.corners[k]))
    leaves = tuple(mechanism.leaf(mechanism.component(*form)) for form in forms)
    x = tuple(leaf_symbol(i) for i in range(len(leaves)))
    gap = Formula(other.distance(x, grows) - (of.radius + other.radius), leaves)
    slips = []
    if contact.friction is not None:
        distance = other.distance(x, False)  # its gradient has size 1 everywhere
        normal = tuple(derivative(distance, str(leaf)) for leaf in x)
        slips = slip_rates(
            rows, contact, of.ball, leaves, normal, [forms], of.radius, up=other.up
        )  # fmt: skip
    add_contact(rows, contact, gap, end=f" at corner {k + 1}{of.title}", slips=slips)


class _Stick:
    """Segment p + s u of a capsule in space, in axes of the other body, that measures all slips.

    The contacts of a line of contact then roll alike, over any step.
    """

    def __init__(self, rows: Rows, contact: PairContact, stick: Shape, other: Shape) -> None:
        mechanism = rows.mechanism
        self.rows, self.contact, self.stick, self.other = rows, contact, stick, other
        self.places = [other.frame.coordinates(stick.place(end)) for end in stick.corners]
        self.leaves = tuple(
            mechanism.leaf(mechanism.component(*form)) for x in self.places for form in x
        )
        self.p, end = (tuple(leaf_symbol(3 * i + k) for k in range(3)) for i in range(2))
        self.u = subtract(end, self.p)

    def add_gap(
        self, s: Number, o: Vector, t: Number, v: Vector, more: Number, where: str
    ) -> None:  # fmt: skip
        """Keep p + s u and o + t v apart."""
        link = subtract(add(subtract(self.p, o), scale(s, self.u)), scale(t, v))
        square, slips = dot(link, link), []
        if self.contact.friction is not None:
            normal, shares = scale(1.0 / sqrt(square), link), (1.0 - s, s)
            slips = slip_rates(
                self.rows, self.contact, self.stick.ball, self.leaves, normal, self.places,
                self.stick.radius, shares, self.other.up,
            )  # fmt: skip
        reach = self.stick.radius + self.other.radius
        gap = Formula(sqrt(square + more) - reach, self.leaves)
        add_contact(self.rows, self.contact, gap, end=where, slips=slips)

    def add_corner(self, o: Vector, t: float, v: Vector, where: str) -> None:
        """Keep it off the corner o + t v; beyond its ends, which see the other one, farther."""
        uu = dot(self.u, self.u)
        free = (t * dot(self.u, v) - dot(self.u, subtract(self.p, o))) / uu
        self.add_gap(_within(free, 0.0, 1.0), o, t, v, uu * _beyond(free), where)

    def add_crossing(self, o: Vector, v: Vector, where: str) -> None:
        """Keep it off an edge, where the lines are nearest to each other between their ends."""
        u, w = self.u, subtract(self.p, o)
        uu, uv, vv, uw, vw = dot(u, u), dot(u, v), dot(v, v), dot(u, w), dot(v, w)
        both = cross(u, v)
        sine2 = dot(both, both)
        bound = _larger(sine2, PARALLEL * uu * vv)
        s_free, t_free = (uv * vw - vv * uw) / bound, (uu * vw - uv * uw) / bound
        s, t = _within(s_free, 0.0, 1.0), _within(t_free, 0.0, 1.0)
        beyond = [_within(s_free - s, -1.0, 1.0), _within(t_free - t, -1.0, 1.0)]
        more = uu * (beyond[0] * beyond[0] + 1.0 - sine2 / bound) + vv * beyond[1] * beyond[1]
        self.add_gap(s, o, t, v, more, where)


def _add_sticks(rows: Rows, contact: PairContact, first: Shape, second: Shape) -> None:
    """Keep two capsules in space apart: ends of each from the other, and where they cross."""
    stick = _Stick(rows, contact, first, second)
    o, v = second.corners[0], subtract(second.corners[1], second.corners[0])
    vv, uv, vw = dot(v, v), dot(stick.u, v), dot(v, subtract(stick.p, o))
    for s in (0.0, 1.0):
        t = _within((vw + s * uv) / vv, 0.0, 1.0)
        stick.add_gap(s, o, t, v, 0.0, f" at corner {1 + int(s)}{first.title}")
    for t in (0.0, 1.0):
        stick.add_corner(o, t, v, f" at corner {1 + int(t)}{second.title}")
    stick.add_crossing(o, v, " where they cross")


def _add_stick_on_box(rows: Rows, contact: PairContact, first: Shape, box: Shape) -> None:
    """Keep a capsule off a box: its ends, the corners, and the edges that cross it."""
    for k in range(2):
        _add_corner(rows, contact, first, k, box, grows=False)
    stick = _Stick(rows, contact, first, box)
    for k, corner in enumerate(box.corners):
        stick.add_corner(corner, 0.0, (0.0,) * 3, f" at corner {k + 1}{box.title}")
    for i, k in EDGES:
        along = subtract(box.corners[k], box.corners[i])
        where = f" at the edge from corner {i + 1} to {k + 1}{box.title}"
        stick.add_crossing(box.corners[i], along, where)


# -------------------------------------------------------------------------------------- cylinders


def add_cylinder(rows: Rows, contact: CylinderContact, _: JointParts) -> None:
    """Keep the rims of a cylinder on one side of a plane."""
    mechanism, carrier = rows.mechanism, rows.parts.frame(contact.on)
    body = rows.parts.frames[contact.body]
    assert isinstance(body, RigidFrame)
    normal = rows.unit(contact.axis)
    along = rows.unit(contact.along, "along must not be of length zero")
    upward = carrier.direction(normal)
    axis, spokes = body.along(along), [*map(body.along, perpendicular(along, mechanism.default))]
    tilts = [mechanism.leaf(mechanism.component(spoke, upward)) for spoke in spokes]
    tilt = norm([mechanism.drawn_value(leaf.index) for leaf in tilts])
    text = (
        "its end is drawn flat on the plane: the sine of its tilt is {value!r}; tilt it, or write "
    )
    text += 'type = "corners" with three places of the rim'
    rows.rule(tilt, ">", text, bound=1e4 * FLAT)
    for sign in (-1.0, 1.0) if is_there(contact.length) else (0.0,):
        centre = body.at(scale(sign * 0.5 * contact.length, along) if sign else (0.0,) * 3)
        link = centre - carrier.place(contact.position or (0.0,) * 3)
        x, y = leaf_symbol(1), leaf_symbol(2)
        sine = sqrt(x * x + y * y + FLAT * FLAT)
        leaves = (mechanism.leaf(mechanism.component(link, upward)), *tilts)
        gap = Formula(leaf_symbol(0) - contact.radius * sine, leaves)
        slips = []
        for tangent in plane_tangents(mechanism, normal) if contact.friction is not None else ():
            across = carrier.direction(tangent)
            used = [
                mechanism.leaf(mechanism.component(link, across), LEAF_RATE),
                mechanism.leaf(mechanism.component(axis, upward)),
            ]
            cosine = leaf_symbol(1)
            pairs = [(spoke, upward, across) for spoke in spokes]
            turning, size2 = dot_of_pairs(mechanism, used, pairs)
            arm = contact.radius * sqrt(_larger(1.0 - cosine * cosine, 0.0))
            speed = dot(contact.surface_velocity or (0.0,) * 3, tangent)
            slip = leaf_symbol(0) - speed - arm * turning / (size2 + FLAT * FLAT)
            slips.append(Formula(slip, tuple(used)))
        end = {-1.0: " at its first rim", 1.0: " at its second rim"}.get(sign, "")
        add_contact(rows, contact, gap, end=end, slips=slips)


SHAPES = {
    CapsuleContact: add_capsules, PolygonContact: add_polygons, BoxContact: add_boxes,
    CylinderContact: add_cylinder,
}  # fmt: skip
