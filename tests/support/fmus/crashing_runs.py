"""Runs and variants of a study of which one takes its process with it."""

from __future__ import annotations

import os

from build_fmu.study import sweep as sweep_module
from build_fmu.study import variants as variants_module

FATAL = 7
FATAL_VARIANT = 2
run_row, export = sweep_module.run_row, variants_module._export


def crashing(shared, job):
    """What a process of a sweep is given to do."""
    result = run_row(shared, job)  # the FMU is unpacked
    if job[0] == FATAL:
        os._exit(3)
    return result


def crashing_export(shared, job):
    """What a process that writes variants is given to do."""
    made = export(shared, job)
    if job[0] == FATAL_VARIANT:
        os._exit(3)
    return made
