"""Profiles: functions through given points, which expressions call by their names.

A profile is a cubic spline, and straight beyond its ends. With h, d and M the length, mean slope
and curvature of its pieces and knots,

    h_k-1 M_k-1 + 2 (h_k-1 + h_k) M_k + h_k M_k+1 = 6 (d_k - d_k-1),

where M is 0 at both ends, so that curvature does not jump there either, or repeats.
"""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from pathlib import Path as FilePath
from typing import TYPE_CHECKING, Annotated, Any, NamedTuple

from solver.files import read_whole
from solver.scene import fields as kind
from solver.scene.expression import FUNCTIONS, Curve
from solver.scene.fields import BROKEN, Part, shown
from solver.scene.files import number, rows_of_table
from solver.scene.report import Path

if TYPE_CHECKING:
    from solver.scene.draft import Draft

_NUMBERS, _SWITCH = kind.ListOf(item=kind.Quantity(), example=[0, 0.5, 1]), kind.Plain(type=bool)
_FORGOTTEN = 64
"""Knots after which an end has no influence: it falls at least by half from one to the next."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Profile(Part):
    """A function through given points, a cubic spline; expressions call it by its name."""

    file: Annotated[
        str, kind.Plain(text="CSV of x and y, found from the scene's folder", example="lobe.csv")
    ] = ""
    x: Annotated[tuple[float, ...], _NUMBERS] = ()
    y: Annotated[tuple[float, ...], _NUMBERS] = ()
    periodic: Annotated[bool, _SWITCH] = False
    """Whether it repeats; its period is the distance of its ends."""
    integrate: Annotated[bool, _SWITCH] = False
    """Whether it is the integral of the spline, from the first x on."""
    curve: Curve = field(default=Curve("", ()), repr=False, compare=False)
    """What expressions call."""

    @property
    def text(self) -> str:
        """The profile as it stands in a scene file that has its points."""
        switches = f"periodic = {shown(self.periodic)}, integrate = {shown(self.integrate)}"
        return f"{{ x = {shown(list(self.x))}, y = {shown(list(self.y))}, {switches} }}"


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
        switches = {word: getattr(given, word) is True for word in ("periodic", "integrate")}
        if whole and len(draft.problems) == before:
            _check(draft, path, points, **switches)
        if whole and len(draft.problems) == before:
            x, y, *_ = zip(*points, strict=True)
            curve = draft.curves[name] = Curve(name, table_of(x, y, **switches))
            if not all(map(math.isfinite, curve.numbers)):
                draft.error(path, "no spline has these points: their numbers differ too much")
            found[name] = Profile(file=given.file or "", x=x, y=y, curve=curve, **switches)
    return found


def _points(draft: "Draft", path: Path, given: Any) -> Iterator[_Point]:
    """Yield the points of a profile; report what is none."""
    file, x, y = given.file, given.x, given.y
    if BROKEN in (file, x, y):
        return
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


# -------------------------------------------------------------------------------------- spline


def table_of(
    x: Sequence[float], y: Sequence[float], *, periodic: bool = False, integrate: bool = False
) -> tuple[float, ...]:
    """Return the table of the spline through points, in the form of ``solver/kernel/spline.c``."""
    h = [right - left for left, right in pairwise(x)]
    d = [(right - left) / step for (left, right), step in zip(pairwise(y), h, strict=True)]
    before = -(-_FORGOTTEN // len(h)) if periodic else 0  # periods, after which it repeats
    bends = _curvatures(h * (2 * before + 1), d * (2 * before + 1))
    bends = bends[before * len(h) : (before + 1) * len(h) + 1]
    if periodic:
        bends[-1] = bends[0]
    begin = d[0] - h[0] * (2.0 * bends[0] + bends[1]) / 6.0
    rows = [(x[0], y[0], begin, 0.5 * bends[0], 0.0)]
    for at, value, slope, step, (m, n) in zip(x, y, d, h, pairwise(bends), strict=False):
        rows.append((at, value, slope - step * (2.0 * m + n) / 6.0, 0.5 * m, (n - m) / 6.0 / step))
    end = d[-1] + h[-1] * (bends[-2] + 2.0 * bends[-1]) / 6.0
    rows.append((x[-1], y[-1], end, 0.5 * bends[-1], 0.0))
    table, area = [x[-1] - x[0] if periodic else 0.0], 0.0
    for (at, *c), step in zip(rows, (0.0, *h, 0.0), strict=True):
        if integrate:
            c = [area, c[0], c[1] / 2.0, c[2] / 3.0, c[3] / 4.0]
            area += step * (c[1] + step * (c[2] + step * (c[3] + step * c[4])))
        table += at, *c, *[0.0] * (5 - len(c))
    return tuple(table)


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
