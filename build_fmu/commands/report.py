"""`holonom report FMU --results FILE.csv`: a page of a run of any importer, from its results."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from build_fmu.errors import UsageError
from build_fmu.reference import columns_of
from build_fmu.run_page import Carried, plain_values
from build_fmu.study.settings import fmu_settings, given_on_the_command_line
from build_fmu.target import runnable


def run(arguments: argparse.Namespace) -> int:
    """Write the page; exit code 0."""
    entries = given_on_the_command_line(arguments.parameters, arguments.settings)
    with runnable(arguments.target, entries) as (path, left):
        carried = Carried(path, arguments.target)
        values = fmu_settings(carried.description, [left])[0] if left else plain_values(left)
        runs = []
        for file in arguments.results:
            columns = dict(columns_of(file))
            if "time" not in columns:
                text = f"{file}: has no column 'time'; write the times in s into one of that name"
                raise UsageError(text)
            times = columns.pop("time")
            label = Path(file).stem if len(arguments.results) > 1 else ""
            runs.append(carried.report_run(times, columns, values, file, label=label))
        target = arguments.output or f"{Path(arguments.results[0]).stem}.html"
        carried.write(target, runs, compare=len(runs) == 2)
    sys.stdout.write(f"{target}\n")
    return 0
