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
from solver.mechanics.equations import VALUE, Leaf
from solver.mechanics.formulas import leaf_symbol
from solver.mechanics.frames import Frame, Ground
from solver.mechanics.mechanism import Mechanism
from solver.mechanics.parts import JointParts, Parts
from solver.mechanics.rows import METRES, Rows
from solver.mechanics.vectors import Vector, dot, perpendicular, turned, unit
from solver.scene import BodyJoint, Screw, Universal


@dataclass(slots=True)
class Pair:
    """Two bodies at a joint: what its rows are written with."""

    mechanism: Mechanism
    rows: Rows
    A: Frame
    B: Frame
    joint: BodyJoint
    ends: tuple[Combination, Combination]
    """The joint's place on either."""
    axis: Vector
    normals: tuple[Vector, ...]
    """Perpendicular to the axis: two in space, one in the plane."""

    @property
    def link(self) -> Combination:
        """From the joint's place on A to that on B."""
        return self.ends[1] - self.ends[0]

    def meet(self) -> None:
        """Let the places coincide."""
        self.rows.coincidence(*self.ends)

    def align(self) -> None:
        """Keep the axes parallel: a . b_1 = a . b_2 = 0; in the plane J a . b = 0."""
        if self.mechanism.dim == 2:
            self.rows.direction(self.A.direction(self.normals[0]), self.B.direction(self.axis))
            return
        for normal in self.normals:
            self.rows.direction(self.A.direction(self.axis), self.B.direction(normal))

    def slide(self) -> None:
        """Keep B on the axis: (x_B - x_A) . c = 0 for each normal c of A."""
        for normal in self.normals:
            self.rows.offset(self.link, self.A.direction(normal))

    def hold(self) -> None:
        """Keep B from turning about the axis: c_1 . b_2 = 0."""
        first, second = self.normals
        self.rows.direction(self.A.direction(first), self.B.direction(second))


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


def _revolute(pair: Pair, found: JointParts) -> None:
    pair.meet()
    if pair.mechanism.dim == 3:
        pair.align()
    _turn(pair, found)


def _turn(pair: Pair, found: JointParts) -> None:
    axis = None if pair.mechanism.dim == 2 else pair.axis
    found.angle = angle_between(pair.mechanism, pair.A, pair.B, axis)


def _move(pair: Pair, found: JointParts) -> None:
    found.displacement = pair.mechanism.component(pair.link, pair.A.direction(pair.axis))


def _spherical(pair: Pair, found: JointParts) -> None:  # noqa: ARG001
    pair.meet()


def _universal(pair: Pair, found: JointParts) -> None:  # noqa: ARG001
    assert isinstance(pair.joint, Universal)
    pair.meet()
    pair.rows.direction(pair.A.direction(pair.axis), pair.B.direction(unit(pair.joint.axes[1])))


def _cylindrical(pair: Pair, found: JointParts) -> None:
    pair.align()
    pair.slide()
    _turn(pair, found)
    _move(pair, found)


def _prismatic(pair: Pair, found: JointParts) -> None:
    pair.align()
    pair.slide()
    if pair.mechanism.dim == 3:
        pair.hold()
    _move(pair, found)


def _planar(pair: Pair, found: JointParts) -> None:  # noqa: ARG001
    pair.align()
    pair.rows.offset(pair.link, pair.A.direction(pair.axis))


def _fixed(pair: Pair, found: JointParts) -> None:  # noqa: ARG001
    pair.meet()
    axes = (pair.B if isinstance(pair.A, Ground) else pair.A).axes
    if pair.mechanism.dim == 2:
        pair.rows.direction(pair.A.direction(axes[1]), pair.B.direction(axes[0]))
        return
    for k in range(3):
        pair.rows.direction(pair.A.direction(axes[k]), pair.B.direction(axes[(k + 1) % 3]))


def _screw(pair: Pair, found: JointParts) -> None:
    _cylindrical(pair, found)
    assert isinstance(pair.joint, Screw)
    assert found.displacement is not None
    assert found.angle is not None
    leaves = tuple(Leaf(VALUE, pair.mechanism.use(q)) for q in (found.displacement, found.angle))
    advance = leaf_symbol(0) - pair.joint.pitch / (2.0 * pi) * leaf_symbol(1)
    found.row = ("function", pair.rows.function(advance, leaves, METRES))


JOINTS: dict[str, Callable[[Pair, JointParts], None]] = {
    "spherical": _spherical,
    "revolute": _revolute,
    "universal": _universal,
    "cylindrical": _cylindrical,
    "prismatic": _prismatic,
    "planar": _planar,
    "fixed": _fixed,
    "screw": _screw,
}
"""Rows of each joint."""


def add_joint(parts: Parts, name: str, joint: BodyJoint) -> None:
    """Add the rows of a lower pair."""
    mechanism = parts.mechanism
    rows = Rows(mechanism, f"joints.{name}", f"joint '{name}'")
    found = parts.joints[name] = JointParts()
    if joint.bodies is None:
        assert joint.points is not None
        first, second = joint.points
        rows.detail = f" on {_called(first.point)} and {_called(second.point)}"
        rows.coincidence(parts.place(first), parts.place(second))
    else:
        names = zip(joint.on, joint.bodies, strict=True)
        rows.detail = " on {} and {}".format(*(_called(point or body) for point, body in names))
        pair = _pair(parts, rows, joint, joint.bodies)
        JOINTS[joint.type](pair, found)
        if joint.axis is not None:
            found.axis = pair.A.direction(pair.axis)
    found.reaction = rows.close()


def _called(name: str | None) -> str:
    return "the ground" if name is None else f"'{name}'"


def _pair(
    parts: Parts, rows: Rows, joint: BodyJoint, bodies: tuple[str | None, str | None]
) -> Pair:  # fmt: skip
    mechanism = parts.mechanism
    A, B = (parts.frame(body) for body in bodies)
    axis: Vector = ()
    normals: tuple[Vector, ...] = ()
    if joint.axis is not None:
        part = (rows.location, rows.name)
        mechanism.finite(joint.axis, part, "axis")
        mechanism.rule(dot(joint.axis, joint.axis), ">", part, "axis must not be of length zero")
        axis = unit(joint.axis)
        plane = mechanism.dim == 2
        normals = (turned(axis),) if plane else perpendicular(axis, mechanism.default)
    assert joint.position is not None or joint.type in ("prismatic", "fixed")
    place = joint.position or _origin(parts, bodies[1])
    first, second = (
        parts.named(point) if point else frame.place(place)
        for point, frame in zip(joint.on, (A, B), strict=True)
    )
    return Pair(mechanism, rows, A, B, joint, (first, second), axis, normals)


def _origin(parts: Parts, body: str | None) -> Vector:
    """Place of a joint whose position is not given: the origin of its second body."""
    if body is None or not parts.is_place(body):
        return (0.0,) * parts.mechanism.dim
    return parts.mechanism.drawn(parts.named(body))
