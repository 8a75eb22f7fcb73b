"""One FMU run with many values of its parameters and inputs."""

from __future__ import annotations

import contextlib
import hashlib
import math
import tempfile
import threading
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from os import PathLike, fspath
from pathlib import Path
from typing import TYPE_CHECKING, Any

from build_fmu.errors import UsageError
from build_fmu.fmu_runner import KeptFmu
from build_fmu.instance import check_platform, description_of
from build_fmu.run import communication_times
from build_fmu.study.dask_workers import folder_of_worker
from build_fmu.study.engines import engine_of
from build_fmu.study.forms import in_form, require_form
from build_fmu.study.grid import rows_of
from build_fmu.study.jobs import Task
from build_fmu.study.names import outputs_of
from build_fmu.study.plan import Plan, Result
from build_fmu.study.settings import Source, entries_of, fmu_settings
from build_fmu.study.stores import by_run, check_name, holds_trajectories, store_for
from build_fmu.study.values import Entry, Mistake, refuse
from build_fmu.target import runnable

if TYPE_CHECKING:
    pass

MOST_VALUES = 500_000_000
"""Most numbers of the trajectories of one sweep: 4 GB."""


@dataclass(frozen=True)
class Sweep:
    """What was to be done, and its results in the order of the runs."""

    plan: Plan
    results: Sequence[Result]
    resumed: int
    """How many of the results were there before."""
    warnings: Sequence[str] = ()
    """What the FMU warned of in the other ones, each sentence once."""

    @property
    def failed(self) -> list[Result]:
        """Runs that did not come to their end."""
        return [result for result in self.results if result.reason]


@dataclass(frozen=True)
class _Shared:
    """What every process needs: a path, or the archive itself for other machines."""

    path: str
    folder: str | None
    """Where it is unpacked, removed at the end; None: in the one of a worker elsewhere."""
    data: bytes | None
    digest: str
    fixed: Mapping[str, Any]
    outputs: Sequence[str]
    times: Sequence[float]
    trajectories: bool


def sweep(
    fmu: str | PathLike[str],
    *,
    grid: Mapping[str, object] | Sequence[str] = (),
    table: str | PathLike[str] | Sequence[Mapping[str, object]] | None = None,
    parameters: Source | None = None,
    outputs: Sequence[str] | None = None,
    stop_time: float | None = None,
    step_size: float | None = None,
    path: str | PathLike[str] | None = None,
    fresh: bool = False,
    trajectories: bool = False,
    form: str = "numpy",
    engine: str = "auto",
    workers: int | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> Any:
    """Run one FMU for each row of a grid or table of its parameters and inputs.

    Parameters
    ----------
    fmu
        An FMU, or a scene, whose FMU is then built for it.
    grid, table, parameters, engine, workers, progress
        As for `build_fmu.variants`; names are those of parameters and inputs of the FMU.
    outputs
        Names of what is kept; None: all outputs.
    stop_time, step_size
        Stop time and communication step in s; None: of the FMU's default experiment.
    path
        A .csv file for the summary, or .h5 for trajectories as well. One that is there, of the same
        sweep, is continued.
    fresh
        Replace what is in that file.
    trajectories
        Whether to return the outputs at all communication points too.
    form
        "numpy", "pandas", "xarray", or "sweep" for a `Sweep`: plan and results as they are.

    Returns
    -------
    numpy.ndarray, pandas.DataFrame, xarray.Dataset or Sweep
        One row for each run, in the order of the grid: its values, whether it `finished`, its
        `end_time` and the `reason` of an early end, and of each output `NAME.final`, `NAME.min` and
        `NAME.max`. With trajectories, NumPy and xarray have `time` and each `NAME` besides, shape
        (runs, points), NaN after an early end; pandas has these alone, by run and time.

    Raises
    ------
    build_fmu.errors.UsageError
        With every mistake of grid, table and parameters.
    KeyboardInterrupt
        With the number of runs that the file has, and how to go on.
    """
    require_form(form)
    mistakes: list[Mistake] = []
    rows = rows_of(grid, table, mistakes)
    run_jobs = engine_of(engine, workers)
    file = None if path is None else Path(path)
    check_name(file)
    with runnable(fspath(fmu), entries_of(parameters)) as (unit, fixed):
        plan = _plan(unit, [fixed, *rows], outputs, stop_time, step_size, mistakes)
        plan.check_columns(trajectories)
        wanted = trajectories or holds_trajectories(file)
        _check_size(plan, wanted)
        with (
            contextlib.closing(store_for(file, plan, fresh, trajectories)) as store,
            tempfile.TemporaryDirectory(prefix="fmu-", ignore_cleanup_errors=True) as folder,
        ):
            known = {
                n for n, x in store.results.items() if x.values is not None or not trajectories
            }
            jobs = [(n, row) for n, row in enumerate(plan.rows, start=1) if n not in known]
            task = Task(
                _run_some, _shared(plan, unit, folder, wanted, engine), partial(_lost, plan)
            )
            said: set[str] = set()
            try:
                with contextlib.closing(run_jobs(task, jobs)) as results:
                    for done, result in enumerate(results, start=len(known) + 1):
                        store.keep(result)
                        said.update(result.warnings)
                        if progress:
                            progress(done, plan.count)
            except KeyboardInterrupt:
                raise _interruption(len(store.results), plan.count, file, fresh) from None
            finally:
                _release()
    found = Sweep(plan, by_run(store.results), len(known), sorted(said))
    return in_form(found, form, trajectories)


def _interruption(done: int, count: int, file: Path | None, fresh: bool) -> KeyboardInterrupt:
    """Say what there is and how to go on, if there is a file."""
    if file is None:
        return KeyboardInterrupt()
    again = "the same command without --fresh" if fresh else "the same command"
    return KeyboardInterrupt(f"{done} of {count} runs are in {file}, {again} goes on")


def _plan(
    unit: str,
    rows: Sequence[Mapping[str, Entry]],
    outputs: Sequence[str] | None,
    stop_time: float | None,
    step_size: float | None,
    mistakes: list[Mistake],
) -> Plan:
    """What is done with an FMU, checked; the first row is that of all runs."""
    description = description_of(unit)
    check_platform(unit)
    fixed, *settings = fmu_settings(description, rows, mistakes)
    names = outputs_of(description, outputs, mistakes)
    refuse(mistakes)
    return Plan(
        fmu=Path(unit).name,
        digest=hashlib.sha256(Path(unit).read_bytes()).hexdigest(),
        rows=settings,
        fixed=fixed,
        outputs=names,
        times=communication_times(description, stop_time, step_size),
        units={v.name: v.unit or "" for v in description.modelVariables},
    )


def _check_size(plan: Plan, trajectories: bool) -> None:
    if trajectories and plan.count * len(plan.times) * len(plan.outputs) > MOST_VALUES:
        text = "the trajectories would fill more than 4 GB; name fewer outputs, longer steps"
        raise UsageError(text)


def _shared(plan: Plan, unit: str, folder: str, trajectories: bool, engine: str) -> _Shared:
    elsewhere = engine.startswith("dask")
    return _Shared(
        path=unit,
        folder=None if elsewhere else folder,
        data=Path(unit).read_bytes() if elsewhere else None,
        digest=plan.digest,
        fixed=plan.fixed,
        outputs=plan.outputs,
        times=plan.times,
        trajectories=trajectories,
    )


def _lost(plan: Plan, job: tuple[int, Mapping[str, Any]], reason: str) -> Result:
    """Result of a run whose process died: nobody knows what its outputs were."""
    return Result(job[0], plan.times[0], reason, [(math.nan,) * 3] * len(plan.outputs))


# ----------------------------------------------------------------------------- in each process

_HERE = threading.local()
"""The FMU that this thread keeps ready: its digest and the `KeptFmu`."""


def _run_some(shared: _Shared, jobs: Sequence[tuple[int, Mapping[str, Any]]]) -> list[Result]:
    """Run some rows; a job is a number and values."""
    fmu = _kept(shared)
    return [_one(fmu, shared, run, values) for run, values in jobs]


def _one(fmu: KeptFmu, shared: _Shared, run: int, row: Mapping[str, Any]) -> Result:
    record = fmu.run({**shared.fixed, **row}, shared.times, shared.outputs)
    # Before the first step outputs may be no more than 0.
    values = record.values if len(record.values) > 1 or not record.reason else record.values[:0]
    if len(values):
        columns = (values[-1], values.min(axis=0), values.max(axis=0))
        summary = list(zip(*(column.tolist() for column in columns), strict=True))
    else:
        summary = [(math.nan,) * 3] * len(shared.outputs)
    kept = values if shared.trajectories else None
    return Result(run, record.end_time, record.reason, summary, kept, record.warnings)


def _kept(shared: _Shared) -> KeptFmu:
    if getattr(_HERE, "digest", None) != shared.digest:
        _release()
        if shared.data is None:
            _HERE.fmu = KeptFmu(shared.path, shared.folder)
        else:
            with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
                copy = Path(folder, "unit.fmu")
                copy.write_bytes(shared.data)
                _HERE.fmu = KeptFmu(copy, folder_of_worker())
        _HERE.digest = shared.digest
    return _HERE.fmu


def _release() -> None:
    """Free what this thread keeps."""
    if getattr(_HERE, "digest", None) is not None:
        _HERE.fmu.close()
    _HERE.digest = None
