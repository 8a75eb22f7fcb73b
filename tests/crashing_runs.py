"""Runs of a sweep of which one takes its process with it."""

from __future__ import annotations

import os

from build_fmu.study import sweep as sweep_module

FATAL = 7
run_some = sweep_module._run_some


def crashing(shared, jobs):
    """What a process of a sweep is given to do."""
    if FATAL in [run for run, _ in jobs]:
        run_some(shared, jobs[:1])  # the FMU is unpacked
        os._exit(3)
    return run_some(shared, jobs)
