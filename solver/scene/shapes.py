"""Contacts of bodies with shapes of their own: capsules, polygons, boxes, cylinders."""

from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING, Annotated, Any, TypeAlias

from solver.scene import fields as kind
from solver.scene.contact_laws import RubbingContact
from solver.scene.contacts import (
    PLACE_OF_PLANE,
    SURFACE_VELOCITY,
    TOWARDS_THE_BODY,
    check_size,
    check_surface_velocity,
    is_same_place,
    read_carrier,
    read_corners,
    read_radii,
)
from solver.scene.expression import Number, Vector
from solver.scene.fields import BROKEN
from solver.scene.mistakes import Path
from solver.scene.rules import NOT_NEGATIVE, POSITIVE

if TYPE_CHECKING:
    from solver.scene.references import Reader

Places: TypeAlias = tuple[Vector, ...]


def _pair(reader: "Reader", path: Path, names: Any, _: Any) -> tuple[str | None, str | None]:
    """Check that both are rigid bodies, or the ground."""
    for i, name in enumerate([] if names is BROKEN else names):
        if reader.known.parts.get(name) == "bar" and reader.dimension != 3:
            message = f"the bar '{name}' carries no shape"
            reader.draft.error((*path, i), message, "make it a rigid body")
    return reader.pair(path, names)


def _places_of_both(reader: "Reader", path: Path, lists: Any) -> tuple[Places, Places]:
    first, second = (BROKEN, BROKEN) if lists is BROKEN else lists
    return (
        read_corners(reader, (*path, 0), first, None),
        read_corners(reader, (*path, 1), second, None),
    )


def _segments(reader: "Reader", path: Path, segments: Any, _: Any) -> tuple[Places, Places]:
    """Check that each capsule has two ends, or one, which is a ball."""
    first, second = _places_of_both(reader, path, segments)
    for i, ends in enumerate((first, second)):
        check_ends(reader, (*path, i), ends)
    return first, second


def check_ends(reader: "Reader", path: Path, ends: Places) -> None:
    """Report a capsule that has not two ends, or one, which is a ball."""
    if len(ends) > 2:
        reader.draft.error(path, f"a capsule has two ends, a ball one, got {len(ends)}")
    elif len(ends) == 2:
        one, two = map(reader.values, ends)
        if one is not None and two is not None and is_same_place(one, two):
            message = "both ends of the capsule are the same place"
            reader.draft.error(path, message, "write the place once: a ball")


def _polygons(reader: "Reader", path: Path, polygons: Any, _: Any) -> tuple[Places, Places]:
    first, second = _places_of_both(reader, path, polygons)
    for i, corners in enumerate((first, second)):
        values = [reader.values(corner) for corner in corners]
        for k, (before, corner) in enumerate(pairwise((values[-1:] or [None]) + values)):
            if before is None or corner is None or len(corners) == 1:
                continue
            if is_same_place(before, corner):
                message = "is the same place as the corner before"
                reader.draft.error((*path, i, k), message, "leave one of them out")
    if len(first) == len(second) == 1:
        message = "both have one corner: two discs"
        reader.draft.error(path, message, 'write type = "sphere"')
    return first, second


def _sizes(reader: "Reader", path: Path, sizes: Any, _: Any) -> Places:
    """Check that boxes have lengths."""
    if sizes is BROKEN:
        return (), ()
    found = tuple(reader.vector((*path, i), size) for i, size in enumerate(sizes))
    for i, size in enumerate(found):
        check_size(reader, (*path, i), size)
    return found


def _rounding(reader: "Reader", path: Path, radii: Any, _: Any) -> tuple[Number, ...]:
    if radii is BROKEN:
        return 0.0, 0.0
    return tuple(
        reader.number((*path, i), radius, rule=NOT_NEGATIVE, unit="m")
        for i, radius in enumerate(radii)
    )


_ROUNDED = kind.ListOf(
    "m", "of the corners of each", size=kind.TWO, example=[0.01, 0.01], reading=_rounding
)


@dataclass(frozen=True, slots=True, kw_only=True)
class PairContact(RubbingContact):
    """Two bodies with shapes, of which one may be the ground."""

    may_be_compliant = False

    bodies: Annotated[
        tuple[str | None, str | None],
        kind.ListOf(item=kind.NAME, size=kind.TWO, example=["a", "b"], reading=_pair),
    ]


@dataclass(frozen=True, slots=True, kw_only=True)
class RoundedContact(PairContact):
    """Two bodies with shapes whose corners are rounded."""

    radii: Annotated[tuple[Number, Number], _ROUNDED] = (0.0, 0.0)


@dataclass(frozen=True, slots=True, kw_only=True)
class CapsuleContact(RoundedContact):
    """Two capsules: all places within a radius of a segment; of one place, a ball."""

    type = "capsule"

    segments: Annotated[
        tuple[Places, Places],
        kind.ListOf(
            "m", "ends of each in axes of its body, from its origin", size=kind.TWO,
            item=kind.ListOf(item=kind.COMPONENTS), reading=_segments,
            example=[[[0, 0, 0], [1, 0, 0]], [[0, 0, 0]]],
        ),
    ]  # fmt: skip
    radii: Annotated[
        tuple[Number, Number],
        kind.ListOf(
            "m", "of each", example=[0.1, 0.1], size=kind.TWO, reading=read_radii, required=True
        ),
    ] = (0.0, 0.0)


@dataclass(frozen=True, slots=True, kw_only=True)
class PolygonContact(RoundedContact):
    """Two convex polygons in the plane; one of two corners is an edge, one of one a place."""

    type = "polygon"
    only_in = (2, 'in space write "box" or "capsule"')

    corners: Annotated[
        tuple[Places, Places],
        kind.ListOf(
            "m", "of each, in turn, in axes of its body, from its origin", size=kind.TWO,
            item=kind.ListOf(item=kind.COMPONENTS), reading=_polygons,
            example=[[[0, 0], [1, 0], [0, 1]], [[0, 0], [1, 0], [0, 1]]],
        ),
    ]  # fmt: skip


def _segment(reader: "Reader", path: Path, ends: Any, _: Any) -> Places:
    """Check that a capsule has two ends, or one, which is a ball."""
    found = read_corners(reader, path, ends, None)
    check_ends(reader, path, found)
    return found


@dataclass(frozen=True, slots=True, kw_only=True)
class BoxContact(RoundedContact):
    """Two boxes about the origins of their bodies, in 2-D rectangles, or one and a capsule."""

    type = "box"

    sizes: Annotated[
        tuple[Vector, ...],
        kind.ListOf(
            "m", "lengths of each along the axes of its body", size=(1, 2),
            item=kind.COMPONENTS, example=[[1, 1, 2], [1, 1, 2]], reading=_sizes,
        ),
    ]  # fmt: skip
    segment: Annotated[
        Places,
        kind.ListOf(
            "m", "instead of the second size: ends of a capsule of the second body, one of a ball",
            size=(1, 2), item=kind.COMPONENTS, example=[[0, 0, 0]], reading=_segment,
        ),
    ] = ()  # fmt: skip

    def check(self, reader: "Reader", path: Path, given: Any) -> None:
        """Check that there are two shapes, and that a capsule has a radius."""
        RoundedContact.check(self, reader, path, given)
        if BROKEN in (given.sizes, given.segment):
            return
        count = 2 if given.segment is None else 1
        if len(self.sizes) != count:
            message = f"must have {'two entries' if count == 2 else 'one entry'}"
            help = "write the size of the first body alone: the second has a 'segment'"
            if count == 2:
                help = "for a capsule or ball of the second body write segment = [...]"
            reader.draft.error((*path, "sizes"), f"{message}, got {len(self.sizes)}", help)
        if given.segment is not None and reader.values(self.radii) == [0.0, 0.0]:
            message = "both are 0: a place or a segment and a sharp box have no normal"
            reader.draft.error((*path, "radii"), message, "give the segment a radius")


@dataclass(frozen=True, slots=True, kw_only=True)
class CylinderContact(RubbingContact):
    """The rims of a cylinder, or that of a disc, on one side of a plane."""

    type = "cylinder"
    only_in = (3, 'in the plane write "plane" with a radius')
    may_be_compliant = False

    body: Annotated[str, kind.Plain(example="coin", reading=read_carrier)]
    radius: Annotated[Number, kind.Quantity("m", "", POSITIVE)]
    length: Annotated[Number, kind.Quantity("m", "of the cylinder", NOT_NEGATIVE)] = 0.0
    along: Annotated[
        Vector, kind.Direction(text="of the cylinder's axis, in axes of the body; z")
    ] = (0.0, 0.0, 1.0)
    axis: Annotated[Vector, TOWARDS_THE_BODY]
    position: Annotated[Vector | None, PLACE_OF_PLANE] = None
    on: Annotated[str | None, kind.BODY_OR_GROUND] = None
    """The body that carries the plane."""
    surface_velocity: Annotated[Vector | None, SURFACE_VELOCITY] = None

    def check(self, reader: "Reader", path: Path, given: Any) -> None:
        """Check that the plane is another body's, and that a moving surface rubs."""
        RubbingContact.check(self, reader, path, given)
        if self.on is not None and self.on == self.body:
            reader.draft.error((*path, "on"), f"the cylinder is that of '{self.on}' itself")
        check_surface_velocity(reader, path, given)


SHAPES: dict[str, type[kind.Part]] = {
    contact.type: contact
    for contact in (CapsuleContact, PolygonContact, BoxContact, CylinderContact)
}
"""Types of contacts of bodies with shapes."""
