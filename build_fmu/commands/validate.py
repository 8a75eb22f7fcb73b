"""`holonom validate FMU`: findings of fmpy's validator."""

from __future__ import annotations

import argparse
import sys

from build_fmu.archive_check import require_whole
from build_fmu.errors import CHECK_FAILED
from build_fmu.printing import print_json


def run(arguments: argparse.Namespace) -> int:
    """Validate; exit code 1 if there is a finding."""
    require_whole(arguments.target)
    from fmpy.validation import validate_fmu

    findings = validate_fmu(arguments.target)
    if arguments.json:
        print_json({"fmu": arguments.target, "findings": findings})
    else:
        sys.stdout.writelines(f"{finding}\n" for finding in findings or ["no finding"])
    return CHECK_FAILED if findings else 0
