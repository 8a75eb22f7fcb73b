"""Forces: elements along a quantity, loads on places, moments, potentials (theory 5)."""

from __future__ import annotations

from solver.mechanics.combination import Combination
from solver.mechanics.equations import VALUE, BodyMoment, Element, Formula, Leaf, Load, Moment
from solver.mechanics.formulas import Compiler, leaf_symbol
from solver.mechanics.frames import RigidFrame
from solver.mechanics.parts import Parts
from solver.mechanics.vectors import Vector, dot
from solver.scene import (
    Damper,
    Force,
    ForceElement,
    Gravitation,
    JointTorque,
    Number,
    Potential,
    Spring,
    Torque,
    TorsionDamper,
    TorsionSpring,
    symbols,
)
from solver.scene.expression import sqrt

Part = tuple[str, str]


def add_force(parts: Parts, compiler: Compiler, name: str, force: ForceElement) -> None:
    """Add a force of any kind."""
    part = (f"forces.{name}", f"force '{name}'")
    match force:
        case Spring(energy=None):
            _spring(parts, compiler, name, force, part)
        case Spring():
            link = _link(parts, name, force.points)
            own = {"length": Leaf(VALUE, parts.mechanism.length(link))}
            assert force.energy is not None
            formula = compiler.formula(force.energy, signals=False, own=own)
            parts.mechanism.potentials.append(formula)
        case Damper():
            parts.mechanism.rule(force.damping, ">=", part, "damping must be >= 0 N.s/m")
            quantity = parts.mechanism.length(_link(parts, name, force.points))
            damping = compiler.sensed(force.damping)
            _element(parts, name, Element(parts.mechanism.use(quantity), damping=damping))
        case Gravitation():
            _gravitation(parts, name, force, part)
        case Potential():
            parts.mechanism.potentials.append(compiler.formula(force.value, signals=False))
        case TorsionSpring() | TorsionDamper() | JointTorque():
            _twist(parts, compiler, name, force, part)
        case Force():
            _load(parts, compiler, force, part)
        case Torque():
            _torque(parts, compiler, force, part)


def _link(parts: Parts, name: str, ends) -> Combination:
    parts.links[name] = parts.link(ends)
    return parts.links[name]


def _element(parts: Parts, name: str, element: Element) -> None:
    parts.elements[name] = len(parts.mechanism.elements)
    parts.mechanism.elements.append(element)


def _spring(parts: Parts, compiler: Compiler, name: str, force: Spring, part: Part) -> None:
    mechanism = parts.mechanism
    link = _link(parts, name, force.points)
    free_length = force.free_length
    if free_length is None:
        drawn = mechanism.drawn(link)
        free_length = sqrt(dot(drawn, drawn))
    assert force.stiffness is not None
    mechanism.rule(force.stiffness, ">=", part, "stiffness must be >= 0 N/m")
    mechanism.rule(free_length, ">=", part, "free_length must be >= 0 m")
    stiffness, rest = compiler.sensed(force.stiffness), compiler.sensed(free_length)
    _element(parts, name, Element(mechanism.use(mechanism.length(link)), stiffness, rest))


def _gravitation(parts: Parts, name: str, force: Gravitation, part: Part) -> None:
    mechanism = parts.mechanism
    for mass in force.masses:
        mechanism.rule(mass, ">=", part, "masses must be >= 0 kg")
    length = Leaf(VALUE, mechanism.use(mechanism.length(_link(parts, name, force.points))))
    product = force.constant * force.masses[0] * force.masses[1]
    mechanism.potentials.append(Formula(-1.0 * product / leaf_symbol(0), (length,)))


def _twist(
    parts: Parts, compiler: Compiler, name: str, force: TorsionSpring | TorsionDamper | JointTorque,
    part: Part,
) -> None:  # fmt: skip
    mechanism = parts.mechanism
    angle = parts.joints[force.joint].angle
    if angle is None:
        parts.problems.append((f"{part[0]}.joint", f"joint '{force.joint}' has no angle"))
        return
    mechanism.use(angle)
    if isinstance(force, TorsionSpring):
        mechanism.rule(force.stiffness, ">=", part, "stiffness must be >= 0 N.m/rad")
        numbers = (compiler.sensed(force.stiffness), compiler.sensed(force.free_angle))
        _element(parts, name, Element(angle, *numbers))
    elif isinstance(force, TorsionDamper):
        mechanism.rule(force.damping, ">=", part, "damping must be >= 0 N.m.s/rad")
        _element(parts, name, Element(angle, damping=compiler.sensed(force.damping)))
    else:
        (drive,), sampled = _value(parts, compiler, (force.value,), part)
        _element(parts, name, Element(angle, drive=drive, sampled=sampled))


def _load(parts: Parts, compiler: Compiler, force: Force, part: Part) -> None:
    mechanism = parts.mechanism
    value, sampled = _value(parts, compiler, force.value, part)
    axes = None
    if force.axes == "body":
        body = (force.point.point or "").partition(".")[0]
        frame = parts.frames.get(body)
        if not isinstance(frame, RigidFrame):
            text = "axes = 'body' needs a place on a rigid body, whose axes they are"
            parts.problems.append((f"{part[0]}.axes", text))
            return
        axes = frame.directors[0]
    mechanism.loads.append(Load(mechanism.link(parts.place(force.point)), value, axes, sampled))


def _torque(parts: Parts, compiler: Compiler, force: Torque, part: Part) -> None:
    mechanism = parts.mechanism
    number = force.value if isinstance(force.value, tuple) else (force.value,)
    value, sampled = _value(parts, compiler, number, part)
    frame = parts.frames.get(force.body)
    in_body = force.axes == "body" and mechanism.dim == 3
    if isinstance(frame, RigidFrame) and mechanism.dim == 3:
        mechanism.body_moments.append(BodyMoment(frame.directors[0], value, in_body, sampled))
        return
    if in_body:
        text = "a bar between two points has no axes of its own: give the torque in global axes"
        parts.problems.append((f"{part[0]}.axes", text))
    arm = frame.along((1.0, 0.0)) if isinstance(frame, RigidFrame) else parts.links[force.body]
    mechanism.moments.append(Moment(mechanism.form(arm, arm)[0], value, sampled))


def _value(
    parts: Parts, compiler: Compiler, value: tuple[Number, ...], part: Part
) -> tuple[Vector, str]:
    """Return a value with sensors for its quantities, and the name of its force if it has any.

    Components without quantities must be finite at the start; the others are not known before the
    first step, which fails where they are not.
    """
    sensed = tuple(compiler.sensed(number) for number in value)
    known = [x for x in sensed if not any(name.startswith("#") for name in symbols(x))]
    parts.mechanism.finite(tuple(known), part, "value")
    return sensed, part[1] if len(known) < len(sensed) else ""
