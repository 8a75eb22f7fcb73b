"""Tests of FMUs, for pytest or alone: what it conserves, and whether it follows a reference.

    from build_fmu.testing import assert_conserves, assert_follows

    def test_the_linkage():
        assert_conserves("linkage.fmu", stop_time=10.0)
        assert_follows("linkage.fmu", "measured.csv", absolute=1e-3)

Both run the FMU in fmpy, from its archive; a scene may stand for it. What fails is an
AssertionError that says where, when and by how much.
"""

from __future__ import annotations

import contextlib
from collections.abc import Mapping, Sequence
from dataclasses import replace
from os import PathLike, fspath
from typing import TYPE_CHECKING

from build_fmu.instance import start_time_of
from build_fmu.reference import Reference, columns_of, limits, name_of, names_to_compare
from build_fmu.study.settings import Source, entries_of
from build_fmu.study.values import Mistake, refuse

if TYPE_CHECKING:
    from numpy import ndarray

    from build_fmu.fmu_runner import Record
    from build_fmu.run import Run

__all__ = ["assert_conserves", "assert_follows"]

MOST_TOLD = 10
"""Columns of which it is said how far they are off."""


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
        An FMU of holonom, or a scene.
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
        run = run_fmu(
            path, stop_time=stop_time, step_size=step_size, settings=left, with_local=True
        )
    problems = [run.failure] if run.failure else []
    for name, limit in (("energy.error", energy), ("constraint.position", constraint)):
        problems += _excess(run, name, limit)
    _require(f"{target} does not conserve", problems)
    return run


def _excess(run: Run, name: str, limit: float) -> list[str]:
    """A sentence about an output that is larger than it may be."""
    if name not in (run.values.dtype.names or ()):
        return [f"there is no output {name!r}; is it an FMU of holonom?"]
    sizes = abs(run.values[name])
    worst = int(sizes.argmax())
    if sizes[worst] <= limit:
        return []
    at = float(run.values["time"][worst])
    return [f"{name} is {sizes[worst]:.3g} at t = {at:g} s, more than {limit:g}"]


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

    The run begins at the start time of the FMU, also where the reference begins later.

    Parameters
    ----------
    target
        An FMU, or a scene.
    reference
        A CSV file whose first line has the names, among them "time", as `holonom simulate --csv`
        and fmpy write it; or arrays by name.
    relative
        Error that passes, relative to the largest value of the reference in that column. Round-off
        passes as well, 1e-10 of the largest value of that unit in all columns (or `relative`, where
        that is less): where the reference is noise about zero, its own largest value says nothing.
    absolute
        Error that passes besides, in the unit of the column; one for all, or by name.
    columns
        What to compare; None: all columns that are outputs of the FMU, but not `energy.error`,
        `energy.balance`, `constraint.*` and `solver.*`. These say how exact a run is, and are noise
        in a good one; `assert_conserves` sets limits to them. Columns of inputs drive nothing.
    parameters
        Values of parameters and inputs by name, or a file of them.

    Returns
    -------
    dict of str to ndarray
        What the FMU gave, by column, and "time".
    """
    __tracebackhide__ = True
    from build_fmu.run import failure

    expected, where = columns_of(reference), name_of(reference)
    names, units, record = _run_along(target, parameters, expected, columns, where)
    passes = limits(expected, names, units, relative, absolute)
    times = expected["time"].tolist()
    finished = len(record.values) == len(times)
    told = failure(record.end_time, times[-1], finished, record.reason)
    problems = [told] if told else []
    found = dict(zip(names, record.values.T, strict=True))
    problems += _differences(times, found, expected, passes)
    _require(f"{target} does not follow {where}", problems)
    return {"time": expected["time"][: len(record.values)], **found}


def _run_along(
    target: str | PathLike[str],
    parameters: Source | None,
    expected: Mapping[str, ndarray],
    columns: Sequence[str] | None,
    where: str,
) -> tuple[list[str], dict[str, str], Record]:
    """Names to compare, the units of variables, and the run through the times of a reference."""
    from build_fmu.fmu_runner import FmuRunner
    from build_fmu.study.settings import fmu_settings
    from build_fmu.target import runnable

    with (
        runnable(fspath(target), entries_of(parameters)) as (path, left),
        contextlib.closing(FmuRunner(path)) as fmu,
    ):
        settings = fmu_settings(fmu.description, [left])[0]
        numbers = [v for v in fmu.description.modelVariables if v.type != "String"]
        causality = {v.name: v.causality for v in numbers}
        names = names_to_compare(expected, columns, causality, where)
        start, times = start_time_of(fmu.description), expected["time"].tolist()
        if times[0] < start:
            message = f"begins at t = {times[0]:g} s, before the FMU, which starts at {start:g} s"
            refuse([Mistake(where, message, "shift its times, or leave out what comes before")])
        before = [start] if times[0] > start else []
        record = fmu.run(settings, [*before, *times], names)
        units = {v.name: v.unit or "" for v in numbers}
        return names, units, replace(record, values=record.values[len(before) :])


def _differences(
    times: Sequence[float],
    found: Mapping[str, ndarray],
    expected: Mapping[str, ndarray],
    passes: Mapping[str, float],
) -> list[str]:
    """Sentences about the columns that are off, first the one that is earliest, then most."""
    off: list[tuple[float, float, str]] = []
    for name, column in found.items():
        error = abs(column - expected[name][: len(column)])  # of points that were reached
        beyond = (~(error <= passes[name])).nonzero()[0]
        if len(beyond):
            worst = int(error.argmax())
            sentence = (
                f"{name} is off by {error[worst]:.3g} at t = {times[worst]:g} s "
                f"({column[worst]:.9g}, expected {expected[name][worst]:.9g}), more than "
                f"{passes[name]:.3g}; {len(beyond)} of {len(column)} points are, from "
                f"t = {times[int(beyond[0])]:g} s on"
            )
            off.append((int(beyond[0]), -error[worst] / max(passes[name], 1e-300), sentence))
    sentences = [sentence for *_, sentence in sorted(off)]
    more = len(sentences) - MOST_TOLD
    return sentences[:MOST_TOLD] + ([f"and {more} more columns are off"] if more > 0 else [])


def _require(what: str, problems: Sequence[str]) -> None:
    __tracebackhide__ = True
    if problems:
        raise AssertionError("\n  ".join([f"{what}:", *problems]))
