"""A sweep as the arrays that its users know: NumPy, pandas, xarray."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from build_fmu.errors import EnvironmentLackError, UsageError

if TYPE_CHECKING:
    from numpy import ndarray

    from build_fmu.study.sweep import Sweep

PACKAGES = ("numpy", "pandas", "xarray")
FORMS = (*PACKAGES, "sweep")


def in_form(found: Sweep, form: str) -> Any:
    """Results of a sweep in one of `FORMS`."""
    if form == "sweep":
        return found
    return {"numpy": _numpy, "pandas": _pandas, "xarray": _xarray}[form](found)


def require_form(form: str) -> None:
    """Refuse a form that is not known, or whose package is not installed."""
    import importlib.util

    if form not in FORMS:
        text = f"there is no form {form!r}; write one of {', '.join(FORMS)}"
        raise UsageError(text)
    if form in PACKAGES and importlib.util.find_spec(form) is None:
        text = f"the package {form} is missing; install it: pip install 'holonom[{form}]'"
        raise EnvironmentLackError(text)


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
