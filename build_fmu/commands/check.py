"""`holonom check SCENE|FMU`: run it and test that energy and constraints hold."""

from __future__ import annotations

import argparse
import sys

from build_fmu.commands.simulate import begun, report_end, simulate
from build_fmu.errors import CHECK_FAILED, UNFINISHED, UsageError
from build_fmu.motion import RESIDUAL, largest_residual, losses
from build_fmu.report import print_json, print_table
from solver.runtime.layout import MOST_COARSENESS, MOST_SAMPLING


def run(arguments: argparse.Namespace) -> int:
    """Check; exit code 1 if a limit is exceeded or the FMU logs an error, 3 at an early end."""
    result = simulate(arguments, with_local=True)
    outputs = result.values.dtype.names or ()
    limits = {"energy.error": arguments.energy, "constraint.position": arguments.constraint}
    missing = [name for name in limits if name not in outputs]
    if missing:
        text = f"{arguments.target} has no output {missing[0]!r}; check is for FMUs of holonom"
        raise UsageError(text)
    if "solver.sampling" in outputs and result.largest("solver.sampling") > 0.0:
        limits["solver.sampling"] = MOST_SAMPLING
    if result.moved and "solver.coarseness" in outputs and result.largest("solver.coarseness") > 0:
        limits["solver.coarseness"] = MOST_COARSENESS
    if result.lag:
        limits[RESIDUAL] = largest_residual(result.largest_by_unit)
    found = {name: (result.largest(name), limit) for name, limit in limits.items()}
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
        print_json(document | ledger | reason | {"warnings": arguments.warnings})
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
    report_end(result)
    if result.lag:
        sys.stderr.write(f"holonom: {result.lag}\n")
    if not result.finished:
        return UNFINISHED
    return 0 if all_hold else CHECK_FAILED
