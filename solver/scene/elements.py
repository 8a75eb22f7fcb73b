"""Points, bars, joints and forces of a scene: what they refer to and whether it makes sense."""

from __future__ import annotations

from typing import Any

from solver.scene import schema
from solver.scene.expression import ExpressionError, Number, evaluate
from solver.scene.fields import BROKEN, shown
from solver.scene.numbers import FORCE, GEOMETRY, NOT_NEGATIVE, POSITIVE, Numbers, Place
from solver.scene.report import Path, did_you_mean
from solver.scene.vocabulary import (
    Bar,
    Body,
    Damper,
    Distance,
    Force,
    ForceElement,
    Joint,
    Point,
    PointReference,
    Spring,
    Torque,
    Vector,
)


class Elements:
    """Reader of the mechanical tables of one scene."""

    def __init__(self, numbers: Numbers, dimension: Any) -> None:
        self.numbers = numbers
        self.draft = numbers.draft
        self.known = numbers.known
        self.dimension = None if dimension is BROKEN else dimension
        """None: broken, so that vectors may have two or three numbers."""
        self.drawn: dict[str, Any] = self.draft.parts("points")
        self._forgotten_dimension()
        self.fixed: set[str] = set()
        self.positions: dict[str, Vector] = {}

    def read(
        self,
    ) -> tuple[dict[str, Point], dict[str, Body], dict[str, Joint], dict[str, ForceElement]]:
        """Read all mechanical tables."""
        draft = self.draft
        points = {name: self._point(name, part) for name, part in self.drawn.items()}
        self.positions = {name: point.position for name, point in points.items()}
        bodies = {name: self._bar(name, part) for name, part in draft.parts("bodies").items()}
        joints = {name: self._distance(name, part) for name, part in draft.parts("joints").items()}
        forces = {name: self._force(name, part) for name, part in draft.parts("forces").items()}
        self._something_moves(points)
        self._free_points_have_mass(bodies)
        return points, bodies, joints, forces

    def _forgotten_dimension(self) -> None:
        """Say once, not at every vector, that a planar scene does not call itself planar."""
        positions = [part.position for part in self.drawn.values()]
        lengths = [len(position) for position in positions if position is not BROKEN]
        if lengths and set(lengths) == {2} and "dimension" not in self.draft.data:
            self.dimension = 2
            message = "positions have 2 numbers, but the scene has dimension 3 (the default)"
            self.draft.error(("points",), message, "write dimension = 2 at the top of the file")

    def zero(self) -> Vector:
        """Return the zero vector of the scene's dimension."""
        return (0.0,) * (self.dimension or 3)

    def vector(self, path: Path, readings: Any, place: Place) -> Vector:
        """Read a vector of the scene's dimension."""
        wanted = self.dimension or 3
        if readings is BROKEN:
            return (0.0,) * wanted
        if len(readings) != wanted and not (self.dimension is None and len(readings) == 2):
            message = f"must have {wanted} numbers in dimension {wanted}, got {len(readings)}"
            self.draft.error(path, message)
        return tuple(
            self.numbers.number((*path, i), reading, place) for i, reading in enumerate(readings)
        )

    def _point(self, name: str, part: schema.Point) -> Point:
        path = ("points", name)
        position = self.vector((*path, "position"), part.position, GEOMETRY)
        velocity = self.zero()
        if part.velocity is not None:
            velocity = self.vector((*path, "velocity"), part.velocity, GEOMETRY)
        mass = self.numbers.optional((*path, "mass"), part.mass, GEOMETRY, NOT_NEGATIVE, "kg")
        if part.fixed is True:
            self.fixed.add(name)
            if any(component != 0.0 for component in velocity):
                message = "a fixed point cannot have a velocity"
                self.draft.error((*path, "velocity"), message, "leave out velocity or fixed")
        return Point(
            position=position,
            velocity=velocity,
            mass=0.0 if mass is None else mass,
            fixed=part.fixed is True,
        )

    def _known_point(self, path: Path, name: str) -> bool:
        """Report a name that is no point."""
        kind = self.known.parts.get(name)
        if kind == "point":
            return True
        if kind is not None:
            self.draft.error(path, f"'{name}' is a {kind}, not a point")
        else:
            help = did_you_mean(name, self.known.of("point"), "known points")
            self.draft.error(path, f"unknown point '{name}'", help)
        return False

    def _bar(self, name: str, part: schema.Bar) -> Body:
        path = ("bodies", name)
        mass = self.numbers.number((*path, "mass"), part.mass, GEOMETRY, POSITIVE, "kg")
        if part.points is BROKEN:
            return Bar(points=("", ""), mass=mass)
        first, second = part.points
        for i, point in enumerate(part.points):
            if point == "ground":
                message = "a bar ends in points, not in 'ground'"
                self.draft.error((*path, "points", i), message, "make a point with fixed = true")
            else:
                self._known_point((*path, "points", i), point)
        if first == second:
            self.draft.error((*path, "points"), f"both ends are '{first}'")
        elif {first, second} <= self.fixed:
            message = f"both ends are fixed ('{first}' and '{second}'): the bar cannot move"
            self.draft.error((*path, "points"), message)
        return Bar(points=(first, second), mass=mass)

    def _distance(self, name: str, part: schema.Distance) -> Joint:
        path = ("joints", name)
        length = (*path, "length")
        return Distance(
            points=self._ends(path, part),
            length=self.numbers.optional(length, part.length, GEOMETRY, POSITIVE, "m"),
        )

    def _force(self, name: str, part: schema.Part) -> ForceElement:
        path = ("forces", name)
        number, optional = self.numbers.number, self.numbers.optional
        if isinstance(part, schema.Spring):
            return Spring(
                points=self._ends(path, part),
                stiffness=number((*path, "stiffness"), part.stiffness, FORCE, NOT_NEGATIVE, "N/m"),
                free_length=optional(
                    (*path, "free_length"), part.free_length, FORCE, NOT_NEGATIVE, "m"
                ),
            )
        if isinstance(part, schema.Damper):
            damping = number((*path, "damping"), part.damping, FORCE, NOT_NEGATIVE, "N.s/m")
            return Damper(points=self._ends(path, part), damping=damping)
        if isinstance(part, schema.Force):
            return self._point_force(path, part)
        assert isinstance(part, schema.Torque)
        return self._torque(path, part)

    def _point_force(self, path: Path, part: schema.Force) -> Force:
        known = part.point is not BROKEN and self._known_point((*path, "point"), part.point)
        if known and part.point in self.fixed:
            self.draft.error((*path, "point"), f"a force on the fixed point '{part.point}'")
        return Force(point=part.point, value=self.vector((*path, "value"), part.value, FORCE))

    def _torque(self, path: Path, part: schema.Torque) -> Torque:
        kind = None if part.body is BROKEN else self.known.parts.get(part.body)
        if part.body is not BROKEN and kind != "bar":
            help = did_you_mean(part.body, self.known.of("bar"), "known bodies")
            message = f"'{part.body}' is a {kind}, not a body" if kind else None
            self.draft.error((*path, "body"), message or f"unknown body '{part.body}'", help)
        where, value = (*path, "value"), part.value
        if value is BROKEN:
            return Torque(body=part.body, value=0.0)
        if isinstance(value, list):
            if self.dimension == 2:
                self.draft.error(where, "must be a number in dimension 2, got a vector")
                return Torque(body=part.body, value=0.0)
            return Torque(body=part.body, value=self.vector(where, value, FORCE))
        if self.dimension == 3:
            help = 'write value = [0, 0, "..."]'
            self.draft.error(where, "must be a vector of 3 numbers in dimension 3", help)
        return Torque(body=part.body, value=self.numbers.number(where, value, FORCE))

    def _ends(self, path: Path, part: Any) -> tuple[PointReference, PointReference]:
        """Read the two ends of a joint or force."""
        if part.points is BROKEN:
            return PointReference(point=None), PointReference(point=None)
        first, second = part.points
        for i, point in enumerate(part.points):
            if point != "ground":
                self._known_point((*path, "points", i), point)
        if first == second:
            self.draft.error((*path, "points"), f"both ends are '{first}'")
        elif {first, second} <= self.fixed | {"ground"}:
            self.draft.error((*path, "points"), f"both ends are fixed: '{first}' and '{second}'")
        places = self._places(path, part)
        return (
            PointReference(point=None if first == "ground" else first, at=places[0]),
            PointReference(point=None if second == "ground" else second, at=places[1]),
        )

    def _places(self, path: Path, part: Any) -> tuple[Vector | None, Vector | None]:
        """Read `at`: the place of 'ground', alone or in a list with one place for each end."""
        where, points = (*path, "at"), part.points
        if part.at is BROKEN:
            return None, None
        if part.at is None:
            if "ground" in points:
                message = "'at' is missing: the place of 'ground'"
                self.draft.error(path, message, f"write at = {shown([0] * len(self.zero()))}")
            return None, None
        if "ground" not in points:
            self.draft.error(where, "'at' is the place of 'ground', which is no end here")
            return None, None
        if not isinstance(part.at[0] if part.at else None, list):
            place = self.vector(where, part.at, GEOMETRY)
            return (place, None) if points[0] == "ground" else (None, place)
        if len(part.at) != 2:
            self.draft.error(where, f"must have one place for each end, got {len(part.at)}")
            return None, None
        first, second = (self.vector((*where, i), at, GEOMETRY) for i, at in enumerate(part.at))
        self._same_place((*where, 0), first, points[0])
        self._same_place((*where, 1), second, points[1])
        return first if points[0] == "ground" else None, second if points[1] == "ground" else None

    def _same_place(self, path: Path, at: Vector, point: str) -> None:
        """A place given for a point must be where the point is drawn (with the defaults)."""
        drawn = self.positions.get(point)
        if drawn is None:
            return
        try:
            pairs = [[self._value(x), self._value(y)] for x, y in zip(at, drawn, strict=False)]
        except (ExpressionError, KeyError):
            return
        if any(x != y for x, y in pairs):
            message = f"point '{point}' is drawn at {shown([y for _, y in pairs])}"
            self.draft.error(path, message, "give the place of 'ground' alone")

    def _value(self, number: Number) -> float:
        return evaluate(number, self.known.values)

    def _something_moves(self, points: dict[str, Point]) -> None:
        if not isinstance(self.draft.data.get("points", {}), dict):
            return
        if not self.draft.data.get("points"):
            self.draft.error((), "no points: nothing can move", "write a table [points]")
        elif points and all(point.fixed for point in points.values()):
            self.draft.error(("points",), "all points are fixed: nothing can move")

    def _free_points_have_mass(self, bodies: dict[str, Body]) -> None:
        """Report points that certainly have no mass: neither their own nor that of a bar."""
        if len(bodies) < len(self.known.of("bar")) or any("" in b.points for b in bodies.values()):
            return
        carried = {point for body in bodies.values() for point in body.points}
        for name, part in self.drawn.items():
            if not self.draft.data["points"][name].keys() <= schema.Point.model_fields.keys():
                continue  # a misspelt mass is reported already
            nothing = part.mass is None or (part.mass is not BROKEN and part.mass.number == 0.0)
            if nothing and part.fixed is False and name not in carried:
                message = f"free point '{name}' has no mass"
                self.draft.error(("points", name), message, "give it a mass, a bar or fixed = true")
