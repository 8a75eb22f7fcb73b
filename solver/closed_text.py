"""The text of a scene in its closed pose: new numbers in place, and what else they change.

Joints count from the drawing. In that of the closed pose their angle or displacement q is less by
what it is there, q*. So that the scene means what it did, formulas read (q + q*) in place of q, and
what is compared with q, such as a driver, becomes less by q*.
"""

from __future__ import annotations

import json
import math
import os
import re
from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property, partial
from pathlib import PurePath
from typing import Any

from solver.closed_pose import Pose, axes_of, moving, number
from solver.mechanics.parts import Parts
from solver.scene import (
    BodyJoint,
    CamContact,
    CornersContact,
    CylinderContact,
    EllipsoidContact,
    ExpressionError,
    Gear,
    PointReference,
    Rolling,
    Scene,
    Spring,
    TorsionDamper,
    TorsionSpring,
)
from solver.scene.grammar import read
from solver.scene.mistakes import location_of
from solver.scene.positions import STRING, Path, spans_of
from solver.scene.rewriting import AsIs, Written, less, value_of
from solver.scene.rules import ANGLE

ROUND_OFF = 1e-12
"""Of the size of the mechanism, or 1 rad: what moved by less stays as it is written."""
SAME = 1e-9
"""Likewise: by so much the closed pose may move when it is read again."""
DIGITS = 15
"""Of a number of the size of the mechanism, or of 1 rad, that is written."""
COUNTED = {"drivers": ("value",), "contacts": ("min", "max"), "forces": ("free_angle",)}
"""Fields of parts with a joint that are compared with its angle or displacement."""
WORDS = {"angle": "rad", "displacement": "m"}
"""What of a joint counts from the drawing, and its unit."""
LINEAR, SPINS = ("vx", "vy", "vz"), ("wx", "wy", "wz", "angular_velocity")
"""Words of velocities and of angular velocities."""
TABLES_WITH_PLACES = ("joints", "forces", "drivers", "contacts", "sensors")
TABLES_WITH_FORMULAS = (
    "expressions",
    "states",
    "constraints",
    "contacts",
    "forces",
    "drivers",
    "outputs",
    "joints",
)
_TOKEN = re.compile(rf"#[^\n]*|{STRING.pattern}", re.DOTALL)


class Edit:
    """New values of a text, by their paths."""

    def __init__(
        self, scene: Scene, parts: Parts, poses: Mapping[str, Pose], closed: Mapping[str, float],
        size: float,
    ) -> None:  # fmt: skip
        self._scene, self._parts, self._closed, self._size = scene, parts, closed, size
        self._values, self._source = scene.values(), scene.source
        self._curves = {name: profile.curve for name, profile in scene.profiles.items()}
        self._spans = spans_of(self._source.text, self._source.notation)
        self._poses = {
            name: pose
            for name, pose in poses.items()
            if pose.moved[0] > ROUND_OFF * size or abs(pose.moved[1]) > ROUND_OFF
        }
        self._counts = {
            f"{joint}.{word}": rounded(closed[f"{joint}.{word}"], scale)
            for joint in self._scene.joints
            for word, scale in (("angle", 1.0), ("displacement", size))
            if abs(closed.get(f"{joint}.{word}", 0.0)) > ROUND_OFF * scale
        }
        """What joints that have moved count from the drawing, by its name."""
        self._remarks: list[str] = []
        self.values: dict[Path, Written] = {}
        """What is to be written, and where."""
        self._add_poses()
        self._add_velocities()
        for table in TABLES_WITH_PLACES:
            for name, part in getattr(self._scene, table).items():
                self._add_places(table, name, part)
        numbers = self._numbers_for_formulas()
        self._count_from_the_new_drawing()
        self._change_formulas()
        self._keep_lengths_of_springs()
        self.remarks = (*numbers, *self._remarks, *self._left())
        """Formulas that numbers replace, and what counts from the drawing, by how much."""

    def _numbers_for_formulas(self) -> list[str]:
        """Say which formulas numbers replace."""
        return [
            f"{location_of(path)}: numbers replace {self._written(path)}"
            for path in self.values
            if path in self._spans and STRING.search(self._written(path))
        ]

    def _written(self, path: Path) -> str:
        span = self._spans[path]
        return self._source.text[span.begin : span.end]

    def _length(self, x: float) -> float:
        return rounded(x, self._size)

    # ----------------------------------------------------------------- places and velocities

    def _add_poses(self) -> None:
        for name, pose in self._poses.items():
            table = "points" if name in self._scene.points else "bodies"
            if pose.moved[0] > ROUND_OFF * self._size:
                self.values[table, name, "position"] = [*map(self._length, pose.place)]
            if abs(pose.moved[1]) > ROUND_OFF:
                turn = [rounded(x, 1.0) for x in pose.orientation]
                new = turn[0] if len(turn) == 1 else {"quaternion": turn}
                self.values[table, name, "orientation"] = new

    @cached_property
    def _speed(self) -> float:
        """Of the mechanism at the start, or from a fall of its size [m/s]."""
        fall = math.hypot(*(number(x, self._values) for x in self._scene.gravity)) * self._size
        words = {name: name.rpartition(".")[2] for name in self._closed}
        return max(
            math.sqrt(fall),
            *(abs(self._closed[name]) for name, word in words.items() if word in LINEAR),
            *(
                abs(self._closed[name]) * self._size
                for name, word in words.items()
                if word in SPINS
            ),
        )

    def _add_velocities(self) -> None:
        """Write velocities at the start that are not those of the file."""
        scene, spins = self._scene, (["angular_velocity"] if self._scene.dimension == 2 else None)
        for name in moving(scene):
            part: Any = (scene.points | scene.bodies)[name]
            table = "points" if name in scene.points else "bodies"
            kinds = [("velocity", [f"v{x}" for x in axes_of(scene)])]
            if table == "bodies":
                kinds.append(("angular_velocity", spins or [f"w{x}" for x in axes_of(scene)]))
            for field, names in kinds:
                found = [self._closed[f"{name}.{x}"] for x in names]
                given = getattr(part, field)
                before = [0.0] * len(found)
                if given is not None:
                    vector = given if isinstance(given, tuple) else (given,)
                    before = [number(x, self._values) for x in vector]
                largest = max(map(abs, (*found, *before)))
                turned = name in self._poses and (table, name, field, "body") in self._spans
                slow = ROUND_OFF * (
                    self._speed if field == "velocity" else self._speed / self._size
                )
                if turned or math.dist(found, before) > max(SAME * largest, slow):
                    found = [rounded(x, largest) for x in found]
                    plane = field == "angular_velocity" and scene.dimension == 2
                    self.values[table, name, field] = found[0] if plane else found

    def _add_places(self, table: str, name: str, part: Any) -> None:
        """Carry places and directions of a part with the bodies that they are fixed to."""
        carriers = (getattr(part, field, None) for field in ("point", "body"))
        ends = (*(getattr(part, "points", None) or ()), *carriers)
        self._carry_ends(
            (table, name, "at"),
            [x for x in ends if isinstance(x, PointReference) and x.at is not None],
        )
        bodies = getattr(part, "bodies", None) or (getattr(part, "body", None),)
        for field in ("position", "axis", "normal"):
            value = getattr(part, field, None)
            if isinstance(part, BodyJoint) or len(bodies) == 1:
                owner = _owner_of(part, field, bodies[0])
                self._carry((table, name, field), owner, value, place=field == "position")
            elif value is not None and (table, name, field) in self._spans:
                self._refuse((table, name, field), bodies)
        if isinstance(part, BodyJoint) and (table, name, "position") in self._spans:
            self._put_on_named_point((table, name, "position"), part)
        if isinstance(part, CamContact):
            owner = (part.follower.point or "").partition(".")[0]
            self._carry((table, name, "face"), owner, part.face, place=False)
        axes = getattr(part, "axes", None)
        if isinstance(axes, tuple) and len(axes) == len(bodies) == 2:
            path = table, name, "axes"
            turned = []
            for body, axis in zip(bodies, axes, strict=True):
                numbers = [number(x, self._values) for x in axis]
                turned.append(self._turned(body, numbers) if body in self._poses else numbers)
            if path in self._spans and not self._poses.keys().isdisjoint(bodies):
                self.values[path] = turned

    def _put_on_named_point(self, path: Path, joint: BodyJoint) -> None:
        """Let a joint on a named point stay there where values given from outside moved that."""
        given: Any = self._parts.scene.joints[str(path[1])]
        names = [f"{point}.{x}" for point in given.on if point for x in axes_of(self._scene)]
        place = [self._closed[x] for x in names if x in self._closed][: self._scene.dimension]
        there: Any = self.values.get(path) or [
            number(x, self._values) for x in joint.position or ()
        ]
        if place and math.dist(place, there) > SAME * self._size:
            self.values[path] = [*map(self._length, place)]

    def _carry_ends(self, path: Path, ends: Sequence[PointReference]) -> None:
        """Carry the places of one end or of both; with two, the file has a place for each."""
        if len(ends) == 1:
            self._carry(path, ends[0].point, ends[0].at, place=True)
        elif path in self._spans and any(end.point in self._poses for end in ends):
            places = [[number(x, self._values) for x in end.at or ()] for end in ends]
            self.values[path] = [
                self._carried(end.point, place) if end.point in self._poses else place
                for end, place in zip(ends, places, strict=True)
            ]

    def _carry(self, path: Path, body: str | None, value: Any, *, place: bool) -> None:
        if body not in self._poses or path not in self._spans or not isinstance(value, tuple):
            return
        numbers = [number(x, self._values) for x in value]
        self.values[path] = self._carried(body, numbers) if place else self._turned(body, numbers)

    def _carried(self, body: str, place: Sequence[float]) -> list[float]:
        return [*map(self._length, self._poses[body].carried(place))]

    def _turned(self, body: str, direction: Sequence[float]) -> list[float]:
        length = math.hypot(*direction)
        return [rounded(x, length) for x in self._poses[body].turned(direction)]

    def _refuse(self, path: Path, bodies: Sequence[str | None]) -> None:
        for body in bodies:
            if body in self._poses:
                message = f"is of the drawing, and '{body}' moves from it when it is closed"
                help = f"draw '{body}' nearer to its place by hand, with what is fixed to it"
                self._scene.fail([self._source.problem(path, message, help)])

    # ------------------------------------------------------------- what counts from the drawing

    def _count_from_the_new_drawing(self) -> None:
        """Let what is compared with a joint's angle or displacement mean what it did."""
        for path, joint, word, is_free in self._counted():
            count = f"{joint}.{word}"
            if count not in self._counts or not (path in self._spans or is_free):
                continue
            given = 0.0
            if path in self._spans:
                given = value_of(self._written(path), self._source.notation)
            new = less(given, self._counts[count])
            scale = 1.0 if word == "angle" else self._size
            new = rounded(new, scale) if isinstance(new, float) else new
            self.values[path] = new
            there = f"replaces {self._written(path)}" if path in self._spans else "is added"
            self._tell(path, new if isinstance(new, str) else repr(new), there, count)

    def _counted(self) -> Iterator[tuple[Path, str, str, bool]]:
        """Yield what is compared with an angle or displacement: field, joint, which of both.

        The last one tells whether a field that is not given means 0, as drawn.
        """
        for table, fields in COUNTED.items():
            for name, part in getattr(self._scene, table).items():
                word = getattr(part, "of", None) or getattr(part, "type", None)
                word = word if word in WORDS else "angle"
                for field in fields:
                    is_free = isinstance(part, TorsionSpring)
                    yield (table, name, field), getattr(part, "joint", ""), word, is_free
        for name, part in self._scene.joints.items():
            if isinstance(part, BodyJoint) and part.stiffness is not None:
                word = "displacement" if part.springs_along else "angle"
                yield ("joints", name, f"free_{word}"), name, word, True

    def _change_formulas(self) -> None:
        """Let formulas that read a joint read what it counted from the old drawing."""
        tables = {path[:k] for path in self._spans for k in range(1, len(path))}
        for path in self._spans if self._counts else ():
            if path[0] not in TABLES_WITH_FORMULAS or path in tables or path[-1] == "description":
                continue
            new = self.values.get(path)
            if isinstance(new, str):
                changed = self._changed(path, new)
                if changed != new:
                    self.values[path] = changed
            elif new is None:
                written = self._written(path)
                text = _TOKEN.sub(partial(self._changed_token, path), written)
                if text != written:
                    self.values[path] = AsIs(text)

    def _changed_token(self, path: Path, token: re.Match[str]) -> str:
        """Return what stands for a formula in the text of a field."""
        if token[0].startswith("#"):
            return token[0]
        given = value_of(token[0], self._source.notation)
        changed = self._changed(path, str(given))
        if changed == given:
            return token[0]
        new = json.dumps(changed, ensure_ascii=False)
        names = [x for name, x in self._read_in(path).items() if rf"({name} " in changed]
        self._tell(path, new, f"replaces {token[0]}", *names)
        return new

    def _read_in(self, path: Path) -> dict[str, str]:
        """Counts of joints that have moved, by what a formula calls them."""
        found = {count: count for count in self._counts}
        force = self._scene.forces.get(str(path[1])) if path[0] == "forces" else None
        own = f"{force.joint}.{ANGLE}" if isinstance(force, TorsionDamper) else ""
        return found | ({ANGLE: own} if own in self._counts else {})

    def _changed(self, path: Path, formula: str) -> str:
        """Return a formula that reads the old counts of joints."""
        read_in = self._read_in(path)
        try:
            mentions = read(formula, self._curves).mentions
        except ExpressionError:  # it is none, such as the name of a joint
            return formula
        for mention in sorted(mentions, key=lambda x: -x.column):
            if mention.role == "symbol" and mention.name in read_in:
                at, count = mention.column - 1, self._counts[read_in[mention.name]]
                name = re.compile(r"\w+(\s*\.\s*\w+)?").match(formula, at)
                assert name is not None, mention
                sign = "+" if count > 0.0 else "-"
                changed = f"({mention.name} {sign} {abs(count)!r})"
                formula = f"{formula[:at]}{changed}{formula[name.end() :]}"
        return formula

    def _keep_lengths_of_springs(self) -> None:
        """Write free lengths that are those of the old drawing."""
        mechanism = self._parts.mechanism
        for name, force in self._scene.forces.items():
            if isinstance(force, Spring) and force.free_length is None and force.energy is None:
                link = [number(x, self._values) for x in mechanism.drawn(self._parts.links[name])]
                old = math.hypot(*link)
                if abs(old - self._closed[f"{name}.length"]) > ROUND_OFF * self._size:
                    path = "forces", name, "free_length"
                    self.values[path] = self._length(old)
                    self._remarks.append(
                        f"{location_of(path)}: {self.values[path]!r} m is added, the length in the "
                        "old drawing, since it is as drawn unless given"
                    )

    def _tell(self, path: Path, new: str, before: str, *counts: str) -> None:
        names = " and ".join(f"{x} is {_by(self._counts[x], x)}" for x in counts)
        text = f"{location_of(path)}: {new} {before}, since {names} in the new drawing"
        self._remarks.append(text)

    def _left(self) -> Iterator[str]:
        """Say of joints that have moved that they count from the new drawing, and what cannot."""
        for count, value in self._counts.items():
            joint, word = count.split(".")
            if abs(value) > SAME * (1.0 if word == "angle" else self._size):
                yield (
                    f"joints.{joint}: its {word} counts from the new drawing, in which it is "
                    f"{_by(value, count)} than from the old one"
                )
        for name, part in (*self._scene.contacts.items(), *self._scene.joints.items()):
            if isinstance(part, CamContact):
                body = (getattr(self._scene.joints[part.joint], "bodies", None) or (None,))[-1]
                turn = self._poses[body].angle if body in self._poses else 0.0
                if abs(turn) > ROUND_OFF:
                    yield (
                        f"contacts.{name}: the angle of its profile counts from +x of the new "
                        f"drawing, in which '{body}' has turned by {turn:.6g} rad; add "
                        f"{turn:.15g} to x in profiles.{part.profile}"
                    )
            if isinstance(part, Gear) and part.backlash is not None:
                first, second = (self._counts.get(f"{x}.angle", 0.0) for x in part.joints)
                turn = second - number(part.ratio, self._values) * first
                if abs(turn) > ROUND_OFF:
                    yield (
                        f"joints.{name}: its play lies about the new drawing, in which the second "
                        f"joint is turned by {turn:.6g} rad within the old play"
                    )


def rounded(x: float, size: float) -> float:
    """Return a number without the digits that are round-off next to this size."""
    if not abs(x) >= 10.0**-DIGITS * size:
        return 0.0
    return round(x, math.ceil(DIGITS - math.log10(size)))


def _by(value: float, count: str) -> str:
    unit = WORDS[count.rpartition(".")[2]]
    return f"{abs(value):.6g} {unit} {'less' if value > 0.0 else 'more'}"


def _owner_of(part: Any, field: str, body: str | None) -> str | None:
    """Body that a place or direction is fixed to: a plane is not that of what touches it."""
    if isinstance(part, Rolling) and field != "axis":
        return None
    is_on = isinstance(part, CornersContact | CylinderContact | EllipsoidContact)
    return part.on if is_on else body


def files_from(scene: Scene, folder: str) -> dict[Path, Written]:
    """Names of the files of a scene as they are from another folder, where they differ."""
    source = scene.source
    home, found = os.path.dirname(os.path.abspath(source.name)), dict[Path, Written]()
    if os.path.realpath(home) == os.path.realpath(folder):
        return found
    spans = spans_of(source.text, source.notation)
    paths = [("profiles", name, "file") for name, part in scene.profiles.items() if part.file]
    for name, part in scene.contacts.items():
        paths += [("contacts", name, word) for word in getattr(part, "files", ())]
    for path in paths:
        span = spans[path]
        given = value_of(source.text[span.begin : span.end], source.notation)
        name = str(given)
        if not name.startswith("data:") and not os.path.isabs(name):
            there = os.path.join(home, name)
            try:
                new = os.path.relpath(os.path.realpath(there), os.path.realpath(folder))
            except ValueError:  # Windows: another drive
                new = there
            found[path] = PurePath(new).as_posix()
    return found
