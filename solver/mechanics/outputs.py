"""What is measured of a mechanism, under the names and in the order in which a user finds it.

The classes of the scene declare names, units and texts. Most values are numbers that the kernel
measures. What it does not - the torque and power of a driver, the force that belongs to a formula -
is an expression over those.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import partial, reduce
from itertools import count
from math import pi
from typing import Any, TypeAlias

from solver.mechanics.actuators import RATE, acted_along, limited
from solver.mechanics.combination import Combination
from solver.mechanics.contacts import distance_left
from solver.mechanics.derivative import derivative
from solver.mechanics.forces import ANGLE, ELONGATION, LENGTH, free_length_of
from solver.mechanics.formulas import leaf_symbol, with_symbols
from solver.mechanics.frames import RigidFrame
from solver.mechanics.instruments import of_a_sensor
from solver.mechanics.parts import JointParts
from solver.mechanics.powers import power_along, power_of_a_load, power_of_a_potential
from solver.mechanics.sensors import Named, Ref, Sensors, Values, references
from solver.mechanics.vectors import add, dot, scale
from solver.runtime.layout import LEAF_RATE, LEAF_VALUE
from solver.scene import (
    Actuator,
    BodyJoint,
    ClearanceContact,
    Constraint,
    Distance,
    Expr,
    Force,
    Gear,
    Gravitation,
    JointTorque,
    JournalContact,
    Number,
    Part,
    PositionDriver,
    Potential,
    Rigid,
    Screw,
    Spring,
    Stop,
    Torque,
    TorsionDamper,
    TorsionSpring,
)
from solver.scene.expression import operate, select, symbol
from solver.scene.joint_springs import FIELD_OF, SPRING_ALONG
from solver.scene.quantities import (
    CONTACT,
    FRICTION,
    MOTION,
    WHOLE,
    WHOLE_OF_CONTACTS,
    Offer,
    turning,
)

Found: TypeAlias = Mapping[str, "Ref | Number | Values | Callable[[], Ref | Number | Values]"]
"""Value of each quantity of a part, by its word; components as a list; what is measured on demand
is made on demand."""


SECTIONS = {"constraint": "residual"}
"""Measurements of quantities of the whole, where these are not called the same."""
FORCE, MODE = ([offer.word for offer in CONTACT].index(word) for word in ("force", "mode"))
SLIP = [offer.word for offer in FRICTION].index("slip")
SECTIONS_OF_CONTACTS = {"energy": "loss", "solver": "contact_solver"}


def named(sensors: Sensors) -> Iterator[Named]:
    """Everything of a mechanism that has a name."""
    parts, scene = sensors.parts, sensors.parts.scene
    for name in scene.points:
        yield from _motion(sensors, name, parts.named(name))
    for name, body in scene.bodies.items():
        if isinstance(body, Rigid):
            yield from _motion(sensors, name, parts.named(name))
        yield from _named(sensors, name, body, body.offers, _turn(sensors, name))
        frame = parts.frames.get(name)
        for point in frame.points if isinstance(frame, RigidFrame) else ():
            yield from _motion(sensors, f"{name}.{point}", parts.named(f"{name}.{point}"))
    for table, values_of in _VALUES.items():
        for name, part in getattr(scene, table).items():
            offers = part.offered(part.given())
            if isinstance(part, BodyJoint) and part.springs_along:
                others = (offer for offer in offers if offer.word not in FIELD_OF)
                offers = (*others, *SPRING_ALONG)  # those without a value are left out
            values = values_of(sensors, name, part) if offers else {}
            yield from _named(sensors, name, part, offers, values)
    for name, contact in scene.contacts.items():
        offers = contact.offered(contact.given())
        if isinstance(contact, Stop) and contact.turns:
            offers = turning(offers)
        yield from _named(sensors, name, contact, offers, _of_a_contact(sensors, name, contact))
    mechanism = parts.mechanism
    of_contacts = WHOLE_OF_CONTACTS if mechanism.contacts or mechanism.frictions else {}
    for whole, sections in ((WHOLE, SECTIONS), (of_contacts, SECTIONS_OF_CONTACTS)):
        for name, offers in whole.items():
            section, k = sections.get(name, name), count()
            for offer in offers:
                for full, text in offer.named(name, scene.dimension):
                    yield Named(full, offer.unit, text, Ref(section, next(k)))


def _named(
    sensors: Sensors, name: str, part: Any, offers: Iterable[Offer], values: Found,
    listed: bool = True,
) -> Iterator[Named]:  # fmt: skip
    """Name the values of a part."""
    asks = name in sensors.asked_of
    for offer in offers:
        value = values.get(offer.word)
        if value is None or (offer.on_demand and not asks):
            continue
        names = [*offer.named(name, sensors.parts.scene.dimension, part)]
        if offer.on_demand and sensors.asked.isdisjoint(full for full, _ in names):
            continue
        value = value() if callable(value) else value
        components = (value,) if isinstance(value, (Ref, float, int, Expr)) else value
        for (full, text), meaning in zip(names, components, strict=False):
            if not offer.on_demand or full in sensors.asked:
                yield Named(full, offer.unit, text, meaning, listed)


def _motion(sensors: Sensors, name: str, place: Combination) -> Iterator[Named]:
    """Position, velocity and acceleration of a place."""
    x, v = sensors.motion(place)
    listed = sensors.parts.mechanism.moves(place)
    values: Found = {"{}": x, "v{}": v, "a{}": lambda: sensors.acceleration(place)}
    yield from _named(sensors, name, None, MOTION, values, listed)


def _turn(sensors: Sensors, name: str) -> Found:
    parts, mechanism = sensors.parts, sensors.parts.mechanism
    frame = parts.frames.get(name)
    if mechanism.dim == 2:
        return _of_angle(sensors, parts.body_angle(name))
    if not isinstance(frame, RigidFrame):
        return {}
    body = mechanism.bodies[frame.directors[0]]
    return {
        "q{}": references("quaternion", body, 4),
        "w{}": references("body_rate", body, 3),
        "wd{}": lambda: sensors.accelerations("body_acceleration", body, 3),
    }


def _of_angle(sensors: Sensors, quantity: int) -> dict[str, Any]:
    return _of_quantity(sensors, quantity, "angle", "angular_velocity", "angular_acceleration")


def _of_quantity(sensors: Sensors, quantity: int, *words: str) -> dict[str, Any]:
    """Return a quantity, its rate and its second derivative, by their words."""
    word, rate, acceleration = words
    return {
        word: Ref("quantity", quantity),
        rate: Ref("quantity_rate", quantity),
        acceleration: lambda: sensors.accelerations("quantity_acceleration", quantity, 1),
    }


# -------------------------------------------------------------------------------------- joints


def _of_a_joint(sensors: Sensors, name: str, joint: Part) -> Found:
    """Motion of a joint, and its reaction."""
    found = sensors.parts.joints[name]
    values = _reaction(sensors, joint, found)
    if found.angle is not None:
        values |= _of_angle(sensors, found.angle)
    if found.displacement is not None:
        words = "displacement", "velocity", "acceleration"
        values |= _of_quantity(sensors, found.displacement, *words)
    if found.friction is not None:
        words = "friction", "slip", "friction_mode"
        force, slip, mode = (Ref("friction", found.friction, k) for k in range(3))
        values |= dict(zip(words, (force, slip, mode), strict=True))
        values["power"] = lambda: -1.0 * _size(sensors, force) * _size(sensors, slip)
    for word, element in (("spring", found.spring), ("damper", found.damper)):
        if element is not None:
            values[word] = Ref("element_force", element)
    if isinstance(joint, Gear) and joint.backlash is not None:
        values |= _of_a_contact(sensors, name, joint)
        pushes = [sensors.value(Ref("contact", k, FORCE)) for k in sensors.parts.contacts[name]]
        values["torque"] = pushes[0] - pushes[1]
    return values


def _size(sensors: Sensors, ref: Ref) -> Number:
    return operate("abs", sensors.value(ref))


def _reaction(sensors: Sensors, joint: Part, found: JointParts) -> dict[str, Any]:
    """Force and torque on the second body, the point or the disc, or on what a row couples."""
    mechanism = sensors.parts.mechanism
    if isinstance(joint, Distance):
        assert found.row is not None
        return {"force": Ref("rod_force", found.row[1])}
    if isinstance(joint, Gear) and joint.backlash is not None:
        return {}
    if joint.has("force") or joint.has("torque"):
        assert found.row is not None
        return dict.fromkeys(
            ("force", "torque"), -1.0 * found.factor * sensors.multiplier(found.row)
        )
    if found.reaction is None or found.pushes:
        return {"force.{}": sensors.pushed(found)}
    force: Values = references("reaction_force", found.reaction, mechanism.dim)
    if not isinstance(joint, BodyJoint):
        return {"force.{}": force}
    torque: Values = references("reaction_torque", found.reaction, 1 if mechanism.dim == 2 else 3)
    if isinstance(joint, Screw):
        # The row s - p/(2 pi) theta pushes along the axis and turns about it.
        assert found.row is not None
        assert found.axis is not None
        axis, mu = sensors.vector(found.axis), sensors.multiplier(found.row)
        lead = joint.pitch / (2.0 * pi)
        force = add([sensors.value(ref) for ref in force], scale(-1.0 * mu, axis))
        torque = add([sensors.value(ref) for ref in torque], scale(mu * lead, axis))
    return {"force.{}": force, "torque.{}": torque}


def _of_a_constraint(sensors: Sensors, name: str, _: Constraint) -> Found:
    row = sensors.parts.joints[name].row
    assert row is not None
    return {"multiplier": sensors.ref(row)}


# -------------------------------------------------------------------------------------- forces


def _of_a_force(sensors: Sensors, name: str, force: Part) -> Found:
    """Length and force, torque or energy of a force."""
    parts = sensors.parts
    if isinstance(force, Actuator):
        return _of_an_actuator(sensors, name, force)
    if name in parts.links:
        line = parts.mechanism.length(parts.links[name])
        length = Ref("quantity", line)
        tension = _tension(sensors, name, force, length)
        pull = sensors.value(tension) if isinstance(tension, Ref) else tension
        power = partial(power_along, sensors, -1.0 * pull, line)
        return {"length": length, "force": tension, "power": power}
    if isinstance(force, Potential):
        return {"energy": force.value, "power": partial(power_of_a_potential, sensors, force)}
    if isinstance(force, (Force, Torque)):
        return {"power": partial(power_of_a_load, sensors, force)}
    assert isinstance(force, (TorsionSpring, TorsionDamper, JointTorque))
    angle = parts.joints[force.joint].angle
    assert angle is not None
    if isinstance(force, TorsionSpring) and force.torque is not None:
        turned = sensors.value(Ref("quantity", angle)) - force.free_angle
        torque = with_symbols(force.torque, {ANGLE: turned})
        return {"torque": torque, "power": partial(power_along, sensors, -1.0 * torque, angle)}
    if name in parts.force_laws:
        torque = _of_law(sensors, name)
        return {"torque": torque, "power": partial(power_along, sensors, -1.0 * torque, angle)}
    torque = Ref("element_force", parts.elements[name])
    if not isinstance(force, JointTorque):
        power = partial(power_along, sensors, -1.0 * sensors.value(torque), angle)
        return {"torque": torque, "power": power}
    rubs, sign = parts.rubbing.get(name, (None, 0.0))
    friction = 0.0 if rubs is None else sign * sensors.value(Ref("friction", rubs, 0))
    value = friction - sensors.value(torque)
    return {"torque": value, "power": partial(power_along, sensors, value, angle)}


def _of_law(sensors: Sensors, name: str) -> Number:
    """Return a force with a law of its own, positive where it draws its quantity together."""
    law, own = sensors.parts.force_laws[name]
    kinds = {LEAF_VALUE: "quantity", LEAF_RATE: "quantity_rate"}
    seen = {symbol(x): sensors.value(Ref(kinds[y.kind], y.index)) for x, y in own.items()}
    rubs, sign = sensors.parts.rubbing.get(name, (None, 0.0))
    force = with_symbols(law, seen)
    return force if rubs is None else force - sign * sensors.value(Ref("friction", rubs, 0))


def _of_an_actuator(sensors: Sensors, name: str, actuator: Actuator) -> Found:
    """Force or torque along what it acts on, its power, and which limit it is at."""
    quantity = acted_along(sensors.parts, name, actuator)
    rate = sensors.value(Ref("quantity_rate", quantity))
    force = -1.0 * _of_law(sensors, name)
    return {
        "length": Ref("quantity", quantity),
        "force": force,
        "torque": force,
        "motor_speed": actuator.ratio * rate,
        "power": partial(power_along, sensors, force, quantity),
        "limited": with_symbols(limited(actuator), {RATE: rate}),
    }


def _tension(
    sensors: Sensors, name: str, force: Part, length: Ref
) -> Ref | Number:  # fmt: skip
    """Return the force of a law, dV/dl of an energy and of gravitation, or what is measured."""
    if isinstance(force, Gravitation):
        value = sensors.value(length)
        return force.constant * force.masses[0] * force.masses[1] / (value * value)
    if name in sensors.parts.force_laws:
        return _of_law(sensors, name)
    if not isinstance(force, Spring) or force.stiffness is not None:
        return Ref("element_force", sensors.parts.elements[name])
    value = sensors.value(length)
    if force.force is not None:
        stretch = value - free_length_of(sensors.parts, name, force)
        return with_symbols(force.force, {LENGTH: value, ELONGATION: stretch})
    assert force.energy is not None
    return with_symbols(derivative(force.energy, str(LENGTH)), {LENGTH: value})


# ------------------------------------------------------------------------------------ contacts


def _of_a_contact(sensors: Sensors, name: str, contact: Part) -> Found:
    """State of a contact, and the friction in it.

    Of a stop with two ends, a journal or a body with corners the gap is the least one; force,
    impacts and impulses are the sums, and so are friction forces, in space those of their sizes.
    """
    if name in sensors.parts.compliant:
        return _of_a_compliant_contact(sensors, name)
    contacts = sensors.parts.contacts[name]
    words = [offer.word for offer in CONTACT]
    values: dict[str, Any] = {
        word: _joined(sensors, word, [Ref("contact", index, k) for index in contacts])
        for k, word in enumerate(words)
    }
    if isinstance(contact, (ClearanceContact, JournalContact)):
        gaps = [sensors.value(Ref("contact", index, 0)) for index in contacts]
        holes = 1 if isinstance(contact, ClearanceContact) else 2
        plays = [distance_left(gap, contact.radius) for gap in gaps[:holes]]
        values["gap"] = reduce(lambda x, y: _both("gap", x, y), [*plays, *gaps[holes:]])
    frictions = [sensors.parts.mechanism.contacts[index].friction for index in contacts]
    frictions = [friction for friction in frictions if friction >= 0]
    if frictions:
        for k, offer in enumerate(FRICTION):
            refs = [Ref("friction", friction, k) for friction in frictions]
            values[offer.word] = _joined(sensors, offer.word, refs)
        if len(frictions) > 1:
            values["slip"] = _largest_slip(sensors, contacts, frictions)
    return values


def _of_a_compliant_contact(sensors: Sensors, name: str) -> Found:
    """Gap and force; of a stop with two ends the gap to the nearer one, and the force of both."""
    gaps: list[Number] = []
    force: Number = 0.0
    for found in sensors.parts.compliant[name]:
        seen = {leaf_symbol(0): sensors.value(Ref("quantity", found.quantity))}
        rate = sensors.value(Ref("quantity_rate", found.quantity))
        gaps.append(with_symbols(found.gap, seen))
        # Where it is pressed in, depth and gap have opposite rates.
        speed = -1.0 * with_symbols(derivative(found.gap, "#0"), seen) * rate
        share = operate("max", 1.0 + found.damping * speed, 0.0)
        force = force + with_symbols(found.force, seen) * share
    gap = gaps[0] if len(gaps) == 1 else operate("min", *gaps)
    return {"gap": gap, "force": force}


def _largest_slip(sensors: Sensors, contacts: list[int], frictions: list[int]) -> Number:
    """Return the slip of the closed corner that slips most."""
    largest: Number = 0.0
    for index, friction in zip(contacts, frictions, strict=False):  # stops do not rub
        mode = sensors.value(Ref("contact", index, MODE))
        slip = select(mode, sensors.value(Ref("friction", friction, SLIP)), 0.0)
        larger = operate("gt", operate("abs", slip), operate("abs", largest))
        largest = select(larger, slip, largest)
    return largest


def _joined(sensors: Sensors, word: str, refs: list[Ref]) -> Ref | Number:
    """Return a quantity of one contact, or of several that have one name."""
    if len(refs) == 1:
        return refs[0]
    total, *others = map(sensors.value, refs)
    for other in others:
        total = _both(word, total, other)
    return total


def _both(word: str, first: Number, second: Number) -> Number:
    if word in ("gap", "mode"):
        return operate("min" if word == "gap" else "max", first, second)
    return first + second


# ------------------------------------------------------------------------------------- drivers


def _of_a_driver(sensors: Sensors, name: str, driver: Part) -> Found:
    """Force or torque of a driver, and its power."""
    parts = sensors.parts
    if not isinstance(driver, PositionDriver):
        found = parts.joints[name]
        assert found.row is not None
        assert found.driven is not None
        value = -1.0 * sensors.multiplier(found.row)
        rate = sensors.value(Ref("quantity_rate", found.driven))
        return {"force": value, "torque": value, "power": value * rate}
    place = parts.place(driver.point)
    force: Values = sensors.pushed(parts.joints[name])
    if (driver.point.point or "") in parts.paths:
        assert place.single is not None
        force = references("driven_force", place.single, parts.mechanism.dim)
    velocity = sensors.motion(place)[1]
    f, v = (
        [sensors.value(x) if isinstance(x, Ref) else x for x in values]
        for values in (force, velocity)
    )
    return {"force.{}": force, "power": dot(f, v)}


_VALUES: dict[str, Callable[[Sensors, str, Any], Found]] = {
    "joints": _of_a_joint,
    "constraints": _of_a_constraint,
    "forces": _of_a_force,
    "drivers": _of_a_driver,
    "sensors": of_a_sensor,
}
"""Values of the parts of each table."""
