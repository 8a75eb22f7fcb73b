"""Points, bars and rigid bodies: nodes, masses and rows.

A uniform slender bar of mass m between two points has the mass matrix (m/6) [[2, 1], [1, 2]] x I,
one row |X_2 - X_1|^2 = L^2, and half its weight at either end. A rigid body is r, its centre of
mass, and directors: d_1, d_2, d_3 with d_i . d_k = delta_ik in space, one d with |d| = 1 in the
plane; its mass matrix is diag(m, E) or diag(m, J). (theory 9)
"""

from __future__ import annotations

from functools import partial, reduce

from solver.mechanics.combination import node
from solver.mechanics.frames import BarFrame, RigidFrame
from solver.mechanics.inertia import FLOOR, euler_tensor, floored, minors
from solver.mechanics.mechanism import DRIVEN, FIXED, FREE, GIVEN, Node, Scale
from solver.mechanics.rows import Rows
from solver.mechanics.vectors import (
    Matrix,
    Vector,
    add,
    columns,
    cross,
    scale,
    times,
    turned,
)
from solver.runtime.layout import NODE_DIRECTION, NODE_POINT
from solver.scene import Bar, Expr, Number, Point, Rigid
from solver.scene.body_sizes import TINY
from solver.scene.expression import operate, select, sqrt


def add_point(rows: Rows, point: Point, path: Vector | None) -> int:
    """Add a point, whose coordinates follow `path` unless that is None; return its node."""
    mechanism = rows.mechanism
    rows.finite(point.position, "position")
    velocity = point.velocity or (0.0,) * mechanism.dim
    rows.finite(velocity, "velocity")
    motion = FIXED if point.fixed else FREE if path is None else DRIVEN
    index = mechanism.add_node(
        Node(
            motion, NODE_POINT, point.position, velocity, point.mass, point.mass,
            GIVEN if point.velocity is not None else 1.0,
        )
    )  # fmt: skip
    if motion == FIXED:
        return index
    mechanism.masses[index, index] = point.mass
    if path is not None:
        mechanism.driven_signals.extend(path)
    return index


def add_bar(rows: Rows, bar: Bar) -> BarFrame:
    """Add a uniform slender bar; return its frame."""
    mechanism = rows.mechanism
    first, second = ends = tuple(rows.parts.points[point] for point in bar.points)
    length2 = rows.distance(node(second) - node(first), None)
    for a in ends:
        mechanism.nodes[a].mass = mechanism.nodes[a].mass + bar.mass / 2.0
        mechanism.nodes[a].weight = mechanism.nodes[a].weight + bar.mass / 2.0
        mechanism.add_mass(a, a, bar.mass / 3.0)
    mechanism.add_mass(first, second, bar.mass / 6.0)
    drawn = (mechanism.nodes[first].position, mechanism.nodes[second].position)
    return BarFrame(mechanism, (first, second), sqrt(length2), drawn)


def _spun(spin: Number | Vector | None, arm: Vector) -> Vector:
    """Return omega x arm."""
    if spin is None:
        return (0.0,) * len(arm)
    return cross(spin, arm) if isinstance(spin, tuple) else scale(spin, turned(arm))


def add_rigid(rows: Rows, body: Rigid, size2: Number) -> RigidFrame:
    """Add a rigid body; return its frame.

    `size2` is its squared size [m2] (``solver.scene.body_sizes``).
    """
    mechanism = rows.mechanism
    rotation = body.rotation
    arm = times(rotation, body.center_of_mass)
    rows.finite(body.position, "position")
    rows.finite(body.velocity or (), "velocity")
    spin, still = body.angular_velocity, (0.0,) * mechanism.dim
    centre = mechanism.add_node(
        Node(
            FREE, NODE_POINT, add(body.position, arm),
            add(body.velocity or still, _spun(spin, arm)), body.mass, body.mass,
            1.0 if body.velocity is None else GIVEN,
        )
    )  # fmt: skip
    mechanism.add_mass(centre, centre, body.mass)
    weight = 1.0 if spin is None else GIVEN
    directors = tuple(
        mechanism.add_node(
            Node(FREE, NODE_DIRECTION, axis, _spun(spin, axis), velocity_weight=weight)
        )
        for axis in columns(rotation)[: 1 if mechanism.dim == 2 else 3]
    )
    frame = RigidFrame(
        mechanism, centre, directors, rotation, mechanism.nodes[centre].position,
        body.center_of_mass, body.points,
    )  # fmt: skip
    mechanism.rigid.append((centre, *directors))
    _add_inertia(rows, frame, body, size2)
    for i, first in enumerate(directors):
        for second in directors[i:]:
            form, _ = mechanism.form(node(first), node(second))
            rows.form_row(form, 1.0 if first == second else 0.0, Scale(1.0, 0), "axes")
    mechanism.bodies[directors[0]] = len(mechanism.bodies)
    return frame


def _add_inertia(rows: Rows, frame: RigidFrame, body: Rigid, size2: Number) -> None:
    """Give the directors their masses."""
    mechanism = rows.mechanism
    if not isinstance(body.inertia, tuple):
        rows.rule(body.inertia, ">=", "inertia must be >= 0 kg.m2")
        ((J,),) = _enough(rows, body, ((body.inertia,),), body.inertia, size2)
        mechanism.add_mass(frame.directors[0], frame.directors[0], J)
        mechanism.nodes[frame.directors[0]].mass = J
        return
    E = euler_tensor(body.inertia)
    for minor in minors(E):
        text = "inertia breaks the triangle inequality J1 + J2 >= J3 of real bodies"
        rows.rule(minor, ">=", text)
    moments = (body.inertia[i][i] for i in range(3))
    E = _enough(rows, body, E, reduce(partial(operate, "max"), moments), size2)
    E = floored(E, mechanism.default)
    # Norms and penalties take the largest: what holds a light direction is its body, and a penalty
    # scaled with its own small inertia would make Uzawa's iteration slow.
    largest = max((E[i][i] for i in range(3)), key=mechanism.default)
    for i, first in enumerate(frame.directors):
        mechanism.nodes[first].mass = largest
        for k in range(i, 3):
            mechanism.add_mass(first, frame.directors[k], E[i][k])


def _enough(rows: Rows, body: Rigid, E: Matrix, moment: Number, size2: Number) -> Matrix:
    """Return E, or FLOOR m l^2 for a body whose largest `moment` counts as 0.

    Forces at its places then turn it as they turn a point mass on massless arms: not at all, but
    for a part in 10^7.
    """
    default = rows.mechanism.default
    if default(size2) == 0.0:
        text = (
            "inertia must be > 0 kg.m2, got {value!r}, since its points, and the bodies joined to "
            "it, lie at its centre of mass; write an inertia, or a point instead of the body"
        )
        rows.rule(moment, ">", text)
        return E
    most = TINY * (body.mass * size2)
    least = FLOOR * body.mass * size2
    is_tiny: Number = float(default(moment) < default(most))
    if isinstance(moment, Expr):
        is_tiny = operate("lt", moment, most)
        bound = f"below {TINY:g} of mass times size squared"
        text = "inertia of {value:.6g} kg.m2 counts as 0, " + bound
        rows.rule(is_tiny * moment, "noted", text)
    return tuple(
        tuple(
            select(is_tiny, least if i == k else 0.0, x) if i == k or x != 0.0 else x
            for k, x in enumerate(row)
        )
        for i, row in enumerate(E)
    )
