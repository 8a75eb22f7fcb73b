"""Contacts of bodies with shapes: capsules, polygons, boxes, polyhedra, and cylinders on planes.

A corner of one shape is as far from the other as its distance D to the hull of that
(``solver.mechanics.hulls``), less both radii. In the plane, corners both ways see all; in space
segments and edges also cross each other (``solver.mechanics.crossings``).

Two corners that touch each other would be two equal gaps: of the shape named first the distance
grows faster beyond its faces or ends, so that one gap is open, and has no jump of slope where they
change over. A cylinder touches a plane with the lowest places of its rims,

cylinder  g = (c - p) . n - R |n x a|,        s = d/dt (c - p) . t - R (w x e) . t

with the centre c of a rim, the axis a, and e the direction of steepest ascent in the plane of it.
"""

from __future__ import annotations

from itertools import pairwise, product

from solver.mechanics.contacts import add_contact, box_corners
from solver.mechanics.convex_parts import NotConvexError, Piece, convex_pieces, free_direction
from solver.mechanics.crossings import Stick, add_crossings
from solver.mechanics.derivative import derivative
from solver.mechanics.formulas import leaf_symbol
from solver.mechanics.frames import Ground, RigidFrame
from solver.mechanics.hulls import (
    BOX_EDGES,
    UP_OF_A_BOX,
    Shape,
    box,
    box_planes,
    larger,
    place,
    polygon,
    polyhedron,
    segment,
    within,
)
from solver.mechanics.mechanism import Formula
from solver.mechanics.parts import JointParts
from solver.mechanics.rows import Rows
from solver.mechanics.slips import dot_of_pairs, is_there, plane_tangents
from solver.mechanics.surfaces import slip_rates
from solver.mechanics.vectors import (
    Vector,
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
    ConvexContact,
    CylinderContact,
    Number,
    PairContact,
    PolygonContact,
    RoundedContact,
)
from solver.scene.expression import sqrt

FLAT = 1e-10
"""Sine of the tilt that rounds off where a rim lies on a plane as a whole and has no lowest place;
a cylinder is drawn with more than 1e4 of it."""
FLUSH = 1e-8
"""Of the size of the mechanism: how far a sharp corner beside a face is in line with it."""
MOST_GAPS = 2000
"""Of two bodies with convex parts."""


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


def add_convex(rows: Rows, contact: ConvexContact, _: JointParts) -> None:
    """Keep each convex part of one body off each of the other."""
    both: list[list[Shape]] = []
    for body, title, file, field in zip(
        contact.bodies, _titles(contact), (contact.file, contact.other_file),
        ("file", "other_file"), strict=True,
    ):  # fmt: skip
        frame = _frame(rows, body)
        if file is None:
            assert contact.size is not None
            corners = box_corners(rows, contact.size, 0.0)
            both.append([_box_in_space(frame, title, corners, 0.0, False)])
            continue
        try:
            pieces = convex_pieces(file, contact.scale)
        except NotConvexError as problem:
            help = "split it into convex pieces that do not share corners, all in one file, or "
            help += 'write a contact for the file of each; points touch what is hollow: "mesh"'
            rows.problem(f"{problem}; {help}", f".{field}")
            return
        names = [
            f" of part {k}{title}" if len(pieces) > 1 else title for k in range(1, len(pieces) + 1)
        ]
        both.append([_polyhedron(frame, x, piece) for x, piece in zip(names, pieces, strict=True)])
    pairs = list(product(*both))
    gaps = sum(len(a.corners) + len(b.corners) + len(a.edges) * len(b.edges) for a, b in pairs)
    if gaps > MOST_GAPS:
        text = f"its corners and edges make {gaps} gaps, more than {MOST_GAPS}: the bodies have "
        text += " and ".join(str(sum(len(shape.edges) for shape in shapes)) for shapes in both)
        rows.problem(f"{text} edges; simplify them, or leave out pieces that cannot touch", ".file")
        return
    for first, second in pairs:
        _add_pair(rows, contact, [first, second])


def _polyhedron(frame: Ground | RigidFrame, title: str, piece: Piece) -> Shape:
    up = free_direction(piece.planes)
    distance = polyhedron(piece.planes)
    return Shape(frame, title, piece.corners, 0.0, distance, piece.planes, piece.edges, up)


def _titles(contact: PairContact) -> list[str]:
    return [f" of '{name}'" if name else " of the ground" for name in contact.bodies]


def _hulls(
    rows: Rows, contact: RoundedContact, corners: tuple[tuple[Vector, ...], tuple[Vector, ...]]
) -> list[Shape]:
    first, second = contact.radii
    rounded = is_there(first) or is_there(second)
    if rounded:
        rows.rule(first + second, ">", "the sum of the radii must be > 0 m")
    shapes = []
    for name, title, places, radius in zip(
        contact.bodies, _titles(contact), corners, contact.radii, strict=True
    ):
        frame = _frame(rows, name)
        if len(places) == 1:
            shapes.append(Shape(frame, title, places, radius, place(places[0])))
        elif len(places) == 2:
            shapes.append(Shape(frame, title, places, radius, segment(*places)))
        elif rows.mechanism.dim == 2:
            distance = polygon(rows, places, rounded, title)
            shapes.append(Shape(frame, title, places, radius, distance))
        else:
            shapes.append(_box_in_space(frame, title, places, radius, rounded))
    return shapes


def _frame(rows: Rows, name: str | None) -> Ground | RigidFrame:
    frame = rows.parts.frame(name)
    assert isinstance(frame, Ground | RigidFrame)
    return frame


def _box_in_space(
    frame: Ground | RigidFrame, title: str, corners: tuple[Vector, ...], radius: Number,
    rounded: bool,
) -> Shape:  # fmt: skip
    half = corners[-1]
    return Shape(
        frame, title, corners, radius, box(half, rounded), box_planes(half), BOX_EDGES, UP_OF_A_BOX
    )


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
    add_crossings(rows, contact, first, second)
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
        axes = [_drawn_normal(rows, shape, x) for shape in (first, second) for x, _ in shape.planes]
        edges = [
            [unit(subtract(x[i], x[k])) for i, k, *_ in shape.edges or ((0, 1, 0, 0),)]
            for x, shape in zip(both, (first, second), strict=True)
        ]
        axes += [cross(a, b) for a, b in product(*edges)]
    if (
        first.planes
        and second.planes
        and not is_there(first.radius)
        and not is_there(second.radius)
    ):
        _note_flush(rows, first, second, both)
    overlap = mechanism.extent
    for axis in axes:
        if number(norm(axis)) > 1e-6:
            one, two = ([number(dot(x, unit(axis))) for x in places] for places in both)
            overlap = min(overlap, max(one) - min(two), max(two) - min(one))
    if overlap > mechanism.drawn_into("m"):
        text = f"it is drawn in penetration: the bodies overlap by {overlap:.6g} m"
        rows.problem(f"{text}; draw them apart")


def _note_flush(
    rows: Rows, first: Shape, second: Shape, places: list[list[tuple[float, ...]]]
) -> None:  # fmt: skip
    """Note sharp corners in line with faces: on an edge nothing decides which face they touch."""
    near, number = FLUSH * rows.mechanism.extent, rows.mechanism.default
    for of, other, corners, others in (
        (first, second, places[0], places[1]), (second, first, places[1], places[0]),
    ):  # fmt: skip
        normals = [_drawn_normal(rows, other, normal) for normal, _ in other.planes]
        tops = [max(number(dot(normal, x)) for x in others) for normal in normals]
        heights = [
            [number(dot(n, x)) - top for n, top in zip(normals, tops, strict=True)] for x in corners
        ]
        beside = [min(column) < -near for column in zip(*heights, strict=True)]  # not on the face
        in_line = [
            sorted(row)[-2] <= near
            and any(abs(x) <= near and is_so for x, is_so in zip(row, beside, strict=True))
            for row in heights
        ]
        if any(in_line):
            text = f"{{value:g}} corners{of.title} are drawn in line with faces{other.title}: on "
            text += "an edge nothing decides which face a sharp corner touches, and it may pass; "
            text += "make one body smaller, or boxes round with radii = [...]"
            rows.rule(float(sum(in_line)), "noted", text)
            return


def _drawn_normal(rows: Rows, shape: Shape, normal: Vector) -> Vector:
    """Return a direction in axes of a body, as it is drawn."""
    rows_of_axes = zip(*shape.frame.axes, strict=True)
    return tuple(rows.mechanism.default(dot(row, normal)) for row in rows_of_axes)


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


def _add_sticks(rows: Rows, contact: PairContact, first: Shape, second: Shape) -> None:
    """Keep two capsules in space apart: ends of each from the other, and where they cross."""
    stick = Stick(rows, contact, first, second)
    o, v = second.corners[0], subtract(second.corners[1], second.corners[0])
    vv, uv, vw = dot(v, v), dot(stick.u, v), dot(v, subtract(stick.p, o))
    for s in (0.0, 1.0):
        t = within((vw + s * uv) / vv, 0.0, 1.0)
        stick.add_gap(s, o, t, v, 0.0, f" at corner {1 + int(s)}{first.title}")
    for t in (0.0, 1.0):
        stick.add_corner(o, t, v, f" at corner {1 + int(t)}{second.title}")
    stick.add_crossing(o, v, " where they cross")


def _add_stick_on_box(rows: Rows, contact: PairContact, first: Shape, box: Shape) -> None:
    """Keep a capsule off a box: its ends, the corners, and the edges that cross it."""
    for k in range(2):
        _add_corner(rows, contact, first, k, box, grows=False)
    stick = Stick(rows, contact, first, box)
    for k, corner in enumerate(box.corners):
        stick.add_corner(corner, 0.0, (0.0,) * 3, f" at corner {k + 1}{box.title}")
    for i, k, *_ in BOX_EDGES:
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
            arm = contact.radius * sqrt(larger(1.0 - cosine * cosine, 0.0))
            speed = dot(contact.surface_velocity or (0.0,) * 3, tangent)
            slip = leaf_symbol(0) - speed - arm * turning / (size2 + FLAT * FLAT)
            slips.append(Formula(slip, tuple(used)))
        end = {-1.0: " at its first rim", 1.0: " at its second rim"}.get(sign, "")
        add_contact(rows, contact, gap, end=end, slips=slips)


SHAPES = {
    CapsuleContact: add_capsules, PolygonContact: add_polygons, BoxContact: add_boxes,
    ConvexContact: add_convex, CylinderContact: add_cylinder,
}  # fmt: skip
