"""What an FMU is held against: columns by name, from a CSV file or arrays, and what error passes.

A column may be off by `relative` times its largest value, and by round-off of the largest value of
its unit: what is zero by symmetry, the height of a planar point, say, is noise in both.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from os import PathLike, fspath
from pathlib import Path
from typing import TYPE_CHECKING, Any

from build_fmu.motion import OF_THE_SOLUTION
from build_fmu.study.csv_tables import csv_table
from build_fmu.study.values import Mistake, nearest, refuse
from solver.signals import Problem, arrays_over_time

if TYPE_CHECKING:
    from numpy import ndarray

Reference = str | PathLike[str] | Mapping[str, Any]

ROUND_OFF = 1e-10
"""Part of the largest value of a unit. Noise of the scenes, with factors rounded otherwise, is
1e-14 of it; steps are solved to 1e-12; the rest is for longer runs."""


def name_of(reference: Reference) -> str:
    """Name for messages."""
    return "the reference" if isinstance(reference, Mapping) else fspath(reference)


def columns_of(reference: Reference) -> dict[str, ndarray]:
    """Arrays by name, checked: times that ascend, and a finite value for each of them.

    Raises
    ------
    UsageError
        With every mistake.
    """
    is_file = not isinstance(reference, Mapping)
    columns, places = read_columns(reference) if is_file else (reference, [])
    problems: list[Problem] = []
    arrays = arrays_over_time(columns, problems, places=places)
    refuse(Mistake(name_of(reference), *problem) for problem in problems)
    return arrays


def read_columns(file: str | PathLike[str]) -> tuple[dict[str, list[float]], list[str]]:
    """Columns of a CSV file of numbers, and the line of each row.

    Raises
    ------
    UsageError
        With every mistake.
    """
    path, mistakes, places = Path(file), list[Mistake](), list[str]()
    help = (
        "write a name for each column into the first line, 'time' among them, with commas between"
    )
    _, head, rows = csv_table(path, help, mistakes)
    columns: dict[str, list[float]] = {name: [] for name in head}
    for where, cells in rows if "time" in head else ():
        places.append(f"line {where.rpartition(':')[2]}")
        for name, cell in zip(head, cells, strict=True):
            value = _number(cell)
            if abs(value) < float("inf"):
                columns[name].append(value)
            else:
                help = "leave out the row, or the column"
                message = f"{name}: must be a finite number, got {cell!r}"
                mistakes.append(Mistake(where, message, help))
    refuse(mistakes)
    return columns, places


def _number(cell: str) -> float:
    try:
        return float(cell)
    except ValueError:
        return float("nan")


def names_to_compare(
    expected: Mapping[str, Any],
    columns: Sequence[str] | None,
    variables: Mapping[str, str],
    where: str,
) -> list[str]:
    """Names of columns, each one of the reference and of the FMU; at least one.

    `variables` has the causality of each. None for `columns` means all outputs but those that say
    how exact a run is, not how it moves.

    Raises
    ------
    UsageError
        With every mistake.
    """
    if columns is None:
        outputs = [name for name, causality in variables.items() if causality == "output"]
        names = [name for name in expected if name in outputs]
        moving = [name for name in names if not name.startswith(OF_THE_SOLUTION)]
        if not names:
            help = nearest(next((x for x in expected if x != "time"), ""), outputs)
            refuse([Mistake(where, "no column is an output of the FMU", help)])
        if not moving:
            message = "all columns tell how exact a run is, and none how it moves"
            refuse([Mistake(where, message, "name those to compare in columns=[...]")])
        return moving
    if isinstance(columns, str) or not columns:
        help = "name at least one, or leave columns out to compare all"
        refuse([Mistake("columns", f"must be a list of names, got {columns!r}", help)])
    refuse(
        Mistake(where, f"{name}: not {words}", nearest(name, among))
        for name in columns
        for words, among in (
            ("in the reference", expected),
            ("a variable of the FMU", [*variables]),
        )
        if name not in among
    )
    return list(columns)


def limits(
    expected: Mapping[str, ndarray],
    names: Sequence[str],
    units: Mapping[str, str],
    relative: float,
    absolute: float | Mapping[str, float],
) -> dict[str, float]:
    """Error that passes in each column.

    Raises
    ------
    UsageError
        If `absolute` has a name that is not compared.
    """
    if isinstance(absolute, Mapping):
        refuse(
            Mistake("absolute", f"{name}: not compared", nearest(name, names))
            for name in absolute
            if name not in names
        )
    own = {name: float(abs(expected[name]).max()) for name in names}
    found = {}
    for name in names:
        # What has no unit is of any kind: its own value is all there is to measure it by.
        alike = [own[x] for x in names if x == name or (units[x] and units[x] == units[name])]
        noise = min(relative, ROUND_OFF) * max(alike)
        besides = absolute.get(name, 0.0) if isinstance(absolute, Mapping) else absolute
        found[name] = max(relative * own[name], noise) + besides
    return found
