"""Rows of a CSV file that people or programs write, each with its place, "a.csv:3"."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterator
from pathlib import Path

from build_fmu.study.values import Mistake, counted


def csv_rows(path: Path, mistakes: list[Mistake]) -> Iterator[tuple[str, list[str]]]:
    """Place and cells of each row that is not empty; the first is the header.

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
        text = path.read_bytes().decode("utf-8-sig")
    except UnicodeDecodeError as error:
        message = f"not a UTF-8 text: byte 0x{error.object[error.start]:02x}"
        line = error.object[: error.start].count(b"\n") + 1
        mistakes.append(Mistake(f"{path}:{line}", message, "save the file as UTF-8"))
    except OSError as error:
        help = "look at its name and folder"
        mistakes.append(Mistake(str(path), f"cannot be read: {error.strerror}", help))
    else:
        yield from io.StringIO(text, newline="")
