"""CSV files: tables of people or programs, each row with its place, "a.csv:3"; and our own."""

from __future__ import annotations

import csv
import io
import json
from collections.abc import Container, Iterator
from pathlib import Path

from build_fmu.study.values import Mistake, counted
from solver.files import read_whole

Rows = Iterator[tuple[str, list[str]]]
"""Place and cells of each."""


def csv_table(path: Path, help: str, mistakes: list[Mistake]) -> tuple[str, list[str], Rows]:
    """Place and names of the header, and the rows below it that are not empty.

    A header that is not there, and names that are missing or given twice, are mistakes with this
    help.
    """
    before, rows = len(mistakes), _rows(path, mistakes)
    where, head = next(rows, (f"{path}:1", []))
    if not head and len(mistakes) == before:
        mistakes.append(Mistake(where, "no header", help))
    for number, name in enumerate(head, start=1):
        if not name or name in head[: number - 1]:
            wrong = f": {name!r} is given twice" if name else " has no name"
            mistakes.append(Mistake(where, f"column {number}{wrong}", help))
    return where, head, rows


def column_name(parameter: str, own: Container[str]) -> str:
    """Name of the column of a parameter in a table that has columns of its `own`."""
    return f"{parameter} (parameter)" if parameter in own else parameter


def cell(value: object) -> str:
    """Value as the text of a cell, which reads back as the same value."""
    if isinstance(value, float) and value - value == 0.0:
        return repr(value)  # as json.dumps does, which takes five times as long
    return value if isinstance(value, str) else json.dumps(value)


def _rows(path: Path, mistakes: list[Mistake]) -> Rows:
    """Rows that are not empty; the first is the header.

    A row that is not as long as the header, and what keeps the file from being read to its end, is
    a mistake instead.
    """
    reader, head = csv.reader(_lines(path, mistakes), skipinitialspace=True, strict=True), 0
    try:
        for row in reader:
            cells, where = [cell.strip() for cell in row], f"{path}:{reader.line_num}"
            if not any(cells):
                continue
            head = head or len(cells)
            if len(cells) == head:
                yield where, cells
            else:
                message = f"has {counted(len(cells), 'cell')}, and the header has {head}"
                mistakes.append(Mistake(where, message, "put a text with a comma into quotes"))
    except csv.Error as error:
        mistakes.append(Mistake(f"{path}:{reader.line_num}", *_words(str(error))))


def _words(error: str) -> tuple[str, str]:
    """What keeps a file from being read to its end, and what helps."""
    if error.startswith("field larger"):
        help = "no value is so long; look for a quote in front of it that is not closed"
        return f"a cell has more than {csv.field_size_limit()} characters", help
    help = "close each quote, before a comma or the end of the line; double one within a text"
    of_quotes = "expected after" in error or "unexpected end" in error
    return f"not CSV: {error}", help if of_quotes else ""


def _lines(path: Path, mistakes: list[Mistake]) -> Iterator[str]:
    try:
        text = read_whole(path).decode("utf-8-sig")
    except UnicodeDecodeError as error:
        message = f"not a UTF-8 text: byte 0x{error.object[error.start]:02x}"
        line = error.object[: error.start].count(b"\n") + 1
        mistakes.append(Mistake(f"{path}:{line}", message, "save the file as UTF-8"))
    except OSError as error:
        help = "look at its name and folder"
        mistakes.append(Mistake(str(path), f"cannot be read: {error.strerror}", help))
    else:
        yield from io.StringIO(text, newline="")
