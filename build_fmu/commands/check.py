"""`holonom check SCENE|FMU`: test that energy and constraints hold, and show how exact it is.

What is exact is tested in one run. A second one, with a tenth of the tolerance or less, or half the
step, shows the error of the path.
"""

from __future__ import annotations

import argparse
import sys
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from build_fmu.accuracy import KINDS, TOO_LONG
from build_fmu.commands.simulate import begun, report_end, simulate
from build_fmu.errors import CHECK_FAILED, UNFINISHED, UsageError
from build_fmu.finer_run import Accuracy, accuracy
from build_fmu.jumps import jumps
from build_fmu.motion import RESIDUAL, lag_of_velocities, largest_residual, losses
from build_fmu.printing import print_json, print_table, progress_bar
from build_fmu.run import run_fmu
from build_fmu.study.settings import given_on_the_command_line
from build_fmu.target import fmu_model, runnable
from solver.runtime.layout import MOST_COARSENESS, MOST_SAMPLING

if TYPE_CHECKING:
    from build_fmu.run import Run

PATH = "error of the path"
BOOKED = "energy.error tests the ledger, not the works in it: their error is in the differences"


def run(arguments: argparse.Namespace) -> int:
    """Check; exit code 1 if a limit is exceeded or the FMU logs an error, 3 at an early end."""
    result, lag, exact = _two_runs(arguments)
    outputs = result.values.dtype.names or ()
    limits = {"energy.error": arguments.energy, "constraint.position": arguments.constraint}
    if "solver.sampling" in outputs and result.largest("solver.sampling") > 0.0:
        limits["solver.sampling"] = MOST_SAMPLING
    if result.moved and "solver.coarseness" in outputs and result.largest("solver.coarseness") > 0:
        limits["solver.coarseness"] = MOST_COARSENESS
    if lag:
        limits[RESIDUAL] = largest_residual(result.largest_by_unit)
    found = {name: (result.largest(name), limit) for name, limit in limits.items()}
    if arguments.accuracy is not None and exact:
        found[PATH] = exact.verdict.error, arguments.accuracy
    holds = {name: largest <= limit for name, (largest, limit) in found.items()}
    all_hold = all(holds.values()) and not result.reason
    taken = losses({name: float(result.values[name][-1]) for name in outputs})
    if arguments.json:
        checks = [
            {"name": name, "largest": largest, "limit": limit, "holds": holds[name]}
            for name, (largest, limit) in found.items()
        ]
        document = {"holds": all_hold, "moved": result.moved, "checks": checks}
        reason = {"reason": result.reason, "end_time": result.end_time}
        ledger = {"taken": taken} if taken else {}
        shown = {"accuracy": _as_document(exact)} if exact else {}
        print_json(document | shown | ledger | reason | {"warnings": arguments.warnings})
    elif begun(result):
        rows = [
            # The errors of a mechanism at rest say nothing about the solver.
            (
                name,
                f"{largest:.2e}" if result.moved or not holds[name] else "nothing moved",
                f"{limit:.2e}",
                "yes" if holds[name] else "NO",
            )
            for name, (largest, limit) in found.items()
        ]
        title = f"{arguments.target}: {result.steps} steps to t = {result.end_time:g} s"
        print_table(title, ("output", "largest", "limit", "holds"), rows)
        if taken:
            rows = [(cause, f"{value:.6g}") for cause, value in taken.items()]
            print_table("energy taken out by", ("cause", "J"), rows)
        if exact:
            _print_accuracy(exact)
            if any(each.unit == "J" for each in exact.differences):
                sys.stdout.write(f"{BOOKED}\n")
        elif not result.moved:
            sys.stdout.write("nothing moved, so that no error of the path is measured\n")
    report_end(_judged(result, exact))
    if lag:
        sys.stderr.write(f"holonom: {lag}\n")
    if exact and exact.verdict.is_warning:
        sys.stderr.write(f"holonom: {exact.verdict.sentence}\n")
    if not result.finished:
        return UNFINISHED
    return 0 if all_hold else CHECK_FAILED


def _judged(result: Run, exact: Accuracy | None) -> Run:
    """Run without what its log says of equal steps, where the finer run tells more."""
    if not (exact and exact.differences and exact.verdict.is_warning):
        return result
    kept = tuple(message for message in result.messages if TOO_LONG not in message)
    return replace(result, messages=kept)


def _two_runs(arguments: argparse.Namespace) -> tuple[Run, str, Accuracy | None]:
    """Run it, and again where it moved and came to its end; say that velocities lag, if they do.

    Raises
    ------
    UsageError
        If it is no FMU of holonom.
    """
    entries = given_on_the_command_line(arguments.parameters, arguments.settings)
    with runnable(arguments.target, entries) as (path, left):
        result = simulate(arguments, path, left, with_local=True)
        outputs = result.values.dtype.names or ()
        for name in ("energy.error", "constraint.position"):
            if name not in outputs:
                text = f"{arguments.target} has no output {name!r}; check is for FMUs of holonom"
                raise UsageError(text)
        residual = result.largest(RESIDUAL) if RESIDUAL in outputs else 0.0
        lag = lag_of_velocities(residual, result.largest_by_unit, lambda: jumps(fmu_model(path)))
        if result.reason or not result.moved:
            return result, lag, None

        def again(finer: dict[str, float]) -> Run:
            with progress_bar(f"repeating {Path(path).stem}, finer") as progress:
                return run_fmu(
                    path, stop_time=arguments.stop, step_size=arguments.step, settings=left,
                    inputs=arguments.inputs, progress=progress, with_local=True, finer=finer,
                )  # fmt: skip

        return result, lag, accuracy(path, left, result, again)


def _print_accuracy(exact: Accuracy) -> None:
    """Table of differences, and what they say where that is no warning."""
    rows = [
        (
            KINDS[each.unit],
            f"{each.amount:.1e} {each.unit}",
            "" if each.unit == "rad" else f"{each.relative:.1e} of {each.scale:.3g} {each.unit}",
            each.name,
            f"{each.time:.4g}",
        )
        for each in exact.differences
    ]
    if rows:
        finer = ", ".join(f"{name} = {value:.3g}" for name, value in exact.finer.items())
        title = f"differences from a run with {finer}"
        print_table(title, ("of", "largest", "relative", "output", "at t [s]"), rows)
    if not exact.verdict.is_warning:
        sys.stdout.write(f"{exact.verdict.sentence}\n")


def _as_document(exact: Accuracy) -> dict[str, object]:
    """What `--json` prints of it."""
    return {
        "finer": dict(exact.finer),
        "error": exact.verdict.error,
        "sentence": exact.verdict.sentence,
        "is_warning": exact.verdict.is_warning,
        "differences": [
            {
                "of": KINDS[each.unit], "largest": each.amount, "unit": each.unit,
                "relative": each.relative, "output": each.name, "time": each.time,
            }
            for each in exact.differences
        ],
    }  # fmt: skip
