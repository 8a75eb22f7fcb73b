"""Quantities of a mechanism that an expression may mention: the variables of its FMU.

``A.x`` of a point, ``bearing.angle`` of a joint, ``buffer.force`` of a spring, ``energy.total`` of
the whole. Positions and rates are known before forces and multipliers are, so forces and
constraints may mention those; everything else may stand in outputs alone.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import Literal, TypeAlias

Level: TypeAlias = Literal["position", "rate", "result"]
"""Of the drawn and moved configuration, of its velocities, or of the solution as a whole."""

SHARED_POINT = "shared_point"
"""Type of a spherical or revolute joint that is given by points: it has a force and no angle."""
WITH_ANGLE = ("revolute", "cylindrical", "screw")
"""Joints whose second body turns about an axis of the first; given by bodies, not by points."""
WITH_DISPLACEMENT = ("prismatic", "cylindrical", "screw")
"""Joints whose second body slides along an axis of the first."""

_BODY_JOINTS = ("universal", "cylindrical", "prismatic", "planar", "fixed", "screw")
_WITH_TORQUE = (*_BODY_JOINTS, "revolute")
_WITH_FORCE = (
    *(*_BODY_JOINTS, "revolute", "spherical", SHARED_POINT, "rolling"),
    *("point_on_line", "point_on_plane", "point_on_surface"),
)
_ENERGIES = ("kinetic", "potential", "total", "work", "dissipated", "balance", "error")
_COUNTS = (
    *("newton_iterations", "uzawa_iterations", "substeps", "order_in_use"),
    *("sampling", "status"),
)
_LINES = ("spring", "damper", "gravitation")
_TWISTS = ("torsion_spring", "torsion_damper", "joint_torque")


@dataclass(frozen=True, slots=True, kw_only=True)
class Inventory:
    """Names of a mechanism's parts; a type "" is unknown and may be any."""

    dimension: int
    points: tuple[str, ...] = ()
    bodies: Mapping[str, str] = field(default_factory=dict)
    """"bar" or "rigid" by name."""
    body_points: tuple[str, ...] = ()
    """"rod.tip"."""
    joints: Mapping[str, str] = field(default_factory=dict)
    """Type by name; ``SHARED_POINT`` for one given by points."""
    constraints: tuple[str, ...] = ()
    forces: Mapping[str, str] = field(default_factory=dict)
    drivers: Mapping[str, str] = field(default_factory=dict)

    def axes(self, rotation: bool = False) -> str:
        """Axes of a vector; of a torque in the plane only z."""
        return "xyz" if self.dimension == 3 else "z" if rotation else "xy"


def quantities(inventory: Inventory) -> dict[str, Level]:
    """Return the names of all quantities of a mechanism, each with its level."""
    return dict(_listed(inventory))


def _listed(inventory: Inventory) -> Iterator[tuple[str, Level]]:
    for name in (*inventory.points, *inventory.body_points):
        yield from _motion_of_a_point(inventory, name)
    for name, kind in inventory.bodies.items():
        yield from _of_a_body(inventory, name, kind)
    for name, kind in inventory.joints.items():
        yield from _of_a_joint(name, kind)
        yield from _results(name, _reactions(inventory, kind))
    for name in inventory.constraints:
        yield from _results(name, ("multiplier",))
    for name, kind in inventory.forces.items():
        yield from _results(name, _of_a_force(kind))
    for name, kind in inventory.drivers.items():
        yield from _results(name, _of_a_driver(inventory, kind))
    yield from _results("energy", _ENERGIES)
    yield from _results("constraint", ("position", "velocity"))
    yield from _results("momentum", inventory.axes())
    yield from _results("angular_momentum", inventory.axes(rotation=True))
    yield from _results("solver", _COUNTS)


def _results(name: str, words: Iterable[str]) -> Iterator[tuple[str, Level]]:
    for word in words:
        yield f"{name}.{word}", "result"


def _motion_of_a_point(inventory: Inventory, name: str) -> Iterator[tuple[str, Level]]:
    for axis in inventory.axes():
        yield f"{name}.{axis}", "position"
    for axis in inventory.axes():
        yield f"{name}.v{axis}", "rate"


def _of_a_body(inventory: Inventory, name: str, kind: str) -> Iterator[tuple[str, Level]]:
    if kind != "bar":
        yield from _motion_of_a_point(inventory, name)
    if inventory.dimension == 2:
        yield f"{name}.angle", "position"
        yield f"{name}.angular_velocity", "rate"
    elif kind != "bar":
        yield from _results(name, ("qw", "qx", "qy", "qz", "wx", "wy", "wz"))


def _of_a_joint(name: str, kind: str) -> Iterator[tuple[str, Level]]:
    if kind in (*WITH_ANGLE, ""):
        yield f"{name}.angle", "position"
        yield f"{name}.angular_velocity", "rate"
    if kind in (*WITH_DISPLACEMENT, ""):
        yield f"{name}.displacement", "position"
        yield f"{name}.velocity", "rate"


def _reactions(inventory: Inventory, kind: str) -> Iterator[str]:
    """Forces and torques on the second body, or on the point; a scalar one where one is enough."""
    if kind in (*_WITH_FORCE, ""):
        yield from (f"force.{axis}" for axis in inventory.axes())
    if kind in (*_WITH_TORQUE, "") and not (kind == "revolute" and inventory.dimension == 2):
        yield from (f"torque.{axis}" for axis in inventory.axes(rotation=True))
    if kind in ("distance", "rack", ""):
        yield "force"
    if kind in ("angle", "gear", ""):
        yield "torque"


def _of_a_force(kind: str) -> tuple[str, ...]:
    if kind in _LINES:
        return "length", "force"
    if kind in _TWISTS:
        return ("torque",)
    if kind == "potential":
        return ("energy",)
    return () if kind else ("length", "force", "torque", "energy")


def _of_a_driver(inventory: Inventory, kind: str) -> tuple[str, ...]:
    along = tuple(f"force.{axis}" for axis in inventory.axes())
    known = {
        "position": (*along, "power"),
        "distance": ("force", "power"),
        "displacement": ("force", "power"),
        "angle": ("torque", "power"),
    }
    return known.get(kind, (*along, "force", "torque", "power"))
