"""Points, bars, joints and forces as nodes, forms, rows and laws - names become indices here.

A distance row is Phi = |x_B - x_A|^2 - L^2, one form u . u with the link u = x_B - x_A. A uniform
slender bar of mass m between two points has the mass matrix (m/6) [[2, 1], [1, 2]] x I, one
distance row, and half its weight at either end. Springs, dampers, torques are laws on a link.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from solver.scene import (
    Bar,
    Damper,
    Distance,
    Expr,
    Force,
    Number,
    PointReference,
    Scene,
    Spring,
    Torque,
)
from solver.scene.expression import sqrt

Vector = tuple[Number, ...]


@dataclass(slots=True)
class Link:
    """Form u . u with u = x_second - x_first; entries (node, coefficient), free nodes first."""

    entries: list[tuple[int, float]]
    drawn2: Number


@dataclass(slots=True)
class Parts:
    """Everything of a mechanism by index; `...` of `support_...` are nodes that do not move.

    Lists run parallel: a row, line or moment refers to a link by its index.
    """

    dim: int
    free_names: list[str] = field(default_factory=list)
    position: list[Vector] = field(default_factory=list)
    velocity: list[Vector] = field(default_factory=list)
    mass: list[Number] = field(default_factory=list)
    coupling: dict[tuple[int, int], Number] = field(default_factory=dict)
    support: list[Vector] = field(default_factory=list)
    links: list[Link] = field(default_factory=list)
    row_link: list[int] = field(default_factory=list)
    row_length2: list[Number] = field(default_factory=list)
    row_labels: list[str] = field(default_factory=list)
    row_force_name: list[str | None] = field(default_factory=list)
    line_link: list[int] = field(default_factory=list)
    line_law: list[tuple[Number, Number, Number]] = field(default_factory=list)
    line_names: list[str] = field(default_factory=list)
    moment_link: list[int] = field(default_factory=list)
    moment: list[Vector] = field(default_factory=list)
    load_node: list[int] = field(default_factory=list)
    load: list[Vector] = field(default_factory=list)
    angle_link: list[int] = field(default_factory=list)
    angle_names: list[str] = field(default_factory=list)
    rules: list[tuple[Number, str, float, str]] = field(default_factory=list)
    nodes: dict[str, int] = field(default_factory=dict)
    """Node of each point: n >= 0 is free node n, n < 0 is support -1 - n."""

    def rule(self, number: Number, relation: str, label: str, text: str) -> None:
        """Demand that a number is `relation` 0 (or finite); `text` says what and in which unit."""
        self.rules.append((number, relation, 0.0, f"{label}: {text}, got {{value!r}}"))

    def finite(self, vector: Vector, label: str, what: str) -> None:
        """Demand that what the expressions of a vector yield is a finite number."""
        for number in vector:
            if isinstance(number, Expr):
                self.rule(number, "finite", label, f"{what} must be a finite number")


def collect(scene: Scene) -> Parts:
    """Return the parts of a scene."""
    parts = Parts(dim=scene.dimension)
    for name, point in scene.points.items():
        parts.finite(point.position, f"point '{name}'", "position")
        parts.finite(point.velocity, f"point '{name}'", "velocity")
        if point.fixed:
            parts.support.append(point.position)
            parts.nodes[name] = -len(parts.support)
            continue
        parts.nodes[name] = len(parts.free_names)
        parts.free_names.append(name)
        parts.position.append(point.position)
        parts.velocity.append(point.velocity)
        parts.mass.append(point.mass)
        parts.rule(point.mass, ">=", f"point '{name}'", "mass must be >= 0 kg")
    for node, mass in enumerate(parts.mass):
        parts.coupling[node, node] = mass
    bar_links = {name: _bar(parts, name, bar) for name, bar in scene.bodies.items()}
    for name, node in parts.nodes.items():
        if node >= 0:
            text = "mass must be > 0 kg, with the bars that end at it"
            parts.rule(parts.mass[node], ">", f"point '{name}'", text)
    for name, joint in scene.joints.items():
        _distance(parts, name, joint)
    for name, force in scene.forces.items():
        _force(parts, name, force, bar_links)
    return parts


def _node(parts: Parts, reference: PointReference) -> int:
    if reference.point is not None:
        return parts.nodes[reference.point]
    assert reference.at is not None
    parts.support.append(reference.at)
    return -len(parts.support)


def _place(parts: Parts, node: int) -> Vector:
    return parts.position[node] if node >= 0 else parts.support[-1 - node]


def _link(parts: Parts, first: int, second: int) -> int:
    entries = sorted(((first, -1.0), (second, 1.0)), key=lambda entry: entry[0] < 0)
    ends = zip(_place(parts, first), _place(parts, second), strict=True)
    drawn2: Number = 0.0
    for a, b in ends:
        drawn2 = drawn2 + (b - a) * (b - a)
    parts.links.append(Link(entries, drawn2))
    return len(parts.links) - 1


def _row(parts: Parts, link: int, length: Number | None, label: str, force: str | None) -> None:
    length2 = parts.links[link].drawn2 if length is None else length * length
    parts.row_link.append(link)
    parts.row_length2.append(length2)
    parts.row_labels.append(label)
    parts.row_force_name.append(force)
    if length is None:
        message = (
            f"{label}: its points coincide; draw them apart (squared distance {{value!r}} m^2)"
        )
        parts.rules.append((length2, ">", 0.0, message))
    else:
        parts.rule(length, ">", label, "length must be > 0 m")


def _bar(parts: Parts, name: str, bar: Bar) -> int:
    first, second = (parts.nodes[point] for point in bar.points)
    label = f"body '{name}'"
    parts.rule(bar.mass, ">", label, "mass must be > 0 kg")
    link = _link(parts, first, second)
    _row(parts, link, None, label, None)
    ends = [node for node in (first, second) if node >= 0]
    for a in ends:
        parts.mass[a] = parts.mass[a] + bar.mass / 2.0
        for b in ends:
            share = bar.mass / 3.0 if a == b else bar.mass / 6.0
            parts.coupling[a, b] = parts.coupling.get((a, b), 0.0) + share
    if parts.dim == 2:
        parts.angle_link.append(link)
        parts.angle_names.append(name)
    return link


def _distance(parts: Parts, name: str, joint: Distance) -> None:
    first, second = (_node(parts, reference) for reference in joint.points)
    link = _link(parts, first, second)
    _row(parts, link, joint.length, f"joint '{name}'", f"{name}.force")


def _force(
    parts: Parts, name: str, force: Spring | Damper | Force | Torque, bar_links: dict[str, int]
) -> None:
    label = f"force '{name}'"
    if isinstance(force, Force):
        parts.finite(force.value, label, "value")
        parts.load_node.append(parts.nodes[force.point])
        parts.load.append(force.value)
        return
    if isinstance(force, Torque):
        value = force.value if isinstance(force.value, tuple) else (force.value,)
        parts.finite(value, label, "value")
        parts.moment_link.append(bar_links[force.body])
        parts.moment.append(value)
        return
    first, second = (_node(parts, reference) for reference in force.points)
    link = _link(parts, first, second)
    parts.line_link.append(link)
    parts.line_names.append(name)
    if isinstance(force, Damper):
        parts.rule(force.damping, ">=", label, "damping must be >= 0 N.s/m")
        parts.line_law.append((0.0, 0.0, force.damping))
        return
    free_length = force.free_length
    if free_length is None:
        free_length = sqrt(parts.links[link].drawn2)
    parts.rule(force.stiffness, ">=", label, "stiffness must be >= 0 N/m")
    parts.rule(free_length, ">=", label, "free_length must be >= 0 m")
    parts.line_law.append((force.stiffness, free_length, 0.0))
