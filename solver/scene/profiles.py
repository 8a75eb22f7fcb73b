"""Profiles: functions through given points, which expressions call by their names.

A profile is a cubic in each piece between its points, and straight beyond its ends, where it may
also hold the values of its ends. With h, d, m and M the length, mean slope, slope and curvature of
its pieces and knots, it is

    cubic      h_k-1 M_k-1 + 2 (h_k-1 + h_k) M_k + h_k M_k+1 = 6 (d_k - d_k-1): the spline, where M
               is 0 at both ends, so that curvature does not jump there either, or repeats
    monotone   (h_k-1 + h_k) 3/m_k = (h_k-1 + 2 h_k)/d_k-1 + (2 h_k-1 + h_k)/d_k, or m_k = 0 where d
               changes its sign: Fritsch and Butland, A method for constructing local monotone
               piecewise cubic interpolants, SIAM J. Sci. Stat. Comput. 5 (1984)
    linear     d
"""

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from pathlib import Path as FilePath
from typing import TYPE_CHECKING, Annotated, Any, Literal, NamedTuple, TypeAlias

from solver.files import read_whole
from solver.scene import fields as kind
from solver.scene.expression import FUNCTIONS, Curve
from solver.scene.fields import BROKEN, Part, shown
from solver.scene.files import number, rows_of_table
from solver.scene.mistakes import Path
from solver.scene.units import misfit

if TYPE_CHECKING:
    from solver.scene.draft import Draft

_NUMBERS, _SWITCH = kind.ListOf(item=kind.OfAnyUnit(), example=[0, 0.5, 1]), kind.Plain(type=bool)
_WORDS = ("cubic", "monotone", "linear")
_BETWEEN = kind.Choice(
    text="between the points: cubic spline, cubic that does not overshoot, or straight lines",
    words=_WORDS,
)
_BEYOND = kind.Choice(
    text="beyond the first and last point: on in a straight line, or hold the value there",
    words=("straight", "hold"),
)
_OVERSHOOT = 0.1
"""Part of the range of its points by which a profile leaves it before that is told."""
Piece: TypeAlias = tuple[float, float, float]
"""Coefficients c_1, c_2, c_3 of (x - x_k)^j."""
_FORGOTTEN = 64
"""Knots after which an end has no influence: it falls at least by half from one to the next."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Profile(Part):
    """A function through given points; expressions call it by its name."""

    file: Annotated[
        str, kind.Plain(text="CSV of x and y, found from the scene's folder", example="lobe.csv")
    ] = ""
    x: Annotated[tuple[float, ...], _NUMBERS] = ()
    y: Annotated[tuple[float, ...], _NUMBERS] = ()
    interpolation: Annotated[Literal["cubic", "monotone", "linear"], _BETWEEN] = "cubic"
    extrapolate: Annotated[Literal["straight", "hold"], _BEYOND] = "straight"
    periodic: Annotated[bool, _SWITCH] = False
    """Whether it repeats; its period is the distance of its ends."""
    integrate: Annotated[bool, _SWITCH] = False
    """Whether it is the integral of the curve, from the first x on."""
    curve: Curve = field(default=Curve("", ()), repr=False, compare=False)
    """What expressions call."""

    @property
    def has_corners(self) -> bool:
        """Whether its slope jumps at its points, or at its ends."""
        return not self.integrate and (self.interpolation == "linear" or self.extrapolate == "hold")

    @property
    def without_corners(self) -> str:
        """What to write so that it has none."""
        is_linear = self.interpolation == "linear"
        return 'interpolation = "monotone"' if is_linear else 'extrapolate = "straight"'

    @property
    def text(self) -> str:
        """The profile as it stands in a scene file that has its points."""
        switches = f"periodic = {shown(self.periodic)}, integrate = {shown(self.integrate)}"
        between = f"interpolation = {shown(self.interpolation)}"
        if not self.periodic:
            between += f", extrapolate = {shown(self.extrapolate)}"
        return f"{{ x = {shown(list(self.x))}, y = {shown(list(self.y))}, {between}, {switches} }}"


class _Point(NamedTuple):
    x: float
    y: float
    path: Path
    row: str = ""
    """In which row of a file."""


def read_profiles(draft: "Draft") -> dict[str, Profile]:
    """Read the table [profiles]; expressions of the draft can call them from then on."""
    found: dict[str, Profile] = {}
    straight = table_of((0.0, 1.0), (0.0, 1.0))  # of those with a mistake
    draft.curves |= {name: Curve(name, straight) for name in draft.names("profiles")}
    for name, (_, given) in draft.parts("profiles").items():
        path, before = ("profiles", name), len(draft.problems)
        whole = BROKEN not in vars(given).values()
        if name in FUNCTIONS:  # floor, which other parts may be called
            draft.error(path, f"the name '{name}' is reserved for the function")
        points = list(_points(draft, path, given))
        periodic, integrate = given.periodic is True, given.integrate is True
        if whole and len(draft.problems) == before:
            _check(draft, path, points, periodic=periodic, integrate=integrate)
            if periodic and given.extrapolate is not None:
                message = "a periodic profile has no ends to go on from"
                draft.error((*path, "extrapolate"), message, "leave it out")
        if whole and len(draft.problems) == before:
            x, y, *_ = zip(*points, strict=True)
            word, beyond = given.interpolation or "cubic", given.extrapolate or "straight"
            numbers = table_of(
                x, y, interpolation=word, periodic=periodic, integrate=integrate,
                extrapolate=beyond,
            )  # fmt: skip
            curve = draft.curves[name] = Curve(name, numbers)
            if not all(map(math.isfinite, numbers)):
                draft.error(path, "no spline has these points: their numbers differ too much")
            elif word == "cubic":
                _advise(draft, path, x, y, periodic=periodic)
            found[name] = Profile(
                file=given.file or "", x=x, y=y, interpolation=word, curve=curve,
                extrapolate=beyond, periodic=periodic, integrate=integrate,
            )  # fmt: skip
    return found


def check_smooth(
    draft: "Draft", path: Path, profiles: Mapping[str, Profile], names: Iterable[str]
) -> None:
    """Report a profile with corners that a curve or surface is made of."""
    for name in names:
        if name in profiles and profiles[name].has_corners:
            message = f"the profile '{name}' has corners, at which the curve has no normal"
            draft.error(path, message, f"write {profiles[name].without_corners} in profiles.{name}")


def _points(draft: "Draft", path: Path, given: Any) -> Iterator[_Point]:
    """Yield the points of a profile; report what is none."""
    file, x, y = given.file, given.x, given.y
    if BROKEN in (file, x, y):
        return
    for word, numbers in (("x", x or ()), ("y", y or ())):
        _have_one_unit(draft, (*path, word), numbers)
    if file is not None and x is None and y is None:
        yield from _points_of_file(draft, (*path, "file"), file)
    elif file is not None or x is None or y is None:
        message = "must have either 'file', or 'x' and 'y'"
        draft.error(path, message, 'write file = "lobe.csv", or x = [0, 0.5, 1] and y = [0, 2, 3]')
    elif len(x) != len(y):
        message = f"must have as many numbers as x, {len(x)}, got {len(y)}"
        draft.error((*path, "y"), message)
    else:
        for i, point in enumerate(zip(x, y, strict=True)):
            for word, reading in zip("xy", point, strict=True):
                if not reading.is_constant:
                    message = f"must be a plain number, got '{reading.text}'"
                    draft.error((*path, word, i), message)
            yield _Point(point[0].number, point[1].number, (*path, "x", i))


def _have_one_unit(draft: "Draft", path: Path, numbers: Sequence[Any]) -> None:
    """Report a literal of another quantity than the first one of its list."""
    first = next((x for x in numbers if x.unit), None)
    for i, x in enumerate(numbers):
        if first and x.unit and misfit(x.unit, first.unit):
            message = f"is {x.text}, and '{first.text}' in the same list measures something else"
            draft.error((*path, i), message, "write both in one unit")


def _points_of_file(draft: "Draft", path: Path, file: str) -> Iterator[_Point]:
    """Yield the points of a CSV file: two numbers a row; a heading may stand above them."""
    where = FilePath(draft.source.name).parent / file
    try:
        rows = rows_of_table(read_whole(where).decode("utf-8-sig"))
    except (OSError, ValueError) as error:  # no such file, or none of text
        message = f"file '{where.as_posix()}' cannot be read: "
        message += (getattr(error, "strerror", None) or str(error)).lower()
        help = "name a CSV file in UTF-8, by its path from the folder of the scene"
        return draft.error(path, message, help)
    if rows and all(number(cell) is None for cell in rows[0][1]):
        del rows[0]
    for n, cells in rows:
        row, numbers = f"'{file}', row {n}", [number(cell) for cell in cells]
        if len(cells) != 2:
            help = "write x and y with decimal points, and one comma between them"
            draft.error(path, f"{row}: must have two cells, got {len(cells)}", help)
        elif None in numbers:
            column = numbers.index(None)
            what = f"must be a finite number, got '{cells[column].strip()}'"
            help = "write numbers such as 0.5 or 1e-3, or leave the row out"
            draft.error(path, f"{row}, column {column + 1}: {what}", help)
        else:
            yield _Point(numbers[0] or 0.0, numbers[1] or 0.0, path, f"{row}: ")
    return None


def _check(
    draft: "Draft", path: Path, points: Sequence[_Point], *, periodic: bool, integrate: bool
) -> None:
    """Report points that no profile of this kind has."""
    least = 3 if periodic else 2
    if len(points) < least:
        kind = "periodic profile" if periodic else "profile"
        draft.error(path, f"a {kind} must have at least {least} points, got {len(points)}")
    for before, point in pairwise(points):
        if not point.x > before.x:
            message = f"{point.row}x must be larger than the one before, {before.x:.15g}, "
            draft.error(point.path, f"{message}got {point.x:.15g}", "sort the points by x")
    if periodic and points and points[0].y != points[-1].y:
        message = f"{points[-1].row}a periodic profile must end with the y it begins with, "
        help = "the last point is the first one, a period later"
        place = points[-1].path if points[-1].row else (*path, "y", len(points) - 1)
        draft.error(place, f"{message}{points[0].y:.15g}, got {points[-1].y:.15g}", help)
    if periodic and integrate:
        message = "the integral of a periodic profile is not periodic"
        draft.error((*path, "integrate"), message, "leave out 'periodic' or 'integrate'")


def _advise(
    draft: "Draft", path: Path, x: Sequence[float], y: Sequence[float], *, periodic: bool
) -> None:
    """Warn of a spline that swings far out of the range of its points, of the farthest place."""
    low, high = min(y), max(y)
    worst, place, value = 0.0, 0.0, 0.0
    for (left, right), base, piece in zip(
        pairwise(x), y, _pieces(x, y, "cubic", periodic=periodic)[1:], strict=False
    ):
        for s in _level(piece, right - left):
            reached = base + s * (piece[0] + s * (piece[1] + s * piece[2]))
            beyond = max(reached - high, low - reached)
            if beyond > worst:
                worst, place, value = beyond, left + s, reached
    if worst > _OVERSHOOT * (high - low):
        message = f"the spline swings beyond its points, whose y are {low:.6g} to {high:.6g}: "
        help = 'write interpolation = "monotone", which does not, or "linear", or give more points'
        draft.warn(path, f"{message}it is {value:.6g} at x = {place:.6g}", help)


def _level(piece: Piece, length: float) -> Iterator[float]:
    """Yield where a piece has no slope, from 0 to its length."""
    a, b, c = 3.0 * piece[2], 2.0 * piece[1], piece[0]
    root = b * b - 4.0 * a * c
    if root < 0.0:
        return
    q = -0.5 * (b + math.copysign(math.sqrt(root), b))
    for above, below in ((q, a), (c, q)):
        if below and 0.0 < above / below < length:
            yield above / below


# -------------------------------------------------------------------------------------- pieces


def table_of(
    x: Sequence[float],
    y: Sequence[float],
    *,
    interpolation: str = "cubic",
    slopes: Sequence[float] = (),
    periodic: bool = False,
    integrate: bool = False,
    extrapolate: str = "straight",
) -> tuple[float, ...]:
    """Return the table of the curve through points, in the form of ``solver/kernel/tape/spline.c``.

    Where `slopes` at the points are given, they make the curve.
    """
    h = [right - left for left, right in pairwise(x)]
    table, area = [x[-1] - x[0] if periodic else 0.0], 0.0
    places, values = (x[0], *x), (y[0], *y)
    pieces = _between(h, y, slopes) if slopes else _pieces(x, y, interpolation, periodic=periodic)
    if extrapolate == "hold":
        pieces = [(0.0, 0.0, 0.0), *pieces[1:-1], (0.0, 0.0, 0.0)]
    for at, value, piece, step in zip(places, values, pieces, (0.0, *h, 0.0), strict=True):
        c = [value, *piece]
        if integrate:
            c = [area, c[0], c[1] / 2.0, c[2] / 3.0, c[3] / 4.0]
            area += step * (c[1] + step * (c[2] + step * (c[3] + step * c[4])))
        table += at, *c, *[0.0] * (5 - len(c))
    return tuple(table)


def _pieces(
    x: Sequence[float], y: Sequence[float], interpolation: str, *, periodic: bool
) -> list[Piece]:
    """Pieces between the points, after that on the left of them and before that on the right."""
    h = [right - left for left, right in pairwise(x)]
    d = [(right - left) / step for (left, right), step in zip(pairwise(y), h, strict=True)]
    if interpolation == "linear":
        return [(slope, 0.0, 0.0) for slope in (d[0], *d, d[-1])]
    if interpolation == "monotone":
        return _between(h, y, _slopes(h, d, periodic=periodic))
    before = -(-_FORGOTTEN // len(h)) if periodic else 0  # periods, after which it repeats
    bends = _curvatures(h * (2 * before + 1), d * (2 * before + 1))
    bends = bends[before * len(h) : (before + 1) * len(h) + 1]
    if periodic:
        bends[-1] = bends[0]
    pieces = [(d[0] - h[0] * (2.0 * bends[0] + bends[1]) / 6.0, 0.5 * bends[0], 0.0)]
    for mean, step, (m, n) in zip(d, h, pairwise(bends), strict=True):
        pieces.append((mean - step * (2.0 * m + n) / 6.0, 0.5 * m, (n - m) / 6.0 / step))
    return [*pieces, (d[-1] + h[-1] * (bends[-2] + 2.0 * bends[-1]) / 6.0, 0.5 * bends[-1], 0.0)]


def _between(h: Sequence[float], y: Sequence[float], slopes: Sequence[float]) -> list[Piece]:
    """Cubics with these values and slopes at their ends; as `_pieces`."""
    pieces = [(slopes[0], 0.0, 0.0)]
    for (left, right), (m, n), step in zip(pairwise(y), pairwise(slopes), h, strict=True):
        d = (right - left) / step
        pieces.append((m, (3.0 * d - 2.0 * m - n) / step, (m + n - 2.0 * d) / step / step))
    return [*pieces, (slopes[-1], 0.0, 0.0)]


def _slopes(h: Sequence[float], d: Sequence[float], *, periodic: bool) -> list[float]:
    """Slopes at the points, between those of the pieces beside and at most three times either."""
    if len(h) == 1:
        return [d[0], d[0]]

    def mean(i: int) -> float:
        left, right, before, after = h[i - 1], h[i], d[i - 1], d[i]
        if not (before > 0.0 < after or before < 0.0 > after):
            return 0.0
        return 3.0 * (left + right) / (
            (left + 2.0 * right) / before + (2.0 * left + right) / after
        )  # fmt: skip

    def end(near: float, far: float, slope: float, next_slope: float) -> float:
        """Slope of the parabola through three points, as far as it does not overshoot."""
        found = ((2.0 * near + far) * slope - near * next_slope) / (near + far)
        if not (found > 0.0 < slope or found < 0.0 > slope):
            return 0.0
        turns = not (slope > 0.0 < next_slope or slope < 0.0 > next_slope)
        return 3.0 * slope if turns and abs(found) > 3.0 * abs(slope) else found

    inner = [mean(i) for i in range(1, len(h))]
    if periodic:
        return [mean(0), *inner, mean(0)]
    return [end(h[0], h[1], d[0], d[1]), *inner, end(h[-1], h[-2], d[-1], d[-2])]


def _curvatures(h: Sequence[float], d: Sequence[float]) -> list[float]:
    """Second derivatives at the knots, zero at the ends, by elimination."""
    factors, values, bends = [0.0], [0.0], [0.0]
    for (left, right), (slope, next_slope) in zip(pairwise(h), pairwise(d), strict=True):
        pivot = 2.0 * (left + right) - left * factors[-1]
        values.append((6.0 * (next_slope - slope) - left * values[-1]) / pivot)
        factors.append(right / pivot)
    for factor, value in zip(factors[:0:-1], values[:0:-1], strict=True):
        bends.append(value - factor * bends[-1])
    return [0.0, *bends[::-1]]
