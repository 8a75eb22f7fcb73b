"""How commands speak: tables and JSON on stdout, progress on stderr."""

from __future__ import annotations

import contextlib
import json
import sys
import time
import warnings
from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import Any

FILE_WIDTH = 120
"""Columns of a table that does not go to a terminal."""
SECONDS_BETWEEN_LINES = 10.0
"""Of progress where stderr is no terminal."""


@contextlib.contextmanager
def scene_warnings() -> Iterator[list[str]]:
    """Say each warning of a scene on stderr, once; yields the list of those that were said."""
    from solver.scene import SceneWarning

    said: list[str] = []
    usual = warnings.showwarning

    def show(message: Warning | str, category: type[Warning], *place: Any) -> None:
        if not issubclass(category, SceneWarning):
            usual(message, category, *place)
        elif str(message) not in said:
            said.append(str(message))
            sys.stderr.write(f"{message}\n")

    with warnings.catch_warnings():
        warnings.simplefilter("always", SceneWarning)
        warnings.showwarning = show
        yield said


def print_json(values: object) -> None:
    """One JSON document on stdout."""
    sys.stdout.write(json_text(values) + "\n")


def json_text(values: object, indent: int = 2) -> str:
    """Text of a JSON document; numbers that are not finite, which JSON has not, become null."""
    finite = json.loads(json.dumps(values), parse_constant=lambda _: None)
    return json.dumps(finite, indent=indent)


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
    """Value for reading: six digits, aligned sign, no -0."""
    return f"{value + 0.0: .6g}"


def as_text(value: object) -> str:
    """Value of a variable as a person writes it: 20 for 20.0, true for True, nothing for None."""
    if value is None:
        return ""
    if isinstance(value, bool):
        return str(value).lower()
    return str(value).removesuffix(".0") if isinstance(value, float) else str(value)


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


@contextlib.contextmanager
def count_bar(title: str, what: str) -> Iterator[Callable[[int, int], object]]:
    """Bar on stderr, or where that is no terminal a line now and then; takes done and all."""
    with progress_bar(title) as bar:
        begin = said = time.monotonic()

        def show(done: int, count: int) -> None:
            nonlocal said
            if bar is not None:
                bar(done / count)
            elif time.monotonic() - said > SECONDS_BETWEEN_LINES:
                said = time.monotonic()
                left = (said - begin) * (count / done - 1.0)
                sys.stderr.write(f"{title}: {done} of {count} {what}, {left:.0f} s left\n")

        yield show
