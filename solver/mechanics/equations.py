"""What the equations of a mechanism are made of: nodes, forms, quantities, rows, forces.

s = u . w,      sigma = s, sqrt(s) or atan2(s_2, s_1),      Phi(sigma, b(t)) = 0

Most are named tuples: a large mechanism has a million of them, and a frozen dataclass takes three
times as long to make.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

from solver.mechanics.combination import Combination
from solver.mechanics.vectors import Vector
from solver.runtime.model import Row
from solver.scene import Number

FREE, DRIVEN, FIXED = 0, 1, 2
"""How a node moves."""
POINT, DIRECTION = 0, 1
"""What a node is."""
FORM, LENGTH, ANGLE = 0, 1, 2
"""Kinds of quantities."""
VALUE, RATE, SIGNAL = 0, 1, 2
"""Kinds of leaves."""
GIVEN = 1e8
"""Weight of a velocity that the scene gives, against 1, when velocities are made consistent."""


@dataclass(slots=True)
class Node:
    """A point or direction: position as drawn [m or 1], velocity, shares of mass [kg]."""

    motion: int
    kind: int
    position: Vector
    velocity: Vector
    mass: Number = 0.0
    """Share in norms."""
    weight: Number = 0.0
    """Mass that gravity acts on."""
    velocity_weight: float = 1.0


class Form(NamedTuple):
    """s = u . w."""

    u: Combination
    w: Combination


class Quantity(NamedTuple):
    """A form, the length of one, or the angle of two (cosine, sine)."""

    kind: int
    forms: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Leaf:
    """What a formula depends on: a quantity's value or rate, or a signal."""

    kind: int
    index: int


class Formula(NamedTuple):
    """A number over leaves, which stand in it as the symbols of `leaf_symbol`."""

    value: Number
    leaves: tuple[Leaf, ...]


class Scale(NamedTuple):
    """A row's size, base extent^power: what its residual is compared with."""

    base: Number
    power: int


class FormRow(NamedTuple):
    """s - constant = 0."""

    form: int
    constant: Number
    scale: Scale
    row: Row


class Coincidence(NamedTuple):
    """u = 0."""

    form: int
    row: Row
    scale: Scale = Scale(1.0, 1)


class FunctionRow(NamedTuple):
    """A formula that is zero."""

    formula: Formula
    scale: Scale
    row: Row


class Element(NamedTuple):
    """Force k (sigma - rest) + c dsigma/dt - drive along a quantity."""

    quantity: int
    stiffness: Number = 0.0
    rest: Number = 0.0
    damping: Number = 0.0
    drive: Number = 0.0
    sampled: str = ""
    """What it is called in a sentence, if the drive reads the mechanism; likewise of loads."""

    @property
    def numbers(self) -> tuple[Number, ...]:
        """All that its law contains."""
        return self.stiffness, self.rest, self.damping, self.drive


class Load(NamedTuple):
    """A force on a link, in global axes (None) or in those of the body with this first director."""

    form: int
    value: Vector
    axes: int | None
    sampled: str = ""


class Moment(NamedTuple):
    """A moment that turns a link: a bar, or a body in the plane."""

    form: int
    value: Vector
    sampled: str = ""


class BodyMoment(NamedTuple):
    """A moment on a spatial body with this first director, in global axes or its own."""

    node: int
    value: Vector
    body_axes: bool
    sampled: str = ""


Part = FormRow | Coincidence | FunctionRow | Element | Formula | Load | Moment | BodyMoment
"""What makes nodes depend on each other."""
