"""Tests of FMUs, for pytest or alone: what it conserves, and whether it follows a reference.

    from build_fmu.testing import assert_conserves, assert_follows

    def test_the_linkage():
        assert_conserves("linkage.fmu", stop_time=10.0)
        assert_follows("linkage.fmu", "measured.csv", absolute=1e-3)

Both run the FMU in fmpy, from its archive; a scene may stand for it. What fails is an
AssertionError that says where, when and by how much.
"""

from __future__ import annotations

import csv
from collections.abc import Mapping, Sequence
from os import PathLike, fspath
from pathlib import Path
from typing import TYPE_CHECKING, Any

from build_fmu.study.settings import Source, entries_of
from build_fmu.study.values import Mistake, nearest, refuse

if TYPE_CHECKING:
    from numpy import ndarray

    from build_fmu.run import Run

__all__ = ["assert_conserves", "assert_follows"]

Reference = str | PathLike[str] | Mapping[str, Any]


def assert_conserves(
    target: str | PathLike[str],
    *,
    energy: float = 1e-9,
    constraint: float = 1e-9,
    stop_time: float | None = None,
    step_size: float | None = None,
    parameters: Source | None = None,
) -> Run:
    """Run to the end, and require that energy and constraints hold all along.

    Parameters
    ----------
    target
        An FMU of build-fmu, or a scene.
    energy, constraint
        Largest `energy.error` and `constraint.position` that pass, relative to the largest energy
        and to length squared.
    stop_time, step_size
        Stop time and communication step in s; None: of the default experiment.
    parameters
        Values of parameters and inputs by name, or a file of them.

    Returns
    -------
    build_fmu.run.Run
        The run, for further tests: `run.values["B0.x"]`.
    """
    __tracebackhide__ = True
    from build_fmu.run import run_fmu
    from build_fmu.target import runnable

    with runnable(fspath(target), entries_of(parameters)) as (path, left):
        run = run_fmu(path, stop_time=stop_time, step_size=step_size, settings=left)
    problems = [run.failure] if run.failure else []
    names = run.values.dtype.names or ()
    for name, limit in (("energy.error", energy), ("constraint.position", constraint)):
        if name not in names:
            problems.append(f"there is no output {name!r}; is it an FMU of build-fmu?")
            continue
        sizes = abs(run.values[name])
        worst = int(sizes.argmax())
        if not sizes[worst] <= limit:
            at = float(run.values["time"][worst])
            problems.append(f"{name} is {sizes[worst]:.3g} at t = {at:g} s, more than {limit:g}")
    _require(f"{target} does not conserve", problems)
    return run


def assert_follows(
    target: str | PathLike[str],
    reference: Reference,
    *,
    relative: float = 1e-6,
    absolute: float | Mapping[str, float] = 0.0,
    columns: Sequence[str] | None = None,
    parameters: Source | None = None,
) -> dict[str, ndarray]:
    """Run through the times of a reference, and require its values at each of them.

    Parameters
    ----------
    target
        An FMU, or a scene.
    reference
        A CSV file whose first line has the names, among them "time", as `build-fmu simulate --csv`
        and fmpy write it; or arrays by name.
    relative
        Error that passes, relative to the largest value of the reference in that column.
    absolute
        Error that passes besides, in the unit of the column; one for all, or by name.
    columns
        What to compare; None: all columns that are variables of the FMU, and at least one.
    parameters
        Values of parameters and inputs by name, or a file of them.

    Returns
    -------
    dict of str to ndarray
        What the FMU gave, by column, and "time".
    """
    __tracebackhide__ = True
    import numpy as np

    from build_fmu.run import failure
    from build_fmu.study.kept import KeptFmu
    from build_fmu.study.settings import fmu_settings
    from build_fmu.target import runnable

    expected = _reference(reference)
    with runnable(fspath(target), entries_of(parameters)) as (path, left):
        fmu = KeptFmu(path)
        try:
            settings = fmu_settings(path, fmu.description, [left])[0]
            known = [v.name for v in fmu.description.modelVariables if v.type != "String"]
            names = _columns(expected, columns, known, _name(reference))
            times = expected["time"].tolist()
            record = fmu.run(settings, times, names)
        finally:
            fmu.close()
    finished = len(record.values) == len(times)
    told = failure(record.end_time, times[-1], finished, record.reason)
    problems = [told] if told else []
    found = {"time": expected["time"][: len(record.values)]}
    for name, column in zip(names, record.values.T, strict=True):
        found[name] = column
        limit = relative * float(np.abs(expected[name]).max())
        limit += absolute.get(name, 0.0) if isinstance(absolute, Mapping) else absolute
        problems += _differences(name, times, column, expected[name], limit)
    _require(f"{target} does not follow {_name(reference)}", problems)
    return found


def _differences(
    name: str, times: Sequence[float], found: ndarray, expected: ndarray, limit: float
) -> list[str]:
    """A sentence about a column that is off; only points that were reached are compared."""
    if not len(found):
        return []
    error = abs(found - expected[: len(found)])
    beyond = int((~(error <= limit)).sum())
    if not beyond:
        return []
    worst = int(error.argmax())
    return [
        f"{name} is off by {error[worst]:.3g} at t = {times[worst]:g} s "
        f"({found[worst]:.9g}, expected {expected[worst]:.9g}), more than {limit:.3g}; "
        f"{beyond} of {len(found)} points are"
    ]


def _require(what: str, problems: Sequence[str]) -> None:
    __tracebackhide__ = True
    if problems:
        raise AssertionError("\n  ".join([f"{what}:", *problems]))


# ------------------------------------------------------------------------------- the reference


def _name(reference: Reference) -> str:
    return "the reference" if isinstance(reference, Mapping) else fspath(reference)


def _reference(reference: Reference) -> dict[str, ndarray]:
    """Arrays by name, checked: times that ascend, and a value for each of them."""
    import numpy as np

    mistakes: list[Mistake] = []
    if isinstance(reference, Mapping):
        columns = {name: np.asarray(values, float) for name, values in reference.items()}
        where = "the reference"
    else:
        where = fspath(reference)
        columns = {name: np.array(x) for name, x in _read(Path(reference), mistakes).items()}
    refuse(mistakes)
    times = columns.get("time")
    if times is None:
        known = ", ".join(columns)
        mistakes.append(Mistake(where, "has no column 'time'", f"there are {known}"))
    elif len(times) < 2 or not (np.diff(times) > 0.0).all():
        row = int(np.argmin(np.diff(times))) + 1 if len(times) > 1 else 0
        message = f"time must ascend, from at least two rows; row {row + 1} does not"
        mistakes.append(Mistake(where, message))
    else:
        wrong = [name for name, values in columns.items() if values.shape != times.shape]
        mistakes += [Mistake(where, f"{name}: not one value for each time") for name in wrong]
    refuse(mistakes)
    return columns


def _read(path: Path, mistakes: list[Mistake]) -> dict[str, list[float]]:
    """Columns of a CSV file of numbers."""
    rows = csv.reader(path.read_text(encoding="utf-8-sig").splitlines(), skipinitialspace=True)
    head = [cell.strip() for cell in next(rows, [])]
    columns: dict[str, list[float]] = {name: [] for name in head}
    for row in rows:
        if not row:
            continue
        if len(row) != len(head):
            message = f"has {len(row)} cells, and the header has {len(head)}"
            mistakes.append(Mistake(f"{path}:{rows.line_num}", message))
            continue
        for name, cell in zip(head, row, strict=True):
            try:
                columns[name].append(float(cell))
            except ValueError:
                message = f"{name}: must be a number, got {cell!r}"
                mistakes.append(Mistake(f"{path}:{rows.line_num}", message))
    return columns


def _columns(
    expected: Mapping[str, Any], columns: Sequence[str] | None, known: Sequence[str], where: str
) -> list[str]:
    """Names to compare, each one of the reference and of the FMU."""
    if columns is None:
        names = [name for name in expected if name in known and name != "time"]
        if not names:
            refuse([Mistake(where, "no column is a variable of the FMU")])
        return names
    refuse(
        Mistake(where, f"{name}: not {words}", nearest(name, among))
        for name in columns
        for words, among in (("in the reference", expected), ("a variable of the FMU", known))
        if name not in among
    )
    return list(columns)
