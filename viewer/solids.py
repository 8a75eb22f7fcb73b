"""Solids of a drawing: shapes of bodies, of what touches, and of looks."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from solver.scene import Bar, Rigid
from solver.scene.inertia import Box, Cylinder, Disc, Rod, Round, Shape, Sphere
from solver.scene.looks import BoxLook, SphereLook, WheelLook
from viewer.places import Array, Place, Places, quaternion, some, tidy, turned_to

AXES: dict[str, Array] = dict(zip("xyz", np.eye(3), strict=True))
Z = AXES["z"]
FLAT = 0.04
"""Thickness of what is flat, over the size of the mechanism."""


def _body_of(look: Any) -> str:
    return (look.on.point or "").partition(".")[0]


class Solids:
    """Solids of a scene, each once."""

    def __init__(self, places: Places, held: dict[str, list[Array]], seen: list[Array]) -> None:
        self.places, self.scene, self.held = places, places.scene, held
        self.size = float(np.linalg.norm(np.ptp(seen, axis=0))) if seen else 0.0
        """Diagonal of the box around all places at the start, or the size of a single body."""
        self.solids: dict[str, dict[str, Any]] = {}
        self.size = self.size or max(map(self._own_size, self.scene.bodies.values()), default=1.0)
        self.colours = {name: k for k, name in enumerate(self.scene.bodies)}

    def add_bodies(self) -> None:
        """Add the shapes of all bodies, after what touches: a body may consist of that alone."""
        for name, body in some(self.scene.bodies.items()):
            if isinstance(body, Rigid):
                self._body(name, body)

    def add_look(self, name: str, look: Any) -> None:
        """Add a shape that is there for the drawing alone."""
        place, body = self.places.fixed_to(*self._of_look(look)), _body_of(look)
        axis = getattr(look, "axis", None)
        turn = turned_to(Z if axis is None else self.places.direction(axis))

        def add(shape: str, **fields: Any) -> None:
            self.add(name, "look", body, place, shape, turn, look.opacity, look.colour, **fields)

        numbers = {
            word: self.places.number(getattr(look, word))
            for word in ("radius", "inner_radius", "length", "width")
            if hasattr(look, word)
        }
        if isinstance(look, BoxLook):
            size = self.places.vector(look.size)
            size[2] = size[2] or self.thickness(0.0)
            add("box", size=size)
        elif isinstance(look, WheelLook):
            radius, width = numbers["radius"], numbers["width"]
            add("cylinder", radius=radius, inner_radius=0.65 * radius, length=width)
            add("cylinder", radius=0.65 * radius, length=0.15 * width)
            add("box", size=(1.3 * radius, 0.12 * radius, 0.4 * width))
        else:
            add("sphere" if isinstance(look, SphereLook) else "cylinder", **numbers)

    def thickness(self, otherwise: float) -> float:
        """Return the thickness of what is flat in the plane; in space another one."""
        return FLAT * self.size if self.scene.dimension == 2 else otherwise

    def add(
        self, owner: str, kind: str, body: str | None, place: Place, shape: str,
        turn: Array | None = None, opacity: float = 1.0, colour: str = "", **fields: Any,
    ) -> None:  # fmt: skip
        """Add a solid of a body, unless an equal one is there."""
        sizes = {word: tidy(x) for word, x in fields.items()}
        where = {
            **place, "turn": tidy(quaternion(np.eye(3) if turn is None else turn)),
            "shape": shape, **sizes,
        }  # fmt: skip
        known = {"owner": owner, "kind": kind, **where, "opacity": opacity}
        known["colour"] = colour or self.colours.get(body or "", -1)
        self.solids.setdefault(str(where), known)

    # ----------------------------------------------------------------------------- bodies

    def _own_size(self, body: Bar | Rigid) -> float:
        """Twice the radius of gyration [m]: the size of a body that nothing holds."""
        if isinstance(body, Bar):
            return 1.0
        moments, _ = self._principal(body)
        return (
            2.0 * math.sqrt(max(0.0, float(moments.max())) / self.places.number(body.mass)) or 1.0
        )

    def _principal(self, body: Rigid) -> tuple[Array, Array]:
        """Principal moments of inertia and their axes."""
        if not isinstance(body.inertia, tuple):
            moment = self.places.number(body.inertia)
            return np.array((0.5 * moment, 0.5 * moment, moment)), np.eye(3)
        rows = [[self.places.number(x) for x in row] for row in body.inertia]
        moments, axes = np.linalg.eigh(np.array(rows))
        axes[:, 0] *= np.sign(np.linalg.det(axes))
        return moments, axes

    def _body(self, name: str, body: Rigid) -> None:
        centre = self.places.vector(body.center_of_mass)
        held = [*self.held[name], *map(self.places.vector, body.points.values())]
        place = self.places.fixed_to(self.places.frame(name), centre)
        reach = -1.0
        if body.shape is not None:
            reach = self._shape(name, place, body.shape)
        looks = [x for x in self.scene.looks.values() if _body_of(x) == name]
        reach = max([reach, *(self._covered(look, centre) for look in looks)])
        far = [x for x in held if np.linalg.norm(x - centre) > max(reach, 1e-9 * self.size)]
        far = [x for k, x in enumerate(far) if all(np.linalg.norm(x - y) for y in far[:k])]
        if far:
            self.add(name, "body", name, place, "struts", to=far)
        if far or looks or reach >= 0.0:
            return
        if all(x["frame"] != place["frame"] for x in self.solids.values()):
            self._ellipsoid(name, body, place)

    def _covered(self, look: Any, centre: Array) -> float:
        """Radius about the mass centre of what a look hides; 0 if one sees through it."""
        if look.opacity < 1.0:
            return 0.0
        number, at = self.places.number, self._of_look(look)[1]
        size = self.places.vector(look.size) if isinstance(look, BoxLook) else np.zeros(3)
        radius, length = (number(getattr(look, x, 0.0)) for x in ("radius", "length"))
        own = max(0.5 * float(np.linalg.norm(size)), math.hypot(radius, 0.5 * length))
        return own * (1.0 + 1e-9) - float(np.linalg.norm(at - centre))

    def _of_look(self, look: Any) -> tuple[int, Array]:
        """Frame of a look and its place there."""
        on = look.on.point
        place = self.places.named(on) if on else self.places.fixed_to(0, np.zeros(3))
        return place["frame"], np.array(place["at"], float) + self.places.vector(look.at)

    def _ellipsoid(self, name: str, body: Rigid, place: Place) -> None:
        """Add the box, in the plane the disc, of the same inertia."""
        moments, axes = self._principal(body)
        over = moments / self.places.number(body.mass)
        least = 0.02 * self.size
        if self.scene.dimension == 2:
            radius = max(math.sqrt(2.0 * over[2]), least)
            self.add(name, "body", name, place, "cylinder", radius=radius, length=FLAT * self.size)
        else:
            edges = np.sqrt(np.maximum(6.0 * (over.sum() - 2.0 * over), least * least))
            self.add(name, "body", name, place, "box", axes, size=edges)

    def _shape(self, name: str, place: Place, shape: Shape) -> float:
        """Add the shape of a body; return the radius of a ball around it."""
        number, flat = self.places.number, FLAT * self.size
        turn, kind = np.eye(3), "cylinder"
        fields: dict[str, Any] = {}
        if isinstance(shape, Round):
            fields = {"radius": number(shape.radius)}
            if inner := number(shape.inner_radius):
                fields["inner_radius"] = inner
        if isinstance(shape, Box):
            size = self.places.vector(shape.size)
            size[2] = size[2] or flat
            kind, fields = "box", {"size": size}
            reach = 0.5 * float(np.linalg.norm(size))
        elif isinstance(shape, Cylinder):
            fields["length"] = number(shape.length)
            turn = turned_to(AXES[shape.axis])
            reach = math.hypot(fields["radius"], 0.5 * fields["length"])
        elif isinstance(shape, Sphere):
            kind, reach = "sphere", fields["radius"]
        elif isinstance(shape, Disc):
            reach, fields["length"] = fields["radius"], flat
        else:
            assert isinstance(shape, Rod)
            length = number(shape.length)
            reach, kind = 0.5 * length, "box"
            fields = {"size": (length, flat, flat)}
        self.add(name, "body", name, place, kind, turn, **fields)
        return reach * (1.0 + 1e-9)
