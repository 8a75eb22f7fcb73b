"""Points, bars and rigid bodies of a scene: what they are made of and where they are drawn."""

from __future__ import annotations

from typing import Any

from solver.scene import schema_bodies as schema
from solver.scene.fields import BROKEN
from solver.scene.geometry import Geometry
from solver.scene.inertia import read_weight
from solver.scene.numbers import GEOMETRY, NOT_NEGATIVE, POSITIVE
from solver.scene.orientation import read_orientation, read_spin
from solver.scene.references import References
from solver.scene.vocabulary_parts import Bar, Body, Point, Rigid


class Bodies:
    """Reader of the tables [points] and [bodies]."""

    def __init__(self, geometry: Geometry, references: References, gravity: Any) -> None:
        self.geometry = geometry
        self.references = references
        self.draft = geometry.draft
        self.parts: dict[str, dict[str, Any]] = {
            table: geometry.draft.parts(table) for table in ("points", "bodies")
        }
        self._forgotten_dimension(gravity)

    def _forgotten_dimension(self, gravity: Any) -> None:
        """Say once, not at every vector, that a planar scene does not call itself planar."""
        places = [
            (table, part.position)
            for table, parts in self.parts.items()
            for part in parts.values()
            if getattr(part, "position", BROKEN) is not BROKEN
        ]
        if gravity not in (None, BROKEN):
            places.append(("gravity", gravity))
        lengths = {len(vector) for _, vector in places}
        if lengths == {2} and "dimension" not in self.draft.data:
            self.geometry.dimension = 2
            what = "gravity has" if places[0][0] == "gravity" else "positions have"
            message = f"{what} 2 numbers, but the scene has dimension 3 (the default)"
            help = "write dimension = 2 at the top of the file"
            self.draft.error((places[0][0],), message, help)

    def read(self) -> tuple[dict[str, Point], dict[str, Body]]:
        """Read points and bodies, and note where they are drawn."""
        points = {name: self._point(name, part) for name, part in self.parts["points"].items()}
        bodies = {name: self._body(name, part) for name, part in self.parts["bodies"].items()}
        return points, bodies

    def _point(self, name: str, part: schema.Point) -> Point:
        path, geometry = ("points", name), self.geometry
        position = geometry.vector((*path, "position"), part.position)
        velocity = geometry.optional((*path, "velocity"), part.velocity)
        mass = geometry.numbers.optional((*path, "mass"), part.mass, GEOMETRY, NOT_NEGATIVE, "kg")
        if part.fixed is True:
            self.references.fixed.add(name)
            if any(component != 0.0 for component in velocity or ()):
                message = "a fixed point cannot have a velocity"
                self.draft.error((*path, "velocity"), message, "leave out velocity or fixed")
        if part.position is not BROKEN:
            self.references.places.drawn[name] = position
        return Point(
            position=position,
            velocity=geometry.zero() if velocity is None else velocity,
            mass=0.0 if mass is None else mass,
            fixed=part.fixed is True,
            velocity_given=velocity is not None,
        )

    def _body(self, name: str, part: Any) -> Body:
        return self._bar(name, part) if isinstance(part, schema.Bar) else self._rigid(name, part)

    def _bar(self, name: str, part: schema.Bar) -> Bar:
        path, mass_at = ("bodies", name), ("bodies", name, "mass")
        mass = self.geometry.numbers.number(mass_at, part.mass, GEOMETRY, POSITIVE, "kg")
        if part.points is BROKEN:
            return Bar(points=("", ""), mass=mass)
        first, second = part.points
        for i, point in enumerate(part.points):
            self._end_of_a_bar(("bodies", name, "points", i), point)
        if first == second:
            self.draft.error((*path, "points"), f"both ends are '{first}'")
        elif {first, second} <= self.references.fixed:
            message = f"both ends are fixed ('{first}' and '{second}'): the bar cannot move"
            self.draft.error((*path, "points"), message)
        self.references.places.add_bar(name, (first, second))
        return Bar(points=(first, second), mass=mass)

    def _end_of_a_bar(self, path: tuple[str | int, ...], point: str) -> None:
        if point == "ground":
            message = "a bar ends in points, not in 'ground'"
            self.draft.error(path, message, "make a point with fixed = true")
        elif self.references.exists(path, point) and self.references.owner(point) is not None:
            message = f"a bar ends in points of the table [points], not in '{point}' of a body"
            help = "end it in a point of [points], and join the two with points = [...]"
            self.draft.error(path, message, help)

    def _rigid(self, name: str, part: schema.Rigid) -> Rigid:
        path, geometry = ("bodies", name), self.geometry
        position = geometry.vector((*path, "position"), part.position)
        orientation = read_orientation(geometry, (*path, "orientation"), part.orientation)
        center = geometry.optional((*path, "center_of_mass"), part.center_of_mass)
        mass, inertia = read_weight(geometry, path, part)
        spin_at = (*path, "angular_velocity")
        spin = read_spin(geometry, spin_at, part.angular_velocity, orientation)
        given = {} if part.points is BROKEN else part.points
        points = {
            point: geometry.vector((*path, "points", point), place)
            for point, place in given.items()
        }
        body = Rigid(
            mass=mass,
            inertia=inertia,
            center_of_mass=geometry.zero() if center is None else center,
            position=position,
            orientation=orientation,
            velocity=geometry.optional((*path, "velocity"), part.velocity),
            angular_velocity=spin,
            points=points,
        )
        if part.position is not BROKEN:
            self.references.places.add_rigid(name, body)
        return body
