"""Tables of parts that scenes of the corpus share."""

from __future__ import annotations

from collections.abc import Sequence

Table = dict[str, object]


def bar(a: float, m: float, J: float, x: float, y: float, angle: float, **more: object) -> Table:
    """Bar of length a from (x, y) on; its mass centre is in its middle, its origin at (x, y)."""
    return {
        "position": [x, y],
        "orientation": angle,
        "mass": m,
        "inertia": J,
        "center_of_mass": [a / 2, 0],
        "points": {"a": [0, 0], "e": [a, 0]},
        **more,
    }


def pinned(*points: str, **more: object) -> Table:
    """Hinge in the plane of two points."""
    return {"type": "revolute", "points": list(points), **more}


def hinge(first: str, second: str, position: Sequence[float], *axis: Sequence[float]) -> Table:
    """Hinge of two bodies, in space about an axis."""
    table: Table = {"type": "revolute", "bodies": [first, second], "position": [*position]}
    return table | {"axis": [*axis[0]]} if axis else table
