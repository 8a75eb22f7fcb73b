"""A sweep as the arrays that its users know: NumPy, pandas, xarray."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from build_fmu.errors import EnvironmentLackError, UsageError

if TYPE_CHECKING:
    from numpy import ndarray

    from build_fmu.study.sweep import Sweep

PACKAGES = ("numpy", "pandas", "xarray")
FORMS = (*PACKAGES, "sweep")


def in_form(found: Sweep, form: str, trajectories: bool) -> Any:
    """Results of a sweep in one of `FORMS`."""
    if form == "sweep":
        return found
    return {"numpy": _numpy, "pandas": _pandas, "xarray": _xarray}[form](found, trajectories)


def require_form(form: str) -> None:
    """Refuse a form that is not known, or whose package is not installed."""
    import importlib.util

    if form not in FORMS:
        text = f"there is no form {form!r}; write one of {', '.join(FORMS)}"
        raise UsageError(text)
    if form in PACKAGES and importlib.util.find_spec(form) is None:
        text = f"the package {form} is missing; install it: pip install 'holonom[{form}]'"
        raise EnvironmentLackError(text)


def _numpy(found: Sweep, trajectories: bool) -> ndarray:
    """Structured array; of trajectories each field holds all points, and so does "time"."""
    import numpy as np

    table = found.plan.table(found.results)
    if not trajectories:
        return table
    arrays = found.plan.arrays(found.results)
    arrays["time"] = np.broadcast_to(found.plan.times, (len(table), len(found.plan.times)))
    fields = [(name, values.dtype, values.shape[1:]) for name, values in arrays.items()]
    whole = np.empty(len(table), np.dtype([*table.dtype.descr, *fields]))
    for name in table.dtype.names or ():
        whole[name] = table[name]
    for name, values in arrays.items():
        whole[name] = values
    return whole


def _pandas(found: Sweep, trajectories: bool) -> Any:
    """Data frame of the summary by run; of trajectories, by run and time."""
    import pandas as pd  # pyright: ignore[reportMissingImports]

    if not trajectories:
        return pd.DataFrame.from_records(found.plan.table(found.results), index="run")
    runs = [result.run for result in found.results]
    index = pd.MultiIndex.from_product([runs, found.plan.times], names=["run", "time"])
    arrays = found.plan.arrays(found.results)
    return pd.DataFrame({name: values.ravel() for name, values in arrays.items()}, index)


def _xarray(found: Sweep, trajectories: bool) -> Any:
    """Data set along "run", of trajectories along "time" too; what was varied is a coordinate."""
    import xarray  # pyright: ignore[reportMissingImports]

    table, plan = found.plan.table(found.results), found.plan
    varied = plan.columns[1 : 1 + len(plan.names)]
    coordinates: dict[str, Any] = {"run": table["run"]}
    coordinates |= {name: ("run", table[name]) for name in varied}
    values: dict[str, Any] = {
        name: ("run", table[name]) for name in plan.columns if name not in ("run", *varied)
    }
    if trajectories:
        coordinates["time"] = ("time", list(plan.times), {"units": "s"})
        for name, array in plan.arrays(found.results).items():
            values[name] = (("run", "time"), array, {"units": plan.units.get(name, "")})
    return xarray.Dataset(values, coordinates)
