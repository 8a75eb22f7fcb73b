"""What parts of a scene refer to: points, bodies, joints and the ground, by name and place.

A point is "A" of the table [points], "rod" for the origin of a rigid body, "rod.tip" for a point
of it, or "ground"; `at` says where on the ground, or where on a body as it is drawn.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from solver.scene.draft import Draft
from solver.scene.expression import Vector
from solver.scene.fields import BROKEN, Part, PointReference, fields_of, shown
from solver.scene.mistakes import Path
from solver.scene.numbers import Known, unknown_end
from solver.scene.places import Places, same
from solver.scene.profiles import Profile
from solver.scene.scene import TYPES
from solver.scene.words import a, did_you_mean

NOWHERE = PointReference(point=None)
"""Stands for a reference that has been reported."""


class Reader(Places):
    """Reader of the parts of one scene; knows where everything is drawn once bodies are read."""

    def __init__(self, draft: Draft, known: Known, profiles: Mapping[str, Profile]) -> None:
        super().__init__(draft, known)
        self.profiles = profiles
        """Those without a mistake."""
        self.joints = {name: draft.part_class("joints", name) for name in draft.names("joints")}
        """Class of each joint of the file; None where its type is unknown."""
        self.driven: dict[tuple[str, str], str] = {}
        """Driver of each point, and of the angle or displacement of each joint."""
        self.fixed: set[str] = set()
        """Points that are part of the ground."""
        self.parts: dict[str, dict[str, Any]] = {}
        """Parts that have been read, by table and name."""

    def read(self, table: str, given: Mapping[str, tuple[type[Part], Any]] | None = None) -> None:
        """Read the parts of a table."""
        found = self.draft.parts(table) if given is None else given
        self.parts[table] = read = {}
        for name, (part, fields) in found.items():
            read[name] = part.read(self, (table, name), fields)

    def fields(self, part: type[Part], path: Path, given: Any) -> dict[str, Any]:
        """Values of the fields that are given, or broken."""
        return {
            name: field.kind.read(self, (*path, name), value, given)
            for name, field in fields_of(part).items()
            if field.is_own and (value := getattr(given, name)) is not None
        }

    def owner(self, name: str) -> str | None:
        """Body that a reference belongs to; None for points and the ground."""
        body = name.partition(".")[0]
        return body if self.known.parts.get(body) == "body" else None

    def exists(self, path: Path, name: str, *, ground: bool = False) -> bool:
        """Report a name that is no point; `ground` says that the ground would do as well."""
        problem = unknown_end(self.known, name, ground=ground)
        if problem is not None:
            self.draft.error(path, *problem)
        return problem is None

    def point(self, path: Path, name: Any, place: Any, field: str = "point") -> PointReference:
        """Read the field `point`, or another, with `at` for a place on a body."""
        where = (*path, field)
        at = None if place is None else self.vector((*path, "at"), place)
        if name is BROKEN:
            return NOWHERE
        if name == "ground":
            self.draft.error(where, "the ground does not move: name a point or a body")
            return NOWHERE
        if not self.exists(where, name):
            return NOWHERE
        return self._reference((*path, "at"), name, at, "leave it out")

    def ends(self, path: Path, names: Any, at: Any) -> tuple[PointReference, PointReference]:
        """Read the fields `points` and `at`, the two ends of a joint, force or driver."""
        if names is BROKEN:
            return NOWHERE, NOWHERE
        where, (first, second) = (*path, "points"), names
        for i, name in enumerate(names):
            if name != "ground":
                self.exists((*where, i), name, ground=True)
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
            for name, (place, at) in zip(names, self._places(path, names, at), strict=True)
        )
        return one, two

    def _places(self, path: Path, points: Any, at: Any) -> list[tuple[Path, Vector | None]]:
        """Read `at`, one place for each end, or that of the one end that needs it."""
        where = (*path, "at")
        given: list[tuple[Path, Vector | None]] = [(where, None), (where, None)]
        if at is None:
            if "ground" in points:
                message = "'at' is missing: the place of 'ground'"
                help = f"write at = {shown([0] * len(self.zero()))}"
                self.draft.error(path, message, help)
        elif at is BROKEN:
            pass
        elif not isinstance(at[0] if at else None, list):
            place = self.vector(where, at)
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
        elif len(at) != 2:
            self.draft.error(where, f"must have one place for each end, got {len(at)}")
        else:
            ends = (((*where, i), each) for i, each in enumerate(at))
            given = [(place, self.vector(place, each)) for place, each in ends]
        return given

    def _reference(self, path: Path, name: str, at: Vector | None, help: str) -> PointReference:
        """Return an end; the place of a point must be where the point is drawn."""
        if name == "ground":
            return PointReference(point=None, at=at)
        if self.known.parts.get(name) == "body":
            point = None if at is None else self.point_at(path, name, at)
            return PointReference(point=point or name, at=None if point else at)
        drawn = self.values(self.drawn.get(name, ()))
        given = None if at is None else self.values(at)
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
        bar = bar or self.dimension != 3
        if kind == "body" or (kind == "bar" and bar) or (ground and name == "ground"):
            return True
        bodies = self.known.of("body", *(["bar"] if bar else []))
        known = [*bodies, *(["ground"] if ground else [])]
        help = did_you_mean(name, known, "known bodies")
        if name == "ground":
            message, help = "the ground does not move: name a body", None
        elif kind == "bar":
            message = f"the bar '{name}' has no axes in space"
            meets = "clearance" if path[0] == "contacts" else "spherical"
            help = f'join one of its points: type = "{meets}" with points = [...]'
            if path[0] == "sensors":
                help = "name one of its points: points = [...]"
        elif name in self.known.ends and "." in name:
            body = name.partition(".")[0]
            message, help = f"'{name}' is a point of a body, not a body", f"write '{body}'"
        elif kind is not None:
            message = f"'{name}' is {a(kind)}, not a body"
        else:
            message = f"unknown body '{name}'"
        self.draft.error(path, message, help)
        return False

    def joint(self, path: Path, name: Any, *words: str) -> bool:
        """Report a name that is no joint with an angle, with a displacement, or with either."""
        if name is BROKEN:
            return False
        kind, part = self.joints.get(name), self.known.parts.get(name)
        if any(self.has(name, word) for word in words):
            return True
        if part == "joint":
            if kind is not None:  # one of unknown type is reported already
                self.draft.error(path, *self._without(name, kind, words))
            return False
        known = [joint for joint in self.joints if any(self.has(joint, word) for word in words)]
        help = did_you_mean(name, known, f"joints with {' or '.join(map(a, words))}")
        message = f"'{name}' is {a(part)}, not a joint" if part else f"unknown joint '{name}'"
        self.draft.error(path, message, help)
        return False

    def has(self, joint: str, word: str) -> bool:
        """Whether there is such a joint, of a known type, with an angle or displacement."""
        offers = self.known.offered[joint] if self.joints.get(joint) else ()
        return any(offer.word == word for offer in offers)

    def _without(
        self, name: str, kind: type[Part], words: tuple[str, ...]
    ) -> tuple[str, str | None]:
        """Words for a joint that has no angle, no displacement, or neither."""
        if any(map(kind.has, words)):
            help = "give it 'bodies' and 'position' instead of 'points'"
            return f"'{name}' joins points, and has no angle", help
        possible = [
            word
            for word, joint in TYPES["joints"].items()
            if any(map(joint.has, words)) and joint.is_in(self.dimension)
        ]
        help = f"types of joints with {' or '.join(map(a, words))}: {', '.join(possible)}"
        what = f"'{name}' is a {kind.type.replace('_', ' ')} joint"
        return f"{what}, which has no {' and no '.join(words)}", help
