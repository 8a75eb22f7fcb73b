"""`holonom check SCENE|FMU`: run it and test that energy and constraints hold."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Mapping

from build_fmu import velocities
from build_fmu.commands.simulate import begun, report_end, simulate
from build_fmu.errors import CHECK_FAILED, UNFINISHED, UsageError
from build_fmu.report import print_json, print_table
from build_fmu.run import Run
from solver.runtime.options import MOST_SAMPLING


def run(arguments: argparse.Namespace) -> int:
    """Check; exit code 1 if a limit is exceeded or the FMU logs an error, 3 at an early end."""
    result = simulate(arguments)
    limits = _limits(arguments, result)
    lag = _lag_of_velocities(result)
    if lag:
        limits[velocities.RESIDUAL] = velocities.largest_allowed(result.largest_by_unit)
    checks = [
        {"name": name, "largest": largest, "limit": limit, "holds": largest <= limit}
        for name, limit in limits.items()
        for largest in (result.largest(name),)
    ]
    holds = all(check["holds"] for check in checks) and not result.reason
    if arguments.json:
        reason = {"reason": result.reason, "end_time": result.end_time}
        warnings = {"warnings": arguments.warnings}
        found = {"holds": holds, "moved": result.moved, "checks": checks}
        print_json(found | reason | warnings)
    elif begun(result):
        rows = [
            (
                str(check["name"]),
                _largest(check, result.moved),
                f"{check['limit']:.2e}",
                _verdict(check["holds"]),
            )
            for check in checks
        ]
        title = f"{arguments.target}: {result.steps} steps to t = {result.end_time:g} s"
        print_table(title, ("output", "largest", "limit", "holds"), rows)
    report_end(result)
    if lag:
        sys.stderr.write(f"holonom: {lag}\n")
    if not result.finished:
        return UNFINISHED
    return 0 if holds else CHECK_FAILED


def _limits(arguments: argparse.Namespace, result: Run) -> dict[str, float]:
    """Largest values that outputs may have, by name."""
    limits = {"energy.error": arguments.energy, "constraint.position": arguments.constraint}
    outputs = result.values.dtype.names or ()
    missing = [name for name in limits if name not in outputs]
    if missing:
        text = f"{arguments.target} has no output {missing[0]!r}; check is for FMUs of holonom"
        raise UsageError(text)
    if "solver.sampling" in outputs and result.largest("solver.sampling") > 0.0:
        limits["solver.sampling"] = MOST_SAMPLING
    return limits


def _lag_of_velocities(result: Run) -> str:
    """Sentence about velocities that do not follow the constraints; empty if they do."""
    if velocities.RESIDUAL not in (result.values.dtype.names or ()):
        return ""
    return velocities.objection(result.largest(velocities.RESIDUAL), result.largest_by_unit)


def _largest(check: Mapping[str, object], moved: bool) -> str:
    """Text of a largest error; that of a mechanism at rest says nothing about the solver."""
    return f"{check['largest']:.2e}" if moved or not check["holds"] else "nothing moved"


def _verdict(holds: object) -> str:
    return "yes" if holds else "NO"
