"""How commands speak: tables and JSON on stdout, progress on stderr."""

from __future__ import annotations

import contextlib
import json
import sys
from collections.abc import Callable, Iterable, Iterator, Sequence

FILE_WIDTH = 120
"""Columns of a table that does not go to a terminal."""


def print_json(values: object) -> None:
    """One JSON document on stdout."""
    sys.stdout.write(json.dumps(values, indent=2) + "\n")


def print_table(title: str, columns: Sequence[str], rows: Iterable[Sequence[str]]) -> None:
    """Table on stdout below its title; columns without names have no head."""
    from rich import box
    from rich.console import Console
    from rich.table import Table
    from rich.text import Text

    table = Table(box=box.SIMPLE_HEAD, pad_edge=False, show_header=any(columns), show_edge=False)
    for i, column in enumerate(columns):
        table.add_column(Text(column), no_wrap=i == 0)
    for row in rows:
        table.add_row(*(Text(cell) for cell in row))
    console = Console(file=sys.stdout, width=None if sys.stdout.isatty() else FILE_WIDTH)
    with console.capture() as capture:
        console.print(table)
    lines = (line.rstrip() for line in capture.get().splitlines())
    sys.stdout.write("\n".join([title, "", *lines, "", ""]))


def number(value: float) -> str:
    """Value for reading: six digits, aligned sign."""
    return f"{value: .6g}"


@contextlib.contextmanager
def progress_bar(title: str) -> Iterator[Callable[[float], object] | None]:
    """Bar on stderr if that is a terminal; yields what to call with the part done."""
    if not sys.stderr.isatty():
        yield None
        return
    from rich.console import Console
    from rich.progress import BarColumn, Progress, TextColumn, TimeRemainingColumn

    columns = (TextColumn("{task.description}"), BarColumn(), TimeRemainingColumn())
    with Progress(*columns, console=Console(file=sys.stderr), transient=True) as progress:
        task = progress.add_task(title, total=1.0)
        yield lambda done: progress.update(task, completed=done)
