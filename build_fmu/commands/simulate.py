"""`holonom simulate SCENE|FMU`: run it in fmpy and show where it ended, or write a CSV file.

With `--formulation` the mechanism runs by `solver.paper` instead, in this process.
"""

from __future__ import annotations

import argparse
import csv
import sys
from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import IO, TYPE_CHECKING, Any

from build_fmu.errors import UNFINISHED, UsageError
from build_fmu.plotting import check_plot, plot_run
from build_fmu.printing import number, print_json, print_table, progress_bar
from build_fmu.run import Run, run_by_paper, run_fmu
from build_fmu.study.settings import given_on_the_command_line
from build_fmu.target import fmu_model, runnable
from solver.files import written_whole

if TYPE_CHECKING:
    from numpy import ndarray

    from build_fmu.study.values import Entry


def run(arguments: argparse.Namespace) -> int:
    """Simulate; exit code 3 if the run ends before its stop time, or the FMU logs an error."""
    if arguments.csv == "-" and arguments.json:
        text = "--csv - and --json both want stdout; name a file for one of them"
        raise UsageError(text)
    if arguments.formulation and arguments.inputs:
        text = "--formulation: the paper's method takes no --inputs that change; use --set"
        raise UsageError(text)
    check_plot(arguments)
    entries = given_on_the_command_line(arguments.parameters, arguments.settings)
    with runnable(arguments.target, entries) as (path, left):
        result = simulate(arguments, path, left, keep=partial(_write_table, arguments))
    if arguments.json:
        print_json(summary(result) | {"warnings": arguments.warnings})
    elif not arguments.csv and begun(result):
        _print_end(arguments.target, result)
    code = report_end(result)
    if arguments.plot and begun(result):
        plot_run(arguments, result)
    return code


def _write_table(arguments: argparse.Namespace, result: Run) -> None:
    """Write what `--csv` asks for."""
    if arguments.csv == "-":
        write_csv(result.values, sys.stdout)
    elif arguments.csv:
        with written_whole(arguments.csv, "w") as file:
            write_csv(result.values, file)
        rows, columns = len(result.values), len(result.values.dtype.names or ())
        # One document on stdout is what --json promises.
        stream = sys.stderr if arguments.json else sys.stdout
        stream.write(f"{arguments.csv}: {rows} row{'s' * (rows != 1)}, {columns} columns\n")


def begun(result: Run) -> bool:
    """Whether there is anything to show: before the first step outputs may be no more than 0."""
    return result.steps > 0 or not result.reason


def report_end(result: Run) -> int:
    """Log and what went wrong on stderr; the exit code."""
    for message in dict.fromkeys(result.messages):
        if message not in result.reason:
            sys.stderr.write(f"{message}\n")
    if result.failure:
        sys.stderr.write(f"holonom: {result.failure}\n")
    return UNFINISHED if result.reason else 0


def simulate(
    arguments: argparse.Namespace, path: str, left: Mapping[str, Entry], *,
    with_local: bool = False, keep: Callable[[Run], None] = lambda _: None,
) -> Run:  # fmt: skip
    """Run an FMU as the arguments say, with the values that are left for the run.

    `keep` gets the run before its page is written: a page that fails loses nothing.
    """
    known: dict[str, Any] = {
        "stop_time": arguments.stop, "step_size": arguments.step, "settings": left,
        "with_local": with_local or bool(arguments.report),
    }  # fmt: skip
    with progress_bar(f"simulating {Path(path).stem}") as progress:
        if formulation := getattr(arguments, "formulation", None):
            result = run_by_paper(path, fmu_model(path), formulation, **known)
        else:
            result = run_fmu(path, inputs=arguments.inputs, progress=progress, **known)
    if not arguments.report:
        keep(result)
        return result
    from build_fmu.run_page import Carried, plain_values

    carried = Carried(path, arguments.target)
    shown = result if with_local else replace(result, values=result.values[carried.ports])
    keep(shown)
    said = [*arguments.warnings, *result.messages]
    carried.write(arguments.report, [carried.of_run(result, plain_values(left))], said)
    sys.stderr.write(f"{arguments.report}: a page of this run, for any browser\n")
    return shown


def write_csv(values: ndarray, file: IO[str]) -> None:
    """Trajectory in fmpy's layout, with digits that read back as the same numbers."""
    writer = csv.writer(file, lineterminator="\n")
    writer.writerow(values.dtype.names or ())
    writer.writerows([repr(float(value)) for value in row] for row in values)


def summary(result: Run) -> dict[str, object]:
    """What `--json` prints."""
    names = result.values.dtype.names or ()
    errors = [name for name in ("energy.error", "constraint.position") if name in names]
    return {
        "finished": result.finished,
        "reason": result.reason,
        "end_time": result.end_time,
        "stop_time": result.stop_time,
        "steps": result.steps,
        "wall_time": result.wall_time,
        "moved": result.moved,
        "largest": {name: result.largest(name) for name in errors},
        "final": {name: float(result.values[name][-1]) for name in names},
    }


def _print_end(target: str, result: Run) -> None:
    rows = [
        (name, number(float(column[0])), number(float(column[-1])), number(result.largest(name)))
        for name in result.values.dtype.names or ()
        for column in (result.values[name],)
    ]
    rest = "" if result.moved else "; nothing moved"
    title = f"{target}: {result.steps} steps in {result.wall_time:.3f} s{rest}"
    print_table(title, ("output", "start", "end", "largest magnitude"), rows)
