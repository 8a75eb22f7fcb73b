"""`holonom check SCENE|FMU`: run it and test that energy and constraints hold."""

from __future__ import annotations

import argparse

from build_fmu.commands.simulate import begun, report_end, simulate
from build_fmu.errors import CHECK_FAILED, UNFINISHED, UsageError
from build_fmu.report import print_json, print_table


def run(arguments: argparse.Namespace) -> int:
    """Check; exit code 1 if a limit is exceeded or the FMU logs an error, 3 at an early end."""
    result = simulate(arguments)
    limits = {"energy.error": arguments.energy, "constraint.position": arguments.constraint}
    missing = [name for name in limits if name not in (result.values.dtype.names or ())]
    if missing:
        text = f"{arguments.target} has no output {missing[0]!r}; check is for FMUs of holonom"
        raise UsageError(text)
    checks = [
        {"name": name, "largest": largest, "limit": limit, "holds": largest <= limit}
        for name, limit in limits.items()
        for largest in (result.largest(name),)
    ]
    holds = all(check["holds"] for check in checks) and not result.reason
    if arguments.json:
        reason = {"reason": result.reason, "end_time": result.end_time}
        warnings = {"warnings": arguments.warnings}
        print_json({"holds": holds, "checks": checks} | reason | warnings)
    elif begun(result):
        rows = [
            (str(c["name"]), f"{c['largest']:.2e}", f"{c['limit']:.2e}", _verdict(c["holds"]))
            for c in checks
        ]
        title = f"{arguments.target}: {result.steps} steps to t = {result.end_time:g} s"
        print_table(title, ("output", "largest", "limit", "holds"), rows)
    report_end(result)
    if not result.finished:
        return UNFINISHED
    return 0 if holds else CHECK_FAILED


def _verdict(holds: object) -> str:
    return "yes" if holds else "NO"
