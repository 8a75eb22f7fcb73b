"""Rows of a study: grids, `--grid a=1:5:9 --grid b=2,3`, and tables of values, `--table FILE.csv`.

    1:5:9         9 values from 1 to 5, both included
    1e-3:10:5:log the same, each a fixed multiple of the one before
    2,3,5:6:11    single values, and ranges among them

Grids multiply, the last one turning fastest; a table has one row for each line. A grid has no value
twice; rows of a table may be alike.
"""

from __future__ import annotations

import itertools
import math
import re
from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from os import PathLike
from pathlib import Path

from build_fmu.study.csv_file import csv_rows
from build_fmu.study.parameter_files import value_of_cell
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

Row = dict[str, Entry]
_ITEM = re.compile(r"(?:\[[^\]]*\]|[^,])*")


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
    lists = [_table(table, mistakes)] if table is not None else []
    lists += [[{name: x} for x in values] for name, values in _grids(grids, mistakes)]
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
) -> list[tuple[str, list[Entry]]]:
    if isinstance(grids, Mapping):
        pairs = [
            (name, values, f"grid[{name!r}]={values if isinstance(values, str) else shown(values)}")
            for name, values in grids.items()
        ]
    else:
        pairs = []
        many = isinstance(grids, Iterable) and not isinstance(grids, str)
        for text in map(str, grids if many else [grids]):
            name, equals, values = text.partition("=")
            where = f"--grid {text}"
            if equals and name.strip():
                pairs.append((name.strip(), values, where))
            else:
                mistakes.append(Mistake(where, "not of the form name=values", FORM))
    return [(name, _entries(values, where, mistakes)) for name, values, where in pairs]


def _entries(values: object, where: str, mistakes: list[Mistake]) -> list[Entry]:
    if isinstance(values, str):
        found = _values(values, where, mistakes)
    else:
        found = plain(values)
        found = [plain(value) for value in found] if isinstance(found, Iterable) else [found]
        if not found:
            mistakes.append(Mistake(where, "no values", FORM))
    seen: set[object] = set()
    for value in found:
        same = (
            value if is_number(value) else repr(value)
        )  # 1 and 1.0 are one value, 1 and true are two
        if same in seen:
            message = f"the value {shown(value)} is given twice; give it once"
            mistakes.append(Mistake(where, message))
        seen.add(same)
    return [Entry(value, where) for value in found]


def _values(text: str, where: str, mistakes: list[Mistake]) -> list[object]:
    """Values of "1:5:9,7", each item with its column for mistakes."""
    values: list[object] = []
    argument = where.removeprefix("--grid ")
    offset, at = len(argument) - len(text) if argument != where else 0, 0
    while True:
        match = _ITEM.match(text, at)
        item = match.group() if match else ""
        column = offset + at + len(item) - len(item.lstrip()) + 1
        values += _item(item.strip(), column, where, mistakes)
        at += len(item)
        if at >= len(text):
            return values
        at += 1  # the comma


def _item(item: str, column: int, where: str, mistakes: list[Mistake]) -> list[object]:
    """Values of one item: a range, or a single value."""
    parts = item.split(":")
    if len(parts) == 1 or item.startswith("["):
        try:
            if not item:
                mistakes.append(Mistake(where, f"column {column}: a value is missing", FORM))
                return []
            return [read_value(item)]
        except ValueError as error:
            mistakes.append(Mistake(where, f"column {column}: {item!r}: {error}", FORM))
            return []
    log = len(parts) == 4 and parts[3].strip() == "log"
    if len(parts) != 3 and not log:
        message = f"column {column}: {item!r} is not a range from:to:count"
        mistakes.append(Mistake(where, message, FORM))
        return []
    numbers: list[float] = []
    for part in parts[:3]:
        try:
            value = read_value(part) if not part.strip().startswith(("[", "{")) else part
        except ValueError as error:
            mistakes.append(Mistake(where, f"column {column}: {part!r}: {error}", FORM))
            return []
        if not is_finite(value):
            message = f"column {column}: {shown(part)} is not {wanted_instead(value)}"
            mistakes.append(Mistake(where, message, FORM))
            return []
        numbers.append(value)
        column += len(part) + 1
    return _range(numbers, log, where, mistakes)


def _range(
    numbers: Sequence[float], log: bool, where: str, mistakes: list[Mistake]
) -> list[object]:
    first, last, count = numbers
    wrong = ""
    if not (isinstance(count, int) and 2 <= count <= MOST_ROWS):
        wrong = f"the count must be a whole number from 2 to {MOST_ROWS}, got {count!r}"
    elif first == last:
        wrong = f"from and to of a range must differ, got {first!r} and {last!r}"
    elif log and not (first > 0.0 < last or first < 0.0 > last):
        wrong = f"from and to of a range with log must have one sign, got {first!r} and {last!r}"
    if wrong:
        mistakes.append(Mistake(where, wrong, FORM))
        return []
    return _log_spaced(first, last, int(count)) if log else _evenly_spaced(first, last, int(count))


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


def _table(
    table: str | PathLike[str] | Sequence[Mapping[str, object]], mistakes: list[Mistake]
) -> list[Row]:
    if not isinstance(table, str | PathLike):
        return _rows(table, mistakes)
    path, before = Path(table), len(mistakes)
    rows = [*csv_rows(path, mistakes)]
    is_read = len(mistakes) == before
    if not rows and not is_read:
        return []
    (header, head), *lines = rows or [(f"{path}:1", [])]
    wrong = _wrong_names(header, head, mistakes)
    if head and not lines and is_read:
        mistakes.append(Mistake(str(path), "has no rows below its header"))
    read = [_row(where, header, head, cells, mistakes) for where, cells in lines]
    return [{name: row[name] for name in row if name not in wrong} for row in read]


def _rows(table: Sequence[Mapping[str, object]], mistakes: list[Mistake]) -> list[Row]:
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


def _wrong_names(where: str, head: Sequence[str], mistakes: list[Mistake]) -> set[str]:
    wrong: set[str] = set()
    help = "write the names of parameters, separated by commas, into the first line"
    if not head:
        mistakes.append(Mistake(where, "no header", help))
    for number, name in enumerate(head, start=1):
        message = ""
        if not name:
            message = f"column {number} has no name"
        elif name in head[: number - 1]:
            message = f"column {number}: {name!r} is given twice"
        elif re.search("[;\t]", name) or _is_number(name):
            message = f"column {number}: {name!r} is not a name"
        if message:
            mistakes.append(Mistake(where, message, help))
            wrong.add(name)
    return wrong


def _is_number(name: str) -> bool:
    try:
        return isinstance(read_value(name), int | float)
    except ValueError:  # a list, or a number with a mistake
        return True


def _row(
    where: str, header: str, head: Sequence[str], cells: Sequence[str], mistakes: list[Mistake]
) -> Row:
    row = {}
    for name, cell in zip(head, cells, strict=True):
        before = len(mistakes)
        if not cell:
            mistakes.append(Mistake(where, f"{name}: an empty cell"))
        value = value_of_cell(cell, where, mistakes)
        if len(mistakes) == before:
            row[name] = Entry(value, where, named=header)
    return row
