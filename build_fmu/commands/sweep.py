"""`holonom sweep FMU|SCENE`: run it with many values; a table of what came out goes to stdout."""

from __future__ import annotations

import argparse
import math
import sys
import time
from collections.abc import Sequence
from pathlib import Path

from build_fmu.errors import UNFINISHED, UsageError
from build_fmu.plotting import check_plot, plot_sweep
from build_fmu.printing import count_bar, number, print_json, print_table
from build_fmu.study.settings import study_arguments
from build_fmu.study.sweep import Sweep, sweep
from build_fmu.study.values import counted

MOST_TOLD = 10


def run(arguments: argparse.Namespace) -> int:
    """Sweep; exit code 3 if a run did not come to its end."""
    given = study_arguments(arguments)
    check_plot(arguments)
    names = [name.strip() for text in arguments.output for name in text.split(",")]
    if "" in names:
        listed = ",".join(arguments.output)
        text = f"--output {listed!r}: a name is empty; for all outputs leave the option out"
        raise UsageError(text)
    path = Path(arguments.results or f"{Path(arguments.target).stem}_sweep.csv")
    begin = time.perf_counter()
    with count_bar(f"sweep of {Path(arguments.target).stem}", "runs") as progress:
        found: Sweep = sweep(
            arguments.target,
            outputs=names or None,
            stop_time=arguments.stop,
            step_size=arguments.step,
            path=path,
            form="sweep",
            progress=progress,
            **given,
        )
    spent = time.perf_counter() - begin
    if arguments.json:
        document = _document(found, path, spent)
        print_json(document | {"warnings": [*arguments.warnings, *found.warnings]})
    else:
        _print(found, path, spent)
    _tell(found.warnings, "warnings")
    if arguments.report:
        _report(arguments, found)
    failed = [f"run {run} ended at t = {time:g} s: {why}" for run, time, why in _failures(found)]
    _tell(failed, "runs")
    if arguments.plot:
        plot_sweep(arguments, found)
    return UNFINISHED if failed else 0


def _report(arguments: argparse.Namespace, found: Sweep) -> None:
    from build_fmu.run_page import report_rows
    from build_fmu.study.settings import given_on_the_command_line
    from build_fmu.target import runnable

    entries = given_on_the_command_line(arguments.parameters, arguments.settings)
    with runnable(arguments.target, entries) as (path, _):
        rows = [(path, {**found.plan.fixed, **row}, row) for row in found.plan.rows]
        said = report_rows(
            arguments.report, rows, arguments.target,
            stop_time=arguments.stop, step_size=arguments.step,
        )  # fmt: skip
    sys.stderr.write(f"{said}\n")


def _failures(found: Sweep) -> list[tuple[int, float, str]]:
    """Number, end time and reason of each run that failed."""
    return found.failed[["run", "end_time", "reason"]].tolist()


def _extremes(found: Sweep) -> list[tuple[str, float, int, float, int]]:
    """Smallest and largest value of each output, each with its run; of clean runs alone."""
    clean = found.results[found.results["finished"]]

    def values(name: str) -> list[tuple[float, int]]:
        pairs = zip(clean[name].tolist(), clean["run"].tolist(), strict=True)
        return [pair for pair in pairs if not math.isnan(pair[0])] or [(math.nan, 0)]

    names = found.plan.outputs
    return [(name, *min(values(f"{name}.min")), *max(values(f"{name}.max"))) for name in names]


def _document(found: Sweep, path: Path, spent: float) -> dict[str, object]:
    return {
        "results": str(path),
        "runs": found.plan.count,
        "resumed": found.resumed,
        "failed": [
            {"run": run, "time": time, "reason": reason} for run, time, reason in _failures(found)
        ],
        "wall_time": spent,
        "outputs": {
            name: {"min": low, "run_of_min": low_run, "max": high, "run_of_max": high_run}
            for name, low, low_run, high, high_run in _extremes(found)
            if low_run
        },
    }


def _print(found: Sweep, path: Path, spent: float) -> None:
    failed = f"{len(found.failed) or 'none'} failed"
    title = f"{path}: {counted(found.plan.count, 'run')}, {failed}; {_duration(found, spent)}"
    rows = [
        (name, number(low), _values(found, low_run), number(high), _values(found, high_run))
        for name, low, low_run, high, high_run in _extremes(found)
    ]
    print_table(title, ("output", "smallest", "with", "largest", "with"), rows)


def _duration(found: Sweep, spent: float) -> str:
    """What was computed now, and in how many seconds."""
    new = found.plan.count - found.resumed
    if not new:
        return "all of them were there from before"
    there = f"{counted(found.resumed, 'run')} from before, {counted(new, 'run')} "
    return f"{there if found.resumed else ''}computed in {spent:.1f} s"


def _values(found: Sweep, run: int) -> str:
    row = found.plan.rows[run - 1] if run else {}
    return ", ".join(f"{k}={x:g}" if isinstance(x, float) else f"{k}={x}" for k, x in row.items())


def _tell(sentences: Sequence[str], what: str) -> None:
    for sentence in sentences[:MOST_TOLD]:
        sys.stderr.write(f"holonom: {sentence}\n")
    if len(sentences) > MOST_TOLD:
        sys.stderr.write(f"holonom: ... and {len(sentences) - MOST_TOLD} more {what}\n")
