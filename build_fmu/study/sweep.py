"""One FMU run with many values of its parameters and inputs."""

from __future__ import annotations

import contextlib
import hashlib
import tempfile
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from os import PathLike, fspath
from pathlib import Path
from typing import TYPE_CHECKING, Any

from build_fmu.errors import UsageError
from build_fmu.instance import (
    check_platform,
    description_of,
    interrupts_held,
    interrupts_taken,
)
from build_fmu.run import communication_times
from build_fmu.study.engines import engine_of
from build_fmu.study.forms import form_of
from build_fmu.study.grid import rows_of
from build_fmu.study.plan import Plan, Result
from build_fmu.study.processes import Task
from build_fmu.study.run_row import Shared, release, run_row
from build_fmu.study.settings import Source, entries_of, fmu_settings, outputs_of
from build_fmu.study.stores import holds_trajectories, require_kind, store_for
from build_fmu.study.values import Entry, Mistake, refuse
from build_fmu.target import runnable

if TYPE_CHECKING:
    from distributed import Client  # pyright: ignore[reportMissingImports]
    from numpy import ndarray

MOST_VALUES = 500_000_000
"""Most numbers of the trajectories of one sweep: 4 GB."""


@dataclass(frozen=True)
class Sweep:
    """What was to be done, and its results in the order of the runs."""

    plan: Plan
    results: ndarray
    """One row for each run, as of the form "numpy" without trajectories."""
    trajectories: ndarray | None
    """Shape (runs, points, outputs), if they were asked for; NaN after an early end."""
    resumed: int
    """How many of the results were there before."""
    warnings: Sequence[str]
    """What the FMU warned of in the other ones, each sentence once."""

    @property
    def failed(self) -> ndarray:
        """Runs that did not come to their end."""
        return self.results[~self.results["finished"]]


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
    engine: str | Client = "auto",
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
    in_form = form_of(form)
    mistakes: list[Mistake] = []
    rows = rows_of(grid, table, mistakes)
    run_jobs = engine_of(engine, workers)
    file = None if path is None else Path(path)
    require_kind(file)
    with runnable(fspath(fmu), entries_of(parameters)) as (unit, fixed):
        plan = _plan(unit, [fixed, *rows], outputs, stop_time, step_size, mistakes)
        plan.check_columns(trajectories)
        wanted = trajectories or holds_trajectories(file)
        if wanted and plan.count * len(plan.times) * len(plan.outputs) > MOST_VALUES:
            text = "the trajectories would fill more than 4 GB; name fewer outputs, longer steps"
            raise UsageError(text)
        on_dask = not isinstance(engine, str) or engine.startswith("dask")
        archive = Path(unit).read_bytes() if on_dask else None
        with (
            contextlib.closing(store_for(file, plan, fresh, trajectories)) as store,
            tempfile.TemporaryDirectory(prefix="fmu-", ignore_cleanup_errors=True) as folder,
        ):
            lacking = trajectories and not holds_trajectories(file)
            left = [n for n, known in enumerate(store.is_done) if lacking or not known]
            jobs = [(n + 1, plan.rows[n]) for n in left]
            shared = Shared(replace(plan, rows=()), unit, folder, archive, wanted)
            task = Task(run_row, shared, partial(_lost, shared.plan))
            said: set[str] = set()
            try:
                with interrupts_taken(), contextlib.closing(run_jobs(task, jobs)) as results:
                    for done, result in enumerate(results, start=plan.count - len(jobs) + 1):
                        with interrupts_held():  # a run is in the table and in the file, or in none
                            store.keep(result)
                        said.update(result.warnings)
                        if progress:
                            progress(done, plan.count)
            except KeyboardInterrupt:
                raise _interruption(int(store.is_done.sum()), plan.count, file, fresh) from None
            finally:
                release()
    resumed = plan.count - len(jobs)
    return in_form(Sweep(plan, store.table, store.trajectories, resumed, sorted(said)))


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


def _lost(plan: Plan, job: tuple[int, Mapping[str, Any]], reason: str) -> Result:
    """Result of a run whose process died: nobody knows what its outputs were."""
    return Result(job[0], plan.times[0], reason, plan.no_summary)
