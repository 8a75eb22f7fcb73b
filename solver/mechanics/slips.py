"""Slip rates of materials that touch.

s = x' . t + sum of arms (w x n) . t,        n . t = 0

with the normal n, tangents t, and the angular velocity w of what turns. In space the tangents turn
with n from those of a direction a by the smallest turn, which is smooth until n points against a.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

from solver.mechanics.combination import Combination
from solver.mechanics.formulas import leaf_symbol
from solver.mechanics.frames import RigidFrame
from solver.mechanics.mechanism import Formula, Leaf, Mechanism
from solver.mechanics.rows import Rows
from solver.mechanics.vectors import Vector, cross, dot, perpendicular, scale, turned
from solver.runtime.layout import LEAF_RATE
from solver.scene import Expr, Number, PointReference
from solver.scene.expression import operate

TINY = 1e-300
"""Added to what divides, and vanishes where there is no direction."""
IDENTITY = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)


def body_of(rows: Rows, reference: PointReference) -> RigidFrame | None:
    """Rigid body that a place belongs to; None for the ground and for points, which do not turn."""
    frame = rows.parts.frames.get((reference.point or "").partition(".")[0])
    return frame if isinstance(frame, RigidFrame) else None


def is_there(number: Number) -> bool:
    """Whether a number may be other than 0."""
    return isinstance(number, Expr) or number != 0.0


def dot_of_pairs(
    mechanism: Mechanism, leaves: list[Leaf],
    pairs: list[tuple[Combination, Combination, Combination]],
) -> tuple[Number, Number]:  # fmt: skip
    """Return sum (d . n) (d . t)' and sum (d . n)^2 of triples d, n, t; their leaves are added.

    With d along all axes of a body the ratio is (w x n) . t. Over a step, where values are means,
    it is then 2 tan(phi/2)/h for a turn phi about n x t, which is what velocities have: a ball that
    rolls rolls without slip at any step. The rate of the angle itself would be phi/h.
    """
    total: Number = 0.0
    size2: Number = 0.0
    for d, n, t in pairs:
        k = len(leaves)
        leaves.append(mechanism.leaf(mechanism.component(d, n)))
        leaves.append(mechanism.leaf(mechanism.component(d, t), LEAF_RATE))
        total = total + leaf_symbol(k) * leaf_symbol(k + 1)
        size2 = size2 + leaf_symbol(k) * leaf_symbol(k)
    return total, size2


def turning(
    mechanism: Mechanism, leaves: list[Leaf], spokes: Iterable[Combination],
    axes: Sequence[Combination], normal: Vector, tangent: Vector,
) -> Number:  # fmt: skip
    """Return (w x n) . t of a body with these axes d; its leaves are added.

    Normal and tangent are given by their components along axes of the other body. It is
    sum y_j d_j' . t with sum y_j d_j = n. Over a step, where values are means, w is then along the
    axis of the turn phi, 2 tan(phi/2)/h, as in ``dot_of_pairs``; and what turns with the other
    body has no slip, so that both keep their angular momentum.
    """
    rows: list[Vector] = []
    rates: list[Number] = []
    for spoke in spokes:
        row: Vector = ()
        rate: Number = 0.0
        for axis, t in zip(axes, tangent, strict=True):
            component = mechanism.component(spoke, axis)
            row = (*row, leaf_symbol(len(leaves)))
            rate = rate + t * leaf_symbol(len(leaves) + 1)
            leaves += mechanism.leaf(component), mechanism.leaf(component, LEAF_RATE)
        rows.append(row)
        rates.append(rate)
    if len(rows) == 2:  # axes of the plane stay at right angles
        along = [dot(row, normal) for row in rows]
        return dot(along, rates) / dot(along, along)
    across = [cross(rows[(j + 1) % 3], rows[(j + 2) % 3]) for j in range(3)]
    volume = dot(rows[0], across[0])
    return dot([dot(normal, x) / volume for x in across], rates)


def sliding(
    mechanism: Mechanism, leaves: list[Leaf], forms: Iterable[tuple[Combination, Combination]],
    tangent: Vector,
) -> Number:  # fmt: skip
    """Return x' . t for forms link . axis that are coordinates of x; their rates are added."""
    total: Number = 0.0
    for t, form in zip(tangent, forms, strict=True):
        total = total + t * leaf_symbol(len(leaves))
        leaves.append(mechanism.leaf(mechanism.component(*form), LEAF_RATE))
    return total


def slips_along(tangents: Sequence[Vector], velocity: Callable[[Vector], Formula]) -> list[Formula]:
    """Return slip rates along tangents; `velocity` returns that along any vector.

    In space those along the axes make both of them, with fewer operations.
    """
    if len(tangents) == 1:
        return [velocity(tangents[0])]
    each = [velocity(axis) for axis in IDENTITY]
    return [Formula(dot(t, [x.value for x in each]), each[0].leaves) for t in tangents]


def plane_tangents(mechanism: Mechanism, normal: Vector) -> tuple[Vector, ...]:
    """Unit vectors along a plane; in 2-D the one to the right of the normal."""
    if mechanism.dim == 2:
        return (scale(-1.0, turned(normal)),)
    first = perpendicular(normal, mechanism.default)[0]
    return first, cross(normal, first)


def tangents(mechanism: Mechanism, normal: Vector, start: Vector) -> tuple[Vector, ...]:
    """Return unit tangents; in 2-D the one to the right of the normal.

    In space they turn with the normal from those of the unit vector `start`, and turn over where it
    points against that.
    """
    if len(normal) == 2:
        return ((normal[1], -1.0 * normal[0]),)
    first, second = perpendicular(start, mechanism.default)
    x, y = dot(normal, first), dot(normal, second)
    # The bound holds of all unit vectors; where the normal is -start it keeps z from 0.
    z = operate("max", 1.0 + dot(normal, start), 0.5 * (x * x + y * y) + TINY)
    mixed = -1.0 * x * y / z
    components = (1.0 - x * x / z, mixed, -1.0 * x), (mixed, 1.0 - y * y / z, -1.0 * y)
    return tuple(
        tuple(dot(parts, column) for column in zip(first, second, start, strict=True))
        for parts in components
    )
