"""Closes the mechanism of a scene, and writes the closed pose into its text."""

from __future__ import annotations

import math
import os
import warnings
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from solver.files import write_whole, wrong_ending
from solver.mechanics.assembly import assemble_parts
from solver.mechanics.mobility import Survey, survey
from solver.runtime import Integrator, OptionError
from solver.runtime.layout import CLOSINGS
from solver.scene import (
    BodyJoint,
    CornersContact,
    CylinderContact,
    Point,
    PointReference,
    Rigid,
    Rolling,
    Scene,
    SceneWarning,
    load,
    loads,
)
from solver.scene.expression import evaluate
from solver.scene.positions import Path, spans_of
from solver.scene.rewriting import UnwrittenError, Written, less, rewritten

METHODS = {
    "at_once": "by the smallest displacement",
    "on_path": "on a path from the drawing",
    "behind_path": "from the end of a path from the drawing, at a dead centre",
    "shaken": "from a shaken drawing",
}
"""How a mechanism was closed, by the words of ``CLOSINGS``."""
ROUND_OFF = 1e-12
"""Of the size of the mechanism, or 1 rad: what moved by less stays as it is written."""
SAME = 1e-9
"""Likewise: by so much the closed pose may move when it is read again."""
COUNTED = {"drivers": ("value",), "contacts": ("min", "max")}
"""Fields of parts with a joint whose angle or displacement they count from the drawing."""
TABLES_WITH_PLACES = ("joints", "forces", "drivers", "contacts")

Turn = tuple[tuple[float, ...], ...]
"""Rotation matrix, row by row."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Closing:
    """A closed mechanism."""

    moved: dict[str, tuple[float, float]]
    """How far each point and body moved from its drawing [m], and the angle it turned by [rad]."""
    method: str
    """How it was closed, in words."""
    tries: int
    """Shaken drawings that were tried, to find a pose or others."""
    others: bool
    """Whether another pose is as near to the drawing."""
    freedoms: int | None
    """Degrees of freedom that joints and drivers leave; None of more than 2000 rows."""
    redundant: tuple[str, ...]
    """Parts whose rows depend on each other in the closed pose."""
    remarks: tuple[str, ...]
    """Formulas that numbers replace, and what counts from the drawing, which is another one now."""
    text: str
    """The scene with the closed pose."""


def close(
    scene: str | os.PathLike[str] | Scene, path: str | os.PathLike[str] | None = None
) -> Closing:
    """Close the mechanism of a scene; its text gets the closed places and velocities.

    Parameters
    ----------
    scene
        A scene file (.toml or .json) or a loaded scene.
    path
        File to write the closed scene into; None: none is written.

    Returns
    -------
    Closing
        What moved, how, and the text: positions, orientations and velocities are numbers in m, rad
        and s, all else, comments too, is as it was.

    Raises
    ------
    SceneError
        With every mistake of the scene; where no pose closes the mechanism, by how much each part
        misses in the best one; or where a place of the drawing cannot be written.
    OptionError
        If the name of the file does not end as the notation of the scene, .toml or .json.
    """
    drawn = scene if isinstance(scene, Scene) else load(scene)
    if path is not None and (wrong := wrong_ending(path, (f".{drawn.source.notation}",))):
        raise OptionError(wrong)
    closed, counts, integrator = _closed(drawn)
    poses = {name: _Pose.of(drawn, name, closed) for name in _moving(drawn)}
    size = max(integrator.numbers[integrator.model.offsets["extent"]], math.ulp(0.0))
    moved = {name: pose.moved for name, pose in poses.items()}
    edit = _Edit(drawn, poses, size)
    try:
        text = rewritten(drawn.source.text, drawn.source.notation, edit.values(closed))
    except UnwrittenError as error:
        message = "is written as a table of several lines, which is not replaced"
        help = "write it in one line, such as orientation = { axis = [0, 0, 1], angle = 0.1 }"
        drawn.fail([drawn.source.problem(error.path, message, help)])
    _check_again(drawn, text, closed, size)
    head = integrator.state.head
    result = Closing(
        moved=moved,
        method=METHODS[CLOSINGS[int(head["closing"])]],
        tries=int(head["closing_tries"]),
        others=bool(head["closing_others"]),
        freedoms=counts.degrees_of_freedom,
        redundant=counts.redundant_parts or (),
        remarks=(*edit.formulas(), *_counted_from_the_drawing(drawn, closed, size)),
        text=text,
    )
    if path is not None:
        write_whole(path, text)
    return result


def _closed(scene: Scene) -> tuple[dict[str, float], Survey, Integrator]:
    """Values of all outputs in the closed pose."""
    settings: Any = scene.solver  # a dataclass, as all parts of a scene
    scene = replace(scene, solver=replace(settings, assemble=True))
    model = assemble_parts(scene)[1]
    integrator = Integrator(model, log=lambda _: None)  # what moved is in the result
    integrator.initialise()
    indices = [k for k, v in enumerate(model.variables) if v.causality == "output"]
    names = (model.variables[k].name for k in indices)
    values = integrator.get(indices)
    numbers = {n: float(x) for n, x in zip(names, values, strict=True) if not isinstance(x, str)}
    return numbers, survey(model), integrator


def _moving(scene: Scene) -> Iterator[str]:
    yield from (name for name, point in scene.points.items() if not point.fixed)
    yield from (name for name, body in scene.bodies.items() if isinstance(body, Rigid))


def _axes(scene: Scene) -> str:
    return "xyz"[: scene.dimension]


# ------------------------------------------------------------------------------------------ poses


@dataclass(frozen=True, slots=True)
class _Pose:
    """Place of a point or body as drawn and closed [m], and its axes."""

    drawn: Sequence[float]
    place: Sequence[float]
    drawn_turn: Turn
    turn: Turn
    angle: float
    """By which it turned [rad]."""
    written_turn: Written | None
    """The closed orientation as a scene has it; None of a point."""

    @classmethod
    def of(cls, scene: Scene, name: str, closed: Mapping[str, float]) -> _Pose:
        """Pose of a part of the scene with these values."""
        values = scene.values()
        part: Point | Rigid = (scene.points | scene.bodies)[name]  # type: ignore[assignment]
        drawn = [_number(x, values) for x in part.position]
        place = [closed[f"{name}.{axis}"] for axis in _axes(scene)]
        unit = _identity(scene.dimension)
        if isinstance(part, Point):
            return cls(drawn, place, unit, unit, 0.0, None)
        before = tuple(tuple(_number(x, values) for x in row) for row in part.rotation)
        if scene.dimension == 2:
            angle = closed[f"{name}.angle"]
            c, s = math.cos(angle), math.sin(angle)
            whole = angle - math.atan2(before[1][0], before[0][0])
            by = math.remainder(whole, 2.0 * math.pi)
            # Without turns that a driver asks for: the closed scene counts from its own drawing.
            turns = round((whole - by) / (2.0 * math.pi))
            turn, written = ((c, -s), (s, c)), angle - 2.0 * math.pi * turns
        else:
            q = [closed[f"{name}.q{x}"] for x in "wxyz"]
            turn, written = _matrix(q), {"quaternion": q}
            by = _angle(_product(turn, _transposed(before)))
        return cls(drawn, place, before, turn, by, written)

    @property
    def moved(self) -> tuple[float, float]:
        """Way [m] and angle [rad]."""
        return math.dist(self.drawn, self.place), self.angle

    def carried(self, place: Sequence[float]) -> list[float]:
        """Where a place of the drawing that is fixed to the body lies in the closed pose."""
        arm = [x - y for x, y in zip(place, self.drawn, strict=True)]
        return [x + y for x, y in zip(self.place, self.turned(arm), strict=True)]

    def turned(self, direction: Sequence[float]) -> list[float]:
        """Direction of the closed pose that was drawn so."""
        return _times(self.turn, _times(_transposed(self.drawn_turn), direction))


def _number(x: Any, values: Mapping[str, float]) -> float:
    return float(evaluate(x, values))


def _identity(n: int) -> Turn:
    return tuple(tuple(float(i == k) for k in range(n)) for i in range(n))


def _transposed(turn: Turn) -> Turn:
    return tuple(zip(*turn, strict=True))


def _times(turn: Turn, x: Sequence[float]) -> list[float]:
    return [math.fsum(a * b for a, b in zip(row, x, strict=True)) for row in turn]


def _product(a: Turn, b: Turn) -> Turn:
    return _transposed(tuple(tuple(_times(a, column)) for column in _transposed(b)))


def _matrix(q: Sequence[float]) -> Turn:
    w, x, y, z = q
    return (
        (1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)),
        (2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)),
        (2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)),
    )


def _angle(turn: Turn) -> float:
    across = (turn[2][1] - turn[1][2], turn[0][2] - turn[2][0], turn[1][0] - turn[0][1])
    return math.atan2(math.hypot(*across), sum(turn[i][i] for i in range(3)) - 1.0)


# ------------------------------------------------------------------------------------------- text


class _Edit:
    """New values of a text, by their paths."""

    def __init__(self, scene: Scene, poses: Mapping[str, _Pose], size: float) -> None:
        self._scene, self._values, self._size = scene, scene.values(), size
        self._spans = spans_of(scene.source.text, scene.source.notation)
        self._poses = {
            name: pose
            for name, pose in poses.items()
            if pose.moved[0] > ROUND_OFF * size or abs(pose.moved[1]) > ROUND_OFF
        }
        self._new: dict[Path, Written] = {}

    def values(self, closed: Mapping[str, float]) -> dict[Path, Written]:
        """What is to be written, and where."""
        for name, pose in self._poses.items():
            table = "points" if name in self._scene.points else "bodies"
            if pose.moved[0] > ROUND_OFF * self._size:
                self._new[table, name, "position"] = list(pose.place)
            if pose.written_turn is not None and abs(pose.moved[1]) > ROUND_OFF:
                self._new[table, name, "orientation"] = pose.written_turn
        self._add_velocities(closed)
        for table in TABLES_WITH_PLACES:
            for name, part in getattr(self._scene, table).items():
                self._add_places(table, name, part)
        self._count_from_the_new_drawing(closed)
        return self._new

    def formulas(self) -> list[str]:
        """Say which formulas numbers replace."""
        text = self._scene.source.text
        return [
            f"{'.'.join(map(str, path))}: numbers replace {text[span.begin : span.end]}"
            for path, new in self._new.items()
            if not isinstance(new, str)
            and (span := self._spans.get(path))
            and '"' in text[span.begin : span.end]
        ]

    def _add_velocities(self, closed: Mapping[str, float]) -> None:
        """Write velocities at the start that are not those of the file."""
        scene, spins = self._scene, (["angular_velocity"] if self._scene.dimension == 2 else None)
        for name in _moving(scene):
            part: Any = (scene.points | scene.bodies)[name]
            table = "points" if name in scene.points else "bodies"
            kinds = [("velocity", [f"v{x}" for x in _axes(scene)])]
            if table == "bodies":
                kinds.append(("angular_velocity", spins or [f"w{x}" for x in _axes(scene)]))
            for field, names in kinds:
                found = [closed[f"{name}.{x}"] for x in names]
                given = getattr(part, field)
                before = [0.0] * len(found)
                if given is not None:
                    vector = given if isinstance(given, tuple) else (given,)
                    before = [_number(x, self._values) for x in vector]
                largest = max(map(abs, (*found, *before)))
                if math.dist(found, before) > SAME * max(largest, SAME):
                    plane = field == "angular_velocity" and scene.dimension == 2
                    self._new[table, name, field] = found[0] if plane else found

    def _count_from_the_new_drawing(self, closed: Mapping[str, float]) -> None:
        """Let drivers and stops of joints, which count from the drawing, mean what they did."""
        for table, fields in COUNTED.items():
            for name, part in getattr(self._scene, table).items():
                joint = getattr(part, "joint", None)
                for word, size in (("angle", 1.0), ("displacement", self._size)):
                    moved = closed.get(f"{joint}.{word}", 0.0)
                    for path in ((table, name, field) for field in fields):
                        if path in self._spans and abs(moved) > ROUND_OFF * size:
                            span, source = self._spans[path], self._scene.source
                            written = source.text[span.begin : span.end]
                            self._new[path] = less(written, source.notation, moved)

    def _add_places(self, table: str, name: str, part: Any) -> None:
        """Carry places and directions of a part with the bodies that they are fixed to."""
        ends = (*(getattr(part, "points", None) or ()), getattr(part, "point", None))
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
        axes = getattr(part, "axes", None)
        if isinstance(axes, tuple) and len(axes) == len(bodies) == 2:
            path = table, name, "axes"
            turned = []
            for body, axis in zip(bodies, axes, strict=True):
                numbers = [_number(x, self._values) for x in axis]
                turned.append(self._poses[body].turned(numbers) if body in self._poses else numbers)
            if path in self._spans and not self._poses.keys().isdisjoint(bodies):
                self._new[path] = turned

    def _carry_ends(self, path: Path, ends: Sequence[PointReference]) -> None:
        """Carry the places of one end or of both; with two, the file has a place for each."""
        if len(ends) == 1:
            self._carry(path, ends[0].point, ends[0].at, place=True)
        elif path in self._spans and any(end.point in self._poses for end in ends):
            places = [[_number(x, self._values) for x in end.at or ()] for end in ends]
            self._new[path] = [
                self._poses[end.point].carried(place) if end.point in self._poses else place
                for end, place in zip(ends, places, strict=True)
            ]

    def _carry(self, path: Path, body: str | None, value: Any, *, place: bool) -> None:
        if body not in self._poses or path not in self._spans or not isinstance(value, tuple):
            return
        numbers = [_number(x, self._values) for x in value]
        pose = self._poses[body]
        self._new[path] = pose.carried(numbers) if place else pose.turned(numbers)

    def _refuse(self, path: Path, bodies: Sequence[str | None]) -> None:
        for body in bodies:
            if body in self._poses:
                message = f"is of the drawing, and '{body}' moves from it when it is closed"
                help = f"draw '{body}' nearer to its place by hand, with what is fixed to it"
                self._scene.fail([self._scene.source.problem(path, message, help)])


def _owner_of(part: Any, field: str, body: str | None) -> str | None:
    """Body that a place or direction is fixed to: a plane is not that of what touches it."""
    if isinstance(part, Rolling) and field != "axis":
        return None
    return part.on if isinstance(part, CornersContact | CylinderContact) else body


def _counted_from_the_drawing(
    scene: Scene, closed: Mapping[str, float], size: float
) -> Iterator[str]:
    """Say which joints have moved: they count from the drawing, which is another one now."""
    for name in scene.joints:
        for word, unit, scale in (("angle", "rad", 1.0), ("displacement", "m", size)):
            value = closed.get(f"{name}.{word}", 0.0)
            if abs(value) > SAME * scale:
                yield (
                    f"joints.{name}: its {word} counts from the new drawing, in which it is "
                    f"{abs(value):.6g} {unit} {'less' if value > 0.0 else 'more'} than from the "
                    "old one; its drivers and stops were changed alike, but no other formulas "
                    "and springs that read it"
                )
    for name, force in scene.forces.items():
        for field in ("free_length", "free_angle"):
            if getattr(force, field, 0.0) is None:
                yield f"forces.{name}: its {field} is that of the drawing, which is another one now"


def _check_again(
    scene: Scene, text: str, closed: Mapping[str, float], size: float
) -> None:  # fmt: skip
    """Read the closed text again; it must need no closing."""
    source = scene.source
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", SceneWarning)  # the scene has them, too
        written = loads(
            text, name=source.name, format="json" if source.notation == "json" else "toml"
        )
    again = _closed(written)[0]
    for name in _moving(scene):
        gap = math.dist(*([x[f"{name}.{axis}"] for axis in _axes(scene)] for x in (closed, again)))
        if gap > SAME * size:
            message = (
                f"the closed pose cannot be written: read again, '{name}' moves by {gap:.3g} m, "
                "since a formula counts from the drawing; let what reads joints be 0 as drawn"
            )
            scene.fail([scene.error("", message)])
