"""Actuators: the force of a motor within its limits, and what its gear loses (theory 5.9).

    F = n clip(value, +-M),      M = min(M_max, P_max/(n |s'|)),      n = ratio

A gear of efficiency e passes n M e on where it drives, and needs n M/e to hold back: the mean of
both acts, and friction of half their difference holds or takes energy.
"""

from __future__ import annotations

from sys import float_info

from solver.mechanics.force_laws import add_drive
from solver.mechanics.formulas import leaf_symbol, sensed, with_symbols
from solver.mechanics.mechanism import Element, Formula, Friction
from solver.mechanics.parts import ForceLaw, JointParts, Parts
from solver.mechanics.rows import RADIANS, Rows
from solver.runtime.layout import LEAF_RATE
from solver.scene import Actuator, Expr, Number, rules
from solver.scene.expression import operate, select, symbol

RATE, MOTOR_SPEED = symbol(rules.RATE), symbol(rules.MOTOR_SPEED)
"""What values and limits of actuators are written in."""
_LEAST_RATE = 1e-9
"""Rate at and below which the power of an actuator without a largest force is that of this rate
[m/s, rad/s]."""
_LEAST_POWER = 1e-100
"""What counts as no power [W]; its square is a number, as derivatives of quotients need."""
_KEEPS_ON = float_info.min
"""Static coefficient of a gear's friction: nothing, but a friction with neither a coefficient nor a
preload is off until the next event, and a motor may begin at a force of 0."""


def add_actuator(rows: Rows, actuator: Actuator, _: JointParts) -> None:
    """Add a force or torque along what an actuator acts on."""
    parts, mechanism = rows.parts, rows.mechanism
    if actuator.points is not None:
        parts.links[rows.name] = parts.link(actuator.points)
    quantity = mechanism.use(acted_along(parts, rows.name, actuator))
    force = _within_limits(actuator)
    mean, half = _passed_on(actuator)
    if rows.is_known(force):
        rows.finite((force,), "value")
        parts.elements[rows.name] = len(mechanism.elements)
        mechanism.elements.append(Element(quantity, drive=sensed(parts, mean * force)))
        parts.force_laws[rows.name] = ForceLaw(-1.0 * mean * force, {})
    else:
        add_drive(rows, quantity, mean * force)
    if isinstance(half, Expr) or half != 0.0:
        _add_gear_losses(rows, quantity, half * operate("abs", force))


def acted_along(parts: Parts, name: str, actuator: Actuator) -> int:
    """Return the quantity that an actuator acts along: a length, an angle or a displacement."""
    if actuator.points is not None:
        return parts.mechanism.length(parts.links[name])
    found = parts.joints[actuator.joint or actuator.guide or ""]
    quantity = found.angle if actuator.joint is not None else found.displacement
    assert quantity is not None
    return quantity


def _within_limits(actuator: Actuator) -> Number:
    """Return the force or torque before losses of the gear, in ``rate`` and what else it reads."""
    value, limit = actuator.ratio * at_motor(actuator, actuator.value), _limit(actuator)
    if limit is None:
        return value
    return operate("min", operate("max", value, -1.0 * limit), limit)


def limited(actuator: Actuator) -> Number:
    """Return 0 where an actuator is free, 1 at its largest force, 2 at its largest power."""
    size = operate("abs", actuator.ratio * at_motor(actuator, actuator.value))
    strength, power = _strength(actuator), actuator.max_power
    weak = 0.0 if strength is None else operate("gt", size, strength)
    if power is None:
        return weak
    slow = operate("gt", operate("mul", size, operate("abs", RATE)), power)
    if strength is None:
        return 2.0 * slow
    first = operate("gt", operate("mul", strength, operate("abs", RATE)), power)
    return select(slow, select(first, 2.0, 1.0), weak)


def at_motor(actuator: Actuator, number: Number) -> Number:
    """Return a number in ``rate`` in the place of ``motor_speed``."""
    return with_symbols(number, {MOTOR_SPEED: actuator.ratio * RATE})


def _strength(actuator: Actuator) -> Number | None:
    """Return the largest force, or torque behind the gear; None without one."""
    most = actuator.max_force if actuator.joint is None else actuator.max_torque
    if most is None:
        return None
    ratio = operate("abs", actuator.ratio)
    return operate("max", ratio * at_motor(actuator, most), 0.0)


def _limit(actuator: Actuator) -> Number | None:
    """Return the largest force at a rate; None without one.

    Of a largest force F and power P it is F P/max(F |rate|, P), which has a slope at rest, and a
    value where F or P is 0.
    """
    strength, power = _strength(actuator), actuator.max_power
    if power is None:
        return strength
    power, speed = operate("max", power, _LEAST_POWER), operate("abs", RATE)
    if strength is None:
        return operate("div", power, operate("max", speed, _LEAST_RATE))
    return operate("div", strength * power, operate("max", strength * speed, power))


def _passed_on(actuator: Actuator) -> tuple[Number, Number]:
    """Mean and half the difference of what a gear passes on as it holds back and as it drives."""
    e = actuator.efficiency
    return 0.5 * (1.0 / e + e), 0.5 * (1.0 / e - e)


def _add_gear_losses(rows: Rows, quantity: int, size: Number) -> None:
    """Add the friction of a gear, which only a joint's motor has."""
    mechanism = rows.mechanism
    rate = mechanism.leaf(quantity, LEAF_RATE)
    rows.detail = " as its gear rubs"
    row = rows.velocity(Formula(leaf_symbol(0), (rate,)), RADIANS)
    own = {rules.RATE: rate}
    rows.parts.rubbing[rows.name] = len(mechanism.frictions), 1.0
    preload = sensed(rows.parts, size, own)
    mechanism.frictions.append(Friction((row[1],), ((row,),), 0.0, _KEEPS_ON, preload))
