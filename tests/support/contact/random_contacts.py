"""Random mechanisms that touch: points, bars, bodies and joints that fall, slide and hit.

A scene is made from one `random.Random`, so that a seed repeats it. Nothing is drawn penetrating:
planes lie below what falls on them, ropes are slack or straight, balls are apart or touch.
"""

from __future__ import annotations

import math
import random
from typing import Any

Content = dict[str, Any]


class RandomContacts:
    """One random scene, and what its inputs do.

    `wild` scenes have mass ratios to 1e6, speeds to 100 m/s and steps to 50 ms.
    """

    def __init__(self, chance: random.Random, *, wild: bool = False) -> None:
        self.chance, self.wild = chance, wild
        self.dim = chance.choice((2, 3))
        self.size = 10.0 ** chance.uniform(-2, 1) if wild else 1.0
        self.spread = chance.choice((0.0, 0.3, 3.0)) if wild else 0.3
        top = chance.choice((0.0, 1.0, 1.0, 5.0, 100.0 if wild else 2.0))
        self.speed = top
        self.content: Content = {
            "name": "touching",
            "dimension": self.dim,
            "gravity": [0.0] * (self.dim - 1) + [chance.choice((-9.81, -9.81, -9.81, 0.0))],
            "points": {},
            "bodies": {},
            "joints": {},
            "contacts": {},
            "forces": {},
            "drivers": {},
            "inputs": {},
        }
        self.places: dict[str, list[float]] = {}
        self.radii: dict[str, float] = {}
        self.islands: list[list[str]] = []
        for _ in range(chance.choice((1, 1, 2, 3))):
            self._group()
        self._contacts()
        self._forces()
        self._settings()

    @property
    def extent(self) -> float:
        """Size of the scene [m]."""
        low, high = (
            [f(x[k] for x in self.places.values()) for k in range(self.dim)] for f in (min, max)
        )
        return max(math.dist(low, high), 0.3 * self.size)

    def _number(self, low: float, high: float) -> float:
        return self.chance.uniform(low, high)

    def _mass(self) -> float:
        return 10.0 ** self._number(-self.spread, self.spread)

    def _direction(self) -> list[float]:
        x = [self.chance.gauss(0, 1) for _ in range(self.dim)]
        size = math.sqrt(sum(a * a for a in x)) or 1.0
        return [a / size for a in x]

    def _velocity(self) -> list[float]:
        return [self.speed * self._number(-1, 1) for _ in range(self.dim)]

    def _group(self) -> None:
        shift = 4.0 * self.size * len(self.islands)
        make = self.chance.choice(
            (self._points, self._tree, self._chain, self._block, self._bodies, self._pile)
        )
        self.islands.append(make([shift] + [0.0] * (self.dim - 1)))

    def _add_point(self, place: list[float], **more: Any) -> str:
        name = f"P{len(self.places)}"
        self.content["points"][name] = {"position": place} | more
        self.places[name] = place
        return name

    def _points(self, at: list[float]) -> list[str]:
        """Free points."""
        names = []
        for _ in range(self.chance.randrange(1, 4)):
            place = [x + self.size * self._number(0, 1) for x in at]
            names.append(self._add_point(place, mass=self._mass(), velocity=self._velocity()))
        return names

    def _pile(self, at: list[float]) -> list[str]:
        """Balls one above the other, or in a row, that touch or nearly do."""
        chance, names = self.chance, []
        radius = 0.1 * self.size
        gap = chance.choice((0.0, 0.0, 1e-3, 0.02)) * self.size
        axis = chance.choice((0, self.dim - 1))
        for k in range(chance.randrange(2, 5)):
            place = list(at)
            place[axis] += k * (2 * radius + gap)
            more: Content = {"mass": chance.choice((1.0, self._mass()))}
            if k == 0 and axis == 0 and self.speed:
                more["velocity"] = [self.speed] + [0.0] * (self.dim - 1)
            name = self._add_point(place, **more)
            self.radii[name] = radius
            if names:
                self._contact(
                    {"type": "sphere", "points": [names[-1], name], "radii": [radius, radius]},
                    self.dim == 2,
                )
            names.append(name)
        return names

    def _tree(self, at: list[float]) -> list[str]:
        """A tree of rods and bars that moves as a whole."""
        chance, velocity = self.chance, self._velocity()
        hung = chance.random() < 0.4
        first = {"fixed": True} if hung else {"mass": self._mass(), "velocity": velocity}
        names = [self._add_point(list(at), **first)]
        for _ in range(chance.randrange(1, 4)):
            parent = chance.choice(names)
            link, length = self._direction(), self.size * self._number(0.3, 1)
            place = [x + length * e for x, e in zip(self.places[parent], link, strict=True)]
            bar = chance.random() < 0.6
            more: Content = {} if hung else {"velocity": velocity}
            name = self._add_point(place, mass=0.0 if bar else self._mass(), **more)
            if bar:
                self.content["bodies"][f"bar{name}"] = {
                    "type": "bar",
                    "points": [parent, name],
                    "mass": self._mass(),
                }
            else:
                self.content["joints"][f"rod{name}"] = {
                    "type": "distance",
                    "points": [parent, name],
                }
            names.append(name)
        return names

    def _chain(self, at: list[float]) -> list[str]:
        """A level chain of equal bars."""
        velocity, names = self._velocity(), []
        n = self.chance.randrange(1, 6)
        for k in range(n + 1):
            place = list(at)
            place[0] += 0.4 * self.size * k
            names.append(self._add_point(place, mass=0.0, velocity=velocity))
        for k in range(n):
            self.content["bodies"][f"bar{names[k]}"] = {
                "type": "bar",
                "points": names[k : k + 2],
                "mass": 1.0,
            }
        return names

    def _add_body(
        self, place: list[float], points: dict[str, list[float]], reach: float, **more: Any
    ) -> str:
        mass = self._mass()
        name = f"B{len(self.content['bodies'])}"
        body: Content = {"position": place, "mass": mass, "points": points} | more
        scale = mass * reach * reach
        if self.dim == 2:
            body["inertia"] = scale * self._number(0.1, 0.5)
        else:
            parts = [self._number(0.1, 1) for _ in range(3)]
            body["inertia"] = [0.2 * scale * (sum(parts) - part) for part in parts]
        self.content["bodies"][name] = body
        self.places[name] = place
        for point, x in points.items():
            self.places[f"{name}.{point}"] = [a + b for a, b in zip(place, x, strict=True)]
        return name

    def _spin(self) -> Any:
        if self.dim == 2:
            return self._number(-1, 1) * self.speed / self.size
        return [self._number(-1, 1) * self.speed / self.size for _ in range(3)]

    def _block(self, at: list[float]) -> list[str]:
        """A block with its corners below."""
        a, b = self.size * self._number(0.1, 0.5), self.size * self._number(0.05, 0.5)
        if self.dim == 2:
            corners = {"l": [-a, -b], "r": [a, -b]}
        else:
            corners = {
                f"c{i}": [a * x, 0.8 * a * y, -b]
                for i, (x, y) in enumerate(((-1, -1), (1, -1), (1, 1), (-1, 1)))
            }
        more: Content = {"velocity": self._velocity()} if self.chance.random() < 0.7 else {}
        if self.chance.random() < 0.3:
            more["angular_velocity"] = self._spin()
        name = self._add_body(list(at), corners, a, **more)
        return [f"{name}.{c}" for c in corners]

    def _bodies(self, at: list[float]) -> list[str]:
        """A ball, or a pendulum, or a chain of rigid bodies."""
        chance, reach = self.chance, 0.3 * self.size
        zero = [0.0] * self.dim
        if chance.random() < 0.4:
            name = self._add_body(
                list(at), {}, reach, velocity=self._velocity(), angular_velocity=self._spin()
            )
            self.radii[name] = reach
            return [name]
        ends, parent, place = [], "ground", list(at)
        for _ in range(chance.randrange(1, 4)):
            centre = [place[0] + reach, *place[1:]]
            tip = [reach, *zero[1:]]
            name = self._add_body(centre, {"tip": tip, "root": [-x for x in tip]}, reach)
            joint: Content = {
                "type": chance.choice(("revolute", "revolute", "prismatic")),
                "bodies": [parent, name],
            }
            if joint["type"] == "revolute":
                joint["position"] = place
            if self.dim == 3:
                joint["axis"] = [0, 1, 0] if chance.random() < 0.7 else self._direction()
            elif joint["type"] == "prismatic":
                joint["axis"] = self._direction()
            if parent != "ground" or chance.random() < 0.8:
                key = f"j{name}"
                self.content["joints"][key] = joint
                if chance.random() < 0.5:
                    stop: Content = {"type": "stop", "joint": key}
                    unit = self.size if joint["type"] == "prismatic" else 1.0
                    if chance.random() < 0.8:
                        stop["min"] = -unit * chance.choice((0.0, 0.1, 0.5))
                    if "min" not in stop or chance.random() < 0.5:
                        stop["max"] = unit * chance.choice((0.1, 0.5))
                    self._contact(stop, False)
                elif chance.random() < 0.15 and parent == "ground":
                    turns = joint["type"] == "revolute"
                    value = f"{0.3 if turns else 0.3 * self.size!r}*sin(3*t)"
                    kind = "angle" if turns else "displacement"
                    self.content["drivers"][f"d{name}"] = {
                        "type": kind,
                        "joint": key,
                        "value": value,
                    }
            parent, place = name, [a + b for a, b in zip(centre, tip, strict=True)]
            ends.append(f"{name}.tip")
        return ends

    def _contact(self, contact: Content, rubs: bool) -> None:
        chance = self.chance
        contact["restitution"] = chance.choice((0.0, 0.0, 0.5, 1.0, self._number(0, 1)))
        if rubs and chance.random() < 0.7:
            contact["friction"] = chance.choice((0.0, 0.1, 0.5, self._number(0, 1.6)))
            if chance.random() < 0.4:
                contact["static_friction"] = contact["friction"] * self._number(1, 2)
        self.content["contacts"][f"c{len(self.content['contacts'])}"] = contact

    def _contacts(self) -> None:
        chance, down = self.chance, self.dim - 1
        for names in self.islands:
            tops = [self.places[n][down] - self.radii.get(n, 0.0) for n in names]
            floor = min(tops) - self.size * chance.choice((0.0, 0.0, 1e-3, 0.1, 0.1))
            hung = chance.random() < 0.1 and bool(self.content["contacts"])
            shared = chance.random() < 0.5
            kind: Content = {}
            for n in names:
                if hung or self.content["points"].get(n, {}).get("fixed"):
                    continue
                plane: Content = {
                    "type": "plane", "point": n, "axis": [0.0] * down + [1.0],
                    "position": [0.0] * down + [floor], "radius": self.radii.get(n, 0.0),
                }  # fmt: skip
                self._contact(plane, True)
                if shared and kind:
                    for word in ("restitution", "friction", "static_friction"):
                        plane.pop(word, None)
                        if word in kind:
                            plane[word] = kind[word]
                kind = kind or plane
                if "friction" in plane and chance.random() < 0.15:
                    value: Any = chance.choice((0.5, -1.0, "0.5*sin(2*t)"))
                    plane["surface_velocity"] = [value] + [0.0] * down
                if chance.random() < 0.1:  # a wall
                    wall = dict(
                        plane,
                        axis=[-1.0] + [0.0] * down,
                        position=[self.places[n][0] + self.radii.get(n, 0.0) + 0.3 * self.size]
                        + [0.0] * down,
                    )
                    wall.pop("surface_velocity", None)
                    self.content["contacts"][f"c{len(self.content['contacts'])}"] = wall
        everyone = [
            n
            for names in self.islands
            for n in names
            if not self.content["points"].get(n, {}).get("fixed")
        ]
        for _ in range(chance.choice((0, 0, 1, 2))):
            if len(everyone) < 2:
                break
            a, b = chance.sample(everyone, 2)
            if a.partition(".")[0] == b.partition(".")[0]:
                continue
            distance = math.dist(self.places[a], self.places[b])
            if distance < 1e-3 * self.size:
                continue
            what = chance.random()
            if what < 0.5:
                r = distance * chance.choice((0.5, 0.45, 0.2))
                self._contact({"type": "sphere", "points": [a, b], "radii": [r, r]}, self.dim == 2)
            elif what < 0.8:
                self._contact(
                    {"type": "stop", "points": [a, b], "max": distance * chance.choice((1.0, 1.1))},
                    False,
                )
            else:
                self._contact(
                    {
                        "type": "clearance",
                        "points": [a, b],
                        "radius": distance * chance.choice((1.0, 1.2)),
                    },
                    self.dim == 2,
                )
        if chance.random() < 0.15:
            a = chance.choice(everyone) if everyone else None
            if a:
                centre = [
                    x + 0.2 * self.size * e
                    for x, e in zip(self.places[a], self._direction(), strict=True)
                ]
                o = self._add_point(centre, fixed=True)
                self._contact(
                    {
                        "type": "clearance",
                        "points": [a, o],
                        "radius": self.size * chance.choice((0.2000001, 0.3)),
                    },
                    self.dim == 2,
                )

    def _forces(self) -> None:
        chance = self.chance
        everyone = [n for names in self.islands for n in names]
        for k in range(chance.choice((0, 0, 1, 2))):
            if len(everyone) < 2:
                break
            a, b = chance.sample(everyone, 2)
            if (
                a.partition(".")[0] == b.partition(".")[0]
                or math.dist(self.places[a], self.places[b]) < 1e-3 * self.size
            ):
                continue
            if chance.random() < 0.5:
                force: Content = {
                    "type": "spring",
                    "points": [a, b],
                    "stiffness": 10.0 ** self._number(0, 4),
                }
            else:
                force = {"type": "damper", "points": [a, b], "damping": 10.0 ** self._number(-1, 2)}
            self.content["forces"][f"f{k}"] = force
        free = [n for n in everyone if not self.content["points"].get(n, {}).get("fixed")]
        if free and chance.random() < 0.3:
            self.content["inputs"]["push"] = chance.choice(
                ({}, {"interpolation": "ramp"}, {"interpolation": "smooth"})
            )
            self.content["forces"]["load"] = {
                "type": "force",
                "point": chance.choice(free),
                "value": ["push"] + [0.0] * (self.dim - 1),
            }

    def _settings(self) -> None:
        chance = self.chance
        step = chance.choice((0.001, 0.005, 0.01, 0.02, 0.05 if self.wild else 0.01))
        settings: Content = {"step_size": step, "assemble": True}
        if chance.random() < 0.5:
            settings["order"] = chance.choice((2, 4, 6, 8))
        if chance.random() < 0.15:
            settings["tolerance"] = 10.0 ** self._number(-6, -3)
        if chance.random() < 0.2:
            settings["impact_law"] = "sequential"
        self.content["solver"] = settings
        self.content["experiment"] = {
            "step_size": step * chance.choice((1, 1, 3)),
            "stop_time": 10.0,
        }
        self.content = {k: v for k, v in self.content.items() if v or k == "dimension"}
