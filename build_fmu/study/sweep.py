"""One FMU run with many values of its parameters and inputs."""

from __future__ import annotations

import hashlib
import math
import tempfile
import threading
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from os import PathLike, fspath
from pathlib import Path
from typing import TYPE_CHECKING, Any

from build_fmu.errors import UsageError
from build_fmu.instance import check_platform
from build_fmu.run import experiment_times
from build_fmu.study.engines import Task, run_jobs
from build_fmu.study.grid import rows_of
from build_fmu.study.kept import KeptFmu, description_of
from build_fmu.study.plan import Plan, Result
from build_fmu.study.settings import Source, entries_of, fmu_settings
from build_fmu.study.stores import Store, by_run, check_name, remove, store_for
from build_fmu.study.values import Mistake, nearest, refuse
from build_fmu.target import runnable

if TYPE_CHECKING:
    from fmpy.model_description import ModelDescription

MOST_VALUES = 500_000_000
"""Most numbers of the trajectories of one sweep: 4 GB."""


@dataclass(frozen=True)
class Sweep:
    """What was to be done, and its results in the order of the runs."""

    plan: Plan
    results: Sequence[Result]
    resumed: int
    """How many of the results were there before."""

    @property
    def failed(self) -> list[Result]:
        """Runs that did not come to their end."""
        return [result for result in self.results if result.reason]


@dataclass(frozen=True)
class _Shared:
    """What every process needs: a path, or the archive itself for other machines."""

    path: str
    data: bytes | None
    digest: str
    fixed: Mapping[str, Any]
    outputs: Sequence[str]
    times: Sequence[float]
    trajectories: bool


def sweep_fmu(
    target: str | PathLike[str],
    *,
    grid: Sequence[str] | Mapping[str, object] = (),
    table: str | PathLike[str] | Sequence[Mapping[str, object]] | None = None,
    parameters: Source | None = None,
    outputs: Sequence[str] | None = None,
    stop_time: float | None = None,
    step_size: float | None = None,
    path: str | PathLike[str] | None = None,
    fresh: bool = False,
    trajectories: bool = False,
    engine: str = "auto",
    workers: int | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> Sweep:
    """Run an FMU, or that of a scene, for each row of a grid or table; see `build_fmu.sweep`."""
    rows = rows_of(grid, table)
    with runnable(fspath(target), entries_of(parameters)) as (fmu, fixed):
        description = description_of(fmu)
        check_platform(fmu)
        settings = fmu_settings(fmu, description, [fixed, *rows])
        plan = Plan(
            fmu=Path(fmu).name,
            digest=hashlib.sha256(Path(fmu).read_bytes()).hexdigest(),
            rows=settings[1:],
            fixed=settings[0],
            outputs=_outputs(fmu, description, outputs),
            times=_times(*experiment_times(description, stop_time, step_size), description),
            units={v.name: v.unit or "" for v in description.modelVariables},
        )
        results = None if path is None else Path(path)
        check_name(results)
        wanted = trajectories or Path(path or "").suffix in (".h5", ".hdf5")
        if wanted and plan.count * len(plan.times) * len(plan.outputs) > MOST_VALUES:
            text = "the trajectories would fill more than 4 GB; name fewer outputs, longer steps"
            raise UsageError(text)
        if fresh:
            remove(results)
        store = store_for(results, plan)
        resumed = len(store.results)
        try:
            _run(plan, store, fmu, wanted, engine, workers, progress)
        finally:
            store.close()
            _release()
    return Sweep(plan, by_run(store.results), resumed)


def _run(
    plan: Plan,
    store: Store,
    fmu: str,
    trajectories: bool,
    engine: str,
    workers: int | None,
    progress: Callable[[int, int], object] | None,
) -> None:
    """Do what is not done yet."""
    shared = _Shared(
        path=fmu,
        data=Path(fmu).read_bytes() if engine.startswith("dask") else None,
        digest=plan.digest,
        fixed=plan.fixed,
        outputs=plan.outputs,
        times=plan.times,
        trajectories=trajectories,
    )
    jobs = [(i, row) for i, row in enumerate(plan.rows, start=1) if i not in store.results]
    for result in run_jobs(Task(_run_some, shared, _lost), jobs, engine, workers):
        if math.isnan(result.end_time):  # its process died: nobody knows how many outputs it had
            nothing = [(math.nan,) * 3] * len(plan.outputs)
            result = Result(result.run, plan.times[0], result.reason, nothing)
        store.keep(result)
        if progress:
            progress(len(store.results), plan.count)


def _times(stop: float, step: float, description: ModelDescription) -> list[float]:
    """Communication points from the start to the stop time; the last step may be shorter."""
    start = float(getattr(description.defaultExperiment, "startTime", None) or 0.0)
    count = (stop - start) / step
    whole = round(count) if abs(count - round(count)) < 1e-6 else math.ceil(count)
    return [*(start + i * step for i in range(max(whole, 1))), stop]


def _outputs(path: str, description: ModelDescription, names: Sequence[str] | None) -> list[str]:
    """Outputs that are asked for, or all."""
    known = [v.name for v in description.modelVariables if v.type != "String"]
    if names is None:
        return [v.name for v in description.modelVariables if v.causality == "output"]
    refuse(
        Mistake(f"--output {name}", f"{path} has no variable {name!r}", nearest(name, known))
        for name in names
        if name not in known
    )
    return list(dict.fromkeys(names))


# ----------------------------------------------------------------------------- in each process

_HERE = threading.local()
"""The FMU that this thread keeps ready: its digest and the `KeptFmu`."""


def _run_some(shared: _Shared, jobs: Sequence[tuple[int, Mapping[str, Any]]]) -> list[Result]:
    """Run some rows; a job is a number and values."""
    fmu = _kept(shared)
    return [_one(fmu, shared, run, values) for run, values in jobs]


def _one(fmu: KeptFmu, shared: _Shared, run: int, values: Mapping[str, Any]) -> Result:
    record = fmu.run({**shared.fixed, **values}, shared.times, shared.outputs)
    if len(record.values):
        columns = (record.values[-1], record.values.min(axis=0), record.values.max(axis=0))
        summary = list(zip(*(column.tolist() for column in columns), strict=True))
    else:
        summary = [(math.nan,) * 3] * len(shared.outputs)
    kept = record.values if shared.trajectories else None
    return Result(run, record.end_time, record.reason, summary, kept)


def _lost(job: tuple[int, Mapping[str, Any]], reason: str) -> Result:
    return Result(job[0], math.nan, reason, [])


def _kept(shared: _Shared) -> KeptFmu:
    if getattr(_HERE, "digest", None) != shared.digest:
        _release()
        if shared.data is None:
            _HERE.fmu = KeptFmu(shared.path)
        else:
            with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
                copy = Path(folder, "unit.fmu")
                copy.write_bytes(shared.data)
                _HERE.fmu = KeptFmu(copy)
        _HERE.digest = shared.digest
    return _HERE.fmu


def _release() -> None:
    """Free what this thread keeps."""
    if getattr(_HERE, "digest", None) is not None:
        _HERE.fmu.close()
    _HERE.digest = None
