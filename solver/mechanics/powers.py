"""Power of each force, and of the friction of each joint: what it gives to the mechanism.

Of a force along a quantity sigma it is F dsigma/dt, of one on a place F . v, of a torque on a body
T . omega, of an energy -dV/dt. Forces are those of the state, as their formulas tell them.
"""

from __future__ import annotations

from solver.mechanics.derivative import derivative
from solver.mechanics.formulas import formula, leaf_symbol, with_symbols
from solver.mechanics.instruments import axes_of, spin
from solver.mechanics.sensors import Ref, Sensors
from solver.mechanics.vectors import Vector, cross, dot
from solver.scene import Force, Number, Part, Potential, Torque


def power_along(sensors: Sensors, force: Number, quantity: int) -> Number:
    """Return the power of a force or torque along a quantity."""
    return force * sensors.value(Ref("quantity_rate", quantity))


def power_of_a_potential(sensors: Sensors, potential: Potential) -> Number:
    """Return -dV/dt."""
    found = formula(sensors.parts, potential.value, signals=False)
    seen = {
        leaf_symbol(k): sensors.value(Ref("quantity", leaf.index))
        for k, leaf in enumerate(found.leaves)
    }
    total: Number = 0.0
    for k, leaf in enumerate(found.leaves):
        slope = with_symbols(derivative(found.value, str(leaf_symbol(k))), seen)
        total = total + power_along(sensors, slope, leaf.index)
    return -1.0 * total


def power_of_a_load(sensors: Sensors, force: Part) -> Number:
    """Return the power of a force on a place, or of a torque on a body."""
    if isinstance(force, Force):
        body = (force.point.point or "").partition(".")[0]
        value, rate = force.value, sensors.velocity(sensors.parts.place(force.point))
    else:
        assert isinstance(force, Torque)
        body = force.body
        value = force.value if isinstance(force.value, tuple) else (force.value,)
        in_axes = body in sensors.parts.frames
        rate = spin(sensors, body) if in_axes else _spin_of_a_bar(sensors, body)
    if force.axes == "body" and len(rate) > 1:
        rate = tuple(dot(axis, rate) for axis in axes_of(sensors, body))
    return dot(value, rate)


def _spin_of_a_bar(sensors: Sensors, bar: str) -> Vector:
    """Return the angular velocity of a bar in space, which does not turn about itself."""
    link = sensors.parts.links[bar]
    x, v = sensors.vector(link), sensors.velocity(link)
    return tuple(c / dot(x, x) for c in cross(x, v))
