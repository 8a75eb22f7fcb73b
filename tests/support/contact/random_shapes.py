"""Random mechanisms of shapes that touch: boxes, drums, eggs, capsules, meshes, journals.

A scene has groups of shapes beside those of `RandomContacts`, some of them on belts, held by
joints that rub, or moved by drivers.
"""

from __future__ import annotations

import math
import random
from pathlib import Path
from typing import Any

from tests.support.contact.random_contacts import Content, RandomContacts

CORNERS = [(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
SIDES = (
    *((1, 2, 4, 3), (5, 7, 8, 6), (1, 5, 6, 2)),
    *((3, 4, 8, 7), (1, 3, 7, 5), (2, 6, 8, 4)),
)


def write_box(folder: Path) -> Path:
    """Write a box of 0.6 x 0.6 x 0.2 m about the origin as a mesh and return its path."""
    lines = [f"v {0.3 * x} {0.3 * y} {0.1 * z}" for x, y, z in CORNERS]
    lines += [f"f {' '.join(map(str, side))}" for side in SIDES]
    path = folder / "box.obj"
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return path


class RandomShapes(RandomContacts):
    """One random scene, with a mesh if there is a file of one."""

    def __init__(
        self, chance: random.Random, *, wild: bool = False, mesh: Path | None = None
    ) -> None:
        self.mesh, self.bodies = mesh, 0
        super().__init__(chance, wild=wild)

    def _group(self) -> None:
        if self.chance.random() < 0.4:
            super()._group()
            return
        both = [self._box, self._egg, self._capsules, self._boxes, self._pendulum, self._dish]
        both += [self._rod, self._rod, self._parked, self._parked]
        more = [self._polygons, self._bearing] if self.dim == 2 else [self._drum, self._journal]
        more += [self._on_mesh] if self.mesh and self.dim == 3 else []
        self.bodies += 1
        self.chance.choice(both + more)([4.0 * self.size * (3 + self.bodies), *self._zero[1:]])

    def _settings(self) -> None:
        super()._settings()
        settings, g = self.content["solver"], self.content["gravity"]
        if self.chance.random() < 0.7:
            settings["order"] = 2
        if self.chance.random() < 0.7:
            settings["rest_time"] = 0.0
        if self.chance.random() < 0.4:  # all floors are slopes
            slope = self._number(0, 0.8)
            g[0], g[-1] = -math.sin(slope) * g[-1], math.cos(slope) * g[-1]

    def _contacts(self) -> None:
        super()._contacts()
        contacts = list(self.content["contacts"].items())
        if self.chance.random() < 0.3:
            self.chance.shuffle(contacts)
        self.content["contacts"] = dict(contacts)

    # ------------------------------------------------------------------------------- helpers

    @property
    def _zero(self) -> list[float]:
        return [0.0] * self.dim

    @property
    def _up(self) -> list[float]:
        return [*self._zero[1:], 1.0]

    def _lifted(self, at: list[float], height: float) -> list[float]:
        return [*at[:-1], at[-1] + height]

    def _height(self) -> float:
        """Return a way to fall [m]."""
        return self.size * self.chance.choice((0.0, 0.0, 1e-3, 0.05))

    def _falling(self) -> Content:
        """Return velocities of what falls, slides and spins."""
        velocity = self._velocity()
        velocity[-1] = -abs(velocity[-1])
        more: Content = {"velocity": velocity}
        if self.chance.random() < 0.6:
            more["angular_velocity"] = self._spin()
        return more

    def _turned(self) -> Content:
        if self.chance.random() < 0.4:
            return {}
        turn = [self._number(-1, 1) for _ in range(3)]
        return {"orientation": turn[0] if self.dim == 2 else {"rotation_vector": turn}}

    def _edges(self) -> list[float]:
        return [self.size * self._number(0.1, 0.5) for _ in range(self.dim)]

    def _touch(self, kind: str, **more: Any) -> None:
        """Add a contact that may rub."""
        contact: Content = {"type": kind, **more}
        self._contact(contact, True)
        if "friction" not in contact:
            contact.pop("collar_radius", None)
            return
        if "axis" in contact and kind != "journal" and self.chance.random() < 0.2:
            speed = self.chance.choice((0.5, -1.0, "0.5*sin(2*t)"))
            contact["surface_velocity"] = [speed, *self._zero[1:]]

    def _floor(self, at: list[float]) -> Content:
        return {"axis": self._up, "position": at}

    # -------------------------------------------------------------------------------- groups

    def _rod(self, at: list[float]) -> None:
        """A rod that hits a floor aslant, with much restitution and friction of any strength."""
        chance, length = self.chance, self.size * self._number(0.3, 1)
        turn, velocity = self._number(0.1, 1.4), self._velocity()
        velocity[-1] = -abs(velocity[-1]) - 0.5
        tip = [length * math.cos(turn), *self._zero[2:], length * math.sin(turn)]
        low = self._lifted(at, self._height())
        ends = [
            self._add_point(place, mass=0.0, velocity=velocity)
            for place in (low, [a + b for a, b in zip(low, tip, strict=True)])
        ]
        bar = {"type": "bar", "points": ends, "mass": self._mass()}
        self.content["bodies"][f"bar{ends[0]}"] = bar
        laws = {
            "restitution": chance.choice((0.5, 0.9, 1.0)),
            "friction": chance.choice((1e-9, 0.1, 0.3, 0.5, 1.0)),
        }
        for end in ends:
            contact = {"type": "plane", "point": end, **self._floor(at), **laws}
            self.content["contacts"][f"c{len(self.content['contacts'])}"] = contact

    def _parked(self, at: list[float]) -> None:
        """A box that stands on a floor, and maybe another one on it."""
        friction = self._number(0, 0.8)
        laws = {"friction": friction, "static_friction": friction * self._number(1, 2)}
        edges, on = [self.size * self._number(0.2, 0.5) for _ in range(self.dim)], "ground"
        for _ in range(self.chance.choice((1, 1, 2))):
            place = self._lifted(at, 0.5 * edges[-1])
            name = self._add_body(place, {}, 0.5 * edges[-1])
            contact = {"type": "corners", "body": name, "size": edges, "on": on}
            contact |= {**self._floor(at), **laws}
            self.content["contacts"][f"c{len(self.content['contacts'])}"] = contact
            at, on = self._lifted(at, edges[-1]), name
            edges = [*(0.8 * x for x in edges[:-1]), edges[-1]]

    def _box(self, at: list[float]) -> None:
        """A box that falls on a floor, flat or on a corner."""
        edges, turn = self._edges(), self._turned()
        reach = 0.5 * (math.hypot(*edges) if turn else edges[-1])
        place = self._lifted(at, reach + self._height())
        name = self._add_body(place, {}, reach, **turn, **self._falling())
        self._touch("corners", body=name, size=edges, **self._floor(at))

    def _egg(self, at: list[float]) -> None:
        """An ellipsoid on a floor, and maybe against a ball."""
        axes, turn = [0.5 * x for x in self._edges()], self._turned()
        reach = max(axes) if turn else axes[-1]
        place = self._lifted(at, reach + self._height())
        name = self._add_body(place, {}, reach, **turn, **self._falling())
        self._touch("ellipsoid", body=name, semi_axes=axes, **self._floor(at))
        if self.chance.random() < 0.4:
            beside = [place[0] + 1.5 * max(axes) + 0.2 * self.size, *place[1:]]
            inward = [-abs(self.speed), *self._zero[1:]]
            ball = self._add_point(beside, mass=self._mass(), velocity=inward)
            self._touch("ellipsoid", body=name, semi_axes=axes, point=ball, radius=0.1 * self.size)

    def _capsules(self, at: list[float]) -> None:
        """Two rods that meet, one of them maybe fixed."""
        length, radius = self.size * self._number(0.1, 0.4), self.size * self._number(0.02, 0.1)
        segment = [[-length, *self._zero[1:]], [length, *self._zero[1:]]]
        above = self._lifted(at, math.hypot(0.6 * length, 2 * radius) + length + self._height())
        first = self._add_body(above, {}, length, **self._turned(), **self._falling())
        other = "ground"
        segments = [segment, [[a + b for a, b in zip(at, end, strict=True)] for end in segment]]
        if self.chance.random() < 0.7:
            other = self._add_body(list(at), {}, length, velocity=[-x for x in self._velocity()])
            segments[1] = segment
        if self.chance.random() < 0.2:
            segments[0] = [self._zero]
        self._touch("capsule", bodies=[first, other], segments=segments, radii=[radius, radius])

    def _boxes(self, at: list[float]) -> None:
        """A box that falls on another one, or on a rod."""
        edges, below = self._edges(), [1.2 * x for x in self._edges()]
        turn, rod = self._turned(), self.chance.random() < 0.4
        reach = 0.5 * (math.hypot(*edges) if turn else edges[-1])
        radius = 0.05 * self.size
        if rod:
            half = 0.5 * below[0]
            place = self._lifted(at, reach + radius + self._height())
            more: Content = {
                "sizes": [edges],
                "segment": [[-half, *self._zero[1:]], [half, *self._zero[1:]]],
                "radii": [0.0, radius],
            }
        else:
            place = self._lifted(at, reach + 0.5 * below[-1] + self._height())
            more = {"sizes": [edges, below]}
        upper = self._add_body(place, {}, reach, **turn, **self._falling())
        lower = self._add_body(list(at), {}, 0.5 * max(below))
        self._touch("box", bodies=[upper, lower], **more)
        axis = {} if self.dim == 2 else {"axis": [0, 1, 0]}
        joint = {"type": self.chance.choice(("fixed", "revolute")), "bodies": ["ground", lower]}
        joint |= {"position": at} | (axis if joint["type"] == "revolute" else {})
        self.content["joints"][f"j{lower}"] = joint

    def _polygons(self, at: list[float]) -> None:
        """A triangle that falls on a square."""
        r = 0.2 * self.size
        corners = [[[-r, -r], [r, -r], [0.0, r]], [[-r, -r], [r, -r], [r, r], [-r, r]]]
        place = self._lifted(at, 2.6 * r + self._height())
        upper = self._add_body(place, {}, r, **self._turned(), **self._falling())
        lower = self._add_body(list(at), {}, r, velocity=self._velocity())
        radii = [self.size * self.chance.choice((0.0, 0.01)) for _ in range(2)]
        self._touch("polygon", bodies=[upper, lower], corners=corners, radii=radii)

    def _drum(self, at: list[float]) -> None:
        """A drum or a coin that lands on its rim or rolls on its side."""
        radius, length = self.size * self._number(0.1, 0.3), self.size * self._number(0, 0.3)
        reach = math.hypot(radius, 0.5 * length)
        place = self._lifted(at, reach + self._height())
        turn = {"rotation_vector": [self._number(0.2, 1.2), self._number(-0.5, 0.5), 0.0]}
        name = self._add_body(place, {}, radius, orientation=turn, **self._falling())
        self._touch("cylinder", body=name, radius=radius, length=length, **self._floor(at))

    def _pendulum(self, at: list[float]) -> None:
        """A pendulum on a hinge that rubs, between end stops, over a floor."""
        chance, reach = self.chance, 0.3 * self.size
        centre = [at[0] + reach, *at[1:]]
        name = self._add_body(centre, {"tip": [reach, *self._zero[1:]]}, reach)
        kind = chance.choice(("revolute", "prismatic"))
        joint: Content = {"type": kind, "bodies": ["ground", name]}
        friction: Content = {"coefficient": chance.choice((0.1, self._number(0, 1)))}
        if chance.random() < 0.5:
            friction["static"] = friction["coefficient"] * self._number(1, 2)
        if kind == "revolute":
            joint["position"], friction["radius"] = at, 0.03 * self.size
        if self.dim == 3 or kind == "prismatic":
            joint["axis"] = [0, 1, 0] if self.dim == 3 and kind == "revolute" else self._direction()
        if chance.random() < 0.7:
            joint["friction"] = friction
        self.content["joints"][f"j{name}"] = joint
        unit = 1.0 if kind == "revolute" else self.size
        stop = {"type": "stop", "joint": f"j{name}", "min": -0.1 * unit, "max": 0.2 * unit}
        self._contact(stop, False)
        floor = self._lifted(at, -self.size * chance.choice((0.0, 0.05, 0.3)))
        self._touch("plane", point=f"{name}.tip", **self._floor(floor))

    def _dish(self, at: list[float]) -> None:
        """Points in a bowl, and one that a driver moves under another."""
        half = [self.size * self._number(0.3, 0.6) for _ in range(self.dim)]
        place = [x + 0.3 * half[0] * e for x, e in zip(at, self._direction(), strict=True)]
        point = self._add_point(place, mass=self._mass(), velocity=self._velocity())
        power = self.chance.choice((2, 2, 4))
        self._touch("superquadric", point=point, semi_axes=half, power=power, position=at)
        if self.chance.random() < 0.4:
            above = self._lifted(at, 1.5 * half[-1] + 0.5 * self.size)
            fist = self._add_point(above)
            value = [repr(x) for x in above]
            value[-1] += f" + {0.05 * self.size!r}*sin(4*t)"
            self.content["drivers"][f"d{fist}"] = {
                "type": "position", "point": fist, "value": value,
            }  # fmt: skip
            rider = self._add_point(
                self._lifted(above, 0.2 * self.size + self._height()), mass=self._mass()
            )
            r = 0.1 * self.size
            self._contact({"type": "sphere", "points": [fist, rider], "radii": [r, r]}, False)

    def _bearing(self, at: list[float]) -> None:
        """A rod on a worn hinge."""
        reach, play = 0.3 * self.size, self.size * self.chance.choice((1e-3, 1e-2))
        pin = self._add_point(list(at), fixed=True)
        centre = [at[0] + reach, *at[1:]]
        root = {"root": [-reach, 0.0], "tip": [reach, 0.0]}
        name = self._add_body(centre, root, reach, angular_velocity=self._spin())
        radius = self.size * self.chance.choice((0.0, 0.02))
        self._touch("clearance", points=[f"{name}.root", pin], radius=play, pin_radius=radius)

    def _journal(self, at: list[float]) -> None:
        """A shaft in a worn bearing, with collars."""
        size, play = self.size, self.size * self.chance.choice((1e-3, 1e-2))
        name = self._add_body(list(at), {}, 0.2 * size, **self._falling())
        more: Content = {"pin_radius": 0.05 * size} if self.chance.random() < 0.7 else {}
        if self.chance.random() < 0.7:
            more |= {"axial_play": play, "collar_radius": 0.08 * size}
        self._touch(
            "journal", bodies=["ground", name], position=at, axis=[0, 1, 0], length=0.2 * size,
            radius=play, **more,
        )  # fmt: skip

    def _on_mesh(self, at: list[float]) -> None:
        """A ball that falls on a box that is a mesh."""
        radius, unit = 0.05 * self.size, self.size
        beside = [at[0] + unit * self._number(-0.2, 0.2), at[1] + unit * self._number(-0.2, 0.2)]
        place = [*beside, at[2] + 0.1 * unit + radius + self._height() + 1e-4 * unit]
        name = self._add_body(place, {}, radius, **self._falling())
        self._touch("mesh", file=str(self.mesh), position=at, scale=unit, point=name,
                    ball_radius=radius, resolution=0.05 * unit)  # fmt: skip
