"""Rows of a study: grids, `--grid a=1:5:9 --grid b=2,3`, and tables of values, `--table FILE.csv`.

    1:5:9         9 values from 1 to 5, both included
    1e-3:10:5:log the same, each a fixed multiple of the one before
    2,3,5:6:11    single values, and ranges among them
    100mm:500mm:5 ends of a range may have a unit, the same one

Grids multiply, the last one turning fastest; a table has one row for each line. A grid has no value
twice; rows of a table may be alike.
"""

from __future__ import annotations

import itertools
import math
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from os import PathLike
from pathlib import Path

from build_fmu.study.csv_tables import csv_table
from build_fmu.study.values import (
    Entry,
    Mistake,
    is_finite,
    is_number,
    plain,
    read_value,
    refuse,
    shown,
    wanted_instead,
)

MOST_ROWS = 1_000_000
"""Most runs or variants of one study; a grid of more is rather a mistake."""
FORM = "write values, a=2,3, or a range, a=1:5:9, which is 9 values from 1 to 5"
NAMES = "write the names of parameters, separated by commas, into the first line"

Row = dict[str, Entry]
_ITEM = re.compile(r"(?:^|,)\s*((?:\[[^\]]*\]|[^,])*)")


class _WrongItemError(ValueError):
    """A mistake so many characters behind the begin of an item, and what it is."""


def rows_of(
    grids: Iterable[str] | Mapping[str, object],
    table: str | PathLike[str] | Sequence[Mapping[str, object]] | None = None,
    mistakes: list[Mistake] | None = None,
) -> list[Row]:
    """Rows of values by name; at least one, which is empty where nothing is varied.

    Parameters
    ----------
    grids
        Texts such as "a=1:5:9", or values by name: a list of them, or a text such as "1:5:9".
    table
        A CSV file whose header has the names, or rows of values by name.
    mistakes
        Takes all mistakes, for the caller to tell with his own. Where there are some, the rows are
        not combined, and have what can be read: for the search for more.

    Raises
    ------
    UsageError
        With every mistake of all of them, if the caller takes none.
    """
    told, mistakes = mistakes, [] if mistakes is None else mistakes
    lists: list[list[Row]] = []
    if isinstance(table, str | PathLike):
        lists.append(_table_of_file(Path(table), mistakes))
    elif table is not None:
        lists.append(_table(table, mistakes))
    lists += _grids(grids, mistakes)
    seen: dict[str, str] = {}
    for rows in lists:
        for name, entry in rows[0].items() if rows else ():
            where = entry.named or entry.where
            if name in seen:
                mistakes.append(Mistake(where, f"{name}: varied by {seen[name]} too"))
            seen[name] = where
    count = math.prod(map(len, lists))
    if count > MOST_ROWS:
        message = f"{count} combinations, more than the {MOST_ROWS} of one study"
        mistakes.append(Mistake(next(iter(seen.values())), message))
    if mistakes:
        refuse(mistakes if told is None else [])
        return [row for rows in lists for row in rows]
    return [{k: v for row in rows for k, v in row.items()} for rows in itertools.product(*lists)]


# ---------------------------------------------------------------------------------------- grids


def _grids(
    grids: Iterable[str] | Mapping[str, object], mistakes: list[Mistake]
) -> Iterator[list[Row]]:
    """Rows of each grid, which have one name."""
    if isinstance(grids, Mapping):
        for name, values in grids.items():
            text = values if isinstance(values, str) else shown(values)
            yield _grid(name, values, f"grid[{name!r}]={text}", 0, mistakes)
        return
    many = isinstance(grids, Iterable) and not isinstance(grids, str)
    for text in map(str, grids if many else [grids]):
        name, equals, values = text.partition("=")
        if equals and name.strip():
            yield _grid(name.strip(), values, f"--grid {text}", len(name) + 1, mistakes)
        else:
            mistakes.append(Mistake(f"--grid {text}", "not of the form name=values", FORM))


def _grid(name: str, values: object, where: str, column: int, mistakes: list[Mistake]) -> list[Row]:
    """Rows of one grid; its text begins behind this column."""
    found: list[object] = []
    if isinstance(values, str):
        for match in _ITEM.finditer(values):
            try:
                found += _values_of(match[1].strip())
            except _WrongItemError as wrong:
                behind, words = wrong.args
                at = column + match.start(1) + behind + 1
                mistakes.append(Mistake(where, f"column {at}: {words}", FORM))
    else:
        listed = plain(values)
        found += map(plain, listed) if isinstance(listed, Iterable) else [listed]
        if not found:
            mistakes.append(Mistake(where, "no values", FORM))
    seen: set[object] = set()
    for value in found:  # 1 and 1.0 are one value, 1 and true are two
        same = value if is_number(value) else repr(value)
        if same in seen:
            message = f"the value {shown(value)} is given twice; give it once"
            mistakes.append(Mistake(where, message))
        seen.add(same)
    return [{name: Entry(value, where)} for value in found]


def _values_of(item: str) -> list[object]:
    """Values of one item: a range, or a single value."""
    parts = item.split(":")
    if not item:
        raise _WrongItemError(0, "a value is missing")
    if len(parts) == 1 or item.startswith("["):
        return [_read(item, 0)]
    is_log = len(parts) == 4 and parts[3].strip() == "log"
    if len(parts) != 3 and not is_log:
        raise _WrongItemError(0, f"{item!r} is not a range from:to:count")
    from solver.scene.units import parted  # --help needs nothing of the solver

    numbers: list[float] = []
    ends = [parted(part) for part in parts[:2]]
    units = {unit for _, unit in ends}
    if len(units) > 1:
        text = f"from and to of a range must have one unit, got {parts[0]!r} and {parts[1]!r}"
        raise _WrongItemError(0, text)
    at = 0
    for part in (*(number for number, _ in ends), parts[2]):
        value = part if part.strip().startswith(("[", "{")) else _read(part, at)
        if not is_finite(value):
            raise _WrongItemError(at, f"{shown(part)} is not {wanted_instead(value)}")
        numbers.append(value)
        at += len(part) + 1
    first, last, count = numbers
    wrong = ""
    if not (isinstance(count, int) and 2 <= count <= MOST_ROWS):
        wrong = f"the count must be a whole number from 2 to {MOST_ROWS}, got {count!r}"
    elif first == last:
        wrong = f"from and to of a range must differ, got {first!r} and {last!r}"
    elif is_log and not (first > 0.0 < last or first < 0.0 > last):
        wrong = f"from and to of a range with log must have one sign, got {first!r} and {last!r}"
    if wrong:
        raise _WrongItemError(0, wrong)
    values = (_log_spaced if is_log else _evenly_spaced)(first, last, int(count))
    unit = units.pop()
    return [f"{value!r} {unit}" for value in values] if unit else values


def _read(text: str, at: int) -> object:
    try:
        return read_value(text)
    except ValueError as error:
        raise _WrongItemError(at, f"{text!r}: {error}") from None


def _log_spaced(first: float, last: float, count: int) -> list[object]:
    """Each a fixed multiple of the one before; the quotient of the ends need not be a double."""
    n, a, b = count - 1, abs(float(first)), abs(float(last))
    inner = (a ** ((n - i) / n) * b ** (i / n) for i in range(1, n))
    return [first, *(math.copysign(value, first) for value in inner), last]


def _evenly_spaced(first: float, last: float, count: int) -> list[object]:
    """Exact between the decimals as they are written, and rounded once: 0.1:0.3:3 has 0.2."""
    a, b, n = Fraction(str(first)), Fraction(str(last)), count - 1
    scale = math.lcm(a.denominator, b.denominator)
    left, right = int(a * scale), int(b * scale)
    inner = [left * (n - i) + right * i for i in range(1, n)]
    if isinstance(first, int) and isinstance(last, int) and not any(x % n for x in inner):
        return [first, *(x // n for x in inner), last]
    return [float(first), *(x / (scale * n) for x in inner), float(last)]


# ---------------------------------------------------------------------------------------- tables


def _table(table: Sequence[Mapping[str, object]], mistakes: list[Mistake]) -> list[Row]:
    """Rows of a table that is given in Python."""
    rows: list[Row] = []
    for i, row in enumerate(table):
        where = f"table[{i}]"
        if not isinstance(row, Mapping):
            message = f"must have values by name, got {shown(row)}"
            help = 'of a data frame, give table=frame.to_dict("records")'
            mistakes.append(Mistake(where, message, help))
            return []
        if rows and row.keys() != rows[0].keys():
            other = ", ".join(sorted(map(str, row.keys() ^ rows[0].keys())))
            mistakes.append(Mistake(where, f"must have the names of table[0]: differs in {other}"))
        rows.append({k: Entry(plain(v), where, named="table") for k, v in row.items()})
    if not rows:
        mistakes.append(Mistake("table", "has no rows"))
    return rows


def _table_of_file(path: Path, mistakes: list[Mistake]) -> list[Row]:
    before = len(mistakes)
    header, head, lines = csv_table(path, NAMES, mistakes)
    wrong = [name for name in head if not _is_name(name)]
    for name in filter(None, wrong):
        message = f"column {head.index(name) + 1}: {name!r} is not a name"
        mistakes.append(Mistake(header, message, NAMES))
    rows: list[Row] = []
    for where, cells in lines:
        row: Row = {}
        for name, cell in zip(head, cells, strict=True):
            try:
                if not cell:
                    mistakes.append(Mistake(where, f"{name}: an empty cell"))
                elif name not in wrong:
                    row[name] = Entry(read_value(cell), where, named=header)
            except ValueError as error:
                mistakes.append(Mistake(where, f"{name}: {cell}: {error}"))
        rows.append(row)
    if not rows and len(mistakes) == before:
        mistakes.append(Mistake(str(path), "has no rows below its header"))
    return rows


def _is_name(text: str) -> bool:
    try:
        return isinstance(read_value(text), bool | str) and not re.search("^$|[;\t]", text)
    except ValueError:  # a list, or a number with a mistake
        return False
