"""`--plot FILE` of commands: what is checked before a run, and the figure after it."""

from __future__ import annotations

import argparse
import contextlib
import sys
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from build_fmu.errors import EnvironmentLackError, UsageError
from build_fmu.study.grid import rows_of
from solver.extras import missing
from solver.files import wrong_ending
from solver.runtime import OptionError

if TYPE_CHECKING:
    from matplotlib.figure import Figure  # pyright: ignore[reportMissingImports]

    from build_fmu.run import Run
    from build_fmu.study.sweep import Sweep


def check_plot(arguments: argparse.Namespace) -> None:
    """Refuse a plot that could not be written, before anything is computed for it.

    Raises
    ------
    UsageError
        If the file's suffix names no format, or a sweep varies too much.
    EnvironmentLackError
        If matplotlib is missing.
    """
    if not arguments.plot:
        if arguments.plot_of is not None:
            text = "--plot-of chooses what --plot FILE shows; give that too"
            raise UsageError(text)
        return
    from viewer.plots import FORMATS, require_few_parameters

    if wrong := wrong_ending(arguments.plot, FORMATS):
        text = f"--plot {wrong}"
        raise UsageError(text)
    if text := missing("matplotlib", "plot"):
        raise EnvironmentLackError(text)
    if arguments.command == "sweep":
        mistakes = []
        rows = rows_of(arguments.grid, arguments.table, mistakes)
        if not mistakes:  # which the sweep reports with those of the FMU
            with _as_usage():
                require_few_parameters(list(rows[0]))


def plot_run(arguments: argparse.Namespace, run: Run) -> None:
    """Write the figure of a run."""
    from viewer.plots import over_time

    times, title = run.values["time"], Path(arguments.target).stem
    columns = {name: run.values[name] for name in run.values.dtype.names or () if name != "time"}
    _write(arguments, lambda names: over_time(times, columns, run.variables, names, title))


def plot_sweep(arguments: argparse.Namespace, found: Sweep) -> None:
    """Write the figure of a sweep; of runs that failed there is no point."""
    import numpy as np

    from build_fmu.study.plan import OF_OUTPUTS
    from viewer.plots import MOST, over_values

    plan, table = found.plan, found.results
    clean = np.where(table["finished"], 1.0, np.nan)
    values = {
        name: np.array([table[f"{name}.{what}"] for what in OF_OUTPUTS], float) * clean
        for name in plan.outputs
    }
    varied = {name: [row[name] for row in plan.rows] for name in plan.rows[0]}
    title = Path(arguments.target).stem
    asked = list(plan.outputs) if arguments.output and len(plan.outputs) <= MOST else None
    _write(arguments, lambda names: over_values(varied, values, plan.units, names or asked, title))


def _write(arguments: argparse.Namespace, figure: Callable[[Sequence[str] | None], Figure]) -> None:
    from viewer.plots import save

    text = arguments.plot_of
    names = None if text is None else [name.strip() for name in text.split(",")]
    path = Path(arguments.plot)
    with _as_usage():
        drawn = figure(names)
    save(drawn, path)
    sys.stderr.write(f"{arguments.plot}: plot\n")


@contextlib.contextmanager
def _as_usage() -> Iterator[None]:
    """What is wrong with the options is the user's mistake."""
    try:
        yield
    except OptionError as error:
        raise UsageError(str(error)) from None
