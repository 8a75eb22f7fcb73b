"""Values of the sensors of a scene, as expressions over what the kernel measures.

An axis e_k of a body turns with its angular velocity omega, de_k/dt = omega x e_k, so that

    f_k = e_k . (a - g)                                      specific force of an IMU
    x_k = e_k . r,    dx_k/dt = e_k . (v - omega x r)        r from the first to the second place
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from solver.mechanics.combination import Combination, node
from solver.mechanics.frames import BarFrame, Ground
from solver.mechanics.sensors import Ref, Sensors, references
from solver.mechanics.vectors import Vector, add, cross, dot, identity, scale, subtract, turned
from solver.scene import Imu, Number, Part, Relative
from solver.scene.expression import operate, select, sqrt
from solver.scene.sensors import GLOBAL

Found = Mapping[str, Any]


def of_a_sensor(sensors: Sensors, _: str, sensor: Part) -> Found:
    """Return the values of a sensor, by their words."""
    if isinstance(sensor, Imu):
        return _of_an_imu(sensors, sensor)
    assert isinstance(sensor, Relative)
    return _of_two(sensors, sensor)


def _of_an_imu(sensors: Sensors, imu: Imu) -> Found:
    parts = sensors.parts
    planar = parts.mechanism.dim == 2
    body = (imu.body.point or "").partition(".")[0]
    axes = axes_of(sensors, body)
    if isinstance(imu.orientation, tuple):
        axes = _combined(axes, imu.orientation)
    elif imu.orientation is not None:
        c, s = operate("cos", imu.orientation), operate("sin", imu.orientation)
        axes = _combined(axes, ((c, -1.0 * s), (s, c)))
    a = sensors.numbers(sensors.acceleration(parts.place(imu.body)))
    force = subtract(a, parts.scene.gravity)
    turn = spin(sensors, body)
    found: dict[str, Any] = {"f{}": tuple(dot(axis, force) for axis in axes)}
    if planar:
        return found | {"w": turn[0]}
    return found | {"w{}": tuple(dot(axis, turn) for axis in axes)}


def _combined(axes: tuple[Vector, ...], matrix: tuple[Vector, ...]) -> tuple[Vector, ...]:
    """Return the axes with the columns of a matrix as components in some axes."""
    found = []
    for column in zip(*matrix, strict=True):
        total: Vector = (0.0,) * len(axes)
        for x, axis in zip(column, axes, strict=True):
            total = add(total, scale(x, axis))
        found.append(total)
    return tuple(found)


def _of_two(sensors: Sensors, sensor: Relative) -> Found:
    """Place of the second from the first, its rate in the axes that are asked for, and turns."""
    parts = sensors.parts
    own = None if sensor.axes == GLOBAL else sensor.axes
    axes, turning = axes_of(sensors, own), spin(sensors, own)
    if sensor.points is not None:
        first, second = (parts.place(end) for end in sensor.points)
    else:
        assert sensor.bodies is not None
        first, second = (_origin(sensors, body) for body in sensor.bodies)
    x, v = (sensors.numbers(values) for values in sensors.motion(second - first))
    seen = subtract(v, _swept(turning, x))
    found: dict[str, Any] = {
        "{}": tuple(dot(axis, x) for axis in axes),
        "v{}": tuple(dot(axis, seen) for axis in axes),
        "distance": sqrt(dot(x, x)),
    }
    if sensor.bodies is None:
        return found
    turn = subtract(*(spin(sensors, body) for body in reversed(sensor.bodies)))
    if parts.mechanism.dim == 2:
        angles = [_angle(sensors, body) for body in sensor.bodies]
        return found | {"angle": angles[1] - angles[0], "angular_velocity": turn[0]}
    angle, psi = _rotation_vector(sensors, sensor.bodies)
    return found | {
        "angle": angle,
        "psi_{}": tuple(dot(axis, psi) for axis in axes),
        "w{}": tuple(dot(axis, turn) for axis in axes),
    }


def _swept(turning: Vector, x: Vector) -> Vector:
    """Return omega x r."""
    return scale(turning[0], turned(x)) if len(x) == 2 else cross(turning, x)


def _origin(sensors: Sensors, body: str | None) -> Combination:
    frame = sensors.parts.frame(body)
    zero = (0.0,) * sensors.parts.mechanism.dim
    if isinstance(frame, Ground):
        return frame.place(zero)
    return node(frame.ends[0]) if isinstance(frame, BarFrame) else frame.at(zero)


def axes_of(sensors: Sensors, body: str | None) -> tuple[Vector, ...]:
    """Return the axes of a body at the time of the measurement; None is the ground."""
    frame = sensors.parts.frame(body)
    if isinstance(frame, Ground):
        return frame.axes
    if isinstance(frame, BarFrame):
        return tuple(sensors.vector(frame.direction(axis)) for axis in frame.axes)
    own = identity(sensors.parts.mechanism.dim)
    return tuple(sensors.vector(frame.along(axis)) for axis in own)


def spin(sensors: Sensors, body: str | None) -> Vector:
    """Return the angular velocity of a body in global axes, of one component in the plane."""
    parts = sensors.parts
    if body is None:
        return (0.0,) if parts.mechanism.dim == 2 else (0.0,) * 3
    if parts.mechanism.dim == 2:
        return (sensors.value(Ref("quantity_rate", parts.body_angle(body))),)
    return sensors.numbers(references("body_rate", _number_of(sensors, body), 3))


def _number_of(sensors: Sensors, body: str) -> int:
    """Return the number of a body in space among the measurements."""
    frame = sensors.parts.frames[body]
    assert not isinstance(frame, (BarFrame, Ground))
    return sensors.parts.mechanism.bodies[frame.directors[0]]


def _angle(sensors: Sensors, body: str | None) -> Number:
    return 0.0 if body is None else sensors.value(Ref("quantity", sensors.parts.body_angle(body)))


def _rotation_vector(sensors: Sensors, bodies: tuple[str | None, str | None]) -> tuple[Number, Any]:
    """Return the angle, from 0 to pi, and the vector that turns the first body's axes to the other.

    Of the quaternion (s, u) = q_2 q_1*, in global axes: psi = 2 atan2(|u|, |s|) sign(s) u/|u|.
    """
    (s1, u1), (s2, u2) = (_quaternion(sensors, body) for body in bodies)
    s = s1 * s2 + dot(u1, u2)
    u = subtract(subtract(scale(s1, u2), scale(s2, u1)), cross(u2, u1))
    size = sqrt(dot(u, u))
    angle = 2.0 * operate("atan2", size, operate("abs", s))
    known = operate("gt", size, 0.0)
    share = select(known, angle / select(known, size, 1.0), 2.0)
    return angle, scale(select(operate("lt", s, 0.0), -1.0 * share, share), u)


def _quaternion(sensors: Sensors, body: str | None) -> tuple[Number, Vector]:
    if body is None:
        return 1.0, (0.0,) * 3
    w, *vector = sensors.numbers(references("quaternion", _number_of(sensors, body), 4))
    return w, tuple(vector)
