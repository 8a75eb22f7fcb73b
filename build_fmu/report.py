"""How commands speak: tables and JSON on stdout, progress on stderr."""

from __future__ import annotations

import contextlib
import json
import sys
from collections.abc import Callable, Iterable, Iterator, Sequence


def print_json(values: object) -> None:
    """One JSON document on stdout."""
    sys.stdout.write(json.dumps(values, indent=2) + "\n")


def print_table(title: str, columns: Sequence[str], rows: Iterable[Sequence[str]]) -> None:
    """Table on stdout; columns after the first are aligned to the right where they are numbers."""
    from rich import box
    from rich.console import Console
    from rich.table import Table
    from rich.text import Text

    table = Table(title=Text(title), title_justify="left", box=box.SIMPLE_HEAD, pad_edge=False)
    for column in columns:
        table.add_column(column, overflow="fold")
    for row in rows:
        table.add_row(*(Text(cell) for cell in row))
    console = Console(file=sys.stdout)
    console.print(table)


def number(value: float) -> str:
    """Value for reading: six digits, aligned sign."""
    return f"{value: .6g}"


@contextlib.contextmanager
def progress_bar(title: str, total: float | None) -> Iterator[Callable[[float], object] | None]:
    """Bar on stderr if that is a terminal; yields what to call with the work done."""
    if not sys.stderr.isatty():
        yield None
        return
    from rich.console import Console
    from rich.progress import BarColumn, Progress, TextColumn, TimeRemainingColumn

    columns = (TextColumn("{task.description}"), BarColumn(), TimeRemainingColumn())
    with Progress(*columns, console=Console(file=sys.stderr), transient=True) as progress:
        task = progress.add_task(title, total=total)
        yield lambda done: progress.update(task, completed=done)
