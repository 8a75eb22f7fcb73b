"""Forces: elements along a quantity, loads on places, moments, potentials (theory 5)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import pi

from solver.mechanics.actuators import add_actuator
from solver.mechanics.antiderivative import energy_of
from solver.mechanics.combination import Combination
from solver.mechanics.force_laws import add_resistance
from solver.mechanics.formulas import formula, leaf_symbol, sensed, sensor, with_symbols
from solver.mechanics.frames import RigidFrame
from solver.mechanics.kinks import add_kinks
from solver.mechanics.mechanism import BodyMoment, Element, Formula, Leaf, Load, Moment, Scale
from solver.mechanics.parts import AXES, JointParts, Meaning, Parts
from solver.mechanics.rows import METRES, RADIANS, Rows
from solver.mechanics.rubbing import without_friction
from solver.mechanics.vectors import Vector, dot
from solver.runtime.layout import LEAF_VALUE
from solver.scene import (
    Actuator,
    Damper,
    Expr,
    Force,
    Gravitation,
    JointTorque,
    Number,
    PointReference,
    Potential,
    Spring,
    Torque,
    TorsionDamper,
    TorsionSpring,
    rules,
    symbols,
)
from solver.scene.expression import sqrt, symbol

LENGTH, ELONGATION, ANGLE = map(symbol, (rules.LENGTH, rules.ELONGATION, rules.ANGLE))
"""What forces and torques of springs are written in."""


def _link(rows: Rows, ends: tuple[PointReference, PointReference]) -> Combination:
    link = rows.parts.links[rows.name] = rows.parts.link(ends)
    return link


def _element(rows: Rows, element: Element) -> None:
    rows.parts.elements[rows.name] = len(rows.mechanism.elements)
    rows.mechanism.elements.append(element)


def add_spring(rows: Rows, force: Spring, _: JointParts) -> None:
    """Add a linear spring, or one with a force or an energy of its length."""
    mechanism, parts = rows.mechanism, rows.parts
    link = _link(rows, force.points)
    if force.energy is not None:
        own = {rules.LENGTH: Leaf(LEAF_VALUE, mechanism.length(link))}
        mechanism.potentials.append(formula(parts, force.energy, signals=False, own=own))
        add_kinks(rows, force.energy, own)
        return
    free_length = free_length_of(parts, rows.name, force)
    if force.force is not None:
        length = with_symbols(force.force, {LENGTH: ELONGATION + free_length})
        reach = mechanism.default(free_length) or mechanism.default(_drawn_length(parts, link))
        _add_law(rows, length, ELONGATION, LENGTH, mechanism.length(link), free_length, reach)
        return
    assert force.stiffness is not None
    law = sensed(parts, force.stiffness), sensed(parts, free_length)
    _element(rows, Element(mechanism.use(mechanism.length(link)), *law))


def free_length_of(parts: Parts, name: str, spring: Spring) -> Number:
    """Return the free length of a spring, as drawn unless it is given."""
    given = spring.free_length
    return _drawn_length(parts, parts.links[name]) if given is None else given


def _drawn_length(parts: Parts, link: Combination) -> Number:
    drawn = parts.mechanism.drawn(link)
    return sqrt(dot(drawn, drawn))


def _add_law(
    rows: Rows, law: Number, stretch: Expr, measured: Expr, quantity: int, free: Number,
    reach: float,
) -> None:  # fmt: skip
    """Add the energy of a force or torque, a function of the symbol `stretch`.

    That is the quantity, which is called `measured` here, less its `free` value.
    """
    mechanism = rows.mechanism
    energy = energy_of(law, str(stretch), reach, mechanism.defaults)
    leaf = Leaf(LEAF_VALUE, quantity)
    energy = with_symbols(energy, {stretch: measured - free})
    own: dict[str, Meaning] = {str(measured): leaf}
    mechanism.potentials.append(formula(rows.parts, energy, signals=False, own=own))
    # Those of the force, whose energy is smoother by one derivative. Where the free value moves, a
    # half step has them where they are in its middle, and no end of a step would meet them.
    if symbols(free).isdisjoint({"t", *rows.parts.scene.inputs}):
        add_kinks(rows, law, {str(stretch): sensor(leaf) - free})


def add_damper(rows: Rows, force: Damper, _: JointParts) -> None:
    """Add a damper between two places."""
    quantity = rows.mechanism.length(_link(rows, force.points))
    if force.force is not None:
        add_resistance(rows, quantity, rules.LENGTH, force.force, METRES)
        return
    assert force.damping is not None
    damping = sensed(rows.parts, force.damping)
    _element(rows, Element(rows.mechanism.use(quantity), damping=damping))


def add_gravitation(rows: Rows, force: Gravitation, _: JointParts) -> None:
    """Add the attraction of two masses."""
    length = rows.mechanism.leaf(rows.mechanism.length(_link(rows, force.points)))
    product = force.constant * force.masses[0] * force.masses[1]
    energy = -1.0 * product / leaf_symbol(0)
    if isinstance(energy, Expr):  # not so with a constant of 0
        rows.mechanism.potentials.append(Formula(energy, (length,)))


def add_potential(rows: Rows, force: Potential, _: JointParts) -> None:
    """Add an energy."""
    rows.mechanism.potentials.append(formula(rows.parts, force.value, signals=False))
    add_kinks(rows, force.value)


def add_twist(
    rows: Rows, force: TorsionSpring | TorsionDamper | JointTorque, _: JointParts
) -> None:
    """Add a torsional spring or damper, or a torque, about the axis of a joint."""
    parts, angle = rows.parts, rows.parts.joints[force.joint].angle
    assert angle is not None
    rows.mechanism.use(angle)
    match force:
        case TorsionSpring(torque=torque) if torque is not None:
            own = symbol(f"{force.joint}.angle")
            _add_law(rows, torque, ANGLE, own, angle, force.free_angle, pi)
        case TorsionSpring():
            assert force.stiffness is not None
            law = sensed(parts, force.stiffness), sensed(parts, force.free_angle)
            _element(rows, Element(angle, *law))
        case TorsionDamper() if force.torque is not None:
            add_resistance(rows, angle, rules.ANGLE, force.torque, RADIANS)
        case TorsionDamper():
            assert force.damping is not None
            _element(rows, Element(angle, damping=sensed(parts, force.damping)))
        case JointTorque():
            slips = _slips_of_joint(rows, force.joint)
            (drive,), sampled = _value(rows, (force.value,), (slips,), RADIANS)
            _element(rows, Element(angle, drive=drive, sampled=sampled))


def add_load(rows: Rows, force: Force, _: JointParts) -> None:
    """Add a force on a place."""
    mechanism, parts = rows.mechanism, rows.parts
    name, turns = force.point.point or "", force.axes == "body"
    free = force.point.at is not None or turns
    slips = [{} if free else {f"{name}.v{axis}": 1.0} for axis in AXES[: mechanism.dim]]
    value, sampled = _value(rows, force.value, slips, METRES)
    axes = None
    if force.axes == "body":
        frame = parts.frames.get((force.point.point or "").partition(".")[0])
        assert isinstance(frame, RigidFrame)
        axes = frame.directors[0]
    mechanism.loads.append(Load(mechanism.link(parts.place(force.point)), value, axes, sampled))


def add_torque(rows: Rows, force: Torque, _: JointParts) -> None:
    """Add a torque on a body."""
    mechanism, parts = rows.mechanism, rows.parts
    slips = {f"{force.body}.angular_velocity": 1.0} if mechanism.dim == 2 else {}
    given = force.value if isinstance(force.value, tuple) else (force.value,)
    value, sampled = _value(rows, given, [slips] * len(given), RADIANS)
    frame = parts.frames.get(force.body)
    if isinstance(frame, RigidFrame) and mechanism.dim == 3:
        moment = BodyMoment(frame.directors[0], value, force.axes == "body", sampled)
        mechanism.body_moments.append(moment)
        return
    arm = frame.along((1.0, 0.0)) if isinstance(frame, RigidFrame) else parts.links[force.body]
    mechanism.moments.append(Moment(mechanism.form(arm, arm)[0], value, sampled))


def _slips_of_joint(rows: Rows, joint: str) -> dict[str, float]:
    """Names of the rates along which a torque about a joint acts, with its sign."""
    slips = {f"{joint}.angular_velocity": 1.0}
    bodies = getattr(rows.parts.scene.joints[joint], "bodies", (None, None))
    if rows.mechanism.dim == 2 and None in bodies:
        first, second = bodies
        slips[f"{second or first}.angular_velocity"] = 1.0 if first is None else -1.0
    return slips


def _value(
    rows: Rows, value: tuple[Number, ...], slips: Sequence[Mapping[str, float]], scale: Scale
) -> tuple[Vector, str]:  # fmt: skip
    """Return a value with sensors for its quantities, and the name of its force if it has any.

    What rubs, by the sign of a rate along which it acts, becomes friction.

    Components without quantities must be finite at the start; the others are not known before the
    first step, which fails where they are not.
    """
    found = tuple(
        sensed(rows.parts, without_friction(rows, number, own, scale))
        for number, own in zip(value, slips, strict=True)
    )
    known = [x for x in found if not any(name.startswith("#") for name in symbols(x))]
    rows.finite(known, "value")
    return found, rows.title if len(known) < len(found) else ""


FORCES = {
    Spring: add_spring, Damper: add_damper, Gravitation: add_gravitation,
    Potential: add_potential, TorsionSpring: add_twist, TorsionDamper: add_twist,
    JointTorque: add_twist, Force: add_load, Torque: add_torque, Actuator: add_actuator,
}  # fmt: skip
