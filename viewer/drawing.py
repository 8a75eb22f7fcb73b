"""Drawing of a scene: frames that move, and what is fixed to them, as plain data (docs/fmu.md).

A report, the picture of an FMU and tools that know nothing of holonom show the same drawing. Its
numbers are those of a run: places depend on parameters.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np

from solver.scene import (
    Actuator,
    Bar,
    BodyJoint,
    ClearanceContact,
    CornersContact,
    CylinderContact,
    Damper,
    Distance,
    DistanceDriver,
    EllipsoidContact,
    Force,
    JournalContact,
    Number,
    PairContact,
    PlaneContact,
    PointOn,
    PointOnLine,
    PointReference,
    PositionDriver,
    Rigid,
    Rolling,
    Scene,
    SphereContact,
    Spring,
    Stop,
    Vector,
)
from viewer.places import Array, Place, Places, some, tidy
from viewer.solids import Solids
from viewer.touching import Touching

FORMAT = 1
AZIMUTH, ELEVATION = math.radians(-55.0), math.radians(22.0)
"""Of the eye, unless the scene says from where it is seen."""
ON_PLANES = PlaneContact | CornersContact | CylinderContact | EllipsoidContact
SLIDES = ("prismatic", "cylindrical", "screw")


def drawing(scene: Scene, values: Mapping[str, float] | None = None) -> dict[str, Any]:
    """Return the drawing of a scene as a dictionary that is JSON.

    Parameters
    ----------
    scene
        The scene.
    values
        Values of parameters by name; those of the scene unless given.
    """
    with np.errstate(all="ignore"):  # sizes of 1e90 m have no squares
        return _Drawing(scene, values or {}).data()


class _Drawing:
    """Links, joints and contacts of a scene; its solids are made of where they hold its bodies."""

    def __init__(self, scene: Scene, values: Mapping[str, float]) -> None:
        self.scene, self.places = scene, Places(scene, values)
        self.links: list[dict[str, Any]] = []
        self.joints: list[dict[str, Any]] = []
        self.contacts: list[dict[str, Any]] = []
        self.held: dict[str, list[Array]] = {name: [] for name in scene.bodies}
        """Places where something holds on to each body, in its axes."""

    def data(self) -> dict[str, Any]:
        """Return everything of the scene that can be seen."""
        scene = self.scene
        for names in (scene.points, scene.bodies):
            for name in some(names):
                if not isinstance(scene.bodies.get(name), Bar):
                    self.places.frame(name)
        for part in (self._joints, self._forces, self._drivers, self._contacts, self._points):
            part()
        solids = Solids(self.places, self.held, self._seen())
        touching = Touching(solids)
        for table in (scene.joints, scene.contacts):
            for item in some(table.items()):
                touching.add(*item)
        solids.add_bodies()
        for item in scene.looks.items():
            solids.add_look(*item)
        return {
            "format": FORMAT,
            "name": scene.name,
            "dimension": scene.dimension,
            "up": tidy(self._up()),
            "gravity": tidy(self.places.vector(scene.gravity)),
            "size": tidy(solids.size),
            "frames": self.places.frames,
            "solids": [*solids.solids.values()],
            "links": self.links,
            "joints": self.joints,
            "contacts": self.contacts,
            "view": self._view(),
        }

    # ----------------------------------------------------------------------------- places

    def _up(self) -> Array:
        """Direction against gravity, of the axes the nearest; z, in the plane y, without it."""
        gravity, up = self.places.vector(self.scene.gravity), np.zeros(3)
        axis = int(np.argmax(np.abs(gravity))) if gravity.any() else self.scene.dimension - 1
        up[axis] = -1.0 if gravity[axis] > 0.0 else 1.0
        return np.array((0.0, 1.0, 0.0)) if self.scene.dimension == 2 else up

    def _seen(self) -> list[Array]:
        """Places of the drawing at the start."""
        found = [end for link in self.links for end in link["ends"]]
        found += [x["place"] for x in (*self.joints, *self.contacts)]
        return [*map(self.places.at_start, found), *(origin for origin, _ in self.places.poses[1:])]

    def _held(self, place: Place) -> Place:
        """Note that something holds a body there."""
        name = self.places.frames[place["frame"]]["name"]
        if isinstance(self.scene.bodies.get(name), Rigid):
            self.held[name].append(np.array(place["at"], float))
        return place

    def _end(self, reference: PointReference) -> Place:
        return self._held(self.places.of(reference))

    # ----------------------------------------------------------------------------- parts

    def _link(self, kind: str, name: str, ends: Iterable[PointReference], **more: Any) -> None:
        places = [self._end(end) for end in ends]
        self.links.append({"name": name, "kind": kind, "ends": places, **more})

    def _rail(self, name: str, ends: list[Place], axis: Array) -> None:
        """Add a rail through the first end, along an axis of its frame, for the other one."""
        self.links.append({"name": name, "kind": "rail", "ends": ends, "axis": tidy(axis)})

    def _joint(self, name: str, kind: str, place: Place, **more: Any) -> None:
        known = {"name": name, "kind": kind, "place": place, "axis": None, "ground": False}
        self.joints.append({**known, "force": [], **more})

    def _force(self, name: str) -> list[str]:
        return [f"{name}.force.{axis}" for axis in "xyz"[: self.scene.dimension]]

    def _joints(self) -> None:
        for name, joint in some(self.scene.joints.items()):
            if isinstance(joint, Distance):
                self._link("rod", name, joint.points, force=[f"{name}.force"])
            elif isinstance(joint, BodyJoint):
                self._body_joint(name, joint)
            elif isinstance(joint, PointOn):
                place, ground = self._end(joint.point), joint.body is None
                self._joint(name, joint.type, place, ground=ground, force=self._force(name))
                if isinstance(joint, PointOnLine):
                    line = self._drawn(joint.body, joint.position, place)
                    axis = self.places.own(joint.body, self.places.direction(joint.axis))
                    self._rail(name, [line, place], axis)
            elif isinstance(joint, Rolling):
                place = self.places.named(joint.body)
                self._joint(name, joint.type, place, force=self._force(name))

    def _drawn(self, body: str | None, position: Vector | None, place: Place) -> Place:
        """Return the place on a body that is drawn at a position, or where another place is."""
        at = self.places.at_start(place) if position is None else self.places.vector(position)
        return self.places.drawn(body, at)

    def _body_joint(self, name: str, joint: BodyJoint) -> None:
        force = self._force(name)
        if joint.points is not None:
            _, place = (self._end(end) for end in joint.points)
            ground = any(end.point is None for end in joint.points)
            self._joint(name, joint.type, place, ground=ground, force=force)
            return
        assert joint.bodies is not None
        assert joint.position is not None
        slides = joint.type in SLIDES
        position = self.places.vector(joint.position)
        ends = [
            self.places.named(on) if on and not slides else self.places.drawn(body, position)
            for body, on in zip(joint.bodies, joint.on, strict=True)
        ]
        axes = getattr(joint, "axes", (joint.axis, joint.axis))
        if joint.type == "revolute" and self.scene.dimension == 2:
            axes = ((0.0, 0.0, 1.0),) * 2
        own = [
            None if axis is None else self.places.own(body, self.places.direction(axis))
            for body, axis in zip(joint.bodies, axes, strict=True)
        ]
        if slides and own[0] is not None:
            self._rail(name, ends, own[0])
        for end in ends if joint.type != "planar" else ():
            self._held(end)
        k = 0 if joint.bodies[1] is None else 1
        axis = own[k] if own[k] is None else tidy(own[k])
        ground = None in joint.bodies
        self._joint(name, joint.type, ends[k], axis=axis, ground=ground, force=force)

    def _forces(self) -> None:
        kinds = {Spring: "spring", Damper: "damper"}
        for name, force in some(self.scene.forces.items()):
            if type(force) in kinds:
                assert isinstance(force, Spring | Damper)
                self._link(kinds[type(force)], name, force.points, force=[f"{name}.force"])
            elif isinstance(force, Actuator) and force.points is not None:
                self._link("actuator", name, force.points, force=[f"{name}.force"])
            elif isinstance(force, Force):
                self._end(force.point)

    def _drivers(self) -> None:
        for name, driver in some(self.scene.drivers.items()):
            if isinstance(driver, DistanceDriver):
                self._link("actuator", name, driver.points, force=[f"{name}.force"])
            elif isinstance(driver, PositionDriver):
                place = self._end(driver.point)
                self._joint(name, "driven", place, force=self._force(name))

    def _contacts(self) -> None:
        for name, contact in some(self.scene.contacts.items()):
            if isinstance(contact, Stop) and contact.points is not None:
                self._link("rope", name, contact.points, force=[f"{name}.force"])
            place, more = self._touch(contact)
            if place is not None:
                offers = (offer.word for offer in contact.offered(contact.given()))
                force = [f"{name}.{word}" for word in offers if word in ("force", "friction")]
                known = {"name": name, "kind": contact.type, "place": place, "force": force}
                self.contacts.append({**known, **more})

    def _touch(self, contact: Any) -> tuple[Place | None, dict[str, Any]]:
        """Return the middle of what touches, and from where it is pushed, as far as that is known.

        That is a normal in a frame, or another place.
        """
        points: Sequence[PointReference] = getattr(contact, "points", None) or ()
        point = getattr(contact, "point", None) or getattr(contact, "follower", None)
        body = getattr(contact, "body", None) or getattr(contact, "part", None)
        if isinstance(contact, SphereContact | ClearanceContact):
            first, second = map(self._end, points)
            return second, {"from": first}
        if isinstance(contact, PairContact | JournalContact):
            first, second = (self.places.drawn(x, self._origin(x)) for x in contact.bodies)
            return second, {"from": first}
        if isinstance(contact, Stop):
            return None, {}
        end = point or next(iter(points), None)
        place = self.places.named(body or "") if end is None else self._end(end)
        if not isinstance(contact, ON_PLANES) or contact.axis is None:
            return place, {}
        carrier = contact.body if isinstance(contact, PlaneContact) else contact.on
        axis = self.places.own(carrier, self.places.direction(contact.axis))
        return place, {"normal": {"frame": self.places.frame(carrier), "axis": tidy(axis)}}

    def _origin(self, body: str | None) -> Array:
        return self.places.poses[self.places.frame(body)][0]

    def _points(self) -> None:
        for k, (name, body) in some(enumerate(self.scene.bodies.items())):
            if isinstance(body, Bar):
                ends = [self.places.named(end) for end in body.points]
                self.links.append({"name": name, "kind": "bar", "ends": ends, "colour": k})
        masses = {name: self._mass(point.mass) for name, point in self.scene.points.items()}
        heaviest = max(masses.values(), default=0.0) or 1.0
        for name, point in some(self.scene.points.items()):
            kind, share = "fixed" if point.fixed else "point", (masses[name] / heaviest) ** (1 / 3)
            more = {"ground": point.fixed, "share": tidy(share)}
            self._joint(name, kind, self.places.named(name), **more)

    def _mass(self, mass: Number) -> float:
        return max(0.0, self.places.number(mass))

    # ----------------------------------------------------------------------------- view

    def _view(self) -> dict[str, Any]:
        """Direction towards the eye, what it follows, places whose paths are drawn, plots."""
        view, towards = self.scene.view, self._up()
        if self.scene.dimension == 2:
            towards = np.array((0.0, 0.0, 1.0))
        elif view.direction is not None:
            towards = self.places.direction(view.direction)
        else:
            first = np.roll(np.abs(towards), 1)
            level = math.cos(AZIMUTH) * first + math.sin(AZIMUTH) * np.cross(towards, first)
            towards = math.cos(ELEVATION) * level + math.sin(ELEVATION) * towards
        traces = [{"name": name, "place": self.places.named(name)} for name in view.traces]
        follow = view.follow and self.places.named(view.follow)
        plots = [[*names] for names in view.plots]
        return {"direction": tidy(towards), "follow": follow, "traces": traces, "plots": plots}
