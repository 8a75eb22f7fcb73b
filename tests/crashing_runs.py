"""Runs and variants of a study of which one takes its process with it."""

from __future__ import annotations

import os

from build_fmu.study import sweep as sweep_module
from build_fmu.study import variants as variants_module

FATAL = 7
FATAL_VARIANT = 2
run_some, export = sweep_module._run_some, variants_module._export


def crashing(shared, jobs):
    """What a process of a sweep is given to do."""
    if FATAL in [run for run, _ in jobs]:
        run_some(shared, jobs[:1])  # the FMU is unpacked
        os._exit(3)
    return run_some(shared, jobs)


def crashing_export(shared, jobs):
    """What a process that writes variants is given to do."""
    made = export(shared, jobs)
    if FATAL_VARIANT in [number for number, _ in jobs]:
        os._exit(3)
    return made
