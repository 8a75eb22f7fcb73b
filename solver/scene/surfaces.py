"""Contacts of a point, wheel or roller with curves and surfaces."""

from dataclasses import dataclass
from itertools import pairwise
from math import isclose, pi
from typing import TYPE_CHECKING, Annotated, Any, Literal

from solver.scene import fields as kind
from solver.scene.contact_laws import RubbingContact
from solver.scene.contacts import check_size
from solver.scene.couplings import check_point_and_body, read_surface
from solver.scene.expression import Number, Vector
from solver.scene.fields import BROKEN, PointReference
from solver.scene.files import DataFile, number, read_file, rows_of_table
from solver.scene.mistakes import Path
from solver.scene.profiles import check_smooth
from solver.scene.rules import NOT_NEGATIVE, POSITIVE, Rule
from solver.scene.words import a, did_you_mean

if TYPE_CHECKING:
    from solver.scene.references import Reader

POWER = Rule(
    lambda x: x == 2.0 or 3.0 <= x <= 100.0,
    "2 or from 3 to 100, else its curvature has no bounds, or no number is as large as x^p",
)
LARGEST = 1e100
"""Of powers of a ratio of semi-axes: those of farther places must not overflow."""


def _profile(reader: "Reader", path: Path, name: Any, _: Any) -> str:
    """Check that a profile exists, is smooth, and is not an integral."""
    if name is BROKEN:
        return ""
    known, draft = reader.draft.names("profiles"), reader.draft
    if name not in known:
        part = reader.known.parts.get(name)
        message = f"'{name}' is {a(part)}, not a profile" if part else f"unknown profile '{name}'"
        draft.error(path, message, did_you_mean(name, known, "profiles"))
    elif name in reader.profiles and reader.profiles[name].integrate:
        message = f"the profile '{name}' is an integral, which has no curve of centres"
        draft.error(path, message, "write points of the curve itself, without integrate")
    check_smooth(draft, path, reader.profiles, [name])
    return name


_PROFILE = kind.Plain(example="road", reading=_profile)
_BALL_RADIUS = kind.Quantity(
    "m", "of a ball whose centre is the point: the arm of its friction", NOT_NEGATIVE
)


def _radius(text: str) -> kind.Quantity:
    return kind.setting("m", text, NOT_NEGATIVE)


@dataclass(frozen=True, slots=True, kw_only=True)
class PointContact(RubbingContact):
    """A point against what a body carries."""

    may_be_compliant = False

    point: Annotated[PointReference, kind.ONE_END]
    body: Annotated[str | None, kind.BODY_OR_GROUND] = None

    def check(self, reader: "Reader", path: Path, given: Any) -> None:
        """Check that the point is none of the body, and that one of the two can move."""
        RubbingContact.check(self, reader, path, given)
        check_point_and_body(reader, path, self.point, self.body, given.body)


@dataclass(frozen=True, slots=True, kw_only=True)
class ProfileContact(PointContact):
    """A point or wheel above a profile, such as a road, that a body carries."""

    type = "profile"
    only_in = (2, "in space write 'surface', whose formula may call profiles")

    profile: Annotated[str, _PROFILE]
    """Height over way, both from `position`."""
    position: Annotated[
        Vector | None, kind.Components("m", "origin of the profile as drawn; the global one")
    ] = None
    axis: Annotated[Vector | None, kind.Direction(text="of the height, as drawn; +y")] = None
    radius: Annotated[float, _radius("of a wheel about the point")] = 0.0


@dataclass(frozen=True, slots=True, kw_only=True)
class CamContact(RubbingContact):
    """A cam r(angle) on the second body of a joint against a point, a roller or a flat face."""

    type = "cam"
    may_be_compliant = False
    only_in = (2, "in space write 'surface', whose formula may call profiles")

    joint: Annotated[str, kind.joint_with("angle", "camshaft")]
    follower: Annotated[
        PointReference,
        kind.Plain(
            text="point of the follower: tip, centre of the roller, or a place of the face",
            example="slide",
            reading=lambda reader, path, name, _: reader.point(path[:-1], name, None, "follower"),
        ),
    ]
    profile: Annotated[str, _PROFILE]
    """Radius over angle, from +x as drawn; of period 2 pi."""
    radius: Annotated[float, _radius("of a roller about the follower's point")] = 0.0
    face: Annotated[
        Vector | None, kind.Direction(text="of a flat face, towards the cam, as drawn")
    ] = None

    def check(self, reader: "Reader", path: Path, given: Any) -> None:
        """Check that the profile is a closed curve about the axis, and the follower fits."""
        RubbingContact.check(self, reader, path, given)
        draft = reader.draft
        if given.face is not None and given.radius is not None:
            message = "a follower has either a roller or a flat face"
            draft.error((*path, "face"), message, "leave out 'face' or 'radius'")
        follower = self.follower.point
        if given.face is not None and follower and reader.owner(follower) is None:
            message = f"'{follower}' is a point, which does not turn and carries no face"
            draft.error((*path, "follower"), message, "name a body or a point of one")
        shaft = reader.parts["joints"].get(self.joint)
        pair = getattr(shaft, "bodies", None)
        if (
            reader.has(self.joint, "angle")
            and pair
            and follower
            and reader.owner(follower) == pair[1]
        ):
            message = f"'{follower}' is a point of the cam, the second body of '{self.joint}'"
            draft.error((*path, "follower"), message)
        profile = reader.profiles.get(self.profile)
        if profile is None or given.profile is BROKEN:
            return
        place, period = (*path, "profile"), profile.x[-1] - profile.x[0]
        if not profile.periodic:
            message = f"the profile '{self.profile}' of a cam must be periodic"
            draft.error(place, message, "write periodic = true")
        elif not isclose(period, 2.0 * pi, rel_tol=1e-9):
            message = f"the profile of a cam must have the period 2 pi rad, got {period:.15g}"
            draft.error(place, message, 'give x in rad, and "2*pi" for a full turn')
        if min(profile.y) <= 0.0:
            message = f"the radius of a cam must be > 0 m, got {min(profile.y):.15g}"
            draft.error(place, message, "give the distance from the axis, not the lift")


@dataclass(frozen=True, slots=True, kw_only=True)
class SurfaceContact(PointContact):
    """A point on the side of a surface where F(x, y, z) > 0, in the plane of a curve F(x, y).

    The coordinates are those in the axes of the body, from its origin.
    """

    type = "surface"

    surface: Annotated[
        Number,
        kind.Quantity(
            text="positive on the side of the point, in body axes",
            example="1 - x**2 - y**2",
            reading=read_surface,
        ),
    ]
    ball_radius: Annotated[Number, _BALL_RADIUS] = 0.0


@dataclass(frozen=True, slots=True, kw_only=True)
class SuperquadricContact(PointContact):
    """A point inside or outside of |x/a|^p + |y/b|^p + |z/c|^p = 1, in axes of a body."""

    type = "superquadric"

    semi_axes: Annotated[
        Vector, kind.Components("m", "half of its length along each axis", rule=POSITIVE,
                                example=[1, 0.8, 0.6])
    ]  # fmt: skip
    power: Annotated[float, kind.setting("", "2 for an ellipsoid", POWER, 2.0)] = 2.0
    position: Annotated[
        Vector | None, kind.Components("m", "centre as drawn; origin of the body")
    ] = None
    side: Annotated[Literal["inside", "outside"], kind.Choice(words=("inside", "outside"))] = (
        "inside"
    )
    ball_radius: Annotated[Number, _BALL_RADIUS] = 0.0

    def check(self, reader: "Reader", path: Path, given: Any) -> None:
        """Check the lengths."""
        PointContact.check(self, reader, path, given)
        if given.semi_axes is not BROKEN:
            check_size(reader, (*path, "semi_axes"), self.semi_axes)
            self._check_ratio(reader, (*path, "semi_axes"))

    def _check_ratio(self, reader: "Reader", path: Path) -> None:
        """Report semi-axes whose ratio has a power that is too large."""
        values, most = reader.values(self.semi_axes), LARGEST ** (1.0 / self.power)
        if values and min(values) > 0.0 and max(values) > most * min(values):
            message = f"the longest over the shortest must be <= {most:.6g} with a power of "
            message += f"{self.power:g}, got {max(values) / min(values):.6g}"
            reader.draft.error(path, message, "make it thicker, or its power smaller")


def _rising(reader: "Reader", path: Path, numbers: Any, _: Any) -> tuple[float, ...]:
    """Check the places of a grid along one axis."""
    if numbers is BROKEN:
        return ()
    places = tuple(reader.constant((*path, i), x) for i, x in enumerate(numbers))
    if len(places) < 2:
        reader.draft.error(path, f"a grid must have at least 2 places, got {len(places)}")
    known = all(x.is_constant for x in numbers)
    for i, (before, place) in enumerate(pairwise(places), 1):
        if known and not place > before:
            message = f"must be larger than the one before, {before:.15g}, got {place:.15g}"
            reader.draft.error((*path, i), message, "sort the places")
    return places


def _heights(reader: "Reader", path: Path, rows: Any, given: Any) -> tuple[tuple[float, ...], ...]:
    """Check that there is a height at each place of a grid."""
    if any(part in (None, BROKEN) for part in (rows, given.x, given.y)):
        return ()
    if len(rows) != len(given.x):
        message = f"must have as many lists as x has numbers, {len(given.x)}, got {len(rows)}"
        reader.draft.error(path, message)
    for i, row in enumerate(rows):
        if len(row) != len(given.y):
            message = f"must have as many numbers as y, {len(given.y)}, got {len(row)}"
            reader.draft.error((*path, i), message)
    return tuple(
        tuple(reader.constant((*path, i, k), z) for k, z in enumerate(row))
        for i, row in enumerate(rows)
    )


def _grid_file(reader: "Reader", path: Path, file: Any, _: Any) -> DataFile | None:
    help = "name a table of heights, with places y in its first row and x in its first column"
    return None if file is BROKEN else read_file(reader.draft, path, file, ("csv",), help)


def _grid_of(reader: "Reader", path: Path, file: DataFile) -> dict[str, Any]:
    """Read x, y and z from a table; report what is no grid."""
    error = reader.draft.error
    rows = rows_of_table(file.content.decode("utf-8-sig", "replace"))
    table: list[list[float]] = []
    for n, cells in rows:
        numbers = [number(cell) for cell in cells]
        if not table:
            numbers[0] = 0.0  # the corner, which may have a text
        row = f"'{file.name}', row {n}"
        if len(cells) != len(rows[0][1]):
            message = f"{row}: must have as many cells as the first, {len(rows[0][1])}"
            error(path, f"{message}, got {len(cells)}")
        if None in numbers:
            column = numbers.index(None)
            message = f"{row}, column {column + 1}: must be a finite number"
            error(path, f"{message}, got '{cells[column].strip()}'")
        table.append([x or 0.0 for x in numbers])
    if min(len(table), len(rows[0][1]) if rows else 0) < 3:
        error(path, f"'{file.name}' must have at least 3 rows and 3 columns")
        return {}
    x, y = tuple(row[0] for row in table[1:]), tuple(table[0][1:])
    for axis, places in (("x", x), ("y", y)):
        for before, place in pairwise(places):
            if not place > before:
                message = f"'{file.name}': {axis} must rise, got {place:.15g} behind {before:.15g}"
                error(path, message)
    return {"x": x, "y": y, "z": tuple(tuple(row[1:]) for row in table[1:])}


_PLACES = kind.ListOf("m", "places of the grid, rising", example=[0, 1, 2], reading=_rising)


@dataclass(frozen=True, slots=True, kw_only=True)
class HeightFieldContact(PointContact):
    """A point above a smooth field of heights z(x, y) over a grid, in axes of a body."""

    type = "height_field"
    only_in = (3, "in the plane write 'profile'")

    file: Annotated[
        DataFile | None,
        kind.Plain(
            text="CSV of the grid instead of x, y, z: places y in the first row, x in the first "
            "column; found from the scene's folder", example="hills.csv", reading=_grid_file,
        ),
    ] = None  # fmt: skip
    x: Annotated[tuple[float, ...], _PLACES] = ()
    y: Annotated[tuple[float, ...], _PLACES] = ()
    z: Annotated[
        tuple[tuple[float, ...], ...],
        kind.ListOf(
            "m", "a list for each x, with a height for each y", item=kind.ListOf(),
            example=[[0, 0.1], [0.2, 0]], reading=_heights,
        ),
    ] = ()  # fmt: skip
    position: Annotated[
        Vector | None, kind.Components("m", "origin of the grid as drawn; that of the body")
    ] = None
    ball_radius: Annotated[Number, _BALL_RADIUS] = 0.0

    @property
    def files(self) -> dict[str, DataFile]:
        """Files by the fields that name them."""
        return {} if self.file is None else {"file": self.file}

    @classmethod
    def read(cls, reader: "Reader", path: Path, given: Any) -> Any:
        """Take the grid from its file, if that is given."""
        values, grid = reader.fields(cls, path, given), (given.x, given.y, given.z)
        if (given.file is None) == any(x is None for x in grid) or (
            given.file is not None and any(x is not None for x in grid)
        ):
            message = "must have either 'file', or 'x', 'y' and 'z'"
            help = (
                'write file = "hills.csv", or x = [0, 1], y = [0, 1] and z = [[0, 0.1], [0.2, 0]]'
            )
            reader.draft.error(path, message, help)
        elif values.get("file") is not None:
            values |= _grid_of(reader, (*path, "file"), values["file"])
        contact = cls(**values)
        contact.check(reader, path, given)
        return contact


SURFACES: dict[str, type[kind.Part]] = {
    contact.type: contact
    for contact in (
        ProfileContact,
        CamContact,
        SurfaceContact,
        SuperquadricContact,
        HeightFieldContact,
    )
}
"""Types of contacts with curves and surfaces."""
