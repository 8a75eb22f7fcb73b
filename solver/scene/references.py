"""What parts of a scene refer to: points, bodies and the ground, by name and place.

A point is "A" of the table [points], "rod" for the origin of a rigid body, "rod.tip" for a point
of it, or "ground"; `at` says where on the ground, or where on a body as it is drawn.
"""

from __future__ import annotations

from typing import Any

from solver.scene.fields import BROKEN, shown
from solver.scene.geometry import Geometry
from solver.scene.numbers import unknown_end
from solver.scene.places import Places, same
from solver.scene.report import Path
from solver.scene.vocabulary_parts import PointReference, Vector
from solver.scene.words import a, did_you_mean

NOWHERE = PointReference(point=None)
"""Stands for a reference that has been reported."""


class References:
    """Reader of references; knows where everything is drawn once points and bodies are read."""

    def __init__(self, geometry: Geometry) -> None:
        self.geometry = geometry
        self.draft = geometry.draft
        self.known = geometry.known
        self.fixed: set[str] = set()
        """Points that are part of the ground."""
        self.places = Places(geometry)

    def owner(self, name: str) -> str | None:
        """Body that a reference belongs to; None for points and the ground."""
        body = name.partition(".")[0]
        return body if self.known.parts.get(body) == "body" else None

    def exists(self, path: Path, name: str) -> bool:
        """Report a name that is no point."""
        problem = unknown_end(self.known, name)
        if problem is not None:
            self.draft.error(path, *problem)
        return problem is None

    def point(self, path: Path, part: Any) -> PointReference:
        """Read the field `point`, with `at` for a place on a body."""
        where, name = (*path, "point"), part.point
        at = self.geometry.optional((*path, "at"), part.at)
        if name is BROKEN:
            return NOWHERE
        if name == "ground":
            self.draft.error(where, "the ground does not move: name a point or a body")
            return NOWHERE
        if not self.exists(where, name):
            return NOWHERE
        return self._reference((*path, "at"), name, at, "leave it out")

    def ends(self, path: Path, part: Any) -> tuple[PointReference, PointReference]:
        """Read the two ends of a joint, force or driver."""
        if part.points is BROKEN:
            return NOWHERE, NOWHERE
        where, (first, second) = (*path, "points"), part.points
        for i, name in enumerate(part.points):
            if name != "ground":
                self.exists((*where, i), name)
        body = self.owner(first)
        if body is not None and body == self.owner(second):
            self.draft.error(where, f"both ends are on the body '{body}', which does not deform")
        elif first == second:
            self.draft.error(where, f"both ends are '{first}'")
        elif {first, second} <= self.fixed | {"ground"}:
            self.draft.error(where, f"both ends are fixed: '{first}' and '{second}'")
        help = "give the place of 'ground' or of a body alone"
        one, two = (
            self._reference(place, name, at, help)
            for name, (place, at) in zip(part.points, self._places(path, part), strict=True)
        )
        return one, two

    def _places(self, path: Path, part: Any) -> list[tuple[Path, Vector | None]]:
        """Read `at`, one place for each end, or that of the one end that needs it."""
        where, points = (*path, "at"), part.points
        given: list[tuple[Path, Vector | None]] = [(where, None), (where, None)]
        if part.at is None:
            if "ground" in points:
                message = "'at' is missing: the place of 'ground'"
                help = f"write at = {shown([0] * len(self.geometry.zero()))}"
                self.draft.error(path, message, help)
        elif part.at is BROKEN:
            pass
        elif not isinstance(part.at[0] if part.at else None, list):
            place = self.geometry.vector(where, part.at)
            bodies = [name for name in points if self.known.parts.get(name) == "body"]
            needs = ["ground"] if "ground" in points else bodies
            if len(needs) == 1:
                given[points.index(needs[0])] = where, place
            elif needs:
                message = "must have one place for each end, got one vector"
                self.draft.error(where, message, "write at = [[...], [...]]")
            elif all(name in self.known.ends for name in points):
                message = "'at' is the place of 'ground' or on a body, which is no end here"
                self.draft.error(where, message)
        elif len(part.at) != 2:
            self.draft.error(where, f"must have one place for each end, got {len(part.at)}")
        else:
            ends = (((*where, i), at) for i, at in enumerate(part.at))
            given = [(place, self.geometry.vector(place, at)) for place, at in ends]
        return given

    def _reference(self, path: Path, name: str, at: Vector | None, help: str) -> PointReference:
        """Return an end; the place of a point must be where the point is drawn."""
        if name == "ground":
            return PointReference(point=None, at=at)
        if self.known.parts.get(name) == "body":
            point = None if at is None else self.places.point_at(path, name, at)
            return PointReference(point=point or name, at=None if point else at)
        drawn = self.geometry.values(self.places.drawn.get(name, ()))
        given = None if at is None else self.geometry.values(at)
        if drawn and given and len(drawn) == len(given) and not same(drawn, given):
            what = "point" if self.owner(name) is None else "the point"
            self.draft.error(path, f"{what} '{name}' is drawn at {shown(drawn)}", help)
        return PointReference(point=name)

    def pair(self, path: Path, names: Any) -> tuple[str | None, str | None]:
        """Read the two bodies of a joint; None is the ground."""
        if names is BROKEN:
            return None, None
        first, second = names
        fine = [self.body((*path, i), name, ground=True) for i, name in enumerate(names)]
        if all(fine) and first == second:
            what = "the ground" if first == "ground" else f"'{first}'"
            self.draft.error(path, f"both bodies are {what}")
        return (None if first == "ground" else first, None if second == "ground" else second)

    def body(self, path: Path, name: str, ground: bool = False, bar: bool = False) -> bool:
        """Report a name that is no body with axes: a rigid body, in the plane also a bar.

        `ground` and `bar` say that the ground, and in space a bar, will do as well.
        """
        kind = self.known.parts.get(name)
        bar = bar or self.geometry.dimension != 3
        if kind == "body" or (kind == "bar" and bar) or (ground and name == "ground"):
            return True
        bodies = self.known.of("body", *(["bar"] if bar else []))
        known = [*bodies, *(["ground"] if ground else [])]
        help = did_you_mean(name, known, "known bodies")
        if name == "ground":
            message, help = "the ground does not move: name a body", None
        elif kind == "bar":
            message = f"the bar '{name}' has no axes in space"
            help = 'join one of its points: type = "spherical" with points = [...]'
        elif name in self.known.ends and "." in name:
            body = name.partition(".")[0]
            message, help = f"'{name}' is a point of a body, not a body", f"write '{body}'"
        elif kind is not None:
            message = f"'{name}' is {a(kind)}, not a body"
        else:
            message = f"unknown body '{name}'"
        self.draft.error(path, message, help)
        return False
