"""A straight arm of two links of 1 m, whose hand is asked for elsewhere."""

from __future__ import annotations

import math
import random
from collections.abc import Iterator

_BODY = "mass = 1, inertia = {inertia}, points = {{ root = {root}, tip = {tip} }}"
_ARM = """
name = "arm"
dimension = {dim}
[bodies]
upper = {{ position = {first}, {body} }}
lower = {{ position = {second}, {body} }}
[joints]
{joints}
[drivers]
hand = {{ type = "position", point = "lower.tip", value = {target} }}
[solver]
assemble = true
"""
_BARS = """
name = "arm"
[points]
O = {{ position = [0, 0, 0], fixed = true }}
A = {{ position = [1, 0, 0], mass = 1 }}
B = {{ position = [2, 0, 0], mass = 1 }}
[bodies]
upper = {{ type = "bar", points = ["O", "A"], mass = 1 }}
lower = {{ type = "bar", points = ["A", "B"], mass = 1 }}
[drivers]
hand = {{ type = "position", point = "B", value = {target} }}
[solver]
assemble = true
"""
_PINS = """
shoulder = {{ type = "{shoulder}", bodies = ["ground", "upper"], position = {origin} }}
elbow = {{ type = "{elbow}", bodies = ["upper", "lower"], position = {middle}{axis} }}
"""
KINDS = {
    "plane": ("revolute", "revolute"),
    "ball and hinge": ("spherical", "revolute"),
    "balls": ("spherical", "spherical"),
}
HANDS = dict.fromkeys(KINDS, "lower.tip") | {"bars": "B"}
"""Point that the hand is, by the kind of arm."""


def arm(kind: str, target: list[float]) -> str:
    """Scene of an arm of one of the kinds of `HANDS`."""
    if kind == "bars":
        return _BARS.format(target=target)
    shoulder, elbow = KINDS[kind]
    dim = 2 if kind == "plane" else 3

    def place(x: float) -> list[float]:
        return [x, 0.0, 0.0][:dim]

    inertia = 0.1 if dim == 2 else [0.1, 0.1, 0.1]
    hinge = ", axis = [0, 0, 1]" if elbow == "revolute" and dim == 3 else ""
    joints = _PINS.format(
        shoulder=shoulder, elbow=elbow, origin=place(0.0), middle=place(1.0), axis=hinge
    )
    body = _BODY.format(inertia=inertia, root=place(-0.5), tip=place(0.5))
    return _ARM.format(
        dim=dim, body=body, first=place(0.5), second=place(1.5), joints=joints, target=target
    )


def targets(kind: str, far: float, count: int, seed: int) -> Iterator[list[float]]:
    """Places that can be reached, so far from the hand as it is drawn, in random directions."""
    random_numbers = random.Random(seed)
    dim = 2 if kind == "plane" else 3
    while count:
        way = [random_numbers.gauss(0.0, 1.0) for _ in range(dim)]
        size = math.hypot(*way)
        target = [x + far * y / size for x, y in zip([2.0, 0.0, 0.0], way, strict=False)]
        if 0.2 < math.hypot(*target) < 1.95:
            count -= 1
            yield target
