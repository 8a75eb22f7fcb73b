"""Results of a step: reactions of joints, forces and powers, measured or as expressions.

Forces and torques are those on the second body of a joint, on the point, or on the disc; in springs
and dampers positive in tension, in their torsional kin positive against the angle.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import pi

from solver.mechanics.derivative import derivative
from solver.mechanics.formulas import rewritten
from solver.mechanics.sensors import Measures, Named, Ref, Values, components, references
from solver.mechanics.vectors import add, dot, scale
from solver.scene import (
    BodyJoint,
    ConstantAngle,
    Distance,
    Driver,
    Expr,
    ForceElement,
    Gear,
    Gravitation,
    Joint,
    JointDriver,
    JointTorque,
    Number,
    PointOn,
    PositionDriver,
    Potential,
    Rack,
    Spring,
    TorsionDamper,
    TorsionSpring,
)
from solver.scene.expression import symbol

# -------------------------------------------------------------------------------------- joints


def reaction(measures: Measures, name: str, joint: Joint) -> Iterator[Named]:
    """Reaction of a joint."""
    found = measures.parts.joints[name]
    if isinstance(joint, Distance):
        assert found.row is not None
        text = f"force in joint '{name}', positive in tension: it pulls its points together"
        yield Named(f"{name}.force", "N", text, Ref("rod_force", found.row[1]))
    elif isinstance(joint, ConstantAngle | Gear | Rack):
        if found.row is not None:
            value = -1.0 * found.factor * measures.multiplier(found.row)
            word, unit = ("force", "N") if isinstance(joint, Rack) else ("torque", "N.m")
            text = f"{word} of {name} on the motion of its second part"
            yield Named(f"{name}.{word}", unit, text, value)
    elif isinstance(joint, BodyJoint):
        yield from _of_bodies(measures, name, joint)
    else:
        values: Values = measures.pushed(found)
        if found.reaction is not None and not found.pushes:
            values = references("reaction_force", found.reaction, measures.parts.mechanism.dim)
        on = "the point" if isinstance(joint, PointOn) else "the disc"
        yield from components(f"{name}.force.", "N", f"force of {name} on {on}", values)


def _of_bodies(measures: Measures, name: str, joint: BodyJoint) -> Iterator[Named]:
    mechanism, found = measures.parts.mechanism, measures.parts.joints[name]
    assert found.reaction is not None
    force: Values = references("reaction_force", found.reaction, mechanism.dim)
    turning = 1 if mechanism.dim == 2 else 3
    torque: Values = references("reaction_torque", found.reaction, turning)
    if joint.type == "screw":
        # The row s - p/(2 pi) theta pushes along the axis and turns about it.
        assert found.row is not None
        assert found.axis is not None
        assert joint.pitch is not None
        axis, mu = measures.vector(found.axis), measures.multiplier(found.row)
        lead = joint.pitch / (2.0 * pi)
        force = add([measures.value(ref) for ref in force], scale(-1.0 * mu, axis))
        torque = add([measures.value(ref) for ref in torque], scale(mu * lead, axis))
    yield from components(f"{name}.force.", "N", f"force of {name} on its second body", force)
    kinds = {"spherical"} | ({"revolute"} if mechanism.dim == 2 else set())
    if joint.bodies is not None and joint.type not in kinds:
        text = f"torque of {name} on its second body, about the joint's place"
        yield from components(f"{name}.torque.", "N.m", text, torque)


# -------------------------------------------------------------------------------------- forces


def of_a_force(measures: Measures, name: str, force: ForceElement) -> Iterator[Named]:
    """Length and force, torque or energy of a force."""
    parts = measures.parts
    if name in parts.links:
        length = Ref("quantity", parts.mechanism.length(parts.links[name]))
        yield Named(f"{name}.length", "m", f"length of {name}", length)
        text = f"force in {name}, positive in tension: it pulls its ends together"
        yield Named(f"{name}.force", "N", text, _tension(measures, name, force, length))
    elif isinstance(force, TorsionSpring | TorsionDamper) and name in parts.elements:
        text = f"torque of {name}, positive against the angle of {force.joint}: it turns it back"
        value = Ref("element_force", parts.elements[name])
        yield Named(f"{name}.torque", "N.m", text, value)
    elif isinstance(force, JointTorque) and name in parts.elements:
        text = f"torque of {name}, positive along the angle of {force.joint}"
        value = -1.0 * measures.value(Ref("element_force", parts.elements[name]))
        yield Named(f"{name}.torque", "N.m", text, value)
    elif isinstance(force, Potential):
        yield Named(f"{name}.energy", "J", f"energy of {name}", force.value)


def _tension(
    measures: Measures, name: str, force: ForceElement, length: Ref
) -> Ref | Number:  # fmt: skip
    """Return dV/dl of a spring with an energy and of gravitation, else what is measured."""
    if isinstance(force, Gravitation):
        value = measures.value(length)
        return force.constant * force.masses[0] * force.masses[1] / (value * value)
    if not isinstance(force, Spring) or force.energy is None:
        return Ref("element_force", measures.parts.elements[name])

    def seen(part: Expr) -> Number | None:
        if part.op != "symbol":
            return None
        return measures.value(length) if part == symbol("length") else part

    return rewritten(derivative(force.energy, "length"), seen)


# ------------------------------------------------------------------------------------- drivers


def of_a_driver(measures: Measures, name: str, driver: Driver) -> Iterator[Named]:
    """Force or torque of a driver, and its power."""
    parts = measures.parts
    if isinstance(driver, PositionDriver):
        yield from _of_a_path(measures, name, driver)
        return
    found = parts.joints[name]
    if found.row is None:
        return
    torque = isinstance(driver, JointDriver) and driver.type == "angle"
    word, unit = ("torque", "N.m") if torque else ("force", "N")
    value = -1.0 * measures.multiplier(found.row)
    what = "distance" if not isinstance(driver, JointDriver) else driver.type
    text = f"{word} of {name}, positive along its {what}"
    yield Named(f"{name}.{word}", unit, text, value)
    rate = measures.value(Ref("quantity_rate", parts.driven[name]))
    yield Named(f"{name}.power", "W", f"power of {name}", value * rate)


def _of_a_path(measures: Measures, name: str, driver: PositionDriver) -> Iterator[Named]:
    parts = measures.parts
    place = parts.place(driver.point)
    path = parts.paths.get(driver.point.point or "")
    force: Values = measures.pushed(parts.joints[name])
    if path is not None:
        assert place.single is not None
        force = references("driven_force", place.single, parts.mechanism.dim)
    yield from components(
        f"{name}.force.", "N", f"force of {name} on the point that it moves", force
    )
    velocity = measures.motion(place)[1]
    f, v = (
        [measures.value(x) if isinstance(x, Ref) else x for x in values]
        for values in (force, velocity)
    )
    yield Named(f"{name}.power", "W", f"power of {name}", dot(f, v))
