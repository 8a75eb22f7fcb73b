"""Where the parts of a scene are drawn, and which named points its places lie on.

A place on a body in global axes is that of the drawing: it is fixed to the body wherever the body
is drawn. On a named point of the body it means that point, so that it stays with the point where
parameters or overrides move the body, and a joint there that no longer fits is reported.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from solver.scene.expression import ExpressionError, Vector, symbols
from solver.scene.mistakes import Path
from solver.scene.numbers import Known, NumberChecks, times

if TYPE_CHECKING:
    from solver.scene.bodies import Rigid
    from solver.scene.draft import Draft

SAME = 1e-12
"""Distance of equal places, relative to their coordinates: the round-off of a rotation."""
DRAWN = 1e-9
"""Distance that rounding in the file explains, relative to a distance of named points."""
CLOSE = 0.1
"""Distance up to which a named point was perhaps meant, relative to that to its neighbour."""


@dataclass(frozen=True, slots=True)
class Seat:
    """Where a place lies on its body, with the default parameters."""

    point: str | None
    """The one named point that is there, "arm.tip"; of a bar the name of its end."""
    own: list[float] | None
    """Coordinates in the axes of a rigid body [m]."""


class Places(NumberChecks):
    """Judge of places as well, once points and bodies are read."""

    def __init__(self, draft: Draft, known: Known) -> None:
        super().__init__(draft, known)
        self.drawn: dict[str, Vector] = {}
        """Of points, origins of bodies, points of bodies and first ends of bars."""
        self.marks: dict[str, dict[str, list[float]]] = {}
        """Named points of each body, with their default coordinates."""
        self.rigid: dict[str, Rigid] = {}

    def add_bar(self, name: str, ends: tuple[str, str]) -> None:
        """Note where a bar is drawn."""
        if all(end in self.drawn for end in ends):
            self.drawn[name] = self.drawn[ends[0]]
            self._mark(name, ends)

    def add_rigid(self, name: str, body: Rigid) -> None:
        """Note where the origin of a body and its points are drawn."""
        self.drawn[name], self.rigid[name] = body.position, body
        for point, place in body.points.items():
            try:
                self.drawn[f"{name}.{point}"] = drawn_place(body, place)
            except (ExpressionError, ValueError):
                continue  # too large a number, or a vector of the wrong length: reported already
        self._mark(name, (f"{name}.{point}" for point in body.points))

    def _mark(self, body: str, points: Iterable[str]) -> None:
        places = {point: self.values(self.drawn.get(point, ())) or [] for point in points}
        size = len(self.zero())
        if len(self.drawn[body]) == size:
            self.marks[body] = {n: place for n, place in places.items() if len(place) == size}

    def point_at(self, path: Path, body: str | None, place: Vector) -> str | None:
        """Named point of a body that a place of the file means, if any.

        What lies close to one is warned of, and what an override moved on its body.
        """
        given = self.values(place)
        if body not in self.marks or not given or len(given) != len(self.zero()):
            return None
        seat = self._seat(path, body, place, given)
        if self.draft.seats is not None:
            self.draft.seats[path, body] = seat
        before = (self.draft.seats_of_file or {}).get((path, body), seat)
        if any(p[: len(path)] == path[: len(p)] for p in self.draft.source.overrides):
            before = seat  # an override gives the place itself
        if before.point in self.marks[body]:
            return before.point
        self._warn_of_a_move(path, body, before, seat)
        self._warn_of_a_neighbour(path, body, given)
        return None

    def _seat(self, path: Path, body: str, place: Vector, given: list[float]) -> Seat:
        marks = self.marks[body]
        there = [point for point, mark in marks.items() if same(mark, given)]
        point = there[0] if len(there) == 1 else None
        if point and not _symbols(place) <= _symbols(self.drawn[point]):
            point = None  # it goes its own way when parameters change
        asked = self.draft.seats is not None or self.draft.seats_of_file
        if body not in self.rigid or not asked:
            return Seat(point, None)
        rigid = self.rigid[body]

        def own() -> Vector:
            arm = tuple(x - y for x, y in zip(place, rigid.position, strict=True))
            return times(tuple(zip(*rigid.rotation, strict=True)), arm)

        return Seat(point, self.values(self.calculated(path, own, ())))

    def _warn_of_a_move(self, path: Path, body: str, before: Seat, seat: Seat) -> None:
        """Warn of a place that only fitted the pose which an override has replaced."""
        if not before.own or not seat.own:
            return
        gap = math.dist(before.own, seat.own)
        if gap <= DRAWN * max(map(abs, (*before.own, *seat.own))):
            return
        for replaced, text in self.draft.source.overrides.items():
            pose = replaced[2:3] in ((), ("position",), ("orientation",))
            if replaced[:2] == ("bodies", body) and pose:
                message = (
                    f"stays where it is drawn, and so lies {gap:.3g} m elsewhere on '{body}', "
                    f"which {text} has moved"
                )
                help = f"name a point of '{body}' there, which it then follows, or move it as well"
                self.draft.warn(path, message, help)
                return

    def _warn_of_a_neighbour(self, path: Path, body: str, given: list[float]) -> None:
        """Warn of a place next to a named point."""
        marks = self.marks[body]
        nearest = min(marks, key=lambda point: math.dist(marks[point], given), default="")
        if not nearest:
            return
        others = [*marks.values(), self.values(self.drawn[body]) or given]
        spans = [span for other in others if (span := math.dist(other, marks[nearest])) > 0.0]
        gap = math.dist(marks[nearest], given)
        if spans and DRAWN * min(spans) < gap <= CLOSE * min(spans):
            at = ", ".join(f"{x:.12g}" for x in marks[nearest])
            message = f"lies {gap:.3g} m beside the point '{nearest}', not on it"
            other = "" if body not in self.rigid else f", or name a point of '{body}' at this place"
            self.draft.warn(path, message, f"write [{at}], where the point is{other}")


def _symbols(place: Vector) -> frozenset[str]:
    return frozenset[str]().union(*map(symbols, place))


def same(a: list[float], b: list[float]) -> bool:
    """Compare places; those of points of bodies carry the round-off of a rotation."""
    size = max(map(abs, (*a, *b)))
    return all(abs(x - y) <= SAME * size for x, y in zip(a, b, strict=True))


def drawn_place(body: Rigid, place: Vector) -> Vector:
    """Global place in m, as drawn, of a place in the axes of a body."""
    return tuple(x + y for x, y in zip(body.position, times(body.rotation, place), strict=True))
