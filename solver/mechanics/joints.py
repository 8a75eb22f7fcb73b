"""Joints between two bodies as rows (theory 9.3).

Each joint is the list of rows between A, the first body, and B, the second one: with x the place of
the joint, a its axis in A, and b_1, b_2 perpendicular to it in B; places and axes are as drawn.
Angles are those of B against A about +a, displacements those of B along a, both zero as drawn.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import pi

from solver.mechanics.combination import Combination
from solver.mechanics.formulas import leaf_symbol, sensed
from solver.mechanics.frames import Frame, Ground
from solver.mechanics.mechanism import Element, Formula, Friction, Leaf, Mechanism
from solver.mechanics.parts import JointParts
from solver.mechanics.rows import METRES, RADIANS, Rows
from solver.mechanics.vectors import Vector, perpendicular, turned, unit
from solver.runtime.layout import LEAF_RATE, REACTION_COINCIDENCE, REACTION_FORCE
from solver.scene import (
    BodyJoint,
    Cylindrical,
    Fixed,
    JointFriction,
    Number,
    Planar,
    Prismatic,
    Revolute,
    Screw,
    Spherical,
    Universal,
)


@dataclass(slots=True)
class Pair:
    """Two bodies at a joint: what its rows are written with."""

    rows: Rows
    joint: BodyJoint
    found: JointParts
    A: Frame
    B: Frame
    ends: tuple[Combination, Combination]
    """The joint's place on either."""
    axis: Vector
    normals: tuple[Vector, ...]
    """Perpendicular to the axis: two in space, one in the plane."""

    def meet(self) -> None:
        """Let the places coincide."""
        self.rows.coincidence(*self.ends)

    def align(self) -> None:
        """Keep the axes parallel: a . b_1 = a . b_2 = 0; in the plane J a . b = 0."""
        for normal in self.normals:
            a, b = (self.axis, normal) if len(self.normals) == 2 else (normal, self.axis)
            self.rows.direction(self.A.direction(a), self.B.direction(b))

    def slide(self) -> None:
        """Keep B on the axis: (x_B - x_A) . c = 0 for each normal c of A."""
        for normal in self.normals:
            self.rows.offset(self._link, self.A.direction(normal))

    def stay(self) -> None:
        """Keep B on the plane across the axis: (x_B - x_A) . a = 0."""
        self.rows.offset(self._link, self.A.direction(self.axis))

    def hold(self) -> None:
        """Keep B from turning about the axis: c_1 . b_2 = 0; in the plane parallel axes do."""
        if len(self.normals) == 2:
            first, second = self.normals
            self.rows.direction(self.A.direction(first), self.B.direction(second))

    def cross(self) -> None:
        """Keep the axis of A perpendicular to the other one, of B."""
        assert isinstance(self.joint, Universal)
        second = unit(self.joint.axes[1])
        self.rows.direction(self.A.direction(self.axis), self.B.direction(second))

    def lock(self) -> None:
        """Keep B from turning at all."""
        axes = (self.B if isinstance(self.A, Ground) else self.A).axes
        pairs = ((1, 0),) if len(axes) == 2 else ((0, 1), (1, 2), (2, 0))
        for i, k in pairs:
            self.rows.direction(self.A.direction(axes[i]), self.B.direction(axes[k]))

    def turn(self) -> None:
        """Offer the angle about the axis."""
        mechanism = self.rows.mechanism
        self.found.angle = angle_between(mechanism, self.A, self.B, self.axis or None)

    def move(self) -> None:
        """Offer the displacement along the axis."""
        along = self.A.direction(self.axis)
        self.found.displacement = self.rows.mechanism.component(self._link, along)

    def advance(self) -> None:
        """Couple displacement and angle by the pitch."""
        assert isinstance(self.joint, Screw)
        assert self.found.displacement is not None
        assert self.found.angle is not None
        leaf = self.rows.mechanism.leaf
        advance = leaf_symbol(0) - self.joint.pitch / (2.0 * pi) * leaf_symbol(1)
        formula = Formula(advance, (leaf(self.found.displacement), leaf(self.found.angle)))
        self.found.row = self.rows.function(formula, METRES)

    @property
    def _link(self) -> Combination:
        """From the joint's place on A to that on B."""
        return self.ends[1] - self.ends[0]


JOINTS: dict[type[BodyJoint], tuple[Callable[[Pair], None], ...]] = {
    Spherical: (Pair.meet,),
    Revolute: (Pair.meet, Pair.align, Pair.turn),
    Universal: (Pair.meet, Pair.cross),
    Cylindrical: (Pair.align, Pair.slide, Pair.turn, Pair.move),
    Prismatic: (Pair.align, Pair.slide, Pair.hold, Pair.move),
    Planar: (Pair.align, Pair.stay),
    Fixed: (Pair.meet, Pair.lock),
    Screw: (Pair.align, Pair.slide, Pair.turn, Pair.move, Pair.advance),
}
"""Rows of each joint, and what it offers; a hinge in the plane has no axis to align."""


def angle_between(mechanism: Mechanism, A: Frame, B: Frame, axis: Vector | None) -> int:
    """Return the angle of B against A about an axis (None in the plane), zero as drawn.

    It is that of b, perpendicular to the axis, in either body: cos = b_A . b_B,
    sin = (a x b)_A . b_B.
    """
    if axis is None:
        mark = (A if isinstance(B, Ground) else B).axes[0]
        across = turned(mark)
    else:
        mark, across = perpendicular(axis, mechanism.default)
    seen = B.direction(mark)
    return mechanism.angle((A.direction(mark), seen), (A.direction(across), seen))


def add_joint(rows: Rows, joint: BodyJoint, found: JointParts) -> None:
    """Add the rows of a lower pair."""
    parts = rows.parts
    if joint.bodies is None:
        assert joint.points is not None
        first, second = joint.points
        rows.detail = f" on {_called(first.point)} and {_called(second.point)}"
        rows.coincidence(parts.place(first), parts.place(second))
    else:
        names = zip(joint.on, joint.bodies, strict=True)
        rows.detail = " on {} and {}".format(*(_called(point or body) for point, body in names))
        pair = _pair(rows, joint, found, joint.bodies)
        for add in JOINTS[type(joint)]:
            add(pair)
        if joint.axis is not None:
            found.axis = pair.A.direction(pair.axis)
        if joint.friction is not None:
            _add_friction(pair, joint.friction)
        _add_spring_and_damper(rows, joint, found)
    found.reaction = rows.close()


def _add_spring_and_damper(rows: Rows, joint: BodyJoint, found: JointParts) -> None:
    """Add the elements that the fields of a joint ask for, about its axis or along it."""
    quantity = found.displacement if joint.springs_along else found.angle
    free = joint.free_displacement if joint.springs_along else joint.free_angle
    free = 0.0 if free is None else free
    elements = rows.mechanism.elements
    if joint.stiffness is not None:
        assert quantity is not None
        law = sensed(rows.parts, joint.stiffness), sensed(rows.parts, free)
        found.spring = len(elements)
        elements.append(Element(rows.mechanism.use(quantity), *law))
    if joint.damping is not None:
        assert quantity is not None
        damping = sensed(rows.parts, joint.damping)
        found.damper = len(elements)
        elements.append(Element(rows.mechanism.use(quantity), damping=damping))


def _add_friction(pair: Pair, friction: JointFriction) -> None:
    """Let a joint rub: about its axis, along it, about its centre, or about and along it.

    |T| <= coefficient radius N + preload with N the force on the places that meet, or, of a joint
    that slides, that across its axis. A cylindrical joint slips by R theta' and s' at once.
    """
    rows, found, mechanism = pair.rows, pair.found, pair.rows.mechanism
    rows.demand(friction)
    across = [("coincidence", k) for entry, k, _ in rows.entries if entry == REACTION_COINCIDENCE]
    across += [("form", k) for entry, k, _ in rows.entries if entry == REACTION_FORCE]
    arm = 1.0 if friction.radius is None else friction.radius
    slips: list[tuple[Number, Leaf]] = []
    if found.angle is not None:
        factor = 1.0 if found.displacement is None else arm
        slips.append((factor, mechanism.leaf(found.angle, LEAF_RATE)))
    if found.displacement is not None:
        arm = 1.0
        slips.append((1.0, mechanism.leaf(found.displacement, LEAF_RATE)))
    formulas = [Formula(factor * leaf_symbol(0), (leaf,)) for factor, leaf in slips]
    size = RADIANS if found.displacement is None else METRES
    slip_rows = tuple(rows.velocity(x, size)[1] for x in formulas or _turning_rates(pair))
    static = rows.static(friction.coefficient, friction.static, "static - coefficient")
    found.friction = len(mechanism.frictions)
    cones = arm * friction.coefficient, arm * static, friction.preload
    smooth = 0.0 if friction.smooth_speed is None else friction.smooth_speed
    mechanism.frictions.append(Friction(slip_rows, (tuple(across),), *cones, smooth))


def _turning_rates(pair: Pair) -> list[Formula]:
    """Angular velocity of B against A in axes of A: w_1 = sum_j (a_2 . b_j) (a_3 . b_j)' etc."""
    mechanism = pair.rows.mechanism
    axes = (pair.B if isinstance(pair.A, Ground) else pair.A).axes
    a, b = ([frame.direction(x) for x in axes] for frame in (pair.A, pair.B))
    formulas = []
    for k in range(3):
        second, third = a[(k + 1) % 3], a[(k + 2) % 3]
        values = [mechanism.leaf(mechanism.component(second, x)) for x in b]
        rates = [mechanism.leaf(mechanism.component(third, x), LEAF_RATE) for x in b]
        total: Number = 0.0
        for j in range(3):
            total = total + leaf_symbol(j) * leaf_symbol(3 + j)
        formulas.append(Formula(total, (*values, *rates)))
    return formulas


def _called(name: str | None) -> str:
    return "the ground" if name is None else f"'{name}'"


def _pair(
    rows: Rows, joint: BodyJoint, found: JointParts, bodies: tuple[str | None, str | None]
) -> Pair:  # fmt: skip
    parts = rows.parts
    A, B = (parts.frame(body) for body in bodies)
    axis: Vector = ()
    normals: tuple[Vector, ...] = ()
    if joint.axis is not None:
        rows.finite(joint.axis, "axis")
        axis = rows.unit(joint.axis)
        normals = rows.mechanism.normals(axis)
    assert joint.position is not None
    first, second = (
        parts.named(point) if point else frame.place(joint.position)
        for point, frame in zip(joint.on, (A, B), strict=True)
    )
    return Pair(rows, joint, found, A, B, (first, second), axis, normals)
