"""Contacts of ellipsoids with planes and balls."""

from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Any

from solver.scene import fields as kind
from solver.scene.contact_laws import RubbingContact
from solver.scene.contacts import (
    PLACE_OF_PLANE,
    SURFACE_VELOCITY,
    check_size,
    check_surface_velocity,
    read_carrier,
)
from solver.scene.couplings import check_point_and_body
from solver.scene.expression import Number, Vector
from solver.scene.fields import BROKEN, PointReference
from solver.scene.mistakes import Path
from solver.scene.rules import NOT_NEGATIVE, POSITIVE

if TYPE_CHECKING:
    from solver.scene.references import Reader

OF_THE_PLANE = ("position", "on", "surface_velocity")
"""Fields that a ball has not."""


@dataclass(frozen=True, slots=True, kw_only=True)
class EllipsoidContact(RubbingContact):
    """An ellipsoid about the origin of a body, in 2-D an ellipse, on a plane or against a ball."""

    type = "ellipsoid"
    may_be_compliant = False

    body: Annotated[str, kind.Plain(example="stone", reading=read_carrier)]
    semi_axes: Annotated[
        Vector,
        kind.Components("m", "half of its length along each axis of the body", rule=POSITIVE,
                        example=[0.1, 0.02, 0.01]),
    ]  # fmt: skip
    axis: Annotated[
        Vector | None,
        kind.Direction(text="normal of the plane, towards the body", example=[0, 0, 1]),
    ] = None
    position: Annotated[Vector | None, PLACE_OF_PLANE] = None
    on: Annotated[str | None, kind.BODY_OR_GROUND] = None
    """The body that carries the plane."""
    surface_velocity: Annotated[Vector | None, SURFACE_VELOCITY] = None
    point: Annotated[
        PointReference | None,
        kind.Plain(
            text="instead of a plane: centre of a ball",
            example="marble",
            reading=lambda reader, path, name, _: reader.point(path[:-1], name, None, "point"),
        ),
    ] = None
    radius: Annotated[Number, kind.Quantity("m", "of the ball", NOT_NEGATIVE)] = 0.0

    def check(self, reader: "Reader", path: Path, given: Any) -> None:
        """Check that it touches one thing, which is none of its body."""
        RubbingContact.check(self, reader, path, given)
        error = reader.draft.error
        if given.semi_axes is not BROKEN:
            check_size(reader, (*path, "semi_axes"), self.semi_axes)
        if (given.axis is None) == (given.point is None):
            message = "neither 'axis' nor 'point' is given"
            if given.axis is not None:
                message = "either 'axis' or 'point' is possible, not both"
            error(path, message, "write axis = [...] for a plane, or the point of a ball")
        elif given.axis is None:
            for name in OF_THE_PLANE:
                if getattr(given, name) is not None:
                    error((*path, name), "has no effect without a plane", "leave it out")
        elif given.radius is not None:
            error((*path, "radius"), "has no effect without a ball", "leave it out")
        if self.point is not None and given.body is not BROKEN:
            check_point_and_body(reader, path, self.point, self.body, given.body)
        if self.on is not None and self.on == self.body:
            error((*path, "on"), f"the ellipsoid is that of '{self.on}' itself")
        check_surface_velocity(reader, path, given)


ELLIPSOIDS: dict[str, type[kind.Part]] = {EllipsoidContact.type: EllipsoidContact}
"""Types of contacts of ellipsoids."""
