"""Rows of every joint as NumPy functions of places and directors, for the complex step.

Written from the table of joints in textbooks' form, apart from the solver: of bodies A and B with
x_A, x_B the places of the joint, a its axis in A, c_1, c_2 across it in A, b_1, b_2 in B, all as
drawn. A body is an array (1 + k, dim): its centre, then its directors; in the plane one director.
Nothing here conjugates or takes an absolute value, so that rows may be evaluated at complex places.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from tests.support.mechanisms.reduced_models import Array


@dataclass(frozen=True)
class Drawn:
    """A body as drawn: its centre of mass (dim,) and its axes, the columns of R (dim, dim)."""

    centre: Array
    R: Array

    def axes(self, body: Array) -> Array:
        """Axes (dim, dim) as columns; in the plane the second is the quarter turn of the first."""
        if len(self.centre) == 3:
            return body[1:].T
        x, y = body[1]
        return np.array([[x, -y], [y, x]])

    def place(self, body: Array, drawn: Array) -> Array:
        """Where a place is that is drawn at global coordinates."""
        return body[0] + self.axes(body) @ (self.R.T @ (drawn - self.centre))

    def direction(self, body: Array, drawn: Array) -> Array:
        """Where a direction points that is drawn along a global vector."""
        return self.axes(body) @ (self.R.T @ drawn)


def unit(v: Array) -> Array:
    return v / np.sqrt(v @ v)


def across(a: Array) -> tuple[Array, Array]:
    """Two directions across a: any pair spans the same rows."""
    first = unit(np.cross(a, [0.3, -0.5, 0.8]))
    return first, np.cross(unit(a), first)


def own_rows(body: Array) -> list[Any]:
    """d_i . d_k of a body, which stay."""
    d = body[1:]
    return [d[i] @ d[k] for i in range(len(d)) for k in range(i, len(d))]


@dataclass(frozen=True)
class Joint:
    """Two bodies at a joint: how they are drawn, its place and axis, and where they are."""

    first: Drawn
    second: Drawn
    position: Array
    axis: Array
    A: Array
    B: Array

    @property
    def link(self) -> Array:
        return self.second.place(self.B, self.position) - self.first.place(self.A, self.position)

    def in_A(self, v: Array) -> Array:  # noqa: N802
        return self.first.direction(self.A, v)

    def in_B(self, v: Array) -> Array:  # noqa: N802
        return self.second.direction(self.B, v)

    def parallel(self) -> list[Any]:
        if len(self.axis) == 2:
            return [self.in_A(np.array([-self.axis[1], self.axis[0]])) @ self.in_B(self.axis)]
        return [self.in_A(self.axis) @ self.in_B(b) for b in across(self.axis)]

    def on_axis(self) -> list[Any]:
        if len(self.axis) == 2:
            return [self.link @ self.in_A(np.array([-self.axis[1], self.axis[0]]))]
        return [self.link @ self.in_A(c) for c in across(self.axis)]

    def angle(self) -> Any:
        """Angle of B against A about the axis, up to half turns, which have no rate."""
        if len(self.axis) == 2:
            mark, side = np.eye(2)
        else:
            mark, side = across(self.axis)
        seen = self.in_B(mark)
        return np.arctan(self.in_A(side) @ seen / (self.in_A(mark) @ seen))

    def displacement(self) -> Any:
        return self.link @ self.in_A(unit(self.axis))


def revolute(joint: Joint) -> list[Any]:
    return [*joint.link, *(joint.parallel() if len(joint.axis) == 3 else [])]


def cylindrical(joint: Joint) -> list[Any]:
    return [*joint.parallel(), *joint.on_axis()]


def prismatic(joint: Joint) -> list[Any]:
    if len(joint.axis) == 2:
        return cylindrical(joint)
    first, second = across(joint.axis)
    return [*cylindrical(joint), joint.in_A(first) @ joint.in_B(second)]


def fixed(joint: Joint) -> list[Any]:
    if len(joint.axis) == 2:
        return [*joint.link, joint.in_A(np.array([1.0, 0])) @ joint.in_B(np.array([0, 1.0]))]
    e = np.eye(3)
    return [*joint.link, *(joint.in_A(e[i]) @ joint.in_B(e[i - 1]) for i in range(3))]


def planar(joint: Joint) -> list[Any]:
    return [*joint.parallel(), joint.displacement()]


def screw(joint: Joint) -> list[Any]:
    return [*cylindrical(joint), joint.displacement() - 0.3 / (2 * np.pi) * joint.angle()]


def universal(joint: Joint) -> list[Any]:
    return [*joint.link, joint.in_A(joint.axis) @ joint.in_B(np.array([2.0, 1.0, -2.0]))]


def constant_angle(joint: Joint) -> list[Any]:
    return [joint.in_A(joint.axis) @ joint.in_B(np.array([1.0, 0.0, 0.3]))]


LOWER: dict[str, Callable[[Joint], list[Any]]] = {
    "spherical": lambda joint: list(joint.link),
    "revolute": revolute,
    "universal": universal,
    "cylindrical": cylindrical,
    "prismatic": prismatic,
    "planar": planar,
    "fixed": fixed,
    "screw": screw,
    "angle": constant_angle,
}
"""Rows of the joints of two bodies, with the axes of `joint_scenes`."""


def tips(joint: Joint) -> tuple[Array, Array, Array, Array]:
    """Tip of A, tip of B, place of B's tip on A as drawn and where it is now; `joint_scenes`."""
    spatial = len(joint.axis) == 3
    on_A, on_B = (
        ([0.3, -0.1, 0.2], [-0.2, 0.1, 0.05]) if spatial else ([0.3, -0.1], [-0.2, 0.1])
    )  # fmt: skip
    # Points are given in body axes from the origin; the centre of B's mass lies off it.
    off = np.array([0.02, 0.05, -0.03])[: len(joint.axis)]
    tip_A = joint.A[0] + joint.first.axes(joint.A) @ on_A
    tip_B = joint.B[0] + joint.second.axes(joint.B) @ (np.array(on_B) - off)
    drawn = joint.second.centre + joint.second.R @ (np.array(on_B) - off)
    return tip_A, tip_B, drawn, joint.first.place(joint.A, drawn)


def distance(joint: Joint) -> list[Any]:
    tip_A, tip_B, _, _ = tips(joint)
    return [(tip_A - tip_B) @ (tip_A - tip_B)]


def point_on_line(joint: Joint) -> list[Any]:
    _, tip, _, place = tips(joint)
    if len(joint.axis) == 2:
        return [(tip - place) @ joint.in_A(np.array([-joint.axis[1], joint.axis[0]]))]
    return [(tip - place) @ joint.in_A(c) for c in across(joint.axis)]


def point_on_plane(joint: Joint) -> list[Any]:
    _, tip, _, place = tips(joint)
    return [(tip - place) @ joint.in_A(joint.axis)]


def point_on_surface(joint: Joint) -> list[Any]:
    local = joint.first.axes(joint.A).T @ (tips(joint)[1] - joint.A[0])
    return [local**2 @ np.array([1.0, 2.0, 3.0])[: len(local)]]


OF_POINTS: dict[str, Callable[[Joint], list[Any]]] = {
    "distance": distance,
    "point_on_line": point_on_line,
    "point_on_plane": point_on_plane,
    "point_on_surface": point_on_surface,
}
"""Rows of the joints of points."""
