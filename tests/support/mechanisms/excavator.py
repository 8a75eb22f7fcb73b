"""An excavator drawn by eye, and its poses in closed form."""

from __future__ import annotations

import itertools
import math
from pathlib import Path

SCENE = (Path(__file__).parents[2] / "truth" / "cases" / "excavator_by_eye.toml").read_text("utf-8")
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


def drawn_pose(
    boom_stroke: float, stick_stroke: float, bucket_stroke: float
) -> list[float] | None:  # fmt: skip
    """Angles of all bodies [rad] on the branch of the drawing; None where a triangle is open."""
    try:
        return branches(boom_stroke, stick_stroke, bucket_stroke).get(DRAWN)
    except ValueError:
        return None


def farthest(angles: list[float], others: list[float]) -> float:
    """Largest difference of two lists of angles [rad], without whole turns."""
    return max(
        abs(math.remainder(a - b, 2.0 * math.pi)) for a, b in zip(angles, others, strict=True)
    )
