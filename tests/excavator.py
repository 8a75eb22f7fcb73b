"""An excavator drawn by eye, and its poses in closed form."""

from __future__ import annotations

import itertools
import math

SCENE = """
name = "excavator"
description = "Boom, stick and bucket posed by three hydraulic cylinders"
dimension = 2
gravity = [0, -9.81]

[parameters]
boom_closed = { value = 1.75, unit = "m" }
stick_closed = { value = 2.40, unit = "m" }
bucket_closed = { value = 1.65, unit = "m" }

[inputs]
boom_stroke = { unit = "m", min = 0, max = 1.3, start = 0.5, interpolation = "smooth" }
stick_stroke = { unit = "m", min = 0, max = 1.5, start = 0.7, interpolation = "smooth" }
bucket_stroke = { unit = "m", min = 0, max = 1.1, start = 0.5, interpolation = "smooth" }

[bodies.boom]
position = [0, 0]
orientation = "30*pi/180"
mass = 1500
inertia = 4500
center_of_mass = [2.8, 0.4]
points = { foot = [0, 0], cyl = [2.3, 0.5], stick_cyl = [2.6, 1.0], tip = [5.7, 0] }

[bodies.stick]
position = ["5.7*cos(30*pi/180)", "5.7*sin(30*pi/180)"]
orientation = "-70*pi/180"
mass = 800
inertia = 800
center_of_mass = [1.0, 0.1]
points = { root = [0, 0], tail = [-0.9, 0.3], bucket_cyl = [0.3, 0.6], rocker = [2.4, 0.0], tip = [2.9, 0] }

[bodies.rocker]
position = [5.9, 0.9]
orientation = 0.0
mass = 60
inertia = 3
points = { a = [0, 0], b = [0.6, 0] }

[bodies.link]
position = [6.5, 0.9]
mass = 60
inertia = 3
points = { a = [0, 0], b = [0.6, 0] }

[bodies.bucket]
position = [6.0, 0.2]
orientation = "-90*pi/180"
mass = 700
inertia = 250
center_of_mass = [0.6, -0.3]
points = { root = [0, 0], link = [0, 0.45], tooth = [1.4, 0] }

[joints]
boom_pin = { type = "revolute", points = ["ground", "boom.foot"], at = [0, 0] }
stick_pin = { type = "revolute", points = ["boom.tip", "stick.root"] }
bucket_pin = { type = "revolute", points = ["stick.tip", "bucket.root"] }
rocker_pin = { type = "revolute", points = ["stick.rocker", "rocker.a"] }
link_pin = { type = "revolute", points = ["rocker.b", "link.a"] }
bucket_link = { type = "revolute", points = ["link.b", "bucket.link"] }

[drivers]
boom_cyl = { type = "distance", points = ["ground", "boom.cyl"], at = [0.4, -0.5], value = "boom_closed + boom_stroke" }
stick_cyl = { type = "distance", points = ["boom.stick_cyl", "stick.tail"], value = "stick_closed + stick_stroke" }
bucket_cyl = { type = "distance", points = ["stick.bucket_cyl", "rocker.b"], value = "bucket_closed + bucket_stroke" }

[solver]
assemble = true

[experiment]
stop_time = 6
step_size = 0.02
"""  # noqa: E501
"""The bucket link is drawn 0.96 m off its pins."""
BODIES = ("boom", "stick", "rocker", "link", "bucket")
STROKES = [(0.2 * boom, 0.2 * stick, 0.5) for boom, stick in itertools.product(range(7), range(8))]
"""Of boom, stick and bucket [m]: all can be reached."""
OTHERS = [
    *itertools.product((0.0, 0.43, 0.87), (0.0, 0.5, 1.0, 1.5), (0.0, 0.37, 0.73)),
    *((boom, stick, bucket) for boom, stick, _ in STROKES for bucket in (0.0, 0.2, 0.8, 1.0)),
]
"""With other strokes of the bucket."""
DRAWN = (1, -1, -1, -1)
"""Branch of the drawing."""
Branch = tuple[int, int, int, int]


def _direction(x: float, y: float) -> float:
    return math.atan2(y, x)


def _between(a: float, b: float, opposite: float) -> float:
    """Angle between sides a and b of a triangle, by the law of cosines."""
    return math.acos((a * a + b * b - opposite * opposite) / (2.0 * a * b))


def branches(boom_stroke: float, stick_stroke: float, bucket_stroke: float) -> dict[Branch, list]:
    """Angles of all bodies [rad], by the signs of three triangles and of a pair of links."""
    found = {}
    for s1, s2, s3, s4 in itertools.product((1, -1), repeat=4):
        at = _between(math.hypot(0.4, 0.5), math.hypot(2.3, 0.5), 1.75 + boom_stroke)
        boom = _direction(0.4, -0.5) + s1 * at - _direction(2.3, 0.5)
        at = _between(math.hypot(3.1, 1.0), math.hypot(0.9, 0.3), 2.40 + stick_stroke)
        stick = boom + _direction(-3.1, 1.0) + s2 * at - _direction(-0.9, 0.3)
        at = _between(math.hypot(2.1, 0.6), 0.6, 1.65 + bucket_stroke)
        rocker = _direction(-2.1, 0.6) + s3 * at
        b = 2.4 + 0.6 * math.cos(rocker), 0.6 * math.sin(rocker)
        span = math.hypot(2.9 - b[0], b[1])
        if not abs(0.6 - 0.45) < span < 0.6 + 0.45:
            continue
        link = _direction(2.9 - b[0], -b[1]) + s4 * -_between(0.6, span, 0.45)
        pin = b[0] + 0.6 * math.cos(link), b[1] + 0.6 * math.sin(link)
        bucket = _direction(pin[0] - 2.9, pin[1]) - math.pi / 2.0
        found[s1, s2, s3, s4] = [boom, stick, stick + rocker, stick + link, stick + bucket]
    return found


def farthest(angles: list[float], others: list[float]) -> float:
    """Largest difference of two lists of angles [rad], without whole turns."""
    return max(
        abs(math.remainder(a - b, 2.0 * math.pi)) for a, b in zip(angles, others, strict=True)
    )
