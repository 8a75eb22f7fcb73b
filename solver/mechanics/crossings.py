"""Segments in space against segments, corners and edges: where p + s u and o + t v touch.

round    g = sqrt(|p + s u - o - t v|^2 + more) - R,    s and t of the nearest places
sharp    g = max(h, 2 m - h)/|l_a a + l_b b| + more,    h = l_a d_a + l_b d_b,
         l_a + l_b = 1,   l_a u . a + l_b u . b = 0,    d_a = d_b at s

with the normals a, b of the faces that meet at a sharp edge and the distances d of p to them: h is
that of p + s u to both, h/|..| that of the lines, and m the largest to other faces. At its ends a
segment is as far as its end and `more` farther, so that no gap has a jump of slope there; farther
are lines that are parallel, too, and where l_a or l_b is < 0 and both faces cannot carry it. No
gap is negative while the bodies do not overlap, since p + s u is a place of one of them, and none
is zero but that of what touches.
"""

from __future__ import annotations

from itertools import product

from solver.mechanics.contacts import add_contact
from solver.mechanics.formulas import leaf_symbol
from solver.mechanics.hulls import MARGIN, Edge, Shape, beyond_ends, larger, largest, within
from solver.mechanics.mechanism import Formula
from solver.mechanics.rows import Rows
from solver.mechanics.slips import is_there
from solver.mechanics.surfaces import slip_rates
from solver.mechanics.vectors import Vector, add, cross, dot, norm, scale, subtract
from solver.scene import Number, PairContact
from solver.scene.expression import sqrt

PARALLEL = 1e-12
"""Square of the sine below which lines do not cross: their ends touch, at 1e-13 of the size."""


class Stick:
    """Segment p + s u of a shape in space, in axes of the other body, that measures all slips.

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

    def _add(self, gap: Number, s: Number, normal: Vector, where: str) -> None:
        slips = []
        if self.contact.friction is not None:
            slips = slip_rates(
                self.rows, self.contact, self.stick.ball, self.leaves, normal, self.places,
                self.stick.radius, (1.0 - s, s), self.other.up,
            )  # fmt: skip
        add_contact(self.rows, self.contact, Formula(gap, self.leaves), end=where, slips=slips)

    def add_gap(
        self, s: Number, o: Vector, t: Number, v: Vector, more: Number, where: str
    ) -> None:  # fmt: skip
        """Keep p + s u and o + t v apart."""
        link = subtract(add(subtract(self.p, o), scale(s, self.u)), scale(t, v))
        square = dot(link, link)
        reach = self.stick.radius + self.other.radius
        self._add(sqrt(square + more) - reach, s, scale(1.0 / sqrt(square), link), where)

    def add_corner(self, o: Vector, t: float, v: Vector, where: str) -> None:
        """Keep it off the corner o + t v; beyond its ends, which see the other one, farther."""
        uu = dot(self.u, self.u)
        free = (t * dot(self.u, v) - dot(self.u, subtract(self.p, o))) / uu
        self.add_gap(within(free, 0.0, 1.0), o, t, v, uu * beyond_ends(free), where)

    def add_crossing(self, o: Vector, v: Vector, where: str) -> None:
        """Keep it off a round edge, where lines are nearest to each other between their ends."""
        u, w = self.u, subtract(self.p, o)
        uu, uv, vv, uw, vw = dot(u, u), dot(u, v), dot(v, v), dot(u, w), dot(v, w)
        both = cross(u, v)
        sine2 = dot(both, both)
        bound = larger(sine2, PARALLEL * uu * vv)
        s_free, t_free = (uv * vw - vv * uw) / bound, (uu * vw - uv * uw) / bound
        s, t = within(s_free, 0.0, 1.0), within(t_free, 0.0, 1.0)
        beyond = [within(s_free - s, -1.0, 1.0), within(t_free - t, -1.0, 1.0)]
        more = uu * (beyond[0] * beyond[0] + 1.0 - sine2 / bound) + vv * beyond[1] * beyond[1]
        self.add_gap(s, o, t, v, more, where)

    def add_sharp_crossing(self, edge: Edge, where: str) -> None:
        """Keep it off an edge without a radius, where two planes of the other shape meet."""
        planes, p, u = self.other.planes, self.p, self.u
        (a, a_off), (b, b_off) = (planes[k] for k in edge[2:])
        length = norm(subtract(*self.stick.corners))
        d_a, d_b, along_a, along_b = dot(a, p) - a_off, dot(b, p) - b_off, dot(a, u), dot(b, u)
        v = cross(b, a)
        both, w = cross(u, v), along_a - along_b
        sine2, uu = dot(both, both), length * length
        bound = larger(sine2, PARALLEL * uu * dot(v, v))
        per = w / larger(w * w, PARALLEL * uu)
        free = (d_b - d_a) * per
        s = within(free, 0.0, 1.0)
        share_a, share_b, apart = -1.0 * along_b * per, along_a * per, (s - free) * w
        height = share_a * d_a + share_b * d_b + larger(share_b * apart, -1.0 * share_a * apart)
        x = add(p, scale(s, u))
        rest = largest(
            dot(n, x) - offset for k, (n, offset) in enumerate(planes) if k not in edge[2:]
        )
        c = sqrt(larger(w * w / bound, 0.25))  # 1 or more where both faces carry it
        out = within(free - within(free, MARGIN, 1.0 - MARGIN), -1.0, 1.0)
        off = within(share_a - within(share_a, 0.0, 1.0), -1.0, 1.0)  # both faces carry it: 0
        aligned = (1.0 - sine2 / bound) + (1.0 - w * per)  # with the edge, or with the plane
        more = length * (out * out + off * off + aligned)
        normal = scale(c, add(scale(share_a, a), scale(share_b, b)))
        self._add(c * larger(height, 2.0 * rest - height) + more, s, normal, where)


def add_crossings(rows: Rows, contact: PairContact, first: Shape, second: Shape) -> None:
    """Keep each edge of a polyhedron off each edge of another one."""
    rounded = is_there(first.radius) or is_there(second.radius)
    for one, two in product(first.edges, second.edges):
        stick = Stick(rows, contact, first.edge(one), second)
        where = f" where the edge from corner {one[0] + 1} to {one[1] + 1}{first.title} crosses "
        where += f"that from {two[0] + 1} to {two[1] + 1}{second.title}"
        if rounded:
            o, end = (second.corners[k] for k in two[:2])
            stick.add_crossing(o, subtract(end, o), where)
        else:
            stick.add_sharp_crossing(two, where)
