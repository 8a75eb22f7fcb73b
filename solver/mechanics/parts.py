"""The parts of a mechanism by name, and what a symbol of a formula means."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, NamedTuple

from solver.mechanics.combination import Combination, node
from solver.mechanics.frames import Frame, Ground, RigidFrame
from solver.mechanics.mechanism import Leaf, Mechanism
from solver.mechanics.vectors import Vector, identity, norm
from solver.runtime.layout import LEAF_RATE, LEAF_VALUE, NODE_DIRECTION, NODE_POINT
from solver.scene import Expr, Number, PointReference, Scene

AXES = "xyz"
Meaning = Leaf | Number
RowOf = tuple[str, int]
"""Kind of a row, "form", "function" or "velocity", and its index among those."""


@dataclass(slots=True)
class JointParts:
    """What a joint or driver offers to others, and where its reactions are found."""

    angle: int | None = None
    """Quantity: of the second body about the axis against the first, zero as drawn."""
    displacement: int | None = None
    """Quantity: of the second body along the axis, zero as drawn."""
    driven: int | None = None
    """Quantity that a driver prescribes."""
    reaction: int | None = None
    """Index among the mechanism's reactions."""
    axis: Combination | None = None
    """Unit direction, fixed in the first body."""
    row: RowOf | None = None
    """The one row of a joint whose reaction is one number."""
    factor: Number = 1.0
    """What -mu of that row is multiplied with to be the reaction."""
    pushes: list[tuple[RowOf, Number, Combination]] = field(default_factory=list)
    """Row, slope, direction: -mu slope direction is a part of the force on the second body."""
    friction: int | None = None
    """Index among the mechanism's frictions."""
    spring: int | None = None
    """Element of the spring in it; likewise of the damper."""
    damper: int | None = None
    own: dict[str, Leaf] = field(default_factory=dict)
    """Symbols of the slopes with a meaning of their own."""


class CompliantContact(NamedTuple):
    """A contact that is a force: all but the damping are formulas of one quantity."""

    quantity: int
    gap: Number
    depth: Number
    force: Number
    """Without damping."""
    damping: Number
    """Share of the force per speed."""


class ForceLaw(NamedTuple):
    """A force of what it reads, positive where it draws its quantity together."""

    force: Number
    """Without what rubs."""
    own: dict[str, Leaf]
    """Symbols with a meaning in it alone, such as ``rate``."""


@dataclass(slots=True)
class Parts:
    """Names and what they stand for in a mechanism."""

    scene: Scene
    mechanism: Mechanism
    points: dict[str, int] = field(default_factory=dict)
    """Node of each point."""
    frames: dict[str, Frame] = field(default_factory=dict)
    """Of rigid bodies, in the plane also of bars."""
    links: dict[str, Combination] = field(default_factory=dict)
    """From the first to the second end of bars, springs, dampers, gravitations."""
    joints: dict[str, JointParts] = field(default_factory=dict)
    paths: Mapping[str, tuple[str, Vector]] = field(default_factory=dict)
    """Driver of each driven point, and the path that it prescribes."""
    elements: dict[str, int] = field(default_factory=dict)
    """Element of a force."""
    rubbing: dict[str, tuple[int, float]] = field(default_factory=dict)
    """Friction of a force with the sign of a rate, and the sign with which it acts along that."""
    force_laws: dict[str, ForceLaw] = field(default_factory=dict)
    """Of dampers and actuators that have a law of their own."""
    derived: list[tuple[str, Number]] = field(default_factory=list)
    """Numbers of laws that no part has as written, each with the title of its part."""
    contacts: dict[str, list[int]] = field(default_factory=dict)
    """Index among the mechanism's contacts; a stop with both ends has two."""
    compliant: dict[str, list[CompliantContact]] = field(default_factory=dict)
    """Likewise of contacts that are forces."""
    meshes: dict[str, dict[str, Any]] = field(default_factory=dict)
    """What `info` tells of the grid of a contact with a mesh."""
    problems: list[tuple[str, str]] = field(default_factory=list)
    """Location and sentence of what is wrong with the scene."""

    def frame(self, name: str | None) -> Frame:
        """Return the frame of a body; None is the ground."""
        return Ground(self.mechanism) if name is None else self.frames[name]

    def axis(self, k: int) -> Combination:
        """Return a global axis."""
        return self.mechanism.fixed(NODE_DIRECTION, identity(self.mechanism.dim)[k])

    def place(self, reference: PointReference) -> Combination:
        """Return the place that a reference names."""
        if reference.point is None:
            assert reference.at is not None
            return self.mechanism.fixed(NODE_POINT, reference.at)
        if reference.at is not None:
            return self.frames[reference.point].place(reference.at)
        return self.named(reference.point)

    def named(self, name: str) -> Combination:
        """Return a point, the origin of a rigid body, or a point of one."""
        if name in self.points:
            return node(self.points[name])
        body, _, point = name.partition(".")
        frame = self.frames[body]
        assert isinstance(frame, RigidFrame)
        return frame.at(frame.points[point] if point else (0.0,) * self.mechanism.dim)

    def link(self, ends: tuple[PointReference, PointReference]) -> Combination:
        """Return the second place less the first."""
        first, second = (self.place(end) for end in ends)
        return second - first

    def is_place(self, name: str) -> bool:
        """Whether a name is that of a point, a rigid body's origin, or a point of one."""
        body, _, point = name.partition(".")
        frame = self.frames.get(body)
        own = isinstance(frame, RigidFrame) and (not point or point in frame.points)
        return name in self.points or own

    # -------------------------------------------------------------------- symbols of formulas

    def meaning(self, name: str) -> Meaning:
        """Return what a symbol of a formula stands for: a quantity, a rate, or a known number."""
        owner, _, word = name.rpartition(".")
        kind = LEAF_RATE if word.startswith(("v", "angular_velocity")) else LEAF_VALUE
        if self.is_place(owner) and (axis := word.removeprefix("v")) in set(AXES):
            place, k = self.named(owner), AXES.index(axis)
            if not self.mechanism.moves(place):
                return 0.0 if kind == LEAF_RATE else self.mechanism.drawn(place)[k]
            quantity = self.mechanism.component(place, self.axis(k))
        elif owner in self.joints:
            joint = self.joints[owner]
            turns = word in ("angle", "angular_velocity")
            quantity = joint.angle if turns else joint.displacement
        else:
            quantity = self.body_angle(owner)
        assert quantity is not None, name
        return Leaf(kind, quantity)

    def body_angle(self, name: str) -> int:
        """Return the angle of a planar body from the x axis."""
        frame = self.frames[name]
        along = node(frame.directors[0]) if isinstance(frame, RigidFrame) else self.links[name]
        x, y = self.axis(0), self.axis(1)
        return self.mechanism.angle((along, x), (along, y))

    def distance(self, call: Expr) -> Meaning:
        """Return what ``distance(A, B)`` stands for."""
        _, first, second = (str(arg) for arg in call.args)
        link = self.named(second) - self.named(first)
        if not self.mechanism.moves(link):
            return norm(self.mechanism.drawn(link))
        return Leaf(LEAF_VALUE, self.mechanism.length(link))
