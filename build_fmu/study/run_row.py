"""One run of a sweep, in whatever process: the FMU stays ready there for the next one."""

from __future__ import annotations

import threading
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from build_fmu.fmu_runner import FmuRunner
from build_fmu.study.plan import Plan, Result


@dataclass(frozen=True)
class Shared:
    """What every process of a sweep needs: a path, or the archive itself for other machines."""

    plan: Plan
    """Without its rows."""
    path: str
    folder: str
    """Where it is unpacked, removed at the end; workers elsewhere have their own."""
    data: bytes | None
    """The archive, for workers elsewhere."""
    trajectories: bool


_HERE = threading.local()
"""The FMU that this thread keeps ready: its digest and the `FmuRunner`."""


def run_row(shared: Shared, job: tuple[int, Mapping[str, Any]]) -> Result:
    """Run one row of a sweep, from its number and values."""
    run, row = job
    plan = shared.plan
    record = _kept(shared).run({**plan.fixed, **row}, plan.times, plan.outputs)
    # Before the first step outputs may be no more than 0.
    values = record.values if len(record.values) > 1 or not record.reason else record.values[:0]
    if len(values):
        found = np.array([values[-1], values.min(axis=0), values.max(axis=0)])
        summary = found.T.ravel().tolist()
    else:
        summary = plan.no_summary
    kept = values if shared.trajectories else None
    return Result(run, record.end_time, record.reason, summary, kept, record.warnings)


def _kept(shared: Shared) -> FmuRunner:
    digest = shared.plan.digest
    if getattr(_HERE, "digest", None) != digest:
        release()
        if shared.data is None:
            _HERE.fmu = FmuRunner(shared.path, shared.folder)
        else:
            from build_fmu.study.dask_workers import folder_of_worker

            folder = folder_of_worker()
            copy = Path(folder, f"{digest}-{threading.get_ident()}.fmu")
            copy.write_bytes(shared.data)
            _HERE.fmu = FmuRunner(copy, folder)
        _HERE.digest = digest
    return _HERE.fmu


def release() -> None:
    """Free what this thread keeps."""
    if getattr(_HERE, "digest", None) is not None:
        _HERE.fmu.close()
    _HERE.digest = None
