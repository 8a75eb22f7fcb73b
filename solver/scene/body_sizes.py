"""The size of a rigid body, and the inertia that counts as none against it.

Forces turn a body at the places where parts join it, and at its named points. Its size l is the
largest distance of these, and of its origin, from its centre of mass; of a body that has all of
them there, the largest distance of the centres of mass of bodies that joints join to it. An inertia
below TINY m l^2 is lost in the round-off of what these forces do, and counts as 0.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import Any

from solver.scene.bodies import Rigid
from solver.scene.expression import Number, Vector
from solver.scene.joints import BodyJoint
from solver.scene.numbers import dot, times
from solver.scene.places import SAME

TINY = 1e-12
"""Of mass times size squared."""

PLACED = ("bodies", "joints", "contacts", "forces", "drivers")
"""Tables whose parts have places."""

Parts = Mapping[str, Mapping[str, Any]]
"""Parts of the tables in `PLACED`, by table and name."""
Places = Mapping[str | None, list[Vector]]


def places_of_bodies(parts: Parts) -> Places:
    """Return the global positions, as drawn, where something is joined to each body."""
    places: defaultdict[str | None, list[Vector]] = defaultdict(list)
    for joint in parts["joints"].values():
        if isinstance(joint, BodyJoint) and joint.bodies and joint.position:
            for body in joint.bodies:
                places[body].append(joint.position)
    for reference in _references(parts):
        if reference.at is not None:
            places[reference.point].append(reference.at)
    return places


def _references(parts: Parts) -> Iterator[Any]:
    for table in ("joints", "contacts", "forces", "drivers"):
        for part in parts[table].values():
            yield from getattr(part, "points", None) or ()
            point = getattr(part, "point", None)
            if point is not None:
                yield point


def squared_sizes(
    parts: Parts, places: Places, default: Callable[[Number], float]
) -> dict[str, Number]:
    """Return l^2 [m2] of each rigid body, 0 of one of which nothing tells a size.

    `default` gives a number with the default parameters, which choose the farthest place.
    """
    rigid = {name: x for name, x in parts["bodies"].items() if isinstance(x, Rigid)}
    centres = {name: _centre(body) for name, body in rigid.items()}
    found: dict[str, Number] = {}
    for name, body in rigid.items():
        arms = [_difference(point, body.center_of_mass) for point in body.points.values()]
        arms += _arms(centres[name], places.get(name, ()), default)
        squares = (dot(arm, arm) for arm in (*arms, body.center_of_mass))
        found[name] = max(squares, key=default)
    lacking = {name for name in found if default(found[name]) == 0.0}
    joined = _joined(parts["joints"].values()) if lacking else []
    for name in lacking:
        others = {x for pair in joined if name in pair for x in pair if x in centres}
        arms = _arms(centres[name], [centres[x] for x in sorted(others)], default)
        found[name] = max([0.0, *(dot(arm, arm) for arm in arms)], key=default)
    return found


def _joined(joints: Iterable[Any]) -> list[set[str]]:
    """Return the names of the bodies of each joint."""
    pairs = []
    for joint in joints:
        ends = [end.point for end in getattr(joint, "points", None) or ()]
        names = [*(getattr(joint, "bodies", None) or ()), *ends]
        pairs.append({name.partition(".")[0] for name in names if name})
    return pairs


def _centre(body: Rigid) -> Vector:
    """Return the centre of mass of a body, as drawn."""
    arm = times(body.rotation, body.center_of_mass)
    return tuple(x + y for x, y in zip(body.position, arm, strict=True))


def _arms(
    centre: Vector, places: Iterable[Vector], default: Callable[[Number], float]
) -> list[Vector]:
    """Return the way to each place from a centre of mass, of those that are not there."""
    found = []
    for place in places:
        arm = _difference(place, centre)
        size = max(abs(default(x)) for x in (*place, *centre))
        if any(abs(default(x)) > SAME * size for x in arm):
            found.append(arm)
    return found


def _difference(a: Vector, b: Vector) -> Vector:
    return tuple(x - y for x, y in zip(a, b, strict=True))
