"""A sweep as the arrays that its users know: NumPy, pandas, xarray."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from build_fmu.errors import EnvironmentLackError, UsageError
from solver.extras import missing

if TYPE_CHECKING:
    from numpy import ndarray

    from build_fmu.study.sweep import Sweep


def form_of(name: str) -> Callable[[Sweep], Any]:
    """Function that has the results of a sweep in a form, whose package is installed."""
    if name not in _FORMS:
        text = f"there is no form {name!r}; write one of {', '.join(_FORMS)}"
        raise UsageError(text)
    if name in ("pandas", "xarray") and (text := missing(name, name)):
        raise EnvironmentLackError(text)
    return _FORMS[name]


def _numpy(found: Sweep) -> ndarray:
    """Structured array; of trajectories each field holds all points, and so does "time"."""
    import numpy as np

    table = found.results
    if found.trajectories is None:
        return table
    points = (len(found.plan.times),)
    fields = [(name, "f8", points) for name in (*found.plan.outputs, "time")]
    whole = np.empty(len(table), np.dtype([*table.dtype.descr, *fields]))
    for name in table.dtype.names or ():
        whole[name] = table[name]
    whole["time"] = found.plan.times
    for i, name in enumerate(found.plan.outputs):
        whole[name] = found.trajectories[:, :, i]
    return whole


def _pandas(found: Sweep) -> Any:
    """Data frame of the summary by run; of trajectories, by run and time."""
    import pandas as pd  # pyright: ignore[reportMissingImports]

    if found.trajectories is None:
        return pd.DataFrame.from_records(found.results, index="run")
    axes = [found.results["run"], found.plan.times]
    index = pd.MultiIndex.from_product(axes, names=["run", "time"])
    values = found.trajectories.reshape(len(index), -1)
    return pd.DataFrame(values, index, list(found.plan.outputs))


def _xarray(found: Sweep) -> Any:
    """Data set along "run", of trajectories along "time" too; what was varied is a coordinate."""
    import xarray  # pyright: ignore[reportMissingImports]

    plan = found.plan
    columns = {name: ("run", found.results[name]) for name in plan.columns}
    coordinates: dict[str, Any] = {name: columns.pop(name) for name in plan.columns[: plan.leading]}
    values: dict[str, Any] = dict(columns)
    if found.trajectories is not None:
        coordinates["time"] = ("time", list(plan.times), {"units": "s"})
        for i, name in enumerate(plan.outputs):
            units = {"units": plan.units.get(name, "")}
            values[name] = (("run", "time"), found.trajectories[:, :, i], units)
    return xarray.Dataset(values, coordinates)


_FORMS = {"numpy": _numpy, "pandas": _pandas, "xarray": _xarray, "sweep": lambda found: found}
